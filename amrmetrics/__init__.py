"""Metrics for localization and SLAM of mobile robots.

Use it as ``import amrmetrics as am``. Reference (ground truth) comes before
estimate in every function. A trajectory is an array of homogeneous matrices of
shape ``(N, d + 1, d + 1)`` with d = 2 or 3; lengths are in metres, times in
seconds, angles in radians unless a name says degrees. Bad input raises
:class:`amrmetrics.errors.AmrError`, a ``ValueError`` that names the argument.

Importing the package loads nothing else; each module loads when it is first
used. What there is stands in ``__init__.pyi``, where type checkers look, too.
"""

import lazy_loader as _lazy

from amrmetrics._version import VERSION

__version__ = VERSION

__getattr__, __dir__, __all__ = _lazy.attach_stub(__name__, __file__)
