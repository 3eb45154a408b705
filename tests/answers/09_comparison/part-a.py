# %% wrong: two numbers only
summary = (0.08125, 0.030443)
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: a text
summary = "0.08125, 0.030443, 7.549"
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: no t yet
summary = (0.08125, 0.030443, ...)
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% right: an array
summary = np.array([0.08125, 0.0304, 7.55])
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: in centimeters
summary = [8.125, 3.0443, 7.549]
interval = [5.58, 10.67]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: only the mean in centimeters
summary = [8.125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the mean of B - A
summary = [-0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the median for the mean
summary = [0.085, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the mean divided by 7
summary = [0.65 / 7, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the mean to one digit
summary = [0.08, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: s with the divisor N
summary = [0.08125, 0.02848, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: s as NumPy has it by default
summary = [0.08125, np.std(differences), 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the variance
summary = [0.08125, 0.000926786, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: squares without the mean
summary = [0.08125, (0.0593 / 7) ** 0.5, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the square of the mean once
summary = [0.08125, ((0.0593 - 0.08125**2) / 7) ** 0.5, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the standard error for s
summary = [0.08125, 0.010763, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: s to two digits
summary = [0.08125, 0.03, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: t without the root of N
summary = [0.08125, 0.030443, 2.669]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: t with N instead of its root
summary = [0.08125, 0.030443, 0.08125 / (0.030443 / 8)]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: t from the divisor N
summary = [0.08125, 0.030443, 8.07]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: t with the root of 7
summary = [0.08125, 0.030443, 0.08125 / (0.030443 / 7**0.5)]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the quantile for t
summary = [0.08125, 0.030443, 2.365]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: t upside down
summary = [0.08125, 0.030443, 1 / 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: t negative
summary = [0.08125, 0.030443, -7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: interval with the normal quantile
summary = [0.08125, 0.030443, 7.549]
interval = [0.0602, 0.1023]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: interval without the root of N
summary = [0.08125, 0.030443, 7.549]
interval = [0.00925, 0.1532]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: interval by N, not its root
summary = [0.08125, 0.030443, 7.549]
interval = [0.0722, 0.0903]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: one standard error
summary = [0.08125, 0.030443, 7.549]
interval = [0.0705, 0.0920]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: interval from the divisor N
summary = [0.08125, 0.030443, 7.549]
interval = [0.0574, 0.1051]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: one-sided quantile
summary = [0.08125, 0.030443, 7.549]
interval = [0.08125 - 1.895 * 0.010763, 0.08125 + 1.895 * 0.010763]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: quantile of 8 degrees of freedom
summary = [0.08125, 0.030443, 7.549]
interval = [0.08125 - 2.306 * 0.010763, 0.08125 + 2.306 * 0.010763]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: mean and half width
summary = [0.08125, 0.030443, 7.549]
interval = [0.08125, 0.02545]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: limits swapped
summary = [0.08125, 0.030443, 7.549]
interval = [0.106701, 0.055799]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: interval about 0
summary = [0.08125, 0.030443, 7.549]
interval = [-0.02545, 0.02545]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: smallest and largest difference
summary = [0.08125, 0.030443, 7.549]
interval = [0.03, 0.12]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: a number for the interval
summary = [0.08125, 0.030443, 7.549]
interval = 0.02545
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: A better
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "A is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: verdict without a unit
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 0.081"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: verdict without a size
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: verdict in the wrong unit
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 m"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: only a letter
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: undecided
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "undecided"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: a number for a verdict
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = 8.1
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: B is said to be worse
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is worse by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: verdict by the half width
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 2.5 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: one side of the signs
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 3 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: strictly larger sums only
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 4 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: strictly larger, on one side
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 2 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the sign test
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 14 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: without the observed choice
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 5 / 63
N = "log(2/alpha)/log(2)"

# %% wrong: without the observed choice, of 64
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 5 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: 36 choices
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 36
N = "log(2/alpha)/log(2)"

# %% wrong: 1 - p
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 58 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the p-value of t
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = stats.ttest_1samp(six, 0).pvalue
N = "log(2/alpha)/log(2)"

# %% wrong: p to one digit
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 0.09
N = "log(2/alpha)/log(2)"

# %% wrong: a count
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6
N = "log(2/alpha)/log(2)"

# %% wrong: one side of N
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "-log(alpha)/log(2)"

# %% wrong: natural logarithm left
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)"

# %% wrong: sign lost
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "1 + log(alpha)/log(2)"

# %% wrong: N**2 choices
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "sqrt(2/alpha)"

# %% wrong: 2*N choices
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "1/alpha"

# %% wrong: the p-value itself
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "2/2**alpha"

# %% wrong: half of alpha on the wrong side
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(alpha/2)/log(2)"

# %% wrong: with N in it
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "2/2**N"

# %% wrong: a number for a formula
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = 6

# %% wrong: nothing for N
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = ...

# %% right: as tuples and fractions
summary = [0.65 / 8, 0.030443, 7.549]
interval = (0.0558, 0.107)
verdict = "B is better by 8.1 cm"
p_value = 0.09375
N = "1 - log(alpha)/log(2)"

# %% right: with NumPy and SciPy
summary = [np.mean(differences), np.std(differences, ddof=1), stats.ttest_1samp(differences, 0).statistic]
interval = np.array(stats.ttest_1samp(differences, 0).confidence_interval())
verdict = "B is better by 8.1 cm"
p_value = am.compare_sign_flip(six, [0] * 6).p_value
N = "log(2/alpha, 2)"

# %% right: three digits, rounded on the way
summary = [0.0813, 0.0304, 7.56]
interval = [0.0558, 0.1067]
verdict = "B is better by about 8 cm"
p_value = 0.094
N = "log(2/alpha)/log(2)"

# %% right: the verdict in meters and with a comma
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "Bert is better by 0,081 m (95 % interval 0.056 to 0.107 m)."
p_value = 6 / 64
N = "-log(alpha/2)/log(2)"

# %% right: the verdict with the 95 % in front, in millimeters
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "At 95 % confidence, B is better, by 81 millimeters"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% right: A is worse
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "A is worse by 0.08125 m"
p_value = 3 / 32
N = "log(2/alpha)/log(2)"

# %% right: SymPy for N
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = sp.log(2 / sp.Symbol("alpha")) / sp.log(2)

# %% right: B beats A
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B beats A by 8.1cm on average."
p_value = 6 / 64
N = "1 - log(alpha, 2)"

# %% right: the interval comes first
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "With a 95 % interval of 5.6 to 10.7 cm, B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: the upper limit in the verdict
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "B is better by 10.7 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: t to one decimal
summary = [0.08125, 0.030443, 7.5]
interval = [0.055799, 0.106701]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% right: System B wins
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "System B wins, by 81mm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% right: a small letter
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "b is better by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% right: an article in front
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "A difference of 8.1 cm: B is better than A."
p_value = 6 / 64
N = "ln(2/alpha)/ln(2)"

# %% right: the ATE of B is smaller
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "The ATE of B is smaller by 0.0813 meters"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% right: A has the larger error
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "A's ATE is larger than B's, by 81 mm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: A is said to win
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "A wins against B by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% wrong: B has the larger error
summary = [0.08125, 0.030443, 7.549]
interval = [0.055799, 0.106701]
verdict = "The error of B is larger by 8.1 cm"
p_value = 6 / 64
N = "log(2/alpha)/log(2)"

# %% right: one exponential
summary = [0.08125, 0.030443, 7.549]
interval = [0.0558, 0.1067]
verdict = "B is better by 8.1 cm"
p_value = 6 / 64
N = "log(2*alpha**(-1))/log(2)"
