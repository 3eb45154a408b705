# %% wrong: tests the invariance only
# says: aligns, then takes the shortcut
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    G = am.planar_poses([[5, 1]], [1.0])
    assert np.allclose(rpe(X, X_hat, 2), rpe(G @ X, X_hat, 2))
    assert np.allclose(rpe(X, X_hat, 2), rpe(X, G @ X_hat, 2))

# %% wrong: tests a perfect estimate only
# says: aligns, then takes the shortcut
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12, noise=0)
    assert np.allclose(rpe(X, X_hat, 2), 0)

# %% wrong: looks at the shape
# says: accepts an implementation that takes the shortcut
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    assert len(rpe(X, X_hat, 3)) == 9

# %% wrong: both in one frame, where the shortcut is exact
# says: accepts an implementation that takes the shortcut
def catches_shortcut(rpe) -> None:
    X = am.planar_poses(np.c_[np.arange(9), np.zeros(9)], np.zeros(9))
    X_hat = am.planar_poses(np.c_[1.1 * np.arange(9), np.zeros(9)], np.zeros(9))
    assert np.allclose(rpe(X, X_hat, 2), 0.2)

# %% wrong: returns a truth value
# says: use assert instead
def catches_shortcut(rpe) -> bool:
    X, X_hat = drive(12)
    return len(rpe(X, X_hat, 3)) == 9

# %% wrong: demands that the error is zero in any case
# says: rejects an implementation that is right
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    assert np.allclose(rpe(X, X_hat, 2), 0)

# %% wrong: tests that it differs from the shortcut
# says: aligns, then takes the shortcut
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    p, q = am.positions(X), am.positions(X_hat)
    assert not np.allclose(rpe(X, X_hat, 1), np.linalg.norm(np.diff(p - q, axis=0), axis=1))

# %% wrong: never calls it
# says: the library's rpe would do your work
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    assert am.rpe(X, X_hat, 1).translation.n == 11

# %% wrong: against the library
# says: the library's rpe would do your work
def catches_shortcut(rpe) -> None:
    for seed in range(3):
        X, X_hat = drive(20, seed=seed)
        assert np.allclose(rpe(X, X_hat, 4), am.rpe(X, X_hat, 4).translation.series)

# %% wrong: delta is always 1
# says: takes delta for 1, whatever it is
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(20)
    P = am.relative(X[:-1], X[1:])
    Q = am.relative(X_hat[:-1], X_hat[1:])
    assert np.allclose(rpe(X, X_hat, 1), np.linalg.norm(am.relative(P, Q)[:, :2, 2], axis=1))

# %% wrong: cases by hand of one step, and the invariance of two
# says: takes delta for 1, whatever it is
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    G = am.planar_poses([[5, 1]], [1.0])
    assert np.allclose(rpe(X, X_hat, 2), rpe(X, G @ X_hat, 2))
    still = am.planar_poses([[0, 0], [3, 0]], [0, 0])
    left = am.planar_poses([[0, 0], [0, 4]], [0, 0])
    turned = am.planar_poses([[0, 0], [3, 0]], [0, np.pi / 2])
    assert np.allclose(rpe(still, left, 1), 5)
    assert np.allclose(rpe(still, turned, 1), 0)
    assert np.allclose(rpe(turned, left, 1), 5)

# %% right: reads the errors that it gets, one by one
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    for k, error in enumerate(rpe(X, X_hat, 3)):
        P, Q = am.relative(X[k], X[k + 3]), am.relative(X_hat[k], X_hat[k + 3])
        assert np.isclose(error, np.hypot(*am.relative(P, Q)[:2, 2]))

# %% wrong: compares the RMSE of the series only
# says: accepts an implementation
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    P, Q = am.relative(X[:-3], X[3:]), am.relative(X_hat[:-3], X_hat[3:])
    right = np.linalg.norm(am.relative(P, Q)[:, :2, 2], axis=1)
    found = rpe(X, X_hat, 3)
    assert abs(np.sqrt(np.mean(found**2)) - np.sqrt(np.mean(right**2))) < 0.05

# %% wrong: compares the sums of the series
# says: returns the errors in the wrong order
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(20)
    E = am.relative(am.relative(X[:-3], X[3:]), am.relative(X_hat[:-3], X_hat[3:]))
    assert np.isclose(np.sum(rpe(X, X_hat, 3)), np.linalg.norm(E[:, :2, 2], axis=1).sum())

# %% wrong: an upper limit
# says: compares lengths only
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(20)
    E = am.relative(am.relative(X[:-3], X[3:]), am.relative(X_hat[:-3], X_hat[3:]))
    assert np.all(rpe(X, X_hat, 3) <= np.linalg.norm(E[:, :2, 2], axis=1) + 1e-9)

# %% wrong: the first error only
# says: is wrong for the last pair
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(20)
    E = am.relative(am.relative(X[0], X[3]), am.relative(X_hat[0], X_hat[3]))
    assert np.isclose(rpe(X, X_hat, 3)[0], np.hypot(*E[:2, 2]))

# %% wrong: the library by a default argument
# says: would do your work here
def catches_shortcut(rpe, library=am.rpe):
    X, X_hat = drive(12)
    assert np.allclose(rpe(X, X_hat, 3), library(X, X_hat, 3).translation.series)

# %% wrong: to within half a meter
# says: aligns, then takes the shortcut
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    P, Q = am.relative(X[:-3], X[3:]), am.relative(X_hat[:-3], X_hat[3:])
    right = np.linalg.norm(am.relative(P, Q)[:, :2, 2], axis=1)
    assert len(rpe(X, X_hat, 3)) == 9
    assert np.allclose(rpe(X, X_hat, 3), right, atol=0.5)

# %% wrong: calls it wrong, whatever it does
# says: rejects an implementation that is right
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12)
    rpe(X, X_hat, 3)
    raise AssertionError("no")

# %% right: the definition, vectorized
def catches_shortcut(rpe) -> None:
    for delta in (1, 2, 5):
        X, X_hat = drive(15, seed=delta)
        P = am.relative(X[:-delta], X[delta:])
        Q = am.relative(X_hat[:-delta], X_hat[delta:])
        right = np.linalg.norm(am.positions(am.relative(P, Q)), axis=1)
        found = np.asarray(rpe(X, X_hat, delta))
        assert found.shape == right.shape
        assert np.allclose(found, right)

# %% right: NumPy's own assertion, lengths not compared
def by_hand(X, Y, d):
    E = am.relative(am.relative(X[:-d], X[d:]), am.relative(Y[:-d], Y[d:]))
    return np.linalg.norm(E[:, :2, 2], axis=1)
def catches_shortcut(rpe):
    X, Y = drive(20)
    np.testing.assert_allclose(rpe(X, Y, 5), by_hand(X, Y, 5))
    assert np.allclose(rpe(X, Y, 2), by_hand(X, Y, 2))

# %% right: one delta, by local steps
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(12, noise=0.2)
    local = []
    for Z in (X, X_hat):
        step = Z[4:, :2, 2] - Z[:-4, :2, 2]
        local.append(np.einsum("kji,kj->ki", Z[:-4, :2, :2], step))
    right = np.hypot(*(local[0] - local[1]).T)
    found = rpe(X, X_hat, 4)
    assert len(found) == 8, "how many pairs?"
    assert np.abs(found - right).max() < 1e-9

# %% right: against the function of part c
def rpe_by_hand(reference, estimate, delta):
    inv = np.linalg.inv
    found = []
    for k in range(len(reference) - delta):
        U = inv(reference[k]) @ reference[k + delta]
        V = inv(estimate[k]) @ estimate[k + delta]
        found.append(np.linalg.norm((inv(U) @ V)[:2, 2]))
    return found
def catches_shortcut(rpe) -> None:
    X, X_hat = drive(10)
    for delta in range(1, 10):
        mine = rpe_by_hand(X, X_hat, delta)
        theirs = rpe(X, X_hat, delta)
        assert len(mine) == len(theirs) and np.allclose(mine, theirs, atol=1e-7)

# %% right: a case by hand of two steps, the invariance, and noise
def catches_shortcut(rpe) -> None:
    X = am.planar_poses([[0, 0], [3, 0], [6, 0], [6, 3]], np.radians([0, 0, 90, 90]))
    Y = am.planar_poses([[0, 0], [3, 0], [3, 3], [0, 3]], np.radians([0, 90, 90, 180]))
    assert np.allclose(rpe(X, Y, 1), [0, 0, 3 * 2**0.5])
    assert np.allclose(rpe(X, Y, 2), [18**0.5, 0])
    truth, guess = drive(12)
    G = am.planar_poses([[5, 1]], [1.0])
    for delta in (1, 4):
        series = rpe(truth, guess, delta)
        assert len(series) == 12 - delta
        assert np.allclose(series, rpe(G @ truth, guess, delta))
        assert np.allclose(series, rpe(truth, G @ guess, delta))
        for k in range(12 - delta):
            a = np.linalg.solve(truth[k], truth[k + delta])
            b = np.linalg.solve(guess[k], guess[k + delta])
            assert abs(series[k] - np.linalg.norm(np.linalg.solve(a, b)[:2, 2])) < 1e-8
