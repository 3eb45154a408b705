# %% wrong: does not align
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y, "none").rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)


judgment = ("b", "a", 8.6)
# %% wrong: fits a scale
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y, "similarity").rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)


judgment = ("b", "a", 8.6)
# %% wrong: pairs of one frame
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1).translation.rmse
    return len(i), ate, near, ate / am.path_length(X)


judgment = ("b", "a", 8.6)
# %% wrong: estimate before truth
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(Y, X).rmse, am.rpe(Y, X, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(Y)


judgment = ("b", "a", 8.6)
# %% wrong: compares sample k with sample k
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    X, Y = am.read_tum(reference).poses, am.read_tum(estimate).poses
    X = X[: len(Y)]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(Y), ate, near, ate / am.path_length(X)


judgment = ("b", "a", 8.6)
# %% wrong: means
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).mean, am.rpe(X, Y, 1, "metres").translation.mean
    return len(i), ate, near, ate / am.path_length(X)


judgment = ("b", "a", 8.6)
# %% wrong: the uses are swapped
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)


judgment = ("a", "b", 8.6)
# %% wrong: the slip in radians
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)


judgment = ("b", "a", 0.15)
# %% wrong: no judgment yet
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)


judgment = ...
# %% wrong: per meter of the estimate
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(Y)


judgment = ("b", "a", 8.6)
# %% wrong: per meter from start to end
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / np.linalg.norm(X[-1, :2, 3] - X[0, :2, 3])


judgment = ("b", "a", 8.6)
# %% wrong: the rate in percent
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, 100 * ate / am.path_length(X)


judgment = ("b", "a", 8.6)
# %% right: step by step, and the slip from the data
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    truth, guess = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(truth.stamps, guess.stamps, max_difference=0.01)
    a = am.align(truth.poses[i], guess.poses[j])
    near = am.rpe(truth.poses[i], guess.poses[j], delta=1, unit="metres", pairs="all")
    rate = am.drift_rate(truth.poses[i], guess.poses[j])
    return len(j), a.rmse, float(near.translation), float(rate)


judgment = ["b", "a", 8.59]
# %% right: by interpolation of nothing, positions only
def evaluate(reference: str, estimate: str) -> tuple[int, float, float, float]:
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    pairs = [(int(np.argmin(abs(t - x))), k) for k, x in enumerate(u)]
    i, j = np.array([(i, k) for i, k in pairs if abs(t[i] - u[k]) <= 0.01]).T
    error = am.ate(am.positions(X[i]), am.positions(Y[j]))
    path = np.linalg.norm(np.diff(am.positions(X[i]), axis=0), axis=1).sum()
    near = am.rpe(X[i], Y[j], 1, "metres").translation.rmse
    return len(i), error.rmse, near, error.rmse / path


judgment = ("b", "a", np.degrees(0.148))
