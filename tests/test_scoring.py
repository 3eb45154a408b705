"""Scores agree with their definitions and with others, and hide nothing."""

import numpy as np
import pytest
import scoringrules
from hypothesis import given
from hypothesis import strategies as st
from sklearn.calibration import calibration_curve
from sklearn.metrics import brier_score_loss, log_loss

import amrmetrics as am

SEEDS = st.integers(0, 2**32 - 1)


def random_map(rng, shape=(20, 30)):
    p = rng.beta(0.5, 0.5, size=shape)
    return (rng.random(shape) < p).astype(int), p


@pytest.mark.parametrize("seed", range(20))
def test_agree_with_scikit_learn_and_scoringrules(seed):
    y, p = random_map(np.random.default_rng(seed))
    assert float(am.cross_entropy(y, p)) == pytest.approx(log_loss(y.ravel(), p.ravel()))
    assert float(am.brier(y, p)) == pytest.approx(brier_score_loss(y.ravel(), p.ravel()))
    assert float(am.cross_entropy(y, p)) == pytest.approx(scoringrules.log_score(y, p).mean())
    assert float(am.brier(y, p)) == pytest.approx(scoringrules.brier_score(y, p).mean())


def test_weights_agree_with_scikit_learn(rng):
    y, p = random_map(rng, (500,))
    w = rng.random(500)
    assert float(am.cross_entropy(y, p, weights=w)) == pytest.approx(
        log_loss(y, p, sample_weight=w)
    )
    assert float(am.brier(y, p, weights=w)) == pytest.approx(
        brier_score_loss(y, p, sample_weight=w)
    )


def test_agree_with_scikit_learn_on_the_maps_of_lecture_05(rng):
    scans = am.simulation.scan_room(rng, steps=40)
    logits = am.simulation.occupancy_grid(scans, hit=0.56, miss=0.45)
    unknown = logits == 0
    y, p = scans.occupied[~unknown], 1 / (1 + np.exp(-logits[~unknown]))
    assert float(am.cross_entropy(scans.occupied, logits=logits, unknown=unknown)) == pytest.approx(
        log_loss(y, p)
    )
    frequency, forecast = calibration_curve(y, p, n_bins=10)
    m = am.murphy(y, p, 10)
    assert m.frequency[m.count > 0] == pytest.approx(frequency)
    assert m.forecast[m.count > 0] == pytest.approx(forecast)


class TestCrossEntropy:
    def test_bits(self, rng):
        y, p = random_map(rng)
        nats, bits = (am.cross_entropy(y, p, unit=unit).value for unit in ("nats", "bits"))
        assert nats == pytest.approx(bits * np.log(2))

    def test_certain_and_right_costs_nothing(self):
        score = am.cross_entropy([1, 0], [1.0, 0.0])
        assert score.value == 0
        assert not len(score.offending)

    def test_certain_and_wrong_is_infinite_and_located(self):
        score = am.cross_entropy([[1, 0, 1], [0, 0, 0]], [[1, 0.5, 0], [1, 0, 0]])
        assert score.value == np.inf
        assert score.offending.tolist() == [[0, 2], [1, 0]]
        assert "2 cells infinite, first at [0, 2]" in repr(score)

    def test_keeps_the_digits_of_tiny_probabilities(self):
        assert am.cross_entropy([0], [1e-20]).value == pytest.approx(1e-20)

    @given(seed=SEEDS)
    def test_logits_equal_probabilities(self, seed):
        rng = np.random.default_rng(seed)
        a = rng.normal(size=50) * 5
        y = rng.integers(0, 2, 50)
        p = 1 / (1 + np.exp(-a))
        assert am.cross_entropy(y, logits=a).value == pytest.approx(am.cross_entropy(y, p).value)

    def test_logits_do_not_overflow(self):
        assert am.cross_entropy([1, 0], logits=[1000, 1000]).value == pytest.approx(500)

    def test_what_stands_in_unknown_cells_does_not_matter(self):
        unknown = np.array([False, True, True])
        p = [0.25, np.nan, 7.0]
        assert am.brier([1, 0, 1], p, unknown=unknown).value == 0.75**2
        assert am.cross_entropy([1, 0, 1], p, unknown=unknown).value == pytest.approx(np.log(4))
        assert am.cross_entropy([1, 0, 1], logits=[0, np.nan, np.inf], unknown=unknown).n == 1
        assert am.murphy([1, 0, 1], p, unknown=unknown).brier == 0.75**2
        assert am.confusion([1, 0, 1], p, 0.2, unknown=unknown).tp == 1
        with pytest.raises(am.AmrError, match="NaN or infinite"):
            am.brier([1, 0, 1], p, unknown=[False, False, True])
        with pytest.raises(am.AmrError, match=r"probability\[2\] is 7"):
            am.brier([1, 0, 1], p, unknown=[False, True, False])

    def test_unknown_and_weights(self, rng):
        y, p = random_map(rng)
        unknown = rng.random(y.shape) < 0.3
        w = rng.random(y.shape)
        for score in (am.cross_entropy, am.brier):
            known = score(y[~unknown], p[~unknown])
            assert score(y, p, unknown=unknown).value == pytest.approx(known.value)
            assert score(y, p, unknown=unknown).n == (~unknown).sum()
            twice = score(np.r_[y.ravel(), y.ravel()], np.r_[p.ravel(), p.ravel()])
            assert score(y, p, weights=0 * p + 2).value == pytest.approx(twice.value)
            assert score(y, p, weights=w).value != pytest.approx(twice.value, rel=1e-6)

    def test_a_weightless_cell_cannot_make_it_infinite(self):
        assert np.isfinite(am.cross_entropy([1, 1], [0.0, 0.5], weights=[0, 1]).value)

    def test_locates_cells_of_the_whole_map(self):
        unknown = np.array([True, False, False])
        score = am.cross_entropy([1, 1, 1], [0, 0.5, 0], unknown=unknown)
        assert score.offending.tolist() == [[2]]


@pytest.mark.parametrize("q", [0.05, 0.3, 0.5, 0.9])
@pytest.mark.parametrize("score", [am.cross_entropy, am.brier])
def test_honesty_is_the_best_policy(q, score):
    # Weights q and 1 - q turn the mean into the expectation, so nothing is random here.
    p = np.linspace(0.001, 0.999, 999)
    expected = [score([1, 0], [x, x], weights=[q, 1 - q]).value for x in p]
    assert p[np.argmin(expected)] == pytest.approx(q)


class TestMurphy:
    @given(seed=SEEDS, bins=st.integers(1, 25))
    def test_the_parts_add_up_exactly(self, seed, bins):
        y, p = random_map(np.random.default_rng(seed))
        m = am.murphy(y, p, bins)
        total = m.reliability - m.resolution + m.uncertainty + m.within_bin
        assert total == pytest.approx(m.brier, abs=1e-14)
        assert m.brier == pytest.approx(am.brier(y, p).value)

    def test_any_binning_and_weights(self, rng):
        y, p = random_map(rng)
        m = am.murphy(y, p, [0, 0.01, 0.5, 0.55, 1], weights=rng.random(p.shape))
        total = m.reliability - m.resolution + m.uncertainty + m.within_bin
        assert total == pytest.approx(m.brier, abs=1e-14)

    def test_against_the_loop_of_the_definition(self, rng):
        y, p = random_map(rng, (200,))
        m = am.murphy(y, p, 5)
        reliability = resolution = 0.0
        for k in range(5):
            inside = (p >= k / 5) & ((p < (k + 1) / 5) | (k == 4))
            reliability += inside.sum() * (p[inside].mean() - y[inside].mean()) ** 2 / 200
            resolution += inside.sum() * (y[inside].mean() - y.mean()) ** 2 / 200
        assert m.reliability == pytest.approx(reliability)
        assert m.resolution == pytest.approx(resolution)

    def test_nothing_is_within_bins_of_one_forecast_each(self, rng):
        p = rng.choice([0.1, 0.5, 0.9], size=500)
        y = rng.random(500) < p
        assert am.murphy(y, p).within_bin == pytest.approx(0, abs=1e-15)

    def test_ends_belong_to_a_bin(self):
        m = am.murphy([0, 1], [0.0, 1.0], 2)
        assert m.count.tolist() == [1, 1]


Y, P = [1, 0], [0.5, 0.5]
REFUSED = {
    "label": (lambda: am.brier([1, 2], P), r"occupied\[1\] is 2; labels are 0 .* or 1"),
    "unknown as -1": (lambda: am.brier([1, -1], P), "Mark unknown cells"),
    "probability": (lambda: am.brier(Y, [0.5, 1.01]), r"probability\[1\] is 1.01"),
    "logits as probability": (lambda: am.cross_entropy(Y, [-2, 0.5]), "passed as logits"),
    "nan": (lambda: am.brier(Y, [np.nan, 0]), r"probability\[0\] is nan"),
    "shapes": (lambda: am.brier(Y, [0.5]), r"occupied has shape \(2,\) and probability \(1,\)"),
    "empty": (lambda: am.brier([], []), "occupied is empty"),
    "all unknown": (lambda: am.brier(Y, P, unknown=[1, 1]), "every cell is unknown"),
    "unknown shape": (lambda: am.brier(Y, P, unknown=[1]), r"unknown has shape \(1,\)"),
    "weights": (lambda: am.brier(Y, P, weights=[1, -1]), "no negative weight"),
    "no weight": (lambda: am.brier(Y, P, weights=[0, 0]), "all 0"),
    "both": (lambda: am.cross_entropy(Y, P, logits=P), "not both"),
    "neither": (lambda: am.cross_entropy(Y), "not neither"),
    "logit shape": (lambda: am.cross_entropy(Y, logits=[1]), r"logits \(1,\)"),
    "unit": (lambda: am.cross_entropy(Y, P, unit="bans"), "unit is 'bans'"),
    "bins": (lambda: am.murphy(Y, P, 0), "bins is 0"),
    "limits": (lambda: am.murphy(Y, P, [0, 0.5]), "limits from 0 to 1"),
    "limits order": (lambda: am.murphy(Y, P, [0, 0.5, 0.5, 1]), "must increase"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()
