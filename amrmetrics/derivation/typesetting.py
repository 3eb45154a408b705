"""A line as it was written, in LaTeX: the order, the brackets and the names that were typed.

SymPy's own printer shows what SymPy made of a line; this one shows the line.
"""

import ast
import re
from typing import NamedTuple

from .reading import CONSTANTS, OTHER_NAMES, UNICODE

WIDEST = 70  # signs in a row; what is wider is broken between its terms

# How tightly a piece holds together. What is looser than its place asks for is put in brackets.
CLAIM, SUM, SIGNED, PRODUCT, FRACTION, POWER, ATOM = range(7)


class Piece(NamedTuple):
    """Some LaTeX; `open` if a factor written behind it would be taken for a part of it."""

    tex: str
    level: int = ATOM
    open: bool = False


GREEK = r"""alpha beta gamma delta zeta eta theta iota kappa mu nu xi pi rho sigma tau upsilon chi
    psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"""
LETTERS = {n: f"\\{n}" for n in GREEK.split()} | {"lam": r"\lambda", "lamda": r"\lambda"}
LETTERS |= {"epsilon": r"\varepsilon", "eps": r"\varepsilon", "phi": r"\varphi", "ell": r"\ell"}
ACCENTS = {"hat": r"\hat", "bar": r"\bar", "tilde": r"\tilde", "dot": r"\dot"}
NUMBERS = {"pi": r"\pi", "oo": r"\infty", "E": "e"}
SCOPED = ("Sum", "Product", "Integral", "Subs", "Limit")  # what binds a letter
BIG = {"Sum": r"\sum", "Product": r"\prod", "Integral": r"\int"}
ANGULAR = ("sin", "cos", "tan", "cot", "sinh", "cosh", "tanh")
OPERATORS = {n: f"\\{n}" for n in (*ANGULAR, "log", "exp", "det")}
OPERATORS |= {"asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan", "Max": r"\max"}
OPERATORS |= {"Min": r"\min", "gamma": r"\Gamma", "uppergamma": r"\Gamma", "lowergamma": r"\gamma"}
OPERATORS |= {"beta": r"\mathrm{B}", "Trace": r"\operatorname{tr}", "sign": r"\operatorname{sgn}"}
OPERATORS |= {n: rf"\operatorname{{{n}}}" for n in ("atan2", "erf", "erfc", "diag", "skew")}
# What is written in a way of its own: the form, the level of the whole, and for each argument
# the level that its place asks for, or None if it is written small.
FORMS = {
    "sqrt": (r"\sqrt{<0>}", POWER, CLAIM),
    "factorial": ("<0>!", POWER, ATOM),
    "binomial": (r"\binom{<0>}{<1>}", ATOM, None, None),
    "KroneckerDelta": (r"\delta_{<0>,<1>}", ATOM, None, None),
    "Mod": (r"<0> \bmod <1>", SUM, PRODUCT, POWER),
    "cross": (r"<0> \times <1>", PRODUCT, POWER, POWER),
    "eye": ("I_{<0>}", ATOM, None),
    "inv": ("<0>^{-1}", POWER, ATOM),
    "T": (r"<0>^{\mathsf{T}}", POWER, ATOM),
    "Abs": (r"\left\lvert <0>\right\rvert ", ATOM, CLAIM),
    "norm": (r"\left\lVert <0>\right\rVert ", ATOM, CLAIM),
    "floor": (r"\left\lfloor <0>\right\rfloor ", ATOM, CLAIM),
    "ceiling": (r"\left\lceil <0>\right\rceil ", ATOM, CLAIM),
    "Subs": (r"\left. <0> \right|_{<1>=<2>}", FRACTION, CLAIM, None, None),
    "Not": (r"\text{not } <0>", CLAIM, SUM),
}
FORMS["transpose"] = FORMS["T"]
SIGNS = {"Eq": "=", "NotEq": r"\ne", "Gt": ">", "GtE": r"\ge", "Lt": "<", "LtE": r"\le"}
SIGNS |= {"Ne": r"\ne", "Ge": r"\ge", "Le": r"\le"}
FORMS |= {name: (f"<0> {sign} <1>", CLAIM, SUM, SUM) for name, sign in SIGNS.items()}


def name_of(node):
    """Return what a call calls (`diff` and `Derivative` are one), "" if `node` is no such call."""
    if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
        return ""
    return OTHER_NAMES.get(node.func.id, node.func.id)


def parse(text):
    """Return Python's tree of a line of text, or None if it is none; nothing is run."""
    try:
        return ast.parse(text.strip().translate(UNICODE), mode="eval").body
    except (SyntaxError, ValueError, MemoryError, RecursionError, OverflowError):
        return None


def plain(text):
    """Return the line as it was typed, on one line."""
    return " ".join(text.split())


def typeset(text, letters=()):
    """Return the LaTeX of a line as it was typed, or None if it is no formula.

    `letters` are names that are letters even where a function is called the same.
    """
    node = parse(text)
    try:
        return node and _Setter(text, letters).line(node)
    except (RecursionError, AttributeError, TypeError, ValueError, IndexError, KeyError):
        return None  # the checker says what is wrong with it


def letter(name):
    """Return the LaTeX of a name: xhat, x_k, x1, epsilon."""
    head, *below = name.split("_")
    if m := re.fullmatch(r"(\D+)(\d+)", head):
        head, below = m[1], [m[2], *below]
    accent = next((a for a in ACCENTS if head.endswith(a) and _single(head[: -len(a)])), "")
    head = head.removesuffix(accent)
    tex = LETTERS.get(head, head) if _single(head) else rf"\mathrm{{{head}}}"
    tex = rf"{ACCENTS[accent]}{{{tex}}}" if accent else tex
    below = [LETTERS.get(b, b if len(b) < 3 or b.isdigit() else rf"\mathrm{{{b}}}") for b in below]
    return f"{tex}_{{{','.join(below)}}}" if any(below) else tex


def _single(name):
    return len(name) == 1 or name in LETTERS


class _Setter:
    def __init__(self, text, letters):
        self.source = text.strip().translate(UNICODE).encode()
        self.letters, self.pieces = set(letters), {}
        self.small = False  # whether in an exponent or within a fraction: quotients become a/b

    def line(self, node):
        """Return the whole line, in several rows if it is wide."""
        tex = self.set(node).tex
        rows = self.rows(node) if _width(tex) > WIDEST else [tex]
        if len(rows) == 1:
            return tex
        rows = [rf"\displaystyle {row}" for row in rows]
        return r"\begin{array}{l} " + r" \\[1ex] ".join(rows) + r" \end{array}"

    def rows(self, node):
        """Return the line in rows, broken before the signs of its claim and its outermost sum."""
        if isinstance(node, ast.Compare) and len(node.ops) == 1:
            left, right = self.rows(node.left), self.rows(node.comparators[0])
            return [*left, rf"\quad {_sign(node.ops[0])} {right[0]}", *right[1:]]
        terms = []
        while isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
            if terms and self.bracketed(node):
                break
            terms.append(f"{_sign(node.op)} {self.place(node.right, PRODUCT)}")
            node = node.left
        rows = [self.place(node, SUM) if terms else self.set(node).tex]
        for term in terms[::-1]:
            if _width(rows[-1] + term) > WIDEST:
                rows.append(r"\quad {}")
            rows[-1] += f" {term}"
        return rows

    def place(self, node, level, last=True):
        """Return a part in a place that asks for this level; brackets that were typed are kept."""
        piece = self.set(node)
        kept = SUM <= piece.level <= PRODUCT and CLAIM < level < POWER and self.bracketed(node)
        loose = piece.level < level or (piece.open and not last)
        return brackets(piece.tex) if loose or kept else piece.tex

    def bracketed(self, node):
        before, after = self.source[: node.col_offset], self.source[node.end_col_offset :]
        return before.rstrip().endswith(b"(") and after.lstrip().startswith(b")")

    def within(self, node, level=CLAIM):
        """Return a part as it stands in an exponent, an index or a fraction."""
        outside, self.small = self.small, True
        tex = self.place(node, level)
        self.small = outside
        return tex

    def form(self, name, args):
        form, level, *places = FORMS[name]
        parts = [
            self.within(a) if p is None else self.place(a, p)
            for a, p in zip(args, places, strict=True)
        ]
        return Piece(re.sub("<(.)>", lambda m: parts[int(m[1])], form), level)

    def set(self, node):
        key = id(node), self.small
        if key not in self.pieces:
            self.pieces[key] = getattr(self, "_" + type(node).__name__)(node)
        return self.pieces[key]

    def all(self, nodes):
        return ", ".join(self.set(n).tex for n in nodes)

    # --- numbers, names, operators -------------------------------------------------------------

    def _Constant(self, node):
        text = self.source[node.col_offset : node.end_col_offset].decode()
        if m := re.fullmatch(r"(.+?)[eE]\+?(-?)0*(\d+)", text):
            return Piece(rf"{m[1]} \cdot 10^{{{m[2]}{m[3]}}}", PRODUCT)
        return Piece(text if text[0].isdigit() or text[0] == "." else rf"\text{{{text}}}")

    def _Name(self, node):
        constant = node.id in CONSTANTS and node.id not in self.letters
        return Piece(NUMBERS[node.id] if constant else letter(node.id))

    def _UnaryOp(self, node):
        if isinstance(node.op, ast.Not):
            return self.form("Not", [node.operand])
        tex = _sign(node.op) + self.place(node.operand, PRODUCT)
        return Piece(tex, SIGNED, self.set(node.operand).open)

    def _BinOp(self, node):
        return getattr(self, "_" + type(node.op).__name__)(node)

    def _Add(self, node):
        left, right = self.place(node.left, SUM), self.place(node.right, PRODUCT)
        return Piece(f"{left} {_sign(node.op)} {right}", SUM)

    def _Mult(self, node):
        left, right = self.place(node.left, SIGNED, last=False), self.place(node.right, FRACTION)
        return _product(left, right, self.set(node.right).open)

    def _Div(self, node):
        top = node.left
        if self.small:
            left, right = self.place(top, SIGNED, last=False), self.place(node.right, POWER)
            return Piece(f"{left}/{right}", SIGNED if left.startswith("-") else PRODUCT, True)
        if _holds_quotient(top) and not self.bracketed(top):  # a/b*c/d: two fractions
            fraction = self.fraction(self.within(top.right), node.right)
            return _product(self.place(top.left, SIGNED, last=False), fraction)
        if isinstance(top, ast.UnaryOp) and isinstance(top.op, ast.USub):
            return Piece("-" + self.fraction(self.within(top.operand), node.right), SIGNED)
        tex = self.within(top)
        if tex.startswith("-") and self.set(top).level == SIGNED:
            return Piece("-" + self.fraction(tex[1:], node.right), SIGNED)
        return Piece(self.fraction(tex, node.right), FRACTION)

    def fraction(self, top, below):
        style = r"\displaystyle " if re.search(r"\\int(?![a-z])", top) else ""
        return rf"\frac{{{style}{top}}}{{{self.within(below)}}}"

    def _Pow(self, node):
        exponent, name = self.within(node.right), name_of(node.left)
        if name in ANGULAR:
            return Piece(
                f"{OPERATORS[name]}^{{{exponent}}}{brackets(self.all(node.left.args))}", POWER
            )
        return Piece(f"{self.place(node.left, ATOM)}^{{{exponent}}}", POWER)

    def _Mod(self, node):
        return self.form("Mod", [node.left, node.right])

    _Sub, _MatMult, _BitXor = _Add, _Mult, _Pow

    def _Compare(self, node):
        tex = self.place(node.left, SUM)
        for op, part in zip(node.ops, node.comparators, strict=True):
            tex += f" {_sign(op)} {self.place(part, SUM)}"
        return Piece(tex, CLAIM)

    def _BoolOp(self, node):
        return self.joined(type(node.op).__name__, node.values)

    def joined(self, word, claims):
        return Piece(rf" \text{{ {word.lower()} }} ".join(self.set(c).tex for c in claims), CLAIM)

    def _Attribute(self, node):
        return self.form(node.attr, [node.value])

    def _Subscript(self, node):
        where = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        base, below = self.place(node.value, ATOM), ",".join(self.within(k) for k in where)
        if isinstance(node.value, ast.Name) and (m := re.fullmatch(r"(.*)_\{(.*)\}", base)):
            base, below = m[1], f"{m[2]},{below}"  # x_a[k]
        return Piece(f"{base}_{{{below}}}")

    # --- functions -----------------------------------------------------------------------------

    def _Call(self, node):
        name, args = name_of(node), node.args
        if not name:  # a method: P.inv()
            name, args = node.func.attr, [node.func.value]
            name = OTHER_NAMES.get(name, name)
        elif node.func.id in self.letters:
            name = ""
        if hasattr(self, "set_" + name):
            return getattr(self, "set_" + name)(*args)
        if name in FORMS:
            return self.form(name, args)
        if name in BIG:
            return self.big(name, args)
        if name in ("And", "Or"):
            return self.joined(name, args)
        if name in OPERATORS:
            return self.operator(OPERATORS[name], args)
        return Piece(letter(node.func.id) + brackets(self.all(args)))

    def operator(self, sign, args):
        bare = isinstance(args[0], ast.Name) and sign in (
            r"\sin",
            r"\cos",
            r"\tan",
            r"\log",
            r"\det",
        )
        if bare or (name_of(args[0]) == "Matrix" and sign == r"\det"):
            return Piece(f"{sign} {self.all(args)}", POWER)
        return Piece(sign + brackets(self.all(args)))

    def big(self, name, args):
        """Sums, products and integrals: the outermost limit stands last and is written first."""
        body, *limits = args
        tex, end = "", ""
        for limit in limits[::-1]:
            x, *ends = getattr(limit, "elts", [limit])
            ends = [self.within(e) for e in ends]
            below = [] if name == "Integral" else [letter(x.id)]
            tex += f"{BIG[name]}_{{{'='.join(below + ends[:1])}}}"
            tex += f"^{{{ends[1]}}} " if ends else " "
            end = rf" \,d{letter(x.id)}{end}"
        tex += self.place(body, PRODUCT)
        return Piece(tex + end, FRACTION) if name == "Integral" else Piece(tex, FRACTION, True)

    def set_exp(self, argument):
        exponent = self.within(argument)
        if _width(exponent) > 28 or re.search(r"\\(sum|prod|int|begin|lim)", exponent):
            return Piece(r"\exp" + brackets(self.set(argument).tex))
        return Piece(f"e^{{{exponent}}}", POWER)

    def set_log(self, argument, base=None):
        return self.operator(
            r"\log" if base is None else rf"\log_{{{self.within(base)}}}", [argument]
        )

    def set_Matrix(self, rows):
        rows = [getattr(r, "elts", [r]) for r in rows.elts]
        body = r" \\ ".join(" & ".join(self.set(x).tex for x in row) for row in rows)
        return Piece(rf"\begin{{pmatrix}} {body} \end{{pmatrix}}")

    def set_Piecewise(self, *pairs):
        rows = []
        for value, case in (pair.elts for pair in pairs):
            otherwise = isinstance(case, ast.Constant)
            when = "otherwise" if otherwise else rf"if }} {self.set(case).tex} \text{{"
            rows.append(rf"{self.set(value).tex} & \text{{{when}}}")
        return Piece(r"\begin{cases} " + r" \\ ".join(rows) + r" \end{cases}", FRACTION)

    def set_Derivative(self, body, *variables):
        letters = []
        for x in variables:
            x, times = (*x.elts,) if isinstance(x, ast.Tuple) else (x, None)
            if isinstance(x, ast.Constant):
                letters += letters[-1:] * (x.value - 1)
            else:
                letters += [self.set(x).tex] * (1 if times is None else times.value)
        several = len(getattr(body, "args", ())) > 1 and name_of(body) not in (*FORMS, *SCOPED)
        d = r"\partial" if several or len(set(letters)) > 1 else "d"
        counts = {x: letters.count(x) for x in letters}
        below = r"\,".join(f"{d} {x}^{{{n}}}" if n > 1 else f"{d} {x}" for x, n in counts.items())
        over = f"{d}^{{{len(letters)}}}" if len(letters) > 1 else d
        return Piece(rf"\frac{{{over}}}{{{below}}} {self.place(body, PRODUCT)}", FRACTION, True)

    def set_Limit(self, body, x, target, side=None):
        end = self.within(target) + (f"^{{{side.value}}}" if side and side.value in "+-" else "")
        tex = rf"\lim_{{{self.set(x).tex} \to {end}}} {self.place(body, PRODUCT)}"
        return Piece(tex, FRACTION, True)


def _sign(op):
    name = type(op).__name__
    return SIGNS.get(name) or {"Add": "+", "UAdd": "+", "Sub": "-", "USub": "-"}[name]


def _product(left, right, is_open=False):
    """Write two factors side by side."""
    joint = " "
    if right[:1].isdigit() or (left[-1:].isdigit() and right.startswith(r"\frac{")):
        joint = r" \cdot "
    elif "mathrm" in left[-20:] or re.match(r"\\(mathrm|frac\{d)", right):
        joint = r"\, "
    if not right.startswith((r"\sin", r"\cos", r"\tan", r"\log", r"\frac")):  # not sin x y
        bare = r"(\\(?:sin|cos|tan|log|det)) ([^\s{}]+(?:_\{\w+\})?)$"
        left = re.sub(bare, r"\1(\2)", left)
    return Piece(left + joint + right, SIGNED if left.startswith("-") else PRODUCT, is_open)


def _holds_quotient(node):
    """Whether a product has a quotient among its factors before the last."""
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, ast.Mult):
        return False
    node = node.left
    while isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
        node = node.left
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div)


def _width(tex):
    """Return about how many signs wide some LaTeX is."""
    silent = r"\\(frac|displaystyle|left|right|mathsf|mathrm|operatorname|quad)"
    return len(re.findall(r"\\[A-Za-z]+|[^\s{}^_\\&]", re.sub(silent, "", tex)))


def brackets(tex):
    """Put `tex` in brackets that are as high as it is."""
    tall = r"\\(frac|sum|prod|int|begin|binom|sqrt|lim|left\.)|\^\{.{9}"
    return rf"\left({tex}\right)" if re.search(tall, tex) else f"({tex})"
