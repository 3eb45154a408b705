"""Forms of a line: when two lines are the same, in other words."""

from collections import Counter

import sympy as sp
from sympy.matrices.expressions.matexpr import MatrixElement

from .reading import is_matrix, tidy


def key(w):
    """The written form up to the order of terms and factors; nothing is computed."""
    if isinstance(w, sp.MatrixBase):
        return ("Matrix", w.shape, tuple(key(x) for x in w))
    if w.is_Atom or not w.args:
        return ("", str(w))
    parts = [key(a) for a in w.args]
    if isinstance(w, sp.MatMul):  # numbers may move, matrices not
        numbers = [key(a) for a in w.args if not is_matrix(a)]
        parts = sorted(numbers, key=repr) + [key(a) for a in w.args if is_matrix(a)]
    elif isinstance(w, (sp.Add, sp.Mul, sp.Eq, sp.Max, sp.Min, sp.MatAdd, sp.And, sp.Or)):
        parts.sort(key=repr)
    return (w.func.__name__, *parts)


ONE = ("one",)


def normal(w, bound=(), whole=True):
    """A form in which padding cancels: (number, rest), to compare lines by, not to compute with.

    Padding is what can be written into a line without a thought: halves, 2/2, a term that has
    nothing to do with the others and its opposite, brackets, a double transpose or inverse, an
    identity matrix; and around the `whole` line u/u and two minus signs. What an honest move
    leaves behind is kept: x + x, the a*b - a*b of a product multiplied out, p/p within a fraction.
    """
    if isinstance(w, sp.MatrixBase):
        return 1, ("Matrix", w.shape, tuple(normal(x, bound, False) for x in w))
    if getattr(w, "is_Rational", False):
        return w, ONE
    if isinstance(w, sp.Add | sp.MatAdd):
        return _normal_sum([normal(a, bound, False) for a in w.args])
    if isinstance(w, sp.Mul | sp.MatMul | sp.Pow):
        return _normal_product(w, bound, whole)
    if isinstance(w, sp.Transpose | sp.Inverse) and type(w.arg) is type(w):
        return normal(w.arg.arg, bound, whole)
    if isinstance(w, MatrixElement) and tuple(w.parent.shape) == (1, 1):
        return normal(w.parent, bound, whole)
    if w.is_Atom or not w.args:
        return 1, ("", f"#{bound.index(w)}" if w in bound else str(w))
    if isinstance(w, sp.Sum | sp.Product | sp.Integral | sp.Subs):
        bound = (*w.variables, *bound)
    parts = [normal(a, bound, isinstance(w, sp.Rel)) for a in w.args]
    if isinstance(w, sp.Eq | sp.And | sp.Or | sp.Max | sp.Min):
        parts.sort(key=repr)
    return 1, (w.func.__name__, *parts)


def _normal_sum(terms):
    numbers = {}
    for c, rest in terms:
        inner = rest[1] if rest[0] == "Add" and abs(c) == 1 else ((1, rest),)
        for d, part in inner:
            numbers.setdefault(part, []).append(c * d)
    pairs = []
    for part, found in numbers.items():
        total, others = sum(found), [p for p in numbers if p != part]
        foreign = part == ONE or not _factors(part) <= {f for p in others for f in _factors(p)}
        halves = any(sp.denom(n) != 1 for n in found)
        found = [total] if halves or (foreign and total in (-1, 0, 1)) else found
        pairs += [(n, part) for n in found if n]
    pairs.sort(key=lambda p: (repr(p[1]), repr(p[0])))
    if len(pairs) < 2:
        return pairs[0] if pairs else (0, ONE)
    below = sp.ilcm(*[sp.denom(n) for n, _ in pairs])
    scale = below if pairs[0][0] > 0 else -below
    return sp.Rational(1, scale), ("Add", tuple((n * scale, part) for n, part in pairs))


def _factors(part):
    """Return the factors of a term, each with whether it stands above the line."""
    if part[0] in ("Mul", "MatMul"):
        return {(p, n > 0) for p, n in part[1]} | {(m, True) for ms in part[2:] for m in ms}
    return {(part, True)}


def _normal_product(w, bound, whole):
    number, powers, matrices = sp.Integer(1), Counter(), []
    args = [w] if isinstance(w, sp.Pow) else w.args
    for a in args:
        base, n = a.args if isinstance(a, sp.Pow) and a.exp.is_Integer else (a, 1)
        if isinstance(base, sp.Pow):  # x**y: a factor of its own
            c, rest = 1, ("Pow", *[normal(x, bound, False) for x in base.args])
        else:
            c, rest = normal(base, bound, False)
        if c == 0 and n < 0:
            c, rest = 1, ("", "1/0")
        number *= sp.sympify(c) ** n
        if is_matrix(a) and tuple(a.shape) != (1, 1):
            scalars, inner = rest[1:] if rest[0] == "MatMul" else ((), (rest,))
            matrices += inner
        else:
            scalars = rest[1] if rest[0] == "Mul" else ((rest, 1),)
        for part, m in scalars:
            powers[part, None if whole else m * n > 0] += int(m * n)
    if not whole and sum(a.is_number and a.is_negative is True for a in args) > 1:
        powers[("--",), True] = 1
    matrices = [m for m in matrices if not _is_identity(m)] or matrices[:1]
    factors = [(p, n) for (p, _), n in powers.items() if n and p != ONE]
    factors = tuple(sorted(factors, key=repr))
    if matrices and (factors or matrices[1:]):
        return number, ("MatMul", factors, tuple(matrices))
    if matrices:
        return number, matrices[0]
    if len(factors) == 1 and factors[0][1] == 1:
        return number, factors[0][0]
    return number, ("Mul", factors) if factors else ONE


def _is_identity(rest):
    return rest[0] == "Matrix" and rest == normal(sp.eye(*rest[1]))[1]


def solved_for(w):
    """Return the symbol that an equation is solved for: alone on one side, not on the other."""
    sides = w.args if isinstance(w, sp.Eq) else ()
    pairs = zip(sides, sides[::-1], strict=True)
    return next((x for x, y in pairs if x.is_Symbol and x not in y.free_symbols), None)


def operators(w):
    """Return which operators in a line are still to be carried out."""
    return {type(x) for x in w.atoms(sp.Sum, sp.Product, sp.Integral, sp.Derivative, sp.Subs)}


def form(w):
    """Return the form of a line: up to order, signs, numbers and the names of bound indices."""
    w = tidy(w)
    if w.has(sp.Sum, sp.Product, sp.Integral):
        w = w.as_dummy()
    return key(w.canonical if isinstance(w, (sp.Gt, sp.Lt, sp.Ge, sp.Le)) else w)
