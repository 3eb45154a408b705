"""The folder of a benchmark: what stands where, and how it gets there in one piece.

::

    protocol.json                                  all that was decided, and its digest
    worlds/{scenario}/{seed}/                      truth.tum, truth.npz, world.json
    trials/{scenario}/{system}/{seed}/             estimate.tum, estimate.npz, trial.json,
                                                   times.npz, output.txt

Poses are text in TUM format, planar ones with z = 0; other arrays are npz. ``times.npz`` (of each
frame and of the whole trial) and ``output.txt`` (the last that was printed) differ from run to
run. All else is the same to the bit whenever and wherever a trial runs, and its SHA-256 stands in
``trial.json`` or ``world.json``. A folder of a trial appears at once and complete, by renaming.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
import shutil
from contextlib import contextmanager
from dataclasses import dataclass, field, fields
from functools import lru_cache
from pathlib import Path
from uuid import uuid4

import numpy as np

from amrmetrics._arguments import as_numbers, as_poses, as_positions, as_stamps
from amrmetrics.benchmark.data import Estimate, Truth
from amrmetrics.errors import AmrError
from amrmetrics.files import _quaternions

PROTOCOL, TRIAL, WORLD, TIMES, OUTPUT = (
    "protocol.json",
    "trial.json",
    "world.json",
    "times.npz",
    "output.txt",
)
# Where folders are filled before they get their names; what a killed run left there is removed.
UNFINISHED = ".unfinished"
# Covariances may be off by this share of their largest entry; rounding is.
PSD_WITHIN = 1e-9


@dataclass(frozen=True)
class TrialEntry:
    """What the index knows of a trial, without its arrays.

    Attributes
    ----------
    system, scenario, split, seed : str, str, str, int
        Which one it is.
    path, world : Path
        Its folder, and the folder of its truth.
    status : str
        "ok", "failed", or "missing" if it has not run yet.
    kind : str
        Of a failure: "raised", "too slow", "out of memory", "died", "nonsense" or "not read".
    reason : str
        Of a failure, one line.
    detail : str
        Of a failure: the end of the traceback.
    protocol : str
        Digest of the protocol that the folder has.
    """

    system: str
    scenario: str
    split: str
    seed: int
    path: Path
    world: Path
    status: str = "missing"
    kind: str = ""
    reason: str = ""
    detail: str = ""
    protocol: str = ""


@dataclass(frozen=True)
class Index:
    """All trials of a folder, those that are missing included.

    Attributes
    ----------
    folder : Path
        Where they are.
    protocol : dict
        As in protocol.json.
    entries : tuple of TrialEntry
        In the protocol's order: scenario, system, seed.
    strangers : tuple of str
        Folders below ``trials`` that the protocol knows nothing of.
    """

    folder: Path
    protocol: dict
    entries: tuple
    strangers: tuple = ()


@dataclass(frozen=True, eq=False)
class Trial(TrialEntry):
    """A trial as it was logged: what the index knows of it, and its arrays.

    Attributes
    ----------
    estimate : Estimate or None
        None if it failed or is missing. Without orientations `poses` are positions, (N, d).
    truth : Truth or None
        None if the world could not be made or read.
    seconds : dict
        What was measured: "wall", "cpu" (seconds) and "peak" (bytes); empty if nothing was.
    """

    estimate: Estimate | None = None
    truth: Truth | None = None
    seconds: dict = field(default_factory=dict)


def digest(content):
    """Return the SHA-256 of a dictionary in canonical JSON, its own entry "digest" left out."""
    plain = {key: value for key, value in content.items() if key != "digest"}
    text = json.dumps(plain, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


def sealed(content):
    """Return a JSON file's bytes, with the digest of the rest in it."""
    content = {**content, "digest": digest(content)}
    return (json.dumps(content, indent=1, allow_nan=False) + "\n").encode()


def with_digests(files, name, said):
    """Return files together with the JSON file `name` that vouches for them."""
    digests = {file: hashlib.sha256(data).hexdigest() for file, data in files.items()}
    return {**files, name: sealed({**said, "files": digests})}


def read_sealed(path):
    """Return the dictionary of a JSON file, None if there is no such file.

    Raises
    ------
    AmrError
        If it is no JSON, or is not as it was written.
    """
    try:
        content = json.loads(Path(path).read_bytes())
    except FileNotFoundError:
        return None
    except ValueError:
        raise AmrError(f"{path} is no JSON. Was it edited, or copied in part?") from None
    if not isinstance(content, dict) or content.get("digest") != digest(content):
        raise AmrError(
            f"{path} is not as it was written: its digest does not match. Restore it from a copy."
        )
    return content


def trial_path(folder, scenario, system, seed):
    """Return the folder of a trial."""
    return Path(folder, "trials", scenario, system, f"{seed:06d}")


def world_path(folder, scenario, seed):
    """Return the folder of the truth that all systems share."""
    return Path(folder, "worlds", scenario, f"{seed:06d}")


# --- Writing ------------------------------------------------------------------------------------


def put_file(path, data):
    """Write a file so that it is there as a whole or not at all."""
    beside = path.with_name(f".{path.name}.{uuid4().hex}")
    try:
        _write(beside, data)
        os.replace(beside, path)
    except BaseException:
        beside.unlink(missing_ok=True)
        raise


def put_folder(folder, target, files):
    """Make the folder `target` with these files (name to bytes), all of them or nothing.

    What stands in its way is moved aside and removed: it was not complete.
    """
    unfinished = Path(folder, UNFINISHED, uuid4().hex)
    unfinished.mkdir(parents=True, exist_ok=True)
    try:
        for name, data in files.items():
            _write(unfinished / name, data)
        target.parent.mkdir(parents=True, exist_ok=True)
        if target.exists():
            os.rename(target, unfinished.with_name(uuid4().hex))
        os.rename(unfinished, target)
    except BaseException:
        shutil.rmtree(unfinished, ignore_errors=True)
        raise


def _write(path, data):
    with open(path, "xb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def begin(folder, content, refuse_other):
    """Write protocol.json and return its content, or compare with the one that is there."""
    folder.mkdir(parents=True, exist_ok=True)
    there = read_protocol(folder)
    if there is not None:
        refuse_other(there, content, folder)
        return there
    for name in ("trials", "worlds"):
        if (folder / name).exists():
            raise AmrError(
                f"{folder} has a folder {name!r}, but no {PROTOCOL}: nobody can tell how it came "
                "about. Take a new folder."
            )
    put_file(folder / PROTOCOL, sealed(content))
    return read_protocol(folder)


@contextmanager
def without_unfinished(folder):
    """Remove what a killed run left half-written, and at the end what was replaced."""
    for left in Path(folder).glob(f".{PROTOCOL}.*"):
        left.unlink(missing_ok=True)
    unfinished = Path(folder, UNFINISHED)
    shutil.rmtree(unfinished, ignore_errors=True)
    unfinished.mkdir()
    try:
        yield
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)


@contextmanager
def locked(folder):
    """Keep a second run out of the folder; a killed run holds nothing.

    The lock is on protocol.json, which has to be there.
    """
    with open(Path(folder, PROTOCOL), "rb") as file:
        if not _lock(file):
            raise AmrError(f"another run is writing into {folder}. Wait until it is done.")
        _held.add(file)
        try:
            yield
        finally:
            _held.discard(file)


# Files that are locked now. A forked worker of a pool has them open, too; if it kept them, it would
# keep the lock when the run is killed and the worker goes on.
_held: set = set()


def _let_go():
    while _held:
        _held.pop().close()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_let_go)


def _lock(file):
    try:
        import fcntl
    except ImportError:
        return _lock_on_windows(file)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        return True  # a file system without locks, as some networks have
    return True


def _lock_on_windows(file):
    import msvcrt

    try:
        file.seek(1 << 30)  # far behind the end, where nobody reads
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
    except OSError:
        return False
    return True


# --- Truth and estimate to bytes and back -------------------------------------------------------


def checked_estimate(estimate, log_stamps=None):
    """Return an Estimate of plain arrays, or refuse it as nonsense with an AmrError.

    Stamps that are missing become those of the log, from its start on.
    """
    if not isinstance(estimate, Estimate):
        raise AmrError(f"the system returned {type(estimate).__name__}; expected an Estimate.")
    stamps = estimate.stamps
    if np.ndim(estimate.poses) not in (2, 3):
        raise AmrError(f"poses has {np.ndim(estimate.poses)} axes; expected (N, d+1, d+1).")
    if stamps is None:
        n = len(estimate.poses)
        if log_stamps is None or n > len(log_stamps):
            raise AmrError(f"{n} poses and no stamps: it cannot be told when they were.")
        stamps = log_stamps[:n]
    stamps, poses = _checked_poses(stamps, estimate.poses)
    rest = {name: _checked(name, getattr(estimate, name)) for name in OPTIONAL}
    _check_together(poses, rest)
    return Estimate(poses, stamps, **rest)


def _checked_poses(stamps, poses):
    poses = np.asarray(poses)
    poses = as_positions(poses, "poses") if poses.ndim == 2 else as_poses(poses, "poses")
    stamps = as_stamps(stamps, "stamps")
    _same_length("stamps", stamps, "poses", poses)
    return stamps, poses


OPTIONAL = tuple(f.name for f in fields(Estimate) if f.name not in ("poses", "stamps"))
DIMENSIONS = {
    "covariances": 3,
    "innovations": 2,
    "innovation_covariances": 3,
    "map_points": 2,
    "accepted": 1,
    "closure_scores": 1,
    "frame_seconds": 1,
}


def _checked(name, value):
    if value is None:
        return None
    array = np.asarray(value)
    if array.ndim != DIMENSIONS[name]:
        raise AmrError(f"{name} has shape {array.shape}; expected {DIMENSIONS[name]} axes.")
    if name == "accepted":
        if array.dtype != bool:
            raise AmrError(f"accepted is of type {array.dtype}; expected True and False.")
        return array
    if name == "map_points":  # nan stands for a landmark that was never seen
        as_numbers(np.where(np.isnan(array), 0, array), name)
        return array.astype(float)
    return as_numbers(array, name)


def _check_together(poses, rest):
    pairs = (("innovation_covariances", "innovations"), ("closure_scores", "accepted"))
    if rest["covariances"] is not None:
        _same_length("covariances", rest["covariances"], "poses", poses)
    for one, other in pairs:
        if rest[one] is not None and rest[other] is not None:
            _same_length(one, rest[one], other, rest[other])
    for name in ("covariances", "innovation_covariances"):
        if rest[name] is not None:
            _check_covariances(name, rest[name])


def _same_length(name, values, other, others):
    if len(values) != len(others):
        raise AmrError(
            f"{name} has {len(values)} entries and {other} has {len(others)}; one each is needed."
        )


def _check_covariances(name, S):
    if S.shape[1] != S.shape[2]:
        raise AmrError(f"{name} has shape {S.shape}; expected (N, n, n).")
    if not S.size:
        return
    scale = np.abs(S).max(axis=(1, 2))
    skew = np.abs(S - S.swapaxes(1, 2)).max(axis=(1, 2)) > PSD_WITHIN * scale
    smallest = np.linalg.eigvalsh(S)[:, 0]
    for wrong, what in ((skew, "symmetric"), (smallest < -PSD_WITHIN * scale, "a covariance")):
        if wrong.any():
            k = int(wrong.argmax())
            raise AmrError(f"{name}[{k}] is not {what} (smallest eigenvalue {smallest[k]:.3g}).")


def truth_files(truth):
    """Return the files of a Truth, name to bytes."""
    stamps, poses = _checked_poses(truth.stamps, truth.poses)
    arrays = {"landmarks": truth.landmarks, "labels": truth.labels}
    return {"truth.tum": _as_tum(stamps, poses), "truth.npz": _as_npz(arrays)}


def estimate_files(estimate):
    """Return the files of an Estimate, name to bytes; its times are in `times_file`."""
    arrays = {name: getattr(estimate, name) for name in OPTIONAL if name != "frame_seconds"}
    poses = _as_tum(estimate.stamps, estimate.poses)
    return {"estimate.tum": poses, "estimate.npz": _as_npz(arrays)}


def digest_of_log(log):
    """Return the SHA-256 of what a system was given."""
    found = hashlib.sha256()
    for f in fields(log):
        array = np.ascontiguousarray(getattr(log, f.name))
        found.update(f"{f.name} {array.dtype} {array.shape} ".encode())
        found.update(array.tobytes())
    return found.hexdigest()


def shape_of(poses):
    """Return what the text of a trajectory does not tell: plane or space, with orientation."""
    oriented = poses.ndim == 3
    return {"dimension": poses.shape[1] - oriented, "oriented": oriented, "poses": len(poses)}


def _as_tum(stamps, poses):
    """Return TUM text whose numbers read back to the same doubles."""
    d = poses.shape[1] - (poses.ndim == 3)
    rows = np.zeros((len(poses), 8))
    rows[:, 0] = stamps
    if poses.ndim == 2:
        rows[:, 1 : 1 + d] = poses  # four zeros say that there is no orientation
    else:
        rows[:, 1 : 1 + d] = poses[:, :d, d]
        R = np.broadcast_to(np.eye(3), (len(poses), 3, 3)).copy()
        R[:, :d, :d] = poses[:, :d, :d]
        rows[:, 4:] = _quaternions(R)
    lines = (" ".join(map(repr, row)) for row in rows.tolist())
    return ("# stamp tx ty tz qx qy qz qw\n" + "\n".join(lines) + "\n").encode()


def _from_tum(data, said):
    """Return stamps and poses, in the plane or in space as the JSON file says."""
    dimension = said["dimension"]
    numbers = np.fromstring(data[data.index(b"\n") :].decode(), sep=" ").reshape(-1, 8)
    stamps = numbers[:, 0].copy()
    positions = numbers[:, 1 : 1 + dimension]
    if not said["oriented"]:
        return stamps, positions.copy()
    from amrmetrics.poses import spatial_poses

    spatial = spatial_poses(numbers[:, 1:4], numbers[:, 4:])
    if dimension == 3:
        return stamps, spatial
    poses = np.zeros((len(numbers), 3, 3))
    poses[:, :2, :2] = spatial[:, :2, :2]
    poses[:, :2, 2] = positions
    poses[:, 2, 2] = 1
    return stamps, poses


def _as_npz(arrays):
    """Return the bytes of an npz file; NumPy writes no time of day into it."""
    file = io.BytesIO()
    np.savez(file, **{name: np.asarray(x) for name, x in arrays.items() if x is not None})
    return file.getvalue()


def _from_npz(data):
    with np.load(io.BytesIO(data), allow_pickle=False) as file:
        return {name: file[name] for name in file.files}


def times_file(frame_seconds=None, wall=None, cpu=None, peak=None):
    """Return the bytes of times.npz: what was measured, seconds and bytes."""
    return _as_npz({"frame_seconds": frame_seconds, "wall": wall, "cpu": cpu, "peak": peak})


def with_peak(data, peak):
    """Return the bytes of times.npz (None for an empty one) with the peak of the memory."""
    return _as_npz({**(_from_npz(data) if data else {}), "peak": peak})


# --- Reading ------------------------------------------------------------------------------------


def read_protocol(folder):
    """Return the dictionary of protocol.json, None if there is none; AmrError if altered."""
    return read_sealed(Path(folder, PROTOCOL))


def index(folder):
    """Return the protocol of a folder and what became of each of its trials.

    Raises
    ------
    AmrError
        If this is no folder of a benchmark, or a trial was run under another protocol.
    """
    folder = Path(folder)
    protocol = read_protocol(folder)
    if protocol is None:
        raise AmrError(
            f"{folder} has no {PROTOCOL}: it is not the folder of a benchmark. "
            "amrmetrics.benchmark.run and adopt make one."
        )
    entries = tuple(_entry(folder, protocol, *trial) for trial in matrix(protocol))
    known = {entry.path for entry in entries}
    found = sorted(path for path in Path(folder, "trials").glob("*/*/*") if path.is_dir())
    strangers = tuple(str(path.relative_to(folder)) for path in found if path not in known)
    return Index(folder, protocol, entries, strangers)


def matrix(protocol):
    """Return (scenario, split, system, seed) of all trials that a protocol asks for."""
    if "trials" in protocol:  # own data are seldom a full matrix
        splits = {s["name"]: s["split"] for s in protocol["scenarios"]}
        return [(a, splits[a], b, seed) for a, b, seed in protocol["trials"]]
    return [
        (scenario["name"], scenario["split"], system["name"], seed)
        for scenario in protocol["scenarios"]
        for system in protocol["systems"]
        for seed in protocol["seeds"]
    ]


def _entry(folder, protocol, scenario, split, system, seed):
    path, world = trial_path(folder, scenario, system, seed), world_path(folder, scenario, seed)
    entry = TrialEntry(system, scenario, split, seed, path, world, protocol=protocol["digest"])
    said = read_sealed(path / TRIAL)
    if said is None:
        return entry
    _check_protocol(said, entry.protocol, path)
    _check_place(said, path, scenario=scenario, system=system, seed=seed)
    told = {name: said[name] for name in ("status", "kind", "reason", "detail")}
    return TrialEntry(system, scenario, split, seed, path, world, **told, protocol=entry.protocol)


def _check_protocol(said, protocol, path):
    if said["protocol"] != protocol:
        raise AmrError(
            f"{path} was logged under protocol {said['protocol'][:12]}, and the folder has "
            f"{protocol[:12]}. Trials of several protocols cannot be evaluated together."
        )


def _check_place(said, path, **expected):
    for name, value in expected.items():
        if said[name] != value:
            raise AmrError(
                f"{path} is of {name} {said[name]}: it was moved or copied there from another "
                "place. Delete the folder, and run the benchmark again: it fills what is missing."
            )


def read_trial(entry):
    """Return a trial with its arrays.

    Parameters
    ----------
    entry : TrialEntry
        As in `index`.

    Returns
    -------
    Trial
        With the truth also where the trial failed or is missing, if there is one.

    Raises
    ------
    AmrError
        If a file is not the one that was written, or belongs to another protocol.
    """
    truth = _read_truth(entry)
    if entry.status == "missing":
        return Trial(**vars(entry), truth=truth)
    said, files = _verified(entry.path, TRIAL, entry.protocol)
    times = _times(entry.path / TIMES)
    frame_seconds = times.pop("frame_seconds", None)
    seconds = {name: float(value) for name, value in times.items()}
    estimate = None
    if entry.status == "ok":
        stamps, poses = _from_tum(files["estimate.tum"], said)
        arrays = _from_npz(files["estimate.npz"])
        estimate = Estimate(poses, stamps, **arrays, frame_seconds=frame_seconds)
    return Trial(**vars(entry), estimate=estimate, truth=truth, seconds=seconds)


def is_intact(entry):
    """Say if all files of a trial are as they were written."""
    return _is_intact(entry.path, TRIAL, entry.protocol)


def has_intact_world(entry):
    """Say if all files of its world are, or if a failed trial has none."""
    if not entry.world.exists():
        return entry.status == "failed"
    return _is_intact(entry.world, WORLD, entry.protocol)


def _is_intact(path, name, protocol):
    try:
        _verified(path, name, protocol)
    except AmrError:
        return False
    return True


def _verified(path, name, protocol):
    """Return the JSON of a folder and the bytes of the files it vouches for."""
    said = read_sealed(path / name)
    if said is None:
        raise AmrError(f"{path} has no {name}. Run the benchmark again: it fills what is missing.")
    _check_protocol(said, protocol, path)
    files = {}
    for file, expected in said["files"].items():
        try:
            files[file] = (path / file).read_bytes()
        except FileNotFoundError:
            raise AmrError(f"{path / file} is missing; {name} vouches for it.") from None
        if hashlib.sha256(files[file]).hexdigest() != expected:
            raise AmrError(
                f"{path / file} is not the file that was logged: its SHA-256 differs from the one "
                f"in {name}. Restore it, or run the benchmark again, which repeats this trial."
            )
    return said, files


def _times(path):
    try:
        return _from_npz(path.read_bytes())
    except FileNotFoundError:
        return {}


def _read_truth(entry):
    files = [entry.world / name for name in (WORLD, "truth.tum", "truth.npz")]
    if not files[0].exists() and entry.status != "ok":
        return None
    state = tuple((f.stat().st_mtime_ns, f.stat().st_size) for f in files if f.exists())
    return _truth(entry.world, entry.protocol, entry.scenario, entry.seed, state)


@lru_cache(maxsize=1)  # systems that were tried on one world are read one after the other
def _truth(world, protocol, scenario, seed, state):
    """Return the Truth of a world whose files are in this state; its arrays are read-only."""
    said, files = _verified(world, WORLD, protocol)
    _check_place(said, world, scenario=scenario, seed=seed)
    stamps, poses = _from_tum(files["truth.tum"], said)
    arrays = _from_npz(files["truth.npz"])
    for array in (stamps, poses, *arrays.values()):
        array.flags.writeable = False
    return Truth(stamps, poses, **arrays)
