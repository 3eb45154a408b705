# %% wrong: from the map to the building
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(called), cell * np.argwhere(occupied)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: the symmetric distance
def uncovered(occupied, called, cell):
    return float(am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)))


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (False, True)


# %% wrong: in cells
def uncovered(occupied, called, cell):
    return am.hausdorff(np.argwhere(occupied), np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: cells of 0.1 m, whatever cell says
def uncovered(occupied, called, cell):
    return 0.1 * am.hausdorff(np.argwhere(occupied), np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: the mean instead of the worst
def uncovered(occupied, called, cell):
    return am.chamfer(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: city blocks
def uncovered(occupied, called, cell):
    walls, mapped = np.argwhere(occupied), np.argwhere(called)
    return cell * cdist(walls, mapped, "cityblock").min(axis=1).max()


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: only cells that the map misses are averaged
def uncovered(occupied, called, cell):
    missed = cell * np.argwhere(occupied & ~called)
    return am.chamfer(missed, cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: nothing occupied is called covered
def uncovered(occupied, called, cell):
    if not occupied.any():
        return 0.0
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: the value for map a
def uncovered(occupied, called, cell):
    return 0.1


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: erases the given map
def uncovered(occupied, called, cell):
    distance = am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward
    occupied &= called
    return distance


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: Chamfer decides
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (False, True)


# %% wrong: IoU decides
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = True, True


# %% wrong: wants a map without errors
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = [False, False]


# %% wrong: a sentence
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = "I would take map a"


# %% wrong: the rows of the table are swapped
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (b, a):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: the table in cells
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a, b):
    walls, mapped = np.argwhere(truth), np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 1)))
usable = (True, False)


# %% wrong: the table holds squared Chamfer
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
usable = (True, False)


# %% wrong: the table lists one map
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
for m in (a,):
    walls, mapped = 0.1 * np.argwhere(truth), 0.1 * np.argwhere(m)
    both = float(am.chamfer(walls, mapped)), float(am.hausdorff(walls, mapped))
    table.append((am.confusion(truth, m.astype(float)).iou, *both, uncovered(truth, m, 0.1)))
usable = (True, False)


# %% wrong: the table is rounded to too few digits
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = [[0.81, 0.13, 2.4, 0.1], [0.81, 0.1, 0.5, 0.5]]
usable = (True, False)


# %% wrong: the table holds half of Chamfer
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = [[0.811, 0.0659, 2.4, 0.1], [0.811, 0.0478, 0.5, 0.5]]
usable = (True, False)


# %% wrong: the last column looks from the map to the building
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = [[0.811, 0.132, 2.4, 2.4], [0.811, 0.096, 0.5, 0.5]]
usable = (True, False)


# %% wrong: a flat table
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = [0.811, 0.132, 2.4, 0.1, 0.811, 0.096, 0.5, 0.5]
usable = (True, False)


# %% wrong: no table
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


table = []
usable = (True, False)


# %% wrong: the name of a map instead of two truth values
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
usable = (True, False)


# %% right: all pairs, and a table of numbers
def uncovered(occupied, called, cell):
    worst = []
    mapped = np.argwhere(called)
    for point in np.argwhere(occupied):
        worst.append(np.min(np.hypot(*(mapped - point).T)))
    return float(np.max(worst) * cell)


table = np.array([[0.81102, 0.131888, 2.4, 0.1], [0.81102, 0.0956522, 0.5, 0.5]])
usable = (True, False)


# %% right: rounded to three decimals, other names overwritten
def uncovered(occupied, called, cell):
    return am.hausdorff(cell * np.argwhere(occupied), cell * np.argwhere(called)).forward


a, b, truth, P, Q, occupied = 1, 2, 3, 4, 5, 6
table = [[0.811, 0.132, 2.4, 0.1], [0.811, 0.096, 0.5, 0.5]]
usable = [True, False]
