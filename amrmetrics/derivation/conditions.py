"""What a line needs in order to mean something, collected before anything cancels."""

import sympy as sp

from .proving import nonzero, positive
from .reading import is_matrix, tidy
from .refuting import names_in


def conditions(lines, model):
    """Conditions such as ``x != 0`` that the lines need and that the domain does not imply."""
    found = {}
    for w in lines:
        if w is not None:
            _walk(w, set(), None, found)
    return tuple(text for text, (kind, parts) in found.items() if not _implied(kind, parts, model))


def _walk(w, bound, derived, found):
    if isinstance(w, (sp.Sum, sp.Product, sp.Integral, sp.Subs)):
        bound = bound | {v.name for v in w.variables}
    if isinstance(w, sp.Derivative):
        derived = names_in(w.expr) if derived is None else derived
    for text, kind, parts in _needs(w, derived):
        free = set().union(*(p.free_symbols for p in parts))
        if free and not {getattr(s, "name", "") for s in free} & bound:
            found.setdefault(text, (kind, parts))
    for a in w.args if not isinstance(w, sp.MatrixBase) else list(w):
        if isinstance(a, sp.Basic):
            _walk(a, bound, derived, found)


def _positive(w, strict):
    """`w` > 0 or >= 0, said of the simplest thing that it depends on."""
    w = tidy(w)
    while True:
        if isinstance(w, sp.Abs) or (isinstance(w, sp.Pow) and w.exp.is_even and w.exp.is_positive):
            if strict:
                yield f"{show(w.args[0])} != 0", "nonzero", (w.args[0],)
            return
        if isinstance(w, sp.Pow) and w.exp.is_Rational and w.exp > 0:
            w = w.base
            continue
        break
    yield f"{show(w)} {'>' if strict else '>='} 0", "positive" if strict else "nonnegative", (w,)


def _needs(w, derived):
    if isinstance(w, sp.Pow) and not is_matrix(w):
        whole, negative = w.exp.is_Integer, (w.exp.is_Rational and w.exp < 0) or _minus(w.exp)
        if whole and negative:
            yield f"{show(w.base)} != 0", "nonzero", (w.base,)
        elif w.exp.is_Rational and not whole:
            yield from _positive(w.base, negative)
        elif not whole and not w.base.is_number:
            yield from _positive(w.base, True)
    elif isinstance(w, sp.log):
        yield from _positive(w.args[0], True)
    elif isinstance(w, sp.atan2):
        yield f"({show(w.args[0])}, {show(w.args[1])}) != (0, 0)", "pair", w.args
    elif isinstance(w, sp.tan):
        yield f"cos({show(w.args[0])}) != 0", "nonzero", (sp.cos(w.args[0], evaluate=False),)
    elif isinstance(w, (sp.asin, sp.acos)):
        yield f"|{show(w.args[0])}| <= 1", "unit", w.args
    elif isinstance(w, sp.Inverse):
        yield f"det({show(w.args[0])}) != 0", "nonzero", (sp.Determinant(w.args[0]),)
    if derived is not None and isinstance(w, (sp.Abs, sp.sign)):
        yield f"{show(w.args[0])} != 0", "nonzero", (w.args[0],)
    if derived is not None and isinstance(w, (sp.Max, sp.Min)):
        a, b = w.args[0], w.args[-1]
        yield (
            f"{show(a)} != {show(b)}",
            "nonzero",
            (sp.Add(a, sp.Mul(-1, b, evaluate=False), evaluate=False),),
        )


def _minus(e):
    return e.could_extract_minus_sign() and e.is_number


def show(w):
    return sp.sstr(tidy(w))


def _implied(kind, parts, model):
    values = [model.evaluated(p) for p in parts]
    if kind == "pair":
        return any(nonzero(v, model) for v in values)
    (e,) = values
    if kind == "nonzero":
        return nonzero(e, model)
    if kind == "unit":
        return positive(1 - e**2, model, strict=False)
    return positive(e, model, strict=kind == "positive")
