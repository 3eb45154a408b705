# %% wrong: tests the invariance only
def catches_shortcut(rpe) -> None:
    """Moves both."""
    X, X_hat = drive(12)
    G = am.planar_poses([[5, 1]], [1.0])
    assert np.allclose(rpe(X, X_hat, 2), rpe(G @ X, X_hat, 2))
    assert np.allclose(rpe(X, X_hat, 2), rpe(X, G @ X_hat, 2))
# %% wrong: tests a perfect estimate only
def catches_shortcut(rpe) -> None:
    """No noise."""
    X, X_hat = drive(12, noise=0)
    assert np.allclose(rpe(X, X_hat, 2), 0)
# %% wrong: looks at the shape
def catches_shortcut(rpe) -> None:
    """N - delta."""
    X, X_hat = drive(12)
    assert len(rpe(X, X_hat, 3)) == 9
# %% wrong: both in one frame, where the shortcut is exact
def catches_shortcut(rpe) -> None:
    """The headings agree."""
    X = am.planar_poses(np.c_[np.arange(9), np.zeros(9)], np.zeros(9))
    X_hat = am.planar_poses(np.c_[1.1 * np.arange(9), np.zeros(9)], np.zeros(9))
    assert np.allclose(rpe(X, X_hat, 2), 0.2)
# %% wrong: returns a truth value
def catches_shortcut(rpe) -> bool:
    """Forgets the assert."""
    X, X_hat = drive(12)
    return np.allclose(rpe(X, X_hat, 3), am.rpe(X, X_hat, 3).translation.series)
# %% wrong: demands that the error is zero in any case
def catches_shortcut(rpe) -> None:
    """Too strict."""
    X, X_hat = drive(12)
    assert np.allclose(rpe(X, X_hat, 2), 0)
# %% wrong: tests that it differs from the shortcut
def catches_shortcut(rpe) -> None:
    """Anything else passes."""
    X, X_hat = drive(12)
    p, q = am.positions(X), am.positions(X_hat)
    assert not np.allclose(rpe(X, X_hat, 1), np.linalg.norm(np.diff(p - q, axis=0), axis=1))
# %% wrong: never calls it
def catches_shortcut(rpe) -> None:
    """Tests the library."""
    X, X_hat = drive(12)
    assert am.rpe(X, X_hat, 1).translation.n == 11
# %% wrong: compares RMSEs loosely
def catches_shortcut(rpe) -> None:
    """A factor of 2 is not enough."""
    X, X_hat = drive(12, turn=0)
    right = am.rpe(X, X_hat, 1).translation.rmse
    assert right / 2 < np.sqrt(np.mean(rpe(X, X_hat, 1) ** 2)) < 2 * right
# %% right: against the library
def catches_shortcut(rpe) -> None:
    """An oracle."""
    for seed in range(3):
        X, X_hat = drive(20, seed=seed)
        assert np.allclose(rpe(X, X_hat, 4), am.rpe(X, X_hat, 4).translation.series)
# %% right: two cases by hand and the invariance
def catches_shortcut(rpe) -> None:
    """Properties."""
    X, X_hat = drive(12)
    G = am.planar_poses([[5, 1]], [1.0])
    assert np.allclose(rpe(X, X_hat, 2), rpe(X, G @ X_hat, 2))
    still = am.planar_poses([[0, 0], [3, 0]], [0, 0])
    left = am.planar_poses([[0, 0], [0, 4]], [0, 0])
    turned = am.planar_poses([[0, 0], [3, 0]], [0, np.pi / 2])
    assert np.allclose(rpe(still, left, 1), 5)
    assert np.allclose(rpe(still, turned, 1), 0)
    assert np.allclose(rpe(turned, left, 1), 5)
