# %% wrong: differences in the world
B_from_A = (-3, 2, 90)
A_inverse = (-1, 2, -90)
def heading_error(heading, heading_hat):
    return am.wrap(heading_hat - heading)

# %% wrong: turned the wrong way
B_from_A = (-2, -3, 90)
A_inverse = (-1, 2, -90)
def heading_error(heading, heading_hat):
    return am.wrap(heading_hat - heading)

# %% wrong: the heading of B in the world
B_from_A = (2, 3, 180)
A_inverse = (-1, 2, -90)
def heading_error(heading, heading_hat):
    return am.wrap(heading_hat - heading)

# %% wrong: all signs of A turned
B_from_A = (2, 3, 90)
A_inverse = (-2, -1, -90)
def heading_error(heading, heading_hat):
    return am.wrap(heading_hat - heading)

# %% wrong: the inverse turned by +90
B_from_A = (2, 3, 90)
A_inverse = (1, -2, -90)
def heading_error(heading, heading_hat):
    return am.wrap(heading_hat - heading)

# %% wrong: radians
B_from_A = (2, 3, np.pi / 2)
A_inverse = (-1, 2, -np.pi / 2)
def heading_error(heading, heading_hat):
    return am.wrap(heading_hat - heading)

# %% wrong: position only
B_from_A = (2, 3)
A_inverse = (-1, 2)
def heading_error(heading, heading_hat):
    return am.wrap(heading_hat - heading)

# %% wrong: not wrapped
B_from_A = (2, 3, 90)
A_inverse = (-1, 2, -90)
def heading_error(heading, heading_hat):
    return heading_hat - heading

# %% wrong: wrapped too early
B_from_A = (2, 3, 90)
A_inverse = (-1, 2, -90)
def heading_error(heading, heading_hat):
    return am.wrap(heading_hat) - am.wrap(heading)

# %% wrong: truth and estimate swapped
B_from_A = (2, 3, 90)
A_inverse = (-1, 2, -90)
def heading_error(heading, heading_hat):
    return am.wrap(heading - heading_hat)

# %% wrong: between 0 and a full turn
B_from_A = (2, 3, 90)
A_inverse = (-1, 2, -90)
def heading_error(heading, heading_hat):
    return (heading_hat - heading) % (2 * np.pi)

# %% wrong: forgot to return
B_from_A = (2, 3, 90)
A_inverse = (-1, 2, -90)
def heading_error(heading, heading_hat):
    am.wrap(heading_hat - heading)

# %% right: by the relative poses
A, B = am.planar_poses([[2, 1], [-1, 3]], np.radians([90, 180]))
X = am.relative(A, B)
B_from_A = (*am.positions(X), np.degrees(am.yaw(X)))
A_inverse = [-1.0, 2.0, -90.0]
def heading_error(heading, heading_hat):
    return np.angle(np.exp(1j * (np.asarray(heading_hat) - heading)))

# %% right: by rotation matrices
B_from_A = np.array([2, 3, 90.0]).tolist()
A_inverse = (-1, 2, -90)
def heading_error(heading, heading_hat):
    zero = np.zeros((len(heading), 2))
    return am.yaw(am.relative(am.planar_poses(zero, heading), am.planar_poses(zero, heading_hat)))
