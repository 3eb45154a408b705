# %% wrong: does not align
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    return len(i), am.ate(X, Y, "none").rmse, am.rpe(X, Y, 1, "metres").translation.rmse


judgment = ("b", "a", 8.6)
# %% wrong: fits a scale
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    return len(i), am.ate(X, Y, "similarity").rmse, am.rpe(X, Y, 1, "metres").translation.rmse


judgment = ("b", "a", 8.6)
# %% wrong: pairs of one frame
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    return len(i), am.ate(X, Y).rmse, am.rpe(X, Y, 1).translation.rmse


judgment = ("b", "a", 8.6)
# %% wrong: estimate before truth
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    return len(i), am.ate(Y, X).rmse, am.rpe(Y, X, 1, "metres").translation.rmse


judgment = ("b", "a", 8.6)
# %% wrong: compares sample k with sample k
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    X, Y = am.read_tum(reference).poses, am.read_tum(estimate).poses
    X = X[: len(Y)]
    return len(Y), am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse


judgment = ("b", "a", 8.6)
# %% wrong: means
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    return len(i), am.ate(X, Y).mean, am.rpe(X, Y, 1, "metres").translation.mean


judgment = ("b", "a", 8.6)
# %% wrong: the uses are swapped
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    return len(i), am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse


judgment = ("a", "b", 8.6)
# %% wrong: the slip in radians
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    return len(i), am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse


judgment = ("b", "a", 0.15)
# %% wrong: no judgment yet
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    return len(i), am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse


judgment = ...
# %% right: step by step, and the slip from the data
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    truth, guess = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(truth.stamps, guess.stamps, max_difference=0.01)
    a = am.align(truth.poses[i], guess.poses[j])
    near = am.rpe(truth.poses[i], guess.poses[j], delta=1, unit="metres", pairs="all")
    return len(j), a.rmse, float(near.translation)


judgment = ["b", "a", 8.59]
# %% right: by interpolation of nothing, positions only
def evaluate(reference: str, estimate: str) -> tuple[int, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    pairs = [(int(np.argmin(abs(t - x))), k) for k, x in enumerate(u)]
    i, j = np.array([(i, k) for i, k in pairs if abs(t[i] - u[k]) <= 0.01]).T
    error = am.ate(am.positions(X[i]), am.positions(Y[j]))
    return len(i), error.rmse, am.rpe(X[i], Y[j], 1, "metres").translation.rmse


judgment = ("b", "a", np.degrees(0.148))
