"""How far the derivation checker can be trusted, measured on labelled steps.

    python tests/derivations/evaluate.py [--seeds 5] [--compare] [FILE.json ...]

Counts false proofs (a wrong step called proved or sampled), false accusations (a right step called
refuted) and undecided ones: on the labelled corpora, on mutants of every valid step, on rewrites of
every valid step, and on hostile text.
"""

import argparse
import ast
import json
import pathlib
import random
import re
import statistics
import sys
import time

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent.parent))

import sympy as sp  # noqa: E402

from amrmetrics.derivation import check_step, reading  # noqa: E402
from amrmetrics.derivation.checking import Step  # noqa: E402

CLAIM = re.compile(r"(Eq|Gt|Ge|Lt|Le|Or|And)\(|.*(==|<|>)")
CORPORA = ["public", "public_2", "own", "own_2", "own_3", "own_4"]


def load(name):
    path = pathlib.Path(name) if str(name).endswith(".json") else HERE / f"{name}.json"
    return json.loads(path.read_text(encoding="utf-8"))


def relation(step):
    return step.get("rel", step.get("relation", "iff"))


def check(step, seed=0, **changes):
    s = {**step, **changes}
    start = time.perf_counter()
    verdict = check_step(s["before"], s["after"], s["symbols"], relation(s), s.get("unknown"), seed)
    return verdict, time.perf_counter() - start


# --- mutants: one small mistake in the line after ----------------------------------------------


class _Mutation(ast.NodeTransformer):
    """Change the k-th place that `change` applies to."""

    def __init__(self, change, k):
        self.change, self.k, self.seen = change, k, -1

    def visit(self, node):
        node = super().generic_visit(node)
        new = self.change(node)
        if new is not None:
            self.seen += 1
            if self.seen == self.k:
                return new
        return node


def _sign(node):
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        op = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
        return ast.BinOp(node.left, op, node.right)
    if isinstance(node, ast.UnaryOp):
        return node.operand
    return None


def _denominator(node):
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
        return ast.BinOp(node.left, ast.Mult(), node.right)
    return None


def _one_more(node):
    if isinstance(node, ast.Constant) and type(node.value) is int:
        return ast.Constant(node.value + 1)
    return None


def _sine(node):
    other = {"sin": "cos", "cos": "sin"}
    if isinstance(node, ast.Name) and node.id in other:
        return ast.Name(other[node.id])
    return None


def _transposed(node):
    if isinstance(node, ast.Attribute) and node.attr == "T":
        return node.value
    return None


def _swapped(names):
    other = dict(zip(names, names[::-1], strict=True))

    def swap(node):
        if isinstance(node, ast.Expression):
            for x in ast.walk(node):
                if isinstance(x, ast.Name) and x.id in other:
                    x.id = other[x.id]
            return node
        return None

    return swap


def mutants(step):
    """(kind, text) pairs; some happen to be equivalent, see `equivalent`."""
    text = step["after"]
    names = {x.id for x in ast.walk(ast.parse(text)) if isinstance(x, ast.Name)}
    plain = sorted(n for n in names if step["symbols"].get(n) in ("real", ">0", "(0,1)", "nonzero"))
    kinds = {"sign": _sign, "denominator": _denominator, "+1": _one_more, "sin/cos": _sine}
    kinds["transposed"] = _transposed
    if len(plain) >= 2:
        kinds["swapped"] = _swapped(plain[:2])
    found = {}
    for kind, change in kinds.items():
        for k in range(3):
            tree = ast.parse(text, mode="eval")
            mutation = _Mutation(change, k)
            tree = mutation.visit(tree)
            if mutation.seen >= k:
                found.setdefault(ast.unparse(ast.fix_missing_locations(tree)), kind)
    if not CLAIM.match(text):
        found.setdefault(f"2*({text})", "factor")
    return [(kind, m) for m, kind in found.items()]


def equivalent(step, mutant):
    """Whether a mutant says the same as the line it came from, by plain floats alone."""
    try:
        one = Step(step["after"], mutant, step["symbols"], "iff", step.get("unknown"), 0)
    except ValueError:
        return False
    rng = random.Random(5)
    if not one.formulas:
        return None
    a, b = (one.model.evaluated(w) for w in (one.before, one.after))
    difference = list(a - b) if getattr(a, "is_Matrix", False) else [a - b]
    for _ in range(12):
        swap = {}
        for s in set().union(*(d.free_symbols for d in difference)):
            if isinstance(s, sp.Symbol):
                x = (
                    sp.Integer(rng.randint(2, 4))
                    if s.is_integer
                    else sp.Float(rng.uniform(0.1, 0.9))
                )
                swap[s] = x
        for d in difference:
            value = d.subs(swap).doit()
            value = value.replace(
                lambda x: isinstance(x, sp.Indexed), lambda x: sp.sin(hash(str(x)) % 97)
            )
            if value.is_number and abs(sp.N(value)) > 1e-9:
                return False
    return True


# --- rewrites: the same line, written differently ------------------------------------------------


def _reordered(node):
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return ast.BinOp(node.right, ast.Add(), node.left)
    return None


def rewrites(step):
    """(kind, line) pairs, text or SymPy objects."""
    text, symbols = step["after"], step["symbols"]
    tree = ast.parse(text, mode="eval")
    mutation = _Mutation(_reordered, 0)
    tree = mutation.visit(tree)
    found = [("reordered", ast.unparse(tree))] if mutation.seen >= 0 else []
    if CLAIM.match(text):
        return found
    one = Step(text, text, symbols, "iff", None, 0)
    value = one.model.evaluated(one.after)
    plain = {s: sp.Symbol(s.name) for s in value.free_symbols if type(s) is sp.Symbol}
    if any(n not in symbols for n in map(str, plain.values())):
        plain, value = {}, sp.Integer(0)  # explicit matrices have parameters that are not declared
    if value != 0:
        for change in (sp.expand, sp.factor, sp.together, sp.trigsimp):
            try:
                new = value.applyfunc(change) if value.is_Matrix else change(value)
            except (sp.PolynomialError, NotImplementedError, AttributeError):
                continue
            found.append((change.__name__, new.xreplace(plain)))
    angle = next((n for n, d in symbols.items() if d in ("angle", "real") and n in text), None)
    if angle:
        found.append(("identity", f"({text})*(sin({angle})**2+cos({angle})**2)"))
    if not reading.is_matrix(one.after) and "Sum" not in text and "Integral" not in text:
        found.append(("square", f"(({text})+1)**2-({text})**2-({text})-1"))
    return found


HOSTILE = [
    "__import__('os').system('echo hacked')",
    "open('x','w')",
    "x.__class__.__mro__",
    "(lambda: 1)()",
    "exec('1')",
    "eval('1')",
    "[x for x in (1,)]",
    "x if x else 1",
    "9**9**9",
    "9**9**9**9",
    "2**10**10",
    "x**(10**9)",
    "x**1000000",
    "(x+1)**5000",
    "((x+1)**100)**100",
    "(x+y+1)**110",
    "factorial(10**9)",
    "factorial(factorial(99))",
    "gamma(10**10)",
    "exp(exp(exp(exp(9))))",
    "exp(10**30)",
    "10**400",
    "1e999",
    "Sum(k,(k,1,10**9))",
    "Sum(Sum(k*j,(k,1,10**6)),(j,1,10**6))",
    "Sum(1/k,(k,1,oo))",
    "Product(k,(k,1,10**7))",
    "Integral(exp(x**2),(x,-oo,oo))",
    "Integral(1/z,(z,-1,1))",
    "Integral(Integral(Integral(sin(x*y*z),(x,0,1)),(y,0,1)),(z,0,1))",
    "Derivative(x**x**x,x,x,x,x,x,x)",
    "Derivative(x,(x,10**9))",
    "Matrix([[x]*9])",
    "Matrix([])",
    "Matrix([[1,2],[3]])",
    "x+" * 3000 + "x",
    "(" * 300 + "x" + ")" * 300,
    "-" * 3900 + "x",
    "sin(" * 150 + "x" + ")" * 150,
    "x" * 10000,
    "x;y",
    "x\ny",
    "x=1",
    "x==1",
    "1<x<2",
    "x:=2",
    "f'{x}'",
    "'x'",
    "b'x'",
    "x[0]",
    "x.T",
    "x()",
    "sin",
    "sin()",
    "sin(x,y)",
    "sin(x=1)",
    "sin(*x)",
    "Eq(x)",
    "Eq(Eq(x,y),x)",
    "Sum(x)",
    "Sum(x,(x,1))",
    "Sum(x,(1,1,2))",
    "Integral(x,x)",
    "Subs(x,1,2)",
    "x\x00y",
    "",
    " ",
    "\ufeffx",
    "x²",
    "𝑥+y",
    "1/0",
    "0**-1",
    "log(0)",
    "oo-oo",
    "oo/oo",
    "x/0",
    "nan",
    "zoo",
    "I*x",
    "1j*x",
    "lambda*x",
    "2x",
    "x^2",
    "True",
    "None",
    "...",
    "Max()",
    "atan2(x)",
    "eye(10**9)",
    "eye(-1)",
    "det(x)",
    "Trace(x)",
    "P.inv",
    "x*(y",
    "x**y**x**y**x**y",
    "x**(y**(x**(y**99)))",
    "(x**99)**99",
    "Subs(Subs(x,x,y**99),y,x**99)",
    "abs(x)" * 3,
    "exp(x)**(10**8)",
    "sqrt(" * 55 + "x" + ")" * 55,
    "Mod(x,0)",
    "binomial(10**9,10**8)",
    "KroneckerDelta(x,y)",
    "floor(10**50*x)",
]
RIGHT = "x+y"


# --- the table ---------------------------------------------------------------------------------


class Tally:
    """Counts for one row of the table."""

    def __init__(self, name):
        self.name, self.times, self.bad = name, [], []
        self.count = dict.fromkeys(["false proof", "false accusation", "undecided", "sampled"], 0)

    def add(self, valid, verdict, seconds, label):
        self.times.append(seconds)
        status, wrong = verdict.status, None
        if valid is False and status in ("proved", "sampled"):
            wrong = "false proof"
        elif valid and status == "refuted":
            wrong = "false accusation"
        elif valid is not None and status in ("undecided", "unreadable"):
            wrong = "undecided"
        elif valid and status == "sampled":
            self.count["sampled"] += 1
        if wrong:
            self.count[wrong] += 1
            self.bad.append(f"{wrong}: {label}: {verdict}")

    def row(self):
        n, c = len(self.times), self.count
        return (
            f"{self.name:<24}{n:>6}{c['false proof']:>13}{c['false accusation']:>18}"
            f"{c['undecided']:>11}"
            f"{c['sampled']:>9}{statistics.median(self.times):>9.3f}{max(self.times):>9.2f}"
        )


HEADER = (
    f"{'steps':<24}{'n':>6}{'false proofs':>13}{'false accusations':>18}{'undecided':>11}"
    f"{'sampled':>9}{'median s':>9}{'max s':>9}"
)


def labelled(name, seeds):
    tally = Tally(pathlib.Path(name).stem)
    for seed in seeds:
        for s in load(name):
            tally.add(s["valid"], *check(s, seed), f"{s['id']} seed {seed}")
    return tally


def mutated(names, seeds):
    tally = Tally("mutants")
    for s in (s for name in names for s in load(name) if s["valid"]):
        for kind, text in mutants(s):
            for seed in seeds:
                verdict, seconds = check(s, seed, after=text)
                if verdict.status == "unreadable":
                    break  # a dropped transpose that no longer fits: caught while reading
                valid = False
                if verdict.status in ("proved", "sampled") and equivalent(s, text) is not False:
                    valid = None  # it happens to say the same, or there is no independent answer
                tally.add(valid, verdict, seconds, f"{s['id']} {kind}: {text} seed {seed}")
    return tally


def rewritten(names, seeds):
    tally = Tally("rewrites")
    for s in (s for name in names for s in load(name) if s["valid"]):
        for kind, line in rewrites(s):
            for seed in seeds:
                tally.add(
                    True, *check(s, seed, after=line), f"{s['id']} {kind}: {line} seed {seed}"
                )
    return tally


def objects(names, seeds):
    """The labelled steps again as SymPy objects: as written, and as SymPy itself builds them."""
    tally = Tally("as SymPy objects")
    for s in (s for name in names for s in load(name)):
        kinds = s["symbols"]
        one = Step(s["before"], s["after"], kinds, relation(s), s.get("unknown"), 0)
        forms = {n: d.kind for n, d in one.domains.items()}
        lines = [None if not s[k] else reading.read(s[k], forms) for k in ("before", "after")]
        built = None if lines[0] is None or not one.formulas else one.model.evaluated(lines[1])
        names = set() if built is None else {v.name for v in built.free_symbols if v.is_Symbol}
        for seed in seeds:
            pair = dict(zip(("before", "after"), lines, strict=True))
            tally.add(s["valid"], *check(s, seed, **pair), f"{s['id']} seed {seed}")
            if built is not None and names <= set(kinds):
                pair["after"] = built
                tally.add(s["valid"], *check(s, seed, **pair), f"{s['id']} {built} seed {seed}")
    return tally


def hostile(pairs=3):
    tally = Tally("hostile text")
    symbols = {"x": "real", "y": "real", "z": "real", "P": "spd2"}
    for text in HOSTILE:
        for pair in ((RIGHT, text), (text, RIGHT), (text, text))[:pairs]:
            verdict, seconds = check({"before": pair[0], "after": pair[1], "symbols": symbols})
            tally.add(None, verdict, seconds, text[:40])
    return tally


# --- the alternatives --------------------------------------------------------------------------


def alternatives(names):
    """What simpler checkers make of the labelled formulas (equations and claims left out)."""

    def simplify(d):
        return sp.simplify(d) == 0

    def equals(d):
        return d.equals(0) is True

    def five_points(d):
        rng = random.Random(1)
        for _ in range(5):
            swap = {
                s: sp.Float(rng.uniform(0, 1))
                if not s.is_integer
                else sp.Integer(rng.randint(1, 5))
                for s in d.free_symbols
            }
            v = sp.N(d.subs(swap).doit())
            if not v.is_number or v.has(sp.nan, sp.zoo) or abs(v) > 1e-6:
                return False
        return True

    from amrmetrics.derivation.limits import bounded

    rows = {
        "simplify(a - b) == 0": simplify,
        "(a - b).equals(0)": equals,
        "five points in [0, 1]": five_points,
    }
    lines = [
        f"{'checker':<26}{'wrong accepted':>16}{'right rejected':>16}{'no answer':>12}"
        f"{'seconds':>10}"
    ]
    steps = [s for name in names for s in load(name)]
    formulas = []
    for s in steps:
        one = Step(s["before"], s["after"], s["symbols"], relation(s), None, 0)
        if one.formulas:
            formulas.append((s, one))
    for name, checker in rows.items():
        accepted = rejected = silent = 0
        start = time.perf_counter()
        for s, one in formulas:

            def answer(one=one, checker=checker):
                a, b = (one.model.evaluated(w).doit() for w in (one.before, one.after))
                difference = list(a - b) if getattr(a, "is_Matrix", False) else [a - b]
                return all(checker(sp.sympify(d)) for d in difference)

            try:
                finished, right = bounded(answer, 10)
            except Exception:
                finished, right = False, False
            silent += not finished
            accepted += finished and right and not s["valid"]
            rejected += finished and not right and s["valid"]
        seconds = time.perf_counter() - start
        lines.append(f"{name:<26}{accepted:>16}{rejected:>16}{silent:>12}{seconds:>10.0f}")
    start = time.perf_counter()
    verdicts = [(s, check(s)[0].status) for s, _ in formulas]
    accepted = sum(v in ("proved", "sampled") and not s["valid"] for s, v in verdicts)
    rejected = sum(v == "refuted" and s["valid"] for s, v in verdicts)
    silent = sum(v == "undecided" for _, v in verdicts)
    seconds = time.perf_counter() - start
    lines.append(f"{'check_step':<26}{accepted:>16}{rejected:>16}{silent:>12}{seconds:>10.0f}")
    right = sum(s["valid"] for s, _ in formulas)
    return [f"{len(formulas)} formulas, {right} right and {len(formulas) - right} wrong", *lines]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--compare", action="store_true", help="also run the alternatives")
    parser.add_argument("corpora", nargs="*", default=CORPORA)
    options = parser.parse_args()
    seeds = range(options.seeds)
    print(HEADER)
    tallies = []
    for make in (
        *[lambda name=name: labelled(name, seeds) for name in options.corpora],
        lambda: mutated(options.corpora, seeds),
        lambda: rewritten(options.corpora, seeds),
        lambda: objects(options.corpora, seeds),
        hostile,
    ):
        tallies.append(make())
        print(tallies[-1].row(), flush=True)
    for t in tallies:
        for line in t.bad:
            print("-", line)
    if options.compare:
        print("\n".join(alternatives(options.corpora)))


if __name__ == "__main__":
    main()
