# %% wrong: the sign of the offset is turned
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = -am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: truth and estimate are swapped
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(estimate), am.read_tum(reference)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: nothing is aligned
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j], "none").rmse, am.ate(X[k], Y[m], "none").rmse

# %% wrong: a scale is fitted
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    a, b = am.ate(X[i], Y[j], "similarity"), am.ate(X[k], Y[m], "similarity")
    return offset, len(k), a.rmse, b.rmse

# %% wrong: the mean for the RMSE
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).mean, am.ate(X[k], Y[m]).mean

# %% wrong: the two ATE are swapped
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[k], Y[m]).rmse, am.ate(X[i], Y[j]).rmse

# %% wrong: the difference of the first stamps is taken for the offset
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = t[0] - u[0]
    (i, j), (k, m) = am.associate(t, u, 0.03), am.associate(t, u, 0.03, offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: samples are paired by their number
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    n = len(u)
    return offset, n, am.ate(X[:n], Y).rmse, am.ate(X[:n], Y).rmse

# %% wrong: the tolerance of the library, not the one that is asked
def synchronize(reference, estimate):
    (t, X), (u, Y) = am.read_tum(reference), am.read_tum(estimate)
    offset = am.clock_offset(t, X, u, Y)
    (i, j), (k, m) = am.associate(t, u, offset=0), am.associate(t, u, offset=offset)
    return offset, len(k), am.ate(X[i], Y[j]).rmse, am.ate(X[k], Y[m]).rmse

# %% wrong: only the offset
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
