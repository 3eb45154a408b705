"""Domains: how to draw a value, and the parameters in which SymPy can reason about them."""

import random
import re

import mpmath
import sympy as sp

from .reading import SHAPES, Unreadable

NAMED = {"real", "nonzero", ">0", ">=0", "angle", "seq", "index", "function", *SHAPES}


class Domain:
    """One declared name: its `symbol` (or explicit matrix) and its reparametrization `free`."""

    def __init__(self, name, text):
        self.name, self.text = name, str(text).replace(" ", "")
        self.low = self.high = self.factor = None
        if m := re.fullmatch(r"int>=?(-?\d{1,6})", self.text):
            self.kind, self.low = "int", int(m[1]) + (">=" not in self.text)
        elif m := re.fullmatch(r"([(\[])(-?[\w./]+),(-?[\w./]+)([)\]])", self.text):
            self.kind = "interval"
            self.low, self.high = _bound(m[2], text), _bound(m[3], text)
            self.closed = (m[1] == "[", m[4] == "]")
            if not self.low < self.high:
                raise Unreadable(f"the domain {text!r} of {name} is empty")
        elif self.text in NAMED:
            self.kind = self.text
        else:
            raise Unreadable(
                f"{text!r} is not a domain; use {', '.join(sorted(NAMED))}, (a,b) or int>=k"
            )
        self._make()

    def _make(self):
        n = self.name
        u = sp.Symbol(n + "_u", positive=True)
        self.free = self.algebra = {}
        if self.kind in SHAPES:
            self.symbol, self.algebra = _matrix(n, self.kind)
            if self.kind in ("spd2", "spd3"):
                self.factor, self.symbol = self.symbol, self.symbol * self.symbol.T
            return
        facts = {
            ">0": {"positive": True},
            ">=0": {"nonnegative": True},
            "nonzero": {"real": True, "nonzero": True},
            "index": {"integer": True, "positive": True},
        }.get(self.kind, {"real": True})
        if self.kind == "int":
            facts = {"integer": True} | (
                {"positive": True}
                if self.low > 0
                else {"nonnegative": True}
                if self.low == 0
                else {}
            )
            self.symbol = sp.Symbol(n, **facts)
            if self.low > 1:
                self.free = {
                    self.symbol: self.low + sp.Symbol(n + "_u", integer=True, nonnegative=True)
                }
            return
        if self.kind == "interval":
            facts = (
                {"positive": True}
                if self.low >= 0
                else {"negative": True}
                if self.high <= 0
                else {"real": True}
            )
            if any(self.closed):
                facts = {"nonnegative": True} if self.low >= 0 else {"real": True}
            self.symbol = sp.Symbol(n, **facts)
            if (self.low == -sp.oo and self.high == sp.oo) or any(self.closed):
                return
            if self.high == sp.oo:
                self.free = {self.symbol: self.low + u} if self.low else {}
            elif self.low == -sp.oo:
                self.free = {self.symbol: self.high - u}
            else:
                self.free = {self.symbol: (self.low + self.high * u) / (1 + u)}
            return
        self.symbol = sp.Symbol(n, **facts)

    def contains(self, x):
        """Whether the number x (mpf) lies in the domain; for a root that was found."""
        if self.kind == "interval":
            low, high = (
                (float("-inf") if self.low == -sp.oo else self.low),
                (float("inf") if self.high == sp.oo else self.high),
            )
            low, high = [_mpf(v) for v in (low, high)]
            return (low < x or (self.closed[0] and low == x)) and (
                x < high or (self.closed[1] and x == high)
            )
        return {">0": x > 0, ">=0": x >= 0, "nonzero": x != 0}.get(self.kind, True)

    def settled(self, x):
        """Return a zero that was found, put exactly on the end of the domain if it is there."""
        from .evaluating import Unreliable

        for end in (0, self.low, self.high):
            if end is not None and end not in (sp.oo, -sp.oo):
                close = abs(x - _mpf(sp.Rational(end)))
                x = _mpf(sp.Rational(end)) if close < mpmath.mpf(2) ** (-mpmath.mp.prec // 2) else x
        if not self.contains(x):
            raise Unreliable("a zero outside the domain")
        return x

    def surely(self, e, positive):
        """Whether the formula e is proved to lie in this (open, connected) domain."""
        if self.kind == "interval":
            ends = [
                e - self.low if self.low != -sp.oo else 1,
                self.high - e if self.high != sp.oo else 1,
            ]
            return not any(self.closed) and all(d == 1 or positive(d) for d in ends)
        return self.kind == "real" or (self.kind == ">0" and positive(e))

    def draw(self, rng, style):
        """A value: `small` integers, `fraction`s, `wild` magnitudes, `edge` of the domain."""
        k = self.kind
        if k == "function":
            return draw_function(rng, style)
        if k in SHAPES:
            return _draw_matrix(k, rng, style)
        if k == "int":
            return sp.Integer(
                self.low + rng.choice([0, 1, 2, 2, 4]) if style != "edge" else self.low
            )
        if k == "index":
            return sp.Integer(1)
        if k == "interval" and (self.low != -sp.oo or self.high != sp.oo):
            return self._draw_interval(rng, style)
        if k == "angle":
            if style == "edge":
                return rng.choice(
                    [sp.Integer(0), sp.pi, -sp.pi, sp.pi / 2, -sp.pi / 2, 2 * sp.pi, sp.pi / 4]
                )
            return (
                rng.choice([1, -1]) * _fraction(rng)
                if style != "small"
                else sp.Integer(rng.randint(-4, 4))
            )
        sign = 1 if k in (">0", ">=0") else rng.choice([1, -1])
        if style == "small":
            low = 0 if k in ("real", "interval", ">=0", "seq") and rng.random() < 0.12 else 1
            return sign * sp.Integer(rng.choice([low, 1, 1, 2, 2, 3, 3, 4, 5]))
        if style == "wild" and rng.random() < 0.7:
            return sign * _fraction(rng) * sp.Integer(10) ** rng.choice([-9, -4, 4, 9])
        if style == "edge" and k not in (">0", "nonzero") and rng.random() < 0.5:
            return sp.Integer(0)
        if style == "edge" and rng.random() < 0.5:
            return sign * sp.Integer(1)
        return sign * _fraction(rng, style)

    def _draw_interval(self, rng, style):
        low, high = self.low, self.high
        if style == "edge":
            ends = [v for v, c in ((low, self.closed[0]), (high, self.closed[1])) if c]
            if ends and rng.random() < 0.7:
                return rng.choice(ends)
        if high == sp.oo or low == -sp.oo:
            step = _fraction(rng) if style != "small" else sp.Integer(rng.randint(1, 4))
            return low + step if high == sp.oo else high - step
        if style == "small":
            t = rng.choice(
                [
                    sp.Rational(1, 2),
                    sp.Rational(1, 4),
                    sp.Rational(3, 4),
                    sp.Rational(1, 3),
                    sp.Rational(2, 3),
                ]
            )
        elif style in ("wild", "edge") and rng.random() < 0.7:
            t = sp.Rational(1, 10 ** rng.choice([3, 6, 9]))
            t = rng.choice([t, 1 - t])
        else:
            t = sp.Rational(rng.randint(1, 96), 97)
        return low + (high - low) * t

    def simple(self):
        """Values from simple to less simple, for the counterexample that is shown."""
        if self.kind == "int":
            return [sp.Integer(self.low + k) for k in range(3)]
        if self.kind == "interval":
            if self.low == -sp.oo or self.high == sp.oo:
                tries = [sp.Integer(k) for k in (0, 1, 2, -1)]
            else:
                tries = [
                    self.low + (self.high - self.low) * sp.Rational(*t)
                    for t in ((1, 2), (1, 4), (3, 4))
                ]
            return [v for v in tries if self.low < v < self.high]
        if self.kind in SHAPES or self.kind == "function":
            rng = random.Random(0)
            return [self.draw(rng, "simplest")] if self.kind != "function" else []
        values = [sp.Integer(k) for k in (1, 0, 2, -1, 3)]
        return [v for v in values if self.contains(v)]


def _mpf(v):
    return mpmath.mpf(v.p) / v.q if isinstance(v, sp.Rational) else mpmath.mpf(v)


def _bound(text, whole):
    text = {"inf": "oo", "-inf": "-oo"}.get(text, text)
    try:
        if text in ("oo", "-oo"):
            return sp.oo if text == "oo" else -sp.oo
        if text.lstrip("-") == "pi":
            return sp.Rational(355, 113) * (-1 if text[0] == "-" else 1)
        return sp.Rational(text)
    except (TypeError, ValueError, ZeroDivisionError):
        raise Unreadable(f"{whole!r} is not a domain: the ends of (a,b) are numbers") from None


def _fraction(rng, style="fraction"):
    """Draw a positive rational; `below` and `above` stay on one side of 1."""
    if style == "below":
        return sp.Rational(rng.randint(1, 60), 61)
    if style == "above":
        return 1 + sp.Rational(rng.randint(1, 900), 7)
    return sp.Rational(rng.randint(1, 60), rng.choice([7, 11, 13, 17, 53, 97]))


def _matrix(n, kind):
    """The explicit matrix in its free parameters, and the relations c**2 + s**2 = 1 among them."""
    rows, cols = SHAPES[kind]
    if kind in ("vec2", "vec3"):
        return sp.ImmutableMatrix(rows, 1, lambda i, j: sp.Symbol(f"{n}_{i}", real=True)), {}
    if kind in ("spd2", "spd3", "chol2"):
        L = sp.ImmutableMatrix(
            rows,
            cols,
            lambda i, j: (
                sp.Symbol(f"{n}_l{i}{j}", positive=True)
                if i == j
                else sp.Symbol(f"{n}_l{i}{j}", real=True)
                if i > j
                else 0
            ),
        )
        return L, {}
    c, s = sp.Symbol(f"{n}_cos", real=True), sp.Symbol(f"{n}_sin", real=True)
    if kind == "rot":
        return sp.ImmutableMatrix([[c, -s], [s, c]]), {s: c}
    x, y = sp.Symbol(f"{n}_x", real=True), sp.Symbol(f"{n}_y", real=True)
    return sp.ImmutableMatrix([[c, -s, x], [s, c, y], [0, 0, 1]]), {s: c}


def _draw_matrix(kind, rng, style):
    rows, cols = SHAPES[kind]

    def number(positive=False):
        if style == "simplest":
            return sp.Integer(1)
        x = sp.Integer(rng.randint(1, 3)) if style in ("small", "edge") else _fraction(rng)
        return x if positive else rng.choice([x, -x, x - 1])

    if kind in ("vec2", "vec3"):
        if style == "edge" and rng.random() < 0.5:
            return sp.ImmutableMatrix.zeros(rows, 1)
        return sp.ImmutableMatrix(
            rows, 1, lambda i, j: sp.Integer(i + 1) if style == "simplest" else number()
        )
    if kind in ("spd2", "spd3", "chol2"):
        L = sp.ImmutableMatrix(
            rows, cols, lambda i, j: number(True) if i == j else number() if i > j else 0
        )
        return L if kind == "chol2" else L * L.T
    c, s = (
        {"simplest": [(0, 1)], "small": [(0, 1), (-1, 0), (0, -1)]}.get(style)
        and rng.choice({"simplest": [(0, 1)], "small": [(0, 1), (-1, 0), (0, -1)]}[style])
    ) or _turn(rng)
    if kind == "rot":
        return sp.ImmutableMatrix([[c, -s], [s, c]])
    return sp.ImmutableMatrix([[c, -s, number()], [s, c, number()], [0, 0, 1]])


def _turn(rng):
    """A rational point on the circle."""
    t = sp.Rational(rng.randint(-30, 30), 13)
    return (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)


def draw_function(rng, style):
    """Draw a smooth function, as a SymPy Lambda: a polynomial, or one with exp and sin."""
    x = sp.Symbol("x")
    a, b, c = (sp.Rational(rng.randint(-9, 9) or 1, rng.choice([1, 2, 4])) for _ in range(3))
    if style == "small":
        return sp.Lambda(x, rng.choice([x**2, x**3 + x, x**2 - 3 * x + 1, 2 * x**3 - x**2]))
    return sp.Lambda(x, a * x**3 + b * x**2 + c * sp.sin(x) + sp.exp(x / 5))
