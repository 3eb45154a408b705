"""One step: read, collect the conditions, look for a counterexample, look for a proof."""

import time
from dataclasses import dataclass, field

import sympy as sp

from . import feedback
from .domains import make
from .limits import bounded
from .proving import Model, conditions, proved
from .reading import Unreadable, apart, is_claim, is_matrix, read, scalar
from .searching import Search

LONGEST = 9  # seconds by the clock, which only a slow machine meets
FEW = 2  # points at which integrals and limits are evaluated before a proof is looked for
RELATIONS = ("iff", "implies", "implied_by")
MARKS = {"proved": "✓", "sampled": "≈", "refuted": "✗", "undecided": "?", "unreadable": "!"}


@dataclass(frozen=True)
class Verdict:
    """What is known about one step. It has no truth value: ask for ``status``."""

    status: str
    message: str = ""
    witness: dict = field(default_factory=dict)
    before_value: object = None
    after_value: object = None
    conditions: tuple = ()
    points: int = 0

    def __bool__(self):
        raise TypeError(
            "a verdict is not True or False: compare .status with 'proved', 'sampled', ..."
        )

    def __repr__(self):
        return f"{MARKS[self.status]} {self.message}"


def check_step(before, after, domains, relation="iff", unknown=None, seed=0):
    """Check the step from `before` to `after` on the declared domains.

    Parameters
    ----------
    before, after : str or SymPy object
        Two formulas (equal everywhere?) or two equations or inequalities. An empty `before` asks
        whether the claim `after` holds on the whole domain.
    domains : dict of str to str
        By name: ``real nonzero >0 >=0 angle (a,b) int>=k seq index function vec2 vec3 spd2 spd3
        chol2 rot se2``, or in words, such as ``positive sequence``. An ``index`` is a place in the
        sequences of the line: from 1 to the size that its sums have.
    relation : {"iff", "implies", "implied_by"}
        Between equations: same solutions, none lost, none gained.
    unknown : str, optional
        The symbol that the equations are solved for.
    seed : int
        Seed of the random points; the verdict is the same for the same seed.

    Returns
    -------
    Verdict

    Raises
    ------
    ValueError
        If `relation` is none of the three.

    Examples
    --------
    >>> check_step("x*y/x", "y", {"x": "real", "y": "real"})
    ✓ proved, if x != 0
    """
    if relation not in RELATIONS:
        raise ValueError(f"relation is {relation!r}; use one of {', '.join(RELATIONS)}")
    try:
        lines = before, after, domains, relation, unknown, seed
        finished, step = bounded(lambda: Step(*lines), 0.8, 6)
        if not finished:
            raise Unreadable("the line is too complicated to read")
    except Unreadable as error:
        return Verdict("unreadable", f"unreadable: {error}")
    return step.verdict()


class Step:
    """Two lines that have been read, and what is asked about them."""

    def __init__(self, before, after, domains, relation, unknown, seed):
        self.end = time.monotonic() + LONGEST
        self.said = True  # whether all conditions could be worked out
        texts = {str(n): str(t) for n, t in dict(domains).items()}
        self.domains = {n: make(n, t, tuple(texts)) for n, t in texts.items()}
        kinds = {n: d.kind for n, d in self.domains.items()}
        empty = before is None or (isinstance(before, str) and not before.strip())
        self.after = apart(read(after, kinds))
        self.before = None if empty else apart(read(before, kinds))
        self.relation = relation
        self.unknown = None if unknown is None else str(unknown)
        if self.unknown is not None and self.unknown not in self.domains:
            raise Unreadable(f"the unknown {self.unknown} is not declared")
        if empty and not is_claim(self.after):
            raise Unreadable(
                "a formula alone claims nothing: write an equation, or give the line before"
            )
        if empty and isinstance(self.after, sp.Eq):
            self.before, self.after = self.after.args
        if self.before is not None and is_claim(self.before) != is_claim(self.after):
            raise Unreadable(
                "one line is a formula and the other an equation: compare like with like"
            )
        self.formulas = self.before is not None and not is_claim(self.before)
        if self.formulas:
            self._same_shape()
        lines = self.before, self.after
        self.search = Search(*lines, self.domains, seed, relation, self.unknown)
        self.model = Model(self.search.domains, self.search.sizes, bool(self.search.sized))

    def _same_shape(self):
        a, b = (tuple(w.shape) if is_matrix(w) else (1, 1) for w in (self.before, self.after))
        if a != b:
            raise Unreadable(f"the shapes differ: {a[0]} x {a[1]} before and {b[0]} x {b[1]} after")
        if a == (1, 1):
            self.before, self.after = scalar(self.before), scalar(self.after)

    def verdict(self):
        search = self.search
        self.said, needed = bounded(lambda: conditions(search.lines, self.model), 0.8, 3)
        needed = needed or ()
        if self.settled_by_proof(search):
            return self.proof(search, needed)
        if search.refutes():
            return feedback.refutation(search)
        if search.suspect:
            text = "undecided: the lines seem to differ, but not surely enough to call it wrong"
            return Verdict("undecided", text, conditions=needed)
        facts = {"conditions": needed, "points": search.points}
        note = f", if {' and '.join(needed)}" if needed else ""
        if search.points and search.enlarged:
            only = note or " on a part of the domain"
            text = "the line after has a value on more of the domain than the line before"
            return Verdict(
                "sampled", f"agrees at the points tried, but only{only}: {text}", **facts
            )
        if not search.rough and (search.points or self.before is None) and self.proved():
            return self.proof(search, needed)
        if search.points > 1 or (search.points and not search.domains):
            return Verdict("sampled", feedback.where(search) + note, **facts)
        text = "undecided: no point was found where both lines have a value"
        if search.points:
            text = "undecided: it agrees at the only point that could be evaluated in time"
        return Verdict("undecided", text, **facts)

    def settled_by_proof(self, search):
        """Whether a proof saves the many quadratures that a full search would take."""
        if not search.rough or self.narrowed():
            return False
        if search.refutes(most=FEW) or search.suspect or search.enlarged:
            return False
        return (search.points > 0 or self.before is None) and self.proved()

    def narrowed(self):
        """Whether the line after needs what the line before does not: then points may be lost."""
        first, both = (
            bounded(lambda lines=lines: conditions(lines, self.model), 0.8, 3)[1]
            for lines in (self.search.lines[:1], self.search.lines)
        )
        return first != both

    def proved(self):
        if not self.said:  # a proof without its conditions is none
            return False
        lines = self.before, self.after, self.relation
        wall = max(1, self.end - time.monotonic())
        return bounded(lambda: proved(*lines, self.model), 3.5, wall)[1] is True

    @staticmethod
    def proof(search, needed):
        note = f", if {' and '.join(needed)}" if needed else ""
        return Verdict("proved", f"proved{note}", conditions=needed, points=search.points)
