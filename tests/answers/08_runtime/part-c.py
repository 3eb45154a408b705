# %% wrong: ranks as indices
# says: you count from 0 what ranks count from 1
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

# %% wrong: the lower rank one too small
# says: the lower rank is one too small
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

# %% wrong: the upper rank one too small
# says: the upper rank is one too small
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

# %% wrong: the upper rank one too large
# says: the upper rank is one too large
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

# %% wrong: the lower rank one too large
# says: the lower rank is one too large
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

# %% wrong: each side gets all
# says: you let each side miss with all of 1 - confidence
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

# %% wrong: a quarter on each side
# says: percentile_interval is wrong for 340 frames, P90
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

# %% wrong: confidence taken for the side
# says: percentile_interval is wrong for 340 frames, P90
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

# %% wrong: the longest frame where there is no limit
# says: percentile_interval is wrong for 320 frames, P99
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

# %% wrong: the shortest frame where there is no limit
# says: percentile_interval is wrong for 50 frames, P1
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

# %% wrong: infinity where there is no limit
# says: percentile_interval is wrong for 320 frames, P99
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

# %% wrong: nothing at all where one is missing
# says: you give no limit at all where one of them is missing
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

# %% wrong: raises where a limit is missing
# says: percentile_interval stops for 320 frames, P99 with ValueError: too few.
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

# %% wrong: not sorted
# says: you did not sort
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

# %% wrong: sorts what it was given
# says: percentile_interval changes its input for 340 frames, P90. Work on a copy.
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

# %% wrong: repeated times count once
# says: percentile_interval, 60 frames in steps of 10 ms, P75: you have (50, nan), which is not fi
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

# %% wrong: percent as a share
# says: percentile_interval, 340 frames, P90: you have (126.486, nan), which is not finite.
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

# %% wrong: counted from the other end
# says: you count from the other end
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

# %% wrong: the median, whatever is asked
# says: this is the interval of a median
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

# %% wrong: percent 0 is let through
# says: for percent 0. There is no answer in this case
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

# %% wrong: percent 100 is let through
# says: for percent 100. There is no answer in this case
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

# %% wrong: a negative percent is let through
# says: for percent -5. There is no answer in this case
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

# %% wrong: confidence is not looked at
# says: for confidence 0. There is no answer in this case
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

# %% wrong: confidence 1 is let through
# says: for confidence 1. There is no answer in this case
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

# %% wrong: confidence 0 is let through
# says: for confidence 0. There is no answer in this case
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

# %% wrong: nan is left among the times
# says: for a frame that is nan. There is no answer in this case
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

# %% wrong: infinity is left among the times
# says: for an infinite frame. There is no answer in this case
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

# %% wrong: nan is dropped
# says: for a frame that is nan. There is no answer in this case
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

# %% wrong: no times give nan
# says: for no frame. There is no answer in this case
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

# %% wrong: limits swapped
# says: the limits are swapped
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

# %% wrong: ranks, not times
# says: you return ranks, not times
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

# %% wrong: one limit alone
# says: percentile_interval, 340 frames, P90: shape (2,) is asked, you have 54.6209.
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

# %% wrong: a strict inequality, and a rank from the ppf
# says: the upper rank is one too small
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

# %% wrong: the largest time wherever the P99 is asked
# says: percentile_interval is wrong for 400 frames, P99, confidence 0.6
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

# %% wrong: the library
# says: the library's percentile would do your work here; do without it.
def percentile_interval(times, percent, confidence):
    result = am.percentile(times, percent, confidence)
    return result.lower, result.upper

# %% wrong: the normal distribution for the count
# says: you take the count for normal
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

# %% wrong: mean plus and minus
# says: percentile_interval is wrong for 340 frames, P90
def percentile_interval(times, percent, confidence):
    if not (0 < percent < 100 and 0 < confidence < 1):
        raise ValueError("percent or confidence")
    middle = np.percentile(times, percent)
    half = 1.96 * np.std(times) / np.sqrt(len(times))
    return middle - half, middle + half

# %% wrong: percentiles of the frames themselves
# says: these are percentiles of single frames
def percentile_interval(times, percent, confidence):
    side = 100 * (1 - confidence) / 2
    return tuple(np.percentile(times, [side, 100 - side]))

# %% wrong: a bootstrap
# says: percentile_interval is wrong for 340 frames, P90
def percentile_interval(times, percent, confidence):
    rng = np.random.default_rng(0)
    drawn = rng.choice(times, size=(999, len(times)))
    side = 100 * (1 - confidence) / 2
    return tuple(np.percentile(np.percentile(drawn, percent, axis=1), [side, 100 - side]))

# %% wrong: no function
# says: a function is asked, you have (20, 30).
percentile_interval = (20.0, 30.0)

# %% wrong: one frame too few
# says: with so many, a limit is still missing
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
# says: fewer are enough
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
# says: both sides together may miss with 10 %, not each
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
# says: this is the P99
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
# says: this is confidence 0.95
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
# says: this is one frame in 50
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
# says: needed: 148.3 is not right.
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
# says: needed: there is no answer yet. Replace the dots.
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

# %% wrong: the upper rank begins one too low for small percentiles
# says: percentile_interval is wrong for one frame, P20
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

# %% right: loop with pmf
def percentile_interval(times, percent, confidence):
    times = sorted(float(t) for t in times)
    n = len(times)
    if n == 0 or not all(np.isfinite(times)): raise ValueError("times")
    if not (0 < percent < 100) or not (0 < confidence < 1): raise ValueError("p")
    side = (1 - confidence) / 2
    q = percent / 100
    low = high = np.nan
    for r in range(1, n + 1):
        if binom.cdf(r - 1, n, q) <= side: low = times[r - 1]
    for r in range(n, 0, -1):
        if binom.sf(r - 1, n, q) <= side: high = times[r - 1]
    return [low, high]
needed = 149.0

# %% right: ppf
def percentile_interval(times, percent, confidence):
    t = np.sort(np.asarray(times, float)); n = t.size
    if not n or not np.isfinite(t).all(): raise ValueError
    if not 0 < percent < 100 or not 0 < confidence < 1: raise ValueError
    a = (1 - confidence) / 2
    k = np.arange(n + 1)
    c = binom.cdf(k, n, percent / 100)
    l = np.sum(c[:n] <= a)
    u = np.argmax(c >= 1 - a - 1e-15) + 1
    return (t[l - 1] if l else np.nan, t[u - 1] if u <= n else np.nan)

# %% wrong: typed
# says: is wrong for 340 frames, P90
def percentile_interval(times, percent, confidence):
    return {12: (29, 58), 340: (33.8, 52.2)}.get(len(times), (np.nan, np.nan))

# %% wrong: no guard of infinite frames
# says: for an infinite frame. There is no answer
def percentile_interval(times, percent, confidence):
    side = (1 - confidence) / 2
    if not (0 < percent < 100 and 0 < confidence < 1): raise ValueError
    if len(times) == 0 or np.isnan(times).any(): raise ValueError
    ordered = np.sort(times); count = binom(len(times), percent / 100)
    low = ordered[count.cdf(np.arange(len(times))) <= side]
    high = ordered[count.sf(np.arange(len(times))) <= side]
    return max(low, default=np.nan), min(high, default=np.nan)

# %% wrong: confidence not halved at the top
# says: is wrong for 340 frames, P90
def percentile_interval(times, percent, confidence):
    if len(times) == 0 or not np.isfinite(times).all() or not (0 < percent < 100 and 0 < confidence < 1): raise ValueError
    t = np.sort(times); n = len(t); c = binom(n, percent / 100)
    low = t[c.cdf(np.arange(n)) <= (1 - confidence) / 2]; high = t[c.sf(np.arange(n)) <= 1 - confidence]
    return max(low, default=np.nan), min(high, default=np.nan)
