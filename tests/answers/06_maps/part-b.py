# %% wrong: nothing but the result
# says: every line follows, but you leap: 1 of at least 3 lines bring something new. Make one move
lines = ["(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))"]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: padded with a factor 1 and a term 0
# says: every line follows, but you leap: 1 of at least 3 lines bring something new. Make one move
lines = [
    "1*(u + v)/(1 + (u + v)/2) - u/(1 + u) - v/(1 + v)",
    "(u + v)/(1 + (u + v)/2) - u/(1 + u) - v/(1 + v) + 0",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: padded with forms of the result
# says: every line follows, but you leap: 2 of at least 3 lines bring something new. Make one move
lines = [
    "(u**2 - 2*u*v + v**2)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)*(u - v)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: the same line over and over
# says: line 1: This line is the same as the line before: the step changes nothing
lines = ["(u + v)/(1 + (u + v)/2) - u/(1 + u) - v/(1 + v)"] * 3 + [
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))"
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: fractions added by numerators and denominators
# says: line 1: wrong: at u = 1/2, v = 1/2 the line before is 0 and the line after is 1/3.
lines = [
    "2*(u + v)/(2 + u + v) - (u + v)/(2 + u + v)",
    "(u + v)/(2 + u + v)",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: a sign in 2u/(1 + u)
# says: line 1: wrong: at u = 1/4, v = 1/2 the line before is 2/165 and the line after is -2/165. 
lines = [
    "4/(2 + u + v) - 1/(1 + u) - 1/(1 + v)",
    "(4*(1 + u)*(1 + v) - (2 + u + v)**2)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: stops before the square
# says: the goal is not reached: the last line agrees with it, but does not have its form yet
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u**2 - 2*u*v + v**2)/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: products without signs
# says: line 1: unreadable: a bracket after a number or bracket: write * for a product
lines = ["2(u + v)/(2 + u + v) - u/(1 + u) - v/(1 + v)", "(u - v)^2"]
first, second = (0.1, 0.9), (0.45, 0.45)

# %% wrong: the steady mapper comes first
# says: first and second are swapped
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.45, 0.45), (0.1, 0.9)

# %% wrong: equal averages
# says: the average IoU is 0.5 for first, 0.5 for second.
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.1, 0.9), (0.5, 0.5)

# %% wrong: the first is better in both
# says: the average F1 is 0.918129 for first, 0.708333 for second.
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (0.8, 0.9), (0.5, 0.6)

# %% wrong: percent
# says: first, second: an IoU lies between 0 and 1.
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = (10, 90), (45, 45)

# %% wrong: one number instead of two
# says: first: a tuple of 2 results is asked, you have 0.5.
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]
first, second = 0.5, 0.45

# %% wrong: an IoU that is undefined
# says: first, second: an IoU lies between 0 and 1.
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

# %% wrong: the start rewritten twice, then a leap
# says: every line follows, but no line shows fractions put together, with what stands above not y
lines = [
    "2*(u+v)/(2+u+v) - u/(1+u) - v/(1+v)",
    "(2*u+2*v)/(u+v+2) - u/(u+1) - v/(v+1)",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]

# %% wrong: the start put in another order twice, then a leap
# says: every line follows, but you leap: 2 of at least 3 lines bring something new. Make one move
lines = [
    "-(u/(1+u) + v/(1+v)) + (u+v)/(1+(u+v)/2)",
    "-(u/(1+u) + v/(1+v)) + 2*(u+v)/(2+u+v)",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]

# %% wrong: the goal with a pair that cancels
# says: every line follows, but you leap: 1 of at least 3 lines bring something new. Make one move
lines = [
    "(u-v)**2/((1+u)*(1+v)*(2+u+v)) + 1/u - 1/u",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v)) + 1/v - 1/v",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]

# %% wrong: three fractions by division, then a leap
# says: every line follows, but you leap: 2 of at least 3 lines bring something new. Make one move
lines = [
    "2 - 4/(2 + u + v) - (1 - 1/(1 + u)) - (1 - 1/(1 + v))",
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: one fraction extended, then a leap
# says: every line follows, but no line shows fractions put together, with what stands above not y
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "(1 + v)/((1 + u)*(1 + v)) + 1/(1 + v) - 4/(2 + u + v)",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: a square more and less on top of the result
# says: every line follows, but no line shows fractions put together, with what stands above not y
lines = [
    "((u - v)**2 + (1 + u)**2 - 1 - 2*u - u**2)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u**2 - 2*u*v + v**2)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: halves of the result
# says: every line follows, but you leap: 1 of at least 3 lines bring something new. Make one move
lines = [
    "(u - v)**2/(2*(1 + u)*(1 + v)*(2 + u + v)) + (u - v)**2/(2*(1 + u)*(1 + v)*(2 + u + v))",
    "2*(u - v)**2/(2*(1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: the result with a factor more above and below
# says: every line follows, but you leap: 2 of at least 3 lines bring something new. Make one move
lines = [
    "(u - v)**2*(1 + u)/((1 + u)**2*(1 + v)*(2 + u + v))",
    "(u**2 - 2*u*v + v**2)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: a term is lost below
# says: line 1: wrong: at u = 1/2, v = 1/2 the line before is 0 and the line after is 1/3.
lines = [
    "2*(u + v)/(1 + u + v) - u/(1 + u) - v/(1 + v)",
    "((2 + u + v)**2 - 4*(1 + u)*(1 + v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: the first mapper has the larger average of both, the same numbers
# says: the average F1 is 0.918129 for first, 0.856209 for second.
first, second = (0.9, 0.8), (0.8, 0.7)

# %% wrong: equal mappers
# says: the average IoU is 0.5 for first, 0.5 for second.
first, second = (0.3, 0.7), (0.3, 0.7)

# %% wrong: three buildings
# says: first: a tuple of 2 results is asked, you have (0.1, 0.9, 0.5).
first, second = (0.1, 0.9, 0.5), (0.45, 0.45, 0.45)

# %% wrong: beyond one
# says: first, second: an IoU lies between 0 and 1.
first, second = (0, 1.2), (0.5, 0.5)

# %% right: three lines exactly, arrays, zero and one
lines = [
    "1/(1+u) + 1/(1+v) - 4/(2+u+v)",
    "((2+u+v)**2 - 4*(1+u)*(1+v))/((1+u)*(1+v)*(2+u+v))",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]
first, second = np.array([1.0, 0.0]), np.array([0.49, 0.49])

# %% right: two fractions first, then the third
lines = [
    "2*(u+v)/(2+u+v) - (u + v + 2*u*v)/((1+u)*(1+v))",
    "(2*(u+v)*(1+u)*(1+v) - (u + v + 2*u*v)*(2+u+v))/((1+u)*(1+v)*(2+u+v))",
    "(u**2 + v**2 - 2*u*v)/((1+u)*(1+v)*(2+u+v))",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]
first, second = (0, 1), (0.45, 0.5)

# %% right: pairs with reasons, the last fractions extended one by one
lines = [
    ("(1/(1+u) - 2/(2+u+v)) + (1/(1+v) - 2/(2+u+v))", "2u/(1+u) = 2 - 2/(1+u)"),
    ("(v-u)/((1+u)*(2+u+v)) + (u-v)/((1+v)*(2+u+v))", "two differences"),
    ("((v-u)*(1+v) + (u-v)*(1+u))/((1+u)*(1+v)*(2+u+v))", "one denominator"),
    ("(u-v)*((1+u) - (1+v))/((1+u)*(1+v)*(2+u+v))", "factor out"),
    ("(u-v)**2/((1+u)*(1+v)*(2+u+v))", "simplify"),
]

# %% right: the written form, three extended fractions
lines = """
    = 2*(u+v)/(2+u+v) - u/(1+u) - v/(1+v)    # times 2/2
    = 2*(u+v)*(1+u)*(1+v)/((1+u)*(1+v)*(2+u+v)) - u*(1+v)*(2+u+v)/((1+u)*(1+v)*(2+u+v)) - v*(1+u)*(2+u+v)/((1+u)*(1+v)*(2+u+v))
    = (u**2 - 2*u*v + v**2)/((1+u)*(1+v)*(2+u+v))   # multiplied out
    = (u-v)**2/((1+u)*(1+v)*(2+u+v))
"""

# %% right: the top multiplied out term by term, powers for fractions
lines = [
    "(1+u)**(-1) + (1+v)**(-1) - 4*(2+u+v)**(-1)",
    "((1+v)*(2+u+v) + (1+u)*(2+u+v) - 4*(1+u)*(1+v))/((1+u)*(1+v)*(2+u+v))",
    "(4 + 4*u + 4*v + u**2 + 2*u*v + v**2 - 4 - 4*u - 4*v - 4*u*v)/((1+u)*(1+v)*(2+u+v))",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]
first, second = [sp.Rational(1, 10), sp.Rational(9, 10)], [0.45, 0.45]

# %% right: names of other parts used up
u = v = J = 3
P, Q, a = 1, 2, 3
lines = [
    "1/(1 + u) + 1/(1 + v) - 4/(2 + u + v)",
    "(2 + u + v)/((1 + u)*(1 + v)) - 4/(2 + u + v)",
    "((2 + u + v)**2 - 4*(1 + u + v + u*v))/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% right: three divisions, the top multiplied out at once
lines = [
    "1/(1+u) + 1/(1+v) - 4/(2+u+v)",
    "(4 + 4*u + 4*v + u**2 + 2*u*v + v**2 - 4 - 4*u - 4*v - 4*u*v)/((1+u)*(1+v)*(2+u+v))",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]

# %% wrong: brackets and 1* only
# says: every line follows, but you leap: 1 of at least 3 lines bring something new. Make one move
lines = [
    "((u + v)/(1 + (u + v)/2)) - (u/(1 + u)) - (v/(1 + v))",
    "(u + v)/(1 + (u + v)/2) - (u/(1 + u) + v/(1 + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: goal split in three terms
# says: every line follows, but no line shows fractions put together, with what stands above not y
lines = [
    "u**2/((1 + u)*(1 + v)*(2 + u + v)) - 2*u*v/((1 + u)*(1 + v)*(2 + u + v)) + v**2/((1 + u)*(1 + v)*(2 + u + v))",
    "(u**2 - 2*u*v + v**2)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: goal with denominator multiplied out
# says: every line follows, but no line shows fractions put together, with what stands above not y
lines = [
    "(u - v)**2/((1 + u + v + u*v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(2 + u + v + 2*v + u*v + v**2))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: goal with other squares
# says: every line follows, but no line shows fractions put together, with what stands above not y
lines = [
    "((u + v)**2 - 4*u*v)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u**2 - 2*u*v + v**2)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: padded by a common factor
# says: every line follows, but you leap: 1 of at least 3 lines bring something new. Make one move
lines = [
    "(u - v)**2*(1 + u)*(1 + v)/((1 + u)**2*(1 + v)**2*(2 + u + v))",
    "(u - v)*(u - v)/((1 + u)*(1 + v)*(2 + u + v))",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% wrong: given and fractions that cancel
# says: every line follows, but no line shows fractions put together, with what stands above not y
lines = [
    "(u + v)/(1 + (u + v)/2) - u/(1 + u) - v/(1 + v) + 1/((1 + u)*(1 + v)) - 1/((1 + u)*(1 + v))",
    "2*(u + v)/(2 + u + v) - u/(1 + u) - v/(1 + v)",
    "(u - v)**2/((1 + u)*(1 + v)*(2 + u + v))",
]

# %% right: half sums
lines = [
    "2*(u+v)/(2+u+v) - (u*(1+v) + v*(1+u))/((1+u)*(1+v))",
    "2*(u+v)/(2+u+v) - (u + v + 2*u*v)/(1 + u + v + u*v)",
    "(2*(u+v)*(1+u+v+u*v) - (u+v+2*u*v)*(2+u+v))/((1+u)*(1+v)*(2+u+v))",
    "((u+v)**2 - 4*u*v)/((1+u)*(1+v)*(2+u+v))",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]

# %% right: reciprocal sums, denominators expanded
lines = [
    "1/(1+u) + 1/(1+v) - 2/(1 + (u+v)/2)",
    "(2+u+v)/(1+u+v+u*v) - 2/(1+(u+v)/2)",
    "((2+u+v)*(1+(u+v)/2) - 2*(1+u+v+u*v))/((1+u+v+u*v)*(1+(u+v)/2))",
    "((u+v)**2/2 - 2*u*v)/((1+u)*(1+v)*(1+(u+v)/2))",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]

# %% right: only pairs of fractions, then factored
lines = [
    "(u/(1+(u+v)/2) - u/(1+u)) + (v/(1+(u+v)/2) - v/(1+v))",
    "u*(u-v)/((1+u)*(2+u+v)) + v*(v-u)/((1+v)*(2+u+v))",
    "(u-v)*(u*(1+v) - v*(1+u))/((1+u)*(1+v)*(2+u+v))",
    "(u-v)**2/((1+u)*(1+v)*(2+u+v))",
]

# %% right: sympy objects
u, v = sp.symbols("u v", positive=True)
D = (1 + u) * (1 + v) * (2 + u + v)
lines = [
    1 / (1 + u) + 1 / (1 + v) - 4 / (2 + u + v),
    ((2 + u + v) ** 2 - 4 * (1 + u) * (1 + v)) / D,
    (u - v) ** 2 / D,
]
