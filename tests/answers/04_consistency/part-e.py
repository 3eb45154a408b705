# %% wrong: the line that carries the mistake on
wrong_line = 4
corrected_line = "Trace(L.inv()*e*e.T*L.T.inv())"

# %% wrong: the right number, and the given line again
wrong_line = 3
corrected_line = "Trace(L.inv()*L.T.inv()*e*e.T)"

# %% wrong: the right number, with the inverse taken twice
wrong_line = 3
corrected_line = "Trace(L.inv()*L.inv()*e*e.T)"

# %% wrong: the right number, with the line above copied
wrong_line = 3
corrected_line = "Trace((L*L.T).inv()*e*e.T)"

# %% wrong: a trace of a quadratic form is suspected
wrong_line = 2
corrected_line = "Trace(e.T*(L*L.T).inv()*e)"

# %% wrong: the last line
wrong_line = 6
corrected_line = "(L.inv()*e).T*(L.inv()*e)"

# %% wrong: cyclic moves are suspected
wrong_line = 5
corrected_line = "Trace((L.inv()*e)*(L.inv()*e).T)"

# %% wrong: the given first line
wrong_line = 1
corrected_line = "e.T*L.T.inv()*L.inv()*e"

# %% wrong: the number only
wrong_line = 3
corrected_line = ...

# %% wrong: prose
wrong_line = 3
corrected_line = "the order is wrong"

# %% wrong: no such line
wrong_line = 0
corrected_line = "Trace(L.T.inv()*L.inv()*e*e.T)"

# %% wrong: a list of all numbers
wrong_line = [2, 3, 4, 5, 6]
corrected_line = "Trace(L.T.inv()*L.inv()*e*e.T)"

# %% wrong: line 2 with brackets
wrong_line = 3
corrected_line = "Trace((L*L.T).inv()*(e*e.T))"

# %% wrong: line 2 with its factors moved
wrong_line = 3
corrected_line = "Trace(e*e.T*(L*L.T).inv())"

# %% wrong: line 1, transposed
wrong_line = 3
corrected_line = "(e.T*(L*L.T).inv()*e).T"

# %% right: the transpose of the inverse
wrong_line = 3
corrected_line = "Trace(L.inv().T*L.inv()*(e*e.T))"

# %% right: brackets
wrong_line = 3
corrected_line = "Trace((L.T.inv()*L.inv())*e*e.T)"

# %% right: NumPy's product, and inv as a function
wrong_line = 3
corrected_line = "Trace(inv(L.T) @ inv(L) @ e @ e.T)"

# %% right: tr, as on paper
wrong_line = 3
corrected_line = "tr(L.T.inv()*L.inv()*e*e.T)"
