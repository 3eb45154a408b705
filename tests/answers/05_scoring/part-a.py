# %% wrong: the sign of the derivative of log(1 - p)
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
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: fractions added by their parts
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
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: the derivative of log p is log p
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
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: leaps to the result
lines_slope = [
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: two lines copied from the lecture
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: padded with zeros and ones
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
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: padded by the order of the factors
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
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: padded with a zero in the numerator and a one below
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
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: stops before the goal
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
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: quotient rule without the second term
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "1/(p*(1-p))",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: quotient rule with the terms exchanged
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "((p-q)*(1-2*p) - p*(1-p))/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: the minus of the inner derivative is lost
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "Derivative((1-q)/(1-p) - q/p, p)",
    "q/p**2 - (1-q)/(1-p)**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: the curvature in one leap
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: multiplies the inequality by something negative
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(q - p, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: an inequality the other way round
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Lt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: an equation instead of the inequality
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Eq(p - q, 0)",
    "Eq(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: the sign in one leap
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: the sign, padded
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt((p-q)/(p*(1-p)) + 0, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: a local minimum is taken for the only one
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, True, True, True, False)

# %% wrong: any point with slope zero is the minimum
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (True, True, True, True, True)

# %% wrong: a single stationary point is taken for a minimum
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = [False, False, True, True, True]

# %% wrong: believes in second derivatives only
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, False, False)

# %% wrong: the numbers of the sentences
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = [3, 4]

# %% wrong: the lines only
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "((1-q)*p - q*(1-p))/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = ...

# %% wrong: LaTeX instead of Python
lines_slope = [
    r"\frac{p-q}{p(1-p)}",
]
lines_curvature = [
    "(p*(1-p) - (p-q)*(1-2*p))/(p*(1-p))**2",
    "(q*(1-p)**2 + (1-q)*p**2)/(p*(1-p))**2",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% wrong: implied products
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
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

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
enough = (False, False, True, True, False)

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
enough = (False, False, True, True, False)

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
lines_curvature = [
    "Derivative((1-q)/(1-p) - q/p, p)",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% right: both fractions brought to the common denominator
lines_slope = [
    "(1-q)/(1-p) - q/p",
    "p*(1-q)/(p*(1-p)) - q*(1-p)/(p*(1-p))",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "Derivative((1-q)/(1-p) - q/p, p)",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)

# %% right: begins with the inner derivative written out
lines_slope = [
    "-q/p - (1-q)/(1-p)*(-1)",
    "(1-q)/(1-p) - q/p",
    "(p-q)/(p*(1-p))",
]
lines_curvature = [
    "Derivative((1-q)/(1-p) - q/p, p)",
    "q/p**2 + (1-q)/(1-p)**2",
]
lines_rise = [
    "Gt(p - q, 0)",
    "Gt(p, q)",
]
enough = (False, False, True, True, False)
