"""Domains: which values a declared name has, which of them to try, and what SymPy may assume."""

import random
import re
from fractions import Fraction
from functools import cached_property

import sympy as sp

from .reading import Unreadable, read

NUMBER_FACTS = {
    "real": {"real": True},
    "angle": {"real": True},
    "nonzero": {"real": True, "nonzero": True},
    ">0": {"positive": True},
    ">=0": {"nonnegative": True},
    "<0": {"negative": True},
    "<=0": {"nonpositive": True},
}
EXAMPLES = "real, >0, (0,1), angle, int>=1, seq, function, vec2, spd2, rot"
LARGE = [11, 12, 13, 16, 24, 25, 30, 36, 49, 97, 100, 101, 128, 341, 561, 1000, 1024, 9999, 10**4]
LARGE += [65536, 99991, 10**5, 999983, 10**6]
ANGLES = [sp.Integer(0), sp.pi, -sp.pi, sp.pi / 2, -sp.pi / 2, 2 * sp.pi, sp.pi / 4, 3 * sp.pi / 4]


class NoRoom(Exception):
    """The values drawn before leave no value for this name, or one too large to work with."""


def make(name, text, names=()):
    """Return the domain that `text` describes, for the symbol `name`.

    Ends of intervals may be other declared `names`.
    """
    from .spelling import canonical

    text = canonical(str(text)).replace(" ", "")
    kinds = dict.fromkeys(names, "number")
    if text in NUMBER_FACTS:
        return Real(name, text, NUMBER_FACTS[text])
    if m := re.fullmatch(r"int(>=?)(-?\d{1,6})", text):
        return Whole(name, text, sp.Integer(int(m[2]) + (m[1] == ">")), sp.oo)
    if text == "int":
        return Whole(name, text, -sp.oo, sp.oo)
    if m := re.fullmatch(r"(int|index)\[(.+),(.+)\]", text):
        return Whole(name, text, *(_end(end, text, kinds) for end in m.groups()[1:]))
    if text == "index":
        return Index(name, text, sp.Integer(1), sp.oo)
    if m := re.fullmatch(r"([(\[])(.+),(.+)([)\]])", text):
        low, high = (_end(end, text, kinds) for end in (m[2], m[3]))
        return Interval(name, text, low, high, (m[1] == "[", m[4] == "]"))
    if m := re.fullmatch(r"seq(.*)", text):
        return Sequence(name, text, make(name, m[1] or "real", names))
    if text == "function":
        return Abstract(name, text)
    if m := re.fullmatch(r"(vec|mat|spd|chol|sym|rot)\(([\w,]+)\)", text):
        sizes = [_end(n, text, kinds) for n in m[2].split(",")]
        if len(sizes) <= 1 + (m[1] == "mat"):
            return Sized(name, text, m[1], sizes)
    return Matrix(name, text)


def _end(text, whole, kinds):
    try:
        end = sp.sympify(read(text.replace("inf", "oo"), kinds)).doit()
    except Unreadable:
        raise _unknown(whole) from None
    if not end.is_number and not end.free_symbols:
        raise _unknown(whole)
    return end


def _unknown(text):
    return Unreadable(f"{text!r} is not a domain; domains are written {EXAMPLES}")


def fraction(rng, low=1, high=60):
    return Fraction(rng.randint(low, high), rng.choice([7, 11, 13, 17, 53, 97]))


class Domain:
    """One declared name.

    ``kind`` says how the name is read: "number", "sequence", "function" or the shape of a matrix.
    ``symbol`` is what proofs work with; ``free`` replaces it by parameters whose assumptions say
    more, and ``circle`` is a pair (sine, cosine) whose squares add up to one.
    """

    kind = "number"
    real = whole = False
    circle = None

    def __init__(self, name, text):
        self.name, self.text = name, text
        self.free = {}

    def contains(self, x, values=None):
        return True

    def simple(self):
        """Values from simple to less simple, for the counterexample that is shown."""
        return []


class Real(Domain):
    """Real numbers, perhaps of one sign."""

    real = True
    low, high, closed = -sp.oo, sp.oo, (False, False)

    def __init__(self, name, text, facts):
        super().__init__(name, text)
        self.symbol = sp.Symbol(name, **facts)
        self.sign = {">0": 1, ">=0": 1, "<0": -1, "<=0": -1}.get(text)
        self.zero = text not in (">0", "<0", "nonzero")

    def contains(self, x, values=None):
        if x == 0:
            return self.zero
        return self.sign is None or (x > 0) == (self.sign > 0)

    def draw(self, rng, style, values):
        if self.text == "angle" and style == "edge":
            return rng.choice(ANGLES)
        if style in ("zero", "one"):
            return Fraction(0 if self.zero and style == "zero" else self.sign or 1)
        s = self.sign or rng.choice([1, -1])
        if style == "near":
            return Fraction(s, rng.choice([5, 10, 30, 100]))
        if style == "small":
            return Fraction(
                s * rng.choice([0 if self.zero and rng.random() < 0.3 else 1, 1, 2, 2, 3, 4, 5])
            )
        if style == "wild":
            return s * fraction(rng) * Fraction(10) ** rng.choice([-9, -4, 4, 9])
        if style == "edge":
            halves = [
                Fraction(s),
                Fraction(s, 2),
                Fraction(3 * s, 2),
                Fraction(5 * s, 2),
                Fraction(s, 3),
            ]
            return Fraction(0) if self.zero and rng.random() < 0.3 else rng.choice(halves)
        return s * (1 - fraction(rng, 1, 6) / 1 if rng.random() < 0.3 else fraction(rng))

    def simple(self):
        return [x for x in map(Fraction, (1, 0, 2, -1, 3, -2)) if self.contains(x)]

    def stretch(self, t, values):
        """Return the value for a parameter t in (-1, 1), for a search that goes downhill."""
        x = Fraction(t) / (1 - abs(Fraction(t)))
        if self.text == "angle":
            return 4 * Fraction(t)
        return x if self.sign is None else self.sign * (1 + Fraction(t)) / (1 - Fraction(t))

    def inside(self, e, positive):
        """Whether the formula `e` is proved to lie in this domain, which must be open."""
        if self.sign is None:
            return self.zero
        return not self.zero and positive(self.sign * e)


class Interval(Domain):
    """An interval whose ends are exact numbers, or depend on other names."""

    real = True

    def __init__(self, name, text, low, high, closed):
        super().__init__(name, text)
        self.low, self.high, self.closed = low, high, closed
        fixed = low.is_number and high.is_number
        if fixed and not low < high:
            raise Unreadable(f"the domain {text!r} of {name} is empty")
        facts = {"real": True}
        if low.is_nonnegative:
            facts = {"nonnegative": True} if closed[0] and low == 0 else {"positive": True}
        elif high.is_nonpositive:
            facts = {"nonpositive": True} if closed[1] and high == 0 else {"negative": True}
        self.symbol = sp.Symbol(name, **facts)
        self.free = {self.symbol: self._parameter()} if fixed else {}
        if self.free.get(self.symbol) == self.symbol:
            self.free = {}

    def _parameter(self):
        u = sp.Symbol(self.name + "_u", positive=True)
        v = sp.Symbol(self.name + "_u", nonnegative=True)
        low, high = self.low, self.high
        if (low == -sp.oo and high == sp.oo) or all(self.closed):
            return self.symbol
        if high == sp.oo:
            return low + (v if self.closed[0] else u) if low else self.symbol
        if low == -sp.oo:
            return high - (v if self.closed[1] else u) if high else self.symbol
        if self.closed[1]:
            return (low * v + high) / (1 + v)
        w = v if self.closed[0] else u
        return (low + high * w) / (1 + w)

    def _ends(self, values):
        return [_placed(end, values) for end in (self.low, self.high)]

    def contains(self, x, values=None):
        low, high = self._ends(values or {})
        above = x > low or (self.closed[0] and x == low)
        return bool(above and (x < high or (self.closed[1] and x == high)))

    def draw(self, rng, style, values):
        low, high = self._ends(values)
        if not low < high:
            raise NoRoom
        if style in ("zero", "one") and self.contains(sp.Integer(style == "one"), values):
            return Fraction(style == "one")
        if style == "edge" and any(self.closed) and rng.random() < 0.7:
            return rng.choice([e for e, c in zip((low, high), self.closed, strict=True) if c])
        if high == sp.oo or low == -sp.oo:
            step = fraction(rng) if style != "small" else Fraction(rng.randint(1, 4))
            if style == "wild":
                step *= Fraction(10) ** rng.choice([-9, -4, 4, 9])
            if low == -sp.oo == -high:
                return rng.choice([1, -1]) * step
            return exact(low + sp.Rational(step) if high == sp.oo else high - sp.Rational(step))
        if style == "small" and high - low > 1 and rng.random() < 0.6:
            inside = [k for k in range(int(sp.floor(low)), int(min(high, low + 12)) + 2)]
            inside = [Fraction(k) for k in inside if self.contains(sp.Integer(k), values)]
            if inside:
                return rng.choice(inside)
        if style == "small":
            share = Fraction(*rng.choice([(1, 2), (1, 4), (3, 4), (1, 3), (2, 3)]))
        elif style in ("wild", "edge", "near"):
            share = Fraction(1, 10 ** rng.choice([3, 6, 9] if style != "near" else [1, 2]))
            share = rng.choice([share, 1 - share])
        else:
            share = Fraction(rng.randint(1, 96), 97)
        return exact(low + (high - low) * sp.Rational(share))

    def simple(self):
        low, high = self.low, self.high
        if not (low.is_number and high.is_number):
            return []
        if low == -sp.oo or high == sp.oo:
            tries = [sp.Integer(k) for k in (0, 1, 2, -1, 3)]
        else:
            middle = [low + (high - low) * sp.Rational(*t) for t in ((1, 2), (1, 4), (3, 4))]
            tries = [sp.Integer(1), sp.Rational(1, 2), sp.Integer(2), *middle]
        return [exact(x) for x in tries if self.contains(x)]

    def stretch(self, t, values):
        share = (1 + sp.Rational(t)) / 2
        low, high = self._ends(values)
        if low == -sp.oo and high == sp.oo:
            return Fraction(t) / (1 - abs(Fraction(t)))
        if high == sp.oo:
            return rational(low + share / (1 - share))
        if low == -sp.oo:
            return rational(high - share / (1 - share))
        return rational(low + (high - low) * share)

    def inside(self, e, positive):
        if any(self.closed):
            return False
        ends = ([e - self.low] if self.low != -sp.oo else []) + (
            [self.high - e] if self.high != sp.oo else []
        )
        return all(map(positive, ends))


class Whole(Domain):
    """Whole numbers from `low` to `high`; the ends may depend on other names."""

    whole = True

    def __init__(self, name, text, low, high):
        super().__init__(name, text)
        self.low, self.high = low, high
        facts = {"integer": True}
        if low.is_positive:
            facts["positive"] = True
        elif low.is_nonnegative:
            facts["nonnegative"] = True
        self.symbol = sp.Symbol(name, **facts)
        if low.is_number and low > 1:
            self.free = {self.symbol: low + sp.Symbol(name + "_u", integer=True, nonnegative=True)}

    def contains(self, x, values=None):
        low, high = (_placed(end, values or {}) for end in (self.low, self.high))
        return bool(low <= x <= high)

    def draw(self, rng, style, values, longest=10**7):
        low, high = (_placed(end, values) for end in (self.low, self.high))
        if low == -sp.oo:
            return Fraction(rng.choice([1, -1]) * rng.choice([0, 1, 2, 3, 5, 12]))
        high = min(high, longest)
        if high < low:
            raise NoRoom
        if style in ("zero", "one"):
            n = max(low, int(style == "one"))
        elif style in ("small", "fraction", "near"):
            n = low + rng.choice([0, 1, 1, 2, 2, 3, 4, 5, 6])
        elif style == "edge":
            n = rng.choice([low, high]) if high < 10**6 else low
        else:
            n = rng.choice([k for k in LARGE if k >= low] or [low])
        return Fraction(int(min(n, high)))

    def simple(self):
        return [Fraction(int(self.low + k)) for k in range(4)] if self.low.is_number else []


class Index(Whole):
    """A place in the sequences of a line: from 1 to the largest size that the line has."""

    def draw(self, rng, style, values, longest=10**7):
        high = min(values.get("", (0, 0, 7))[2], longest)
        return Fraction(rng.randint(1, max(1, int(high))))

    def simple(self):
        return [Fraction(1), Fraction(2)]


class Sequence(Domain):
    """Numbers with an index, each from the domain `element`."""

    kind = "sequence"

    def __init__(self, name, text, element):
        super().__init__(name, text)
        self.element = element
        facts = element.symbol.assumptions0
        facts = {n: facts[n] for n in ("integer", "positive", "nonnegative") if facts.get(n)}
        self.symbol = sp.IndexedBase(name, real=True, **facts)


class Abstract(Domain):
    """A smooth function of one or several real arguments."""

    kind = "function"
    arguments = 1

    def __init__(self, name, text):
        super().__init__(name, text)
        self.symbol = sp.Function(name, real=True)

    def draw(self, rng, style, values):
        xs = [sp.Dummy("x") for _ in range(self.arguments)]

        def mixed():
            return sum(rng.choice([1, 2, -1, sp.Rational(1, 2), -3]) * x for x in xs) + rng.randint(
                -2, 2
            )

        if style == "small":
            x = xs[0]
            one = rng.choice([x**2, x**3 + x, x**2 - 3 * x + 1, 2 * x**3 - x**2])
            more = sum(k * x * y**2 + y**4 - k * y**3 * x for k, y in enumerate(xs[1:], 2))
            return sp.Lambda(tuple(xs), one + more)
        a, b = (sp.Rational(rng.randint(1, 9), rng.choice([2, 4])) for _ in range(2))
        body = a * mixed() ** 3 + b * sp.sin(mixed()) + sp.exp(mixed() / 5) - mixed() ** 4 / 7
        return sp.Lambda(tuple(xs), body)


class Matrix(Domain):
    """Vectors and matrices of a fixed size."""

    def __init__(self, name, text):
        super().__init__(name, text)
        m = re.fullmatch(r"(vec|mat|spd|chol|sym|rot|se)([1-6])?(?:x([1-6]))?", text)
        if not m or (m[1] == "se" and text != "se2") or (m[3] and m[1] != "mat"):
            raise _unknown(text)
        self.family = m[1]
        rows = int(m[2] or 2) + (self.family == "se")
        self.kind = (rows, 1 if self.family == "vec" else int(m[3] or rows))
        self.symbol = self._by_quaternion() if text == "rot3" else self._explicit()

    def _by_quaternion(self):
        """Every rotation in space, by a quaternion of any length but zero."""
        w, x, y, z = sp.symbols([f"{self.name}_{k}" for k in "wxyz"], real=True)
        v = sp.Matrix([x, y, z])
        cross = sp.Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        R = (w**2 - v.dot(v)) * sp.eye(3) + 2 * v * v.T + 2 * w * cross
        return (R / (w**2 + x**2 + y**2 + z**2)).as_immutable()

    def _explicit(self):
        rows, columns = self.kind
        n = self.name

        def entry(i, j):
            i, j = (max(i, j), min(i, j)) if self.family == "sym" else (i, j)
            if self.family in ("spd", "chol") and i < j:
                return sp.Integer(0)
            positive = self.family in ("spd", "chol") and i == j
            facts = {"positive": True} if positive else {"real": True}
            return sp.Symbol(f"{n}_{i}" if columns == 1 else f"{n}_{i}{j}", **facts)

        if self.family in ("rot", "se"):
            c, s = (sp.Symbol(f"{n}_{f}", real=True) for f in ("cos", "sin"))
            self.circle = s, c
            x, y = (sp.Symbol(f"{n}_{f}", real=True) for f in "xy")
            turn = [[c, -s], [s, c]]
            return sp.ImmutableMatrix(
                turn if self.family == "rot" else [[*turn[0], x], [*turn[1], y], [0, 0, 1]]
            )
        L = sp.ImmutableMatrix(rows, columns, entry)
        self.factor = L
        return L * L.T if self.family == "spd" else L

    @cached_property
    def inverse(self):
        """The inverse where it is known without dividing by a determinant, else None."""
        M = self.symbol
        if self.family == "spd":
            back = self.factor.adjugate() / self.factor.det()
            return (back.T * back).as_immutable()
        if self.family == "rot":
            return M.T
        if self.family == "se":
            R = M[:2, :2].T
            return R.row_join(-R * M[:2, 2]).col_join(sp.ImmutableMatrix([[0, 0, 1]]))
        return None

    def draw(self, rng, style, values):
        return self._drawn(rng, style)

    def _drawn(self, rng, style):
        rows, columns = self.kind
        scale = Fraction(10) ** rng.choice([-9, -4, 0, 0, 4]) if style == "wild" else 1

        def number(positive=False):
            x = Fraction(rng.randint(1, 3)) if style in ("small", "edge") else fraction(rng)
            return scale * (x if positive else rng.choice([x, -x, x - 1]))

        if style == "one" and rows == columns:
            return [[Fraction(int(i == j)) for j in range(rows)] for i in range(rows)]
        if style == "zero" and self.family in ("vec", "mat", "sym"):
            return [[Fraction(0)] * columns for _ in range(rows)]
        if self.family in ("rot", "se"):
            return self._turn(rng, style, rows, number)
        if style == "edge" and rng.random() < 0.4 and self.family in ("vec", "mat", "sym"):
            return [[Fraction(0)] * columns for _ in range(rows)]
        x = [[number() for _ in range(columns)] for _ in range(rows)]
        if self.family == "sym":
            return [[x[max(i, j)][min(i, j)] for j in range(columns)] for i in range(rows)]
        if self.family in ("spd", "chol"):
            bare = style == "zero" or (style == "edge" and rng.random() < 0.4)  # diagonal
            L = [
                [number(True) if i == j else x[i][j] * (i > j and not bare) for j in range(rows)]
                for i in range(rows)
            ]
            if self.family == "chol":
                return L
            return [[sum(a * b for a, b in zip(r, s, strict=True)) for s in L] for r in L]
        return x

    def _turn(self, rng, style, rows, number):
        size = rows - (self.family == "se")
        R = [[Fraction(int(i == j)) for j in range(size)] for i in range(size)]
        for i in range(size):
            for j in range(i):
                t = (
                    Fraction(rng.randint(-30, 30), 13)
                    if style != "small"
                    else rng.choice([0, 1, -1])
                )
                c, s = (1 - t**2) / Fraction(1 + t**2), 2 * t / Fraction(1 + t**2)
                for row in R:
                    row[i], row[j] = c * row[i] - s * row[j], s * row[i] + c * row[j]
        if self.family == "se":
            R = [[*row, number()] for row in R] + [[Fraction(0)] * size + [Fraction(1)]]
        return R

    def simple(self):
        rows, columns = self.kind
        if columns == 1:
            return [[[Fraction(i + 1)] for i in range(rows)]]
        rng = random.Random(0)
        return [self.draw(rng, "small", {})]


class Sized(Matrix):
    """Vectors and matrices whose size is a declared letter."""

    def __init__(self, name, text, family, sizes):
        Domain.__init__(self, name, text)
        self.family = family
        self.kind = (sizes[0], sp.Integer(1) if family == "vec" else sizes[-1])
        self.symbol = sp.MatrixSymbol(name, *self.kind)
        self.free = {}

    inverse = None

    def fits(self, x, values):
        """Whether the matrix `x`, a list of rows, has the size that the letters say."""
        if not isinstance(x, list):
            return True
        return (len(x), len(x[0])) == tuple(_placed(n, values) for n in self.kind)

    def draw(self, rng, style, values):
        """Draw as a matrix of the size that the letters have at this point."""
        rows, columns = (int(_placed(n, values)) for n in self.kind)
        if max(rows, columns) > 5:
            raise NoRoom
        fixed = object.__new__(Matrix)
        fixed.family, fixed.kind = self.family, (rows, columns)
        return fixed._drawn(rng, style)

    def simple(self):
        return []


def _placed(end, values):
    """Return the end of a domain as a number, with the names in it at their values."""
    if end.is_number:
        return end
    numbers = {s: sp.Rational(values[s.name]) for s in end.free_symbols}
    return end.subs(numbers)


def rational(x):
    """Return a fraction that is, or is close to, the SymPy number `x`."""
    return exact(x) if x.is_Rational else Fraction(float(x))


def exact(x):
    """Return a SymPy number as a fraction if it is rational; others stay as they are."""
    return Fraction(int(x.p), int(x.q)) if x.is_Rational else x
