# %% wrong: nothing but the results
# says: lines_z: every line follows, but you leap: 1 of at least 2 lines
lines_z = ["(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["n"]

# %% wrong: the inverse keeps the order
# says: lines_z: line 1: wrong
lines_z = ["e.T*L.inv()*L.T.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: stops before the square of a length
# says: lines_z: the goal is not reached: the last line agrees with it, but does not have its form
lines_z = ["e.T*L.T.inv()*L.inv()*e"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: the sign of F
# says: its sign is turned
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: F is the density
# says: you took g alone
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: F by the rule for powers
# says: you used the rule for powers, with g as a constant
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "z**3/3*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: each square has the mean one half
# says: lines_mean: line 2: wrong
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1/2, (i, 1, n))",
    "n/2",
]

# %% wrong: leaps over the integration by parts
# says: lines_mean: every line follows, but you leap: 2 of at least 3 lines
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["Sum(1, (i, 1, n))", "n"]

# %% wrong: the sum is forgotten
# says: lines_mean: line 1:
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo))", "1"]

# %% wrong: NumPy's transposition sign
# says: lines_z: line 2: unreadable
lines_z = ["e.T @ L.T.inv() @ L.inv() @ e", "(L^-1 e)^T (L^-1 e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["n"]

# %% wrong: the last lines are missing
# says: lines_mean: the goal is not reached: the last line agrees with it, but does not have its f
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))"]

# %% wrong: pads with the transpose of a number, then leaps
# says: lines_z: every line follows, but no line has the inverse of the product taken apart, with
lines_z = ["(e.T*(L*L.T).inv()*e).T", "(L.inv()*e).T*(L.inv()*e)"]
lines_mean = ["Sum(Integral(g, (z, -oo, oo)), (i, 1, n))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: pads with a factor 2/2, then leaps
# says: lines_z: every line follows, but you leap: 1 of at least 2 lines
lines_z = ["2*e.T*(L*L.T).inv()*e/2", "(L.inv()*e).T*(L.inv()*e)"]
lines_mean = ["Sum(Integral(g, (z, -oo, oo)), (i, 1, n))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: pads with a double transpose, then leaps
# says: lines_z: every line follows, but you leap: 1 of at least 2 lines
lines_z = ["e.T.T.T*(L*L.T).inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
lines_mean = ["Sum(Integral(g, (z, -oo, oo)), (i, 1, n))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: pads with plus and minus the same, then leaps
# says: lines_z: every line follows, but no line has the inverse of the product taken apart, with
lines_z = ["e.T*(L*L.T).inv()*e + e.T*e - e.T*e", "(L.inv()*e).T*(L.inv()*e)"]
lines_mean = ["Sum(Integral(g, (z, -oo, oo)), (i, 1, n))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: pads with two minus signs, then leaps
# says: lines_z: every line follows, but no line has the inverse of the product taken apart, with
lines_z = ["(-e).T*(L*L.T).inv()*(-e)", "(L.inv()*e).T*(L.inv()*e)"]
lines_mean = ["Sum(Integral(g, (z, -oo, oo)), (i, 1, n))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: pads with an identity matrix, then leaps
# says: lines_z: every line follows, but you leap: 1 of at least 2 lines
lines_z = ["e.T*eye(2)*(L*L.T).inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
lines_mean = ["Sum(Integral(g, (z, -oo, oo)), (i, 1, n))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: no integration by parts, n in and out
# says: lines_mean: every line follows, but nothing was integrated by parts. After that step the s
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
lines_mean = ["n*Integral(z**2*g, (z, -oo, oo))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: half of the integral, then the answer
# says: lines_mean: every line follows, but nothing was integrated by parts. After that step the s
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
lines_mean = ["Sum(2*Integral(z**2*g, (z, 0, oo)), (i, 1, n))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: no integral, n written in two ways
# says: lines_mean: every line follows, but you leap: 2 of at least 3 lines
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
lines_mean = ["Sum(1, (i, 1, n))", "n*2/2", "n"]

# %% right: the written form, with signs and reasons
lines_z = """
    = e.T*L.T.inv()*L.inv()*e        # the order turns around
    = (e.T*L.inv().T)*(L.inv()*e)    # transpose and inverse change places
    = (L.inv()*e).T*(L.inv()*e)      # transpose of a product
"""
lines_mean = """
    = Sum(Integral(z*Derivative(-g, z), (z, -oo, oo)), (i, 1, n))  # z*g is the derivative of -g
    = Sum(Integral(g, (z, -oo, oo)), (i, 1, n))                    # by parts
    = Sum(1, (i, 1, n))                                            # total probability
    = n                                                            # n ones
"""

# %% right: pairs of line and reason, inv as a function
lines_z = [
    ("e.T*inv(L.T)*inv(L)*e", "the order turns around"),
    ("(inv(L)*e).T*(inv(L)*e)", "transpose of a product"),
]
F = "-z*g + 7"
lines_mean = [
    ("n*Integral(z**2*g, (z, -oo, oo))", "equal terms"),
    ("n*Integral(g, (z, -oo, oo))", "by parts"),
    ("n*1", "total probability"),
    ("n", "times one"),
]

# %% right: SymPy objects
import sympy as sp

z_s, n_s, i_s = sp.Symbol("z"), sp.Symbol("n"), sp.Symbol("i")
density = sp.exp(-(z_s**2) / 2) / sp.sqrt(2 * sp.pi)
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = -z_s * density
lines_mean = [
    sp.Sum(sp.Integral(density, (z_s, -sp.oo, sp.oo)), (i_s, 1, n_s)),
    sp.Sum(1, (i_s, 1, n_s)),
    n_s,
]

# %% right: longer, the given lines repeated, a constant in F
lines_z = [
    "e.T*(L*L.T).inv()*e",
    "e.T*L.T.inv()*L.inv()*e",
    "(e.T*L.inv().T)*(L.inv()*e)",
    "(L.inv()*e).T*(L.inv()*e)",
]
F = "5 - z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(z**2*exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% right: the sum of equal integrals first
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-(1/sqrt(2*pi))*z*exp(-(z**2)/2)"
lines_mean = [
    "n*Integral(z**2*exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo))",
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: the inverse of a product left in the middle
# says: lines_z: every line follows, but no line has the inverse of the product taken apart, with
lines_z = ["e.T*(L*L.T).inv()*L*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]

# %% wrong: by parts, with something that does not vanish beside it
# says: lines_mean: every line follows, but nothing was integrated by parts. After that step the s
lines_mean = ["n - 1 + Integral(g, (z, -oo, oo))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: F' instead of F
# says: this is F', not F
F = "z**2*g - g"

# %% wrong: F for z*g
# says: you integrated z*g, not what is asked
F = "-g"

# %% wrong: F as an integral
# says: F is unreadable: Integral needs limits: Integral(expression, (variable, from, to))
F = "Integral(z**2*g - g, z)"

# %% wrong: F with an equals sign
# says: F: enter the right side alone, without an equals sign and a left side.
F = "F = -z*g"

# %% right: one line with the limits of the first term
lines_mean = [
    "Sum(-Limit(z*g, z, oo) + Limit(z*g, z, -oo) + Integral(g, (z, -oo, oo)), (i, 1, n))",
    "Sum(Integral(g, (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% right: the transpose of the inverse
lines_z = ["e.T*L.inv().T*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]

# %% right: brackets, and the letters of other parts
e, P, z, n, g, i = 1, 2, 3, 4, 5, 6
lines_z = ["e.T*(L.T.inv()*(L.inv()*e))", "(L.inv()*e).T*(L.inv()*e)"]
