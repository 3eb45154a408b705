"""From text, or a SymPy object, to the *written form*: a SymPy tree that nothing has cancelled.

Text goes through Python's own parser. Only the listed kinds of node are built, and no text is
ever run as code.
"""

import ast
import difflib
import re

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import BooleanAtom
from sympy.matrices.expressions.matexpr import MatrixElement

MAX_TEXT, MAX_NODES, MAX_DEPTH, MAX_DEGREE, MAX_TERMS = 4000, 2500, 60, 120, 1000
UNICODE = str.maketrans({"−": "-", "–": "-", "·": "*", "×": "*", "≤": "<=", "≥": ">=", "≠": "!="})
UNICODE |= str.maketrans({"²": "**2", "³": "**3", "π": "pi", "∞": "oo"})

_ONE = "sin cos tan cot sinh cosh tanh asin acos atan exp log Abs sign gamma factorial erf erfc"
_TWO = "atan2 binomial beta uppergamma lowergamma KroneckerDelta Mod"
FUNCTIONS = {n: getattr(sp, n) for n in f"{_ONE} {_TWO} floor ceiling Max Min".split()}
ARITY = dict.fromkeys(_TWO.split(), (2, 2)) | {"log": (1, 2), "Max": (1, 9), "Min": (1, 9)}
OTHER_NAMES = {"abs": "Abs", "max": "Max", "min": "Min", "ln": "log", "ceil": "ceiling"}
OTHER_NAMES |= {"diff": "Derivative", "integrate": "Integral", "summation": "Sum", "limit": "Limit"}
OTHER_NAMES |= {"product": "Product", "prod": "Product", "sum": "Sum", "Integrate": "Integral"}
OTHER_NAMES |= {
    "tr": "Trace",
    "trace": "Trace",
    "Determinant": "det",
    "Inverse": "inv",
    "Diff": "Derivative",
}
OTHER_NAMES |= {f"arc{n}": f"a{n}" for n in ("sin", "cos", "tan", "tan2")}
MODULES = ("np", "numpy", "math", "sp", "sympy")
RELATIONS = {n: getattr(sp, n) for n in ("Eq", "Ne", "Gt", "Ge", "Lt", "Le")}
COMPARE = {ast.Gt: sp.Gt, ast.GtE: sp.Ge, ast.Lt: sp.Lt, ast.LtE: sp.Le}
COMPARE |= {ast.Eq: sp.Eq, ast.NotEq: sp.Ne}
CONSTANTS = {"pi": sp.pi, "E": sp.E, "oo": sp.oo}
MATRIX = {"inv": sp.Inverse, "det": sp.Determinant, "trace": sp.Trace, "transpose": sp.Transpose}
SCOPED = {"Sum": sp.Sum, "Product": sp.Product, "Integral": sp.Integral}
SPECIAL = ["sqrt", *SCOPED, "Derivative", "Subs", "Limit", "Piecewise", "And", "Or", "Not"]
SPECIAL += ["Matrix", "eye", "diag", "Trace", "det", "inv", "transpose", "norm", "cross", "skew"]


class Unreadable(ValueError):
    """The line cannot be read; the message says why and what to write instead."""


def is_matrix(w):
    """Whether `w` is a matrix, explicit or symbolic."""
    return bool(getattr(w, "is_Matrix", False))


def is_claim(w):
    """Whether `w` is an equation or inequality, not a formula."""
    return isinstance(w, sp.Rel | sp.And | sp.Or | sp.Not | BooleanAtom)


def is_inequality(w):
    """Whether `w` is a single claim with <, <=, > or >=."""
    return isinstance(w, sp.Gt | sp.Ge | sp.Lt | sp.Le)


def read(line, kinds):
    """Return the written form of `line` (text or SymPy object), checked for size."""
    if isinstance(line, str):
        return vet(_Reader(kinds).line(line), kinds)
    try:
        w = sp.sympify(line, strict=True)
    except (sp.SympifyError, TypeError, ValueError):
        found = type(line).__name__
        raise Unreadable(f"a {found} is neither text nor a SymPy object") from None
    return vet(w.as_immutable() if isinstance(w, sp.MatrixBase) else w, kinds)


class _Reader:
    def __init__(self, kinds):
        self.kinds, self.bound, self.depth, self.text = kinds, [], 0, ""

    def line(self, text):
        if len(text) > MAX_TEXT:
            raise Unreadable(f"the line has {len(text)} characters; the limit is {MAX_TEXT}")
        try:
            self.text = text.strip().translate(UNICODE)
            tree = ast.parse(self.text, mode="eval")
        except (SyntaxError, ValueError, MemoryError, RecursionError, OverflowError) as error:
            raise Unreadable(_hint(text, error)) from None
        try:
            return self.build(tree.body)
        except Unreadable:
            raise
        except (RecursionError, TypeError, ValueError, AttributeError, IndexError) as error:
            raise Unreadable(f"cannot be read as a formula ({type(error).__name__})") from None

    def build(self, node):
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise Unreadable("too deeply nested; split the line into shorter ones")
        method = getattr(self, "_" + type(node).__name__, None)
        if method is None:
            raise Unreadable(f"{type(node).__name__} is not part of a formula")
        result = method(node)
        self.depth -= 1
        return result

    def number(self, node):
        return scalar(self.build(node))

    def matrix(self, node, square=False):
        w = self.build(node)
        if not is_matrix(w):
            raise Unreadable(f"{w} is a number, not a matrix")
        if square and w.shape[0] != w.shape[1]:
            raise Unreadable(f"a matrix of shape {w.shape[0]} x {w.shape[1]} is not square")
        return w

    def _Constant(self, node):
        if type(node.value) is bool:
            return sp.true if node.value else sp.false
        if type(node.value) is int:
            return sp.Integer(node.value)
        digits = ast.get_source_segment(self.text, node)  # all that were written
        lost = node.value == 0 and re.search("[1-9]", digits.lower().split("e")[0])
        if type(node.value) is float and abs(node.value) < 1e300 and not lost:
            return sp.Rational(digits)
        raise Unreadable(f"{digits[:30]!r} is not a number that one can work with")

    def _Name(self, node):
        name, kind = node.id, self.kinds.get(node.id)
        if isinstance(kind, tuple):
            return sp.MatrixSymbol(name, *kind)
        if kind in ("sequence", "function") and name not in self.bound:
            how = f"{name}[i]" if kind == "sequence" else f"{name}(...)"
            raise Unreadable(f"{name} is a {kind}: write {how}")
        if kind or name in self.bound:
            return sp.Symbol(name)
        if name in CONSTANTS:
            return CONSTANTS[name]
        raise Unreadable(_unknown(name, self.kinds))

    def _UnaryOp(self, node):
        if not isinstance(node.op, ast.USub | ast.UAdd):
            raise Unreadable("only + and - may stand before a term")
        value = self.build(node.operand)
        return _negative(value) if isinstance(node.op, ast.USub) else value

    def _BinOp(self, node):
        if isinstance(node.op, ast.Pow):
            return _power(self.build(node.left), self.build(node.right))
        for kinds, join, turned in (
            ((ast.Add, ast.Sub), _plus, _negative),
            ((ast.Mult, ast.Div, ast.MatMult), _times, _over),
        ):
            if isinstance(node.op, kinds):
                parts = []  # a long sum is a deep tree: walk down its spine
                while isinstance(node, ast.BinOp) and isinstance(node.op, kinds):
                    w = self.build(node.right)
                    parts.append(turned(w) if isinstance(node.op, ast.Sub | ast.Div) else w)
                    node = node.left
                return join([self.build(node), *parts[::-1]])
        if isinstance(node.op, ast.Mod):
            return FUNCTIONS["Mod"](self.number(node.left), self.number(node.right), evaluate=False)
        if isinstance(node.op, ast.BitXor):
            raise Unreadable("^ is not a power: write ** instead")
        raise Unreadable(f"the operator {type(node.op).__name__} is not part of a formula")

    def _Compare(self, node):
        if any(type(op) not in COMPARE for op in node.ops):
            raise Unreadable(
                "write an equation as left == right, an inequality with <, <=, > or >="
            )
        parts = [self.build(x) for x in (node.left, *node.comparators)]
        links = [_relation(COMPARE[type(op)], *parts[k : k + 2]) for k, op in enumerate(node.ops)]
        return links[0] if len(links) == 1 else sp.And(*links, evaluate=False)

    def _BoolOp(self, node):
        kind = sp.And if isinstance(node.op, ast.And) else sp.Or
        return kind(*[self.claim(x) for x in node.values], evaluate=False)

    def claim(self, node):
        w = self.build(node)
        if not is_claim(w):
            raise Unreadable(f"{w} is a formula where an equation or inequality is needed")
        return w

    def _Attribute(self, node):
        module = getattr(node.value, "id", None)
        if module in MODULES and module not in self.kinds:
            name = OTHER_NAMES.get(node.attr, node.attr)
            raise Unreadable(f"write {name}, without {module}.")
        if node.attr == "T":
            return sp.Transpose(self.matrix(node.value))
        raise Unreadable(f".{node.attr} is not known; matrices have .T, .inv(), .det(), .trace()")

    def _Subscript(self, node):
        where = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        index = [self.number(k) for k in where]
        if isinstance(node.value, ast.Name) and self.kinds.get(node.value.id) == "sequence":
            return sp.IndexedBase(node.value.id)[tuple(index) if len(index) > 1 else index[0]]
        w = self.matrix(node.value)
        if len(index) == 1 and w.shape[1] == 1:
            index.append(sp.Integer(0))
        inside = [k.is_Integer and 0 <= k < n for k, n in zip(index, w.shape, strict=False)]
        if len(index) != 2 or not (all(inside) or _sizes(w)):
            shape = f"{w.shape[0]} x {w.shape[1]}"
            raise Unreadable(f"entries of a {shape} matrix are written M[row, column], from 0")
        return _entry(w, *index)

    def _Call(self, node):
        if node.keywords or any(isinstance(a, ast.Starred) for a in node.args):
            raise Unreadable("options cannot be passed to a function here")
        if isinstance(node.func, ast.Attribute):
            if node.func.attr not in MATRIX or node.args:
                return self._Attribute(node.func)
            square = node.func.attr != "transpose"
            return MATRIX[node.func.attr](self.matrix(node.func.value, square))
        if not isinstance(node.func, ast.Name):
            raise Unreadable("a bracket after a number or bracket: write * for a product")
        name = OTHER_NAMES.get(node.func.id, node.func.id)
        if self.kinds.get(name) == "function":
            return sp.Function(name)(*[self.number(a) for a in _counted(node, 1, 4)])
        if name in self.kinds or name in self.bound:
            raise Unreadable(f"{name} is not a function: write {name}*(...) for a product")
        if name in FUNCTIONS:
            values = [self.number(a) for a in _counted(node, *ARITY.get(name, (1, 1)))]
            if name == "log" and len(values) == 2:
                return _times([sp.log(values[0], evaluate=False), _over(sp.log(values[1]))])
            return FUNCTIONS[name](*values, evaluate=False)
        if name in ("E", "Var", "Cov", "mean") or (name == "P" and "P" not in self.kinds):
            raise Unreadable(f"{name}(...) is not known: write a mean as an Integral or a Sum")
        if name in RELATIONS:
            return _relation(RELATIONS[name], *[self.build(a) for a in _counted(node, 2, 2)])
        if name in SCOPED:
            return self.scoped(node, SCOPED[name], name)
        if name not in SPECIAL:
            raise Unreadable(_unknown(name, self.kinds))
        return getattr(self, "make_" + name)(node)

    def make_sqrt(self, node):
        return _power(self.build(*_counted(node, 1, 1)), sp.Rational(1, 2))

    def make_And(self, node):
        return sp.And(*[self.claim(a) for a in _counted(node, 1, 9)], evaluate=False)

    def make_Or(self, node):
        return sp.Or(*[self.claim(a) for a in _counted(node, 1, 9)], evaluate=False)

    def make_Not(self, node):
        return sp.Not(self.claim(*_counted(node, 1, 1)), evaluate=False)

    def make_Piecewise(self, node):
        cases = []
        for pair in _counted(node, 1, 9):
            parts = getattr(pair, "elts", [])
            if len(parts) != 2:
                raise Unreadable("write Piecewise((formula, condition), ..., (formula, True))")
            cases.append((self.number(parts[0]), self.claim(parts[1])))
        return sp.Piecewise(*cases, evaluate=False)

    def make_Limit(self, node):
        body, name, target, *side = _counted(node, 3, 4)
        if not isinstance(name, ast.Name):
            raise Unreadable("write Limit(formula, letter, value)")
        target = self.number(target)
        side = getattr(side[0], "value", None) if side else "+-"
        if side not in ("+", "-", "+-"):
            raise Unreadable('the side of a Limit is "+" or "-"')
        if target in (sp.oo, -sp.oo):
            side = "-" if target == sp.oo else "+"
        self.bound.append(name.id)
        body = self.number(body)
        self.bound.pop()
        return sp.Limit(body, sp.Symbol(name.id), target, side)

    def make_Trace(self, node):
        return sp.Trace(self.matrix(*_counted(node, 1, 1), square=True))

    def make_det(self, node):
        return sp.Determinant(self.matrix(*_counted(node, 1, 1), square=True))

    def make_inv(self, node):
        return sp.Inverse(self.matrix(*_counted(node, 1, 1), square=True))

    def make_transpose(self, node):
        return sp.Transpose(self.matrix(*_counted(node, 1, 1)))

    def make_norm(self, node):
        v = self.matrix(*_counted(node, 1, 1))
        return _power(_times([sp.Transpose(v), v]), sp.Rational(1, 2))

    def make_diag(self, node):
        entries = [self.number(a) for a in _counted(node, 1, 6)]
        n = range(len(entries))
        return sp.ImmutableMatrix([[entries[i] if i == j else 0 for j in n] for i in n])

    def make_cross(self, node):
        u, v = (self.matrix(a) for a in _counted(node, 2, 2))
        return _times([_skew(u), v])

    def make_skew(self, node):
        return _skew(self.matrix(*_counted(node, 1, 1)))

    def make_eye(self, node):
        n = self.build(*_counted(node, 1, 1))
        if n.is_Symbol:
            return sp.Identity(n)
        if not (n.is_Integer and 1 <= n <= 6):
            raise Unreadable("eye(n) needs a whole number n from 1 to 6")
        return sp.eye(int(n)).as_immutable()

    def make_Matrix(self, node):
        (rows,) = _counted(node, 1, 1)
        rows = [getattr(r, "elts", [r]) for r in getattr(rows, "elts", [])]
        if not rows or len({len(r) for r in rows}) != 1 or not 1 <= len(rows[0]) <= 6 >= len(rows):
            raise Unreadable("write Matrix([[a, b], [c, d]]) or Matrix([a, b]), at most 6 x 6")
        return sp.ImmutableMatrix([[self.number(x) for x in row] for row in rows])

    def scoped(self, node, kind, name):
        """Sum, Product and Integral: (expression, (variable, low, high), ...), outermost last."""
        limits, outside = [], len(self.bound)
        for limit in node.args[:0:-1]:
            parts = getattr(limit, "elts", [])
            if len(parts) != 3 or not isinstance(parts[0], ast.Name):
                break
            ends = [self.number(x) for x in parts[1:]]
            self.bound.append(parts[0].id)
            limits.append((sp.Symbol(parts[0].id), *ends))
        if not limits or len(limits) != len(node.args) - 1:
            raise Unreadable(f"{name} needs limits: {name}(expression, (variable, from, to))")
        body = self.number(node.args[0])
        del self.bound[outside:]
        return kind(body, *limits[::-1])

    def make_Derivative(self, node):
        variables = []
        for a in _counted(node, 2, 7)[1:]:
            x, times = a.elts if isinstance(a, ast.Tuple) and len(a.elts) == 2 else (a, None)
            if isinstance(x, ast.Constant) and variables:
                x, times = None, ast.Constant(x.value - 1)
            x = variables[-1] if x is None else self.build(x)
            n = 1 if times is None else self._Constant(times)
            variables += [x] * int(min(n, 9))
        if len(variables) > 6 or not all(isinstance(v, sp.Symbol | sp.Indexed) for v in variables):
            raise Unreadable("a derivative is taken by one variable at a time, at most six times")
        body = self.build(node.args[0])
        if is_matrix(body) and tuple(body.shape) != (1, 1):
            rows, columns = map(int, body.shape)
            return sp.ImmutableMatrix(
                rows, columns, lambda i, j: sp.Derivative(_entry(body, i, j), *variables)
            )
        return sp.Derivative(scalar(body), *variables)

    def make_Subs(self, node):
        body, name, value = _counted(node, 3, 3)
        if not isinstance(name, ast.Name):
            raise Unreadable("write Subs(expression, variable, value)")
        value = self.number(value)
        self.bound.append(name.id)
        w = sp.Subs(self.number(body), sp.Symbol(name.id), value)
        self.bound.pop()
        return w


def _counted(node, low, high):
    if not low <= len(node.args) <= high:
        count = low if low == high else f"{low} to {high}"
        raise Unreadable(f"{node.func.id} takes {count} argument{'s' * (high > 1)}")
    return node.args


def _skew(v):
    """Return the matrix that turns a cross product with `v` into a matrix product."""
    if tuple(v.shape) != (3, 1):
        raise Unreadable("cross and skew are for vectors of three components")
    x, y, z = (_entry(v, sp.Integer(k), sp.Integer(0)) for k in range(3))
    return sp.ImmutableMatrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def _sizes(w):
    """Whether the size of `w` is a symbol."""
    return any(not n.is_Integer for n in map(sp.sympify, w.shape))


def _entry(w, i, j):
    return w[i, j] if isinstance(w, sp.MatrixBase) else MatrixElement(w, i, j)


def scalar(w):
    """Return `w` as a number: a 1 x 1 matrix is its entry."""
    if is_claim(w):
        raise Unreadable("an equation cannot stand inside a formula")
    if not is_matrix(w):
        return w
    if tuple(w.shape) != (1, 1):
        raise Unreadable(f"a {w.shape[0]} x {w.shape[1]} matrix stands where a number is needed")
    return _entry(w, 0, 0)


def alike(parts):
    """Return `parts`, all numbers or all matrices of one shape."""
    shapes = {tuple(w.shape) if is_matrix(w) else (1, 1) for w in parts}
    if shapes == {(1, 1)} or any(is_claim(w) for w in parts):
        return [scalar(w) for w in parts]
    if len(shapes) > 1:
        names = [
            "a number" if s == (1, 1) else f"a {s[0]} x {s[1]} matrix"
            for s in sorted(shapes, key=str)
        ]
        raise Unreadable(f"the shapes do not fit: {' and '.join(names)}")
    return list(parts)


def _relation(kind, left, right):
    left, right = alike([left, right])
    if kind is not sp.Eq and is_matrix(left):
        raise Unreadable("matrices cannot be ordered by < or >")
    return kind(left, right, evaluate=False)


def _flat(parts, kind):
    return [x for w in parts for x in (w.args if type(w) is kind else [w])]


def _plus(parts):
    parts = alike(parts)
    if is_matrix(parts[0]):
        return sp.MatAdd(*parts, evaluate=False)
    return sp.Add(*_flat(parts, sp.Add), evaluate=False)


def _times(parts):
    if not any(is_matrix(w) for w in parts):
        parts = [scalar(w) for w in parts]
        if len(parts) == 2 and parts[0].is_Integer and isinstance(parts[1], sp.Pow):
            base, exponent = parts[1].args
            if base.is_Integer and exponent == -1:
                return sp.Rational(parts[0], base)  # 1/2 is a number, not a quotient
        return sp.Mul(*_flat(parts, sp.Mul), evaluate=False)
    scalars, factors = [], []
    for w in parts:
        shape = tuple(w.shape) if is_matrix(w) else None
        before = factors and (factors[0].shape[0], factors[-1].shape[1])
        if shape is None or (before and shape == (1, 1) != before[1:] + (1,)):
            scalars.append(scalar(w))
        elif before and before[1] != shape[0]:
            if before != (1, 1):
                fit = f"{before[0]} x {before[1]} times {shape[0]} x {shape[1]}"
                raise Unreadable(f"the shapes do not fit: {fit}; is a .T missing?")
            scalars.append(scalar(sp.MatMul(*factors, evaluate=False)))
            factors = [w]
        else:
            factors.append(w)
    return sp.MatMul(*scalars, *factors, evaluate=False)


def _negative(w):
    if w.is_Number:
        return -w
    if isinstance(w, sp.Mul) and w.args[0].is_Number:
        return sp.Mul(-w.args[0], *w.args[1:], evaluate=False)
    return _times([sp.Integer(-1), w])


def _over(w):
    if is_matrix(w) and tuple(w.shape) != (1, 1):
        raise Unreadable("one cannot divide by a matrix: multiply by its .inv()")
    return _power(w, sp.Integer(-1))


def _power(base, exponent):
    exponent = scalar(exponent)
    if is_matrix(base) and tuple(base.shape) != (1, 1):
        if base.shape[0] != base.shape[1]:
            raise Unreadable("only a square matrix has powers")
        if exponent == -1:
            return sp.Inverse(base)
        if not (exponent.is_Integer and 1 <= exponent <= 6):
            raise Unreadable("a power of a matrix is a whole number from 1 to 6, or .inv()")
        return sp.MatMul(*[base] * int(exponent), evaluate=False)
    base = scalar(base)
    if base == 0 and exponent.is_Number and exponent < 0:
        raise Unreadable("division by zero")
    return sp.Pow(base, exponent, evaluate=False)


def _unknown(name, kinds):
    known = [*kinds, *FUNCTIONS, *RELATIONS, *SPECIAL, *CONSTANTS]
    close = difflib.get_close_matches(name, known, 1, 0.6) if len(name) > 1 else []
    close = close or [k for k in known if k.lower() == name.lower()]
    ask = f"did you mean {close[0]}?" if close else "declare it in the domains"
    return f"{name[:40]} is not declared; {ask}"


def _hint(text, error):
    for pattern, hint in (
        (r"^\s*$", "the line is empty"),
        (r"\blambda\b", "lambda is a reserved word: call it lam"),
        (r"(?<![\w.])\d+(\.\d+)?(?![eE][+-]?\d)[A-Za-z_]", "a product needs its sign: 2*x, not 2x"),
        (r"\|", "the absolute value of x is written Abs(x)"),
        (r"[\w)]!(?!=)", "the factorial of n is written factorial(n)"),
        (r"(?<![=<>!])=(?!=)", "write an equation as left == right, or Eq(left, right)"),
    ):
        if re.search(pattern, text):
            return hint
    if text.count("(") != text.count(")") or text.count("[") != text.count("]"):
        return "the brackets do not match"
    return f"cannot be read: {getattr(error, 'msg', None) or 'too complicated'}"


def tidy(w):
    """Put order, signs and numbers straight, as SymPy does on building; compute nothing else."""
    if isinstance(w, sp.MatrixBase):
        return w.applyfunc(tidy)
    if w.is_Atom or not w.args:
        return sp.Symbol(w.name) if type(w) is sp.Symbol else w
    args = [tidy(a) for a in w.args]
    return w.func(*args, evaluate=False) if isinstance(w, sp.Rel) else w.func(*args)


def rebuild(w, leaf):
    """Return `w` with the nodes exchanged for which `leaf` returns one, all else as written."""
    new = leaf(w)
    if new is not None:
        return new
    if not w.args or (w.is_Atom and not isinstance(w, sp.Indexed)):
        return w
    if isinstance(w, sp.MatrixBase):
        return w.applyfunc(lambda x: rebuild(x, leaf))
    args = [rebuild(a, leaf) for a in w.args]
    if all(a is b for a, b in zip(args, w.args, strict=True)):
        return w
    kept = sp.Add | sp.Mul | sp.Pow | sp.MatAdd | sp.MatMul | sp.Rel | sp.And | sp.Or | sp.Piecewise
    keep = isinstance(w, kept) or (isinstance(w, sp.Function) and not isinstance(w, AppliedUndef))
    return w.func(*args, evaluate=False) if keep else w.func(*args)


def apart(w):
    """Return `w` with every bound letter exchanged for one that nothing else is called.

    Not those of Subs, which SymPy takes for equal whatever their letters are.
    """

    def leaf(x):
        if isinstance(x, sp.Sum | sp.Product | sp.Integral):
            swap, limits = {}, []
            for letter, *ends in x.limits[::-1]:  # the outermost first: inner ends may use it
                ends = [renamed(apart(e), swap) for e in ends]
                swap = {**swap, letter: sp.Dummy(letter.name)}
                limits.append((swap[letter], *ends))
            return x.func(renamed(apart(x.function), swap), *limits[::-1])
        if isinstance(x, sp.Limit):
            body, letter, target, side = x.args
            new = sp.Dummy(letter.name)
            return sp.Limit(renamed(apart(body), {letter: new}), new, apart(target), str(side))
        return None

    return rebuild(w, leaf)


def renamed(w, swap):
    """Return `w` with some symbols exchanged, everything else as written."""
    return rebuild(w, lambda x: swap.get(x) if x.is_Symbol else None) if swap else w


def vet(w, kinds):
    """Refuse what is too large to work on and what is not declared, in text and SymPy objects."""
    from .evaluating import Undefined, Unreliable, magnitude_ok

    bound = set()
    for count, node in enumerate(sp.preorder_traversal(w)):
        if count > MAX_NODES:
            raise Unreadable("the line is too long; split it")
        if node in (sp.nan, sp.zoo):
            raise Unreadable("the line contains a value that is not defined, such as 1/0")
        if isinstance(node, sp.Sum | sp.Product | sp.Integral | sp.Subs):
            bound |= {v.name for v in node.variables}
        if isinstance(node, sp.Limit):
            bound.add(node.args[1].name)
        if isinstance(node, sp.Sum | sp.Product):
            for _, low, high in node.limits:
                if (high - low).is_Integer and high - low > MAX_TERMS:
                    raise Unreadable(
                        f"a sum of more than {MAX_TERMS} terms needs a symbol as limit"
                    )
        if (
            type(node) is sp.Symbol
            and node.name not in (*kinds, "+", "-", "+-")
            and node.name not in bound
        ):
            raise Unreadable(_unknown(node.name, kinds))
        part, limit = None, 1e300
        if isinstance(node, sp.Pow) and node.base.free_symbols and not node.exp.free_symbols:
            part, limit = node.exp, MAX_DEGREE
        elif isinstance(node, sp.Pow | sp.Function) and not isinstance(node, AppliedUndef):
            part = None if node.free_symbols else node
        try:
            if part is not None and not magnitude_ok(part, limit):
                raise Unreadable("a number or an exponent in this line is too large to work with")
        except (Undefined, Unreliable):
            raise Unreadable("a number in this line is not defined or too large") from None
    if degree(w) > 4 * MAX_DEGREE:
        raise Unreadable("the powers in this line are too large to check")
    return w


def degree(w):
    """Return a bound for the polynomial degree after expanding."""
    if w.is_Atom or not w.args:
        return int(w.is_Symbol)
    inner = [degree(a) for a in w.args]
    if isinstance(w, sp.Mul | sp.MatMul):
        return sum(inner)
    if isinstance(w, sp.Pow) and w.exp.is_Rational:
        return float(abs(w.exp)) * inner[0]
    return max(inner)
