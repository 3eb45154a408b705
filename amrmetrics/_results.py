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

    def _repr_html_(self):
        rows = "".join(
            f"<tr><th>{escape(f.name)}</th><td>{escape(_short(getattr(self, f.name)))}</td></tr>"
            for f in fields(self)
            if f.repr
        )
        return f"<table>{rows}</table>"


def _plain(value):
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return value


def _short(value):
    if isinstance(value, np.ndarray) and value.size > SHOWN:
        return f"array of shape {value.shape}"
    if isinstance(value, float):
        return f"{value:.6g}"
    return str(value)
