"""Proofs: a normal form of zero, the moments of symbolic sums, positivity by coefficients."""

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.matrices.expressions.matexpr import MatrixElement

from .limits import bounded
from .reading import is_matrix

MAX_TERMS = 6000


class Model:
    """The declared names as SymPy symbols with assumptions; written forms evaluated over them."""

    def __init__(self, domains):
        self.domains = domains
        self.free = {s: e for d in domains.values() for s, e in d.free.items()}
        self.circles = {s: c for d in domains.values() for s, c in d.algebra.items()}
        self.known = {}

    def evaluated(self, w):
        if w not in self.known:
            self.known[w] = self._evaluate(w)
        return self.known[w]

    def _evaluate(self, w):
        if isinstance(w, (sp.Symbol, sp.MatrixSymbol)):
            if w.name in self.domains and not isinstance(w, sp.Dummy):
                return self.domains[w.name].symbol
            return sp.Symbol(w.name, real=True) if w.is_real is None else w
        if isinstance(w, sp.Indexed):
            return sp.IndexedBase(str(w.base.label), real=True)[
                tuple(self.evaluated(k) for k in w.indices)
            ]
        if isinstance(w, sp.MatrixBase):
            return w.applyfunc(self.evaluated)
        if w.is_Atom:
            return w
        if isinstance(w, AppliedUndef):
            name = w.func.__name__
            if name in self.domains and self.domains[name].kind == "seq":
                return sp.IndexedBase(name, real=True)[tuple(self.evaluated(k) for k in w.args)]
            return sp.Function(name, real=True)(*[self.evaluated(a) for a in w.args])
        if isinstance(w, sp.Inverse):
            return self._inverse(w.args[0])
        if isinstance(w, sp.MatMul):
            return sp.prod([self.evaluated(a) for a in w.args], start=sp.Integer(1))
        if isinstance(w, sp.MatAdd):
            return sum((self.evaluated(a) for a in w.args[1:]), self.evaluated(w.args[0]))
        if isinstance(w, (sp.Transpose, sp.Trace, sp.Determinant)):
            m = self.evaluated(w.args[0])
            return (
                m.T
                if isinstance(w, sp.Transpose)
                else m.trace()
                if isinstance(w, sp.Trace)
                else self.reduce(m.det())
            )
        if isinstance(w, sp.MatPow):
            return self.evaluated(w.base) ** w.exp
        if isinstance(w, MatrixElement):
            return self.evaluated(w.args[0])[w.args[1], w.args[2]]
        if isinstance(w, (sp.Identity, sp.ZeroMatrix)):
            return w.as_explicit()
        if isinstance(w, sp.Derivative):
            return self.evaluated(w.expr).diff(*[self.evaluated(v) for v in w.variables])
        if isinstance(w, sp.Subs):
            swap = {
                self.evaluated(v): self.evaluated(p)
                for v, p in zip(w.variables, w.point, strict=True)
            }
            return self.evaluated(w.expr).subs(swap, simultaneous=True)
        if isinstance(w, (sp.Integral, sp.Sum, sp.Product)):
            return self._scoped(w)
        return w.func(*[self.evaluated(a) for a in w.args])

    def _scoped(self, w):
        """Give the bound variable the assumptions of its limits, not those of a namesake."""
        limits, swap = [], {}
        body = self.evaluated(w.function)
        for name, *ends in w.limits:
            ends = [self.evaluated(e) for e in ends]
            if isinstance(w, sp.Integral):
                facts = {"positive": True} if ends and ends[0].is_nonnegative else {"real": True}
            else:
                facts = (
                    {"integer": True, "positive": True}
                    if ends[0].is_positive
                    else {"integer": True}
                )
            fresh = sp.Symbol(name.name, **facts)
            swap[self.evaluated(name)] = fresh
            limits.append((fresh, *ends))
        limits = [(x, *[e.subs(swap) for e in ends]) for x, *ends in limits]
        return w.func(body.subs(swap), *limits)

    def _inverse(self, w):
        if isinstance(w, sp.MatMul) and all(
            is_matrix(a) and a.shape[0] == a.shape[1] for a in w.args
        ):
            return sp.prod([self._inverse(a) for a in w.args[::-1]], start=sp.Integer(1))
        if isinstance(w, sp.Inverse):
            return self.evaluated(w.args[0])
        if isinstance(w, sp.Transpose):
            return self._inverse(w.args[0]).T
        m = self.evaluated(w)
        if isinstance(w, sp.MatrixSymbol) and self.domains[w.name].kind in ("rot", "se2"):
            R = m[:2, :2].T
            if m.shape == (2, 2):
                return R
            return R.row_join(-R * m[:2, 2]).col_join(sp.ImmutableMatrix([[0, 0, 1]]))
        if isinstance(w, sp.MatrixSymbol) and self.domains[w.name].kind in ("spd2", "spd3"):
            L = self.domains[w.name].factor
            back = L.adjugate() / L.det()
            return (back.T * back).as_immutable()
        return (m.adjugate() / self.reduce(m.det())).as_immutable()

    def reduce(self, e):
        """The normal form of a scalar: trigonometry and circles reduced, denominators untouched."""
        return _reduce(sp.expand(e), self.circles) if self.circles or e.has(sp.sin, sp.cos) else e

    def parametrized(self, e):
        return e.subs(self.free, simultaneous=True) if self.free else e


def terms(e):
    """About how many terms `e` has when expanded."""
    if e.is_Atom:
        return 1
    inner = [terms(a) for a in e.args]
    if e.is_Add:
        return min(sum(inner), 10**9)
    if e.is_Mul:
        return min(sp.prod(inner), 10**9)
    if e.is_Pow and e.exp.is_Integer:
        n, k = inner[0], min(abs(int(e.exp)), 200)
        return min(int(sp.binomial(n + k - 1, k)), 10**9) if n > 1 else 1
    return 1


def _reduce(e, circles=None):
    """Expand and take sin**2 to 1 - cos**2 for every angle, and r**q to its radicand."""
    e = sp.expand(e)
    gens = {}
    for f in e.atoms(sp.sin):
        gens[f] = sp.cos(f.args[0])
    gens |= circles or {}
    for s, c in gens.items():
        if e.has(s):
            e = _replace_powers(e, s, 2, 1 - c**2)
    return e


def _replace_powers(e, base, q, value):
    """base**q -> value in an expanded polynomial."""
    out = []
    for t in sp.Add.make_args(e):
        k = t.as_powers_dict().get(base, 0)
        if getattr(k, "is_Integer", False) and k >= q:
            m, r = divmod(int(k), q)
            t = sp.expand(t / base**k * base**r * value**m)
        out.append(t)
    return sp.expand(sp.Add(*out))


def _common_angles(e):
    """Write sin and cos of sums and multiples in those of single smallest angles."""
    arguments = [a for f in e.atoms(sp.sin, sp.cos, sp.tan) for a in [f.args[0]]]
    parts = {}
    for a in arguments:
        for t in sp.Add.make_args(sp.expand(a)):
            c, m = t.as_coeff_Mul()
            if c.is_Rational:
                parts[m] = sp.ilcm(parts.get(m, 1), c.q)
    swap = {m: n * sp.Dummy(real=True) for m, n in parts.items() if n > 1 and m.is_Symbol}
    e = e.subs(swap)
    return sp.expand_trig(e.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)))


def _radicals(e, circles):
    """Roots as new symbols r with r**q = radicand, reduced away."""
    roots = {}
    for p in e.atoms(sp.Pow):
        if p.exp.is_Rational and not p.exp.is_Integer and not p.base.is_number:
            q = sp.ilcm(roots.get(p.base, 1), p.exp.q)
            roots[p.base] = q
    if not roots or len(roots) > 4:
        return None
    names = {b: sp.Dummy(positive=True) for b in roots}
    e = e.replace(
        lambda p: p.is_Pow and p.base in names and p.exp.is_Rational and not p.exp.is_Integer,
        lambda p: names[p.base] ** int(p.exp * roots[p.base]),
    )
    e = sp.fraction(sp.together(e))[0]
    e = sp.expand(e)
    for b, r in names.items():
        e = _replace_powers(e, r, int(roots[b]), b)
    return _reduce(sp.fraction(sp.together(e))[0], circles)


def name_moments(e, names=None):
    """Write symbolic sums in their moments Sum(monomial); equal sums get equal names."""
    names = {} if names is None else names

    def moment(s):
        body, (i, low, high) = s.function, s.limits[0]
        if len(s.limits) > 1:
            inner = name_moments(sp.Sum(s.function, *s.limits[:-1]), names)
            return name_moments(sp.Sum(inner, s.limits[-1]), names)
        body = sp.expand(name_moments(body, names))
        k = sp.Symbol("_k", integer=True, positive=True)
        body = sp.expand(body.subs(i, k + low - 1))
        high = sp.expand(high - low + 1)
        total = 0
        for t in sp.Add.make_args(body):
            c, m = t.as_independent(k)
            if delta := [d for d in m.atoms(sp.KroneckerDelta) if d.has(k)]:
                where = sp.solve(delta[0].args[0] - delta[0].args[1], k)[0]
                total += c * (m / delta[0]).subs(k, where)
            elif m == 1:
                total += c * high
            elif m.is_polynomial(k):
                total += c * sp.summation(m, (k, 1, high))
            else:
                total += c * names.setdefault((m, high), sp.Symbol(f"_M{len(names)}", real=True))
        return total

    return e.replace(lambda x: isinstance(x, sp.Sum), moment) if e.has(sp.Sum) else e


def vanishes(e, model, seconds=1.2):
    """True if `e` is proved to be zero on the domain; False means only that no proof was found."""
    if e == 0:
        return True
    for attempt in ATTEMPTS:
        finished, answer = bounded(lambda attempt=attempt: attempt(e, model) == 0, seconds)
        if finished and answer:
            return True
    return False


def _polynomial(e, model):
    if e.has(sp.Sum):
        e = name_moments(e)
    e = model.parametrized(e)
    if e.has(sp.Integral, sp.Sum, sp.Product, sp.Derivative) and terms(e) > MAX_TERMS:
        return e
    if terms(e) > MAX_TERMS:
        return e
    e = _common_angles(e)
    e = sp.fraction(sp.together(e))[0]
    if terms(e) > 20 * MAX_TERMS:
        return e
    e = _reduce(e, model.circles)
    if e == 0:
        return e
    e = sp.expand(sp.powsimp(sp.expand_power_base(e)))
    r = _radicals(e, model.circles)
    return e if r is None else r


def _integrated(e, model):
    if not e.has(sp.Integral, sp.Sum, sp.Product):
        return e
    e = model.parametrized(e)
    e = sp.powsimp(e).replace(sp.exp, lambda x: sp.exp(sp.factor(x))).doit()
    return e if e.has(sp.Piecewise) else sp.simplify(model.parametrized(e))


def _cases(e, model):
    """|g| = g or -g: zero in every case."""
    e = e.rewrite(sp.Abs) if e.has(sp.Max, sp.Min) else e
    switches = list(e.atoms(sp.Abs))
    if not 1 <= len(switches) <= 3:
        return e
    import itertools

    for signs in itertools.product([1, -1], repeat=len(switches)):
        case = e.xreplace({a: s * a.args[0] for a, s in zip(switches, signs, strict=True)})
        if _polynomial(case, model) != 0:
            return e
    return sp.Integer(0)


def _logs(e, model):
    e = sp.expand_log(model.parametrized(name_moments(e)))
    e = e.replace(sp.log, lambda x: sp.expand_log(_log_of_powers(sp.factor(sp.together(x)))))
    return sp.simplify(sp.expand(e)) if terms(e) < 2000 else e


def _log_of_powers(x):
    """log of a product, with log(y**2) = 2 log|y| for every real y that is not zero."""
    even = [f for f in sp.Mul.make_args(x) if f.is_Pow and f.exp.is_even and f.base.is_real]
    rest = sp.Mul(*[f for f in sp.Mul.make_args(x) if f not in even])
    return sum((f.exp * sp.log(sp.Abs(f.base)) for f in even), sp.log(rest))


def _simplified(e, model):
    return sp.simplify(model.parametrized(e)) if sp.count_ops(e) < 400 else e


def _functions(e, model):
    e = model.parametrized(e)
    return (
        sp.simplify(sp.gammasimp(sp.expand_func(sp.powsimp(e, force=False))))
        if e.has(sp.gamma, sp.factorial, sp.binomial)
        else e
    )


ATTEMPTS = [_polynomial, _integrated, _logs, _cases, _simplified, _functions]


def positive(e, model, strict=True):
    """True if `e` > 0 (or >= 0) is proved on the domain."""
    e = model.parametrized(e)
    known = e.is_positive if strict else e.is_nonnegative
    if known:
        return True
    finished, answer = bounded(lambda: _positive(e, strict), 1.0)
    return finished and bool(answer)


def _positive(e, strict):
    if terms(e) > MAX_TERMS:
        return False
    num, den = sp.fraction(sp.together(e))
    for part in (num, den):
        sign = 1
        for f in sp.Mul.make_args(sp.factor(part)):
            if f.is_positive or (not strict and part is num and f.is_nonnegative):
                continue
            if (
                f.is_Pow
                and f.exp.is_even
                and f.base.is_real
                and (f.base.is_nonzero or (not strict and part is num))
            ):
                continue
            s = _sign(f, strict or part is den)
            if not s:
                return False
            sign *= s
        num, den = (sign, den) if part is num else (num, sign)
    return num * den > 0


def _square_completed(f, strict):
    """a v**2 + b v + c with a > 0 is positive where 4 a c - b**2 is."""
    for v in sorted(f.free_symbols, key=str):
        if f.is_polynomial(v) and sp.degree(f, v) == 2:
            a, b, c = sp.Poly(f, v).all_coeffs()
            rest = sp.expand(4 * a * c - b**2)
            if _sign(a, True) == 1 and (
                (rest == 0 and not strict) or (rest != 0 and _sign(rest, strict) == 1)
            ):
                return 1
    return 0


def _sign(f, strict):
    return _sign_by_coefficients(f, strict) or _square_completed(f, strict)


def _sign_by_coefficients(f, strict):
    pieces = [
        t.is_positive or (0 if t.is_nonnegative else None) for t in sp.Add.make_args(sp.expand(f))
    ]
    if None not in pieces and (any(pieces) or not strict):
        return 1
    pieces = [
        t.is_negative or (0 if t.is_nonpositive else None) for t in sp.Add.make_args(sp.expand(f))
    ]
    if None not in pieces and (any(pieces) or not strict):
        return -1
    return 0


def nonzero(e, model):
    return bool(e.is_nonzero) or positive(e, model) or positive(-e, model) or positive(e**2, model)


def equation_proved(before, after, relation, model):
    """Same solutions: a ratio that is never zero, or one solution put into the other line."""
    f, g = (model.evaluated(w.lhs) - model.evaluated(w.rhs) for w in (before, after))
    if not f.is_Matrix and not g.is_Matrix:
        f, g = sp.expand(f), sp.expand(g)
        names = {}
        f, g = name_moments(f, names), name_moments(g, names)
        for simpler in (sp.cancel, sp.simplify):
            finished, ratio = bounded(lambda simpler=simpler: sp.factor(simpler(f / g)), 1.0)
            whole = finished and not ratio.has(sp.zoo, sp.nan)
            if whole and all(nonzero(part, model) for part in sp.fraction(ratio)):
                return True
    return any(
        _solution_proved(line, rest, relation == ok, model)
        for line, rest, ok in ((after, f, "implied_by"), (before, g, "implies"))
    )


def _solution_proved(line, f, one_way, model):
    """`line` says x = e; `f` is zero there and, if that is needed, nowhere else on the domain."""
    if not isinstance(line.lhs, (sp.Symbol, sp.MatrixSymbol)):
        return False
    domain = model.domains[line.lhs.name]
    x, e = (sp.Matrix([model.evaluated(w)]) for w in line.args)
    f = sp.Matrix([f])
    if f.has(sp.Integral) or not all(v.is_Symbol for v in x) or any(e.has(v) for v in x):
        return False
    if not one_way:
        slopes = f.jacobian(list(x))
        if slopes.rows != slopes.cols:
            return False
        slope = model.reduce(slopes.det())
        if any(
            slope.has(v) for v in x
        ):  # not linear: a strictly rising or falling function on an interval
            if domain.kind not in ("real", ">0", "interval") or not domain.surely(
                e[0], lambda d: positive(d, model)
            ):
                return False
            if not positive(slope, model) and not positive(-slope, model):
                return False
        elif not nonzero(slope, model):
            return False
    swap = dict(zip(x, e, strict=True))
    return all(vanishes(d.subs(swap, simultaneous=True), model) for d in f)


def inequality_proved(before, after, model):
    from .evaluating import RELATIONS

    if before.func is not after.func and RELATIONS[before.func] * RELATIONS[after.func] == 0:
        return False
    if (before.func in (sp.Gt, sp.Lt)) != (after.func in (sp.Gt, sp.Lt)):
        return False
    f, g = (
        RELATIONS[w.func] * (model.evaluated(w.lhs) - model.evaluated(w.rhs))
        for w in (before, after)
    )
    finished, ratio = bounded(lambda: sp.factor(sp.simplify(f / g)), 1.5)
    return finished and positive(ratio, model)
