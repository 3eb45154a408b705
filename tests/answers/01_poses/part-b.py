# %% wrong: nothing but the result
# says: the sum set to zero is not among the lines
lines_tau = ["Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))"]

# %% wrong: padded, and the sum that is asked left out
# says: the sum set to zero is not among the lines
lines_tau = [
    "Eq(2*Derivative(Sum((p[i] - q[i] - tau*u[i])**2, (i, 1, N)), tau)/2, 0)",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]

# %% wrong: the inner derivative is forgotten
# says: line 1: wrong
lines_tau = [
    "Eq(Sum(2*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]

# %% wrong: the sign of tau slips
# says: line 2: wrong
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(-tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]

# %% wrong: the square of a sum for the sum of squares
# says: line 2: wrong
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i], (i, 1, N))**2, Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]

# %% wrong: stops before the end
# says: the goal is not reached
lines_tau = ["Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)"]

# %% wrong: u leaves the sum
# says: line 2: wrong
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i], (i, 1, N)), Sum(p[i] - q[i], (i, 1, N)))",
]

# %% wrong: an equals sign instead of Eq
# says: Eq(left, right)
lines_tau = [
    "Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)) = 0",
    "tau*Sum(u[i]**2, (i, 1, N)) = Sum(u[i]*(p[i] - q[i]), (i, 1, N))",
]

# %% wrong: a number
# says: a list of lines is asked
lines_tau = 0

# %% wrong: the second derivative of the usual square
# says: the inner derivative is forgotten both times
J_second = "2*N"

# %% wrong: the second derivative without its 2
# says: the factor 2 of the square is lost
J_second = "Sum(u[i]**2, (i, 1, N))"

# %% wrong: the second derivative with the sign of the first
# says: the sign is turned
J_second = "-2*Sum(u[i]**2, (i, 1, N))"

# %% wrong: one inner derivative alone
# says: the inner derivative is forgotten once
J_second = "-2*Sum(u[i], (i, 1, N))"

# %% wrong: the square of the sum
# says: the square of the sum for the sum of the squares
J_second = "2*Sum(u[i], (i, 1, N))**2"

# %% wrong: u is not squared, its sign is right
# says: the inner derivative is forgotten once
J_second = "2*Sum(u[i], (i, 1, N))"

# %% wrong: the first derivative
# says: this is the first derivative
J_second = "-2*Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N))"

# %% wrong: the operator still stands
# says: Derivative still stands in your formula
J_second = "Derivative(-2*Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), tau)"

# %% wrong: with a left side
# says: enter the right side alone
J_second = "J'' = 2*Sum(u[i]**2, (i, 1, N))"

# %% wrong: the wrong degenerate value
# says: undetermined_at: 1 is not right
undetermined_at = 1

# %% wrong: no value
# says: numbers are asked
undetermined_at = "nowhere"

# %% right: in two lines
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]
J_second = "Sum(2*u[k]**2, (k, 1, N))".replace("k", "i")
undetermined_at = 0.0

# %% right: the given line repeated, and the sum split
lines_tau = [
    "Eq(Derivative(Sum((p[i] - q[i] - tau*u[i])**2, (i, 1, N)), tau), 0)",
    "Eq(-2*Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(Sum(u[i]*(p[i] - q[i]), (i, 1, N)) - tau*Sum(u[i]**2, (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]
J_second = "2*Sum(u[i]*u[i], (i, 1, N))"

# %% right: in the written form, with signs and reasons
lines_tau = """
    <=> Eq(-2*Sum(u[i]*(p[i] - q[i] - tau*u[i]), i), 0)   # chain rule
    <=> Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), i), 0)      # divide by -2
    <=> Eq(tau*Sum(u[i]**2, i), Sum(u[i]*(p[i] - q[i]), i))  # tau leaves the sum
"""

# %% right: pairs of line and reason, factors exchanged
lines_tau = [
    ("Eq(0, Sum((p[i] - q[i] - tau*u[i])*u[i], (i, 1, N)))", "divided by -2"),
    ("Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))", "split"),
]

# %% right: another letter in the second derivative
J_second = "2*Sum(u[k]**2, (k, 1, N))"
undetermined_at = "0"

# %% right: the second derivative as SymPy's object
import sympy as sp
i, N = sp.symbols("i N", integer=True)
J_second = sp.Sum(2 * sp.IndexedBase("u")[i] ** 2, (i, 1, N))
undetermined_at = sp.Integer(0)
