"""The value of a written form at one point, with the meaning of real analysis.

Nothing is simplified on the way, so what a line does not define (1/0, log of a negative number, an
integral that diverges) is seen as not defined.
"""

import itertools
from fractions import Fraction
from functools import lru_cache

import sympy as sp
from mpmath import libmp
from sympy.core.function import AppliedUndef
from sympy.matrices.expressions.matexpr import MatrixElement

from . import breaks
from .arithmetic import (
    Arithmetic,
    Imprecise,
    Undefined,
    Unreliable,
    as_float,
    certain_sign,
    fraction,
    sign,
    whole,
)
from .reading import rebuild, renamed

LONGEST_SUM = 10_000
LONGEST_SERIES = 400
LARGEST_MATRIX = 6
BENT = (*breaks.BENT, AppliedUndef)
A = Arithmetic
FUNCTIONS = {
    sp.sin: A.sin,
    sp.cos: A.cos,
    sp.tan: A.tan,
    sp.cot: A.cot,
    sp.sinh: A.sinh,
    sp.cosh: A.cosh,
    sp.tanh: A.tanh,
    sp.asin: A.asin,
    sp.acos: A.acos,
    sp.atan: A.atan,
    sp.atan2: A.atan2,
    sp.exp: A.exp,
    sp.log: A.log,
    sp.Abs: A.absolute,
    sp.sign: A.signum,
    sp.Max: A.largest,
    sp.Min: A.smallest,
    sp.gamma: A.gamma,
    sp.loggamma: lambda a, x: a.log(a.gamma(x)),
    sp.factorial: A.factorial,
    sp.polygamma: lambda a, n, x: a.trusted(lambda y: a.mp.polygamma(whole(n), y), x),
    sp.digamma: lambda a, x: a.trusted(a.mp.digamma, x),
    sp.binomial: A.binomial,
    sp.beta: A.beta,
    sp.erf: A.erf,
    sp.erfc: A.erfc,
    sp.uppergamma: lambda a, s, x: a.trusted(a.mp.gammainc, s, x),
    sp.lowergamma: lambda a, s, x: a.trusted(lambda t, y: a.mp.gammainc(t, 0, y), s, x),
    sp.Mod: A.modulo,
    sp.KroneckerDelta: A.delta,
    sp.Heaviside: A.heaviside,
    sp.Add: lambda a, *xs: a.add(xs),
    sp.Mul: lambda a, *xs: a.multiply(xs),
    sp.Pow: A.power,
}
SCOPES = (sp.Sum, sp.Product, sp.Integral, sp.Limit, sp.Subs, sp.Derivative, sp.Indexed)
NUMBERS = {sp.pi: A.pi, sp.E: lambda a: a.exp(Fraction(1))}
ORDER = {sp.Gt: (1,), sp.Ge: (1, 0), sp.Lt: (-1,), sp.Le: (-1, 0), sp.Eq: (0,), sp.Ne: (1, -1)}


class Budget:
    """How many nodes may still be evaluated; counted, so that every machine gives one verdict."""

    def __init__(self, nodes):
        self.left = nodes

    def spend(self, nodes=1):
        self.left -= nodes
        if self.left < 0:
            raise Unreliable("too long to evaluate")


class Point:
    """A place: values of the symbols and functions, elements of the sequences, a precision.

    ``make(arithmetic)`` returns the values of the declared names: numbers, lists of rows for
    matrices, a SymPy ``Lambda`` for an abstract function. ``entry(name, index, at)`` is an element
    of a sequence.
    """

    def __init__(self, make, entry, arithmetic, budget):
        self.make, self.entry, self.budget = make, entry, budget
        self.arithmetic = arithmetic
        self.known, self.bound = {}, {}
        self.values = make(self.arithmetic)

    def _copy(self, **changes):
        at = object.__new__(Point)
        at.__dict__ = {**self.__dict__, **changes}
        return at

    def bind(self, name, number, again=None):
        """Return the point with one more value; ``again(at)`` finds it in other precisions."""
        name = key(name) if isinstance(name, sp.Symbol) else name
        bound = {**self.bound, name: again or (lambda at: number)}
        return self._copy(values={**self.values, name: number}, bound=bound)

    def sharper(self, factor):
        """Return the same point in so many times the digits."""
        at = self._copy(arithmetic=Arithmetic(factor * self.arithmetic.prec), known={})
        at.values = self.make(at.arithmetic)
        for name, again in self.bound.items():
            at.values[name] = again(at)
        return at


def key(symbol):
    """Return what a symbol is called in `Point.values`: a bound letter is only itself."""
    return symbol if isinstance(symbol, sp.Dummy) else symbol.name


def value(w, at):
    """The value of the written form `w`: a number, or a list of rows for a matrix."""
    at.budget.spend()
    if w.is_Rational:
        return Fraction(int(w.p), int(w.q))
    if isinstance(w, sp.Symbol | sp.MatrixSymbol):
        try:
            return at.values[key(w)]
        except KeyError:
            raise Unreliable(f"no value for {w}") from None
    a, kind = at.arithmetic, w.func
    if kind in FUNCTIONS:
        return FUNCTIONS[kind](a, *[value(x, at) for x in w.args])
    if w in NUMBERS:
        return NUMBERS[w](a)
    rule = RULES.get(kind)
    if rule is not None:
        return rule(w, at)
    if isinstance(w, sp.MatrixBase):
        return [[value(w[i, j], at) for j in range(w.cols)] for i in range(w.rows)]
    if isinstance(w, AppliedUndef):
        f = at.values[w.func.__name__]
        for name, x in zip(f.variables, w.args, strict=True):
            at = at.bind(name, value(x, at), lambda at, x=x: value(x, at))
        return value(f.expr, at)
    raise Unreliable(f"no rule for {kind.__name__}")


def integer(w, at, kind):
    n = whole(value(w, at))
    if n is None:
        raise Undefined(kind)
    return n


def _indexed(w, at):
    return at.entry(str(w.base.label), tuple(integer(k, at, "index") for k in w.indices), at)


# ---- sums, products, limits ----------------------------------------------------------------------


def _sum(w, at, combine=Arithmetic.add):
    name, low, high = w.limits[-1]
    body = w.function if len(w.limits) == 1 else w.func(w.function, *w.limits[:-1])
    first = integer(low, at, "ends")
    if high == sp.oo:
        return _series(body, name, first, at, combine)
    last = integer(high, at, "ends")
    if last - first > LONGEST_SUM:
        raise Unreliable("a long sum")
    terms = [value(body, at.bind(name, Fraction(k))) for k in range(first, last + 1)]
    return combine(at.arithmetic, terms)


def _series(body, name, first, at, combine):
    """An infinite sum: terms that fall like a geometric series, or slower ones by mpmath."""
    if combine is not Arithmetic.add:
        raise Unreliable("an infinite product")
    a = at.arithmetic

    def term(k):
        return value(body, at.bind(name, Fraction(k)))

    total, last, bound = [], None, None
    for k in range(first, first + LONGEST_SERIES):
        t = term(k)
        total.append(t)
        size = a.mp.make_mpf(a.size(t))
        ratio = size / last if last else None
        falls = ratio is not None and ratio < 0.9
        bound = size * ratio / (1 - ratio) if falls else None
        last = size
        if k > first + 8 and falls and bound < a.mp.mpf(2) ** -a.prec:
            break
        if k > first + 8 and size == 0:
            return a.add(total)
    if bound is not None and bound < abs(a.number(a.add(total))) * a.mp.mpf(2) ** -60:
        return a.add([a.add(total), a.around(0, 4 * bound)])
    _refuse_slow_decay(term, [10**3, 10**3 + 1, 10**4, 10**4 + 1, 10**5, 10**5 + 1], a)
    signs = {sign(t) for t in total}
    a.mp.dps = 20
    try:
        s = a.mp.nsum(lambda k: a.number(term(int(k))), [first, a.mp.inf])
        if len(signs) == 1 and abs(s) < abs(a.number(a.add(total))):
            raise Unreliable("a series of which the first terms tell nothing")
    except (ValueError, ZeroDivisionError, OverflowError):
        raise Unreliable("a series that does not settle") from None
    finally:
        a.mp.prec = a.prec + 40
    return a.around(s, abs(s) * a.mp.mpf(10) ** -12)


def _refuse_slow_decay(f, places, a):
    """Raise `Undefined` if x f(x) does not fall: then neither sum nor integral converges."""
    sizes = [a.number(f(x)) * x for x in places]
    same = len({x > 0 for x in sizes}) == 1 and 0 not in sizes
    if all((x > 0) != (y > 0) for x, y in zip(sizes[::2], sizes[1::2], strict=True)):
        if abs(sizes[-1]) * places[0] >= abs(sizes[0]) * places[-1] * 0.99:
            raise Undefined("converges")
        return  # alternating, and the terms fall
    if same and all(abs(y) >= abs(x) * 0.99 for x, y in itertools.pairwise(sizes)):
        raise Undefined("converges")
    if not same or abs(sizes[-1]) > abs(sizes[0]) / 2:
        raise Unreliable("slow or changing terms")


def _limit(w, at):
    body, name, target, side = w.args
    if target == sp.oo and body.has(sp.Sum, sp.Product):
        return _extrapolated(body, name, at)
    sharp = at.sharper(8)
    a = sharp.arithmetic
    if target in (sp.oo, -sp.oo):
        s = 1 if target == sp.oo else -1
        paths = [[Fraction(s * 2**k) for k in (50, 70, 90)]]
    else:
        x = value(target, sharp)
        sides = {"+": [1], "-": [-1], "+-": [1, -1]}[str(side)]
        paths = [
            [a.add([x, Fraction(s, 2**k)]) for k in (a.prec // 8, a.prec // 6, a.prec // 5)]
            for s in sides
        ]
    ends = []
    for path in paths:
        try:
            ends.append([a.number(value(body, sharp.bind(name, x))) for x in path])
        except Undefined:  # a limit from the side on which there is something
            if path is paths[-1] and not ends:
                raise
    flat_ends = [x for path in ends for x in path[1:]]
    error = max(abs(x - y) for x in flat_ends for y in flat_ends)
    scale = 1 + abs(flat_ends[0])
    if error > scale * a.mp.mpf(10) ** -8:
        grows = all(abs(p[2]) > 100 * abs(p[1]) > 1e4 * abs(p[0]) for p in ends)
        jumps = all(abs(p[2] - p[1]) < error / 1000 for p in ends)
        raise Undefined("limit") if grows or jumps else Unreliable("a limit that does not settle")
    return at.arithmetic.around(flat_ends[-1], 2 * error + scale * a.mp.mpf(2) ** -60)


def _extrapolated(body, name, at):
    """A limit of sums: from 16, 32, ... 256 terms, the powers of 1/n removed one by one."""
    a = at.arithmetic
    row = [a.number(value(body, at.bind(name, Fraction(2**k)))) for k in range(4, 9)]
    power = 2
    while len(row) > 2:
        row = [(power * y - x) / (power - 1) for x, y in itertools.pairwise(row)]
        power *= 2
    error = abs(row[1] - row[0])
    if error > (1 + abs(row[1])) * 1e-4:
        raise Unreliable("a limit that does not settle")
    return a.around(row[1], 10 * error + a.mp.mpf(10) ** -9)


# ---- integrals -----------------------------------------------------------------------------------


def _integral(w, at):
    """One quadrature for each integral and point: it is what takes the time."""
    names = {key(v): at.values.get(key(v)) for v in w.free_symbols if hasattr(v, "name")}
    place = (w, *sorted((str(n), str(v)) for n, v in names.items()))
    if w.has(sp.Indexed):
        return _quadrature(w, at)
    if place not in at.known:
        at.known[place] = _quadrature(w, at)
    return at.known[place]


def _quadrature(w, at):
    if len(w.limits[-1]) != 3:
        raise Unreliable("an integral without limits")
    name, *ends = w.limits[-1]
    body = w.function if len(w.limits) == 1 else w.func(w.function, *w.limits[:-1])
    nested = body.has(sp.Integral)
    inmost = at.arithmetic.prec < 60
    if nested and inmost:
        raise Unreliable("more than two nested integrals")
    if body.has(sp.Derivative):
        body = rebuild(body, _carried_out)
    digits = 12 if nested or inmost else 22 if at.arithmetic.prec < 400 else 34
    rough = nested or inmost
    inner = at.sharper(1)
    inner.arithmetic = a = Arithmetic(4 * digits, lenient=True)
    mp = a.mp
    mp.dps = digits
    low, high = (_end(x, at, a) for x in ends)
    if low == high:
        return Fraction(0)
    turned = low > high
    low, high = min(low, high), max(low, high)

    def exact(x):
        return fraction(mp.mpf(x))

    def f(x):
        return value(body, inner.bind(name, x))

    def smooth(x):
        try:
            y = f(exact(x))
            return a.number(y) if sign(y) else mp.zero  # what is all rounding is as good as zero
        except Undefined as reason:
            if x in (low, high) or reason.kind == "kink":
                return mp.zero
            raise

    cuts = _cuts(body, name, low, high, inner, exact)
    sharp = inner if nested else inner._copy(arithmetic=Arithmetic(3500, lenient=True))

    def close(x):  # 10**-900 from an end, what rounding leaves of other numbers is too much
        return value(body, sharp.bind(name, x))

    _refuse_divergence(f, close, low, high, cuts, exact, a)
    at.budget.spend(40)
    try:
        total, error = mp.quad(smooth, [low, *cuts, high], error=True, maxdegree=4 if rough else 6)
        size = mp.quad(lambda x: abs(smooth(x)), [low, *cuts, high], maxdegree=3)
        for end, start in ((low, [*cuts, high][0]), (high, [low, *cuts][-1])):
            if mp.isinf(end) and not mp.isinf(start) and not rough:
                error += _tail_error(smooth, start, end, size, mp)
            elif not mp.isinf(end) and not mp.isinf(start):
                error += _end_error(smooth, end, start, digits, mp)
    except (ZeroDivisionError, OverflowError):
        raise Unreliable("an integral that does not settle") from None
    if not abs(total) < 1e100 or error > mp.mpf(10) ** (-4 if rough else -7) * (1 + size):
        raise Unreliable("an integral that does not settle")
    radius = 20 * error + (size or 1) * mp.mpf(10) ** (-digits + 4 + 2 * rough)
    return at.arithmetic.around(-total if turned else total, radius)


def _carried_out(w):
    """Return a derivative inside an integral in closed form, where that is beyond doubt."""
    if isinstance(w, sp.Derivative) and not w.expr.has(*BENT):
        return w.doit()
    return None


def _tail_error(f, start, end, size, mp):
    """Return how far two different quadratures of an infinite end are apart."""
    s = mp.sign(end)
    far = max(abs(f(start + s * mp.mpf(10) ** k / 4)) for k in (3, 4, 5))
    if far < mp.mpf(10) ** -40 * size:
        return 0  # falls exponentially: the plain one alone is right
    plain = mp.quad(lambda t: f(start + s * t), [0, mp.inf], maxdegree=5)
    stretched = mp.quad(lambda t: f(start + s * mp.expm1(t)) * mp.exp(t), [0, 5, 40], maxdegree=5)
    return abs(plain - stretched)


def _end_error(f, end, start, digits, mp):
    """Return what a quadrature can miss next to a finite end at which the integrand grows.

    No node is nearer to the end than rounding allows; there x^-p still has an area.
    """
    near = (start - end) * mp.mpf(10) ** -digits
    here, farther = (abs(f(end + step)) for step in (near, 10 * near))
    if not here or not farther:
        return 0
    power = min(mp.log10(here / farther), mp.mpf("0.99"))
    return abs(near) * here / (1 - power) if power > 0 else 0


def _end(w, at, a):
    if w in (sp.oo, -sp.oo):
        return a.mp.inf if w == sp.oo else -a.mp.inf
    return a.number(value(w, at))


def _cuts(body, name, low, high, at, exact):
    """Where the integrand breaks or bends, and in a long range around its middle."""
    mp = at.arithmetic.mp
    span = [max(low, mp.mpf(-30)), min(high, mp.mpf(30))]
    found = []
    if span[0] < span[1]:
        xs = [span[0] + (span[1] - span[0]) * (mp.mpf(k) + mp.mpf("0.37")) / 40 for k in range(40)]
        places = breaks.breaks(body, only=name)
        places += [g.diff(name) for g in places if g.has(sp.sin, sp.cos) and not g.has(*BENT)]
        for g in places:  # a wave may touch zero without a change of sign
            found += _roots_between(lambda x, g=g: sign_at(g, name, exact(x), at), xs)
    if mp.isinf(low) or mp.isinf(high):
        found += [c for c in (-4, 0, 4) if low < c < high]
    return sorted(set(found))


def sign_at(g, name, x, at):
    try:
        return sign(value(g, at.bind(name, x)))
    except (Undefined, Unreliable):
        return None


def _roots_between(f, xs):
    """Return where `f` changes its sign, to 60 bits."""
    signs = [f(x) for x in xs]
    found = []
    for (x, s), (y, t) in itertools.pairwise(zip(xs, signs, strict=True)):
        if s == 0:
            found.append(x)
        elif s and t and s != t:
            for _ in range(60):
                middle = (x + y) / 2
                m = f(middle)
                if not m:
                    x = middle
                    break
                x, y = (middle, y) if m == s else (x, middle)
            found.append(x)
    return found


def _refuse_divergence(f, close, low, high, cuts, exact, a):
    """Raise `Undefined` where the integrand grows like 1/x or faster, or does not fall so fast."""
    ten = Fraction(10)

    def near(place, s, f=f):
        return lambda k: (f(place + s * ten**-k), ten**-k)

    def far(s):
        return lambda k: (f(s * ten**k), ten**k)

    looks = []
    for end, inward in ((low, 1), (high, -1)):
        if a.mp.isinf(end):
            looks += [(far(-inward), (50, 500, 1000), 0.9), (far(-inward), (2, 4, 8), 1e10)]
        else:
            looks.append((near(exact(end), inward, close), (10, 100, 900), 0.9))
    looks += [(near(exact(x), s), (5, 8, 11), 0.9) for x in cuts for s in (1, -1)]
    if any(_grows(look, ks, factor, a) for look, ks, factor in looks):
        raise Undefined("converges")


def _grows(look, ks, factor, a):
    """Whether the areas under the integrand do not fall from place to place."""
    try:
        areas = [a.mp.make_mpf(a.least(y)) * a.number(h) for y, h in map(look, ks)]
    except (Unreliable, Undefined):
        return False
    return (
        areas[-1] > 1e-60
        and areas[0] > 0
        and all(y >= factor * x for x, y in itertools.pairwise(areas))
    )


# ---- derivatives, substitution, cases ------------------------------------------------------------


def _derivative(w, at):
    """The derivative where the function has a value: by formula where nothing can go wrong."""
    body = _inserted(w.expr, at)
    if body.has(*BENT, *SCOPES) or not all(v.is_Symbol for v in w.variables):
        return _difference(w, at)
    slope = _formula(body, tuple(w.variables))
    if slope.has(sp.Derivative):  # of a determinant, say, for which there is no formula
        return _difference(w, at)
    value(body, at)
    return value(slope, at)


@lru_cache(maxsize=500)
def _formula(body, variables):
    return body.diff(*variables)


def _inserted(w, at):
    """Return `w` with the abstract functions made concrete."""

    def leaf(x):
        if not isinstance(x, AppliedUndef):
            return None
        f = at.values[x.func.__name__]
        return renamed(
            f.expr, dict(zip(f.variables, (_inserted(a, at) for a in x.args), strict=True))
        )

    return rebuild(w, leaf) if w.has(AppliedUndef) else w


def _difference(w, at):
    """Central differences with two fine steps: their difference says how far they are off."""
    rough = w.expr.has(sp.Integral, sp.Limit) or any(
        high == sp.oo for s in w.expr.atoms(sp.Sum) for _, _, high in s.limits
    )
    prec = at.arithmetic.prec
    inner = at if rough else at.sharper(len(w.variables) + 3)
    a = inner.arithmetic
    here = value(w.expr, inner)  # a function has a derivative only where it has a value
    step = Fraction(1, 2 ** (18 if rough else prec // 2))
    slopes = [_slope(w.expr, w.variables, inner, h) for h in (step, step / 2)]
    if len(w.variables) == 1:
        gaps = [_gap(w, here, inner, h) for h in (step, step / 2)]
        if gaps[1] > a.mp.mpf(2) ** (-5 if rough else -prec // 3) and gaps[1] > 0.75 * gaps[0]:
            raise Undefined("kink")
    error = abs(a.number(a.subtract(*slopes)))
    size = abs(a.number(slopes[1]))
    return a.add(
        [slopes[1], a.around(0, 2 * error + size * a.mp.mpf(2) ** (-30 if rough else -prec))]
    )


def _slope(w, variables, at, step):
    if not variables:
        return value(w, at)
    a, rest = at.arithmetic, variables[1:]
    ends = [_slope(w, rest, _moved(at, variables[0], s * step), step) for s in (1, -1)]
    return a.multiply([a.subtract(*ends), 1 / (2 * step)])


def _gap(w, here, at, step):
    """Return by how much the slopes to the right and to the left differ."""
    a = at.arithmetic
    ends = [value(w.expr, _moved(at, w.variables[0], s * step)) for s in (1, -1)]
    bend = a.subtract(a.add(ends), a.multiply([Fraction(2), here]))
    return abs(a.number(a.multiply([bend, 1 / step])))


def _moved(at, variable, step):
    """Return the point with the variable, a symbol or an element of a sequence, moved on."""
    if not isinstance(variable, sp.Indexed):
        name = key(variable)
        again = at.bound.get(name)

        def moved(at):
            here = again(at) if again else at.make(at.arithmetic)[name]
            return at.arithmetic.add([here, step])

        return at.bind(name, at.arithmetic.add([at.values[name], step]), moved)
    place = str(variable.base.label), tuple(integer(k, at, "index") for k in variable.indices)
    known = at.entry

    def entry(name, index, at):
        x = known(name, index, at)
        return at.arithmetic.add([x, step]) if (name, index) == place else x

    return at._copy(entry=entry)


def _subs(w, at):
    for name, place in zip(w.variables, w.point, strict=True):
        at = at.bind(name, value(place, at), lambda at, place=place: value(place, at))
    return value(w.args[0], at)


def _rounded(w, at):
    """Floor and ceiling; what is whole to hundreds of digits is whole, unless an exponential."""
    a = at.arithmetic
    x = value(w.args[0], at)
    try:
        return a.floor(x) if isinstance(w, sp.floor) else a.ceiling(x)
    except Imprecise:
        if a.prec < 800 or w.has(sp.exp, sp.tanh, sp.erf, sp.erfc, sp.cosh, sp.sinh):
            raise
        return Fraction(round(a.number(x)))


def _piecewise(w, at):
    for expression, condition in w.args:
        answer = truth(condition, at)
        if answer is None:
            raise Unreliable("on the edge of a case")
        if answer:
            return value(expression, at)
    raise Undefined("piecewise")


# ---- matrices ------------------------------------------------------------------------------------


def product(x, y, a):
    if not isinstance(x, list):
        x, y = y, x
    if not isinstance(x, list):
        return a.multiply([x, y])
    if not isinstance(y, list):
        return [[a.multiply([y, e]) for e in row] for row in x]
    columns = list(zip(*y, strict=True))
    return [
        [a.add([a.multiply(pair) for pair in zip(row, column, strict=True)]) for column in columns]
        for row in x
    ]


def _matmul(w, at):
    result = value(w.args[0], at)
    for factor in w.args[1:]:
        result = product(result, value(factor, at), at.arithmetic)
    return result


def _matadd(w, at):
    parts = [value(part, at) for part in w.args]
    return [
        [at.arithmetic.add(entries) for entries in zip(*rows, strict=True)]
        for rows in zip(*parts, strict=True)
    ]


def transpose(x):
    return [list(column) for column in zip(*x, strict=True)]


def determinant(x, a):
    if len(x) == 1:
        return x[0][0]
    terms = [
        a.multiply([Fraction((-1) ** j), x[0][j], determinant(minor(x, 0, j), a)])
        for j in range(len(x))
    ]
    return a.add(terms)


def minor(x, i, j):
    return [row[:j] + row[j + 1 :] for k, row in enumerate(x) if k != i]


def inverse(x, a):
    d = determinant(x, a)
    if certain_sign(d) == 0:
        raise Undefined("nonzero")
    if len(x) == 1:
        return [[a.divide(Fraction(1), d)]]
    n = range(len(x))
    cofactors = [
        [a.multiply([Fraction((-1) ** (i + j)), determinant(minor(x, j, i), a)]) for j in n]
        for i in n
    ]
    return [[a.divide(e, d) for e in row] for row in cofactors]


def identity(n):
    if n > LARGEST_MATRIX:
        raise Unreliable("a large matrix")
    return [[Fraction(int(i == j)) for j in range(n)] for i in range(n)]


def _matpow(w, at):
    n = whole(value(w.exp, at))
    base = value(w.base, at)
    if n < 0:
        base = inverse(base, at.arithmetic)
    result = identity(len(base))
    for _ in range(abs(n)):
        result = product(result, base, at.arithmetic)
    return result


RULES = {
    sp.Indexed: _indexed,
    sp.Sum: _sum,
    sp.Product: lambda w, at: _sum(w, at, Arithmetic.multiply),
    sp.Limit: _limit,
    sp.Integral: _integral,
    sp.Derivative: _derivative,
    sp.Subs: _subs,
    sp.Piecewise: _piecewise,
    sp.floor: _rounded,
    sp.ceiling: _rounded,
    sp.MatMul: _matmul,
    sp.MatAdd: _matadd,
    sp.MatPow: _matpow,
    sp.Inverse: lambda w, at: inverse(value(w.args[0], at), at.arithmetic),
    sp.Transpose: lambda w, at: transpose(value(w.args[0], at)),
    sp.Determinant: lambda w, at: determinant(value(w.args[0], at), at.arithmetic),
    sp.Trace: lambda w, at: at.arithmetic.add(
        [row[i] for i, row in enumerate(value(w.args[0], at))]
    ),
    MatrixElement: lambda w, at: value(w.args[0], at)[int(w.args[1])][int(w.args[2])],
    sp.Identity: lambda w, at: identity(integer(w.shape[0], at, "size")),
    sp.ZeroMatrix: lambda w, at: [[Fraction(0)] * int(w.shape[1])] * int(w.shape[0]),
}


# ---- comparing -----------------------------------------------------------------------------------


def flat(x):
    return [e for row in x for e in row] if isinstance(x, list) else [x]


def compare(x, y, a, bits, floor=libmp.fzero):
    """Return "equal" (to that many bits), "different" (beyond doubt), or None.

    What is smaller than `floor` is compared as if it were of that size.
    """
    answers = set()
    for one, other in zip(flat(x), flat(y), strict=True):
        d = a.subtract(one, other)
        s = sign(d)
        if s:
            return "different"
        scale = a.larger(floor, a.larger(a.size(one), a.size(other)))
        answers.add(s == 0 or a.settled(d, scale, bits))
    return "equal" if answers == {True} else None


def truth(w, at, bits=None):
    """True, False, or None (too close to tell). A claim about something undefined is false.

    With `bits`, an equation that holds to that many bits counts as true.
    """
    if w in (sp.true, sp.false):
        return bool(w)
    if isinstance(w, sp.And | sp.Or):
        answers = [truth(x, at, bits) for x in w.args]
        stop = isinstance(w, sp.Or)
        return stop if stop in answers else (None if None in answers else not stop)
    if isinstance(w, sp.Not):
        answer = truth(w.args[0], at, bits)
        return None if answer is None else not answer
    try:
        left, right = value(w.lhs, at), value(w.rhs, at)
    except Undefined:
        return False
    a = at.arithmetic
    if w.func in (sp.Eq, sp.Ne):
        if bits is None:
            same = compare(left, right, a, a.prec)
        else:  # what cannot be told from zero at a root is small against one, not against itself
            size = max(a.mp.one, *(magnitude(x, at) for x in w.args))
            same = compare(left, right, a, bits, size._mpf_)
        return None if same is None else (same == "equal") == (w.func is sp.Eq)
    s = sign(a.subtract(left, right))
    return None if s is None else s in ORDER[w.func]


def magnitude(w, at):
    """Return how large the terms of a side are, although they may cancel."""
    mp = at.arithmetic.mp
    if isinstance(w, sp.Add | sp.MatAdd):
        return mp.fsum(magnitude(x, at) for x in w.args)
    if isinstance(w, sp.Mul | sp.MatMul):
        return mp.fprod(magnitude(x, at) for x in w.args)
    if isinstance(w, sp.MatrixBase):
        return max(magnitude(x, at) for x in w)
    if isinstance(w, sp.Pow) and w.exp.is_Integer and w.exp > 0:
        return magnitude(w.base, at) ** int(w.exp)
    sizes = [mp.make_mpf(at.arithmetic.size(x)) for x in flat(value(w, at))]
    return max([*sizes, mp.mpf(1) if w.has(*SCOPES) else mp.zero])


def magnitude_ok(w, limit=1e300):
    """Whether a number without symbols is of a size that one can work with."""
    try:
        x = value(w, Point(lambda a: {}, None, Arithmetic(60), Budget(10**5)))
    except Imprecise:
        x = value(w, Point(lambda a: {}, None, Arithmetic(900), Budget(10**5)))
    return all(e == 0 or 1e-300 < abs(as_float(e)) <= limit for e in flat(x))
