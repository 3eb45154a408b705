# %% wrong: nothing but the results
lines_psi = ["2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the derivative of the logarithm without the inner one
lines_psi = """
    = 2*k**2*(1/k - 1/(1 + x/k))
    = 2*x/(1 + x/k)
"""
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the first term does not become a constant
lines_psi = """
    = 2*k**2*(x/k - 1/(k*(1 + x/k)))
    = 2*x/(1 + x/k)
"""
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: leaps to the result, rewritten once
lines_psi = ["2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: takes the constant out, then leaps
lines_psi = ["2*k**2*Derivative(x/k - log(1 + x/k), x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: pads with plus and minus the same
lines_psi = ["2*x/(1 + x/k) + k - k", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: pads with a factor 2/2
lines_psi = ["2*2*x/(2*(1 + x/k))", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: stops before the fraction is one
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the weight is the influence function
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "2*x/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the weight without the half
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "2/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the weight is the curvature
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)**2"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the weight of Cauchy's kernel
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x**2/k**2)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the derivative is left in the weight
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "Derivative(2*k**2*(x/k - log(1 + x/k)), x)/(2*x)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the limit is read off
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the limit of a fraction that still is infinity over infinity
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2*k*x/(k + x), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: x is put to infinity in numerator and denominator
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2*x, x, oo)/Limit(1 + x/k, x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: l'Hopital by the quotient rule
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1 + x/k)**2, x, oo)", "0"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the limit without k
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the bound is claimed
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*k"

# %% wrong: the bound is claimed, padded
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "= 2*2*x/(2*(1 + x/k))\n < 2*k"

# %% wrong: the bound is claimed, padded behind
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*k + k - k\n = 2*k"

# %% wrong: the limit of the result
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2*k, x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the two halves, then a leap
lines_psi = ["x/(1 + x/k) + x/(1 + x/k)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: the logarithm is taken apart, then a leap
lines_psi = ["Derivative(2*k**2*(x/k - log(k + x) + log(k)), x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x/(x/k)\n = 2*k"

# %% wrong: a denominator that is smaller makes the fraction smaller
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "> 2*x/(x/k)\n = 2*k"

# %% wrong: the bound as an equation
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = ["2*x/(x/k)", "2*k"]

# %% wrong: the bound of small x
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = "< 2*x\n < 2*k"

# %% wrong: the last part is missing
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*k*x/(k + x)", "2*x/(1 + x/k)"]
weight = "1/(1 + x/k)"
lines_limit = ["Limit(2/(1/x + 1/k), x, oo)", "2*k"]
lines_bound = ...

# %% right: three lines, the fraction put together in between
lines_psi = """
    = 2*k**2*(1/k - (1/k)/(1 + x/k))   # chain rule
    = 2*k*(1 + x/k - 1)/(1 + x/k)      # one fraction
    = 2*x/(1 + x/k)                    # cancel
"""
weight = "k/(k + x)"
lines_limit = """
    = Limit(2*k - 2*k/(1 + x/k), x, oo)   # divide with remainder
    = 2*k                                 # the rest vanishes
"""
lines_bound = """
    = 2*k - 2*k/(1 + x/k)   # divide with remainder
    < 2*k                   # the rest is positive
"""

# %% right: derivatives of each term, l'Hopital, lists of pairs
lines_psi = [
    ("2*k**2*(Derivative(x/k, x) - Derivative(log(1 + x/k), x))", "linear"),
    ("2*k**2*(1/k - 1/(k + x))", "chain rule"),
    ("2*k - 2*k**2/(k + x)", "multiply out"),
    ("2*k*x/(k + x)", "one fraction"),
    ("2*x/(1 + x/k)", "divide by k"),
]
weight = "1/(1+x/k)"
lines_limit = [
    ("Limit(Derivative(2*x, x)/Derivative(1 + x/k, x), x, oo)", "l'Hopital"),
    ("2/(1/k)", "no x left"),
    ("2*k", ""),
]
lines_bound = [("= 2*k*x/(k + x)", "times k"), ("< 2*k*x/x", "smaller below"), ("= 2*k", "cancel")]

# %% right: SymPy objects
import sympy as sp

x, k = sp.symbols("x k", positive=True)
psi = 2 * x / (1 + x / k)
lines_psi = [2 * k**2 * (1 / k - 1 / (k + x)), 2 * k * (1 - k / (k + x)), psi]
weight = sp.simplify(psi / (2 * x))
lines_limit = [sp.Limit(2 / (1 / x + 1 / k), x, sp.oo), 2 * k]
lines_bound = "= 2*k*(x/(k + x))\n < 2*k*1\n = 2*k"

# %% right: the given lines repeated, other names of the limit
lines_psi = """
    Derivative(2*k**2*(x/k - log(1 + x/k)), x)
    = 2*k**2*(1/k - (1/k)*(1/(1 + x/k)))
    = 2*k*(1 - 1/(1 + x/k))
    = 2*k*((x/k)/(1 + x/k))
    = 2*x/(1 + x/k)
"""
weight = "(2*x/(1 + x/k))/(2*x)"
lines_limit = """
    Limit(2*x/(1 + x/k), x, oo)
    = 2*Limit(x/(1 + x/k), x, oo)
    = 2*Limit(1/(1/x + 1/k), x, oo)
    = 2*(1/(0 + 1/k))
    = 2*k
"""
lines_bound = """
    2*x/(1 + x/k)
    < 2*x/(x/k)     # leave out the 1
    = 2*k
"""

# %% right: rows without signs, a strict step after a loose one
lines_psi = """
    2*k**2*Derivative(x/k - log(1 + x/k), x)
    2*k**2*(1/k - 1/(k*(1 + x/k)))
    2*k**2*((1 + x/k) - 1)/(k*(1 + x/k))
    2*x/(1 + x/k)
"""
weight = "1 - x/(k + x)"
lines_limit = """
    Limit(2*k/(k/x + 1), x, oo)
    2*k/(0 + 1)
    2*k
"""
lines_bound = """
    = 2*k*x/(x + k)
    <= 2*k*(x + k/2)/(x + k)
    < 2*k
"""

# %% right: another variable in the limit
lines_psi = ["2*k**2*(1/k - 1/(k + x))", "2*k*(1 - k/(k + x))", "2*x/(1 + x/k)"]
weight = "1/(x/k + 1)"
lines_limit = ["Limit(2*k*u/(1 + u), u, oo)", "Limit(2*k/(1/u + 1), u, oo)", "2*k"]
lines_bound = "= 2*k*(x/k)/(1 + x/k)\n < 2*k*(1 + x/k)/(1 + x/k)\n = 2*k"

# %% right: t = 1/x, and diff for a derivative
lines_psi = """
    = 2*k**2*(diff(x/k, x) - diff(log(1 + x/k), x))   # term by term
    = 2*k**2*(1/k - 1/(k + x))                        # chain rule
    = 2*k*x/(k + x)                                   # one fraction
    = 2*x/(x/k + 1)                                   # divide by k
"""
weight = "(1 + x/k)**-1"
lines_limit = ["Limit(2/(t + 1/k), t, 0)", "2/(1/k)", "2*k"]
lines_bound = ["= 2*k*x/(k + x)", "< 2*k*(x + k)/(k + x)", "= 2*k"]
