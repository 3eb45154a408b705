# %% wrong: a good mean only
# says: your test accepts an implementation that tests above only.
def catches_wrong_bands(consistent):
    assert consistent(np.full(50, 3.0), 3)

# %% wrong: a large mean only
# says: your test accepts an implementation that tests above only.
def catches_wrong_bands(consistent):
    assert consistent(np.full(50, 3.0), 3)
    assert not consistent(np.full(50, 6.0), 3)

# %% wrong: far outside on both sides
# says: your test accepts an implementation that sells the 5 % and 95 % quantiles as a 95 % band.
def catches_wrong_bands(consistent):
    for n in (1, 2, 3):
        assert consistent(np.full(50, n + 0.1), n)
        assert consistent(np.full(50, n - 0.1), n)
        assert not consistent(np.full(50, 3 * n), n)
        assert not consistent(np.full(50, n / 3), n)

# %% wrong: one value only
# says: your test accepts an implementation that uses the band of a single value for any N.
def catches_wrong_bands(consistent):
    for n in (1, 2, 3):
        low, high = chi2.ppf([0.025, 0.975], n)
        assert consistent(np.array([low * 1.01]), n)
        assert consistent(np.array([high * 0.99]), n)
        assert not consistent(np.array([low * 0.99]), n)
        assert not consistent(np.array([high * 1.01]), n)

# %% wrong: believes in the band of 5 % and 95 %
# says: your test rejects an implementation that is right (the band).
def catches_wrong_bands(consistent):
    low, high = chi2.ppf([0.05, 0.95], 60) / 20
    assert consistent(np.full(20, low + 0.01), 3)
    assert not consistent(np.full(20, high + 0.01), 3)

# %% wrong: random values, as many as chance has it
# says: your test accepts an implementation that tests above only.
def catches_wrong_bands(consistent):
    values = np.random.default_rng(0).chisquare(3, size=(200, 20))
    assert 0.8 < np.mean([consistent(v, 3) for v in values]) < 1

# %% wrong: one degree of freedom only
# says: your test accepts an implementation that takes N degrees of freedom, whatever dof is.
def catches_wrong_bands(consistent):
    for N in (5, 50):
        low, high = chi2.ppf([0.025, 0.975], N) / N
        assert consistent(np.full(N, high - 0.01), 1)
        assert consistent(np.full(N, low + 0.01), 1)
        assert not consistent(np.full(N, high + 0.01), 1)
        assert not consistent(np.full(N, low - 0.01), 1)

# %% wrong: returns a truth value
# says: your test accepts an implementation that passes every mean below dof. It returns False; us
def catches_wrong_bands(consistent):
    return consistent(np.full(50, 3.0), 3) and not consistent(np.full(50, 4.0), 3)

# %% wrong: demands the mean below the degrees of freedom
# says: your test rejects an implementation that is right (the band). It accepts one that passes e
def catches_wrong_bands(consistent):
    assert consistent(np.full(50, 2.9), 3)
    assert not consistent(np.full(50, 3.1), 3)

# %% wrong: never calls what it tests
# says: there is no answer yet: your test never calls what it is to test.
def catches_wrong_bands(consistent):
    assert chi2.ppf(0.975, 3) > 3

# %% wrong: expects a verdict in words
# says: your test rejects an implementation that is right (the band).
def catches_wrong_bands(consistent):
    assert consistent(np.full(50, 3.0), 3) == "consistent"

# %% wrong: a number instead of values
# says: your test breaks with TypeError: object of type 'float' has no len() on an implementation
def catches_wrong_bands(consistent):
    assert consistent(3.0, 3)

# %% wrong: a value instead of a function
# says: a function is asked, you have True.
catches_wrong_bands = True

# %% wrong: never asks for a mean above the band
# says: your test accepts an implementation that never objects to a mean above the band.
def catches_wrong_bands(consistent):
    for N, n in ((10, 3), (80, 2)):
        low, high = chi2.ppf([0.025, 0.975], N * n) / N
        assert not consistent(np.full(N, 0.999 * low), n)
        assert consistent(np.full(N, 1.001 * low), n)
        assert consistent(np.full(N, 0.999 * high), n)

# %% wrong: never asks for a mean below the band
# says: your test accepts an implementation that never objects to a mean below the band.
def catches_wrong_bands(consistent):
    for N, n in ((10, 3), (80, 2)):
        low, high = chi2.ppf([0.025, 0.975], N * n) / N
        assert consistent(np.full(N, 1.001 * low), n)
        assert consistent(np.full(N, 0.999 * high), n)
        assert not consistent(np.full(N, 1.001 * high), n)

# %% wrong: two means, one N, one dof
# says: your test accepts an implementation that tests below only.
def catches_wrong_bands(consistent):
    assert consistent(np.full(80, 2.45), 2)
    assert not consistent(np.full(80, 1.5), 2)

# %% wrong: both ends, but poses only
# says: your test accepts an implementation that takes every error for a pose of three components.
def catches_wrong_bands(consistent):
    for N in (5, 60):
        low, high = chi2.ppf([0.025, 0.975], N * 3) / N
        for mean, inside in ((low - 0.01, 0), (low + 0.01, 1), (high - 0.01, 1), (high + 0.01, 0)):
            assert bool(consistent(np.full(N, mean), 3)) == bool(inside)

# %% wrong: both ends, but two components only
# says: your test accepts an implementation that takes every error for one of two components.
def catches_wrong_bands(consistent):
    N, n = 80, 2
    low, high = chi2.ppf([0.025, 0.975], N * n) / N
    means = (low - 0.01, low + 0.01, high - 0.01, high + 0.01)
    assert [bool(consistent(np.full(N, m), n)) for m in means] == [False, True, True, False]

# %% right: compares with True and False
def catches_wrong_bands(consistent):
    for N, n in ((10, 3), (80, 2)):
        low, high = chi2.ppf([0.025, 0.975], N * n) / N
        assert consistent(np.full(N, low + 0.001), n) is True
        assert consistent(np.full(N, low - 0.001), n) is False
        assert consistent(np.full(N, high - 0.001), n) is True
        assert consistent(np.full(N, high + 0.001), n) is False

# %% right: bisects for both ends
def catches_wrong_bands(consistent):
    for N, n in ((4, 1), (30, 3)):
        low, high = chi2.ppf(0.025, N * n) / N, chi2.ppf(0.975, N * n) / N
        for outside, end in ((0.0, low), (50.0, high)):
            inside = float(n)
            assert consistent(np.full(N, inside), n)
            assert not consistent(np.full(N, outside), n)
            for _ in range(40):
                middle = (inside + outside) / 2
                if consistent(np.full(N, middle), n):
                    inside = middle
                else:
                    outside = middle
            assert abs(inside - end) < 1e-3

# %% right: p-values as the judge, on a grid
def catches_wrong_bands(consistent):
    for N in (2, 12, 100):
        for n in (2, 3, 6):
            for mean in np.linspace(0.2 * n, 2.5 * n, 121):
                p = 2 * min(chi2.cdf(N * mean, N * n), chi2.sf(N * mean, N * n))
                if abs(p - 0.05) > 1e-6:
                    assert bool(consistent(np.full(N, mean), n)) == (p > 0.05), (N, n, mean)

# %% wrong: never asks inside the band
# says: your test accepts an implementation that sells the 5 % and 95 % quantiles as a 95 % band.
def catches_wrong_bands(consistent):
    for N, n in ((10, 3), (80, 2)):
        low, high = chi2.ppf([0.025, 0.975], N * n) / N
        assert not consistent(np.full(N, 0.999 * low), n)
        assert not consistent(np.full(N, 1.001 * high), n)

# %% wrong: a test by name
# says: your test rejects an implementation that is right (the band).
def catches_wrong_bands(consistent):
    assert consistent.__name__ == "consistent"
    consistent(np.full(10, 3.0), 3)

# %% wrong: compares with the library's verdict on good means
# says: your test accepts an implementation that never objects to a mean above the band.
def catches_wrong_bands(consistent):
    for seed in range(20):
        values = np.random.default_rng(seed).chisquare(3, 20)
        test = am.consistency_test(values.reshape(-1, 1), 3)
        assert bool(consistent(values, 3)) == (test.verdict == "consistent")

# %% wrong: the 99 % band
# says: your test rejects an implementation that is right (the band).
def catches_wrong_bands(consistent):
    for N, n in ((10, 3), (80, 2)):
        low, high = chi2.ppf([0.005, 0.995], N * n) / N
        assert consistent(np.full(N, 1.001 * low), n)
        assert not consistent(np.full(N, 1.001 * high), n)

# %% right: lists, random values scaled to a mean
def catches_wrong_bands(consistent):
    rng = np.random.default_rng(3)
    for N, n in ((3, 1), (20, 3), (90, 2)):
        low, high = chi2.interval(0.95, N * n)
        for mean, inside in ((low, 1), (low, 0), (high, 0), (high, 1)):
            step = 1e-3 * mean / N
            values = rng.chisquare(n, N)
            wanted = mean / N + (step if inside == (mean == low) else -step)
            values *= wanted / values.mean()
            assert bool(consistent(list(values), n)) == bool(inside)
