"""Submissions that are clumsy or hostile, and what each of them has to be worth.

Each builds the bytes of a notebook from the solved exercise (``solved``) or from the untouched one
with a trick in it (``tricked``).
"""

import copy
import json
from dataclasses import dataclass

from exercise import ProblemSet, grade_id

NAME = "02_alignment"
SET = ProblemSet(NAME)
POINTS = {"part-a": 2, "part-b": 3, "part-c": 4, "part-d": 4, "part-e": 2, "part-f": 3}
FULL = sum(POINTS.values())


@dataclass(frozen=True)
class Kind:
    name: str
    data: bytes
    points: float
    opened: tuple = ()
    says: str = ""
    quick: bool = False
    file: str = f"{NAME}/{NAME}.ipynb"


def notebook(answers):
    made = copy.deepcopy(SET.exercise)
    for cell in made.cells:
        cell.source = answers.get(grade_id(cell), cell.source)
    return made


def as_dict(made):
    return json.loads(json.dumps(made))


def text_of(made):
    return json.dumps(made, indent=1, ensure_ascii=False)


def solved(change=None, answers=None):
    made = as_dict(notebook(SET.official | (answers or {})))
    made["cells"][-1]["source"] += "\n\nRigid: wheels measure meters, $s=1$."
    if change:
        change(made["cells"])
    return made


def tricked(source, answers=None, after="setup"):
    """Return an untouched exercise with a cell of tricks after the one that is named."""
    made = as_dict(notebook(answers or {}))
    made["cells"].insert(place(made["cells"], after) + 1, scratch(source))
    return made


def scratch(source):
    return {
        "cell_type": "code",
        "metadata": {},
        "source": source,
        "outputs": [],
        "execution_count": None,
        "id": "scratch",
    }


def place(cells, name):
    return next(k for k, c in enumerate(cells) if named(c) == name)


def named(cell):
    return cell["metadata"].get("nbgrader", {}).get("grade_id")


def with_scratch(source, after="setup"):
    return solved(lambda cells: cells.insert(place(cells, after) + 1, scratch(source)))


def without(name):
    return solved(lambda cells: cells.pop(place(cells, name)))


def twice(name, source=None):
    def change(cells):
        k = place(cells, name)
        cells.insert(k + 1, copy.deepcopy(cells[k]))
        if source is not None:
            cells[k + 1]["source"] = source

    return solved(change)


def stripped(made):
    for cell in made["cells"]:
        cell["metadata"] = {}
    return made


def stub(name):
    return next(c.source for c in SET.exercise.cells if grade_id(c) == name)


def in_front(name, source):
    return solved(answers={name: source + "\n" + SET.official[name]})


def with_start(line):
    """Return the official function of part d, with a line in front of its body."""
    return SET.official["part-d"].replace("### BEGIN", line + "\n    ### BEGIN")


HEAVY = "x" * 100
ALIGN = """
def align_2d(reference, estimate{extra}):
    if np.ptp(reference, axis=0).max() == 0 or np.ptp(estimate, axis=0).max() == 0:
        raise ValueError
    {body}
"""


def align(body, extra=""):
    return {"part-d": ALIGN.format(body=body, extra=extra)}


def kinds():
    """Yield every kind; files first, then what code does to its process, then tricks."""
    good = text_of(solved())
    yield Kind("good", good.encode(), FULL, quick=True)
    yield Kind("untouched", text_of(tricked("")).encode(), 0, quick=True)
    yield from files(good)
    yield from processes()
    yield from tricks()


def files(good):
    def kind(name, data, *rest, **more):
        data = data if isinstance(data, bytes) else text_of(data).encode()
        return Kind(name, data, *rest, **more)

    yield kind("twice a", twice("part-a"), FULL, says="2 cells for part-a", quick=True)
    yield kind("twice a, stub below", twice("part-a", stub("part-a")), FULL, says="2 cells")
    yield kind("twice prose", twice("prose-g"), FULL)
    yield kind("twice check", twice("check-b"), FULL)
    yield kind("twice setup", twice("setup"), FULL)
    yield kind("twice everything", solved(lambda c: c.extend(copy.deepcopy(c))), FULL)
    yield kind("renamed", good.encode(), FULL, file="my alignment homework.ipynb", quick=True)
    yield kind("numbered", good.encode(), FULL, file=f"{NAME}/{NAME} (1).ipynb")
    yield kind("upper case", good.encode(), FULL, file=f"{NAME.upper()}.IPYNB")
    half = good[: good.index("catches_reflection(align)")]
    yield kind("truncated", half.encode(), FULL - 3, ("part-f",), "damaged", quick=True)
    everything = tuple(POINTS)
    yield kind("empty", b"", 0, everything, "empty", quick=True)
    yield kind("blanks", b" \n\0\0\n", 0, everything, "empty")
    yield kind("web page", b"<!DOCTYPE html><html></html>", 0, everything, "web page")
    yield kind("a list", b"[1, 2, 3]", 0, everything, "no notebook")
    yield kind("nested", b"[" * 200_000, 0, everything, "not graded")
    yield kind("nbformat 5", solved() | {"nbformat": 5}, FULL, says="nbformat 5", quick=True)
    yield kind("no nbformat", {"cells": solved()["cells"]}, FULL)
    yield kind("UTF-16", good.encode("utf-16"), FULL, says="UTF-16", quick=True)
    yield kind("UTF-16 without a mark", good.encode("utf-16-le"), FULL, says="UTF-16")
    western = good.replace("# C = -18", "# für C = -18").encode("cp1252", "replace")
    yield kind("cp1252", western, FULL, says="CP1252", quick=True)
    yield kind("BOM", good.encode("utf-8-sig"), FULL)
    yield kind("metadata stripped", stripped(solved()), FULL, says="recognized", quick=True)
    yield kind("without check", without("check-a"), FULL)
    yield kind("without setup", without("setup"), FULL)
    missing = "its cell is missing"
    yield kind("without part", without("part-d"), FULL - 4, ("part-d",), missing, quick=True)
    edited = solved(lambda c: c[place(c, "check-e")].update(source="print('Part e holds.')"))
    yield kind("edited check", edited, FULL, says="check-e")
    answers = {"part-e": stub("part-e")}
    wrong = solved(lambda c: c[place(c, "check-e")].update(source="pass"), answers)
    yield kind("edited check, no answer", wrong, FULL - 2, says="check-e")
    lines = solved(lambda c: [cell.update(source=cell["source"].splitlines(True)) for cell in c])
    yield kind("sources as lists", lines, FULL)
    outputs = [{"output_type": "stream", "name": "stdout", "text": HEAVY * 200_000}]
    large = solved(lambda c: c[place(c, "part-a")].update(outputs=outputs))
    yield kind("20 MB of outputs", large, FULL)
    nonsense = solved(lambda c: c.extend([None, 3, "cell", {"cell_type": 5}, {"source": 7}]))
    yield kind("cells that are none", nonsense, FULL)
    turned = solved(lambda c: c[place(c, "part-e")].update(cell_type="markdown"))
    yield kind("answer as text", turned, FULL - 2, ("part-e",), "another kind")


FORKS = """
import os
for _ in range(10_000):
    try:
        os.fork()
    except OSError:
        pass
"""
SWALLOW = """
while True:
    try:
        while True:
            pass
    except BaseException:
        pass
"""
DEAF = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\nwhile True:\n    pass"
DAEMON = "import os, time\nif os.fork() == 0:\n    os.setsid()\n    time.sleep(999)"
GROW = "grown = []\nwhile True:\n    grown.append(bytes(10_000_000))"
FILL = "for k in range(10**6):\n    open(f'f{k}', 'wb').write(bytes(10**6))"


def processes():
    def kind(name, made, *rest, **more):
        return Kind(name, text_of(made).encode(), *rest, **more)

    a_open = FULL - 2, ("part-a",)
    yield kind("os._exit", in_front("part-a", "import os\nos._exit(3)"), *a_open, "exit code 3",
               quick=True)  # fmt: skip
    yield kind("sys.exit", in_front("part-a", "import sys\nsys.exit()"), FULL - 2)
    yield kind("abort", in_front("part-a", "import os\nos.abort()"), *a_open, "ended its process")
    fault = "import ctypes\nctypes.string_at(0)"
    yield kind("memory fault", in_front("part-a", fault), *a_open, "ended its process")
    killed = with_scratch("import os, signal\nos.kill(os.getpid(), 9)")
    yield kind("SIGKILL", killed, FULL)
    yield kind("kills all", with_scratch("import os\nos.kill(-1, 9)"), FULL)
    yield kind("endless", in_front("part-a", "while True:\n    pass"), *a_open, "still running",
               quick=True)  # fmt: skip
    yield kind("deaf", with_scratch(DEAF), FULL, says="still running")
    yield kind("swallowed", with_scratch(SWALLOW, "part-c"), FULL, says="still running")
    endless = SET.official["part-d"].replace(
        "### BEGIN", "while True:\n        pass\n    ### BEGIN"
    )
    yield kind("endless function", solved(answers={"part-d": endless}), FULL - 4, ("part-d",),
               "still running")  # fmt: skip
    leaving = SET.official["part-d"].replace(
        "### BEGIN", "__import__('os')._exit(0)\n    ### BEGIN"
    )
    yield kind("function that exits", solved(answers={"part-d": leaving}), FULL - 4, ("part-d",),
               "ended its process")  # fmt: skip
    slow = with_start("__import__('time').sleep(0.3)")
    yield kind("slow function", solved(answers={"part-d": slow}), FULL)
    recursion = with_start("return align_2d(reference, estimate)")
    yield kind("recursion", solved(answers={"part-d": recursion}), FULL - 4)
    deep = (
        "for _ in range(3):\n        align(*np.ones((2, 4, 2)))\n        catches_reflection(align)"
    )
    deep = SET.official["part-f"].replace("### BEGIN", deep + "\n    ### BEGIN")
    yield kind("recursion that calls", solved(answers={"part-f": deep}), FULL - 3, quick=True)
    yield kind("grows", with_scratch(GROW), FULL, says="memory", quick=True)
    yield kind("200 MB printed", with_scratch("print('x' * 200_000_000)"), FULL, quick=True)
    yield kind("fills the disk", with_scratch(FILL), FULL, quick=True)
    yield kind("forks", with_scratch(FORKS), FULL)
    yield kind("daemon", with_scratch(DAEMON), FULL)
    threads = "import threading\nfor _ in range(9999): threading.Thread(target=input).start()"
    yield kind("threads", with_scratch(threads), FULL)
    yield kind("print returns", with_scratch("print = lambda *a, **k: 1"), FULL, quick=True)
    yield kind("input", with_scratch("input('?')"), FULL)
    noise = "import warnings\nwarnings.simplefilter('error')\nnp.seterr(all='raise')"
    yield kind("warnings as errors", with_scratch(noise), FULL)
    magic = "%matplotlib inline\nimport matplotlib.pyplot as plt\nplt.plot([1, 2])\n!ls"
    yield kind("magics and plots", with_scratch(magic), FULL, quick=True)
    names = "p = q = np = am = check = cloud = library = display = list = len = None"
    yield kind("names redefined", with_scratch(names, "part-f"), FULL - 3)
    yield kind("names taken", in_front("part-b", "del am, display\nnp = p_hat = None"), FULL)
    busy = "import threading\ndef spin():\n    while True: pass\n"
    busy += "threading.Thread(target=spin, daemon=True).start()"
    yield kind("a thread left running", with_scratch(busy), FULL)
    yield kind("signals ignored", with_scratch(SIGNALS), FULL, says="signals", quick=True)
    closed = "import sys\nsys.stdout.close()\nsys.stderr.close()\nsys.stdin.close()"
    yield kind("stdout closed", with_scratch(closed), FULL, quick=True)
    yield kind(
        "file descriptors closed",
        with_scratch("import os\nos.closerange(0, 99)"),
        FULL,
    )
    yield kind("no recursion left", with_scratch("import sys\nsys.setrecursionlimit(70)"), FULL)
    yield kind("traced", with_scratch(TRACED), FULL)
    yield kind("files removed", with_scratch("import os, shutil\nshutil.rmtree(os.getcwd())"), FULL)
    evil = "class Evil(BaseException): pass\nraise Evil"
    yield kind("strange exception", with_scratch(evil), FULL)
    evil = with_start("raise type('Evil', (BaseException,), {})")
    yield kind("function with it", solved(answers={"part-d": evil}), FULL - 4, quick=True)
    lazy = {"part-a": "theta_deg = (x for x in [126.87])\nt_star = J_min = map(float, '24')"}
    yield kind("generators", solved(answers=lazy), FULL - 2)
    itself = {"part-a": "theta_deg = []\ntheta_deg.append(theta_deg)\nt_star = J_min = theta_deg"}
    yield kind("contains itself", solved(answers=itself), FULL - 2)
    for name, source in ODD.items():
        yield kind(f"odd value: {name}", solved(answers={"part-a": source}), FULL - 2)
    lying = {"part-a": LYING}
    yield kind("hostile methods", solved(answers=lying), FULL - 2, quick=True)
    large = {"part-a": "theta_deg = 10 ** 10 ** 6\nt_star = [0] * 10**7\nJ_min = 'x' * 10**8"}
    yield kind("huge answers", solved(answers=large), FULL - 2, ("part-a",), "part-a")
    deep = {"part-a": "theta_deg = []\nfor _ in range(10**5):\n    theta_deg = [theta_deg]"}
    yield kind("nested answer", solved(answers=deep), FULL - 2)


SIGNALS = """
import signal
for number in range(1, 65):
    try:
        signal.signal(number, lambda *_: None)
    except (OSError, ValueError):
        pass
"""
TRACED = """
import sys, threading
def trace(frame, event, argument):
    return trace
sys.settrace(trace)
threading.settrace(trace)
"""
ODD = {
    name: f"theta_deg = {value}\nt_star = {value}\nJ_min = {value}"
    for name, value in {
        "dict": "{'a': 1}",
        "type": "dict",
        "module": "np",
        "nested": "[[1, 2], [3]]",
        "table": "np.zeros(3, dtype='i,f')",
        "date": "np.datetime64('2026-11-26')",
        "objects": "np.array([None, {}, 1j], dtype=object)",
        "empty": "[]",
        "SymPy": "__import__('sympy').Symbol('x')",
        "bytes": "b'126.87'",
    }.items()
}
LYING = """
class Lying:
    __class__ = property(lambda self: np.ndarray)
    def __len__(self): return 10**18
    def __array__(self, *a, **k): raise SystemExit
    def __eq__(self, other): raise KeyboardInterrupt
    def __hash__(self): raise GeneratorExit
    def __iter__(self):
        while True: yield 1
    def __repr__(self): raise SystemExit
    __float__ = __getattr__ = __bool__ = __array__
theta_deg = t_star = J_min = Lying()
"""
LAMBDAS = """
for name in list(vars(check)):
    if callable(getattr(check, name)):
        setattr(check, name, lambda *a, **k: None)
"""
MODULES = """
import sys, types
fake = types.ModuleType("amrmetrics.check")
fake.__getattr__ = lambda name: (lambda *a, **k: None)
sys.modules["amrmetrics.check"] = fake
am.check = check = fake
"""
SOLUTION = """
import glob, json
for place in ("../..", "/tmp", "/work", "/home", "/root"):
    for path in glob.glob(f"{place}/**/solutions/02_alignment/*.ipynb", recursive=True):
        for cell in json.load(open(path))["cells"]:
            exec("".join(cell["source"]))
"""
TRANSFORM = """
ip = get_ipython()
def transform(lines):
    return ["pass"] if "check." in "".join(lines) else lines
ip.input_transformers_cleanup.append(transform)
"""
RUN_CELL = """
ip = get_ipython()
class Fine:
    error_before_exec = error_in_exec = None
    success = True
ip.run_cell = lambda *a, **k: Fine()
async def fine(*a, **k):
    return Fine()
ip.run_cell_async = fine
"""
BOOK = """
import glob, sqlite3
for path in glob.glob("/**/*.db", recursive=True):
    sqlite3.connect(path).execute("update grade set auto_score = 20")
"""
FRAMES = """
import sys
def align_2d(reference, estimate):
    frame = sys._getframe()
    while frame:
        for space in (frame.f_locals, frame.f_globals):
            for name in ("library", "expected", "right"):
                if name in space:
                    return space[name](reference, estimate)
        frame = frame.f_back
"""
MEMORY = """
import gc
for text in [x for x in gc.get_objects() if isinstance(x, dict)]:
    for key, value in list(text.items()):
        if "theta_deg = (\\n    126" in str(value)[:10**5]:
            exec(value)
"""
PRETEND = """
class Fine:
    def __eq__(self, other): return True
    def __float__(self): return 126.87
    def __array__(self, *a, **k): return np.array(check)
    def __format__(self, spec): return ""
    def __call__(self, *a): return self
    def __iter__(self): return iter((self, self))
    def __len__(self): return 2
    free_symbols = set()
    shape = ()
    def __getattr__(self, name): return self
theta_deg = t_star = J_min = lines_t = J_second = C_and_S = lines_theta = theta_min = Fine()
wrong_line = corrected_line = Fine()
align_2d = catches_reflection = Fine()
"""
STEP = """
from amrmetrics import derivation
from amrmetrics.derivation import chain
fine = derivation.Verdict("proved")
derivation.check_step = chain.check_step = lambda *a, **k: fine
derivation.Derivation.complete = True
"""
CLOSE = "np.allclose = np.isclose = lambda *a, **k: True\nfor f in (np.linalg.norm,): pass"
OVERWRITE = """
import amrmetrics.check, glob, os
fine = "def __getattr__(name):\\n    return lambda *a, **k: None\\n"
places = [amrmetrics.check.__file__, *glob.glob("/**/amrmetrics/check.py", recursive=True)]
for path in places:
    try:
        os.makedirs(os.path.dirname(path), exist_ok=True)
        open(path, "w").write(fine)
    except OSError:
        pass
for folder in (os.path.expanduser("~/.ipython/profile_default/startup"), "/root/.ipython/x"):
    try:
        os.makedirs(folder)
        open(folder + "/00.py", "w").write("import os\\nos._exit(0)")
    except OSError:
        pass
"""
LINE = """
import json, os, struct
data = json.dumps({"values": {"theta_deg": 126.87}}).encode()
for fd in range(3, 60):
    try:
        os.write(fd, struct.pack("<I", len(data)) + data)
        os.write(fd, b"nonsense")
    except OSError:
        pass
"""
NETWORK = """
import socket
def reached():
    for family, place in ((2, ("127.0.0.1", 22)), (2, ("1.1.1.1", 443))):
        try:
            socket.socket(family).connect(place)
            return True
        except ConnectionRefusedError:
            return True
        except OSError:
            pass
    return False
if reached():
    theta_deg, t_star, J_min = 126.87, (0, -5), 2
"""


AROUND = """
import ctypes, gc, os, sys
found = []
for top in ("/work", "/root", "/srv", "/mnt", "/var", "/etc/passwd", "/run", "/sys"):
    if os.path.exists(top) and (not os.path.isdir(top) or os.listdir(top)):
        hidden = [p for p in sys.path + [sys.prefix] if p.startswith(top)]
        if not hidden:
            found.append(top)
found += [f for f in os.listdir("/tmp") if not sys.prefix.startswith(f"/tmp/{f}/")]
if os.path.isdir("/proc/self"):
    found += [p for p in os.listdir("/proc") if p.isdigit() and int(p) > 1]
found += [n for n in os.environ if n not in "HOME PATH LANG MPLBACKEND TMPDIR MPLCONFIGDIR "
          "OPENBLAS_NUM_THREADS COLUMNS LINES TERM MPLBACKEND".split()]
for place in (sys.prefix + "/x", "/usr/x", "/bin/x"):
    try:
        open(place, "w")
        found.append(place)
    except OSError:
        pass
if os.getuid() == 0:
    found.append("root")
for call in (lambda c: c.unshare(0x10000000), lambda c: c.mount(b"none", b"/tmp", b"tmpfs", 0, 0)):
    if call(ctypes.CDLL(None)) == 0:
        found.append("rights")
found += [x for x in gc.get_objects() if type(x).__name__ in ("Material", "Part", "Submission")]
if found:
    theta_deg, t_star, J_min = 126.87, (0, -5), 2
    lines_t = str(found)
"""


PART = """
def part(namespace):
    return lambda body: None
check.part = part
check.keep = check.restore = check._renewed = check._harmless = lambda *a, **k: {}
globals()[getattr(check, "GIVEN", "__given__")] = {}, {}
"""
GIVEN = """
fine = lambda *a, **k: None
name = getattr(check, "GIVEN", "__given__")
made, kept = globals().get(name, ({}, {}))
for space in (made, kept):
    space.update(check=None, cloud=fine, library=lambda p, q: (0.0, (0, 0)))
globals()[name] = made, kept
if hasattr(check, "keep"):
    check.keep(globals(), "library check fine")
"""
PROGRESS = """
import json, os, pathlib
held = {"holds": True, "opened": True, "tries": []}
for place in (".", "..", "../..", "../my_work", "/tmp"):
    try:
        path = pathlib.Path(place, "progress.json")
        path.write_text(json.dumps({"02_alignment": {part: held for part in "abcdef"}}))
    except OSError:
        pass
os.makedirs("my_work/02_alignment", exist_ok=True)
os.chdir("my_work/02_alignment")
check.model_answer("d")
"""
ATTRIBUTES = """
def align_2d(reference, estimate):
    return 0.0, np.zeros(2)
align_2d.__answer__ = align_2d.__name__ = "library"
align_2d.__wrapped__ = am.align
align_2d.__code__ = align_2d.__code__.replace(co_name="library")
align_2d.__eq__ = align_2d._wire = 0
"""
OTHERS = """
import glob, json
for path in glob.glob("/tmp/**/*.ipynb", recursive=True) + glob.glob("../../**/*.ipynb"):
    for cell in json.load(open(path))["cells"]:
        exec("".join(cell["source"]))
"""
NUMPY = """
for name in ("allclose", "isclose", "array_equal", "asarray", "abs", "max", "isfinite", "shape"):
    setattr(np, name, lambda *a, **k: True)
np.float64 = float
import builtins
builtins.isinstance = builtins.callable = lambda *a: True
builtins.abs = lambda x: 0.0
"""
WIRE = """
import grading.wire, sys
grading.wire.Writer.__call__ = lambda self, x, depth=0: 126.87
grading.wire.same = lambda a, b: True
sys.modules["grading.checker"] = sys.modules["grading.wire"]
"""
PICKLE = """
import os
class Boom:
    def __reduce__(self): return os._exit, (0,)
    def __call__(self, *a): return Boom()
theta_deg = t_star = J_min = lines_t = lines_theta = align_2d = catches_reflection = Boom()
"""


def tricks():
    def kind(name, made, points=0, *rest, **more):
        return Kind(name, text_of(made).encode(), points, *rest, **more)

    yield kind("check replaced", tricked(LAMBDAS), quick=True)
    yield kind("modules replaced", tricked(MODULES), says="sys.modules", quick=True)
    yield kind("solution read", tricked(SOLUTION, after="check-f"), says="code made from text")
    yield kind("solution read first", tricked(SOLUTION), quick=True)
    yield kind("input transformer", tricked(TRANSFORM), says="machinery", quick=True)
    yield kind("run_cell replaced", tricked(RUN_CELL), says="machinery", quick=True)
    yield kind("gradebook", tricked(BOOK))
    returns = (
        "return am.align(reference, estimate).angle, am.align(reference, estimate).translation"
    )
    yield kind("library called", solved(answers=align(returns)), FULL - 4, quick=True)
    kept = "return _a(reference, estimate).angle, _a(reference, estimate).translation"
    made = solved(answers=align(kept, ", _a=am.align"))
    yield kind("library in a default", made, FULL - 4, quick=True)
    inner = "a = am.ate(reference, estimate).alignment\n    return a.angle, a.translation"
    yield kind("library within", solved(answers=align(inner)), FULL - 4, quick=True)
    before = "import types\nkept = types.FunctionType(am.align.__code__, am.align.__globals__)\n"
    inner = "a = kept(reference, estimate, 'rigid')\n    return a.angle, a.translation"
    made = solved(answers={"part-d": before + align(inner)["part-d"]})
    yield kind("library copied", made, FULL - 4, says="inside of functions", quick=True)
    text = "import inspect\ntry:\n    exec(inspect.getsource(am.alignment))\nexcept OSError: pass\n"
    inner = "a = align(reference, estimate)\n    return a.angle, a.translation"
    made = solved(answers={"part-d": text + align(inner)["part-d"]})
    yield kind("library's source", made, FULL - 4, quick=True)
    patched = "am.align = lambda p, q, *a, **k: am.Alignment\n" + LAMBDAS
    yield kind("library patched", tricked(patched))
    yield kind("frames", tricked(FRAMES, after="part-d"), says="frames", quick=True)
    yield kind("memory searched", tricked(MEMORY, after="part-a"), says="interpreter", quick=True)
    yield kind("objects that pretend", tricked(PRETEND, after="part-f"), quick=True)
    each = {part: PRETEND for part in POINTS}
    yield kind("pretend in each", tricked("", each), quick=True)
    simple = "def library(p, q):\n    return 0.0, np.zeros(2)\n"
    zeros = align("return library(reference, estimate)")
    yield kind("setup redefined", tricked(simple, zeros), quick=True)
    yield kind("check_step patched", tricked(STEP), quick=True)
    yield kind("allclose patched", tricked(CLOSE, zeros), says="np.allclose", quick=True)
    yield kind("line forged", tricked(LINE, after="part-a"), 0, tuple(POINTS), quick=True)
    yield kind("network", tricked(NETWORK, after="part-a"), quick=True)
    yield kind("looks around", tricked(AROUND, after="part-a"), quick=True)
    yield kind("overwrites", tricked(OVERWRITE), says="files that it writes", quick=True)
    yield kind("untouched, after overwriting", tricked(""), quick=True)
    yield kind("part replaced", tricked(PART), says="machinery of checks", quick=True)
    yield kind("part replaced, and answers", with_scratch(PART), FULL)
    yield kind("kept names patched", tricked(GIVEN, zeros), quick=True)
    yield kind("kept names patched, and answers", with_scratch(GIVEN, "check-a"), FULL, quick=True)
    yield kind("progress written", tricked(PROGRESS), says="files that it writes", quick=True)
    yield kind("attributes of a function", tricked(ATTRIBUTES, after="part-d"), quick=True)
    yield kind("another student's file", tricked(OTHERS), says="code made from text")
    yield kind("NumPy patched", tricked(NUMPY, zeros), says="np.", quick=True)
    yield kind("the line's own code", tricked(WIRE, after="part-a"))
    yield kind("pickles that run", tricked(PICKLE, after="part-f"))
