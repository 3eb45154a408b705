# %% wrong: reference and estimate are swapped
# says: reference and estimate are swapped
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = estimate - estimate.mean(axis=0), reference - reference.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, estimate.mean(axis=0) - R @ reference.mean(axis=0)

# %% wrong: the sign of theta
# says: the sign of theta is turned
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: atan instead of atan2
# says: atan covers half a turn only
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum() / (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: the arguments of atan2 are swapped
# says: the arguments of atan2 are swapped
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p * q).sum(), (p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: the means are not removed
# says: the means are still in the sums
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference, estimate
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, p.mean(axis=0) - R @ q.mean(axis=0)

# %% wrong: t without the rotation
# says: t forgets to rotate a mean
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    return theta, reference.mean(axis=0) - estimate.mean(axis=0)

# %% wrong: t with the transposed rotation
# says: t rotates the wrong way
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), np.sin(theta)], [-np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: degrees
# says: theta is in degrees
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return np.degrees(theta), reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: the SVD without its determinant
# says: a reflection takes the place of the rotation
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    U, _, Vt = np.linalg.svd(p.T @ q)
    R = U @ Vt
    return np.arctan2(R[1, 0], R[0, 0]), reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: the angle between the first and the last point
# says: you compare the first and last rows alone
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    a, b = reference[-1] - reference[0], estimate[-1] - estimate[0]
    theta = am.wrap(np.arctan2(a[1], a[0]) - np.arctan2(b[1], b[0]))
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: calls the library
# says: the library's align would do your work here; do without it.
def align_2d(reference, estimate):
    a = am.align(reference, estimate)
    return a.angle, a.translation

# %% wrong: calls the library by another name
# says: the library's align would do your work here; do without it.
from amrmetrics import align as library_align


def align_2d(reference, estimate):
    a = library_align(reference, estimate)
    return a.angle, a.translation

# %% wrong: an answer for a single point
# says: align_2d returns (0, [2.93596, -1.01049]) for a single point. There is no answer in this c
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: refuses one sample only, not a robot that stands still
# says: align_2d returns (0, [-2.58024, -6.48806]) for a true path that stands still. There is no 
def align_2d(reference, estimate):
    if len(reference) == 1:
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: an absolute threshold refuses a small cloud
# says: align_2d stops for a 1 mm cloud with ValueError: no angle is best.
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    C, S = (p * q).sum(), (p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum()
    if np.hypot(C, S) < 1:
        raise ValueError("no angle is best")
    theta = np.arctan2(S, C)
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: compares rounded sums with zero
# says: align_2d returns (1.32582, [-3.2627, -5.50904]) for nine true rows of 0.1 (their mean is n
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    C, S = (p * q).sum(), (p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum()
    if C == 0 and S == 0:
        raise ValueError("no angle is best")
    theta = np.arctan2(S, C)
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: refuses two points
# says: align_2d stops for two points, -70° with ValueError: no angle is best.
def align_2d(reference, estimate):
    if len(reference) < 3 or (reference == reference[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: None for a single point
# says: align_2d returns None for a single point. There is no answer in this case: raise a ValueEr
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        return None
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: changes its input
# says: align_2d changes its input for four points, 30°. Work on a copy.
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p_mean, q_mean = reference.mean(axis=0), estimate.mean(axis=0)
    reference -= p_mean
    estimate -= q_mean
    p, q = reference, estimate
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, p_mean - R @ q_mean

# %% wrong: constants
# says: align_2d is wrong for four points, 30°: it returns (0, [0, 0]).
def align_2d(reference, estimate):
    return 0.0, np.zeros(2)

# %% wrong: the rotation matrix instead of the angle
# says: align_2d, four points, 30°, result 1: one number is asked, you have [[0.868313, -0.496017]
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return R, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: prints instead of returning
# says: align_2d: there is no answer yet. It returns nothing for four points, 30°.
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    print(theta)

# %% wrong: refuses everything
# says: align_2d stops for four points, 30° with ValueError: no angle is best.
def align_2d(reference, estimate):
    raise ValueError("no angle is best")

# %% wrong: a string
# says: align_2d, four points, 30°: a tuple of 2 results is asked, you have 'theta, t'.
def align_2d(reference, estimate):
    return "theta, t"

# %% wrong: two strings
# says: align_2d, four points, 30°, result 1: numbers are asked, you have 'theta'.
def align_2d(reference, estimate):
    return "theta", "t"

# %% wrong: recursion without an end
# says: align_2d stops for four points, 30° with RecursionError: maximum recursion depth exceeded.
def align_2d(reference, estimate):
    return align_2d(reference, estimate)

# %% wrong: leaves the program
# says: align_2d stops for four points, 30° with SystemExit.
def align_2d(reference, estimate):
    raise SystemExit

# %% wrong: a value instead of a function
# says: a function is asked, you have (0.5, [1, 2]).
align_2d = (0.5, [1.0, 2.0])

# %% right: complex numbers
def align_2d(reference, estimate):
    if len(np.unique(reference, axis=0)) == 1 or len(np.unique(estimate, axis=0)) == 1:
        raise ValueError("one of the paths is a single point")
    z, w = reference @ [1, 1j], estimate @ [1, 1j]
    theta = np.angle(np.vdot(w - w.mean(), z - z.mean()))
    t = z.mean() - np.exp(1j * theta) * w.mean()
    return theta, (t.real, t.imag)

# %% right: the SVD with its determinant
def align_2d(reference, estimate):
    for points in (reference, estimate):
        if np.allclose(points, points[0], rtol=0, atol=1e-9):
            raise ValueError("one of the paths is a single point")
    p, q = reference.mean(axis=0), estimate.mean(axis=0)
    U, _, Vt = np.linalg.svd((estimate - q).T @ (reference - p))
    R = Vt.T @ np.diag([1, np.linalg.det(Vt.T @ U.T)]) @ U.T
    return np.arctan2(R[1, 0], R[0, 0]), p - R @ q

# %% right: a loop over the samples
def align_2d(reference, estimate):
    N = len(reference)
    p, q = sum(reference) / N, sum(estimate) / N
    C = S = P = Q = 0.0
    for k in range(N):
        x, y = reference[k] - p
        u, v = estimate[k] - q
        C, S = C + x * u + y * v, S + y * u - x * v
        P, Q = P + x * x + y * y, Q + u * u + v * v
    if min(P, Q) < 1e-18:
        raise ValueError("one of the paths is a single point")
    c, s = C / np.hypot(C, S), S / np.hypot(C, S)
    return np.arctan2(s, c), p - [c * q[0] - s * q[1], s * q[0] + c * q[1]]

# %% wrong: an angle from 0 to a full turn
# says: theta is right up to a full turn, and leaves (-pi, pi]
def align_2d(reference, estimate):
    for x in (reference, estimate):
        if (x == x[0]).all():
            raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum()) % (2 * np.pi)
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: close counts as equal
# says: align_2d stops for a cloud of a nanometer with ValueError: no angle is best.
def align_2d(reference, estimate):
    for x in (reference, estimate):
        if np.allclose(x, x[0]):
            raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: only the first two rows are compared
# says: align_2d stops for two points, -70° with ValueError: no angle is best.
def align_2d(reference, estimate):
    for x in (reference, estimate):
        if (x[0] == x[-2]).all():
            raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: only one of the two paths is looked at
# says: align_2d returns (0, [-6.11966, -6.33028]) for a true path that stands still. There is no 
def align_2d(reference, estimate):
    if np.ptp(estimate, axis=0).max() == 0:
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: N of 1 only is refused
# says: align_2d returns (0, [-2.58024, -6.48806]) for a true path that stands still. There is no 
def align_2d(reference, estimate):
    if len(reference) == 1:
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: the angle of the first segment
# says: you compare the first segments alone
def align_2d(reference, estimate):
    for x in (reference, estimate):
        if (x == x[0]).all():
            raise ValueError("no angle is best")
    d, e = reference[1] - reference[0], estimate[1] - estimate[0]
    theta = np.arctan2(d[1], d[0]) - np.arctan2(e[1], e[0])
    theta = (theta + np.pi) % (2 * np.pi) - np.pi
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: the angle that makes J largest
# says: this is the angle at which J is largest
def align_2d(reference, estimate):
    for x in (reference, estimate):
        if (x == x[0]).all():
            raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2(-(p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), -(p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)

# %% wrong: subtracts the means in place
# says: align_2d changes its input for four points, 30°. Work on a copy.
def align_2d(reference, estimate):
    for x in (reference, estimate):
        if (x == x[0]).all():
            raise ValueError("no angle is best")
    p_mean, q_mean = reference.mean(axis=0), estimate.mean(axis=0)
    reference -= p_mean
    estimate -= q_mean
    u, v = reference.T
    a, b = estimate.T
    theta = np.arctan2((v * a - u * b).sum(), (u * a + v * b).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, p_mean - R @ q_mean

# %% wrong: the alignment of ATE
# says: the library's align would do your work here; do without it.
def align_2d(reference, estimate):
    best = am.ate(reference, estimate).alignment
    return best.angle, best.translation

# %% wrong: the library by a default argument
# says: the library's align would do your work here; do without it.
def align_2d(reference, estimate, f=am.align):
    best = f(reference, estimate)
    return best.angle, best.translation

# %% right: complex numbers
def align_2d(reference, estimate):
    z = reference[:, 0] + 1j * reference[:, 1]
    w = estimate[:, 0] + 1j * estimate[:, 1]
    if all(z == z[0]) or all(w == w[0]):
        raise ValueError("one of them stands still")
    turn = np.sum((z - z.mean()) * np.conj(w - w.mean()))
    turn /= abs(turn)
    t = z.mean() - turn * w.mean()
    return [float(np.angle(turn)), [t.real, t.imag]]

# %% right: a helper, compared row by row, names used up
from math import *

p = q = cloud = library = 0


def rotated(x, theta):
    return np.array([cos(theta) * x[0] - sin(theta) * x[1], sin(theta) * x[0] + cos(theta) * x[1]])


def align_2d(reference, estimate):
    if len(np.unique(reference, axis=0)) == 1 or len(np.unique(estimate, axis=0)) == 1:
        raise ValueError("all rows are equal")
    x, y = reference - np.mean(reference, axis=0), estimate - np.mean(estimate, axis=0)
    theta = atan2(np.sum(np.cross(y, x)), np.vdot(x, y))
    return theta, reference.mean(axis=0) - rotated(estimate.mean(axis=0), theta)
