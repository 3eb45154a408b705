# %% wrong: the line that carries the mistake on
# says: the corrected line equals line 1, as it should. But line 4, which you blame, does follow f
wrong_line = 4
corrected_line = "Trace(L.inv()*e*e.T*L.T.inv())"

# %% wrong: the right number, and the given line again
# says: the corrected line: this is line 3 as it stands.
corrected_line = "Trace(L.inv()*L.T.inv()*e*e.T)"

# %% wrong: the right number, with the inverse taken twice
# says: the corrected line, compared with line 2: wrong
corrected_line = "Trace(L.inv()*L.inv()*e*e.T)"

# %% wrong: the right number, with the line above copied
# says: the corrected line: this is line 2 as it stands.
corrected_line = "Trace((L*L.T).inv()*e*e.T)"

# %% wrong: a trace of a quadratic form is suspected
# says: the corrected line follows from line 1, but that is not all: line 2 was right as it stood.
wrong_line = 2
corrected_line = "Trace(e.T*(L*L.T).inv()*e)"

# %% wrong: the last line
# says: the corrected line equals line 1, as it should. But line 6, which you blame, does follow f
wrong_line = 6
corrected_line = "(L.inv()*e).T*(L.inv()*e)"

# %% wrong: cyclic moves are suspected
# says: the corrected line equals line 1, as it should. But line 5, which you blame, does follow f
wrong_line = 5
corrected_line = "Trace((L.inv()*e)*(L.inv()*e).T)"

# %% wrong: the given first line
# says: the number of the line: a whole number from 2 to 6 is asked, you have 1. The first line is
wrong_line = 1
corrected_line = "e.T*L.T.inv()*L.inv()*e"

# %% wrong: the number only
# says: the corrected line: there is no answer yet. Replace the dots.
corrected_line = ...

# %% wrong: prose
# says: the corrected line, compared with line 2: unreadable
corrected_line = "the order is wrong"

# %% wrong: no such line
# says: the number of the line: a whole number from 2 to 6 is asked, you have 0. The first line is
wrong_line = 0

# %% wrong: a list of all numbers
# says: the number of the line: a whole number from 2 to 6 is asked, you have [2, 3, 4, 5, 6]. The
wrong_line = [2, 3, 4, 5, 6]

# %% wrong: line 2 with brackets
# says: the corrected line: the inverse of the product still stands in it, as in the lines above t
corrected_line = "Trace((L*L.T).inv()*(e*e.T))"

# %% wrong: line 2 with its factors moved
# says: the corrected line: the inverse of the product still stands in it, as in the lines above t
corrected_line = "Trace(e*e.T*(L*L.T).inv())"

# %% wrong: line 1, transposed
# says: the corrected line: the inverse of the product still stands in it, as in the lines above t
corrected_line = "(e.T*(L*L.T).inv()*e).T"

# %% right: the transpose of the inverse
corrected_line = "Trace(L.inv().T*L.inv()*(e*e.T))"

# %% right: brackets
corrected_line = "Trace((L.T.inv()*L.inv())*e*e.T)"

# %% right: NumPy's product, and inv as a function
corrected_line = "Trace(inv(L.T) @ inv(L) @ e @ e.T)"

# %% right: tr, as on paper
corrected_line = "tr(L.T.inv()*L.inv()*e*e.T)"

# %% wrong: the product inverted inside a bracket
# says: the corrected line: the inverse of the product still stands in it, as in the lines above t
corrected_line = "Trace(((L*L.T).T).inv()*e*e.T)"

# %% wrong: the number, counted from 0
# says: the corrected line follows from line 1, but that is not all: line 2 was right as it stood.
wrong_line = 2

# %% wrong: no inverse of the transpose
# says: the corrected line, compared with line 2: wrong
corrected_line = "Trace(L.T*L.inv()*e*e.T)"

# %% right: SymPy objects
import sympy as sp

factor, error = sp.MatrixSymbol("L", 2, 2), sp.MatrixSymbol("e", 2, 1)
corrected_line = sp.Trace(factor.T.inv() * factor.inv() * error * error.T)

# %% right: the number as text, the factors moved on
wrong_line = "3"
corrected_line = "= Trace(L.inv()*e*e.T*L.T.inv())"
