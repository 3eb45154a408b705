# %% wrong: one q only, the middle
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    q = 0.5
    cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
    assert abs(p[np.argmin(cost)] - q) < 1e-9


# %% wrong: one q only, elsewhere
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    q = 0.3
    cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
    assert np.sum(cost <= cost.min() + 1e-12) == 1 and abs(p[np.argmin(cost)] - q) < 1e-9


# %% wrong: a coarse grid
def catches_improper_rules(rule):
    p = np.arange(1, 10) / 10
    for q in p:
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert abs(p[np.argmin(cost)] - q) < 1e-9
        assert np.sum(cost <= cost.min() + 1e-12) == 1


# %% wrong: ties are overlooked
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    for q in p:
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        honest = q * rule(q, 1) + (1 - q) * rule(q, 0)
        assert honest <= cost.min() + 1e-12


# %% wrong: ends of the interval are left out
def catches_improper_rules(rule):
    p = np.linspace(0.02, 0.98, 97)
    for k, q in enumerate(p):
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k] + 1e-15)


# %% wrong: a wide tolerance
def catches_improper_rules(rule):
    p = np.linspace(0.001, 0.999, 999)
    for q in p:
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert abs(p[np.argmin(cost)] - q) < 0.05


# %% wrong: an absolute tolerance on the costs
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    for k in (2, 5, 100, 300, 777, 998):
        q = p[k]
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k] + 1e-9)


# %% wrong: q at the ends, where 0 times infinity is nan
def catches_improper_rules(rule):
    p = np.linspace(0, 1, 501)
    for k, q in enumerate(p):
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k])


# %% wrong: demands a finite cost
def catches_improper_rules(rule):
    p = np.linspace(0, 1, 101)
    assert np.all(np.isfinite(rule(p, 1)))


# %% wrong: demands that a right answer costs nothing
def catches_improper_rules(rule):
    assert rule(1.0, 1) == 0 and rule(0.0, 0) == 0
    assert rule(0.9, 1) < rule(0.5, 1) < rule(0.1, 1)


# %% wrong: the cost only has to grow with the distance
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    assert np.all(np.diff(rule(p, 1)) < 0)
    assert np.all(np.diff(rule(p, 0)) > 0)


# %% wrong: the slope at q only
def catches_improper_rules(rule):
    for q in (0.2, 0.5, 0.7):
        def cost(p):
            return q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert abs(cost(q + 1e-6) - cost(q - 1e-6)) < 1e-9


# %% wrong: random labels, few of them
def catches_improper_rules(rule):
    rng = np.random.default_rng(0)
    for q in (0.3, 0.6):
        y = rng.random(200) < q
        p = np.linspace(0.01, 0.99, 99)
        cost = [np.mean(np.where(y, rule(x, 1), rule(x, 0))) for x in p]
        assert abs(p[np.argmin(cost)] - q) < 0.1


# %% wrong: symmetric costs are asked
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    assert np.allclose(rule(p, 1), rule(1 - p, 0))


# %% wrong: a truth value is returned
def catches_improper_rules(rule):
    p = np.linspace(0.01, 0.99, 99)
    q = 0.3
    cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
    return bool(abs(p[np.argmin(cost)] - q) < 1e-9)


# %% wrong: accepts everything
def catches_improper_rules(rule):
    rule(0.5, 1)


# %% wrong: rejects everything
def catches_improper_rules(rule):
    raise AssertionError


# %% wrong: never calls the rule
def catches_improper_rules(rule):
    assert True


# %% wrong: only Brier is right
def catches_improper_rules(rule):
    p = np.linspace(0, 1, 11)
    assert np.allclose(rule(p, 1), (1 - p) ** 2)


# %% wrong: the arguments the other way round
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    for k in (2, 100, 300, 777, 998):
        q = p[k]
        cost = q * rule(1, p) + (1 - q) * rule(0, p)
        assert np.all(np.delete(cost, k) > cost[k])


# %% wrong: one q and two neighbors
def catches_improper_rules(rule):
    q = 0.005
    f = lambda p: q * rule(p, 1) + (1 - q) * rule(p, 0)
    assert f(0.004) > f(q) < f(0.006)


# %% wrong: one q near 0, on a fine grid
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    cost = p[2] * rule(p, 1) + (1 - p[2]) * rule(p, 0)
    assert np.all(np.delete(cost, 2) > cost[2])


# %% wrong: one q near 1, on a fine grid
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    cost = p[995] * rule(p, 1) + (1 - p[995]) * rule(p, 0)
    assert np.all(np.delete(cost, 995) > cost[995])


# %% wrong: only q near the ends, on a fine grid
def catches_improper_rules(rule):
    p = np.arange(1001) / 1000
    for k in (2, 5, 8, 992, 995, 998):
        cost = p[k] * rule(p, 1) + (1 - p[k]) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k])


# %% wrong: all q up to 0.95, on a fine grid
def catches_improper_rules(rule):
    p = np.arange(1, 951) / 1000
    for k, q in enumerate(p):
        cost = q * rule(p, 1) + (1 - q) * rule(p, 0)
        assert np.all(np.delete(cost, k) > cost[k])


# %% wrong: many q, but their neighbors only
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


# %% right: a loop over numbers and random true probabilities
def catches_improper_rules(rule):
    rng = np.random.default_rng(1)
    tried = [*rng.uniform(0.001, 0.999, 40), 0.003, 0.006, 0.994, 0.997]
    for q in map(float, tried):
        honest = q * rule(q, 1) + (1 - q) * rule(q, 0)
        for p in [*np.linspace(0.001, 0.999, 200), *(q + d for d in (-0.02, -5e-4, 5e-4, 0.02))]:
            if 0 < p < 1 and abs(p - q) > 1e-6:
                assert q * rule(p, 1) + (1 - q) * rule(p, 0) > honest, (q, p)


# %% right: labels as arrays, ends of the interval included
def catches_improper_rules(rule):
    p = np.linspace(0, 1, 801)
    ones, zeros = np.ones(801, dtype=int), np.zeros(801, dtype=int)
    for k in (1, 3, 50, 123, 400, 555, 700, 797, 799):
        cost = p[k] * rule(p, ones) + (1 - p[k]) * rule(p, zeros)
        assert list(np.flatnonzero(cost == cost.min())) == [k]
