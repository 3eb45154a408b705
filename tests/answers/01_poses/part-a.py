# %% wrong: differences in the world
# says: you did not turn the position
B_from_A = (-3, 2, 90)

# %% wrong: turned the wrong way
# says: you turned the position by +90 degrees
B_from_A = (-2, -3, 90)

# %% wrong: the heading of B in the world
# says: the heading is still the world's
B_from_A = (2, 3, 180)

# %% wrong: the heading of B in the world, counted the other way
# says: the heading is still the world's
B_from_A = [2, 3, -180]

# %% wrong: the turn from B to A
# says: the heading turns the wrong way
B_from_A = (2, 3, -90)

# %% wrong: left comes before ahead
# says: ahead and left are exchanged
B_from_A = (3, 2, 90)

# %% wrong: left is negative
# says: left counts as negative
B_from_A = (2, -3, 90)

# %% wrong: A, seen from B
# says: this is A, seen from B
X_A, X_B = am.planar_poses([[2, 1], [-1, 3]], np.radians([90, 180]))
X = am.relative(X_B, X_A)
B_from_A = (*am.positions(X), np.degrees(am.yaw(X)))

# %% wrong: nothing was done
# says: this is B in the world
B_from_A = (-1, 3, 180)

# %% wrong: radians
# says: the heading is in radians
B_from_A = (2, 3, np.pi / 2)

# %% wrong: position only
# says: shape (3,) is asked
B_from_A = (2, 3)

# %% wrong: all signs of A turned
# says: you only changed signs
A_inverse = (-2, -1, -90)

# %% wrong: the inverse turned by +90
# says: you turned the position by +90 degrees
A_inverse = (1, -2, -90)

# %% wrong: the heading of the inverse is A's
# says: the heading keeps its sign
A_inverse = (-1, 2, 90)

# %% wrong: minus is forgotten before the turned position
# says: or forgot its minus
A_inverse = (1, -2, 270)

# %% wrong: the inverse of the other robot
# says: this is the inverse of B
A_inverse = (-1, 3, 180)

# %% wrong: not wrapped
# says: the difference is not wrapped
def heading_error(heading, heading_hat):
    return heading_hat - heading

# %% wrong: wrapped too early
# says: both headings are wrapped, but not the difference
def heading_error(heading, heading_hat):
    return am.wrap(heading_hat) - am.wrap(heading)

# %% wrong: truth and estimate swapped
# says: truth and estimate are swapped
def heading_error(heading, heading_hat):
    return am.wrap(heading - heading_hat)

# %% wrong: between 0 and a full turn
# says: the result lies in [0, 2 pi)
def heading_error(heading, heading_hat):
    return (heading_hat - heading) % (2 * np.pi)

# %% wrong: the one-liner that lecture 01 refutes
# says: the formula that rounds up to +pi just below -pi
def heading_error(heading, heading_hat):
    return np.mod(heading_hat - heading + np.pi, 2 * np.pi) - np.pi

# %% wrong: the angle of a complex number, which may be +pi
# says: half a turn comes out as +pi
def heading_error(heading, heading_hat):
    return np.angle(np.exp(1j * (np.asarray(heading_hat) - heading)))

# %% wrong: the arctangent of sine and cosine
# says: half a turn comes out as +pi
def heading_error(heading, heading_hat):
    d = heading_hat - heading
    return np.arctan2(np.sin(d), np.cos(d))

# %% wrong: without a sign
# says: the sign is lost
def heading_error(heading, heading_hat):
    return np.abs(am.wrap(heading_hat - heading))

# %% wrong: one turn is taken off at most
# says: is wrong for many turns
def heading_error(heading, heading_hat):
    d = heading_hat - heading
    d = np.where(d >= np.pi, d - 2 * np.pi, d)
    return np.where(d < -np.pi, d + 2 * np.pi, d)

# %% wrong: degrees
# says: the result is in degrees
def heading_error(heading, heading_hat):
    return np.degrees(am.wrap(heading_hat - heading))

# %% wrong: the arctangent of the tangent
# says: this is the turn modulo half a turn
def heading_error(heading, heading_hat):
    return np.arctan(np.tan(heading_hat - heading))

# %% wrong: one number for all
# says: shape (2,) is asked
def heading_error(heading, heading_hat):
    return float(am.wrap(heading_hat - heading)[0])

# %% wrong: the input is changed
# says: changes its input
def heading_error(heading, heading_hat):
    heading_hat -= heading
    return am.wrap(heading_hat)

# %% wrong: numbers that were typed in
# says: is wrong for headings around 180 degrees
def heading_error(heading, heading_hat):
    return np.array([-0.25, 0.5])

# %% wrong: forgot to return
# says: It returns nothing
def heading_error(heading, heading_hat):
    am.wrap(heading_hat - heading)

# %% right: by the relative poses, in letters that the check uses too
A, B = am.planar_poses([[2, 1], [-1, 3]], np.radians([90, 180]))
X = am.relative(A, B)
B_from_A = (*am.positions(X), np.degrees(am.yaw(X)))
A_inverse = [-1.0, 2.0, -90.0]

# %% right: headings counted the other way
B_from_A = (2, 3, -270)
A_inverse = (-1, 2, 270)

# %% right: arrays
B_from_A = np.array([2, 3, 90.0])
A_inverse = np.array([[-1], [2], [-90]])

# %% right: SymPy's numbers, and a name that hides a builtin
import sympy as sp
abs = 0
B_from_A = sp.Matrix([2, 3, 90])
A_inverse = (sp.Integer(-1), sp.Integer(2), -sp.Integer(90))

# %% right: by rotation matrices
def heading_error(heading, heading_hat):
    zero = np.zeros((len(heading), 2))
    return am.yaw(am.relative(am.planar_poses(zero, heading), am.planar_poses(zero, heading_hat)))

# %% right: the angle of a complex number, and +pi is sent to -pi
def heading_error(heading, heading_hat):
    w = np.angle(np.exp(1j * (heading_hat - heading)))
    return np.where(w >= np.pi, -np.pi, w)

# %% right: a list, one by one
def heading_error(heading, heading_hat):
    return [am.wrap(b - a) for a, b in zip(heading, heading_hat)]

# %% right: a loop over whole turns
def heading_error(heading, heading_hat):
    d = np.array(heading_hat) - heading
    while (d >= np.pi).any() or (d < -np.pi).any():
        d[d >= np.pi] -= 2 * np.pi
        d[d < -np.pi] += 2 * np.pi
    return d

# %% right: wrapped before and after
def heading_error(heading, heading_hat):
    print("called")
    return am.wrap(am.wrap(heading_hat) - am.wrap(heading))
