"""Numbers for a written form at one point, in high precision and with the meaning of real analysis.

Nothing is simplified on the way, so what a line does not define (1/0, log of a negative number, an
even root of one) is seen as not defined. Terms that cancel to rounding error add up to zero.
"""

import itertools

import mpmath
import sympy as sp
from mpmath import mp
from sympy.core.function import AppliedUndef
from sympy.matrices.expressions.matexpr import MatrixElement

HUGE = 10**7


class Undefined(Exception):
    """The written form has no value here; `kind` says why."""

    def __init__(self, kind="undefined"):
        super().__init__(kind)
        self.kind = kind


class Unreliable(Exception):
    """A value exists perhaps, but not one that anybody should be accused with."""


class Underflow(Unreliable):
    """Too small for a number, which in the far tail of an integral is as good as zero."""


def add(terms):
    """Add; what cancels to rounding error is zero, and no term may be too small to be seen."""
    total = mpmath.fsum(terms)
    sizes = [abs(t) for t in terms if t]
    if not sizes or not mpmath.isfinite(total):
        return total
    if total and abs(total) < mpmath.ldexp(max(sizes), -int(0.85 * mp.prec)):
        return mp.zero
    if mp.dps > 100 and min(sizes) < mpmath.ldexp(max(sizes), 10 - mp.prec):
        raise Unreliable("terms of too different a size")
    return total


def power(a, b):
    if b == int(b) if abs(b) < HUGE else False:
        b = int(b)
        if a == 0 and b < 0:
            raise Undefined("denominator")
        if a and abs(b * mpmath.log(abs(a), 2)) > HUGE:
            raise Unreliable
        return mpmath.power(a, b)
    if a < 0 or (a == 0 and b < 0):
        raise Undefined("root" if a < 0 else "denominator")
    if a == 0:
        return mp.zero
    if abs(b * mpmath.log(a, 2)) > HUGE:
        raise Unreliable
    return mpmath.power(a, b)


def _log(x):
    if x <= 0:
        raise Undefined("log" if x < 0 else "log of zero")
    return mpmath.log(x)


def _exp(x):
    if abs(x) > mpmath.mpf(10) ** 60:
        raise Underflow if x < 0 else Unreliable
    return mpmath.exp(x)


def _trig(f, x):
    if abs(x) > mpmath.mpf(10) ** 40:
        raise Unreliable
    y = f(x)
    return mp.zero if abs(x) > 0.01 and abs(y) < mpmath.ldexp(1, -int(0.85 * mp.prec)) else y


def _sin(x):
    return _trig(mpmath.sin, x)


def _cos(x):
    return _trig(mpmath.cos, x)


def _quotient(a, b):
    if b == 0:
        raise Undefined("denominator")
    return a / b


def _atan2(y, x):
    if x == 0 and y == 0:
        raise Undefined("atan2")
    return mpmath.atan2(y, x)


def _arc(f, x):
    if abs(x) > 1:
        if add([abs(x), -mp.one]):
            raise Undefined("arc")
        x = mpmath.mpf(mpmath.sign(x))
    return f(x)


def _gamma(x):
    if x <= 0 and x == int(x):
        raise Undefined("gamma")
    if abs(x) > 10**5:
        raise Unreliable
    return mpmath.gamma(x)


def _step(x):
    if x == 0:
        raise Undefined("kink")
    return mpmath.mpf(1 if x > 0 else 0)


FUNCTIONS = {
    sp.sin: _sin,
    sp.cos: _cos,
    sp.tan: lambda x: _quotient(_sin(x), _cos(x)),
    sp.cot: lambda x: _quotient(_cos(x), _sin(x)),
    sp.sinh: lambda x: (_exp(x) - _exp(-x)) / 2,
    sp.cosh: lambda x: (_exp(x) + _exp(-x)) / 2,
    sp.tanh: lambda x: mpmath.tanh(x),
    sp.asin: lambda x: _arc(mpmath.asin, x),
    sp.acos: lambda x: _arc(mpmath.acos, x),
    sp.atan: lambda x: mpmath.atan(x),
    sp.atan2: _atan2,
    sp.exp: _exp,
    sp.log: _log,
    sp.Abs: abs,
    sp.sign: lambda x: mpmath.mpf(mpmath.sign(x)),
    sp.Max: max,
    sp.Min: min,
    sp.gamma: _gamma,
    sp.loggamma: lambda x: _log(_gamma(x)),
    sp.factorial: lambda x: _gamma(x + 1),
    sp.polygamma: lambda n, x: mpmath.polygamma(int(n), x),
    sp.digamma: lambda x: mpmath.digamma(x),
    sp.binomial: lambda n, k: mpmath.binomial(n, k),
    sp.beta: lambda a, b: mpmath.beta(a, b),
    sp.erf: lambda x: mpmath.erf(x),
    sp.erfc: lambda x: mpmath.erfc(x),
    sp.uppergamma: lambda s, x: mpmath.gammainc(s, x),
    sp.lowergamma: lambda s, x: mpmath.gammainc(s, 0, x),
    sp.floor: mpmath.floor,
    sp.ceiling: mpmath.ceil,
    sp.Mod: lambda a, b: mpmath.fmod(a, b) if b else _quotient(a, b),
    sp.KroneckerDelta: lambda a, b: mpmath.mpf(a == b),
    sp.Heaviside: lambda x, *half: _step(x),
    sp.DiracDelta: lambda x, *n: mp.zero if x else _quotient(x, x),
    sp.re: lambda x: x,
    sp.im: lambda x: mp.zero,
    sp.conjugate: lambda x: x,
}
KINKED = (sp.Abs, sp.sign, sp.Max, sp.Min)
NUMBERS = {
    sp.pi: lambda: +mp.pi,
    sp.E: lambda: +mp.e,
    sp.oo: lambda: mp.inf,
    -sp.oo: lambda: -mp.inf,
}
RELATIONS = {sp.Eq: 0, sp.Ne: 0, sp.Gt: 1, sp.Ge: 1, sp.Lt: -1, sp.Le: -1}


def magnitude_ok(w, limit=1e300):
    """Whether a number without symbols is of a size that one can work with."""
    with mpmath.workdps(15):
        x = abs(value(w, Point({}, None)))
        return not x or 1e-300 < x <= limit


class Point:
    """Values by name, lists for matrices; `entry(name, index)` is an element of a sequence."""

    def __init__(self, values, entry, derive=None, known=None):
        self.values, self.entry, self.derive = values, entry, derive
        self.known = {} if known is None else known

    def bind(self, name, number):
        return Point({**self.values, name: number}, self.entry, self.derive, self.known)


def value(w, at):
    """The value of the written form `w`: a number, or a nested list for a matrix."""
    if w.is_Integer:
        return mpmath.mpf(w.p)
    if w.is_Rational:
        return mpmath.mpf(w.p) / w.q
    if w.is_Float:
        return mpmath.mpf(w._mpf_)
    if w in NUMBERS:
        return NUMBERS[w]()
    if isinstance(w, (sp.Symbol, sp.MatrixSymbol)):
        try:
            return at.values[w.name]
        except KeyError:
            raise Unreliable(f"no value for {w.name}") from None
    kind = w.func
    if kind in FUNCTIONS:
        return FUNCTIONS[kind](*[value(a, at) for a in w.args])
    if kind in (sp.Add,):
        return add([value(a, at) for a in w.args])
    if kind is sp.Mul:
        return mpmath.fprod(value(a, at) for a in w.args)
    if kind is sp.Pow:
        return power(value(w.base, at), value(w.exp, at))
    rule = RULES.get(kind)
    if rule is not None:
        return rule(w, at)
    if isinstance(w, sp.MatrixBase):
        return [[value(w[i, j], at) for j in range(w.cols)] for i in range(w.rows)]
    if isinstance(w, AppliedUndef):
        if w.func.__name__ in at.values:
            return at.values[w.func.__name__](w, at)
        return at.entry(w.func.__name__, tuple(int(value(k, at)) for k in w.args))
    raise Unreliable(f"no rule for {kind.__name__}")


def _indexed(w, at):
    return at.entry(str(w.base.label), tuple(int(value(k, at)) for k in w.indices))


def _sum(w, at, combine=add, empty=0):
    ranges, (name, low, high), *rest = [], *[(k.name, a, b) for k, a, b in w.limits[::-1]]
    a, b = value(low, at), value(high, at)
    if b == mp.inf and not rest:
        return _series(lambda k: value(w.function, at.bind(name, k)), int(a), combine)
    if not b - a < 400:
        raise Unreliable("a long sum")
    inner = w.function if not rest else w.func(w.function, *w.limits[:-1])
    ranges = [mpmath.mpf(k) for k in range(int(a), int(b) + 1)]
    return (
        combine([value(inner, at.bind(name, k)) for k in ranges]) if ranges else mpmath.mpf(empty)
    )


def _series(term, k, combine):
    """An infinite sum whose terms fall off like those of a geometric series."""
    if combine is not add:
        raise Unreliable("an infinite product")
    total, last, calm = mp.zero, mp.inf, 0
    for n in range(k, k + 20000):
        t = term(mpmath.mpf(n))
        total += t
        small = abs(t) < abs(total) * mpmath.mpf(10) ** (-mp.dps - 3)
        calm = calm + 1 if small and abs(t) <= 0.998 * abs(last) else 0
        if calm > 5:
            return total
        if n == k + 300 and abs(t) > 0.995 * abs(last):
            break
        last = t
    raise Unreliable("a series that does not settle")


def _integral(w, at):
    """One quadrature for each integral, precision and point: it is what takes the time."""
    names = sorted(v.name for v in w.free_symbols if isinstance(v, sp.Symbol))
    key = (w, mp.prec, *[str(at.values.get(n)) for n in names])
    if w.has(sp.Indexed):
        return _quadrature(w, at)
    if key not in at.known:
        at.known[key] = _quadrature(w, at)
    return at.known[key]


def _quadrature(w, at):
    limits = w.limits[-1]
    if len(limits) != 3:
        raise Unreliable("an integral without limits")
    name, low, high = limits[0].name, value(limits[1], at), value(limits[2], at)
    inner = w.function if len(w.limits) == 1 else w.func(w.function, *w.limits[:-1])
    if inner.has(sp.Integral):
        inner = at.derive(inner)
    if low == high:
        return mp.zero
    sign = 1
    if low > high:
        low, high, sign = high, low, -1

    def f(x):
        try:
            return value(inner, at.bind(name, x))
        except Undefined:
            return mp.zero if x in (low, high) else _fail()
        except Underflow:
            return mp.zero

    # The second look, in more digits, also cuts the range elsewhere: both will not err alike.
    cuts = [c for c in ((-4, 0, 4) if mp.dps < 30 else (-7, -1, 1, 7)) if low < c < high]
    first, error = mpmath.quad(f, [low, *cuts, high], error=True)
    if not abs(first) < 1e100 or error > mpmath.mpf(10) ** (-int(0.6 * mp.dps)) * (1 + abs(first)):
        raise Unreliable("an integral that does not settle")
    return sign * first


def _fail():
    raise Unreliable("undefined inside an integral")


def _derivative(w, at):
    value(w.expr, at)  # a function has a derivative only where it has a value
    for node in sp.preorder_traversal(w.expr):
        if isinstance(node, KINKED) and node.free_symbols & w.expr.free_symbols:
            try:
                arguments = [value(a, at) for a in node.args]
            except Unreliable:  # inside a sum or an integral
                continue
            if any(
                not add([a, -b])
                for a, b in itertools.combinations(
                    [*arguments, *[mp.zero][: 2 - len(arguments)]], 2
                )
            ):
                raise Undefined("kink")
    return value(at.derive(w), at)


def _subs(w, at):
    for name, point in zip(w.variables, w.point, strict=True):
        at = at.bind(name.name, value(point, at))
    return value(w.expr, at)


def _piecewise(w, at):
    for expression, condition in w.args:
        if condition is sp.true or truth(condition, at):
            return value(expression, at)
    raise Undefined("piecewise")


def product(a, b):
    if not isinstance(a, list):
        return [[a * x for x in row] for row in b] if isinstance(b, list) else a * b
    if not isinstance(b, list):
        return product(b, a)
    return [
        [add([x * y for x, y in zip(row, column, strict=True)]) for column in zip(*b, strict=True)]
        for row in a
    ]


def _matmul(w, at):
    result = value(w.args[0], at)
    for a in w.args[1:]:
        result = product(result, value(a, at))
    return result


def _matadd(w, at):
    return [
        [add(list(x)) for x in zip(*rows, strict=True)]
        for rows in zip(*[value(a, at) for a in w.args], strict=True)
    ]


def transpose(a):
    return [list(row) for row in zip(*a, strict=True)]


def determinant(a):
    if len(a) == 1:
        return a[0][0]
    return add([(-1) ** j * a[0][j] * determinant(minor(a, 0, j)) for j in range(len(a))])


def minor(a, i, j):
    return [row[:j] + row[j + 1 :] for k, row in enumerate(a) if k != i]


def inverse(a):
    d = determinant(a)
    if d == 0:
        raise Undefined("det")
    if len(a) == 1:
        return [[1 / d]]
    n = range(len(a))
    return [[(-1) ** (i + j) * determinant(minor(a, j, i)) / d for j in n] for i in n]


def _matpow(w, at):
    n = int(value(w.exp, at))
    base = value(w.base, at)
    base, n = (inverse(base), -n) if n < 0 else (base, n)
    result = [[mpmath.mpf(i == j) for j in range(len(base))] for i in range(len(base))]
    for _ in range(n):
        result = product(result, base)
    return result


RULES = {
    sp.Indexed: _indexed,
    sp.Sum: _sum,
    sp.Product: lambda w, at: _sum(w, at, mpmath.fprod, 1),
    sp.Integral: _integral,
    sp.Derivative: _derivative,
    sp.Subs: _subs,
    sp.Piecewise: _piecewise,
    sp.MatMul: _matmul,
    sp.MatAdd: _matadd,
    sp.MatPow: _matpow,
    sp.Inverse: lambda w, at: inverse(value(w.args[0], at)),
    sp.Transpose: lambda w, at: transpose(value(w.args[0], at)),
    sp.Determinant: lambda w, at: determinant(value(w.args[0], at)),
    sp.Trace: lambda w, at: add([row[i] for i, row in enumerate(value(w.args[0], at))]),
    MatrixElement: lambda w, at: value(w.args[0], at)[int(w.args[1])][int(w.args[2])],
    sp.Identity: lambda w, at: [
        [mpmath.mpf(i == j) for j in range(w.shape[0])] for i in range(w.shape[0])
    ],
    sp.ZeroMatrix: lambda w, at: [[mp.zero] * w.shape[1] for _ in range(w.shape[0])],
}


def flat(a):
    return [x for row in a for x in row] if isinstance(a, list) else [a]


def shape(a):
    return (len(a), len(a[0])) if isinstance(a, list) else (1, 1)


def gap(a, b, bits=0.7):
    """Return the largest difference; 0 where the values agree to that part of the digits."""
    largest = mp.zero
    for x, y in zip(flat(a), flat(b), strict=True):
        d = abs(x - y)
        if d > mpmath.ldexp(max(abs(x), abs(y)), -int(bits * mp.prec)):
            largest = max(largest, d)
    return largest


def truth(w, at):
    """True, False, or None (too close to tell). A claim about something undefined is false."""
    if w in (sp.true, sp.false):
        return bool(w)
    if isinstance(w, (sp.And, sp.Or)):
        answers = [truth(a, at) for a in w.args]
        stop = isinstance(w, sp.Or)
        return stop if stop in answers else (None if None in answers else not stop)
    if isinstance(w, sp.Not):
        answer = truth(w.args[0], at)
        return None if answer is None else not answer
    try:
        left, right = value(w.lhs, at), value(w.rhs, at)
    except Undefined:
        return False
    d = max(abs(x - y) for x, y in zip(flat(left), flat(right), strict=True))
    scale = max([mp.one, *map(abs, flat(left)), *map(abs, flat(right))])
    equal = d < mpmath.ldexp(scale, -int(0.6 * mp.prec))
    if not equal and d < mpmath.ldexp(scale, -int(0.3 * mp.prec)):
        return None
    if w.func in (sp.Eq, sp.Ne):
        return equal == (w.func is sp.Eq)
    if equal:
        return w.func in (sp.Ge, sp.Le)
    return (flat(left)[0] > flat(right)[0]) == (RELATIONS[w.func] > 0)
