# %% wrong: the first line that looks odd
wrong_line = 2
corrected_line = "(r**2 + q**2)/2 - (r**2 + 2*r*q + q**2)/4"
# %% wrong: the consequence, not the mistake
wrong_line = 4
corrected_line = "(r - q)**2/4"
# %% wrong: the sign of the mixed term
wrong_line = 3
corrected_line = "(r**2 + q**2)/2 - (r**2 - 2*r*q + q**2)/4"
# %% wrong: the mixed term without its 2
wrong_line = 3
corrected_line = "(r**2 + q**2)/2 - (r**2 + r*q + q**2)/4"
# %% wrong: the given line once more
wrong_line = 3
corrected_line = "(r**2 + q**2)/2 - (r**2 + q**2)/4"
# %% wrong: the line above once more
wrong_line = 3
corrected_line = "(r**2 + q**2)/2 - ((r + q)/2)**2"
# %% wrong: divides the square of the sum by 2
wrong_line = 3
corrected_line = "(r**2 + q**2)/2 - (r**2 + 2*r*q + q**2)/2"
# %% wrong: counts from 0
wrong_line = 2
corrected_line = "(r - q)**2/4"
# %% wrong: a text for the number
wrong_line = "third"
corrected_line = "(r**2 + q**2)/2 - (r**2 + 2*r*q + q**2)/4"
# %% right: the mixed term on its own
wrong_line = 3
corrected_line = "(r**2 + q**2)/2 - (r**2 + q**2)/4 - r*q/2"
# %% right: all the way
wrong_line = 3
corrected_line = "((r - q)/2)**2"
