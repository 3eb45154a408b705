# %% wrong: the sign of the derivative of log(1 - p)
# says: lines_slope: line 1: wrong
lines_slope = [
    "-q/p - (1-q)/(1-p)",
    "(-q*(1-p) - (1-q)*p)/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: fractions added by their parts
# says: lines_slope: line 2: wrong
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q) - q)/((1-p) - p)",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: the derivative of log p is log p
# says: lines_slope: line 1: wrong
lines_slope = [
    "-q*log(p) + (1-q)*log(1-p)",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: leaps to the result
# says: lines_slope: every line follows, but you leap: 1 of at least 3 lines
lines_slope = [
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: two lines copied from the lecture
# says: lines_slope: every line follows, but you leap: 2 of at least 3 lines
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: padded with zeros and ones
# says: lines_slope: every line follows, but you leap: 1 of at least 3 lines
lines_slope = [
    "Derivative(-q*log(p) - (1-q)*log(1-p), p) + 0",
    "1*(p-q)/(p*(1-p)) + 0",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: padded by the order of the factors
# says: lines_slope: line 2: This line is the same as the line before: the step changes nothing
lines_slope = [
    "(p-q)/((1-p)*p)",
    "(-q+p)/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: padded with a zero in the numerator and a one below
# says: lines_slope: every line follows, but you leap: 1 of at least 3 lines
lines_slope = [
    "(p-q+0)/(p*(1-p))",
    "(p-q)/(1*p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: stops before the goal
# says: lines_slope: the goal is not reached: the last line agrees with it, but does not have its
lines_slope = [
    "-q/p - (1-q)*(-1/(1-p))",
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: quotient rule without the second term
# says: lines_curvature: line 1: wrong
lines_curvature = [
    "1/(p*(1-p))",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: quotient rule with the terms exchanged
# says: lines_curvature: line 1: wrong
lines_curvature = [
    "((p-q)*(1-2*p) - p*(1-p))/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: the minus of the inner derivative is lost
# says: lines_curvature: line 2: wrong
lines_curvature = [
    "Derivative((1-q)/(1-p) - q/p, p)",
    "q/p**2 - (1-q)/(1-p)**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: the curvature in one leap
# says: lines_curvature: every line follows, but you leap: 1 of at least 2 lines
lines_curvature = [
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: multiplies the inequality by something negative
# says: lines_rise: line 1: wrong
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(q - p, 0)",
    "Gt(p, q)",
]

# %% wrong: an inequality the other way round
# says: lines_rise: line 2: wrong
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Lt(p, q)",
]

# %% wrong: an equation instead of the inequality
# says: lines_rise: line 1: wrong
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Eq(p - q, 0)",
    "Eq(p, q)",
]

# %% wrong: the sign in one leap
# says: lines_rise: every line follows, but you leap: 1 of at least 2 lines
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p, q)",
]

# %% wrong: the sign, padded
# says: lines_rise: every line follows, but you leap: 1 of at least 2 lines
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt((p-q)/(p*(1-p)) + 0, 0)",
    "Gt(p, q)",
]

# %% wrong: a local minimum is taken for the only one
# says: you take a minimum nearby for the lowest of all
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
enough = (False, True, True, True, False)

# %% wrong: any point with slope zero is the minimum
# says: you take every point with slope 0 for a minimum
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
enough = (True, True, True, True, True)

# %% wrong: a single stationary point is taken for a minimum
# says: you take the only point with slope 0 for a minimum
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
enough = [False, False, True, True, True]

# %% wrong: believes in second derivatives only
# says: you trust second derivatives only
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
enough = (False, False, True, False, False)

# %% wrong: the numbers of the sentences
# says: enough: a tuple of 5 results is asked, you have [3, 4].
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
enough = [3, 4]

# %% wrong: the lines only
# says: enough: there is no answer yet. Replace the dots.
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
enough = ...

# %% wrong: LaTeX instead of Python
# says: lines_slope: line 1: unreadable
lines_slope = [
    r"\frac{p-q}{p(1-p)}",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: implied products
# says: lines_slope: line 2: unreadable
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "(p-q)/(p(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% right: the given lines repeated, other orders, a line more
lines_slope = [
    "Derivative(-q*log(p) - (1-q)*log(1-p), p)",
    "-q/p + (1-q)/(1-p)",
    "(-q*(1-p) + (1-q)*p)/(p*(1-p))",
    "(-q + q*p + p - q*p)/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "Derivative(-q/p + (1-q)/(1-p), p)",
    "Derivative(-q/p, p) + Derivative((1-q)/(1-p), p)",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt((p-q)/(p*(1-p)), 0)",
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = [False, False, True, True, False]

# %% right: derivatives term by term, and the inequality moved
lines_slope = [
    "-q*Derivative(log(p), p) - (1-q)*Derivative(log(1-p), p)",
    "-q/p - (1-q)*(-1/(1-p))",
    "p*(1-q)/(p*(1-p)) - q*(1-p)/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(1*p*(1-p) - (p-q)*(1-2*p))/(p**2*(1-p)**2)",
    "(p**2 - 2*p*q + q)/(p**2*(1-p)**2)",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0*p*(1-p))",
    "Gt(p, q)",
]

# %% right: one move more in the last chain
lines_slope = [
    "(q-1)/(p-1) - q/p",
    "(p*(q-1) - q*(p-1))/(p*(p-1))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Lt(q - p, 0)",
    "Lt(q, p)",
    "Gt(p, q)",
]

# %% right: the numerator multiplied out, two moves in the others
lines_slope = [
    "-q/p + (1-q)/(1-p)",
    "(-q*(1-p) + (1-q)*p)/(p*(1-p))",
    "(p - p*q - q + p*q)/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "Derivative(-q/p + (1-q)/(1-p), p)",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p, q + 0*p)",
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = [False, False, True, True, False]

# %% right: the numerator multiplied out in the second line
lines_slope = [
    "-q/p + (1-q)/(1-p)",
    "(-q + q*p + p - q*p)/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]

# %% right: both fractions brought to the common denominator
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "p*(1-q)/(p*(1-p)) - q*(1-p)/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]

# %% right: begins with the inner derivative written out
lines_slope = [
    "-q/p - (1-q)/(1-p)*(-1)",
    "(1-q)/(1-p) - q/p",
    "(p-q)/(p*(1-p))",
]

# %% wrong: the result rewritten three times
# says: lines_slope: every line follows, but you leap: 2 of at least 3 lines
lines_slope = ["-(q-p)/(p*(1-p))", "(p-q)/(p-p**2)", "(p-q)/(p*(1-p))"]

# %% wrong: the two halves of the result
# says: lines_slope: every line follows, but no line has the two logarithms differentiated, each t
lines_slope = ["p/(p*(1-p)) - q/(p*(1-p))", "1/(1-p) - q/(p*(1-p))", "(p-q)/(p*(1-p))"]

# %% wrong: the two fractions, and the result rewritten
# says: lines_slope: every line follows, but a move is missing: differentiate term by term, or sho
lines_slope = ["-q/p + (1-q)/(1-p)", "(p-q)/(p-p**2)", "(p-q)/(p*(1-p))"]

# %% wrong: the fractions twice
# says: lines_slope: every line follows, but you leap: 2 of at least 3 lines
lines_slope = ["-q/p + (1-q)/(1-p)", "2*(-q/p + (1-q)/(1-p))/2", "(p-q)/(p*(1-p))"]

# %% wrong: nothing differentiated, a term added and taken away
# says: lines_slope: every line follows, but you leap: 2 of at least 3 lines
lines_slope = [
    "Derivative(-q*log(p) - (1-q)*log(1-p), p) + q - q",
    "(p-q)/(p*(1-p)) + 1/p - 1/p",
    "(p-q)/(p*(1-p))",
]

# %% wrong: the curvature on a common denominator first
# says: lines_curvature: every line follows, but no line shows how you differentiate: split what i
lines_curvature = ["(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2", "q/p**2 + (1-q)/(1-p)**2"]

# %% wrong: the curvature, with the given line doubled and halved
# says: lines_curvature: every line follows, but no line shows how you differentiate: split what i
lines_curvature = ["Derivative(2*(p-q)/(p*(1-p)), p)/2", "q/p**2 + (1-q)/(1-p)**2"]

# %% wrong: the curvature, with something added under the derivative
# says: lines_curvature: every line follows, but no line shows how you differentiate: split what i
lines_curvature = [
    "Derivative((p-q)/(p*(1-p)) + p, p) - 1",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% wrong: the curvature, with the other sign of numerator and denominator
# says: lines_curvature: every line follows, but you leap: 1 of at least 2 lines
lines_curvature = ["Derivative((q-p)/(p*(p-1)), p)", "q/p**2 + (1-q)/(1-p)**2"]

# %% wrong: the goal turned round in between
# says: lines_rise: every line follows, but no line shows what becomes of the denominator before p
lines_rise = ["Lt(q,p)", "Gt(p,q)"]

# %% wrong: the goal doubled in between
# says: lines_rise: every line follows, but no line shows what becomes of the denominator before p
lines_rise = ["Gt(2*p, 2*q)", "Gt(p,q)"]

# %% wrong: the given inequality doubled
# says: lines_rise: every line follows, but no line shows what becomes of the denominator before p
lines_rise = ["Gt(2*(p-q)/(p*(1-p)), 0)", "Gt(p, q)"]

# %% wrong: the given inequality turned round
# says: lines_rise: every line follows, but no line shows what becomes of the denominator before p
lines_rise = ["Lt((q-p)/(p*(1-p)), 0)", "Gt(p, q)"]

# %% wrong: trusts the second derivative at q
# says: you trust the second derivative at q
enough = (False, True, True, False, False)

# %% wrong: nothing is enough
# says: enough: (False, False, False, False, False) is not right.
enough = (False,) * 5

# %% wrong: one sentence is left out
# says: enough: a tuple of 5 results is asked, you have (False, False, True, True).
enough = (False, False, True, True)

# %% wrong: words
# says: enough, result 1: True or False is asked, you have 'no'.
enough = ["no", "no", "yes", "yes", "no"]

# %% right: SymPy objects
import sympy as sp

x, y = sp.symbols("p q")
lines_slope = [
    sp.Derivative(-y * sp.log(x), x) + sp.Derivative(-(1 - y) * sp.log(1 - x), x),
    -y / x + (1 - y) / (1 - x),
    (x - y) / (x * (1 - x)),
]

# %% right: 0 and 1
enough = (0, 0, 1, 1, 0)

# %% right: an array of bool
enough = np.array([False, False, True, True, False])

# %% right: diff
lines_curvature = ["diff(-q/p + (1-q)/(1-p), p)", "q/p**2+(1-q)/(1-p)**2"]

# %% right: pairs of line and reason
lines_slope = [
    ("-q/p + (1-q)/(1-p)", "the logarithm's derivative"),
    ("(-q*(1-p) + (1-q)*p)/(p*(1-p))", "common denominator"),
    ("(p-q)/(p*(1-p))", "the product p q cancels"),
]
lines_rise = [("Gt(p-q, 0)", "p(1-p) is positive"), ("Gt(p, q)", "add q")]

# %% right: a text with reasons
lines_slope = """
= -q*Derivative(log(p), p) - (1-q)*Derivative(log(1-p), p)   # the sum rule
= -q/p + (1-q)/(1-p)                                         # logarithms
= (p-q)/(p*(1-p))                                            # one fraction
"""

# %% right: the product rule
lines_curvature = [
    "Derivative(p-q, p)/(p*(1-p)) + (p-q)*Derivative(1/(p*(1-p)), p)",
    "1/(p*(1-p)) - (p-q)*(1-2*p)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% right: the quotient rule alone
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% right: the quotient rule multiplied out
lines_curvature = [
    "(p - p**2 - p + 2*p**2 + q - 2*p*q)/(p*(1-p))**2",
    "(p**2 - 2*p*q + q)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% right: the quotient rule with the inner difference written out
lines_curvature = [
    "(p*(1-p) - (p-q)*((1-p) - p))/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]

# %% right: each term differentiated by itself
lines_curvature = [
    "Derivative(-q*p**(-1), p) + Derivative((1-q)*(1-p)**(-1), p)",
    "q*p**(-2) + (1-q)*(1-p)**(-2)",
]

# %% right: the inequality multiplied in two moves
lines_rise = ["Gt((p-q)/p, 0)", "Gt(p-q, 0)", "Gt(p, q)"]

# %% right: the fraction divided out first
lines_rise = ["Gt(1/(1-p) - q/(p*(1-p)), 0)", "Gt(1, q/p)", "Gt(p, q)"]

# %% right: both sides keep the denominator
lines_rise = ["Gt(p/(p*(1-p)), q/(p*(1-p)))", "Gt(p, q)"]

# %% right: relation signs
lines_rise = ["p - q > 0", "p > q"]
