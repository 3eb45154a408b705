"""What passes for a pose: the same whether it is looked at fast or closely, alone or among many."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import amrmetrics as am
from amrmetrics._arguments import BLOCK, as_poses, as_positions

N = BLOCK + 100


def poses(d, n=N, seed=0):
    rng = np.random.default_rng(seed)
    if d == 2:
        return am.planar_poses(rng.normal(size=(n, 2)), rng.uniform(-3, 3, n))
    return am.spatial_poses(rng.normal(size=(n, 3)), Rotation.random(n, rng=rng).as_quat())


def off(X):
    """Return by how much each is no rotation, as the limit is meant: entries of R^T R - I."""
    R = X[:, :-1, :-1]
    return np.abs(np.einsum("nki,nkj->nij", R, R) - np.eye(R.shape[1])).max((1, 2))


def accepted(X):
    try:
        found = as_poses(X, "X")
    except am.AmrError:
        with pytest.raises(am.AmrError):
            as_positions(X, "X")
        return False
    assert np.array_equal(as_positions(X, "X"), X[:, :-1, -1])
    return np.array_equal(found, X)


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("k", [0, BLOCK - 1, BLOCK, N - 1])
def test_one_bad_entry_of_a_rotation_is_found_wherever_it_is(d, k):
    X = poses(d)
    assert off(X).max() < 1e-14
    assert accepted(X)
    for i in range(d):
        for j in range(d):
            for error in (1e-3, -1e-3, np.nan, np.inf, 1e200):
                Y = X.copy()
                Y[k, i, j] += error
                assert not accepted(Y), (i, j, error)


@pytest.mark.parametrize("d", [2, 3])
def test_the_limit_is_the_same_for_one_and_for_all(d):
    """Stretched by 1 + x, R^T R is off by 2 x."""
    for x, fine in ((4.9e-6, True), (-4.9e-6, True), (5.1e-6, False), (-5.1e-6, False)):
        for many in (1, N):
            X = poses(d)
            X[:many, :d, :d] *= 1 + x
            assert accepted(X) == fine, (x, many)
    for x, fine in ((4.9e-6, True), (1.5e-5, False)):
        for many in (1, N):
            for column in range(d):  # one column alone
                X = poses(d)
                X[:many, :d, column] *= 1 + x
                assert accepted(X) == fine, (x, many, column)


def test_columns_that_are_not_at_right_angles():
    """A shear of the second column keeps all lengths and the cross product, nearly."""
    for shear, fine in ((0.9e-5, True), (1.1e-5, False), (1e-3, False)):
        X = poses(3)
        X[5, :3, 1] += shear * X[5, :3, 0]
        assert accepted(X) == fine, shear


@pytest.mark.parametrize("d", [2, 3])
def test_reflections_and_last_rows(d):
    for k in (3, N - 1):
        X = poses(d)
        X[k, :, 0] *= -1
        assert not accepted(X)
        for j in range(d + 1):
            for error in (1e-300, -1e-9, np.nan):
                X = poses(d)
                X[k, d, j] = X[k, d, j] + error if j < d else 1 + 1e-15
                assert not accepted(X), (j, error)


@pytest.mark.parametrize("d", [2, 3])
def test_positions(d):
    for far, fine in ((1e100, True), (-1e100, True), (1.01e100, False), (np.nan, False)):
        for k in (0, N - 1):
            X = poses(d)
            X[k, d - 1, d] = far
            assert accepted(X) == fine
    X = poses(d)
    X[:, 0, d] = 1e100  # the sum of their squares is larger
    assert accepted(X)
