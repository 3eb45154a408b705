# %% wrong: the resolution is taken for the reliability
# says: this is the resolution
reliability = [am.murphy(labels, p).resolution for p in (A, B)]
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: B first
# says: the maps are swapped
reliability = [am.murphy(labels, p).reliability for p in (B, A)]
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: labels and forecasts swapped
# says: reliability: [0.134767, 0.055561] is not right.
reliability = [float(np.mean((np.round(p, 1) - labels) ** 2)) for p in (A, B)]
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: the Brier scores
# says: this is the Brier score
reliability = [am.brier(labels, p).value for p in (A, B)]
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: 20 bins
# says: you took 20 bins
reliability = [am.murphy(labels, p, 20).reliability for p in (A, B)]
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: a root like an RMSE
# says: you took the root
reliability = [am.murphy(labels, p).reliability ** 0.5 for p in (A, B)]
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: whole results instead of a term
# says: reliability: you have whole results of am.murphy. Take one of their terms.
reliability = [am.murphy(labels, p) for p in (A, B)]
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: one map only
# says: reliability: shape (2,) is asked, you have 0.0989177.
reliability = am.murphy(labels, A).reliability
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: the reliability diagram the wrong way round
# says: fault and keep: not both hold
fault = "overconfident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: another word
# says: fault: the words are "overconfident" and "underconfident".
fault = "too timid"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: a number for the fault
# says: fault: the words are "overconfident" and "underconfident".
fault = 0.1
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: repaired by subtracting the reliability
# says: you forgot what the bins hide
repaired = [m.brier - m.reliability for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: not repaired
# says: nothing is repaired
repaired = [m.brier for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: repaired maps in the wrong order
# says: the maps are swapped
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, B), am.murphy(labels, A))]

# %% wrong: the uncertainty is forgotten
# says: the uncertainty is forgotten
repaired = [-m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: the resolution is added
# says: the resolution is added
repaired = [m.uncertainty + m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

# %% wrong: the rate of all cells instead of the bin's
# says: all cells get the same forecast with you
repaired = [labels.mean() * (1 - labels.mean())] * 2

# %% wrong: keeps the map with the better Brier score
# says: fault and keep: not both hold
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = "B"

# %% wrong: a perfect repair
# says: repaired: your values are rounded to fewer than four digits.
repaired = [0.0, 0.0]

# %% wrong: no decision
# says: keep: there is no answer yet. Replace the dots.
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]
keep = ...

# %% wrong: another spelling
# says: fault: the words are "overconfident" and "underconfident".
fault = "under-confident"
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, A), am.murphy(labels, B))]

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
repaired = tuple(am.brier(labels, repair(p)).value for p in (A, B))

# %% right: from the points of the diagram
m = [am.murphy(labels, p, bins=np.linspace(0, 1, 11)) for p in (A, B)]
reliability = np.array([np.nansum(x.count * (x.forecast - x.frequency) ** 2) / len(labels) for x in m])
repaired = np.array([np.nansum(x.count * x.frequency * (1 - x.frequency)) / len(labels) for x in m])
keep = "AB"[int(np.argmin(repaired))]

# %% wrong: two digits
# says: reliability: your values are rounded to fewer than four digits.
reliability = [float(f"{am.murphy(labels, p).reliability:.2g}") for p in (A, B)]

# %% wrong: three digits
# says: reliability: your values are rounded to fewer than four digits.
reliability = [float(f"{am.murphy(labels, p).reliability:.3g}") for p in (A, B)]

# %% wrong: repaired with two digits
# says: repaired: your values are rounded to fewer than four digits.
repaired = [0.037, 0.048]

# %% wrong: a plain mean over the bins
# says: all bins count the same with you, however many cells they hold
reliability = [
    float(np.nanmean((m.forecast - m.frequency) ** 2))
    for m in (am.murphy(labels, p) for p in (A, B))
]

# %% wrong: the expected calibration error
# says: this is the mean distance, not squared (calibration error)
reliability = [
    float(np.nansum(m.count * np.abs(m.forecast - m.frequency)) / m.n)
    for m in (am.murphy(labels, p) for p in (A, B))
]

# %% wrong: the greatest gap
# says: this is the greatest distance of a bin
reliability = [
    float(np.nanmax(np.abs(m.forecast - m.frequency)))
    for m in (am.murphy(labels, p) for p in (A, B))
]

# %% wrong: both words wrong
# says: fault and keep: not both hold
fault = "overconfident"
keep = "B"

# %% wrong: the map with the better reliability
# says: fault and keep: not both hold
keep = "B"

# %% wrong: both maps
# says: keep: the words are "A" and "B".
keep = "both"

# %% wrong: the within-bin term is left in
# says: you forgot what the bins hide
repaired = [m.brier - m.reliability for m in (am.murphy(labels, p) for p in (A, B))]

# %% wrong: uncertainty minus reliability
# says: you subtract the reliability from the uncertainty
repaired = [m.uncertainty - m.reliability for m in (am.murphy(labels, p) for p in (A, B))]

# %% wrong: repaired with 20 bins
# says: you took 20 bins
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, p, 20) for p in (A, B))]

# %% wrong: B first in the repaired ones as well
# says: the maps are swapped
reliability = [am.murphy(labels, p).reliability for p in (B, A)]
repaired = [m.uncertainty - m.resolution for m in (am.murphy(labels, p) for p in (B, A))]

# %% right: four digits
reliability = [float(f"{am.murphy(labels, p).reliability:.4g}") for p in (A, B)]
repaired = [0.03746, 0.04767]

# %% right: four digits after the point
reliability = (round(am.murphy(labels, A).reliability, 4), round(am.murphy(labels, B).reliability, 4))

# %% right: SymPy numbers, and words in capitals
import sympy as sp

reliability = [sp.Float(am.murphy(labels, p).reliability) for p in (A, B)]
fault = "Underconfident"
keep = " a"

# %% right: names of other parts are taken
w, p, y, rules, labels_again = 1, A, labels, None, labels.copy()
repaired = [m.uncertainty - m.resolution for m in (am.murphy(y, p), am.murphy(y, B))]

# %% right: labels as numbers
labels = labels.astype(float)
reliability = np.array([am.murphy(labels, x).reliability for x in (A, B)])
