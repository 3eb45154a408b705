# %% wrong: normal quantile
# says: you took the normal quantile
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.norm.ppf((1 + confidence) / 2) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: divisor N
# says: your s has the divisor N
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=0) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: N degrees of freedom
# says: you took N degrees of freedom
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d)) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: one-sided quantile
# says: all of 1 - confidence is cut off on each side
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf(confidence, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: 2.365 for any N
# says: you took 2.365 for any N
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = 2.365 * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: 95 % whatever is asked
# says: the quantile is that of 95 %, whatever is asked
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf(0.975, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: quantile of the lower tail
# says: the limits are swapped
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 - confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: no root of N
# says: the root of N is left out
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1)
    return d.mean() - half, d.mean() + half

# %% wrong: divided by N
# says: you divided by N, not by its root
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / len(d)
    return d.mean() - half, d.mean() + half

# %% wrong: unpaired
# says: you ignore that the runs are paired
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    return tuple(stats.ttest_ind(a, b).confidence_interval(confidence))

# %% wrong: b - a
# says: this is b - a
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = b - a
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: failed runs are dropped
# says: runs that failed are left out
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    keep = ~np.isnan(a - b)
    a, b = a[keep], b[keep]
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: nanmean and nanstd
# says: runs that failed are left out, but N counts them
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * np.nanstd(d, ddof=1) / np.sqrt(len(d))
    return np.nanmean(d) - half, np.nanmean(d) + half

# %% wrong: failed runs are 0
# says: runs that failed have an error of 0
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = 0
    b[np.isnan(b)] = 0
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: the worst error seen
# says: runs that failed get the worst error seen, not `worst`
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = seen.max()
    b[np.isnan(b)] = seen.max()
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: only failures of A
# says: runs that B failed are left out
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    keep = ~np.isnan(b)
    a, b = a[keep], b[keep]
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: runs that both failed are dropped
# says: runs that both failed are left out
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    keep = ~(np.isnan(a) & np.isnan(b))
    a, b = a[keep], b[keep]
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: the difference becomes worst
# says: a difference becomes `worst`, not an error
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a, b = np.where(np.isnan(a - b), worst, a - b), 0 * len(a)
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: nan is compared with ==
# says: paired_interval, a run that A failed: you have (nan, nan), which is not finite.
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[a == np.nan] = worst
    b[b == np.nan] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: changes its input
# says: paired_interval changes its input for a run that A failed. Work on a copy.
def paired_interval(a, b, worst, confidence=0.95):
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: no default for the confidence
# says: paired_interval stops for ten runs, and no confidence given with TypeError: paired_interva
def paired_interval(a, b, worst, confidence):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: a default of 90 %
# says: paired_interval is wrong for ten runs, and no confidence given
def paired_interval(a, b, worst, confidence=0.9):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% right: in place, on copies, with names that the check uses
def paired_interval(a, b, worst, confidence=0.95):
    limits = normal = by_rule = None
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: normal from 30 runs on
# says: paired_interval is wrong for 40 runs
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = (stats.t.ppf((1 + confidence) / 2, len(d) - 1) if len(d) < 30 else stats.norm.ppf((1 + confidence) / 2)) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: absolute differences
# says: you took absolute differences
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = abs(a - b)
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: 95 is taken for 95 %
# says: for confidence 95. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    confidence = confidence / 100 if confidence > 1 else confidence
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: three runs at least
# says: paired_interval stops for two runs with ValueError: lengths or confidence.
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 3 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: an infinite error is a failed run
# says: for an error of B of minus infinity. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[~np.isfinite(a)] = worst
    b[~np.isfinite(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: no guard at all
# says: for one run. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: no guard of lengths
# says: for six runs of A and one of B. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: no guard of a single run
# says: for one run. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: no guard of the confidence
# says: for confidence 1. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: confidence 0 and 1 are allowed
# says: for confidence 1. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 <= confidence <= 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: no guard of infinite errors
# says: for an error of B of minus infinity. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: worst is not compared
# says: for worst below an error of A. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst):
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: worst equal to an error is refused
# says: paired_interval stops for a worst error that is just the largest with ValueError: errors.
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen >= worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: worst is compared with A only
# says: for worst below an error of B. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (a > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: worst nan is not refused
# says: for worst = nan. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or np.isinf(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: worst is compared only if a run failed
# says: for worst below an error of A. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (len(seen) < 2 * len(a) and (seen > worst).any()):
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: negative errors are refused
# says: paired_interval stops for scores below 0 with ValueError: errors.
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any() or (seen < 0).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: returns mean and half width
# says: you return the mean and the half width
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean(), half

# %% wrong: prints, and returns nothing
# says: paired_interval: there is no answer yet. It returns nothing for eight runs.
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    print(d.mean() - half, d.mean() + half)

# %% wrong: the library
# says: the library's compare_paired would do your work here; do without it.
def paired_interval(a, b, worst, confidence=0.95):
    r = am.compare_paired(a, b, confidence, failures='worst', worst=worst)
    return r.lower, r.upper

# %% wrong: asserts instead of a ValueError
# says: for one run. There is no answer in this case
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise AssertionError("lengths")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% right: by SciPy
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    low, high = stats.ttest_rel(a, b).confidence_interval(confidence)
    return low, high

# %% right: an array, and sums by hand
def paired_interval(a, b, worst, confidence=0.95):
    if not 0 < confidence < 1 or np.shape(a) != np.shape(b) or np.size(a) < 2:
        raise ValueError
    runs = [[float(x) for x in a], [float(x) for x in b]]
    for row in runs:
        for k, x in enumerate(row):
            if x != x:
                row[k] = worst
            if abs(row[k]) == np.inf or not row[k] <= worst:
                raise ValueError("error")
    if not abs(worst) < np.inf:
        raise ValueError("worst")
    d = [x - y for x, y in zip(*runs)]
    n = len(d)
    m = sum(d) / n
    s = (sum((x - m) ** 2 for x in d) / (n - 1)) ** 0.5
    q = stats.t.isf((1 - confidence) / 2, n - 1)
    return np.array([m - q * s / n**0.5, m + q * s / n**0.5])

# %% right: t.interval, and warnings
def paired_interval(a, b, worst, confidence=0.95):
    import warnings
    warnings.warn("this is slow")
    print("working")
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    return stats.t.interval(confidence, len(d) - 1, loc=d.mean(), scale=stats.sem(d))

# %% right: a list
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1:
        raise ValueError("lengths or confidence")
    seen = np.r_[a, b]
    seen = seen[~np.isnan(seen)]
    if np.isinf(seen).any() or not np.isfinite(worst) or (seen > worst).any():
        raise ValueError("errors")
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return [d.mean() - half, d.mean() + half]

# %% wrong: constants
# says: paired_interval is wrong for eight runs
def paired_interval(a, b, worst, confidence=0.95):
    return (0.05, 0.11)

# %% wrong: median in the middle
# says: about the median, not the mean
def paired_interval(a, b, worst, confidence=0.95):
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1: raise ValueError
    a = np.where(np.isnan(a), worst, a); b = np.where(np.isnan(b), worst, b)
    if not np.isfinite(np.r_[a, b]).all() or not np.isfinite(worst) or np.r_[a, b].max() > worst: raise ValueError
    d = a - b; q = stats.t.ppf(0.5 + confidence / 2, len(d) - 1); h = q * d.std(ddof=1) / np.sqrt(len(d))
    return np.median(d) - h, np.median(d) + h

# %% right: scipy interval
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    if a.shape != b.shape or a.size < 2: raise ValueError("runs")
    if not (0 < confidence < 1): raise ValueError("confidence")
    for x in (a, b):
        if np.isinf(x).any(): raise ValueError("inf")
    if not np.isfinite(worst): raise ValueError("worst")
    seen = np.concatenate((a, b)); seen = seen[~np.isnan(seen)]
    if seen.size and seen.max() > worst: raise ValueError("worst")
    a[np.isnan(a)] = worst; b[np.isnan(b)] = worst
    return stats.ttest_rel(a, b).confidence_interval(confidence)

# %% right: pure python with math star
from math import *
import statistics
sum = 0
def paired_interval(a, b, worst, confidence=0.95):
    if len(a) != len(b) or len(a) < 2: raise ValueError()
    if isnan(worst) or isinf(worst) or not (confidence > 0 and confidence < 1): raise ValueError()
    d = []
    for x, y in zip(a, b):
        if isinf(x) or isinf(y) or x > worst or y > worst: raise ValueError()
        d.append((worst if isnan(x) else float(x)) - (worst if isnan(y) else float(y)))
    m = statistics.fmean(d); s = statistics.stdev(d)
    h = stats.t.isf((1 - confidence) / 2, len(d) - 1) * s / sqrt(len(d))
    return [m - h, m + h]

# %% right: array result
def paired_interval(a, b, worst, confidence=0.95):
    if len(a) != len(b) or len(a) < 2 or not 0 < confidence < 1 or not np.isfinite(worst): raise ValueError
    e = np.nan_to_num(np.array([a, b], dtype=float), nan=worst, posinf=np.inf, neginf=-np.inf)
    if np.isinf(e).any() or e.max() > worst: raise ValueError
    d = np.diff(e[::-1], axis=0)[0]
    return d.mean() + stats.sem(d) * np.array(stats.t.interval(confidence, len(d) - 1))
