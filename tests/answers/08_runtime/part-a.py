# %% wrong: the expected number of misses
at_least_one = 1800 / 2000
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the probability of no miss
at_least_one = (1 - 1/2000)**1800
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: one frame a second
at_least_one = 1 - (1 - 1/2000)**180
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: one minute
at_least_one = 1 - (1 - 1/2000)**600
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: exactly one miss
at_least_one = 1800*(1/2000)*(1 - 1/2000)**1799
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: one frame alone
at_least_one = 1/2000
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: percent
at_least_one = 59.4
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: one decimal only
at_least_one = 0.6
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: a text
at_least_one = "59 %"
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: ranks from 0
at_least_one = 0.594
ranks = (5, 11)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the lower rank misses too often
at_least_one = 0.594
ranks = (7, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: K at most l
at_least_one = 0.594
ranks = (5, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: K more than u
at_least_one = 0.594
ranks = (6, 11)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the widest interval
at_least_one = 0.594
ranks = (1, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: ranks swapped
at_least_one = 0.594
ranks = (12, 6)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: limits for ranks
at_least_one = 0.594
ranks = (29, 58)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: ranks of an interval for the median
at_least_one = 0.594
ranks = (3, 10)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: counted from the longest
at_least_one = 0.594
ranks = (1, 7)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: one rank alone
at_least_one = 0.594
ranks = 6
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the next frame, as an index from 0
at_least_one = 0.594
ranks = (6, 12)
limits = (31, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the list as it stands
at_least_one = 0.594
ranks = (6, 12)
limits = (22, 33)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: limits swapped
at_least_one = 0.594
ranks = (6, 12)
limits = (58, 29)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: ranks for limits
at_least_one = 0.594
ranks = (6, 12)
limits = (6, 12)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: seconds
at_least_one = 0.594
ranks = (6, 12)
limits = (0.029, 0.058)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the 90 % that was asked for
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.9
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: one count too many
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954 + 0.0317
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: one count too few
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954 - 0.0401
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the last count is missing
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954 - 0.1267
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: from the count before
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954 + 0.0115
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the probability of a miss
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.046
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the lower side left out
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 1 - 0.0317
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: the upper side left out
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 1 - 0.0143
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: percent of the interval
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 95.4
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: two decimals
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.95
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% wrong: failures dropped
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (2/4, 1/4, 0)
median = 4

# %% wrong: failures dropped, only the curve
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (2/4, 1/4, 0)
median = 9

# %% wrong: the end of watching is a recovery
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (6/8, 3/8, 2/8)
median = 9

# %% wrong: runs stay at risk for ever
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (6/8, 5/8, 4/8)
median = 9

# %% wrong: the censored run leaves first
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (6/8, 6/8*3/4, 6/8*3/4*2/3)
median = 9

# %% wrong: shares that have recovered
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.25, 0.4, 0.6)
median = 9

# %% wrong: factors, not products
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (6/8, 4/5, 2/3)
median = 9

# %% wrong: a tie counts once
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (7/8, 7/8*4/5, 7/8*4/5*2/3)
median = 9

# %% wrong: the last share is missing
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6)
median = 9

# %% wrong: still lost in percent
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (75, 60, 40)
median = 9

# %% wrong: median of the recovered
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 5.5

# %% wrong: median of all ends
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 7

# %% wrong: mean of the recovered runs
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 6

# %% wrong: never reached
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 12

# %% wrong: the share for the median
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 0.4

# %% wrong: nan for the median
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = float("nan")

# %% wrong: the dots are left in a later one
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = ...

# %% right: lists and arrays
at_least_one = 0.594
ranks = [6, 12]
limits = np.array([29.0, 58.0])
probability = 0.954
still_lost = np.array([3/4, 3/5, 2/5])
median = 9.0

# %% right: computed with SciPy and NumPy
at_least_one = 1 - binom.pmf(0, 1800, 1/2000)
ranks = (6, 12)
limits = tuple(np.sort(frames)[[5, 11]])
probability = binom.cdf(11, 12, 0.75) - binom.cdf(5, 12, 0.75)
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% right: with the exponential function
at_least_one = 1 - np.exp(-0.9)
ranks = (6, 12)
limits = (29, 58)
probability = 0.0401 + 0.1032 + 0.1936 + 0.2581 + 0.2323 + 0.1267
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% right: fractions, and the library for the median
at_least_one = 0.594
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = [__import__("fractions").Fraction(3, 4), __import__("fractions").Fraction(3, 5), __import__("fractions").Fraction(2, 5)]
median = am.relocalization_time(lost, recovered).median

# %% right: SymPy, NumPy numbers, other names overwritten
at_least_one = sp.Float(0.594)
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = np.cumprod([6/8, 4/5, 2/3])
median = np.float64(9)

# %% right: sorted in place, names of the setup used up
frames.sort()
k = l = n = q = 3
at_least_one = 0.594
ranks = (6, 12)
limits = [frames[5], frames[11]]
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9

# %% right: everything from math
from math import *
at_least_one = 1 - exp(1800*log1p(-1/2000))
ranks = (6, 12)
limits = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 9
