# %% wrong: the line after it is blamed
wrong_line = 4
corrected_line = "R.T*l - R.T*p"

# %% wrong: the line before it is blamed
wrong_line = 2
corrected_line = "R*(l - p)"

# %% wrong: the right line, still without the rotation
wrong_line = 3
corrected_line = "R.T*l - p"

# %% wrong: rotated the other way
wrong_line = 3
corrected_line = "R.T*l - R*p"

# %% wrong: both terms rotated the other way
wrong_line = 3
corrected_line = "R*l - R*p"

# %% wrong: the sign of p
wrong_line = 3
corrected_line = "R.T*l + R.T*p"

# %% wrong: line 2 once more
wrong_line = 3
corrected_line = "R.T*(l - p)"

# %% wrong: the last line is blamed
wrong_line = 5
corrected_line = "R.T*(l - p)"

# %% wrong: a line of a proof that is right, in the wrong place
wrong_line = 2
corrected_line = "R.T*l - R.T*p"

# %% wrong: words
wrong_line = 3
corrected_line = "p must be rotated as well"

# %% right: with the inverse
wrong_line = 3
corrected_line = "R.inv()*l - R.inv()*p"

# %% right: terms in the other order
wrong_line = 3
corrected_line = "-R.T*p + R.T*l"
