# %% wrong: above the threshold only
# says: a cell at the threshold is called free
def rates_at(occupied, probability, gamma):
    c = probability > gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else np.nan for n in parts)

# %% wrong: 1e-12 in the denominators
# says: a rate with nothing to count becomes 0
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    tp, fp, fn = (
        np.sum((occupied == 1) & c),
        np.sum((occupied == 0) & c),
        np.sum((occupied == 1) & ~c),
    )
    return tp / (tp + fp + 1e-12), tp / (tp + fn + 1e-12), tp / (tp + fp + fn + 1e-12)

# %% wrong: zero where there is nothing to count
# says: a rate with nothing to count becomes 0
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else 0.0 for n in parts)

# %% wrong: two empty maps agree perfectly
# says: nothing to count is taken for perfect
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else 1.0 for n in parts)

# %% wrong: precision and recall are swapped
# says: precision and recall are swapped
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(occupied == 1), np.sum(c), np.sum((occupied == 1) | c)
    return tuple(t / n if n else np.nan for n in parts)

# %% wrong: ~ of whole numbers
# says: `~` turns 1 into -2, not into 0
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    tp, fp, fn = np.sum(occupied[c]), np.sum(~occupied[c]), np.sum(occupied[~c])
    with np.errstate(invalid="ignore", divide="ignore"):
        return tuple(np.divide(tp, n) for n in (tp + fp, tp + fn, tp + fp + fn))

# %% wrong: accuracy instead of IoU
# says: IoU is accuracy, which counts the free cells as well
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1)
    return (*(t / n if n else np.nan for n in parts), np.mean((occupied == 1) == c))

# %% wrong: F1 instead of IoU
# says: the last rate, IoU, is F1
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = (t, np.sum(c)), (t, np.sum(occupied == 1)), (2 * t, np.sum(c) + np.sum(occupied == 1))
    return tuple(t / n if n else np.nan for t, n in parts)

# %% wrong: stops with nothing to count
# says: rates_at stops for nothing called (there is something to count for recall and IoU) with Ze
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = int(np.sum((occupied == 1) & c))
    return t / int(np.sum(c)), t / int(np.sum(occupied)), t / int(np.sum((occupied == 1) | c))

# %% wrong: the answer to the first case
# says: rates_at is wrong for a row of cells: it returns (0.6, 0.75, 0.5).
def rates_at(occupied, probability, gamma):
    return 0.6, 0.75, 0.5

# %% wrong: lets the library do it
# says: the library's confusion would do your work here; do without it.
def rates_at(occupied, probability, gamma):
    c = am.confusion(occupied, probability, gamma)
    return c.precision, c.recall, c.iou

# %% wrong: cuts the map that it was given
# says: rates_at changes its input for eight cells. Work on a copy.
def rates_at(occupied, probability, gamma):
    probability[probability < gamma] = -1
    t = np.sum((occupied == 1) & (probability >= 0))
    parts = (
        np.sum(probability >= 0),
        np.sum(occupied == 1),
        np.sum((occupied == 1) | (probability >= 0)),
    )
    return tuple(t / n if n else np.nan for n in parts)

# %% wrong: two of the three
# says: rates_at, eight cells: a tuple of 3 results is asked, you have (0.6, 0.75).
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    return t / np.sum(c), t / np.sum(occupied == 1)

# %% wrong: one row of a map only
# says: rates_at, a grid, result 1: you have nan, which is not finite.
def rates_at(occupied, probability, gamma):
    called = [k for k, q in enumerate(probability) if np.all(q >= gamma)]
    true = [k for k, v in enumerate(occupied) if np.all(v == 1)]
    t = len(set(called) & set(true))
    parts = len(called), len(true), len(set(called) | set(true))
    return tuple(t / n if n else np.nan for n in parts)

# %% wrong: undefined as soon as one count is empty
# says: rates_at, nothing called (there is something to count for recall and IoU), result 2: you h
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n for n in parts) if all(parts) else (np.nan,) * 3

# %% wrong: None for nan
# says: rates_at, nothing called (there is something to count for recall and IoU), result 1: numbe
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else None for n in parts)

# %% wrong: lets the class of the library do it
# says: the library's Confusion would do your work here; do without it.
def rates_at(occupied, probability, gamma):
    true, called = np.equal(occupied, 1), probability >= gamma
    cells = true & called, called & ~true, true & ~called, ~true & ~called
    c = am.Confusion(*(int(np.sum(x)) for x in cells), gamma)
    return c.precision, c.recall, c.iou

# %% right: loops and counts
def rates_at(occupied, probability, gamma):
    tp = fp = fn = 0
    for cell, q in zip(np.ravel(occupied), np.ravel(probability), strict=True):
        called = q >= gamma
        tp += bool(cell) and bool(called)
        fp += bool(called) and not cell
        fn += bool(cell) and not called
    nan = float("nan")
    return (
        tp / (tp + fp) if tp + fp else nan,
        tp / (tp + fn) if tp + fn else nan,
        tp / (tp + fp + fn) if tp + fp + fn else nan,
    )

# %% right: NumPy's 0/0
def rates_at(occupied, probability, gamma):
    occupied, called = occupied.astype(bool), probability >= gamma
    hits = (occupied & called).sum()
    with np.errstate(invalid="ignore"):
        return tuple(hits / np.array([called.sum(), occupied.sum(), (occupied | called).sum()]))

# %% right: IoU from the other two counts, F1 on the way
def rates_at(occupied, probability, gamma):
    truth, called = np.asarray(occupied, dtype=float), np.asarray(probability >= gamma, dtype=float)
    t, n, m = np.sum(truth * called), truth.sum(), called.sum()
    return (t / m if m else np.nan, t / n if n else np.nan, t / (n + m - t) if n + m else np.nan)

# %% wrong: nearly equal counts as at least
# says: rates_at is wrong for cells a hair below gamma: it returns (0.6, 1, 0.6).
def rates_at(occupied, probability, gamma):
    true = np.asarray(occupied) == 1
    called = (probability > gamma) | np.isclose(probability, gamma)
    hits = np.sum(true & called)
    wholes = [np.sum(called), np.sum(true), np.sum(true | called)]
    return tuple(float(hits / n) if n else np.nan for n in wholes)

# %% wrong: a small number in the denominators, seen in every rate
# says: you add a small number to what you divide by (about 1e-6)
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / (n + 1e-6) for n in parts)

# %% wrong: nan only where all is empty
# says: a rate with nothing to count becomes 0
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    if not c.any() and not np.any(occupied):
        return np.nan, np.nan, np.nan
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / max(n, 1) for n in parts)

# %% wrong: no hit is taken for undefined
# says: rates_at, a map that is wrong everywhere, result 1: you have nan, which is not finite.
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if t else np.nan for n in parts)

# %% wrong: IoU of two empty maps is 1
# says: rates_at is wrong for nothing called and nothing occupied: it returns (nan, nan, 1).
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    n, m, k = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return t / n if n else np.nan, t / m if m else np.nan, t / k if k else 1.0

# %% wrong: gamma is 1/2
# says: gamma is always 1/2 with you
def rates_at(occupied, probability, gamma):
    c = np.asarray(probability) >= 0.5
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else np.nan for n in parts)

# %% wrong: the union counts the hits twice
# says: the union counts the hits twice
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    n, m = np.sum(c), np.sum(occupied == 1)
    return tuple(t / k if k else np.nan for k in (n, m, n + m))

# %% wrong: specificity for recall
# says: recall is the specificity
def rates_at(occupied, probability, gamma):
    y, c = np.asarray(occupied) == 1, probability >= gamma
    t, free = np.sum(y & c), np.sum(~y)
    n, k = np.sum(c), np.sum(y | c)
    return (
        t / n if n else np.nan,
        np.sum(~y & ~c) / free if free else np.nan,
        t / k if k else np.nan,
    )

# %% wrong: the rates of the free cells
# says: these are the rates of the free cells
def rates_at(occupied, probability, gamma):
    y, c = np.asarray(occupied) == 0, probability < gamma
    t = np.sum(y & c)
    return tuple(t / n if n else np.nan for n in (np.sum(c), np.sum(y), np.sum(y | c)))

# %% wrong: the library by a default argument
# says: the library's confusion would do your work here; do without it.
def rates_at(occupied, probability, gamma, f=am.confusion):
    if np.size(occupied) == 0:
        return np.nan, np.nan, np.nan
    c = f(occupied, probability, gamma)
    return c.precision, c.recall, c.iou

# %% wrong: a threshold sweep
# says: the library's threshold_sweep would do your work here; do without it.
def rates_at(occupied, probability, gamma):
    s = am.threshold_sweep(occupied, probability)
    k = np.sum(s.thresholds >= gamma) - 1
    return s.precision[k], s.recall[k], s.iou[k]

# %% wrong: text for nan
# says: rates_at, nothing called (there is something to count for recall and IoU), result 1: numbe
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else "nan" for n in parts)

# %% wrong: prints instead of returning
# says: rates_at: there is no answer yet. It returns nothing for eight cells.
def rates_at(occupied, probability, gamma):
    print(0.6, 0.75, 0.5)

# %% right: divides and lets NumPy warn
def rates_at(occupied, probability, gamma):
    called = probability >= gamma
    tp = np.sum((occupied == 1) & called)
    return (
        tp / np.sum(called),
        tp / np.sum(occupied == 1),
        tp / np.sum((occupied == 1) | called),
    )

# %% right: an array
def rates_at(occupied, probability, gamma):
    o, c = np.asarray(occupied) == 1, np.asarray(probability) >= gamma
    tp = np.sum(o & c)
    with np.errstate(all="ignore"):
        return np.float64(tp) / np.array([c.sum(), o.sum(), (o | c).sum()])

# %% right: a helper, and sets of indices
import math


def part(some, whole):
    return len(some) / len(whole) if whole else math.nan


def rates_at(occupied, probability, gamma):
    called = {k for k, q in enumerate(probability.ravel()) if q >= gamma}
    true = {k for k, y in enumerate(occupied.ravel()) if y}
    hits = called & true
    return [part(hits, called), part(hits, true), part(hits, called | true)]

# %% wrong: gamma above one is nothing
# says: rates_at, a grid of whole numbers 0 and 1, result 1: you have nan, which is not finite.
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    if gamma >= 1:
        c = np.zeros_like(c)
    t = np.sum((occupied == 1) & c)
    return tuple(t / n if n else np.nan for n in (c.sum(), np.sum(occupied), np.sum((occupied == 1) | c)))

# %% wrong: axis 0
# says: rates_at, a grid, result 1: you have nan, which is not finite.
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c, axis=0)
    return tuple(np.mean(t / np.sum(x, axis=0)) for x in (c, occupied == 1, (occupied == 1) | c))

# %% wrong: rounds
# says: you round to 4 decimals
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    return tuple(round(t / n, 4) if n else np.nan for n in (c.sum(), np.sum(occupied), np.sum((occupied == 1) | c)))

# %% wrong: IoU 0 for empty
# says: rates_at is wrong for nothing called and nothing occupied: it returns (nan, nan, 0).
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    n, m, k = c.sum(), np.sum(occupied), np.sum((occupied == 1) | c)
    return (t / n if n else np.nan, t / m if m else np.nan, t / max(k, 1))

# %% wrong: the last row is forgotten
# says: rates_at is wrong for a row of cells: it returns (0.375, 0.75, 0.333333).
def rates_at(occupied, probability, gamma):
    y, p = np.ravel(occupied)[:-1], np.ravel(probability)[:-1]
    c = p >= gamma
    t = np.sum((y == 1) & c)
    return tuple(t / n if n else np.nan for n in (c.sum(), np.sum(y), np.sum((y == 1) | c)))

# %% wrong: dict
# says: rates_at, eight cells: a tuple of 3 results is asked, you have {'precision': 1, 'recall': 
def rates_at(occupied, probability, gamma):
    return {"precision": 1, "recall": 1, "iou": 1}

# %% right: confusion counts with bool arithmetic
def rates_at(occupied, probability, gamma):
    o = occupied.astype(bool)
    c = probability >= gamma
    tp, fp, fn = np.count_nonzero(o & c), np.count_nonzero(~o & c), np.count_nonzero(o & ~c)
    def d(x, y):
        try:
            return x / y
        except ZeroDivisionError:
            return float("nan")
    return d(tp, tp + fp), d(tp, tp + fn), d(tp, tp + fp + fn)

# %% right: masked mean
def rates_at(occupied, probability, gamma):
    o, c = np.array(occupied, bool), np.array(probability) >= gamma
    return o[c].mean(), c[o].mean(), (o & c)[o | c].mean()
