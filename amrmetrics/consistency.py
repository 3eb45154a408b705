"""Whether an estimator's covariance can be trusted: NEES, NIS and their tests (lecture 04).

With e ~ N(0, P) the NEES e^T P^-1 e is chi-square with as many degrees of freedom as e has
components; a filter whose P is too small has larger values, one whose P is too large smaller
ones. Both are wrong, so every test here is two-sided.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics import _intervals
from amrmetrics._arguments import as_count, as_numbers, as_pose_pair, as_probability
from amrmetrics._results import Result
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from amrmetrics._types import Array, ArrayLike

# Correlations of independent values stay inside 3 / sqrt(n) in 99.7 % of all recordings.
CORRELATED = 3.0


@dataclass(frozen=True)
class ConsistencyTest(Result):
    """What the mean of NEES or NIS values says about the covariance.

    Attributes
    ----------
    mean : float
        Mean value; `dof` is expected of a consistent filter.
    lower, upper : float
        Interval that holds the mean of a consistent filter with probability `confidence`.
    p_value : float
        Probability of a mean at least as far out, on either side, if it is consistent.
    verdict : str
        "consistent", "overconfident" (mean above, P too small) or "underconfident".
    n : int
        Number of values.
    n_effective : float
        Number of independent values that are worth as much; equals `n` unless successive
        values are correlated, and then the interval is computed with it.
    dof : int
        Degrees of freedom of one value.
    confidence : float
        Of the interval, in (0, 1).
    """

    mean: float
    lower: float
    upper: float
    p_value: float
    verdict: str
    n: int
    n_effective: float
    dof: int
    confidence: float

    def __repr__(self):
        count = f"n {self.n}"
        if self.n_effective < self.n:
            count += f", correlated in time: worth {self.n_effective:.1f} independent ones"
        return (
            f"{self.verdict}: mean {self.mean:.6g}, {100 * self.confidence:g} % of consistent "
            f"filters in [{self.lower:.6g}, {self.upper:.6g}], p {self.p_value:.3g}, "
            f"dof {self.dof}, {count}"
        )


def pose_errors(reference: ArrayLike, estimate: ArrayLike) -> Array:
    """Return what is to be added to the estimate, in the world frame, to get the reference.

    Parameters
    ----------
    reference, estimate : (N, d+1, d+1) array
        Poses in one world frame, d = 2 or 3, not aligned: a covariance speaks about the
        filter's own frame.

    Returns
    -------
    (N, 3) or (N, 6) array
        In the plane x, y (meters) and heading (radians, wrapped to [-pi, pi)); in space
        x, y, z and the rotation vector phi with R = Exp(phi) R_estimate, ||phi|| <= pi.
        Both parts are world-frame ("left") errors; a covariance of body-frame errors has
        to be rotated first.

    Raises
    ------
    AmrError
        If the poses are malformed or differ in number or dimension.

    References
    ----------
    Lecture 04. Sola, Deray and Atchuthan, A micro Lie theory for state estimation in
    robotics (2018), eqs. (26)-(27).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> truth = am.planar_poses([[2, 0]], [np.radians(-179)])
    >>> estimate = am.planar_poses([[1, 0]], [np.radians(179)])
    >>> e = am.pose_errors(truth, estimate)
    >>> e[0, :2].tolist(), round(float(np.degrees(e[0, 2])), 9)
    ([1.0, 0.0], 2.0)
    """
    from amrmetrics.poses import wrap

    X, Y = as_pose_pair(reference, estimate)
    d = X.shape[-1] - 1
    turn = X[:, :d, :d] @ Y[:, :d, :d].swapaxes(1, 2)
    if d == 2:
        rotation = wrap(np.arctan2(turn[:, 1, 0], turn[:, 0, 0]))[:, None]
    else:
        from scipy.spatial.transform import Rotation

        rotation = Rotation.from_matrix(turn).as_rotvec()
    return np.column_stack([X[:, :d, d] - Y[:, :d, d], rotation])


def nees(errors: ArrayLike, covariances: ArrayLike) -> Array:
    """Normalized estimation error squared, e^T P^-1 e.

    Parameters
    ----------
    errors : (N, n) array
        Estimation errors, headings wrapped (see `pose_errors`).
    covariances : (N, n, n) or (n, n) array
        What the filter claims, in the same frame and order; one for each error or one
        for all. Symmetric positive definite.

    Returns
    -------
    (N,) array
        Values >= 0, chi-square with n degrees of freedom if the claim is right.

    Raises
    ------
    AmrError
        If a covariance is not symmetric or not positive definite (with its index), or
        shapes do not fit.

    References
    ----------
    Lecture 04. Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking
    and Navigation (2001), eq. (5.4.2-4).

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.nees([[3.0, 0.0], [0.0, 3.0]], [[9.0, 0.0], [0.0, 1.0]]).tolist()
    [1.0, 9.0]
    """
    return _mahalanobis(errors, covariances, "errors", "covariances")


def nis(innovations: ArrayLike, covariances: ArrayLike) -> Array:
    """Normalized innovation squared, nu^T S^-1 nu; needs no ground truth.

    Parameters
    ----------
    innovations : (N, m) array
        Measurement minus prediction, bearings wrapped.
    covariances : (N, m, m) or (m, m) array
        Innovation covariances S = H P H^T + R. Symmetric positive definite.

    Returns
    -------
    (N,) array
        Values >= 0, chi-square with m degrees of freedom for a consistent filter.

    Raises
    ------
    AmrError
        If a covariance is not symmetric or not positive definite (with its index), or
        shapes do not fit.

    References
    ----------
    Lecture 04. Bar-Shalom, Li and Kirubarajan (2001), eq. (5.4.2-15).

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.nis([[0.2]], [[0.04]]).round(12).tolist()
    [1.0]
    """
    return _mahalanobis(innovations, covariances, "innovations", "covariances")


def consistency_test(values: ArrayLike, dof: int, confidence: float = 0.95) -> ConsistencyTest:
    """Test whether NEES or NIS values are what a consistent filter gives, two-sided.

    Parameters
    ----------
    values : (N,) or (M, T) array
        Independent values (one instant of N runs), successive values of one run, or M
        runs of T steps. Values that follow each other in time (the last axis) are tested
        for correlation.
    dof : int
        Dimension of the error, >= 1.
    confidence : float
        Probability, in (0, 1), of calling a consistent filter consistent.

    Returns
    -------
    ConsistencyTest
        Mean, interval, p-value and verdict.

    Raises
    ------
    AmrError
        If a value is negative or not finite, dof is no positive whole number, or
        confidence is outside (0, 1).

    References
    ----------
    Lecture 04. Bar-Shalom, Li and Kirubarajan (2001), section 5.4.2.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> values = np.random.default_rng(1).chisquare(3, size=100)
    >>> am.consistency_test(values, dof=3).verdict
    'consistent'
    >>> am.consistency_test(values / 2, dof=3).verdict
    'underconfident'
    """
    from scipy.stats import chi2

    values = as_numbers(values, "values")
    if values.ndim not in (1, 2) or not values.size:
        raise AmrError(f"values have shape {values.shape}; expected (N,) or (runs, steps), N >= 1.")
    if values.min() < 0:
        k = np.argwhere(values < 0)[0].tolist()
        raise AmrError(f"values{k} is {values.min():.6g}; a NEES or NIS cannot be negative.")
    dof, confidence = as_count(dof, "dof"), as_probability(confidence, "confidence")
    n, mean = values.size, float(values.mean())
    n_effective = n / _inflation(np.atleast_2d(values))
    total = n_effective * dof
    lower, upper = chi2.ppf([(1 - confidence) / 2, (1 + confidence) / 2], total) / n_effective
    tails = chi2.cdf(n_effective * mean, total), chi2.sf(n_effective * mean, total)
    verdict = (
        "overconfident" if mean > upper else "underconfident" if mean < lower else "consistent"
    )
    return ConsistencyTest(
        mean, float(lower), float(upper), float(min(1, 2 * min(tails))), verdict, n,
        float(n_effective), dof, confidence,
    )  # fmt: skip


def expected_nees(P: ArrayLike, Sigma: ArrayLike, bias: ArrayLike = 0) -> float:
    """Mean of the NEES when the filter claims P and the errors have covariance Sigma and a bias.

    Parameters
    ----------
    P, Sigma : (n, n) array
        Claimed and true covariance, symmetric positive definite.
    bias : (n,) array or float
        True mean of the error; a number stands for every component.

    Returns
    -------
    float
        trace(P^-1 Sigma) + b^T P^-1 b; n if the claim is right.

    Raises
    ------
    AmrError
        If P or Sigma is not a covariance, or the shapes do not fit.

    References
    ----------
    Lecture 04. Mathai and Provost, Quadratic Forms in Random Variables (1992),
    corollary 3.2b.1.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> am.expected_nees(np.eye(3), np.diag([1.0, 1.0, 4.0]), bias=[1, 0, 0])
    7.0
    """
    W, w = _whitened(P, Sigma, bias)
    return float(np.trace(W) + w @ w)


def nees_variance(P: ArrayLike, Sigma: ArrayLike, bias: ArrayLike = 0) -> float:
    """Variance of the NEES of Gaussian errors, in the situation of `expected_nees`.

    Parameters
    ----------
    P, Sigma : (n, n) array
        Claimed and true covariance, symmetric positive definite.
    bias : (n,) array or float
        True mean of the error.

    Returns
    -------
    float
        2 trace((P^-1 Sigma)^2) + 4 b^T P^-1 Sigma P^-1 b; 2n if the claim is right.

    Raises
    ------
    AmrError
        If P or Sigma is not a covariance, or the shapes do not fit.

    References
    ----------
    Lecture 04. Mathai and Provost (1992), corollary 3.2b.2.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> am.nees_variance(np.eye(3), np.eye(3))
    6.0
    """
    W, w = _whitened(P, Sigma, bias)
    return float(2 * np.vdot(W, W) + 4 * w @ W @ w)


def consistency_power(dof: int, trials: int, inflation: float, confidence: float = 0.95) -> float:
    """Probability that `consistency_test` notices a covariance P = inflation * Sigma.

    Parameters
    ----------
    dof : int
        Dimension of the error, >= 1.
    trials : int or array of int
        Number of independent values, >= 1.
    inflation : float or array
        Claimed over true covariance, > 0: below 1 overconfident, above 1 underconfident.
    confidence : float
        Of the test, in (0, 1).

    Returns
    -------
    float or array
        In (0, 1); 1 - confidence at inflation 1.

    Raises
    ------
    AmrError
        If an argument is out of range.

    References
    ----------
    Lecture 04: the mean times trials * inflation is chi-square with trials * dof degrees
    of freedom.

    Examples
    --------
    >>> import amrmetrics as am
    >>> round(am.consistency_power(3, 50, 0.8), 3)
    0.516
    """
    from scipy.stats import chi2

    dof, confidence = as_count(dof, "dof"), as_probability(confidence, "confidence")
    inflation, trials = as_numbers(inflation, "inflation"), as_numbers(trials, "trials")
    if inflation.size and inflation.min() <= 0:
        raise AmrError(f"inflation is {inflation.min():g}; a ratio of covariances is positive.")
    if (trials < 1).any() or (trials != np.round(trials)).any():
        raise AmrError(f"trials is {trials}; expected whole numbers of at least 1.")
    total = trials * dof
    lower, upper = chi2.ppf((1 - confidence) / 2, total), chi2.isf((1 - confidence) / 2, total)
    power = chi2.cdf(inflation * lower, total) + chi2.sf(inflation * upper, total)
    return power if np.ndim(power) else float(power)


def runs_needed(dof: int, inflation: float, power: float = 0.9, confidence: float = 0.95) -> int:
    """Smallest number of independent values that shows P = inflation * Sigma.

    Parameters
    ----------
    dof : int
        Dimension of the error, >= 1.
    inflation : float
        Claimed over true covariance, > 0 and not 1.
    power : float
        Wanted probability of noticing, in (0, 1) and above 1 - confidence.
    confidence : float
        Of the test, in (0, 1).

    Returns
    -------
    int
        Number of runs.

    Raises
    ------
    AmrError
        If an argument is out of range.

    References
    ----------
    Lecture 04, from `consistency_power`.

    Examples
    --------
    >>> import amrmetrics as am
    >>> n = am.runs_needed(3, 0.8)
    >>> am.consistency_power(3, n - 1, 0.8) < 0.9 <= am.consistency_power(3, n, 0.8)
    True
    """
    power, confidence = as_probability(power, "power"), as_probability(confidence, "confidence")
    if power <= 1 - confidence:
        raise AmrError(f"power is {power:g}; even a consistent filter is noticed that often.")
    if not abs(float(as_numbers(inflation, "inflation")) - 1) > 1e-4:
        raise AmrError(
            f"inflation is {inflation}; a claim within 1e-4 of the truth is never shown."
        )
    high = 1
    while consistency_power(dof, high, inflation, confidence) < power:
        high *= 2
    low = high // 2
    while high - low > 1:
        middle = (low + high) // 2
        enough = consistency_power(dof, middle, inflation, confidence) >= power
        low, high = (low, middle) if enough else (middle, high)
    return high


def _mahalanobis(e, P, name, cov_name):
    """Return e^T P^-1 e by a Cholesky factorization that runs over all samples at once."""
    e, P = as_numbers(e, name), as_numbers(P, cov_name)
    if e.ndim != 2 or not e.size:
        raise AmrError(f"{name} has shape {e.shape}; expected (N, n), one row per sample, N >= 1.")
    n = e.shape[1]
    if P.shape not in ((n, n), (len(e), n, n)):
        raise AmrError(
            f"{cov_name} has shape {P.shape}; {name} {e.shape} need ({n}, {n}) or "
            f"({len(e)}, {n}, {n})."
        )
    z = e.T.copy()
    L = np.moveaxis(P.reshape(-1, n, n), 0, -1).copy()
    _refuse_asymmetric(L, cov_name)
    for j in range(n):
        # The pivot is the variance of component j given the components before it.
        pivot = L[j, j]
        bad = pivot <= n * np.finfo(float).eps * P[..., j, j]
        if bad.any():
            which = f"[{int(np.argmax(bad))}]" if P.ndim == 3 else ""
            raise AmrError(
                f"{cov_name}{which} is not positive definite: it gives some direction no or a "
                "negative variance. A filter that reports this has failed numerically."
            )
        for i in range(j + 1, n):
            factor = L[i, j] / pivot
            z[i] -= factor * z[j]
            L[i, j + 1 :] = L[i, j + 1 :] - factor * L[j, j + 1 :]
        z[j] /= np.sqrt(pivot)
    return np.einsum("jn,jn->n", z, z)


def _refuse_asymmetric(P, name):
    off = np.abs(P - P.swapaxes(0, 1)).max((0, 1)) > 1e-8 * np.abs(P).max((0, 1))
    if off.any():
        which = f"[{int(np.argmax(off))}]" if len(off) > 1 else ""
        raise AmrError(
            f"{name}{which} is not symmetric, so it is no covariance. Use (P + P.T) / 2."
        )


def _whitened(P, Sigma, bias):
    """Return L^-1 Sigma L^-T and L^-1 b with P = L L^T: the errors as P sees them."""
    P, Sigma, bias = as_numbers(P, "P"), as_numbers(Sigma, "Sigma"), as_numbers(bias, "bias")
    if P.ndim != 2 or P.shape[0] != P.shape[1] or P.shape != Sigma.shape or not P.size:
        raise AmrError(f"P has shape {P.shape} and Sigma {Sigma.shape}; both must be (n, n).")
    n = len(P)
    if bias.shape not in ((), (n,)):
        raise AmrError(f"bias has shape {bias.shape}; expected ({n},) or one number.")
    for name, matrix in (("P", P), ("Sigma", Sigma)):
        _mahalanobis(np.ones((1, n)), matrix, "errors", name)
    L = np.linalg.cholesky(P)
    half = np.linalg.solve(L, Sigma)
    return np.linalg.solve(L, half.T), np.linalg.solve(L, np.broadcast_to(bias, n).astype(float))


def _inflation(values):
    """Return by how much correlation in time inflates the variance of the mean, >= 1.

    It is 1 if the first correlation is within what independent values show.
    """
    steps = values.shape[1]
    if steps < 10:
        return 1.0
    if values.var() <= 1e-20 * values.mean() ** 2:  # all equal, up to rounding
        return 1.0
    rho = _intervals.autocorrelation(values)[1 : steps // 2]
    if rho[0] <= CORRELATED / np.sqrt(values.size):
        return 1.0
    return _intervals.inflation(rho)
