# %% wrong: the cross product has the wrong sign
# says: the sign is turned
C_and_S = ["u*a + v*b", "u*b - v*a"]

# %% wrong: the cross product is taken for a scalar product
# says: a sign inside is turned
C_and_S = ["u*a + v*b", "u*b + v*a"]

# %% wrong: the factor 2 is in the brackets as well
# says: the 2 is in it twice
C_and_S = ["2*(u*a + v*b)", "2*(v*a - u*b)"]

# %% wrong: C and S are swapped
# says: C_k and S_k are swapped
C_and_S = ["v*a - u*b", "u*a + v*b"]

# %% wrong: S is missing
# says: S_k: there is no answer yet. Replace the dots.
C_and_S = ["u*a + v*b"]

# %% wrong: the angle is still in C
# says: C_k is unreadable: theta is not declared; did you mean beta? This part knows the names u, 
C_and_S = ["u*a + v*b*cos(theta)", "v*a - u*b"]

# %% wrong: the derivative of the cosine keeps its sign
# says: line 1: wrong: B = 1, C = -0.59162583, S = 1, theta = 1 holds in the line before but not i
lines_theta = [
    "Eq(-2*(C*sin(theta) + S*cos(theta)), 0)",
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(tan(theta), S/C)",
]

# %% wrong: the ratio is upside down
# says: line 2: wrong: C = -cos(2)/sin(2), S = 1, theta = -2 holds in the line before but not in t
lines_theta = ["Eq(C*sin(theta), S*cos(theta))", "Eq(tan(theta), C/S)"]

# %% wrong: nothing but the result
# says: every line follows, but you leap: 1 of at least 3 lines bring something new. Make one move
lines_theta = ["Eq(tan(theta), S/C)"]

# %% wrong: one of the two stationary angles is lost in the chain
# says: line 2: wrong: C = 1, S = 1, theta = -2.8966140 holds in the line before but not in the li
lines_theta = [
    "Eq(C*sin(theta), S*cos(theta))",
    "Eq(theta, atan2(S, C))",
    "Eq(tan(theta), S/C)",
]

# %% wrong: atan instead of atan2
# says: half of all angles are lost
theta_min = "atan(S/C)"

# %% wrong: the arguments of atan2 are swapped
# says: C and S have changed places
theta_min = "atan2(C, S)"

# %% wrong: the maximum
# says: it makes J largest
theta_min = "atan2(-S, -C)"

# %% wrong: the sign of the angle
# says: the angle is turned the other way
theta_min = "-atan2(S, C)"

# %% wrong: acos knows no sign
# says: acos, which knows no sign, misled you
theta_min = "acos(C/sqrt(C**2 + S**2))"

# %% wrong: NumPy's spelling
# says: theta_min is unreadable: write atan2, without np.
theta_min = "np.arctan2(S, C)"

# %% wrong: the lecture's names for the estimate
# says: C_k is unreadable: vhat is not declared. This part knows the names u, v, a, b only.
C_and_S = ["u*uhat + v*vhat", "v*uhat - u*vhat"]

# %% wrong: a constant
# says: C_k: 0 is not right. At u = 1, v = 1, a = 1, b = 1 it makes C_k equal to 0 instead of 2.
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

# %% wrong: a sign in C
# says: a sign inside is turned
C_and_S = ["u*a - v*b", "v*a - u*b"]

# %% wrong: half of C and S
# says: the 2 is halved away
C_and_S = ["(u*a + v*b)/2", "(v*a - u*b)/2"]

# %% wrong: the products of truth with itself
# says: C_k: u*u + v*v is not right. At u = 1, v = 1, a = 1, b = 0 it makes C_k equal to 2 instead
C_and_S = ["u*u + v*v", "v*u - u*v"]

# %% wrong: only one text for both
# says: C_and_S: two formulas are asked, each a string.
C_and_S = "u*a + v*b, v*a - u*b"

# %% wrong: the given line rewritten, then a leap
# says: every line follows, but no line has sine and cosine with the derivative carried out.
lines_theta = [
    "Eq(Derivative(-2*(C*cos(theta) + S*sin(theta)), theta), 0)",
    "Eq(Derivative(C*cos(theta) + S*sin(theta), theta), 0)",
    "Eq(tan(theta), S/C)",
]

# %% wrong: the goal rewritten before it
# says: every line follows, but no line has sine and cosine with the derivative carried out.
lines_theta = [
    "Eq(C*tan(theta), S)",
    "Eq(tan(theta) - S/C, 0)",
    "Eq(tan(theta), S/C)",
]

# %% wrong: a sign after the derivative
# says: line 2: wrong: C = -cos(2)/sin(2), S = 1, theta = -2 holds in the line before but not in t
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta), -S*cos(theta))",
    "Eq(tan(theta), S/C)",
]

# %% wrong: asin
# says: asin, which covers half a turn only, misled you
theta_min = "asin(S/sqrt(C**2 + S**2))"

# %% wrong: the formula of the tangent
# says: theta_min: S/C is not right. At B = 1, C = 1, S = 1 it makes B - 2*(C*cos(theta_min) + S*s
theta_min = "S/C"

# %% wrong: half a turn on
# says: it makes J largest
theta_min = "atan2(S, C) + pi"

# %% right: SymPy objects and names used up
import sympy

a, b, u, v, C, S = sympy.symbols("a b u v C S", real=True)
C_and_S = (a * u + b * v, a * v - b * u)
theta_min = sympy.atan2(S, C)

# %% right: two lines more, pairs with reasons
lines_theta = [
    ("Eq(-2*Derivative(C*cos(theta) + S*sin(theta), theta), 0)", "B is fixed"),
    ("Eq(-2*(S*cos(theta) - C*sin(theta)), 0)", "differentiate"),
    ("Eq(S*cos(theta) - C*sin(theta), 0)", "divide by -2"),
    ("Eq(C*sin(theta)/cos(theta), S)", "the cosine is not 0"),
    ("Eq(tan(theta), S/C)", "divide by C"),
]

# %% right: divided by the cosine at once
lines_theta = [
    "Eq(2*C*sin(theta) - 2*S*cos(theta), 0)",
    "Eq(C*sin(theta) - S*cos(theta), 0)",
    "Eq(tan(theta), S/C)",
]
theta_min = "-atan2(-S, C)"
