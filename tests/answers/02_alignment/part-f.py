# %% wrong: orthogonality only
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        p = rng.normal(size=(5, d))
        R, t = align(p, p * np.append(np.ones(d - 1), -1) + 0.1 * rng.normal(size=(5, d)))
        assert np.allclose(R.T @ R, np.eye(d))


# %% wrong: the determinant, on clean data only
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        p = rng.normal(size=(5, d))
        R, t = align(p, p + 1)
        assert np.linalg.det(R) > 0


# %% wrong: the determinant only
def catches_reflection(align):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        p = rng.normal(size=(5, d))
        R, t = align(p, p * np.append(np.ones(d - 1), -1) + 0.1 * rng.normal(size=(5, d)))
        assert np.linalg.det(R) > 0


# %% wrong: the plane only
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
def catches_reflection(align):
    p = np.random.default_rng(1).normal(size=(5, 2))
    R, t = align(p, p * [1, -1])
    assert np.allclose(p * [1, -1] @ R.T + t, p)


# %% wrong: rejects everything
def catches_reflection(align):
    p = np.random.default_rng(1).normal(size=(5, 2))
    align(p, p)
    raise AssertionError("it may be a reflection")


# %% wrong: returns a truth value instead of asserting
def catches_reflection(align):
    rng = np.random.default_rng(1)
    p = rng.normal(size=(5, 2))
    R, t = align(p, p * [1, -1] + 0.1 * rng.normal(size=(5, 2)))
    return np.linalg.det(R) < 0


# %% wrong: never calls what it tests
def catches_reflection(align):
    assert np.linalg.det(np.eye(2)) > 0


# %% wrong: raises another exception
def catches_reflection(align):
    rng = np.random.default_rng(1)
    p = rng.normal(size=(5, 2))
    R, t = align(p, p * [1, -1] + 0.1 * rng.normal(size=(5, 2)))
    if np.linalg.det(R) < 0:
        raise RuntimeError("a reflection")


# %% wrong: compares noisy points exactly
def catches_reflection(align):
    rng = np.random.default_rng(1)
    p = rng.normal(size=(5, 2))
    q = p + 0.1 * rng.normal(size=(5, 2))
    R, t = align(p, q)
    assert np.linalg.det(R) > 0
    assert np.allclose(q @ R.T + t, p)


# %% wrong: expects the library's result object
def catches_reflection(align):
    p = np.random.default_rng(1).normal(size=(5, 2))
    assert np.linalg.det(align(p, p * [1, -1]).rotation) > 0


# %% wrong: a rotation in the plane for points in space
def catches_reflection(align):
    p = np.random.default_rng(1).normal(size=(5, 3))
    R, t = align(p, p * [1, 1, -1])
    a = np.arctan2(R[1, 0], R[0, 0])
    assert np.allclose(R, [[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])


# %% wrong: recursion without an end
def catches_reflection(align):
    align(p, p_hat)
    catches_reflection(align)


# %% wrong: a value instead of a function
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
