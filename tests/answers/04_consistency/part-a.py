# %% wrong: solved with the transpose of L
# says: you solved with the transpose of L
z = (2 / 2 - 7 / 6, 7 / 3)
epsilon = (2 / 2 - 7 / 6) ** 2 + (7 / 3) ** 2
expected = 46 / 9

# %% wrong: multiplied by L
# says: you multiplied by L
z = (4, 23)
epsilon = 5
expected = 46 / 9

# %% wrong: each component by its own standard deviation
# says: you left the correlation out
z = (1, 7 / 10**0.5)
epsilon = 5
expected = 46 / 9

# %% wrong: the root of the NEES
# says: this is the length of z, not its square
epsilon = 5**0.5
expected = 46 / 9

# %% wrong: P is not inverted
# says: P is not inverted
epsilon = 2 * (4 * 2 + 2 * 7) + 7 * (2 * 2 + 10 * 7)
expected = 46 / 9

# %% wrong: no bias
# says: the bias is left out
epsilon = 5
expected = 112 / 36

# %% wrong: expects what an honest filter has
# says: this is the share of the bias, or what an honest filter has
epsilon = 5
expected = 2

# %% wrong: claim and truth are swapped
# says: claim and truth are swapped
epsilon = 5
expected = 4 / 4 + 10 / 18 + 4 / 4 + 4 / 18

# %% wrong: the bias with its length instead of its square
# says: the bias counts with its length, not its square
epsilon = 5
expected = 28 / 9 + 2**0.5

# %% wrong: the bias is not whitened
# says: the bias is not whitened
epsilon = 5
expected = 28 / 9 + 8

# %% wrong: the bias divided by the diagonal of L
# says: the bias is divided by the diagonal of L
epsilon = 5
expected = 28 / 9 + 1 + 4 / 9

# %% wrong: the NEES without the correlation
# says: you left the correlation out
epsilon = 4 / 4 + 49 / 10
expected = 46 / 9

# %% wrong: a lower triangle with a slip
# says: z: (1, 1.25) is not right.
z = (1, 1.25)
epsilon = 1 + 1.25**2
expected = 46 / 9

# %% wrong: one part is missing
# says: expected: there is no answer yet. Replace the dots.
epsilon = 5
expected = ...

# %% wrong: text
# says: z: numbers are asked, you have '1, 2'.
z = "1, 2"
epsilon = 5
expected = 46 / 9

# %% wrong: three components
# says: z: shape (2,) is asked, you have (1, 2, 0).
z = (1, 2, 0)
epsilon = 5
expected = 46 / 9

# %% right: by machine
z = np.linalg.solve([[2, 0], [1, 3]], [2, 7])
epsilon = z @ z
expected = np.trace(np.linalg.solve([[4, 2], [2, 10]], np.diag([4, 18]))) + 2

# %% right: fractions
z = [1, 2]
epsilon = 5
expected = 28 / 9 + 2

# %% right: two decimals
z = (1.0, 2.0)
epsilon = 5
expected = 5.11

# %% right: an array, and whitening by machine
L = np.linalg.cholesky([[4, 2], [2, 10]])
z = np.linalg.solve(L, [2, 7])
epsilon = np.sum(z**2)
whitened_bias = np.linalg.solve(L, [2, -2])
half = np.linalg.solve(L, np.diag([2, 18**0.5]))
expected = np.sum(half**2) + whitened_bias @ whitened_bias

# %% wrong: one decimal
# says: you rounded to one decimal, and two are asked
expected = 5.1

# %% wrong: the bias is taken off
# says: the bias is taken off
expected = 28 / 9 - 2

# %% wrong: the bias alone
# says: this is the share of the bias, or what an honest filter has
expected = 1 + 1.0

# %% wrong: solved with P
# says: you solved with P, not with L
z = np.linalg.solve([[4, 2], [2, 10]], [2, 7])

# %% wrong: the whitened components in the wrong order
# says: the components are swapped
z = (2, 1)

# %% wrong: divided by n
# says: you divided by the number of components
epsilon = 2.5

# %% wrong: the bias divided by the diagonal of L, not squared
# says: the bias is divided by the diagonal of L, and not squared
expected = 28 / 9 + 1 + 2 / 3

# %% wrong: the bias over its variances
# says: the bias is divided by the variances alone
expected = 28 / 9 + 4 / 4 + 4 / 10

# %% right: SymPy
import sympy as sp

factor = sp.Matrix([[4, 2], [2, 10]]).cholesky()
white = factor.inv() * sp.Matrix([2, 7])
z = tuple(white)
epsilon = (white.T * white)[0]
expected = sp.Rational(46, 9)

# %% right: a column, and letters of other parts
P, e, S, nu = 1, 2, 3, 4
robot = None
z = np.array([[1.0], [2.0]])
