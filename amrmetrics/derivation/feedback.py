"""What a student is told: the simplest counterexample, how the sides differ; never the answer."""

import mpmath
import sympy as sp

from .evaluating import Undefined, Unreliable, flat
from .reading import tidy
from .refuting import Root, Solved, rebuild


def simplest(search, check, values):
    """Exchange one value after another for a simpler one, as long as the step stays refuted."""
    kind = search.found[1][0]
    for n in [n for n in values if n]:
        for v in search.domains[n].simple() if not isinstance(values[n], (Root, Solved)) else []:
            if v == values[n]:
                break
            keep = search.found, search.used
            if check({**values, n: v}) and search.found[1][0] == kind:
                values = {**values, n: v}
                break
            search.found, search.used = keep
    return values


def number(x, digits=8):
    """A number as one writes it: 3, 2/7, 0.5403."""
    if isinstance(x, list):
        return sp.ImmutableMatrix([[number(a, digits) for a in row] for row in x])
    if x is None or isinstance(x, str):
        return sp.nan
    with mpmath.workdps(40):
        x = mpmath.mpf(x)
        for q in (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 20, 24, 25, 50, 100):
            p = mpmath.nint(x * q)
            if abs(x * q - p) < mpmath.mpf(10) ** -25 and abs(p) < 10**6 and (p or not x):
                return sp.Rational(int(p), q)
        return sp.Float(mpmath.nstr(x, digits), digits)


def witness(search, values):
    shown = {}
    for n, v in values.items():
        if not n or n not in search.domains:
            continue
        if search.domains[n].kind == "index":
            continue
        shown[n] = (
            number(v.start)
            if isinstance(v, (Root, Solved))
            else v.expr
            if isinstance(v, sp.Lambda)
            else v
        )
    k = values[""][0]
    for (point, name, index), v in sorted(search.used.items(), key=str):
        if point == k:
            shown[f"{name}[{', '.join(map(str, index))}]"] = v
    return shown


def compared(search, after=None, points=6):
    """Return pairs (before, after) of values at points where the lines can be compared."""
    kept, pairs = search.after, []
    search.after = kept if after is None else after
    try:
        for k in range(2 if search.slow else points):
            try:
                seen = search.look(search.draw(500 + k, "fraction"), search.digits)
            except (Unreliable, Undefined, ValueError, ZeroDivisionError, OverflowError):
                continue
            if seen[0] in ("equal", "different"):
                pairs += zip(flat(seen[1]), flat(seen[2]), strict=True)
    finally:
        search.after = kept
    return pairs


def constant(numbers):
    return len(numbers) > 1 and max(abs(x - numbers[0]) for x in numbers) < 1e-12 * (
        1 + abs(numbers[0])
    )


def difference_in_words(search):
    """Say how the sides differ, if it is the same everywhere: sign, factor, N - 1, one term."""
    pairs = [(x, y) for x, y in compared(search) if x or y]
    if not search.domains or len(pairs) < 2 or any(x == y for x, y in pairs):
        return ""
    if all(x and y for x, y in pairs) and constant([y / x for x, y in pairs]):
        r = number(pairs[0][1] / pairs[0][0])
        if r == -1:
            return " The two sides differ by the sign."
        r = r if abs(r) > 1 else number(pairs[0][0] / pairs[0][1])
        return (
            f" The two sides differ by a factor {r}."
            if r.is_Rational
            else f" The two sides differ by a factor, about {sp.Float(r, 4)}."
        )
    for n, d in search.domains.items():
        if d.kind == "int":
            for k in (-1, 1):
                moved = rebuild(
                    search.after, lambda w, n=n, k=k: w + k if w.is_Symbol and w.name == n else None
                )
                again = compared(search, moved)
                if again and all(abs(x - y) < 1e-12 * (1 + abs(x)) for x, y in again):
                    other = f"{n} {'+' if k > 0 else '-'} 1"
                    return f" They would be equal if {n} in the line after were {other}."
    if isinstance(search.after, sp.Add):
        for term in search.after.args:
            values = compared(search, term)
            share = [(x - y, t) for (x, y), (_, t) in zip(compared(search), values, strict=False)]
            if len(values) > 1 and all(t for _, t in share) and constant([d / t for d, t in share]):
                name = sp.sstr(tidy(term))
                return f" The difference is a multiple of the term {name}: look at its factor."
    if constant([y - x for x, y in pairs]):
        return " The two sides differ by a number that does not depend on any symbol."
    return ""
