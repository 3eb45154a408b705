"""What a program uses while it runs: time per frame, processor, memory, energy (lecture 08).

`measure` takes the times of a running program; `energy` and `resource_use` read logs that
another tool wrote, so that no hardware is needed to work with them.
"""

from __future__ import annotations

import sys
import time
from array import array
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from amrmetrics._arguments import as_array, as_count, as_numbers, as_size, as_stamps
from amrmetrics._results import Number, Result
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from collections.abc import Callable

    from amrmetrics._types import ArrayLike

# How the name of a column ends, the unit in which it is reported, and its factor.
UNITS = {
    "percent": ("%", 1.0),
    "bytes": ("bytes", 1.0),
    "kb": ("bytes", 1e3),
    "mb": ("bytes", 1e6),
    "gb": ("bytes", 1e9),
    "kib": ("bytes", 2.0**10),
    "mib": ("bytes", 2.0**20),
    "gib": ("bytes", 2.0**30),
    "w": ("W", 1.0),
    "mw": ("W", 1e-3),
    "celsius": ("celsius", 1.0),
}
STAMPS = ("time", "stamp", "stamps", "timestamp")
JOULES_PER_WATT_HOUR = 3600.0


@dataclass(frozen=True, eq=False, repr=False)
class Measurement(Result):
    """What `measure` found in one block of a program.

    Attributes
    ----------
    n : int
        Number of finished frames.
    interrupted : int
        Frames that ended with an exception; their times are not among the durations.
    unit : str
        "s", of all times.
    durations : (n,) array
        Wall time of each frame.
    processor_times : (n,) array
        Processor time of each frame, all threads of the process added up.
    starts : (n,) array
        When each frame began, counted from the beginning of the block.
    elapsed : float
        Wall time of the block, what lies between the frames included.
    cpu_share : float
        Processor time per wall time inside the frames: 1 is one busy core, more than 1 several
        threads, less that frames wait; nan without frames.
    peak_memory : float
        Most memory that the process has had in use since it began, in bytes; nan where the
        system does not tell.
    peak_before : float
        The same when the block began. If it is equal, the peak lies before the block.
    undefined : dict
        For each number that is nan, the reason.
    """

    n: int
    interrupted: int
    unit: str
    durations: np.ndarray
    processor_times: np.ndarray
    starts: np.ndarray
    elapsed: float
    cpu_share: float
    peak_memory: float
    peak_before: float
    undefined: dict

    def __repr__(self):
        left_out = f", {self.interrupted} interrupted" if self.interrupted else ""
        return (
            f"{self.n} frames in {self.elapsed:.6g} s{left_out}, {self.durations.sum():.6g} s "
            f"inside them, CPU share {self.cpu_share:.3g} cores, peak memory "
            f"{self.peak_memory / 1e6:.6g} MB ({self.peak_before / 1e6:.6g} MB before)"
            + "".join(f"; {why}" for why in dict.fromkeys(self.undefined.values()))
        )


class Recorder:
    """Takes the times of frames inside a ``with`` block; `measure` makes one.

    One recorder is for one thread, and a frame does not begin inside another.
    """

    def __init__(self, clock, processor_clock):
        self._clock, self._processor_clock = clock, processor_clock
        # Three doubles a frame: a list of tuples would itself take the memory that is measured.
        self._rows, self._frame, self._interrupted = array("d"), _Frame(self), 0
        self._began = self._ended = None

    def __enter__(self):
        self._peak_before = _peak_memory()
        self._began = self._clock()
        return self

    def __exit__(self, *exception):
        self._ended = self._clock()
        self._peak = _peak_memory()

    def frame(self):
        """Return the context of one frame: ``with log.frame(): step()``."""
        return self._frame

    @property
    def durations(self):
        """Wall time of each finished frame so far, (n,) array of seconds."""
        return self._table()[:, 2]

    @property
    def result(self):
        """The `Measurement`, once the block has ended."""
        if self._ended is None:
            raise AmrError("the measurement has not ended: take the result after the with block.")
        starts, processor_times, durations = self._table().T
        busy, undefined = durations.sum(), {}
        if not busy > 0:
            undefined["cpu_share"] = "no frame took any time" if len(starts) else "no frame"
        if not self._peak > 0:
            why = "this system does not tell the peak memory"
            undefined |= {"peak_memory": why, "peak_before": why}
        return Measurement(
            n=len(starts),
            interrupted=self._interrupted,
            unit="s",
            durations=durations,
            processor_times=processor_times,
            starts=starts - self._began,
            elapsed=self._ended - self._began,
            cpu_share=float(processor_times.sum() / busy) if busy > 0 else float("nan"),
            peak_memory=self._peak,
            peak_before=self._peak_before,
            undefined=undefined,
        )

    def _table(self):
        return np.array(self._rows).reshape(-1, 3)


class _Frame:
    """One frame after the other; made once, so that a frame costs four looks at a clock."""

    __slots__ = ("_clock", "_cpu", "_log", "_processor_clock", "_start")

    def __init__(self, log):
        self._log, self._start = log, None
        self._clock, self._processor_clock = log._clock, log._processor_clock

    def __enter__(self):
        if self._start is not None:
            raise AmrError("a frame began inside another one; end the first before the second.")
        self._cpu = self._processor_clock()
        self._start = self._clock()

    def __exit__(self, kind, error, trace):
        end = self._clock()
        cpu = self._processor_clock() - self._cpu
        start, self._start = self._start, None
        if kind is None:
            self._log._rows.extend((start, cpu, end - start))
        else:
            self._log._interrupted += 1


def measure(
    clock: Callable[[], float] = time.perf_counter,
    processor_clock: Callable[[], float] = time.process_time,
) -> Recorder:
    """Log the wall time of each frame, the CPU share and the peak memory of this process.

    Parameters
    ----------
    clock : callable
        Gives seconds of wall time. The default is the finest clock that never goes back.
    processor_clock : callable
        Gives seconds of processor time of the process. The default adds up all threads;
        child processes are not in it.

    Returns
    -------
    Recorder
        For a ``with`` statement. Inside, ``with log.frame():`` around each frame; after it,
        ``log.durations`` for `latency` and ``log.result``, a `Measurement`. A frame costs
        a few microseconds (see ``course.py bench``), which weighs on the CPU share of frames
        below 0.1 ms.

    Raises
    ------
    AmrError
        If a clock cannot be called; later, if a frame begins inside another one or the result
        is taken before the block has ended.

    References
    ----------
    Lecture 08. Memory: VmHWM of proc(5) on Linux, ru_maxrss of getrusage(2) on macOS,
    PeakWorkingSetSize of GetProcessMemoryInfo on Windows.

    Examples
    --------
    >>> import amrmetrics as am
    >>> with am.measure() as log:
    ...     for k in range(5):
    ...         with log.frame():
    ...             _ = sum(range(10_000))
    >>> log.result.n, bool(log.durations.min() > 0)
    (5, True)
    """
    for name, value in (("clock", clock), ("processor_clock", processor_clock)):
        if not callable(value):
            raise AmrError(f"{name} is {value!r}; expected a function such as time.perf_counter.")
    return Recorder(clock, processor_clock)


def _peak_memory():
    """Return the most bytes that this process has had in memory; nan if nobody knows."""
    try:
        if sys.platform == "win32":
            return float(_windows_peak())
        if sys.platform.startswith("linux"):
            # Not ru_maxrss: it starts with the peak of the process that started this one.
            with open("/proc/self/status", "rb") as status:
                line = next(line for line in status if line.startswith(b"VmHWM:"))
            return 1024.0 * int(line.split()[1])
        import resource

        used = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        return float(used) if sys.platform == "darwin" else 1024.0 * used
    except (OSError, ImportError, AttributeError, StopIteration):
        return float("nan")


def _windows_peak():
    import ctypes

    names = ("peak", "now", "paged_peak", "paged", "pool_peak", "pool", "file", "file_peak")

    class Counters(ctypes.Structure):
        _fields_ = [("size", ctypes.c_uint32), ("faults", ctypes.c_uint32)] + [
            (name, ctypes.c_size_t) for name in names
        ]

    counters = Counters()
    counters.size = ctypes.sizeof(Counters)
    kernel = ctypes.WinDLL("kernel32", use_last_error=True)
    kernel.GetCurrentProcess.restype = ctypes.c_void_p
    ask = kernel.K32GetProcessMemoryInfo
    ask.argtypes = [ctypes.c_void_p, ctypes.POINTER(Counters), ctypes.c_uint32]
    if not ask(kernel.GetCurrentProcess(), ctypes.byref(counters), counters.size):
        raise OSError("the memory counters of this process cannot be read")
    return counters.peak


@dataclass(frozen=True, eq=False, repr=False)
class Energy(Number):
    """Energy from a power log; converts to joules with ``float()``.

    Attributes
    ----------
    joules, watt_hours : float
        The integral of the power.
    mean_power, max_power : float
        Watts, over `duration` and of the samples in it.
    duration : float
        Seconds that were integrated.
    per_frame : float
        Joules per frame; nan if no number of frames was given.
    n : int
        Samples of the log inside the limits.
    longest_gap : float
        Seconds between the two neighboring samples that lie farthest apart: in between, power
        is taken to change along a line.
    undefined : dict
        For each number that is nan, the reason.
    """

    joules: float
    watt_hours: float
    mean_power: float
    max_power: float
    duration: float
    per_frame: float
    n: int
    longest_gap: float
    undefined: dict

    def __float__(self):
        return self.joules

    def __repr__(self):
        frame = f", {self.per_frame:.6g} J per frame" if self.per_frame == self.per_frame else ""
        return (
            f"{self.joules:.6g} J ({self.watt_hours:.6g} Wh) in {self.duration:.6g} s, mean "
            f"{self.mean_power:.6g} W, max {self.max_power:.6g} W{frame}, n {self.n}, longest gap "
            f"{self.longest_gap:.6g} s"
        )


def energy(
    stamps: ArrayLike,
    power: float,
    *,
    start: float | None = None,
    end: float | None = None,
    frames: int | None = None,
) -> Energy:
    """Integrate a power log by the trapezoidal rule.

    Parameters
    ----------
    stamps : (N,) array
        Seconds, increasing, N >= 2.
    power : (N,) array
        Watts that are consumed. Single samples may be negative (a motor that brakes), their
        mean may not.
    start, end : float, optional
        Seconds between which to integrate, inside the log; its first and last stamp if not
        given. Power at the limits is interpolated.
    frames : int, optional
        Number of frames that were worked on in this time, >= 1.

    Returns
    -------
    Energy
        Joules, watt hours, mean and largest power.

    Raises
    ------
    AmrError
        If stamps do not increase, shapes differ, a limit lies outside the log, or the mean
        power is negative.

    References
    ----------
    Lecture 08. Dahlquist and Bjorck, Numerical Methods in Scientific Computing I (2008),
    eq. (5.1.11): the trapezoidal rule.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.energy([0, 1, 3], [10, 20, 20])
    55 J (0.0152778 Wh) in 3 s, mean 18.3333 W, max 20 W, n 3, longest gap 2 s
    """
    t, watts = as_stamps(stamps, "stamps"), as_numbers(power, "power")
    if watts.shape != t.shape or len(t) < 2:
        raise AmrError(
            f"power has shape {watts.shape} and stamps {t.shape}; expected (N,) both, N >= 2."
        )
    begin = _limit(start, t[0], t, "start")
    finish = _limit(end, t[-1], t, "end")
    if begin >= finish:
        raise AmrError(f"start is {begin:g} s and end {finish:g} s; start must come first.")
    inside = (t >= begin) & (t <= finish)
    between = (t > begin) & (t < finish)
    T = np.r_[begin, t[between], finish]
    P = np.interp(T, t, watts)
    joules = float(((P[1:] + P[:-1]) / 2 * np.diff(T)).sum())
    if joules < 0:
        raise AmrError(
            f"power is {joules / (finish - begin):g} W on average; what is consumed is positive. "
            "A battery that counts its own charge has the other sign: use -power."
        )
    undefined = {}
    if frames is None:
        per_frame, undefined["per_frame"] = float("nan"), "no number of frames was given"
    else:
        per_frame = joules / as_count(frames, "frames")
    around = slice(np.searchsorted(t, begin, "right") - 1, np.searchsorted(t, finish) + 1)
    return Energy(
        joules=joules,
        watt_hours=joules / JOULES_PER_WATT_HOUR,
        mean_power=joules / (finish - begin),
        max_power=float(P.max()),
        duration=finish - begin,
        per_frame=per_frame,
        n=int(inside.sum()),
        longest_gap=float(np.diff(t[around]).max()),
        undefined=undefined,
    )


def _limit(value, default, t, name):
    limit = float(default if value is None else as_size(value, name, sign=""))
    if not t[0] <= limit <= t[-1]:
        raise AmrError(
            f"{name} is {limit:g} s, outside the log, which covers {t[0]:g} s to {t[-1]:g} s."
        )
    return limit


@dataclass(frozen=True, eq=False, repr=False)
class ResourceUse(Result):
    """Mean, 95th percentile and maximum of each column of a log.

    Attributes
    ----------
    mean, p95, max : dict of float
        For each column, by its name in the log. The mean is over time, so that samples that
        stand close together do not count double; the 95th percentile is over the samples.
    unit : dict of str
        For each column: "%", "bytes", "W" or "celsius".
    duration : float
        Seconds between the first and the last sample.
    n : int
        Number of samples.
    """

    mean: dict
    p95: dict
    max: dict
    unit: dict
    duration: float
    n: int

    def __repr__(self):
        columns = (
            f"{name}: mean {self.mean[name]:.6g}, P95 {self.p95[name]:.6g}, max "
            f"{self.max[name]:.6g} {unit}"
            for name, unit in self.unit.items()
        )
        return "; ".join(columns) + f"; n {self.n} in {self.duration:.6g} s"


def resource_use(log: Any) -> ResourceUse:
    """Summarize a log of processor, graphics processor, memory or power by its named columns.

    Parameters
    ----------
    log : mapping or structured array
        Columns by name, all of one length (N,), N >= 2: a dictionary of arrays, a table of
        pandas, or what ``numpy.genfromtxt(path, delimiter=",", names=True)`` returns. One is
        called ``time`` (or stamp, stamps, timestamp) and holds increasing seconds. The names
        of the others end with their unit: ``_percent``, ``_bytes``, ``_kB``, ``_MB``,
        ``_GB``, ``_KiB``, ``_MiB``, ``_GiB``, ``_W``, ``_mW``, ``_celsius``. A percentage may
        exceed 100 where several cores are added up.

    Returns
    -------
    ResourceUse
        Memory in bytes, power in watts, whatever the columns use.

    Raises
    ------
    AmrError
        If there is no column of stamps or no other, a name does not say its unit, lengths
        differ, or a value is not finite or, but for power and temperature, negative.

    References
    ----------
    Lecture 08; the mean over time is the trapezoidal rule, as in `energy`.

    Examples
    --------
    >>> import amrmetrics as am
    >>> log = {"time": [0, 1, 2], "cpu_percent": [100, 140, 100], "memory_MB": [200, 210, 220]}
    >>> use = am.resource_use(log)
    >>> use.mean["cpu_percent"], use.max["memory_MB"], use.unit["memory_MB"]
    (120.0, 220000000.0, 'bytes')
    """
    names = getattr(getattr(log, "dtype", None), "names", None)
    names = [str(name) for name in names or (log if hasattr(log, "keys") else ())]
    clocks = [name for name in names if name.lower() in STAMPS]
    if len(clocks) != 1 or len(names) < 2:
        raise AmrError(
            f"log has the columns {names}; expected one called 'time' and others such as "
            "'cpu_percent' and 'memory_MB'."
        )
    t = as_stamps(as_array(log[clocks[0]], clocks[0]), clocks[0])
    if len(t) < 2:
        raise AmrError("log has a single sample; a mean over time needs at least 2.")
    mean, p95, largest, unit = {}, {}, {}, {}
    for name in names:
        if name == clocks[0]:
            continue
        unit[name], factor = _unit(name)
        values = as_numbers(as_array(log[name], name), name)
        if values.shape != t.shape:
            raise AmrError(f"{name} has shape {values.shape}; {clocks[0]} has {t.shape}.")
        if unit[name] in ("%", "bytes") and values.min() < 0:
            k = int(np.argmin(values))
            raise AmrError(f"{name}[{k}] is {values[k]:g}; a use cannot be negative.")
        values = factor * values
        total = ((values[1:] + values[:-1]) / 2 * np.diff(t)).sum()
        mean[name] = float(total / (t[-1] - t[0]))
        p95[name], largest[name] = float(np.percentile(values, 95)), float(values.max())
    return ResourceUse(mean, p95, largest, unit, float(t[-1] - t[0]), len(t))


def _unit(name):
    ending = name.rsplit("_", 1)[-1].lower()
    if "_" not in name or ending not in UNITS:
        raise AmrError(
            f"column {name!r} does not say its unit; rename it so that it ends with one, such as "
            f"{name}_percent, {name}_MB or {name}_W."
        )
    return UNITS[ending]
