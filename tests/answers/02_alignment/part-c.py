# %% wrong: the cross product has the wrong sign
C_and_S = ["u*a + v*b", "u*b - v*a"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C)"

# %% wrong: the cross product is taken for a scalar product
C_and_S = ["u*a + v*b", "u*b + v*a"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C)"

# %% wrong: the factor 2 is in the brackets as well
C_and_S = ["2*(u*a + v*b)", "2*(v*a - u*b)"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C)"

# %% wrong: C and S are swapped
C_and_S = ["v*a - u*b", "u*a + v*b"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C)"

# %% wrong: S is missing
C_and_S = ["u*a + v*b"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C)"

# %% wrong: the angle is still in C
C_and_S = ["u*a + v*b*cos(theta)", "v*a - u*b"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C)"

# %% wrong: the derivative of the cosine keeps its sign
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = [
    "Eq(-2*(C*sin(theta) + S*cos(theta)), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C)"

# %% wrong: the ratio is upside down
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = ["Eq(C*sin(theta), S*cos(theta))", "Eq(tan(theta), C/S)"]
theta_min = "atan2(S, C)"

# %% wrong: nothing but the result
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = ["Eq(tan(theta), S/C)"]
theta_min = "atan2(S, C)"

# %% wrong: one of the two stationary angles is lost in the chain
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = [
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(theta, atan2(S, C))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C)"

# %% wrong: atan instead of atan2
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan(S/C)"

# %% wrong: the arguments of atan2 are swapped
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(C, S)"

# %% wrong: the maximum
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(-S, -C)"

# %% wrong: the sign of the angle
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "-atan2(S, C)"

# %% wrong: acos knows no sign
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "acos(C/sqrt(C**2 + S**2))"

# %% wrong: NumPy's spelling
C_and_S = ["u*a + v*b", "v*a - u*b"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "np.arctan2(S, C)"

# %% wrong: the lecture's names for the estimate
C_and_S = ["u*uhat + v*vhat", "v*uhat - u*vhat"]
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C)"

# %% wrong: a constant
C_and_S = ["0", "0"]
lines_theta = ["Eq(0, 0)"]
theta_min = "0"

# %% right: longer, other order
C_and_S = ("b*v + a*u", "-(u*b - a*v)")
lines_theta = [
    "Eq(Derivative(B, theta) - 2*Derivative(C*cos(theta) + S*sin(theta), theta), 0)",
    "Eq(-2*(-C*sin(theta) + S*cos(theta)), 0)",
    "Eq(C*sin(theta) - S*cos(theta), 0)",
    "Eq(S*cos(theta), C*sin(theta))",
    "Eq(sin(theta)/cos(theta), S/C)",
    "Eq(tan(theta), S/C)",
]
theta_min = "atan2(S, C) + 2*pi"

# %% right: the half angle, which needs no quadrant
C_and_S = ["u*a + v*b", "a*v - b*u"]
lines_theta = [
    "Eq(C*sin(theta) - S*cos(theta), 0)",
    "Eq(sin(theta)/cos(theta), S/C)",
    "Eq(S/C, tan(theta))",
]
theta_min = "2*atan2(S, C + sqrt(C**2 + S**2))"
