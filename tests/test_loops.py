"""Curves agree with scikit-learn and their definitions, chi-squares keep their promises."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import chi2, kstest
from sklearn.metrics import average_precision_score, precision_recall_curve, roc_curve

import amrmetrics as am

# Few different scores, so that ties are the rule.
CANDIDATES = st.lists(st.tuples(st.booleans(), st.integers(0, 6)), min_size=1, max_size=40)


def brute(labels, scores, threshold):
    called = scores >= threshold
    return (
        int((called & labels).sum()),
        int((called & ~labels).sum()),
        int((~called & labels).sum()),
        int((~called & ~labels).sum()),
    )


class TestPrecisionRecall:
    @settings(max_examples=300)
    @given(CANDIDATES)
    def test_equals_the_definition_at_every_threshold(self, candidates):
        labels, scores = (np.array(column) for column in zip(*candidates, strict=True))
        curve = am.precision_recall(labels, scores / 7)
        assert np.array_equal(curve.thresholds, np.unique(scores / 7)[::-1])
        for k, threshold in enumerate(curve.thresholds):
            counts = brute(labels, scores / 7, threshold)
            assert (curve.tp[k], curve.fp[k], curve.fn[k], curve.tn[k]) == counts
        assert curve.n == len(labels)

    @settings(max_examples=300)
    @given(CANDIDATES)
    def test_agrees_with_scikit_learn(self, candidates):
        labels, scores = (np.array(column) for column in zip(*candidates, strict=True))
        if not labels.any():
            return
        curve = am.precision_recall(labels, scores)
        precision, recall, thresholds = precision_recall_curve(labels, scores)
        assert np.array_equal(curve.thresholds[::-1], thresholds)
        assert np.abs(curve.precision[::-1] - precision[:-1]).max() < 1e-12
        assert np.abs(curve.recall[::-1] - recall[:-1]).max() < 1e-12
        average = average_precision_score(labels, scores)
        assert abs(curve.average_precision - average) < 1e-12
        if not labels.all():
            fpr, tpr, levels = roc_curve(labels, scores, drop_intermediate=False)
            assert np.array_equal(curve.thresholds, levels[1:])
            assert np.abs(curve.false_positive_rate - fpr[1:]).max() < 1e-12
            assert np.abs(curve.recall - tpr[1:]).max() < 1e-12

    def test_a_million_candidates(self, rng):
        labels = rng.random(1_000_000) < 1e-3
        scores = np.round(rng.normal(size=1_000_000) + 2 * labels, 3)
        curve = am.precision_recall(labels, scores)
        assert curve.average_precision == pytest.approx(
            average_precision_score(labels, scores), abs=1e-12
        )
        assert curve.tp[-1] == labels.sum()

    def test_by_hand_with_a_tie(self):
        curve = am.precision_recall([1, 0, 1, 1, 0, 0], [0.9, 0.7, 0.7, 0.7, 0.2, 0.1])
        assert curve.thresholds.tolist() == [0.9, 0.7, 0.2, 0.1]
        assert curve.precision.tolist() == [1, 3 / 4, 3 / 5, 3 / 6]
        assert curve.recall.tolist() == [1 / 3, 1, 1, 1]
        assert curve.false_positive_rate.tolist() == [0, 1 / 3, 2 / 3, 1]
        assert curve.f1.tolist() == pytest.approx([1 / 2, 6 / 7, 3 / 4, 2 / 3])
        assert curve.average_precision == pytest.approx(1 / 3 + 3 / 4 * 2 / 3)

    def test_full_precision_ends_before_the_first_false_closure(self):
        curve = am.precision_recall([1, 1, 1, 0, 1], [0.9, 0.8, 0.7, 0.7, 0.6])
        assert curve.recall_at_full_precision == 0.5
        assert curve.threshold_at_full_precision == 0.8
        # Precision 1 is what counts, not the best precision that the detector has.
        curve = am.precision_recall([1, 0, 1, 1], [0.9, 0.9, 0.8, 0.7])
        assert curve.recall_at_full_precision == 0
        assert np.isnan(curve.threshold_at_full_precision)
        assert "highest score" in curve.undefined["threshold_at_full_precision"]
        assert am.precision_recall([1, 1], [2, 1]).recall_at_full_precision == 1

    def test_no_true_closure_is_said(self):
        curve = am.precision_recall([0, 0], [0.3, 0.2])
        assert np.isnan(curve.average_precision) and np.isnan(curve.recall).all()
        assert np.isnan(curve.recall_at_full_precision)
        assert curve.precision.tolist() == [0, 0]
        assert curve.undefined["average_precision"] == "no candidate is a true closure"
        assert "average_precision undefined: no candidate is a true" in repr(curve)

    def test_no_false_closure_is_said(self):
        curve = am.precision_recall([1, 1], [0.3, 0.2])
        assert np.isnan(curve.false_positive_rate).all()
        assert curve.undefined == {"false_positive_rate": "no candidate is a false closure"}
        assert curve.average_precision == 1

    def test_no_candidate_is_said(self):
        curve = am.precision_recall([], [])
        assert np.isnan(curve.average_precision) and np.isnan(curve.recall_at_full_precision)
        assert curve.undefined["average_precision"] == "there is no candidate"
        assert curve.n == 0 and len(curve.thresholds) == 0
        assert curve.at(0.5)["tp"] == 0

    def test_equal_scores_are_said(self):
        curve = am.precision_recall([1, 0, 0, 0], [0.5] * 4)
        assert curve.average_precision == 0.25
        assert curve.notes == ("all scores are equal: they rank nothing",)
        assert "all scores are equal" in repr(curve)
        assert am.precision_recall([1], [0.5]).notes == ()
        assert am.precision_recall([1, 0], [0.5, 0.4]).notes == ()

    def test_any_threshold(self):
        curve = am.precision_recall([1, 0, 1], [0.9, 0.5, 0.1])
        assert curve.at(0.5) == {
            "threshold": 0.5, "tp": 1, "fp": 1, "fn": 1, "tn": 0,
            "precision": 0.5, "recall": 0.5, "false_positive_rate": 1.0, "f1": 0.5,
        }  # fmt: skip
        assert curve.at(0.51)["fp"] == 0
        assert curve.at(-3)["tp"] == 2
        nothing = curve.at(0.91)
        assert (nothing["tp"], nothing["fp"], nothing["fn"], nothing["tn"]) == (0, 0, 2, 1)
        assert np.isnan(nothing["precision"]) and nothing["recall"] == 0

    def test_table_and_dictionary(self):
        curve = am.precision_recall([1, 0, 1], [0.9, 0.5, 0.1])
        assert set(curve.table) == {
            "thresholds", "tp", "fp", "fn", "tn", "precision", "recall", "false_positive_rate", "f1"
        }  # fmt: skip
        assert {len(column) for column in curve.table.values()} == {3}
        assert json.loads(json.dumps(curve.as_dict()))["tp"] == [1, 1, 2]
        assert "average_precision" in curve._repr_html_()

    def test_inputs_are_not_changed(self):
        labels, scores = np.array([0, 1, 1]), np.array([0.1, 0.9, 0.5])
        am.precision_recall(labels, scores)
        assert labels.tolist() == [0, 1, 1] and scores.tolist() == [0.1, 0.9, 0.5]


def information(rng, edges, dim):
    A = rng.normal(size=(edges, dim, dim))
    return A @ A.swapaxes(1, 2) + 0.1 * np.eye(dim)


@pytest.mark.parametrize("dim", [1, 3, 6])
class TestResidualSummary:
    def test_equals_the_definition(self, rng, dim):
        W, e = information(rng, 50, dim), rng.normal(size=(50, dim))
        summary = am.residual_summary(e, W, free_nodes=20)
        expected = np.einsum("mi,mij,mj->m", e, W, e)
        assert np.allclose(summary.edge_chi_square, expected, rtol=1e-12)
        assert summary.chi_square == pytest.approx(expected.sum())
        assert summary.dof == 30 * dim
        assert summary.p_value == pytest.approx(chi2.sf(expected.sum(), 30 * dim), rel=1e-9)
        assert (summary.edges, summary.free_nodes, summary.dim) == (50, 20, dim)

    def test_one_matrix_stands_for_all(self, rng, dim):
        W, e = information(rng, 1, dim)[0], rng.normal(size=(5, dim))
        all_of_them = am.residual_summary(e, np.tile(W, (5, 1, 1)))
        assert am.residual_summary(e, W).chi_square == all_of_them.chi_square

    def test_p_values_are_uniform(self, dim):
        # One false alarm in 10 000.
        rng = np.random.default_rng(11)
        W = information(rng, 20, dim)
        roots = np.linalg.inv(np.linalg.cholesky(W)).swapaxes(1, 2)
        draws = rng.normal(size=(500, 20, dim))
        found = [am.residual_summary(np.einsum("mij,mj->mi", roots, z), W).p_value for z in draws]
        assert kstest(found, "uniform").pvalue > 1e-4

    def test_without_freedom_the_p_value_is_undefined(self, rng, dim):
        summary = am.residual_summary(np.zeros((3, dim)), np.eye(dim), free_nodes=3)
        assert summary.dof == 0 and np.isnan(summary.p_value)
        assert "no freedom" in summary.undefined["p_value"] and "no freedom" in repr(summary)
        summary = am.residual_summary(np.zeros((3, dim)), np.eye(dim), free_nodes=2)
        assert summary.p_value == 1 and not summary.undefined


class TestInlierRatio:
    def test_gate(self):
        gate = chi2.ppf(0.95, 3)
        e = np.sqrt(np.array([[0.5, gate * (1 - 1e-12), gate * (1 + 1e-12), 100]])).T * [[1, 0, 0]]
        ratio = am.inlier_ratio(e, np.eye(3))
        assert ratio.inliers.tolist() == [True, True, False, False]
        assert float(ratio) == ratio.value == 0.5
        assert ratio.gate == pytest.approx(gate)
        assert ratio.n == 4
        assert am.inlier_ratio(e, np.eye(3), 0.5).value == 0.25

    def test_keeps_what_it_promises(self):
        # 4 standard deviations: one false alarm in 16 000 for each of the three.
        e = np.random.default_rng(3).normal(size=(20_000, 6))
        for confidence in (0.5, 0.9, 0.99):
            spread = np.sqrt(confidence * (1 - confidence) / len(e))
            found = am.inlier_ratio(e, np.eye(6), confidence).value
            assert abs(found - confidence) < 4 * spread

    @pytest.mark.parametrize(
        ("loss", "weights"),
        [
            ("huber", [1, 1, 0.5, 0.1]),
            ("cauchy", [1, 0.5, 0.2, 1 / 101]),
            ("geman_mcclure", [1, 0.25, 0.04, 1 / 101**2]),
            ("linear", [1, 1, 1, 1]),
        ],
    )
    def test_by_weight(self, loss, weights):
        width = None if loss == "linear" else 3.0
        e = 3 * np.array([[0.0, 1, 2, 10]]).T * [[0, 0, 1]]
        ratio = am.inlier_ratio(e, np.eye(3), loss=loss, width=width)
        assert ratio.weights.tolist() == pytest.approx(weights)
        assert ratio.by_weight == pytest.approx(np.mean(weights))
        assert loss in repr(ratio)

    @pytest.mark.parametrize(("dim", "width"), [(3, 2.7955), (6, 3.5485)])
    def test_default_width(self, dim, width):
        ratio = am.inlier_ratio(np.ones((1, dim)), np.eye(dim))
        assert ratio.width == pytest.approx(width, abs=1e-4)
        assert ratio.width**2 == pytest.approx(ratio.gate)


class TestKernels:
    @pytest.mark.parametrize("loss", ["linear", "huber", "cauchy", "geman_mcclure"])
    def test_weight_is_the_slope_of_the_cost(self, loss):
        from amrmetrics.loops import LOSSES

        s, h, k = np.linspace(0.1, 40, 83), 1e-6, 2.0
        slope = (LOSSES[loss](s + h, k)[0] - LOSSES[loss](s - h, k)[0]) / (2 * h)
        assert np.allclose(slope, LOSSES[loss](s, k)[1], atol=1e-8)
        # All cost and weigh the same near zero.
        assert LOSSES[loss](np.array([1e-12]), k)[0] == pytest.approx(1e-12)

    def test_values_far_out(self):
        from amrmetrics.loops import LOSSES

        s = np.array([100.0])
        assert LOSSES["huber"](s, 2.0)[0] == 2 * 2 * 10 - 4
        assert LOSSES["cauchy"](s, 2.0)[0] == pytest.approx(4 * np.log(26))
        assert LOSSES["geman_mcclure"](s, 2.0)[0] == pytest.approx(100 / 26)


class TestCity:
    def test_is_what_it_says(self):
        run = am.simulation.city_run(np.random.default_rng(5), 500, closures=80, aliased=40)
        assert run.truth.shape == (500, 3, 3) and np.array_equal(run.truth[0], np.eye(3))
        steps = am.relative(run.truth[:-1], run.truth[1:])
        assert np.allclose(np.linalg.norm(am.positions(steps), axis=1), 1)
        assert run.labels.sum() == 80 and len(run.labels) == 80 + 40 + 200
        i, j = run.pairs.T
        assert (j - i >= 20).all()
        together = np.linalg.norm(am.positions(run.truth)[i] - am.positions(run.truth)[j], axis=1)
        assert np.array_equal(together < 0.5, run.labels)
        assert len(np.unique(run.pairs, axis=0)) == len(run.pairs)
        assert ((run.scores > 0) & (run.scores < 1)).all()
        assert len(np.unique(run.scores)) < len(run.scores)  # ties

    @pytest.mark.parametrize("seed", range(5))
    def test_noise_is_what_the_information_says(self, seed):
        # One false alarm in 10 000 on either side.
        run = am.simulation.city_run(np.random.default_rng(seed), 1000, closures=300)
        graph = run.graph(run.labels).with_poses(run.truth)
        summary = am.residual_summary(graph.residuals(), graph.information)
        assert 1e-4 < summary.p_value < 1 - 1e-4
        assert summary.edges == 999 + 300

    def test_false_candidates_say_the_same_place(self):
        run = am.simulation.city_run(np.random.default_rng(6))
        assert np.linalg.norm(am.positions(run.measurements), axis=1).max() < 0.3
        chi = run.graph().with_poses(run.truth).summary().edge_chi_square[len(run.odometry) :]
        assert chi[run.labels].max() < chi[~run.labels].min()

    def test_graph_takes_candidates_in_order(self):
        run = am.simulation.city_run(np.random.default_rng(7))
        graph = run.graph([4, 2])
        assert graph.edges[-2:].tolist() == run.pairs[[4, 2]].tolist()
        assert len(run.graph().edges) == len(run.odometry) + len(run.pairs)
        assert np.allclose(run.graph([]).residuals(), 0)
        assert np.array_equal(run.graph([]).edges[:2], [[0, 1], [1, 2]])

    def test_same_seed_same_run(self):
        one, two = (am.simulation.city_run(np.random.default_rng(8)) for _ in "ab")
        assert all(np.array_equal(a, b) for a, b in zip(one, two, strict=True))


RNG = np.random.default_rng(1)
REFUSED = {
    "label": (
        lambda: am.precision_recall([1, 2], [0, 1]),
        r"labels\[1\] is 2; labels are 1 for a candidate",
    ),
    "nan label": (lambda: am.precision_recall([1, np.nan], [0, 1]), r"labels\[1\] is nan"),
    "score": (lambda: am.precision_recall([1, 0], [0, np.nan]), r"scores\[1\] is nan"),
    "infinite score": (lambda: am.precision_recall([1, 0], [np.inf, 0]), r"scores\[0\] is inf"),
    "lengths": (lambda: am.precision_recall([1], [0, 1]), r"labels has shape \(1,\) and scores"),
    "two axes": (lambda: am.precision_recall([[1, 0]], [[0, 1]]), r"shape \(N,\) both"),
    "threshold": (lambda: am.precision_recall([1], [1]).at([1, 2]), "threshold has shape"),
    "asymmetric": (
        lambda: am.residual_summary([[1, 2]], [[2, 1], [0, 2]]),
        "information is not symmetric",
    ),
    "slightly asymmetric": (
        lambda: am.residual_summary([[1, 2]], [[2, 1], [1 + 1e-6, 2]]),
        "information is not symmetric",
    ),
    "singular": (
        lambda: am.residual_summary(np.ones((2, 2)), [np.eye(2), [[1, 1], [1, 1]]]),
        r"information\[1\] is not positive definite",
    ),
    "indefinite": (lambda: am.inlier_ratio([[1, 2]], [[1, 2], [2, 1]]), "not positive definite"),
    "negative": (lambda: am.inlier_ratio([[1.0]], [[-1]]), "not positive definite"),
    "zero": (lambda: am.inlier_ratio([[1.0]], [[0]]), "not positive definite"),
    "information shape": (lambda: am.residual_summary([[1, 2]], np.eye(3)), r"shape \(3, 3\)"),
    "information nan": (
        lambda: am.residual_summary([[1.0]], [[np.nan]]),
        r"information\[0, 0\] is nan",
    ),
    "residual nan": (lambda: am.residual_summary([[np.nan]], [[1]]), r"residuals\[0, 0\] is nan"),
    "one residual": (lambda: am.residual_summary([1, 2], np.eye(2)), r"residuals has shape \(2,\)"),
    "no residual": (lambda: am.residual_summary(np.ones((0, 3)), np.eye(3)), "M >= 1"),
    "free nodes": (
        lambda: am.residual_summary([[1.0]], [[1]], free_nodes=-1),
        "free_nodes is -1",
    ),
    "half a node": (
        lambda: am.residual_summary([[1.0]], [[1]], free_nodes=0.5),
        "free_nodes is 0.5",
    ),
    "confidence": (lambda: am.inlier_ratio([[1.0]], [[1]], 95), "confidence is 95"),
    "loss": (lambda: am.inlier_ratio([[1.0]], [[1]], loss="tukey"), "loss is 'tukey'; expected"),
    "width": (lambda: am.inlier_ratio([[1.0]], [[1]], width=0), "width is 0"),
    "width of none": (
        lambda: am.inlier_ratio([[1.0]], [[1]], loss="linear", width=1),
        "the linear loss has none",
    ),
    "city generator": (lambda: am.simulation.city_run(7), "rng is 7"),
    "city too short": (
        lambda: am.simulation.city_run(RNG, 40, closures=1000),
        "closures is 1000; this drive of 40 poses",
    ),
    "city of one": (lambda: am.simulation.city_run(RNG, 1), "poses is 1"),
    "city noise": (lambda: am.simulation.city_run(RNG, closure_std=(1, 1)), "closure_std has"),
    "city candidates": (lambda: am.simulation.city_run(RNG, aliased=-1), "aliased is -1"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()
