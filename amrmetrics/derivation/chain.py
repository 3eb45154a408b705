"""Chains of checked lines: what `derive` shows, and a derivation from a given line to a goal."""

import html
import re
from collections import Counter
from dataclasses import dataclass, field

import sympy as sp

from .checking import MARKS, Verdict, check_step
from .domains import make
from .forms import form, key, normal, operators, solved_for
from .reading import Unreadable, is_claim, is_matrix, read, rebuild
from .typesetting import plain, typeset

# The signs between two lines: as they are written, as they are typed, and in LaTeX.
SIGNS = {"equal": "=", "iff": "⇔", "implies": "⇒", "implied_by": "⇐"}
SIGNS |= {"<": "<", "<=": "≤", ">": ">", ">=": "≥"}
TYPED = {sign: relation for relation, sign in SIGNS.items()} | {"<=>": "iff", "=>": "implies"}
TYPED |= {"<=": "<=", ">=": ">="}
TEX = {"⇔": r"\Leftrightarrow", "⇒": r"\Rightarrow", "⇐": r"\Leftarrow", "≤": r"\le", "≥": r"\ge"}
SIGN = re.compile(r"<=>|=>|<=|>=|[⇔⇒⇐≤≥<>]|=(?!=)")
NAME = r"[A-Z]\w*\d\w*"  # of a result: D7
ORDER = {"<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge}
GOOD = ("proved", "sampled", "by lemma", "by hand", "cited")


def written_lines(text):
    """Return the name of a chain and its lines, each as (sign, line, reason)."""
    name, lines = "", []
    for row in text.splitlines():
        line, _, reason = (part.strip() for part in row.partition("#"))
        if not lines and (m := re.match(rf"({NAME}):(?!=)", line)):
            name, line = m[1], line[m.end() :].strip()
        inside = lines and len(re.findall(r"[(\[]", lines[-1][1])) > len(
            re.findall(r"[)\]]", lines[-1][1])
        )
        m = None if inside else SIGN.match(line)
        if line and (m or not lines):
            lines.append([m[0] if m else "", line[m.end() if m else 0 :].strip(), ""])
        elif line:
            lines[-1][1] += " " + line
        if reason and lines:
            lines[-1][2] = f"{lines[-1][2]} {reason}".strip()
    return name, [tuple(x) for x in lines]


def entered_lines(lines):
    """Return lines as a student enters them, each as (sign, line, reason).

    One text in the written form, or a list of lines, each a text, a SymPy object or a pair of
    line and reason; signs and reasons may be left out.
    """
    if isinstance(lines, str):
        rows = [row for row in lines.splitlines() if row.strip()]
        if any(SIGN.match(row.strip()) for row in rows):
            return written_lines(lines)[1]
        lines = rows  # no signs: then a row is a line
    out = []
    for line in lines:
        line, reason = line if isinstance(line, tuple | list) else (line, "")
        split = written_lines(line)[1] if isinstance(line, str) else []
        out += [(sign, x, why or reason) for sign, x, why in split] or [("", line, reason)]
    return out


@dataclass(frozen=True)
class Line:
    """A line as it was written, what it means to the checker, and how it is set."""

    text: str
    meaning: object = field(default=None, repr=False)
    latex: str | None = field(default=None, repr=False)

    def html(self):
        """Return the line as mathematics, or as text if it is none."""
        if self.latex is None:
            return f"<code>{html.escape(self.text)}</code>"
        return f"$\\displaystyle {html.escape(self.latex, quote=False)}$"


@dataclass(frozen=True)
class Step:
    """One line of a chain: what was written, why, and what is known about it."""

    number: int
    line: Line
    verdict: Verdict
    because: str = ""
    relation: str = ""
    how: str = ""  # "by lemma", "by hand" or "cited", where the checker alone does not speak
    assumed: str = ""  # the lemma that the step takes for granted
    notes: tuple = ()

    @property
    def status(self):
        """How the step is known: proved, sampled, by lemma, by hand, cited; or what is wrong."""
        return self.how or self.verdict.status

    @property
    def text(self):
        """The line as it was written."""
        return self.line.text

    @property
    def latex(self):
        """The LaTeX of the line, None if it has none."""
        return self.line.latex

    @property
    def written(self):
        """The line as a SymPy object, None if it cannot be read."""
        return self.line.meaning

    @property
    def reason(self):
        """The reason and what is known about the step, in words; conditions in backticks."""
        if self.status in ("by hand", "cited"):
            return f"{self.status}: {self.because}"
        marks = {"proved": "✓", "by lemma": "✓", "sampled": "≈ sampled, not proved"}
        words = marks.get(self.status, "")
        if words:
            words += f", assumed: {self.assumed}" if self.assumed else ""
            needs = " and ".join(f"`{c}`" for c in self.verdict.conditions)
            words += f", if {needs}" if needs else ""
        return "  ".join(x for x in (self.because, words) if x)

    @property
    def remarks(self):
        """What is said below the line: why it is wrong, and what is odd about it."""
        known = self.status in GOOD
        wrong = [] if known else [f"{MARKS[self.verdict.status]} {self.verdict.message}"]
        return [*wrong, *self.notes]

    @property
    def sign(self):
        """The sign before the line."""
        return SIGNS.get(self.relation, "")

    def __repr__(self):
        return "\n".join(_text([self]))

    def _repr_html_(self):
        return _html([self])


class Chain:
    """A chain of lines, each checked against the one before.

    Attributes
    ----------
    name : str
        What later chains call the result.
    given : Line or None
        The first line, if it is not itself a claim that is checked.
    steps : list of Step
        The lines that were checked.
    """

    def __init__(self, domains=None, name="", seed=0):
        self._expand = getattr(domains, "expand", lambda line: line)
        domains = getattr(domains, "domains", domains) or {}
        self.domains = {str(n): str(t) for n, t in domains.items()}
        self.kinds = {n: make(n, t, self.domains).kind for n, t in self.domains.items()}
        self.name, self.seed = name, seed
        self.given, self.steps = None, []

    def line(self, line):
        """Read a line, a text or a SymPy object."""
        return self._shown(line, read(self._expand(line), self.kinds))

    def _shown(self, line, meaning=None):
        if isinstance(line, str):
            return Line(plain(line), meaning, typeset(line, self.domains))
        latex = sp.latex(line, order="none") if isinstance(line, sp.Basic) else None
        return Line(str(line), meaning, latex)

    def add(self, line, because="", relation=None, unknown=None, lemmas=(), how=""):
        """Check a line against the line before, and keep it with what is known about it.

        `lemmas` are those that the step may use; `how` is "", "by hand" or "cited".
        """
        shown, before, notes, assumed = self._shown(line), self.last, [], ""
        try:
            shown = self.line(line)
            relation = self._relation(relation, before, shown.meaning)
            verdict = None
            if lemmas and before is not None:
                verdict = proved_by(lemmas, before, shown.meaning, relation, self)
                assumed = lemmas[0].name if lemmas[0].assumed else ""
                if verdict is not None and not assumed:
                    how = how or "by lemma"
                elif verdict is None and assumed:
                    notes.append(f"The lemma {assumed} is not used in this step")
            if verdict is None:
                verdict = self.verdict(before, shown.meaning, relation, unknown)
            if before is not None and self._idle(shown, before):
                notes.append("This line is the same as the line before: the step changes nothing")
        except Unreadable as error:
            verdict = Verdict("unreadable", f"unreadable: {error}")
        how = "" if verdict.status in ("refuted", "unreadable") else how
        step = Step(self._next, shown, verdict, because, relation, how, assumed, tuple(notes))
        self.steps.append(step)
        return step

    @property
    def _next(self):
        return len(self.steps) + 1

    def _idle(self, line, _before):
        return line.text == self.lines[-1]

    def _relation(self, relation, before, written):
        """Return the relation that is meant, and refuse one that does not fit the lines."""
        if before is None:
            return ""
        if is_claim(written) != is_claim(before):
            raise Unreadable(
                "one line is a formula and the other an equation: compare like with like"
            )
        if is_claim(written):
            relation = {"<=": "implied_by", None: "iff"}.get(relation, relation)
            fits, instead = ("iff", "implies", "implied_by"), "two claims: write <=>, => or <="
        else:
            relation = relation or "equal"
            fits, instead = ("equal", *ORDER), "two formulas: write =, <, >, <= or >="
        if relation not in fits:
            raise Unreadable(f"{SIGNS.get(relation, relation)} stands between {instead} there")
        return relation

    def verdict(self, before, after, relation, unknown=None):
        """Return what the checker says about a step."""
        domains = self.used(before, after) if unknown is None else self.domains
        if relation in ORDER:
            after = ORDER[relation](number(before), number(after), evaluate=False)
            before = None
        relation = "iff" if relation in ("equal", "", *ORDER) else relation
        return check_step(before, after, domains, relation, unknown, self.seed)

    def used(self, *lines):
        """Return the domains of the names in `lines`: no other name can make a difference."""
        nodes = [x for w in lines if w is not None for x in sp.preorder_traversal(w)]
        new = {str(getattr(x, "name", getattr(x, "func", ""))) for x in nodes} & {*self.domains}
        names = set()
        while new:
            names |= new
            ends = {n for x in new for n in re.findall(r"\w+", self.domains[x])}
            new = ends & {*self.domains} - names
        return {n: t for n, t in self.domains.items() if n in names}

    @property
    def read_lines(self):
        """The lines that could be read, as SymPy objects."""
        lines = [self.given] * (self.given is not None) + [s.line for s in self.steps]
        return [x.meaning for x in lines if x.meaning is not None]

    @property
    def last(self):
        """The last line that could be read, as a SymPy object."""
        return next(iter(self.read_lines[::-1]), None)

    @property
    def start(self):
        """The first line: the given one, or the claim that stands alone."""
        return self.given or self.steps[0].line

    @property
    def lines(self):
        """All lines as they were written, the given one first."""
        return [self.given.text] * (self.given is not None) + [s.text for s in self.steps]

    @property
    def verdicts(self):
        """What the checker says, a verdict for each step."""
        return [s.verdict for s in self.steps]

    @property
    def status(self):
        """How each step is known."""
        return tuple(s.status for s in self.steps)

    @property
    def counts(self):
        """How many steps are known in which way."""
        return dict(Counter(self.status))

    @property
    def conditions(self):
        """What the steps need, such as ``x != 0``."""
        return tuple(dict.fromkeys(c for v in self.verdicts for c in v.conditions))

    @property
    def relation(self):
        """What holds between the first and the last line; None if nothing follows."""
        return composed([s.relation for s in self.steps])

    @property
    def complete(self):
        """Whether every step is known to be right, and something follows from the chain."""
        return all(s in GOOD for s in self.status) and self.relation is not None

    def _closing(self):
        """Return what follows from a chain that is more than equations: a text or lines."""
        if {s.relation for s in self.steps} <= {"", "equal", "iff"} or len(self.steps) < 2:
            return ""
        if self.relation in ORDER:
            return self.start, SIGNS[self.relation], self.steps[-1].line
        ends = {"implies": ("first", "last"), "implied_by": ("last", "first")}.get(self.relation)
        if ends is None:
            return "The signs point both ways: nothing follows from the first line to the last."
        return "Together: the {} line implies the {}.".format(*ends)

    def __repr__(self):
        return "\n".join(_text(self.steps, self.given, self.name, self._closing()))

    def _repr_html_(self):
        return _html(self.steps, self.given, self.name, self._closing())


def composed(relations):
    """Return what a chain of relations composes to, or None if nothing follows from it."""
    kinds = {r for r in relations if r not in ("", "equal", "iff")}
    if not kinds:
        return "iff" if "iff" in relations else "equal"
    for strict, loose in (("<", "<="), (">", ">=")):
        if kinds <= {strict, loose}:
            return strict if strict in kinds else loose
    return kinds.pop() if len(kinds) == 1 else None


def follows(relation, asked):
    """Whether `relation` between two lines says at least what is `asked`."""
    claims = ("iff", "implies", "implied_by")
    weaker = {"equal": ("<=", ">=", *claims), "<": ("<=",), ">": (">=",), "iff": claims}
    return relation == asked or asked in weaker.get(relation, ())


# --- showing --------------------------------------------------------------------------------------


def _text(steps, given=None, name="", closing=""):
    """Return the lines of a chain in plain text: a line a step, and what is said below it."""
    rows = [(given.text, "", [])] if given else []
    rows += [(f"{s.sign} {s.text}".strip(), s.reason.replace("`", ""), s.remarks) for s in steps]
    short = [formula for formula, why, _ in rows if why and len(formula) <= 60]
    wide = max(map(len, short), default=0)
    lead, out = f"{name}: " if name else "", []
    for formula, why, remarks in rows:
        out.append(lead + (f"{formula.ljust(wide)}  {why}" if why else formula))
        lead = " " * len(lead)
        out += [f"{lead}    {r}" for r in remarks]
    if isinstance(closing, tuple):
        closing = f"Together: {closing[0].text} {closing[1]} {closing[2].text}"
    return [*out, lead + closing] if closing else out


# JupyterLab sets tables centered, striped and with cells to the right: the block is none of that.
TABLE = 'style="width:100%; max-width:1000px; margin:0; table-layout:auto"'
ROW = 'style="background:none"'
CELL = 'style="text-align:left; vertical-align:baseline; padding:3px 6px"'
BEFORE = 'style="text-align:right; vertical-align:baseline; padding:3px 0 3px 18px; width:30px"'
# The reason stands beside the formula, or below it in the same column if both are too wide.
BOTH = 'style="display:flex; flex-wrap:wrap; align-items:baseline"'
FORMULA = 'style="flex:0 1 auto; max-width:100%; overflow-x:auto; overflow-y:hidden"'
REASON = 'style="flex:0 1 300px; margin-left:auto; padding-left:16px"'


def _html(steps, given=None, name="", closing=""):
    """Return a chain as HTML: sign, formula, and the reason with what is known."""
    title = f"<strong>{html.escape(name)}</strong>&ensp;" if name else ""
    rows = [("", title + given.html())] if given else []
    for s in steps:
        formula = ("" if rows else title) + s.line.html()
        why = prose(s.reason).replace("  ", "&nbsp;&nbsp;")  # no mark alone in a row
        cell = f"<div {FORMULA}>{formula}</div><div {REASON}>{why}</div>"
        remarks = "".join(f"<div>{html.escape(r, quote=False)}</div>" for r in s.remarks)
        rows.append((s.sign, f"<div {BOTH}>{cell}</div>{remarks}"))
    if isinstance(closing, tuple):
        first, sign, last = closing
        closing = f"Together: {first.html()} ${html.escape(TEX.get(sign, sign))}$ {last.html()}"
    rows += [("", closing)] if closing else []
    out = ""
    for sign, cell in rows:
        sign = html.escape(TEX.get(sign, sign))
        lead = f"<td {BEFORE}>${sign}$</td><td" if sign else '<td colspan="2"'
        out += f"<tr {ROW}>{lead} {CELL}>{cell}</td></tr>"
    return f"<table {TABLE}>{out}</table>"


def prose(text):
    """Return a text as HTML; what stands in `backticks` is a formula."""
    parts = text.split("`")
    for k, part in enumerate(parts):
        tex = typeset(part) if k % 2 else None
        parts[k] = html.escape(part if tex is None else f"${tex}$", quote=False)
    return "".join(parts)


# --- lemmas ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Lemma:
    """A result that a step may use: what holds between two formulas, or between two claims."""

    name: str
    relation: str
    first: object
    last: object
    sure: bool = True  # whether every step of it is proved
    conditions: tuple = ()
    assumed: bool = False  # taken for granted, not derived

    def is_step(self, before, after, relation, chain):
        """Whether the step is this lemma: the same claims, or formulas that differ by as much."""
        turned = {"implies": "implied_by", "implied_by": "implies"}
        if is_claim(self.first):
            ends, step = [form(self.first), form(self.last)], [form(before), form(after)]
            back = turned.get(self.relation, self.relation)
            forth = ends == step and follows(self.relation, relation)
            return forth or (ends[::-1] == step and follows(back, relation))
        if self.relation not in ORDER or not follows(self.relation, relation):
            return False
        ends = (before, after, self.first, self.last)
        gaps = [sp.Add(number(b), -number(a), evaluate=False) for a, b in (ends[:2], ends[2:])]
        return chain.verdict(*gaps, "equal").status == "proved"


def proved_by(lemmas, before, after, relation, chain):
    """Return a verdict if the step follows from the lemmas, else None."""
    needs = {c: None for x in lemmas for c in x.conditions}
    if len(lemmas) == 1 and lemmas[0].is_step(before, after, relation, chain):
        return Verdict("proved", "proved", conditions=tuple(needs))
    pair = [before, after]
    for lemma in lemmas:
        if lemma.relation == "equal":
            pair = [exchanged(w, lemma.first, lemma.last) for w in pair]
    keys = [key(w) for w in pair]
    if keys == [key(before), key(after)]:
        return None
    if keys[0] != keys[1] or relation in ORDER:
        verdict = chain.verdict(*pair, relation)
        if verdict.status != "proved":
            return verdict if lemmas[0].assumed else None
        needs |= dict.fromkeys(verdict.conditions)
    doubtful = not all(x.sure or x.assumed for x in lemmas)
    if doubtful and chain.verdict(before, after, relation).status == "refuted":
        return None
    return Verdict("proved", "proved", conditions=tuple(needs))


def exchanged(w, left, right):
    """`w` with `left` replaced by `right`, except where a letter of `left` is a bound one."""
    parts, letters = [form(a) for a in left.args], left.free_symbols
    wanted = form(left)

    def leaf(x):
        if isinstance(x, sp.Sum | sp.Product | sp.Integral | sp.Subs | sp.Limit):
            bound = {*getattr(x, "variables", x.args[1:2])}
            if bound & letters:
                return x
        if type(x) is not type(left):
            return None
        if form(x) == wanted:
            return right
        return part(x) if isinstance(x, sp.Add | sp.Mul | sp.MatMul) else None

    def part(x):
        """`x` with some of its terms or factors exchanged, or None if `left` is not in it."""
        n, there, rest = len(parts), [form(a) for a in x.args], list(x.args)
        if isinstance(x, sp.MatMul):  # the factors in their order, side by side
            k = next((k for k in range(len(there)) if there[k : k + n] == parts), None)
            if k is None:
                return None
            rest[k : k + n] = right.args if isinstance(right, sp.MatMul) else [right]
        else:
            for p in parts:
                if p not in there:
                    return None
                del rest[there.index(p)], there[there.index(p)]
            rest.append(right)
        return x.func(*rest, evaluate=False)

    return rebuild(w, leaf)


def number(w):
    """Return the entry of a 1 x 1 matrix, and everything else as it is."""
    return w[0, 0] if is_matrix(w) and tuple(w.shape) == (1, 1) else w


# --- from a given line to a goal ------------------------------------------------------------------


class Derivation(Chain):
    """A chain of lines that has to end at a goal.

    Parameters
    ----------
    goal : str or SymPy object
        The last line has to be this, up to the order of terms and the names of bound indices. If
        the goal is an equation with a symbol alone on one side, and the chain does not start from
        such a one, the other side may have any form without further sums, integrals, derivatives.
    given : str or SymPy object, optional
        The line the chain starts from. Without it the first line is the start; if that is an
        equation or inequality, it has to hold on the whole domain.
    domains : dict of str to str, or what `declare` returns
        As for `check_step`.
    must_pass : sequence, or dict of description to form
        Forms that some line of the chain has to have.
    lemmas : dict of str to str or SymPy equation
        Named equations that a step may use; they are assumed, not checked.
    seed : int
        Seed of the random points.
    relation : str
        What has to hold between the first line and the last: ``equal``, ``<``, ``<=``, ``>``,
        ``>=`` between formulas, ``iff``, ``implies``, ``implied_by`` between claims. By default
        an equation between formulas, and that the last claim follows from the first.

    Examples
    --------
    >>> D = Derivation("y", given="x*y/x", domains={"x": "nonzero", "y": "real"})
    >>> D.step("y", because="cancel x")
    = y  cancel x  ✓
    >>> D.complete
    True
    """

    def __init__(
        self, goal, given=None, domains=None, must_pass=(), lemmas=None, seed=0, relation=None
    ):
        super().__init__(domains, seed=seed)
        self.goal = self._task("goal", goal).meaning
        self.given = None if given is None else self._task("given line", given)
        self.asked = relation or ("implies" if is_claim(self.goal) else "equal")
        self._own_start = False  # whether the first line that was entered is the start
        forms = must_pass.items() if isinstance(must_pass, dict) else enumerate(must_pass, 1)
        forms = {f"required form {k}": form for k, form in forms}
        self.must_pass = {what: self._task(what, form).meaning for what, form in forms.items()}
        self.lemmas = {
            str(n): self._task(f"lemma {n}", e).meaning for n, e in (lemmas or {}).items()
        }
        for n, e in self.lemmas.items():
            if not isinstance(e, sp.Eq):
                raise ValueError(f"lemma {n} must be an equation Eq(left, right)")

    def _task(self, what, line):
        try:
            return self.line(line)
        except Unreadable as error:
            raise ValueError(f"the {what} cannot be read: {error}") from None

    def step(self, line, because="", relation="iff", unknown=None, lemma=None):
        """Add a line, check it against the line before, and return it with its verdict."""
        if lemma is not None and lemma not in self.lemmas:
            known = ", ".join(self.lemmas) or "none"
            text = f"the lemma {lemma!r} is not declared (declared: {known})"
            verdict = Verdict("unreadable", text)
            self.steps.append(Step(self._next, self._shown(line), verdict, because))
            return self.steps[-1]
        start = self._read(line) if self.given is None and not self.steps else None
        if start is not None and not is_claim(start.meaning):
            self.given, self._own_start = start, True
            return Step(1, start, Verdict("proved"), because)
        lemmas = []
        if lemma is not None:
            lemmas = [Lemma(lemma, "equal", *self.lemmas[lemma].args, assumed=True)]
        relation = None if relation == "iff" else relation  # it stands for = between formulas
        return self.add(line, because, relation, unknown, lemmas)

    def _read(self, line):
        try:
            return self.line(line)
        except Unreadable:
            return None

    @property
    def _next(self):
        return len(self.steps) + 1 + self._own_start

    def _idle(self, line, before):
        return key(line.meaning) == key(before)

    def check(self, lines):
        """Add several lines: one text in the written form, or a list of lines.

        A line of a list is a text, a SymPy object, or a tuple of that and a reason; signs before
        the lines may be left out. A first line that repeats the given one is skipped.
        """
        for k, (sign, line, because) in enumerate(entered_lines(lines)):
            if k == 0 and not self.steps and self.given is not None:
                first = self._read(line)
                if first is not None and key(first.meaning) == key(self.given.meaning):
                    continue
            self.step(line, because, TYPED.get(sign, "iff"))
        return self

    @property
    def reached(self):
        """Whether the last line is the goal, or an equation solved as the goal is."""
        last = self.last
        return last is not None and (form(last) == form(self.goal) or self._solved(last))

    def _solved(self, last):
        """Whether the chain solves for the goal's unknown, and `last` says what the goal says."""
        x = solved_for(self.goal)
        if x is None or solved_for(last) != x or solved_for(self.read_lines[0]) == x:
            return False
        if not operators(last) <= operators(self.goal):
            return False
        return self.verdict(last, self.goal, "iff").status in ("proved", "sampled")

    @property
    def moves(self):
        """How many lines are new: not the given, the goal or a line before in other words."""
        lines = self.read_lines
        start = {normal(self.given.meaning)} if self.given is not None else set()
        if not self.reached:
            return len({normal(w) for w in lines} - start)
        end = {normal(self.goal), normal(lines[-1])}
        between = {normal(w) for w in lines[:-1]} - start - end
        return len(between) + (not start or key(lines[-1]) != key(self.given.meaning))

    @property
    def problems(self):
        """What is missing or wrong, in words; empty if the derivation is complete."""
        if not self.steps:
            return ["there are no lines yet"]
        out = []
        for s in self.steps:
            said = [] if s.status in GOOD else [s.verdict.message]
            out += [f"line {s.number}: {words}" for words in (*said, *s.notes)]
        if not out and not follows(self.relation, self.asked):
            signs = SIGNS.get(self.relation, "nothing")
            out.append(
                f"between the first and the last line the task asks {SIGNS[self.asked]}; what "
                f"the signs of your lines compose to is {signs}"
            )
        passed = [form(w) for w in self.read_lines]
        for name, w in self.must_pass.items():
            if form(w) not in passed:
                out.append(f"the chain leaps over a step: {name} is not among the lines")
        return out if self.reached else [*out, self._short_of_goal()]

    def _short_of_goal(self):
        last = self.last
        if last is None:
            return "no line can be read"
        if is_claim(last) != is_claim(self.goal):
            return "the goal is not reached: of it and the last line, one is an equation, one not"
        if self.verdict(last, self.goal, "iff").status == "refuted":
            return "the goal is not reached: the last line says something else"
        return (
            "the goal is not reached: the last line agrees with it, but does not have its form yet"
        )

    @property
    def complete(self):
        """Every line right, every required form passed, the goal reached."""
        return not self.problems

    def text(self):
        """The chain in plain text, and what is missing."""
        return "\n".join([super().__repr__(), *(f"- {p}" for p in self._missing())])

    __str__ = __repr__ = text

    def _missing(self):
        """Return the problems that do not stand below their line already."""
        return [p for p in self.problems if not p.startswith("line ")]

    def _repr_html_(self):
        items = "".join(f"<li>{html.escape(p, quote=False)}</li>" for p in self._missing())
        return super()._repr_html_() + (f"<ul>{items}</ul>" if items else "")
