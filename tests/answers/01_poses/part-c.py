# %% wrong: the two numbers are interpolated
# says: you interpolated the two headings as numbers
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [(1 - s) * am.yaw(A) + s * am.yaw(B)])[0]

# %% wrong: the entries are mixed
# says: you mixed the matrix entries
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    return (1 - s) * A + s * B

# %% wrong: the entries are mixed, and the size is repaired
# says: a third of the way, at constant speed
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    M = (1 - s) * A + s * B
    M[:2, :2] /= np.sqrt(np.linalg.det(M[:2, :2]))
    return M

# %% wrong: s counts from B
# says: s counts from B
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    turn = am.wrap(am.yaw(A) - am.yaw(B))
    return am.planar_poses([s * A[:2, 2] + (1 - s) * B[:2, 2]], [am.yaw(B) + s * turn])[0]

# %% wrong: the turn has no sign
# says: the turn has lost its sign
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = A[:2, 2] + s * (B[:2, 2] - A[:2, 2])
    return am.planar_poses([p], [am.yaw(A) + s * am.rotation_angle(am.relative(A, B))])[0]

# %% wrong: the turn is counted from 0 to 2 pi
# says: the turn is counted in [0, 2 pi)
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    turn = (am.yaw(B) - am.yaw(A)) % (2 * np.pi)
    return am.planar_poses([A[:2, 2] + s * (B[:2, 2] - A[:2, 2])], [am.yaw(A) + s * turn])[0]

# %% wrong: the library by a default argument
# says: would do your work here
def pose_between(A, B, s, between=am.interpolate):
    if not 0 <= s <= 1:
        raise ValueError("s")
    return between([0, 1], np.array([A, B]), [s])[0]

# %% wrong: the turn is taken from B to A
# says: the turn goes the wrong way
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = A[:2, 2] + s * (B[:2, 2] - A[:2, 2])
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(B, A))])[0]

# %% wrong: the turn alone
# says: the heading is the turn alone
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = A[:2, 2] + s * (B[:2, 2] - A[:2, 2])
    return am.planar_poses([p], [s * am.yaw(am.relative(A, B))])[0]

# %% wrong: the heading does not turn
# says: the heading stays A's
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = A[:2, 2] + s * (B[:2, 2] - A[:2, 2])
    return am.planar_poses([p], [am.yaw(A)])[0]

# %% wrong: the position of the relative pose, not turned into the world
# says: the step is in A's axes
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    X = am.relative(A, B)
    return am.planar_poses([A[:2, 2] + s * X[:2, 2]], [am.yaw(A) + s * am.yaw(X)])[0]

# %% wrong: a part of the motion, which runs on an arc
# says: the position runs on an arc
def pose_between(A, B, s):
    from scipy.linalg import expm, logm
    if not 0 <= s <= 1:
        raise ValueError("s")
    return A @ expm(s * logm(am.relative(A, B))).real

# %% wrong: the pose as A sees it
# says: you returned the way from A
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    X = am.relative(A, B)
    return am.planar_poses([s * X[:2, 2]], [s * am.yaw(X)])[0]

# %% wrong: always the middle
# says: this is always the middle
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = (A[:2, 2] + B[:2, 2]) / 2
    return am.planar_poses([p], [am.yaw(A) + am.yaw(am.relative(A, B)) / 2])[0]

# %% wrong: slow at both ends
# says: a third of the way, at constant speed
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    s = 3 * s**2 - 2 * s**3
    p = A[:2, 2] + s * (B[:2, 2] - A[:2, 2])
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])[0]

# %% wrong: refuses both ends
# says: stops for s = 0
def pose_between(A, B, s):
    if not 0 < s < 1:
        raise ValueError("s")
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])[0]

# %% wrong: extrapolates
# says: raise a ValueError that says so
def pose_between(A, B, s):
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])[0]

# %% wrong: refuses what is above 1 only
# says: raise a ValueError that says so
def pose_between(A, B, s):
    if s > 1:
        raise ValueError("s")
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])[0]

# %% wrong: clips s instead of refusing it
# says: raise a ValueError that says so
def pose_between(A, B, s):
    s = np.clip(s, 0, 1)
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])[0]

# %% wrong: asserts, which is no ValueError
# says: raises AssertionError
def pose_between(A, B, s):
    assert 0 <= s <= 1
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])[0]

# %% wrong: returns a batch of one
# says: shape (3, 3) is asked
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    p = (1 - s) * A[:2, 2] + s * B[:2, 2]
    return am.planar_poses([p], [am.yaw(A) + s * am.yaw(am.relative(A, B))])

# %% wrong: works in A itself
# says: changes its input
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    heading = am.yaw(A) + s * am.yaw(am.relative(A, B))
    A[:2, 2] += s * (B[:2, 2] - A[:2, 2])
    return am.planar_poses([A[:2, 2]], [heading])[0]

# %% wrong: calls the library's interpolation
# says: the library's interpolate would do your work
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s")
    return am.interpolate([0, 1], np.array([A, B]), [s])[0]

# %% wrong: calls what the library's interpolation calls
# says: would do your work here
def pose_between(A, B, s):
    from amrmetrics import stamps
    if not 0 <= s <= 1:
        raise ValueError("s")
    return stamps.between_samples(np.array([0.0, 1.0]), np.array([A, B]), np.array([s]))[0]

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

# %% right: a power of the rotation, and a list
from math import *
def pose_between(A, B, s):
    if not (s >= 0 and s <= 1):
        raise ValueError
    turn = atan2(A[0, 0] * B[1, 0] - A[1, 0] * B[0, 0], A[0, 0] * B[0, 0] + A[1, 0] * B[1, 0])
    c, d = cos(s * turn), sin(s * turn)
    R = A[:2, :2] @ [[c, -d], [d, c]]
    x = A[0, 2] + s * (B[0, 2] - A[0, 2])
    y = A[1, 2] + s * (B[1, 2] - A[1, 2])
    return [[R[0, 0], R[0, 1], x], [R[1, 0], R[1, 1], y], [0, 0, 1]]

# %% right: the headings unwrapped
def pose_between(A, B, s):
    if s > 1 or s < 0:
        raise am.AmrError(f"s is {s}")
    start, end = np.unwrap([am.yaw(A), am.yaw(B)])
    return am.planar_poses([A[:2, 2] * (1 - s) + B[:2, 2] * s], [(1 - s) * start + s * end])[0]

# %% right: a share of the motion, its position on a straight line
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError("s is a share")
    X = am.relative(A, B)
    return A @ am.planar_poses([s * X[:2, 2]], [s * am.yaw(X)])[0]

# %% right: SciPy's slerp, with a helper
from scipy.spatial.transform import Rotation, Slerp
def lifted(X):
    return np.block([[X[:2, :2], np.zeros((2, 1))], [np.zeros((1, 2)), np.ones((1, 1))]])
def pose_between(A, B, s):
    if not 0 <= s <= 1:
        raise ValueError(s)
    turn = Slerp([0, 1], Rotation.from_matrix([lifted(A), lifted(B)]))
    X = turn(s).as_matrix()
    X[:2, 2] = A[:2, 2] + s * (B[:2, 2] - A[:2, 2])
    return X
