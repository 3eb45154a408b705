# %% wrong: from P only
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 3)), rng.normal(size=(6, 3))
    assert np.isclose(hausdorff(P, Q), cdist(P, Q).min(axis=1).max())


# %% wrong: two equal sets
def catches_wrong_hausdorff(hausdorff):
    P = np.array([[0, 0], [1, 0], [0, 2]])
    assert hausdorff(P, P) == 0


# %% wrong: one point each
def catches_wrong_hausdorff(hausdorff):
    assert np.isclose(hausdorff([[0, 0]], [[3, 4]]), 5)
    assert np.isclose(hausdorff([[0, 0, 0]], [[1, 2, 2]]), 3)


# %% wrong: symmetry only
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 3)), rng.normal(size=(9, 3))
    assert np.isclose(hausdorff(P, Q), hausdorff(Q, P))
    assert hausdorff(P, Q) > 0


# %% wrong: the plane only
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 2)), rng.normal(size=(9, 2))
    right = max(cdist(P, Q).min(axis=1).max(), cdist(P, Q).min(axis=0).max())
    assert np.isclose(hausdorff(P, Q), right)
    assert np.isclose(hausdorff(Q, P), right)


# %% wrong: space only
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 3)), rng.normal(size=(9, 3))
    right = max(cdist(P, Q).min(axis=1).max(), cdist(P, Q).min(axis=0).max())
    assert np.isclose(hausdorff(P, Q), right)
    assert np.isclose(hausdorff(Q, P), right)


# %% wrong: distances along the axes only
def catches_wrong_hausdorff(hausdorff):
    P, Q = [[0, 0, 0], [1, 0, 0]], [[0, 0, 0], [1, 0, 0], [0, 0, 4]]
    assert np.isclose(hausdorff(P, Q), 4)
    assert np.isclose(hausdorff(Q, P), 4)


# %% wrong: believes that the directions are added
def catches_wrong_hausdorff(hausdorff):
    P, Q = [[0, 0], [1, 0]], [[0, 3], [1, 0], [8, 0]]
    assert np.isclose(hausdorff(P, Q), 10)


# %% wrong: never too large
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 3)), rng.normal(size=(9, 3))
    assert hausdorff(P, Q) <= cdist(P, Q).max()


# %% wrong: returns a truth value
def catches_wrong_hausdorff(hausdorff):
    P, Q = [[0, 0, 0]], [[1, 2, 2], [0, 0, 0]]
    return hausdorff(P, Q) == 3 and hausdorff(Q, P) == 3


# %% wrong: never calls what it tests
def catches_wrong_hausdorff(hausdorff):
    assert float(am.hausdorff([[0, 0]], [[3, 4]])) == 5


# %% wrong: the directions are equal
def catches_wrong_hausdorff(hausdorff):
    P = np.array([[0.0, 0.0, 0.0], [10.0, 0.0, 0.0]])
    assert np.isclose(hausdorff(P, P + [1, 2, 2]), 3)
    assert np.isclose(hausdorff(P + [1, 2, 2], P), 3)


# %% wrong: numbers instead of points
def catches_wrong_hausdorff(hausdorff):
    assert hausdorff([0, 1], [0, 4]) == 3


# %% wrong: a value instead of a function
catches_wrong_hausdorff = True


# %% right: by hand
def catches_wrong_hausdorff(hausdorff):
    P = [[0, 0, 0], [0, 0, 50]]
    Q = [[1, 2, 2], [0, 0, 50], [2, 3, 56]]
    assert abs(hausdorff(P, Q) - 7) < 1e-9
    assert abs(hausdorff(Q, P) - 7) < 1e-9
    assert abs(hausdorff([[0, 0], [9, 9]], [[9, 9], [3, 4], [0, 0]]) - 5) < 1e-9


# %% right: the smallest radius that covers both sets
def catches_wrong_hausdorff(hausdorff):
    for seed in range(4):
        rng, d = np.random.default_rng(seed), 2 + seed % 2
        P, Q = 9 * rng.random((5, d)), 9 * rng.random((12, d))
        for first, second in ((P, Q), (Q, P)):
            radius = float(hausdorff(first, second))
            for r, covered in ((radius * 1.001, True), (radius * 0.999, False)):
                near = cdist(first, second) <= r
                assert (near.any(axis=0).all() and near.any(axis=1).all()) == covered
