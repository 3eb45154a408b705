"""Counts, rates and distances of maps agree with brute force, and nothing is made up."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.distance import cdist, directed_hausdorff
from sklearn import metrics

import amrmetrics as am

SEEDS = st.integers(0, 2**32 - 1)


def random_map(rng, n=300):
    p = rng.integers(0, 20, size=n) / 19
    return (rng.random(n) < p).astype(int), p


@pytest.mark.parametrize("seed", range(20))
def test_rates_agree_with_scikit_learn(seed):
    y, p = random_map(np.random.default_rng(seed))
    c = am.confusion(y, p, 0.4)
    called = p >= 0.4
    assert metrics.confusion_matrix(y, called).ravel().tolist() == [c.tn, c.fp, c.fn, c.tp]
    assert c.precision == pytest.approx(metrics.precision_score(y, called))
    assert c.recall == pytest.approx(metrics.recall_score(y, called))
    assert c.f1 == pytest.approx(metrics.f1_score(y, called))
    assert c.iou == pytest.approx(metrics.jaccard_score(y, called))
    assert c.accuracy == pytest.approx(metrics.accuracy_score(y, called))
    assert c.n == len(y)


@given(seed=SEEDS)
def test_f1_is_a_function_of_iou(seed):
    y, p = random_map(np.random.default_rng(seed))
    c = am.confusion(y, p)
    assert c.f1 == pytest.approx(2 * c.iou / (1 + c.iou))


class TestUndefined:
    def test_nothing_called(self):
        c = am.confusion([1, 0], [0.1, 0.1])
        assert np.isnan(c.precision)
        assert (c.recall, c.f1, c.iou) == (0, 0, 0)
        assert c.undefined == {"precision": "no cell is called occupied"}
        assert "precision undefined: no cell is called occupied" in repr(c)

    def test_two_empty_maps(self):
        c = am.confusion([0, 0], [0.1, 0.1])
        assert np.isnan([c.precision, c.recall, c.f1, c.iou]).all()
        assert set(c.undefined) == {"precision", "recall", "f1", "iou"}
        assert (c.false_positive_rate, c.accuracy) == (0, 1)

    def test_full_map(self):
        c = am.confusion([1, 1], [0.9, 0.9])
        assert np.isnan(c.false_positive_rate)
        assert c.undefined == {"false_positive_rate": "no cell is free"}


class TestSweep:
    @given(seed=SEEDS)
    def test_equals_the_counts_at_each_threshold(self, seed):
        y, p = random_map(np.random.default_rng(seed), 60)
        sweep = am.threshold_sweep(y, p)
        assert sweep.thresholds[1:].tolist() == sorted(set(p), reverse=True)
        for k, threshold in enumerate(sweep.thresholds[1:], start=1):
            c = am.confusion(y, p, threshold)
            assert (sweep.tp[k], sweep.fp[k], sweep.fn[k], sweep.tn[k]) == (c.tp, c.fp, c.fn, c.tn)
            for rate in ("precision", "recall", "f1", "iou", "false_positive_rate"):
                assert np.allclose(getattr(sweep, rate)[k], getattr(c, rate), equal_nan=True)

    def test_agrees_with_the_roc_of_scikit_learn(self, rng):
        y, p = random_map(rng)
        sweep = am.threshold_sweep(y, p)
        fpr, tpr, _ = metrics.roc_curve(y, p, drop_intermediate=False)
        assert np.allclose(sweep.false_positive_rate, fpr)
        assert np.allclose(sweep.recall, tpr)

    def test_unknown_cells_do_not_count(self, rng):
        y, p = random_map(rng)
        unknown = rng.random(len(y)) < 0.5
        a = am.threshold_sweep(y, p, unknown=unknown)
        b = am.threshold_sweep(y[~unknown], p[~unknown])
        assert np.array_equal(a.tp, b.tp)
        assert am.confusion(y, p, unknown=unknown) == am.confusion(y[~unknown], p[~unknown])


@pytest.mark.parametrize("d", [2, 3])
class TestDistances:
    @given(seed=SEEDS)
    def test_equal_brute_force(self, d, seed):
        rng = np.random.default_rng(seed)
        P, Q = rng.normal(size=(rng.integers(1, 30), d)), rng.normal(size=(rng.integers(1, 30), d))
        D = cdist(P, Q)
        to_q, to_p = D.min(1), D.min(0)
        c, h = am.chamfer(P, Q), am.hausdorff(P, Q)
        assert float(c) == pytest.approx(to_q.mean() + to_p.mean())
        assert (c.forward, c.backward) == pytest.approx((to_q.mean(), to_p.mean()))
        assert float(h) == pytest.approx(max(to_q.max(), to_p.max()))
        assert h.worst_distance == pytest.approx(h.value)
        assert D[h.worst] == pytest.approx(h.value)
        assert c.worst == h.worst

    def test_hausdorff_agrees_with_scipy(self, rng, d):
        P, Q = rng.normal(size=(2, 200, d))
        h = am.hausdorff(P, Q)
        assert h.forward == pytest.approx(directed_hausdorff(P, Q)[0])
        assert h.backward == pytest.approx(directed_hausdorff(Q, P)[0])

    @given(seed=SEEDS)
    def test_hausdorff_is_a_metric(self, d, seed):
        rng = np.random.default_rng(seed)
        A, B, C = (rng.normal(size=(rng.integers(1, 9), d)) for _ in range(3))
        assert float(am.hausdorff(A, A)) == 0
        assert float(am.hausdorff(A, B)) == float(am.hausdorff(B, A))
        through_b = float(am.hausdorff(A, B)) + float(am.hausdorff(B, C))
        assert float(am.hausdorff(A, C)) <= through_b + 1e-12

    def test_one_outlier(self, rng, d):
        P = rng.normal(size=(1000, d))
        Q = np.vstack([P, np.full((1, d), 100.0)])
        far = np.linalg.norm(P - 100, axis=1).min()
        assert float(am.hausdorff(P, Q)) == pytest.approx(far)
        assert float(am.chamfer(P, Q)) == pytest.approx(far / 1001)


def test_chamfer_breaks_the_triangle_inequality():
    a, b, c = [[0.0, 0.0]], [[0.0, 0.0], [1.0, 0.0]], [[1.0, 0.0]]
    assert float(am.chamfer(a, c)) > float(am.chamfer(a, b)) + float(am.chamfer(b, c))


REFUSED = {
    "threshold": (lambda: am.confusion([1], [0.5], 50), "threshold is 50"),
    "label": (lambda: am.threshold_sweep([3], [0.5]), "labels are 0"),
    "empty set": (lambda: am.chamfer(np.zeros((0, 2)), [[1, 2]]), "P is empty"),
    "nan": (lambda: am.hausdorff([[1, 2]], [[np.nan, 1]]), r"Q\[0, 0\] is nan"),
    "dimension": (lambda: am.chamfer([[1, 2]], [[1, 2, 3]]), "P is 2-D and Q is 3-D"),
    "shape": (lambda: am.chamfer([1, 2], [[1, 2]]), r"P has shape \(2,\)"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()
