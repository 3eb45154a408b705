# %% wrong: takes the shortcut
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    p, q = am.positions(reference), am.positions(estimate)
    return np.linalg.norm((p[delta:] - p[:-delta]) - (q[delta:] - q[:-delta]), axis=1)
# %% wrong: aligns, then takes the shortcut
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    p, q = am.positions(reference), am.positions(am.align(reference, estimate).apply(estimate))
    return np.linalg.norm((p[delta:] - p[:-delta]) - (q[delta:] - q[:-delta]), axis=1)
# %% wrong: turns by R instead of its inverse
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    steps = []
    for Z in (reference, estimate):
        dp = Z[delta:, :2, 2] - Z[:-delta, :2, 2]
        steps.append(np.einsum("kij,kj->ki", Z[:-delta, :2, :2], dp))
    return np.linalg.norm(steps[0] - steps[1], axis=1)
# %% wrong: looks back from the end
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    back = am.relative(reference[delta:], reference[:-delta])
    back_hat = am.relative(estimate[delta:], estimate[:-delta])
    return np.linalg.norm(am.positions(am.relative(back, back_hat)), axis=1)
# %% wrong: compares the lengths of the steps
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    p, q = am.positions(reference), am.positions(estimate)
    steps = [np.linalg.norm(x[delta:] - x[:-delta], axis=1) for x in (p, q)]
    return np.abs(steps[0] - steps[1])
# %% wrong: returns the RMSE
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    motion = am.relative(reference[:-delta], reference[delta:])
    motion_hat = am.relative(estimate[:-delta], estimate[delta:])
    return np.sqrt(np.mean(am.positions(am.relative(motion, motion_hat)) ** 2))
# %% wrong: takes consecutive pairs
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    X, Y = reference[::delta], estimate[::delta]
    E = am.relative(am.relative(X[:-1], X[1:]), am.relative(Y[:-1], Y[1:]))
    return np.linalg.norm(am.positions(E), axis=1)
# %% wrong: returns nothing where there is no pair
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if not 1 <= delta < len(reference):
        return np.array([])
    motion = am.relative(reference[:-delta], reference[delta:])
    motion_hat = am.relative(estimate[:-delta], estimate[delta:])
    return np.linalg.norm(am.positions(am.relative(motion, motion_hat)), axis=1)
# %% wrong: lets the library do it
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    return am.rpe(reference, estimate, delta).translation.series
# %% wrong: mixes the inverse of the truth with the estimate's start
def rpe_translation(reference: np.ndarray, estimate: np.ndarray, delta: int) -> np.ndarray:
    if not 1 <= delta < len(reference):
        raise ValueError("no pair")
    start = am.relative(reference[:-delta], estimate[:-delta])
    end = am.relative(reference[delta:], estimate[delta:])
    return np.linalg.norm(am.positions(end) - am.positions(start), axis=1)
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
