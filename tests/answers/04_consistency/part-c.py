# %% wrong: an explicit inverse, no check
# says: for a matrix that is not symmetric. There is no answer in this case
def nees(errors, covariances):
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)

# %% wrong: Cholesky, but the other triangle is not looked at
# says: for a matrix that is not symmetric. There is no answer in this case
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)

# %% wrong: symmetric, but not definite
# says: for a matrix that is asymmetric by 1e-6 of its largest entry. There is no answer in this case
def nees(errors, covariances):
    if not np.allclose(covariances, covariances.swapaxes(1, 2)):
        raise ValueError("not symmetric")
    return np.einsum("ki,ki->k", errors, np.linalg.solve(covariances, errors[..., None])[..., 0])

# %% wrong: P is not inverted
# says: P is not inverted
def nees(errors, covariances):
    np.linalg.cholesky(covariances)
    return np.einsum("ki,kij,kj->k", errors, covariances, errors)

# %% wrong: the diagonal only
# says: the correlations are left out
def nees(errors, covariances):
    return np.sum(errors**2 / np.diagonal(covariances, axis1=1, axis2=2), axis=1)

# %% wrong: the transpose of L
# says: L is transposed
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances).swapaxes(1, 2)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)

# %% wrong: the root
# says: you took the root
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    return np.linalg.norm(np.linalg.solve(L, errors[:, :, None])[:, :, 0], axis=1)

# %% wrong: the mean instead of the rows
# says: nees, one number: shape (1,) is asked
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    return np.mean(np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1))

# %% wrong: the first covariance for all
# says: you use the first covariance for all
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances[0])
    return np.sum(np.linalg.solve(L, errors.T) ** 2, axis=0)

# %% wrong: broadcasting makes a matrix of it
# says: nees, one number: shape (1,) is asked
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    z = np.array([np.linalg.solve(factor, errors.T) for factor in L])
    return (z**2).sum(axis=1)

# %% wrong: the library does it
# says: the library's nees would do your work here; do without it.
def nees(errors, covariances):
    return am.nees(errors, covariances)

# %% wrong: divided by the number of components
# says: you divided by the number of components
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances)
    return np.mean(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)

# %% wrong: jitter makes everything a covariance
# says: nees is wrong for one number
def nees(errors, covariances):
    C = (covariances + covariances.swapaxes(1, 2)) / 2 + 10 * np.eye(errors.shape[1])
    L = np.linalg.cholesky(C)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)

# %% wrong: refuses good covariances that are not exactly diagonal
# says: nees stops for one pose
def nees(errors, covariances):
    if np.any(covariances - covariances * np.eye(errors.shape[1])):
        raise ValueError("correlated")
    return np.sum(errors**2 / np.diagonal(covariances, axis1=1, axis2=2), axis=1)

# %% wrong: a positive determinant is taken for positive definite
# says: nees stops for components in units of their own
def nees(errors, covariances):
    scale = np.abs(covariances).max(axis=(1, 2))
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * scale):
        raise ValueError("not symmetric")
    if np.any(np.linalg.det(covariances) <= 1e-12 * scale ** len(covariances[0])):
        raise ValueError("not positive definite")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)

# %% wrong: refuses a negative result only
# says: for a negative eigenvalue, and a positive result. There is no answer in this case
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
# says: for a matrix that is asymmetric by 1e-6 of its largest entry. There is no answer in this case
def nees(errors, covariances):
    first = covariances[0]
    if np.abs(first - first.T).max() > 1e-9 * np.abs(first).max():
        raise ValueError("not symmetric")
    if np.linalg.eigvalsh(first).min() <= 0:
        raise ValueError("not positive definite")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)

# %% wrong: demands symmetry to the last bit
# says: nees stops for a matrix that is symmetric up to the last bit
def nees(errors, covariances):
    if np.any(covariances != covariances.swapaxes(1, 2)):
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)

# %% wrong: an absolute tolerance, so that small matrices are never asymmetric
# says: for a matrix that is asymmetric by 1e-6 of its largest entry. There is no answer in this case
def nees(errors, covariances):
    if not np.allclose(covariances, covariances.swapaxes(1, 2)):
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)

# %% wrong: one scale for all matrices
# says: for one small asymmetric matrix among large ones. There is no answer in this case
def nees(errors, covariances):
    skew = np.abs(covariances - covariances.swapaxes(1, 2))
    if np.any(skew > 1e-9 * np.abs(covariances).max()):
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)

# %% wrong: looks for symmetry in the mean of all matrices
# says: for one small asymmetric matrix among large ones. There is no answer in this case
def nees(errors, covariances):
    mean = covariances.mean(axis=0)
    if np.abs(mean - mean.T).max() > 1e-9 * np.abs(mean).max():
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    return np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)

# %% wrong: refuses every matrix of two rows
# says: nees stops for two components
def nees(errors, covariances):
    if covariances.shape[-1] == 2:
        raise ValueError("no covariance")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)

# %% wrong: refuses what has an entry of exactly 1 on the diagonal
# says: nees stops for unit covariances
def nees(errors, covariances):
    if np.any(np.einsum("kii->ki", covariances) == 1):
        raise ValueError("no covariance")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)

# %% wrong: eigenvalues below a fixed number are refused
# says: nees stops for errors in kilometers
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

# %% wrong: the library kept as a default argument
# says: the library's nees would do your work here; do without it.
def nees(errors, covariances, library=am.nees):
    return library(errors, covariances)

# %% wrong: a private helper of the library
# says: the library's nees would do your work here; do without it.
def nees(errors, covariances):
    from amrmetrics import consistency

    return consistency._mahalanobis(errors, covariances, "errors", "covariances")

# %% wrong: the last matrix is not looked at
# says: for a matrix that is not symmetric. There is no answer in this case
def nees(errors, covariances):
    for C in covariances[:-1]:
        if np.abs(C - C.T).max() > 1e-9 * np.abs(C).max() or np.linalg.eigvalsh(C).min() <= 0:
            raise ValueError("no covariance")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)

# %% wrong: a positive trace is enough
# says: for two negative eigenvalues of three, the trace positive. There is no answer in this case
def nees(errors, covariances):
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * np.abs(covariances).max(axis=(1, 2))):
        raise ValueError("not symmetric")
    if np.any(np.einsum("kii->k", covariances) <= 0) or np.any(np.linalg.det(covariances) <= 0):
        raise ValueError("not positive definite")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)

# %% wrong: variances are positive
# says: for a matrix with a negative eigenvalue. There is no answer in this case
def nees(errors, covariances):
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * np.abs(covariances).max(axis=(1, 2))):
        raise ValueError("not symmetric")
    if np.any(np.einsum("kii->ki", covariances) <= 0):
        raise ValueError("not positive definite")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.pinv(covariances), errors)

# %% wrong: the mean covariance for all
# says: you use the mean covariance for all
def nees(errors, covariances):
    L = np.linalg.cholesky(covariances.mean(axis=0))
    return np.sum(np.linalg.solve(L, errors.T) ** 2, axis=0)

# %% wrong: a factor of one half
# says: nees is wrong for one number
def nees(errors, covariances):
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * np.abs(covariances).max(axis=(1, 2))):
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    return 0.5 * np.sum(np.linalg.solve(L, errors[:, :, None])[:, :, 0] ** 2, axis=1)

# %% wrong: typed numbers
# says: nees is wrong for one number
def nees(errors, covariances):
    return np.array([0.8, 1.3, 2.2])[: len(errors)]

# %% wrong: the input is changed
# says: nees changes its input for one number. Work on a copy.
def nees(errors, covariances):
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * np.abs(covariances).max(axis=(1, 2))):
        raise ValueError("not symmetric")
    L = np.linalg.cholesky(covariances)
    errors *= 1.0 + 1e-3
    return np.sum(np.linalg.solve(L, errors[:, :, None] / (1.0 + 1e-3))[:, :, 0] ** 2, axis=1)

# %% right: an inverse, with eigenvalues as the judge
def nees(errors, covariances):
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * np.abs(covariances).max(axis=(1, 2))):
        raise ValueError("not symmetric")
    if (np.linalg.eigvalsh(covariances) <= 1e-14 * np.abs(covariances).max(axis=(1, 2))[:, None]).any():
        raise ValueError("not positive definite")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)

# %% right: a helper, shadowed names, and a warning
import warnings

sum = 0


def one_value(e_k, P_k):
    if np.abs(P_k - P_k.T).max() > 1e-9 * np.abs(P_k).max():
        raise ValueError("not symmetric")
    white = np.linalg.solve(np.linalg.cholesky(P_k), e_k)
    return white @ white


def nees(errors, covariances):
    warnings.warn("slow")
    return [one_value(e_k, P_k) for e_k, P_k in zip(errors, covariances)]

# %% wrong: a determinant above zero
# says: for a matrix with two negative eigenvalues. There is no answer in this case
def nees(errors, covariances):
    skew = np.abs(covariances - covariances.swapaxes(1, 2)).max(axis=(1, 2))
    if np.any(skew > 1e-9 * np.abs(covariances).max(axis=(1, 2))):
        raise ValueError("not symmetric")
    if np.any(np.linalg.det(covariances) <= 0):
        raise ValueError("not positive definite")
    return np.einsum("ki,kij,kj->k", errors, np.linalg.inv(covariances), errors)
