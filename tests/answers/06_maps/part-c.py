# %% wrong: above the threshold only
def rates_at(occupied, probability, gamma):
    c = probability > gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else np.nan for n in parts)


# %% wrong: 1e-12 in the denominators
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    tp, fp, fn = (
        np.sum((occupied == 1) & c),
        np.sum((occupied == 0) & c),
        np.sum((occupied == 1) & ~c),
    )
    return tp / (tp + fp + 1e-12), tp / (tp + fn + 1e-12), tp / (tp + fp + fn + 1e-12)


# %% wrong: zero where there is nothing to count
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else 0.0 for n in parts)


# %% wrong: two empty maps agree perfectly
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else 1.0 for n in parts)


# %% wrong: precision and recall are swapped
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(occupied == 1), np.sum(c), np.sum((occupied == 1) | c)
    return tuple(t / n if n else np.nan for n in parts)


# %% wrong: ~ of whole numbers
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    tp, fp, fn = np.sum(occupied[c]), np.sum(~occupied[c]), np.sum(occupied[~c])
    with np.errstate(invalid="ignore", divide="ignore"):
        return tuple(np.divide(tp, n) for n in (tp + fp, tp + fn, tp + fp + fn))


# %% wrong: accuracy instead of IoU
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1)
    return (*(t / n if n else np.nan for n in parts), np.mean((occupied == 1) == c))


# %% wrong: F1 instead of IoU
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = (t, np.sum(c)), (t, np.sum(occupied == 1)), (2 * t, np.sum(c) + np.sum(occupied == 1))
    return tuple(t / n if n else np.nan for t, n in parts)


# %% wrong: stops with nothing to count
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = int(np.sum((occupied == 1) & c))
    return t / int(np.sum(c)), t / int(np.sum(occupied)), t / int(np.sum((occupied == 1) | c))


# %% wrong: the answer to the first case
def rates_at(occupied, probability, gamma):
    return 0.6, 0.75, 0.5


# %% wrong: lets the library do it
def rates_at(occupied, probability, gamma):
    c = am.confusion(occupied, probability, gamma)
    return c.precision, c.recall, c.iou


# %% wrong: cuts the map that it was given
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
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    return t / np.sum(c), t / np.sum(occupied == 1)


# %% wrong: one row of a map only
def rates_at(occupied, probability, gamma):
    called = [k for k, q in enumerate(probability) if np.all(q >= gamma)]
    true = [k for k, v in enumerate(occupied) if np.all(v == 1)]
    t = len(set(called) & set(true))
    parts = len(called), len(true), len(set(called) | set(true))
    return tuple(t / n if n else np.nan for n in parts)


# %% wrong: undefined as soon as one count is empty
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n for n in parts) if all(parts) else (np.nan,) * 3


# %% wrong: None for nan
def rates_at(occupied, probability, gamma):
    c = probability >= gamma
    t = np.sum((occupied == 1) & c)
    parts = np.sum(c), np.sum(occupied == 1), np.sum((occupied == 1) | c)
    return tuple(t / n if n else None for n in parts)


# %% wrong: lets the class of the library do it
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
