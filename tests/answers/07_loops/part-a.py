# %% wrong: ties broken, the right ones first
points = [(1/5, 1), (2/5, 1), (2/5, 2/3), (3/5, 3/4), (4/5, 4/5), (4/5, 4/6), (1, 5/7), (1, 5/8), (1, 5/9), (1, 5/10)]
average_precision = (1 + 1 + 3/4 + 4/5 + 5/7) / 5
full = 2 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: recall at full precision inside a tie
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 2 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: pairs of precision and recall
points = [(1, 1/5), (2/3, 2/5), (4/5, 4/5), (4/6, 4/5), (5/9, 1), (5/10, 1)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: lowest threshold first
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)][::-1]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: the ROC curve
points = [(0, 1/5), (1/5, 2/5), (1/5, 4/5), (2/5, 4/5), (4/5, 1), (1, 1)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: one by one in the average, of a tie the false ones first
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = (1 + 2/3 + 3/4 + 4/5 + 5/9) / 5
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: one by one in the average, of a tie the right ones first
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.85
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: the trapezoidal rule
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.78
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: interpolated
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 1/5 + 3/5 * 4/5 + 1/5 * 5/9
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: eleven levels of recall
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = (3 * 1 + 6 * 4/5 + 2 * 5/9) / 11
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: the mean of all precisions
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = np.mean([1, 2/3, 4/5, 4/6, 5/9, 5/10])
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: the threshold instead of the recall
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 0.9
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: recall as a share of all candidates
points = [(1/10, 1), (2/10, 2/3), (4/10, 4/5), (4/10, 4/6), (5/10, 5/9), (5/10, 5/10)]
average_precision = 0.764
full = 1 / 10
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: the last point is left out, since everything is accepted there
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: one digit
points = [(1/5, 1), (2/5, 0.7), (4/5, 0.8), (4/5, 0.7), (1, 0.6), (1, 0.5)]
average_precision = 0.8
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: percent
points = [(20, 100), (40, 67), (80, 80), (80, 67), (100, 56), (100, 50)]
average_precision = 76
full = 20
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: per candidate, not per false candidate
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/P"

# %% wrong: precision is taken for specificity
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "1 - P"

# %% wrong: the odds of P upside down
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*beta*P/((1 - P)*(1 - beta))"

# %% wrong: the specificity
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "1 - r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: an equation that is not solved
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "P == r*beta/(r*beta + f*(1 - beta))"

# %% wrong: base rates are left out
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*(1 - P)/P"

# %% wrong: a number instead of a formula
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = 0.001

# %% wrong: two lists instead of pairs
points = [[1/5, 2/5, 4/5, 4/5, 1, 1], [1, 2/3, 4/5, 4/6, 5/9, 5/10]]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: strings
points = ["(1/5, 1)", "(2/5, 2/3)", "(4/5, 4/5)", "(4/5, 4/6)", "(1, 5/9)", "(1, 5/10)"]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: the counts
points = [(1, 0), (2, 1), (4, 1), (4, 2), (5, 4), (5, 5)]
average_precision = 0.764
full = 1
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: no signs between factors
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r beta (1 - P)/(P (1 - beta))"

# %% wrong: other letters than those of the question
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: recall instead of its increase
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 1/5*1 + 2/5*2/3 + 4/5*4/5 + 4/5*4/6 + 5/9 + 5/10
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: the increases are not weighted
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = (1 + 2/3 + 4/5 + 5/9) / 4
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: the precision at the lowest threshold
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 2
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: solved for the recall
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "P*(1 - beta)/(beta*(1 - P))"

# %% wrong: the increases are not weighted, two decimals
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.76
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

# %% wrong: two decimals
points = [(0.2, 1), (0.4, 0.67), (0.8, 0.8), (0.8, 0.67), (1, 0.56), (1, 0.5)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*beta*(1 - P)/(P*(1 - beta))"

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
