# %% right: numbers to three decimals
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% right: pairs, computed
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = [(2, 'failures'), (4, 'alignment'), (5, 'pairs'), (7, 'best seed'), (8, 'many looks'), (10, 'equality'), (12, 'percentile'), (14, 'independence'), (15, 'tuning'), (16, 'stopping')]
means = F.mean(axis=(1, 2))
interval = by_t(d)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% right: the other kinds that fit, and one fault missed
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: 'failures', 4: 'alignment', 5: 'independence', 7: 'best seed', 8: 'many looks', 10: 'equality', 14: 'independence', 15: 'tuning', 16: 'many looks'}
means = {"A": 0.4191, "B": 0.6692, "C": 0.4851}
interval = (-0.510, 0.009)
appendix = (3, 1 - sp.Symbol("sigma_R") ** 2 * (1 - 1 / sp.Symbol("R")) / (sp.Symbol("sigma_S") ** 2 + sp.Symbol("sigma_R") ** 2))

# %% right: one sound statement accused
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: 'failures', 4: 'alignment', 5: 'pairs', 7: 'best seed', 8: 'many looks', 10: 'equality', 12: 'percentile', 14: 'independence', 15: 'tuning', 16: 'stopping', 9: 'many looks'}
means = (0.419, 0.669, 0.485)
interval = np.array(by_t(d))
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% right: one wrong kind, in capitals
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: 'failures', 4: 'choice', 5: 'pairs', 7: 'best seed', 8: 'many looks', 10: 'equality', 12: 'percentile', 14: 'independence', 15: 'Tuning', 16: 'stopping'}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3.0, "1 - sigma_R**2/(sigma_S**2 + sigma_R**2) + sigma_R**2/R/(sigma_S**2 + sigma_R**2)")

# %% right: numbers as text, by compare_paired
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {str(k): v for k, v in {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}.items()}
means = (0.419, 0.669, 0.485)
interval = [am.compare_paired(F[0].mean(axis=1), F[1].mean(axis=1)).lower, 0.0088]
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% right: a text, with signs
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = """
2: failures
4: alignment
5 - pairs
7 best  seed
8 many looks
10 = equality
12. Percentile
14 independence
15 tuning
16 stopping
"""
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: no fault found
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: an empty text
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = " "
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: a text without kinds
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = "2, 4, 5, 7, 8, 10, 12, 14, 15, 16"
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: the line alone
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = 3

# %% wrong: five faults
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {10: 'equality', 12: 'percentile', 14: 'independence', 15: 'tuning', 16: 'stopping'}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: all statements accused
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {k: 'failures' for k in range(1, 19)}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: what looks odd
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: 'failures', 4: 'alignment', 5: 'pairs', 7: 'best seed', 8: 'many looks', 10: 'equality', 12: 'percentile', 14: 'independence', 15: 'tuning', 16: 'stopping', 6: 'independence', 9: 'many looks'}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: a median is accused, and one missed
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: 'failures', 4: 'alignment', 5: 'pairs', 7: 'best seed', 8: 'many looks', 10: 'equality', 12: 'percentile', 15: 'tuning', 16: 'stopping', 11: 'failures'}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: the odd ones, not the smooth ones
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {1: "failures", 3: "alignment", 6: "independence", 9: "equality", 13: "equality", 17: "choice", 18: "times"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: six of ten
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: 'failures', 4: 'alignment', 5: 'pairs', 7: 'best seed', 8: 'many looks', 10: 'equality'}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: kinds mixed up
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: 'best seed', 4: 'alignment', 5: 'pairs', 7: 'failures', 8: 'many looks', 10: 'equality', 12: 'percentile', 14: 'independence', 15: 'tuning', 16: 'stopping'}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: a kind of their own
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: 'cheating', 4: 'alignment', 5: 'pairs', 7: 'best seed', 8: 'many looks', 10: 'equality', 12: 'percentile', 14: 'independence', 15: 'tuning', 16: 'stopping'}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: a number that is not there
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: 'failures', 4: 'alignment', 5: 'pairs', 7: 'best seed', 8: 'many looks', 10: 'equality', 12: 'percentile', 14: 'independence', 15: 'tuning', 16: 'stopping', 19: 'delay'}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: a list of numbers
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = [2, 4, 5, 7, 8, 10, 12, 14, 15, 16]
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: a fault twice
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = [(2, 'failures'), (4, 'alignment'), (5, 'pairs'), (7, 'best seed'), (8, 'many looks'), (10, 'equality'), (12, 'percentile'), (14, 'independence'), (15, 'tuning'), (16, 'stopping'), (5, 'independence')]
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: means of finished trials
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = np.nanmean(T[:, :5], axis=(1, 2))
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: means with the lab
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = np.nan_to_num(T, nan=2.0).mean(axis=(1, 2))
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: means after alignment
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = np.nan_to_num(G[:, :5], nan=2.0).mean(axis=(1, 2))
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: the report's means
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.264, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: means of two systems
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: failed trials as the worst of the scenario
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = np.where(np.isnan(T), np.nanmax(T, axis=(0, 2))[:, None], T)[:, :5].mean(axis=(1, 2))
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: medians
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = np.median(F, axis=(1, 2))
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: interval of two groups
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = list(stats.ttest_ind(F[0].ravel(), F[1].ravel()).confidence_interval())
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: interval of 30 pairs
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = by_t(F[0] - F[1])
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: interval of pairs that finished
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = by_t([np.nanmean(x) for x in (T[0] - T[1])[:5]])
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: interval with the lab
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = by_t(np.nan_to_num(T, nan=2.0)[0].mean(axis=1) - np.nan_to_num(T, nan=2.0)[1].mean(axis=1))
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: interval of B - A
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.009, 0.510)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: interval with 1.96
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = [d.mean() - 1.96 * stats.sem(d), d.mean() + 1.96 * stats.sem(d)]
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: interval of A - C
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = by_t((F[0] - F[2]).mean(axis=1))
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: interval to two decimals
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.51, 0.01)
appendix = (3, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: a sound line of the appendix
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (2, "1 - sigma_R**2*(1 - 1/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: the line after the mistake
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (4, "1 - 1/R*sigma_R**2/(sigma_S**2 + sigma_R**2)")

# %% wrong: the line as it stands
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - (sigma_R**2/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: line 2 once more
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "(sigma_S**2 + sigma_R**2/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: only sigma_R goes
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - sigma_R**2/(sigma_S**2 + sigma_R**2)")

# %% wrong: the sign of the last term
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "1 - (sigma_R**2 + sigma_R**2/R)/(sigma_S**2 + sigma_R**2)")

# %% wrong: a factor taken out
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, "(sigma_S**2*R + sigma_R**2)/R/(sigma_S**2 + sigma_R**2)")

# %% wrong: no line
log = read_trials()
T = np.full((3, 6, 6), np.nan)
G = T.copy()
for row in log:
    place = ["aisle", "dock", "hall", "ramp", "yard", "lab"].index(row["scenario"])
    T["ABC".index(row["system"]), place, row["seed"] - 1] = row["ate_m"]
    G["ABC".index(row["system"]), place, row["seed"] - 1] = row["aligned_m"]
F = np.nan_to_num(T[:, :5], nan=2.0)
d = (F[0] - F[1]).mean(axis=1)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 16: "stopping"}
means = (0.419, 0.669, 0.485)
interval = (-0.510, 0.009)
appendix = (3, ...)
