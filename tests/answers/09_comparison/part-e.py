# %% wrong: the line that carries the mistake on
# says: the corrected line equals line 1, as it should. But line 5, which you blame, does follow f
wrong_line = 5

# %% wrong: line 2 is suspected
# says: the corrected line, compared with line 1: wrong
wrong_line = 2
corrected_line = "((1 - 1/N)*Sum(d[k]**2, k) - Sum(d[k], k)**2/N)/N**2"

# %% wrong: line 2, with the right line
# says: the corrected line follows from line 1, but that is not all: line 2 was right as it stood.
wrong_line = 2

# %% wrong: line 3 is suspected
# says: the corrected line, compared with line 2: wrong
wrong_line = 3
corrected_line = "(Sum(d[k]**2, k) - dbar**2)/N**2"

# %% wrong: line 3, rewritten
# says: the corrected line: this is line 2 or 3 as it stands.
wrong_line = 3
corrected_line = "(Sum(d[k]**2, k) - dbar*Sum(d[k], k))/N**2"

# %% wrong: line 3 with s2
# says: the corrected line follows from line 2, but that is not all: line 3 was right as it stood.
wrong_line = 3

# %% wrong: the given line again
# says: the corrected line: this is line 4 as it stands.
corrected_line = "s2/N"

# %% wrong: the line above
# says: the corrected line: this is line 2 or 3 as it stands.
corrected_line = "(Sum(d[k]**2, k) - N*dbar**2)/N**2"

# %% wrong: the line above, split
# says: the corrected line: it follows, but differences still stand in it. Say it by s2 and N alon
corrected_line = "Sum(d[k]**2, k)/N**2 - dbar**2/N"

# %% wrong: the line above as deviations, without s2
# says: the corrected line: it follows, but differences still stand in it. Say it by s2 and N alon
corrected_line = "Sum((d[k] - dbar)**2, k)/N**2"

# %% wrong: s2 plus and minus itself
# says: the corrected line: it follows, but differences still stand in it. Say it by s2 and N alon
corrected_line = "Sum((d[k] - dbar)**2, k)/N**2 + s2 - s2"

# %% wrong: divided by N - 1
# says: the corrected line, compared with line 3: wrong
corrected_line = "s2/(N - 1)"

# %% wrong: factor upside down
# says: the corrected line, compared with line 3: wrong
corrected_line = "N*s2/(N - 1)/N"

# %% wrong: one N missing
# says: the corrected line, compared with line 3: wrong
corrected_line = "(N - 1)*s2/N"

# %% wrong: s2 with the divisor N**2
# says: the corrected line, compared with line 3: wrong
corrected_line = "s2/N**2"

# %% wrong: a name that is not known
# says: the corrected line, compared with line 3: unreadable: s is not declared. This part knows t
corrected_line = "(N - 1)*s/N**2"

# %% wrong: a number instead of a line
# says: the corrected line: a string is asked, you have 4.
corrected_line = 4

# %% wrong: line 1
# says: the number of the line: a whole number from 2 to 5 is asked, you have 1. The first line is
wrong_line = 1

# %% wrong: a text for the line
# says: the number of the line: a whole number from 2 to 5 is asked, you have 'four'. The first li
wrong_line = "four"

# %% wrong: standard errors alone
# says: you compared the standard errors alone
ratio = 0.935

# %% wrong: quantiles alone
# says: you compared the quantiles alone
ratio = 0.829

# %% wrong: without the root
# says: the root is missing
ratio = 0.725

# %% wrong: the ratio upside down
# says: this is the ratio of t to bootstrap
ratio = 1.29

# %% wrong: root upside down
# says: the root stands upside down
ratio = 0.886

# %% wrong: equal
# says: this is the blog's: equal
ratio = 1

# %% wrong: by how much shorter
# says: this is by how much it is shorter
ratio = 0.225

# %% wrong: in percent
# says: this is a percentage
ratio = 77.5

# %% wrong: two digits
# says: you rounded to two decimals
ratio = 0.78

# %% right: two factors
corrected_line = "(N-1)/N*s2/N"
ratio = 0.7752

# %% right: as a sum
corrected_line = "s2/N - s2/N**2"
ratio = 1.96 / 2.365 * (7 / 8) ** 0.5

# %% right: another bracket
corrected_line = "(1 - 1/N)*s2/N"
ratio = 0.7754

# %% right: SymPy
_s, _n = sp.symbols("s2 N")
corrected_line = _s * (_n - 1) / _n**2
ratio = np.float64(0.7753)

# %% right: s**2 for s2, NumPy's number
wrong_line = np.int64(4)
corrected_line = "s**2*(N-1)/N**2"

# %% right: as sympy
corrected_line = (sp.Symbol("N") - 1) * sp.Symbol("s2") / sp.Symbol("N") ** 2
ratio = np.sqrt(7 / 8) * 1.959964 / stats.t.ppf(0.975, 7)

# %% right: text number and equals
wrong_line = "4"
corrected_line = "= s2/N - s2/N**2"
ratio = 0.775

# %% right: 1 - 1/N
wrong_line = 4.0
corrected_line = "(1 - 1/N)*s**2/N"

# %% wrong: right line plus a difference
# says: differences still stand in it
corrected_line = "(N-1)*s2/N**2 + dbar - dbar"
