# %% wrong: ties broken, the right ones first
# says: you accepted candidates one by one
points = [(1/5, 1), (2/5, 1), (2/5, 2/3), (3/5, 3/4), (4/5, 4/5), (4/5, 4/6), (1, 5/7), (1, 5/8), (1, 5/9), (1, 5/10)]
average_precision = (1 + 1 + 3/4 + 4/5 + 5/7) / 5
full = 2 / 5

# %% wrong: recall at full precision inside a tie
# says: you broke a tie, the right one first
average_precision = 0.764
full = 2 / 5

# %% wrong: pairs of precision and recall
# says: each pair is turned around
points = [(1, 1/5), (2/3, 2/5), (4/5, 4/5), (4/6, 4/5), (5/9, 1), (5/10, 1)]
average_precision = 0.764

# %% wrong: lowest threshold first
# says: the lowest score is first
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)][::-1]
average_precision = 0.764

# %% wrong: the ROC curve
# says: this is the ROC curve
points = [(0, 1/5), (1/5, 2/5), (1/5, 4/5), (2/5, 4/5), (4/5, 1), (1, 1)]
average_precision = 0.764

# %% wrong: one by one in the average, of a tie the false ones first
# says: you accepted one by one, of a tie the false ones first
average_precision = (1 + 2/3 + 3/4 + 4/5 + 5/9) / 5

# %% wrong: one by one in the average, of a tie the right ones first
# says: you accepted one by one, of a tie the right ones first
average_precision = 0.853

# %% wrong: the trapezoidal rule
# says: this is the area under straight lines
average_precision = 0.782

# %% wrong: interpolated
# says: you interpolated: the best precision at this recall or more
average_precision = 1/5 + 3/5 * 4/5 + 1/5 * 5/9

# %% wrong: eleven levels of recall
# says: this is the average over eleven levels of recall
average_precision = (3 * 1 + 6 * 4/5 + 2 * 5/9) / 11

# %% wrong: the mean of all precisions
# says: you averaged the precisions of all points
average_precision = np.mean([1, 2/3, 4/5, 4/6, 5/9, 5/10])

# %% wrong: the threshold instead of the recall
# says: this is the threshold
average_precision = 0.764
full = 0.9

# %% wrong: recall as a share of all candidates
# says: recall is the share of all candidates
points = [(1/10, 1), (2/10, 2/3), (4/10, 4/5), (4/10, 4/6), (5/10, 5/9), (5/10, 5/10)]
average_precision = 0.764
full = 1 / 10

# %% wrong: the last point is left out, since everything is accepted there
# says: you left out that all are accepted
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9)]
average_precision = 0.764

# %% wrong: one digit
# says: you rounded to one decimal
points = [(1/5, 1), (2/5, 0.7), (4/5, 0.8), (4/5, 0.7), (1, 0.6), (1, 0.5)]
average_precision = 0.8

# %% wrong: percent
# says: you give percent
points = [(20, 100), (40, 67), (80, 80), (80, 67), (100, 56), (100, 50)]
average_precision = 76
full = 20

# %% wrong: per candidate, not per false candidate
# says: the false candidates are taken for all
average_precision = 0.764
false_positive_rate = "r*beta*(1 - P)/P"

# %% wrong: precision is taken for specificity
# says: precision and specificity are taken for one
average_precision = 0.764
false_positive_rate = "1 - P"

# %% wrong: the odds of P upside down
# says: P and 1 - P are swapped
average_precision = 0.764
false_positive_rate = "r*beta*P/((1 - P)*(1 - beta))"

# %% wrong: the specificity
# says: this is the specificity
average_precision = 0.764
false_positive_rate = "1 - r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: an equation that is not solved
# says: false_positive_rate is unreadable: f is not declared. This part knows the names beta, P, r
average_precision = 0.764
false_positive_rate = "P == r*beta/(r*beta + f*(1 - beta))"

# %% wrong: base rates are left out
# says: beta and 1 - beta count the same
average_precision = 0.764
false_positive_rate = "r*(1 - P)/P"

# %% wrong: a number instead of a formula
# says: false_positive_rate: a string is asked, you have 0.001.
average_precision = 0.764
false_positive_rate = 0.001

# %% wrong: two lists instead of pairs
# says: points: pairs of numbers (recall, precision) are asked, in a list.
points = [[1/5, 2/5, 4/5, 4/5, 1, 1], [1, 2/3, 4/5, 4/6, 5/9, 5/10]]
average_precision = 0.764

# %% wrong: strings
# says: points: pairs of numbers (recall, precision) are asked, in a list.
points = ["(1/5, 1)", "(2/5, 2/3)", "(4/5, 4/5)", "(4/5, 4/6)", "(1, 5/9)", "(1, 5/10)"]
average_precision = 0.764

# %% wrong: the counts
# says: these are numbers of right and false ones
points = [(1, 0), (2, 1), (4, 1), (4, 2), (5, 4), (5, 5)]
average_precision = 0.764
full = 1

# %% wrong: no signs between factors
# says: false_positive_rate is unreadable: cannot be read: invalid syntax. Write * between factors
average_precision = 0.764
false_positive_rate = "r beta (1 - P)/(P (1 - beta))"

# %% wrong: other letters than those of the question
# says: false_positive_rate is unreadable: b is not declared. This part knows the names beta, P, r
average_precision = 0.764
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: recall instead of its increase
# says: you took recall itself, not its increase
average_precision = 1/5*1 + 2/5*2/3 + 4/5*4/5 + 4/5*4/6 + 5/9 + 5/10

# %% wrong: the increases are not weighted
# says: you averaged the precisions where recall increases
average_precision = (1 + 2/3 + 4/5 + 5/9) / 4

# %% wrong: the precision at the lowest threshold
# says: this is the precision at the lowest score
average_precision = 0.764
full = 1 / 2

# %% wrong: solved for the recall
# says: this is the recall divided by the rate
average_precision = 0.764
false_positive_rate = "P*(1 - beta)/(beta*(1 - P))"

# %% wrong: the increases are not weighted, two decimals
# says: you rounded to two decimals
average_precision = 0.76

# %% wrong: two decimals
# says: you rounded to two decimals
points = [(0.2, 1), (0.4, 0.67), (0.8, 0.8), (0.8, 0.67), (1, 0.56), (1, 0.5)]
average_precision = 0.764

# %% right: three decimals
points = [(0.200, 1.000), (0.400, 0.667), (0.800, 0.800), (0.800, 0.667), (1.000, 0.556), (1.000, 0.500)]
average_precision = 0.764
full = 0.20
false_positive_rate = "beta*r*(1-P)/((1-beta)*P)"

# %% right: arrays, from the library
curve = am.precision_recall(labels, scores)
points = np.column_stack([curve.recall, curve.precision])
average_precision = curve.average_precision
full = np.float64(curve.recall_at_full_precision)
false_positive_rate = "(beta/(1 - beta))*((1 - P)/P)*r"

# %% right: fractions, and a formula of SymPy
import sympy as sp

from fractions import Fraction as F
points = [(F(1, 5), 1), (F(2, 5), F(2, 3)), (F(4, 5), F(4, 5)), (F(4, 5), F(2, 3)), (1, F(5, 9)), (1, F(1, 2))]
average_precision = F(1, 5) + F(1, 5) * F(2, 3) + F(2, 5) * F(4, 5) + F(1, 5) * F(5, 9)
full = F(1, 5)
beta, f, P, r = sp.symbols("beta f P r")
false_positive_rate = sp.solve(sp.Eq(P, r * beta / (r * beta + f * (1 - beta))), f)[0]

# %% right: lists, and the point where the curve is often begun
points = [[0, 1], [0.2, 1], [0.4, 2/3], [0.8, 0.8], [0.8, 2/3], [1, 5/9], [1, 0.5]]
average_precision = 0.764
full = 0.2
false_positive_rate = "r*beta/(1 - beta)*(1/P - 1)"

# %% right: SymPy numbers in a tuple
import sympy as sp

R = sp.Rational
points = ((R(1, 5), 1), (R(2, 5), R(2, 3)), (R(4, 5), R(4, 5)), (R(4, 5), R(2, 3)), (1, R(5, 9)), (1, R(1, 2)))
average_precision = R(1, 5) * (1 + R(2, 3) + 2 * R(4, 5) + R(5, 9))
full = R(1, 5)
false_positive_rate = "(r*beta/P - r*beta)/(1 - beta)"

# %% right: computed from the counts
points = [(tp / 5, tp / n) for tp, n in ((1, 1), (2, 3), (4, 5), (4, 6), (5, 9), (5, 10))]
average_precision = sum(d * q for d, q in zip((0.2, 0.2, 0.4, 0.2), (1, 2/3, 4/5, 5/9)))
full = 0.2
false_positive_rate = "-r*beta*(P - 1)/(P - P*beta)"

# %% right: a matrix of SymPy
import sympy as sp

points = sp.Matrix([[0.2, 1], [0.4, 0.667], [0.8, 0.8], [0.8, 0.667], [1, 0.556], [1, 0.5]])
average_precision = 0.764
full = 0.2
beta, P, r = sp.symbols("beta P r", positive=True)
false_positive_rate = r * beta * (1 - P) / (P * (1 - beta))

# %% right: SymPy and arrays
points = np.array([[0.2, 1], [0.4, 0.667], [0.8, 0.8], [0.8, 0.667], [1, 0.556], [1, 0.5]])
average_precision = sp.Rational(1, 5) + sp.Rational(2, 15) + sp.Rational(8, 25) + sp.Rational(1, 9)
full = "0.2" and 0.2
false_positive_rate = sp.Symbol("r") * sp.Symbol("beta") / (1 - sp.Symbol("beta")) * (1 / sp.Symbol("P") - 1)

# %% right: with the start of the plot, other order of factors
from math import *
points = [(0, 1), (0.2, 1.0), [0.4, 2 / 3], (0.8, 0.8), (0.8, 2 / 3), (1.0, 0.5556), (1, 0.5)]
false_positive_rate = "beta/(1-beta)*r*(1-P)/P"

# %% wrong: accepted above the threshold
# says: you left out that all are accepted
points = [(0, 1), (1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9)]

# %% wrong: beta for r
# says: the recall is left out
false_positive_rate = "beta*(1-P)/(P*(1-beta))"
