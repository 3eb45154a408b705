# %% wrong: nothing but the result
lines_tau = ["Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))"]
J_second = "2*Sum(u[i]**2, (i, 1, N))"
undetermined_at = 0

# %% wrong: the inner derivative is forgotten
lines_tau = [
    "Eq(Sum(2*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]
J_second = "2*Sum(u[i]**2, (i, 1, N))"
undetermined_at = 0

# %% wrong: the sign of tau slips
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(-tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]
J_second = "2*Sum(u[i]**2, (i, 1, N))"
undetermined_at = 0

# %% wrong: the square of a sum for the sum of squares
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i], (i, 1, N))**2, Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]
J_second = "2*Sum(u[i]**2, (i, 1, N))"
undetermined_at = 0

# %% wrong: stops before the end
lines_tau = ["Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)"]
J_second = "2*Sum(u[i]**2, (i, 1, N))"
undetermined_at = 0

# %% wrong: u leaves the sum
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i], (i, 1, N)), Sum(p[i] - q[i], (i, 1, N)))",
]
J_second = "2*Sum(u[i]**2, (i, 1, N))"
undetermined_at = 0

# %% wrong: the second derivative of the usual square
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]
J_second = "2*N"
undetermined_at = 0

# %% wrong: the second derivative without its 2
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]
J_second = "Sum(u[i]**2, (i, 1, N))"
undetermined_at = 0

# %% wrong: the wrong degenerate value
lines_tau = [
    "Eq(Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)), 0)",
    "Eq(tau*Sum(u[i]**2, (i, 1, N)), Sum(u[i]*(p[i] - q[i]), (i, 1, N)))",
]
J_second = "2*Sum(u[i]**2, (i, 1, N))"
undetermined_at = 1

# %% wrong: an equals sign instead of Eq
lines_tau = [
    "Sum(u[i]*(p[i] - q[i] - tau*u[i]), (i, 1, N)) = 0",
    "tau*Sum(u[i]**2, (i, 1, N)) = Sum(u[i]*(p[i] - q[i]), (i, 1, N))",
]
J_second = "2*Sum(u[i]**2, (i, 1, N))"
undetermined_at = 0

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
undetermined_at = 0
