# %% wrong: one clear case
# says: your test accepts an implementation that compares the means alone.
def catches_wrong_winners(winner):
    assert winner(np.array([1.0, 1.1, 1.2]), np.array([0.5, 0.61, 0.7])) == "B"

# %% wrong: clear cases only
# says: your test accepts an implementation that ignores that the runs are paired.
def catches_wrong_winners(winner):
    rng = np.random.default_rng(0)
    b = rng.uniform(1, 2, 8)
    a = b + 0.5 + 0.05 * rng.normal(size=8)
    assert winner(a, b) == "B"
    assert winner(b, a) == "A"
    assert winner(b + 0.05 * rng.normal(size=8), b) == "undecided"

# %% wrong: P5 of both sides
# says: your test accepts an implementation that compares the means alone.
def catches_wrong_winners(winner):
    d = np.array([0.12, 0.08, 0.10, 0.03, 0.09, 0.05, 0.07, 0.11])
    b = np.array([0.31, 0.54, 0.24, 0.62, 0.39, 0.47, 0.28, 0.51])
    assert winner(b + d, b) == "B"
    assert winner(b, b + d) == "A"

# %% wrong: edges of 8 runs, no failures
# says: your test accepts an implementation that sorts the runs before it pairs them.
def catches_wrong_winners(winner):
    rng = np.random.default_rng(1)
    x = rng.normal(size=8)
    x = (x - x.mean()) / x.std(ddof=1)
    for t, name in ((2.36, "undecided"), (2.37, "B")):
        b = rng.uniform(1, 3, 8)
        a = b + 0.01 * (x + t / np.sqrt(8))
        assert winner(a, b) == name
        assert winner(b, a) == name.replace("B", "A")

# %% wrong: edges of several N, no failures
# says: your test accepts an implementation that sorts the runs before it pairs them.
def catches_wrong_winners(winner):
    rng = np.random.default_rng(1)
    for N in (3, 8, 30):
        x = rng.normal(size=N)
        x = (x - x.mean()) / x.std(ddof=1)
        q = stats.t.ppf(0.975, N - 1)
        for t, name in ((0.99 * q, "undecided"), (1.01 * q, "B")):
            b = rng.uniform(1, 3, N)
            a = b + 0.01 * (x + t / np.sqrt(N))
            assert winner(a, b) == name
            assert winner(b, a) == name.replace("B", "A")

# %% wrong: the runs of B are all alike
# says: your test accepts an implementation that sorts the runs before it pairs them.
def catches_wrong_winners(winner):
    for N in (3, 8, 30):
        x = np.arange(N) ** 2.0
        x = (x - x.mean()) / x.std(ddof=1)
        q = stats.t.ppf(0.975, N - 1)
        for t, name in ((0.99 * q, "undecided"), (1.01 * q, "B")):
            b = np.full(N, 2.0)
            a = b + 0.1 * (x + t / np.sqrt(N))
            assert winner(a, b) == name
            assert winner(b, a) == name.replace("B", "A")

# %% wrong: differences that are symmetric
# says: your test accepts an implementation that takes the median for the mean.
def catches_wrong_winners(winner):
    for N in (3, 8, 30):
        x = np.linspace(-1, 1, N)
        x = x / x.std(ddof=1)
        q = stats.t.ppf(0.975, N - 1)
        for t, name in ((0.99 * q, "undecided"), (1.01 * q, "B")):
            b = 2 + np.cos(5 * np.arange(N))
            a = b + 0.1 * (x + t / np.sqrt(N))
            assert winner(a, b) == name
            assert winner(b, a) == name.replace("B", "A")

# %% right: large differences
def catches_wrong_winners(winner):
    rng = np.random.default_rng(8)
    for N in (4, 9, 25):
        x = rng.gamma(2, size=N)
        x = (x - x.mean()) / x.std(ddof=1)
        q = stats.t.ppf(0.975, N - 1)
        for t, name in ((0.99 * q, "undecided"), (1.01 * q, "B")):
            d = 0.3 * (x + t / np.sqrt(N))
            b = rng.uniform(1.5, 3.5, N)
            a = b + d
            assert winner(a, b) == name
            assert winner(b, a) == name.replace("B", "A")
            k = int(np.argmax(d))
            a[k], b[k] = np.nan, 5 - d[k]
            assert winner(a, b) == name
            assert winner(b, a) == name.replace("B", "A")

# %% wrong: failures of A only
# says: your test accepts an implementation that sorts the runs before it pairs them.
def catches_wrong_winners(winner):
    rng = np.random.default_rng(1)
    for N in (3, 8, 30):
        x = rng.normal(size=N)
        x = (x - x.mean()) / x.std(ddof=1)
        q = stats.t.ppf(0.975, N - 1)
        for t, name in ((0.99 * q, "undecided"), (1.01 * q, "B")):
            b = rng.uniform(1, 3, N)
            d = 0.01 * (x + t / np.sqrt(N))
            a = b + d
            assert winner(a, b) == name
            assert winner(b, a) == name.replace("B", "A")
            k = d.argmax()
            a[k], b[k] = np.nan, 5 - d[k]
            assert winner(a, b) == name

# %% wrong: never asks for A
# says: your test accepts an implementation that sorts the runs before it pairs them.
def catches_wrong_winners(winner):
    rng = np.random.default_rng(1)
    for N in (3, 8, 30):
        x = rng.normal(size=N)
        x = (x - x.mean()) / x.std(ddof=1)
        q = stats.t.ppf(0.975, N - 1)
        for t, name in ((0.99 * q, "undecided"), (1.01 * q, "B")):
            b = rng.uniform(1, 3, N)
            a = b + 0.01 * (x + t / np.sqrt(N))
            assert winner(a, b) == name

# %% wrong: random data, share of false alarms
# says: your test accepts an implementation that sorts the runs before it pairs them.
def catches_wrong_winners(winner):
    rng = np.random.default_rng(2)
    found = []
    for _ in range(300):
        b = rng.uniform(1, 3, 8)
        found.append(winner(b + 0.05 * rng.normal(size=8), b) != "undecided")
    assert 0.01 < np.mean(found) < 0.09

# %% wrong: believes in the normal quantile
# says: your test rejects an implementation that is right (the t interval, failures as 5 m). It ac
def catches_wrong_winners(winner):
    x = np.array([-1.0, 0.0, 1.0, 0.5, -0.5, 0.7, -0.7, 0.0])
    x = x / x.std(ddof=1)
    for t, name in ((1.9, "undecided"), (2.0, "B")):
        b = np.linspace(1, 3, 8)
        assert winner(b + 0.01 * (x + t / np.sqrt(8)), b) == name

# %% wrong: believes that failures are dropped
# says: your test rejects an implementation that is right (the t interval, failures as 5 m).
def catches_wrong_winners(winner):
    d = np.array([0.12, 0.08, 0.10, 0.03, 0.09, 0.05, 0.07, 0.11])
    b = np.linspace(1, 3, 8)
    a = b + d
    a[2] = np.nan
    assert winner(a, b) == "B"

# %% wrong: the library
# says: the library's compare_paired would do your work here; do without it.
def catches_wrong_winners(winner):
    rng = np.random.default_rng(2)
    for N in (3, 8, 20):
        b = rng.uniform(1, 3, N)
        a = b + 0.05 * rng.normal(size=N)
        assert winner(a, b) == am.compare_paired(a, b).verdict[:1].replace("u", "undecided")

# %% wrong: the own function of part c
# says: your test breaks with NameError: name 'paired_interval' is not defined on an implementatio
def catches_wrong_winners(winner):
    rng = np.random.default_rng(2)
    for N in (3, 8, 20):
        b = rng.uniform(1, 3, N)
        a = b + 0.05 * rng.normal(size=N)
        low, high = paired_interval(a, b, 5.0)
        assert winner(a, b) == ("B" if low > 0 else "A" if high < 0 else "undecided")

# %% wrong: returns a truth value
# says: your test accepts an implementation that compares the means alone. It returns True; use as
def catches_wrong_winners(winner):
    return winner(np.array([1.0, 1.1, 1.2]), np.array([0.5, 0.61, 0.7])) == "B"

# %% wrong: never calls what it tests
# says: there is no answer yet: your test never calls what it is to test.
def catches_wrong_winners(winner):
    assert stats.t.ppf(0.975, 7) > 2

# %% wrong: expects the library's words
# says: your test rejects an implementation that is right (the t interval, failures as 5 m).
def catches_wrong_winners(winner):
    assert winner(np.array([1.0, 1.1, 1.2]), np.array([0.5, 0.61, 0.7])) == "B better"

# %% wrong: takes a large ATE for good
# says: your test rejects an implementation that is right (the t interval, failures as 5 m). It ac
def catches_wrong_winners(winner):
    assert winner(np.array([1.0, 1.1, 1.2]), np.array([0.5, 0.61, 0.7])) == "A"

# %% wrong: numbers instead of runs
# says: your test breaks with TypeError: object of type 'numpy.float64' has no len() on an impleme
def catches_wrong_winners(winner):
    assert winner(1.0, 0.5) == "B"

# %% wrong: a value instead of a function
# says: a function is asked, you have True.
catches_wrong_winners = True

# %% wrong: one N only, with failures
# says: your test accepts an implementation that takes the quantile of 8 runs for any N.
def catches_wrong_winners(winner):
    rng = np.random.default_rng(5)
    x = rng.normal(size=8)
    x = (x - x.mean()) / x.std(ddof=1)
    for t, name in ((2.36, "undecided"), (2.37, "B")):
        d = 0.01 * (x + t / np.sqrt(8))
        b = rng.uniform(1, 3, 8)
        a = b + d
        k, m = d.argmax(), d.argmin()
        a[k], b[k] = np.nan, 5 - d[k]
        if d[m] < 0:
            a[m], b[m] = 5 + d[m], np.nan
        assert winner(a, b) == name
        assert winner(b, a) == name.replace("B", "A")

# %% right: an oracle of its own, many random cases near the edge
def catches_wrong_winners(winner):
    rng = np.random.default_rng(3)
    for trial in range(60):
        N = int(rng.integers(3, 40))
        x = rng.exponential(size=N)
        x = (x - x.mean()) / x.std(ddof=1)
        t = stats.t.ppf(0.975, N - 1) * rng.choice([-1.004, -0.996, 0.996, 1.004])
        b = rng.uniform(1, 4, N)
        a = b + 0.01 * (x + t / np.sqrt(N))
        if trial % 3 == 0:
            k = np.argmax(a - b)
            if a[k] > b[k]:
                a[k], b[k] = np.nan, 5 - a[k] + b[k]
        if trial % 4 == 0:
            k = np.nanargmin(a - b)
            if a[k] < b[k]:
                a[k], b[k] = 5 - b[k] + a[k], np.nan
        A = np.where(np.isnan(a), 5, a)
        B = np.where(np.isnan(b), 5, b)
        p = stats.ttest_rel(A, B).pvalue
        best = "undecided" if p > 0.05 else "B" if np.mean(A - B) > 0 else "A"
        assert winner(a, b) == best, (N, p)

# %% right: with big differences, and lists turned into arrays
def catches_wrong_winners(winner):
    for N in (3, 5, 12, 50):
        steps = np.linspace(-1, 1, N) ** 3 + 0.1 * (np.arange(N) == 1)
        steps = (steps - np.mean(steps)) / np.std(steps, ddof=1)
        edge = stats.t.ppf(0.975, N - 1) / np.sqrt(N)
        base = 2.5 + 1.5 * np.cos(7 * np.arange(N))
        for scale in (1e-3, 0.2):
            for factor in (0.998, 1.002):
                d = scale * (steps + factor * edge)
                low, high = base - d / 2, base + d / 2
                name = "B" if factor > 1 else "undecided"
                assert winner(high, low) == name
                assert winner(low, high) == name.replace("B", "A")
                worst = int(np.argmax(d))
                high[worst] = np.nan
                low[worst] = 5.0 - d[worst]
                assert winner(high, low) == name
                assert winner(low, high) == name.replace("B", "A")
                least = int(np.argmin(d))
                if d[least] < 0:
                    low[least] = np.nan
                    high[least] = 5.0 + d[least]
                    assert winner(high, low) == name
                    assert winner(low, high) == name.replace("B", "A")

# %% right: few cases by hand
def catches_wrong_winners(winner):
    d = np.array([3.0, -1.0, 2.0, 0.5, 1.5])
    t = d.mean() / (d.std(ddof=1) / np.sqrt(5))
    q = stats.t.ppf(0.975, 4)
    b = np.array([1.0, 4.0, 2.5, 0.8, 3.3])
    for factor, name in ((1.01, "B"), (0.99, "undecided")):
        e = 0.02 * (d + (factor * q / t - 1) * d.mean())
        assert winner(b + e, b) == name
        assert winner(b, b + e) == name.replace("B", "A")
        x, y = b + e, b.copy()
        x[0], y[0] = np.nan, 5 - e[0]
        x[1], y[1] = (5 + e[1], np.nan) if e[1] < 0 else (x[1], y[1])
        assert winner(x, y) == name
        assert winner(y, x) == name.replace("B", "A")
    long = np.tile(d, 8)
    t = long.mean() / (long.std(ddof=1) / np.sqrt(40))
    for factor, name in ((1.004, "B"), (0.996, "undecided")):
        e = 0.01 * (long + (factor * stats.t.ppf(0.975, 39) / t - 1) * long.mean())
        assert winner(np.tile(b, 8) + e, np.tile(b, 8)) == name
