# %% wrong: the sign of the offset is turned
# says: the sign of the offset is turned
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = -am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: truth and estimate are swapped
# says: truth and estimate are swapped
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(estimate), am.read_tum(reference)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: nothing is aligned
# says: nothing was aligned
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j], "none").rmse, am.ate(X[k], Y[m], "none").rmse

# %% wrong: a scale is fitted
# says: a scale was fitted, too
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    a, b = am.ate(X[i], Y[j], "similarity"), am.ate(X[k], Y[m], "similarity")
    return offset, len(k), a.rmse, b.rmse

# %% wrong: the mean for the RMSE
# says: this is the mean, not the RMSE
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).mean, am.ate(X[k], Y[m]).mean

# %% wrong: the two ATE are swapped
# says: the two ATE are swapped
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[k], Y[m]).rmse, am.ate(X[i], Y[j]).rmse

# %% wrong: the pairs are counted without the offset
# says: the pairs are counted without the offset
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    i, j = am.associate(t, u, 0.03)
    k, m = am.associate(t, u, 0.03, offset)
    return offset, len(i), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: the file names are fixed in the function
# says: is wrong for another run
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum("reference.txt"), am.read_tum("estimate.txt")
    offset = am.clock_offset(t, X, u, Y)
    i, j = am.associate(t, u, 0.03)
    k, m = am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: four numbers that were typed in
# says: is wrong for another run
def synchronize(reference, estimate):
    return -0.381224, 220, 0.2208353, 0.0170348

# %% wrong: the offset was typed in
# says: is wrong for another run
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = -0.381224
    i, j = am.associate(t, u, 0.03)
    k, m = am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: the difference of the first stamps is taken for the offset
# says: you took the difference of the first stamps
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = t[0] - u[0]
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: samples are paired by their number
# says: samples are paired by their number
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    n = min(len(t), len(u))
    return offset, n, am.ate(X[:n], Y[:n]).rmse, am.ate(X[:n], Y[:n]).rmse

# %% wrong: the tolerance of the library, not the one that is asked
# says: no stamps match within max_difference=0.01 s
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, offset=0), am.associate(t, u, offset=offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: the samples of the estimate, matched or not
# says: is wrong for another run
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(u), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: matches within less than is asked
# says: is wrong for another run
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.02), am.associate(t, u, 0.02, offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: both errors with the offset
# says: both ATE are taken with the offset
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    k, m = am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[k], Y[m]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: milliseconds
# says: the offset is in milliseconds
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return 1000 * offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: the estimate is interpolated, no pairs are counted
# says: is wrong for the two files
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    v = u + offset
    inside = (v >= t[0]) & (v <= t[-1])
    late = am.ate(am.interpolate(t, X, u), Y).rmse
    return offset, inside.sum(), late, am.ate(am.interpolate(t, X, v[inside]), Y[inside]).rmse

# %% wrong: only the offset
# says: a tuple of 4 results is asked
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    return am.clock_offset(t, X, u, Y)

# %% right: positions only
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    p, q = am.positions(X), am.positions(Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(m), float(am.ate(p[i], q[j])), float(am.ate(p[k], q[m]))

# %% right: shifted stamps, and the RMSE by hand
def synchronize(reference, estimate):
    t, X = am.read_tum(reference)
    u, Y = am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    results = []
    for stamps in (u, u + offset):
        i, j = am.associate(t, stamps, max_difference=0.03)
        a = am.align(X[i], Y[j])
        left = am.positions(X[i]) - a.apply(am.positions(Y[j]))
        results.append(np.sqrt((left**2).sum(axis=1).mean()))
    return [offset, len(j), *results]

# %% right: in the plane
def synchronize(reference, estimate):
    print("reading", reference)
    true, seen = am.read_tum(reference), am.read_tum(estimate)
    X, Y = am.project(true.poses), am.project(seen.poses)
    offset = float(am.clock_offset(true.stamps, X, seen.stamps, Y))
    found = []
    for shift in (0.0, offset):
        i, j = am.associate(true.stamps, seen.stamps, 0.03, shift)
        found.append(am.ate(X[i], Y[j]).rmse)
    return np.array([offset, len(i), *found])

# %% right: with match
def synchronize(reference, estimate):
    true, seen = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(true.stamps, true.poses, seen.stamps, seen.poses)
    errors = []
    for shift in (0, offset):
        i, j = am.associate(true.stamps, seen.stamps, offset=shift, max_difference=0.03)
        errors += [am.ate(true.poses[i], seen.poses[j], align="rigid")]
    return offset, len(i), errors[0], errors[1]
