# %% wrong: orthogonality only
# says: your test accepts an implementation that ignores the determinant.
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        p = rng.normal(size=(5, d))
        R, t = align(p, p * np.append(np.ones(d - 1), -1) + 0.1 * rng.normal(size=(5, d)))
        assert np.allclose(R.T @ R, np.eye(d))

# %% wrong: the determinant, on clean data only
# says: your test accepts an implementation that ignores the determinant.
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        p = rng.normal(size=(5, d))
        R, t = align(p, p + 1)
        assert np.linalg.det(R) > 0

# %% wrong: the determinant only
# says: your test accepts an implementation that changes the sign of the wrong axis.
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        p = rng.normal(size=(5, d))
        R, t = align(p, p * np.append(np.ones(d - 1), -1) + 0.1 * rng.normal(size=(5, d)))
        assert np.linalg.det(R) > 0

# %% wrong: the plane only
# says: your test accepts an implementation that is right in the plane only.
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for q in (rng.normal(size=(9, 2)), rng.normal(size=(9, 2))):
        p = q @ [[0, 1], [1, 0]] + [3, 4] + 0.1 * rng.normal(size=q.shape)
        R, t = align(p, q)
        assert np.linalg.det(R) > 0
        J = ((p - q @ R.T - t) ** 2).sum()
        for a in np.linspace(0, 2 * np.pi, 1000):
            e = p - q @ np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]])
            assert ((e - e.mean(axis=0)) ** 2).sum() > J * (1 - 1e-9)

# %% wrong: the known rotation of clean data
# says: your test accepts an implementation that ignores the determinant.
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        rotation, _ = np.linalg.qr(rng.normal(size=(d, d)))
        rotation[:, 0] *= np.linalg.det(rotation)
        q = rng.normal(size=(5, d))
        R, t = align(q @ rotation.T + 2, q)
        assert np.allclose(R, rotation)
        assert np.allclose(t, 2)

# %% wrong: demands the reflection
# says: your test rejects an implementation that is right (the SVD with its sign).
def catches_reflection(align):
    p = np.random.default_rng(1).normal(size=(5, 2))
    R, t = align(p, p * [1, -1])
    assert np.allclose(p * [1, -1] @ R.T + t, p)

# %% wrong: rejects everything
# says: your test rejects an implementation that is right (the SVD with its sign): it may be a ref
def catches_reflection(align):
    p = np.random.default_rng(1).normal(size=(5, 2))
    align(p, p)
    raise AssertionError("it may be a reflection")

# %% wrong: returns a truth value instead of asserting
# says: your test accepts an implementation that ignores the determinant. It returns True; use ass
def catches_reflection(align):
    rng = np.random.default_rng(1)
    p = rng.normal(size=(5, 2))
    R, t = align(p, p * [1, -1] + 0.1 * rng.normal(size=(5, 2)))
    return np.linalg.det(R) < 0

# %% wrong: never calls what it tests
# says: there is no answer yet: your test never calls what it is to test.
def catches_reflection(align):
    assert np.linalg.det(np.eye(2)) > 0

# %% wrong: raises another exception
# says: your test breaks with RuntimeError: a reflection on an implementation that ignores the det
def catches_reflection(align):
    rng = np.random.default_rng(1)
    p = rng.normal(size=(5, 2))
    R, t = align(p, p * [1, -1] + 0.1 * rng.normal(size=(5, 2)))
    if np.linalg.det(R) < 0:
        raise RuntimeError("a reflection")

# %% wrong: compares noisy points exactly
# says: your test rejects an implementation that is right (the SVD with its sign).
def catches_reflection(align):
    rng = np.random.default_rng(1)
    p = rng.normal(size=(5, 2))
    q = p + 0.1 * rng.normal(size=(5, 2))
    R, t = align(p, q)
    assert np.linalg.det(R) > 0
    assert np.allclose(q @ R.T + t, p)

# %% wrong: expects the library's result object
# says: your test breaks with AttributeError: 'tuple' object has no attribute 'rotation' on an imp
def catches_reflection(align):
    p = np.random.default_rng(1).normal(size=(5, 2))
    assert np.linalg.det(align(p, p * [1, -1]).rotation) > 0

# %% wrong: a rotation in the plane for points in space
# says: your test breaks with ValueError: operands could not be broadcast together with shapes (3,
def catches_reflection(align):
    p = np.random.default_rng(1).normal(size=(5, 3))
    R, t = align(p, p * [1, 1, -1])
    a = np.arctan2(R[1, 0], R[0, 0])
    assert np.allclose(R, [[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])

# %% wrong: recursion without an end
# says: your test breaks with RecursionError: maximum recursion depth exceeded while calling a Pyt
def catches_reflection(align):
    align(p, p_hat)
    catches_reflection(align)

# %% wrong: a value instead of a function
# says: a function is asked, you have True.
catches_reflection = True

# %% right: the library as the judge, on mirrored data
def catches_reflection(align):
    rng = np.random.default_rng(5)
    for d in (2, 3):
        for k in range(20):
            p, q = rng.normal(size=(2, 4, d))
            R, t = align(p, q)
            best = am.align(p, q)
            assert np.allclose(R, best.rotation), f"{d}-D, trial {k}"
            assert np.allclose(t, best.translation)

# %% right: SciPy in space, all angles in the plane
def catches_reflection(align):
    from scipy.spatial.transform import Rotation

    rng = np.random.default_rng(7)
    for _ in range(20):
        p, q = rng.normal(size=(2, 6, 3))
        R, t = align(p, q)
        assert abs(np.linalg.det(R) - 1) < 1e-9
        best, _ = Rotation.align_vectors(p - p.mean(axis=0), q - q.mean(axis=0))
        assert np.abs(R - best.as_matrix()).max() < 1e-6
        p, q = rng.normal(size=(2, 6, 2))
        R, t = align(p, q)
        assert abs(np.linalg.det(R) - 1) < 1e-9
        z, w = (x @ [1, 1j] - (x @ [1, 1j]).mean() for x in (p, q))
        angles = np.exp(1j * np.linspace(0, 2 * np.pi, 720))
        left = (np.abs(z - angles[:, None] * w) ** 2).sum(axis=1)
        assert ((p - q @ R.T - t) ** 2).sum() <= left.min() + 1e-9

# %% wrong: orthogonality and determinant, on mirrored data in space only
# says: your test accepts an implementation that is right in space only.
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for _ in range(20):
        p, q = rng.normal(size=(2, 6, 3))
        R, t = align(p, q)
        assert np.allclose(R @ R.T, np.eye(3))
        assert np.linalg.det(R) > 0

# %% wrong: better than no rotation
# says: your test accepts an implementation that never rotates.
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        for _ in range(20):
            p, q = rng.normal(size=(2, 6, d))
            R, t = align(p, q)
            assert np.linalg.det(R) > 0
            still = p - p.mean(axis=0) - (q - q.mean(axis=0))
            assert np.sum((p - q @ R.T - t) ** 2) <= np.sum(still**2) + 1e-9

# %% wrong: clean data in both
# says: your test accepts an implementation that ignores the determinant.
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        q = rng.normal(size=(6, d))
        R, t = align(q + 1, q)
        assert np.allclose(q @ R.T + t, q + 1)
        assert np.isclose(np.linalg.det(R), 1)

# %% wrong: never looks at what comes back
# says: your test accepts an implementation that ignores the determinant.
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        align(*rng.normal(size=(2, 6, d)))
    assert True

# %% wrong: compares names
# says: your test accepts an implementation that ignores the determinant.
def catches_reflection(align):
    align(p, p_hat)
    assert "svd" not in align.__name__

# %% right: the condition of the best rotation
def catches_reflection(align):
    rng = np.random.default_rng(9)
    for d in (2, 3):
        for _ in range(30):
            x, y = rng.normal(size=(2, 6, d)) + 3
            R, _ = align(x, y)
            assert np.allclose(R @ R.T, np.eye(d))
            assert np.isclose(np.linalg.det(R), 1)
            M = R.T @ (x - x.mean(axis=0)).T @ (y - y.mean(axis=0))
            assert np.allclose(M, M.T)
            low = np.linalg.eigvalsh((M + M.T) / 2)
            assert low[0] + low[1] > -1e-9

# %% right: an error raised by hand, many random rotations near and far
def catches_reflection(align):
    rng = np.random.default_rng(11)
    for d in (2, 3):
        for _ in range(8):
            x, y = rng.normal(size=(2, 7, d))
            R, t = align(x, y)
            if not np.allclose(np.dot(R, np.transpose(R)), np.eye(d)) or np.linalg.det(R) < 0:
                raise AssertionError("no rotation")
            a, b = x - x.mean(axis=0), y - y.mean(axis=0)
            best = np.sum((a - b @ np.transpose(R)) ** 2)
            for size in (0.01, 0.1, 1, 10):
                for _ in range(50):
                    K = size * rng.normal(size=(d, d))
                    other = np.linalg.solve(np.eye(d) - K + K.T, np.eye(d) + K - K.T) @ R
                    if np.sum((a - b @ other.T) ** 2) < best - 1e-9:
                        raise AssertionError("another one is better")
