"""A planar robot among landmarks, and filters that are consistent or not (lecture 04)."""

from time import perf_counter
from typing import NamedTuple

import numpy as np

from amrmetrics._arguments import as_count, as_generator, as_rows, as_size
from amrmetrics.errors import AmrError
from amrmetrics.poses import planar_poses, positions, wrap, yaw

# Around the circle that the robot of `drive` follows by default, meters.
LANDMARKS = ((6, 1), (5, 7), (0, 10), (-5, 8), (-7, 3), (-4, -3), (0, -2), (4, -4))


class Run(NamedTuple):
    """One drive, repeated with fresh noise. The world frame is fixed to the ground.

    Attributes
    ----------
    truth : (runs, T+1, 3, 3) array
        True poses at the times 0, dt, ..., T dt: the same drive in all runs, read-only.
    controls : (T, 2) array
        True speed (m/s) and turn rate (rad/s) in each step.
    odometry : (runs, T, 2) array
        The same as measured.
    landmarks : (L, 2) array
        True positions in the world frame, meters.
    visible : (T, L) bool array
        Which landmarks are in range at the end of each step.
    measurements : (runs, T, L, 2) array
        Range (m) and bearing (rad, from the robot's x axis, in [-pi, pi)) at the end of
        each step; nan where the landmark is not visible.
    prior : (runs, 3) array
        Where the robot believes to start: x, y, heading (m, m, rad).
    prior_covariance : (3, 3) array
        Of the errors of `prior`.
    odometry_std, measurement_std : (2,) array
        Standard deviations of the noise: m/s and rad/s; m and rad.
    dt : float
        Duration of a step, seconds.
    """

    truth: np.ndarray
    controls: np.ndarray
    odometry: np.ndarray
    landmarks: np.ndarray
    visible: np.ndarray
    measurements: np.ndarray
    prior: np.ndarray
    prior_covariance: np.ndarray
    odometry_std: np.ndarray
    measurement_std: np.ndarray
    dt: float


class Log(NamedTuple):
    """What a filter recorded.

    Attributes
    ----------
    estimate : (runs, T+1, 3, 3) array
        Estimated poses in the world frame; the first is the prior.
    covariances : (runs, T+1, 3, 3) array
        Of the errors in x, y, heading (m, m, rad) as `amrmetrics.pose_errors` has them.
    used : (T, L) bool array
        Which measurements updated the filter.
    innovations : (runs, T, L, 2) array
        Measured minus predicted range (m) and bearing (rad); nan where not used.
    S : (runs, T, L, 2, 2) array
        Their covariances; nan where not used.
    seconds : (T,) array
        Computing time of each step, for all runs together. All other fields are the same
        when the filter sees the same `Run` again.
    """

    estimate: np.ndarray
    covariances: np.ndarray
    used: np.ndarray
    innovations: np.ndarray
    S: np.ndarray
    seconds: np.ndarray


def motion_model(state, control, dt):
    """Move a unicycle by one step, along the chord at the mean heading; arguments unchecked.

    Parameters
    ----------
    state : (..., 3) array
        x, y, heading in the world frame; m, m, rad.
    control : (..., 2) array
        Speed (m/s) and turn rate (rad/s).
    dt : float
        Duration, seconds.

    Returns
    -------
    state : (..., 3) array
        The next state; its heading is not wrapped.
    F, G : (..., 3, 3) and (..., 3, 2) array
        Its derivatives with respect to `state` and to `control`.

    References
    ----------
    Lecture 04. Thrun, Burgard and Fox, Probabilistic Robotics (2005), section 5.3, has the
    arc; the chord differs from it by O(dt^3) and needs no case for a turn rate of zero.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.simulation.motion_model([0.0, 0.0, 0.0], [1.0, 0.0], dt=0.5)[0].tolist()
    [0.5, 0.0, 0.0]
    """
    state, control = np.asarray(state, dtype=float), np.asarray(control, dtype=float)
    v, w = control[..., 0], control[..., 1]
    middle = state[..., 2] + w * dt / 2
    c, s = dt * np.cos(middle), dt * np.sin(middle)
    F = np.zeros((*middle.shape, 3, 3))
    F[..., :, :] = np.eye(3)
    F[..., 0, 2], F[..., 1, 2] = -v * s, v * c
    G = np.zeros((*middle.shape, 3, 2))
    G[..., 0, 0], G[..., 1, 0], G[..., 2, 1] = c, s, dt
    G[..., :2, 1] = F[..., :2, 2] * dt / 2
    return state + np.stack([v * c, v * s, w * dt], axis=-1), F, G


def measurement_model(state, landmark):
    """Predict range and bearing of a landmark; arguments unchecked.

    Parameters
    ----------
    state : (..., 3) array
        x, y, heading in the world frame; m, m, rad.
    landmark : (..., 2) array
        Position in the world frame, meters, away from the robot.

    Returns
    -------
    z : (..., 2) array
        Range (m) and bearing (rad, from the robot's x axis, in [-pi, pi)).
    H : (..., 2, 3) array
        Its derivative with respect to `state`; that with respect to `landmark` is
        ``-H[..., :2]``.

    References
    ----------
    Lecture 04. Thrun, Burgard and Fox (2005), table 7.2.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> z, H = am.simulation.measurement_model([1.0, 0.0, np.pi / 2], [1.0, 2.0])
    >>> z.round(9).tolist()
    [2.0, 0.0]
    """
    state, landmark = np.asarray(state, dtype=float), np.asarray(landmark, dtype=float)
    dx, dy = np.moveaxis(landmark - state[..., :2], -1, 0)
    r = np.hypot(dx, dy)
    z = np.stack([r, wrap(np.arctan2(dy, dx) - state[..., 2])], axis=-1)
    H = np.zeros((*r.shape, 2, 3))
    H[..., 0, 0], H[..., 0, 1] = -dx / r, -dy / r
    H[..., 1, 0], H[..., 1, 1], H[..., 1, 2] = dy / r**2, -dx / r**2, -1
    return z, H


def drive(
    rng,
    landmarks=LANDMARKS,
    runs=1,
    steps=200,
    dt=0.1,
    speed=1.0,
    turn_rate=0.3,
    odometry_std=(0.1, 0.05),
    measurement_std=(0.1, 0.03),
    initial_std=(0.1, 0.1, 0.05),
    odometry_bias=(0.0, 0.0),
    measurement_bias=(0.0, 0.0),
    max_range=8.0,
):
    """Drive from the origin past landmarks and measure, `runs` times over.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of all noise.
    landmarks : (L, 2) array
        Positions in the world frame, meters, L >= 1.
    runs, steps : int
        Number of repetitions, and of steps T in each, >= 1.
    dt : float
        Duration of a step, seconds, > 0.
    speed, turn_rate : float or (T,) array
        What the robot does, m/s and rad/s; 0 and 0 to stand still.
    odometry_std : (2,) array
        Standard deviations of the noise of speed (m/s) and turn rate (rad/s), >= 0.
    measurement_std : (2,) array
        Standard deviations of the noise of range (m) and bearing (rad), > 0.
    initial_std : (3,) array
        Standard deviations of the prior's errors in x, y (m) and heading (rad), >= 0.
    odometry_bias : (2,) array
        Added to all odometry (m/s, rad/s), and no filter is told. Wheels that are 2 % smaller
        than the software believes are 0.02 times the speed.
    measurement_bias : (2,) array
        Added to all ranges (m) and bearings (rad), and no filter is told. A sensor mounted
        one degree askew is (0, 0.017).
    max_range : float
        Landmarks beyond it are not seen, meters, > 0. The sensor looks all around.

    Returns
    -------
    Run
        The truth, and what the robot measured.

    Raises
    ------
    AmrError
        If an argument has the wrong shape or is out of range, or if the robot passes a
        landmark within 5 standard deviations of the range: measured ranges could be negative.

    References
    ----------
    Lecture 04. Thrun, Burgard and Fox (2005), sections 5.3 and 6.6.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> run = am.simulation.drive(np.random.default_rng(4), runs=3)
    >>> run.truth.shape, run.measurements.shape
    ((3, 201, 3, 3), (3, 200, 8, 2))
    """
    as_generator(rng)
    landmarks = as_rows(landmarks, "landmarks", (2,), "landmarks")
    runs, steps = as_count(runs, "runs"), as_count(steps, "steps")
    dt, max_range = as_size(dt, "dt"), as_size(max_range, "max_range")
    speed = as_size(speed, "speed", (), (steps,), sign="")
    turn_rate = as_size(turn_rate, "turn_rate", (), (steps,), sign="")
    odometry_std = as_size(odometry_std, "odometry_std", (2,), sign=">= 0")
    measurement_std = as_size(measurement_std, "measurement_std", (2,))
    initial_std = as_size(initial_std, "initial_std", (3,), sign=">= 0")
    odometry_bias = as_size(odometry_bias, "odometry_bias", (2,), sign="")
    measurement_bias = as_size(measurement_bias, "measurement_bias", (2,), sign="")

    controls = np.empty((steps, 2))
    controls[:, 0], controls[:, 1] = speed, turn_rate
    states = np.zeros((steps + 1, 3))
    for k in range(steps):
        states[k + 1] = motion_model(states[k], controls[k], dt)[0]
    exact = measurement_model(states[1:, None], landmarks)[0]
    closest = exact[..., 0].min(axis=0)
    if closest.min() < 5 * measurement_std[0]:
        raise AmrError(
            f"landmarks[{closest.argmin()}] is {closest.min():.3g} m from the path; with "
            f"a range noise of {measurement_std[0]:g} m keep {5 * measurement_std[0]:g} m away."
        )
    visible = exact[..., 0] <= max_range

    def draw(std, *shape):
        return std * rng.standard_normal((runs, *shape, len(std)))

    prior = states[0] + draw(initial_std)
    odometry = controls + odometry_bias + draw(odometry_std, steps)
    measurements = exact + measurement_bias + draw(measurement_std, *visible.shape)
    measurements[..., 1] = wrap(measurements[..., 1])
    measurements[:, ~visible] = np.nan
    truth = planar_poses(states[:, :2], states[:, 2])
    return Run(
        np.broadcast_to(truth, (runs, *truth.shape)), controls, odometry, landmarks, visible,
        measurements, prior, np.diag(initial_std**2), odometry_std, measurement_std, dt,
    )  # fmt: skip


def ekf_localization(
    run, process_scale=1.0, measurement_scale=1.0, prior_scale=1.0, wrap_innovation=True
):
    """Localize the robot in a known map with an extended Kalman filter, all runs at once.

    Parameters
    ----------
    run : Run
        From `drive`. The filter uses odometry, measurements, prior and landmarks.
    process_scale, measurement_scale, prior_scale : float
        Claimed over true covariance of odometry, measurements and prior, > 0: below 1 the
        filter trusts them too much.
    wrap_innovation : bool
        False leaves the difference of two bearings in (-2 pi, 2 pi): for a landmark straight
        behind the robot it jumps by a full turn. A common mistake, for study.

    Returns
    -------
    Log
        Estimates, covariances, innovations with S, and computing times.

    Raises
    ------
    AmrError
        If `run` does not come from `drive` or a scale is not positive.

    Notes
    -----
    If all three scales are one number kappa, then P and S are kappa times those of the
    honest filter and the gain P H^T S^-1 is the same. So are the estimates and the ATE; the
    NEES and NIS are divided by kappa. Two filters, equally good, and one of them lies.

    Measurements of one instant are used one after the other, each linearized at the estimate
    that the one before left. Given the ones before, each innovation has covariance S.

    References
    ----------
    Lecture 04. Thrun, Burgard and Fox (2005), table 7.2. Bar-Shalom, Li and Kirubarajan,
    Estimation with Applications to Tracking and Navigation (2001), section 5.4.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> run = am.simulation.drive(np.random.default_rng(4), runs=50)
    >>> for kappa in (1, 1 / 9):
    ...     log = am.simulation.ekf_localization(run, kappa, kappa, kappa)
    ...     errors = am.pose_errors(run.truth[:, -1], log.estimate[:, -1])
    ...     test = am.consistency_test(am.nees(errors, log.covariances[:, -1]), dof=3)
    ...     print(f"{am.ate(run.truth[0], log.estimate[0]).rmse:.6f} m, {test.verdict}")
    0.019810 m, consistent
    0.019810 m, overconfident
    """
    Q, R = _noise(run, process_scale, measurement_scale)
    mean = run.prior
    P = np.broadcast_to(
        as_size(prior_scale, "prior_scale") * run.prior_covariance, (len(mean), 3, 3)
    )
    log, states = _new_log(run, P), [mean]
    for k in range(len(run.controls)):
        started = perf_counter()
        mean, F, G = motion_model(mean, run.odometry[:, k], run.dt)
        P = F @ P @ F.mT + G @ Q @ G.mT
        for j in np.flatnonzero(run.visible[k]):
            z, H = measurement_model(mean, run.landmarks[j])
            nu = _innovation(run.measurements[:, k, j], z, wrap_innovation)
            mean, P, S = _correct(mean, P, slice(3), H, nu, R)
            log.used[k, j], log.innovations[:, k, j], log.S[:, k, j] = True, nu, S
        states.append(mean)
        log.covariances[:, k + 1] = P
        log.seconds[k] = perf_counter() - started
    return _with_poses(log, states)


def ekf_slam(run, jacobians="estimate"):
    """Localize the robot and map the landmarks with an EKF, all runs at once.

    Which measurement belongs to which landmark is known; a landmark enters the state where it
    is first seen. Turning robot and map together changes no measurement, so no filter can
    learn the heading: its variance must not fall below the prior's. The standard filter's
    does, because it linearizes the same landmark at one estimate after the other.

    Parameters
    ----------
    run : Run
        From `drive`. The filter uses odometry, measurements and prior.
    jacobians : str
        Where the models are linearized: "estimate", as every robot has to, or "truth", the
        ideal filter that only a simulation can run, which learns no heading.

    Returns
    -------
    Log
        For the robot's pose. The first sight of a landmark has no innovation.

    Raises
    ------
    AmrError
        If `run` does not come from `drive` or `jacobians` is another word.

    References
    ----------
    Lecture 04. Thrun, Burgard and Fox (2005), table 10.1. Bailey, Nieto, Guivant, Stevens
    and Nebot, Consistency of the EKF-SLAM algorithm (IROS 2006). Huang and Dissanayake,
    Convergence and consistency analysis for extended Kalman filter based SLAM (IEEE
    Transactions on Robotics 23(5), 2007).

    Examples
    --------
    The robot stands still and looks, with a heading known to 0.3 rad.

    >>> import numpy as np
    >>> import amrmetrics as am
    >>> run = am.simulation.drive(np.random.default_rng(4), speed=0, turn_rate=0,
    ...     odometry_std=(0, 0), measurement_std=(0.3, 0.1), initial_std=(0.1, 0.1, 0.3))
    >>> for jacobians in ("truth", "estimate"):
    ...     P = am.simulation.ekf_slam(run, jacobians).covariances
    ...     print(f"{jacobians}: {np.sqrt(P[0, -1, 2, 2]):.3f} rad")
    truth: 0.300 rad
    estimate: 0.069 rad
    """
    if jacobians not in ("estimate", "truth"):
        raise AmrError(f"jacobians is {jacobians!r}; expected 'estimate' or 'truth'.")
    Q, R = _noise(run)
    runs, ideal = len(run.prior), jacobians == "truth"
    truth = np.concatenate([positions(run.truth[0]), yaw(run.truth[0])[:, None]], axis=1)
    size = 3 + 2 * len(run.landmarks)
    mean, P = np.zeros((runs, size)), np.zeros((runs, size, size))
    mean[:, :3], P[:, :3, :3] = run.prior, run.prior_covariance
    log, states, known = _new_log(run, P[:, :3, :3]), [run.prior], set()
    for k in range(len(run.controls)):
        started = perf_counter()
        moved, F, G = motion_model(mean[:, :3], run.odometry[:, k], run.dt)
        if ideal:
            _, F, G = motion_model(truth[k], run.controls[k], run.dt)
        mean[:, :3] = moved
        P[:, :3] = F @ P[:, :3]
        P[:, :, :3] = P[:, :, :3] @ F.mT
        P[:, :3, :3] += G @ Q @ G.mT
        for j in np.flatnonzero(run.visible[k]):
            z, m = run.measurements[:, k, j], slice(3 + 2 * j, 5 + 2 * j)
            if j not in known:
                mean[:, m] = _place(mean[:, :3], z)
            predicted, H = measurement_model(mean[:, :3], mean[:, m])
            if ideal:
                _, H = measurement_model(truth[k + 1], run.landmarks[j])
            if j not in known:
                known.add(j)
                # Solve dz = H dx - H[:, :2] dm for the error dm of the new landmark.
                J = np.linalg.inv(H[..., :2])
                P[:, m] = J @ H @ P[:, :3]
                P[:, :, m] = P[:, m].mT
                P[:, m, m] = J @ (H @ P[:, :3, :3] @ H.mT + R) @ J.mT
                continue
            nu = _innovation(z, predicted)
            columns = [0, 1, 2, m.start, m.start + 1]
            H = np.concatenate([H, -H[..., :2]], axis=-1)
            mean, P, S = _correct(mean, P, columns, H, nu, R)
            log.used[k, j], log.innovations[:, k, j], log.S[:, k, j] = True, nu, S
        states.append(mean[:, :3].copy())
        log.covariances[:, k + 1] = P[:, :3, :3]
        log.seconds[k] = perf_counter() - started
    return _with_poses(log, states)


def _correct(mean, P, columns, H, nu, R):
    """Update by one measurement of the state components in `columns`."""
    PHt = P[:, :, columns] @ H.mT
    S = H @ PHt[:, columns] + R
    gain = np.linalg.solve(S, PHt.mT).mT
    return mean + (gain @ nu[..., None])[..., 0], P - gain @ PHt.mT, S


def _innovation(measured, predicted, wrapped=True):
    nu = measured - predicted
    if wrapped:
        nu[..., 1] = wrap(nu[..., 1])
    return nu


def _place(state, z):
    """Return where the landmark is that was seen at range and bearing `z`."""
    direction = state[:, 2] + z[:, 1]
    return state[:, :2] + z[:, :1] * np.stack([np.cos(direction), np.sin(direction)], axis=-1)


def _noise(run, process_scale=1.0, measurement_scale=1.0):
    """Return the covariances Q and R that a filter claims."""
    if not isinstance(run, Run):
        raise AmrError(f"run is of type {type(run).__name__}; expected what drive returns.")
    Q = as_size(process_scale, "process_scale") * np.diag(run.odometry_std**2)
    R = as_size(measurement_scale, "measurement_scale") * np.diag(run.measurement_std**2)
    return Q, R


def _new_log(run, P):
    runs, steps, L, _ = run.measurements.shape
    covariances = np.empty((runs, steps + 1, 3, 3))
    covariances[:, 0] = P
    return Log(
        None, covariances, np.zeros((steps, L), dtype=bool), np.full((runs, steps, L, 2), np.nan),
        np.full((runs, steps, L, 2, 2), np.nan), np.empty(steps),
    )  # fmt: skip


def _with_poses(log, states):
    states = np.stack(states, axis=1)
    poses = planar_poses(states[..., :2].reshape(-1, 2), states[..., 2].ravel())
    return log._replace(estimate=poses.reshape(*states.shape[:2], 3, 3))
