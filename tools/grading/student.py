"""The process in which a student's code runs, and those that start, watch and end it.

`zygote` imports what students use and then forks, on demand, a guard. The guard leaves the
namespaces, forks the student's process and ends it when nobody wants it any more. Neither has
ever seen a solution, so there is none to be found in memory either.
"""

import contextlib
import importlib
import json
import os
import pkgutil
import select
import signal
import socket
import sys
import tempfile
import time
import types

from grading import isolation, wire

USED = ("IPython.core.interactiveshell", "matplotlib.pyplot", "sympy", "scipy.stats",
        "scipy.optimize", "scipy.spatial.transform", "scipy.linalg", "amrmetrics.check",
        "amrmetrics.derivation.written", "amrmetrics.benchmark._child", "json", "csv", "ctypes",
        "cloudpickle")  # fmt: skip


def preload():
    """Import what submissions use: it is done once, and no file of the library is needed later."""
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for name in USED:
            importlib.import_module(name)
        import amrmetrics

        for module in pkgutil.walk_packages(amrmetrics.__path__, "amrmetrics."):
            if "__main__" not in module.name:
                with contextlib.suppress(ImportError):
                    importlib.import_module(module.name)
        for name in dir(amrmetrics):
            getattr(amrmetrics, name, None)
        shell = new_shell()
        shell.run_cell("pass", store_history=False)
        type(shell).clear_instance()
    from amrmetrics.benchmark import running

    running._in_a_process = in_a_fork


def new_shell():
    """Return what runs the cells of a notebook."""
    from IPython.core.interactiveshell import InteractiveShell
    from traitlets.config import Config

    class Shell(InteractiveShell):
        def enable_gui(self, gui=None):
            pass

    settings = Config()
    settings.HistoryManager.enabled = False
    settings.HistoryManager.hist_file = ":memory:"
    settings.InteractiveShell.colors = "nocolor"
    settings.InteractiveShell.cache_size = 0
    return Shell.instance(config=settings)


def in_a_fork(scratch, time_limit, run):
    """Run a trial of a benchmark in a fork, in place of a program that imports everything again.

    That takes a tenth of the time, and there is no file of the library where students' code runs.
    """
    from amrmetrics.benchmark import _child, running

    here = os.path.join(scratch, "here")
    wanted, line = os.pipe()
    with tempfile.TemporaryFile(dir=scratch) as output:
        pid = os.fork()
        if pid == 0:
            with contextlib.suppress(BaseException):
                os.setsid()
                for stream, target in ((wanted, 0), (output.fileno(), 1), (output.fileno(), 2)):
                    os.dup2(stream, target)
                os.closerange(3, 4096)
                sys.stdin, sys.stdout = os.fdopen(0), os.fdopen(1, "w")
                sys.stderr = os.fdopen(2, "w", buffering=1)
                os.chdir(here)
                os.environ |= running._environment(here)
                _child.limit = lambda memory: None  # what is imported would count, too
                _child.main(scratch)
            os._exit(0)
        os.close(wanted)
        end = time.monotonic() + time_limit + running.GRACE
        while not (ended := os.waitpid(pid, os.WNOHANG)[0]) and time.monotonic() < end:
            time.sleep(0.005)
        if not ended:
            with contextlib.suppress(OSError):
                os.killpg(pid, signal.SIGKILL)
            os.waitpid(pid, 0)
        os.close(line)
        output.seek(0)
        return output.read()[-running.OUTPUT_KEPT :], not ended


def zygote(line):
    """Fork a guard for each order that comes with two sockets; end when the line is cut."""
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    while True:
        data, sockets, _, _ = socket.recv_fds(line, 1 << 16, 2)
        if not data:
            os._exit(0)
        if os.fork() == 0:
            code = 1
            with contextlib.suppress(BaseException):
                line.close()
                guard(json.loads(data), *(socket.socket(fileno=s) for s in sockets))
                code = 0
            os._exit(code)
        for s in sockets:
            os.close(s)


def guard(order, talk, control):
    """Start a student's process and say how it ended; end it when the control line is cut."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    os.setsid()
    level = isolation.separate()
    pid = os.fork()
    if pid == 0:
        control.close()
        student(level, order, talk)
    talk.close()
    control.sendall(json.dumps({"level": level, "pid": pid}).encode() + b"\n")
    ended = 0
    while not ended:
        ended, status = os.waitpid(pid, os.WNOHANG)
        if not ended and select.select([control], [], [], 0.02)[0]:
            break
    if not ended:
        for kill in (os.killpg, os.kill):
            with contextlib.suppress(OSError):
                kill(pid, signal.SIGKILL)
        _, status = os.waitpid(pid, 0)
    with contextlib.suppress(OSError):  # what is left in its group, where there is no namespace
        os.killpg(pid, signal.SIGKILL)
    with contextlib.suppress(OSError):
        code = os.waitstatus_to_exitcode(status)
        control.sendall(json.dumps({"exit": code}).encode() + b"\n")


def student(level, order, talk):
    """Become the student's process. This never returns."""
    try:
        os.setpgid(0, 0)
        kept = os.dup(talk.fileno())
        nothing = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(nothing, stream)
        line = os.dup2(kept, 3)
        os.closerange(4, 4096)
        talk = socket.socket(fileno=line)
        isolation.enclose(level, order)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGCHLD):
            signal.signal(number, signal.SIG_DFL)
        Student(talk, order).serve()
    finally:
        os._exit(0)


class Student:
    """Runs cells and functions of a student when asked, and hands over what they make."""

    def __init__(self, line, order):
        self.shell = new_shell()
        # A notebook's cells run in __main__, where pickle and multiprocessing look for them.
        main = types.ModuleType("__main__")
        self.shell.user_module = sys.modules["__main__"] = main
        main.__dict__.update(self.shell.user_ns)
        self.shell.user_ns = main.__dict__
        self.home = os.getcwd()
        tempfile.tempdir = None  # it may be known from before, as a folder of the grader's
        sys.path.insert(0, self.home)
        self.peer = wire.Peer(line, self.answer)
        self.peer.memory = {}
        self.recursion = sys.getrecursionlimit()

    def serve(self):
        self.peer.serve()

    def answer(self, asked):
        own = os.getpid()
        if sys.getrecursionlimit() < self.recursion:
            sys.setrecursionlimit(self.recursion)
        for number, name in enumerate(("stdin", "stdout", "stderr")):
            if getattr(getattr(sys, name), "closed", True):
                setattr(sys, name, os.fdopen(number, "w" if number else "r", closefd=False))
        said = getattr(self, "do_" + asked["do"])(asked)
        if os.getpid() != own:  # the code forked, and this is the copy
            os._exit(0)
        return said

    def do_run(self, asked):
        """Run a cell and say what it raised."""
        try:
            result = self.shell.run_cell(asked["source"], store_history=False)
            error = result.error_before_exec or result.error_in_exec
        except BaseException as raised:  # IPython itself stumbled: over what a student changed
            error = raised
        return {"error": wire.written_error(error) if error is not None else None}

    def do_restore(self, asked):
        from amrmetrics import check

        with contextlib.suppress(Exception):
            check.restore(self.shell.user_ns)
        return {}

    def do_take_away(self, asked):
        """Let functions of the library refuse, by whatever name they are known."""
        for place in asked["names"]:
            refuse(place)
        return {}

    def do_names(self, asked):
        space = self.shell.user_ns
        values = {n: self.peer.write(space[n]) for n in asked["names"] if n in space}
        return {"values": values, "folders": wire.folders_in(values, self.home)}

    def do_files(self, asked):
        """Write files that the arguments of the next call name."""
        import base64

        for path, data in asked["files"].items():
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "wb") as file:
                file.write(base64.b64decode(data))
        return {}

    def do_call(self, asked):
        return self.peer.answer_call(self.peer.own[asked["of"]], asked)


REFUSAL = """
def refuse(*arguments, **options):
    from amrmetrics.check import NotYet
    raise NotYet({said!r})
"""


def refuse(place):
    """Empty a function of the library, or a class, so that no reference to it is of use.

    With it goes what does its work in the same module and is not offered to users: by that,
    another function of the library would have the answer as well.
    """
    module, _, name = place.partition(":")
    target = sys.modules[module]
    for part in name.split("."):
        target = getattr(target, part)
    from amrmetrics.check import workers_of

    workers = [] if isinstance(target, type) else workers_of(target) or [target]
    said = f"the library's {name} would do your work here; do without it."
    made = {}
    exec(REFUSAL.format(said=said), made)
    if isinstance(target, type):
        methods = (vars(target).get(name) for name in ("__init__", "__new__", "__post_init__"))
        workers += [method for method in methods if isinstance(method, types.FunctionType)]
    for function in workers:
        empty(function, made["refuse"])


def empty(function, refusal):
    while function is not None:
        for cell in getattr(function, "__closure__", None) or ():
            cell.cell_contents = refusal
        with contextlib.suppress(ValueError, AttributeError):
            function.__code__ = refusal.__code__
            function.__defaults__ = function.__kwdefaults__ = None
        function = getattr(function, "__wrapped__", None)
