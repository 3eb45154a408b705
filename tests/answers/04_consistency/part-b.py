# %% wrong: nothing but the results
lines_z = ["(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["n"]

# %% wrong: the inverse keeps the order
lines_z = ["e.T*L.inv()*L.T.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: stops before the square of a length
lines_z = ["e.T*L.T.inv()*L.inv()*e"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: the sign of F
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: F is the density
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: F by the rule for powers
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "z**3/3*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1, (i, 1, n))",
    "n",
]

# %% wrong: each square has the mean one half
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = [
    "Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))",
    "Sum(1/2, (i, 1, n))",
    "n/2",
]

# %% wrong: leaps over the integration by parts
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["Sum(1, (i, 1, n))", "n"]

# %% wrong: the sum is forgotten
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo))", "1"]

# %% wrong: g is not written out
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*g"
lines_mean = ["Sum(Integral(g, (z, -oo, oo)), (i, 1, n))", "Sum(1, (i, 1, n))", "n"]

# %% wrong: NumPy's transposition sign
lines_z = ["e.T @ L.T.inv() @ L.inv() @ e", "(L^-1 e)^T (L^-1 e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["n"]

# %% wrong: the last lines are missing
lines_z = ["e.T*L.T.inv()*L.inv()*e", "(L.inv()*e).T*(L.inv()*e)"]
F = "-z*exp(-z**2/2)/sqrt(2*pi)"
lines_mean = ["Sum(Integral(exp(-z**2/2)/sqrt(2*pi), (z, -oo, oo)), (i, 1, n))"]

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
