# %% wrong: the chi-square falls
# says: your test accepts an implementation that wraps headings from below only.
def catches_wrong_optimizers(optimize):
    graph = drive(1, uneven=True)
    X = optimize(graph)
    assert graph.with_poses(X).summary().chi_square < graph.summary().chi_square

# %% wrong: the anchor only
# says: your test accepts an implementation that does not wrap headings.
def catches_wrong_optimizers(optimize):
    graph = drive(1, fixed=(3,), uneven=True)
    assert np.allclose(optimize(graph)[3], graph.poses[3])

# %% wrong: no turn beyond pi
# says: your test accepts an implementation that does not wrap headings.
def catches_wrong_optimizers(optimize):
    for fixed in ((0,), (3,), (2, 7)):
        graph = drive(0, fixed, uneven=True)
        X = optimize(graph)
        assert np.allclose(X[list(fixed)], graph.poses[list(fixed)], atol=1e-5)
        least = graph.with_poses(X).summary().chi_square
        for node in graph.free:
            for move in 1e-4 * np.vstack([np.eye(3), -np.eye(3)]):
                Y = X.copy()
                Y[node] = X[node] @ am.planar_poses([move[:2]], move[2:])[0]
                assert graph.with_poses(Y).summary().chi_square > least

# %% wrong: equal information
# says: your test accepts an implementation that ignores the information.
def catches_wrong_optimizers(optimize):
    for turns, fixed in ((1, (0,)), (-1, (3,)), (0, (2, 7))):
        graph = drive(turns, fixed)
        X = optimize(graph)
        assert np.allclose(X[list(fixed)], graph.poses[list(fixed)], atol=1e-5)
        least = graph.with_poses(X).summary().chi_square
        for node in graph.free:
            for move in 1e-4 * np.vstack([np.eye(3), -np.eye(3)]):
                Y = X.copy()
                Y[node] = X[node] @ am.planar_poses([move[:2]], move[2:])[0]
                assert graph.with_poses(Y).summary().chi_square > least

# %% wrong: node 0 is always the anchor
# says: your test accepts an implementation that fixes node 0, whatever the graph says.
def catches_wrong_optimizers(optimize):
    for turns in (1, -1):
        graph = drive(turns, uneven=True)
        X = optimize(graph)
        assert np.allclose(X[0], graph.poses[0], atol=1e-5)
        least = graph.with_poses(X).summary().chi_square
        for node in graph.free:
            for move in 1e-4 * np.vstack([np.eye(3), -np.eye(3)]):
                Y = X.copy()
                Y[node] = X[node] @ am.planar_poses([move[:2]], move[2:])[0]
                assert graph.with_poses(Y).summary().chi_square > least

# %% wrong: a minimum, but the anchor is not looked at
# says: your test accepts an implementation that fixes node 0, whatever the graph says.
def catches_wrong_optimizers(optimize):
    for turns, fixed in ((1, (0,)), (-1, (3,)), (0, (2,))):
        graph = drive(turns, fixed, uneven=True)
        X = optimize(graph)
        least = graph.with_poses(X).summary().chi_square
        for node in graph.free:
            for move in 1e-4 * np.vstack([np.eye(3), -np.eye(3)]):
                Y = X.copy()
                Y[node] = X[node] @ am.planar_poses([move[:2]], move[2:])[0]
                assert graph.with_poses(Y).summary().chi_square > least

# %% wrong: the total chi-square agrees with its degrees of freedom
# says: your test accepts an implementation that ignores the information.
def catches_wrong_optimizers(optimize):
    for turns in (0, 1, -1):
        graph = drive(turns, (3,))
        X = optimize(graph)
        assert np.allclose(X[3], graph.poses[3])
        assert graph.with_poses(X).summary().p_value > 1e-6

# %% wrong: measurements without noise
# says: your test accepts an implementation that ignores the information.
from dataclasses import replace

def catches_wrong_optimizers(optimize):
    for turns in (0, 1, -1):
        noisy = drive(turns, (3,), uneven=True)
        Z = am.relative(noisy.poses[noisy.edges[:, 0]], noisy.poses[noisy.edges[:, 1]])
        graph = replace(noisy, measurements=Z)
        assert np.allclose(optimize(graph), graph.poses, atol=1e-5)

# %% wrong: headings lie within pi
# says: your test accepts an implementation that does not wrap headings.
def catches_wrong_optimizers(optimize):
    X = optimize(drive(1, uneven=True))
    assert np.all(np.abs(am.yaw(X)) <= np.pi)

# %% wrong: the library decides
# says: the library's optimize would do your work here; do without it.
def catches_wrong_optimizers(optimize):
    for turns, fixed in ((1, (0,)), (-1, (3,)), (0, (2, 7))):
        graph = drive(turns, fixed, uneven=True)
        assert np.allclose(optimize(graph), am.optimize(graph).poses, atol=1e-5)

# %% wrong: returns a truth value
# says: your test accepts an implementation that does not wrap headings. It returns True; use asse
def catches_wrong_optimizers(optimize):
    graph = drive(1, (3,), uneven=True)
    return np.allclose(optimize(graph)[3], graph.poses[3])

# %% wrong: never calls what it tests
# says: there is no answer yet: your test never calls what it is to test.
def catches_wrong_optimizers(optimize):
    graph = drive(1, (3,), uneven=True)
    assert graph.summary().chi_square > 0

# %% wrong: a value instead of a function
# says: a function is asked, you have pose graph in the plane: 12 nodes, 15 edges, fixed 0.
catches_wrong_optimizers = drive(1)

# %% wrong: demands a chi-square of zero
# says: your test rejects an implementation that is right (am.optimize).
def catches_wrong_optimizers(optimize):
    graph = drive(1, (3,), uneven=True)
    assert graph.with_poses(optimize(graph)).summary().chi_square < 1e-6

# %% wrong: expects the result of the library
# says: your test breaks with AttributeError: 'numpy.ndarray' object has no attribute 'converged'
def catches_wrong_optimizers(optimize):
    result = optimize(drive(1, (3,), uneven=True))
    assert result.converged

# %% wrong: a second call must not change anything
# says: your test accepts an implementation that ignores the information.
def catches_wrong_optimizers(optimize):
    for turns, fixed in ((1, (0,)), (-1, (3,)), (0, (2, 7))):
        graph = drive(turns, fixed, uneven=True)
        X = optimize(graph)
        assert np.allclose(optimize(graph.with_poses(X)), X, atol=1e-5)

# %% wrong: twice the information, the same map
# says: your test accepts an implementation that does not wrap headings.
from dataclasses import replace

def catches_wrong_optimizers(optimize):
    for turns, fixed in ((1, (0,)), (-1, (3,)), (0, (2, 7))):
        graph = drive(turns, fixed, uneven=True)
        twice = replace(graph, information=2 * graph.information)
        assert np.allclose(optimize(graph), optimize(twice), atol=1e-5)

# %% wrong: other information, another map; the anchor stays
# says: your test accepts an implementation that does not wrap headings.
from dataclasses import replace

def catches_wrong_optimizers(optimize):
    for turns in (1, -1):
        graph = drive(turns, (3,), uneven=True)
        same = replace(graph, information=np.eye(3))
        assert not np.allclose(optimize(graph), optimize(same), atol=1e-5)
        assert np.allclose(optimize(graph)[3], graph.poses[3])

# %% wrong: one direction of one node is tried
# says: your test accepts an implementation that does not wrap headings.
def catches_wrong_optimizers(optimize):
    graph = drive(1, (3,), uneven=True)
    X = optimize(graph)
    assert np.allclose(X[3], graph.poses[3], atol=1e-5)
    Y = X.copy()
    Y[5] = X[5] @ am.planar_poses([[0.5, 0]], [0])[0]
    assert graph.with_poses(Y).summary().chi_square > graph.with_poses(X).summary().chi_square

# %% wrong: moves are so large that any map is better
# says: your test accepts an implementation that does not wrap headings.
def catches_wrong_optimizers(optimize):
    rng = np.random.default_rng(1)
    for turns, fixed in ((1, (0,)), (-1, (3,)), (0, (2, 7))):
        graph = drive(turns, fixed, uneven=True)
        X = optimize(graph)
        assert np.allclose(X[list(fixed)], graph.poses[list(fixed)], atol=1e-5)
        least = graph.with_poses(X).summary().chi_square
        for _ in range(20):
            Y = X @ am.planar_poses(rng.normal(size=(12, 2)), rng.normal(size=12))
            assert graph.with_poses(Y).summary().chi_square > least

# %% wrong: left turns only
# says: your test accepts an implementation that wraps headings from below only.
def catches_wrong_optimizers(optimize):
    for fixed in ((3,), (2, 7)):
        graph = drive(1, fixed, uneven=True)
        X = optimize(graph)
        assert np.allclose(X[list(fixed)], graph.poses[list(fixed)], atol=1e-5)
        least = graph.with_poses(X).summary().chi_square
        for node in graph.free:
            for move in 1e-4 * np.vstack([np.eye(3), -np.eye(3)]):
                Y = X.copy()
                Y[node] = X[node] @ am.planar_poses([move[:2]], move[2:])[0]
                assert graph.with_poses(Y).summary().chi_square > least

# %% wrong: positions only, straight on
# says: your test accepts an implementation that does not wrap headings.
def catches_wrong_optimizers(optimize):
    X = am.planar_poses([[0, 0], [1, 0], [2, 0]], [0, 0, 0])
    Z = am.planar_poses([[1, 0], [1, 0], [1.7, 0]], [0, 0, 0])
    graph = am.PoseGraph(X, [[0, 1], [1, 2], [0, 2]], Z, np.eye(3))
    assert np.allclose(am.positions(optimize(graph))[:, 0], [0, 0.9, 1.8], atol=1e-5)

# %% right: the gradient is zero
def catches_wrong_optimizers(optimize):
    for turns in (0, 1, -1):
        for fixed in ((0,), (3,), (4, 9)):
            graph = drive(turns, fixed, uneven=True, seed=2)
            found = graph.with_poses(optimize(graph))
            assert np.abs(found.poses[list(fixed)] - graph.poses[list(fixed)]).max() < 1e-5
            We = np.einsum("mij,mj->mi", graph.information, found.residuals())
            gradient = np.zeros((12, 3))
            for end, J in zip(graph.edges.T, found.jacobians()):
                np.add.at(gradient, end, np.einsum("mij,mi->mj", J, We))
            assert np.abs(gradient[graph.free]).max() < 0.05

# %% right: SciPy is the judge
def catches_wrong_optimizers(optimize):
    from scipy.optimize import least_squares

    for turns, fixed in ((1, (0,)), (-1, (3,)), (1, (2, 7))):
        graph = drive(turns, fixed, uneven=True, seed=1)
        roots = np.linalg.cholesky(graph.information).swapaxes(1, 2)

        def poses(v):
            d = np.zeros((12, 3))
            d[graph.free] = v.reshape(-1, 3)
            return graph.poses @ am.planar_poses(d[:, :2], d[:, 2])

        def white(v):
            e = graph.with_poses(poses(v)).residuals()
            return np.einsum("mij,mj->mi", roots, e).ravel()

        best = least_squares(white, np.zeros(3 * len(graph.free)), xtol=1e-12, ftol=1e-12, gtol=1e-12)
        assert np.allclose(optimize(graph), poses(best.x), atol=1e-4)

# %% right: random small moves
def catches_wrong_optimizers(optimize):
    rng = np.random.default_rng(7)
    for turns, fixed in ((1, (0,)), (-1, (5,)), (0, (2, 7)), (1, (11,))):
        graph = drive(turns, fixed, True, seed=3)
        X = optimize(graph)
        for k in fixed:
            assert np.allclose(X[k], graph.poses[k], atol=1e-4)
        least = graph.with_poses(X).summary().chi_square
        for _ in range(200):
            d = 1e-4 * rng.normal(size=(12, 3))
            d[list(fixed)] = 0
            for sign in (1, -1):
                Y = X @ am.planar_poses(sign * d[:, :2], sign * d[:, 2])
                assert graph.with_poses(Y).summary().chi_square >= least

# %% right: a step of Gauss-Newton is zero, the message says where
def catches_wrong_optimizers(optimize):
    for seed, turns, fixed in ((0, 1, [0]), (1, -1, [6]), (2, 0, [1, 10])):
        graph = drive(turns, fixed, uneven=True, seed=seed)
        found = graph.with_poses(optimize(graph))
        assert np.allclose(found.poses[fixed], graph.poses[fixed], atol=1e-5), "anchor"
        e, (A, B) = found.residuals(), found.jacobians()
        H, g = np.zeros((36, 36)), np.zeros(36)
        for k, (i, j) in enumerate(graph.edges):
            J = np.zeros((3, 36))
            J[:, 3 * i : 3 * i + 3], J[:, 3 * j : 3 * j + 3] = A[k], B[k]
            H += J.T @ graph.information[k] @ J
            g += J.T @ graph.information[k] @ e[k]
        free = (3 * graph.free[:, None] + np.arange(3)).ravel()
        step = np.linalg.solve(H[np.ix_(free, free)], g[free])
        assert np.abs(step).max() < 1e-5, "no minimum"

# %% right: graphs of its own
def catches_wrong_optimizers(optimize):
    rng = np.random.default_rng(3)
    for turn in (0.8, -0.8):
        n = 9
        truth = am.planar_poses(rng.normal(size=(n, 2)) * 3 + 5, 1.0 + turn * np.arange(n))
        edges = np.array([(i, j) for i in range(n) for j in range(i + 1, min(i + 4, n))])
        noise = 0.03 * rng.normal(size=(len(edges), 3))
        Z = am.relative(truth[edges[:, 0]], truth[edges[:, 1]])
        Z = Z @ am.planar_poses(noise[:, :2], noise[:, 2])
        A = rng.normal(size=(len(edges), 3, 3)) * [[1], [5], [9]]
        graph = am.PoseGraph(truth, edges, Z, A.swapaxes(1, 2) @ A + np.eye(3), fixed=(2, 6))
        X = optimize(graph)
        assert np.allclose(X[[2, 6]], truth[[2, 6]], atol=1e-5)
        chi = lambda Y: graph.with_poses(Y).summary().chi_square
        for k in graph.free:
            for d in 2e-4 * np.r_[np.eye(3), -np.eye(3)]:
                Y = X.copy()
                Y[k] = Y[k] @ am.planar_poses([d[:2]], [d[2]])[0]
                assert chi(Y) > chi(X)

# %% right: gradient by differences on several graphs
def catches_wrong_optimizers(optimize) -> None:
    for turns, fixed, seed in ((1, (3,), 1), (-1, (2, 7), 2), (0, (11,), 3), (1, (0, 5), 4)):
        g = drive(turns, fixed, True, seed)
        X = np.array(optimize(g))
        for k in fixed: assert np.abs(X[k] - g.poses[k]).max() < 1e-6
        f = lambda Y: g.with_poses(Y).summary().chi_square
        least = f(X)
        for k in range(12):
            if k in fixed: continue
            for axis in range(3):
                v = np.zeros(3); v[axis] = 1e-4
                up, down = X.copy(), X.copy()
                up[k] = X[k] @ am.planar_poses([v[:2]], [v[2]])[0]
                down[k] = X[k] @ am.planar_poses([-v[:2]], [-v[2]])[0]
                assert f(up) >= least and f(down) >= least
