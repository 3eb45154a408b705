# %% wrong: the line after it is blamed
# says: line 4, which you blame, does follow from line 3
wrong_line = 4

# %% wrong: the line before it is blamed
# says: the corrected line, compared with line 1
wrong_line = 2
corrected_line = "R*(l - p)"

# %% wrong: the right line, still without the rotation
# says: this is line 3 as it stands
corrected_line = "R.T*l - p"

# %% wrong: line 3, its terms exchanged
# says: this is line 3 as it stands
corrected_line = "-p + R.T*l"

# %% wrong: rotated the other way
# says: compared with line 2
corrected_line = "R.T*l - R*p"

# %% wrong: both terms rotated the other way
# says: compared with line 2
corrected_line = "R*l - R*p"

# %% wrong: the sign of p
# says: look at its factor
corrected_line = "R.T*l + R.T*p"

# %% wrong: the other term has lost its rotation
# says: compared with line 2
corrected_line = "l - R.T*p"

# %% wrong: line 2 once more
# says: this is line 2 as it stands
corrected_line = "R.T*(l - p)"

# %% wrong: the last line is blamed
# says: this is line 2 as it stands
wrong_line = 5
corrected_line = "R.T*(l - p)"

# %% wrong: a line of a proof that is right, in the wrong place
# says: line 2 was right as it stood
wrong_line = 2

# %% wrong: words
# says: cannot be read
corrected_line = "p must be rotated as well"

# %% wrong: a letter that is not given
# says: This part knows the names R, l, p only
corrected_line = "R.T*l - S*p"

# %% wrong: no number
# says: a whole number from 2 to 5 is asked
wrong_line = "the third"

# %% wrong: the given line
# says: a whole number from 2 to 5 is asked
wrong_line = 1

# %% right: with the inverse
corrected_line = "R.inv()*l - R.inv()*p"

# %% right: terms in the other order
wrong_line = 3.0
corrected_line = "-R.T*p + R.T*l"

# %% right: the number as text, the line with an equals sign before it
wrong_line = "3"
corrected_line = "= R.T*l - R.T*p"

# %% right: brackets
corrected_line = "(R.T)*l - (R.T*p)"

# %% right: one transposed, one inverted
wrong_line = np.int64(3)
corrected_line = "R.T*l - R**-1*p"
