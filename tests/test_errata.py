"""Every number of ERRATA.md, computed from the definitions and looked up in its entry.

Nothing of the library is used where the definition itself is in doubt; its part is named where
an entry says what the library does instead.
"""

import re
from pathlib import Path

import numpy as np
import pytest
from evo.core import filters, geometry, metrics, result, sync, trajectory
from scipy import integrate, stats
from scipy.spatial.distance import cdist
from scipy.spatial.transform import Rotation
from sklearn.metrics import log_loss
from test_simulation import aligned, brier, rms, rpe, rpe_shortcut, squares

import amrmetrics as am

ERRATA = Path(__file__).parents[1].joinpath("ERRATA.md").read_text("utf-8")
ENTRIES = re.findall(r"^### ([EL]\d+): ", ERRATA, re.M)


def entry(name):
    """Give the text of one entry, in one line and with plain signs."""
    found = re.search(rf"^### {name}: .*?(?=^##|\Z)", ERRATA, re.M | re.S)
    return " ".join(found[0].replace("−", "-").split())


def says(name, *phrases):
    """Check that the entry holds each phrase, whose numbers a test has just computed."""
    text = entry(name)
    for phrase in phrases:
        assert phrase in text, f"{name} does not say {phrase!r}"


@pytest.fixture(scope="module")
def run():
    return am.simulation.demonstration()


@pytest.mark.parametrize("name", ENTRIES)
def test_each_entry_says_what_is_right_gives_a_number_and_names_a_test_that_exists(name):
    text = entry(name)
    for head in ("**Said:**", "**Right:**", "**Number:**", "**Test:**"):
        assert head in text
    tests = re.findall(r"`(test_\w+)`", text.split("**Test:**")[1])
    assert tests and set(tests) <= set(globals())
    assert f"| {name} |" in ERRATA or name.startswith("L")


# The source lesson


def test_e1_the_rpe_shortcut_depends_on_the_frame(run):
    X, X_hat = run.truth, run.estimate
    moved = aligned(X, X_hat)
    says("E1", f"Shortcut: {rpe_shortcut(X, X_hat):.6f} m before alignment")
    says("E1", f"{rpe_shortcut(X, moved):.6f} m after it")
    says("E1", f"Definition: {rpe(X, X_hat):.6f} m both times")
    assert rpe(X, moved) == pytest.approx(rpe(X, X_hat), rel=1e-12)
    assert rpe_shortcut(X, moved) < rpe(X, X_hat)


@pytest.mark.parametrize("degrees", [7, -30, 180])
def test_e1_size_of_the_phantom_error(run, degrees):
    gamma = np.radians(degrees)
    G = am.planar_poses([[1.5, -0.8]], [gamma])[0]
    X = run.truth
    expected = 2 * abs(np.sin(gamma / 2)) * rms((X[5:] - X[:-5])[:, :2, 2])
    assert rpe_shortcut(X, G @ X) == pytest.approx(expected, rel=1e-12)
    assert rpe(X, G @ X) < 1e-12


def test_e2_the_expected_nis_is_not_2(run):
    mean = squares(run.innovations, run.innovation_covariance).mean()
    drawn, stated = np.array([0.08, np.radians(2.0)]), np.array([0.1, np.radians(2.5)])
    expected = np.sum(drawn**2 / stated**2)
    low, high = stats.chi2.ppf([0.025, 0.975], 400) / 200
    says("E2", f"0.8² + 0.8² = {expected:.2f}", f"the run gives {mean:.4f}")
    says("E2", f"[{low:.3f}, {high:.3f}]")
    assert mean < low
    # Under its true distribution, 0.64 chi2_400 / 200, the value is an ordinary one.
    assert 0.025 < stats.chi2.cdf(200 * mean / 0.64, 400) < 0.975


def test_e3_the_expected_anees_is_not_3_and_the_test_rarely_sees_it(run):
    mean = squares(run.errors, run.error_covariance).mean()
    ratio = (1.0 / 1.1) ** 2
    low, high = stats.chi2.ppf([0.025, 0.975], 600)
    says("E3", f"(1.0/1.1)² = {2 + ratio:.3f}", f"the run gives {mean:.4f}")
    says("E3", f"[{low / 200:.3f}, {high / 200:.3f}]")
    assert low < 200 * mean < high

    # 200 ANEES = A + ratio B with A ~ chi2_400 and B ~ chi2_200, independent.
    def below(limit):
        density = stats.chi2(200).pdf
        return integrate.quad(
            lambda b: density(b) * stats.chi2.cdf(limit - ratio * b, 400), 90, 350, epsabs=1e-10
        )[0]

    power = below(low) + 1 - below(high)
    says("E3", f"in only {100 * power:.1f} % of all runs")


def test_e4_the_fudge_makes_an_undefined_precision_the_worst_one(run):
    nothing = np.zeros_like(run.occupied)
    tp, fp = np.sum(nothing & run.occupied), np.sum(nothing & ~run.occupied)
    assert tp == fp == 0
    says("E4", f"the lesson's precision is {tp / (tp + fp + 1e-12):.0f}")
    # It also makes a perfect precision imperfect.
    assert 1 / (1 + 0 + 1e-12) < 1
    result = am.confusion(run.occupied, nothing.astype(float))
    assert np.isnan(result.precision)


def test_e5_clipping_belongs_to_the_logarithm(run):
    q, p = run.occupied, run.probability
    says("E5", f"[{p.min():.5f}, {p.max():.5f}]", f"Brier score is {brier(q, p):.7f}")
    assert min(p.min(), 1 - p.max()) > 0.004
    for clip in (1e-12, 1e-6, 1e-3, 0.004):
        assert brier(q, np.clip(p, clip, 1 - clip)) == brier(q, p)
    assert brier(q, np.clip(p, 0.005, 0.995)) != brier(q, p)
    # A map that is certain and right has Brier score 0, and not clip**2.
    assert brier(q, q.astype(float)) == 0
    assert brier(q, np.clip(q, 0.01, 0.99)) == pytest.approx(0.01**2)
    says("E5", "ε² when clipped (10⁻⁴ for ε = 0.01)")
    # A clipped logarithm is not strictly proper: below the clip the truth gains nothing.
    rate, clip = 1e-4, 1e-3

    def expected_score(report):
        report = np.clip(report, clip, 1 - clip)
        return -rate * np.log(report) - (1 - rate) * np.log(1 - report)

    says("E5", "probability 10⁻⁴ and ε = 10⁻³, the reports 10⁻⁴, 5·10⁻⁴ and 0")
    assert expected_score(1e-4) == expected_score(5e-4) == expected_score(0)


def test_e6_an_explicit_inverse_accepts_what_is_no_covariance():
    indefinite = np.array([[1.0, 2.0], [2.0, 1.0]])
    error = np.array([[1.0, -1.0]])
    says("E6", f"a squared length of {squares(error, indefinite)[0]:.0f}")
    with pytest.raises(np.linalg.LinAlgError):
        np.linalg.cholesky(indefinite)
    with pytest.raises(am.AmrError, match="positive definite"):
        am.nees(error, indefinite)


def test_e7_heading_depends_on_the_rule_of_differences(run):
    t, X = run.stamps, run.truth
    forward = np.diff(X[:, :2, 2], axis=0)
    one_sided = np.arctan2(forward[:, 1], forward[:, 0])
    exact = np.arctan2(0.8 * np.cos(0.4 * t), 0.5)
    heading = np.arctan2(X[:, 1, 0], X[:, 0, 0])
    inner = slice(1, -1)
    central_error = np.degrees(np.abs(heading - exact)[inner].max())
    one_sided_error = np.degrees(np.abs(one_sided - exact[:-1]).max())
    says("E7", f"at most {central_error:.2f}°", f"up to {one_sided_error:.2f}°")
    # Standing still, the rule has no answer at all, and arctan2 gives 0 without a word.
    assert np.arctan2(0.0, 0.0) == 0


def test_e8_successive_instants_are_not_independent_trials():
    # Errors with the stated covariance at every instant, nine tenths of which remain.
    rng = np.random.default_rng(8)
    kept, runs, instants = 0.9, 20_000, 200
    error = rng.standard_normal((runs, 3))
    total = np.sum(error**2, axis=1)
    for _ in range(1, instants):
        error = kept * error + np.sqrt(1 - kept**2) * rng.standard_normal((runs, 3))
        total += np.sum(error**2, axis=1)
    low, high = stats.chi2.ppf([0.025, 0.975], 3 * instants)
    rejected = (total < low) | (total > high)
    of_400 = rejected.reshape(50, 400).mean(axis=1)
    says("E8", f"rejects {100 * rejected.mean():.0f} % of such consistent runs")
    says("E8", f"between {100 * of_400.min():.0f} and {100 * of_400.max():.0f} %")


def test_e9_a_common_motion_changes_neither_error(run):
    X, X_hat = run.truth, run.estimate
    G, H = am.planar_poses([[40, -7], [-3, 12]], [1.1, -2.0])
    cases = {"recorded": (X, X_hat), "common": (G @ X, G @ X_hat), "different": (G @ X, H @ X_hat)}
    apart = {name: rms((A - B)[:, :2, 2]) for name, (A, B) in cases.items()}
    for A, B in cases.values():
        says("E9", f"over 5 samples {rpe(A, B):.6f} m")
        assert am.rpe(A, B, 5).translation.rmse == pytest.approx(rpe(A, B))
        says("E9", f"aligned ATE {am.ate(A, B).rmse:.6f} m each time")
    assert apart["recorded"] == pytest.approx(apart["common"], rel=1e-12)
    says("E9", f"without alignment {apart['common']:.4f} m", f"instead: {apart['different']:.4f} m")


# Literature and tools


def test_l1_a_rotation_without_its_determinant():
    rng = np.random.default_rng(1)
    cloud = rng.standard_normal((200_000, 3, 2)) * (1, 0.2)
    seen = cloud + 0.15 * rng.standard_normal(cloud.shape)
    centered = [Z - Z.mean(axis=1, keepdims=True) for Z in (cloud, seen)]
    cross = centered[0].transpose(0, 2, 1) @ centered[1]
    U, _, Vt = np.linalg.svd(cross)
    mirrored = np.mean(np.linalg.det(U @ Vt) < 0)
    # 0.1 % of 200 000 trials: one standard error.
    assert mirrored == pytest.approx(0.216, abs=0.004)
    says("L1", "(1, 0.2) and noise 0.15: 21.6 %")


def rotation_that_evo_finds(p, q):
    return geometry.umeyama_alignment(q.T, p.T)[0]


def test_l2_an_absolute_threshold_for_degenerate_positions():
    off = []
    for seed in range(6):
        rng = np.random.default_rng(seed)
        p = np.outer(np.linspace(0, 100, 200), [0.6, 0.8, 0.0])
        R = Rotation.random(rng=rng).as_matrix()
        q = (p + 1e-3 * rng.standard_normal(p.shape)) @ R
        p = p + 1e-3 * rng.standard_normal(p.shape)
        difference = Rotation.from_matrix(rotation_that_evo_finds(p, q) @ R.T)
        off.append(np.degrees(difference.magnitude()))
        with pytest.raises(am.DegenerateAlignmentError):
            am.align(p, q)
    says("L2", f"off by {min(off):.0f}° to {max(off):.0f}°")

    angle = np.linspace(0, 6, 50)
    tiny = 0.5e-9 * np.column_stack([np.cos(angle), np.sin(angle), np.sin(2 * angle)])
    with pytest.raises(geometry.GeometryException):
        rotation_that_evo_finds(tiny, tiny)
    assert np.allclose(am.align(tiny, tiny).rotation, np.eye(3), atol=1e-9)


def test_l3_a_cross_entropy_that_depends_on_the_type_of_the_numbers():
    double, single = np.array([0.0, 0.5]), np.float32([0.0, 0.5])
    says("L3", f"`log_loss` is {log_loss([1, 0], double):.2f} in double precision")
    says("L3", f"{log_loss([1, 0], single):.2f} in single precision")
    for forecast in (double, single):
        score = am.cross_entropy([1, 0], forecast)
        assert score.value == np.inf and score.offending.tolist() == [[0]]


def both_ways(P, Q, power):
    distance = cdist(P, Q) ** power
    return distance.min(axis=0).mean() + distance.min(axis=1).mean()


def test_l4_four_distances_of_one_name():
    truth = 10.0 * np.arange(100)[:, None] * (1, 0)
    few, all_of_them = truth.copy(), truth + (0, 0.2)
    few[:5] += (0, 1)
    plain = both_ways(truth, few, 1), both_ways(truth, all_of_them, 1)
    squared = both_ways(truth, few, 2), both_ways(truth, all_of_them, 2)
    says("L4", f"({plain[0]:.2f} m to {plain[1]:.2f} m)")
    says("L4", f"({squared[0]:.2f} m² to {squared[1]:.2f} m²)")
    assert am.chamfer(truth, few).value == pytest.approx(plain[0])


def evo_summary(errors):
    metric = metrics.APE(metrics.PoseRelation.translation_part)
    metric.error = errors
    return metric.get_result()


def test_l5_the_mean_of_two_rmses():
    short, long = np.full(10, 1.0), np.full(90, 3.0)
    merged = result.merge_results([evo_summary(short), evo_summary(long)])
    pooled = np.sqrt(np.mean(np.concatenate([short, long]) ** 2))
    says("L5", f"evo's merged RMSE is {merged.stats['rmse']:.1f} m")
    says("L5", f"that of all hundred samples {pooled:.2f} m")
    truth = np.zeros((100, 2))
    runs = [
        am.ate(truth[: len(errors)], errors[:, None] * (1.0, 0.0), "none")
        for errors in (short, long)
    ]
    assert am.pool(runs).rmse == pytest.approx(pooled)


def test_l6_steps_that_are_longer_than_asked(run):
    xy = run.truth[::8, :2, 2]
    poses = [np.eye(4) for _ in xy]
    for pose, position in zip(poses, xy, strict=True):
        pose[:2, 3] = position
    walked = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(xy, axis=0), axis=1))])
    pairs = np.array(filters.filter_pairs_by_path(poses, 1.0))
    lengths = np.diff(walked[pairs], axis=1)
    says("L6", f"between {lengths.min():.2f} m and {lengths.max():.2f} m")
    ours = am.rpe(run.truth[::8], run.estimate[::8], 1, "meters", "consecutive")
    assert np.all(np.abs(ours.lengths - 1) <= 0.1)


def test_l7_one_true_sample_for_three_estimates():
    stamps = {"truth": np.array([0, 0.1, 0.2, 0.3]), "estimate": np.array([0.1, 0.101, 0.102])}
    paths = {
        name: trajectory.PoseTrajectory3D(
            positions_xyz=np.column_stack([t, t, t]),
            orientations_quat_wxyz=np.tile([1.0, 0, 0, 0], (len(t), 1)),
            timestamps=t,
        )
        for name, t in stamps.items()
    }
    true, estimated = sync.associate_trajectories(paths["truth"], paths["estimate"])
    assert list(true.timestamps) == [0.1, 0.1, 0.1]
    assert list(estimated.timestamps) == [0.1, 0.101, 0.102]
    says("L7", "truth at 0, 0.1, 0.2 and 0.3 s", "estimates at 0.100, 0.101 and 0.102 s")
    i, j = am.associate(stamps["truth"], stamps["estimate"])
    assert (list(i), list(j)) == ([1], [0])


def test_l8_degrees_with_another_pi():
    says("L8", f"π/3.14 = {np.pi / 3.14:.6f}")


def test_l9_the_first_stamp_that_is_not_earlier():
    rng = np.random.default_rng(36)
    clock = 0.01 * np.arange(2000)
    jittered = clock + rng.uniform(-0.002, 0.002, size=2000)

    def position(t):
        return np.column_stack([2 * t, 2 * np.sin(t)])

    observed = position(jittered) + 0.01 * rng.normal(size=(2000, 2))

    def ate(i, j):
        return am.ate(position(clock[i]), observed[j]).rmse

    nearest = ate(*am.associate(clock, jittered))
    later = ate(np.arange(1999), np.searchsorted(jittered, clock[:-1]))
    says("L9", f"{nearest:.4f} m with the nearest stamp", f"{later:.4f} m with the first")
