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
"No proof was found" is never "wrong".
"""

from .checking import Verdict, check_step

__all__ = ["Derivation", "Verdict", "check_step"]


def __getattr__(name):
    if name == "Derivation":
        from .chain import Derivation

        return Derivation
    raise AttributeError(name)
