# %% wrong: NEES only, both are process noise
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() for k in (0, 1)]
wrong_noise = ["process", "process"]
stated = ["too small", "too large"]

# %% wrong: both are measurement noise
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() for k in (0, 1)]
wrong_noise = ["measurement", "measurement"]
stated = ["too small", "too large"]

# %% wrong: the two noises are swapped
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() for k in (0, 1)]
wrong_noise = ["measurement", "process"]
stated = ["too small", "too large"]

# %% wrong: large NEES is taken for a large covariance
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() for k in (0, 1)]
wrong_noise = ["process", "measurement"]
stated = ["too large", "too small"]

# %% wrong: both too small
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() for k in (0, 1)]
wrong_noise = ["process", "measurement"]
stated = ["too small", "too small"]

# %% wrong: robots in the wrong order
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (1, 0)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() for k in (1, 0)]
wrong_noise = ["measurement", "process"]
stated = ["too large", "too small"]

# %% wrong: divided by the degrees of freedom
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() / 3 for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() / 2 for k in (0, 1)]
wrong_noise = ["process", "measurement"]
stated = ["too small", "too large"]

# %% wrong: both robots together
mean_nees = am.nees(e, P).mean()
mean_nis = am.nis(nu, S).mean()
wrong_noise = "process"
stated = "too small"

# %% wrong: innovations with the covariance of the position
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], P[robot == k][:, :2, :2]).mean() for k in (0, 1)]
wrong_noise = ["process", "measurement"]
stated = ["too small", "too large"]

# %% wrong: other words
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() for k in (0, 1)]
wrong_noise = ["odometry", "sensor"]
stated = ["overconfident", "underconfident"]

# %% wrong: the numbers only
mean_nees = [am.nees(e[robot == k], P[robot == k]).mean() for k in (0, 1)]
mean_nis = [am.nis(nu[robot == k], S[robot == k]).mean() for k in (0, 1)]
wrong_noise = ...
stated = ...

# %% wrong: the median
mean_nees = [np.median(am.nees(e[robot == k], P[robot == k])) for k in (0, 1)]
mean_nis = [np.median(am.nis(nu[robot == k], S[robot == k])) for k in (0, 1)]
wrong_noise = ["process", "measurement"]
stated = ["too small", "too large"]

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
wrong_noise = ["process", "measurement"]
stated = ["too small", "too large"]

# %% right: typed from a printout with two decimals, words as an array
mean_nees = (6.33, 1.38)
mean_nis = (2.10, 0.51)
wrong_noise = np.array(["process", "measurement"])
stated = ("too small", "too large")
