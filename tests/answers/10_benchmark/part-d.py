# %% right: as planned
spread = np.sqrt([pilot.mean(axis=1).var(ddof=1) - pilot.var(axis=1, ddof=1).mean() / 4, pilot.var(axis=1, ddof=1).mean()])
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% right: other seeds, the verdict of compare
spread = (0.320, 0.556)
seeds = (3, 5, 12)
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = result.verdict("localizer", "mapper")

# %% right: a number of seeds, the run for a folder
spread = (0.320, 0.556)
seeds = 3
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
folder = am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder.folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = [round(row["lower"], 3), round(row["upper"], 3)]
verdict = "The localizer is better."

# %% right: worked out by hand; all fields written
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", failures="worst", metric="ate", better="lower", confidence=0.95, maximum_ate=None)
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
E = {}
for x in am.benchmark.evaluate(folder).table():
    E[x["system"], x["scenario"], x["seed"]] = np.nan if x["ate"] is None else x["ate"]
names = [x.name for x in SCENARIOS]
T = np.array([[[E[a, b, c] for c in (0, 1, 2)] for b in names] for a in ("localizer", "mapper")])
F = np.where(np.isnan(T), np.nanmax(T, axis=(0, 2))[:, None], T)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return d.mean() - half, d.mean() + half
interval = np.array(by_t((F[0] - F[1]).mean(axis=1)))
verdict = "localizer"

# %% right: run by threads, a path, systems in the other order
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = Path(new_folder()) / 'logs'
with ThreadPoolExecutor(2) as pool:
    am.benchmark.run(SYSTEMS[::-1], SCENARIOS, np.array(seeds), folder, pool, False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (-row["upper"], -row["lower"])
verdict = "Localizer better"

# %% right: a scenario for tuning, which is in no result
spread = (0.320, 0.556)
seeds = range(3)
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS + (hall("lab", "yard", split="tuning"),), seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: sigma_S still with a part of sigma_R
spread = (0.423, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: variances
spread = (0.102, 0.309)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: swapped
spread = (0.556, 0.320)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: variances with the divisor 4
spread = np.sqrt([pilot.mean(axis=1).var() - pilot.var(axis=1).mean() / 4, pilot.var(axis=1).mean()])
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: sigma_R of all numbers
spread = (0.320, pilot.std(ddof=1))
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: one number
spread = 0.556
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: no spread yet
spread = (..., ...)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: two seeds
spread = (0.320, 0.556)
seeds = [0, 1]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: a seed more, to be safe
spread = (0.320, 0.556)
seeds = [0, 1, 2, 3]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: one seed three times
spread = (0.320, 0.556)
seeds = [4, 4, 4]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, [4], folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: a text
spread = (0.320, 0.556)
seeds = "0, 1, 2"
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, 3, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: the alignment that everybody takes
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: only the start is aligned
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="origin", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: with a scale
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="similarity", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: coverage as it is by default
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: failures counted beside the others
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", failures="separate")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: the median
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95)
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: a limit of the error
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", maximum_ate=1.0)
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: another metric
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", metric="ate_max")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: confidence 0.9
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", confidence=0.9)
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: a dictionary for the protocol
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = {"align": "none"}
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean"))
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: run without the protocol
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: not run
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
interval = (-0.8565, -0.1678)
verdict = "localizer better"

# %% wrong: run one system alone
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS[0], SCENARIOS, seeds, folder, progress=False, protocol=protocol)
interval = (-0.8565, -0.1678)
verdict = "localizer better"

# %% wrong: a scenario left out
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS[:5], seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: another gate, after a look at the results
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run((System("localizer", estimators.ekf_localization, {"gate": 60.0}), SYSTEMS[1]), SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: a seventh scenario in the result
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS + (hall("lab", "yard"),), seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: run with other seeds than planned
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, [3, 5, 12], folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: easier scenarios
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, [replace(x, settings=x.settings | {"survey_std": 0.1}) for x in SCENARIOS], seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: aligned afterwards
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(am.benchmark.evaluate(folder, protocol={"align": "rigid"}))
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "mapper better"

# %% wrong: failed trials dropped
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(am.benchmark.evaluate(folder, protocol={"failures": "separate"}))
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: the best seed of each
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
E = {}
for x in am.benchmark.evaluate(folder).table():
    E[x["system"], x["scenario"], x["seed"]] = np.nan if x["ate"] is None else x["ate"]
names = [x.name for x in SCENARIOS]
T = np.array([[[E[a, b, c] for c in (0, 1, 2)] for b in names] for a in ("localizer", "mapper")])
F = np.where(np.isnan(T), np.nanmax(T, axis=(0, 2))[:, None], T)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return d.mean() - half, d.mean() + half
interval = by_t(F[0].min(axis=1) - F[1].min(axis=1))
verdict = "localizer better"

# %% wrong: all pairs independent
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
E = {}
for x in am.benchmark.evaluate(folder).table():
    E[x["system"], x["scenario"], x["seed"]] = np.nan if x["ate"] is None else x["ate"]
names = [x.name for x in SCENARIOS]
T = np.array([[[E[a, b, c] for c in (0, 1, 2)] for b in names] for a in ("localizer", "mapper")])
F = np.where(np.isnan(T), np.nanmax(T, axis=(0, 2))[:, None], T)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return d.mean() - half, d.mean() + half
interval = by_t(F[0] - F[1])
verdict = "localizer better"

# %% wrong: unpaired
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
E = {}
for x in am.benchmark.evaluate(folder).table():
    E[x["system"], x["scenario"], x["seed"]] = np.nan if x["ate"] is None else x["ate"]
names = [x.name for x in SCENARIOS]
T = np.array([[[E[a, b, c] for c in (0, 1, 2)] for b in names] for a in ("localizer", "mapper")])
F = np.where(np.isnan(T), np.nanmax(T, axis=(0, 2))[:, None], T)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return d.mean() - half, d.mean() + half
interval = list(stats.ttest_ind(F[0].ravel(), F[1].ravel()).confidence_interval())
verdict = "localizer better"

# %% wrong: mapper - localizer
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (-row["upper"], -row["lower"])
verdict = "localizer better"

# %% wrong: mean and half width
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["mean"], row["upper"] - row["mean"])
verdict = "localizer better"

# %% wrong: a normal quantile
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
E = {}
for x in am.benchmark.evaluate(folder).table():
    E[x["system"], x["scenario"], x["seed"]] = np.nan if x["ate"] is None else x["ate"]
names = [x.name for x in SCENARIOS]
T = np.array([[[E[a, b, c] for c in (0, 1, 2)] for b in names] for a in ("localizer", "mapper")])
F = np.where(np.isnan(T), np.nanmax(T, axis=(0, 2))[:, None], T)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return d.mean() - half, d.mean() + half
m = (F[0] - F[1]).mean(axis=1)
interval = (m.mean() - 1.96 * stats.sem(m), m.mean() + 1.96 * stats.sem(m))
verdict = "localizer better"

# %% wrong: the row of one scenario
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = [result.table()[1]["lower"], result.table()[1]["upper"]]
verdict = "localizer better"

# %% wrong: the mapper
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "mapper better"

# %% wrong: undecided
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "undecided"

# %% wrong: conflicting
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "conflicting"

# %% wrong: both
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer or mapper"

# %% wrong: no verdict yet
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = ...
