# %% wrong: the two numbers are interpolated
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [(1 - s) * am.yaw(A) + s * am.yaw(B)])[0]

# %% wrong: the entries are mixed
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    return (1 - s) * A + s * B

# %% wrong: the entries are mixed, and the size is repaired
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    M = (1 - s) * A + s * B
    M[:2, :2] /= np.sqrt(np.linalg.det(M[:2, :2]))
    return M

# %% wrong: s counts from B
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    turn = am.wrap(am.yaw(A) - am.yaw(B))
    return am.planar_poses([s * A[:2, 2] + (1 - s) * B[:2, 2]], [am.yaw(B) + s * turn])[0]

# %% wrong: the difference is not wrapped
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = A[:2, 2] + s * (B[:2, 2] - A[:2, 2])
    return am.planar_poses([p], [am.yaw(A) + s * (am.yaw(B) - am.yaw(A))])[0]

# %% wrong: the turn has no sign
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = A[:2, 2] + s * (B[:2, 2] - A[:2, 2])
    return am.planar_poses([p], [am.yaw(A) + s * am.rotation_angle(am.relative(A, B))])[0]

# %% wrong: the position of the relative pose, not turned into the world
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    X = am.relative(A, B)
    return am.planar_poses([A[:2, 2] + s * X[:2, 2]], [am.yaw(A) + s * am.yaw(X)])[0]

# %% wrong: extrapolates
def pose_between(A, B, s):
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])[0]

# %% wrong: clips s instead of refusing it
def pose_between(A, B, s):
    s = np.clip(s, 0, 1)
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])[0]

# %% wrong: returns a batch of one
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])

# %% wrong: calls the library's interpolation
def pose_between(A, B, s):
    return am.interpolate([0, 1], np.array([A, B]), [s])[0]

# %% wrong: an arc by composing a part of the relative pose, then a straight end
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    X = am.relative(A, B)
    turn = s * am.yaw(X)
    c, d = np.cos(turn), np.sin(turn)
    part = am.planar_poses([np.array([[c, -d], [d, c]]) @ X[:2, 2] * s], [turn])[0]
    return A @ part

# %% right: a wrapped difference
def pose_between(A, B, s):
    if s < 0 or s > 1:
        raise ValueError("s must lie between 0 and 1")
    turn = am.wrap(am.yaw(B) - am.yaw(A))
    c, d = np.cos(am.yaw(A) + s * turn), np.sin(am.yaw(A) + s * turn)
    x, y = A[:2, 2] + s * (B[:2, 2] - A[:2, 2])
    return np.array([[c, -d, x], [d, c, y], [0, 0, 1]])

# %% right: complex numbers
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("outside")
    a, b = A[0, 0] + 1j * A[1, 0], B[0, 0] + 1j * B[1, 0]
    z = a * np.exp(1j * s * np.angle(b / a))
    X = np.eye(3)
    X[:2, :2] = [[z.real, -z.imag], [z.imag, z.real]]
    X[:2, 2] = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return X
