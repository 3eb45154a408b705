"""Looking for a counterexample: many points, every branch and edge, a second look each time."""

import random
import time
from itertools import chain

import mpmath
import sympy as sp
from mpmath import mp
from sympy.core.function import AppliedUndef

from .evaluating import (
    KINKED,
    Point,
    Undefined,
    Unreliable,
    add,
    determinant,
    flat,
    gap,
    inverse,
    product,
    truth,
    value,
)
from .limits import bounded
from .reading import SHAPES, is_claim, is_matrix

STYLES = ["small"] * 7 + ["fraction"] * 9 + ["below", "above"] * 2 + ["wild"] * 4 + ["edge"] * 6
HALF = ("root", "log", "arc", "piecewise")  # undefined in these ways on a whole part of the domain
SOFT = ("atan2", "kink")  # undefined in these ways is a condition of the step, never a refutation


def rebuild(w, leaf):
    """`w` with some nodes exchanged, everything else as written."""
    new = leaf(w)
    if new is not None:
        return new
    if w.is_Atom or not w.args:
        return w
    if isinstance(w, sp.MatrixBase):
        return w.applyfunc(lambda x: rebuild(x, leaf))
    args = [rebuild(a, leaf) for a in w.args]
    if all(a is b for a, b in zip(args, w.args, strict=True)):
        return w
    keep = isinstance(w, (sp.Add, sp.Mul, sp.Pow, sp.MatAdd, sp.MatMul, sp.Rel)) or (
        isinstance(w, sp.Function) and not isinstance(w, (AppliedUndef, sp.Piecewise))
    )
    return w.func(*args, evaluate=False) if keep else w.func(*args)


class Root:
    """A zero of `g` in the variable `name` near `start`, as exact as the precision in use."""

    def __init__(self, g, name, start, shift=None):
        self.g, self.name, self.start = g, name, start

    def at(self, point):
        def f(x):
            return value(self.g, point.bind(self.name, x))

        try:
            x = mpmath.findroot(
                f,
                (self.start, self.start + abs(self.start) * 1e-12 + mpmath.mpf(10) ** -18),
                verify=False,
            )
        except (ZeroDivisionError, ValueError, Undefined):
            raise Unreliable("a root that cannot be refined") from None
        if abs(x - self.start) > 1e-6 * (1 + abs(self.start)):
            raise Unreliable("a root that moved")
        return x


class Solved:
    """The solution of one equation for a matrix or a vector: given outright, or linear."""

    def __init__(self, equation, name):
        self.equation, self.name, self.start = equation, name, None

    def at(self, point):
        for one, other in (
            (self.equation.lhs, self.equation.rhs),
            (self.equation.rhs, self.equation.lhs),
        ):
            if (
                isinstance(one, (sp.Symbol, sp.MatrixSymbol))
                and one.name == self.name
                and not other.has(one)
            ):
                self.start = value(other, point)
                return self.start
        rows = SHAPES.get(point.kind(self.name), (0, 0))
        if rows[1] != 1:
            raise Unreliable("not a vector")
        n = rows[0]

        def f(*x):
            at = point.bind(self.name, [[c] for c in x])
            return [
                a - b
                for a, b in zip(*(flat(value(w, at)) for w in self.equation.args), strict=True)
            ]

        zero = f(*[mp.zero] * n)
        columns = [
            [a - b for a, b in zip(f(*[mpmath.mpf(i == k) for i in range(n)]), zero, strict=True)]
            for k in range(n)
        ]
        if len(zero) != n or determinant(columns) == 0:
            raise Unreliable("no unique solution")
        back = product([[-z for z in zero]], inverse(columns))[0]
        if any(abs(r) > mpmath.ldexp(1, -int(0.6 * mp.prec)) for r in f(*back)):
            raise Unreliable("not linear")
        self.start = [[x] for x in back]
        return self.start


def to_number(v, point):
    if isinstance(v, (Root, Solved)):
        return v.at(point)
    if isinstance(v, sp.MatrixBase):
        return [[to_number(x, point) for x in row] for row in v.tolist()]
    if v.is_Rational:
        return mpmath.mpf(v.p) / v.q
    return sp.N(v, mp.dps + 10)._to_mpmath(mp.prec)


class Search:
    """Everything tried for one step; `witness` is set when it is refuted."""

    def __init__(self, before, after, model, seed, deadline):
        self.before, self.after, self.model, self.seed = before, after, model, seed
        self.deadline = time.thread_time() + deadline
        lines = [w for w in (before, after) if w is not None]
        used = set()
        for w in lines:
            used |= {s.name for s in w.free_symbols if hasattr(s, "name")} | {
                str(s) for s in w.free_symbols
            }
            used |= {f.func.__name__ for f in w.atoms(AppliedUndef)}
            used |= {str(b.label) for b in w.atoms(sp.IndexedBase)}
        self.domains = {n: d for n, d in model.domains.items() if n in used}
        self.slow = any(w.has(sp.Integral) or w.has(sp.oo) for w in lines)
        self.nested = any(
            len(x.limits) > 1 or x.function.has(sp.Integral)
            for w in lines
            for x in w.atoms(sp.Integral)
        )
        self.digits, self.confirm = (25, 36) if self.slow else (120, 300)
        self.points = 0
        self.undefined = self.enlarged = 0
        self.soft = set()
        self.found = None
        self.entries, self.closed, self.known = {}, {}, {}
        self.suspect = False  # a difference was seen that a second look has not settled
        self.functions = any(d.kind == "function" for d in self.domains.values())

    def expired(self):
        return time.thread_time() > self.deadline

    def draw(self, k, style):
        rng = random.Random(f"{self.seed}/{k}/{style}")
        values = {n: d.draw(rng, style) for n, d in self.domains.items() if d.kind != "seq"}
        return {"": (k, style), **values}

    def zeros(self):
        """Points with all, and with each single, value zero, as far as the domains allow."""
        names = [n for n in self.domains if self.real(n) and self.domains[n].contains(mp.zero)]
        for k, chosen in enumerate([names, *([n] for n in names[:5])]):
            if names:
                yield {**self.draw(200 + k, "fraction"), **dict.fromkeys(chosen, sp.Integer(0))}

    def lines(self, values):
        """Both lines with the abstract functions made concrete."""
        if not self.functions:
            return self.before, self.after

        def leaf(w):
            if isinstance(w, AppliedUndef) and isinstance(values.get(w.func.__name__), sp.Lambda):
                f, args = values[w.func.__name__], [rebuild(a, leaf) for a in w.args]
                result = f.expr.xreplace({f.variables[0]: args[0]})
                for n, a in enumerate(args[1:], 2):
                    result += n * a * args[0] + a**2
                return result
            return None

        return tuple(None if w is None else rebuild(w, leaf) for w in (self.before, self.after))

    def point(self, values):
        k, style = values[""]
        self.entries.clear()

        def entry(name, index):
            key = (k, name, index)
            if key not in self.entries:
                rng = random.Random(f"{self.seed}/{key}")
                self.entries[key] = (
                    self.model.domains[name].draw(rng, style)
                    if name in self.model.domains
                    else sp.Integer(1)
                )
            return to_number(self.entries[key], None)

        def derive(w):
            """The derivative, or the inner of two integrals, in closed form."""
            e = self.model.evaluated(w)
            if not e.has(sp.Integral) or isinstance(w, sp.Derivative):
                return e
            if w not in self.closed:
                self.closed[w] = bounded(lambda: sp.simplify(e.doit()), 1.5)[1]
            if self.closed[w] is None or self.closed[w].has(sp.Integral):
                raise Unreliable("an inner integral without closed form")
            return self.closed[w]

        numbers = {}
        at = Point(numbers, entry, derive, self.known)
        for n, v in values.items():
            if n and not isinstance(v, (Root, Solved, sp.Lambda)):
                numbers[n] = to_number(v, at)
        at.kind = lambda name: self.domains[name].kind
        for n, v in values.items():
            if isinstance(v, Root):
                numbers[n] = self.domains[n].settled(v.at(at))
            elif isinstance(v, Solved):
                numbers[n] = v.at(at)
        return at

    def side(self, w, at):
        try:
            v = value(w, at)
        except Undefined as u:
            return "undefined", u.kind
        if not all(mpmath.isfinite(x) for x in flat(v)):
            raise Unreliable
        return "value", v

    def look(self, values, digits):
        """What the two formulas do at a point: (kind, before, after)."""
        with mpmath.workdps(digits):
            before, after = self.lines(values)
            at = self.point(values)
            a, b = self.side(before, at), self.side(after, at)
            if a[0] == b[0] == "undefined":
                return "undefined", None, None
            if b[0] == "undefined":
                return ("soft" if b[1] in SOFT else "shrunk"), a[1], b[1]
            if a[0] == "undefined":
                return ("soft" if a[1] in SOFT else "enlarged"), a[1], b[1]
            d = gap(a[1], b[1], 0.45 if self.slow else 0.7)
            return ("equal" if d == 0 else "different"), a[1], b[1], d

    def try_point(self, values, generic=False):
        """True if the step is refuted here, after a second look in higher precision."""
        try:
            seen = self.look(values, self.digits)
            if seen[0] == "equal":
                self.points += 1
            elif seen[0] == "undefined":
                self.undefined += 1
            elif seen[0] == "enlarged":
                self.enlarged += generic and seen[1] in HALF
            if seen[0] not in ("different", "shrunk") or self.nested:
                self.suspect = self.suspect or seen[0] in ("different", "shrunk")
                return False
            before, self.suspect = self.suspect, True
            again = self.look(values, self.confirm)
            self.suspect = before
            if again[0] != seen[0]:
                return False
            k = (
                3 if seen[0] == "different" else 1
            )  # the difference, or the value of the line before
            if any(
                abs(x - y) > abs(y) / 1000
                for x, y in zip(flat(seen[k]), flat(again[k]), strict=True)
            ):
                return False
            self.used = dict(self.entries)
            self.found = values, again
            return True
        except (
            Unreliable,
            OverflowError,
            MemoryError,
            ValueError,
            ZeroDivisionError,
            mpmath.libmp.NoConvergence,
        ):
            return False

    def formulas(self):
        """True if refuted."""
        styles = STYLES if not self.slow else ["small"] * 2 + ["fraction"] * 3
        if not self.domains:
            styles = styles[:1]
        for k, style in enumerate(styles):
            if self.expired():
                break
            if self.try_point(self.draw(k, style), generic=style in ("small", "fraction")):
                return True
        for values in chain(self.zeros(), self.surface_points([self.before, self.after])):
            if self.expired():
                break
            if self.try_point(values):
                return True
        return False

    def surface_points(self, lines):
        """Points on, and on both sides of, every surface where something can happen."""
        count = 0
        for g in surfaces(lines):
            names = [n for n in sorted(names_in(g)) if self.real(n)]
            for n in names[:3]:
                for k, style in ((100, "small"), (101, "fraction")):
                    values = self.draw(k + count, style)
                    for r in self.roots(g, n, values):
                        yield from self.around(values, n, r)
                    count += 1
                    if count > 40 or self.expired():
                        return

    def around(self, values, n, r):
        yield {**values, n: r}
        start = r.start if isinstance(r, Root) else to_number(r, None)
        x = sp.Rational(str(mpmath.nstr(start, 12)))
        for near in (
            x * sp.Rational(1, 2),
            x * sp.Rational(3, 2),
            x * 2,
            x - sp.Rational(1, 7),
            x + sp.Rational(1, 7),
            x * sp.Rational(999, 1000),
            x * sp.Rational(1001, 1000),
        ):
            if self.model.domains[n].contains(to_number(near, None)) and near != x:
                yield {**values, n: near}

    def real(self, n):
        d = self.domains.get(n)
        return d is not None and d.kind in ("real", "nonzero", ">0", ">=0", "angle", "interval")

    def roots(self, g, n, values):
        """Return the zeros of `g` in the variable `n`: exact if rational, else by scanning."""
        domain = self.domains[n]
        if any(isinstance(v, sp.Lambda) for v in values.values()):
            g = self.lines_of(g, values)
        try:
            with mpmath.workdps(40):
                at = self.point({k: v for k, v in values.items() if k != n})
                f = [value(g, at.bind(n, mpmath.mpf(x))) for x in (1, 2, 3, 7)]
                slope = f[1] - f[0]
                if slope and not add([f[2], -f[1], -slope]) and not add([f[3], -f[0], -6 * slope]):
                    r = mpmath.mpf(1) - f[0] / slope
                    r = Root(g, n, r) if rational(r) is None else rational(r)
                    return [r] if domain.contains(to_number(r, at)) else []
        except (Undefined, Unreliable, ValueError, ZeroDivisionError, OverflowError):
            pass
        exact = self.exact_roots(g, n, values)
        if exact is not None:
            return [r for r in exact if domain.contains(to_number(r, None))]
        found = []
        try:
            with mpmath.workdps(30):
                at = self.point({k: v for k, v in values.items() if k != n})
                xs = grid(domain)
                fs = []
                for x in xs:
                    try:
                        fs.append(value(g, at.bind(n, x)))
                    except (Undefined, Unreliable):
                        fs.append(None)
                for k in range(len(xs)):
                    if fs[k] is None:
                        continue
                    if fs[k] == 0:
                        found.append(Root(g, n, xs[k]))
                    elif k and fs[k - 1] is not None and fs[k] * fs[k - 1] < 0:
                        r = bisect(lambda x: value(g, at.bind(n, x)), xs[k - 1], xs[k], fs[k - 1])
                        if r is not None:
                            found.append(Root(g, n, r))
        except (Unreliable, Undefined, ValueError, ZeroDivisionError, OverflowError):
            return []
        return [r for r in found if domain.contains(r.start)][:8]

    def lines_of(self, g, values):
        keep = self.before, self.after
        self.before, self.after = g, None
        g = self.lines(values)[0]
        self.before, self.after = keep
        return g

    def exact_roots(self, g, n, values):
        if g.has(sp.Indexed, sp.Sum, sp.Integral, AppliedUndef, sp.Derivative, sp.Subs) or any(
            isinstance(v, (Root, Solved)) for v in values.values()
        ):
            return None
        try:
            e = self.model.evaluated(g)
            x = self.domains[n].symbol
            swap = {}
            for m, d in self.domains.items():
                if m != n and m in values:
                    if isinstance(d.symbol, sp.MatrixBase):
                        return None
                    swap[d.symbol] = values[m]
            t = sp.Symbol("t_")
            e = sp.fraction(sp.together(e.subs(swap).subs(x, t)))[0]
            if e.is_polynomial(t) and all(c.is_Rational for c in sp.Poly(e, t).all_coeffs()):
                poly = sp.Poly(e, t)
                if poly.is_zero or poly.degree() > 6:
                    return None
                return sorted(set(sp.real_roots(poly.sqf_part())), key=lambda r: abs(sp.N(r, 15)))
        except (TypeError, ValueError, NotImplementedError, AttributeError, sp.PolynomialError):
            return None
        return None

    def claim(self):
        """A claim that must hold everywhere: True if refuted."""
        generic_points = [
            (self.draw(k, s), s in ("small", "fraction"))
            for k, s in enumerate(STYLES if self.domains else STYLES[:1])
        ]
        for values, generic in generic_points:
            if not self.expired() and self.claim_at(values, generic):
                return True
        for values in chain(self.zeros(), self.surface_points([self.after])):
            if not self.expired() and self.claim_at(values, False):
                return True
        return self.downhill()

    def downhill(self, rounds=60):
        """Walk from the point where an inequality is closest to failing to where it fails."""
        w = self.after
        if not isinstance(w, sp.Gt | sp.Ge | sp.Lt | sp.Le) or self.slow:
            return False

        def margin(values):
            with mpmath.workdps(30):
                try:
                    line, at = self.lines(values)[1], self.point(values)
                    return value(line.gts, at) - value(line.lts, at)
                except (Undefined, Unreliable, ValueError, ZeroDivisionError, OverflowError):
                    return mp.inf

        rng = random.Random(f"{self.seed}/downhill")
        for style in ("fraction", "below"):
            values = self.draw(300, style)
            names = [n for n in values if n and self.real(n)]
            best = margin(values)
            for _ in range(rounds if names else 0):
                n = rng.choice(names)
                factor = sp.Rational(*rng.choice([(1, 3), (3, 4), (4, 3), (3, 1), (-1, 1)]))
                moved = {**values, n: values[n] * factor}
                if self.expired() or not self.domains[n].contains(to_number(moved[n], None)):
                    continue
                height = margin(moved)
                if height < best:
                    values, best = moved, height
                if best < 0:
                    return self.claim_at(values, True)
        return False

    def claim_at(self, values, generic):
        try:
            answers = []
            for digits in (self.digits, self.confirm):
                with mpmath.workdps(digits):
                    w, at = self.lines(values)[1], self.point(values)
                    shown = sides(w, at)
                    answers.append(truth(w, at))
                    if answers[-1] is not False:
                        break
            if answers[-1]:
                self.points += 1
            if answers != [False, False]:
                return False
            if None in shown:
                self.undefined += 1
                if not generic:
                    return False
            self.used = dict(self.entries)
            self.found = values, ("false", *shown)
            return True
        except (Unreliable, Undefined, OverflowError, ValueError, ZeroDivisionError):
            return False

    def claims(self, relation, unknown):
        """Two equations or inequalities: True if a solution is lost or gained."""
        names = (
            [unknown]
            if unknown
            else [n for n in preferred(self.before, self.after) if self.real(n)][:2]
        )
        names = [n for n in names if n in self.domains]
        if not any(
            self.real(n) for n in names
        ):  # equal truth at every point: any symbol may be solved for
            names += [
                n for n in preferred(self.before, self.after) if self.real(n) and n not in names
            ][:1]
        styles = ["small"] * 4 + ["fraction"] * 4 + ["edge"] * 5
        for k, style in enumerate(styles):
            values = self.draw(k, style)
            if style == "edge" and k % 2:
                values = {
                    n: sp.Integer(0)
                    if n and self.real(n) and self.domains[n].contains(mp.zero)
                    else v
                    for n, v in values.items()
                }
            for n in names or [None]:
                for candidate in self.candidates(values, n, k):
                    if self.expired():
                        return False
                    if self.claims_at(candidate, relation, n):
                        return True
        for values in self.surface_points([self.before, self.after]):
            if self.expired() or self.claims_at(values, relation, unknown):
                return self.found is not None
        return False

    def candidates(self, values, n, k):
        if n is None:
            yield values
            return
        rng = random.Random(f"{self.seed}/{n}/{k}")
        yield values
        yield {**values, n: self.domains[n].draw(rng, "fraction")}
        if self.domains[n].kind == "int":
            yield from ({**values, n: sp.Integer(self.domains[n].low + k)} for k in range(12))
        for w in atoms_of(self.before) + atoms_of(self.after):
            if w.func is sp.Eq and not self.real(n):
                yield {**values, n: Solved(w, n)}
            g = difference(w) if self.real(n) else None
            if g is None or n not in names_in(g):
                continue
            for r in self.roots(g, n, values):
                if w.func in (sp.Eq, sp.Ne):
                    yield {**values, n: r}
                else:
                    yield from self.around(values, n, r)

    def claims_at(self, values, relation, n):
        try:
            answers = []
            for digits in (self.digits, self.confirm):
                with mpmath.workdps(digits):
                    (before, after), at = self.lines(values), self.point(values)
                    p, q = self.holds(before, at, n), self.holds(after, at, n)
                    answers.append((p, q))
                    bad = (p is True and q is False and relation != "implied_by") or (
                        p is False and q is True and relation != "implies"
                    )
                    if not bad:
                        self.points += None not in (p, q) and (p or q)
                        return False
                    shown = (
                        "lost" if p else "gained",
                        (p, sides(before, at)),
                        (q, sides(after, at)),
                    )
            if answers[0] != answers[1]:
                return False
            self.used = dict(self.entries)
            self.found = values, shown
            return True
        except (Unreliable, Undefined, OverflowError, ValueError, ZeroDivisionError):
            return False

    def holds(self, w, at, n):
        answer = truth(w, at)
        if (
            answer is False
            and n
            and self.domains[n].kind == "angle"
            and all(a.func is sp.Eq for a in atoms_of(w))
        ):
            for turns in (-1, 1, -2, 2):
                if truth(w, at.bind(n, at.values[n] + 2 * turns * mp.pi)):
                    return True
        return answer


def rational(x):
    """The simple fraction that x is, or None."""
    p = sp.Rational(mpmath.nstr(x, 38)).limit_denominator(10**8)
    return p if abs(mpmath.mpf(p.p) / p.q - x) < mpmath.mpf(10) ** -34 * (1 + abs(x)) else None


def sides(w, at):
    out = []
    for part in (w.lhs, w.rhs) if isinstance(w, sp.Rel) else ():
        try:
            out.append(value(part, at))
        except (Undefined, Unreliable):
            out.append(None)
    return tuple(out)


def atoms_of(w):
    return (
        [a for part in w.args for a in atoms_of(part)]
        if isinstance(w, (sp.And, sp.Or, sp.Not))
        else [w]
        if isinstance(w, sp.Rel)
        else []
    )


def difference(w):
    if is_matrix(w.lhs) or is_matrix(w.rhs):
        return None
    return w.lhs if w.rhs == 0 else sp.Add(w.lhs, sp.Mul(-1, w.rhs, evaluate=False), evaluate=False)


def preferred(before, after):
    """An unknown, if none is named: what one line has alone on its left, then what both have."""
    names = [w.lhs.name for w in atoms_of(after) + atoms_of(before) if w.lhs.is_Symbol]
    both = names_in(before) & names_in(after)
    return list(dict.fromkeys([*names, *sorted(both), *sorted(names_in(before) | names_in(after))]))


def names_in(w):
    return {s.name for s in w.free_symbols if isinstance(s, (sp.Symbol, sp.MatrixSymbol))}


def grid(domain):
    """Where to look for sign changes."""
    steps = [mpmath.mpf(10) ** (mpmath.mpf(k) / 3) for k in range(-21, 16)]
    if domain.kind == "angle":
        return [-mp.pi + (mpmath.mpf(k) + mpmath.mpf("0.123")) * mp.pi / 24 for k in range(49)]
    if domain.kind in (">0", ">=0"):
        return steps
    if domain.kind == "interval" and domain.low != -sp.oo and domain.high != sp.oo:
        low, high = to_number(domain.low, None), to_number(domain.high, None)
        return sorted({low + (high - low) * s / (1 + s) for s in steps})
    if domain.kind == "interval" and domain.low != -sp.oo:
        return [to_number(domain.low, None) + s for s in steps]
    return [-s for s in steps[::-1]] + [mp.zero] + steps


def bisect(f, a, b, fa):
    """A sign change that is a zero and not a pole."""
    size = max(abs(fa), abs(f(b)))
    for _ in range(90):
        m = (a + b) / 2
        try:
            fm = f(m)
        except (Undefined, Unreliable):
            return None
        if fm == 0:
            return m
        a, b, fa = (m, b, fm) if fm * fa > 0 else (a, m, fa)
    return m if abs(f(m)) < size * mpmath.mpf("1e-12") else None


def surfaces(lines):
    """Where branches, poles and edges are, as written forms whose zero set matters."""
    found, out = set(), []

    def walk(w, bound):
        if isinstance(w, (sp.Sum, sp.Product, sp.Integral, sp.Subs)):
            bound = bound | {v.name for v in w.variables}
        for g in critical(w):
            if (
                g.free_symbols
                and not names_in(g) & bound
                and g not in found
                and not g.has(sp.Integral, sp.Derivative)
            ):
                found.add(g)
                out.append(g)
        for a in w.args if not isinstance(w, sp.MatrixBase) else list(w):
            if isinstance(a, sp.Basic):
                walk(a, bound)

    for w in lines:
        if w is not None:
            walk(w, set())
    return out[:14]


def critical(w):
    if isinstance(w, sp.Pow) and not (w.exp.is_Integer and w.exp > 0):
        return [w.base]
    if isinstance(w, (sp.Max, sp.Min)):
        return [
            sp.Add(a, sp.Mul(-1, b, evaluate=False), evaluate=False)
            for k, a in enumerate(w.args)
            for b in w.args[k + 1 :]
        ]
    if isinstance(w, (*KINKED, sp.log, sp.gamma)):
        return [w.args[0]]
    if isinstance(w, sp.atan2):
        return list(w.args)
    if isinstance(w, sp.tan):
        return [sp.cos(w.args[0], evaluate=False)]
    if isinstance(w, (sp.asin, sp.acos)):
        return [sp.Add(w.args[0], sp.Integer(s), evaluate=False) for s in (-1, 1)]
    if isinstance(w, sp.Inverse):
        return [sp.Determinant(w.args[0])]
    if isinstance(w, sp.Rel) and not is_matrix(w.lhs) and not is_claim(w.lhs):
        return [difference(w)]
    return []
