# %% wrong: from P only
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 3)), rng.normal(size=(6, 3))
    assert np.isclose(hausdorff(P, Q), cdist(P, Q).min(axis=1).max())

# %% wrong: two equal sets
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    P = np.array([[0, 0], [1, 0], [0, 2]])
    assert hausdorff(P, P) == 0

# %% wrong: one point each
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    assert np.isclose(hausdorff([[0, 0]], [[3, 4]]), 5)
    assert np.isclose(hausdorff([[0, 0, 0]], [[1, 2, 2]]), 3)

# %% wrong: symmetry only
# says: your test accepts an implementation that takes the smaller direction.
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 3)), rng.normal(size=(9, 3))
    assert np.isclose(hausdorff(P, Q), hausdorff(Q, P))
    assert hausdorff(P, Q) > 0

# %% wrong: the plane only
# says: your test accepts an implementation that drops the third coordinate.
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 2)), rng.normal(size=(9, 2))
    right = max(cdist(P, Q).min(axis=1).max(), cdist(P, Q).min(axis=0).max())
    assert np.isclose(hausdorff(P, Q), right)
    assert np.isclose(hausdorff(Q, P), right)

# %% wrong: space only
# says: your test accepts an implementation that drops a coordinate in the plane.
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 3)), rng.normal(size=(9, 3))
    right = max(cdist(P, Q).min(axis=1).max(), cdist(P, Q).min(axis=0).max())
    assert np.isclose(hausdorff(P, Q), right)
    assert np.isclose(hausdorff(Q, P), right)

# %% wrong: distances along the axes only
# says: your test accepts an implementation that adds the two directions.
def catches_wrong_hausdorff(hausdorff):
    P, Q = [[0, 0, 0], [1, 0, 0]], [[0, 0, 0], [1, 0, 0], [0, 0, 4]]
    assert np.isclose(hausdorff(P, Q), 4)
    assert np.isclose(hausdorff(Q, P), 4)

# %% wrong: believes that the directions are added
# says: your test rejects an implementation that is right (am.hausdorff).
def catches_wrong_hausdorff(hausdorff):
    P, Q = [[0, 0], [1, 0]], [[0, 3], [1, 0], [8, 0]]
    assert np.isclose(hausdorff(P, Q), 10)

# %% wrong: never too large
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    P, Q = rng.normal(size=(6, 3)), rng.normal(size=(9, 3))
    assert hausdorff(P, Q) <= cdist(P, Q).max()

# %% wrong: returns a truth value
# says: your test accepts an implementation that looks from P only. It returns False; use assert i
def catches_wrong_hausdorff(hausdorff):
    P, Q = [[0, 0, 0]], [[1, 2, 2], [0, 0, 0]]
    return hausdorff(P, Q) == 3 and hausdorff(Q, P) == 3

# %% wrong: never calls what it tests
# says: there is no answer yet: your test never calls what it is to test.
def catches_wrong_hausdorff(hausdorff):
    assert float(am.hausdorff([[0, 0]], [[3, 4]])) == 5

# %% wrong: the directions are equal
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    P = np.array([[0.0, 0.0, 0.0], [10.0, 0.0, 0.0]])
    assert np.isclose(hausdorff(P, P + [1, 2, 2]), 3)
    assert np.isclose(hausdorff(P + [1, 2, 2], P), 3)

# %% wrong: numbers instead of points
# says: your test breaks with AmrError: P has shape (2,); points need shape (N, 2) or (N, 3), one 
def catches_wrong_hausdorff(hausdorff):
    assert hausdorff([0, 1], [0, 4]) == 3

# %% wrong: a value instead of a function
# says: a function is asked, you have True.
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

# %% wrong: one order only
# says: your test accepts an implementation that looks from Q only.
def catches_wrong_hausdorff(hausdorff):
    for d in (2, 3):
        P, Q = np.zeros((1, d)), np.vstack([np.zeros(d), np.full(d, 5.0)])
        assert np.isclose(hausdorff(P, Q), 5 * d**0.5)

# %% wrong: within a tenth
# says: your test accepts an implementation that returns a little too much.
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        P, Q = rng.normal(size=(5, d)), rng.normal(size=(9, d))
        right = max(cdist(P, Q).min(axis=0).max(), cdist(P, Q).min(axis=1).max())
        assert abs(hausdorff(P, Q) - right) < 0.1 * right
        assert abs(hausdorff(Q, P) - right) < 0.1 * right

# %% wrong: not too small only
# says: your test accepts an implementation that looks from Q only.
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        P, Q = rng.normal(size=(5, d)), rng.normal(size=(9, d))
        D = cdist(P, Q)
        assert hausdorff(P, Q) >= D.min(axis=0).max() - 1e-9
        assert hausdorff(P, Q) >= D.min(axis=1).max() - 1e-9

# %% wrong: moved, turned and scaled sets
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(1)
    for d in (2, 3):
        P, Q = rng.normal(size=(5, d)), rng.normal(size=(9, d))
        assert np.isclose(hausdorff(P + 3, Q + 3), hausdorff(P, Q))
        assert np.isclose(hausdorff(2 * P, 2 * Q), 2 * hausdorff(P, Q))

# %% wrong: compares names
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    hausdorff([[0, 0]], [[1, 1]])
    assert hausdorff.__name__ == "tested"

# %% wrong: nothing asserted
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    print(hausdorff([[0, 0]], [[3, 4]]))

# %% right: the library as the judge
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(3)
    for d in (2, 3):
        for _ in range(20):
            P, Q = rng.normal(size=(4, d)), rng.normal(size=(7, d))
            assert abs(hausdorff(P, Q) - float(am.hausdorff(P, Q))) < 1e-9
            assert abs(hausdorff(Q, P) - float(am.hausdorff(P, Q))) < 1e-9

# %% right: an error raised by hand, names used up
P = Q = cdist = 0


def catches_wrong_hausdorff(hausdorff):
    def distance(first, second):
        return max(min(np.linalg.norm(np.subtract(x, y)) for y in second) for x in first)

    sets = [
        ([[0, 0], [5, 1]], [[3, 4], [0, 0.5], [6, 7]]),
        ([[0, 0, 1], [5, 1, 2]], [[3, 4, 9], [0, 0, 5], [6, 7, 3]]),
        ([[1, 2, 3], [9, 9, 1], [2, 2, 2]], [[4, 6, 15]]),
    ]
    for one, other in sets:
        right = max(distance(one, other), distance(other, one))
        for found in (hausdorff(one, other), hausdorff(other, one)):
            if not np.isclose(found, right):
                raise AssertionError(f"{found} instead of {right}")

# %% wrong: hand numbers all equal in both directions
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    assert abs(hausdorff([[0, 0], [3, 4]], [[0, 0], [3, 4]])) < 1e-9
    assert abs(hausdorff([[0, 0]], [[3, 4]]) - 5) < 1e-9
    assert abs(hausdorff([[0, 0, 0]], [[1, 2, 2]]) - 3) < 1e-9

# %% wrong: returns None always asserts isinstance
# says: your test accepts an implementation that looks from P only.
def catches_wrong_hausdorff(hausdorff):
    assert isinstance(hausdorff([[0, 0]], [[3, 4]]), float)
    assert hausdorff([[0, 0]], [[3, 4]]) >= 0

# %% wrong: raises ValueError
# says: your test breaks with ValueError: wrong on an implementation that looks from P only. It sh
def catches_wrong_hausdorff(hausdorff):
    rng = np.random.default_rng(0)
    for d in (2, 3):
        P, Q = rng.normal(size=(4, d)), rng.normal(size=(6, d))
        if abs(hausdorff(P, Q) - float(am.hausdorff(P, Q))) > 1e-6:
            raise ValueError("wrong")

# %% right: hand numbers in both dimensions and orders
def catches_wrong_hausdorff(hausdorff):
    A, B = [[0, 0], [10, 0]], [[0, 3], [10, 4], [22, 5]]
    assert abs(hausdorff(A, B) - 13) < 1e-6
    assert abs(hausdorff(B, A) - 13) < 1e-6
    A, B = [[0, 0, 0], [9, 9, 9]], [[1, 2, 2], [9, 9, 9], [11, 12, 15]]
    assert abs(hausdorff(A, B) - 7) < 1e-6
    assert abs(hausdorff(B, A) - 7) < 1e-6
    assert abs(hausdorff([[0.5, 1.5]], [[0.5, 1.5]])) < 1e-6

# %% right: pytest.approx
def catches_wrong_hausdorff(hausdorff):
    from scipy.spatial.distance import directed_hausdorff as h

    rng = np.random.default_rng(2)
    for d in (2, 3):
        for n, m in ((1, 4), (4, 1), (6, 6)):
            P, Q = 5 * rng.random((n, d)), 5 * rng.random((m, d))
            np.testing.assert_allclose(hausdorff(P, Q), max(h(P, Q)[0], h(Q, P)[0]))
