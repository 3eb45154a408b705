# %% wrong: NEES only, both are process noise
# says: wrong_noise and stated: not all four words hold
wrong_noise = ["process", "process"]

# %% wrong: both are measurement noise
# says: wrong_noise and stated: not all four words hold
wrong_noise = ["measurement", "measurement"]

# %% wrong: the two noises are swapped
# says: wrong_noise and stated: not all four words hold
wrong_noise = ["measurement", "process"]

# %% wrong: large NEES is taken for a large covariance
# says: wrong_noise and stated: not all four words hold
stated = ["too large", "too small"]

# %% wrong: both too small
# says: wrong_noise and stated: not all four words hold
stated = ["too small", "too small"]

# %% wrong: robots in the wrong order
# says: the robots are swapped
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (1, 0)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() for k in (1, 0)]
wrong_noise = ["measurement", "process"]
stated = ["too large", "too small"]

# %% wrong: divided by the degrees of freedom
# says: you divided by the number of components
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() / 3 for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() / 2 for k in (0, 1)]

# %% wrong: both robots together
# says: mean_nees: shape (2,) is asked, you have 3.85608
mean_nees = am.nees(e, P).mean()
mean_nis = am.nis(nu, S).mean()
wrong_noise = "process"
stated = "too small"

# %% wrong: innovations with the covariance of the position
# says: mean_nis: [159.
mean_nis = [am.nis(nu[robot == k], P[robot == k][:, :2, :2]).mean() for k in (0, 1)]

# %% wrong: other words
# says: wrong_noise: two words are asked, each "process" or "measurement"
wrong_noise = ["odometry", "sensor"]
stated = ["overconfident", "underconfident"]

# %% wrong: the numbers only
# says: wrong_noise: there is no answer yet. Replace the dots
wrong_noise = ...
stated = ...

# %% wrong: the median
# says: these are medians
mean_nees = [np.median(am.nees(e[robot == k], P[robot == k])) for k in (0, 1)]
mean_nis = [np.median(am.nis(nu[robot == k], S[robot == k])) for k in (0, 1)]

# %% right: by reshaping, with tuples
mean_nees = tuple(am.nees(e, P).reshape(2, -1).mean(axis=1))
mean_nis = tuple(am.nis(nu, S).reshape(2, -1).mean(axis=1))
wrong_noise = ("process", "measurement")
stated = ("too small", "too large")

# %% right: from the definition, as an array
half = len(e) // 2
values = np.einsum("ki,kij,kj->k", e, np.linalg.inv(P), e)
mean_nees = np.array([values[:half].mean(), values[half:].mean()])
values = np.einsum("ki,kij,kj->k", nu, np.linalg.inv(S), nu)
mean_nis = np.array([values[:half].mean(), values[half:].mean()])

# %% right: typed from a printout with two decimals, words as an array
mean_nees = (6.33, 1.38)
mean_nis = (2.10, 0.51)
wrong_noise = np.array(["process", "measurement"])
stated = ("too small", "too large")

# %% wrong: variances only in the NIS
# says: you used the variances only, without the correlations
mean_nis = [
    (nu[robot == k] ** 2 / np.einsum("kii->ki", S[robot == k])).sum(axis=1).mean() for k in (0, 1)
]

# %% wrong: variances only in the NEES
# says: you used the variances only, without the correlations
mean_nees = [
    (e[robot == k] ** 2 / np.einsum("kii->ki", P[robot == k])).sum(axis=1).mean() for k in (0, 1)
]

# %% wrong: the NIS with one decimal
# says: you rounded to one decimal, and two are asked
mean_nis = (2.1, 0.5)

# %% wrong: every other row
# says: these are means of one half of the log, not of one robot
mean_nis = [am.nis(nu[k::2], S[k::2]).mean() for k in (0, 1)]

# %% wrong: both too large
# says: wrong_noise and stated: not all four words hold
stated = ["too large", "too large"]

# %% wrong: the fault of A is seen, that of B not
# says: wrong_noise and stated: not all four words hold
wrong_noise = ["process", "process"]
stated = ["too small", "too small"]

# %% wrong: sums
# says: these are sums, not means
mean_nees = [am.nees(e[robot == k], P[robot == k]).sum() for k in (0, 1)]

# %% right: SymPy numbers, words in capitals
import sympy as sp

mean_nees = [sp.Float(am.nees(e[robot == k], P[robot == k]).mean()) for k in (0, 1)]
wrong_noise = ["Process", "measurement "]

# %% right: from sums of the whitened innovations, errors scaled in place
white = np.linalg.solve(np.linalg.cholesky(S), nu[..., None])[..., 0]
mean_nis = [np.sum(white[robot == k] ** 2) / 160 for k in (0, 1)]
nu *= 0
