# %% wrong: the textbook line: nan for 0 times log 0
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(y * np.log(p) + (1 - y) * np.log(1 - p))


# %% wrong: clipped
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    p = np.clip(p, 1e-12, 1 - 1e-12)
    return -np.mean(np.where(y, np.log(p), np.log(1 - p)))


# %% wrong: a tiny number inside the logarithm
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, p, 1 - p) + 1e-300))


# %% wrong: nan swept away
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.nan_to_num(np.where(y, np.log(p), np.log(1 - p))))


# %% wrong: infinite cells left out
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    loss = -np.log(np.where(y, p, 1 - p))
    return np.mean(loss[np.isfinite(loss)])


# %% wrong: unknown cells are in
def map_score(occupied, probability, unknown):
    p, y = probability, occupied
    if not np.all((p >= 0) & (p <= 1)) or unknown.all():
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))


# %% wrong: only the unknown cells
def map_score(occupied, probability, unknown):
    p, y = probability[unknown], occupied[unknown]
    if not np.all((p >= 0) & (p <= 1)):
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))


# %% wrong: unknown cells are set to 1/2
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    p = np.where(unknown, 0.5, probability)
    return -np.mean(np.log(np.where(occupied, p, 1 - p)))


# %% wrong: unknown cells count in the number of cells
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.sum(np.log(np.where(y, p, 1 - p))) / unknown.size


# %% wrong: the sum
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.sum(np.log(np.where(y, p, 1 - p)))


# %% wrong: bits
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log2(np.where(y, p, 1 - p)))


# %% wrong: the sign
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return np.mean(np.log(np.where(y, p, 1 - p)))


# %% wrong: occupied cells only
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.where(y, np.log(p), 0))


# %% wrong: the probability of free
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(np.where(y, 1 - p, p)))


# %% wrong: Brier
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return np.mean((p - y) ** 2)


# %% wrong: the input is changed
def map_score(occupied, probability, unknown):
    if unknown.all():
        raise ValueError
    probability[unknown] = 0.5
    if not np.all((probability >= 0) & (probability <= 1)):
        raise ValueError
    return -np.mean(np.log(np.where(occupied, probability, 1 - probability))[~unknown])


# %% wrong: no check of the range
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0:
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))


# %% wrong: nan passes the check
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or np.any((p < 0) | (p > 1)):
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))


# %% wrong: no cell is known, and nan comes out
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if not np.all((p >= 0) & (p <= 1)):
        raise ValueError
    return -np.mean(np.log(np.where(y, p, 1 - p)))


# %% wrong: refuses what is infinite
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    loss = -np.log(np.where(y, p, 1 - p))
    if np.isinf(loss).any():
        raise ValueError('a cell was told impossible')
    return np.mean(loss)


# %% wrong: the library does it
def map_score(occupied, probability, unknown):
    return am.cross_entropy(occupied, probability, unknown=unknown).value


# %% wrong: the library by another name
def map_score(occupied, probability, unknown):
    import amrmetrics.scoring as s
    return float(s.cross_entropy(occupied, probability, unknown=unknown))


# %% wrong: a constant
def map_score(occupied, probability, unknown):
    return 0.5


# %% wrong: cell by cell instead of the mean
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.log(np.where(y, p, 1 - p))


# %% wrong: bool arrays cannot be subtracted
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    return -np.mean(np.log(p ** y * (1 - p) ** (~y - y)))


# %% wrong: the range is tested before unknown cells are dropped
def map_score(occupied, probability, unknown):
    if unknown.all() or not np.all((probability >= 0) & (probability <= 1)):
        raise ValueError("bad forecast")
    p, y = probability[~unknown], occupied[~unknown]
    return -np.mean(np.log(np.where(y, p, 1 - p)))


# %% wrong: clipped at 1e-15
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    p = np.clip(p, 1e-15, 1 - 1e-15)
    return -np.mean(np.where(y, np.log(p), np.log(1 - p)))


# %% wrong: clipped at one percent
def map_score(occupied, probability, unknown):
    p, y = probability[~unknown], occupied[~unknown]
    if p.size == 0 or not np.all((p >= 0) & (p <= 1)):
        raise ValueError("bad forecast")
    p = np.clip(p, 0.01, 0.99)
    return -np.mean(np.where(y, np.log(p), np.log(1 - p)))


# %% wrong: the mask the other way round
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
