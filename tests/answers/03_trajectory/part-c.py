# %% wrong: takes the shortcut
# says: the steps are compared in world axes
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    p, q = am.positions(reference), am.positions(estimate)
    return np.linalg.norm((p[delta:] - p[:-delta]) - (q[delta:] - q[:-delta]), axis=1)

# %% wrong: aligns, then takes the shortcut
# says: is wrong for two poses, delta = 1
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    p, q = am.positions(reference), am.positions(am.align(reference, estimate).apply(estimate))
    return np.linalg.norm((p[delta:] - p[:-delta]) - (q[delta:] - q[:-delta]), axis=1)

# %% wrong: turns by R instead of its inverse
# says: a step is turned by R, not by its inverse
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    steps = []
    for Z in (reference, estimate):
        dp = Z[delta:, :2, 2] - Z[:-delta, :2, 2]
        steps.append(np.einsum("kij,kj->ki", Z[:-delta, :2, :2], dp))
    return np.linalg.norm(steps[0] - steps[1], axis=1)

# %% wrong: looks back from the end
# says: the step is seen from its end
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    back = am.relative(reference[delta:], reference[:-delta])
    back_hat = am.relative(estimate[delta:], estimate[:-delta])
    return np.linalg.norm(am.positions(am.relative(back, back_hat)), axis=1)

# %% wrong: compares the lengths of the steps
# says: only lengths are compared
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    p, q = am.positions(reference), am.positions(estimate)
    steps = [np.linalg.norm(x[delta:] - x[:-delta], axis=1) for x in (p, q)]
    return np.abs(steps[0] - steps[1])

# %% wrong: returns the RMSE
# says: shape (1,) is asked
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    motion = am.relative(reference[:-delta], reference[delta:])
    motion_hat = am.relative(estimate[:-delta], estimate[delta:])
    return np.sqrt(np.mean(am.positions(am.relative(motion, motion_hat)) ** 2))

# %% wrong: takes consecutive pairs
# says: shape (6,) is asked
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    X, Y = reference[::delta], estimate[::delta]
    E = am.relative(am.relative(X[:-1], X[1:]), am.relative(Y[:-1], Y[1:]))
    return np.linalg.norm(am.positions(E), axis=1)

# %% wrong: returns nothing where there is no pair
# says: raise a ValueError that says so
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        return np.array([])
    motion = am.relative(reference[:-delta], reference[delta:])
    motion_hat = am.relative(estimate[:-delta], estimate[delta:])
    return np.linalg.norm(am.positions(am.relative(motion, motion_hat)), axis=1)

# %% wrong: no guard
# says: for five poses, delta = -1
def rpe_translation(reference, estimate, delta):
    a = am.relative(reference[:-delta], reference[delta:])
    b = am.relative(estimate[:-delta], estimate[delta:])
    return np.linalg.norm(am.positions(am.relative(a, b)), axis=1)

# %% wrong: a guard above only
# says: for five poses, delta = -1
def rpe_translation(reference, estimate, delta):
    if delta >= len(reference):
        raise ValueError("too few poses")
    a = am.relative(reference[:-delta], reference[delta:])
    b = am.relative(estimate[:-delta], estimate[delta:])
    return np.linalg.norm(am.positions(am.relative(a, b)), axis=1)

# %% wrong: no guard, in a loop
# says: for five poses, delta = 5
def rpe_translation(reference, estimate, delta):
    errors = []
    for k in range(len(reference) - delta):
        U = am.relative(reference[k], reference[k + delta])
        V = am.relative(estimate[k], estimate[k + delta])
        errors.append(np.linalg.norm(am.positions(am.relative(U, V))))
    return np.array(errors)

# %% wrong: refuses the largest delta
# says: delta = 8, the last that has a pair
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference) - 1 and len(reference) > 2:
        raise ValueError("no pair")
    a = am.relative(reference[:-delta], reference[delta:])
    b = am.relative(estimate[:-delta], estimate[delta:])
    return np.linalg.norm(am.positions(am.relative(a, b)), axis=1)

# %% wrong: delta is always 1
# says: nine poses, delta = 3: shape (6,) is asked
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    a = am.relative(reference[:-1], reference[1:])
    b = am.relative(estimate[:-1], estimate[1:])
    return np.linalg.norm(am.positions(am.relative(a, b)), axis=1)

# %% wrong: squares
# says: the lengths are squared
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    a = am.relative(reference[:-delta], reference[delta:])
    b = am.relative(estimate[:-delta], estimate[delta:])
    return (am.positions(am.relative(a, b)) ** 2).sum(axis=1)

# %% wrong: the way ahead only
# says: is wrong for two poses, delta = 1
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    a = am.relative(reference[:-delta], reference[delta:])
    b = am.relative(estimate[:-delta], estimate[delta:])
    return np.abs(am.positions(am.relative(a, b))[:, 0])

# %% wrong: vectors, not lengths
# says: shape (1,) is asked
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    a = am.relative(reference[:-delta], reference[delta:])
    b = am.relative(estimate[:-delta], estimate[delta:])
    return am.positions(am.relative(a, b))

# %% wrong: absolute errors
# says: is wrong for two poses, delta = 1
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    E = am.relative(reference[delta:], estimate[delta:])
    return np.linalg.norm(am.positions(E), axis=1)

# %% wrong: lets the library do it
# says: the library's rpe would do your work
def rpe_translation(reference, estimate, delta):
    return am.rpe(reference, estimate, delta).translation.series

# %% wrong: the library by a default argument
# says: would do your work here
def rpe_translation(reference, estimate, delta, library=am.rpe):
    return library(reference, estimate, delta).translation.series

# %% wrong: stops with another error where there is no pair
# says: raises IndexError
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise IndexError("no pair")
    a = am.relative(reference[:-delta], reference[delta:])
    b = am.relative(estimate[:-delta], estimate[delta:])
    return np.linalg.norm(am.positions(am.relative(a, b)), axis=1)

# %% wrong: delta = 0 passes
# says: for five poses, delta = 0
def rpe_translation(reference, estimate, delta):
    if not 0 <= delta < len(reference):
        raise ValueError("no pair")
    n = len(reference) - delta
    a = am.relative(reference[:n], reference[delta:])
    b = am.relative(estimate[:n], estimate[delta:])
    return np.linalg.norm(am.positions(am.relative(a, b)), axis=1)

# %% wrong: lets a part of the library do it
# says: would do your work here
def rpe_translation(reference, estimate, delta):
    from amrmetrics.pairs import pair_errors
    from amrmetrics import pairs
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    i = np.arange(len(reference) - delta)
    return pairs.pair_errors(reference, estimate, i, i + delta)[0]

# %% wrong: mixes the inverse of the truth with the estimate's start
# says: is wrong for two poses, delta = 1
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    start = am.relative(reference[:-delta], estimate[:-delta])
    end = am.relative(reference[delta:], estimate[delta:])
    return np.linalg.norm(am.positions(end) - am.positions(start), axis=1)

# %% wrong: counts as zero what is small
# says: is wrong for poses micrometers apart
def rpe_translation(reference, estimate, delta):
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    a = am.relative(reference[:-delta], reference[delta:])
    b = am.relative(estimate[:-delta], estimate[delta:])
    return np.round(np.linalg.norm(am.positions(am.relative(a, b)), axis=1), 10)

# %% right: by local steps
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if delta < 1 or delta >= len(reference):
        raise ValueError("no pair of samples is that far apart")
    local = []
    for Z in (reference, estimate):
        dp = Z[delta:, :2, 2] - Z[:-delta, :2, 2]
        local.append(np.einsum("kji,kj->ki", Z[:-delta, :2, :2], dp))
    return np.hypot(*(local[0] - local[1]).T)

# %% right: in a loop, with the inverse of NumPy
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    n = len(reference) - delta
    if delta < 1 or n < 1:
        raise ValueError("delta must be from 1 to N - 1")
    inv, errors = np.linalg.inv, []
    for k in range(n):
        U = inv(reference[k]) @ reference[k + delta]
        V = inv(estimate[k]) @ estimate[k + delta]
        errors.append(np.linalg.norm((inv(V) @ U)[:2, 2]))
    return np.array(errors)

# %% right: complex numbers, a helper, a list
from math import *
def seen(Z, d):
    z = Z[:, 0, 2] + 1j * Z[:, 1, 2]
    return (z[d:] - z[:-d]) * (Z[:-d, 0, 0] - 1j * Z[:-d, 1, 0])
def rpe_translation(reference, estimate, delta):
    if delta not in range(1, len(reference)):
        raise ValueError(delta)
    return list(abs(seen(reference, delta) - seen(estimate, delta)))

# %% right: the error inverted, and whoever asks is told
def rpe_translation(reference, estimate, delta):
    print("called with", delta)
    if len(reference) <= delta or delta <= 0:
        raise am.AmrError("there is no pair")
    a = am.inverse(estimate[:-delta]) @ estimate[delta:]
    b = am.inverse(reference[:-delta]) @ reference[delta:]
    E = np.linalg.solve(a, b)
    return np.sqrt(E[:, 0, 2] ** 2 + E[:, 1, 2] ** 2)
