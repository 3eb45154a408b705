# %% wrong: solved with the transpose of L
z = (2 / 2 - 7 / 6, 7 / 3)
epsilon = (2 / 2 - 7 / 6) ** 2 + (7 / 3) ** 2
expected = 46 / 9

# %% wrong: multiplied by L
z = (4, 23)
epsilon = 5
expected = 46 / 9

# %% wrong: each component by its own standard deviation
z = (1, 7 / 10**0.5)
epsilon = 5
expected = 46 / 9

# %% wrong: the root of the NEES
z = (1, 2)
epsilon = 5**0.5
expected = 46 / 9

# %% wrong: P is not inverted
z = (1, 2)
epsilon = 2 * (4 * 2 + 2 * 7) + 7 * (2 * 2 + 10 * 7)
expected = 46 / 9

# %% wrong: no bias
z = (1, 2)
epsilon = 5
expected = 112 / 36

# %% wrong: expects what an honest filter has
z = (1, 2)
epsilon = 5
expected = 2

# %% wrong: claim and truth are swapped
z = (1, 2)
epsilon = 5
expected = 4 / 4 + 10 / 18 + 4 / 4 + 4 / 18

# %% wrong: the bias with its length instead of its square
z = (1, 2)
epsilon = 5
expected = 28 / 9 + 2**0.5

# %% wrong: the bias is not whitened
z = (1, 2)
epsilon = 5
expected = 28 / 9 + 8

# %% wrong: the bias divided by the diagonal of L
z = (1, 2)
epsilon = 5
expected = 28 / 9 + 1 + 4 / 9

# %% wrong: the NEES without the correlation
z = (1, 2)
epsilon = 4 / 4 + 49 / 10
expected = 46 / 9

# %% wrong: a lower triangle with a slip
z = (1, 1.25)
epsilon = 1 + 1.25**2
expected = 46 / 9

# %% wrong: one part is missing
z = (1, 2)
epsilon = 5
expected = ...

# %% wrong: text
z = "1, 2"
epsilon = 5
expected = 46 / 9

# %% wrong: three components
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
