# %% right: as planned
spread = np.sqrt([pilot.mean(axis=1).var(ddof=1) - pilot.var(axis=1, ddof=1).mean() / 4, pilot.var(axis=1, ddof=1).mean()])
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
ran = am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% right: other seeds, the verdict of compare
spread = (0.320, 0.556)
seeds = (3, 5, 12)
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
ran = am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = result.verdict("localizer", "mapper")

# %% right: a number of seeds, the run for a folder
spread = (0.320, 0.556)
seeds = 3
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
ran = folder = am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder.folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = [round(row["lower"], 3), round(row["upper"], 3)]
verdict = "The localizer is better."

# %% right: worked out by hand; all fields written
spread = (0.320, 0.556)
seeds = [0, 1, 2]
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", failures="worst", metric="ate", better="lower", confidence=0.95, maximum_ate=None)
folder = new_folder()
ran = am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False, protocol=protocol)
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
    ran = am.benchmark.run(SYSTEMS[::-1], SCENARIOS, np.array(seeds), folder, pool, False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (-row["upper"], -row["lower"])
verdict = "Localizer better"

# %% right: a scenario for tuning, which is in no result
spread = (0.320, 0.556)
seeds = range(3)
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean")
folder = new_folder()
ran = am.benchmark.run(SYSTEMS, SCENARIOS + (hall("lab", "yard", split="tuning"),), seeds, folder, progress=False, protocol=protocol)
result = am.benchmark.compare(folder)
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
interval = (row["lower"], row["upper"])
verdict = "localizer better"

# %% wrong: sigma_S still with a part of sigma_R
# says: the variance of the means still contains a part of sigma_R
spread = (0.423, 0.556)
ran = row = interval = None

# %% wrong: variances
# says: these are variances
spread = (0.102, 0.309)
ran = row = interval = None

# %% wrong: swapped
# says: sigma_S and sigma_R are swapped
spread = (0.556, 0.320)
ran = row = interval = None

# %% wrong: variances with the divisor 4
# says: variances have the divisor 4
spread = np.sqrt([pilot.mean(axis=1).var() - pilot.var(axis=1).mean() / 4, pilot.var(axis=1).mean()])
ran = row = interval = None

# %% wrong: sigma_R of all numbers
# says: sigma_R is the standard deviation of all numbers
spread = (0.320, pilot.std(ddof=1))
ran = row = interval = None

# %% wrong: one number
# says: spread: shape (2,) is asked, you have 0.556.
spread = 0.556
ran = row = interval = None

# %% wrong: no spread yet
# says: spread: there is no answer yet. Replace the dots.
spread = (..., ...)
ran = row = interval = None

# %% wrong: two seeds
# says: that is what comes out if all trials count as independent
seeds = [0, 1]
ran = row = interval = None

# %% wrong: a seed more, to be safe
# says: that is the number of seeds of the pilot
seeds = [0, 1, 2, 3]
ran = row = interval = None

# %% wrong: one seed three times
# says: seeds: one stands twice. The same seed makes the same world again.
seeds = [4, 4, 4]
ran = row = interval = None

# %% wrong: a text
# says: seeds: a list of whole numbers is asked, none of them negative.
seeds = "0, 1, 2"
ran = row = interval = None

# %% wrong: the alignment that everybody takes
# says: protocol, align: an offset of the whole trajectory lets the robot miss its dock, and your
protocol = am.benchmark.Protocol(minimum_coverage=0.95, statistic="mean")
ran = row = interval = None

# %% wrong: only the start is aligned
# says: protocol, align: an offset of the whole trajectory lets the robot miss its dock, and your
protocol = am.benchmark.Protocol(align="origin", minimum_coverage=0.95, statistic="mean")
ran = row = interval = None

# %% wrong: with a scale
# says: protocol, align: an offset of the whole trajectory lets the robot miss its dock, and your
protocol = am.benchmark.Protocol(align="similarity", minimum_coverage=0.95, statistic="mean")
ran = row = interval = None

# %% wrong: coverage as it is by default
# says: protocol, minimum_coverage: trials of which coverage fail is not what the customer says.
protocol = am.benchmark.Protocol(align="none", statistic="mean")
ran = row = interval = None

# %% wrong: failures counted beside the others
# says: protocol, failures: a trial in which the robot is towed has to count in the mean, and with
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", failures="separate")
ran = row = interval = None

# %% wrong: the median
# says: protocol, statistic: the customer says which statistic the table shows.
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95)
ran = row = interval = None

# %% wrong: a limit of the error
# says: protocol, maximum_ate: the customer does not say that a large error alone is a failure.
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", maximum_ate=1.0)
ran = row = interval = None

# %% wrong: another metric
# says: protocol, metric: what decides is another number than the customer says.
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", metric="ate_max")
ran = row = interval = None

# %% wrong: confidence 0.9
# says: protocol, confidence: the customer says how sure they want to be.
protocol = am.benchmark.Protocol(align="none", minimum_coverage=0.95, statistic="mean", confidence=0.9)
ran = row = interval = None

# %% wrong: a dictionary for the protocol
# says: protocol: an am.benchmark.Protocol is asked.
protocol = {"align": "none"}
ran = row = interval = None

# %% wrong: run without the protocol
# says: folder: it was run under another protocol than yours; of its align: an offset of the whole
ran = am.benchmark.run(SYSTEMS, SCENARIOS, seeds, folder, progress=False)

# %% wrong: not run
# says: folder: there is no answer yet. Nothing was run into it.
ran = row = None
interval = (-0.8565, -0.1678)

# %% wrong: run one system alone
# says: folder: mapper is not in it. Run both systems together.
ran = am.benchmark.run(SYSTEMS[0], SCENARIOS, seeds, folder, progress=False, protocol=protocol)
interval = (-0.8565, -0.1678)

# %% wrong: a scenario left out
# says: folder: not all six test scenarios are in it as such.
ran = am.benchmark.run(SYSTEMS, SCENARIOS[:5], seeds, folder, progress=False, protocol=protocol)

# %% wrong: another gate, after a look at the results
# says: folder: the settings of localizer were changed.
ran = am.benchmark.run((System("localizer", estimators.ekf_localization, {"gate": 60.0}), SYSTEMS[1]), SCENARIOS, seeds, folder, progress=False, protocol=protocol)

# %% wrong: a seventh scenario in the result
# says: folder: there are more than the six test scenarios in it.
ran = am.benchmark.run(SYSTEMS, SCENARIOS + (hall("lab", "yard"),), seeds, folder, progress=False, protocol=protocol)

# %% wrong: run with other seeds than planned
# says: folder: it was run with other seeds than yours.
ran = am.benchmark.run(SYSTEMS, SCENARIOS, [3, 5, 12], folder, progress=False, protocol=protocol)

# %% wrong: easier scenarios
# says: folder: the settings of scenario hall were changed.
ran = am.benchmark.run(SYSTEMS, [replace(x, settings=x.settings | {"survey_std": 0.1}) for x in SCENARIOS], seeds, folder, progress=False, protocol=protocol)

# %% wrong: aligned afterwards
# says: the trajectories are aligned (rigid)
result = am.benchmark.compare(am.benchmark.evaluate(folder, protocol={"align": "rigid"}))
row = next(x for x in result.table() if x["scenario"] == "all scenarios")
verdict = "mapper better"

# %% wrong: failed trials dropped
# says: failed trials are left out
result = am.benchmark.compare(am.benchmark.evaluate(folder, protocol={"failures": "separate"}))
row = next(x for x in result.table() if x["scenario"] == "all scenarios")

# %% wrong: the best seed of each
# says: each system has its best seed
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

# %% wrong: all pairs independent
# says: each pair of trials counts as independent
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

# %% wrong: unpaired
# says: you ignore that trials are paired
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

# %% wrong: mapper - localizer
# says: this is mapper - localizer
interval = (-row["upper"], -row["lower"])

# %% wrong: mean and half width
# says: this is the mean and the half width
interval = (row["mean"], row["upper"] - row["mean"])

# %% wrong: a normal quantile
# says: the quantile is normal
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

# %% wrong: the row of one scenario
# says: this is another row of the table
result = am.benchmark.compare(folder)
interval = [result.table()[1]["lower"], result.table()[1]["upper"]]

# %% wrong: the mapper
# says: you took the larger error for the better one
verdict = "mapper better"

# %% wrong: undecided
# says: you want more certainty than the customer
verdict = "undecided"

# %% wrong: conflicting
# says: verdict: one of 'localizer better', 'mapper better', 'undecided' is asked.
verdict = "conflicting"

# %% wrong: both
# says: verdict: one of 'localizer better', 'mapper better', 'undecided' is asked.
verdict = "localizer or mapper"

# %% wrong: no verdict yet
# says: verdict: there is no answer yet. Replace the dots.
verdict = ...
