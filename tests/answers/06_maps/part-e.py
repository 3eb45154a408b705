# %% wrong: the line that carries the mistake on
# says: the corrected line equals line 1, as it should. But line 5, which you blame, does follow f
wrong_line = 5
corrected_line = "d2 + phi*(d1 - d2) + phi*g1 + (1 - phi)*g2"

# %% wrong: the line above once more
# says: the corrected line: this is line 3 as it stands.
corrected_line = "phi*d1 + (1 - phi)*d2 + phi*g1 + (1 - phi)*g2"

# %% wrong: the missing term has the wrong sign
# says: the corrected line, compared with line 3: wrong: at phi = 1/4, d1 = 1, d2 = 1, g1 = 1, g2 
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + (phi - 1/2)*(g2 - g1)"

# %% wrong: half of the missing term
# says: the corrected line, compared with line 3: wrong: at phi = 1/2, d1 = 1, d2 = 1, g1 = 1, g2 
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + phi*g1"

# %% wrong: expanding is suspected
# says: the corrected line follows from line 1, but that is not all: line 2 was right as it stood.
wrong_line = 2
corrected_line = "phi*d1 + phi*g1 + d2 + g2 - phi*d2 - phi*g2"

# %% wrong: the number only
# says: the corrected line: there is no answer yet. Replace the dots.
corrected_line = ...

# %% wrong: names with brackets
# says: the corrected line, compared with line 3: unreadable: g is not declared. This part knows t
corrected_line = "phi*d[1] + (1 - phi)*d[2] + phi*g[1] + (1 - phi)*g[2]"

# %% wrong: the sets of the lecture, of one and two points
# says: sets, result 1: a tuple of 3 results is asked, you have [[0, 0]].
sets = [[0, 0]], [[0, 0], [1, 0]], [[1, 0]]

# %% wrong: the sets of the lecture, points repeated
# says: sets: nine different points are asked, no point twice.
sets = [[0, 0], [0, 0], [0, 0]], [[0, 0], [1, 0], [1, 0]], [[1, 0], [1, 0], [1, 0]]

# %% wrong: Q lies halfway
# says: you squared the distances
sets = [[0, 0], [0, 1], [0, 2]], [[5, 0], [5, 1], [5, 2]], [[10, 0], [10, 1], [10, 2]]

# %% wrong: the set in two camps is P
# says: you have the sets in another order: Q is the one between
sets = [[0, 3], [90, 3], [90, 4]], [[0, 0], [0, 1], [0, 2]], [[90, 0], [90, 1], [90, 2]]

# %% wrong: R is far away
# says: sets: 1998 m is not longer than 2 m + 1998 m.
sets = [[0, 0], [1, 0], [2, 0]], [[0, 1], [1, 1], [2, 1]], [[1000, 0], [1001, 0], [1002, 0]]

# %% wrong: no sets
# says: sets: there is no answer yet. Replace the dots.
sets = ...

# %% wrong: points on a line as numbers
# says: sets, result 1, result 1: a tuple of 2 results is asked, you have 0.
sets = [0, 1, 2], [3, 90, 91], [92, 93, 94]

# %% wrong: two sets
# says: sets: a tuple of 3 results is asked, you have [[[0, 0], [0, 1], [0, 2]], [[90, 0], [90, 1]
sets = [[0, 0], [0, 1], [0, 2]], [[90, 0], [90, 1], [90, 2]]

# %% right: shares of Q taken off, sets on a line
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + phi*(g1 - g2) - (g1 - g2)/2"
sets = [[0, 0], [1, 0], [2, 0]], [[3, 0], [96, 0], [97, 0]], [[98, 0], [99, 0], [100, 0]]

# %% right: without the plain mean, arrays, small and askew
corrected_line = "phi*d1 + d2 - phi*d2 + phi*g1 + g2 - phi*g2"
X = np.array([[0, 0], [0.1, 0], [0, 0.1]])
sets = (X, np.array([[-0.1, 0], [5.9, 6], [6, 5.9]]), X + 6)

# %% wrong: the term without its half
# says: the corrected line, compared with line 3: wrong: at phi = 1/2, d1 = 1, d2 = 1, g1 = 1, g2 
corrected_line = "phi*d1 + (1 - phi)*d2 + (g1 + g2)/2 + phi*(g1 - g2)"

# %% wrong: the third line blamed
# says: the corrected line follows from line 2, but that is not all: line 3 was right as it stood.
wrong_line = 3

# %% wrong: the blamed line is a word
# says: the number of the line: a whole number from 2 to 5 is asked, you have 'four'. The first li
wrong_line = "four"

# %% wrong: only the missing term
# says: the corrected line, compared with line 3: wrong: at phi = 1/2, d1 = 1, d2 = 1, g1 = 1, g2 
corrected_line = "(phi - 1/2)*(g1 - g2)"

# %% wrong: an equation
# says: the corrected line, compared with line 3: unreadable: write an equation as left == right, 
corrected_line = "J = phi*d1 + (1 - phi)*d2 + phi*g1 + g2 - phi*g2"

# %% wrong: longer by squares only
# says: you squared the distances
sets = [[0, 0], [0, 1], [0, 2]], [[4, 0], [4, 1], [4, 3]], [[9, 0], [9, 1], [9, 2]]

# %% wrong: longer one way only
# says: you averaged from the first set only
sets = [[0, 7], [0, 9], [0, 4]], [[8, 8], [1, 6], [9, 7]], [[7, 6], [6, 0], [4, 0]]

# %% wrong: points in space
# says: sets, result 1, result 1: a tuple of 2 results is asked, you have [0, 0, 0].
sets = (
    [[0, 0, 0], [0, 1, 0], [0, 2, 0]],
    [[0, 3, 0], [90, 3, 0], [90, 4, 0]],
    [[90, 0, 0], [90, 1, 0], [90, 2, 0]],
)

# %% wrong: a point that is nan
# says: sets: the coordinates have to be finite numbers.
sets = (
    [[0, 0], [0, 1], [0, np.nan]],
    [[0, 3], [90, 3], [90, 4]],
    [[90, 0], [90, 1], [90, 2]],
)

# %% right: a SymPy object
_v = sp.symbols("phi d1 d2 g1 g2")
corrected_line = _v[0] * _v[1] + (1 - _v[0]) * _v[2] + _v[0] * _v[3] + (1 - _v[0]) * _v[4]
sets = ([[0, 0], [0, 1], [0, 2]], [[0.1, 0], [0, 1.1], [100, 0.5]], [[100, 0], [100, 1], [100, 2]])

# %% right: the number as text, the line with its equals sign, sets by name
wrong_line = "4"
corrected_line = "= d1*phi + d2 - d2*phi + (g1 + g2)/2 + (2*phi - 1)*(g1 - g2)/2"
sets = {
    "P": [(0, 0), (0, 1), (0, 2)],
    "Q": [(0, 3), (1e4, 3), (1e4, 4)],
    "R": [(1e4, 0), (1e4, 1), (1e4, 2)],
}

# %% right: one array, letters used up
P = Q = R = phi = d1 = 0
sets = np.array(
    [[[0, 0], [0, 1], [0, 2]], [[0, 3], [90, 3], [90, 4]], [[90, 0], [90, 1], [90, 2]]]
)
wrong_line = np.int64(4)

# %% wrong: sets as text
# says: sets: a tuple of 3 results is asked, you have 'P, Q, R'.
sets = "P, Q, R"

# %% wrong: complex numbers
# says: sets, result 1, result 1: a tuple of 2 results is asked, you have 0j.
sets = [0, 1j, 2j], [3j, 90 + 3j, 90 + 4j], [90, 90 + 1j, 90 + 2j]

# %% wrong: the same as line 5 corrected
# says: the corrected line: this is line 5 as it stands.
corrected_line = "d2 + phi*(d1 - d2) + (g1 + g2)/2"

# %% wrong: both lines
# says: the number of the line: a whole number from 2 to 5 is asked, you have (4, 5). The first li
wrong_line = (4, 5)

# %% right: SymPy rationals in sets
sets = [[(sp.Integer(0), sp.Integer(k)) for k in range(3)], [(0, 3), (90, 3), (90, 4)], [(90, 0), (90, 1), (90, 2)]]

# %% right: factored differently
corrected_line = "phi*(d1 + g1) + (1 - phi)*(d2) + (1 - phi)*g2"
