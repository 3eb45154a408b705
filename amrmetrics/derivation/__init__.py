"""Derivations, checked line by line.

A step gets one of five verdicts.

``proved``
    Shown symbolically, on the whole domain, under the conditions that are listed.
``sampled``
    Agrees at many random points in high precision, on every branch. That is evidence and not a
    proof.
``refuted``
    There is a point of the domain where the step is wrong. The point and both values are given.
``undecided``
    Neither a counterexample nor enough points where both lines have a value.
``unreadable``
    The line cannot be read. The message says what to write instead.

The order is: read, collect the conditions, look for a counterexample, then for a proof.
"No proof was found" is never "wrong". Values are exact fractions or intervals that contain them
(`arithmetic`), so that a counterexample is certain and hangs on no tolerance; a proof keeps the
rules that stand at the top of `proving`.

Why not something simpler? Measured on the 328 formulas (133 right, 195 wrong) of the corpora
``public`` and ``own`` in ``tests/derivations``, with SymPy 1.14 on Python 3.11::

    checker                   wrong accepted  right rejected  no answer in 10 s
    simplify(a - b) == 0                   1              25                  0
    (a - b).equals(0)                      1              23                  4
    five points in [0, 1]                 14              13                 23
    check_step                             0               0                  0

The first two read "could not show it" as "wrong". Five points cannot tell ``|x|`` from ``x``.
``python tests/derivations/evaluate.py --compare public own`` prints this table again, and the one
of false proofs, false accusations and times over five seeds, with mutants, rewrites and hostile
text.
"""

from .checking import Verdict, check_step

__all__ = ["Derivation", "Verdict", "check_step", "declare"]


def __getattr__(name):
    if name == "Derivation":
        from .chain import Derivation

        return Derivation
    if name == "declare":
        from .written import declare

        return declare
    raise AttributeError(name)
