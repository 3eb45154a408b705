# %% wrong: nothing but the results
# says: lines_psi: every line follows, but you leap: 1 of at least 2 lines bring something new. Ma
lines_psi = ["2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the derivative of the logarithm without the inner one
# says: lines_psi: line 1: wrong
lines_psi = """
    = 2*c**2*(1/c - 1/(1 + x/c))
    = 2*x/(1 + x/c)
"""
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the first term does not become a constant
# says: lines_psi: line 1: wrong
lines_psi = """
    = 2*c**2*(x/c - 1/(c*(1 + x/c)))
    = 2*x/(1 + x/c)
"""
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: leaps to the result, rewritten once
# says: lines_psi: every line follows, but none shows the derivative of each term, as it is before
lines_psi = ["2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: takes the constant out, then leaps
# says: lines_psi: every line follows, but none shows the derivative of each term, as it is before
lines_psi = ["2*c**2*Derivative(x/c - log(1 + x/c), x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: pads with plus and minus the same
# says: lines_psi: every line follows, but you leap: 1 of at least 2 lines bring something new. Ma
lines_psi = ["2*x/(1 + x/c) + c - c", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: pads with a factor 2/2
# says: lines_psi: every line follows, but you leap: 1 of at least 2 lines bring something new. Ma
lines_psi = ["2*2*x/(2*(1 + x/c))", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: stops before the fraction is one
# says: lines_psi: the goal is not reached: the last line agrees with it, but does not have its fo
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the weight is the influence function
# says: this is the influence function
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
weight = "2*x/(1 + x/c)"
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the weight without the half
# says: you left out the 2 of 2x
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
weight = "2/(1 + x/c)"
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the weight is the curvature
# says: this is half of the slope of psi
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
weight = "1/(1 + x/c)**2"
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the weight of Cauchy's kernel
# says: this is the weight of Cauchy's kernel
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
weight = "1/(1 + x**2/c**2)"
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the derivative is left in the weight
# says: weight: Derivative still stands in your formula. Carry it out.
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
weight = "Derivative(2*c**2*(x/c - log(1 + x/c)), x)/(2*x)"
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the limit is read off
# says: lines_limit: every line follows, but you leap: 1 of at least 2 lines bring something new.
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the limit of a fraction that still is infinity over infinity
# says: lines_limit: every line follows, but none shows the fraction under the limit in a form who
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2*c*x/(c + x), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: x is put to infinity in numerator and denominator
# says: lines_limit: line 1: wrong
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2*x, x, oo)/Limit(1 + x/c, x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: l'Hopital by the quotient rule
# says: lines_limit: line 1: wrong
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1 + x/c)**2, x, oo)", "0"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the limit without c
# says: lines_limit: line 2: wrong
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the bound is claimed
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*c"

# %% wrong: the bound is claimed, padded
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "= 2*2*x/(2*(1 + x/c))\n < 2*c"

# %% wrong: the bound is claimed, padded behind
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*c + c - c\n = 2*c"

# %% wrong: the limit of the result
# says: lines_limit: every line follows, but none shows the fraction under the limit in a form who
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2*c, x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the two halves, then a leap
# says: lines_psi: every line follows, but none shows the derivative of each term, as it is before
lines_psi = ["x/(1 + x/c) + x/(1 + x/c)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the logarithm is taken apart, then a leap
# says: lines_psi: every line follows, but none shows the derivative of each term, as it is before
lines_psi = ["Derivative(2*c**2*(x/c - log(c + x) + log(c)), x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: a denominator that is smaller makes the fraction smaller
# says: lines_bound: lines begin with = or <, and none of yours with <.
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "> 2*x/(x/c)\n = 2*c"

# %% wrong: the bound as an equation
# says: lines_bound: lines begin with = or <, and none of yours with <.
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = ["2*x/(x/c)", "2*c"]

# %% wrong: the bound of small x
# says: lines_bound: line 2: wrong
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x\n < 2*c"

# %% wrong: the last part is missing
# says: lines_bound: the derivation: there is no answer yet. Replace the dots.
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = ...

# %% right: three lines, the fraction put together in between
lines_psi = """
    = 2*c**2*(1/c - (1/c)/(1 + x/c))   # chain rule
    = 2*c*(1 + x/c - 1)/(1 + x/c)      # one fraction
    = 2*x/(1 + x/c)                    # cancel
"""
weight = "c/(c + x)"
lines_limit = """
    = Limit(2*c - 2*c/(1 + x/c), x, oo)   # divide with remainder
    = 2*c                                 # the rest vanishes
"""
lines_bound = """
    = 2*c - 2*c/(1 + x/c)   # divide with remainder
    < 2*c                   # the rest is positive
"""

# %% right: derivatives of each term, l'Hopital, lists of pairs
lines_psi = [
    ("2*c**2*(Derivative(x/c, x) - Derivative(log(1 + x/c), x))", "linear"),
    ("2*c**2*(1/c - 1/(c + x))", "chain rule"),
    ("2*c - 2*c**2/(c + x)", "multiply out"),
    ("2*c*x/(c + x)", "one fraction"),
    ("2*x/(1 + x/c)", "divide by c"),
]
weight = "1/(1+x/c)"
lines_limit = [
    ("Limit(Derivative(2*x, x)/Derivative(1 + x/c, x), x, oo)", "l'Hopital"),
    ("2/(1/c)", "no x left"),
    ("2*c", ""),
]
lines_bound = [("= 2*c*x/(c + x)", "times c"), ("< 2*c*x/x", "smaller below"), ("= 2*c", "cancel")]

# %% right: SymPy objects
import sympy as sp

x, c = sp.symbols("x c", positive=True)
psi = 2 * x / (1 + x / c)
lines_psi = [2 * c**2 * (1 / c - 1 / (c + x)), 2 * c * (1 - c / (c + x)), psi]
weight = sp.simplify(psi / (2 * x))
lines_limit = [sp.Limit(2 / (1 / x + 1 / c), x, sp.oo), 2 * c]
lines_bound = "= 2*c*(x/(c + x))\n < 2*c*1\n = 2*c"

# %% right: the given lines repeated, other names of the limit
lines_psi = """
    Derivative(2*c**2*(x/c - log(1 + x/c)), x)
    = 2*c**2*(1/c - (1/c)*(1/(1 + x/c)))
    = 2*c*(1 - 1/(1 + x/c))
    = 2*c*((x/c)/(1 + x/c))
    = 2*x/(1 + x/c)
"""
weight = "(2*x/(1 + x/c))/(2*x)"
lines_limit = """
    Limit(2*x/(1 + x/c), x, oo)
    = 2*Limit(x/(1 + x/c), x, oo)
    = 2*Limit(1/(1/x + 1/c), x, oo)
    = 2*(1/(0 + 1/c))
    = 2*c
"""
lines_bound = """
    2*x/(1 + x/c)
    < 2*x/(x/c)     # leave out the 1
    = 2*c
"""

# %% right: rows without signs, a strict step after a loose one
lines_psi = """
    2*c**2*Derivative(x/c - log(1 + x/c), x)
    2*c**2*(1/c - 1/(c*(1 + x/c)))
    2*c**2*((1 + x/c) - 1)/(c*(1 + x/c))
    2*x/(1 + x/c)
"""
weight = "1 - x/(c + x)"
lines_limit = """
    Limit(2*c/(c/x + 1), x, oo)
    2*c/(0 + 1)
    2*c
"""
lines_bound = """
    = 2*c*x/(x + c)
    <= 2*c*(x + c/2)/(x + c)
    < 2*c*(x + c)/(x + c)
    = 2*c
"""

# %% right: another variable in the limit
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*x/(1 + x/c)"]
weight = "1/(x/c + 1)"
lines_limit = ["Limit(2*c*u/(1 + u), u, oo)", "Limit(2*c/(1/u + 1), u, oo)", "2*c"]
lines_bound = "= 2*c*(x/c)/(1 + x/c)\n < 2*c*(1 + x/c)/(1 + x/c)\n = 2*c"

# %% right: t = 1/x, and diff for a derivative
lines_psi = """
    = 2*c**2*(diff(x/c, x) - diff(log(1 + x/c), x))   # term by term
    = 2*c**2*(1/c - 1/(c + x))                        # chain rule
    = 2*c*x/(c + x)                                   # one fraction
    = 2*x/(x/c + 1)                                   # divide by c
"""
weight = "(1 + x/c)**-1"
lines_limit = ["Limit(2/(t + 1/c), t, 0)", "2/(1/c)", "2*c"]
lines_bound = ["= 2*c*x/(c + x)", "< 2*c*(x + c)/(c + x)", "= 2*c"]

# %% wrong: one fraction times a bracket, minus what it adds
# says: lines_psi: every line follows, but none shows the derivative of each term, as it is before
lines_psi = ["2*x/(1 + x/c)*(1 + x) - 2*x**2/(1 + x/c)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: a constant is added to the result and taken away
# says: lines_psi: every line follows, but none shows the derivative of each term, as it is before
lines_psi = ["2*c + (2*x/(1 + x/c) - 2*c)", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the two derivatives are announced, not carried out
# says: lines_psi: every line follows, but none shows the derivative of each term, as it is before
lines_psi = ["Derivative(2*c*x, x) - Derivative(2*c**2*log(1 + x/c), x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: only the first term is differentiated, then a leap
# says: lines_psi: every line follows, but none shows the derivative of each term, as it is before
lines_psi = ["2*c - 2*c**2*Derivative(log(1 + x/c), x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the result is halved and doubled in two fractions
# says: lines_psi: every line follows, but none shows the derivative of each term, as it is before
lines_psi = ["4*x/(1 + x/c) - 2*x*(1 + x/c)/(1 + x/c)**2", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: three is added below the limit and taken away
# says: lines_limit: every line follows, but none shows the fraction under the limit in a form who
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = "= Limit(2*x/(1 + x/c) + 3, x, oo) - 3\n = 2*c"
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: three is added, in a fraction of its own
# says: lines_limit: every line follows, but none shows the fraction under the limit in a form who
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = "= Limit((2*x + 3*(1 + x/c))/(1 + x/c), x, oo) - 3\n = 2*c"
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: another function with the same limit
# says: lines_limit: every line follows, but none shows the fraction under the limit in a form who
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = "= Limit(2*c + 1/x, x, oo)\n = 2*c"
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: two other functions with the same limit
# says: lines_limit: every line follows, but none shows the fraction under the limit in a form who
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = "= Limit(2*c + 1/x, x, oo)\n = Limit(2*c + 1/(2*x), x, oo)\n = 2*c"
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: a factor that tends to 1
# says: lines_limit: every line follows, but none shows the fraction under the limit in a form who
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = "= Limit(2*c*(1 - 1/x), x, oo)\n = 2*c"
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: infinity over infinity beside a finite factor
# says: lines_limit: every line follows, but none shows the fraction under the limit in a form who
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = "= Limit((2/(1/x + 1/c))*(x/x), x, oo)*Limit(x/x, x, oo)\n = 2*c"
lines_bound = "< 2*x/(x/c)\n = 2*c"

# %% wrong: the bound is claimed, x behind it and taken away
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*c + x - x\n = 2*c"

# %% wrong: the bound is claimed, times a fraction that is one
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*c*(1 + x)/(1 + x)\n = 2*c"

# %% wrong: times c, then the bound is claimed
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "= 2*x*c/(c + x)\n < 2*c"

# %% wrong: times c, then the bound is claimed in a fraction that is one
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "= 2*c*x/(c + x)\n < 2*c*(1 + x)/(1 + x)\n = 2*c"

# %% wrong: the bound minus the rest to it
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "= 2*c - (2*c - 2*x/(1 + x/c))\n < 2*c"

# %% wrong: the rest to the bound is added
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "< 2*x/(1 + x/c) + (2*c - 2*c*x/(c + x))\n = 2*c"

# %% wrong: the rest to the bound within a bracket
# says: lines_bound: every line follows, but you leap: at no < does one see which part became larg
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "= 2*(c - (c - c*x/(c + x)))\n < 2*c"

# %% wrong: the bound stands on the wrong side of the sign
# says: lines_bound: lines begin with = or <, and none of yours with <.
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/x + 1/c), x, oo)", "2*c"]
lines_bound = "= 2*c - 2*c/(1 + x/c)\n > 2*c"

# %% right: both slopes multiplied out at once, limits of the parts, a term is left out
lines_psi = "= 2*c - 2*c**2/(c + x)\n = 2*x/(1 + x/c)"
weight = "c/(x + c)"
lines_limit = "= Limit(2*c, x, oo) - Limit(2*c**2/(c + x), x, oo)\n = 2*c - 0\n = 2*c"
lines_bound = "= 2*c*(1 - c/(c + x))\n < 2*c*1\n = 2*c"

# %% right: one slope after the other, quotient of limits, the denominator shrinks to 1/c
lines_psi = ["Derivative(2*c*x, x) - Derivative(2*c**2*log(1 + x/c), x)", "2*c - Derivative(2*c**2*log(1 + x/c), x)", "2*c - 2*c**2*(1/c)/(1 + x/c)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2, x, oo)/Limit(1/x + 1/c, x, oo)", "2/(1/c)", "2*c"]
lines_bound = ["= 2/(1/x + 1/c)", "< 2/(1/c)", "= 2*c"]

# %% right: the logarithm of a quotient, u = x/c in the limit, a sum in the denominator
lines_psi = ["Derivative(2*c*x - 2*c**2*(log(c + x) - log(c)), x)", "2*c - 2*c**2*(1/(c + x) - 0)", "(2*c*(c + x) - 2*c**2)/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2*c/(1/u + 1), u, oo)", "2*c"]
lines_bound = ["= 2*c/(c/x + 1)", "< 2*c"]

# %% right: the inner derivative is left for the next line, l'Hopital carried out
lines_psi = ["2*c**2*(1/c - Derivative(x/c, x)/(1 + x/c))", "2*c*(1 - 1/(1 + x/c))", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2/(1/c), x, oo)", "2*c"]
lines_bound = ["< 2*c*(1 + x/c)/(1 + x/c)", "= 2*c"]

# %% right: first another form of the fraction, then divided by x; numerators compared
lines_psi = ["2*c**2*(1/c - 1/(c + x))", "2*c*(1 - c/(c + x))", "2*c*x/(c + x)", "2*x/(1 + x/c)"]
lines_limit = ["Limit(2*c*x/(c + x), x, oo)", "Limit(2*c/(c/x + 1), x, oo)", "2*c/(0 + 1)", "2*c"]
lines_bound = ["= 2*c*x/(c + x)", "< 2*c*(c + x)/(c + x)", "= 2*c"]

# %% right: u = 1 + x/c in the limit, numerator made larger
lines_psi = """
    = 2*c**2*Derivative(x/c, x) - 2*c**2*Derivative(log(1 + x/c), x)
    = 2*c**2/c - 2*c**2*(1/(1 + x/c))*(1/c)
    = 2*x/(1 + x/c)
"""
weight = "  c / (x + c) "
lines_limit = """
    = Limit(2*c*(u - 1)/u, u, oo)
    = Limit(2*c*(1 - 1/u), u, oo)
    = 2*c
"""
lines_bound = """
    < (2*x + 2*c)/(1 + x/c)
    = 2*c
"""

# %% right: l'Hopital and a chain in pieces
lines_psi = [
    "Derivative(2*c*x, x) - Derivative(2*c**2*log(1 + x/c), x)",
    "2*c - 2*c**2*(1/c)/(1 + x/c)",
    "2*c - 2*c/(1 + x/c)",
    "2*c*(x/c)/(1 + x/c)",
    "2*x/(1 + x/c)",
]
lines_limit = """
= Limit(2/(1/c), x, oo)
= 2*c
"""
lines_bound = """
= 2/(1/x + 1/c)
< 2/(1/c)
= 2*c
"""
weight = "c/(c + x)"

# %% right: quotient by c + x
lines_psi = """
= 2*c**2*(1/c - 1/(c + x))
= 2*c - 2*c**2/(c + x)
= 2*c*x/(c + x)
= 2*x/(1 + x/c)
"""
lines_limit = """
= Limit(2*c*x/(c + x), x, oo)
= Limit(2*c/(c/x + 1), x, oo)
= 2*c/(0 + 1)
= 2*c
"""
lines_bound = """
= 2*c*x/(c + x)
< 2*c*x/x
= 2*c
"""
weight = 1 / (1 + sp.Symbol("x") / sp.Symbol("c"))

# %% wrong: limit just claimed, padded
# says: Rewrite the fraction itself
lines_limit = """
= Limit(4*x/(2 + 2*x/c), x, oo)
= 2*c
"""

# %% wrong: weight with psi over x
# says: you left out the 2 of 2x
weight = "2/(1 + x/c)"
