# %% wrong: the resolution is taken for the reliability
reliability = [am.murphy(labels, p).resolution for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: B first
reliability = [am.murphy(labels, p).reliability for p in (B, A)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: labels and forecasts swapped
reliability = [float(np.mean((np.round(p, 1) - labels) ** 2)) for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: the Brier scores
reliability = [am.brier(labels, p).value for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: 20 bins
reliability = [am.murphy(labels, p, 20).reliability for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: a root like an RMSE
reliability = [am.murphy(labels, p).reliability ** 0.5 for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: whole results instead of a term
reliability = [am.murphy(labels, p) for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: one map only
reliability = am.murphy(labels, A).reliability
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: the reliability diagram the wrong way round
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "overconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: another word
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "too timid"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: a number for the fault
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = 0.1
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: repaired by subtracting the reliability
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "underconfident"
repaired = [m.brier - m.reliability for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: not repaired
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "underconfident"
repaired = [m.brier for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: repaired maps in the wrong order
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, B), am.murphy(labels, A))]
keep = "A"

# %% wrong: the uncertainty is forgotten
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "underconfident"
repaired = [-m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: the resolution is added
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty + m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% wrong: the rate of all cells instead of the bin's
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "underconfident"
repaired = [labels.mean() * (1 - labels.mean())] * 2
keep = "A"

# %% wrong: keeps the map with the better Brier score
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "B"

# %% wrong: a perfect repair
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "underconfident"
repaired = [0.0, 0.0]
keep = "A"

# %% wrong: no decision
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "underconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = ...

# %% wrong: another spelling
reliability = [am.murphy(labels, p).reliability for p in (A, B)]
fault = "under-confident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "A"

# %% right: the repair carried out
def bins(p):
    return np.minimum((p * 10).astype(int), 9)


def repair(p):
    k = bins(p)
    return (np.bincount(k, labels, 10) / np.maximum(np.bincount(k, minlength=10), 1))[k]


reliability = tuple(
    sum(
        np.mean(bins(p) == k) * (p[bins(p) == k].mean() - labels[bins(p) == k].mean()) ** 2
        for k in np.unique(bins(p))
    )
    for p in (A, B)
)
fault = "underconfident"
repaired = tuple(am.brier(labels, repair(p)).value for p in (A, B))
keep = "A"

# %% right: from the points of the diagram
m = [am.murphy(labels, p, bins=np.linspace(0, 1, 11)) for p in (A, B)]
reliability = np.array([np.nansum(x.count * (x.forecast - x.frequency) ** 2) / len(labels) for x in m])
fault = "underconfident"
repaired = np.array([np.nansum(x.count * x.frequency * (1 - x.frequency)) / len(labels) for x in m])
keep = "AB"[int(np.argmin(repaired))]
