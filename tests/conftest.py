"""Options and fixtures that all tests share."""

import matplotlib
import numpy as np
import pytest

matplotlib.use("Agg")


def pytest_addoption(parser):
    parser.addoption(
        "--sweep",
        action="store_true",
        help="run every stochastic claim at 20 seeds (minutes) instead of one",
    )


@pytest.fixture
def rng():
    return np.random.default_rng(2026)
