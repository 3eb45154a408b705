# %% wrong: the line that carries the mistake on
wrong_line = 5
corrected_line = "d2 + phi*(d1 - d2) + phi*g1 + (1 - phi)*g2"
sets = [[0, 0], [0, 1], [0, 2]], [[0, 3], [90, 3], [90, 4]], [[90, 0], [90, 1], [90, 2]]

# %% wrong: the line above once more
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + phi*g1 + (1 - phi)*g2"
sets = [[0, 0], [0, 1], [0, 2]], [[0, 3], [90, 3], [90, 4]], [[90, 0], [90, 1], [90, 2]]

# %% wrong: the missing term has the wrong sign
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g2 - g1)"
sets = [[0, 0], [0, 1], [0, 2]], [[0, 3], [90, 3], [90, 4]], [[90, 0], [90, 1], [90, 2]]

# %% wrong: half of the missing term
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + phi*g1"
sets = [[0, 0], [0, 1], [0, 2]], [[0, 3], [90, 3], [90, 4]], [[90, 0], [90, 1], [90, 2]]

# %% wrong: expanding is suspected
wrong_line = 2
corrected_line = "phi*d1 + phi*g1 + d2 + g2 - phi*d2 - phi*g2"
sets = [[0, 0], [0, 1], [0, 2]], [[0, 3], [90, 3], [90, 4]], [[90, 0], [90, 1], [90, 2]]

# %% wrong: the number only
wrong_line = 4
corrected_line = ...
sets = [[0, 0], [0, 1], [0, 2]], [[0, 3], [90, 3], [90, 4]], [[90, 0], [90, 1], [90, 2]]

# %% wrong: names with brackets
wrong_line = 4
corrected_line = "phi*d[1] + (1 - phi)*d[2] + phi*g[1] + (1 - phi)*g[2]"
sets = [[0, 0], [0, 1], [0, 2]], [[0, 3], [90, 3], [90, 4]], [[90, 0], [90, 1], [90, 2]]

# %% wrong: the sets of the lecture, of one and two points
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g1 - g2)"
sets = [[0, 0]], [[0, 0], [1, 0]], [[1, 0]]

# %% wrong: the sets of the lecture, points repeated
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g1 - g2)"
sets = [[0, 0], [0, 0], [0, 0]], [[0, 0], [1, 0], [1, 0]], [[1, 0], [1, 0], [1, 0]]

# %% wrong: Q lies halfway
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g1 - g2)"
sets = [[0, 0], [0, 1], [0, 2]], [[5, 0], [5, 1], [5, 2]], [[10, 0], [10, 1], [10, 2]]

# %% wrong: the set in two camps is P
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g1 - g2)"
sets = [[0, 3], [90, 3], [90, 4]], [[0, 0], [0, 1], [0, 2]], [[90, 0], [90, 1], [90, 2]]

# %% wrong: R is far away
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g1 - g2)"
sets = [[0, 0], [1, 0], [2, 0]], [[0, 1], [1, 1], [2, 1]], [[1000, 0], [1001, 0], [1002, 0]]

# %% wrong: no sets
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g1 - g2)"
sets = ...

# %% wrong: points on a line as numbers
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g1 - g2)"
sets = [0, 1, 2], [3, 90, 91], [92, 93, 94]

# %% wrong: two sets
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g1 - g2)"
sets = [[0, 0], [0, 1], [0, 2]], [[90, 0], [90, 1], [90, 2]]

# %% right: shares of Q taken off, sets on a line
wrong_line = 4
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + phi*(g1 - g2) - (g1 - g2)/2"
sets = [[0, 0], [1, 0], [2, 0]], [[3, 0], [96, 0], [97, 0]], [[98, 0], [99, 0], [100, 0]]

# %% right: without the plain mean, arrays, small and askew
wrong_line = 4
corrected_line = "phi*d1 + d2 - phi*d2 + phi*g1 + g2 - phi*g2"
X = np.array([[0, 0], [0.1, 0], [0, 0.1]])
sets = (X, np.array([[-0.1, 0], [5.9, 6], [6, 5.9]]), X + 6)
