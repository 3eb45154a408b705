"""What every public name promises: a light import, a full docstring, no hidden state."""

import importlib
import inspect
import pkgutil
import subprocess
import sys

import pytest

import amrmetrics as am

PUBLIC = [getattr(am, name) for name in am.__all__ if not inspect.ismodule(getattr(am, name, None))]
MODULES = [name for _, name, _ in pkgutil.iter_modules(am.__path__, "amrmetrics.")]


def test_import_loads_numpy_and_nothing_slow():
    code = "import amrmetrics, sys; print(*sys.modules)"
    loaded = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    ).stdout.split()
    slow = {"scipy", "sympy", "matplotlib", "IPython", "ipywidgets", "nbgrader", "pandas"}
    assert not slow & set(loaded)


@pytest.mark.parametrize("module", MODULES)
def test_each_module_imports_alone(module):
    if not module.endswith("__main__"):
        assert importlib.import_module(module).__doc__


def test_every_advertised_name_exists():
    for name in am.__all__:
        assert getattr(am, name) is not None, name
    assert set(am.__all__) <= set(dir(am))


@pytest.mark.parametrize(
    "function", [f for f in PUBLIC if inspect.isfunction(f)], ids=lambda f: f.__name__
)
def test_docstrings_are_complete(function):
    text = inspect.getdoc(function)
    for section in ("Parameters", "Returns", "Raises", "References", "Examples"):
        assert f"\n{section}\n" + "-" * len(section) in text, section
    for parameter in inspect.signature(function).parameters:
        assert parameter in text.split("Returns")[0], parameter
    assert ">>> " in text


@pytest.mark.parametrize(
    "kind",
    [c for c in PUBLIC if inspect.isclass(c) and not issubclass(c, Exception)],
    ids=lambda c: c.__name__,
)
def test_results_document_their_fields(kind):
    text = inspect.getdoc(kind)
    for field in getattr(kind, "__dataclass_fields__", {}):
        assert field in text, field
