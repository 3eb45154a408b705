# %% wrong: no warm-up in any table
# says: your test accepts an implementation that counts the warm-up.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (300, 0, 2), (555, 0, 4), (240, 0, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: a warm-up that looks like the rest
# says: your test accepts an implementation that leaves out one image too many.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (400, 1, 2)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] = 0.05
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: no image is lost
# says: your test accepts an implementation that leaves out images without a pose.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (300, 20, 0), (555, 35, 0)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: no image waits
# says: your test accepts an implementation that starts the clock with the computing.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = np.zeros(n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: the processor works all the time, nobody waits
# says: your test accepts an implementation that starts the clock with the computing.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = np.zeros(n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 1.0)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: fewer than 100 images
# says: your test accepts an implementation that counts the warm-up.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((50, 0, 0), (60, 5, 1), (90, 10, 2)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: all times are equal
# says: your test accepts an implementation that is one rank too low.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = np.full(n, 0.05)
        wait = np.full(n, 0.02)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: a tolerance of 10 %
# says: your test accepts an implementation that is one rank too low.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found / right - 1) < 0.1

# %% wrong: an upper bound only
# says: your test accepts an implementation that starts the clock with the computing.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found <= right + 1e-9

# %% wrong: a lower bound only
# says: your test accepts an implementation that counts the warm-up.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found >= right - 1e-9

# %% wrong: counts the time from the start
# says: your test rejects an implementation that is right (a sorted list). It accepts one that sta
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: expects the warm-up to count
# says: your test rejects an implementation that is right (a sorted list). It accepts one that cou
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: interpolates itself
# says: your test rejects an implementation that is right (a sorted list).
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.percentile(np.where(np.isinf(age), 9, age), 99)
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: counts ranks from 0
# says: your test rejects an implementation that is right (a sorted list).
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[min(int(np.ceil(99 * len(age) / 100)), len(age) - 1)]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: drops lost images itself
# says: your test rejects an implementation that is right (a sorted list). It accepts one that lea
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = (times + wait)[warm_up:]
        age = age[np.isfinite(age)]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: returns a truth value
# says: your test accepts an implementation that counts the warm-up. It returns False; use assert
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        ok = abs(found - right) < 1e-9
    return ok

# %% wrong: compares floats with ==, the numbers added in another order
# says: your test rejects an implementation that is right (a sorted list).
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right

# %% wrong: stops with another error
# says: your test breaks with ValueError: wrong on an implementation that counts the warm-up. It s
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        if not (found == right or abs(found - right) < 1e-9):
            raise ValueError("wrong")

# %% wrong: one table, all in one
# says: your test accepts an implementation that counts the warm-up.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((240, 15, 7),):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: one table without anything
# says: your test accepts an implementation that counts the warm-up.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0),):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: waiting is always the same as the warm-up
# says: your test accepts an implementation that always leaves out 40 images.
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((340, 40, 2),):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% wrong: never calls what it tests
# says: there is no answer yet: your test never calls what it is to test.
def catches_wrong_summaries(p99):
    assert np.sort([3, 1, 2])[-1] == 3

# %% wrong: no function
# says: a function is asked, you have True.
catches_wrong_summaries = True

# %% wrong: a hundred whole numbers
# says: your test accepts an implementation that counts the warm-up.
def catches_wrong_summaries(p99):
    assert np.isclose(p99(table_of(np.arange(1, 101)), 0), 99)

# %% wrong: mean and order only
# says: your test accepts an implementation that counts the warm-up.
def catches_wrong_summaries(p99):
    times = np.random.default_rng(0).uniform(0.01, 0.09, 500)
    found = p99(table_of(times, 0.02), 10)
    assert times.mean() < found <= times.max() + 0.02

# %% wrong: another table for the function than for itself
# says: your test rejects an implementation that is right (a sorted list).
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(0)
    times = rng.uniform(0.01, 0.09, 500)
    assert np.isclose(p99(table_of(rng.permutation(times)), 100), np.sort(times[100:])[395])

# %% wrong: only one lost image too many
# says: your test accepts an implementation that counts the warm-up.
def catches_wrong_summaries(p99):
    times = np.linspace(0.01, 0.09, 100)
    times[[5, 50]] = np.nan
    assert p99(table_of(times, 0.02, 0.5), 0) == np.inf
    assert np.isfinite(p99(table_of(times, 0.02, 0.5), 10)) == False

# %% right: random tables, every fault in them
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(1)
    for n, warm_up, gone in ((150, 0, 0), (320, 20, 2), (555, 35, 4), (240, 15, 7)):
        times = rng.uniform(0.01, 0.09, n)
        wait = rng.uniform(0.001, 0.05, n)
        times[:warm_up] += 3
        times[rng.choice(np.arange(warm_up, n), gone, replace=False)] = np.nan
        table = table_of(times, wait, 0.6)
        age = np.where(np.isnan(times), np.inf, times + wait)[warm_up:]
        right = np.sort(age)[int(np.ceil(99 * len(age) / 100)) - 1]
        found = p99(table, warm_up)
        assert found == right or abs(found - right) < 1e-9

# %% right: three tables by hand
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(7)
    order = rng.permutation(200)
    times = 0.01 + 0.0003 * np.arange(200)
    wait = 0.02 + 0.0001 * np.arange(200)
    table = table_of(times[order], wait[order], 0.3)
    assert np.isclose(p99(table, 0), times[197] + wait[197], rtol=0, atol=1e-9)
    slow = np.r_[np.full(30, 4.0), times[order]]
    slow_wait = np.r_[np.full(30, 0.5), wait[order]]
    found = p99(table_of(slow, slow_wait, 0.3), 30)
    assert np.isclose(found, times[197] + wait[197], rtol=0, atol=1e-9)
    some = times.copy()
    some[[3, 120]] = np.nan
    found = p99(table_of(some[order], wait[order], 0.3), 0)
    assert np.isclose(found, times[199] + wait[199], rtol=0, atol=1e-9)
    some[7] = np.nan
    assert p99(table_of(some[order], wait[order], 0.3), 0) == np.inf
    late = np.r_[np.full(9, 2.0), times]
    late[[4, 60, 61]] = np.nan
    late[[60, 61]] = 0.011
    found = p99(table_of(late, 0.02), 9)
    assert abs(found - np.sort(late[9:])[197] - 0.02) < 1e-9
    long = 0.01 + 0.0001 * rng.permutation(460)
    long[:17] = 1.7
    found = p99(table_of(long, 0.01), 17)
    assert abs(found - np.sort(long[17:])[438] - 0.01) < 1e-9

# %% right: a reference of its own, many random tables, lists
def catches_wrong_summaries(p99):
    def mine(table, warm_up):
        delays = []
        for image, start, end, cpu in table[warm_up:]:
            delays.append(end - image if end == end else float("inf"))
        delays.sort()
        n = len(delays)
        return delays[(99 * n + 99) // 100 - 1]

    rng = np.random.default_rng(3)
    for _ in range(40):
        n = int(rng.integers(120, 600))
        warm_up = int(rng.integers(0, 60))
        times = rng.gamma(4, 0.02, n)
        times[:warm_up] *= 9
        times[rng.random(n) < rng.choice([0, 0.003, 0.03])] = np.nan
        table = table_of(times, rng.gamma(2, 0.02, n), rng.random())
        assert np.isclose(p99(table, warm_up), mine(table, warm_up), rtol=0, atol=1e-9)

# %% right: one falling ramp, moved by warm-up and lost images
def catches_wrong_summaries(p99):
    times = np.arange(300, 0, -1) / 1000
    wait = np.linspace(0.05, 0, 300)
    close = {"rtol": 0, "atol": 1e-9}
    assert np.isclose(p99(table_of(times, wait, 0.5), 0), (times + wait)[3], **close)
    assert np.isclose(p99(table_of(times, wait, 0.5), 100), (times + wait)[102], **close)
    times[[200, 210]] = np.nan
    assert np.isclose(p99(table_of(times, wait, 0.5), 100), (times + wait)[100], **close)
    times[220] = np.nan
    assert p99(table_of(times, wait, 0.5), 100) == np.inf

# %% right: compared by counting, no rank is computed
def catches_wrong_summaries(p99):
    rng = np.random.default_rng(11)
    for n, warm_up, gone in ((130, 0, 1), (333, 21, 0), (412, 12, 3), (300, 30, 9)):
        for _ in range(5):
            times = np.exp(rng.normal(-3, 0.6, n))
            wait = np.exp(rng.normal(-4, 0.5, n))
            times[:warm_up] += rng.choice([1, 5])
            times[warm_up + rng.permutation(n - warm_up)[:gone]] = np.nan
            found = p99(table_of(times, wait, 0.4), warm_up)
            age = np.nan_to_num(times + wait, nan=np.inf)[warm_up:]
            assert found > 0
            assert 100 * np.sum(age <= found + 1e-9) >= 99 * len(age)
            assert 100 * np.sum(age < found - 1e-9) < 99 * len(age)
            assert found == np.inf or np.abs(age - found).min() < 1e-9

# %% wrong: np.percentile is right, for it
# says: It accepts one that interpolates between two ranks
def catches_wrong_summaries(p99) -> None:
    r = np.random.default_rng(3)
    t = r.permutation(np.linspace(0.01, 0.1, 257)); w = r.uniform(0, 0.05, 257)
    assert np.isclose(p99(table_of(t, w, 0.5), 0), np.percentile(t + w, 99), 0, 1e-9)
