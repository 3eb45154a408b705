# %% wrong: nothing but the result
# says: every line follows, but you leap: 1 of at least 4 lines bring something new. Make one move
lines_t = ["Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)"]

# %% wrong: the inner derivative has the wrong sign in one place
# says: line 1: wrong: t = 3.3333333, N = 1, p[1] = 1, q[1] = -2 holds in the line before but not 
lines_t = [
    "Eq(Sum(-2*(p[i] - q[i] + t), (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]

# %% wrong: the sum of t is taken for t
# says: line 3: wrong: t = 3.3333333, N = 2, p[1] = 1, p[2] = 1, q[1] = -2, q[2] = -4 holds in the
lines_t = [
    "Eq(Sum(-2*(p[i] - q[i] - t), (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
]

# %% wrong: truth and estimate are swapped on the way
# says: line 2: wrong: t = 3.3333333, N = 1, p[1] = 1, q[1] = -2 holds in the line before but not 
lines_t = [
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(q[i], (i, 1, N)) - Sum(p[i], (i, 1, N)))",
    "Eq(t, (Sum(q[i], (i, 1, N)) - Sum(p[i], (i, 1, N)))/N)",
]

# %% wrong: the same line twice, to fill the list
# says: line 2: This line is the same as the line before: the step changes nothing
lines_t = [
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]

# %% wrong: a step is left out
# says: every line follows, but you leap: 3 of at least 4 lines bring something new. Make one move
lines_t = [
    "Eq(Sum(-2*(p[i] - q[i] - t), (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]

# %% wrong: stops before the end
# says: the goal is not reached: the last line agrees with it, but does not have its form yet
lines_t = [
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
]

# %% wrong: an equals sign instead of Eq
# says: line 1: unreadable: write an equation as left == right, or Eq(left, right)
lines_t = [
    "Sum(p[i] - q[i] - t, (i, 1, N)) = 0",
    "N*t = Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N))",
    "t = (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N",
]

# %% wrong: sums without limits
# says: line 1: unreadable: Sum needs limits: Sum(expression, (variable, from, to))
lines_t = [
    "Eq(Sum(p - q - t), 0)",
    "Eq(N*t, Sum(p) - Sum(q))",
    "Eq(t, (Sum(p) - Sum(q))/N)",
]

# %% wrong: no list
# says: every line follows, but you leap: 1 of at least 4 lines bring something new. Make one move
lines_t = "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)"

# %% wrong: numbers instead of lines
# says: line 1: a string is asked, you have 0.
lines_t = [0, -5]

# %% wrong: not closed brackets
# says: line 1: unreadable: the brackets do not match
lines_t = ["Eq(Sum(p[i] - q[i] - t, (i, 1, N), 0)"]

# %% wrong: the second derivative of one term
# says: this is the second derivative of one term
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "2"

# %% wrong: the second derivative with the sign of the inner derivative
# says: the inner derivative keeps a sign
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "-2*N"

# %% wrong: the second derivative is not carried out
# says: J_second: Derivative still stands in your formula. Carry it out.
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "Derivative(Sum((p[i] - q[i] - t)**2, (i, 1, N)), t, t)"

# %% wrong: a number, not a text
# says: this is the second derivative of one term
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = 2

# %% wrong: solved for t, but t is still on the right
# says: the goal is not reached: the last line agrees with it, but does not have its form yet
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, Sum(p[i] - q[i], (i, 1, N))/N + t - Sum(t, (i, 1, N))/N)",
]

# %% right: shortest, with the zero on the left and the sides turned
lines_t = [
    "Eq(0, 2*Sum(t - p[i] + q[i], (i, 1, N)))",
    "Eq(0, Sum(p[i] - q[i] - t, (i, 1, N)))",
    "Eq(Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)), N*t)",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "N + N"

# %% right: longer, another index, the factor 2 kept for a while, the given line repeated
lines_t = [
    "Eq(Derivative(Sum((p[i] - q[i] - t)**2, (i, 1, N)), t), 0)",
    "Eq(Sum(2*(p[i] - q[i] - t)*(-1), (i, 1, N)), 0)",
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i], (i, 1, N)) - Sum(t, (i, 1, N)), 0)",
    "Eq(Sum(p[k] - q[k], (k, 1, N)) - N*t, 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]

# %% right: the lecture's index k
lines_t = [
    "Eq(-2*Sum(p[k] - q[k] - t, (k, 1, N)), 0)",
    "Eq(Sum(p[k] - q[k] - t, (k, 1, N)), 0)",
    "Eq(N*t, Sum(p[k], (k, 1, N)) - Sum(q[k], (k, 1, N)))",
    "Eq(t, (Sum(p[k], (k, 1, N)) - Sum(q[k], (k, 1, N)))/N)",
]

# %% right: two means in the last line
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, Sum(p[i], (i, 1, N))/N - Sum(q[i], (i, 1, N))/N)",
]

# %% right: the mean of the differences, sides turned
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(Sum(p[i] - q[i], (i, 1, N))/N, t)",
]

# %% wrong: the given line halved and turned, then a leap
# says: every line follows, but you leap: 2 of at least 4 lines bring something new. Make one move
lines_t = [
    "Eq(Derivative(Sum((p[i] - q[i] - t)**2, (i, 1, N)), t)/2, 0)",
    "Eq(0, Derivative(Sum((p[i] - q[i] - t)**2, (i, 1, N)), t))",
    "Eq(Derivative(Sum((t - p[i] + q[i])**2, (i, 1, N)), t), 0)",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]

# %% wrong: padded at the end
# says: every line follows, but no line has the derivative carried out inside the sum.
lines_t = [
    "Eq(t, Sum(p[i] - q[i], (i, 1, N))/N)",
    "Eq(2*t, 2*Sum(p[i] - q[i], (i, 1, N))/N)",
    "Eq(t, Sum(p[i], (i, 1, N))/N - Sum(q[i], (i, 1, N))/N)",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]

# %% wrong: the sum written three ways, then a leap
# says: every line follows, but you leap: 3 of at least 4 lines bring something new. Make one move
lines_t = [
    "Eq(Sum(-2*(p[i] - q[i] - t), (i, 1, N)), 0)",
    "Eq(Sum(2*(t - p[i] + q[i]), (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]

# %% wrong: the factor N is forgotten
# says: line 3: wrong: t = 3.3333333, N = 2, p[1] = 1, p[2] = 1, q[1] = -2, q[2] = -4 holds in the
lines_t = [
    "Eq(Sum(-2*(p[i] - q[i] - t), (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)) - t, 0)",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]

# %% wrong: the factor of the square is lost
# says: the factor of the square is lost
J_second = "N"

# %% wrong: the factor of the square twice
# says: the factor of the square is in it twice
J_second = "4*N"

# %% wrong: the first derivative
# says: this is the first derivative
J_second = "2*N*t - 2*Sum(p[i] - q[i], (i, 1, N))"

# %% wrong: zero, as at a minimum
# says: it is zero at the minimum, and that is the slope
J_second = 0

# %% right: expanded first, pairs with reasons
lines_t = [
    (
        "Eq(Derivative(Sum((p[i] - q[i])**2, (i, 1, N)) - 2*t*Sum(p[i] - q[i], (i, 1, N)) + N*t**2, t), 0)",
        "expand the square",
    ),
    ("Eq(-2*Sum(p[i] - q[i], (i, 1, N)) + 2*N*t, 0)", "differentiate"),
    ("Eq(N*t, Sum(p[i] - q[i], (i, 1, N)))", "divide by 2"),
    ("Eq(t, Sum(p[i] - q[i], (i, 1, N))/N)", "divide by N"),
    ("Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)", "split the sum"),
]

# %% right: the numbers kept to the end, a SymPy object
import sympy

lines_t = [
    "Eq(Sum(-2*(p[i] - q[i] - t), (i, 1, N)), 0)",
    "Eq(2*Sum(q[i] + t - p[i], (i, 1, N)), 0)",
    "Eq(-2*Sum(p[i], (i, 1, N)) + 2*Sum(q[i], (i, 1, N)) + 2*N*t, 0)",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = 2 * sympy.Symbol("N")

# %% right: names of other parts used up
t = N = p = q = J = 0
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i] - q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
