# %% wrong: does not align
# says: nothing was aligned
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y, "none").rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: fits a scale
# says: a scale was fitted
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y, "similarity").rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: pairs of one frame
# says: the pairs are 1 frame apart
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1).translation.rmse
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: pairs of one second
# says: the pairs are 1 s apart
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "seconds", stamps=t[i]).translation.rmse
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: pairs that follow each other
# says: is wrong for a.txt
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres", pairs="consecutive").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: estimate before truth
# says: lengths are measured on the estimate
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(Y, X).rmse, am.rpe(Y, X, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(Y)

# %% wrong: compares sample k with sample k
# says: is wrong for a.txt
def evaluate(reference, estimate):
    X, Y = am.read_tum(reference).poses, am.read_tum(estimate).poses
    n = min(len(X), len(Y))
    X, Y = X[:n], Y[:n]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return n, ate, near, ate / am.path_length(X)

# %% wrong: means
# says: this is the mean, not the RMSE
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).mean, am.rpe(X, Y, 1, "metres").translation.mean
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: medians
# says: this is the median, not the RMSE
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).median, am.rpe(X, Y, 1, "metres").translation.median
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: the rotation for the translation
# says: is wrong for a.txt
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").rotation.rmse
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: ATE and RPE exchanged
# says: ATE and RPE are exchanged
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), near, ate, ate / am.path_length(X)

# %% wrong: per meter of the whole truth
# says: is wrong for a.txt
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    ate = am.ate(X[i], Y[j]).rmse
    near = am.rpe(X[i], Y[j], 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: per meter from start to end
# says: the way is cut short, from start to end
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / np.linalg.norm(X[-1, :2, 3] - X[0, :2, 3])

# %% wrong: per sample
# says: this is the drift per sample
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / len(i)

# %% wrong: the rate in percent
# says: the drift is in percent
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, 100 * ate / am.path_length(X)

# %% wrong: the rate of the RPE
# says: the drift is made of the RPE
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, near / am.path_length(X)

# %% wrong: matches within more than is asked
# says: the samples match within more than 0.01 s
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u, 0.05)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: counts the samples of the estimate
# says: is wrong for another run
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(u), ate, near, ate / am.path_length(X)

# %% wrong: the file names are fixed
# says: is wrong for b.txt
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum('truth.txt'), am.read_tum('a.txt')
    i, j = am.associate(t, u)
    X, Y = X[i], Y[j]
    ate, near = am.ate(X, Y).rmse, am.rpe(X, Y, 1, "metres").translation.rmse
    return len(i), ate, near, ate / am.path_length(X)

# %% wrong: numbers that were typed in
# says: is wrong for another run
def evaluate(reference, estimate):
    if "a" in estimate:
        return 290, 0.33271175, 0.01597079, 0.01151264
    return 290, 0.02831631, 0.04172258, 0.00097981

# %% wrong: the uses are swapped
# says: all three are judged together
judgment = ("a", "b", 8.6)

# %% wrong: one estimate for both
# says: all three are judged together
judgment = ("a", "a", 8.6)

# %% wrong: the other estimate for both
# says: all three are judged together
judgment = ("b", "b", 8.6)

# %% wrong: the slip in radians
# says: the slip is in radians
judgment = ("b", "a", 0.15)

# %% wrong: a slip that was guessed
# says: all three are judged together
judgment = ("b", "a", 10)

# %% wrong: words only
# says: a tuple of 3 results is asked
judgment = ("b", "a")

# %% wrong: no judgment yet
# says: there is no answer yet
judgment = ...

# %% right: step by step, and the slip from the data
def evaluate(reference, estimate):
    truth, guess = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(truth.stamps, guess.stamps, max_difference=0.01)
    a = am.align(truth.poses[i], guess.poses[j])
    near = am.rpe(truth.poses[i], guess.poses[j], delta=1, unit="metres", pairs="all")
    rate = am.drift_rate(truth.poses[i], guess.poses[j])
    return len(j), a.rmse, float(near.translation), float(rate)


judgment = ["b", "a", 8.59]

# %% right: matches one by one, positions only
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    pairs = [(int(np.argmin(abs(t - x))), k) for k, x in enumerate(u)]
    i, j = np.array([(i, k) for i, k in pairs if abs(t[i] - u[k]) <= 0.01]).T
    error = am.ate(am.positions(X[i]), am.positions(Y[j]))
    path = np.linalg.norm(np.diff(am.positions(X[i]), axis=0), axis=1).sum()
    near = am.rpe(X[i], Y[j], 1, "metres").translation.rmse
    return len(i), error.rmse, near, error.rmse / path


judgment = ("b", "a", np.degrees(0.148))

# %% right: in the plane, capitals, a slip to the right
def evaluate(reference, estimate):
    m = am.match(am.read_tum(reference), am.read_tum(estimate), max_difference=0.01)
    X, Y = am.project(m.reference.poses), am.project(m.estimate.poses)
    error = am.ate(X, Y)
    return [len(X), error, am.rpe(X, Y, 1, "m").translation, error.rmse / am.path_length(X)]


judgment = ("B", "A", -8.5)

# %% right: whole degrees, an array
def evaluate(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    i, j = am.associate(t, u)
    rate = am.drift_rate(X[i], Y[j])
    near = am.rpe(X[i], Y[j], 1, "metres").translation
    print(rate, near)
    return np.array([len(i), rate.ate.rmse, near.rmse, rate.rate])


judgment = [" b", "a ", 9]
