# %% wrong: an explicit inverse, no check
def nees(errors, covariances):
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)


# %% wrong: Cholesky, but the other triangle is not looked at
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)


# %% wrong: symmetric, but not definite
def nees(errors, covariances):
    if not np.allclose(covariances, covariances.swapaxes(1, 2)):
        raise ValueError("not symmetric")
    return np.einsum("ki,ki->k", errors, np.linalg.solve(covariances, errors[..., None])[..., 0])


# %% wrong: P is not inverted
def nees(errors, covariances):
    np.linalg.cholesky(covariances)
    return np.einsum("ki,kij,kj->k", errors, covariances, errors)


# %% wrong: the diagonal only
def nees(errors, covariances):
    return np.sum(errors**2 / np.diagonal(covariances, axis1=1, axis2=2), axis=1)


# %% wrong: the transpose of L
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances).swapaxes(1, 2)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)


# %% wrong: the root
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    return np.linalg.norm(np.linalg.solve(L, errors[:, :, None])[:, :, 0], axis=1)


# %% wrong: the mean instead of the rows
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    return np.mean(np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1))


# %% wrong: the first covariance for all
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances[0])
    return np.sum(np.linalg.solve(L, errors.T) ** 2, axis=0)


# %% wrong: broadcasting makes a matrix of it
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    z = np.array([np.linalg.solve(factor, errors.T) for factor in L])
    return (z**2).sum(axis=1)


# %% wrong: the library does it
def nees(errors, covariances):
    return am.nees(errors, covariances)


# %% wrong: divided by the number of components
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    return np.mean(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)


# %% wrong: jitter makes everything a covariance
def nees(errors, covariances):
    C = (covariances + covariances.swapaxes(1, 2)) / 2 + 10 * np.eye(errors.shape[1])
    L = np.linalg.cholesky(C)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)


# %% wrong: refuses good covariances that are not exactly diagonal
def nees(errors, covariances):
    if np.any(covariances - covariances * np.eye(errors.shape[1])):
        raise ValueError("correlated")
    return np.sum(errors**2 / np.diagonal(covariances, axis1=1, axis2=2), axis=1)


# %% wrong: a positive determinant is taken for positive definite
def nees(errors, covariances):
    scale = np.abs(covariances).max(axis=(1, 2))
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * scale):
        raise ValueError("not symmetric")
    if np.any(np.linalg.det(covariances) <= 1e-12 * scale ** len(covariances[0])):
        raise ValueError("not positive definite")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)


# %% wrong: refuses a negative result only
def nees(errors, covariances):
    scale = np.abs(covariances).max(axis=(1, 2))
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * scale):
        raise ValueError("not symmetric")
    values = np.einsum("ki,ki->k", errors, np.linalg.solve(covariances, errors[..., None])[..., 0])
    if np.any(values < 0):
        raise ValueError("negative")
    return values


# %% wrong: looks at the first matrix only
def nees(errors, covariances):
    first = covariances[0]
    if np.abs(first - first.T).max() > 1e-9 * np.abs(first).max():
        raise ValueError("not symmetric")
    if np.linalg.eigvalsh(first).min() <= 0:
        raise ValueError("not positive definite")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)


# %% wrong: demands symmetry to the last bit
def nees(errors, covariances):
    if np.any(covariances != covariances.swapaxes(1, 2)):
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)


# %% wrong: an absolute tolerance, so that small matrices are never asymmetric
def nees(errors, covariances):
    if not np.allclose(covariances, covariances.swapaxes(1, 2)):
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)


# %% wrong: one scale for all matrices
def nees(errors, covariances):
    skew = np.abs(covariances - covariances.swapaxes(1, 2))
    if np.any(skew > 1e-9 * np.abs(covariances).max()):
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)


# %% wrong: looks for symmetry in the mean of all matrices
def nees(errors, covariances):
    mean = covariances.mean(axis=0)
    if np.abs(mean - mean.T).max() > 1e-9 * np.abs(mean).max():
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)


# %% wrong: refuses every matrix of two rows
def nees(errors, covariances):
    if covariances.shape[-1] == 2:
        raise ValueError("no covariance")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)


# %% wrong: refuses what has an entry of exactly 1 on the diagonal
def nees(errors, covariances):
    if np.any(np.einsum("kii->ki", covariances) == 1):
        raise ValueError("no covariance")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)


# %% wrong: eigenvalues below a fixed number are refused
def nees(errors, covariances):
    scale = np.abs(covariances).max(axis=(1, 2))
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * scale) or np.linalg.eigvalsh(covariances).min() < 1e-9:
        raise ValueError("no covariance")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)


# %% right: a loop with SciPy
def nees(errors, covariances):
    from scipy.linalg import cho_factor, cho_solve

    values = []
    for e_k, P_k in zip(errors, covariances):
        if np.abs(P_k - P_k.T).max() > 1e-9 * np.abs(P_k).max():
            raise ValueError("asymmetric")
        values.append(e_k @ cho_solve(cho_factor(P_k), e_k))
    return np.array(values)


# %% right: eigenvalues
def nees(errors, covariances):
    size = np.abs(covariances).max(axis=(1, 2), keepdims=True)
    scaled = covariances / size
    if not np.allclose(scaled, np.transpose(scaled, (0, 2, 1)), rtol=0, atol=1e-9):
        raise ValueError("asymmetric")
    variances, axes = np.linalg.eigh(covariances)
    if (variances <= 1e-13 * variances.max(axis=1, keepdims=True)).any():
        raise ValueError("not positive definite")
    return np.sum(np.einsum("kij,ki->kj", axes, errors) ** 2 / variances, axis=1)
