# %% wrong: reference and estimate are swapped
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = estimate - estimate.mean(axis=0), reference - reference.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, estimate.mean(axis=0) - R @ reference.mean(axis=0)


# %% wrong: the sign of theta
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: atan instead of atan2
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum() / (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: the arguments of atan2 are swapped
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p * q).sum(), (p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: the means are not removed
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference, estimate
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, p.mean(axis=0) - R @ q.mean(axis=0)


# %% wrong: t without the rotation
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    return theta, reference.mean(axis=0) - estimate.mean(axis=0)


# %% wrong: t with the transposed rotation
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), np.sin(theta)], [-np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: degrees
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return np.degrees(theta), reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: the SVD without its determinant
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    U, _, Vt = np.linalg.svd(p.T @ q)
    R = U @ Vt
    return np.arctan2(R[1, 0], R[0, 0]), reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: the angle between the first and the last point
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        raise ValueError("no angle is best")
    a, b = reference[-1] - reference[0], estimate[-1] - estimate[0]
    theta = am.wrap(np.arctan2(a[1], a[0]) - np.arctan2(b[1], b[0]))
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: calls the library
def align_2d(reference, estimate):
    a = am.align(reference, estimate)
    return a.angle, a.translation


# %% wrong: calls the library by another name
from amrmetrics import align as library_align


def align_2d(reference, estimate):
    a = library_align(reference, estimate)
    return a.angle, a.translation


# %% wrong: an answer for a single point
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: refuses one sample only, not a robot that stands still
def align_2d(reference, estimate):
    if len(reference) == 1:
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: an absolute threshold refuses a small cloud
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    C, S = (p * q).sum(), (p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum()
    if np.hypot(C, S) < 1:
        raise ValueError("no angle is best")
    theta = np.arctan2(S, C)
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: compares rounded sums with zero
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    C, S = (p * q).sum(), (p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum()
    if C == 0 and S == 0:
        raise ValueError("no angle is best")
    theta = np.arctan2(S, C)
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: refuses two points
def align_2d(reference, estimate):
    if len(reference) < 3 or (reference == reference[0]).all():
        raise ValueError("no angle is best")
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: None for a single point
def align_2d(reference, estimate):
    if (reference == reference[0]).all() or (estimate == estimate[0]).all():
        return None
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return theta, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: changes its input
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
def align_2d(reference, estimate):
    return 0.0, np.zeros(2)


# %% wrong: the rotation matrix instead of the angle
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
    return R, reference.mean(axis=0) - R @ estimate.mean(axis=0)


# %% wrong: prints instead of returning
def align_2d(reference, estimate):
    p, q = reference - reference.mean(axis=0), estimate - estimate.mean(axis=0)
    theta = np.arctan2((p[:, 1] * q[:, 0] - p[:, 0] * q[:, 1]).sum(), (p * q).sum())
    print(theta)


# %% wrong: refuses everything
def align_2d(reference, estimate):
    raise ValueError("no angle is best")


# %% wrong: a string
def align_2d(reference, estimate):
    return "theta, t"


# %% wrong: two strings
def align_2d(reference, estimate):
    return "theta", "t"


# %% wrong: recursion without an end
def align_2d(reference, estimate):
    return align_2d(reference, estimate)


# %% wrong: leaves the program
def align_2d(reference, estimate):
    raise SystemExit


# %% wrong: a value instead of a function
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
