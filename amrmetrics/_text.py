"""Read a table of numbers from a text file as people write them, and say what was unusual.

The fast way reads the whole file at once. Only if that fails is it read line by line, so that
each bad line can be named.
"""

import gzip
import os
import re
import zlib
from csv import QUOTE_NONE
from functools import cached_property
from io import BytesIO

import numpy as np

from amrmetrics.errors import AmrError

# More rows than this part in need of repair: the file is not what it is taken for.
REPAIRABLE = 0.1

# Below this size the fast reader takes longer to load than the plain one to read.
LARGE = 2_000_000
# Rows that show whether a column has numbers.
LOOKED_AT = 100
# Bytes in which a regular file begins with its numbers.
BEGINNING = 65_536

COMMENTS = ("#", "%", "//")
COMMENT = re.compile("#|%|//")
SEPARATING = (b",", b";", b"\t")
SEPARATORS = bytes.maketrans(b",;\t", b"   ")
EMPTY_ENTRIES = (b",,", b";;", b", ,", b"; ;")
# Python also reads 1_0, infinity and digits of other scripts; these files do not mean them.
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
NOT_FINITE = re.compile(r"[+-]?(nan|inf)", re.IGNORECASE)


class Table:
    """The numbers of a text file, and what stands around them.

    Attributes
    ----------
    path : str
    values : (N, C) array
        Finite numbers.
    head : list of list of str
        Words of each comment and each line of words above the numbers, lower case.
    commas : bool
        Commas stand between the numbers.
    repairs : list of (str, int, int or None)
        What was unusual, the first line with it, and how many rows had it.
    """

    def __init__(self, path):
        self.path, self._rows, self._columns = str(path), None, None
        values = self._read_from_disk()
        self.values = self._read_text() if values is None else values

    def _read_from_disk(self):
        """Let pandas read a large and regular file, so that its text never is in memory."""
        large = not self.path.endswith(".gz") and os.path.getsize(self.path) > LARGE
        pandas = _pandas() if large else None
        if not pandas:
            return None
        beginning = _bytes(self.path, BEGINNING)
        beginning = beginning[: beginning.rfind(b"\n") + 1]
        start = self._read_head(beginning)
        first = b"" if start is None else _first_line(beginning, start)
        if not first or _is_irregular(first):
            return None
        try:
            table = pandas.read_csv(
                self.path,
                sep=" ",
                header=None,
                skiprows=self._first - 1,
                dtype=float,
                quoting=QUOTE_NONE,
            ).to_numpy()
        except ValueError:
            return None
        self.commas = False
        return table if np.isfinite(table).all() else None

    def _read_text(self):
        """Read the whole text, at once if it is regular."""
        start = self._read_head(self._data)
        if start is None:
            raise AmrError(
                f"{self.path} has no data: {self._first - 1} lines, all blank, comments or words."
            )
        first = _first_line(self._data, start)
        self.commas = b"," in first
        if b";" in first:
            if self.commas and b"." not in first:
                raise AmrError(f"{self.path} has decimal commas. Write its numbers with points.")
            self.note("semicolons between the numbers", self._first)
        regular = True
        if any(mark in first for mark in SEPARATING):
            regular = all(self._data.find(entry, start) < 0 for entry in EMPTY_ENTRIES)
            if regular:
                self._data = self._data.translate(SEPARATORS)
        values = _read_at_once(self._data, start) if regular else None
        return self._read_lines() if values is None else values

    def _read_head(self, data):
        """Find header and comments above the numbers; return where these begin, None if nowhere."""
        start, self._first, self.head, self.repairs, header = 0, 1, [], [], None
        while start < len(data):
            end = data.find(b"\n", start) + 1 or len(data)
            line = _text(data[start:end]).strip()
            words = _words(line)
            if words and _is_number(words[0]):
                break
            if line:
                self.head.append(_words(line.lstrip("#%/ ").lower()))
            if words:
                header = header or self._first
            start, self._first = end, self._first + 1
        else:
            return None
        if header:
            self.note("header line without #", header)
        if not data.isascii() and not _is_utf8(data):
            odd = next(k for k, byte in enumerate(data) if byte > 127)
            line = data.count(b"\n", 0, odd) + 1
            self.note("letters that are not UTF-8, read as Latin-1", line)
        return start

    def _read_lines(self):
        """Read line by line, and leave out the lines that cannot be read."""
        rows, lines, bad = [], [], []
        numbered = list(enumerate(self._text, 1))[self._first - 1 :]
        entries = [(k, _words(line)) for k, line in numbered]
        entries = [(k, words) for k, words in entries if words]
        width = _most_common([len(words) for _, words in entries])
        if self.commas:
            entries, width = self._without_words(entries, width)
        for k, words in entries:
            why = _why_bad(words, width)
            if why:
                bad.append((k, why))
            else:
                rows.append([float(word) for word in words])
                lines.append(k)
        if bad:
            k, why = bad[0]
            self.note(f"lines left out ({why})", k, len(bad), of=len(entries))
        self._lines = np.array(lines)
        return np.array(rows)

    def _without_words(self, entries, width):
        """Leave out columns that hold no numbers, such as the names of frames."""
        whole = [words for _, words in entries if len(words) == width]
        some = whole[:LOOKED_AT]
        kept = [k for k in range(width) if any(_is_number(words[k]) for words in some)]
        if len(kept) == width or len(some) < 2:
            return entries, width
        self._columns = kept
        k = min(set(range(width)) - set(kept))
        what = f"columns without numbers, such as {some[0][k] or 'nothing'} in column {k + 1}"
        self.note(f"{what}, left out", self._first)
        self.head = [self._used(words, width) for words in self.head]
        return [(line, self._used(words, width)) for line, words in entries], len(kept)

    def _used(self, words, width):
        """Return the words of the columns that are used, of a line that has them all."""
        return [words[k] for k in self._columns] if len(words) == width else words

    @cached_property
    def _lines(self):
        """Line of the file that each row stood in when it was read."""
        numbered = enumerate(self._text, 1)
        return np.array([k for k, line in numbered if k >= self._first and _words(line)])

    @cached_property
    def _data(self):
        return _bytes(self.path)

    @cached_property
    def _text(self):
        return _text(self._data).split("\n")

    @property
    def lines(self):
        """Line of the file that each row stands in, (N,) array of int."""
        return self._lines if self._rows is None else self._lines[self._rows]

    def word(self, row, column):
        """Return an entry as it stands in the file."""
        column = column if self._columns is None else self._columns[column]
        return _words(self._text[self.lines[row] - 1])[column]

    def keep(self, rows):
        """Leave only these rows, in this order."""
        before = np.arange(len(self.values)) if self._rows is None else self._rows
        self.values, self._rows = self.values[rows], before[rows]

    def note(self, what, line, count=None, of=None, why=""):
        """Note a repair; refuse a file in which more than one row in ten needs one."""
        of = of or len(self.values) if count else 1
        if count and count > REPAIRABLE * of:
            raise AmrError(
                f"{self.path}, line {line}: {what}, {count} of {of} rows. More than one row in "
                f"ten in need of repair is no slip.{why and ' '}{why}"
            )
        self.repairs.append((what, line, count))

    def refuse(self, row, what):
        """Raise an error about a row."""
        raise AmrError(f"{self.path}, line {self.lines[row]}: {what}")


def _bytes(path, size=-1):
    opener = gzip.open if path.endswith(".gz") else open
    try:
        with opener(path, "rb") as file:
            data = file.read(size)
    except (gzip.BadGzipFile, EOFError, zlib.error) as error:
        raise AmrError(f"{path} is not a whole gzip archive ({error}).") from None
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise AmrError(f"{path} is not a text file in UTF-8 but in UTF-16. Save it as UTF-8.")
    if b"\0" in data[:4096]:
        raise AmrError(
            f"{path} is not a text file: it holds zero bytes. Is it an archive or a bag?"
        )
    data = data.removeprefix(b"\xef\xbb\xbf")
    return data.replace(b"\r\n", b"\n").replace(b"\r", b"\n") if b"\r" in data else data


def _first_line(data, start=0):
    end = data.find(b"\n", start)
    return data[start:] if end < 0 else data[start:end]


def _is_utf8(data):
    try:
        data.decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True


def _text(data):
    return data.decode("utf-8") if _is_utf8(data) else data.decode("latin-1")


def _words(line):
    """Return the entries of a line without its comment."""
    line = COMMENT.split(line, maxsplit=1)[0].strip().rstrip(",;")
    if "," in line or ";" in line:
        return [word for part in re.split("[,;]", line) for word in part.split() or [""]]
    return line.split()


def _is_number(word):
    return NUMBER.fullmatch(word) or NOT_FINITE.fullmatch(word)


def _why_bad(words, width):
    for column, word in enumerate(words, 1):
        if not NUMBER.fullmatch(word):
            return f"{word or 'nothing'} in column {column} is no number"
        if not np.isfinite(float(word)):
            return f"{word} in column {column} is too large"
    return f"{len(words)} columns, not {width}" if len(words) != width else ""


def _most_common(numbers):
    values, counts = np.unique(numbers, return_counts=True)
    return int(values[counts.argmax()])


def _is_irregular(first):
    """Say if a line has anything but single blanks between its numbers."""
    return b"  " in first or first != first.strip() or any(mark in first for mark in SEPARATING)


def _read_at_once(data, start):
    """Return all numbers of a regular table from a place on, or None where it is not one."""
    pandas = _pandas() if len(data) > LARGE else None
    text = BytesIO(data)
    text.seek(start)
    try:
        if pandas:
            comment = "#" if data.find(b"#", start) >= 0 else None
            options = {"header": None, "dtype": float, "quoting": QUOTE_NONE}
            table = pandas.read_csv(text, sep=r"\s+", comment=comment, **options).to_numpy()
        else:
            table = np.loadtxt(text, comments="#", ndmin=2)
    except ValueError:
        return None
    return table if np.isfinite(table).all() else None


def _pandas():
    """Return pandas if it is there and reads every number to its last digit."""
    try:
        import pandas
    except ImportError:
        return None
    return pandas if tuple(map(int, pandas.__version__.split(".")[:2])) >= (3, 1) else None
