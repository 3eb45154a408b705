# %% wrong: the textbook line: nan for 0 times log 0
# says: map_score, a map sure of some cells, which is right there and costs 0: you have nan, which
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(y * np.log(p) + (1 - y) * np.log(1 - p))

# %% wrong: clipped
# says: you clip, or add something before the logarithm (about 1e-12)
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    p = np.clip(p, 1e-12, 1 - 1e-12)
    return -np.mean(np.where(y, np.log(p), np.log(1 - p)))

# %% wrong: a tiny number inside the logarithm
# says: you clip, or add something before the logarithm (about 1e-300)
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, p, 1 - p) + 1e-300))

# %% wrong: nan swept away
# says: nan_to_num makes infinity finite
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.nan_to_num(np.where(y, np.log(p), np.log(1 - p))))

# %% wrong: infinite cells left out
# says: you leave out cells of infinite cost
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    loss = -np.log(np.where(y, p, 1 - p))
    return np.mean(loss[np.isfinite(loss)])

# %% wrong: unknown cells are in
# says: the unknown cells are in
def map_score(occupied, probability, unknown):
    p, y = probability, occupied
    if not np.all((p >= 0) & (p <= 1)) or unknown.all():
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: only the unknown cells
# says: you keep the unknown cells, not the known ones
def map_score(occupied, probability, unknown):
    p, y = probability[unknown], occupied[unknown]
    if not np.all((p >= 0) & (p <= 1)):
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: unknown cells are set to 1/2
# says: unknown cells count as told 1/2
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    p = np.where(unknown, 0.5, probability)
    return -np.mean(np.log(np.where(occupied, p, 1 - p)))

# %% wrong: unknown cells count in the number of cells
# says: the unknown cells count in the number of cells
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.sum(np.log(np.where(y, p, 1 - p))) / unknown.size

# %% wrong: the sum
# says: this is the sum, not the mean
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.sum(np.log(np.where(y, p, 1 - p)))

# %% wrong: bits
# says: you take base 2, and nats are asked
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log2(np.where(y, p, 1 - p)))

# %% wrong: the sign
# says: a sign is lost
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: occupied cells only
# says: free cells cost nothing with you
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.where(y, np.log(p), 0))

# %% wrong: the probability of free
# says: p is taken for the probability of free
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, 1 - p, p)))

# %% wrong: Brier
# says: this is the Brier score
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return np.mean((p - y) ** 2)

# %% wrong: the input is changed
# says: map_score changes its input for a row of cells. Work on a copy.
def map_score(occupied, probability, unknown):
    if unknown.all():
        raise ValueError
    probability[unknown] = 0.5
    if not np.all((probability >= 0) & (probability <= 1)):
        raise ValueError
    return -np.mean(np.log(np.where(occupied, probability, 1 - probability))[~unknown])

# %% wrong: no check of the range
# says: for a known cell told 1.2. There is no answer in this case
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0:
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: nan passes the check
# says: for a known cell told nan. There is no answer in this case
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or np.any((p < 0) | (p > 1)):
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: no cell is known, and nan comes out
# says: for no known cell. There is no answer in this case
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if not np.all((p >= 0) & (p <= 1)):
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: refuses what is infinite
# says: an occupied cell told 0, alone with ValueError: a cell was told imposs
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    loss = -np.log(np.where(y, p, 1 - p))
    if np.isinf(loss).any():
        raise ValueError('a cell was told impossible')
    return np.mean(loss)

# %% wrong: the library does it
# says: the library's cross_entropy would do your work here; do without it.
def map_score(occupied, probability, unknown):
    return am.cross_entropy(occupied, probability, unknown=unknown).value

# %% wrong: the library by another name
# says: the library's cross_entropy would do your work here; do without it.
def map_score(occupied, probability, unknown):
    import amrmetrics.scoring as s
    return float(s.cross_entropy(occupied, probability, unknown=unknown))

# %% wrong: a constant
# says: a row of cells
def map_score(occupied, probability, unknown):
    return 0.5

# %% wrong: cell by cell instead of the mean
# says: map_score, a row of cells: one number is asked
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.log(np.where(y, p, 1 - p))

# %% wrong: bool arrays cannot be subtracted
# says: a row of cells with TypeError: numpy boolean subtract, the `-` operato
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(p ** y * (1 - p) ** (~y - y)))

# %% wrong: the range is tested before unknown cells are dropped
# says: an unknown cell told 1.7 with ValueError: bad forecast.
def map_score(occupied, probability, unknown):
    if unknown.all() or not np.all((probability >= 0) & (probability <= 1)):
        raise ValueError("bad forecast")
    p, y = probability[~unknown], occupied[~unknown]
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: clipped at 1e-15
# says: you clip, or add something before the logarithm (about 1e-15)
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    p = np.clip(p, 1e-15, 1 - 1e-15)
    return -np.mean(np.where(y, np.log(p), np.log(1 - p)))

# %% wrong: clipped at one percent
# says: you clip, or add something before the logarithm (about 0.01)
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    p = np.clip(p, 0.01, 0.99)
    return -np.mean(np.where(y, np.log(p), np.log(1 - p)))

# %% wrong: the mask the other way round
# says: you keep the unknown cells, not the known ones
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    p, y = probability[unknown], occupied[unknown]
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% right: a loop with math.log
def map_score(occupied, probability, unknown):
    import math

    losses = []
    for y, p, out in zip(occupied.flat, probability.flat, unknown.flat):
        if out:
            continue
        if math.isnan(p) or p < 0 or p > 1:
            raise ValueError(f"{p} is no probability")
        q = p if y else 1 - p
        losses.append(math.inf if q == 0 else -math.log(q))
    if not losses:
        raise ValueError("nothing is known")
    return sum(losses) / len(losses)

# %% right: logarithms of each class, weights by a mask
def map_score(occupied, probability, unknown):
    known = np.logical_not(unknown)
    if not known.any():
        raise ValueError("nothing known")
    if not (np.abs(probability[known] - 0.5) <= 0.5).all():
        raise ValueError("outside [0, 1]")
    with np.errstate(divide="ignore"):
        total = -np.log(probability[known & occupied]).sum()
        total -= np.log1p(-probability[known & ~occupied]).sum()
    return float(total / known.sum())

# %% right: powers
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    with np.errstate(divide='ignore'):
        return np.mean(-np.log(np.power(p, y.astype(int)) * np.power(1 - p, 1 - y.astype(int))))

# %% wrong: clipped near 1 alone
# says: you clip, or add something before the logarithm, near 1 alone
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, p, np.maximum(1 - p, 1e-12))))

# %% wrong: clipped near 0 alone
# says: you clip, or add something before the logarithm, near 0 alone (about 1e-09)
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, np.maximum(p, 1e-9), 1 - p)))

# %% wrong: infinite for occupied cells only, nan dropped
# says: a free cell told 1, alone
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    if (y & (p == 0)).any():
        return np.inf
    t = -np.where(y, np.log(p), 0) - np.where(y, 0, np.log(1 - p))
    t[~y & (p == 1)] = np.nan
    return float(np.where(np.isfinite(t), t, 0).mean())

# %% wrong: infinite before the range is tested
# says: for a cell told 0 wrongly, another one told 1.2. There is no answer in this case
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0:
        raise ValueError("no known cell")
    if np.any(p[y] == 0) or np.any(p[~y] == 1):
        return np.inf
    if not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: the range with a tolerance
# says: for a known cell told a little more than 1. There is no answer in this case
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= -1e-6) & (p <= 1 + 1e-6)):
        raise ValueError("bad forecast")
    p = np.clip(p, 0, 1)
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: only the first cell is tested
# says: for a known cell told -0.1. There is no answer in this case
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not 0 <= p[0] <= 1:
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: the mean of row means
# says: map_score is wrong for a grid
def map_score(occupied, probability, unknown):
    if unknown.all() or not np.all((probability >= 0) & (probability <= 1) | unknown):
        raise ValueError("bad forecast")
    with np.errstate(all="ignore"):
        loss = np.where(unknown, np.nan, -np.log(np.where(occupied, probability, 1 - probability)))
        return np.nanmean(np.nanmean(loss, axis=-1))

# %% wrong: two dimensions only
# says: a row of cells with ValueError: not enough values to unpack (expected
def map_score(occupied, probability, unknown):
    rows, columns = occupied.shape
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% wrong: the library as a default argument
# says: the library's cross_entropy would do your work here; do without it.
def map_score(occupied, probability, unknown, score=am.cross_entropy):
    return score(occupied[~unknown], probability[~unknown]).value

# %% wrong: the library, loaded again
# says: the library's cross_entropy would do your work here; do without it.
import importlib.util
import sys


def map_score(occupied, probability, unknown):
    import amrmetrics.scoring as s

    spec = importlib.util.spec_from_file_location("scores_again", s.__file__)
    again = sys.modules["scores_again"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(again)
    return again.cross_entropy(occupied, probability, unknown=unknown).value

# %% wrong: base 10
# says: you take base 10, and nats are asked
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log10(np.where(y, p, 1 - p)))

# %% wrong: the values of the first cases are typed in
# says: a row of cells
def map_score(occupied, probability, unknown):
    typed = {8: 0.8, 54: 0.9, 1: 1.2039728043259361}
    return typed.get(occupied.size, 0.0)

# %% wrong: the most likely label is scored, not the true one
# says: a row of cells
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.maximum(p, 1 - p)))

# %% wrong: an infinite cell is told by None
# says: map_score: there is no answer yet. It returns nothing for an occupied cell told 0, alone.
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    loss = -np.log(np.where(y, p, 1 - p))
    return None if np.isinf(loss).any() else loss.mean()

# %% right: without errstate
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, p, 1 - p)))

# %% right: infinity as a case of its own
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    if np.any(p[y] == 0) or np.any(p[~y] == 1):
        return float("inf")
    total = 0.0
    for yes, told in zip(y, p):
        total -= np.log(told if yes else 1 - told)
    return total / len(p)

# %% right: a helper, and xlogy
def known_only(occupied, probability, unknown):
    keep = ~unknown
    return occupied[keep].astype(float), probability[keep].astype(float)


def map_score(occupied, probability, unknown):
    from scipy.special import xlog1py, xlogy

    y, p = known_only(occupied, probability, unknown)
    if not len(p):
        raise ValueError("nothing known")
    if np.isnan(p).any() or p.min() < 0 or p.max() > 1:
        raise ValueError("no probability")
    return -(xlogy(y, p) + xlog1py(1 - y, -p)).sum() / len(p)

# %% right: prints and warns
import warnings


def map_score(occupied, probability, unknown):
    warnings.warn("here I am")
    print("cells", occupied.size)
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return float(np.negative(np.log(np.abs(1 - y - p))).mean())
