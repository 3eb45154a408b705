# %% wrong: another line, a line that is right
# says: the corrected line follows from line 2, but that is not all: line 3 was right as it stood.
wrong_line = 3
fall = 0.222

# %% wrong: line 3 in another order
# says: the corrected line: this says no more than line 3.
corrected_line = "d/n*((m + k)/k)"
fall = 0.222

# %% wrong: the last line
# says: the corrected line equals line 1, as it should. But line 5, which you blame, does follow f
wrong_line = 5
corrected_line = "d/n + d/n*(m/k)"
fall = 0.222

# %% wrong: the first line
# says: the number of the line: a whole number from 2 to 5 is asked, you have 1. The first line is
wrong_line = 1
fall = 0.222

# %% wrong: a line that does not exist
# says: the number of the line: a whole number from 2 to 5 is asked, you have 6. The first line is
wrong_line = 6
fall = 0.222

# %% wrong: line 3 as it stands
# says: the corrected line: this says no more than line 3.
corrected_line = "(m + k)/n*(d/k)"
fall = 0.222

# %% wrong: line 3 in one fraction
# says: the corrected line: this says no more than line 3.
corrected_line = "d*(m + k)/(n*k)"
fall = 0.222

# %% wrong: line 3 with the sum taken apart only
# says: the corrected line: every line follows, but its bracket is not yet 1 and something, as tha
corrected_line = "d/n*(m/k + k/k)"
fall = 0.222

# %% wrong: line 2 as it stands
# says: the corrected line: this says no more than line 2.
corrected_line = "(m + k)/n*(1 - (k - d)/k)"
fall = 0.222

# %% wrong: line 4 as it stands
# says: the corrected line: this says no more than line 4.
corrected_line = "d/n*(1 + m/(m + k))"
fall = 0.222

# %% wrong: m cancelled
# says: the corrected line, compared with line 3: wrong
corrected_line = "d/n*(1 + k/m)"
fall = 0.222

# %% wrong: k over m plus k
# says: the corrected line, compared with line 3: wrong
corrected_line = "d/n*(1 + k/(m + k))"
fall = 0.222

# %% wrong: the 1 is lost
# says: the corrected line, compared with line 3: wrong
corrected_line = "d/n*(m/k)"
fall = 0.222

# %% wrong: minus
# says: the corrected line, compared with line 3: wrong
corrected_line = "d/n*(1 - m/k)"
fall = 0.222

# %% wrong: without d
# says: the corrected line, compared with line 3: wrong
corrected_line = "1/n*(1 + m/k)"
fall = 0.222

# %% wrong: no signs between factors
# says: the corrected line, compared with line 3: unreadable: n is not a function: write n*(...) f
corrected_line = "d/n(1 + m/k)"
fall = 0.222

# %% wrong: letters that nobody declared
# says: the corrected line, compared with line 3: unreadable: x is not declared. This part knows t
corrected_line = "d/n*(1 + m/(n - x))"
fall = 0.222

# %% wrong: a number for the line
# says: the corrected line: a string is asked, you have 0.2222.
corrected_line = 0.2222
fall = 0.222

# %% wrong: padded line 3
# says: the corrected line: this says no more than line 3.
corrected_line = "d/n*((m + k)/k) + 1 - 1"
fall = 0.222

# %% wrong: the fall of the blog
# says: this is what the blog gets
fall = 2/12*(1 + 2/8)

# %% wrong: the own share only
# says: each recovery takes its own share only
fall = 2/12

# %% wrong: of those still watched
# says: this is the share of those still watched
fall = 2/6

# %% wrong: the m were never there
# says: you took the m out from the beginning
fall = 2/10

# %% wrong: the curve after the fall
# says: this is the height of the curve after it
fall = 8/12*4/6

# %% wrong: the curve before the fall
# says: this is the height of the curve before it
fall = 8/12

# %% wrong: a fall upward
# says: the sign is turned
fall = -2/9

# %% wrong: one recovery only
# says: this is how far one recovery lets it fall
fall = 1/9

# %% wrong: percent of the fall
# says: you give percent
fall = 22.2

# %% wrong: one decimal of the fall
# says: you took the m out from the beginning
fall = 0.2

# %% wrong: no fall yet
# says: fall: there is no answer yet. Replace the dots.
fall = ...

# %% right: a fraction, other brackets
corrected_line = "(d/n)*(m/k + 1)"
fall = 2/9

# %% right: multiplied out
corrected_line = "d/n + d*m/(n*k)"
fall = 8/12*2/6

# %% right: a power, spaces, three decimals
wrong_line = 4.0
corrected_line = "  (1 + m*k**-1) * d / n "
fall = 0.2222

# %% right: the number as a text, an equals sign in front
wrong_line = "4"
corrected_line = "= d/n*(1 + m/k)"
fall = 0.222

# %% right: the number as NumPy has it
wrong_line = np.int64(4)
corrected_line = "d*(1 + m/k)/n"
fall = np.float64(2) / 9

# %% right: a SymPy object
n, m, k, d = sp.symbols("n m k d")
corrected_line = d / n * (1 + m / k)
fall = sp.Rational(2, 9)

# %% right: e, text and SymPy
wrong_line = np.int64(4)
corrected_line = sp.Symbol("d") / sp.Symbol("n") * (1 + sp.Symbol("m") / sp.Symbol("k"))
fall = sp.Rational(2, 9)
