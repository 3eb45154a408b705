"""Stamps are matched as defined, nothing is extrapolated, and known clock offsets come back."""

import re

import numpy as np
import pytest
from evo.core import sync
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.spatial.transform import RigidTransform, Rotation, Slerp

import amrmetrics as am

# Multiples of 1/1024 s have exact differences: ties are ties.
STAMPS = st.sets(st.integers(-60, 60), min_size=1, max_size=40).map(
    lambda ticks: np.array(sorted(ticks)) / 1024
)
TICKS = st.integers(0, 30).map(lambda ticks: ticks / 1024)


def plain_associate(t, u, limit, offset):
    """Return the matches by the definition, looking at every pair."""
    free_t, free_u, found = {*range(len(t))}, {*range(len(u))}, []
    while True:
        chosen = {}
        for j in sorted(free_u):
            gaps = {i: abs(t[i] - (u[j] + offset)) for i in sorted(free_t)}
            i = min(gaps, key=gaps.get, default=None)
            if i is None or gaps[i] > limit:
                continue
            if i not in chosen or gaps[i] < chosen[i][0]:
                chosen[i] = gaps[i], j
        if not chosen:
            break
        found += [(i, j) for i, (_, j) in chosen.items()]
        free_t -= {*chosen}
        free_u -= {j for _, j in chosen.values()}
    pairs = sorted(i for i, _ in found), sorted(j for _, j in found)
    return list(zip(*pairs, strict=True))


class TestAssociate:
    @given(STAMPS, STAMPS, TICKS, TICKS, st.sampled_from([0.0, 1.3e9]))
    def test_is_what_the_definition_says(self, t, u, limit, offset, epoch):
        t, u = t + epoch, u + epoch
        expected = plain_associate(t, u, limit, offset)
        if expected:
            i, j = am.associate(t, u, limit, offset)
            assert list(zip(i.tolist(), j.tolist(), strict=True)) == expected
        else:
            with pytest.raises(am.AmrError, match="no stamps match within"):
                am.associate(t, u, limit, offset)

    @given(STAMPS, STAMPS)
    def test_is_one_to_one_in_time_order_and_within_the_limit(self, t, u):
        limit = 9 / 1024
        assume(np.abs(t[:, None] - u).min() <= limit)
        i, j = am.associate(t, u, limit)
        assert (np.diff(i) > 0).all()
        assert (np.diff(j) > 0).all()
        assert i.dtype == j.dtype == int
        assert np.abs(t[i] - u[j]).max() <= limit

    @given(STAMPS, STAMPS, TICKS)
    def test_leaves_no_free_neighbor_unused(self, t, u, limit):
        assume(np.abs(t[:, None] - u).min() <= limit)
        i, j = am.associate(t, u, limit)
        free_t, free_u = np.delete(t, i), np.delete(u, j)
        assert not free_t.size or not free_u.size or np.abs(free_t[:, None] - free_u).min() > limit

    def test_jitter_costs_no_matches(self, rng):
        t = np.arange(100_000) * 0.01
        u = np.sort(t + rng.normal(0, 0.002, len(t)))
        assert len(am.associate(t, u, 0.01)[0]) > 99_900

    @given(STAMPS, STAMPS)
    def test_is_symmetric_where_no_stamp_has_two_partners_in_reach(self, t, u):
        limit = 0.49 * min([*np.diff(t), *np.diff(u), 1.0])
        assume(np.abs(t[:, None] - u).min() <= limit)
        i, j = am.associate(t, u, limit)
        back_j, back_i = am.associate(u, t, limit)
        assert np.array_equal(i, back_i)
        assert np.array_equal(j, back_j)

    @given(STAMPS)
    def test_matches_a_recording_with_itself(self, t):
        i, j = am.associate(t, t, 0.0)
        assert np.array_equal(i, np.arange(len(t)))
        assert np.array_equal(i, j)

    @pytest.mark.parametrize(
        ("t", "u", "expected"),
        [
            ([0.0, 2.0], [1.0], [(0, 0)]),  # the earlier of two references
            ([1.0], [0.0, 2.0], [(0, 0)]),  # the earlier of two estimates
            ([0.0, 1.0, 2.0], [0.5, 1.5], [(0, 0), (1, 1)]),
            ([5.0], [1.0, 4.0, 4.5, 7.0], [(0, 2)]),
            ([0.0, 10.0], [4.0, 9.0], [(0, 0), (1, 1)]),
        ],
    )
    def test_ties_and_rivals(self, t, u, expected):
        i, j = am.associate(t, u, 10.0)
        assert list(zip(i.tolist(), j.tolist(), strict=True)) == expected

    @pytest.mark.parametrize("rates", [(30, 100), (100, 30), (20, 20), (200, 10)])
    def test_cameras_and_motion_capture(self, rng, rates):
        t, u = (1.3e9 + np.arange(0, 100, 1 / rate) for rate in rates)
        u = np.sort(u + rng.uniform(-1e-3, 1e-3, len(u)))
        i, j = am.associate(t, u, 0.02)
        assert len(i) == pytest.approx(min(len(t), len(u)), abs=2)
        sampled = rng.choice(len(i), 50)
        for k in sampled:
            assert np.abs(t[i[k]] - u[j[k]]) == np.abs(t - u[j[k]]).min()

    def test_longer_than_a_block_and_stamps_of_today(self, rng):
        t = 1.3e9 + np.arange(100_000) * 0.01
        u = np.unique(rng.uniform(t[0] - 1, t[-1] + 1, 150_000))
        nearest = np.abs(t[:, None] - u[None, ::1000]).argmin(0)
        i, j = am.associate(t, u, 0.004)
        partner = dict(zip(j.tolist(), i.tolist(), strict=True))
        for k, best in zip(range(0, len(u), 1000), nearest, strict=True):
            gap = abs(t[best] - u[k])
            assert partner.get(k, best) == best
            if gap > 0.004 + 1e-6:
                assert k not in partner
            elif k not in partner:  # then another estimate is nearer to that reference
                assert np.abs(u - t[best]).min() <= gap
        assert len(np.unique(i)) == len(i)

    def test_stamps_one_rounding_step_apart(self):
        step = np.spacing(1.3e9)
        for start in (1.3e9, 1.3e9 + step):
            i, j = am.associate([start, start + step], [start + step], 1.0)
            assert (i.tolist(), j.tolist()) == ([1], [0])

    def test_one_to_one_even_where_differences_round_to_the_same(self):
        i, j = am.associate([2.0**60], [1.0, 1.5, 2.0**59], 2.0**61)
        assert (i.tolist(), j.tolist()) == ([0], [2])

    def test_the_limit_is_inclusive_in_decimals_too(self):
        t = np.arange(100) / 10
        for epoch in (0, 1.3e9):
            assert len(am.associate(epoch + t, epoch + t + 0.01, 0.01)[0]) == 100
            assert len(am.associate(epoch + t, epoch + t + 0.011, 0.01, -0.001)[0]) == 100
            with pytest.raises(am.AmrError, match="no stamps match"):
                am.associate(epoch + t, epoch + t + 0.0101, 0.01)

    def test_evo_gives_one_reference_to_two_estimates(self):
        t, u = np.array([0.0, 0.1, 0.2]), np.array([0.098, 0.103, 0.2])
        evo_j, evo_i = sync.matching_time_indices(u, t)
        assert (evo_i, evo_j) == ([1, 1, 2], [0, 1, 2])
        i, j = am.associate(t, u)
        assert (i.tolist(), j.tolist()) == ([1, 2], [0, 2])

    def test_agrees_with_evo_where_stamps_are_far_apart(self, rng):
        t = np.cumsum(rng.uniform(0.05, 0.2, 500))
        u = t[rng.random(500) < 0.7] + 3 + rng.uniform(-0.015, 0.015)
        u += rng.uniform(-0.004, 0.004, len(u))
        evo_j, evo_i = sync.matching_time_indices(u, t, 0.01, 3.0)
        i, j = am.associate(t, u, 0.01, -3.0)
        assert (i.tolist(), j.tolist()) == (evo_i, evo_j)

    def test_lists_integers_read_only_and_unchanged(self):
        t, u = np.arange(5), np.arange(5, dtype=np.float32)
        t.flags.writeable = u.flags.writeable = False
        for args in ((t, u), (t.tolist(), u.tolist())):
            assert am.associate(*args)[0].tolist() == [0, 1, 2, 3, 4]
        assert am.associate([2.0], [2.0])[0].tolist() == [0]


def random_poses(rng, n, d):
    if d == 2:
        return am.planar_poses(rng.normal(size=(n, 2)), rng.uniform(-9, 9, n))
    return am.spatial_poses(rng.normal(size=(n, 3)), Rotation.random(n, rng=rng).as_quat())


class TestInterpolate:
    def test_equals_scipy_in_space(self, rng):
        stamps = 1.3e9 + np.cumsum(rng.uniform(0.1, 1, 50))
        new = np.sort(rng.uniform(stamps[0], stamps[-1], 200))
        X = random_poses(rng, 50, 3)
        Y = am.interpolate(stamps, X, new)
        expected = Slerp(stamps - 1.3e9, Rotation.from_matrix(X[:, :3, :3]))(new - 1.3e9)
        assert np.allclose(Y[:, :3, :3], expected.as_matrix(), atol=1e-12)
        for k in range(3):
            assert np.allclose(Y[:, k, 3], np.interp(new, stamps, X[:, k, 3]), atol=1e-9)
        assert np.allclose(RigidTransform.from_matrix(Y).as_matrix(), Y, atol=1e-12)

    def test_equals_unwrapped_headings_in_the_plane(self, rng):
        stamps = np.cumsum(rng.uniform(0.1, 1, 50))
        heading = np.cumsum(rng.uniform(-3, 3, 50))
        xy = rng.normal(size=(50, 2))
        new = np.sort(rng.uniform(stamps[0], stamps[-1], 200))
        Y = am.interpolate(stamps, am.planar_poses(xy, heading), new)
        expected = np.interp(new, stamps, heading)
        assert np.allclose(am.wrap(am.yaw(Y) - expected), 0, atol=1e-12)
        assert np.allclose(Y[:, 0, 2], np.interp(new, stamps, xy[:, 0]))

    @pytest.mark.parametrize("d", [2, 3])
    def test_gives_the_poses_back_at_their_own_stamps(self, rng, d):
        stamps, X = np.cumsum(rng.uniform(0.1, 1, 20)), random_poses(rng, 20, d)
        kept = stamps.copy(), X.copy()
        stamps.flags.writeable = X.flags.writeable = False
        assert np.allclose(am.interpolate(stamps, X, stamps), X, atol=1e-14)
        assert np.allclose(am.interpolate(list(stamps), X.tolist(), stamps[[3]]), X[[3]])
        assert np.array_equal(stamps, kept[0])
        assert np.array_equal(X, kept[1])
        assert np.array_equal(am.interpolate([7], X[:1], [7]), X[:1])

    @pytest.mark.parametrize("d", [2, 3])
    def test_turns_at_constant_speed(self, rng, d):
        X = random_poses(rng, 2, d)
        part = np.linspace(0, 1, 11)
        turn = am.rotation_angle(am.relative(X[0], am.interpolate([0, 1], X, part)))
        assert np.allclose(turn, part * turn[-1])

    def test_map_coordinates_keep_their_digits(self):
        X = am.planar_poses([[5e5, 5.4e6], [5e5 + 1, 5.4e6]], [0, 0])
        assert am.interpolate([0, 1], X, [0.25])[0, 0, 2] == 5e5 + 0.25


def heading(t):
    return (
        0.3 * t + np.sin(0.7 * t) + 0.4 * np.sin(1.9 * t + 1) + 0.2 * np.sin(3.1 * t * (1 + t / 99))
    )


def recording(rng, t, d, noise):
    """Return noisy poses at the times t of a robot that turns irregularly."""
    if d == 2:
        return am.planar_poses(np.zeros((len(t), 2)), heading(t) + noise * rng.normal(size=len(t)))
    turn = Rotation.from_euler("zyx", np.c_[heading(t), 0.5 * np.sin(1.1 * t), 0.2 * np.cos(t)])
    error = Rotation.from_rotvec(noise * rng.normal(size=(len(t), 3)))
    return am.spatial_poses(np.zeros((len(t), 3)), (turn * error).as_quat())


class TestClockOffset:
    @pytest.mark.parametrize("offset", [0.0, 0.35, -3.0, 1.3e9])
    @pytest.mark.parametrize("rates", [(100, 100), (100, 30), (10, 50)])
    @pytest.mark.parametrize("d", [2, 3])
    def test_recovers_a_known_offset(self, rng, d, rates, offset):
        t, u = np.arange(0, 40, 1 / rates[0]), np.arange(0, 40, 1 / rates[1])
        X, Y = (recording(rng, s, d, 0) for s in (t, u))
        found = am.clock_offset(t, X, u - offset, random_poses(rng, 1, d) @ Y)
        # Between samples 0.1 s apart, the angular speed is not quite a straight line.
        assert found == pytest.approx(offset, abs=1e-4, rel=1e-15)

    @pytest.mark.parametrize("d", [2, 3])
    def test_partial_overlap_another_start_and_another_mounting(self, rng, d):
        t, u = np.arange(0, 40, 0.01), np.arange(12, 55, 0.03)
        mounting = random_poses(rng, 1, d)
        Y = recording(rng, u, d, 1e-3) @ mounting
        found = am.clock_offset(t, recording(rng, t, d, 1e-3), u + 7, Y)
        assert found == pytest.approx(-7, abs=5e-3)

    @pytest.mark.parametrize("d", [2, 3])
    def test_noise_does_not_pull_to_one_side(self, d):
        found = []
        for seed in range(20):
            rng = np.random.default_rng(seed)
            t, u = np.arange(0, 30, 0.01), np.arange(5, 25, 1 / 30)
            pair = recording(rng, t, d, 0.01), recording(rng, u, d, 0.01)
            found.append(am.clock_offset(t, pair[0], u - 0.35, pair[1]))
        error = np.array(found) - 0.35
        assert error.std() < 5e-3
        # A mean of 20: four standard errors are exceeded by chance once in a thousand times.
        assert abs(error.mean()) < 4 * error.std() / np.sqrt(20)

    def test_is_what_associate_adds(self, rng):
        t = np.arange(0, 30, 0.02)
        X = recording(rng, t, 2, 0)
        late = t[200:900] + 1.234
        offset = am.clock_offset(t, X, late, X[200:900])
        i, j = am.associate(t, late, 1e-3, offset)
        assert np.array_equal(i, np.arange(200, 900))
        assert np.array_equal(j, np.arange(700))

    def test_gaps_lists_and_unchanged_inputs(self, rng):
        t = np.arange(0, 30, 0.02)
        t = t[(t < 10) | (t > 12)]
        X = recording(rng, t, 2, 0)
        kept = X.copy()
        t.flags.writeable = X.flags.writeable = False
        assert am.clock_offset(list(t), X, (t + 1).tolist(), X) == pytest.approx(-1, abs=1e-6)
        assert np.array_equal(X, kept)


EYES = np.tile(np.eye(3), (5, 1, 1))
TIMES = np.arange(0, 30, 0.02)
RNG = np.random.default_rng(0)


def turning(angle):
    return am.planar_poses(np.zeros((len(TIMES), 2)), angle)


WAVES = turning(heading(TIMES))
REFUSED = {
    "unsorted": (lambda: am.associate([0, 2, 1], [0]), "reference_stamps go back in time at ind"),
    "repeated": (lambda: am.associate([0], [1, 1]), "estimate_stamps repeat at index 1: 1.000000"),
    "empty": (lambda: am.associate([], [0]), "reference_stamps is empty"),
    "nan": (lambda: am.associate([0], [np.nan]), r"estimate_stamps\[0\] is nan"),
    "inf": (lambda: am.associate([np.inf], [0]), r"reference_stamps\[0\] is inf"),
    "shape": (lambda: am.associate([[0]], [0]), r"reference_stamps has shape \(1, 1\)"),
    "text": (lambda: am.associate(["now"], [0]), "must be an array of real numbers"),
    "negative limit": (lambda: am.associate([0], [0], -1), "max_difference is -1.0 s; it must not"),
    "two limits": (lambda: am.associate([0], [0], [1, 2]), r"max_difference has shape \(2,\)"),
    "nan offset": (lambda: am.associate([0], [0], offset=np.nan), "offset is nan"),
    "far offset": (lambda: am.associate([0], [0], offset=[[1]]), r"offset has shape \(1, 1\)"),
    "extrapolation": (
        lambda: am.interpolate(range(5), EYES, [3, 4.5]),
        "new_stamps run from 3.000000 to 4.500000 s, the recording from 0.000000 to 4.000000 s.*"
        "Nothing is extrapolated",
    ),
    "before": (lambda: am.interpolate(range(5), EYES, [-1e-9]), "Nothing is extrapolated"),
    "new unsorted": (lambda: am.interpolate(range(5), EYES, [2, 1]), "new_stamps go back in time"),
    "new empty": (lambda: am.interpolate(range(5), EYES, []), "new_stamps is empty"),
    "count": (lambda: am.interpolate(range(4), EYES, [1]), "stamps has 4 entries and X has 5"),
    "no rotations": (lambda: am.interpolate([0], [2 * np.eye(3)], [0]), r"X\[0\] has the last row"),
    "few samples": (
        lambda: am.clock_offset(range(5), EYES, range(3), EYES[:3]),
        "X has 5 and Xh 3 samples; a clock offset needs four",
    ),
    "clock count": (
        lambda: am.clock_offset(range(5), EYES, range(4), EYES),
        "estimate_stamps has 4 entries and Xh has 5",
    ),
    "clock dimensions": (
        lambda: am.clock_offset(range(5), EYES, range(5), np.tile(np.eye(4), (5, 1, 1))),
        "one of X and Xh is 2-D, the other 3-D",
    ),
    "no turn": (
        lambda: am.clock_offset(range(5), EYES, range(5), EYES),
        "the angular speed of X does not vary",
    ),
    "constant turn": (
        lambda: am.clock_offset(TIMES, WAVES, TIMES, turning(0.4 * TIMES)),
        "the angular speed of Xh does not vary",
    ),
    "constant turn and noise": (
        lambda: am.clock_offset(
            TIMES,
            turning(0.4 * TIMES + 1e-3 * RNG.normal(size=len(TIMES))),
            TIMES,
            turning(0.4 * TIMES + 1e-3 * RNG.normal(size=len(TIMES))),
        ),
        "agree at no offset",
    ),
    "two motions": (
        lambda: am.clock_offset(TIMES, WAVES, TIMES, turning(np.cumsum(RNG.normal(size=1500)))),
        r"agree at no offset \(correlation 0.\d\d at best\)",
    ),
    "periodic": (
        lambda: am.clock_offset(TIMES, turning(np.sin(TIMES)), TIMES, turning(np.sin(TIMES))),
        "the motion repeats itself",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()


class TestNoMatchSaysWhatWouldHelp:
    def test_the_offset_that_it_proposes_works(self):
        t, u = 1.3e9 + np.arange(9) / 10, np.arange(9) / 10
        for given_offset in (0.0, 5.0):
            with pytest.raises(am.AmrError, match="do not overlap") as caught:
                am.associate(t, u, 0.01, given_offset)
            offset = float(re.search(r"try offset=([\d.e+]+)", str(caught.value))[1])
            assert len(am.associate(t, u, 0.01, offset)[0]) == 9

    def test_the_tolerance_that_it_proposes_works(self):
        t = np.arange(9) / 10
        with pytest.raises(am.AmrError, match=r"typical gap 0.1 s") as caught:
            am.associate(t, t + 0.03)
        tolerance = float(re.search(r"Try max_difference=([\d.e-]+)", str(caught.value))[1])
        assert len(am.associate(t, t + 0.03, tolerance)[0]) == 9
        assert "from 0.030000 to 0.830000 s" in str(caught.value)

    def test_with_single_samples(self):
        with pytest.raises(am.AmrError, match="typical gap none"):
            am.associate([1.0], [2.0])


class TestEdgesOfAGap:
    @pytest.mark.parametrize(("step", "longest"), [(0.25, 2.5), (0.0625, 1.0)])
    def test_ten_usual_steps_and_at_least_a_second_are_bridged(self, step, longest):
        before = np.arange(40) * step
        for gap, bridged in ((longest, True), (longest + 0.001, False), (0.999 * longest, True)):
            t = np.r_[before, before[-1] + gap + before]
            run = am.Trajectory(t, am.planar_poses(np.c_[t, 0 * t], 0 * t))
            middle = np.array([before[-1] + gap / 2])
            if bridged:
                assert len(am.interpolate(run, middle)) == 1
            else:
                with pytest.raises(am.AmrError, match=f"a gap of more than max_gap={longest:g} s"):
                    am.interpolate(run, middle)
            ends = np.array([before[-1], before[-1] + gap])
            assert len(am.interpolate(run, ends)) == 2  # samples lie in no gap


@pytest.mark.parametrize("apart", [0.0101, 0.0125, 0.02, 0.026, 0.099, 0.0995, 0.3, 17.0, 0.5])
@pytest.mark.parametrize("start", [0.0, 1.5e9])
def test_advised_tolerance_is_enough_and_hardly_more(apart, start):
    t, u = start + np.array([0.0, 100.0]), start + np.array([apart, 40.0])
    with pytest.raises(am.AmrError, match="no stamps match") as caught:
        am.associate(t, u)
    advised = float(re.search(r"Try max_difference=(\S+) or more", str(caught.value))[1])
    assert len(am.associate(t, u, max_difference=advised)[0]) == 1
    assert apart * (1 - 1e-6) <= advised <= 1.1 * apart


def test_four_samples_are_enough_for_a_clock_offset():
    t = np.arange(4.0)
    X = am.planar_poses(np.zeros((4, 2)), [0, 0.1, 0.5, 0.6])
    assert float(am.clock_offset(t, X, t - 3, X)) == pytest.approx(3, abs=1e-6)
    with pytest.raises(am.AmrError, match=r"X has 3 and Xh 4 samples; .* needs four or more"):
        am.clock_offset(t[:3], X[:3], t, X)


@pytest.mark.parametrize(("part", "enough"), [(1e-4, True), (1e-8, False)])
def test_an_angular_speed_that_hardly_varies(part, enough):
    t = np.arange(0, 60, 0.05)
    turned = 0.4 * t + part * (np.sin(t) + 0.6 * np.sin(2.3 * t) + 0.3 * np.cos(0.37 * t))
    X = am.planar_poses(np.zeros((len(t), 2)), turned)
    if enough:
        assert float(am.clock_offset(t, X, t - 0.35, X)) == pytest.approx(0.35, abs=1e-3)
    else:
        with pytest.raises(am.AmrError, match="the angular speed of X does not vary"):
            am.clock_offset(t, X, t - 0.35, X)


@pytest.mark.parametrize(("square", "enough"), [(0.48, False), (0.52, True)])
def test_half_of_the_variance_has_to_agree(rng, square, enough):
    from amrmetrics.stamps import _coarse_lag

    w, noise = rng.normal(size=(2, 4000))
    w -= w.mean()
    noise -= noise.mean()
    noise -= w * (w @ noise) / (w @ w)
    v = np.sqrt(square) * w / np.std(w) + np.sqrt(1 - square) * noise / np.std(noise)
    if enough:
        assert _coarse_lag(w, v, 5, 0.1) == 0
    else:
        with pytest.raises(am.AmrError, match=r"agree at no offset \(correlation 0\.69 at best"):
            _coarse_lag(w, v, 5, 0.1)
