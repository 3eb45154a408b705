"""Numbers that know how far they can be trusted.

A value is a ``Fraction`` (exact) or an interval (two ends, rounded outward) that contains it. So a
comparison is certain or it is not, and nobody is accused because of a tolerance. The precision is
an argument everywhere: no global state of mpmath is read or changed.
"""

from fractions import Fraction
from functools import lru_cache

import mpmath
from mpmath import libmp
from mpmath.libmp import libmpi

LARGEST_FRACTION = 4000  # bits; beyond, an exact number costs more than it is worth
LARGEST_EXPONENT = 10**7


class Undefined(Exception):
    """The written form certainly has no value here; `kind` says why."""

    def __init__(self, kind):
        super().__init__(kind)
        self.kind = kind


class Unreliable(Exception):
    """A value exists perhaps, but none that anybody should be accused with."""


class Imprecise(Unreliable):
    """More digits may help."""


def sign(x):
    """Return -1, 0 or 1, or None if the interval does not tell."""
    if isinstance(x, Fraction):
        return (x > 0) - (x < 0)
    low, high = (libmp.mpf_sign(end) for end in x)
    return low if low == high else None


def certain_sign(x):
    s = sign(x)
    if s is None:
        raise Imprecise("too close to zero to tell")
    return s


def whole(x):
    """Return the number as an int, or None if it is not a whole number beyond doubt."""
    if isinstance(x, Fraction):
        return int(x) if x.denominator == 1 else None
    return None


def middle(x, prec=60):
    """Return the middle of the interval as a raw mpmath number."""
    if isinstance(x, Fraction):
        return libmp.from_rational(x.numerator, x.denominator, prec)
    return libmpi.mpi_mid(x, prec)


def fraction(x):
    """Return a number of mpmath as the fraction that it is."""
    return Fraction(*map(int, libmp.to_rational(x._mpf_)))


def as_float(x):
    try:
        return libmp.to_float(middle(x))
    except OverflowError:
        return float("inf") * libmp.mpf_sign(middle(x))


# Sine and cosine of one angle are asked for one after the other, and by each line that has them.
_cos_sin = lru_cache(maxsize=1000)(libmpi.mpi_cos_sin)


class Arithmetic:
    """Exact and interval arithmetic with `prec` bits."""

    def __init__(self, prec, lenient=False):
        self.prec, self.lenient = prec, lenient  # the root of what is zero or a bit less is zero
        self.mp = mpmath.MPContext()
        self.mp.prec = prec + 40

    # ---- conversions -------------------------------------------------------------------------

    def interval(self, x):
        if not isinstance(x, Fraction):
            return x
        p, q = x.numerator, x.denominator
        if q == 1:
            end = libmp.from_int(p)
            return end, end
        return tuple(libmp.from_rational(p, q, self.prec, end) for end in ("f", "c"))

    def small(self, x):
        """Return `x`, as an interval if it is a fraction of too many digits."""
        if isinstance(x, Fraction):
            size = x.numerator.bit_length() + x.denominator.bit_length()
            return x if size < LARGEST_FRACTION else self.interval(x)
        if any(end in (libmp.finf, libmp.fninf, libmp.fnan) for end in x):
            raise Unreliable("not a finite number")
        return x

    def number(self, x):
        """Return a value of the working context in the middle of `x`."""
        return self.mp.make_mpf(middle(x, self.prec + 40))

    def around(self, x, radius):
        """Return the interval with middle `x` and that radius, both of mpmath."""
        x, radius = self.mp.mpf(x), self.mp.mpf(radius)
        if not (self.mp.isfinite(x) and self.mp.isfinite(radius)):
            raise Unreliable("not a finite number")
        return (x - radius)._mpf_, (x + radius)._mpf_

    def trusted(self, f, *xs):
        """Return ``f`` by mpmath, with an error estimated from the ends of the arguments."""
        with_slack = [[self.mp.make_mpf(end) for end in self.interval(x)] for x in xs]
        lows, highs = zip(*with_slack, strict=True)
        try:
            y, z = f(*lows), f(*highs)
        except (ValueError, ZeroDivisionError, OverflowError, libmp.NoConvergence):
            raise Unreliable("mpmath gives up") from None
        if isinstance(y, self.mp.mpc) or isinstance(z, self.mp.mpc):
            raise Unreliable("a complex value")
        slack = abs(y) * self.mp.mpf(2) ** (8 - self.prec)
        return self.around((y + z) / 2, abs(y - z) + slack)

    # ---- the four operations ------------------------------------------------------------------

    def add(self, terms):
        exact, rest = Fraction(0), None
        for t in terms:
            if isinstance(t, Fraction):
                exact += t
            else:
                rest = t if rest is None else libmpi.mpi_add(rest, t, self.prec)
        if rest is None:
            return self.small(exact)
        return libmpi.mpi_add(rest, self.interval(exact), self.prec) if exact else rest

    def negative(self, x):
        return -x if isinstance(x, Fraction) else libmpi.mpi_neg(x)

    def subtract(self, x, y):
        return self.add([x, self.negative(y)])

    def multiply(self, factors):
        exact, rest = Fraction(1), None
        for t in factors:
            if isinstance(t, Fraction):
                exact *= t
            else:
                rest = t if rest is None else libmpi.mpi_mul(rest, t, self.prec)
        if rest is None or not exact:
            return self.small(exact)
        return rest if exact == 1 else libmpi.mpi_mul(rest, self.interval(exact), self.prec)

    def divide(self, x, y):
        if certain_sign(y) == 0:
            raise Undefined("nonzero")
        if isinstance(x, Fraction) and isinstance(y, Fraction):
            return self.small(x / y)
        return libmpi.mpi_div(self.interval(x), self.interval(y), self.prec)

    def power(self, base, exponent):
        n = whole(exponent)
        if n is not None:
            return self.whole_power(base, n)
        if isinstance(exponent, Fraction) and exponent.denominator == 2:
            return self.whole_power(self.root(base), exponent.numerator)
        s = certain_sign(base)
        if s < 0:
            raise Undefined("nonnegative")
        if s == 0:
            if certain_sign(exponent) < 0:
                raise Undefined("nonzero")
            return Fraction(0)
        return self.exp(self.multiply([exponent, self.log(base)]))

    def whole_power(self, base, n):
        if n < 0:
            return self.divide(Fraction(1), self.whole_power(base, -n))
        if n > LARGEST_EXPONENT:
            if certain_sign(base) <= 0:
                raise Unreliable("a very large power")
            return self.exp(self.multiply([Fraction(n), self.log(base)]))
        if isinstance(base, Fraction):
            bits = max(base.numerator.bit_length(), base.denominator.bit_length())
            if bits * n < LARGEST_FRACTION or base in (0, 1, -1):
                return base**n
        return libmpi.mpi_pow_int(self.interval(base), n, self.prec)

    def root(self, x):
        s = sign(x)
        if s is None and self.lenient:
            return libmp.fzero, libmp.mpf_sqrt(x[1], self.prec, "c")
        if s is None and libmp.mpf_sign(x[1]) >= 0:
            raise Imprecise("the root of what may be zero")
        if s is not None and s < 0:
            raise Undefined("nonnegative")
        if isinstance(x, Fraction):
            p, q = (libmp.isqrt(n) for n in (x.numerator, x.denominator))
            if p * p == x.numerator and q * q == x.denominator:
                return Fraction(int(p), int(q))
        return libmpi.mpi_sqrt(self.interval(x), self.prec)

    # ---- functions ---------------------------------------------------------------------------

    def exp(self, x):
        if x == 0:
            return Fraction(1)
        size = as_float(x)
        if size < -1e40:
            return libmp.fzero, libmp.mpf_shift(libmp.fone, -(10**30))
        if size > 1e40:
            raise Unreliable("a very large exponent")
        return libmpi.mpi_exp(self.interval(x), self.prec)

    def log(self, x):
        if certain_sign(x) <= 0:
            raise Undefined("positive")
        return Fraction(0) if x == 1 else libmpi.mpi_log(self.interval(x), self.prec)

    def sin(self, x):
        return Fraction(0) if x == 0 else self._turned(x)[1]

    def cos(self, x):
        return Fraction(1) if x == 0 else self._turned(x)[0]

    def _turned(self, x):
        if abs(as_float(x)) > 1e30:
            return ((libmp.fnone, libmp.fone),) * 2
        return _cos_sin(self.interval(x), self.prec)

    def tan(self, x):
        return self.divide(self.sin(x), self.cos(x))

    def cot(self, x):
        return self.divide(self.cos(x), self.sin(x))

    def sinh(self, x):
        return self._hyperbolic(x, -1)

    def cosh(self, x):
        return self._hyperbolic(x, 1)

    def _hyperbolic(self, x, s):
        both = [self.exp(x), self.multiply([Fraction(s), self.exp(self.negative(x))])]
        return self.multiply([Fraction(1, 2), self.add(both)])

    def tanh(self, x):
        if x == 0:
            return Fraction(0)
        e = self.exp(self.multiply([Fraction(-2), self.absolute(x)]))
        y = self.divide(self.subtract(Fraction(1), e), self.add([Fraction(1), e]))
        return y if certain_sign(x) > 0 else self.negative(y)

    def atan(self, x):
        return x if x == 0 else libmpi.mpi_atan(self.interval(x), self.prec)

    def asin(self, x):
        return self._arc(x, lambda other: self.atan2(x, other))

    def acos(self, x):
        return self._arc(x, lambda other: self.atan2(other, x))

    def _arc(self, x, angle):
        rest = self.multiply([self.subtract(Fraction(1), x), self.add([Fraction(1), x])])
        if certain_sign(rest) < 0:
            raise Undefined("unit")
        return angle(self.root(rest))

    def atan2(self, y, x):
        sx, sy = sign(x), sign(y)
        if sx == 0 and sy == 0:
            raise Undefined("pair")
        if sx == 1:
            return self.atan(self.divide(y, x))
        if sy in (1, -1):
            quarter = self.multiply([Fraction(sy, 2), self.pi()])
            return self.subtract(quarter, self.atan(self.divide(x, y)))
        if sx == -1 and (sy == 0 or self.settled(y, libmp.fone, 700)):
            return self.pi()
        raise Imprecise("an angle at its jump")

    def pi(self):
        return libmpi.mpi_pi(self.prec)

    def absolute(self, x):
        return abs(x) if isinstance(x, Fraction) else libmpi.mpi_abs(x, self.prec)

    def signum(self, x):
        return Fraction(certain_sign(x))

    def largest(self, *xs):
        best = xs[0]
        for x in xs[1:]:
            s = sign(self.subtract(x, best))
            if s is None:  # the interval of the larger one, whichever it is
                ends = zip(self.interval(x), self.interval(best), strict=True)
                best = tuple(self.larger(a, b) for a, b in ends)
            elif s > 0:
                best = x
        return best

    @staticmethod
    def larger(a, b):
        return a if libmp.mpf_gt(a, b) else b

    def smallest(self, *xs):
        return self.negative(self.largest(*map(self.negative, xs)))

    def floor(self, x):
        if isinstance(x, Fraction):
            return Fraction(x.numerator // x.denominator)
        low, high = (libmp.to_int(libmp.mpf_floor(end)) for end in x)
        if low != high:
            raise Imprecise("a floor at its jump")
        return Fraction(low)

    def ceiling(self, x):
        return self.negative(self.floor(self.negative(x)))

    def modulo(self, x, y):
        return self.subtract(x, self.multiply([y, self.floor(self.divide(x, y))]))

    def gamma(self, x):
        n = whole(x)
        if n is not None and n <= 0:
            raise Undefined("gamma")
        if abs(as_float(x)) > 1e5:
            raise Unreliable("a very large factorial")
        if n is not None and n < 200:
            return Fraction(libmp.ifac(n - 1))
        if certain_sign(x) > 0:
            return libmpi.mpi_gamma(self.interval(x), self.prec)
        return self.trusted(self.mp.gamma, x)

    def factorial(self, x):
        return self.gamma(self.add([x, Fraction(1)]))

    def binomial(self, n, k):
        j, m = whole(k), whole(n)
        if j is not None and j < 0:
            return Fraction(0)
        if j is not None and j < 400:
            top = [self.subtract(n, Fraction(i)) for i in range(j)]
            return self.multiply([*top, Fraction(1, libmp.ifac(j))])
        if m is not None and j is not None and 0 <= m - j < 400:
            return self.binomial(n, Fraction(m - j))
        return self.trusted(self.mp.binomial, n, k)

    def beta(self, a, b):
        return self.divide(
            self.multiply([self.gamma(a), self.gamma(b)]), self.gamma(self.add([a, b]))
        )

    def erf(self, x):
        return Fraction(0) if x == 0 else self.trusted(self.mp.erf, x)

    def erfc(self, x):
        return self.trusted(self.mp.erfc, x)

    def heaviside(self, x, *_):
        s = certain_sign(x)
        if s == 0:
            raise Undefined("kink")
        return Fraction(int(s > 0))

    def delta(self, i, j):
        return Fraction(int(certain_sign(self.subtract(i, j)) == 0))

    # ---- comparing ---------------------------------------------------------------------------

    def settled(self, x, scale, bits):
        """Whether the interval `x` around zero is narrower than `scale` by that many bits."""
        if isinstance(x, Fraction):
            return True
        width = libmpi.mpi_delta(x, 30)
        if width == libmp.fzero:
            return True
        if scale == libmp.fzero:
            return False
        return libmp.mpf_lt(width, libmp.mpf_shift(scale, -bits))

    def least(self, x):
        """Return the smallest absolute value in `x`, as a raw mpmath number."""
        return libmpi.mpi_abs(self.interval(x), 30)[0]

    def size(self, x):
        """Return the largest absolute value in `x`, as a raw mpmath number."""
        return libmpi.mpi_abs(self.interval(x), 30)[1]
