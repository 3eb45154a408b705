"""Matrices whose size is a letter: products as words, proofs by trace and by cancelling.

A matrix is a sum of words with coefficients. A letter of a word is (name, transposed, inverted).
What stands beside its own inverse cancels; a row times ... times a column is a number and moves to
the front; a trace does not change when its word is turned around or transposed. The inverse of a
product whose factors are not square is a letter of its own: its name is the word that it inverts.
"""

import sympy as sp
from sympy.matrices.expressions.matexpr import MatrixElement

from .reading import is_matrix, rebuild


class NoForm(Exception):
    """Something that is no word."""


def same(before, after, model):
    """Whether two lines with matrices of any size are proved to be equal."""
    from .proving import vanishes

    algebra = _Algebra(model)
    try:
        if not is_matrix(before):
            return vanishes(algebra.scalar(before) - algebra.scalar(after), model)
        difference = dict(algebra.matrix(before))
        for word, c in algebra.matrix(after).items():
            difference[word] = difference.get(word, 0) - c
        return all(vanishes(sp.sympify(c), model) for c in difference.values())
    except NoForm:
        return False


class _Algebra:
    def __init__(self, model):
        self.model, self.names = model, {}

    def family(self, name):
        if isinstance(name, tuple):
            return "sym" if self.flipped(name, False) == name else "mat"
        return getattr(self.model.domains.get(name), "family", "mat")

    def height(self, letter):
        """Return the number of rows of a letter, or None if it is not known."""
        name, transposed, inverted = letter
        if isinstance(name, tuple):
            return self.height(name[0])
        kind = getattr(self.model.domains.get(name), "kind", None)
        return kind and kind[transposed != inverted]

    def square(self, word):
        return all(self.height(x) == self.height(self.flipped((x,), False)[0]) for x in word)

    def number(self, *key, **facts):
        """Return the symbol of a number that is known by its word only."""
        if key not in self.names:
            self.names[key] = sp.Symbol(f"_N{len(self.names)}", real=True, **facts)
        return self.names[key]

    # ---- words -------------------------------------------------------------------------------

    def letter(self, name, transposed, inverted):
        family = self.family(name)
        if family in ("spd", "sym"):
            transposed = False
        if family == "rot":
            transposed, inverted = transposed != inverted, False
        return name, transposed, inverted

    def flipped(self, word, invert):
        turned = [(n, t, not i) if invert else (n, not t, i) for n, t, i in reversed(word)]
        return tuple(self.letter(*x) for x in turned)

    def cancels(self, a, b):
        return a == self.flipped((b,), invert=True)[0] and self.family(a[0]) != "vec"

    def reduced(self, word, c):
        """Return the word without neighbors that cancel, and with its numbers in front."""
        out = []
        for x in word:
            if out and self.cancels(out[-1], x):
                out.pop()
                continue
            out.append(x)
            if beside := self.undone(out):
                del out[-beside:]
                continue
            if self.family(x[0]) == "vec" and not x[1]:
                row = [k for k, y in enumerate(out[:-1]) if self.family(y[0]) == "vec" and y[1]]
                if row:
                    c *= self.trace(tuple(out[row[-1] :]), None)
                    del out[row[-1] :]
        return tuple(out), c

    @staticmethod
    def undone(out):
        """Return how many letters at the end are a product beside its own inverse, or 0."""
        last = len(out) - 1
        for place, (name, *flags) in enumerate(out):
            if isinstance(name, tuple) and flags == [False, False]:
                before = tuple(out[max(place - len(name), 0) : place])
                if tuple(out[place + 1 :]) == name or (place == last and before == name):
                    return len(name) + 1
        return 0

    def matrix(self, w):
        """Return the sum of words that `w` is: a dict from word to coefficient."""
        if isinstance(w, sp.MatrixSymbol):
            return {(self.letter(w.name, False, False),): sp.Integer(1)}
        if isinstance(w, sp.Identity):
            return {(): sp.Integer(1)}
        if isinstance(w, sp.Transpose | sp.Inverse):
            return self.turned(self.matrix(w.args[0]), isinstance(w, sp.Inverse))
        if isinstance(w, sp.MatAdd):
            return self.total([self.matrix(a).items() for a in w.args])
        if isinstance(w, sp.MatMul):
            result = {(): sp.Integer(1)}
            for a in w.args:
                factor = self.matrix(a) if is_matrix(a) else {(): self.scalar(a)}
                products = [
                    self.reduced(u + v, c * d) for u, c in result.items() for v, d in factor.items()
                ]
                result = self.total([products])
            return result
        raise NoForm

    @staticmethod
    def total(parts):
        result = {}
        for items in parts:
            for word, c in items:
                result[word] = sp.expand(result.get(word, 0) + c)
        return {word: c for word, c in result.items() if c != 0}

    def turned(self, m, invert):
        if not invert:
            return self.total([[self.reduced(self.flipped(u, False), c) for u, c in m.items()]])
        if len(m) != 1:
            name = f"inverse of {sorted(map(str, m.items()))}"
            return {((name, False, False),): sp.Integer(1)}
        ((word, c),) = m.items()
        if not self.square(word):
            return {((word, False, False),): 1 / c}
        return {self.flipped(word, True): 1 / c}

    # ---- numbers -----------------------------------------------------------------------------

    def scalar(self, w):
        """Return a formula in which traces, determinants and forms are symbols."""

        def leaf(x):
            if isinstance(x, sp.Trace):
                words = self.matrix(x.args[0]).items()
                size = sp.sympify(x.args[0].shape[0])
                return sp.Add(*(c * self.trace(u, size) for u, c in words))
            if isinstance(x, sp.Determinant):
                return self.determinant(x.args[0])
            if isinstance(x, MatrixElement):
                if tuple(x.args[0].shape) != (1, 1):
                    raise NoForm
                words = self.matrix(x.args[0]).items()
                return sp.Add(*(c * (self.trace(u, None) if u else 1) for u, c in words))
            return None

        return self.model.evaluated(rebuild(w, leaf))

    def trace(self, word, size):
        while len(word) > 1 and self.cancels(word[-1], word[0]):
            word = word[1:-1]
        if not word:
            return self.model.evaluated(size)
        turns = [w[k:] + w[:k] for w in (word, self.flipped(word, False)) for k in range(len(word))]
        if all(self.family(name) != "vec" for name, *_ in word):
            for turn in turns:
                shorter, _ = self.reduced(turn, 1)
                if len(shorter) < len(turn):
                    return self.trace(shorter, self.height(turn[0]))
        return self.number("trace", min(turns, key=repr))

    def determinant(self, w):
        m = self.matrix(w)
        if len(m) != 1 or not self.square(next(iter(m))):
            return self.number("det", tuple(sorted(m.items(), key=str)))
        ((word, c),) = m.items()
        result = c ** self.model.evaluated(sp.sympify(w.shape[0]))
        for name, _, inverted in word:
            family = self.family(name)
            facts = {"positive": True} if family in ("spd", "chol") else {}
            one = sp.Integer(1) if family == "rot" else self.number("det", name, **facts)
            result *= 1 / one if inverted else one
        return result
