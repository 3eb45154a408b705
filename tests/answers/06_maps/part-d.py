# %% wrong: from the map to the building
# says: you look from the map to the building
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(called), cell * np.argwhere(occupied)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: the symmetric distance
# says: invented cells count: you look in both directions
def uncovered(occupied, called, cell):
    return float(am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)))


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (False, True)

# %% wrong: in cells
# says: you count in cells
def uncovered(occupied, called, cell):
    return am.hausdorff(np.argwhere(occupied), np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: cells of 0.1 m, whatever cell says
# says: cells are 0.1 m wide with you, whatever is said
def uncovered(occupied, called, cell):
    return 0.1 * am.hausdorff(np.argwhere(occupied), np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: the mean instead of the worst
# says: you average, and the worst cell is asked
def uncovered(occupied, called, cell):
    return am.chamfer(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: city blocks
# says: you add up rows and columns instead of taking lengths
def uncovered(occupied, called, cell):
    walls, mapped = np.argwhere(occupied), np.argwhere(called)
    return cell * cdist(walls, mapped, "cityblock").min(axis=1).max()


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: only cells that the map misses are averaged
# says: you average over the cells that the map misses
def uncovered(occupied, called, cell):
    missed = cell * np.argwhere(occupied & ~called)
    return am.chamfer(missed, cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: nothing occupied is called covered
# says: uncovered returns 0 for none occupied. There is no answer in this case: raise a ValueError
def uncovered(occupied, called, cell):
    if not occupied.any():
        return 0.0
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: the value for map a
# says: uncovered is wrong for a wall cell that is called two cells away: it returns 0.1.
def uncovered(occupied, called, cell):
    return 0.1


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: erases the given map
# says: uncovered changes its input for a wall cell that is called two cells away. Work on a copy.
def uncovered(occupied, called, cell):
    distance = am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward
    occupied &= called
    return distance


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: Chamfer decides
# says: an average, or an invented cell, decides with you
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (False, True)

# %% wrong: IoU decides
# says: IoU decides with you, which does not say where the errors are
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = True, True

# %% wrong: wants a map without errors
# says: no map with an error will do for you
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = [False, False]

# %% wrong: a sentence
# says: usable: a tuple of 2 results is asked, you have 'I would take map a'.
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = "I would take map a"

# %% wrong: the rows of the table are swapped
# says: the two maps are swapped
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (b, a):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: the table in cells
# says: you counted in cells
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = np.argwhere(truth), np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 1)))

# %% wrong: the table holds squared Chamfer
# says: you squared the distances
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = (
        sum(np.mean(cdist(walls, mapped).min(axis=k) ** 2) for k in (0, 1)),
        float(am.hausdorff(walls, mapped)),
    )
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: the table lists one map
# says: table: a row of four numbers is asked for each of the two maps; you have [(0.8110236220472
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a,):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% wrong: the table is rounded to too few digits
# says: table, IoU: three decimals are asked.
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = [[0.81, 0.13, 2.4, 0.1], [0.81, 0.1, 0.5, 0.5]]

# %% wrong: the table holds half of Chamfer
# says: you halved the sum of the two directions
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = [[0.811, 0.0659, 2.4, 0.1], [0.811, 0.0478, 0.5, 0.5]]

# %% wrong: the last column looks from the map to the building
# says: invented cells count: you looked from the map, or both ways
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = [[0.811, 0.132, 2.4, 2.4], [0.811, 0.096, 0.5, 0.5]]

# %% wrong: a flat table
# says: table: a row of four numbers is asked for each of the two maps; you have [0.811, 0.132, 2.
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = [0.811, 0.132, 2.4, 0.1, 0.811, 0.096, 0.5, 0.5]

# %% wrong: no table
# says: table: there is no answer yet. It has no row.
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []

# %% wrong: the name of a map instead of two truth values
# says: usable: a tuple of 2 results is asked, you have 'A'.
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = [[0.811, 0.132, 2.4, 0.1], [0.811, 0.096, 0.5, 0.5]]
usable = "A"

# %% right: a distance transform
def uncovered(occupied, called, cell):
    from scipy.ndimage import distance_transform_edt

    if not (occupied.any() and called.any()):
        raise ValueError("a map without an occupied cell has no distance")
    return distance_transform_edt(~called)[occupied].max() * cell


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))

# %% right: all pairs, and a table of numbers
def uncovered(occupied, called, cell):
    worst = []
    mapped = np.argwhere(called)
    for point in np.argwhere(occupied):
        worst.append(np.min(np.hypot(*(mapped - point).T)))
    return float(np.max(worst) * cell)


table = np.array([[0.81102, 0.131888, 2.4, 0.1], [0.81102, 0.0956522, 0.5, 0.5]])

# %% right: rounded to three decimals, other names overwritten
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


a, b, truth, P, Q, occupied = 1, 2, 3, 4, 5, 6
table = [[0.811, 0.132, 2.4, 0.1], [0.811, 0.096, 0.5, 0.5]]
usable = [True, False]

# %% wrong: a search window of 11 x 11 cells
# says: you look no farther than 5 cells
def near(M, i, j):
    best = np.inf
    for k in range(max(0, i - 5), min(M.shape[0], i + 6)):
        for n in range(max(0, j - 5), min(M.shape[1], j + 6)):
            if M[k, n]:
                best = min(best, np.hypot(k - i, n - j))
    return best


def uncovered(occupied, called, cell):
    if not occupied.any() or not called.any():
        raise ValueError
    d = np.array([near(called, i, j) for i, j in np.argwhere(occupied)])
    return float(d[np.isfinite(d)].max() * cell)

# %% wrong: a search along rows and columns only
# says: uncovered is wrong for a wall cell that is called on the diagonal: it returns 0.
def uncovered(occupied, called, cell):
    if not occupied.any() or not called.any():
        raise ValueError("nothing there")
    P, Q = np.argwhere(occupied), np.argwhere(called)
    worst = 0
    for p in P:
        same = Q[(Q == p).any(axis=1)]
        worst = max(worst, np.abs(same - p).sum(axis=1).min() if len(same) else 0)
    return cell * worst

# %% wrong: a step on the diagonal counts as one
# says: a step on the diagonal counts as one cell
def uncovered(occupied, called, cell):
    if not occupied.any() or not called.any():
        raise ValueError("nothing there")
    D = cdist(np.argwhere(occupied), np.argwhere(called), "chebyshev")
    return cell * D.min(axis=1).max()

# %% wrong: squares
# says: you square the distances
def uncovered(occupied, called, cell):
    if not occupied.any() or not called.any():
        raise ValueError("nothing there")
    D = cdist(cell * np.argwhere(occupied), cell * np.argwhere(called), "sqeuclidean")
    return D.min(axis=1).max()

# %% wrong: Chamfer
# says: this is the Chamfer distance
def uncovered(occupied, called, cell):
    return float(am.chamfer(cell * np.argwhere(occupied), cell * np.argwhere(called)))

# %% wrong: infinity where none is called
# says: uncovered returns inf for none called. There is no answer in this case: raise a ValueError
def uncovered(occupied, called, cell):
    if not called.any():
        return np.inf
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward

# %% wrong: the best cell
# says: you take the best cell, not the worst
def uncovered(occupied, called, cell):
    if not occupied.any() or not called.any():
        raise ValueError("nothing there")
    return cell * cdist(np.argwhere(occupied), np.argwhere(called)).min()

# %% wrong: rounded to three decimals
# says: you round, and the distance itself is asked
def uncovered(occupied, called, cell):
    d = am.hausdorff(np.argwhere(occupied), np.argwhere(called)).forward
    return round(cell * d, 3)

# %% wrong: a TypeError where none is called
# says: uncovered raises TypeError('nothing there') for none called. There is no answer in this ca
def uncovered(occupied, called, cell):
    if not occupied.any() or not called.any():
        raise TypeError("nothing there")
    return cell * am.hausdorff(np.argwhere(occupied), np.argwhere(called)).forward

# %% wrong: the table holds F1
# says: you filled in F1, and IoU is asked
table = [[0.896, 0.132, 2.4, 0.1], [0.896, 0.096, 0.5, 0.5]]

# %% wrong: the table holds accuracy
# says: this is accuracy, which counts the free cells as well
table = [
    [np.mean(truth == m), 0.131888, 2.4, 0.1 if m is a else 0.5] for m in (a, b)
]

# %% wrong: the table has the columns as rows
# says: table: a row of four numbers is asked for each of the two maps; you have [[0.811, 0.811], 
table = [[0.811, 0.811], [0.132, 0.096], [2.4, 0.5], [0.1, 0.5]]

# %% wrong: a guess at usable
# says: no map with an error will do for you
usable = (False, False)

# %% wrong: nothing said of b
# says: usable: a tuple of 2 results is asked, you have True.
usable = True

# %% right: arrays, a tree
def uncovered(occupied, called, cell):
    from scipy.spatial import cKDTree

    P, Q = np.argwhere(occupied) * cell, np.argwhere(called) * cell
    if len(P) == 0 or len(Q) == 0:
        raise ValueError("no cells")
    return float(cKDTree(Q).query(P)[0].max())


usable = np.array([True, False])

# %% right: one and zero, rows by name
table = {"a": (0.811, 0.132, 2.4, 0.1), "b": (0.811, 0.0957, 0.5, 0.5)}
usable = (1, 0)

# %% right: circles that grow, builtins used up
sum = min = 0


def uncovered(occupied, called, cell):
    if not np.any(occupied) or not np.any(called):
        raise ValueError("an empty grid")
    gaps = [np.hypot(*(np.argwhere(called) - p).T).min() for p in np.argwhere(occupied)]
    return cell * sorted(gaps)[-1]

# %% right: broadcasting
def uncovered(occupied, called, cell):
    P, Q = np.argwhere(occupied), np.argwhere(called)
    if P.size == 0 or Q.size == 0:
        raise ValueError("an empty grid")
    gaps = [np.sqrt(((Q - p) ** 2).sum(axis=1).min()) for p in P]
    return np.max(gaps) * cell

# %% wrong: window of 40 cells
# says: uncovered is wrong for a corridor, called at one end: it returns 6.
def uncovered(occupied, called, cell):
    if not occupied.any() or not called.any():
        raise ValueError
    D = cdist(np.argwhere(occupied), np.argwhere(called))
    return cell * min(D.min(axis=1).max(), 60)

# %% wrong: only missed cells, error if none is missed
# says: uncovered stops for a map that is right with ValueError: all covered.
def uncovered(occupied, called, cell):
    P = np.argwhere(occupied & ~called)
    if not len(P):
        raise ValueError("all covered")
    return cell * cdist(P, np.argwhere(called)).min(axis=1).max()

# %% wrong: mean of worst ten percent
# says: uncovered is wrong for a random map of wider cells: it returns 2.65394.
def uncovered(occupied, called, cell):
    if not occupied.any() or not called.any():
        raise ValueError
    return cell * np.quantile(cdist(np.argwhere(occupied), np.argwhere(called)).min(axis=1), 0.95)

# %% wrong: x and y in a square grid
# says: uncovered is wrong for a random map: it returns 0.559017.
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called.T)).forward

# %% wrong: assertion instead of ValueError
# says: uncovered raises AssertionError() for none called. There is no answer in this case: raise 
def uncovered(occupied, called, cell):
    assert occupied.any() and called.any()
    return cell * am.hausdorff(np.argwhere(occupied), np.argwhere(called)).forward

# %% wrong: usable strings
# says: usable, result 1: True or False is asked, you have 'True'.
usable = ("True", "False")

# %% right: usable ints in array, numpy table
usable = np.array([1, 0])

# %% right: distance from SciPy's directed one
def uncovered(occupied, called, cell):
    from scipy.spatial.distance import directed_hausdorff

    P, Q = np.argwhere(occupied), np.argwhere(called)
    if 0 in (len(P), len(Q)):
        raise ValueError("empty")
    return directed_hausdorff(P, Q)[0] * cell

# %% right: growing by dilation
def uncovered(occupied, called, cell):
    i, j = np.nonzero(occupied)
    k, n = np.nonzero(called)
    if i.size * k.size == 0:
        raise ValueError("empty")
    return max(min((x - k) ** 2 + (y - n) ** 2) for x, y in zip(i, j)) ** 0.5 * cell
