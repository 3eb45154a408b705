# %% wrong: the expected number of misses
# says: this is the expected number of misses
at_least_one = 1800 / 2000
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the probability of no miss
# says: this is the probability of no miss
at_least_one = (1 - 1/2000)**1800
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: one frame a second
# says: you took one frame a second
at_least_one = 1 - (1 - 1/2000)**180
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: one minute
# says: you took one minute
at_least_one = 1 - (1 - 1/2000)**600
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: exactly one miss
# says: this is exactly one miss
at_least_one = 1800*(1/2000)*(1 - 1/2000)**1799
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: one frame alone
# says: this is one frame alone
at_least_one = 1/2000
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: percent
# says: you give percent
at_least_one = 59.4
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: one decimal only
# says: you rounded to one decimal
at_least_one = 0.6
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: a text
# says: at_least_one: numbers are asked, you have '59 %'.
at_least_one = "59 %"
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: ranks from 0
# says: you count ranks from 0
at_least_one = 0.594
ranks = (5, 11)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the lower rank misses too often
# says: the lower rank misses with more than 5 %
at_least_one = 0.594
ranks = (7, 12)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: K at most l
# says: of the two lower ranks you took the one that K has to exceed
at_least_one = 0.594
ranks = (5, 12)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: K more than u
# says: you ask that more than u frames lie below, not u or more
at_least_one = 0.594
ranks = (6, 11)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the widest interval
# says: this is the widest interval that there is
at_least_one = 0.594
ranks = (1, 12)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: ranks swapped
# says: the ranks are swapped
at_least_one = 0.594
ranks = (12, 6)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: limits for ranks
# says: these are the limits, not their ranks
at_least_one = 0.594
ranks = (29, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: ranks of an interval for the median
# says: this is an interval for the median
at_least_one = 0.594
ranks = (3, 10)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: counted from the longest
# says: the ranks are counted from the longest frame
at_least_one = 0.594
ranks = (1, 7)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: one rank alone
# says: ranks: shape (2,) is asked, you have 6.
at_least_one = 0.594
ranks = 6
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the next frame, as an index from 0
# says: you count from 0
at_least_one = 0.594
limits = (31, 58)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the list as it stands
# says: you count in the list as it stands
at_least_one = 0.594
limits = (22, 33)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: limits swapped
# says: the limits are swapped
at_least_one = 0.594
limits = (58, 29)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: ranks for limits
# says: these are the ranks, not the frames
at_least_one = 0.594
limits = (6, 12)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: seconds
# says: you give seconds
at_least_one = 0.594
limits = (0.029, 0.058)
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the 90 % that was asked for
# says: this is what was asked for, not what these ranks give
at_least_one = 0.594
probability = 0.9
still_lost = (0.75, 0.6, 0.4)

# %% wrong: one count too many
# says: you count K = u as a hit
at_least_one = 0.594
probability = 0.954 + 0.0317
still_lost = (0.75, 0.6, 0.4)

# %% wrong: one count too few
# says: you count K = l as a miss
at_least_one = 0.594
probability = 0.954 - 0.0401
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the last count is missing
# says: the last count is missing from the sum
at_least_one = 0.594
probability = 0.954 - 0.1267
still_lost = (0.75, 0.6, 0.4)

# %% wrong: from the count before
# says: the sum begins one count too early
at_least_one = 0.594
probability = 0.954 + 0.0115
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the probability of a miss
# says: this is the probability that it misses
at_least_one = 0.594
probability = 0.046
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the lower side left out
# says: you left out the lower side
at_least_one = 0.594
probability = 1 - 0.0317
still_lost = (0.75, 0.6, 0.4)

# %% wrong: the upper side left out
# says: you count K = u as a hit
at_least_one = 0.594
probability = 1 - 0.0143
still_lost = (0.75, 0.6, 0.4)

# %% wrong: percent of the interval
# says: you give percent
at_least_one = 0.594
probability = 95.4
still_lost = (0.75, 0.6, 0.4)

# %% wrong: two decimals
# says: you rounded to two decimals
at_least_one = 0.594
probability = 0.95
still_lost = (0.75, 0.6, 0.4)

# %% wrong: failures dropped
# says: you dropped the runs that were not recovered
at_least_one = 0.594
probability = 0.954
still_lost = (2/4, 1/4, 0)
median = 4

# %% wrong: failures dropped, only the curve
# says: you dropped the runs that were not recovered
at_least_one = 0.594
probability = 0.954
still_lost = (2/4, 1/4, 0)

# %% wrong: the end of watching is a recovery
# says: you count the end of watching as a recovery
at_least_one = 0.594
probability = 0.954
still_lost = (6/8, 3/8, 2/8)

# %% wrong: runs stay at risk for ever
# says: runs stay at risk after their watching has ended
at_least_one = 0.594
probability = 0.954
still_lost = (6/8, 5/8, 4/8)

# %% wrong: the censored run leaves first
# says: at equal times you let the censored run leave first
at_least_one = 0.594
probability = 0.954
still_lost = (6/8, 6/8*3/4, 6/8*3/4*2/3)

# %% wrong: shares that have recovered
# says: these are shares that have recovered
at_least_one = 0.594
probability = 0.954
still_lost = (0.25, 0.4, 0.6)

# %% wrong: factors, not products
# says: these are the factors, not yet their products
at_least_one = 0.594
probability = 0.954
still_lost = (6/8, 4/5, 2/3)

# %% wrong: a tie counts once
# says: you count each time once, whoever recovers at it
at_least_one = 0.594
probability = 0.954
still_lost = (7/8, 7/8*4/5, 7/8*4/5*2/3)

# %% wrong: the last share is missing
# says: still_lost: shape (3,) is asked, you have (0.75, 0.6).
at_least_one = 0.594
probability = 0.954
still_lost = (0.75, 0.6)

# %% wrong: still lost in percent
# says: you give percent
at_least_one = 0.594
probability = 0.954
still_lost = (75, 60, 40)

# %% wrong: median of the recovered
# says: you dropped the runs that were not recovered
at_least_one = 0.594
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 5.5

# %% wrong: median of all ends
# says: you took each end of watching for a recovery
at_least_one = 0.594
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 7

# %% wrong: mean of the recovered runs
# says: this is the mean of the recovered runs
at_least_one = 0.594
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 6

# %% wrong: never reached
# says: you took the end of the longest run
at_least_one = 0.594
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 12

# %% wrong: the share for the median
# says: this is the share at that time
at_least_one = 0.594
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = 0.4

# %% wrong: nan for the median
# says: median: you have nan, which is not finite.
at_least_one = 0.594
probability = 0.954
still_lost = (0.75, 0.6, 0.4)
median = float("nan")

# %% wrong: the dots are left in a later one
# says: median: there is no answer yet. Replace the dots.
at_least_one = 0.594
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
limits = tuple(np.sort(frames)[[5, 11]])
probability = binom.cdf(11, 12, 0.75) - binom.cdf(5, 12, 0.75)
still_lost = (0.75, 0.6, 0.4)

# %% right: with the exponential function
at_least_one = 1 - np.exp(-0.9)
probability = 0.0401 + 0.1032 + 0.1936 + 0.2581 + 0.2323 + 0.1267
still_lost = (0.75, 0.6, 0.4)

# %% right: fractions, and the library for the median
at_least_one = 0.594
probability = 0.954
still_lost = [__import__("fractions").Fraction(3, 4), __import__("fractions").Fraction(3, 5), __import__("fractions").Fraction(2, 5)]
median = am.relocalization_time(lost, recovered).median

# %% right: SymPy, NumPy numbers, other names overwritten
at_least_one = sp.Float(0.594)
probability = 0.954
still_lost = np.cumprod([6/8, 4/5, 2/3])
median = np.float64(9)

# %% right: sorted in place, names of the setup used up
frames.sort()
k = l = n = q = 3
at_least_one = 0.594
limits = [frames[5], frames[11]]
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% right: everything from math
from math import *
at_least_one = 1 - exp(1800*log1p(-1/2000))
probability = 0.954
still_lost = (0.75, 0.6, 0.4)

# %% right: SymPy, arrays, floats
at_least_one = 0.594
ranks = np.array([6.0, 12.0])
limits = [29.0, 58.0]
probability = sp.Rational(954, 1000)
still_lost = np.array([0.75, 0.6, 0.4])
median = 9.0
