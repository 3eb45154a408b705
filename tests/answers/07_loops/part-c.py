# %% wrong: the threshold of the best F1
# says: you take the best F1, whatever the costs
def best_threshold(labels, scores, missed, false):
    best, threshold = -1, np.inf
    for level in np.unique(scores)[::-1]:
        a = scores >= level
        tp, fp, fn = np.sum(a & (labels == 1)), np.sum(a & (labels == 0)), np.sum(~a & (labels == 1))
        if 2 * tp / (2 * tp + fp + fn) > best:
            best, threshold = 2 * tp / (2 * tp + fp + fn), level
    return threshold


lam = [0.743, 0.743]

# %% wrong: scores are taken for probabilities
# says: you take scores for probabilities, and divide the costs
def best_threshold(labels, scores, missed, false):
    return false / (missed + false)


lam = [0.2, 0.8]

# %% wrong: the costs are swapped
# says: the two costs are swapped
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [false * np.sum(true & (scores < t)) + missed * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: accepting nothing is not among the choices
# says: accepting nothing is never tried
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = np.unique(scores)[::-1]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: of equally cheap ones the lowest
# says: you take the lowest of equally cheap thresholds
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [*np.unique(scores), np.inf]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: accepts above the threshold only
# says: you accept what lies above the threshold, and not at it
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores <= t)) + false * np.sum(~true & (scores > t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: candidates one by one, ties broken
# says: best_threshold is wrong for a tie of a right and a false one: it returns 0.9.
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    order = np.argsort(-scores, kind="stable")
    y = (np.asarray(labels)[order] == 1).astype(float)
    costs = np.r_[0, np.cumsum(false * (1 - y) - missed * y)]
    k = int(np.argmin(costs))
    return np.inf if k == 0 else scores[order][k - 1]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: labels of 0 and 1 are inverted by ~
# says: ~ is to turn 0 and 1 around, which it does not
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(labels[scores < t]) + false * np.sum(~labels[scores >= t]) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [0.663, 0.905]

# %% wrong: rates are weighed, not counts
# says: you weigh rates, not counts
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    P, N = max(np.sum(true), 1), max(np.sum(~true), 1)
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) / P + false * np.sum(~true & (scores >= t)) / N for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: no errors are raised
# says: for costs -1 and 1. There is no answer in this case
def best_threshold(labels, scores, missed, false):
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: nan is not refused
# says: for costs nan and 1. There is no answer in this case
def best_threshold(labels, scores, missed, false):
    if missed < 0 or false < 0 or missed == np.inf or false == np.inf:
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: a cost of 0 is refused
# says: best_threshold stops for false closures that cost nothing with ValueError.
def best_threshold(labels, scores, missed, false):
    if not (0 < missed < np.inf and 0 < false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: the library counts
# says: the library's precision_recall would do your work here; do without it.
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    curve = am.precision_recall(labels, scores)
    costs = [missed * np.sum(np.equal(labels, 1)), *(missed * curve.fn + false * curve.fp)]
    return [np.inf, *curve.thresholds][int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: a fixed grid of thresholds
# says: 1 accepts nothing, for you
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = np.linspace(1, 0, 1001)
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: nothing is accepted by a threshold of 1
# says: 1 accepts nothing, for you
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [1.0, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: the cost is returned
# says: you return the cost
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    return min(missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels)


lam = [0.663, 0.905]

# %% wrong: no false closure is allowed, whatever it costs
# says: you allow no false closure, whatever the costs
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    top = np.max(scores[~true], initial=-np.inf)
    above = scores[scores > top]
    return np.min(above, initial=np.inf)


lam = [0.952, 0.952]

# %% wrong: the index of the threshold
# says: you return the index of the threshold
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return int(np.argmin(costs))


lam = [0.663, 0.905]

# %% wrong: stops where there is no candidate
# says: best_threshold stops for no candidate with ValueError: zero-size array to reduction operat
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [scores.max() + 1, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    k = int(np.argmin(costs))
    return levels[k] if k else np.inf


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% wrong: the function is right, the missions are swapped
# says: the two missions are swapped
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((1, 4), (4, 1))]

# %% wrong: the function is right, lam has two digits
# says: you rounded to two decimals
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = (0.66, 0.9)

# %% wrong: the function is right, lam is missing
# says: lam: there is no answer yet. Replace the dots.
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = ...

# %% right: a list of thresholds and argmin
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf):
        raise ValueError
    true = labels == 1
    levels = [np.inf, *np.unique(scores)[::-1]]
    costs = [missed * np.sum(true & (scores < t)) + false * np.sum(~true & (scores >= t)) for t in levels]
    return levels[int(np.argmin(costs))]


lam = [best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))]

# %% right: one sort, ties kept together
def best_threshold(labels, scores, missed, false):
    if not (np.isfinite([missed, false]).all() and min(missed, false) >= 0):
        raise ValueError("costs")
    levels, place = np.unique(scores, return_inverse=True)
    true = np.asarray(labels, dtype=bool)
    gain = np.bincount(place, np.where(true, missed, -false), len(levels))[::-1].cumsum()
    k = int(np.argmax(np.r_[0, gain]))
    return float(np.r_[np.inf, levels[::-1]][k])


lam = np.array([best_threshold(run.labels, run.scores, *c) for c in ((4, 1), (1, 4))])

# %% right: plain Python, numbers typed from the printout
def best_threshold(labels, scores, missed, false):
    for cost in (missed, false):
        if cost != cost or cost < 0 or cost in (np.inf, -np.inf):
            raise ValueError("a cost is negative or not finite")

    def cost_at(level):
        total = 0
        for y, s in zip(labels, scores):
            if y and s < level:
                total += missed
            if not y and s >= level:
                total += false
        return total

    best = np.inf
    for level in sorted(set(scores.tolist()), reverse=True):
        if cost_at(level) < cost_at(best):
            best = level
    return best


lam = (0.663, 0.905)

# %% right: min with a key
def best_threshold(labels, scores, missed, false):
    import math

    if not all(math.isfinite(c) and c >= 0 for c in (missed, false)):
        raise ValueError
    true = np.array(labels, bool)
    cost = lambda t: missed * (true & (scores < t)).sum() + false * (~true & (scores >= t)).sum()
    return min([math.inf, *scores], key=lambda t: (cost(t), -t))


lam = {k: best_threshold(run.labels, run.scores, *c) for k, c in enumerate(((4, 1), (1, 4)))}
lam = list(lam.values())

# %% right: sorted sweep
def best_threshold(labels, scores, missed, false):
    if missed < 0 or false < 0 or not np.isfinite([missed, false]).all(): raise ValueError("costs")
    y = np.asarray(labels).astype(bool); s = np.asarray(scores, float)
    best, arg = missed * y.sum(), np.inf
    for t in sorted(set(s.tolist()), reverse=True):
        a = s >= t
        c = missed * np.count_nonzero(y & ~a) + false * np.count_nonzero(a & ~y)
        if c < best: best, arg = c, t
    return arg
lam = np.array([0.663, 0.905])

# %% right: cumsum
def best_threshold(labels, scores, missed, false):
    for cost in (missed, false):
        if not 0 <= cost < float("inf"): raise ValueError
    y = np.array(labels) == 1; s = np.array(scores)
    if len(s) == 0: return np.inf
    o = np.argsort(-s, kind="stable"); s, y = s[o], y[o]
    cost = missed * (y.sum() - np.cumsum(y)) + false * np.cumsum(~y)
    last = np.append(s[1:] != s[:-1], True)
    cost, s = np.append(missed * y.sum(), cost[last]), np.append(np.inf, s[last])
    return s[np.argmin(cost)]

# %% wrong: typed
# says: for two thresholds that cost the same
def best_threshold(labels, scores, missed, false):
    return 0.905 if false > missed else 0.663

# %% wrong: midpoints
# says: best_threshold is wrong for the candidates
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf): raise ValueError
    s = np.unique(scores)[::-1]; mids = [np.inf, *((s[:-1] + s[1:]) / 2), -np.inf]
    y = np.equal(labels, 1)
    c = [missed * np.sum(y & (scores < t)) + false * np.sum(~y & (scores >= t)) for t in mids]
    return mids[int(np.argmin(c))]

# %% wrong: only scores of right candidates are tried, ties by the lowest
# says: you take the lowest of equally cheap thresholds
def best_threshold(labels, scores, missed, false):
    if not (0 <= missed < np.inf and 0 <= false < np.inf): raise ValueError
    y = np.equal(labels, 1); levels = sorted(set(np.asarray(scores)[y])) + [np.inf]
    c = [missed * np.sum(y & (scores < t)) + false * np.sum(~y & (scores >= t)) for t in levels]
    return levels[int(np.argmin(c))]
