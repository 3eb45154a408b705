# %% wrong: nothing but the result
lines_t = ["Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)"]
J_second = "2*N"

# %% wrong: the inner derivative has the wrong sign in one place
lines_t = [
    "Eq(Sum(-2*(p[i] - q[i] + t), (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "2*N"

# %% wrong: the sum of t is taken for t
lines_t = [
    "Eq(Sum(-2*(p[i] - q[i] - t), (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
]
J_second = "2*N"

# %% wrong: truth and estimate are swapped on the way
lines_t = [
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(q[i], (i, 1, N)) - Sum(p[i], (i, 1, N)))",
    "Eq(t, (Sum(q[i], (i, 1, N)) - Sum(p[i], (i, 1, N)))/N)",
]
J_second = "2*N"

# %% wrong: the same line twice, to fill the list
lines_t = [
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "2*N"

# %% wrong: a step is left out
lines_t = [
    "Eq(Sum(-2*(p[i] - q[i] - t), (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "2*N"

# %% wrong: stops before the end
lines_t = [
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
]
J_second = "2*N"

# %% wrong: an equals sign instead of Eq
lines_t = [
    "Sum(p[i] - q[i] - t, (i, 1, N)) = 0",
    "N*t = Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N))",
    "t = (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N",
]
J_second = "2*N"

# %% wrong: sums without limits
lines_t = [
    "Eq(Sum(p - q - t), 0)",
    "Eq(N*t, Sum(p) - Sum(q))",
    "Eq(t, (Sum(p) - Sum(q))/N)",
]
J_second = "2*N"

# %% wrong: no list
lines_t = "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)"
J_second = "2*N"

# %% wrong: numbers instead of lines
lines_t = [0, -5]
J_second = "2*N"

# %% wrong: not closed brackets
lines_t = ["Eq(Sum(p[i] - q[i] - t, (i, 1, N), 0)"]
J_second = "2*N"

# %% wrong: the second derivative of one term
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "2"

# %% wrong: the second derivative with the sign of the inner derivative
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "-2*N"

# %% wrong: the second derivative is not carried out
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = "Derivative(Sum((p[i] - q[i] - t)**2, (i, 1, N)), t, t)"

# %% wrong: a number, not a text
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, (Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))/N)",
]
J_second = 2

# %% wrong: solved for t, but t is still on the right
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, Sum(p[i] - q[i], (i, 1, N))/N + t - Sum(t, (i, 1, N))/N)",
]
J_second = "2*N"

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
J_second = "2*N"

# %% right: the lecture's index k
lines_t = [
    "Eq(-2*Sum(p[k] - q[k] - t, (k, 1, N)), 0)",
    "Eq(Sum(p[k] - q[k] - t, (k, 1, N)), 0)",
    "Eq(N*t, Sum(p[k], (k, 1, N)) - Sum(q[k], (k, 1, N)))",
    "Eq(t, (Sum(p[k], (k, 1, N)) - Sum(q[k], (k, 1, N)))/N)",
]
J_second = "2*N"

# %% right: two means in the last line
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(t, Sum(p[i], (i, 1, N))/N - Sum(q[i], (i, 1, N))/N)",
]
J_second = "2*N"

# %% right: the mean of the differences, sides turned
lines_t = [
    "Eq(-2*Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(Sum(p[i] - q[i] - t, (i, 1, N)), 0)",
    "Eq(N*t, Sum(p[i], (i, 1, N)) - Sum(q[i], (i, 1, N)))",
    "Eq(Sum(p[i] - q[i], (i, 1, N))/N, t)",
]
J_second = "2*N"
