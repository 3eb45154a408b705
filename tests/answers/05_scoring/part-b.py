# %% wrong: every smooth rule is proper
verdicts = ["strict", "strict", "strict", "proper", "strict"]
cheats = {}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: all are strict
verdicts = ["strict"] * 5
cheats = {}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: all are improper
verdicts = ["improper"] * 5
cheats = {name: (0.9, 0.75) for name in rules}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: a tie is overlooked
verdicts = ["improper", "improper", "strict", "strict", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: a tie counts as a gain
verdicts = ["improper", "improper", "strict", "improper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8), "rounded": (0.52, 0.5)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: rounding is taken for a clip
verdicts = ["improper", "improper", "strict", "improper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8), "rounded": (0.98, 1.0)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: a constant makes it improper
verdicts = ["improper", "improper", "improper", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8), "offset": (0.5, 0.2)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: a root cannot be proper
verdicts = ["improper", "improper", "strict", "proper", "improper"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8), "odds": (0.9, 0.75)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: only strict or not
verdicts = ["improper", "improper", "strict", "improper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: the pair the other way round
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.75, 0.9), "cautious": (0.8, 0.5)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: a bolder cheat where the rule wants a more timid one
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.99), "cautious": (0.5, 0.8)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: tried at one half only
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.5, 0.6), "cautious": (0.5, 0.8)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: a probability outside
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (1.5, 0.9), "cautious": (0.5, 0.8)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: honest pairs
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.9), "cautious": (0.5, 0.5)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: one pair is missing
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: verdicts without proofs
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {}
w = ...

# %% wrong: the pairs are left as they were
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {
    ...  # your answer here
}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: pairs without names
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = [(0.9, 0.75), (0.5, 0.8)]
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: one word for all
verdicts = "improper"
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: p alone
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": 0.75, "cautious": 0.8}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: True and False
verdicts = [False, False, True, True, True]
cheats = {}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: the weight of the cross-entropy
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "1/(p*(1-p))"

# %% wrong: the factor 1/2 is lost
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "1/(p*(1-p))**(3/2)"

# %% wrong: the sign of the weight
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "-1/(2*(p*(1-p))**(3/2))"

# %% wrong: the whole slope
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "(p-q)/(2*(p*(1-p))**(3/2))"

# %% wrong: power 1/2
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "1/(2*sqrt(p*(1-p)))"

# %% wrong: the weight is not carried out
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "Derivative(-2*sqrt(p*(1-p)), p, 2)"

# %% wrong: a constant weight
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "2"

# %% wrong: an added term looks like a tie
verdicts = ["improper", "improper", "proper", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: a word with a capital
verdicts = ["Improper", "Improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: one improper rule is let pass
verdicts = ["improper", "proper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "1/(2*(p*(1-p))**(3/2))"

# %% wrong: the whole slope, with a negative power
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8)}
w = "(p-q)*(p*(1-p))**(-3/2)/2"

# %% right: other pairs, a tuple, roots
verdicts = ("improper", "improper", "strict", "proper", "strict")
cheats = {"cautious": (0.1, 4 * 0.1 / 1.3), "cubic": [0.2, 1 / 3]}
w = "1/(2*p*(1-p)*sqrt(p*(1-p)))"

# %% right: pairs found by search, negative powers
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {
    name: min(
        ((q, p) for q in np.arange(0.05, 1, 0.05) for p in np.arange(0.05, 1, 0.05)),
        key=lambda z: sum(
            s * (z[0] * rules[name](x, 1) + (1 - z[0]) * rules[name](x, 0))
            for s, x in ((1, z[1]), (-1, z[0]))
        ),
    )
    for name in ("cubic", "cautious")
}
w = "0.5*p**(-3/2)*(1-p)**(-3/2)"

# %% right: a sum of two terms
verdicts = ["improper", "improper", "strict", "proper", "strict"]
cheats = {"cubic": (0.6, 0.55), "cautious": (0.9, 0.95), "odds": None}
w = "(sqrt(p/(1-p)) + sqrt((1-p)/p))/(2*p*(1-p))"
