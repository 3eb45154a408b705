# %% wrong: a cell at the threshold is called free
# says: a cell at 0.5 is called free
rates = (1 / 2, 1 / 4, 1 / 3, 1 / 5)
distances = (6.5, 12)

# %% wrong: precision and recall are swapped
# says: precision and recall are swapped
rates = (1 / 2, 2 / 3, 4 / 7, 2 / 5)
distances = (6.5, 12)

# %% wrong: F1 is the plain average
# says: F1 is the plain average of the two
rates = (2 / 3, 1 / 2, 7 / 12, 2 / 5)
distances = (6.5, 12)

# %% wrong: IoU counts the free cells as well
# says: IoU is accuracy, which counts the free cells as well
rates = (2 / 3, 1 / 2, 4 / 7, 5 / 8)
distances = (6.5, 12)

# %% wrong: the counts
# says: you give counts, and rates are asked
rates = (2, 1, 2, 3)
distances = (6.5, 12)

# %% wrong: squared Chamfer
# says: for Chamfer you squared the distances
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (9 / 2 + 153 / 3, 12)

# %% wrong: mean of the two directions
# says: for Chamfer you halved the sum of the two directions
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (3.25, 12)

# %% wrong: one direction only
# says: for Chamfer you looked from P only
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (1.5, 3)

# %% wrong: Hausdorff from the reference only
# says: for Hausdorff you looked from P only
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 3)

# %% wrong: all five points at once
# says: for Chamfer you averaged all five points at once
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (18 / 5, 12)

# %% wrong: the rates are swapped
# says: the two rates are swapped, or you give the share of free cells
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "r/(r + f)"

# %% wrong: odds instead of a share
# says: this is odds, occupied to free, not a share
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "f/r"

# %% wrong: a balanced map
# says: you take as many occupied cells as free ones
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "1/2"

# %% wrong: the precision itself, with the base rate on both sides
# says: base_rate: b stands in your formula, and it is what is asked. Solve for it.
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (6.5, 12)
base_rate = "b*r/(b*r + (1 - b)*f)"

# %% wrong: one part is missing
# says: distances: there is no answer yet. Replace the dots.
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = ...

# %% wrong: Chamfer from the reference only
# says: for Chamfer you looked from P only
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (1.5, 12)

# %% wrong: Chamfer from the estimate only
# says: for Chamfer you looked from Q only
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (5, 12)

# %% wrong: sums instead of means
# says: for Chamfer you added up, and each direction is a mean
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 5)
distances = (18, 12)

# %% wrong: an equation instead of a formula
# says: base_rate: b stands in your formula, and it is what is asked. Solve for it.
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

# %% wrong: F1 is the geometric mean
# says: F1 is their geometric mean
rates = (2 / 3, 1 / 2, (1 / 3) ** 0.5, 2 / 5)

# %% wrong: IoU is F1
# says: the last rate, IoU, is F1
rates = (2 / 3, 1 / 2, 4 / 7, 4 / 7)

# %% wrong: F1 for IoU and IoU for F1
# says: the last rate, IoU, is F1
rates = (2 / 3, 1 / 2, 2 / 5, 4 / 7)

# %% wrong: the union counts the hits twice
# says: the union counts the hits twice
rates = (2 / 3, 1 / 2, 4 / 7, 2 / 7)

# %% wrong: false alarms over free cells for precision
# says: precision is the false-positive rate
rates = (1 / 4, 1 / 2, 4 / 7, 2 / 5)

# %% wrong: one decimal
# says: rates: two decimals are asked.
rates = (0.7, 0.5, 0.6, 0.4)

# %% wrong: percent
# says: you give percent
rates = (66.7, 50, 57.1, 40)

# %% wrong: rates of the free cells
# says: these are the rates of the free cells
rates = (3 / 5, 3 / 4, 2 / 3, 1 / 2)

# %% wrong: three of the four
# says: rates: a tuple of 4 results is asked, you have (0.666667, 0.5, 0.571429).
rates = (2 / 3, 1 / 2, 4 / 7)

# %% wrong: Chamfer with a root of the mean squares
# says: for Chamfer you squared the distances, and took a root at the end
distances = ((9 / 2 + 153 / 3) ** 0.5, 12)

# %% wrong: Chamfer and Hausdorff swapped
# says: Chamfer and Hausdorff are swapped
distances = (12, 6.5)

# %% wrong: both directions of Hausdorff added
# says: for Hausdorff you added the two directions
distances = (6.5, 15)

# %% wrong: the farthest pair
# says: for Hausdorff you took the farthest pair of all
distances = (6.5, 160**0.5)

# %% wrong: the mean over all pairs
# says: for Chamfer you averaged the distances of all pairs
distances = (cdist(P, Q).mean(), 12)

# %% wrong: specificity
# says: you take f for the specificity
base_rate = "(1 - f)/(r + 1 - f)"

# %% wrong: the difference
# says: base_rate: f/(r - f) is not right. At r = 1/2, f = 1/2 it makes r*base_rate/(r*base_rate +
base_rate = "f/(r - f)"

# %% wrong: a number
# says: you take as many occupied cells as free ones
base_rate = 0.5

# %% wrong: the text of a sentence
# says: base_rate is unreadable: cannot be read: invalid syntax. Write * between factors.
base_rate = "where hits equal false alarms"

# %% wrong: nothing but zeros
# says: rates: (0, 0, 0, 0) is not right.
rates, distances, base_rate = (0, 0, 0, 0), (0, 0), "0"

# %% right: arrays from the data
_o, _c = np.array(occupied) == 1, np.array(probability) >= 0.5
_tp, _fp, _fn = (_o & _c).sum(), (~_o & _c).sum(), (_o & ~_c).sum()
rates = np.array(
    [_tp / (_tp + _fp), _tp / (_tp + _fn), 2 * _tp / (2 * _tp + _fp + _fn), _tp / (_tp + _fp + _fn)]
)
_D = cdist(P, Q)
distances = np.array([_D.min(0).mean() + _D.min(1).mean(), max(_D.min(0).max(), _D.min(1).max())])
base_rate = "f/(f+r)"

# %% right: SymPy's numbers, the library's objects and a solved equation
rates = [sp.Rational(2, 3), sp.Rational(1, 2), sp.Rational(4, 7), sp.Rational(2, 5)]
distances = (am.chamfer(P, Q), am.hausdorff(P, Q))
_r, _f, _b = sp.symbols("r f b", positive=True)
base_rate = sp.solve(sp.Eq(_b * _r / (_b * _r + (1 - _b) * _f), sp.Rational(1, 2)), _b)

# %% right: two decimals and a power
rates = (0.67, 0.5, 0.57, 0.4)
base_rate = "(1 + r/f)**(-1)"

# %% right: fractions, other letters used up
from fractions import Fraction
from math import *

sum = r = f = u = v = 0
e = 3
rates = (Fraction(2, 3), Fraction(1, 2), Fraction(4, 7), Fraction(2, 5))

# %% wrong: MCC-like average of precision and IoU
# says: rates: (0.666667, 0.5, 0.55, 0.4) is not right.
rates = (2 / 3, 1 / 2, 0.55, 0.4)

# %% wrong: recall from all cells
# says: rates: (0.666667, 0.25, 0.571429, 0.4) is not right.
rates = (2 / 3, 1 / 4, 4 / 7, 2 / 5)

# %% wrong: truncated sloppily
# says: rates: (0.6, 0.5, 0.57, 0.4) is not right.
rates = (0.6, 0.5, 0.57, 0.4)

# %% wrong: Hausdorff mean
# says: for Hausdorff you took a mean
distances = (6.5, 5)

# %% wrong: base rate simplified wrongly
# says: the two rates are swapped, or you give the share of free cells
base_rate = "1/(1 + f/r)"

# %% wrong: r over f
# says: base_rate: r/f is not right. At r = 1/2, f = 1/2 it makes r*base_rate/(r*base_rate + f*(1 
base_rate = "r/f"

# %% wrong: empty
# says: rates: a tuple of 4 results is asked, you have [].
rates, distances, base_rate = [], [], ""

# %% wrong: nested
# says: rates: a tuple of 4 results is asked, you have ((0.666667, 0.5), (0.571429, 0.4)).
rates = ((2 / 3, 1 / 2), (4 / 7, 2 / 5))

# %% right: NumPy floats, text with spaces
rates = np.round([2 / 3, 1 / 2, 4 / 7, 2 / 5], 3).tolist()
distances = [np.float32(6.5), np.int64(12)]
base_rate = "  f / ( f + r )  "

# %% right: row vector
rates = np.array([[2 / 3, 1 / 2, 4 / 7, 2 / 5]])
distances = np.array([[6.5], [12]])
base_rate = "f*(r + f)**-1"
