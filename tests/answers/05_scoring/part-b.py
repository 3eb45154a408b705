# %% wrong: every smooth rule is proper
# says: you found that there is a minimum, not where it lies
verdicts = ["strict", "strict", "strict", "proper", "strict"]
cheats = {}

# %% wrong: all are strict
# says: a rule that you call strict or proper can be beaten
verdicts = ["strict"] * 5
cheats = {}

# %% wrong: all are improper
# says: you gave (p, q), and q comes first
verdicts = ["improper"] * 5
cheats = {name: (0.9, 0.75) for name in rules}

# %% wrong: a tie is overlooked
# says: you overlook a tie
verdicts = ["improper", "improper", "strict", "strict", "strict"]

# %% wrong: a tie counts as a gain
# says: cheats: rounded is called improper, but at q = 0.52, p = 0.5 costs 0.25 on average and hon
verdicts = ["improper", "improper", "strict", "improper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8), "rounded": (0.52, 0.5)}

# %% wrong: rounding is taken for a clip
# says: cheats: rounded is called improper. Prove it by one pair of numbers (q, p), both inside (0
verdicts = ["improper", "improper", "strict", "improper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8), "rounded": (0.98, 1.0)}

# %% wrong: a constant makes it improper
# says: cheats: offset is called improper, but at q = 0.5, p = 0.2 costs 2.84 on average and hones
verdicts = ["improper", "improper", "improper", "proper", "strict"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8), "offset": (0.5, 0.2)}

# %% wrong: a root cannot be proper
# says: cheats: odds is called improper, but at q = 0.9, p = 0.75 costs 0.69282 on average and hon
verdicts = ["improper", "improper", "strict", "proper", "improper"]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.5, 0.8), "odds": (0.9, 0.75)}

# %% wrong: only strict or not
# says: cheats: rounded is called improper. Prove it by one pair of numbers (q, p), both inside (0
verdicts = ["improper", "improper", "strict", "improper", "strict"]

# %% wrong: the pair the other way round
# says: you gave (p, q), and q comes first
cheats = {"cubic": (0.75, 0.9), "cautious": (0.8, 0.5)}

# %% wrong: a bolder cheat where the rule wants a more timid one
# says: you gave (p, q), and q comes first
cheats = {"cubic": (0.9, 0.99), "cautious": (0.5, 0.8)}

# %% wrong: tried at one half only
# says: cheats: cubic is called improper, but at q = 0.5, p = 0.6 costs 0.14 on average and honest
cheats = {"cubic": (0.5, 0.6), "cautious": (0.5, 0.8)}

# %% wrong: a probability outside
# says: cheats: cubic is called improper. Prove it by one pair of numbers (q, p), both inside (0,
cheats = {"cubic": (1.5, 0.9), "cautious": (0.5, 0.8)}

# %% wrong: honest pairs
# says: cheats: cubic is called improper, but at q = 0.9, p = 0.9 costs 0.0738 on average and hone
cheats = {"cubic": (0.9, 0.9), "cautious": (0.5, 0.5)}

# %% wrong: one pair is missing
# says: cheats: cautious is called improper. Prove it by one pair of numbers (q, p), both inside (
cheats = {"cubic": (0.9, 0.75)}

# %% wrong: verdicts without proofs
# says: cheats: cubic is called improper. Prove it by one pair of numbers (q, p), both inside (0,
cheats = {}
w = ...

# %% wrong: the pairs are left as they were
# says: cheats: cubic is called improper. Prove it by one pair of numbers (q, p), both inside (0,
cheats = {
    ...  # your answer here
}

# %% wrong: pairs without names
# says: cheats: cubic is called improper. Prove it by one pair of numbers (q, p), both inside (0,
cheats = [(0.9, 0.75), (0.5, 0.8)]

# %% wrong: one word for all
# says: verdicts: a tuple of 5 results is asked, you have 'improper'.
verdicts = "improper"

# %% wrong: p alone
# says: cheats: cubic is called improper. Prove it by one pair of numbers (q, p), both inside (0,
cheats = {"cubic": 0.75, "cautious": 0.8}

# %% wrong: True and False
# says: you use words other than "strict", "proper" and "improper"
verdicts = [False, False, True, True, True]
cheats = {}

# %% wrong: the weight of the cross-entropy
# says: this is the weight of the cross-entropy
w = "1/(p*(1-p))"

# %% wrong: the factor 1/2 is lost
# says: a factor 1/2 is lost
w = "1/(p*(1-p))**(3/2)"

# %% wrong: the sign of the weight
# says: its sign is turned
w = "-1/(2*(p*(1-p))**(3/2))"

# %% wrong: the whole slope
# says: p - q is in it again
w = "(p-q)/(2*(p*(1-p))**(3/2))"

# %% wrong: power 1/2
# says: the power of p*(1-p) is not right
w = "1/(2*sqrt(p*(1-p)))"

# %% wrong: the weight is not carried out
# says: w: Derivative still stands in your formula. Carry it out.
w = "Derivative(-2*sqrt(p*(1-p)), p, 2)"

# %% wrong: a constant weight
# says: this is the weight of the Brier score
w = "2"

# %% wrong: an added term looks like a tie
# says: an added term without p looks like a tie to you
verdicts = ["improper", "improper", "proper", "proper", "strict"]

# %% right: a word with a capital
verdicts = ["Improper", "Improper", "strict", "proper", "strict"]

# %% wrong: one improper rule is let pass
# says: a rule that you call strict or proper can be beaten
verdicts = ["improper", "proper", "strict", "proper", "strict"]

# %% wrong: the whole slope, with a negative power
# says: p - q is in it again
w = "(p-q)*(p*(1-p))**(-3/2)/2"

# %% right: other pairs, a tuple, roots
verdicts = ("improper", "improper", "strict", "proper", "strict")
cheats = {"cautious": (0.1, 4 * 0.1 / 1.3), "cubic": [0.2, 1 / 3]}
w = "1/(2*p*(1-p)*sqrt(p*(1-p)))"

# %% right: pairs found by search, negative powers
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
cheats = {"cubic": (0.6, 0.55), "cautious": (0.9, 0.95), "odds": None}
w = "(sqrt(p/(1-p)) + sqrt((1-p)/p))/(2*p*(1-p))"

# %% wrong: the tie called strict, and the strict one a tie
# says: verdicts: ('improper', 'improper', 'proper', 'strict', 'strict') is not right.
verdicts = ["improper", "improper", "proper", "strict", "strict"]

# %% wrong: the names instead of a list
# says: you use words other than "strict", "proper" and "improper"
verdicts = list(rules)

# %% wrong: the factor 1/2 twice
# says: there is a factor 1/2 too many
w = "1/(4*(p*(1-p))**(3/2))"

# %% wrong: a weight with q left in it
# says: w: q/(2*(p*(1-p))**(3/2)) is not right. At p = 1/4, q = 1/2 it makes (w)*(p-q) equal to -0
w = "q/(2*(p*(1-p))**(3/2))"

# %% wrong: the expected cost
# says: w: q*sqrt((1-p)/p) + (1-q)*sqrt(p/(1-p)) is not right. At p = 1/4, q = 1/2 it makes (w)*(p
w = "q*sqrt((1-p)/p) + (1-q)*sqrt(p/(1-p))"

# %% wrong: p(1-p) above
# says: p*(1-p) stands above, not below
w = "(p*(1-p))**(3/2)/2"

# %% wrong: an equation
# says: w: enter the right side alone, without an equals sign and a left side.
w = "w = 1/(2*(p*(1-p))**(3/2))"

# %% right: a computed SymPy object, in which p - q is not canceled
import sympy as sp

p_, q_ = sp.symbols("p q", positive=True)
mean_cost = q_ * sp.sqrt((1 - p_) / p_) + (1 - q_) * sp.sqrt(p_ / (1 - p_))
w = sp.simplify(sp.diff(mean_cost, p_) / (p_ - q_))

# %% right: the quotient as it is, as text
w = "(-q/(2*p**2*sqrt((1-p)/p)) + (1-q)/(2*(1-p)**2*sqrt(p/(1-p))))/(p-q)"

# %% right: NumPy numbers and arrays
verdicts = np.array(["improper", "improper", "strict", "proper", "strict"])
cheats = {"cubic": np.array([0.2, 0.3]), "cautious": (np.float64(0.5), np.float64(0.8))}

# %% right: computed on a grid
def verdict_of(rule):
    grid_p = np.arange(1, 100) / 100
    ties = False
    for q in grid_p:
        cost = np.array([q * rule(p, 1) + (1 - q) * rule(p, 0) for p in grid_p])
        honest = q * rule(q, 1) + (1 - q) * rule(q, 0)
        if cost.min() < honest - 1e-12:
            return "improper"
        ties = ties or np.sum(cost < honest + 1e-12) > 1
    return "proper" if ties else "strict"


verdicts = [verdict_of(rule) for rule in rules.values()]
cheats = {"cubic": (0.9, 0.75), "cautious": (0.9, 0.97)}

# %% right: shadowed names, and letters of other parts
sum = 0
max = min = None
check_value, grid, np_ = 1, None, np
p, q, A, labels = 0.3, 0.4, "A", []
w = "p**(-1.5)*(1-p)**(-1.5)/2"
