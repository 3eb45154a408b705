# %% right: three digits on paper
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% right: arrays and a list of letters
dropped = np.array([0.325, 0.54])
worst_seen = np.array([3.2, 3.65]) / 6
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = ["A", "A", "B", "A"]

# %% right: lists, fractions by SymPy
dropped = [sp.Rational(130, 400), sp.Rational(270, 500)]
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = sp.Rational(7, 5)
medians = (0.380, 0.525)
winners = ("a", "a", "b", "a")

# %% right: a dictionary, and the unit
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = "1.4 m"
medians = {"A": 0.38, "B": 0.525}
winners = "A, A, B, A"

# %% right: computed by NumPy
E = np.array([[.31, .42, np.nan, .23, np.nan, .34], [.4, .6, .95, .3, np.nan, .45]])
dropped = np.nanmean(E, axis=1)
worst_seen = np.nan_to_num(E, nan=0.95).mean(axis=1)
two_meters = np.nan_to_num(E, nan=2).mean(axis=1)
tie = 1.40
medians = np.median(np.nan_to_num(E, nan=np.inf), axis=1)
winners = "AABA"

# %% wrong: dropped: only the worlds that both finished
dropped = (0.325, 0.4375)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: dropped: failed trials count as 0
dropped = (0.217, 0.450)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: dropped: sums
dropped = (1.30, 2.70)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: dropped: B first
dropped = (0.540, 0.325)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: dropped: in centimeters
dropped = (32.5, 54.0)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: dropped: one number
dropped = 0.325
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: dropped: two digits
dropped = (0.33, 0.54)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: worst seen: of its own system
dropped = (0.325, 0.540)
worst_seen = ((1.30 + 2 * 0.42) / 6, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: worst seen: divided by the finished trials
dropped = (0.325, 0.540)
worst_seen = (3.20 / 4, 3.65 / 5)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: worst seen: the world that both failed is dropped
dropped = (0.325, 0.540)
worst_seen = ((1.30 + 0.95) / 5, 0.54)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: worst seen: still dropped
dropped = (0.325, 0.540)
worst_seen = (0.325, 0.540)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: two meters: B's failure forgotten
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.450)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: two meters: 2 is added once
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (3.30 / 6, 4.70 / 6)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: two meters: divided by the finished trials
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (5.30 / 4, 4.70 / 5)
tie = 1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: tie: from the means
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 0.540 - 0.325
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: tie: B's own failure forgotten
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 0.70
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: tie: both failures on one side
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40 / 3
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: tie: the sign
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = -1.40
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: tie: centimeters
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 140
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: tie: two numbers
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = (1.4, 1.4)
medians = (0.380, 0.525)
winners = "AABA"

# %% wrong: medians without the failed
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.325, 0.45)
winners = "AABA"

# %% wrong: medians: failed count as 0
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.27, 0.425)
winners = "AABA"

# %% wrong: medians: the third
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.34, 0.45)
winners = "AABA"

# %% wrong: medians: the fourth
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.42, 0.60)
winners = "AABA"

# %% wrong: winners: the larger error
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "BBAB"

# %% wrong: winners: always A
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AAAA"

# %% wrong: winners: three letters
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AAB"

# %% wrong: winners: other letters
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AACA"

# %% wrong: winners: not entered
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = ...
