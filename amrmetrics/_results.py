"""What all results share: plain numbers for JSON and pandas, and a table for the notebook."""

from dataclasses import fields
from html import escape

import numpy as np

# Longer arrays are data, not numbers to read: the table shows their shape.
SHOWN = 6


class Result:
    """Base of the frozen dataclasses that the library returns.

    A field that is no number, text or array is declared with ``repr=False`` and left out.
    """

    def as_dict(self):
        """Return the fields as plain numbers, text, lists and dictionaries, ready for JSON."""
        return {f.name: _plain(getattr(self, f.name)) for f in fields(self) if f.repr}

    def _title(self):
        return ""

    def _rows(self):
        """Return what a table shows: names and texts."""
        return [(f.name, _short(getattr(self, f.name))) for f in fields(self) if f.repr]

    def _repr_html_(self):
        caption = f"<caption>{escape(self._title())}</caption>" if self._title() else ""
        rows = "".join(
            f"<tr><th>{escape(name)}</th><td>{escape(text)}</td></tr>"
            for name, text in self._rows()
        )
        return f"<table>{caption}{rows}</table>"


class Number(Result, np.lib.mixins.NDArrayOperatorsMixin):
    """A result that stands for a single number: ``float()`` gives it, and NumPy and formats use it.

    ``f"{result:.3f}"``, ``np.mean([result, result])`` and ``result < 0.1`` work.
    """

    def __float__(self):
        raise NotImplementedError

    def __array__(self, dtype=None, copy=None):
        return np.array(float(self), dtype)

    def __array_ufunc__(self, ufunc, method, *inputs, **options):
        plain = [float(x) if isinstance(x, Number) else x for x in inputs]
        return getattr(ufunc, method)(*plain, **options)

    def __format__(self, spec):
        return format(float(self), spec) if spec else str(self)

    def __round__(self, digits=None):
        return round(float(self), digits)

    def __hash__(self):
        return id(self)


def _plain(value):
    if isinstance(value, Result):
        return value.as_dict()
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return value


def _short(value):
    if isinstance(value, np.ndarray) and value.size > SHOWN:
        return f"array of shape {value.shape}"
    if isinstance(value, float):
        return f"{value:.6g}"
    return str(value)
