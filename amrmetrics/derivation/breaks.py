"""Where a formula breaks, bends or jumps: one table for conditions, search and proofs."""

import sympy as sp

from .reading import is_claim, is_matrix, tidy

BENT = (sp.Abs, sp.sign, sp.Max, sp.Min, sp.floor, sp.ceiling, sp.Mod, sp.Heaviside, sp.Piecewise)


def minus(a, b):
    return a if b == 0 else sp.Add(a, sp.Mul(-1, b, evaluate=False), evaluate=False)


def needs(w, model=None, ways=({},)):
    """Yield (kind, formulas) for what the node `w` itself needs in order to have a value.

    `ways` are what the letters of sums and products may be exchanged for, see `proving`.
    Kinds: ``nonzero``, ``positive``, ``nonnegative``, ``unit`` (at most 1 in size), ``pair`` (not
    both zero), ``gamma`` (no whole number below 1).
    """
    if isinstance(w, sp.Pow) and not is_matrix(w):
        negative = w.exp.is_number and w.exp.could_extract_minus_sign()
        if w.exp.is_Integer:
            if negative:
                yield "nonzero", (w.base,)
        elif w.exp.is_Rational:
            yield "positive" if negative else "nonnegative", (w.base,)
        elif not w.base.is_positive:
            exponent = w.exp if model is None else model.evaluated(w.exp)
            exponents = [exponent.subs(way) for way in ways]
            if not all(e.is_integer for e in exponents):
                yield "positive", (w.base,)
            elif not any(e.is_nonnegative for e in exponents):
                yield "nonzero", (w.base,)
    elif isinstance(w, sp.log):
        yield "positive", w.args
    elif isinstance(w, sp.atan2):
        yield "pair", w.args
    elif isinstance(w, sp.tan):
        yield "nonzero", (sp.cos(w.args[0], evaluate=False),)
    elif isinstance(w, sp.cot):
        yield "nonzero", (sp.sin(w.args[0], evaluate=False),)
    elif isinstance(w, sp.asin | sp.acos):
        yield "unit", w.args
    elif isinstance(w, sp.gamma | sp.loggamma | sp.digamma):
        yield "gamma", w.args
    elif isinstance(w, sp.factorial):
        yield "gamma", (sp.Add(w.args[0], 1, evaluate=False),)
    elif isinstance(w, sp.Mod):
        yield "nonzero", (w.args[1],)
    elif isinstance(w, sp.Inverse):
        yield "nonzero", (sp.Determinant(w.args[0]),)


def bends(w):
    """Return the formulas at whose zeros the node `w` has a kink, a jump or a lowest place."""
    if isinstance(w, sp.Max | sp.Min):
        pairs = [(a, b) for k, a in enumerate(w.args) for b in w.args[k + 1 :]]
        return [minus(a, b) for a, b in pairs]
    if isinstance(w, sp.Abs | sp.sign | sp.Heaviside):
        return [w.args[0]]
    if isinstance(w, sp.floor | sp.ceiling):
        return [sp.sin(sp.Mul(sp.pi, w.args[0], evaluate=False), evaluate=False)]
    if isinstance(w, sp.Rel) and not is_matrix(w.lhs) and not is_claim(w.lhs):
        return [minus(w.lhs, w.rhs)]
    if isinstance(w, sp.atan2):
        return [w.args[0]]
    if isinstance(w, sp.Pow) and w.exp.is_Integer and w.exp.is_even and w.exp > 0:
        return [w.base]  # where a square is smallest, a narrow peak may be
    return []


def edges(kind, parts):
    """Return the formulas at whose zeros what is needed begins to fail."""
    if kind == "unit":
        return [sp.Add(parts[0], s, evaluate=False) for s in (-1, 1)]
    return [g for part in parts for g in _factors(part)]


def _factors(g):
    """Return what vanishes where a product or power does: its factors, which change their sign."""
    if isinstance(g, sp.Mul):
        return [f for part in g.args for f in _factors(part)]
    if isinstance(g, sp.Pow) and g.exp.is_positive:
        return _factors(g.base)
    return [g]


def nodes(w, bound=None):
    """Yield every node of a written form with the letters bound where it stands: (scope, ends)."""
    bound = bound or {}
    yield w, bound
    if isinstance(w, sp.MatrixBase):
        for x in w:
            yield from nodes(x, bound)
        return
    if isinstance(w, sp.Sum | sp.Product | sp.Integral):
        bound = {**bound, **{letter: (w.func, *ends) for letter, *ends in w.limits}}
    elif isinstance(w, sp.Subs):
        bound = {**bound, **{letter: (w.func,) for letter in w.variables}}
    elif isinstance(w, sp.Limit):
        bound = {**bound, w.args[1]: (w.func,)}
    for x in w.args:
        if isinstance(x, sp.Basic):
            yield from nodes(x, bound)


def breaks(w, only=None):
    """Return the formulas at whose zeros `w` breaks, bends or jumps, without bound letters.

    With `only`, those that depend on this one letter and stand in no scope of their own.
    """
    found = {}
    for node, bound in nodes(w):
        for kind, parts in needs(node):
            found |= dict.fromkeys((g, frozenset(bound)) for g in edges(kind, parts))
        found |= dict.fromkeys((g, frozenset(bound)) for g in bends(node))
    if only is None:
        found |= dict.fromkeys((e, frozenset()) for node, _ in nodes(w) for e in _at_ends(node))
    free = [g for g, bound in found if g.free_symbols and not g.free_symbols & bound]
    if only is not None:
        return [g for g in dict.fromkeys(free) if only in g.free_symbols]
    return [g for g in dict.fromkeys(free) if not g.has(sp.Integral, sp.Derivative, sp.Limit)]


def _at_ends(w):
    """Return where the integrand breaks or bends just at an end of the range."""
    if not isinstance(w, sp.Integral) or len(w.limits) != 1 or w.function.has(sp.Integral):
        return []
    letter, *ends = w.limits[0]
    inside = breaks(w.function, only=letter)
    return [g.subs(letter, e) for g in inside for e in ends if e not in (sp.oo, -sp.oo)]


def show(w):
    """Write a formula in words that a reader knows, bound letters under their names."""
    w = tidy(w)
    letters = {d: sp.Symbol(d.name) for d in w.atoms(sp.Dummy)}
    return sp.sstr(w.xreplace(letters) if letters else w)
