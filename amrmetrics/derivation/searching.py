"""Looking for a counterexample: many points, every edge, and downhill to where a claim fails."""

import contextlib
import random
import time
from fractions import Fraction
from itertools import combinations, pairwise

import sympy as sp
from mpmath import libmp
from sympy.core.function import AppliedUndef

from .arithmetic import Arithmetic, Imprecise, Undefined, Unreliable, as_float, fraction, sign
from .breaks import bends, breaks, minus, nodes
from .domains import ANGLES, LARGE, Index, NoRoom, Sized, exact, rational
from .evaluating import (
    BENT,
    SCOPES,
    Budget,
    Point,
    compare,
    determinant,
    flat,
    inverse,
    magnitude,
    product,
    truth,
    value,
)
from .limits import bounded
from .reading import is_claim, is_inequality, is_matrix

STYLES = ["small"] * 7 + ["fraction"] * 8 + ["wild"] * 6 + ["edge"] * 5
PRECISIONS = (200, 800)
ROUGH = sp.Integral | sp.Limit
SOFT = ("pair", "kink")  # what is undefined so is a condition of the step, never a refutation
HALF = ("nonnegative", "positive", "unit", "piecewise")  # fails on a whole part of the domain
FAILURES = (Unreliable, OverflowError)
NEAREST = 4  # zeros of a function that are looked for on the two sides of 0
LONG = 40  # sums of more terms are tried at few points only


class Root:
    """A zero of `g` in the variable `name`, known to lie between two ends."""

    def __init__(self, g, name, low, high):
        self.g, self.name, self.low, self.high = g, name, low, high
        self.start = low

    def at(self, point):
        """Return a narrow interval in which `g` changes its sign."""
        a = point.arithmetic

        def f(x):
            return a.number(value(self.g, point.bind(self.name, fraction(x))))

        ends = [a.number(x) for x in (self.low, self.high)]
        try:
            x = a.mp.findroot(f, ends, solver="anderson", verify=False)
        except (ValueError, ZeroDivisionError, Undefined):
            raise Unreliable("a root that cannot be refined") from None
        radius = (abs(x) + a.mp.mpf(10) ** -9) * a.mp.mpf(2) ** (-2 * a.prec // 3)
        signs = [
            sign(value(self.g, point.bind(self.name, fraction(x + s * radius)))) for s in (1, -1)
        ]
        if not (signs[0] and signs[1]) or signs[0] == signs[1]:
            raise Unreliable("a root without a change of sign")
        return a.around(x, radius)


class Solved:
    """The solution of one equation for a vector or a matrix: given outright, or linear."""

    def __init__(self, equation, symbol, shape):
        self.equation, self.symbol, self.shape, self.start = equation, symbol, shape, None

    def at(self, point):
        name = self.symbol.name
        for one, other in (self.equation.args, self.equation.args[::-1]):
            if one == self.symbol and not other.has(one):
                self.start = value(other, point)
                return self.start
        if self.shape[1] != 1:
            raise Unreliable("not a vector")
        n, a = int(self.shape[0]), point.arithmetic

        def f(xs):
            moved = point.bind(name, [[x] for x in xs])
            left, right = (flat(value(w, moved)) for w in self.equation.args)
            return [a.subtract(x, y) for x, y in zip(left, right, strict=True)]

        unit = [[Fraction(int(i == k)) for i in range(n)] for k in range(n)]
        zero = f([Fraction(0)] * n)
        columns = [[a.subtract(x, y) for x, y in zip(f(e), zero, strict=True)] for e in unit]
        if len(zero) != n or sign(determinant(columns, a)) == 0:
            raise Unreliable("no unique solution")
        right = [[a.negative(z) for z in zero]]
        solution = product(right, inverse(columns, a), a)[0]
        if any(sign(x) for x in f(solution)):
            raise Unreliable("not linear")
        self.start = [[x] for x in solution]
        return self.start


class Search:
    """Everything tried for one step; `found` is set when it is refuted."""

    def __init__(self, before, after, domains, seed, relation="iff", unknown=None):
        self.before, self.after, self.seed = before, after, seed
        self.relation, self.unknown = relation, unknown
        self.lines = [w for w in (before, after) if w is not None]
        used = set().union(*map(names_in, self.lines))
        self.domains, self.dependent = _in_order(domains, used)
        shapes = [k for d in self.domains.values() if isinstance(d, Sized) for k in d.kind]
        shapes += [k for w in self.lines for one in w.atoms(sp.Identity) for k in one.shape]
        self.sized = {n.name for k in shapes for n in sp.sympify(k).free_symbols}
        self.everything = domains
        for f in set().union(*(w.atoms(AppliedUndef) for w in self.lines)):
            domains[f.func.__name__].arguments = len(f.args)
        self.rough = any(w.has(*ROUGH.__args__) or w.has(sp.oo) for w in self.lines)
        # Differences and quadratures have an error that does not shrink with the value itself.
        slopes = any(w.has(sp.Derivative) for w in self.lines)
        self.floor = 1e-3 if self.rough else 1e-12 if slopes else 0.0
        self.sizes = {
            n
            for n in set().union(*map(_sizes, self.lines)) & self.domains.keys()
            if not isinstance(self.domains[n], Index)
        }
        nested = any(x.function.has(sp.Integral) for w in self.lines for x in w.atoms(sp.Integral))
        nested = nested or any(len(x.limits) > 1 for w in self.lines for x in w.atoms(sp.Integral))
        self.budget, self.bits = Budget(500_000 if nested else 200_000), 14 if nested else 24
        self.end = time.monotonic() + 5.5  # only a slow machine meets it before the budget
        self.points, self.enlarged = 0, 0
        self.found = None
        self.suspect = False  # a difference was seen that a second look has not settled
        self.closest = []  # (relative margin, values) of an inequality
        self.places, self.largest = set(), 0
        self.known, self.arithmetics, self.solved = {}, {}, {}

    # ---- points ------------------------------------------------------------------------------

    def draw(self, k, style, longest=None):
        """Return values by name; under "" stand the number of the point and its style."""
        rng = random.Random(f"{self.seed}/{k}/{style}")
        longest = longest or (LONG if k % 5 else 300)
        values = {"": (k, style, 7)}
        for name, domain in self.domains.items():
            if domain.kind == "sequence":
                continue
            if isinstance(domain, Index):
                sizes = [values[n] for n in self.sizes if n in values]
                values[""] = (k, style, max(sizes, default=7))
            if domain.whole:
                cap = longest if name in self.sizes or self.rough else 10**7
                cap = 4 if name in self.sized else cap
                values[name] = domain.draw(rng, style, values, cap)
            else:
                values[name] = domain.draw(rng, style, values)
        return values

    def valid(self, values):
        """Whether values that were changed one by one still fit together."""
        sizes = [values[n] for n in self.sizes if n in values]
        for name, domain in self.domains.items():
            if isinstance(domain, Index):
                if sizes and not 1 <= values[name] <= max(sizes):
                    return False
            elif isinstance(domain, Sized):
                if not domain.fits(values[name], values):
                    return False
            elif name in self.dependent and not domain.contains(values[name], values):
                return False
        return True

    def point(self, values, prec):
        k, style, _ = values[""]
        entries = {}

        def entry(name, index, at):
            if (name, index) not in entries:
                rng = random.Random(f"{self.seed}/{k}/{name}/{index}")
                entries[name, index] = self.everything[name].element.draw(rng, style, values)
            return number(entries[name, index], at.arithmetic)

        def make(a):
            return {
                n: number(v, a) for n, v in values.items() if n and not isinstance(v, Root | Solved)
            }

        if prec not in self.arithmetics:  # to make one takes as long as a short evaluation
            self.arithmetics[prec] = Arithmetic(prec)
        at = Point(make, entry, self.arithmetics[prec], self.budget)
        at.known = self.known.setdefault((prec, str(values)), {}) if self.rough else {}
        self.entries = entries
        for name, v in values.items():
            if isinstance(v, Root | Solved):
                at = at.bind(name, v.at(at), v.at)
        return at

    def expired(self):
        return self.budget.left < 0 or time.monotonic() > self.end

    def everywhere(self):
        """Yield (kind of place, values) from the plain to the remote."""
        styles = ["small", "fraction", "near"] * 3 + ["edge"] if self.rough else STYLES
        if is_claim(self.after) and self.before is not None:  # each is solved for its unknowns, too
            styles = STYLES[:11:2] + STYLES[15::2]
        if not self.domains:
            styles = styles[:1]
        if self.rough:  # few points can be afforded: the first whole numbers, of both parities
            yield from self._whole_numbers()
        for k, style in enumerate(styles):
            yield style, self._drawn(k, style)
        yield from self._corners()
        yield from self._zeros()
        if not self.rough:
            yield from self._whole_numbers()
        yield from self._at_breaks(self.lines)

    def _drawn(self, k, style):
        for again in range(4):
            try:
                return self.draw(k + 1000 * again, style)
            except NoRoom:  # one name leaves no room for another
                continue
        return None

    def _corners(self):
        """Points at which everything is zero or one, and angles are parts of a turn."""
        for style in ("zero", "one"):
            yield "zero", self._drawn(700, style)
        turning = any(w.has(sp.sin, sp.cos, sp.tan, sp.cot, sp.pi) for w in self.lines)
        names = [n for n, d in self.domains.items() if d.real and (turning or d.text == "angle")]
        angles = [n for n in names if self.domains[n].text == "angle"] or names
        for angle in ANGLES if angles else ():
            values = self._drawn(700, "one") or {}
            chosen = [n for n in angles if n in values and self.domains[n].contains(angle, values)]
            if chosen:
                yield "zero", {**values, **dict.fromkeys(chosen, exact(angle))}

    def _zeros(self):
        alone = {n: d for n, d in self.domains.items() if n not in self.dependent}
        free = [n for n, d in alone.items() if d.real and d.contains(0)]
        some = [free, *([n] for n in free[:5]), *combinations(free[:5], 2)] if free else []
        for k, chosen in enumerate(some):
            values = self._drawn(200 + k, "fraction")
            if values:
                yield "zero", {**values, **dict.fromkeys(chosen, Fraction(0))}

    def _whole_numbers(self):
        names = [n for n, d in self.domains.items() if d.whole and d.low.is_number]
        names = [n for n in names if self.domains[n].low != -sp.oo]
        for one, other in pairwise(names[:3]):  # all pairs of small ones
            for k in range(64):
                values = self._drawn(450 + k % 2, "fraction")
                small = {n: self.domains[n].low + j for n, j in ((one, k // 8), (other, k % 8))}
                if values and all(self.domains[n].contains(x, values) for n, x in small.items()):
                    yield "whole", {**values, **{n: Fraction(int(x)) for n, x in small.items()}}
        for name in names[:3]:
            low = self.domains[name].low
            stepped = any(w.has(sp.Mod, sp.floor, sp.ceiling) for w in self.lines)
            alone = len(self.domains) == 1 and not self.sizes
            count = 4 if self.rough else 24 if not alone else 4000 if stepped else 1000
            near = [int(low) + k for k in range(count)]
            far = [] if self.rough or name in self.sizes else [k for k in LARGE if k >= low]
            bare = not any(w.has(sp.Indexed) for w in self.lines)
            if bare and self.before is None and self.sizes == {name}:  # about sums that grow
                far = [100, 1000, 10_000]
            for k, n in enumerate(near + far):
                values = self._drawn(400 + k % 6, "fraction")
                if values and self.domains[name].contains(n, values):
                    yield "whole", {**values, name: Fraction(n)}

    def _at_breaks(self, lines):
        """Points on, and on both sides of, every place where something can happen."""
        formulas = list(dict.fromkeys(g for w in lines for g in breaks(w)))[:12]
        for k, (name, domain) in enumerate(self.domains.items()):
            if not (domain.real or domain.whole):
                continue
            here = [g for g in formulas if name in names_in(g)]
            styles = ["small", *["wild"] * 4] if domain.whole else ["small", "fraction"]
            for again, style in enumerate(styles if here else ()):
                values = self._drawn(500 + k + 20 * again, style)
                if values is None or self.expired():
                    return
                places = [r for g in here for r in self.roots(g, name, values)]
                yield from (("break", p) for p in self._beside(places, name, values))
        if not self.rough:
            yield from (("break", p) for p in self._beyond(lines))

    def _beside(self, places, name, values):
        """Points at some places of one name, next to each of them and between each two."""
        domain, near = self.domains[name], []
        for r in places:
            x = r.low if isinstance(r, Root) else exact(sp.Rational(str(_decimal(r, 12))))
            x = x if isinstance(x, Fraction) else Fraction(as_float(x))
            near.append(x)
            if not domain.whole:
                yield {**values, name: r}
        if domain.whole:
            around = [Fraction(x.numerator // x.denominator + k) for x in near for k in (0, 1)]
        else:
            around = [(x + y) / 2 for x, y in pairwise(sorted(near))]
            around += [x * Fraction(k, 1000) for x in near for k in (500, 999, 1001, 1500)]
            around += [x + Fraction(k, 7) for x in near for k in (-1, 1)]
            ends = [e for e in (domain.low, domain.high) if e.is_number and e.is_finite]
            around += [(x + rational(e)) / 2 for x in near for e in ends]
        for y in dict.fromkeys(around):
            if domain.contains(sp.Rational(y), values):
                yield {**values, name: y}

    def _beyond(self, lines):
        """Points on the side of a bend that chance has not met: downhill to where it begins."""
        names = [n for n, d in self.domains.items() if d.real]
        formulas = dict.fromkeys(
            g for w in lines for node, bound in nodes(w) if not bound for g in bends(node)
        )
        for g in list(formulas)[:6] if names else ():
            starts = [self._drawn(800 + k, s) for k, s in enumerate(("small", "fraction") * 3)]
            heights = [(self._height(g, v), k) for k, v in enumerate(starts) if v]
            heights = [(h, k) for h, k in heights if abs(h) < float("inf")]
            if not heights or len({h > 0 for h, _ in heights}) > 1:
                continue
            s = 1 if heights[0][0] > 0 else -1
            for _, k in sorted((s * h, k) for h, k in heights)[:2]:
                yield self._walk(starts[k], names, lambda v, g=g, s=s: s * self._height(g, v))

    # ---- roots -------------------------------------------------------------------------------

    def roots(self, g, name, values):
        """Return the zeros of `g` in the variable `name`: exact ones, or intervals."""
        domain = self.domains[name]
        others = {n: v for n, v in values.items() if n != name}
        known = exact_roots(g, name, others)
        if domain.whole:  # a whole number next to a zero that is not whole
            return [exact(r) for r in known or []][:6]
        if known is not None:
            return [exact(r) for r in known if domain.contains(r, values)][:6]
        try:
            at = self.point({"": values[""], **others}, 120)
            return self._scan(g, name, at, domain, values)
        except (Undefined, *FAILURES):
            return []

    def _scan(self, g, name, at, domain, values):
        """Return the zeros of `g` where it changes its sign, or touches zero and turns back."""
        xs = self._places(g, domain, values)
        slope = None if g.has(*BENT, *SCOPES) else g.diff(sp.Symbol(name))
        turns = _crossings(slope, name, xs, at) if slope and not slope.has(sp.Derivative) else []
        starts = [getattr(r, "start", r) for r in turns]
        found = _crossings(g, name, sorted({*xs, *starts}), at)
        found += [r for r in turns if _touches(g, name, r, at)]
        return sorted(found, key=lambda r: abs(getattr(r, "start", r)))

    def _places(self, g, domain, values):
        """Return where to look for changes of sign: near, far, and close together for waves."""
        ts = [Fraction(2 * k - 37, 38) for k in range(38)]
        ts += [Fraction(s, 10**k) for k in (2, 3, 5, 7) for s in (1, -1)]
        ts += [s * (1 - Fraction(1, 10**k)) for k in (2, 4) for s in (1, -1)]
        xs = {domain.stretch(t, values) for t in ts}
        if g.has(sp.sin, sp.cos, sp.tan, sp.cot):
            xs |= {
                Fraction(k, 7) for k in range(-56, 57) if domain.contains(sp.Rational(k, 7), values)
            }
        return sorted(xs)

    # ---- judging one point -------------------------------------------------------------------

    def wrong_at(self, values, place="fraction"):
        """Whether the step is refuted here, beyond doubt and at two precisions."""
        if values is None or not self.valid(values):
            return False
        outcome = seen = None
        for prec in PRECISIONS if self.domains else PRECISIONS[::-1]:
            try:
                outcome, seen = self.judge(values, prec)
            except Imprecise:
                continue
            except FAILURES:
                return False
            except Undefined:
                return False
            once = outcome == "wrong" and self.rough and prec == PRECISIONS[0] and self.domains
            if outcome is not None and not once:
                break
            self.suspect = self.suspect or outcome == "wrong"
            if once:
                self.budget.left = max(self.budget.left, 400_000)  # for the second look
        if outcome == "holds":
            self.points += 1
            self.places.add(place)
            if place == "whole":
                tried = [int(values[n]) for n, d in self.domains.items() if d.whole]
                self.largest = max(self.largest, *tried)
            self.suspect = False if self.rough else self.suspect
        elif outcome == "enlarged":
            self.enlarged += place in ("small", "fraction")
        elif outcome == "wrong":
            self.found = values, seen, dict(self.entries)
            return True
        return False

    def judge(self, values, prec):
        """Return "holds", "wrong", "enlarged", "undefined" or None, and what was seen."""
        at = self.point(values, prec)
        if self.before is None:
            return self._claim(at, values)
        if is_claim(self.before):
            return self._pair_of_claims(at)
        return self._formulas(at, prec)

    def _formulas(self, at, prec):
        sides = []
        for w in (self.before, self.after):
            try:
                sides.append(value(w, at))
            except Undefined as reason:
                sides.append(reason)
        a, b = sides
        if isinstance(a, Undefined) and isinstance(b, Undefined):
            return "undefined", sides
        if isinstance(b, Undefined):
            return ("undefined" if b.kind in SOFT else "wrong"), ("shrunk", a, b)
        if isinstance(a, Undefined):
            if a.kind in ("converges", "limit"):
                return "wrong", ("diverges", a, b)
            return ("enlarged" if a.kind in HALF else "undefined"), sides
        bits = self.bits if self.rough else at.arithmetic.prec // 2
        same = compare(a, b, at.arithmetic, bits, libmp.from_float(self.floor))
        if same is None and (self.rough or prec == PRECISIONS[-1]):  # the size of what cancels
            sizes = [magnitude(w, at)._mpf_ for w in (self.before, self.after)]
            same = compare(a, b, at.arithmetic, bits, at.arithmetic.larger(*sizes))
        return {"equal": "holds", "different": "wrong", None: None}[same], ("values", a, b)

    def _claim(self, at, values):
        """Judge a claim that must hold everywhere; one about something undefined says nothing."""
        w = self.after
        seen = "claim", *[value(x, at) for x in w.args if isinstance(w, sp.Rel)]
        answer = truth(w, at)
        if is_inequality(w):
            a = at.arithmetic
            margin = as_float(a.subtract(value(w.gts, at), value(w.lts, at)))
            size = sum(abs(as_float(x)) for x in seen[1:]) or 1.0
            self.closest.append((margin / size, values))
            if answer is None and isinstance(w, sp.Gt | sp.Lt):
                answer = False if self._tie(w, values) else None
                if answer is False:
                    exact_side = seen[2] if isinstance(seen[2], Fraction) else seen[1]
                    seen = "claim", exact_side, exact_side
        return {True: "holds", False: "wrong", None: None}[answer], seen

    def _tie(self, w, values):
        """Whether both sides are the same number: shown by exact arithmetic or not at all."""
        if self.rough or any(not isinstance(v, Fraction | sp.Expr) for n, v in values.items() if n):
            return False
        d = _substituted(minus(*w.args), values)
        if d is None or sp.count_ops(d) > 100:
            return False
        return bounded(lambda: sp.expand(sp.together(sp.expand(d))) == 0, 0.2)[1] is True

    def _pair_of_claims(self, at):
        p, q = (self._holds(w, at) for w in (self.before, self.after))
        lost = p is True and q is False and self.relation != "implied_by"
        gained = p is False and q is True and self.relation != "implies"
        if lost or gained:
            return "wrong", ("lost" if lost else "gained", p, q)
        if p is None or q is None:
            return None, None
        return "holds" if p or q else "undefined", None

    def _holds(self, w, at):
        bits = 25 if self.rough else at.arithmetic.prec // 4
        answer = truth(w, at, bits)
        if answer is False and all(e.func is sp.Eq for e in atoms_of(w)):
            names = {self.unknown} if self.unknown else names_in(w)
            angles = [n for n in names & self.domains.keys() if self.domains[n].text == "angle"]
            if any(truth(w, moved, bits) for n in sorted(angles) for moved in _turned(w, n, at)):
                return True
        return answer

    # ---- the whole search --------------------------------------------------------------------

    def refutes(self, most=None):
        """Return whether a point was found at which the step is wrong; `most` points are tried."""
        for k, (place, values) in enumerate(self._candidates()):
            if self.expired() or k == most:
                break
            if self.wrong_at(values, place):
                return True
        if most is None and self.before is None and is_inequality(self.after) and not self.rough:
            self.budget.left = max(self.budget.left, 40_000)  # long sums leave nothing
            return self._downhill()
        return False

    def _candidates(self):
        if self.before is None or not is_claim(self.before):
            yield from self.everywhere()
            return
        names = self._unknowns()
        systems = [eqs for w in self.lines for eqs in _systems(w)]
        for place, values in self.everywhere():
            yield place, values
            if values is None or place in ("whole", "break", "zero"):
                continue
            for name in names[:2]:
                yield from ((place, p) for p in self._solutions(name, values))
            for eqs in systems:
                yield from ((place, p) for p in self._common(eqs, names, values))

    def _unknowns(self):
        """Return the names to solve for: the one given, or what stands alone, then the others."""
        if self.unknown:
            return [self.unknown]
        alone = [x.name for w in self.lines for e in atoms_of(w) for x in e.args if x.is_Symbol]
        both = names_in(self.before) & names_in(self.after)
        names = [*alone[::-1], *sorted(both), *sorted(self.domains)]
        return [
            n
            for n in dict.fromkeys(names)
            if n in self.domains and self.domains[n].kind == "number"
        ]

    def _common(self, equations, names, values):
        """Yield the common solutions of several equations in as many names, if SymPy has them."""
        used = set().union(*map(names_in, equations))
        chosen = [n for n in names if n in used and self.domains[n].real][: len(equations)]
        others = {n: values[n] for n in used & values.keys() - {*chosen}}
        system = str((equations, others))

        def solve():
            gaps = [_substituted(minus(*e.args), others) for e in equations]
            if None in gaps:
                return []
            return sp.solve(gaps, [sp.Symbol(n) for n in chosen], dict=True)

        if system not in self.solved:
            self.solved[system] = bounded(solve, 0.5)[1] or []
        for solution in self.solved[system]:
            found = {s.name: x for s, x in solution.items()}
            if all(x.is_real and self.domains[n].contains(x, values) for n, x in found.items()):
                yield {**values, **{n: exact(x) for n, x in found.items()}}

    def _solutions(self, name, values):
        domain = self.domains.get(name)
        if domain is None:
            return
        for w in atoms_of(self.before) + atoms_of(self.after):
            if w.func is sp.Eq and not domain.real:
                symbols = [s for s in w.free_symbols if getattr(s, "name", None) == name]
                if symbols and isinstance(domain.kind, tuple):
                    yield {**values, name: Solved(w, symbols[0], domain.kind)}
                continue
            if not domain.real or is_matrix(w.args[0]):
                continue
            g = minus(*w.args)
            if name not in names_in(g):
                continue
            if w.func in (sp.Eq, sp.Ne):
                yield from ({**values, name: r} for r in self.roots(g, name, values))
            else:
                yield from self._beside(self.roots(g, name, values), name, values)

    def _downhill(self):
        """Walk from where an inequality is closest to failing to where it fails."""
        names = [n for n, d in self.domains.items() if d.real]
        gap = minus(self.after.gts, self.after.lts)
        for values in self._stationary(names):
            if self.wrong_at(values, "downhill"):
                return True
        starts = sorted(self.closest, key=lambda pair: pair[0])
        starts = [values for _, values in starts[:2]] + [self._drawn(300, "fraction")]
        for start in starts if names else []:
            if start is None or any(isinstance(v, Root | Solved) for v in start.values()):
                continue
            values = self._walk(start, names, lambda v: self._height(gap, v))
            for size in (1, 2, 12, 100, 10**9):
                plain = {n: v.limit_denominator(size) for n, v in values.items() if n in names}
                inside = all(
                    self.domains[n].contains(sp.Rational(v), values) for n, v in plain.items()
                )
                if inside and self.wrong_at({**values, **plain}, "downhill"):
                    return True
            if self.wrong_at(values, "downhill"):
                return True
        if not self.expired():
            self.places.add("downhill")
        return False

    def _stationary(self, names):
        """Yield the places where the difference of the sides is flat, if they are known exactly."""
        difference = minus(*self.after.args)
        if difference.has(*BENT, *SCOPES):
            return
        for name in names[:2]:
            values = self._drawn(310, "small")
            slope = difference.diff(sp.Symbol(name))
            roots = exact_roots(slope, name, {n: v for n, v in values.items() if n != name}) or []
            for r in roots:
                if self.domains[name].contains(r, values):
                    yield {**values, name: exact(r)}

    def _walk(self, start, names, height, rounds=14):
        """Return the point to which one leads that goes down, one name after another."""
        ts = dict.fromkeys(names, Fraction(0))
        for n in names:
            ts[n] = _shrunk(self.domains[n], start[n], start)
        here = self._stretched(start, ts)
        best, step = height(here), Fraction(1, 4)
        for _ in range(3 * rounds):
            better = False
            for n in names:
                for s in (step, -step):
                    t = max(
                        min(ts[n] + s * (1 - abs(ts[n])), Fraction(10**9 - 1, 10**9)),
                        -Fraction(10**9 - 1, 10**9),
                    )
                    moved = self._stretched(start, {**ts, n: t})
                    h = height(moved)
                    if h < best:
                        best, here, better = h, moved, True
                        ts[n] = t
            if best < 0 or self.expired():
                break
            if not better:
                step /= 3
                if step < Fraction(1, 10**7):
                    break
        return here

    def _stretched(self, start, ts):
        """Return the values for these parameters; ends that are letters come before."""
        values = dict(start)
        for n, t in ts.items():
            values[n] = self.domains[n].stretch(t, values)
        return values

    def _height(self, g, values):
        try:
            return as_float(value(g, self.point(values, 90)))
        except (Undefined, *FAILURES):
            return float("inf")


def _turned(w, name, at):
    """Yield the point with an angle moved on by whole turns, for what is equal up to turns."""
    a = at.arithmetic
    turn = a.multiply([Fraction(2), a.pi()])
    numbers = [e for e in atoms_of(w) if not is_matrix(e.lhs)]
    try:
        apart = [a.subtract(*(value(x, at) for x in e.args)) for e in numbers]
    except Undefined:  # a claim about something undefined is false at every turn
        return
    turns = [s * round(as_float(d) / as_float(turn)) for d in apart for s in (1, -1)]
    for k in dict.fromkeys((*turns, -1, 1, -2, 2)):
        yield at.bind(name, a.add([at.values[name], a.multiply([Fraction(k), turn])]))


def _shrunk(domain, x, values, rounds=40):
    """Return the parameter in (-1, 1) at which `domain.stretch` gives about `x`."""
    low, high = Fraction(-1) + Fraction(1, 10**9), Fraction(1) - Fraction(1, 10**9)
    x = as_float(x) if isinstance(x, Fraction) else float(x)
    rising = float(domain.stretch(high, values)) > float(domain.stretch(low, values))
    for _ in range(rounds):
        middle = (low + high) / 2
        if (float(domain.stretch(middle, values)) < x) == rising:
            low = middle
        else:
            high = middle
    return ((low + high) / 2).limit_denominator(10**9)


def _crossings(g, name, xs, at):
    """Return the first places where `g` changes its sign between neighbors in `xs`, or is zero."""

    def height(x):
        try:
            return value(g, at.bind(name, x))
        except (Undefined, Unreliable):
            return None

    heights = [height(x) for x in xs]
    signs = [None if h is None else sign(h) for h in heights]
    found = []
    pairs = pairwise(zip(xs, signs, heights, strict=True))
    for (x, s, h), (y, t, k) in sorted(pairs, key=lambda pair: abs(pair[0][0])):
        if len(found) == NEAREST:
            break
        if s == 0:
            found.append(x)
        elif s and t and s != t:
            with contextlib.suppress(Undefined, *FAILURES):  # a pole changes the sign, too
                ends = [fraction(at.arithmetic.mp.make_mpf(e)) for e in Root(g, name, x, y).at(at)]
                steep = abs(as_float(value(g, at.bind(name, ends[0]))))
                if steep < 1e-9 * (1 + max(abs(as_float(h)), abs(as_float(k)))):
                    found.append(Root(g, name, *ends))
    return found


def _touches(g, name, root, at):
    """Whether `g` cannot be told from zero at a place where it turns."""
    try:
        here = root.at(at) if isinstance(root, Root) else root
        h = value(g, at.bind(name, here))
    except (Undefined, *FAILURES):
        return False
    return not sign(h) and abs(as_float(h)) < 1e-15


def number(v, a):
    """Return a drawn value as a number of the arithmetic `a`."""
    if isinstance(v, Fraction | tuple | sp.Lambda):
        return v
    if isinstance(v, list):
        return [[number(x, a) for x in row] for row in v]
    if v.is_Rational:
        return exact(v)
    x = _decimal(v, int(a.prec * 0.31) + 10)._mpf_
    return libmp.mpf_sub(x, _ulp(x, a), a.prec + 20, "f"), libmp.mpf_add(
        x, _ulp(x, a), a.prec + 20, "c"
    )


def _decimal(x, digits):
    """Return a real number in digits, without the imaginary part that SymPy may leave of it."""
    return sp.re(sp.N(x, digits))


def _ulp(x, a):
    return libmp.mpf_shift(libmp.mpf_abs(x), -a.prec)


def names_in(w):
    """Return the declared names in a line: symbols, sequences and functions."""
    names = {s.name for s in w.atoms(sp.Symbol, sp.MatrixSymbol) if not isinstance(s, sp.Dummy)}
    names |= {f.func.__name__ for f in w.atoms(AppliedUndef)}
    return names | {str(b.label) for b in w.atoms(sp.IndexedBase)}


def _sizes(w):
    """Return the names in the ends of the sums and products of a line."""
    ends = [e for s in w.atoms(sp.Sum, sp.Product) for _, *pair in s.limits for e in pair]
    return {x.name for e in ends for x in e.free_symbols if not isinstance(x, sp.Dummy)}


def _in_order(domains, used):
    """Return the domains that a step uses; a domain stands behind the names that it depends on."""

    def depends(d):
        parts = [getattr(d, "low", sp.Integer(0)), getattr(d, "high", sp.Integer(0))]
        parts += d.kind if isinstance(d, Sized) else []
        return {s.name for p in parts for s in sp.sympify(p).free_symbols}

    wanted = set(used) & domains.keys()
    while more := set().union(*(depends(domains[n]) for n in wanted), set()) - wanted:
        wanted |= more
    rank = {n: (bool(depends(domains[n])), isinstance(domains[n], Index)) for n in wanted}
    order = sorted(wanted, key=lambda n: (rank[n], list(domains).index(n)))
    return {n: domains[n] for n in order}, {
        n for n in wanted if rank[n][0] and domains[n].kind == "number"
    }


def atoms_of(w):
    if isinstance(w, sp.And | sp.Or | sp.Not):
        return [x for part in w.args for x in atoms_of(part)]
    return [w] if isinstance(w, sp.Rel) else []


def _systems(w):
    """Return the equations between numbers that a line joins by And, for each And."""
    parts = [
        [e for e in x.args if isinstance(e, sp.Eq) and not is_matrix(e.lhs)]
        for x in sp.preorder_traversal(w)
        if isinstance(x, sp.And)
    ]
    return [equations for equations in parts if len(equations) > 1]


def _substituted(g, values):
    """Return `g` with exact numbers for the symbols, or None where it has more than that."""
    if g.has(
        sp.Indexed,
        sp.Sum,
        sp.Product,
        sp.Derivative,
        sp.Subs,
        sp.Piecewise,
        AppliedUndef,
        *ROUGH.__args__,
    ):
        return None
    swap = {}
    for s in g.free_symbols:
        v = values.get(getattr(s, "name", None))
        if isinstance(s, sp.MatrixSymbol):
            return None
        if v is not None:
            if not isinstance(v, Fraction | sp.Expr):
                return None
            swap[s] = sp.Rational(v) if isinstance(v, Fraction) else v
    return g.subs(swap).doit()


def exact_roots(g, name, values):
    """Return the real roots of `g` in `name` if it is a rational function of it, else None."""
    if any(name in names_in(f) for f in g.atoms(sp.Function)):
        return None

    def solve():
        e = _substituted(g, values)
        if e is None:
            return None
        t = sp.Dummy("t", real=True)
        e = sp.fraction(sp.together(e.subs(sp.Symbol(name), t)))[0]
        if not e.is_polynomial(t) or e.free_symbols - {t}:
            return None
        p = sp.Poly(e, t)
        if p.is_zero or p.degree() > 6:
            return None
        if all(c.is_Rational for c in p.all_coeffs()):
            found = sp.real_roots(p.sqf_part())
        elif p.degree() <= 2:
            found = [r for r in sp.roots(p) if r.is_real]
        else:
            return None
        return sorted(set(found), key=lambda r: abs(sp.N(r, 15)))

    return bounded(solve, 0.3)[1]
