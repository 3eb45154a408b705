"""The types of the public functions. Only type checkers import this."""

import os

import numpy as np
from numpy.typing import ArrayLike as ArrayLike
from numpy.typing import NDArray

Array = NDArray[np.float64]
Path = str | os.PathLike[str]
