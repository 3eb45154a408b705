"""What crosses between a check and a student's process: plain data in JSON, nothing that runs.

Numbers, text, containers, arrays without objects, SymPy expressions as trees of known classes and
the library's own dataclasses are rebuilt on the other side. A function stays where it is, and the
other side gets one that calls it from afar. Anything else arrives as an `Opaque` with its name.
"""

import base64
import contextlib
import dataclasses
import decimal
import fractions
import functools
import json
import os
import pathlib
import struct
import sys
import time

import numpy as np

LARGEST = 64 << 20  # bytes of a message
DEEPEST = 40  # containers in containers
MOST_CALLS = 30  # calls in calls
DIGITS = 1000  # of an integer
SAME = 3  # results alike until a function is taken for one that gives no other
FOLDERS = 32 << 20  # bytes in the folders that answers name
MOST_FILES = 4096
REMEMBERED = 5000  # of such results
PLAIN = "biufcSUmM"  # kinds of arrays


class Gone(BaseException):
    """The other side has ended, is too slow or sends nonsense. No check may catch it."""


class Opaque:
    """Stands for something that does not cross."""

    def __init__(self, kind, text):
        self.kind, self.text = kind, text

    def __repr__(self):
        return self.text


class Remote(Exception):
    """What the other side raised, if it is of no known kind."""


# --- From objects to plain data -----------------------------------------------------------------


class Writer:
    """Write objects as plain data; functions are kept in a table and go as their number."""

    def __init__(self, own, foreign):
        self.own, self.foreign = own, foreign

    def __call__(self, x, depth=0):
        kind = type(x)
        if x is None or kind is bool or kind is float or kind is str:
            return x.encode("utf-8", "replace").decode() if kind is str else x
        if kind is int:
            return x if x.bit_length() < 3 * DIGITS else ["big", hex(x)]
        if depth > DEEPEST:
            return self.opaque(x)
        try:
            return self.tagged(x, depth + 1)
        except BaseException:  # an object of a student may raise anything
            return self.opaque(x)

    def many(self, items, depth):
        return [self(item, depth) for item in items]

    def tagged(self, x, depth):
        kind = type(x)
        if x is ...:
            return ["dots"]
        if isinstance(x, np.generic) and not isinstance(x, np.void):
            return ["scalar", x.dtype.str, base64.b64encode(x.tobytes()).decode()]
        if isinstance(x, np.ndarray | np.void):
            return self.array(np.asarray(x), depth)
        for name, class_ in (("list", list), ("tuple", tuple), ("set", set), ("froze", frozenset)):
            if isinstance(x, class_):
                return [name, self.many(class_.__iter__(x), depth)]
        if isinstance(x, dict):
            return ["dict", [self.many(pair, depth) for pair in dict.items(x)]]
        for class_ in (str, int, float):
            if isinstance(x, class_):  # of a class of its own: the plain value in it
                return self(class_.__new__(class_, getattr(class_, PLAINLY[class_])(x)), depth)
        if kind is complex:
            return ["complex", x.real, x.imag]
        if kind is bytes:
            return ["bytes", base64.b64encode(x).decode()]
        if kind is range or kind is slice:
            return [kind.__name__, self(x.start, depth), self(x.stop, depth), self(x.step, depth)]
        if kind in (fractions.Fraction, decimal.Decimal):
            return [kind.__name__.lower(), str(x)]
        if str(kind.__module__).startswith("pandas.") and hasattr(x, "to_numpy"):
            return self.array(np.asarray(x.to_numpy()), depth)
        if isinstance(x, pathlib.PurePath):
            return ["path", str(x)]
        if kind is np.random.Generator:
            return ["generator", self(x.bit_generator.state, depth)]
        if is_sympy(x):
            return ["sympy", tree(x)]
        if is_ours(kind):
            fields = [f.name for f in dataclasses.fields(kind) if f.init]
            values = [[name, self(getattr(x, name), depth)] for name in fields]
            return ["ours", f"{kind.__module__}:{kind.__qualname__}", values]
        if callable(x):
            if getattr(x, "_wire", None) in self.foreign and self.foreign[x._wire] is x:
                return ["home", x._wire]
            number = next((n for n, f in self.own.items() if f is x), len(self.own))
            self.own[number] = x
            return ["call", number, str(getattr(x, "__name__", ""))[:80]]
        if isinstance(x, type({}.keys()) | type({}.values()) | type({}.items())):
            return ["list", self.many(x, depth)]
        return self.opaque(x)

    def array(self, x, depth):
        if x.dtype.kind in PLAIN:
            data = base64.b64encode(np.ascontiguousarray(x).tobytes()).decode()
            return ["array", x.dtype.str, list(x.shape), data]
        if x.dtype.names:
            columns = [[name, self.array(x[name], depth)] for name in x.dtype.names]
            return ["table", list(x.shape), columns]
        if x.dtype == object:
            return ["objects", list(x.shape), self.many(x.ravel().tolist(), depth)]
        return self.opaque(x)

    @staticmethod
    def opaque(x):
        try:
            text = repr(x)[:200].encode("utf-8", "replace").decode()
        except BaseException:  # whatever a repr of a student's does
            text = f"<{type(x).__name__}>"
        return ["opaque", type(x).__name__[:80], text]


PLAINLY = {str: "__str__", int: "__int__", float: "__float__"}


def is_sympy(x):
    sp = sys.modules.get("sympy")
    return sp is not None and isinstance(x, sp.Basic | sp.MatrixBase)


def is_ours(kind):
    """Whether this is a dataclass of the library, and not one of the same name."""
    module = sys.modules.get(kind.__module__)
    return (
        str(kind.__module__).split(".")[0] == "amrmetrics"
        and getattr(module, kind.__qualname__, None) is kind
        and dataclasses.is_dataclass(kind)
    )


def tree(w):
    """Return a SymPy object as nested lists of the names of its classes."""
    import sympy as sp

    if isinstance(w, sp.MatrixBase):
        return ["matrix", *w.shape, [tree(item) for item in w.flat()]]
    if isinstance(w, sp.Symbol):
        known = {k: v for k, v in w._assumptions_orig.items() if isinstance(v, bool)}
        return ["symbol", w.name, known]
    if isinstance(w, sp.core.symbol.Str):
        return ["name", w.name]
    if isinstance(w, sp.Rational) and not w.is_infinite:
        return ["ratio", hex(w.p), hex(w.q)]
    if isinstance(w, sp.Float):
        return ["float", str(w), int(w._prec)]
    if isinstance(w, sp.core.function.AppliedUndef):
        return ["undefined", w.func.__name__, [tree(a) for a in w.args]]
    return ["of", type(w).__name__, [tree(a) for a in w.args]]


# --- And back -----------------------------------------------------------------------------------


class Reader:
    """Build objects from plain data; anything that does not fit is a ValueError."""

    def __init__(self, own, distant):
        self.own, self.distant = own, distant

    def __call__(self, x):
        if not isinstance(x, list):
            if isinstance(x, dict):
                raise ValueError("a dict")
            return x
        name, *rest = x
        return getattr(self, "of_" + name)(*rest)

    def many(self, items):
        return [self(item) for item in items]

    def of_dots(self):
        return ...

    def of_big(self, digits):
        return int(digits, 16)

    def of_scalar(self, dtype, data):
        return np.frombuffer(base64.b64decode(data), plain_dtype(dtype))[0]

    def of_array(self, dtype, shape, data):
        flat = np.frombuffer(base64.b64decode(data), plain_dtype(dtype))
        return flat.reshape(shape).copy()

    def of_table(self, shape, columns):
        parts = [(str(name), self.of_array(*data[1:])) for name, data in columns]
        kinds = [(name, part.dtype, part.shape[len(shape) :]) for name, part in parts]
        table = np.empty(tuple(shape), kinds)
        for name, part in parts:
            table[name] = part
        return table

    def of_objects(self, shape, items):
        flat = np.empty(len(items), dtype=object)
        for k, item in enumerate(items):
            flat[k] = self(item)
        return flat.reshape(shape)

    def of_list(self, items):
        return self.many(items)

    def of_tuple(self, items):
        return tuple(self.many(items))

    def of_set(self, items):
        return set(self.many(items))

    def of_froze(self, items):
        return frozenset(self.many(items))

    def of_dict(self, pairs):
        return {self(key): self(value) for key, value in pairs}

    def of_complex(self, real, imaginary):
        return complex(real, imaginary)

    def of_bytes(self, data):
        return base64.b64decode(data)

    def of_range(self, *ends):
        return range(*self.many(ends))

    def of_slice(self, *ends):
        return slice(*self.many(ends))

    def of_fraction(self, text):
        return fractions.Fraction(short(text))

    def of_decimal(self, text):
        return decimal.Decimal(short(text))

    def of_path(self, text):
        return pathlib.Path(text)

    def of_generator(self, state):
        state = self(state)
        known = ("PCG64", "PCG64DXSM", "MT19937", "Philox", "SFC64")
        if state["bit_generator"] not in known:
            raise ValueError("an unknown generator")
        bits = getattr(np.random, state["bit_generator"])()
        bits.state = state
        return np.random.Generator(bits)

    def of_sympy(self, branches):
        return grown(branches)

    def of_ours(self, place, values):
        module, name = place.split(":")
        kind = getattr(sys.modules.get(module), name)
        if not is_ours(kind):
            raise ValueError(place)
        return kind(**{field: self(value) for field, value in values})

    def of_home(self, number):
        return self.own[number]

    def of_call(self, number, name):
        return self.distant(int(number), str(name))

    def of_opaque(self, kind, text):
        return Opaque(str(kind), str(text))


def short(text):
    if len(text) > DIGITS:
        raise ValueError("too many digits")
    return text


def plain_dtype(text):
    dtype = np.dtype(str(text))
    if dtype.kind not in PLAIN:
        raise ValueError(text)
    return dtype


@functools.cache
def sympy_classes():
    """Return SymPy's own classes of expressions, by name."""
    import sympy as sp

    found, todo = {}, [sp.Basic]
    while todo:
        class_ = todo.pop()
        todo += class_.__subclasses__()
        if str(class_.__module__).startswith("sympy."):
            found.setdefault(class_.__name__, class_)
    return found


def grown(branches):
    """Return the SymPy object of a tree; nothing in it is computed, no text is evaluated."""
    import sympy as sp

    kind, name, *rest = branches
    if kind == "matrix":
        return sp.Matrix(name, rest[0], [grown(b) for b in rest[1]])
    if kind == "symbol":
        return sp.Symbol(str(name), **{str(k): bool(v) for k, v in rest[0].items()})
    if kind == "name":
        return sp.core.symbol.Str(str(name))
    if kind == "ratio":
        return sp.Rational(int(name, 16), int(rest[0], 16))
    if kind == "float":
        return sp.Float(str(name), precision=int(rest[0]))
    arguments = [grown(b) for b in rest[0]]
    if kind == "undefined":
        return sp.Function(str(name))(*arguments)
    class_ = sympy_classes().get(name)
    if class_ is None:
        raise ValueError(name)
    if class_ in (sp.Add, sp.Mul):
        return class_._from_args(arguments)
    with contextlib.suppress(TypeError):
        return class_(*arguments, evaluate=False)
    return class_(*arguments)


# --- Folders -------------------------------------------------------------------------------------


def texts_in(data):
    if isinstance(data, dict | list):
        for item in data.values() if isinstance(data, dict) else data:
            yield from texts_in(item)
    elif isinstance(data, str) and 0 < len(data) < 500:
        yield data


def folders_in(values, home):
    """Return the files of each folder below `home` that an answer names."""
    found, left = {}, FOLDERS
    for text in dict.fromkeys(texts_in(values)):
        try:
            if not os.path.isdir(text) or not os.path.realpath(text).startswith(home):
                continue
            files = {}
            for path in pathlib.Path(text).rglob("*"):
                if path.is_file() and not path.is_symlink():
                    data = path.read_bytes()
                    left -= len(data) + 1000
                    if left < 0:
                        return {}
                    name = path.relative_to(text).as_posix()
                    files[name] = base64.b64encode(data).decode()
            found[text] = files
        except (OSError, ValueError):
            continue
    return found


def laid_out(values, folders, place):
    """Write folders that were handed over below a place, and let the answers name them there."""
    if not isinstance(folders, dict) or not folders:
        return values
    if sum(map(len, folders.values())) > MOST_FILES:
        raise Gone("hands over too many files")
    there = {}
    for number, (text, files) in enumerate(folders.items()):
        there[text] = base = os.path.join(place, str(number))
        os.makedirs(base, exist_ok=True)
        for name, data in files.items():
            parts = pathlib.PurePosixPath(name).parts
            if not parts or ".." in parts or name.startswith("/"):
                raise Gone("hands over files outside of their folder")
            path = pathlib.Path(base, *parts)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(base64.b64decode(data))

    def moved(data):
        if isinstance(data, list):
            return [moved(item) for item in data]
        return there.get(data, data) if isinstance(data, str) else data

    return {name: moved(data) for name, data in values.items()}


# --- Errors -------------------------------------------------------------------------------------


def written_error(error):
    names = [c.__name__ for c in type(error).__mro__][:20]
    try:
        text = str(error)[:2000].encode("utf-8", "replace").decode()
    except BaseException:  # whatever a student's __str__ does
        text = ""
    return {"kinds": names, "text": text}


def read_error(said):
    """Return an exception of the nearest known kind that carries the name of the other one."""
    import builtins

    from amrmetrics import check, errors

    kinds, text = [str(kind)[:80] for kind in said["kinds"]], str(said["text"])
    for kind in kinds:
        known = (check, errors, np.linalg, builtins)
        found = next((getattr(m, kind) for m in known if hasattr(m, kind)), None)
        if isinstance(found, type) and issubclass(found, Exception):
            if kind != kinds[0]:
                found = type(kinds[0], (found,), {})
            with contextlib.suppress(Exception):
                return found(text)
    return type(kinds[0] if kinds else "Exception", (Remote,), {})(text)


# --- The line -----------------------------------------------------------------------------------


class Peer:
    """One end of a line on which either side asks and the other answers, also within an answer."""

    def __init__(self, line, answer):
        self.line, self.answer = line, answer
        self.deadline = None
        self.tired = lambda: False
        self.own, self.foreign = {}, {}
        self.write = Writer(self.own, self.foreign)
        self.read = Reader(self.own, self.distant)
        self.memory = None  # or a dict of what functions of the other side have returned
        self.depth = 0

    def distant(self, number, name):
        """Return a function that stands for one of the other side."""
        if number not in self.foreign:

            def function(*arguments, **options):
                return self.call(number, arguments, options)

            function.__name__ = function.__qualname__ = name or "function"
            function._wire = number
            self.foreign[number] = function
        return self.foreign[number]

    def call(self, number, arguments, options):
        """Call a function of the other side; what it does to arrays and lists is done here, too."""
        key = None
        if self.memory is not None and not options:
            key = number, key_of(arguments)
            times, _, value = self.memory.get(key, (0, None, None))
            if times >= SAME:
                return value.copy() if isinstance(value, np.ndarray) else value
        given = [self.write(a) for a in arguments]
        named = [[name, self.write(a)] for name, a in options.items()]
        said = self.ask({"do": "call", "of": number, "with": given, "and": named})
        for k, changed in said.get("changed", ()):
            overwrite(arguments[k], self.understood(changed))
        if "error" in said:
            raise read_error(said["error"])
        value = self.understood(said["value"])
        if key and key[1] is not None and not said.get("changed"):
            self.remember(key, said["value"], value)
        return value

    def remember(self, key, said, value):
        """Keep a result: a test that calls what it tests a thousand times alike would take long."""
        if type(value) not in (*PLAIN_KINDS, np.ndarray) and not isinstance(value, np.generic):
            return
        if len(self.memory) > REMEMBERED:
            self.memory.clear()
        value = value.copy() if isinstance(value, np.ndarray) else value  # whoever gets it, has it
        times, before, _ = self.memory.get(key, (0, said, None))
        self.memory[key] = (times + 1 if same(before, said) else -float("inf")), said, value

    def understood(self, data):
        try:
            return self.read(data)
        except Gone:
            raise
        except Exception as error:
            raise Gone(f"hands over what cannot be read ({type(error).__name__})") from None

    def answer_call(self, function, asked):
        """Return what is said of a call that the other side asked for."""
        try:
            arguments = [self.read(a) for a in asked["with"]]
            options = {str(name): self.read(a) for name, a in asked["and"]}
        except Exception as error:
            return {"error": written_error(error)}
        before = asked["with"]
        said = {}
        try:
            said["value"] = self.write(function(*arguments, **options))
        except Gone:
            raise
        except BaseException as error:
            said["error"] = written_error(error)
        changed = []
        for k, a in enumerate(arguments):
            if isinstance(a, np.ndarray | list | dict | set | np.random.Generator):
                after = self.write(a)
                if not same(after, before[k]):
                    changed.append([k, after])
        return said | {"changed": changed}

    def ask(self, message):
        # A recursion that ends in the midst of an answer would leave the line in disorder.
        room(150)
        self.depth += 1
        try:
            if self.depth > MOST_CALLS:
                raise RecursionError("too many calls within calls")
            self.send(message)
            while True:
                said = self.receive()
                if "do" not in said:
                    return said
                self.send(self.answer(said))
        finally:
            self.depth -= 1

    def serve(self):
        while True:
            self.send(self.answer(self.receive()))

    def send(self, message):
        data = json.dumps(message).encode()
        if len(data) > LARGEST:
            message = {"error": written_error(ValueError("this is too large to be handed over"))}
            data = json.dumps(message).encode()
        self.until(self.line.sendall, struct.pack("<I", len(data)) + data)

    def receive(self):
        (size,) = struct.unpack("<I", self.exactly(4))
        if size > LARGEST:
            raise Gone("sends too much")
        try:
            said = json.loads(self.exactly(size))
        except (ValueError, RecursionError):
            raise Gone("sends nonsense") from None
        if not isinstance(said, dict):
            raise Gone("sends nonsense")
        return said

    def exactly(self, size):
        parts = bytearray()
        while len(parts) < size:
            part = self.until(self.line.recv, min(size - len(parts), 1 << 20), 0.5)
            if not part:
                raise Gone("ended")
            parts += part
        return bytes(parts)

    def until(self, method, argument, pause=float("inf")):
        """Call a method of the line; after each pause, ask whether the other side is tired."""
        while True:
            left = float("inf") if self.deadline is None else self.deadline - time.monotonic()
            if left <= 0:
                raise Gone("slow")
            wait = min(left, pause)
            try:
                self.line.settimeout(wait if wait < float("inf") else None)
                return method(argument)
            except TimeoutError:
                if wait == left:
                    raise Gone("slow") from None
                if self.tired():
                    raise Gone("tired") from None
            except OSError:
                raise Gone("ended") from None


PLAIN_KINDS = (type(None), bool, int, float, complex, str)


def key_of(x):
    """Return something that only equal plain values, lists and arrays share; None for others."""
    kind = type(x)
    if kind in PLAIN_KINDS:
        return kind, repr(x)
    if kind in (tuple, list):
        keys = [key_of(item) for item in x]
        return None if None in keys else (kind, *keys)
    if kind is np.ndarray or isinstance(x, np.generic):
        return (kind, x.dtype.str, x.shape, x.tobytes()) if x.dtype.kind in PLAIN else None
    return None


def room(frames):
    """Raise a RecursionError unless so many more calls are possible."""
    if frames:
        room(frames - 1)


def same(a, b):
    return a == b or json.dumps(a) == json.dumps(b)  # nan is not equal to itself


def overwrite(old, new):
    """Do to an argument here what was done to it there."""
    with contextlib.suppress(Exception):
        if isinstance(old, np.ndarray) and isinstance(new, np.ndarray):
            old[...] = new
        elif isinstance(old, list) and isinstance(new, list):
            old[:] = new
        elif isinstance(old, dict | set) and isinstance(new, type(old)):
            old.clear()
            old.update(new)
        elif isinstance(old, np.random.Generator) and isinstance(new, np.random.Generator):
            old.bit_generator.state = new.bit_generator.state
