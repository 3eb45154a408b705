# %% wrong: normal quantile
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
def paired_interval(a, b, worst, confidence=0.95):
    a, b = np.array(a, float), np.array(b, float)
    a[np.isnan(a)] = worst
    b[np.isnan(b)] = worst
    d = a - b
    half = stats.t.ppf((1 + confidence) / 2, len(d) - 1) * d.std(ddof=1) / np.sqrt(len(d))
    return d.mean() - half, d.mean() + half

# %% wrong: no guard of lengths
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
def paired_interval(a, b, worst, confidence=0.95):
    r = am.compare_paired(a, b, confidence, failures='worst', worst=worst)
    return r.lower, r.upper

# %% wrong: asserts instead of a ValueError
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
