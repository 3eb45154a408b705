"""Intervals that come from counting: for a quantile, for a share, for values that depend.

They assume nothing about the shape of a distribution. How many of n independent values lie
below a quantile is a binomial count, and so is how many frames miss a deadline.
"""

import numpy as np

# Independent frames are taken for dependent with this probability: three standard deviations
# of a normal variable on one side, as in `consistency`.
FALSE_ALARM = 0.00135


def smallest_sample(q, confidence):
    """Return the least n whose smallest and largest value enclose the quantile q surely enough.

    All n lie below it with probability q^n, all above it with (1 - q)^n.
    """
    larger = max(q, 1 - q)
    n = max(1, int(np.log1p(-confidence) / np.log(larger)) - 1)
    while 1 - q**n - (1 - q) ** n < confidence:
        n += 1
    return n


def quantile_ranks(n, q, confidence):
    """Return the ranks l, u (from 1) of the order statistics that enclose the quantile q.

    The probability of a miss is at most (1 - confidence) / 2 on each side where n allows it.
    Where the largest value is not enough for that, it is the limit all the same, and the
    other side gets what remains of 1 - confidence; likewise with the smallest. A limit that
    n independent values cannot give is None.
    """
    from scipy.stats import binom

    if q < 0.5:
        upper, lower = quantile_ranks(n, 1 - q, confidence)
        return tuple(rank and n + 1 - rank for rank in (lower, upper))
    miss = 1 - confidence
    if n < smallest_sample(q, confidence):
        low = int(binom.ppf(miss, n, q))
        return (low if q > 0.5 and low >= 1 else None), None
    low, high = int(binom.ppf(miss / 2, n, q)), int(binom.isf(miss / 2, n, q)) + 1
    if high > n:
        low, high = int(binom.ppf(miss - q**n, n, q)), n
    return max(low, 1), high


def spread_ranks(ranks, n, n_effective):
    """Return ranks among n dependent values that are worth `n_effective` independent ones."""
    low, high = ranks
    low = low and int((low - 1) * n // n_effective) + 1
    high = high and n - int((n_effective - high) * n // n_effective)
    return low, high


def share_interval(count, n, confidence):
    """Return the limits of Clopper and Pearson for a share of which `count` of n were seen."""
    from scipy.stats import beta

    tail = (1 - confidence) / 2
    lower = beta.ppf(tail, count, n - count + 1) if count > 0 else 0.0
    upper = beta.isf(tail, count + 1, n - count) if count < n else 1.0
    return float(lower), float(upper)


def effective_number(marked):
    """Return how many independent values are worth as much as these, to count the marked ones.

    It is n unless the marked values stand together so often that independent ones do so with
    probability FALSE_ALARM only (Stevens, Annals of Eugenics 9 (1939): the number of groups
    is hypergeometric); then n over 1 + 2 sum rho_k, summed while the correlations rho_k of
    the marks are positive.
    """
    from scipy.stats import hypergeom

    n, k = len(marked), int(marked.sum())
    if not 0 < k < n:
        return n
    groups = int(marked[0]) + int((marked[1:] & ~marked[:-1]).sum())
    if hypergeom.cdf(groups, n, n - k + 1, k) > FALSE_ALARM:
        return n
    rho = autocorrelation(marked.astype(float))[1 : n // 2]
    return max(1.0, n / inflation(rho))


def inflation(rho):
    """Return 1 + 2 sum rho_k, summed while the correlations at the lags 1, 2, ... are positive.

    By so much correlation in time inflates the variance of a mean.
    """
    ends = np.flatnonzero(rho <= 0)
    return 1 + 2 * float(rho[: ends[0] if len(ends) else None].sum())


def autocorrelation(x):
    """Return the correlation with itself, 0 to n - 1 values later, of one run or of several.

    Several runs (runs, n) have one mean and one variance.
    """
    from scipy.fft import irfft, next_fast_len, rfft

    n = x.shape[-1]
    size = next_fast_len(2 * n, real=True)
    spectrum = np.atleast_2d(rfft(x - x.mean(), size))
    products = irfft((spectrum.real**2 + spectrum.imag**2).sum(0), size)[:n]
    return products / np.arange(n, 0, -1) * (n / products[0])
