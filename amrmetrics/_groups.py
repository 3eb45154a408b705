"""Exponential, logarithm and their derivatives in SE(2) and SE(3), for many poses at once.

A tangent vector is the translation part followed by the rotation part: (x, y, angle) with
n = 3 components in the plane, (x, y, z, rotation vector) with n = 6 in space. Arguments are
unchecked; the leading axis counts poses. Sola, Deray and Atchuthan, A micro Lie theory for
state estimation in robotics (2018), is the source of all but `right_jacobian_inverse`.
"""

import numpy as np

# Below this angle (rad) the closed forms lose digits, and their series are exact to rounding.
SMALL = 0.1


def log(X):
    """Return the tangent vectors (N, n) of poses (N, d+1, d+1), rotations by at most pi."""
    R, t = X[:, :-1, :-1], X[:, :-1, -1]
    if X.shape[-1] == 3:
        angle = np.arctan2(R[:, 1, 0], R[:, 0, 0])
        a, b = half_cotangent(angle), angle / 2
        x, y = t.T
        return np.column_stack([a * x + b * y, a * y - b * x, angle])
    from scipy.spatial.transform import Rotation

    phi = Rotation.from_matrix(R).as_rotvec()
    angle = np.linalg.norm(phi, axis=1)
    once = np.cross(phi, t)
    c = half_cotangent_rest(angle)[:, None]
    return np.column_stack([t - once / 2 + c * np.cross(phi, once), phi])


def exp(xi):
    """Return the poses (N, d+1, d+1) of tangent vectors (N, n)."""
    d = 2 if xi.shape[1] == 3 else 3
    v, phi = xi[:, :d], xi[:, d:]
    X = np.zeros((len(xi), d + 1, d + 1))
    X[:, d, d] = 1
    angle = phi[:, 0] if d == 2 else np.linalg.norm(phi, axis=1)
    half_sinc = np.sinc(angle / (2 * np.pi))  # sin(angle/2) / (angle/2)
    b = half_sinc * half_sinc / 2  # (1 - cos angle) / angle^2
    if d == 2:
        a, b = np.sinc(angle / np.pi), b * angle
        x, y = v.T
        X[:, 0, 0] = X[:, 1, 1] = np.cos(angle)
        X[:, 1, 0] = np.sin(angle)
        X[:, 0, 1] = -X[:, 1, 0]
        X[:, 0, 2], X[:, 1, 2] = a * x - b * y, b * x + a * y
        return X
    from scipy.spatial.transform import Rotation

    X[:, :3, :3] = Rotation.from_rotvec(phi).as_matrix()
    square = angle * angle
    rest = 1 / 6 - square * (1 / 120 - square * (1 / 5040 - square / 362880))
    np.divide(angle - np.sin(angle), square * angle, out=rest, where=angle > SMALL)
    once = np.cross(phi, v)
    X[:, :3, 3] = v + b[:, None] * once + rest[:, None] * np.cross(phi, once)
    return X


def inverse(X):
    """Return the inverses of poses (N, d+1, d+1)."""
    Y = np.zeros_like(X)
    turned = X[:, :-1, :-1].swapaxes(1, 2)
    Y[:, :-1, :-1] = turned
    Y[:, :-1, -1:] = -turned @ X[:, :-1, -1:]
    Y[:, -1, -1] = 1
    return Y


def jacobians(e, back):
    """Return the derivatives of residuals e (N, n) at both ends of their edges, (N, n, n) each.

    e = log(inverse(Z) inverse(X_i) X_j), and `back` is inverse(X_j) X_i, the way from j to
    i: X_i Exp(delta) changes e as X_j Exp(-Ad(back) delta) does.
    """
    at_j = right_jacobian_inverse(e)
    return -at_j @ adjoint(back), at_j


def adjoint(X):
    """Return Ad(X), (N, n, n): X Exp(xi) = Exp(Ad(X) xi) X."""
    d = X.shape[-1] - 1
    R, t = X[:, :d, :d], X[:, :d, d]
    n = 3 if d == 2 else 6
    A = np.zeros((len(X), n, n))
    A[:, :d, :d] = R
    A[:, d:, d:] = 1 if d == 2 else R
    if d == 2:
        A[:, 0, 2], A[:, 1, 2] = t[:, 1], -t[:, 0]
    else:
        A[:, :3, 3:] = _cross_matrix(t) @ R
    return A


def right_jacobian_inverse(xi):
    """Return J, (N, n, n): log(exp(xi) exp(delta)) = xi + J delta, to first order in delta.

    J is x / (1 - exp(-x)) at the matrix x = ad(xi). Its odd part is x / 2. Its even part is
    (x/2) coth(x/2), and because the eigenvalues of x are 0 and +-i angle (each twice in
    space), it equals 1 + b x^2 + c x^4 when value and slope agree there.
    """
    d = 2 if xi.shape[1] == 3 else 3
    angle = xi[:, 2] if d == 2 else np.linalg.norm(xi[:, 3:], axis=1)
    ad = small_adjoint(xi)
    square = ad @ ad
    even = half_cotangent_rest(angle)[:, None, None] * square
    if d == 3:
        c = _fourth(angle)[:, None, None]
        even += c * (square @ square + (angle * angle)[:, None, None] * square)
    return np.eye(xi.shape[1]) + ad / 2 + even


def small_adjoint(xi):
    """Return ad(xi), (N, n, n): the derivative of Ad(exp(s xi)) at s = 0."""
    ad = np.zeros((len(xi), xi.shape[1], xi.shape[1]))
    if xi.shape[1] == 3:
        x, y, angle = xi.T
        ad[:, 0, 1], ad[:, 0, 2] = -angle, y
        ad[:, 1, 0], ad[:, 1, 2] = angle, -x
        return ad
    ad[:, :3, :3] = ad[:, 3:, 3:] = _cross_matrix(xi[:, 3:])
    ad[:, :3, 3:] = _cross_matrix(xi[:, :3])
    return ad


def half_cotangent(angle):
    """Return (angle/2) cot(angle/2): 1 at 0, 0 at pi."""
    return 1 - angle * angle * half_cotangent_rest(angle)


def half_cotangent_rest(angle):
    """Return (1 - (angle/2) cot(angle/2)) / angle^2: 1/12 at 0."""
    s = angle * angle
    rest = 1 / 12 + s * (1 / 720 + s * (1 / 30240 + s * (1 / 1209600 + s / 47900160)))
    half = angle / 2
    large = np.abs(angle) > SMALL
    # From the half angles: sin(angle) loses its digits near pi.
    cotangent = np.divide(half * np.cos(half), np.sin(half), out=np.ones_like(half), where=large)
    return np.divide(1 - cotangent, s, out=rest, where=large)


def _fourth(angle):
    """Return c of `right_jacobian_inverse`: -1/720 at 0."""
    s = angle * angle
    rest = -1 / 720 + s * (-1 / 15120 + s * (-1 / 403200 + s * (-1 / 11975040)))
    large = np.abs(angle) > SMALL
    half = angle / 2
    ratio = np.divide(half, np.sin(half), out=np.ones_like(half), where=large)
    # slope * angle + 2 (1 - value), where value = (angle/2) cot(angle/2)
    value = 1 - s * half_cotangent_rest(angle)
    top = 2 - value - ratio * ratio
    return np.divide(top, 2 * s * s, out=rest, where=large)


def _cross_matrix(v):
    x, y, z = v.T
    C = np.zeros((len(v), 3, 3))
    C[:, 0, 1], C[:, 0, 2], C[:, 1, 2] = -z, y, -x
    C[:, 1, 0], C[:, 2, 0], C[:, 2, 1] = z, -y, x
    return C
