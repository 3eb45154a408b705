"""Graphs are optimized as gtsam does it, and as closed forms say; files come back as they were."""

import dataclasses
import gzip
import json
import warnings
from pathlib import Path

import mpmath
import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm, logm
from scipy.optimize import least_squares
from scipy.sparse import csc_array
from scipy.spatial.transform import Rotation
from scipy.stats import kstest

import amrmetrics as am
from amrmetrics import _groups

ANGLES = [0.0, 1e-9, 1e-5, 0.0999, 0.1001, 1.0, 3.0, np.pi - 1e-4, np.pi - 1e-9]
PLANE, SPACE = 3, 6


def tangents(rng, dim, angle, n=20):
    """Return n tangent vectors whose rotation has that angle."""
    d = 2 if dim == PLANE else 3
    axis = rng.normal(size=(n, dim - d))
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    return np.column_stack([rng.normal(size=(n, d)), angle * axis])


def hat(xi):
    """Return the matrix whose exponential is the pose."""
    if len(xi) == PLANE:
        x, y, a = xi
        return np.array([[0, -a, x], [a, 0, y], [0, 0, 0]])
    x, y, z, a, b, c = xi
    return np.array([[0, -c, b, x], [c, 0, -a, y], [-b, a, 0, z], [0, 0, 0, 0]])


def random_poses(rng, dim, n, size=1.0, turn=1.0):
    scale = [size] * (2 if dim == PLANE else 3) + [turn] * (1 if dim == PLANE else 3)
    return _groups.exp(scale * rng.normal(size=(n, dim)))


def information(rng, edges, dim):
    A = rng.normal(size=(edges, dim, dim))
    return 20 * (A @ A.swapaxes(1, 2) + np.eye(dim))


def random_graph(rng, dim, n=30, closures=25, noise=1.0, start=0.2):
    """Return a graph with that noise, in standard deviations, and a start near the truth."""
    X = random_poses(rng, dim, n, 3.0)
    chain = np.column_stack([np.arange(n - 1), np.arange(1, n)])
    i, j = rng.integers(n, size=(2, 3 * closures))
    edges = np.concatenate([chain, np.column_stack([i, j])[i != j][:closures]])
    W = information(rng, len(edges), dim)
    error = np.linalg.solve(
        np.linalg.cholesky(W).swapaxes(1, 2), noise * rng.normal(size=(len(edges), dim, 1))
    )[:, :, 0]
    Z = am.relative(X[edges[:, 0]], X[edges[:, 1]]) @ _groups.exp(error)
    moved = start * rng.normal(size=(n, dim))
    moved[0] = 0
    return X, am.PoseGraph(X @ _groups.exp(moved), edges, Z, W)


@pytest.mark.parametrize("dim", [PLANE, SPACE])
class TestGroups:
    @pytest.mark.parametrize("angle", ANGLES)
    def test_exp_is_the_matrix_exponential(self, rng, dim, angle):
        xi = tangents(rng, dim, angle)
        expected = [expm(hat(v)) for v in xi]
        assert np.allclose(_groups.exp(xi), expected, rtol=0, atol=2e-14)

    @pytest.mark.parametrize("angle", ANGLES)
    def test_log_undoes_exp(self, rng, dim, angle):
        xi = tangents(rng, dim, angle)
        # Near half a turn the sign of the axis hangs on the last digits.
        back = _groups.log(_groups.exp(xi))
        if angle > np.pi - 1e-6:
            assert np.allclose(_groups.exp(back), _groups.exp(xi), rtol=0, atol=1e-12)
        else:
            assert np.allclose(back, xi, rtol=0, atol=1e-12 / (np.pi - angle))

    def test_log_is_the_matrix_logarithm(self, rng, dim):
        X = random_poses(rng, dim, 20)
        for xi, T in zip(_groups.log(X), X, strict=True):
            assert np.allclose(hat(xi), logm(T).real, atol=1e-12)

    def test_adjoint_moves_a_motion_to_the_other_side(self, rng, dim):
        X, xi = random_poses(rng, dim, 20), 0.3 * rng.normal(size=(20, dim))
        moved = np.einsum("mij,mj->mi", _groups.adjoint(X), xi)
        assert np.allclose(X @ _groups.exp(xi), _groups.exp(moved) @ X, atol=1e-12)

    @pytest.mark.parametrize("angle", ANGLES[:-1])
    def test_right_jacobian_by_differences(self, rng, dim, angle):
        xi, h = tangents(rng, dim, min(angle, np.pi - 1e-3)), 1e-5
        J = _groups.right_jacobian_inverse(xi)
        for k, step in enumerate(h * np.eye(dim)):
            ahead, behind = (
                _groups.log(_groups.exp(xi) @ _groups.exp(np.tile(s, (len(xi), 1))))
                for s in (step, -step)
            )
            assert np.allclose((ahead - behind) / (2 * h), J[:, :, k], atol=1e-8)

    def test_right_jacobian_is_the_inverse_of_its_series(self, rng, dim):
        # J_r = sum (-ad)^k / (k + 1)!, Sola, Deray and Atchuthan (2018), eq. (67) and after.
        for angle in ANGLES:
            xi = tangents(rng, dim, angle, 5)
            term = total = np.tile(np.eye(dim), (5, 1, 1))
            for k in range(1, 60):
                term = term @ -_groups.small_adjoint(xi) / (k + 1)
                total = total + term
            product = _groups.right_jacobian_inverse(xi) @ total
            assert np.allclose(product, np.eye(dim), rtol=0, atol=1e-11)


@pytest.mark.parametrize("angle", [1e-5, 1e-3, 0.0999, 0.1001, 1.0, 3.0, 3.14159])
def test_coefficients_keep_their_digits(angle):
    with mpmath.workdps(60):
        a = mpmath.mpf(angle)
        half = a / 2
        value = half * mpmath.cot(half)
        second = (1 - value) / a**2
        fourth = (2 - value - (half / mpmath.sin(half)) ** 2) / (2 * a**4)
        expected = float(second), float(fourth)
    found = _groups.half_cotangent_rest(np.array([angle]))[0], _groups._fourth(np.array([angle]))[0]
    assert found[0] == pytest.approx(expected[0], rel=1e-11)
    assert found[1] == pytest.approx(expected[1], rel=1e-7)


class TestResiduals:
    def test_in_the_plane_by_hand(self):
        X = am.planar_poses([[1, 1], [1, 3]], [np.pi / 2, np.pi])
        Z = am.planar_poses([[1.5, 0]], [np.pi / 2])
        graph = am.PoseGraph(X, [[0, 1]], Z, np.eye(3))
        # Two meters ahead of i; 1.5 m were measured, and half a meter ahead of i is to the
        # right of j, which looks to the left.
        assert graph.residuals()[0] == pytest.approx([0, -0.5, 0], abs=1e-15)

    def test_the_translation_belongs_to_the_tangent(self):
        # V(pi/2)^-1 (1, 0) = (pi/4, -pi/4): a straight chord is part of a bent way.
        X = am.planar_poses([[0, 0], [1, 0]], [0, np.pi / 2])
        graph = am.PoseGraph(X, [[0, 1]], np.eye(3)[None], np.eye(3))
        expected = [np.pi / 4, -np.pi / 4, np.pi / 2]
        assert graph.residuals()[0] == pytest.approx(expected)

    def test_the_heading_is_wrapped(self):
        X = am.planar_poses([[0, 0], [0, 0]], [3.1, -3.1])
        graph = am.PoseGraph(X, [[0, 1]], np.eye(3)[None], np.eye(3))
        assert graph.residuals()[0, 2] == pytest.approx(2 * np.pi - 6.2)

    @pytest.mark.parametrize("dim", [PLANE, SPACE])
    def test_zero_where_the_measurement_is_right(self, rng, dim):
        X, graph = random_graph(rng, dim, noise=0)
        assert np.abs(graph.with_poses(X).residuals()).max() < 1e-13
        assert np.abs(graph.residuals()).max() > 0.1

    @pytest.mark.parametrize("dim", [PLANE, SPACE])
    def test_no_frame_of_the_world_matters(self, rng, dim):
        _, graph = random_graph(rng, dim)
        turned = graph.with_poses(random_poses(rng, dim, 1)[0] @ graph.poses)
        assert np.allclose(turned.residuals(), graph.residuals(), atol=1e-12)

    @pytest.mark.parametrize("dim", [PLANE, SPACE])
    @pytest.mark.parametrize("angle", [0.0, 1e-6, 0.5, np.pi - 1e-3])
    def test_jacobians_by_differences(self, rng, dim, angle):
        X = random_poses(rng, dim, 20, 2.0)
        i, j = np.arange(10), np.arange(10, 20)
        Z = am.relative(X[i], X[j]) @ _groups.exp(-tangents(rng, dim, angle, 10))
        graph = am.PoseGraph(X, np.column_stack([i, j]), Z, np.eye(dim))
        h = 1e-5
        for nodes, J in zip((i, j), graph.jacobians(), strict=True):
            for k, step in enumerate(h * np.eye(dim)):
                ahead, behind = X.copy(), X.copy()
                ahead[nodes] = X[nodes] @ _groups.exp(step[None])
                behind[nodes] = X[nodes] @ _groups.exp(-step[None])
                slope = graph.with_poses(ahead).residuals() - graph.with_poses(behind).residuals()
                assert np.allclose(slope / (2 * h), J[:, :, k], atol=2e-8)


class TestPlaneBySymbols:
    """The Jacobians of the plane, derived from e = log(inverse(Z) inverse(X_i) X_j) by SymPy."""

    def pose(self, x, y, a):
        return sp.Matrix([[sp.cos(a), -sp.sin(a), x], [sp.sin(a), sp.cos(a), y], [0, 0, 1]])

    def inverse(self, X):
        R, t = X[:2, :2], X[:2, 2]
        return sp.Matrix.vstack(sp.Matrix.hstack(R.T, -R.T * t), sp.Matrix([[0, 0, 1]]))

    def test_both_ends(self, rng):
        z, p, q = (sp.symbols(f"{name}_x {name}_y {name}_a", real=True) for name in "zpq")
        u, v, w = sp.symbols("u v w", real=True)
        # X Exp(delta), to first order in delta.
        motion = sp.eye(3) + sp.Matrix([[0, -w, u], [w, 0, v], [0, 0, 0]])
        Z, P, Q = (self.pose(*s) for s in (z, p, q))
        turn = q[2] - p[2] - z[2]
        half = turn / 2
        points = rng.uniform(-1, 1, size=(30, 9))
        found = []
        for first, second in ((P * motion, Q), (P, Q * motion)):
            # The motion is no rotation beyond first order, so it is inverted as a matrix.
            back = P if first == P else None
            left = self.inverse(P) if back is not None else motion.adjugate() * self.inverse(P)
            E = self.inverse(Z) * left * second
            angle = turn + (w if back is not None else -w)
            a = angle / 2 * sp.cot(angle / 2)
            e = sp.Matrix(
                [
                    a * E[0, 2] + angle / 2 * E[1, 2],
                    a * E[1, 2] - angle / 2 * E[0, 2],
                    angle,
                ]
            )
            J = e.jacobian([u, v, w]).subs({u: 0, v: 0, w: 0})
            found.append(sp.lambdify([*z, *p, *q], J, "numpy"))
        assert half != 0
        Zs, Ps, Qs = (am.planar_poses(s[:, :2], s[:, 2]) for s in np.split(points, 3, axis=1))
        edges = np.column_stack([np.arange(30), np.arange(30, 60)])
        graph = am.PoseGraph(np.concatenate([Ps, Qs]), edges, Zs, np.eye(3))
        for f, J in zip(found, graph.jacobians(), strict=True):
            expected = np.array([f(*point) for point in points])
            assert np.allclose(J, expected, rtol=0, atol=1e-11)

    def test_the_inverse_right_jacobian_is_exact(self):
        x, y, a, u, v, w = sp.symbols("x y a u v w", real=True)
        # log(exp(xi) exp(delta)) by V(angle)^-1, against I + ad/2 + (1 - g)/a^2 ad^2.
        V = sp.Matrix([[sp.sin(a), sp.cos(a) - 1], [1 - sp.cos(a), sp.sin(a)]]) / a
        R = sp.Matrix([[sp.cos(a), -sp.sin(a)], [sp.sin(a), sp.cos(a)]])
        t = V * sp.Matrix([x, y]) + R * sp.Matrix([u, v])
        angle = a + w
        g = angle / 2 * sp.cot(angle / 2)
        e = sp.Matrix([g * t[0] + angle / 2 * t[1], g * t[1] - angle / 2 * t[0], angle])
        J = e.jacobian([u, v, w]).subs({u: 0, v: 0, w: 0})
        ad = sp.Matrix([[0, -a, y], [a, 0, -x], [0, 0, 0]])
        c = (1 - a / 2 * sp.cot(a / 2)) / a**2
        difference = J - (sp.eye(3) + ad / 2 + c * ad**2)
        half = sp.symbols("half", positive=True)
        for entry in difference:
            in_half = entry.subs(a, 2 * half).subs(sp.cot(half), sp.cos(half) / sp.sin(half))
            assert sp.simplify(sp.expand_trig(in_half)) == 0


@pytest.mark.parametrize("dim", [PLANE, SPACE])
class TestOptimize:
    def test_finds_the_truth_without_noise(self, rng, dim):
        X, graph = random_graph(rng, dim, noise=0)
        result = am.optimize(graph)
        assert result.converged
        assert np.allclose(result.poses, X, atol=1e-8)
        assert result.chi_square < 1e-9 < result.chi_square_before

    def test_equals_a_dense_solution(self, rng, dim):
        _, graph = random_graph(rng, dim, n=8, closures=8)
        roots = np.linalg.cholesky(graph.information).swapaxes(1, 2)

        def white(delta):
            X = graph.poses.copy()
            X[1:] = X[1:] @ _groups.exp(delta.reshape(-1, dim))
            return np.einsum("mij,mj->mi", roots, graph.with_poses(X).residuals()).ravel()

        dense = least_squares(white, np.zeros(7 * dim), xtol=1e-14, ftol=1e-14, gtol=1e-14)
        result = am.optimize(graph)
        assert result.chi_square == pytest.approx(2 * dense.cost, rel=1e-9)
        X = graph.poses[1:] @ _groups.exp(dense.x.reshape(-1, dim))
        assert np.allclose(result.poses[1:], X, atol=1e-5)

    @pytest.mark.parametrize("loss", ["huber", "cauchy", "geman_mcclure"])
    def test_robust_cost_is_least(self, rng, dim, loss):
        from amrmetrics.loops import LOSSES

        _, graph = random_graph(rng, dim, n=8, closures=8)
        roots = np.linalg.cholesky(graph.information).swapaxes(1, 2)
        result = am.optimize(graph, loss, width=2.0)

        def root_of_cost(delta):
            X = result.poses.copy()
            X[1:] = X[1:] @ _groups.exp(delta.reshape(-1, dim))
            e = np.einsum("mij,mj->mi", roots, graph.with_poses(X).residuals())
            return np.sqrt(LOSSES[loss]((e * e).sum(1), 2.0)[0])

        def cost(delta):
            return (root_of_cost(delta) ** 2).sum()

        assert result.converged
        assert result.cost == pytest.approx(cost(np.zeros(7 * dim)))
        # What is found is a minimum: the slope is nothing, and no way leads down.
        h = 1e-5
        slopes = [(cost(s) - cost(-s)) / (2 * h) for s in h * np.eye(7 * dim)]
        assert np.abs(slopes).max() < 1e-3 * np.sqrt(graph.information.max() * result.cost)
        for direction in rng.normal(size=(50, 7 * dim)):
            assert cost(1e-3 * direction) > result.cost

    def test_result_says_what_it_is(self, rng, dim):
        _, graph = random_graph(rng, dim)
        result = am.optimize(graph)
        before, after = graph.summary(), result.summary()
        assert result.chi_square_before == pytest.approx(before.chi_square, rel=1e-12)
        assert result.chi_square == pytest.approx(after.chi_square, rel=1e-9)
        assert np.allclose(result.edge_chi_square, after.edge_chi_square)
        assert result.dof == (len(graph.edges) - 29) * dim == after.dof
        assert result.p_value == pytest.approx(after.p_value, abs=1e-9)
        assert (result.cost, result.cost_before) == (result.chi_square, result.chi_square_before)
        assert result.weights.tolist() == [1] * len(graph.edges)
        assert result.history[0] == result.cost_before and result.history[-1] == result.cost
        assert (np.diff(result.history) <= 0).all()
        assert result.reason.startswith("converged") and 2 < result.iterations < 15
        assert np.array_equal(result.graph.poses, result.poses)
        assert np.array_equal(result.poses[0], graph.poses[0])
        assert "NOT" not in repr(result) and f"dof {result.dof}" in repr(result)
        assert np.isnan(result.width)
        assert result.inlier_ratio().n == len(graph.edges)
        plain = json.loads(json.dumps(result.as_dict()))
        assert plain["reason"] == result.reason and len(plain["weights"]) == len(graph.edges)
        assert "array of shape" in result._repr_html_() and "reason" in result._repr_html_()

    def test_input_is_not_changed(self, rng, dim):
        _, graph = random_graph(rng, dim)
        poses = graph.poses.copy()
        am.optimize(graph)
        assert np.array_equal(graph.poses, poses)

    def test_fixed_nodes_stay(self, rng, dim):
        _, graph = random_graph(rng, dim)
        graph = dataclasses.replace(graph, fixed=(3, 17, 29))
        result = am.optimize(graph)
        for k in (3, 17, 29):
            assert np.array_equal(result.poses[k], graph.poses[k])
        assert not np.array_equal(result.poses[0], graph.poses[0])
        assert result.dof == (len(graph.edges) - 27) * dim

    def test_the_gauge_does_not_matter(self, rng, dim):
        _, graph = random_graph(rng, dim)
        one = am.optimize(graph)
        two = am.optimize(dataclasses.replace(graph, fixed=(12,)))
        assert one.chi_square == pytest.approx(two.chi_square, rel=1e-9)
        assert np.allclose(
            am.relative(one.poses[12], one.poses), am.relative(two.poses[12], two.poses), atol=1e-5
        )

    def test_order_and_direction_of_edges_do_not_matter(self, rng, dim):
        _, graph = random_graph(rng, dim)
        # e of the edge turned around is -Ad(Z) e to first order; without noise there is no more.
        _, exact = random_graph(rng, dim, noise=0)
        turned = am.PoseGraph(
            exact.poses, exact.edges[:, ::-1], am.inverse(exact.measurements), exact.information
        )
        assert np.allclose(am.optimize(turned).poses, am.optimize(exact).poses, atol=1e-7)
        shuffled = graph.keep(rng.permutation(len(graph.edges)))
        assert am.optimize(shuffled).chi_square == pytest.approx(am.optimize(graph).chi_square)

    def test_chi_square_has_the_degrees_of_freedom_that_it_says(self, dim):
        # One false alarm in 10 000; one node or edge more or less would be found.
        rng = np.random.default_rng(21)
        p_values = []
        for _ in range(120):
            _, graph = random_graph(rng, dim, n=12, closures=6, noise=0.02, start=0.02)
            scaled = dataclasses.replace(graph, information=graph.information / 0.02**2)
            p_values.append(am.optimize(scaled).p_value)
        assert kstest(p_values, "uniform").pvalue > 1e-4

    def test_two_edges_between_the_same_nodes(self, dim):
        d = 2 if dim == PLANE else 3
        Z = np.tile(np.eye(d + 1), (2, 1, 1))
        Z[:, 0, d] = 1.0, 2.0
        W = np.stack([np.eye(dim), 3 * np.eye(dim)])
        X = np.tile(np.eye(d + 1), (2, 1, 1))
        result = am.optimize(am.PoseGraph(X, [[0, 1], [0, 1]], Z, W))
        assert result.poses[1, 0, d] == pytest.approx(1.75)
        assert result.chi_square == pytest.approx(0.75**2 + 3 * 0.25**2)

    def test_a_chain_spreads_the_closure_error_by_covariance(self, dim):
        # Edges along x with variances v_k, and a closure that is c longer than their sum: edge
        # k is stretched by c v_k / (sum of v and of the closure's).
        d = 2 if dim == PLANE else 3
        variances, closure, c = np.array([1.0, 2.0, 5.0]), 4.0, 0.6
        X = np.tile(np.eye(d + 1), (4, 1, 1))
        X[:, 0, d] = np.arange(4)
        Z = np.tile(np.eye(d + 1), (4, 1, 1))
        Z[:, 0, d] = 1, 1, 1, 3 + c
        W = np.stack([np.eye(dim) / v for v in (*variances, closure)])
        result = am.optimize(am.PoseGraph(X, [[0, 1], [1, 2], [2, 3], [0, 3]], Z, W))
        expected = np.arange(4) + np.append(0, (c * variances / 12).cumsum())
        assert am.positions(result.poses)[:, 0] == pytest.approx(expected, abs=1e-9)
        assert result.chi_square == pytest.approx(c**2 / 12)
        assert result.dof == dim

    def test_no_node_is_free(self, rng, dim):
        _, graph = random_graph(rng, dim, n=4, closures=2)
        result = am.optimize(dataclasses.replace(graph, fixed=range(4)))
        assert result.converged and result.reason == "no node is free"
        assert result.dof == len(graph.edges) * dim
        assert result.chi_square == pytest.approx(result.chi_square_before)

    def test_stops_when_told_and_says_so(self, rng, dim):
        _, graph = random_graph(rng, dim)
        result = am.optimize(graph, max_iterations=1)
        assert not result.converged and result.iterations == 1
        assert result.reason == "stopped after 1 iterations"
        assert "NOT CONVERGED" in repr(result)

    def test_strong_damping_is_no_convergence(self, rng, dim):
        # Each step promises less than the tolerance, and the minimum is far away.
        _, graph = random_graph(rng, dim)
        result = am.optimize(graph, damping=1e9)
        assert result.converged and result.iterations > 10
        assert result.chi_square == pytest.approx(am.optimize(graph).chi_square, rel=1e-7)

    def test_starting_at_the_minimum(self, rng, dim):
        _, graph = random_graph(rng, dim)
        first = am.optimize(graph)
        again = am.optimize(first.graph)
        assert again.converged and again.iterations <= 2
        assert again.chi_square == pytest.approx(first.chi_square, rel=1e-9)

    def test_equations_are_those_of_the_dense_jacobian(self, rng, dim):
        from amrmetrics import least_squares as module

        _, graph = random_graph(rng, dim)
        graph = dataclasses.replace(graph, fixed=(2, 5))
        weight = rng.uniform(0.1, 1, len(graph.edges))
        problem = module._Problem(graph, module.LOSSES["linear"], np.nan, weight > 2)
        e, back = problem.residuals(graph.poses)
        values, gradient = problem.equations(e, back, weight)
        n = dim * len(graph.free)
        H = csc_array((values, problem.indices, problem.indptr), shape=(n, n)).toarray()
        J = np.zeros((len(graph.edges), dim, 30, dim))
        k = np.arange(len(graph.edges))
        J[k, :, graph.edges[:, 0]], J[k, :, graph.edges[:, 1]] = graph.jacobians()
        J = J[:, :, graph.free[np.argsort(problem.unknown[graph.free])]].reshape(-1, dim, n)
        W = weight[:, None, None] * graph.information
        assert np.allclose(H, np.einsum("mai,mab,mbj->ij", J, W, J), atol=1e-9)
        expected = np.einsum("mai,mab,mb->i", J, W, graph.residuals())
        assert np.allclose(gradient.ravel(), expected, atol=1e-9)
        step = problem.solve(values, gradient, 0.5)
        assert np.allclose(step.ravel(), -np.linalg.solve(H + 0.5 * np.eye(n), expected))


class TestRobust:
    def run(self):
        run = am.simulation.city_run(np.random.default_rng(4), 300, closures=60, aliased=6)
        wanted = run.labels | (run.scores >= np.sort(run.scores[~run.labels])[-4])
        return run, wanted

    @pytest.mark.parametrize("loss", ["huber", "cauchy", "geman_mcclure"])
    def test_kernels_defend_against_false_closures(self, loss):
        run, wanted = self.run()
        right = am.optimize(run.graph(run.labels))
        graph = run.graph(wanted)
        ruined, saved = am.optimize(graph), am.optimize(graph, loss)
        assert saved.converged
        errors = [am.ate(run.truth, r.poses, "none").rmse for r in (right, saved, ruined)]
        assert errors[1] < 2 * errors[0] < errors[2]
        false = ~run.labels[wanted]
        weights = saved.weights[len(run.odometry) :]
        assert weights[false].max() < 0.3 < np.median(weights[~false])
        assert saved.loss == loss and loss in repr(saved)
        assert saved.cost < saved.cost_before
        assert (np.diff(saved.history) <= 0).all()
        ratio = saved.inlier_ratio()
        assert np.allclose(ratio.weights, saved.weights)
        assert ratio.width == saved.width

    def test_a_wide_kernel_is_linear(self, rng):
        _, graph = random_graph(rng, PLANE)
        linear = am.optimize(graph)
        for loss in ("huber", "cauchy", "geman_mcclure"):
            wide = am.optimize(graph, loss, width=1e5)
            assert wide.chi_square == pytest.approx(linear.chi_square, rel=1e-6)
            assert wide.weights.min() > 1 - 1e-6

    def test_a_kernel_on_some_edges_only(self):
        run, wanted = self.run()
        graph = run.graph(wanted)
        closures = np.arange(len(graph.edges)) >= len(run.odometry)
        result = am.optimize(graph, "cauchy", robust=closures)
        assert (result.weights[~closures] == 1).all()
        assert (result.weights[closures] < 1).all()
        nowhere = am.optimize(graph, "cauchy", robust=0 * closures > 0)
        assert nowhere.chi_square == pytest.approx(am.optimize(graph).chi_square)


class TestDivergence:
    def far(self):
        """Return a graph whose edges contradict each other, started beside its minimum."""
        rng = np.random.default_rng(10)
        _, graph = random_graph(rng, PLANE, n=6, closures=6, noise=30)
        moved = 0.05 * rng.normal(size=(6, 3))
        moved[0] = 0
        return graph.with_poses(am.optimize(graph).poses @ _groups.exp(moved))

    def test_without_damping_it_is_an_error(self):
        with pytest.raises(am.AmrError, match=r"diverges: the cost is .* and was .*default"):
            am.optimize(self.far(), damping=0, max_iterations=30)

    def test_with_damping_the_cost_never_rises(self):
        result = am.optimize(self.far())
        assert result.converged
        assert (np.diff(result.history) <= 0).all()
        assert result.cost < result.cost_before

    @pytest.mark.parametrize("seed", range(20))
    def test_from_anywhere_it_says_how_it_ended(self, seed):
        rng = np.random.default_rng(seed)
        _, graph = random_graph(rng, PLANE, noise=30, start=10)
        result = am.optimize(graph)
        assert (np.diff(result.history) <= 0).all()
        if result.converged:
            again = am.optimize(result.graph, max_iterations=3)
            assert again.cost == pytest.approx(result.cost, rel=1e-4)
        else:
            assert "NOT CONVERGED" in repr(result)

    def test_without_damping_from_near(self, rng):
        _, graph = random_graph(rng, PLANE)
        plain, damped = am.optimize(graph, damping=0), am.optimize(graph)
        assert plain.converged
        assert plain.chi_square == pytest.approx(damped.chi_square, rel=1e-9)

    def test_a_cost_beyond_all_numbers(self):
        X = am.planar_poses([[0, 0], [1e90, 0]], [0, 0])
        graph = am.PoseGraph(X, [[0, 1]], np.eye(3)[None], 1e200 * np.eye(3))
        with pytest.raises(am.AmrError, match="not finite"):
            am.optimize(graph)


gtsam = pytest.importorskip("gtsam", reason="gtsam has no wheel for this Python or system")
SWAP = [3, 4, 5, 0, 1, 2]  # gtsam puts rotation first in space


def to_gtsam(graph, loss=None, width=None):
    plane = graph.dim == PLANE

    def pose(T):
        return (
            gtsam.Pose2(T[0, 2], T[1, 2], np.arctan2(T[1, 0], T[0, 0])) if plane else gtsam.Pose3(T)
        )

    between = gtsam.BetweenFactorPose2 if plane else gtsam.BetweenFactorPose3
    factors, start = gtsam.NonlinearFactorGraph(), gtsam.Values()
    rows = zip(graph.edges.tolist(), graph.measurements, graph.information, strict=True)
    for (i, j), Z, W in rows:
        noise = gtsam.noiseModel.Gaussian.Information(W if plane else W[np.ix_(SWAP, SWAP)])
        if loss:
            kernel = getattr(gtsam.noiseModel.mEstimator, loss).Create(width)
            noise = gtsam.noiseModel.Robust.Create(kernel, noise)
        factors.add(between(i, j, pose(Z), noise))
    for k, X in enumerate(graph.poses):
        start.insert(k, pose(X))
    return factors, start


def solve_by_gtsam(graph, **kernel):
    factors, start = to_gtsam(graph, **kernel)
    anchored = factors.clone()
    plane = graph.dim == PLANE
    fix = gtsam.NonlinearEqualityPose2 if plane else gtsam.NonlinearEqualityPose3
    at = start.atPose2(0) if plane else start.atPose3(0)
    anchored.add(fix(0, at))
    parameters = gtsam.LevenbergMarquardtParams()
    parameters.setRelativeErrorTol(1e-12)
    parameters.setAbsoluteErrorTol(1e-12)
    parameters.setMaxIterations(1000)
    found = gtsam.LevenbergMarquardtOptimizer(anchored, start, parameters).optimize()
    poses = [
        found.atPose2(k).matrix() if plane else found.atPose3(k).matrix()
        for k in range(len(graph.poses))
    ]
    return 2 * factors.error(found), np.array(poses)


@pytest.mark.parametrize("dim", [PLANE, SPACE])
class TestAgreesWithGtsam:
    def test_residuals_and_chi_square(self, rng, dim):
        _, graph = random_graph(rng, dim)
        factors, start = to_gtsam(graph)
        chi = [2 * factors.at(k).error(start) for k in range(factors.size())]
        assert np.allclose(graph.summary().edge_chi_square, chi, rtol=1e-9)

    @pytest.mark.parametrize("seed", range(3))
    def test_minimum(self, dim, seed):
        _, graph = random_graph(np.random.default_rng(seed), dim)
        chi_square, poses = solve_by_gtsam(graph)
        result = am.optimize(graph)
        assert result.chi_square == pytest.approx(chi_square, rel=1e-6)
        assert np.allclose(result.poses, poses, atol=1e-4)

    @pytest.mark.parametrize(
        ("loss", "name"),
        [("huber", "Huber"), ("cauchy", "Cauchy"), ("geman_mcclure", "GemanMcClure")],
    )
    def test_kernels(self, rng, dim, loss, name):
        _, graph = random_graph(rng, dim, start=0.01)
        cost, _ = solve_by_gtsam(graph, loss=name, width=1.5)
        result = am.optimize(graph, loss, width=1.5)
        factors, start = to_gtsam(graph, name, 1.5)
        assert result.cost_before == pytest.approx(2 * factors.error(start), rel=1e-9)
        assert result.cost == pytest.approx(cost, rel=1e-6)

    def test_files(self, rng, dim, tmp_path):
        _, graph = random_graph(rng, dim)
        am.write_g2o(tmp_path / "ours.g2o", graph)
        factors, values = gtsam.readG2o(str(tmp_path / "ours.g2o"), dim == SPACE)
        assert factors.size() == len(graph.edges)
        expected = graph.summary().chi_square
        assert 2 * factors.error(values) == pytest.approx(expected, rel=1e-9)
        gtsam.writeG2o(*to_gtsam(graph), str(tmp_path / "theirs.g2o"))
        back = am.read_g2o(tmp_path / "theirs.g2o")
        assert np.array_equal(back.edges, graph.edges)
        # gtsam writes six digits.
        assert np.allclose(back.information, graph.information, rtol=1e-4, atol=1e-3)
        assert np.allclose(back.poses, graph.poses, atol=1e-4)


def test_agrees_with_gtsam_on_a_manhattan_world():
    run = am.simulation.city_run(np.random.default_rng(2), 3500, closures=2101)
    graph = run.graph(run.labels)
    chi_square, poses = solve_by_gtsam(graph)
    result = am.optimize(graph)
    assert len(graph.edges) == 5600
    assert result.chi_square == pytest.approx(chi_square, rel=1e-8)
    assert np.allclose(result.poses, poses, atol=1e-4)


@pytest.mark.parametrize("name", ["Klaus3.g2o", "toyExample.g2o", "pose3example.txt"])
def test_files_that_others_wrote(name, tmp_path):
    path = Path(gtsam.__file__).parent / "Data" / name
    if not path.exists():
        pytest.skip(f"this gtsam comes without {name}")
    graph = am.read_g2o(path)
    factors, values = gtsam.readG2o(str(path), True)
    assert graph.summary().chi_square == pytest.approx(2 * factors.error(values), rel=1e-4)
    result = am.optimize(graph)
    assert result.converged
    am.write_g2o(tmp_path / "out.g2o", result.graph)
    assert am.read_g2o(tmp_path / "out.g2o").summary().chi_square == pytest.approx(
        result.chi_square, rel=1e-6, abs=1e-6
    )


X2 = am.planar_poses([[0, 0], [1, 0], [2, 0]], [0, 0, 0])
E2 = [[0, 1], [1, 2]]
Z2 = am.planar_poses([[1, 0], [1, 0]], [0, 0])
BAD_Z = Z2.copy()
BAD_Z[1, 0, 2] = np.nan
BAD_X = X2.copy()
BAD_X[2, 0, 2] = np.inf
G2 = am.PoseGraph(X2, E2, Z2, np.eye(3))
REFUSED = {
    "no anchor": (
        lambda: am.optimize(dataclasses.replace(G2, fixed=())),
        r"no fixed node.*dataclasses.replace\(graph, fixed=\(0,\)\)",
    ),
    "disconnected": (
        lambda: am.optimize(G2.keep([0])),
        r"not connected: no edges lead from 1 of 3 nodes \(ids 2\)",
    ),
    "disconnected by half": (
        lambda: am.optimize(dataclasses.replace(G2, edges=[[0, 1], [1, 0]])),
        "not connected",
    ),
    "index": (lambda: am.PoseGraph(X2, [[0, 1], [1, 3]], Z2, np.eye(3)), r"edges\[1, 1\] is 3"),
    "negative index": (
        lambda: am.PoseGraph(X2, [[-1, 1], [1, 2]], Z2, np.eye(3)),
        r"edges\[0, 0\] is -1; the graph has 3 poses, so indices run from 0 to 2",
    ),
    "half an index": (
        lambda: am.PoseGraph(X2, [[0, 0.5], [1, 2]], Z2, np.eye(3)),
        "edges must hold whole numbers",
    ),
    "loop": (lambda: am.PoseGraph(X2, [[0, 1], [1, 1]], Z2, np.eye(3)), r"edges\[1\] joins node 1"),
    "edges shape": (lambda: am.PoseGraph(X2, [0, 1], Z2, np.eye(3)), r"edges has shape \(2,\)"),
    "no edges": (lambda: am.PoseGraph(X2, np.empty((0, 2)), Z2, np.eye(3)), "M >= 1"),
    "too few measurements": (
        lambda: am.PoseGraph(X2, E2, Z2[:1], np.eye(3)),
        r"measurements has shape \(1, 3, 3\)",
    ),
    "measurements in space": (
        lambda: am.PoseGraph(X2, E2, np.tile(np.eye(4), (2, 1, 1)), np.eye(3)),
        r"measurements has shape \(2, 4, 4\)",
    ),
    "nan measurement": (lambda: am.PoseGraph(X2, E2, BAD_Z, np.eye(3)), "measurements.* is nan"),
    "infinite pose": (lambda: am.PoseGraph(BAD_X, E2, Z2, np.eye(3)), "poses.* is inf"),
    "nan information": (
        lambda: am.PoseGraph(X2, E2, Z2, np.nan * np.eye(3)),
        "information.* is nan",
    ),
    "no pose": (lambda: am.PoseGraph(2 * X2, E2, Z2, np.eye(3)), "poses.*last row"),
    "information asymmetric": (
        lambda: am.PoseGraph(X2, E2, Z2, np.triu(np.ones((3, 3))) + np.eye(3)),
        "information is not symmetric",
    ),
    "information indefinite": (
        lambda: am.PoseGraph(X2, E2, Z2, np.stack([np.eye(3), np.diag([1, 1, -1])])),
        r"information\[1\] is not positive definite",
    ),
    "information shape": (
        lambda: am.PoseGraph(X2, E2, Z2, np.eye(6)),
        r"information has shape \(6, 6\); 2 edges of 3 components",
    ),
    "fixed outside": (lambda: am.PoseGraph(X2, E2, Z2, np.eye(3), fixed=(3,)), "fixed holds 3"),
    "fixed a number": (lambda: am.PoseGraph(X2, E2, Z2, np.eye(3), fixed=0), "fixed is 0"),
    "ids twice": (lambda: am.PoseGraph(X2, E2, Z2, np.eye(3), ids=[0, 1, 1]), "ids has shape"),
    "ids too few": (lambda: am.PoseGraph(X2, E2, Z2, np.eye(3), ids=[0, 1]), "ids has shape"),
    "mask": (lambda: G2.keep([True]), r"edges has shape \(1,\); a mask needs shape \(2,\)"),
    "choice": (lambda: G2.keep([2]), r"indices from 0 to 1"),
    "other poses": (lambda: G2.with_poses(X2[:2]), r"poses has shape \(2, 3, 3\)"),
    "new edge": (lambda: G2.with_edges([[0, 7]], Z2[:1], np.eye(3)), r"edges\[0, 1\] is 7"),
    "no graph": (lambda: am.optimize(X2), "graph is a ndarray"),
    "loss": (lambda: am.optimize(G2, "tukey"), "loss is 'tukey'"),
    "width": (lambda: am.optimize(G2, "huber", width=-1), "width is -1"),
    "robust": (lambda: am.optimize(G2, "huber", robust=[True]), "robust has shape"),
    "robust indices": (lambda: am.optimize(G2, "huber", robust=[0, 1]), "one bool per edge"),
    "damping": (lambda: am.optimize(G2, damping=-1), "damping is -1"),
    "iterations": (lambda: am.optimize(G2, max_iterations=0), "max_iterations is 0"),
    "tolerance": (lambda: am.optimize(G2, tolerance=-1), "tolerance is -1"),
    "write no graph": (lambda: am.write_g2o("x", X2), "graph is a ndarray"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()


def test_advice_works():
    graph = dataclasses.replace(G2, fixed=())
    assert am.optimize(dataclasses.replace(graph, fixed=(0,))).converged
    assert am.optimize(dataclasses.replace(G2.keep([0]), fixed=(0, 2))).converged


def test_graph_methods():
    more = G2.with_edges([[0, 2]], X2[2:], 5 * np.eye(3))
    assert more.edges.tolist() == [[0, 1], [1, 2], [0, 2]]
    assert more.information[:, 0, 0].tolist() == [1, 1, 5]
    assert more.keep([False, False, True]).edges.tolist() == [[0, 2]]
    assert more.keep([2, 0]).edges.tolist() == [[0, 2], [0, 1]]
    assert (more.dim, more.free.tolist(), more.fixed) == (3, [1, 2], (0,))
    assert repr(more) == "pose graph in the plane: 3 nodes, 3 edges, fixed 0"
    X = X2.copy()
    graph = am.PoseGraph(X, E2, Z2, np.eye(3))
    X[0] = 7
    assert np.array_equal(graph.poses, X2)


PLANAR = """\
VERTEX_SE2 10 0 0 0
VERTEX_SE2 12 1 0 0.5
VERTEX_SE2 15 2 1 -0.5
EDGE_SE2 10 12 1 0.1 0.4 100 1 2 200 3 400
EDGE_SE2 15 12 -1 -1 1 100 0 0 100 0 400
FIX 12
"""
W6 = " ".join("1" if k in (0, 6, 11, 15, 18, 20) else "0" for k in range(21))
SPATIAL = f"""\
VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1
VERTEX_SE3:QUAT 1 1 2 3 0.5 0.5 0.5 0.5
EDGE_SE3:QUAT 0 1 1 2 3 0.5 0.5 0.5 0.5 {W6}
"""


def read(tmp_path, text, **options):
    path = tmp_path / "graph.g2o"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return am.read_g2o(path, **options)


class TestG2o:
    def test_plane(self, tmp_path):
        graph = read(tmp_path, PLANAR)
        assert graph.ids.tolist() == [10, 12, 15]
        assert graph.edges.tolist() == [[0, 1], [2, 1]]
        assert graph.fixed == (1,)
        assert np.allclose(graph.poses, am.planar_poses([[0, 0], [1, 0], [2, 1]], [0, 0.5, -0.5]))
        assert np.allclose(graph.measurements[0], am.planar_poses([[1, 0.1]], [0.4])[0])
        assert graph.information[0].tolist() == [[100, 1, 2], [1, 200, 3], [2, 3, 400]]

    def test_space(self, tmp_path):
        numbers = np.arange(1, 22) / 100 + 10 * np.isin(np.arange(21), (0, 6, 11, 15, 18, 20))
        text = SPATIAL.replace(W6, " ".join(map(repr, numbers.tolist())))
        graph = read(tmp_path, text)
        assert np.allclose(graph.poses[1, :3, :3], [[0, 0, 1], [1, 0, 0], [0, 1, 0]])
        assert graph.measurements[0, :3, 3].tolist() == [1, 2, 3]
        W = graph.information[0]
        assert np.array_equal(W, W.T)
        assert W[0].tolist() == numbers[:6].tolist()
        assert W[1, 1:].tolist() == numbers[6:11].tolist()
        assert (W[4, 4], W[4, 5], W[5, 5]) == tuple(numbers[18:])
        assert graph.fixed == (0,)

    @pytest.mark.parametrize(
        "change",
        [
            lambda text: "\n".join(text.splitlines()[::-1]),  # edges before vertices
            lambda text: text.replace("\n", "\r\n"),
            lambda text: "# made by hand\n\n" + text.replace("\n", "  # so\n\n"),
            lambda text: text.replace(" ", "\t "),
            lambda text: "\ufeff" + text,
            lambda text: text.rstrip("\n"),
            lambda text: text + "PARAMS_SE2OFFSET 0 0 0 0\n",
            lambda text: "  " + text.replace("\n", " \n "),
        ],
    )
    def test_as_others_write_it(self, tmp_path, change):
        graph, changed = read(tmp_path, PLANAR), read(tmp_path, change(PLANAR))
        order = np.argsort(changed.edges[:, 0])
        assert np.array_equal(changed.edges[order], graph.edges)
        assert np.array_equal(changed.measurements[order], graph.measurements)
        assert np.array_equal(changed.poses, graph.poses)
        assert changed.fixed == graph.fixed

    def test_several_fixed_nodes(self, tmp_path):
        assert read(tmp_path, PLANAR + "FIX 15 10\n").fixed == (0, 1, 2)
        assert read(tmp_path, PLANAR.replace("FIX 12\n", "")).fixed == (0,)

    def test_ids_that_no_double_holds(self, tmp_path):
        big = 6989586621679009793
        graph = read(tmp_path, PLANAR.replace(" 15 ", f" {big} "))
        assert graph.ids.tolist() == [10, 12, big]
        am.write_g2o(tmp_path / "out.g2o", graph)
        assert am.read_g2o(tmp_path / "out.g2o").ids.tolist() == [10, 12, big]

    @pytest.mark.parametrize("dim", [PLANE, SPACE])
    @pytest.mark.parametrize("name", ["a.g2o", "a.g2o.gz"])
    def test_round_trip(self, rng, tmp_path, dim, name):
        _, graph = random_graph(rng, dim)
        ids = np.sort(rng.choice(1000, 30, replace=False))
        graph = dataclasses.replace(graph, fixed=(2, 4), ids=ids)
        am.write_g2o(tmp_path / name, graph)
        back = am.read_g2o(tmp_path / name)
        assert np.array_equal(back.ids, ids) and back.fixed == (2, 4)
        assert np.array_equal(back.edges, graph.edges)
        assert np.array_equal(back.information, graph.information)
        assert np.abs(back.poses - graph.poses).max() < 4e-15
        assert np.abs(back.measurements - graph.measurements).max() < 4e-15
        packed = (tmp_path / name).read_bytes()
        assert (packed[:2] == b"\x1f\x8b") == name.endswith("gz")
        text = gzip.decompress(packed) if name.endswith("gz") else packed
        assert b"\r" not in text

    def test_missing_vertices_are_placed_by_edges(self, tmp_path):
        text = "".join(line + "\n" for line in PLANAR.splitlines() if "VERTEX" not in line)
        with pytest.warns(am.RecordingWarning, match=r"3 nodes have no VERTEX line.*line 1\)"):
            graph = read(tmp_path, text)
        assert np.abs(graph.residuals()).max() < 1e-12
        assert np.array_equal(graph.poses[0], np.eye(3))
        text = PLANAR.replace("VERTEX_SE2 12 1 0 0.5\n", "")
        with pytest.warns(am.RecordingWarning, match="1 nodes have no VERTEX"):
            graph = read(tmp_path, text)
        # Nodes 10 and 15 stay; 12 follows from the first of them.
        assert am.positions(graph.poses)[[0, 2]].tolist() == [[0, 0], [2, 1]]
        assert np.abs(graph.residuals()[0]).max() < 1e-12
        with pytest.raises(am.AmrError, match=r"1 nodes have no VERTEX line.*strict=False"):
            read(tmp_path, text, strict=True)

    def test_missing_vertices_in_two_parts(self, tmp_path):
        text = "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 7 8 2 0 0 1 0 0 1 0 1\n"
        with pytest.warns(am.RecordingWarning):
            graph = read(tmp_path, text)
        assert np.abs(graph.residuals()).max() < 1e-12

    def test_quaternions_that_are_not_quite_unit(self, tmp_path):
        text = SPATIAL.replace("0.5 0.5 0.5 0.5 1", "0.5002 0.5 0.5 0.5 1")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            assert np.allclose(read(tmp_path, text).residuals(), 0, atol=1e-3)
        text = SPATIAL.replace("0.5 0.5 0.5 0.5 1", "0.51 0.51 0.51 0.51 1")
        with pytest.warns(am.RecordingWarning, match=r"1 quaternions, up to 2 %.*line 3"):
            graph = read(tmp_path, text)
        assert np.allclose(graph.residuals(), 0, atol=1e-12)
        with pytest.raises(am.AmrError, match="line 3: 1 quaternions"):
            read(tmp_path, text, strict=True)

    def test_other_lines_are_left_out_and_said(self, tmp_path):
        text = PLANAR * 1 + "".join(f"EDGE_SE2 10 12 1 0 0 {W} \n" for W in ["1 0 0 1 0 1"] * 30)
        text += "VERTEX_XY 99 1 1\nEDGE_SE2_XY 10 99 1 1 1 0 1\n"
        with pytest.warns(am.RecordingWarning, match=r"VERTEX_XY \(1\), EDGE_SE2_XY \(1\).*37"):
            graph = read(tmp_path, text)
        assert len(graph.edges) == 32 and 99 not in graph.ids
        with pytest.raises(am.AmrError, match="line 37: lines left out"):
            read(tmp_path, text, strict=True)

    def test_the_warning_points_at_the_caller(self, tmp_path):
        path = tmp_path / "graph.g2o"
        path.write_text(PLANAR.replace("VERTEX_SE2 12 1 0 0.5\n", ""), encoding="utf-8")
        with pytest.warns(am.RecordingWarning) as caught:
            am.read_g2o(path)
        assert caught[0].filename == __file__ and len(caught) == 1


BAD_FILES = {
    "empty": (b"", "has no edge: 0 lines"),
    "no edges": ("VERTEX_SE2 0 0 0 0\n", "has no edge: 1 lines"),
    "short edge": (
        PLANAR.replace(" 3 400", " 3"),
        r"line 4: EDGE_SE2 with 10 numbers.*expected 11",
    ),
    "long vertex": (PLANAR.replace("0 0.5\n", "0 0.5 1\n"), "line 2: VERTEX_SE2 with 5 numbers"),
    "word": (PLANAR.replace("0.4 100", "0.4 1oo"), "line 4: column 7, '1oo' is not a number"),
    "nan": (PLANAR.replace("0.5\n", "nan\n", 1), "line 2: column 5 of VERTEX_SE2 is nan"),
    "infinite": (PLANAR.replace("-1 -1 1", "-1 inf 1"), "line 5: column 5 of EDGE_SE2 is inf"),
    "huge": (PLANAR.replace("-1 -1 1", "-1 1e300 1"), "line 5: column 5 of EDGE_SE2 is 1e300"),
    "id": (PLANAR.replace("SE2 12 1", "SE2 12.5 1", 1), "line 2: '12.5' is no id"),
    "huge id": (PLANAR.replace("SE2 12 1", "SE2 99999999999999999999 1", 1), "is no id"),
    "id twice": (PLANAR.replace("SE2 12 1", "SE2 10 1", 1), "line 2: node 10 has a VERTEX line"),
    "fix": (PLANAR.replace("FIX 12", "FIX 11"), "line 6: FIX 11, but no line has a node 11"),
    "fix a word": (PLANAR.replace("FIX 12", "FIX x"), "line 6: 'x' is no id"),
    "loop": (PLANAR.replace("15 12 -1", "15 15 -1"), "line 5: an edge from node 15 to itself"),
    "indefinite": (
        PLANAR.replace("100 0 0 100 0 400", "100 200 0 100 0 400"),
        "line 5: the information matrix is not positive definite",
    ),
    "zero information": (PLANAR.replace("0 400", "0 0"), "line 5: the information matrix"),
    "quaternion": (
        SPATIAL.replace("3 0.5 0.5 0.5 0.5 1", "3 0.5 0.5 0.5 0.7 1"),
        "line 3: the quaternion has length 1.1",
    ),
    "zero quaternion": (SPATIAL.replace("0 0 0 1\n", "0 0 0 0\n", 1), "line 1: the quaternion"),
    "mixed": (PLANAR + SPATIAL, "mixes SE2 and SE3"),
    "landmarks": (
        PLANAR + "VERTEX_XY 9 1 1\nEDGE_SE2_XY 10 9 1 1 1 0 1\n",
        r"line 7: 2 of 8 lines.*VERTEX_XY \(1\), EDGE_SE2_XY \(1\).*remove those lines",
    ),
    "toro": ("VERTEX2 0 0 0 0\nEDGE2 0 1 1 0 0 1 0 1 1 0 0\n", "line 1: .*TORO's"),
    "tum": ("0.1 1 2 3 0 0 0 1\n0.2 1 2 3 0 0 0 1\n", "line 1: 2 of 2 lines are neither"),
    "binary": (b"\xff\xfe\x00V", "not a text file"),
}


@pytest.mark.parametrize("case", BAD_FILES)
def test_bad_files_are_refused_with_the_line(case, tmp_path):
    text, message = BAD_FILES[case]
    with pytest.raises(am.AmrError, match=message):
        read(tmp_path, text)


def test_removing_landmarks_works_as_advised(tmp_path):
    assert len(read(tmp_path, PLANAR).edges) == 2


def test_rotations_are_written_as_unit_quaternions(tmp_path, rng):
    _, graph = random_graph(rng, SPACE)
    am.write_g2o(tmp_path / "a.g2o", graph)
    words = [line.split() for line in (tmp_path / "a.g2o").read_text().splitlines()]
    q = np.array([row[5:9] for row in words if row[0] == "VERTEX_SE3:QUAT"], dtype=float)
    assert np.allclose(Rotation.from_quat(q).as_matrix(), graph.poses[:, :3, :3])
    assert (q[:, 3] >= 0).all()
