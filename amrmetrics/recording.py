"""A recorded trajectory: poses or positions, their time stamps, and where they came from."""

from dataclasses import dataclass, replace

import numpy as np

from amrmetrics._arguments import as_array, as_poses, as_positions, as_stamps
from amrmetrics.errors import AmrError


@dataclass(frozen=True, eq=False, repr=False)
class Trajectory:
    """A recording, accepted wherever poses are; ``stamps, X = trajectory`` takes it apart.

    It has a length and can be sliced: ``trajectory[100:200]``, ``trajectory[::10]``, an array
    of indices or of booleans. ``trajectory[k]`` is one pose, an array.

    Parameters
    ----------
    stamps : (N,) array or None
        Seconds, increasing; None where nobody recorded them.
    poses : (N, d+1, d+1) or (N, d) array
        Poses in meters, d = 2 or 3, or positions alone.
    source : str
        Where they came from, such as the path of a file.
    repairs : tuple of str
        What a reader had to repair.
    frames : (N,) array of int, optional
        Numbers of the camera frames, increasing, where a file has them in place of stamps.
    why_no_orientation : str
        Of positions alone: why there is nothing else.
    coverage : Coverage, optional
        How much of a run was matched; `match` says so.

    Raises
    ------
    AmrError
        If lengths differ, stamps do not increase, or these are no poses.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t = np.arange(0, 10, 0.1)
    >>> run = am.Trajectory(t, am.planar_poses(np.c_[t, 0 * t], 0 * t), "a drive")
    >>> run
    a drive: 100 poses in the plane, 9.9 s, 10 per second, path 9.9 m
    >>> len(run[20:40]), run.between(2, 4).stamps[0].round(1)
    (20, np.float64(2.0))
    """

    stamps: np.ndarray | None
    poses: np.ndarray
    source: str = ""
    repairs: tuple = ()
    frames: np.ndarray | None = None
    why_no_orientation: str = ""
    coverage: object = None

    def __post_init__(self):
        poses = as_array(self.poses, "poses")
        poses = as_positions(poses, "poses") if poses.ndim == 2 else as_poses(poses, "poses")
        object.__setattr__(self, "poses", poses)
        if poses.ndim == 2 and not self.why_no_orientation:
            object.__setattr__(self, "why_no_orientation", "only positions were given")
        if self.stamps is not None:
            object.__setattr__(self, "stamps", as_stamps(self.stamps, "stamps"))
            self._as_many("stamps", self.stamps)
        if self.frames is not None:
            frames = as_array(self.frames, "frames")
            self._as_many("frames", frames)
            if (np.diff(frames) <= 0).any():
                k = int((np.diff(frames) <= 0).argmax())
                raise AmrError(f"frames must increase; {frames[k + 1]} comes after {frames[k]}.")
            object.__setattr__(self, "frames", frames)

    def _as_many(self, name, values):
        if len(values) != len(self.poses):
            raise AmrError(
                f"{name} has {len(values)} entries for {len(self.poses)} poses; one each is needed."
            )

    def __len__(self):
        return len(self.poses)

    def __iter__(self):
        return iter((self.stamps, self.poses))

    def __array__(self, dtype=None, copy=None):
        return np.array(self.poses, dtype, copy=copy)

    def __getitem__(self, index):
        try:
            poses = self.poses[index]
        except IndexError as error:
            raise AmrError(f"{error}; the trajectory has {len(self)} poses.") from None
        if isinstance(index, int | np.integer):
            return poses
        if poses.ndim != self.poses.ndim or poses.shape[1:] != self.poses.shape[1:]:
            raise AmrError(
                f"a trajectory is sliced along time only, trajectory[10:20]; you gave {index!r}. "
                "Slice trajectory.poses for the rest."
            )
        if not len(poses):
            raise AmrError(f"nothing is left of the {len(self)} poses at {index!r}.")
        stamps, frames = (x if x is None else x[index] for x in (self.stamps, self.frames))
        return replace(self, stamps=stamps, poses=poses, frames=frames)

    @property
    def positions(self):
        """Positions in the world frame, (N, d) array, meters; a copy."""
        return np.array(self.poses if self.poses.ndim == 2 else self.poses[:, :-1, -1])

    @property
    def dimension(self):
        """2 in the plane, 3 in space."""
        return self.poses.shape[1] - (self.poses.ndim == 3)

    @property
    def duration(self):
        """Seconds from the first to the last stamp; nan without stamps."""
        return float("nan") if self.stamps is None else float(self.stamps[-1] - self.stamps[0])

    @property
    def rate(self):
        """Poses per second in the median; nan without stamps or with a single one."""
        if self.stamps is None or len(self) < 2:
            return float("nan")
        return float(1 / np.median(np.diff(self.stamps)))

    @property
    def path_length(self):
        """Length of the path, meters."""
        from amrmetrics.poses import path_length

        return path_length(self.positions)

    def between(self, start=None, end=None):
        """Return the part from `start` to `end`, both included, in seconds of its own clock.

        Raises
        ------
        AmrError
            If there are no stamps, or none lies between.
        """
        if self.stamps is None:
            raise AmrError(f"{self._name()} has no stamps; slice it by index: trajectory[10:20].")
        low, high = (x if x is not None else y for x, y in ((start, -np.inf), (end, np.inf)))
        inside = (self.stamps >= low) & (self.stamps <= high)
        if not inside.any():
            raise AmrError(
                f"no stamp lies between {low:.6f} and {high:.6f} s; {self._name()} runs from "
                f"{self.stamps[0]:.6f} to {self.stamps[-1]:.6f} s."
            )
        return self[inside]

    def _name(self):
        return self.source or "the trajectory"

    def __repr__(self):
        what = "poses" if self.poses.ndim == 3 else "positions"
        where = "in the plane" if self.dimension == 2 else "in space"
        rows = [f"{len(self)} {what} {where}"]
        if self.stamps is None:
            rows.append("no stamps")
        else:
            rows.append(f"{self.duration:.6g} s")
            if len(self) > 1:
                rows.append(f"{self.rate:.4g} per second")
        rows.append(f"path {self.path_length:.6g} m")
        rows += [f"repaired: {what}" for what in self.repairs]
        return f"{self.source or 'trajectory'}: {', '.join(rows)}"


def coverage_of(reference, estimate):
    """Return the coverage that `match` left, None without; refuse recordings nobody matched.

    Recordings of equal length whose stamps differ are no pairs of samples either.
    """
    if not (isinstance(reference, Trajectory) and isinstance(estimate, Trajectory)):
        return None
    if reference.coverage is not None and reference.coverage is estimate.coverage:
        return reference.coverage
    n, m = len(reference), len(estimate)
    help_ = "Match them first: reference, estimate = am.match(reference, estimate)."
    if n != m:
        raise AmrError(
            f"reference has {n} poses and estimate has {m}; sample k of one must belong to sample "
            f"k of the other. {help_}"
        )
    if reference.stamps is not None and estimate.stamps is not None and n > 1:
        apart = np.abs(reference.stamps - estimate.stamps)
        usual = np.median(np.diff(reference.stamps))
        if apart.max() > usual / 2:
            k = int(apart.argmax())
            raise AmrError(
                f"sample {k} of reference and of estimate are {apart[k]:.6g} s apart, where the "
                f"reference has a pose every {usual:.3g} s. {help_}"
            )
    return None


def as_recording(stamps, X, stamps_name, name):
    """Return stamps and poses of equal number; a Trajectory in place of `stamps` has both."""
    if X is None:
        if not isinstance(stamps, Trajectory):
            raise AmrError(f"{name} is missing; {stamps_name} alone is no trajectory.")
        X = stamps
    stamps, X = as_stamps(stamps, stamps_name), as_poses(X, name)
    if len(stamps) != len(X):
        raise AmrError(
            f"{stamps_name} has {len(stamps)} entries and {name} has {len(X)} poses; each pose "
            "needs one stamp."
        )
    return stamps, X
