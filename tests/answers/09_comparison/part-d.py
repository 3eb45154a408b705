# %% wrong: systems swapped in the table
# says: the systems are swapped
table = [np.nanmean(errors[1]), np.nanmean(errors[0])]

# %% wrong: failed runs as 0 in the table
# says: runs that failed count as 0
table = [np.nan_to_num(errors[0]).mean(), np.nan_to_num(errors[1]).mean()]

# %% wrong: medians
# says: these are medians
table = [np.nanmedian(errors[0]), np.nanmedian(errors[1])]

# %% wrong: only runs that both finished
# says: you took only runs that both finished
D = errors[0] - errors[1]
ok = ~np.isnan(D)
table = [errors[0][ok].mean(), errors[1][ok].mean()]

# %% wrong: the mean of everything is nan
# says: table: you have [nan, nan], which is not finite.
table = [errors[0].mean(), errors[1].mean()]

# %% wrong: means of means of scenarios
# says: these are means of the means of scenarios
table = np.nanmean(np.nanmean(errors, axis=2), axis=1)

# %% wrong: the worst error for failed runs
# says: runs that failed get the worst error
table = [np.nan_to_num(e, nan=np.nanmax(errors)).mean() for e in errors]

# %% wrong: failed swapped
# says: the systems are swapped
failed = [2, 13]

# %% wrong: finished instead of failed
# says: these are runs that finished
failed = [35, 46]

# %% wrong: shares
# says: these are shares
failed = [13 / 48, 2 / 48]

# %% wrong: failed scenarios
# says: you counted scenarios
failed = [5, 2]

# %% wrong: failed in all
# says: failed: shape (2,) is asked, you have 15.
failed = 15

# %% wrong: pairs as independent
# says: each pair of runs counts as independent
D = errors[0] - errors[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
interval = by_t(D[ok])

# %% wrong: lines in the order of the file
# says: lines are paired in the order of the file
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
interval = by_t([x for x in log['ate_m'][log['system'] == 'A'] - log['ate_m'][log['system'] == 'B'] if x == x])

# %% wrong: unpaired means of scenarios
# says: you compare means of the pairs of scenarios, unpaired
D = errors[0] - errors[1]
ok = ~np.isnan(D)
interval = stats.ttest_ind([x[k].mean() for x, k in zip(errors[0], ok) if k.any()], [x[k].mean() for x, k in zip(errors[1], ok) if k.any()]).confidence_interval()

# %% wrong: unpaired runs
# says: you compare all finished runs, unpaired
interval = np.array(stats.ttest_ind(errors[0].ravel(), errors[1].ravel(), nan_policy='omit').confidence_interval())

# %% wrong: each system over its own finished runs
# says: each system is averaged over all its runs in a scenario, not over pairs
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
interval = by_t([np.nanmean(x) - np.nanmean(y) for x, y in zip(errors[0], errors[1]) if (x == x).any()])

# %% wrong: normal quantile
# says: the quantile is normal
D = errors[0] - errors[1]
ok = ~np.isnan(D)
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
interval = [np.mean(per) - 1.96 * stats.sem(per), np.mean(per) + 1.96 * stats.sem(per)]

# %% wrong: divisor N
# says: your s has the divisor N
D = errors[0] - errors[1]
ok = ~np.isnan(D)
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
interval = [np.mean(per) + z * stats.t.ppf(0.975, 10) * np.std(per) / 11**0.5 for z in (-1, 1)]

# %% wrong: 12 scenarios
# says: you divided by the root of 12, and one scenario has no pair
D = errors[0] - errors[1]
ok = ~np.isnan(D)
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
interval = [np.mean(per) + z * stats.t.ppf(0.975, 11) * np.std(per, ddof=1) / 12**0.5 for z in (-1, 1)]

# %% wrong: a scenario without pairs counts as 0
# says: a scenario without a pair counts as 0
D = errors[0] - errors[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
interval = by_t(per + [0])

# %% wrong: failed differences count as 0
# says: runs that failed count as 0
D = errors[0] - errors[1]
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
interval = by_t(np.nan_to_num(D).mean(axis=1))

# %% wrong: the worst error for failed runs, in the interval
# says: runs that failed get the worst error
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
interval = by_t((np.nan_to_num(errors[0], nan=np.nanmax(errors)) - np.nan_to_num(errors[1], nan=np.nanmax(errors))).mean(axis=1))

# %% wrong: only scenarios without a failure
# says: only scenarios without a failure count
D = errors[0] - errors[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
interval = by_t([x.mean() for x, k in zip(D, ok) if k.all()])

# %% wrong: B - A
# says: this is B - A
D = errors[0] - errors[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
interval = [-by_t(per)[1], -by_t(per)[0]]
verdict = "A better"

# %% wrong: limits swapped
# says: the limits are swapped
D = errors[0] - errors[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
interval = by_t(per)[::-1]

# %% wrong: in centimeters
# says: these are in centimeters
D = errors[0] - errors[1]
ok = ~np.isnan(D)
def by_t(d):
    d = np.ravel(d)
    half = stats.t.ppf(0.975, len(d) - 1) * stats.sem(d)
    return [d.mean() - half, d.mean() + half]
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
interval = [100 * x for x in by_t(per)]

# %% wrong: mean and half width
# says: this is the mean and the half width
D = errors[0] - errors[1]
ok = ~np.isnan(D)
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
interval = [np.mean(per), 0.0208]

# %% wrong: two decimals
# says: you rounded to two decimals
table = (0.41, 0.45)

# %% wrong: an interval with two digits
# says: you rounded to three decimals
interval = (0.036, 0.077)

# %% wrong: a result object
# says: interval: numbers are asked, you have B better by 0.0566364: mean of A - B 0.0566364, 95 %
D = errors[0] - errors[1]
ok = ~np.isnan(D)
per = [x[k].mean() for x, k in zip(D, ok) if k.any()]
interval = am.compare_paired(per, [0] * 11)

# %% wrong: trusts the table
# says: you trust the table of means
verdict = "A better"

# %% wrong: bars overlap
# says: you look at the bars of both, which overlap
verdict = "undecided"

# %% wrong: a conflict, though the winner fails less
# says: you take a winner that fails less often for a conflict
verdict = "conflicting"

# %% wrong: a truth value
# says: verdict: a string is asked, you have True.
verdict = True

# %% wrong: no verdict
# says: verdict: there is no answer yet. Replace the dots.
verdict = ""

# %% right: typed from a printout
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
