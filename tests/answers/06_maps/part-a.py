# %% wrong: a cell at the threshold is called free
rates = (1 / 2, 1 / 4, 1 / 3, 1 / 5)
distances = (6.5, 12)
base_rate = "f/(r + f)"

# %% wrong: precision and recall are swapped
rates = (1 / 2, 2 / 3, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "f/(r + f)"

# %% wrong: F1 is the plain average
rates = (2 / 3, 1 / 2, 7 / 12, 2 / 5)
distances = (6.5, 12)
base_rate = "f/(r + f)"

# %% wrong: IoU counts the free cells as well
rates = (2 / 3, 1 / 2, 4 / 7, 5 / 8)
distances = (6.5, 12)
base_rate = "f/(r + f)"

# %% wrong: the counts
rates = (2, 1, 2, 3)
distances = (6.5, 12)
base_rate = "f/(r + f)"

# %% wrong: squared Chamfer
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (9 / 2 + 153 / 3, 12)
base_rate = "f/(r + f)"

# %% wrong: mean of the two directions
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (3.25, 12)
base_rate = "f/(r + f)"

# %% wrong: one direction only
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (1.5, 3)
base_rate = "f/(r + f)"

# %% wrong: Hausdorff from the reference only
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 3)
base_rate = "f/(r + f)"

# %% wrong: all five points at once
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (18 / 5, 12)
base_rate = "f/(r + f)"

# %% wrong: the rates are swapped
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "r/(r + f)"

# %% wrong: odds instead of a share
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "f/r"

# %% wrong: a balanced map
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "1/2"

# %% wrong: the precision itself, with the base rate on both sides
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "b*r/(b*r + (1 - b)*f)"

# %% wrong: one part is missing
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = ...
base_rate = "f/(r + f)"

# %% wrong: Chamfer from the reference only
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (1.5, 12)
base_rate = "f/(r + f)"

# %% wrong: Chamfer from the estimate only
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (5, 12)
base_rate = "f/(r + f)"

# %% wrong: sums instead of means
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (18, 12)
base_rate = "f/(r + f)"

# %% wrong: an equation instead of a formula
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "b = f/(r + f)"

# %% right: by machine
map_ = am.confusion(occupied, probability)
rates = [map_.precision, map_.recall, map_.f1, map_.iou]
distances = (float(am.chamfer(P, Q)), float(am.hausdorff(P, Q)))
base_rate = "1/(1 + r/f)"

# %% right: rounded decimals
rates = (0.667, 0.5, 0.571, 0.4)
distances = [6.5, 12]
base_rate = "1 - r/(f + r)"

# %% right: the given names overwritten
P, Q, occupied, probability = 1, 2, 3, 4
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "f/(r + f)"
