"""Time limits that hold in any thread and on any system: no signals."""

import ctypes
import threading


class TimeUp(BaseException):
    """Raised inside the guarded call; not an Exception, so that no library swallows it."""


def bounded(call, seconds):
    """Return ``(True, call())``, or ``(False, None)`` if it takes longer than `seconds`."""
    thread = threading.get_ident()
    inject = ctypes.pythonapi.PyThreadState_SetAsyncExc
    lock, over, done = threading.Lock(), threading.Event(), False

    def watch():
        pause = seconds
        while not over.wait(pause):
            with lock:
                if done:
                    return
                inject(ctypes.c_ulong(thread), ctypes.py_object(TimeUp))
            pause = 0.25  # somebody may have swallowed it: try again

    def stop():
        nonlocal done
        while True:
            try:
                with lock:
                    done = True
                inject(ctypes.c_ulong(thread), None)  # one that is still on its way must not arrive
                over.set()
                return
            except TimeUp:
                continue

    threading.Thread(target=watch, daemon=True).start()
    try:
        try:
            return True, call()
        finally:
            stop()
    except TimeUp:
        stop()
        from sympy.core.cache import clear_cache

        clear_cache()  # an interrupted deduction leaves half-filled assumptions behind
        return False, None
