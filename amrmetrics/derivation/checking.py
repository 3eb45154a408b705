"""One step: read, conditions, refute, prove."""

import threading
import time
from dataclasses import dataclass, field
from functools import partial

import mpmath
import sympy as sp

from . import feedback
from .conditions import conditions
from .domains import Domain
from .limits import bounded
from .proving import Model, equation_proved, inequality_proved, positive, vanishes
from .reading import Unreadable, is_claim, is_matrix, read
from .refuting import Search

_one_at_a_time = threading.RLock()
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
        chol2 rot se2``.
    relation : {"iff", "implies", "implied_by"}
        Between equations: same solutions, none lost, none gained.
    unknown : str, optional
        The symbol that the equations are solved for.
    seed : int
        Seed of the random points; the verdict is the same for the same seed.

    Returns
    -------
    Verdict

    Examples
    --------
    >>> check_step("x*y/x", "y", {"x": "real", "y": "real"})
    ✓ proved, if x != 0
    """
    if relation not in RELATIONS:
        raise ValueError(f"relation is {relation!r}; use one of {', '.join(RELATIONS)}")
    with _one_at_a_time, mpmath.workprec(53):  # the precision of mpmath is global
        return _check(before, after, domains, relation, unknown, seed)


def _check(before, after, domains, relation, unknown, seed):
    try:
        finished, step = bounded(
            lambda: _Step(before, after, domains, relation, unknown, seed), 0.8, 1.2
        )
        if not finished:
            return Verdict("unreadable", "unreadable: the line is too complicated to read")
        return step.verdict()
    except Unreadable as error:
        return Verdict("unreadable", f"unreadable: {error}")
    except Exception as error:  # a library gave up on this line: that is no verdict on the student
        return Verdict(
            "undecided", f"undecided: the line is too complicated ({type(error).__name__})"
        )


class _Step:
    def __init__(self, before, after, domains, relation, unknown, seed):
        self.end = time.monotonic() + 8.5
        domains = {str(n): Domain(str(n), t) for n, t in dict(domains).items()}
        kinds = {n: d.kind for n, d in domains.items()}
        self.model = Model(domains)
        empty = before is None or (isinstance(before, str) and not before.strip())
        self.after = read(after, kinds)
        self.before = None if empty else read(before, kinds)
        self.relation, self.seed = relation, seed
        self.unknown = None if unknown is None else str(unknown)
        if self.unknown is not None and self.unknown not in domains:
            raise Unreadable(f"the unknown {self.unknown} is not declared")
        self.identity = False
        if empty and not is_claim(self.after):
            raise Unreadable(
                "a formula alone claims nothing: write an equation, or give the line before"
            )
        if empty and isinstance(self.after, sp.Eq):
            self.before, self.after, self.identity = self.after.lhs, self.after.rhs, True
        if self.before is not None and is_claim(self.before) != is_claim(self.after):
            raise Unreadable(
                "one line is a formula and the other an equation: compare like with like"
            )
        self.formulas = self.before is not None and not is_claim(self.before)
        if self.formulas:
            self._same_shape()

    def _same_shape(self):
        a, b = (tuple(w.shape) if is_matrix(w) else (1, 1) for w in (self.before, self.after))
        if a != b:
            raise Unreadable(f"the shapes differ: {a[0]} x {a[1]} before and {b[0]} x {b[1]} after")
        if a == (1, 1):
            from .reading import _scalar

            self.before, self.after = _scalar(self.before), _scalar(self.after)

    def verdict(self):
        lines = [self.before, self.after]
        search = Search(self.before, self.after, self.model, self.seed, 3.0)
        finished, needed = bounded(lambda: conditions(lines, self.model), 0.8, 1.2)
        needed = needed if finished else ()
        finished, wrong = bounded(lambda: self.refute(search), 4.0, 4.8)
        if wrong or search.found:
            return self.refuted(search)
        if search.suspect:
            text = "undecided: the lines seem to differ, but not surely enough to call it wrong"
            return Verdict("undecided", text, conditions=needed)
        note = f", if {' and '.join(needed)}" if needed else ""
        if search.enlarged:
            return Verdict(
                "sampled" if search.points else "undecided",
                f"agrees at {search.points} points, but only{note or ' on a part of the domain'}: "
                "the line after has a value on more of the domain than the line before",
                conditions=needed,
                points=search.points,
            )
        _, proved = bounded(self.prove, 2.6, self.end - time.monotonic())
        if proved and (search.points or self.before is None):
            return Verdict("proved", f"proved{note}", conditions=needed, points=search.points)
        if search.points:
            return Verdict(
                "sampled",
                f"agrees at {search.points} points (not a proof){note}",
                conditions=needed,
                points=search.points,
            )
        return Verdict(
            "undecided",
            "undecided: no point was found where both lines have a value",
            conditions=needed,
        )

    def refute(self, search):
        """Search for a counterexample, and then for the simplest one near it."""
        if self.formulas:
            wrong, check = search.formulas(), search.try_point
        elif self.before is None:
            wrong, check = search.claim(), partial(search.claim_at, generic=True)
        else:
            wrong = search.claims(self.relation, self.unknown)
            check = partial(search.claims_at, relation=self.relation, n=self.unknown)
        if wrong:
            feedback.simplest(search, check, search.found[0])
        return wrong

    def prove(self):
        m = self.model
        finished, pair = bounded(
            lambda: [
                None if w is None or is_claim(w) else m.evaluated(w)
                for w in (self.before, self.after)
            ],
            1.5,
        )
        if not finished:
            return False
        if self.formulas:
            a, b = pair
            if is_matrix(a):
                return all(vanishes(x, m) for x in (a - b))
            return vanishes(a - b, m)
        if self.before is None:
            w = self.after
            if not isinstance(w, (sp.Gt, sp.Ge, sp.Lt, sp.Le)):
                return False
            d = m.evaluated(w.gts) - m.evaluated(w.lts)
            return positive(d, m, strict=isinstance(w, (sp.Gt, sp.Lt)))
        if isinstance(self.before, sp.Eq) and isinstance(self.after, sp.Eq):
            return equation_proved(self.before, self.after, self.relation, m)
        if all(isinstance(w, (sp.Gt, sp.Ge, sp.Lt, sp.Le)) for w in (self.before, self.after)):
            return inequality_proved(self.before, self.after, m)
        return False

    def refuted(self, search):
        values, seen = search.found
        shown = feedback.witness(search, values)
        place = ", ".join(f"{n} = {v}" for n, v in shown.items()) or "any point"
        if self.formulas:
            a = feedback.number(seen[1])
            if seen[0] == "shrunk":
                text = f"at {place} the line before is {a}, but the line after is not defined"
                return Verdict("refuted", f"wrong: {text}", shown, a, sp.nan)
            b = feedback.number(seen[2])
            if a == b:  # they differ further behind
                a, b = (feedback.number(x, 25) for x in seen[1:3])
            _, words = bounded(lambda: feedback.difference_in_words(search), 0.6, 0.9)
            text = (
                f"wrong: at {place} the line before is {a} and the line after is {b}.{words or ''}"
            )
            return Verdict("refuted", text, shown, a, b)
        if self.before is None:
            a, b = (feedback.number(x) for x in seen[1:3])
            return Verdict(
                "refuted",
                f"wrong: at {place} the left side is {a} and the right side is {b}",
                shown,
                a,
                b,
            )
        kind, (p, _), (q, _) = seen
        which = (
            "holds in the line before but not in the line after"
            if kind == "lost"
            else "holds in the line after but not before"
        )
        return Verdict(
            "refuted",
            f"wrong: {place} {which}: a solution is {kind}",
            shown,
            sp.sympify(p),
            sp.sympify(q),
        )
