# %% wrong: the first line that looks odd
# says: line 2 was right as it stood
wrong_line = 2
corrected_line = "(r**2 + q**2)/2 - (r**2 + 2*r*q + q**2)/4"

# %% wrong: the consequence, not the mistake
# says: line 4, which you blame, does follow from line 3
wrong_line = 4
corrected_line = "(r - q)**2/4"

# %% wrong: the sign of the mixed term
# says: compared with line 2
corrected_line = "(r**2 + q**2)/2 - (r**2 - 2*r*q + q**2)/4"

# %% wrong: the mixed term without its 2
# says: compared with line 2
corrected_line = "(r**2 + q**2)/2 - (r**2 + r*q + q**2)/4"

# %% wrong: the given line once more
# says: this is line 3 as it stands
corrected_line = "(r**2 + q**2)/2 - (r**2 + q**2)/4"

# %% wrong: the line above once more
# says: this is line 2 as it stands
corrected_line = "(r**2 + q**2)/2 - ((r + q)/2)**2"

# %% wrong: divides the square of the sum by 2
# says: compared with line 2
corrected_line = "(r**2 + q**2)/2 - (r + q)**2/2"

# %% wrong: the minus reaches the first term only
# says: compared with line 2
corrected_line = "(r**2 + q**2)/2 - r**2/4 + r*q/2 + q**2/4"

# %% wrong: counts from 0
# says: line 2 was right as it stood
wrong_line = 2
corrected_line = "r**2/4 - r*q/2 + q**2/4"

# %% wrong: a text for the number
# says: a whole number from 2 to 4 is asked
wrong_line = "third"

# %% wrong: a letter that is not given
# says: This part knows the names n, r, q only
corrected_line = "(r**2 + q**2)/2 - (r**2 + 2*r*p + q**2)/4"

# %% right: the mixed term on its own
corrected_line = "(r**2 + q**2)/2 - (r**2 + q**2)/4 - r*q/2"

# %% right: all the way
corrected_line = "(r - q)**2/4"

# %% right: an equals sign first, the number as text
wrong_line = "3"
corrected_line = "= r**2/4 + q**2/4 - r*q/2"

# %% right: SymPy's object
import sympy as sp
r, q = sp.symbols("r q", positive=True)
corrected_line = (r**2 + q**2) / 2 - (r**2 + 2 * r * q + q**2) / 4
