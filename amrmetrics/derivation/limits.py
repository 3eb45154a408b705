"""Time limits that hold in any thread and on any system: no signals.

A second thread raises `TimeUp` in the first one when the time is up. That exception can arrive
between any two instructions, so nothing here may hold a lock in Python code, nor wait in one: the
two threads share two flags and one plain lock, and each operation on them is a single call.

Where the system tells the computing time of a thread, that is what is limited, so that a busy
machine gives the same verdicts; a longer limit on the time by the clock holds everywhere.
"""

import _thread
import ctypes
import sys
import threading
import time


class TimeUp(BaseException):
    """Raised inside the guarded call; not an Exception, so that no library swallows it."""


class _Watch:
    def __init__(self, seconds, wall):
        self.thread, self.seconds = threading.get_ident(), seconds
        self.begin, self.wall = time.monotonic(), wall
        try:
            self.clock = time.pthread_getcpuclockid(self.thread)
            self.used = time.clock_gettime(self.clock)
        except (AttributeError, OSError):
            self.clock, self.wall = None, seconds
        self.off = self.launched = self.fired = self.ended = False
        self.wire = _thread.allocate_lock()
        self.wire.acquire()

    def start(self):
        self.launched = bool(_thread.start_new_thread(self._watch, ()))

    def _inject(self, what):
        ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(self.thread), what)

    def _left(self):
        wall = self.begin + self.wall - time.monotonic()
        if self.clock is None:
            return wall
        return min(wall, self.used + self.seconds - time.clock_gettime(self.clock))

    def _watch(self):
        pause = self.seconds
        while not self.wire.acquire(timeout=pause):
            if self.off:
                break
            pause = self._left()
            if pause <= 0:
                self.fired = True
                self._inject(ctypes.py_object(TimeUp))
                pause = 0.25  # somebody may have swallowed it: try again
            pause = max(pause, 0.01)
        self.ended = True

    def stop(self):
        """Return when nothing can arrive any more; may be called again if interrupted itself."""
        self.off = True
        if self.wire.locked() and not self.ended:
            self.wire.release()
        while self.launched and not self.ended:
            time.sleep(0.0002)
        if self.fired:
            self._inject(None)  # one that is still on its way must not arrive


def bounded(call, seconds, wall=None):
    """Return ``(True, call())``, or ``(False, None)`` if it takes longer than `seconds`.

    These are seconds of computing, where the system tells them, and at most `wall` seconds by the
    clock (three times as many, if not given).
    """
    watch = _Watch(seconds, 3 * seconds if wall is None else wall)
    outcome, error, begun = (False, None), None, False
    hook = sys.unraisablehook
    # Where it arrives in a destructor or a callback, it is lost, and a message with it.
    sys.unraisablehook = lambda lost: None if lost.exc_type is TimeUp else hook(lost)
    while True:
        try:
            if not begun:
                begun = True
                watch.start()
                outcome = True, call()
            watch.stop()
            break
        except TimeUp:
            continue
        except BaseException as other:
            error = other
    sys.unraisablehook = hook
    if error is not None:
        raise error
    if not outcome[0] and not watch.fired:
        raise TimeUp  # it was meant for a call further out
    if not outcome[0]:
        from sympy.core.cache import clear_cache

        clear_cache()  # an interrupted deduction leaves half-filled assumptions behind
    return outcome
