"""What a student is told: the simplest counterexample, how the sides differ; never the answer."""

from fractions import Fraction

import sympy as sp
from mpmath import libmp

from .arithmetic import Undefined, middle
from .breaks import show
from .evaluating import flat, value
from .limits import bounded
from .reading import is_claim, rebuild
from .searching import FAILURES, Root, Solved

PLACES = {
    "wild": "very small and very large values",
    "whole": "whole numbers one by one and up to {}",
    "break": "both sides of every place where a line bends or breaks",
    "zero": "zeros",
    "downhill": "downhill from the closest points",
}


def where(search):
    """Say of what was only sampled where it was tried."""
    places = [w.format(search.largest) for place, w in PLACES.items() if place in search.places]
    tail = f", also at {', '.join(places)}" if places else ""
    return f"agrees at the points tried{tail} (not a proof)"


def refutation(search):
    from .checking import Verdict

    values = simplest(search)
    _, seen, entries = search.found
    shown = witness(search, values, entries)
    place = ", ".join(f"{n} = {v}" for n, v in shown.items()) or "any point"
    kind, p, q = (*seen, None, None)[:3]
    if kind in ("lost", "gained"):
        line = (
            "in the line before but not in the line after"
            if p
            else "in the line after but not before"
        )
        text = f"wrong: {place} holds {line}: a solution is {kind}"
        return Verdict("refuted", text, shown, sp.sympify(p), sp.sympify(q))
    if kind == "claim" and p is None:
        return Verdict("refuted", f"wrong: at {place} the claim does not hold", shown)
    a, b = told_apart(p, q)
    if kind == "shrunk":
        text = f"at {place} the line before is {a}, but the line after is not defined"
    elif kind == "diverges":
        text = f"at {place} the line before has no finite value, but the line after is {b}"
    elif kind == "claim" and str(a) == str(b):
        text = f"at {place} both sides are {a}"
    elif kind == "claim":
        text = f"at {place} the left side is {a} and the right side is {b}"
    else:
        _, words = bounded(lambda: difference_in_words(search), 0.6)
        text = f"at {place} the line before is {a} and the line after is {b}.{words or ''}"
    return Verdict("refuted", f"wrong: {text}", shown, a, b)


def simplest(search):
    """Exchange one value after another for a simpler one, as long as the step stays refuted."""
    values, seen, entries = search.found
    search.budget.left = 20_000
    for n in [n for n in values if n]:
        if isinstance(values[n], Root | Solved) or n not in search.domains:
            continue
        for v in search.domains[n].simple():
            if v == values[n]:
                break
            if search.wrong_at({**values, n: v}) and search.found[1][0] == seen[0]:
                values, seen, entries = search.found
                break
            search.found = values, seen, entries
    return values


def number(x, digits=8):
    """A number as one writes it: 3, 2/7, 0.5403."""
    if isinstance(x, list):
        return sp.ImmutableMatrix([[number(a, digits) for a in row] for row in x])
    if isinstance(x, sp.Expr):
        return x
    if isinstance(x, Fraction):
        if abs(x.numerator) < 10**6 and x.denominator < 10**4:
            return sp.Rational(x)
        x = libmp.from_rational(x.numerator, x.denominator, 400)
    else:
        x = middle(x, 400)
    _, _, exponent, bits = x
    if exponent + bits > 40:  # no whole number that one writes; to write it out takes all memory
        return sp.Float(libmp.to_str(x, digits), digits)
    for q in (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 20, 24, 25, 50, 100):
        y = libmp.mpf_mul_int(x, q, 400)
        p = libmp.to_int(y, "n")
        gap = libmp.mpf_abs(libmp.mpf_sub(y, libmp.from_int(p), 400))
        if (
            abs(p) < 10**6
            and libmp.mpf_lt(gap, libmp.from_float(1e-25))
            and (p or x == libmp.fzero)
        ):
            return sp.Rational(p, q)
    return sp.Float(libmp.to_str(x, digits), digits)


def told_apart(p, q):
    """Return both values with as many digits as it takes to see that they differ."""
    a, b = (sp.nan if isinstance(x, Undefined) else number(x) for x in (p, q))
    if isinstance(p, list | Undefined):
        return a, b
    for digits in (16, 32, 64, 128):
        if str(a) != str(b):
            break
        a, b = (decimal(x, digits) for x in (p, q))
    return (number(p), number(q)) if str(a) == str(b) else (a, b)


def decimal(x, digits):
    raw = middle(x, 4 * digits + 40)
    return sp.Float(libmp.to_str(raw, digits), digits)


def witness(search, values, entries):
    shown = {}
    for n, v in values.items():
        if not n or n not in search.domains:
            continue
        if isinstance(v, Root | Solved):
            v = v.start
        if isinstance(v, sp.Lambda):
            shown[n] = v
        elif v is not None:
            shown[n] = number(v)
    for (name, index), v in sorted(entries.items(), key=str):
        shown[f"{name}[{', '.join(map(str, index))}]"] = number(v)
    return shown


def compared(search, after=None, points=6):
    """Return pairs (before, after) of values at points where the lines can be compared."""
    pairs = []
    for k in range(2 if search.rough else points):
        values = search._drawn(600 + k, "fraction")
        try:
            at = search.point(values, 200)
            sides = [
                value(w, at) for w in (search.before, search.after if after is None else after)
            ]
            sides = [[at.arithmetic.number(x) for x in flat(v)] for v in sides]
        except (Undefined, *FAILURES):
            continue
        pairs += zip(*sides, strict=True)
    return pairs


def constant(numbers):
    first = numbers[0]
    return len(numbers) > 1 and all(abs(x - first) < 1e-12 * (1e-30 + abs(first)) for x in numbers)


def difference_in_words(search):
    """Say how the sides differ, if it is the same everywhere: sign, factor, N - 1, one term."""
    if is_claim(search.after) or not search.domains:
        return ""
    search.budget.left = 60_000
    pairs = [(x, y) for x, y in compared(search) if x or y]
    if len(pairs) < 3 or any(abs(x - y) < 1e-12 * abs(x) for x, y in pairs):
        return ""
    if all(x and y for x, y in pairs) and constant([y / x for x, y in pairs]):
        return _factor(pairs[0][1] / pairs[0][0])
    for n, d in search.domains.items():
        for k in (-1, 1) if d.whole and n not in search.sized else ():
            moved = rebuild(
                search.after, lambda w, n=n, k=k: w + k if w.is_Symbol and w.name == n else None
            )
            again = compared(search, moved)
            if again and all(abs(x - y) < 1e-12 * (1e-30 + abs(x)) for x, y in again):
                other = f"{n} {'+' if k > 0 else '-'} 1"
                return f" They would be equal if {n} in the line after were {other}."
    if isinstance(search.after, sp.Add):
        for term in search.after.args:
            share = [
                ((x - y), t)
                for (x, y), (_, t) in zip(compared(search), compared(search, term), strict=False)
            ]
            if len(share) > 2 and all(t for _, t in share) and constant([d / t for d, t in share]):
                return (
                    f" The difference is a multiple of the term {show(term)}: look at its factor."
                )
    if constant([y - x for x, y in pairs]):
        return " The two sides differ by a number that does not depend on any symbol."
    return ""


def _factor(ratio):
    for r in (ratio, 1 / ratio):
        n = number((r._mpf_, r._mpf_))
        if n == -1:
            return " The two sides differ by the sign."
        if n.is_Rational and abs(n) > 1:
            return f" The two sides differ by a factor {n}."
    return f" The two sides differ by a factor, about {sp.Float(str(ratio), 4)}."
