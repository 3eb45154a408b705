# %% wrong: the line that carries the mistake on
wrong_line = 5
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.775

# %% wrong: line 2 is suspected
wrong_line = 2
corrected_line = "((1 - 1/N)*Sum(d[k]**2, k) - Sum(d[k], k)**2/N)/N**2"
ratio = 0.775

# %% wrong: line 2, with the right line
wrong_line = 2
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.775

# %% wrong: line 3 is suspected
wrong_line = 3
corrected_line = "(Sum(d[k]**2, k) - dbar**2)/N**2"
ratio = 0.775

# %% wrong: line 3, rewritten
wrong_line = 3
corrected_line = "(Sum(d[k]**2, k) - dbar*Sum(d[k], k))/N**2"
ratio = 0.775

# %% wrong: line 3 with s2
wrong_line = 3
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.775

# %% wrong: the given line again
wrong_line = 4
corrected_line = "s2/N"
ratio = 0.775

# %% wrong: the line above
wrong_line = 4
corrected_line = "(Sum(d[k]**2, k) - N*dbar**2)/N**2"
ratio = 0.775

# %% wrong: the line above, split
wrong_line = 4
corrected_line = "Sum(d[k]**2, k)/N**2 - dbar**2/N"
ratio = 0.775

# %% wrong: the line above as deviations, without s2
wrong_line = 4
corrected_line = "Sum((d[k] - dbar)**2, k)/N**2"
ratio = 0.775

# %% wrong: s2 plus and minus itself
wrong_line = 4
corrected_line = "Sum((d[k] - dbar)**2, k)/N**2 + s2 - s2"
ratio = 0.775

# %% wrong: divided by N - 1
wrong_line = 4
corrected_line = "s2/(N - 1)"
ratio = 0.775

# %% wrong: factor upside down
wrong_line = 4
corrected_line = "N*s2/(N - 1)/N"
ratio = 0.775

# %% wrong: one N missing
wrong_line = 4
corrected_line = "(N - 1)*s2/N"
ratio = 0.775

# %% wrong: s2 with the divisor N**2
wrong_line = 4
corrected_line = "s2/N**2"
ratio = 0.775

# %% wrong: a name that is not known
wrong_line = 4
corrected_line = "(N - 1)*s/N**2"
ratio = 0.775

# %% wrong: a number instead of a line
wrong_line = 4
corrected_line = 4
ratio = 0.775

# %% wrong: line 1
wrong_line = 1
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.775

# %% wrong: a text for the line
wrong_line = "four"
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.775

# %% wrong: standard errors alone
wrong_line = 4
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.935

# %% wrong: quantiles alone
wrong_line = 4
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.829

# %% wrong: without the root
wrong_line = 4
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.725

# %% wrong: the ratio upside down
wrong_line = 4
corrected_line = "(N - 1)*s2/N**2"
ratio = 1.29

# %% wrong: root upside down
wrong_line = 4
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.886

# %% wrong: equal
wrong_line = 4
corrected_line = "(N - 1)*s2/N**2"
ratio = 1

# %% wrong: by how much shorter
wrong_line = 4
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.225

# %% wrong: in percent
wrong_line = 4
corrected_line = "(N - 1)*s2/N**2"
ratio = 77.5

# %% wrong: two digits
wrong_line = 4
corrected_line = "(N - 1)*s2/N**2"
ratio = 0.78

# %% right: two factors
wrong_line = 4
corrected_line = "(N-1)/N*s2/N"
ratio = 0.7752

# %% right: as a sum
wrong_line = 4
corrected_line = "s2/N - s2/N**2"
ratio = 1.96 / 2.365 * (7 / 8) ** 0.5

# %% right: another bracket
wrong_line = 4
corrected_line = "(1 - 1/N)*s2/N"
ratio = 0.7754

# %% right: SymPy
_s, _n = sp.symbols("s2 N")
wrong_line = 4
corrected_line = _s * (_n - 1) / _n**2
ratio = np.float64(0.7753)

# %% right: s**2 for s2, NumPy's number
wrong_line = np.int64(4)
corrected_line = "s**2*(N-1)/N**2"
ratio = 0.775
