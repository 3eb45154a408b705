"""Limits of work that need no thread and no signal, so that they hold in a browser as well.

A guarded call is watched by Python's profile hook: it counts calls and returns, which are the same
on every machine, and stops the work when there are too many. Now and then it looks at the clock,
so that a slow machine stops, too.
"""

import sys
import time
from inspect import CO_GENERATOR

EVENTS = 4_000_000  # calls and returns in a second of an ordinary machine
CHUNK = 64


class TimeUp(BaseException):
    """Raised inside the guarded call; not an Exception, so that no library swallows it."""

    def __init__(self, watch):
        super().__init__("too much work")
        self.watch = watch


class _Watch:
    """The hook of one guarded call; it charges the guarded calls around it as well."""

    def __init__(self, seconds, wall, outer):
        self.left, self.end = seconds * EVENTS, time.monotonic() + wall
        self.outer = outer if isinstance(outer, _Watch) else None
        self.since, self.over = 0, False

    def __call__(self, frame, event, argument):
        if self.over:  # the call has returned: what ends the watch must not be stopped
            return
        self.since += 1
        # An exception that arrives while a generator is being closed would be lost, with a message.
        begins = event in ("call", "c_call") and not frame.f_code.co_flags & CO_GENERATOR
        if self.since >= CHUNK and begins:
            self.since = 0
            self.charge(time.monotonic())

    def charge(self, now):
        if self.outer:
            self.outer.charge(now)
        self.left -= CHUNK
        if self.left < 0 or now > self.end:
            raise TimeUp(self)


LIBRARIES = ("sympy", "mpmath")


def bounded(call, seconds, wall=None):
    """Return ``(True, call())``, or ``(False, None)`` if that is more than `seconds` of work.

    At most `wall` seconds by the clock (four times as many, if not given). A guarded call inside
    another one keeps the limits of both. If SymPy gives up with an exception of its own, the answer
    is ``(False, None)``, too; an exception that this package raises is a mistake in it, and passes.
    """
    before = sys.getprofile()
    watch = _Watch(seconds, 4 * seconds if wall is None else wall, before)
    sys.setprofile(watch)
    try:
        return True, call()
    except TimeUp as up:
        if up.watch is not watch:
            raise
        return False, None
    except Exception as error:
        if _raised_in(error) not in LIBRARIES:
            raise
        return False, None
    finally:
        watch.over = True
        if callable(before) or before is None:
            sys.setprofile(before)
        else:  # a profiler of the standard library, which is no function
            sys.setprofile(None)
            before.enable()


def _raised_in(error):
    """Return the package in whose code an exception was raised."""
    place = error.__traceback__
    while place.tb_next:
        place = place.tb_next
    return place.tb_frame.f_globals.get("__name__", "").split(".")[0]
