# %% wrong: ties broken, the true ones first
points = [(1/5, 1), (2/5, 1), (2/5, 2/3), (3/5, 3/4), (4/5, 4/5), (4/5, 4/6), (1, 5/7), (1, 5/8), (1, 5/9), (1, 5/10)]
average_precision = (1 + 1 + 3/4 + 4/5 + 5/7) / 5
full = 2 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: recall at full precision inside a tie
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.76
full = 2 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: pairs of precision and recall
points = [(1, 1/5), (2/3, 2/5), (4/5, 4/5), (4/6, 4/5), (5/9, 1), (5/10, 1)]
average_precision = 0.76
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: lowest threshold first
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)][::-1]
average_precision = 0.76
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: the ROC curve
points = [(0, 1/5), (1/5, 2/5), (1/5, 4/5), (2/5, 4/5), (4/5, 1), (1, 1)]
average_precision = 0.76
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: one by one in the average, of a tie the false ones first
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = (1 + 2/3 + 3/4 + 4/5 + 5/9) / 5
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: one by one in the average, of a tie the true ones first
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.85
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: the trapezoidal rule
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.78
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: interpolated
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 1/5 + 3/5 * 4/5 + 1/5 * 5/9
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: eleven levels of recall
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = (3 * 1 + 6 * 4/5 + 2 * 5/9) / 11
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: the mean of all precisions
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = np.mean([1, 2/3, 4/5, 4/6, 5/9, 5/10])
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: the threshold instead of the recall
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 0.9
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: recall as a share of all candidates
points = [(1/10, 1), (2/10, 2/3), (4/10, 4/5), (4/10, 4/6), (5/10, 5/9), (5/10, 5/10)]
average_precision = 0.764
full = 1 / 10
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: the last point is left out, since everything is accepted there
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: one digit
points = [(1/5, 1), (2/5, 0.7), (4/5, 0.8), (4/5, 0.7), (1, 0.6), (1, 0.5)]
average_precision = 0.8
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: percent
points = [(20, 100), (40, 67), (80, 80), (80, 67), (100, 56), (100, 50)]
average_precision = 76
full = 20
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: per candidate, not per false candidate
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/p"

# %% wrong: precision is taken for specificity
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "1 - p"

# %% wrong: the odds of p upside down
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*b*p/((1 - p)*(1 - b))"

# %% wrong: the specificity
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "1 - r*b*(1 - p)/(p*(1 - b))"

# %% wrong: an equation that is not solved
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "p == r*b/(r*b + f*(1 - b))"

# %% wrong: base rates are left out
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*(1 - p)/p"

# %% wrong: a number instead of a formula
points = [(1/5, 1), (2/5, 2/3), (4/5, 4/5), (4/5, 4/6), (1, 5/9), (1, 5/10)]
average_precision = 0.764
full = 1 / 5
false_positive_rate = 0.001

# %% wrong: two lists instead of pairs
points = [[1/5, 2/5, 4/5, 4/5, 1, 1], [1, 2/3, 4/5, 4/6, 5/9, 5/10]]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: strings
points = ["(1/5, 1)", "(2/5, 2/3)", "(4/5, 4/5)", "(4/5, 4/6)", "(1, 5/9)", "(1, 5/10)"]
average_precision = 0.764
full = 1 / 5
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% wrong: the counts
points = [(1, 0), (2, 1), (4, 1), (4, 2), (5, 4), (5, 5)]
average_precision = 0.764
full = 1
false_positive_rate = "r*b*(1 - p)/(p*(1 - b))"

# %% right: two decimals
points = [(0.20, 1.00), (0.40, 0.67), (0.80, 0.80), (0.80, 0.67), (1.00, 0.56), (1.00, 0.50)]
average_precision = 0.76
full = 0.20
false_positive_rate = "b*r*(1-p)/((1-b)*p)"

# %% right: arrays, from the library
curve = am.precision_recall(labels, scores)
points = np.column_stack([curve.recall, curve.precision])
average_precision = curve.average_precision
full = np.float64(curve.recall_at_full_precision)
false_positive_rate = "(b/(1 - b))*((1 - p)/p)*r"

# %% right: fractions, and a formula of SymPy
import sympy as sp

from fractions import Fraction as F
points = [(F(1, 5), 1), (F(2, 5), F(2, 3)), (F(4, 5), F(4, 5)), (F(4, 5), F(2, 3)), (1, F(5, 9)), (1, F(1, 2))]
average_precision = F(1, 5) + F(1, 5) * F(2, 3) + F(2, 5) * F(4, 5) + F(1, 5) * F(5, 9)
full = F(1, 5)
b, f, p, r = sp.symbols("b f p r")
false_positive_rate = sp.solve(sp.Eq(p, r * b / (r * b + f * (1 - b))), f)[0]

# %% right: lists, and the point where the curve is often begun
points = [[0, 1], [0.2, 1], [0.4, 2/3], [0.8, 0.8], [0.8, 2/3], [1, 5/9], [1, 0.5]]
average_precision = 0.764
full = 0.2
false_positive_rate = "r*b/(1 - b)*(1/p - 1)"

# %% right: SymPy numbers in a tuple
import sympy as sp

R = sp.Rational
points = ((R(1, 5), 1), (R(2, 5), R(2, 3)), (R(4, 5), R(4, 5)), (R(4, 5), R(2, 3)), (1, R(5, 9)), (1, R(1, 2)))
average_precision = R(1, 5) * (1 + R(2, 3) + 2 * R(4, 5) + R(5, 9))
full = R(1, 5)
false_positive_rate = "(r*b/p - r*b)/(1 - b)"

# %% right: computed from the counts
points = [(tp / 5, tp / n) for tp, n in ((1, 1), (2, 3), (4, 5), (4, 6), (5, 9), (5, 10))]
average_precision = sum(d * q for d, q in zip((0.2, 0.2, 0.4, 0.2), (1, 2/3, 4/5, 5/9)))
full = 0.2
false_positive_rate = "-r*b*(p - 1)/(p - p*b)"

# %% right: a matrix of SymPy
import sympy as sp

points = sp.Matrix([[0.2, 1], [0.4, 0.67], [0.8, 0.8], [0.8, 0.67], [1, 0.56], [1, 0.5]])
average_precision = 0.76
full = 0.2
b, p, r = sp.symbols("b p r", positive=True)
false_positive_rate = r * b * (1 - p) / (p * (1 - b))
