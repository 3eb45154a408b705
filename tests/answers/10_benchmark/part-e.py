# %% right: numbers to three decimals
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
# says: faults: there is no answer yet. Replace the dots.
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
# says: faults: there is no answer yet. Replace the dots.
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
# says: faults: '4, 5, 7, 8, 10, 12, 14, 15, 16' is no kind of the table.
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
# says: appendix: the number of a line and the corrected line are asked.
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
# says: faults: at least six statements are at fault; you have fewer.
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
# says: faults: more than one of the 18 statements is not judged rightly: a fault is missed, a sou
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
# says: faults: more than one of the 18 statements is not judged rightly: a fault is missed, a sou
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
# says: faults: more than one of the 18 statements is not judged rightly: a fault is missed, a sou
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
# says: faults: more than one of the 18 statements is not judged rightly: a fault is missed, a sou
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
# says: faults: more than one of the 18 statements is not judged rightly: a fault is missed, a sou
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
# says: faults: more than one of the 18 statements is not judged rightly: a fault is missed, a sou
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
# says: faults: 'cheating' is no kind of the table.
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
# says: faults: the statements are numbered 1 to 18; you have 19.
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
# says: faults: a line for each is asked, such as: 19 delay
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
# says: faults: a statement stands twice. Give its main fault.
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
# says: failed trials are left out, and trials are averaged
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
# says: lab is among the scenarios
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
# says: the trajectories are aligned
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
# says: failed trials of B are left out
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
# says: means: shape (3,) is asked, you have (0.419, 0.669).
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
# says: a failed trial counts as the worst of its scenario
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
# says: these are medians
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
# says: you ignore that trials are paired
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
# says: each pair of trials counts as independent
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
# says: only pairs that both finished are left
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
# says: lab is among the scenarios
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
# says: this is B - A
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
# says: the quantile is normal
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
# says: this is A - C
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
# says: you rounded to two decimals
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
# says: the corrected line follows from line 1, but that is not all: line 2 was right as it stood.
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
# says: the corrected line: this says no more than line 3.
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
# says: the corrected line: this says no more than line 3.
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
# says: the corrected line: this says no more than line 1.
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
# says: the corrected line, compared with line 2: wrong
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
# says: the corrected line, compared with line 2: wrong
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
# says: the corrected line: every line follows, but it does not begin with 1 - ... as line 3 does.
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
# says: the corrected line: there is no answer yet. Replace the dots.
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

# %% right: a dictionary with one missing
faults = {2: "failures", 4: "Alignment", 5: "pairs", 7: "best-seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning"}
means = {"A": 0.419, "B": 0.669, "C": 0.485}

# %% right: pairs, SymPy line
faults = [(16, "stopping"), (15, "tuning"), (14, "independence"), (12, "percentile"), (10, "equality"), (8, "many looks"), (7, "best seed"), (5, "pairs"), (4, "alignment"), (2, "failures")]
appendix = ["3", "= 1 - (1 - 1/R)*sigma_R**2/(sigma_S**2 + sigma_R**2)"]

# %% wrong: two missing
# says: more than one of the 18 statements
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence"}

# %% wrong: one missing and one accused
# says: more than one of the 18 statements
faults = {2: "failures", 4: "alignment", 5: "pairs", 7: "best seed", 8: "many looks", 10: "equality", 12: "percentile", 14: "independence", 15: "tuning", 9: "equality"}

# %% wrong: everything of one kind
# says: more than one of the 18 statements
faults = {n: "failures" for n in range(1, 19)}
