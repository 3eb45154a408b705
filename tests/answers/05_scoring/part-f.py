# %% wrong: one q only, the middle
# says: your test accepts an implementation that clips p to [0.01, 0.99] first.
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    q = 0.5
    cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
    assert abs(p[np.argmin(cost)] - q) < 1e-9

# %% wrong: one q only, elsewhere
# says: your test accepts an implementation that clips p to [0.01, 0.99] first.
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    q = 0.3
    cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
    assert np.sum(cost <= cost.min() + 1e-12) == 1 and abs(p[np.argmin(cost)] - q) < 1e-9

# %% wrong: a coarse grid
# says: your test accepts an implementation that clips p to [0.01, 0.99] first.
def catches_improper_rules(rule):
    p = np.arange(1, 10) / 10
    for q in p:
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert abs(p[np.argmin(cost)] - q) < 1e-9
        assert np.sum(cost <= cost.min() + 1e-12) == 1

# %% wrong: ties are overlooked
# says: your test accepts an implementation that costs the same whatever you say.
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    for q in p:
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        honest = q * rule(q, 1) + (1 - q) * rule(q, 0)
        assert honest <= cost.min() + 1e-12

# %% wrong: ends of the interval are left out
# says: your test accepts an implementation that clips p to [0.01, 0.99] first.
def catches_improper_rules(rule):
    p = np.linspace(0.02, 0.98, 97)
    for k, q in enumerate(p):
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k] + 1e-15)

# %% wrong: a wide tolerance
# says: your test accepts an implementation that clips p to [0.01, 0.99] first.
def catches_improper_rules(rule):
    p = np.linspace(0.001, 0.999, 999)
    for q in p:
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert abs(p[np.argmin(cost)] - q) < 0.05

# %% wrong: an absolute tolerance on the costs
# says: your test rejects an implementation that is right (a millionth).
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    for k in (2, 5, 100, 300, 777, 998):
        q = p[k]
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k] + 1e-9)

# %% wrong: q at the ends, where 0 times infinity is nan
# says: your test rejects an implementation that is right (their sum).
def catches_improper_rules(rule):
    p = np.linspace(0, 1, 501)
    for k, q in enumerate(p):
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k])

# %% wrong: demands a finite cost
# says: your test rejects an implementation that is right (their sum).
def catches_improper_rules(rule):
    p = np.linspace(0, 1, 101)
    assert np.all(np.isfinite(rule(p, 1)))

# %% wrong: demands that a right answer costs nothing
# says: your test rejects an implementation that is right (a rule that is not symmetric).
def catches_improper_rules(rule):
    assert rule(1.0, 1) == 0 and rule(0.0, 0) == 0
    assert rule(0.9, 1) < rule(0.5, 1) < rule(0.1, 1)

# %% wrong: the cost only has to grow with the distance
# says: your test accepts an implementation that takes the absolute error.
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    assert np.all(np.diff(rule(p, 1)) < 0)
    assert np.all(np.diff(rule(p, 0)) > 0)

# %% wrong: the slope at q only
# says: your test accepts an implementation that costs the same whatever you say.
def catches_improper_rules(rule):
    for q in (0.2, 0.5, 0.7):
        def cost(p):
            return q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert abs(cost(q + 1e-6) - cost(q - 1e-6)) < 1e-9

# %% wrong: random labels, few of them
# says: your test accepts an implementation that clips p to [0.01, 0.99] first.
def catches_improper_rules(rule):
    rng = np.random.default_rng(0)
    for q in (0.3, 0.6):
        y = rng.random(200) < q
        p = np.linspace(0.01, 0.99, 99)
        cost = [np.mean(np.where(y, rule(x, 1), rule(x, 0))) for x in p]
        assert abs(p[np.argmin(cost)] - q) < 0.1

# %% wrong: symmetric costs are asked
# says: your test rejects an implementation that is right (a rule that is not symmetric).
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    assert np.allclose(rule(p, 1), rule(1 - p, 0))

# %% wrong: a truth value is returned
# says: your test accepts an implementation that takes the absolute error. It returns False; use a
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    q = 0.3
    cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
    return bool(abs(p[np.argmin(cost)] - q) < 1e-9)

# %% wrong: accepts everything
# says: your test accepts an implementation that takes the absolute error.
def catches_improper_rules(rule):
    rule(0.5, 1)

# %% wrong: rejects everything
# says: your test rejects an implementation that is right (Brier).
def catches_improper_rules(rule):
    raise AssertionError

# %% wrong: never calls the rule
# says: there is no answer yet: your test never calls what it is to test.
def catches_improper_rules(rule):
    assert True

# %% wrong: only Brier is right
# says: your test rejects an implementation that is right (their sum).
def catches_improper_rules(rule):
    p = np.linspace(0, 1, 11)
    assert np.allclose(rule(p, 1), (1 - p) ** 2)

# %% wrong: the arguments the other way round
# says: your test rejects an implementation that is right (their sum).
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    for k in (2, 100, 300, 777, 998):
        q = p[k]
        cost = q * rule(1, p) + (1 - q) * rule(0, p)
        assert np.all(np.delete(cost, k) > cost[k])

# %% wrong: one q and two neighbors
# says: your test accepts an implementation that takes 0.3 to 0.6 for 0.4.
def catches_improper_rules(rule):
    q = 0.005
    f = lambda p: q * rule(p, 1) + (1 - q) * rule(p, 0)
    assert f(0.004) > f(q) < f(0.006)

# %% wrong: one q near 0, on a fine grid
# says: your test accepts an implementation that takes 0.3 to 0.6 for 0.4.
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    cost = p[2] * rule(p, 1) + (1 - p[2]) * rule(p, 0)
    assert np.all(np.delete(cost, 2) > cost[2])

# %% wrong: one q near 1, on a fine grid
# says: your test accepts an implementation that takes 0.3 to 0.6 for 0.4.
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    cost = p[995] * rule(p, 1) + (1 - p[995]) * rule(p, 0)
    assert np.all(np.delete(cost, 995) > cost[995])

# %% wrong: only q near the ends, on a fine grid
# says: your test accepts an implementation that takes 0.3 to 0.6 for 0.4.
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    for k in (2, 5, 8, 992, 995, 998):
        cost = p[k] * rule(p, 1) + (1 - p[k]) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k])

# %% wrong: all q up to 0.95, on a fine grid
# says: your test accepts an implementation that caps p at 0.99 first.
def catches_improper_rules(rule):
    p = np.arange(1, 951) / 1000
    for k, q in enumerate(p):
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k])

# %% wrong: many q, but their neighbors only
# says: your test accepts an implementation that pays a bonus for p near 0.7.
def catches_improper_rules(rule):
    for q in np.arange(2, 999, 3) / 1000:
        cost = [q * rule(p, 1) + (1 - q) * rule(p, 0) for p in (q - 1e-4, q, q + 1e-4)]
        assert cost[0] > cost[1] < cost[2]

# %% right: argmin and the second best on a fine grid
def catches_improper_rules(rule):
    p = np.linspace(0.0005, 0.9995, 2000)
    for k in range(0, 2000, 7):
        q = p[k]
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        best, second = np.sort(cost)[:2]
        assert np.argmin(cost) == k, q
        assert second > best, "a tie"

# %% wrong: hand-picked true probabilities, ends of the interval included
# says: your test accepts an implementation that cheats in the interval [
def catches_improper_rules(rule):
    p = np.linspace(0, 1, 801)
    ones, zeros = np.ones(801, dtype=int), np.zeros(801, dtype=int)
    for k in (1, 3, 50, 123, 400, 555, 700, 797, 799):
        cost = p[k] * rule(p, ones) + (1 - p[k]) * rule(p, zeros)
        assert list(np.flatnonzero(cost == cost.min())) == [k]

# %% wrong: three hand-picked true probabilities
# says: your test accepts an implementation that cheats in the interval [
def catches_improper_rules(rule):
    p = np.linspace(0.001, 0.999, 999)
    for q in (0.35, 0.7, 0.995):
        i = np.abs(p - q).argmin()
        cost = q * rule(p, np.ones(999, int)) + (1 - q) * rule(p, np.zeros(999, int))
        assert (np.delete(cost, i) > cost[i]).all()

# %% wrong: above 1/2 only
# says: your test accepts an implementation that cheats in the interval [
def catches_improper_rules(rule):
    p = np.linspace(0.001, 0.999, 999)
    for i in range(500, 999):
        cost = p[i] * rule(p, np.ones(999, int)) + (1 - p[i]) * rule(p, np.zeros(999, int))
        assert (np.delete(cost, i) > cost[i]).all()

# %% wrong: below 1/2 only
# says: your test accepts an implementation that caps p at 0.99 first.
def catches_improper_rules(rule):
    p = np.linspace(0.001, 0.999, 999)
    for i in range(0, 501):
        cost = p[i] * rule(p, 1) + (1 - p[i]) * rule(p, 0)
        assert (np.delete(cost, i) > cost[i]).all()

# %% wrong: q from 0.1 to 0.9 in steps of 0.1, and near the ends
# says: your test accepts an implementation that cheats in the interval [
def catches_improper_rules(rule):
    p = np.arange(1, 1000) / 1000
    for q in (0.002, *np.arange(1, 10) / 10, 0.998):
        i = np.abs(p - q).argmin()
        cost = p[i] * rule(p, 1) + (1 - p[i]) * rule(p, 0)
        assert (np.delete(cost, i) > cost[i]).all()

# %% wrong: forecasts far from q only
# says: your test accepts an implementation that pays a bonus for p near 0.7.
def catches_improper_rules(rule):
    for q in np.arange(1, 1000) / 1000:
        honest = q * rule(q, 1) + (1 - q) * rule(q, 0)
        for p in (0.001, 0.25, 0.5, 0.75, 0.999):
            if abs(p - q) > 1e-9:
                assert q * rule(p, 1) + (1 - q) * rule(p, 0) > honest

# %% wrong: gains caught, ties not
# says: your test accepts an implementation that costs the same whatever you say.
def catches_improper_rules(rule):
    p = np.arange(1, 1000) / 1000
    for q in p:
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        honest = q * rule(q, 1) + (1 - q) * rule(q, 0)
        assert (cost >= honest - 1e-15).all()

# %% wrong: no q at all
# says: your test accepts an implementation that takes the absolute error.
def catches_improper_rules(rule):
    assert rule(0.9, 1) < rule(0.1, 1)
    assert rule(0.9, 0) > rule(0.1, 0)

# %% wrong: asserts the opposite
# says: your test rejects an implementation that is right (Brier).
def catches_improper_rules(rule):
    p = np.arange(1, 1000) / 1000
    for k, q in enumerate(p):
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert not (np.delete(cost, k) > cost[k]).all()

# %% wrong: the weights of the labels are exchanged
# says: your test rejects an implementation that is right (Brier).
def catches_improper_rules(rule):
    p = np.arange(1, 1000) / 1000
    for k, q in enumerate(p):
        cost = (1 - q) * rule(p, 1) + q * rule(p, 0)
        assert (np.delete(cost, k) > cost[k]).all()

# %% wrong: raises ValueError
# says: your test breaks with ValueError: improper on an implementation that takes the absolute er
def catches_improper_rules(rule):
    p = np.arange(1, 1000) / 1000
    for k, q in enumerate(p):
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        if not (np.delete(cost, k) > cost[k]).all():
            raise ValueError("improper")

# %% right: steps of 0.005
def catches_improper_rules(rule):
    p = np.arange(1, 200) / 200
    p = np.concatenate([[0.001, 0.002], p, [0.998, 0.999]])
    for q in p:
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert np.sum(cost <= q * rule(q, 1) + (1 - q) * rule(q, 0)) == 1, q

# %% right: a loop over numbers
def mean_cost(rule, p, q):
    return q * rule(p, 1) + (1 - q) * rule(p, 0)


def catches_improper_rules(rule):
    steps = [k / 400 for k in range(1, 400)]
    for q in steps:
        honest = mean_cost(rule, q, q)
        for p in steps[::3] + [q - 1e-3, q + 1e-3]:
            if p != q and not mean_cost(rule, p, q) > honest:
                raise AssertionError(f"{p} beats {q}")

# %% right: labels of bool, a matrix of costs
def catches_improper_rules(rule):
    p = np.linspace(0.002, 0.998, 499)
    yes, no = np.full(499, True), np.full(499, False)
    cost = np.outer(p, rule(p, yes)) + np.outer(1 - p, rule(p, no))
    own = np.diag(cost).copy()
    np.fill_diagonal(cost, np.inf)
    assert (cost.min(axis=1) > own).all()

# %% right: many random true probabilities
def catches_improper_rules(rule):
    rng = np.random.default_rng(7)
    q = np.sort(np.concatenate([rng.uniform(0, 1, 3000), [0.004, 0.996]]))[:, None]
    p = np.linspace(0, 1, 1001)[1:-1][None]
    cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
    honest = q * rule(q, 1) + (1 - q) * rule(q, 0)
    assert np.all((cost > honest) | (np.abs(p - q) < 1e-6))
