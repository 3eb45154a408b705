"""The six systems of the default benchmark, each from a sensor log to an estimate."""

from __future__ import annotations

from time import perf_counter

import numpy as np

from amrmetrics import _groups
from amrmetrics._arguments import as_size
from amrmetrics.benchmark.data import Estimate, SensorLog, System
from amrmetrics.loops import LOSSES, as_loss
from amrmetrics.poses import planar_poses, wrap
from amrmetrics.simulation.filters import measurement_model, motion_model

# A wheel that does not slip sideways would make odometry's covariance singular.
SIDEWAYS = 1e-3  # m in a step

# A pose graph is at rest when a step lowers its cost by less than this part of it.
ONLINE_TOLERANCE, FINAL_TOLERANCE = 1e-4, 1e-10
MOST_STEPS = 50
ACCEPTED = 0.2  # least weight; with the Cauchy kernel at width 2, within 4 standard deviations
PARTS = 0.5 ** np.arange(20)  # of a step that would raise the cost


def dead_reckoning(log: SensorLog, *, stamp_delay: float = 0.0) -> Estimate:
    """Add up odometry from the prior on, and its covariance with it.

    Parameters
    ----------
    log : SensorLog
        Its odometry and prior are used.
    stamp_delay : float
        Seconds by which the stamps of the estimate are late: a clock that nobody set.

    Returns
    -------
    Estimate
        Poses, covariances and times.

    References
    ----------
    Lecture 04. Thrun, Burgard and Fox, Probabilistic Robotics (2005), section 5.4, with
    noise of speed and turn rate alone.

    Examples
    --------
    >>> import numpy as np
    >>> from amrmetrics.benchmark import estimators, worlds
    >>> log, truth = worlds.make(np.random.default_rng(1), steps=100)
    >>> estimators.dead_reckoning(log).covariances.shape
    (101, 3, 3)
    """
    track = _Track(log)
    for k in range(len(log.odometry)):
        started = perf_counter()
        track.predict(k)
        track.keep(k, started)
    return track.estimate(stamp_delay)


def ekf_localization(
    log: SensorLog,
    *,
    claimed: float = 1.0,
    gate: float = 13.8,
    lost_after: float = 10.0,
    stamp_delay: float = 0.0,
) -> Estimate:
    """Localize in the surveyed map with an extended Kalman filter, until lost.

    Parameters
    ----------
    log : SensorLog
        Its odometry, sightings, surveyed landmarks and prior are used.
    claimed : float
        Claimed over true standard deviations of all noise and of the prior, > 0. Below 1
        the filter is overconfident; but for the gate, its estimates are the same.
    gate : float
        Sightings with a larger NIS are ignored. 13.8 lets 99.9 % of right ones pass.
    lost_after : float
        After so many seconds of frames that have sightings of which none passes, the filter
        is lost and hands in the poses until then.
    stamp_delay : float
        Seconds by which the stamps of the estimate are late.

    Returns
    -------
    Estimate
        With the innovations of all sightings, those that the gate stopped included: the NIS
        of the others says nothing about the filter, it is small by selection.

    References
    ----------
    Lecture 04. Thrun, Burgard and Fox (2005), table 7.2; the gate is Bar-Shalom, Li and
    Kirubarajan, Estimation with Applications to Tracking and Navigation (2001).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> from amrmetrics.benchmark import estimators, worlds
    >>> log, truth = worlds.make(np.random.default_rng(1))
    >>> for claimed in (1.0, 0.6):
    ...     estimate = estimators.ekf_localization(log, claimed=claimed)
    ...     ate = am.ate(truth.poses, estimate.poses).rmse
    ...     errors = am.pose_errors(truth.poses, estimate.poses)
    ...     print(f"{ate:.2f} m, NEES {am.nees(errors, estimate.covariances).mean():.1f}")
    0.06 m, NEES 2.9
    0.06 m, NEES 8.9
    """
    claimed = float(as_size(claimed, "claimed"))
    track = _Track(log, claimed)
    R = claimed**2 * np.diag(log.sighting_std**2)
    frames = _by_step(log)
    blocked = 0.0
    for k in range(len(log.odometry)):
        started = perf_counter()
        track.predict(k)
        seen = frames[k + 1]
        passed = False
        for landmark, z in seen:
            predicted, H = measurement_model(track.state, log.landmarks[landmark])
            nu = _innovation(z, predicted)
            PHt = track.P @ H.T
            S = H @ PHt + R
            track.innovations.append(nu)
            track.S.append(S)
            white = np.linalg.solve(np.linalg.cholesky(S), np.column_stack([PHt.T, nu]))
            weighted, off = white[:, :3], white[:, 3]
            if off @ off > gate:
                continue
            passed = True
            track.state = track.state + weighted.T @ off
            track.P = track.P - weighted.T @ weighted
        track.keep(k, started)
        if seen:
            blocked = 0.0 if passed else blocked + log.stamps[k + 1] - log.stamps[k]
            if blocked >= lost_after:
                break
    return track.estimate(stamp_delay)


def ekf_slam(log: SensorLog, *, stamp_delay: float = 0.0) -> Estimate:
    """Localize and map the landmarks with an extended Kalman filter.

    Which sighting belongs to which landmark is known; where the landmarks are is not.

    Parameters
    ----------
    log : SensorLog
        Its odometry, sightings and prior are used.
    stamp_delay : float
        Seconds by which the stamps of the estimate are late.

    Returns
    -------
    Estimate
        With the map at the end. The first sight of a landmark has no innovation.

    References
    ----------
    Lecture 04. Thrun, Burgard and Fox (2005), table 10.1.

    Examples
    --------
    >>> import numpy as np
    >>> from amrmetrics.benchmark import estimators, worlds
    >>> log, truth = worlds.make(np.random.default_rng(1), steps=300)
    >>> estimators.ekf_slam(log).map_points.shape
    (24, 2)
    """
    track = _Track(log)
    R = np.diag(log.sighting_std**2)
    frames = _by_step(log)
    size = 3 + 2 * len(log.landmarks)
    mean, P = np.zeros(size), np.zeros((size, size))
    mean[:3], P[:3, :3] = track.state, track.P
    place = {}
    n = 3
    for k in range(len(log.odometry)):
        started = perf_counter()
        mean[:3], F, G = motion_model(mean[:3], log.odometry[k], track.dt[k])
        P[:3, :n] = F @ P[:3, :n]
        P[:3, :3] = _symmetric(P[:3, :3] @ F.T + G @ track.Q @ G.T)
        P[3:n, :3] = P[:3, 3:n].T
        for landmark, z in frames[k + 1]:
            if landmark not in place:
                m = slice(n, n + 2)
                mean[m] = _place(mean[:3], z)
                _, H = measurement_model(mean[:3], mean[m])
                # Solve dz = H dx - H[:, :2] dm for the error dm of the new landmark.
                J = np.linalg.inv(H[:, :2])
                P[m, :n] = J @ H @ P[:3, :n]
                P[:n, m] = P[m, :n].T
                P[m, m] = _symmetric(J @ (H @ P[:3, :3] @ H.T + R) @ J.T)
                place[landmark] = n
                n += 2
                continue
            m = place[landmark]
            predicted, H = measurement_model(mean[:3], mean[m : m + 2])
            PHt = P[:n, :3] @ H.T - P[:n, m : m + 2] @ H[:, :2].T
            S = H @ PHt[:3] - H[:, :2] @ PHt[m : m + 2] + R
            nu = _innovation(z, predicted)
            white = np.linalg.solve(np.linalg.cholesky(S), np.column_stack([PHt.T, nu]))
            weighted, off = white[:, :n], white[:, n]
            mean[:n] += weighted.T @ off
            P[:n, :n] -= weighted.T @ weighted
            track.innovations.append(nu)
            track.S.append(S)
        track.state, track.P = mean[:3].copy(), P[:3, :3].copy()
        track.keep(k, started)
    points = np.full((len(log.landmarks), 2), np.nan)
    for landmark, m in place.items():
        points[landmark] = mean[m : m + 2]
    return track.estimate(stamp_delay, map_points=points)


def pose_graph(
    log: SensorLog,
    *,
    min_score: float = 0.85,
    loss: str = "linear",
    width: float = 2.0,
    stamp_delay: float = 0.0,
) -> Estimate:
    """Estimate all poses from odometry and loop closures.

    Every pose is a node. The graph is optimized anew in each frame in which a closure is
    accepted, from where it was; such frames take long, all others hardly any time.

    Parameters
    ----------
    log : SensorLog
        Its odometry, closure candidates, scores and prior are used, and for the map its
        sightings.
    min_score : float
        Candidates with at least this score become edges.
    loss : {"linear", "huber", "cauchy", "geman_mcclure"}
        What a closure costs, as in `amrmetrics.optimize`.
    width : float
        Of a robust kernel, in standard deviations.
    stamp_delay : float
        Seconds by which the stamps of the estimate are late.

    Returns
    -------
    Estimate
        The poses as they are at the end, which know of closures that came after them. The
        covariance of each is the exact block of the inverse information at the optimum,
        with closures weighted as the kernel has them, plus the prior's. Map points are
        means of what was sighted, seen from these poses. Accepted are edges with a weight
        of at least 0.2; closure scores are the weights, or with the linear loss the scores.
        The times are those of the frames; the covariances, at the end, are in none.

    Notes
    -----
    Let X_k change by Exp(xi_k) X_k. Without closures, xi is a random walk with independent
    steps; a closure measures the sum of the steps between its ends. So the normal equations
    are solved in the space of the closures, where they are dense and small, by the
    Sherman-Morrison-Woodbury identity. The steps are those of Gauss-Newton, halved while
    they raise the cost.

    References
    ----------
    Lecture 07. Grisetti, Kuemmerle, Stachniss and Burgard, A tutorial on graph-based SLAM,
    IEEE ITS Magazine 2 (2010). Zhang, Parameter estimation techniques: a tutorial, Image and
    Vision Computing 15 (1997), for the kernels.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> from amrmetrics.benchmark import estimators, worlds
    >>> log, truth = worlds.make(np.random.default_rng(1), steps=300, aliased=20)
    >>> for loss in ("linear", "cauchy"):
    ...     estimate = estimators.pose_graph(log, loss=loss)
    ...     print(f"{loss}: {am.ate(truth.poses, estimate.poses).rmse:.2f} m")
    linear: 8.47 m
    cauchy: 0.12 m
    """
    as_loss(loss, None if loss == "linear" else width, 3)
    graph = _Graph(log, LOSSES[loss], width)
    good = np.asarray(log.scores) >= min_score
    ends = np.asarray(log.candidates)[:, 1]
    seconds = np.empty(len(log.odometry))
    for k in range(len(log.odometry)):
        started = perf_counter()
        graph.append(k)
        new = np.flatnonzero(good & (ends == k + 1))
        if len(new):
            graph.close(new)
            graph.optimize(ONLINE_TOLERANCE)
        seconds[k] = perf_counter() - started
    started = perf_counter()
    graph.optimize(FINAL_TOLERANCE)
    seconds[-1] += perf_counter() - started
    weights = np.zeros(len(log.scores))
    weights[graph.chosen] = graph.weights()
    poses = graph.poses
    return Estimate(
        poses,
        stamps=log.stamps + stamp_delay,
        covariances=graph.covariances(),
        map_points=_map_points(log, poses),
        accepted=weights >= ACCEPTED,
        closure_scores=np.array(log.scores) if loss == "linear" else weights,
        frame_seconds=seconds,
    )


def systems() -> tuple[System, ...]:
    """Return the six default systems.

    Returns
    -------
    tuple of System
        dead_reckoning, ekf_localization, ekf_overconfident, ekf_slam, pose_graph,
        pose_graph_robust. Their thresholds were chosen in the scenario "yard".

    Examples
    --------
    >>> from amrmetrics.benchmark import estimators
    >>> [system.name for system in estimators.systems()][:2]
    ['dead_reckoning', 'ekf_localization']
    """
    gate = {"gate": 13.8, "lost_after": 10.0}
    return (
        System("dead_reckoning", dead_reckoning, description="Odometry alone."),
        System(
            "ekf_localization",
            ekf_localization,
            {"claimed": 1.0, **gate},
            description="EKF in a surveyed map; gives up when lost.",
        ),
        System(
            "ekf_overconfident",
            ekf_localization,
            {"claimed": 0.6, **gate},
            description="The same, claiming 0.6 of the standard deviations.",
        ),
        System("ekf_slam", ekf_slam, description="EKF that maps the landmarks; no survey."),
        System(
            "pose_graph",
            pose_graph,
            {"min_score": 0.85, "loss": "linear"},
            description="Odometry and every closure with a good score.",
        ),
        System(
            "pose_graph_robust",
            pose_graph,
            {"min_score": 0.85, "loss": "cauchy", "width": 2.0},
            description="The same with a Cauchy kernel on the closures.",
        ),
    )


class _Track:
    """A filter's state and what it leaves behind."""

    def __init__(self, log, claimed=1.0):
        self.log = log
        self.dt = np.diff(log.stamps)
        self.Q = claimed**2 * np.diag(log.odometry_std**2)
        self.state = np.array(log.prior, dtype=float)
        self.P = claimed**2 * np.array(log.prior_covariance, dtype=float)
        self.states, self.covariances = [self.state], [self.P]
        self.innovations, self.S, self.seconds = [], [], []

    def predict(self, k):
        self.state, F, G = motion_model(self.state, self.log.odometry[k], self.dt[k])
        self.P = _symmetric(F @ self.P @ F.T + G @ self.Q @ G.T)

    def keep(self, k, started):
        self.states.append(self.state)
        self.covariances.append(self.P)
        self.seconds.append(perf_counter() - started)

    def estimate(self, delay, **more):
        states, P = np.array(self.states), np.array(self.covariances)
        if self.innovations:
            more["innovations"] = np.array(self.innovations)
            more["innovation_covariances"] = np.array(self.S)
        return Estimate(
            planar_poses(states[:, :2], states[:, 2]),
            stamps=self.log.stamps[: len(states)] + delay,
            covariances=P,
            frame_seconds=np.array(self.seconds),
            **more,
        )


class _Graph:
    """A chain of poses with closures; see the notes of `pose_graph`."""

    def __init__(self, log, loss, width):
        self.log, self.loss, self.width = log, loss, width
        self.Z, self.Q = _motions(log)
        self.back, self.W = _groups.inverse(self.Z), np.linalg.inv(self.Q)
        self.all = np.empty((len(self.Z) + 1, 3, 3))
        self.all[0] = planar_poses(log.prior[None, :2], log.prior[2:])[0]
        self.n = 1
        self.chosen = np.empty(0, dtype=int)
        self.R = np.linalg.inv(log.closure_information)

    @property
    def poses(self):
        return self.all[: self.n]

    def append(self, k):
        self.all[k + 1] = self.all[k] @ self.Z[k]
        self.n = k + 2

    def close(self, new):
        self.chosen = np.concatenate([self.chosen, new])
        self.i, self.j = self.log.candidates[self.chosen].T
        self.closure_back = _groups.inverse(self.log.closures[self.chosen])

    def residuals(self, X):
        """Return the residuals of the chain and of the closures."""
        n = len(X) - 1
        chain = _groups.log(self.back[:n] @ _groups.inverse(X[:-1]) @ X[1:])
        closures = _groups.log(self.closure_back @ _groups.inverse(X[self.i]) @ X[self.j])
        return chain, closures

    def cost(self, chain, closures):
        """Return the cost, and the weights of the closures."""
        square = np.einsum("ma,ab,mb->m", closures, self.log.closure_information, closures)
        rho, weights = self.loss(square, self.width)
        own = np.einsum("ma,mab,mb->", chain, self.W[: len(chain)], chain, optimize=False)
        return own + rho.sum(), weights

    def weights(self):
        if not len(self.chosen):
            return np.empty(0)
        return self.cost(*self.residuals(self.poses))[1]

    def system(self, X, chain, closures, weights):
        """Return all that the normal equations consist of, linearized at X."""
        way = _groups.inverse(X)
        slope = _groups.right_jacobian_inverse(chain) @ _groups.adjoint(way[1:])
        back = np.linalg.inv(slope)
        step = -(back @ chain[:, :, None])[:, :, 0]
        S = back @ self.Q[: len(chain)] @ back.mT
        walk, spread = _summed(step), _summed(S)
        B = _groups.right_jacobian_inverse(closures) @ _groups.adjoint(way[self.j])
        low = np.maximum(self.i[:, None], self.i)
        high = np.maximum(np.minimum(self.j[:, None], self.j), low)
        K = B[:, None] @ (spread[high] - spread[low]) @ B.mT
        m = np.arange(len(B))
        K[m, m] += self.R / weights[:, None, None]
        K = K.transpose(0, 2, 1, 3).reshape(3 * len(B), 3 * len(B))
        missing = closures + (B @ (walk[self.j] - walk[self.i])[:, :, None])[:, :, 0]
        return step, S, spread, B, K, missing

    def step(self, X, chain, closures, weights):
        """Return the xi of each pose in a step of Gauss-Newton."""
        own, S, _, B, K, missing = self.system(X, chain, closures, weights)
        pull = -np.linalg.solve(K, missing.ravel()).reshape(missing.shape)
        pull = (B.mT @ pull[:, :, None])[:, :, 0]
        # A closure pulls at each step of the walk between its ends.
        force = np.zeros((len(X), 3))
        np.add.at(force, self.i, pull)
        np.subtract.at(force, self.j, pull)
        force = force.cumsum(axis=0)[:-1]
        return _summed(own + (S @ force[:, :, None])[:, :, 0])

    def optimize(self, tolerance):
        """Move the poses to where the cost is smallest, from where they are."""
        if not len(self.chosen):
            return
        X = self.poses.copy()
        residuals = self.residuals(X)
        cost, weights = self.cost(*residuals)
        for _ in range(MOST_STEPS):
            xi = self.step(X, *residuals, weights)
            for part in PARTS:
                moved = _groups.exp(part * xi) @ X
                found = self.residuals(moved)
                new_cost, new_weights = self.cost(*found)
                if new_cost <= cost:
                    break
            else:
                break
            gained = cost - new_cost
            X, residuals, cost, weights = moved, found, new_cost, new_weights
            if gained <= tolerance * (1 + cost):
                break
        self.all[: self.n] = X

    def covariances(self):
        """Return the covariance of each pose's error in the world frame."""
        X = self.poses
        if len(self.chosen):
            chain, closures = self.residuals(X)
            _, weights = self.cost(chain, closures)
            _, _, spread, B, K, _ = self.system(X, chain, closures, weights)
            k = np.arange(len(X))[:, None]
            A = (spread[np.minimum(k, self.j)] - spread[np.minimum(k, self.i)]) @ B.mT
            A = A.transpose(0, 2, 1, 3).reshape(3 * len(X), 3 * len(B))
            reduction = np.linalg.solve(K, A.T).T
            spread = spread - reduction.reshape(len(X), 3, -1) @ A.reshape(len(X), 3, -1).mT
        else:
            slope = _groups.adjoint(_groups.inverse(X[1:]))
            back = np.linalg.inv(slope)
            spread = _summed(back @ self.Q @ back.mT)
        T = np.broadcast_to(np.eye(3), X.shape).copy()
        T[:, 0, 2], T[:, 1, 2] = -X[:, 1, 2], X[:, 0, 2]
        start = np.linalg.inv(T[0])
        P = T @ (spread + start @ self.log.prior_covariance @ start.T) @ T.mT
        return _symmetric(P)


def _motions(log):
    """Return the motions that odometry measures, and the covariances of their errors."""
    dt = np.diff(log.stamps)
    v, w = log.odometry.T
    half = w * dt / 2
    c, s = np.cos(half), np.sin(half)
    Z = planar_poses(np.column_stack([v * dt * c, v * dt * s]), w * dt)
    # The errors of a motion model's chord, in the frame of the pose that it leads to.
    J = np.zeros((len(dt), 3, 2))
    J[:, 0, 0], J[:, 1, 0] = dt * c, -dt * s
    J[:, 0, 1], J[:, 1, 1], J[:, 2, 1] = v * dt**2 / 2 * s, v * dt**2 / 2 * c, dt
    noise = np.diag(log.odometry_std**2)
    return Z, J @ noise @ J.mT + SIDEWAYS**2 * np.diag([1.0, 1.0, 0.0])


def _symmetric(P):
    # Over a thousand steps, the rounding of a product like F P F^T would grow without bound.
    return (P + P.mT) / 2


def _summed(steps):
    """Return the sums of the first 0, 1, ..., N steps."""
    return np.concatenate([np.zeros_like(steps[:1]), steps.cumsum(axis=0)])


def _by_step(log):
    """Return for each pose what is sighted there: (landmark, (range, bearing))."""
    frames = [[] for _ in log.stamps]
    z = np.column_stack([log.sightings["range"], log.sightings["bearing"]])
    for row, step, landmark in zip(
        z, log.sightings["step"].tolist(), log.sightings["landmark"].tolist(), strict=True
    ):
        frames[step].append((landmark, row))
    return frames


def _innovation(measured, predicted):
    nu = measured - predicted
    nu[1] = wrap(nu[1])
    return nu


def _place(state, z):
    direction = state[2] + z[1]
    return state[:2] + z[0] * np.array([np.cos(direction), np.sin(direction)])


def _map_points(log, poses):
    """Return the mean of where each landmark was sighted, nan where it never was."""
    seen = log.sightings
    ahead = np.column_stack([np.cos(seen["bearing"]), np.sin(seen["bearing"])])
    X = poses[seen["step"]]
    points = (X[:, :2, :2] @ (seen["range"][:, None] * ahead)[:, :, None])[:, :, 0] + X[:, :2, 2]
    L = len(log.landmarks)
    count = np.bincount(seen["landmark"], minlength=L)
    sums = [np.bincount(seen["landmark"], column, minlength=L) for column in points.T]
    with np.errstate(invalid="ignore"):
        return np.column_stack(sums) / count[:, None]
