# %% right: three digits on paper
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

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

# %% wrong: dropped: only the worlds that both finished
# says: only worlds that both finished are left
dropped = (0.325, 0.4375)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: dropped: failed trials count as 0
# says: failed trials count as 0
dropped = (0.217, 0.450)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: dropped: sums
# says: these are sums over the finished trials
dropped = (1.30, 2.70)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: dropped: B first
# says: A and B are swapped
dropped = (0.540, 0.325)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: dropped: in centimeters
# says: these are in centimeters
dropped = (32.5, 54.0)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: dropped: one number
# says: dropped: shape (2,) is asked, you have 0.325.
dropped = 0.325
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: dropped: two digits
# says: dropped: (0.33, 0.54) is not right.
dropped = (0.33, 0.54)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: worst seen: of its own system
# says: a failed trial counts as the worst ATE of its own system
dropped = (0.325, 0.540)
worst_seen = ((1.30 + 2 * 0.42) / 6, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: worst seen: divided by the finished trials
# says: the failed trials are added, but the sum is divided by the finished ones
dropped = (0.325, 0.540)
worst_seen = (3.20 / 4, 3.65 / 5)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: worst seen: the world that both failed is dropped
# says: the world in which both failed is dropped
dropped = (0.325, 0.540)
worst_seen = ((1.30 + 0.95) / 5, 0.54)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: worst seen: still dropped
# says: failed trials are dropped
dropped = (0.325, 0.540)
worst_seen = (0.325, 0.540)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: two meters: B's failure forgotten
# says: two_meters: (0.883, 0.45) is not right.
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.450)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: two meters: 2 is added once
# says: two_meters: (0.55, 0.783333) is not right.
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (3.30 / 6, 4.70 / 6)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: two meters: divided by the finished trials
# says: the failed trials are added, but the sum is divided by the finished ones
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (5.30 / 4, 4.70 / 5)
tie = 1.40
medians = (0.380, 0.525)

# %% wrong: tie: from the means
# says: you took the difference of the means, not of the sums
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 0.540 - 0.325
medians = (0.380, 0.525)

# %% wrong: tie: B's own failure forgotten
# says: B's own failed trial is forgotten
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 0.70
medians = (0.380, 0.525)

# %% wrong: tie: both failures on one side
# says: both numbers of failed trials are added
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40 / 3
medians = (0.380, 0.525)

# %% wrong: tie: the sign
# says: the sign is turned
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = -1.40
medians = (0.380, 0.525)

# %% wrong: tie: centimeters
# says: you give centimeters
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 140
medians = (0.380, 0.525)

# %% wrong: tie: two numbers
# says: tie: one number is asked, you have (1.4, 1.4).
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = (1.4, 1.4)
medians = (0.380, 0.525)

# %% wrong: medians without the failed
# says: failed trials are dropped
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.325, 0.45)

# %% wrong: medians: failed count as 0
# says: failed trials count as 0
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.27, 0.425)

# %% wrong: medians: the third
# says: you took the third in order, as if there were five worlds
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.34, 0.45)

# %% wrong: medians: the fourth
# says: you took the fourth in order
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.42, 0.60)

# %% wrong: winners: the larger error
# says: winners: your four letters do not all agree with the numbers above. The smaller error wins
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "BBAB"

# %% wrong: winners: always A
# says: winners: your four letters do not all agree with the numbers above.
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AAAA"

# %% wrong: winners: three letters
# says: winners: four letters are asked, each A or B, such as 'ABAB'.
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AAB"

# %% wrong: winners: other letters
# says: winners: four letters are asked, each A or B, such as 'ABAB'.
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = "AACA"

# %% wrong: winners: not entered
# says: winners: there is no answer yet. Replace the dots.
dropped = (0.325, 0.540)
worst_seen = (0.533, 0.608)
two_meters = (0.883, 0.783)
tie = 1.40
medians = (0.380, 0.525)
winners = ...

# %% right: dictionaries and text
dropped = {"A": 0.325, "B": 0.54}
tie = "w = 1.4 m"
winners = ["A", "A", "B", "A"]
medians = np.array([0.38, 0.525])

# %% right: SymPy numbers
worst_seen = (sp.Rational(16, 30), sp.Rational(73, 120))
two_meters = [0.883, 0.783]
winners = "a, a, b, a"
