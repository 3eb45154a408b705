# %% wrong: least squares, then a gate
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    result = am.optimize(graph)
    return np.flatnonzero((abs(i - j) > 1) & (result.edge_chi_square > 16.3)).tolist()

# %% wrong: a gate on dead reckoning
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    return np.flatnonzero((abs(i - j) > 1) & (graph.summary().edge_chi_square > 16.3)).tolist()

# %% wrong: a wide gate on dead reckoning
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    return np.flatnonzero((abs(i - j) > 1) & (graph.summary().edge_chi_square > 5000)).tolist()

# %% wrong: Geman-McClure from dead reckoning
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    result = am.optimize(graph, "geman_mcclure", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square > 50)).tolist()

# %% wrong: every edge that Huber weighs less
# says: it keeps a false closure: the rest contradicts itself
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    result = am.optimize(graph, "huber")
    return np.flatnonzero((abs(i - j) > 1) & (result.weights < 1)).tolist()

# %% wrong: the gate of 95 % after the kernels
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square > 7.81)).tolist()

# %% wrong: all closures
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    return np.flatnonzero(abs(i - j) > 1).tolist()

# %% wrong: none
# says: it keeps a false closure: the rest contradicts itself
def false_closures(path):
    return []

# %% wrong: the right ones instead of the false ones
# says: you name the right closures
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square < 50)).tolist()

# %% wrong: counted from 1
# says: you count the edges from 1
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return (1 + np.flatnonzero(closures & (result.edge_chi_square > 50))).tolist()

# %% wrong: counted among the closures
# says: false_closures, graph.g2o: it names 8 edges of the odometry, which are right.
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return np.flatnonzero(result.edge_chi_square[closures] > 50).tolist()

# %% wrong: a mask
# says: graph.g2o. Indices are asked.
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return closures & (result.edge_chi_square > 50)

# %% wrong: pairs of nodes
# says: graph.g2o. One whole number per edge is asked.
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return graph.edges[closures & (result.edge_chi_square > 50)].tolist()

# %% wrong: the first edges of the file are taken for the odometry
# says: false_closures, another drive, its lines mixed: it names 16 edges of the odometry, which a
def false_closures(path):
    graph = am.read_g2o(path)
    closures = np.arange(len(graph.edges)) >= len(graph.poses) - 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square > 50)).tolist()

# %% wrong: the eight worst
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    worst = np.argsort(np.where(closures, result.edge_chi_square, -1))[::-1]
    return sorted(worst[:8].tolist())

# %% wrong: the file that is in the folder, whatever is asked
# says: false_closures, another drive, its lines mixed: it names 7 edges of the odometry, which ar
def false_closures(path):
    graph = am.read_g2o("graph.g2o")
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square > 50)).tolist()

# %% wrong: the numbers, typed in
# says: a function is asked, you have [161, 169, 179, 182, 184, 185, 187, 196].
graph = am.read_g2o("graph.g2o")
i, j = graph.edges.T
closures = abs(i - j) > 1
start = am.optimize(graph, "cauchy", robust=closures).graph
result = am.optimize(start, "geman_mcclure", robust=closures)
false_closures = np.flatnonzero(closures & (result.edge_chi_square > 50)).tolist()

# %% wrong: residuals are gated without the information
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    e = result.graph.residuals()
    return np.flatnonzero(closures & (np.linalg.norm(e, axis=1) > 0.05)).tolist()

# %% wrong: one closure is removed, the worst
# says: it keeps a false closure: the rest contradicts itself
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    result = am.optimize(graph)
    if result.p_value > 0.05 or not (abs(i - j) > 1).any():
        return []
    return [int(np.argmax(np.where(abs(i - j) > 1, result.edge_chi_square, -1)))]

# %% wrong: chi-square of the total instead of the edges
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    result = am.optimize(graph)
    return [] if result.p_value > 0.05 else np.flatnonzero(abs(i - j) > 1).tolist()

# %% wrong: odometry is gated, too, at one standard deviation
# says: false_closures, graph.g2o: it names 8 edges of the odometry, which are right.
def false_closures(path):
    graph = am.read_g2o(path)
    start = am.optimize(graph, "cauchy").graph
    result = am.optimize(start, "geman_mcclure")
    return np.flatnonzero(result.edge_chi_square > 1).tolist()

# %% wrong: stops where there is nothing to find
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    chi_square = result.edge_chi_square
    worst = np.flatnonzero(closures)[np.argmax(chi_square[closures])]
    return sorted({int(worst), *np.flatnonzero(closures & (chi_square > 50)).tolist()})

# %% wrong: None where there is nothing to find
# says: false_closures: there is no answer yet. It returns nothing for a drive without a false clo
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square > 50)).tolist() or None

# %% wrong: what np.where returns
# says: graph.g2o. One whole number per edge is asked.
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return np.where(closures & (result.edge_chi_square > 50))

# %% wrong: a closure leads to a later node
# says: it keeps a false closure: the rest contradicts itself
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = (j - i) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square > 50)).tolist()

# %% wrong: a closure leads to an earlier node
# says: it keeps a false closure: the rest contradicts itself
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = i - j > 1
    if not closures.any():
        closures = j - i > 1
    result = am.optimize(graph, "cauchy", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square > 50)).tolist()

# %% wrong: an edge is odometry if it leads to the next node
# says: you name the right closures
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = j - i != 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square < 50)).tolist()

# %% wrong: Cauchy alone, with the gate of 95 %
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    result = am.optimize(graph, "cauchy", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square > 7.81)).tolist()

# %% wrong: Cauchy on all edges, with the gate of the library
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    result = am.optimize(graph, "cauchy")
    gate = am.inlier_ratio(result.graph.residuals(), graph.information)
    apart = np.ptp(graph.edges, axis=1)
    return np.flatnonzero(~gate.inliers & (apart > 1)).tolist()

# %% wrong: Cauchy alone, with a gate of 99 %
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    result = am.optimize(graph, "cauchy", robust=closures)
    return np.flatnonzero(closures & (result.edge_chi_square > 11.34)).tolist()

# %% wrong: Huber, Geman-McClure, and every weight below a tenth
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    closures = np.abs(graph.edges[:, 0] - graph.edges[:, 1]) != 1
    if not closures.any():
        return []
    start = am.optimize(graph, "huber", robust=closures)
    result = am.optimize(start.graph, "geman_mcclure", robust=closures)
    return [k for k in range(len(graph.edges)) if closures[k] and result.weights[k] < 0.1]

# %% wrong: what a narrow kernel left out is gated as if it were in the fit
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    result = am.optimize(graph, "cauchy", robust=closures)
    for width in (100, 30, 10, 3):
        result = am.optimize(result.graph, "geman_mcclure", width=width, robust=closures)
    inliers = am.inlier_ratio(result.graph.residuals(), graph.information, 0.999).inliers
    rest = am.optimize(graph.keep(inliers | ~closures))
    final = graph.with_poses(rest.poses).summary().edge_chi_square
    return np.flatnonzero(closures & (final > 16.27)).tolist()

# %% wrong: a gate in meters
# says: in with the odometry and all that are right
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    start = am.optimize(graph, "cauchy", robust=closures).graph
    result = am.optimize(start, "geman_mcclure", robust=closures)
    off = np.linalg.norm(result.graph.residuals()[:, :2], axis=1)
    return np.flatnonzero(closures & (off > 1)).tolist()

# %% wrong: each of them twice, once for each kernel
# says: false_closures names an edge more than once for graph.g2o. Name each once.
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    found = []
    for kernel in ("cauchy", "geman_mcclure"):
        result = am.optimize(graph, kernel, robust=closures)
        found += np.flatnonzero(closures & (result.edge_chi_square > 100)).tolist()
        graph = result.graph
    return found

# %% right: Huber first, then Geman-McClure, a list comprehension
def false_closures(path):
    graph = am.read_g2o(path)
    closures = np.abs(graph.edges[:, 0] - graph.edges[:, 1]) != 1
    if not closures.any():
        return []
    start = am.optimize(graph, "huber", robust=closures)
    result = am.optimize(start.graph, "geman_mcclure", robust=closures)
    far = result.edge_chi_square > 50
    return [k for k in range(len(graph.edges)) if closures[k] and far[k]]

# %% right: the worst closure out, again and again; an array
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    kept = np.arange(len(graph.edges))
    closures = abs(i - j) > 1
    while True:
        result = am.optimize(graph.keep(kept))
        values = np.where(closures[kept], result.edge_chi_square, 0)
        if values.max() < 30:
            return np.setdiff1d(np.arange(len(graph.edges)), kept)
        kept = np.delete(kept, values.argmax())

# %% right: Cauchy alone, a wide gate, a set
def false_closures(path):
    graph = am.read_g2o(path)
    result = am.optimize(graph, "cauchy")
    apart = np.ptp(graph.edges, axis=1)
    return {int(k) for k in np.flatnonzero(result.edge_chi_square > 100) if apart[k] > 1}

# %% right: one closure after the other, short loops first; a tuple
def false_closures(path):
    graph = am.read_g2o(path)
    apart = abs(graph.edges[:, 0] - graph.edges[:, 1])
    kept, false = np.flatnonzero(apart == 1).tolist(), []
    fit = am.optimize(graph.keep(kept))
    for k in np.argsort(apart, kind="stable"):
        if apart[k] == 1:
            continue
        new = am.optimize(graph.keep([*kept, k]))
        if new.chi_square - fit.chi_square < 30:
            kept, fit = [*kept, k], new
        else:
            false.append(k)
    return tuple(sorted(false))

# %% right: a kernel that narrows, then least squares of what is left
def false_closures(path):
    graph = am.read_g2o(path)
    i, j = graph.edges.T
    closures = abs(i - j) > 1
    result = am.optimize(graph, "cauchy", robust=closures)
    for width in (100, 30, 10, 3):
        result = am.optimize(result.graph, "geman_mcclure", width=width, robust=closures)
    inliers = am.inlier_ratio(result.graph.residuals(), graph.information, 0.999).inliers
    rest = am.optimize(graph.keep(inliers | ~closures))
    final = graph.with_poses(rest.poses).summary().edge_chi_square
    return np.flatnonzero(closures & (final > 100)).astype(float)

# %% right: one statement after the other, i and j put in order first
def false_closures(path):
    graph = am.read_g2o(path)
    first = graph.edges.min(axis=1)
    last = graph.edges.max(axis=1)
    is_closure = last - first > 1
    found = []
    mapped = am.optimize(graph, loss="cauchy", robust=is_closure)
    mapped = am.optimize(mapped.graph, loss="geman_mcclure", robust=is_closure)
    for k, chi_square in enumerate(mapped.edge_chi_square):
        if is_closure[k] and chi_square > 100:
            found.append(k)
    return found
