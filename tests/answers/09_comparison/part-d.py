# %% wrong: systems swapped in the table
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[1]), np.nanmean(E[0])]
failed = [13, 2]
interval = by_t(per)
verdict = "B better"

# %% wrong: failed runs as 0 in the table
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nan_to_num(E[0]).mean(), np.nan_to_num(E[1]).mean()]
failed = [13, 2]
interval = by_t(per)
verdict = "B better"

# %% wrong: medians
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmedian(E[0]), np.nanmedian(E[1])]
failed = [13, 2]
interval = by_t(per)
verdict = "B better"

# %% wrong: only runs that both finished
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [E[0][ok].mean(), E[1][ok].mean()]
failed = [13, 2]
interval = by_t(per)
verdict = "B better"

# %% wrong: the mean of everything is nan
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [E[0].mean(), E[1].mean()]
failed = [13, 2]
interval = by_t(per)
verdict = "B better"

# %% wrong: means of means of scenarios
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0][1:].mean(axis=1)), 0.45]
failed = [13, 2]
interval = by_t(per)
verdict = "B better"

# %% wrong: the worst error for failed runs
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nan_to_num(e, nan=np.nanmax(E)).mean() for e in E]
failed = [13, 2]
interval = by_t(per)
verdict = "B better"

# %% wrong: failed swapped
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [2, 13]
interval = by_t(per)
verdict = "B better"

# %% wrong: finished instead of failed
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [35, 46]
interval = by_t(per)
verdict = "B better"

# %% wrong: shares
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13 / 48, 2 / 48]
interval = by_t(per)
verdict = "B better"

# %% wrong: failed scenarios
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [5, 2]
interval = by_t(per)
verdict = "B better"

# %% wrong: failed in all
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = 15
interval = by_t(per)
verdict = "B better"

# %% wrong: pairs as independent
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t(D[ok])
verdict = "B better"

# %% wrong: lines in the order of the file
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t([x for x in log['ate_m'][log['system'] == 'A'] - log['ate_m'][log['system'] == 'B'] if x == x])
verdict = "B better"

# %% wrong: unpaired means of scenarios
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = stats.ttest_ind([x[k].mean() for x, k in zip(E[0], ok) if k.any()], [x[k].mean() for x, k in zip(E[1], ok) if k.any()]).confidence_interval()
verdict = "B better"

# %% wrong: unpaired runs
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = np.array(stats.ttest_ind(E[0].ravel(), E[1].ravel(), nan_policy='omit').confidence_interval())
verdict = "B better"

# %% wrong: each system over its own finished runs
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t([np.nanmean(x) - np.nanmean(y) for x, y in zip(E[0], E[1]) if (x == x).any()])
verdict = "B better"

# %% wrong: normal quantile
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = [np.mean(per) - 1.96 * stats.sem(per), np.mean(per) + 1.96 * stats.sem(per)]
verdict = "B better"

# %% wrong: divisor N
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = [np.mean(per) + z * stats.t.ppf(0.975, 10) * np.std(per) / 11**0.5 for z in (-1, 1)]
verdict = "B better"

# %% wrong: 12 scenarios
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = [np.mean(per) + z * stats.t.ppf(0.975, 11) * np.std(per, ddof=1) / 12**0.5 for z in (-1, 1)]
verdict = "B better"

# %% wrong: a scenario without pairs counts as 0
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t(per + [0])
verdict = "B better"

# %% wrong: failed differences count as 0
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t(np.nan_to_num(D).mean(axis=1))
verdict = "B better"

# %% wrong: the worst error for failed runs, in the interval
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t((np.nan_to_num(E[0], nan=np.nanmax(E)) - np.nan_to_num(E[1], nan=np.nanmax(E))).mean(axis=1))
verdict = "B better"

# %% wrong: only scenarios without a failure
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t([x.mean() for x, k in zip(D, ok) if k.all()])
verdict = "B better"

# %% wrong: B - A
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = [-by_t(per)[1], -by_t(per)[0]]
verdict = "A better"

# %% wrong: limits swapped
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t(per)[::-1]
verdict = "B better"

# %% wrong: in centimeters
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = [100 * x for x in by_t(per)]
verdict = "B better"

# %% wrong: mean and half width
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = [np.mean(per), 0.0208]
verdict = "B better"

# %% wrong: two decimals
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = (0.41, 0.45)
failed = [13, 2]
interval = by_t(per)
verdict = "B better"

# %% wrong: an interval with two digits
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = (0.036, 0.077)
verdict = "B better"

# %% wrong: a result object
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = am.compare_paired(per, [0] * 11)
verdict = "B better"

# %% wrong: trusts the table
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t(per)
verdict = "A better"

# %% wrong: bars overlap
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t(per)
verdict = "undecided"

# %% wrong: a conflict, though the winner fails less
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t(per)
verdict = "conflicting"

# %% wrong: a truth value
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t(per)
verdict = True

# %% wrong: no verdict
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = by_t(per)
verdict = ""

# %% right: typed from a printout
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = (0.409, 0.449)
failed = (13, 2)
interval = (0.0359, 0.0774)
verdict = "B"

# %% right: arrays
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = np.nanmean(E, axis=(1, 2))
failed = np.isnan(E).sum(axis=(1, 2))
interval = np.array(by_t(per))
verdict = "B is better"

# %% right: by pandas-like loops
log = read_runs()
rows = {}
for scenario, seed, system, ate in log:
    rows.setdefault(scenario, {}).setdefault(seed, {})[system] = ate
per = []
for seeds in rows.values():
    gaps = [pair["A"] - pair["B"] for pair in seeds.values()]
    gaps = [gap for gap in gaps if gap == gap]
    if gaps:
        per.append(sum(gaps) / len(gaps))
test = stats.ttest_1samp(per, 0)
ates = {name: [r["ate_m"] for r in log if r["system"] == name] for name in "AB"}
table = [np.nanmean(ates[name]) for name in 'AB']
failed = [sum(np.isnan(ates[name])) for name in 'AB']
interval = test.confidence_interval()
verdict = "b better"

# %% right: the library's verdict
log = read_runs()
E = np.full((2, 12, 4), np.nan)
for row in log:
    E["AB".index(row["system"]), row["scenario"] - 1, row["seed"] - 1] = row["ate_m"]
D = E[0] - E[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
table = [np.nanmean(E[0]), np.nanmean(E[1])]
failed = [13, 2]
interval = (lambda r: (r.lower, r.upper))(am.compare_paired(per, [0.0] * len(per)))
verdict = am.compare_paired(per, [0.0] * len(per)).verdict
