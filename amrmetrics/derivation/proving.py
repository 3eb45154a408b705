"""Proofs. Every one keeps these rules, and nothing else counts as a proof.

1.  Symbols carry only what their domains say; the ends of a domain are exact.
2.  What a line needs in order to have a value (`breaks.needs`) is said as a condition, or is
    implied by the domains. Only under these conditions may terms cancel.
3.  A sum or product is written in closed form only if its upper end is proved to lie no more than
    one below its lower end, the empty range included; terms are split off only inside the range.
4.  A Kronecker delta picks a term only if its index is proved to lie in the range.
5.  An integral has a closed form by a rule whose conditions are proved, or by an antiderivative of
    an integrand that is proved to have neither pole nor bend in the open range.
6.  An equation is solved by division by what is proved not to vanish.
"""

import itertools

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.matrices.expressions.matexpr import MatrixElement

from .algebra import same
from .breaks import BENT, needs, nodes, show
from .limits import bounded
from .reading import is_claim, is_inequality, is_matrix, renamed

MAX_TERMS = 6000
ENDLESS = (sp.zoo, sp.nan, sp.oo, -sp.oo)


class Model:
    """The declared names as SymPy symbols with assumptions; written forms evaluated over them."""

    def __init__(self, domains, tops=(), sized=False):
        self.domains, self.tops, self.sized = domains, tops, sized
        self.free = {s: e for d in domains.values() for s, e in d.free.items()}
        self.circles = dict(d.circle for d in domains.values() if d.circle)
        self.known = {}

    # ---- evaluating --------------------------------------------------------------------------

    def evaluated(self, w):
        if w not in self.known:
            self.known[w] = self._evaluate(w)
        return self.known[w]

    def _evaluate(self, w):
        if isinstance(w, sp.Dummy) or w.is_Number:
            return w
        if isinstance(w, sp.Symbol | sp.MatrixSymbol):
            return self.domains[w.name].symbol if w.name in self.domains else w
        if isinstance(w, sp.Indexed):
            base = self.domains[str(w.base.label)].symbol
            return base[tuple(self.evaluated(k) for k in w.indices)]
        if isinstance(w, sp.MatrixBase):
            return w.applyfunc(self.evaluated)
        if w.is_Atom:
            return w
        rule = RULES.get(w.func)
        if rule is not None:
            return rule(self, w)
        if isinstance(w, AppliedUndef):
            return self.domains[w.func.__name__].symbol(*map(self.evaluated, w.args))
        return w.func(*map(self.evaluated, w.args))

    def _scoped(self, w):
        """Give a bound letter the assumptions of its range."""
        swap, limits = {}, []
        for letter, *ends in w.limits[::-1]:
            ends = [self.evaluated(e).xreplace(swap) for e in ends]
            if isinstance(w, sp.Integral):
                above = all(self.parametrized(e).is_nonnegative for e in ends)
                facts = {"positive": True} if above else {"real": True}
            else:
                facts = {"integer": True}
                if self.parametrized(ends[0]).is_positive:
                    facts["positive"] = True
                elif self.parametrized(ends[0]).is_nonnegative:
                    facts["nonnegative"] = True
            swap[letter] = sp.Dummy(letter.name, **facts)
            limits.append((swap[letter], *ends))
        return w.func(self.evaluated(w.function).xreplace(swap), *limits[::-1])

    def _inverse(self, w):
        if isinstance(w, sp.MatMul) and all(
            is_matrix(a) and a.shape[0] == a.shape[1] for a in w.args
        ):
            return sp.prod([self._inverse(a) for a in w.args[::-1]], start=sp.Integer(1))
        if isinstance(w, sp.Inverse):
            return self.evaluated(w.args[0])
        if isinstance(w, sp.Transpose):
            return self._inverse(w.args[0]).T
        if isinstance(w, sp.MatrixSymbol) and self.domains[w.name].inverse is not None:
            return self.domains[w.name].inverse
        m = self.evaluated(w)
        return (m.adjugate() / self.reduce(m.det())).as_immutable()

    def reduce(self, e):
        """The normal form of a scalar: trigonometry and circles reduced, denominators untouched."""
        return reduced(sp.expand(e), self.circles) if self.circles or e.has(sp.sin, sp.cos) else e

    def parametrized(self, e):
        return e.subs(self.free, simultaneous=True) if self.free else e

    # ---- what is implied ---------------------------------------------------------------------

    def implied(self, kind, parts):
        """Whether the domains imply what a formula needs (see `breaks.needs`)."""
        if kind == "pair":
            return any(nonzero(e, self) for e in parts)
        if kind == "differ":
            return nonzero(parts[0] - parts[1], self)
        (e,) = parts
        if kind == "nonzero":
            return nonzero(e, self)
        if kind == "unit":
            return positive(1 - e**2, self, strict=False)
        if kind == "gamma":
            return positive(e, self)
        return positive(e, self, strict=kind == "positive")

    def smooth(self, e, letter, low, high):
        """Whether `e` is proved to have neither pole nor bend for `letter` in the open range."""
        u = sp.Dummy("u", positive=True)
        if low == -sp.oo:
            inside = sp.Dummy("u", real=True) if high == sp.oo else high - u
        else:
            inside = low + u if high == sp.oo else (low + high * u) / (1 + u)
        for node, bound in nodes(e):
            if letter not in node.free_symbols:
                continue
            if isinstance(node, BENT):
                return False
            for kind, parts in needs(node):
                if bound.keys() & set().union(*(p.free_symbols for p in parts)):
                    return False
                if not self.implied(
                    kind, [sp.sympify(p).doit().subs(letter, inside) for p in parts]
                ):
                    return False
        return True


def _product(model, w):
    return sp.prod([model.evaluated(a) for a in w.args], start=sp.Integer(1))


def _total(model, w):
    return sum((model.evaluated(a) for a in w.args[1:]), model.evaluated(w.args[0]))


def _derived(model, w):
    return model.evaluated(w.expr).diff(*map(model.evaluated, w.variables))


def _put(model, w):
    letters = {v: sp.Dummy(v.name, real=True) for v in w.variables}
    body = model.evaluated(renamed(w.args[0], letters))
    values = dict(zip(letters.values(), map(model.evaluated, w.point), strict=True))
    return body.subs(values, simultaneous=True)


def _limit(model, w):
    body, letter, target, side = w.args
    new = sp.Dummy(letter.name, **({"positive": True} if target == sp.oo else {"real": True}))
    e, target = model.evaluated(body).subs(letter, new), model.evaluated(target)
    falls = {
        d.symbol: sp.exp(-sp.Dummy(positive=True))  # so that SymPy sees that r**n tends to zero
        for d in model.domains.values()
        if d.text == "(0,1)"
    }
    finished, result = bounded(lambda: sp.limit(e.subs(falls), new, target, str(side)), 0.8)
    if not finished or result.has(*ENDLESS, sp.Limit, sp.AccumBounds):
        return w.func(e, new, target, str(side))
    return result.subs({-f.args[0]: -sp.log(s) for s, f in falls.items()})


RULES = {
    sp.Inverse: lambda model, w: model._inverse(w.args[0]),
    sp.MatMul: _product,
    sp.MatAdd: _total,
    sp.Transpose: lambda model, w: model.evaluated(w.args[0]).T,
    sp.Trace: lambda model, w: model.evaluated(w.args[0]).trace(),
    sp.Determinant: lambda model, w: model.reduce(model.evaluated(w.args[0]).det()),
    sp.MatPow: lambda model, w: model.evaluated(w.base) ** w.exp,
    MatrixElement: lambda model, w: model.evaluated(w.args[0])[w.args[1], w.args[2]],
    sp.Identity: lambda model, w: w.as_explicit(),
    sp.ZeroMatrix: lambda model, w: w.as_explicit(),
    sp.Derivative: _derived,
    sp.Subs: _put,
    sp.Limit: _limit,
    sp.Integral: Model._scoped,
    sp.Sum: Model._scoped,
    sp.Product: Model._scoped,
}


# ---- conditions ----------------------------------------------------------------------------------


def conditions(lines, model):
    """Return what the lines need and the domains do not imply, such as ``x != 0``.

    What an integrand needs is not among it: whether an integral exists is a question of its own.
    """
    found = {}
    for w in lines:
        for node, bound in nodes(w):
            inside = nodes(node.expr) if isinstance(node, sp.Derivative) else []
            ways = _ways({v: bound[v] for v in node.free_symbols & bound.keys()}, model)
            for kind, parts in [*needs(node, model, ways), *_kinks(inside)]:
                letters = set().union(*(p.free_symbols for p in parts))
                scopes = {v: bound[v] for v in letters & bound.keys()}
                if letters and all(s[0] in (sp.Sum, sp.Product) for s in scopes.values()):
                    found.setdefault(_words(kind, parts, scopes), (kind, parts, scopes))
    return tuple(
        text for text, need in found.items() if text and not _implied_in_range(*need, model)
    )


def _implied_in_range(kind, parts, scopes, model):
    """Whether a need is implied for every value of the letters of sums and products."""
    if model.sized and any(p.has(sp.MatrixSymbol) for p in parts):
        return all(isinstance(p, sp.Determinant) and _regular(p.args[0], model) for p in parts)
    parts = [model.evaluated(p) for p in parts]
    return any(model.implied(kind, [p.subs(w) for p in parts]) for w in _ways(scopes, model))


def _ways(scopes, model):
    """Return what letters of sums and products are: counted from the lower or the upper end."""
    rising, falling = {}, {}
    for letter, (kind, *ends) in scopes.items():
        if kind in (sp.Sum, sp.Product):
            steps = sp.Dummy(letter.name, integer=True, nonnegative=True)
            rising[letter] = model.evaluated(ends[0]) + steps
            if ends[1] != sp.oo:
                falling[letter] = model.evaluated(ends[1]) - steps
    return [rising, {**rising, **falling}] if rising else [{}]


def _regular(w, model):
    """Whether a matrix of any size has an inverse by what it is made of."""
    if isinstance(w, sp.MatrixSymbol):
        return getattr(model.domains.get(w.name), "family", "") in ("spd", "chol", "rot")
    if not isinstance(w, sp.MatMul | sp.Transpose | sp.Inverse):
        return False
    return all(
        _regular(a, model) if is_matrix(a) else nonzero(model.evaluated(a), model) for a in w.args
    )


def _kinks(inside):
    for node, _ in inside:
        if isinstance(node, sp.Abs | sp.sign):
            yield "nonzero", node.args
        elif isinstance(node, sp.Max | sp.Min):
            args = sorted(node.args, key=lambda a: a.is_number)  # x != 0, not 0 != x
            yield from (("differ", pair) for pair in itertools.combinations(args, 2))


def _words(kind, parts, bound):
    """Say a condition of the simplest thing that it is about; "" for what cannot be said."""
    every = ", ".join(sorted(s.name for s in bound))
    tail = f" for every {every}" if bound else ""
    w = parts[0]
    while kind in ("positive", "nonnegative"):
        if isinstance(w, sp.Abs) or (isinstance(w, sp.Pow) and w.exp.is_even and w.exp.is_positive):
            if kind == "nonnegative":
                return ""
            kind, w = "nonzero", w.args[0]
        elif isinstance(w, sp.Pow) and w.exp.is_Rational and w.exp > 0:
            w = w.base
        else:
            break
    text = {
        "nonzero": "{} != 0",
        "positive": "{} > 0",
        "nonnegative": "{} >= 0",
        "unit": "|{}| <= 1",
        "gamma": "{} > 0",
        "differ": "{} != {}",
        "pair": "({}, {}) != (0, 0)",
    }[kind]
    return text.format(*(show(p) for p in (w, *parts[1:]))) + tail


# ---- normal forms --------------------------------------------------------------------------------


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


def reduced(e, circles=None):
    """Expand and take sin**2 to 1 - cos**2 for every angle."""
    e = sp.expand(e)
    pairs = {f: sp.cos(f.args[0]) for f in e.atoms(sp.sin)} | (circles or {})
    for s, c in pairs.items():
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
    parts = {}
    for f in e.atoms(sp.sin, sp.cos, sp.tan, sp.cot):
        for t in sp.Add.make_args(sp.expand(f.args[0])):
            c, m = t.as_coeff_Mul()
            if c.is_Rational:
                parts[m] = sp.ilcm(parts.get(m, 1), c.q)
    swap = {m: n * sp.Dummy(real=True) for m, n in parts.items() if n > 1 and m.is_Symbol}
    e = e.subs(swap).replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x))
    return sp.expand_trig(e.replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x)))


def _radicals(e, circles):
    """Roots as new symbols r with r**q = radicand, reduced away."""
    roots = {}
    for p in e.atoms(sp.Pow):
        if p.exp.is_Rational and not p.exp.is_Integer and not p.base.is_number:
            roots[p.base] = sp.ilcm(roots.get(p.base, 1), p.exp.q)
    if not 1 <= len(roots) <= 4:
        return e
    names = {b: sp.Dummy(positive=True) for b in roots}
    e = e.replace(
        lambda p: p.is_Pow and p.base in names and p.exp.is_Rational and not p.exp.is_Integer,
        lambda p: names[p.base] ** int(p.exp * roots[p.base]),
    )
    e = sp.expand(sp.fraction(sp.together(e))[0])
    for b, r in names.items():
        e = _replace_powers(e, r, int(roots[b]), b)
    return reduced(sp.fraction(sp.together(e))[0], circles)


def vanishes(e, model):
    """True if `e` is proved to be zero on the domain; False means only that no proof was found."""
    from .closing import closed

    if e == 0:
        return True
    finished, e = bounded(lambda: closed(decided(e, model), model), 1.6)
    if not finished:
        return False
    for attempt, seconds in ATTEMPTS:
        finished, answer = bounded(lambda attempt=attempt, e=e: attempt(e, model) == 0, seconds)
        if finished and answer:
            return True
    return False


def decided(e, model):
    """Return `e` with |g|, the sign of g and the like carried out where the sign of g is proved."""
    for f in e.atoms(sp.Abs, sp.sign, sp.Heaviside, sp.Max, sp.Min):
        if isinstance(f, sp.Max | sp.Min) and len(f.args) != 2:
            continue
        g = f.args[0] - f.args[1] if isinstance(f, sp.Max | sp.Min) else f.args[0]
        s = 1 if positive(g, model) else -1 if positive(-g, model) else 0
        if s:
            e = e.xreplace({f: _carried_out(f, s)})
    return e


def _carried_out(f, s):
    """Return the value of a switch whose argument has the sign `s`."""
    a, b = f.args[0], f.args[-1]
    if isinstance(f, sp.Max | sp.Min):
        return (a if s > 0 else b) if isinstance(f, sp.Max) else (b if s > 0 else a)
    if isinstance(f, sp.Heaviside):
        return sp.Integer(s > 0)
    return s * a if isinstance(f, sp.Abs) else sp.Integer(s)


def polynomial(e, model):
    """The numerator of `e`, in a normal form modulo the relations among its functions."""
    e = model.parametrized(e)
    if terms(e) > MAX_TERMS:
        return e
    e = sp.fraction(sp.together(_common_angles(e)))[0]
    if terms(e) > 20 * MAX_TERMS:
        return e
    e = reduced(e, model.circles)
    if e != 0:
        e = sp.together(sp.expand(sp.powsimp(sp.expand_power_base(e))))
        e = sp.expand(sp.fraction(e)[0])
    return e if e == 0 else _radicals(e, model.circles)


def _cases(e, model):
    """|g| = g or -g: zero in every case."""
    e = e.rewrite(sp.Abs) if e.has(sp.Max, sp.Min) else e
    switches = list(e.atoms(sp.Abs))
    if not 1 <= len(switches) <= 3:
        return e
    for signs in itertools.product([1, -1], repeat=len(switches)):
        case = e.xreplace({a: s * a.args[0] for a, s in zip(switches, signs, strict=True)})
        if polynomial(case, model) != 0:
            return e
    return sp.Integer(0)


def _simplified(e, model):
    """One bounded `simplify`, logarithms of products and powers taken apart before."""
    e = model.parametrized(e)
    if sp.count_ops(e) > 500:
        return e
    if e.has(sp.log):
        e = sp.expand_log(e).replace(sp.log, lambda x: _log(sp.factor(sp.together(x))))
        e = sp.expand(e)
    if e.has(sp.gamma, sp.factorial, sp.binomial, sp.beta):
        e = sp.gammasimp(sp.expand_func(sp.powsimp(e).rewrite(sp.gamma)))
    return sp.simplify(e)


def _log(x):
    """log of a product, with log(y**2) = 2 log|y| for every real y that is not zero."""
    even = [f for f in sp.Mul.make_args(x) if f.is_Pow and f.exp.is_even and f.base.is_real]
    rest = sp.Mul(*[f for f in sp.Mul.make_args(x) if f not in even])
    return sp.expand_log(sum((f.exp * sp.log(sp.Abs(f.base)) for f in even), sp.log(rest)))


ATTEMPTS = [(polynomial, 1.2), (_cases, 0.8), (_simplified, 1.4)]


# ---- signs ---------------------------------------------------------------------------------------


def positive(e, model, strict=True):
    """True if `e` > 0 (or >= 0) is proved on the domain."""
    e = sp.sympify(model.parametrized(e))
    known = e.is_positive if strict else e.is_nonnegative
    if known:
        return True
    if e.is_number:
        return False
    finished, answer = bounded(lambda: _positive(e, strict), 0.6)
    return finished and bool(answer)


def _positive(e, strict):
    if terms(e) > MAX_TERMS:
        return False
    total = 1
    numerator, denominator = sp.fraction(sp.together(e))
    for part in (numerator, denominator):
        exact = strict or part is denominator
        for f in sp.Mul.make_args(sp.factor(part)):
            even = f.is_Pow and f.exp.is_even and f.base.is_real
            if f.is_positive or (not exact and (f.is_nonnegative or even)):
                continue
            if even and f.base.is_nonzero:
                continue
            s = _sign(f, exact)
            if not s:
                return False
            total *= s
    return total > 0


def _sign(f, strict):
    f = sp.expand(f)
    for s in (1, -1):
        pieces = [_piece(s * t) for t in sp.Add.make_args(f)]
        if None not in pieces and (any(pieces) or not strict):
            return s
    return _square_completed(f, strict)


def _piece(t):
    return 1 if t.is_positive else 0 if t.is_nonnegative else None


def _square_completed(f, strict):
    """a v**2 + b v + c with a > 0 is positive where 4 a c - b**2 is."""
    for v in sorted(f.free_symbols, key=str):
        if f.is_polynomial(v) and sp.degree(f, v) == 2:
            a, b, c = sp.Poly(f, v).all_coeffs()
            rest = sp.expand(4 * a * c - b**2)
            if a.is_positive and (
                (rest == 0 and not strict) or (rest != 0 and _sign(rest, strict) == 1)
            ):
                return 1
    return 0


def nonzero(e, model):
    e = sp.sympify(e)
    return bool(e.is_nonzero) or any(positive(x, model) for x in (e, -e, e**2))


# ---- claims --------------------------------------------------------------------------------------


def proved(before, after, relation, model):
    """Whether the step is proved; `before` is None for a claim that has to hold everywhere."""
    if before is None:
        return is_inequality(after) and _claim(after, model)
    if isinstance(before, sp.Eq) and isinstance(after, sp.Eq):
        return _equations(before, after, relation, model)
    if is_inequality(before) and is_inequality(after):
        return _inequalities(before, after, relation, model)
    if is_claim(before):
        return False
    if model.sized:
        return same(before, after, model)
    a, b = model.evaluated(before), model.evaluated(after)
    if is_matrix(a):
        return all(vanishes(x, model) for x in (a - b))
    return vanishes(a - b, model)


def _claim(w, model):
    if model.sized:
        return False
    from .closing import closed

    d = closed(model.evaluated(w.gts) - model.evaluated(w.lts), model)
    return positive(d, model, strict=isinstance(w, sp.Gt | sp.Lt))


def _equations(before, after, relation, model):
    """Same solutions: a ratio that is never zero, or one solution put into the other line."""
    if model.sized:
        return False
    from .closing import closed

    f, g = (model.evaluated(w.lhs) - model.evaluated(w.rhs) for w in (before, after))
    if not is_matrix(f) and not is_matrix(g):
        names = {}
        f, g = (closed(sp.expand(x), model, names) for x in (f, g))
        for simpler in (sp.cancel, sp.simplify):
            finished, ratio = bounded(lambda simpler=simpler: sp.factor(simpler(f / g)), 1.0)
            sound = finished and not ratio.has(*ENDLESS)
            if sound and all(nonzero(part, model) for part in sp.fraction(ratio)):
                return True
    pairs = ((after, f, "implied_by"), (before, g, "implies"))
    return any(_solution(line, rest, relation == ok, model) for line, rest, ok in pairs)


def _solution(line, f, one_way, model):
    """`line` says x = e; `f` is zero there and, if that is needed, nowhere else on the domain."""
    if not isinstance(line.lhs, sp.Symbol | sp.MatrixSymbol) or line.lhs.name not in model.domains:
        return False
    domain = model.domains[line.lhs.name]
    x, e = (sp.Matrix([model.evaluated(w)]) for w in line.args)
    f = sp.Matrix([f])
    if f.has(sp.Integral) or not all(v.is_Symbol for v in x) or any(e.has(v) for v in x):
        return False
    if not one_way and not _only_once(f, x, e, domain, model):
        return False
    swap = dict(zip(x, e, strict=True))
    return all(vanishes(d.subs(swap, simultaneous=True), model) for d in f)


def _only_once(f, x, e, domain, model):
    """Whether `f` has at most one zero in `x`: linear, or strictly rising or falling."""
    slopes = f.jacobian(list(x))
    if slopes.rows != slopes.cols:
        return False
    slope = model.reduce(slopes.det())
    if not any(slope.has(v) for v in x):
        return nonzero(slope, model)
    if not domain.real or not domain.inside(e[0], lambda d: positive(d, model)):
        return False
    return positive(slope, model) or positive(-slope, model)


def _inequalities(before, after, relation, model):
    """Both sides of one line are those of the other times something positive."""
    if model.sized:
        return False
    strict = [isinstance(w, sp.Gt | sp.Lt) for w in (before, after)]
    if strict[0] != strict[1]:
        return False
    f, g = (model.evaluated(w.gts) - model.evaluated(w.lts) for w in (before, after))
    finished, ratio = bounded(lambda: sp.factor(sp.simplify(f / g)), 1.0)
    return finished and positive(ratio, model)
