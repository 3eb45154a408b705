"""Sums, products and integrals in closed form, or under a name that equal ones share.

Everything here keeps the rules 3 to 5 of `proving`.
"""

import sympy as sp

from .limits import bounded
from .proving import ENDLESS, nonzero, positive, reduced

SCOPES = (sp.Sum, sp.Product, sp.Integral)
K = sp.Symbol("_k", integer=True, positive=True)
U = sp.Symbol("_u", positive=True)
X = sp.Symbol("_x", real=True)


def closed(e, model, names=None):
    """Return `e` without sums, products and integrals: closed forms, or symbols for the rest."""
    if not e.has(*SCOPES):
        return e
    return _Closing(model, {} if names is None else names).close(e)


class _Closing:
    def __init__(self, model, names):
        self.model, self.names = model, names

    def close(self, e):
        if not e.has(*SCOPES):
            return e
        if isinstance(e, sp.Sum):
            return self.total(e)
        if isinstance(e, sp.Product):
            return self.product(e)
        if isinstance(e, sp.Integral):
            return self.integral(e)
        if isinstance(e, sp.log) and isinstance(e.args[0], sp.Product):
            inside = e.args[0]
            if inside.function.is_positive:
                return self.close(sp.Sum(sp.expand_log(sp.log(inside.function)), *inside.limits))
        if isinstance(e, sp.exp) and e.args[0].has(*SCOPES):
            return sp.exp(sp.expand(self.close(e.args[0])))
        return e.func(*map(self.close, e.args))

    def proved(self, e, strict=False):
        return positive(sp.sympify(e), self.model, strict=strict)

    def name(self, *what, **facts):
        """Return the symbol for something without closed form; equal ones have the same."""
        key = tuple(sp.sympify(w) if not isinstance(w, str) else w for w in what)
        if key not in self.names:
            self.names[key] = sp.Symbol(f"_M{len(self.names)}", **{"real": True, **facts})
        return self.names[key]

    # ---- sums --------------------------------------------------------------------------------

    def total(self, s):
        if len(s.limits) > 1:
            inner = s.func(s.function, *s.limits[:-1])
            triangle = self._triangle(s)
            if triangle is not None:
                return self.close(triangle)
            return self.close(sp.Sum(self.close(inner), s.limits[-1]))
        body, (i, low, high) = s.function, s.limits[0]
        if isinstance(body, sp.Sum) and len(body.limits) == 1:
            return self.total(sp.Sum(body.function, *body.limits, *s.limits))
        body = sp.expand(self.close(body), power_base=False)
        if high == sp.oo:
            return self.series(s, body, i, low)
        head, body, high = self.from_one(body, i, low, high)
        return head + sum(self.one_sum(t, high) for t in sp.Add.make_args(sp.expand(body)))

    def from_one(self, body, i, low, high):
        """Return what stands before, the body and the upper end of the same sum from 1 on."""
        low = sp.sympify(low)
        if low.is_Integer and -3 <= low <= 4 and self.proved(high - low + 1):
            early = range(int(low), 1) if low < 1 else range(1, int(low))
            ahead = [body.subs(i, k) for k in early]
            if low == 1 or (self.proved(high) and not any(a.has(*ENDLESS) for a in ahead)):
                return sum(ahead) * (1 if low < 1 else -1), body.subs(i, K), high
        return 0, body.subs(i, K + low - 1), sp.expand(high - low + 1)

    def one_sum(self, t, n):
        """Sum of one term, k from 1 to n."""
        c, m = t.as_independent(K)
        deltas = [d for d in m.atoms(sp.KroneckerDelta) if d.has(K)]
        if deltas:
            return c * self.picked(m, deltas[0], n)
        if not m.has(K):
            return c * m * n if self.proved(n) else c * m * self.name("length", n)
        if m.is_polynomial(K):
            return c * (sp.summation(m, (K, 1, n)) if self.proved(n) else self.name("sum", m, n))
        special = self.geometric(m, n) if self.proved(n) else None
        return c * (self.long_sum(m, n) if special is None else special)

    def long_sum(self, m, n):
        """A named sum; ends that differ by a number share one name and the terms between."""
        step, base = sp.expand(n).as_coeff_Add()
        if step.is_Integer and 0 < abs(step) <= 4 and self.proved(base) and self.proved(n):
            between = range(1, int(step) + 1) if step > 0 else range(int(step) + 1, 1)
            rest = sum(m.subs(K, base + k) for k in between)
            if not rest.has(*ENDLESS):
                return self.name("sum", m, base) + (rest if step > 0 else -rest)
        return self.name("sum", m, n)

    def picked(self, m, delta, n):
        """The term that a Kronecker delta picks, if its place is proved to lie in the range."""
        a, b = delta.args
        place, *others = sp.solve(a - b, K) or [sp.nan]
        if place.is_integer and not others and self.proved(place - 1) and self.below(place, n):
            return (m / delta).subs(K, place)
        return self.name("sum", m, n)

    def below(self, place, n):
        """Whether `place` <= n: shown, or because an index is at most the sizes of its line."""
        if self.proved(n - place):
            return True
        tops = [self.model.evaluated(sp.Symbol(t)) for t in self.model.tops]
        letters = [
            s
            for s in place.free_symbols
            if getattr(self.model.domains.get(s.name), "text", "") == "index"
        ]
        if len(letters) != 1 or len(tops) != 1:
            return False
        top = self.model.parametrized(tops[0])
        return place.coeff(letters[0]) == 1 and self.proved(n - place.subs(letters[0], top))

    def geometric(self, m, n):
        """Sum over k = 1..n of binomial(n, k)**b * P(k) * r**k, or None."""
        c, P, r, special = split_powers(m, K)
        if special == [sp.binomial(n, K)]:
            return c * (self.binomial_sum(P, r, n) - P.subs(K, 0))
        if special or r == 1 or not nonzero(r - 1, self.model):
            return None
        q = sp.Dummy("q", positive=True)
        g = (q - q ** (n + 1)) / (1 - q)
        result = 0
        for (j,), a in P.terms():
            h = g
            for _ in range(j):
                h = q * sp.diff(h, q)
            result += a * h
        return c * result.subs(q, r)

    @staticmethod
    def binomial_sum(P, r, n):
        """Sum over k = 0..n of binomial(n, k) P(k) r**k, by falling factorials of k."""
        return sum(
            a * sp.ff(n, j).expand(func=True) * r**j * sp.factor(1 + r) ** (n - j)
            for j, a in falling(P)
        )

    def series(self, s, body, i, low):
        """An infinite sum: geometric or exponential terms, else by SymPy without conditions."""
        k = sp.Symbol("_k", integer=True, nonnegative=True)
        result = 0
        for t in sp.Add.make_args(sp.expand(body.subs(i, k + low))):
            c, m = t.as_independent(k)
            a, P, r, special = split_powers(m, k)
            if not special and r != 1 and positive(1 - r**2, self.model):
                result += (
                    c
                    * a
                    * sum(b * sp.factorial(j) * r**j / (1 - r) ** (j + 1) for j, b in falling(P))
                )
            elif special == [1 / sp.factorial(k)]:
                result += c * a * sp.exp(r) * sum(b * r**j for j, b in falling(P))
            else:
                return self.by_sympy(s)
        return result

    def by_sympy(self, s):
        finished, e = bounded(lambda: s.doit(), 0.8)
        if finished and not e.has(*SCOPES, sp.Piecewise, *ENDLESS):
            return e
        return self.name("series", s.as_dummy())

    def _triangle(self, s):
        """Two nested sums over a triangle: half of a square, or the other order."""
        if len(s.limits) != 2:
            return None
        f, (j, a, b), (i, low, high) = s.function, *s.limits
        if low != 1 or not self.proved(high):
            return None
        lag = sp.Dummy("lag", integer=True, nonnegative=True)
        by_lag = f.subs(sp.Abs(i - j), lag)
        if a == 1 and b == high and by_lag.has(lag) and not by_lag.has(i, j):
            pairs = sp.Sum((high - lag) * by_lag, (lag, 1, high - 1))
            return high * by_lag.subs(lag, 0) + 2 * pairs
        t = sp.Dummy("t")
        mirrored = f.subs(i, t).subs(j, i).subs(t, j)
        if a == i + 1 and b == high and sp.expand(f - mirrored) == 0:
            whole = sp.Sum(sp.Sum(f, (j, 1, high)), (i, 1, high))
            return (whole - sp.Sum(f.subs(j, i), (i, 1, high))) / 2
        if a == i and b == high:
            return sp.Sum(sp.Sum(mirrored, (j, 1, i)), (i, 1, high))
        return None

    # ---- products ----------------------------------------------------------------------------

    def product(self, s):
        if len(s.limits) > 1 or s.limits[0][2] == sp.oo:
            return self.name("product", s.as_dummy())
        body, (i, low, high) = self.close(s.function), s.limits[0]
        if isinstance(body, sp.exp):
            return sp.exp(self.close(sp.Sum(body.args[0], s.limits[0])))
        low = sp.sympify(low)
        body, n = body.subs(i, K + low - 1), sp.expand(high - low + 1)
        result = 1
        for f in sp.Mul.make_args(sp.factor(sp.powsimp(body)) if body.is_Add else body):
            result *= self.one_product(f, n)
        return result

    def one_product(self, f, n):
        if not f.has(K):
            return f**n if self.proved(n) else self.name("power", f, n)
        if f.is_Pow and not f.exp.has(K):
            return self.one_product(f.base, n) ** f.exp
        if f.is_Pow and not f.base.has(K) and f.base.is_positive:
            return f.base ** self.close(sp.Sum(f.exp, (K, 1, n)))
        if f.is_polynomial(K) and sp.degree(f, K) == 1 and self.proved(n):
            a, b = sp.Poly(f, K).all_coeffs()
            if positive(b / a + 1, self.model):
                return a**n * sp.gamma(b / a + n + 1) / sp.gamma(b / a + 1)
        step, base = n.as_coeff_Add()
        facts = {"positive": True} if f.is_positive else {}
        if step.is_Integer and 0 < abs(step) <= 4 and self.proved(base) and self.proved(n):
            between = range(1, int(step) + 1) if step > 0 else range(int(step) + 1, 1)
            rest = sp.prod([f.subs(K, base + k) for k in between])
            return self.name("product", f, base, **facts) * (rest if step > 0 else 1 / rest)
        return self.name("product", f, n, **facts)

    # ---- integrals ---------------------------------------------------------------------------

    def integral(self, s):
        if len(s.limits) > 1:
            return self.close(
                sp.Integral(self.close(s.func(s.function, *s.limits[:-1])), s.limits[-1])
            )
        body, (x, *ends) = self.close(s.function), s.limits[0]
        if len(ends) != 2:
            return self.name("integral", s)
        low, high = map(self.close, ends)
        if low == high:
            return sp.Integer(0)
        if low == sp.oo or high == -sp.oo:
            return -self.integral(sp.Integral(body, (x, high, low)))
        body = self.unfolded(body, x, low, high)
        if isinstance(body, list):
            return sum(self.close(part) for part in body)
        for rule in (self.by_rule, self.by_antiderivative):
            finished, e = bounded(lambda rule=rule: rule(body, x, low, high), 1.2)
            if finished and e is not None:
                return e
        return self.moments(body, x, low, high)

    def unfolded(self, body, x, low, high):
        """Return the body, or the integrals over the parts of a range that |x| bends."""
        bends = [a for a in body.atoms(sp.Abs) if a.has(x)]
        for a in bends:
            places = sp.solve(a.args[0], x) if a.args[0].is_polynomial(x) else []
            if len(places) == 1 and not places[0].has(x):
                c = places[0]
                inside = low == -sp.oo or self.proved(c - low)
                if inside and (high == sp.oo or self.proved(high - c)):
                    rising = sp.diff(a.args[0], x)
                    if rising.is_positive or rising.is_negative:
                        s = 1 if rising.is_positive else -1
                        return [
                            sp.Integral(body.xreplace({a: -s * a.args[0]}), (x, low, c)),
                            sp.Integral(body.xreplace({a: s * a.args[0]}), (x, c, high)),
                        ]
        return body

    def by_rule(self, body, x, low, high):
        """Gauss, Gamma and Beta integrals, term by term; None if one term is none of them."""
        if high == sp.oo and low == -sp.oo:
            return self.term_by_term(body.subs(x, X), X, self.gauss)
        if high == sp.oo:
            body = body.subs(x, U + low) if low != 0 else body.subs(x, U)
            if body.has(sp.log(U)):
                body = (body.subs(sp.log(U), X).subs(U, sp.exp(X)) * sp.exp(X)).subs(
                    sp.log(sp.exp(X)), X
                )
                return self.term_by_term(body, X, self.gauss)
            return self.term_by_term(body, U, self.gamma)
        if low == -sp.oo:
            return self.by_rule(body.subs(x, -x), x, -high, sp.oo)
        return self.beta(body, x, low, high)

    def term_by_term(self, body, x, rule):
        body = sp.expand(
            sp.powsimp(sp.expand(body, power_base=False, power_exp=False), combine="exp"),
            power_base=False,
            power_exp=False,
        )
        result = 0
        for t in sp.Add.make_args(body):
            c, m = sp.powsimp(t, combine="exp").as_independent(x)
            part = rule(m, x)
            if part is None:
                return None
            result += c * part
        return result

    def gauss(self, m, x):
        """x**n exp(-a x**2 + b x) over all x."""
        power, exponent = sp.Integer(0), sp.Integer(0)
        for f in sp.Mul.make_args(m):
            if isinstance(f, sp.exp):
                exponent += f.args[0]
            elif f == x or (f.is_Pow and f.base == x):
                power += f.as_base_exp()[1]
            elif f.has(x):
                return None
        exponent = sp.expand(exponent)
        if not (power.is_Integer and 0 <= power <= 12 and exponent.is_polynomial(x)):
            return None
        Q = sp.Poly(exponent, x)
        if Q.degree() != 2:
            return None
        a, b, c = -Q.coeff_monomial(x**2), Q.coeff_monomial(x), Q.coeff_monomial(1)
        if not positive(a, self.model):
            return None
        n = int(power)
        mean, spread = b / (2 * a), 1 / (2 * a)
        moment = sum(
            sp.binomial(n, j) * mean ** (n - j) * spread ** (j // 2) * sp.factorial2(j - 1)
            for j in range(0, n + 1, 2)
        )
        return sp.sqrt(sp.pi / a) * sp.exp(sp.expand(b**2 / (4 * a)) + c) * moment

    def gamma(self, m, u):
        """u**s exp(-b u**p) over u > 0."""
        power, exponent = sp.Integer(0), sp.Integer(0)
        for f in sp.Mul.make_args(m):
            base, e = f.as_base_exp()
            if isinstance(f, sp.exp):
                exponent += f.args[0]
            elif base == u and not e.has(u):
                power += e
            elif f.has(u):
                return None
        exponent = sp.expand(exponent)
        b, rest = (-exponent).as_independent(u)
        if isinstance(exponent, sp.Add):
            shape = sp.factor(exponent).as_independent(u)
            b, rest = -shape[0], shape[1]
        base, p = rest.as_base_exp()
        if base != u or p.has(u):
            return None
        if not all(positive(e, self.model) for e in (b, p, power + 1)):
            return None
        return sp.gamma((power + 1) / p) / p * b ** (-(power + 1) / p)

    def beta(self, body, x, low, high):
        """(x - low)**p (high - x)**q between two ends, with whatever does not depend on x."""
        u = sp.Symbol("_u", positive=True)
        v = sp.Symbol("_v", positive=True)
        width = high - low
        if not positive(width, self.model):
            return None
        body = sp.powsimp(sp.factor(body.subs(x, low + width * u))) if body.has(x) else body
        result = 0
        for t in sp.Add.make_args(body):
            c, m = sp.factor(t).as_independent(u)
            powers = {u: sp.Integer(0), v: sp.Integer(0)}
            for f in sp.Mul.make_args(m):
                base, e = f.as_base_exp()
                if e.has(u) or not base.has(u):
                    return None
                base, factor = self.one_of(base, u, v)
                if base is None or (factor != 1 and not positive(factor, self.model)):
                    return None
                powers[base] += e
                c *= factor**e
            a, b = powers[u] + 1, powers[v] + 1
            if not (positive(a, self.model) and positive(b, self.model)):
                return None
            result += c * sp.gamma(a) * sp.gamma(b) / sp.gamma(a + b)
        return width * result

    @staticmethod
    def one_of(base, u, v):
        """Return which of u and v = 1 - u a factor is, and its coefficient."""
        if not base.is_polynomial(u) or sp.degree(base, u) != 1:
            return None, None
        a, b = sp.Poly(base, u).all_coeffs()
        if b == 0:
            return u, a
        return (v, b) if sp.expand(a + b) == 0 else (None, None)

    def by_antiderivative(self, body, x, low, high):
        if body.has(*self.names.values()) and len(self.names) > 4:
            return None
        if not self.model.smooth(body, x, low, high):
            return None
        above = self.proved(low) and (high == sp.oo or self.proved(high))
        facts = {"positive": True} if above else {"real": True}
        y = sp.Dummy("y", **facts)
        e = sp.integrate(sp.powsimp(body.subs(x, y)), (y, low, high))
        if e.has(sp.Integral, sp.Piecewise, *ENDLESS):
            e = sp.simplify(e) if e.has(sp.Piecewise) else e
        return None if e.has(sp.Integral, sp.Piecewise, *ENDLESS) else e

    def moments(self, body, x, low, high):
        """Named integrals over a standard range, one for each term."""
        u = sp.Dummy("u", positive=True)
        if low != -sp.oo and high != sp.oo:
            body, low, high = body.subs(x, low + (high - low) * u) * (high - low), 0, 1
        elif low != -sp.oo and high == sp.oo:
            body, low = body.subs(x, low + u), 0
        else:
            body = body.subs(x, u)
        letter = sp.Symbol("_x", real=True)
        result = 0
        for t in sp.Add.make_args(sp.expand(reduced(body))):
            c, m = t.as_independent(u)
            result += c * self.name("integral", m.subs(u, letter), low, high)
        return result


def split_powers(m, k):
    """Return (c, P, r, special) with m = c P(k) r**k times special factors."""
    c, r, P, special = sp.Integer(1), sp.Integer(1), sp.Poly(1, k), []
    for f in sp.Mul.make_args(m):
        base, e = (sp.E, f.args[0]) if isinstance(f, sp.exp) else f.as_base_exp()
        if not f.has(k):
            c *= f
        elif f.is_polynomial(k):
            P *= sp.Poly(f, k)
        elif not base.has(k) and e.is_polynomial(k) and sp.degree(e, k) == 1:
            slope, offset = sp.Poly(e, k).all_coeffs()
            r *= base**slope
            c *= base**offset
        else:
            special.append(f)
    return c, P, sp.simplify(r) if r != 1 else r, special


def falling(P):
    """Yield (j, a) with P(k) = sum of a * k (k-1) ... (k-j+1)."""
    k = P.gen
    rest = P
    for j in range(P.degree() + 1):
        divided, a = sp.div(rest, sp.Poly(k - j, k))
        if a.as_expr() != 0:
            yield j, a.as_expr()
        rest = divided
