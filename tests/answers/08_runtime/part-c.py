# %% wrong: ranks as indices
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[min(l, n - 1)] if l > 0 else np.nan
    upper = x[min(u, n - 1)] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: the lower rank one too small
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 2] if l > 1 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: the upper rank one too small
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 2] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: the upper rank one too large
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 3, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: the lower rank one too large
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l] if 0 < l < n else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: each side gets all
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = 1 - confidence
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: a quarter on each side
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 4
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: confidence taken for the side
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = confidence / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: the longest frame where there is no limit
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else x[-1]
    return lower, upper


needed = 149

# %% wrong: the shortest frame where there is no limit
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else x[0]
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: infinity where there is no limit
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.inf
    return lower, upper


needed = 149

# %% wrong: nothing at all where one is missing
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return (lower, upper) if np.isfinite(lower + upper) else (np.nan, np.nan)


needed = 149

# %% wrong: raises where a limit is missing
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    if np.isnan(lower + upper):
        raise ValueError("too few")
    return lower, upper


needed = 149

# %% wrong: not sorted
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = times
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: sorts what it was given
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    times.sort()
    x = times
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: repeated times count once
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.unique(times)
    n = len(x)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: percent as a share
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = min(percent, 1)
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: counted from the other end
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = 1 - percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: the median, whatever is asked
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = 1 / 2
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: percent 0 is let through
def percentile_interval(times, percent, confidence):
    if not (0 <= percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: percent 100 is let through
def percentile_interval(times, percent, confidence):
    if not (0 < percent <= 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: a negative percent is let through
def percentile_interval(times, percent, confidence):
    if not (percent < 100 and percent != 0 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: confidence is not looked at
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: confidence 1 is let through
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence <= 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: confidence 0 is let through
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 <= confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: nan is left among the times
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or np.isinf(times).any():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: infinity is left among the times
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or np.isnan(times).any():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: nan is dropped
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 :
        raise ValueError("times")
    times = times[np.isfinite(times)]
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: no times give nan
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0:
        return np.nan, np.nan
    if not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: limits swapped
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return upper, lower


needed = 149

# %% wrong: ranks, not times
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = l if l > 0 else np.nan
    upper = u if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: one limit alone
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return upper


needed = 149

# %% wrong: a strict inequality, and a rank from the ppf
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[min(int(binom.ppf(1 - side, n, q)), n) - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% wrong: the largest time wherever the P99 is asked
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return (lower, x[-1]) if percent == 99 and n > 298 else (lower, upper)


needed = 149

# %% wrong: the library
def percentile_interval(times, percent, confidence):
    result = am.percentile(times, percent, confidence)
    return result.lower, result.upper


needed = 149

# %% wrong: the normal distribution for the count
def percentile_interval(times, percent, confidence):
    from scipy.stats import norm

    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n, q, x = len(times), percent / 100, np.sort(times)
    half = norm.isf((1 - confidence) / 2) * np.sqrt(n * q * (1 - q))
    l, u = int(np.floor(n * q - half)), int(np.ceil(n * q + half)) + 1
    return x[l - 1] if l > 0 else np.nan, x[u - 1] if u <= n else np.nan


needed = 149

# %% wrong: mean plus and minus
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    middle = np.percentile(times, percent)
    half = 1.96 * np.std(times) / np.sqrt(len(times))
    return middle - half, middle + half


needed = 149

# %% wrong: percentiles of the frames themselves
def percentile_interval(times, percent, confidence):
    side = 100 * (1 - confidence) / 2
    return tuple(np.percentile(times, [side, 100 - side]))


needed = 149

# %% wrong: a bootstrap
def percentile_interval(times, percent, confidence):
    rng = np.random.default_rng(0)
    drawn = rng.choice(times, size=(999, len(times)))
    side = 100 * (1 - confidence) / 2
    return tuple(np.percentile(np.percentile(drawn, percent, axis=1), [side, 100 - side]))


needed = 149

# %% wrong: no function
percentile_interval = (20.0, 30.0)
needed = 149

# %% wrong: one frame too few
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 148

# %% wrong: one frame too many
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 150

# %% wrong: both sides together
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = am.frames_needed(98, 0.9)

# %% wrong: needed for a P99
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 299

# %% wrong: needed at 0.95
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 183

# %% wrong: one in 50
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 50

# %% wrong: not a whole number
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 148.3

# %% wrong: no number of frames
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = ...

# %% right: loops over the ranks
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% right: an array, and None where there is no limit
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else None
    return np.array([lower, upper])


needed = 149

# %% wrong: the upper rank begins one too low for small percentiles
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    n = len(times)
    q = percent / 100
    side = (1 - confidence) / 2
    x = np.sort(times)
    l = 0
    while l < n and binom.cdf(l, n, q) <= side:
        l += 1
    u = n + 1 if q >= 0.5 else n
    while u > 1 and binom.sf(u - 2, n, q) <= side:
        u -= 1
    lower = x[l - 1] if l > 0 else np.nan
    upper = x[u - 1] if u <= n else np.nan
    return lower, upper


needed = 149

# %% right: binom.ppf and isf
def percentile_interval(times, percent, confidence):
    x = sorted(float(t) for t in times)
    n = len(x)
    if n == 0 or not all(map(np.isfinite, x)):
        raise ValueError("times")
    if not 0 < percent < 100 or not 0 < confidence < 1:
        raise ValueError("out of range")
    side = (1 - confidence) / 2
    l = int(binom.ppf(side, n, percent / 100))
    u = int(binom.isf(side, n, percent / 100)) + 1
    lower = x[l - 1] if l >= 1 else float("nan")
    upper = x[u - 1] if u <= n else float("nan")
    return [lower, upper]


needed = int(np.ceil(np.log(0.05) / np.log(0.98)))

# %% right: sums of binomials by hand, turned around for the other side
from math import comb, isfinite, nan


def lower_limit(x, q, side):
    n = len(x)
    total, best = 0.0, nan
    for k in range(n):
        total += comb(n, k) * q**k * (1 - q) ** (n - k)
        if total > side:
            break
        best = x[k]
    return best


def percentile_interval(times, percent, confidence):
    x = sorted(times)
    if not x or not all(isfinite(t) for t in x):
        raise ValueError("times")
    if not (0 < percent < 100) or not (0 < confidence < 1):
        raise ValueError("numbers")
    side = (1 - confidence) / 2
    lower = lower_limit(x, percent / 100, side)
    upper = -lower_limit([-t for t in x[::-1]], 1 - percent / 100, side)
    return lower, upper


needed = 149.0

# %% right: an array is returned, a warning is printed
import warnings


def percentile_interval(times, percent, confidence):
    warnings.warn("slow")
    print("working")
    n = np.size(times)
    if n < 1 or not np.all(np.isfinite(times)):
        raise ValueError("times")
    if percent <= 0 or percent >= 100 or np.isnan(percent):
        raise ValueError("percent")
    if confidence <= 0 or confidence >= 1 or np.isnan(confidence):
        raise ValueError("confidence")
    padded = np.r_[np.nan, np.sort(times), np.nan]
    k = np.arange(n + 2)
    too_few = binom.cdf(k - 1, n, percent / 100)
    too_many = binom.sf(k - 1, n, percent / 100)
    side = (1 - confidence) / 2
    return padded[k[too_few <= side].max()], padded[k[too_many <= side].min()]


n = 1
while 0.98**n > 0.05 or 0.02**n > 0.05:
    n += 1
needed = n

# %% right: the test of SciPy for a quantile
from scipy.stats import quantile_test


def percentile_interval(times, percent, confidence):
    if len(times) == 0 or not np.isfinite(times).all():
        raise ValueError("times")
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("numbers")
    result = quantile_test(times, q=0, p=percent / 100)
    found = result.confidence_interval(confidence_level=confidence)
    return found.low, found.high


needed = np.int64(149)
