# %% wrong: nothing but the result
lines = ["(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))"]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: padded with a factor 1 and a term 0
lines = [
    "1*(u + v)/(1 + (u + v)/2) - u/(1 + u) - v/(1 + v)",
    "(u + v)/(1 + (u + v)/2) - u/(1 + u) - v/(1 + v) + 0",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: padded with forms of the result
lines = [
    "(u**2 - 2*u*v + v**2)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)*(u - v)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: the same line over and over
lines = ["(u + v)/(1 + (u + v)/2) - u/(1 + u) - v/(1 + v)"] * 3 + [
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))"
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: fractions added by numerators and denominators
lines = [
    "2*(u + v)/(2 + u + v) - (u + v)/(2 + u + v)",
    "(u + v)/(2 + u + v)",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: a sign in 2u/(1 + u)
lines = [
    "4/(2 + u + v) - 1/(1 + u) - 1/(1 + v)",
    "(4*(1 + u)*(1 + v) - (2 + u + v)**2)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: stops before the square
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u**2 - 2*u*v + v**2)/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: products without signs
lines = ["2(u + v)/(2 + u + v) - u/(1 + u) - v/(1 + v)", "(u - v)^2"]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: the steady mapper comes first
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.45, 0.45), (0.1, 0.9)

# %% wrong: equal averages
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.5, 0.5)

# %% wrong: the first is better in both
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.8, 0.9), (0.5, 0.6)

# %% wrong: percent
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (10, 90), (45, 45)

# %% wrong: one number instead of two
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = 0.5, 0.45

# %% wrong: an IoU that is undefined
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (np.nan, 0.5), (0.45, 0.45)

# %% right: a common denominator at once
lines = [
    "2*(u + v)/(2 + u + v) - u/(1 + u) - v/(1 + v)",
    "(2*(u + v)*(1 + u)*(1 + v) - (u*(1 + v) + v*(1 + u))*(2 + u + v))"
    "/((1 + u)*(1 + v)*(2 + u + v))",
    "(u**2 + v**2 - 2*u*v)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = [1, 0], [0.4, 0.4]

# %% right: the given line repeated, divisions one after the other
lines = [
    "(u+v)/(1+(u+v)/2)-u/(1+u)-v/(1+v)",
    "1 - 1 + 1/(1+u) + 1/(1+v) - 4/(2+u+v)",
    "((1+u) + (1+v))/((1+u)*(1+v)) - 4/(2+u+v)",
    "((2+u+v)*(2+u+v) - 4*(1+u)*(1+v))/(1+u)/(1+v)/(2+u+v)",
    "((1+u) - (1+v))**2/((1+u)*(1+v)*(2+u+v))",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]
first, second = (0.95, 0.2), (0.56, 0.57)

# %% right: two differences, each with a factor u - v
lines = [
    "(1/(1 + u) - 2/(2 + u + v)) + (1/(1 + v) - 2/(2 + u + v))",
    "(u - v)/(2 + u + v)*(1/(1 + v) - 1/(1 + u))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)
