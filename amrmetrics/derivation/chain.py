"""A derivation as a chain of checked lines, from the given line to the goal."""

import html
import re
from dataclasses import dataclass, field

import sympy as sp

from .checking import MARKS, Verdict, check_step
from .domains import Domain
from .reading import Unreadable, is_claim, is_matrix, read, tidy
from .refuting import rebuild

START = "the start of the chain"  # a formula that nothing stands before: there is no step to check
SIGNS = {
    "iff": ("⇔", r"\Leftrightarrow"),
    "implies": ("⇒", r"\Rightarrow"),
    "implied_by": ("⇐", r"\Leftarrow"),
}


@dataclass(frozen=True)
class Step:
    """One line of a chain: what was written, why, and the verdict on it."""

    number: int
    text: str
    verdict: Verdict
    because: str = ""
    relation: str = ""
    lemma: str | None = None
    notes: tuple = ()
    written: object = field(default=None, repr=False)
    latex: str = field(default="", repr=False)

    @property
    def status(self):
        return self.verdict.status

    def result(self):
        """The verdict in words, with what was assumed and what is odd about the step."""
        if self.verdict.message == START:
            return START
        words = f"{MARKS[self.status]} {self.verdict.message}"
        if self.lemma and self.status in ("proved", "sampled"):
            words += f"; assumed: {self.lemma}"
        return ". ".join([words, *self.notes])

    def __repr__(self):
        sign = SIGNS[self.relation][0] + " " if self.relation in SIGNS else self.relation and "= "
        reason = f"\n    because {self.because}" if self.because else ""
        return f"({self.number}) {sign}{self.text}\n    {self.result()}{reason}"

    def _repr_html_(self):
        return f"<table>{self.row()}</table>"

    def row(self):
        sign = SIGNS[self.relation][1] if self.relation in SIGNS else "=" if self.relation else ""
        left = 'style="text-align:left"'
        formula = (
            f"${sign}\\; \\displaystyle {self.latex}$"
            if self.latex
            else f"<code>{html.escape(self.text)}</code>"
        )
        reason = f"<br><em>{html.escape(self.because)}</em>" if self.because else ""
        cells = f"<td {left}>{formula}</td><td {left}>{html.escape(self.result())}{reason}</td>"
        return f"<tr><td>({self.number})</td>{cells}</tr>"


class Derivation:
    """A chain of lines, each checked against the one before.

    Parameters
    ----------
    goal : str or SymPy object
        The last line has to be this, up to the order of terms and the names of bound indices. If
        the goal is an equation with a symbol alone on one side, and the chain does not start from
        such a one, the other side may have any form without further sums, integrals, derivatives.
    given : str or SymPy object, optional
        The line the chain starts from. Without it the first line is the start; if that is an
        equation or inequality, it has to hold on the whole domain.
    domains : dict of str to str
        As for `check_step`.
    must_pass : sequence, or dict of description to form
        Forms that some line of the chain has to have.
    lemmas : dict of str to str or SymPy equation
        Named equations that a step may use; they are assumed, not checked.
    seed : int
        Seed of the random points.

    Examples
    --------
    >>> D = Derivation("y", given="x*y/x", domains={"x": "nonzero", "y": "real"})
    >>> D.step("y", because="cancel x")
    (1) = y
        ✓ proved
        because cancel x
    >>> D.complete
    True
    """

    def __init__(self, goal, given=None, domains=None, must_pass=(), lemmas=None, seed=0):
        self.domains = {str(n): str(t) for n, t in (domains or {}).items()}
        self.kinds = {n: Domain(n, t).kind for n, t in self.domains.items()}
        self.seed, self.steps = seed, []
        self.goal = self._task("goal", goal)
        self.given = None if given is None else self._task("given line", given)
        self._texts = {"goal": _text(goal), "given": None if given is None else _text(given)}
        forms = must_pass.items() if isinstance(must_pass, dict) else enumerate(must_pass, 1)
        self.must_pass = {
            f"required form {k}": self._task(f"required form {k}", form) for k, form in forms
        }
        self.lemmas = {str(n): self._task(f"lemma {n}", e) for n, e in (lemmas or {}).items()}
        for n, e in self.lemmas.items():
            if not isinstance(e, sp.Eq):
                raise ValueError(f"lemma {n} must be an equation Eq(left, right)")

    def _task(self, what, line):
        try:
            return read(line, self.kinds)
        except Unreadable as error:
            raise ValueError(f"the {what} cannot be read: {error}") from None

    def step(self, line, because="", relation="iff", unknown=None, lemma=None):
        """Add a line, check it against the line before, and return it with its verdict."""
        notes = []
        try:
            written = read(line, self.kinds)
        except Unreadable as error:
            return self._add(
                line,
                Verdict("unreadable", f"unreadable: {error}"),
                because,
                relation,
                lemma,
                notes,
                None,
            )
        before = self._before()
        if lemma is not None and lemma not in self.lemmas:
            known = ", ".join(self.lemmas) or "none"
            verdict = Verdict(
                "unreadable", f"the lemma {lemma!r} is not declared (declared: {known})"
            )
            return self._add(line, verdict, because, relation, lemma, notes, written)
        if before is None and not is_claim(written):
            verdict, relation = Verdict("proved", START), ""
        else:
            pair = [before, written]
            if lemma is not None:
                pair = [None if w is None else use(self.lemmas[lemma], w) for w in pair]
                if pair == [before, written]:
                    notes.append(f"The lemma {lemma} is not used in this step")
            verdict = check_step(*pair, self.domains, relation, unknown, self.seed)
            if before is not None and key(before) == key(written):
                notes.append("This line is the same as the line before: the step changes nothing")
            if before is None:
                relation = ""
        if relation == "iff" and not is_claim(written):
            relation = "equal"
        return self._add(line, verdict, because, relation, lemma, notes, written)

    def check(self, lines):
        """Add several lines, each a text or a tuple (text, reason).

        A first line that repeats the given one is skipped.
        """
        for k, line in enumerate(lines):
            line, because = line if isinstance(line, tuple) else (line, "")
            if k == 0 and not self.steps and self.given is not None and self._is_given(line):
                continue
            self.step(line, because)
        return self

    def _is_given(self, line):
        try:
            return key(read(line, self.kinds)) == key(self.given)
        except Unreadable:
            return False

    def _before(self):
        return next(iter(self._lines()[::-1]), None)

    def _add(self, line, verdict, because, relation, lemma, notes, written):
        latex = "" if written is None else typeset(written, isinstance(line, str))
        step = Step(
            len(self.steps) + 1,
            _text(line),
            verdict,
            because,
            relation,
            lemma,
            tuple(notes),
            written,
            latex,
        )
        self.steps.append(step)
        return step

    @property
    def verdicts(self):
        return [s.verdict for s in self.steps]

    @property
    def reached(self):
        """Whether the last line is the goal, or an equation solved as the goal is."""
        last = self._before()
        return last is not None and (form(last) == form(self.goal) or self._solved(last))

    def _solved(self, last):
        """Whether the chain solves for the goal's unknown, and `last` says what the goal says."""
        x = solved_for(self.goal)
        start = self._lines()[0]
        if x is None or solved_for(last) != x or solved_for(start) == x:
            return False
        if not operators(last) <= operators(self.goal):
            return False
        verdict = check_step(last, self.goal, self.domains, seed=self.seed)
        return verdict.status in ("proved", "sampled")

    def _lines(self):
        return [w for w in [self.given, *[s.written for s in self.steps]] if w is not None]

    @property
    def moves(self):
        """How many lines are new; another order, an added 0 or a factor of 1 make none."""
        return len({key(without_padding(w)) for w in self._lines()}) - (self.given is not None)

    @property
    def problems(self):
        """What is missing or wrong, in words; empty if the derivation is complete."""
        out = []
        for s in self.steps:
            if s.status not in ("proved", "sampled"):
                out.append(f"line {s.number}: {s.verdict.message}")
            out += [f"line {s.number}: {n}" for n in s.notes]
        if not self.steps:
            return ["there are no lines yet"]
        passed = [form(w) for w in self._lines()]
        for name, w in self.must_pass.items():
            if form(w) not in passed:
                out.append(f"the chain leaps over a step: {name} is not among the lines")
        if not self.reached:
            out.append(self._short_of_goal())
        return out

    def _short_of_goal(self):
        last = self._before()
        if last is None:
            return "no line can be read"
        if is_claim(last) != is_claim(self.goal):
            return "the goal is not reached: of it and the last line, one is an equation, one not"
        status = check_step(last, self.goal, self.domains, seed=self.seed).status
        if status == "refuted":
            return "the goal is not reached: the last line says something else"
        return (
            "the goal is not reached: the last line agrees with it, but does not have its form yet"
        )

    @property
    def complete(self):
        """Every line proved or sampled, every required form passed, the goal reached."""
        return not self.problems

    @property
    def conditions(self):
        return tuple(dict.fromkeys(c for v in self.verdicts for c in v.conditions))

    def summary(self):
        """(what, how much) pairs for the table under the chain."""
        checked = [v.status for v in self.verdicts if v.message != START]
        rows = [(word, checked.count(word)) for word in MARKS]
        rows = [(word, n) for word, n in rows if n or word in ("proved", "sampled", "refuted")]
        rows += [("assumed", ", ".join(self.lemmas))] if self.lemmas else []
        rows += [("needs", ", ".join(self.conditions))] if self.conditions else []
        return [*rows, ("goal", "reached" if self.reached else "not reached")]

    def text(self):
        """The chain in plain text."""
        lines = [f"given: {self._texts['given']}"] if self.given is not None else []
        lines += [repr(s) for s in self.steps]
        lines.append("; ".join(f"{what}: {much}" for what, much in self.summary()))
        lines += [f"- {p}" for p in self.problems]
        return "\n".join(lines)

    __str__ = __repr__ = text

    def _repr_html_(self):
        rows = []
        if self.given is not None:
            formula = typeset(self.given, True)
            rows.append(
                f'<tr><td></td><td style="text-align:left">$\\displaystyle {formula}$</td>'
                '<td style="text-align:left">given</td></tr>'
            )
        rows += [s.row() for s in self.steps]
        cells = "".join(
            f"<td>{html.escape(f'{what}: {much}')}</td>" for what, much in self.summary()
        )
        items = "".join(f"<li>{html.escape(p)}</li>" for p in self.problems)
        return f"<table>{''.join(rows)}</table><table><tr>{cells}</tr></table>" + (
            f"<ul>{items}</ul>" if items else ""
        )


def _text(line):
    return " ".join(line.split()) if isinstance(line, str) else str(line)


def typeset(w, as_written):
    if not as_written:
        return sp.latex(w)
    # SymPy keeps 1/x, as it is written, as the product of 1 and 1/x.
    return re.sub(r"(?<![\d.])1 (\\cdot )?(?=\\frac\{1\})", "", sp.latex(w, order="none"))


def key(w):
    """The written form up to the order of terms and factors; nothing is computed."""
    if isinstance(w, sp.MatrixBase):
        return ("Matrix", w.shape, tuple(key(x) for x in w))
    if w.is_Atom or not w.args:
        return ("", str(w))
    parts = [key(a) for a in w.args]
    if isinstance(w, sp.MatMul):  # numbers may move, matrices not
        numbers = [key(a) for a in w.args if not is_matrix(a)]
        parts = sorted(numbers, key=repr) + [key(a) for a in w.args if is_matrix(a)]
    elif isinstance(w, (sp.Add, sp.Mul, sp.Eq, sp.Max, sp.Min, sp.MatAdd, sp.And, sp.Or)):
        parts.sort(key=repr)
    return (w.func.__name__, *parts)


def without_padding(w):
    """`w` without added zeros and without factors of one."""

    def leaf(x):
        if isinstance(x, sp.Pow) and x.base == 1:
            return x.base
        if not isinstance(x, (sp.Add, sp.Mul)):
            return None
        neutral = sp.Integer(0 if isinstance(x, sp.Add) else 1)
        rest = [a for a in map(without_padding, x.args) if a != neutral]
        return x.func(*(rest or [neutral]), evaluate=False)

    return rebuild(w, leaf)


def solved_for(w):
    """Return the symbol that an equation is solved for: alone on one side, not on the other."""
    sides = w.args if isinstance(w, sp.Eq) else ()
    pairs = zip(sides, sides[::-1], strict=True)
    return next((x for x, y in pairs if x.is_Symbol and x not in y.free_symbols), None)


def operators(w):
    """Return which operators in a line are still to be carried out."""
    return {type(x) for x in w.atoms(sp.Sum, sp.Product, sp.Integral, sp.Derivative, sp.Subs)}


def form(w):
    """Return the form of a line: up to order, signs, numbers and the names of bound indices."""
    w = tidy(w)
    if w.has(sp.Sum, sp.Product, sp.Integral):
        w = w.as_dummy()
    return key(w.canonical if isinstance(w, (sp.Gt, sp.Lt, sp.Ge, sp.Le)) else w)


def use(lemma, w):
    """`w` with the left side of the lemma replaced by its right side, wherever it stands."""
    left = key(lemma.lhs)
    new = rebuild(w, lambda x: lemma.rhs if key(x) == left else None)
    if new is w or new == w:
        new = w if is_claim(w) or getattr(w, "is_Matrix", False) else w.subs(lemma.lhs, lemma.rhs)
    return new
