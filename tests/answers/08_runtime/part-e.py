# %% wrong: another line, a line that is right
wrong_line = 3
corrected_line = "d/n*(1 + m/k)"
fall = 0.222

# %% wrong: line 3 in another order
wrong_line = 4
corrected_line = "d/n*((m + k)/k)"
fall = 0.222

# %% wrong: the last line
wrong_line = 5
corrected_line = "d/n + d/n*(m/k)"
fall = 0.222

# %% wrong: the first line
wrong_line = 1
corrected_line = "d/n*(1 + m/k)"
fall = 0.222

# %% wrong: a line that does not exist
wrong_line = 6
corrected_line = "d/n*(1 + m/k)"
fall = 0.222

# %% wrong: line 3 as it stands
wrong_line = 4
corrected_line = "(m + k)/n*(d/k)"
fall = 0.222

# %% wrong: line 3 in one fraction
wrong_line = 4
corrected_line = "d*(m + k)/(n*k)"
fall = 0.222

# %% wrong: line 3 with the sum taken apart only
wrong_line = 4
corrected_line = "d/n*(m/k + k/k)"
fall = 0.222

# %% wrong: line 2 as it stands
wrong_line = 4
corrected_line = "(m + k)/n*(1 - (k - d)/k)"
fall = 0.222

# %% wrong: line 4 as it stands
wrong_line = 4
corrected_line = "d/n*(1 + m/(m + k))"
fall = 0.222

# %% wrong: m cancelled
wrong_line = 4
corrected_line = "d/n*(1 + k/m)"
fall = 0.222

# %% wrong: k over m plus k
wrong_line = 4
corrected_line = "d/n*(1 + k/(m + k))"
fall = 0.222

# %% wrong: the 1 is lost
wrong_line = 4
corrected_line = "d/n*(m/k)"
fall = 0.222

# %% wrong: minus
wrong_line = 4
corrected_line = "d/n*(1 - m/k)"
fall = 0.222

# %% wrong: without d
wrong_line = 4
corrected_line = "1/n*(1 + m/k)"
fall = 0.222

# %% wrong: no signs between factors
wrong_line = 4
corrected_line = "d/n(1 + m/k)"
fall = 0.222

# %% wrong: letters that nobody declared
wrong_line = 4
corrected_line = "d/n*(1 + m/(n - x))"
fall = 0.222

# %% wrong: a number for the line
wrong_line = 4
corrected_line = 0.2222
fall = 0.222

# %% wrong: padded line 3
wrong_line = 4
corrected_line = "d/n*((m + k)/k) + 1 - 1"
fall = 0.222

# %% wrong: the fall of the blog
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = 2/12*(1 + 2/8)

# %% wrong: the own share only
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = 2/12

# %% wrong: of those still watched
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = 2/6

# %% wrong: the m were never there
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = 2/10

# %% wrong: the curve after the fall
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = 8/12*4/6

# %% wrong: the curve before the fall
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = 8/12

# %% wrong: a fall upward
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = -2/9

# %% wrong: one recovery only
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = 1/9

# %% wrong: percent of the fall
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = 22.2

# %% wrong: one decimal of the fall
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = 0.2

# %% wrong: no fall yet
wrong_line = 4
corrected_line = "d/n*(1 + m/k)"
fall = ...

# %% right: a fraction, other brackets
wrong_line = 4
corrected_line = "(d/n)*(m/k + 1)"
fall = 2/9

# %% right: multiplied out
wrong_line = 4
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
wrong_line = 4
corrected_line = d / n * (1 + m / k)
fall = sp.Rational(2, 9)
