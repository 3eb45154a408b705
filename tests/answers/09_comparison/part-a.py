# %% wrong: two numbers only
# says: summary: three numbers are asked: mean, s and t.
summary = (0.08125, 0.030443)

# %% wrong: a text
# says: summary: three numbers are asked: mean, s and t.
summary = "0.08125, 0.030443, 7.549"

# %% wrong: no t yet
# says: t: there is no answer yet. Replace the dots.
summary = (0.08125, 0.030443, ...)

# %% right: an array
summary = np.array([0.08125, 0.0304, 7.55])

# %% wrong: in centimeters
# says: this is in centimeters
summary = [8.125, 3.0443, 7.549]
interval = [5.58, 10.67]

# %% wrong: only the mean in centimeters
# says: this is in centimeters
summary = [8.125, 0.030443, 7.549]

# %% wrong: the mean of B - A
# says: this is B - A
summary = [-0.08125, 0.030443, 7.549]

# %% wrong: the median for the mean
# says: this is the median
summary = [0.085, 0.030443, 7.549]

# %% wrong: the mean divided by 7
# says: you divided by 7
summary = [0.65 / 7, 0.030443, 7.549]

# %% wrong: the mean to one digit
# says: you rounded to two decimals
summary = [0.08, 0.030443, 7.549]

# %% wrong: s with the divisor N
# says: you divided by N
summary = [0.08125, 0.02848, 7.549]

# %% wrong: s as NumPy has it by default
# says: you divided by N
summary = [0.08125, np.std(differences), 7.549]

# %% wrong: the variance
# says: this is the variance: the root is missing
summary = [0.08125, 0.000926786, 7.549]

# %% wrong: squares without the mean
# says: the mean is not taken off
summary = [0.08125, (0.0593 / 7) ** 0.5, 7.549]

# %% wrong: the square of the mean once
# says: the square of the mean is taken off once, not N times
summary = [0.08125, ((0.0593 - 0.08125**2) / 7) ** 0.5, 7.549]

# %% wrong: the standard error for s
# says: this is the standard error of the mean
summary = [0.08125, 0.010763, 7.549]

# %% wrong: s to two digits
# says: you rounded to two decimals
summary = [0.08125, 0.03, 7.549]

# %% wrong: t without the root of N
# says: you left out the root of N: this is an effect size
summary = [0.08125, 0.030443, 2.669]

# %% wrong: t with N instead of its root
# says: you divided by N, not by its root
summary = [0.08125, 0.030443, 0.08125 / (0.030443 / 8)]

# %% wrong: t from the divisor N
# says: your s has the divisor N
summary = [0.08125, 0.030443, 8.07]

# %% wrong: t with the root of 7
# says: you divided s by the root of 7
summary = [0.08125, 0.030443, 0.08125 / (0.030443 / 7**0.5)]

# %% wrong: the quantile for t
# says: this is the quantile
summary = [0.08125, 0.030443, 2.365]

# %% wrong: t upside down
# says: numerator and denominator are swapped
summary = [0.08125, 0.030443, 1 / 7.549]

# %% wrong: t negative
# says: this is B - A
summary = [0.08125, 0.030443, -7.549]

# %% wrong: interval with the normal quantile
# says: you took the normal quantile
summary = [0.08125, 0.030443, 7.549]
interval = [0.0602, 0.1023]

# %% wrong: interval without the root of N
# says: the root of N is left out
summary = [0.08125, 0.030443, 7.549]
interval = [0.00925, 0.1532]

# %% wrong: interval by N, not its root
# says: you divided by N, not by its root
summary = [0.08125, 0.030443, 7.549]
interval = [0.0722, 0.0903]

# %% wrong: one standard error
# says: the quantile is left out
summary = [0.08125, 0.030443, 7.549]
interval = [0.0705, 0.0920]

# %% wrong: interval from the divisor N
# says: your s has the divisor N
summary = [0.08125, 0.030443, 7.549]
interval = [0.0574, 0.1051]

# %% wrong: one-sided quantile
# says: the quantile is that of a one-sided interval
summary = [0.08125, 0.030443, 7.549]
interval = [0.08125 - 1.895 * 0.010763, 0.08125 + 1.895 * 0.010763]

# %% wrong: quantile of 8 degrees of freedom
# says: the quantile is that of 8 degrees of freedom
summary = [0.08125, 0.030443, 7.549]
interval = [0.08125 - 2.306 * 0.010763, 0.08125 + 2.306 * 0.010763]

# %% wrong: mean and half width
# says: this is the mean and the half width
summary = [0.08125, 0.030443, 7.549]
interval = [0.08125, 0.02545]

# %% wrong: limits swapped
# says: the limits are swapped
summary = [0.08125, 0.030443, 7.549]
interval = [0.106701, 0.055799]

# %% wrong: interval about 0
# says: this is an interval about 0
summary = [0.08125, 0.030443, 7.549]
interval = [-0.02545, 0.02545]

# %% wrong: smallest and largest difference
# says: these are the smallest and the largest difference
summary = [0.08125, 0.030443, 7.549]
interval = [0.03, 0.12]

# %% wrong: a number for the interval
# says: interval: shape (2,) is asked, you have 0.02545.
summary = [0.08125, 0.030443, 7.549]
interval = 0.02545

# %% wrong: A better
# says: verdict: 'A is better by 8.1 cm' names the wrong system. The differences are A - B, and an
summary = [0.08125, 0.030443, 7.549]
verdict = "A is better by 8.1 cm"

# %% wrong: verdict without a unit
# says: verdict: 0.081 of what? The unit is missing.
summary = [0.08125, 0.030443, 7.549]
verdict = "B is better by 0.081"

# %% wrong: verdict without a size
# says: verdict: it does not say by how much.
summary = [0.08125, 0.030443, 7.549]
verdict = "B is better"

# %% wrong: verdict in the wrong unit
# says: the unit is wrong
summary = [0.08125, 0.030443, 7.549]
verdict = "B is better by 8.1 m"

# %% wrong: only a letter
# says: verdict: a sentence is asked that says which system is better, and by how much. You have '
summary = [0.08125, 0.030443, 7.549]
verdict = "B"

# %% wrong: undecided
# says: verdict: a sentence is asked that says which system is better, and by how much. You have '
summary = [0.08125, 0.030443, 7.549]
verdict = "undecided"

# %% wrong: a number for a verdict
# says: verdict: a string is asked, you have 8.1.
summary = [0.08125, 0.030443, 7.549]
verdict = 8.1

# %% wrong: B is said to be worse
# says: verdict: 'B is worse by 8.1 cm' names the wrong system. The differences are A - B, and an
summary = [0.08125, 0.030443, 7.549]
verdict = "B is worse by 8.1 cm"

# %% wrong: verdict by the half width
# says: this is the half width of the interval
summary = [0.08125, 0.030443, 7.549]
verdict = "B is better by 2.5 cm"

# %% wrong: one side of the signs
# says: you counted one side only
summary = [0.08125, 0.030443, 7.549]
p_value = 3 / 64

# %% wrong: strictly larger sums only
# says: you left out sums that are just as large
summary = [0.08125, 0.030443, 7.549]
p_value = 4 / 64

# %% wrong: strictly larger, on one side
# says: you left out equal sums, and one side
summary = [0.08125, 0.030443, 7.549]
p_value = 2 / 64

# %% wrong: the sign test
# says: you counted signs, not sums
summary = [0.08125, 0.030443, 7.549]
p_value = 14 / 64

# %% wrong: without the observed choice
# says: you left out the observed choice, in both counts
summary = [0.08125, 0.030443, 7.549]
p_value = 5 / 63

# %% wrong: without the observed choice, of 64
# says: you left out the choice that was observed
summary = [0.08125, 0.030443, 7.549]
p_value = 5 / 64

# %% wrong: 36 choices
# says: there are more choices of signs than you divided by
summary = [0.08125, 0.030443, 7.549]
p_value = 6 / 36

# %% wrong: 1 - p
# says: this is 1 - p
summary = [0.08125, 0.030443, 7.549]
p_value = 58 / 64

# %% wrong: the p-value of t
# says: this is the p-value of t
summary = [0.08125, 0.030443, 7.549]
p_value = stats.ttest_1samp(six, 0).pvalue

# %% wrong: p to one digit
# says: you rounded to two decimals
summary = [0.08125, 0.030443, 7.549]
p_value = 0.09

# %% wrong: a count
# says: this is the number of choices
summary = [0.08125, 0.030443, 7.549]
p_value = 6

# %% wrong: one side of N
# says: you count one side only
summary = [0.08125, 0.030443, 7.549]
N = "-log(alpha)/log(2)"

# %% wrong: natural logarithm left
# says: the natural logarithm is left as it is
summary = [0.08125, 0.030443, 7.549]
N = "log(2/alpha)"

# %% wrong: sign lost
# says: the sign is lost
summary = [0.08125, 0.030443, 7.549]
N = "1 + log(alpha)/log(2)"

# %% wrong: N**2 choices
# says: you take N**2 for the number of choices
summary = [0.08125, 0.030443, 7.549]
N = "sqrt(2/alpha)"

# %% wrong: 2*N choices
# says: you take 2*N for the number of choices
summary = [0.08125, 0.030443, 7.549]
N = "1/alpha"

# %% wrong: the p-value itself
# says: this is the smallest p-value, not N
summary = [0.08125, 0.030443, 7.549]
N = "2/2**alpha"

# %% wrong: half of alpha on the wrong side
# says: N: log(alpha/2)/log(2) is not right
summary = [0.08125, 0.030443, 7.549]
N = "log(alpha/2)/log(2)"

# %% wrong: with N in it
# says: N is unreadable: N is not declared. This part knows the names alpha only.
summary = [0.08125, 0.030443, 7.549]
N = "2/2**N"

# %% wrong: a number for a formula
# says: N: a string is asked, you have 6.
summary = [0.08125, 0.030443, 7.549]
N = 6

# %% wrong: nothing for N
# says: N: there is no answer yet. Replace the dots.
summary = [0.08125, 0.030443, 7.549]
N = ...

# %% right: as tuples and fractions
summary = [0.65 / 8, 0.030443, 7.549]
interval = (0.0558, 0.107)
p_value = 0.09375
N = "1 - log(alpha)/log(2)"

# %% right: with NumPy and SciPy
summary = [np.mean(differences), np.std(differences, ddof=1), stats.ttest_1samp(differences, 0).statistic]
interval = np.array(stats.ttest_1samp(differences, 0).confidence_interval())
p_value = am.compare_sign_flip(six, [0] * 6).p_value
N = "log(2/alpha, 2)"

# %% right: three digits, rounded on the way
summary = [0.0813, 0.0304, 7.56]
interval = [0.0558, 0.1067]
verdict = "B is better by about 8 cm"
p_value = 0.094

# %% right: the verdict in meters and with a comma
summary = [0.08125, 0.030443, 7.549]
verdict = "Bert is better by 0,081 m (95 % interval 0.056 to 0.107 m)."
N = "-log(alpha/2)/log(2)"

# %% right: the verdict with the 95 % in front, in millimeters
summary = [0.08125, 0.030443, 7.549]
verdict = "At 95 % confidence, B is better, by 81 millimeters"

# %% right: A is worse
summary = [0.08125, 0.030443, 7.549]
verdict = "A is worse by 0.08125 m"
p_value = 3 / 32

# %% right: SymPy for N
summary = [0.08125, 0.030443, 7.549]
N = sp.log(2 / sp.Symbol("alpha")) / sp.log(2)

# %% right: B beats A
summary = [0.08125, 0.030443, 7.549]
verdict = "B beats A by 8.1cm on average."
N = "1 - log(alpha, 2)"

# %% right: the interval comes first
summary = [0.08125, 0.030443, 7.549]
verdict = "With a 95 % interval of 5.6 to 10.7 cm, B is better by 8.1 cm"

# %% wrong: the upper limit in the verdict
# says: this is the upper limit
summary = [0.08125, 0.030443, 7.549]
verdict = "B is better by 10.7 cm"

# %% wrong: t to one decimal
# says: you rounded to one decimal
summary = [0.08125, 0.030443, 7.5]

# %% right: System B wins
summary = [0.08125, 0.030443, 7.549]
verdict = "System B wins, by 81mm"

# %% right: a small letter
summary = [0.08125, 0.030443, 7.549]
verdict = "b is better by 8.1 cm"

# %% right: an article in front
summary = [0.08125, 0.030443, 7.549]
verdict = "A difference of 8.1 cm: B is better than A."
N = "ln(2/alpha)/ln(2)"

# %% right: the ATE of B is smaller
summary = [0.08125, 0.030443, 7.549]
verdict = "The ATE of B is smaller by 0.0813 meters"

# %% right: A has the larger error
summary = [0.08125, 0.030443, 7.549]
verdict = "A's ATE is larger than B's, by 81 mm"

# %% wrong: A is said to win
# says: verdict: 'A wins against B by 8.1 cm' names the wrong system. The differences are A - B, a
summary = [0.08125, 0.030443, 7.549]
verdict = "A wins against B by 8.1 cm"

# %% wrong: B has the larger error
# says: verdict: 'The error of B is larger by 8.1 cm' names the wrong system. The differences are
summary = [0.08125, 0.030443, 7.549]
verdict = "The error of B is larger by 8.1 cm"

# %% right: one exponential
summary = [0.08125, 0.030443, 7.549]
interval = [0.0558, 0.1067]
N = "log(2*alpha**(-1))/log(2)"

# %% right: other words and units
summary = np.array([0.0813, 0.0304, 7.55])
interval = (0.0558, 0.107)
verdict = "System B is more accurate, by 81 mm (95 % interval 56 to 107 mm)."
p_value = sp.Rational(3, 32)
N = sp.log(2 / sp.Symbol("alpha"), 2)

# %% right: a negative sign with worse
verdict = "A is worse by 0.0813 meters"
N = "1 - log(alpha)/log(2)"
p_value = 0.0938

# %% right: rows
summary = [sp.Rational(13, 160), 0.030443, 7.549]
interval = np.array([[0.0558], [0.1067]])
verdict = "B wins: its error is 8.1 cm smaller than that of A."

# %% wrong: p of 64 without ties
# says: you left out the choice that was observed
p_value = 5 / 64

# %% wrong: N as equation
# says: without an equals sign and a left side
N = "N = log(2/alpha)/log(2)"
