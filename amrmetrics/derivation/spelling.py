"""What a letter stands for: from words to the one spelling that domains have."""

import difflib
import functools
import re

from .reading import Unreadable

EXAMPLES = (
    "real, positive, > 0, in (0, 1), integer >= 1, angle, index, function, sequence k = 1..N, "
    "vector of 2, matrix 2 x 3, positive definite 2 x 2, lower triangular 2 x 2, rotation, pose"
)
SPELLINGS = {
    "real": "number, reals, numbers",
    "nonzero": "non-zero, not zero, !=0",
    ">0": "positive",
    ">=0": "non-negative, nonnegative",
    "<0": "negative",
    "<=0": "non-positive, nonpositive",
    "(0,1)": "probability, probabilities",
    "angle": "angles",
    "index": "indices",
    "function": "functions, smooth function",
    "int": "integer, integers, whole number, whole numbers",
    "int>=1": "positive integer, natural, natural number, natural numbers",
    "int>=0": "non-negative integer, nonnegative integer",
    "int[0,1]": "0 or 1, 0/1, zero or one",
    "rot": "rotation, rotation of the plane",
    "se2": "pose, pose in the plane",
}
WORDS = {w.strip(): s for s, words in SPELLINGS.items() for w in (s, *words.split(","))}
# Which matrix it is: the first of these whose words all stand in the text.
SHAPES = {
    "chol": {"lower", "triangular"},
    "spd": {"positive", "definite"},
    "sym": {"symmetric"},
    "rot": {"rotation"},
    "vec": {"vector"},
    "mat": {"matrix"},
}
ALSO = {"covariance": SHAPES["spd"], "cholesky": SHAPES["chol"]}
FILLERS = {"of", "a", "in", "with", "d", "matrix", "symmetric", "positive", "diagonal", "factor"}


@functools.cache
def canonical(text):
    """Return the spelling of the domain that `text` describes in words, or that it already is.

    Examples
    --------
    >>> canonical("integer >= 1"), canonical("positive sequence"), canonical("vector of 2")
    ('int>=1', 'seq>0', 'vec2')
    """
    text = " ".join(text.translate(str.maketrans({"≥": ">=", "≤": "<=", "≠": "!="})).split())
    found = _number(text) or _sequence(text) or _matrix(text)
    if found is None:
        known = [*WORDS, "sequence", "vector of 2", "matrix 2 x 2", "covariance 2 x 2"]
        close = difflib.get_close_matches(text.lower(), known, 1, 0.6)
        ask = f"; did you mean {close[0]!r}?" if close else "."
        raise Unreadable(
            f"{text!r} does not say what a letter stands for{ask} Write for example {EXAMPLES}"
        )
    return found


def _number(text):
    """Return the spelling of a kind of number, of an index or of a function, or None."""
    for words in (text.lower(), text.lower().replace(" ", "")):
        for plain in (words, re.sub(r" (real|number|numbers|reals)$", "", words)):
            if plain in WORDS:
                return WORDS[plain]
    text = re.sub(r"^(real|number|angle)s? (?=[(\[<>i])", "", text)
    if (m := re.fullmatch(r"(?:in ?)?([(\[])(.+),(.+)([)\]])", text)) and _ends(m[2], m[3]):
        return f"{m[1]}{_end(m[2])},{_end(m[3])}{m[4]}"
    if m := re.fullmatch(r"([<>])(=?)(.+)", text):
        end, closed = _end(m[3]), bool(m[2])
        if end == "0":
            return m[1] + m[2] + end
        return f"{'(['[closed]}{end},oo)" if m[1] == ">" else f"(-oo,{end}{')]'[closed]}"
    m = re.fullmatch(r"(int|ind)(?:egers?|ex|ices)?(?![a-z])(.+)|whole numbers?(.+)", text, re.I)
    if m is None:
        return None
    kind, rest = {"ind": "index"}.get((m[1] or "").lower(), "int"), (m[2] or m[3]).strip()
    if m := re.fullmatch(r"(?:in |from )?\[?(.+?) ?(?:\.\.| to |,)(.+?)\]?", rest):
        return f"{kind}[{_end(m[1])},{_end(m[2])}]" if _ends(m[1], m[2]) else None
    if m := re.fullmatch(r"(>=?)(.+)", rest):
        end = _end(m[2])
        if kind == "int" and re.fullmatch(r"-?\d+", end):
            return kind + m[1] + end
        return f"{kind}[{end if m[1] == '>=' else end + '+1'},oo]"
    return None


def _ends(*texts):
    """Whether texts can be ends of an interval."""
    return not any(re.search(r"[\[\],<>=]|\.\.", t) or t.count("(") != t.count(")") for t in texts)


def _end(text):
    text = text.replace(" ", "").replace("∞", "oo").replace("infinity", "oo")
    return re.sub(r"\binf\b", "oo", text)


def _sequence(text):
    """Return "seq" with the spelling of its elements, or None."""
    m = re.fullmatch(r"(.*?)\bseq(?:uence)?s?(?=int|[^a-z]|$)(.*)", text, re.I)
    if m is None:
        return None
    of = f"{m[1]} {re.sub(r'^ ?of ', '', m[2])}".strip()
    element = _number(of) if of else "real"
    if element in (None, "index", "function", "rot", "se2"):
        return None
    return "seq" if element == "real" else "seq" + element


def _matrix(text):
    """Return the spelling of a matrix or vector, or None."""
    spelled = text.replace(" ", "")
    if re.fullmatch(r"(vec|mat|sym|spd|chol|rot)(\d+|\(\w+\))|mat(\d+x\d+|\(\w+,\w+\))", spelled):
        return "rot" if spelled == "rot2" else spelled
    size = r"(\d+|[A-Za-z])"
    m = re.search(rf"\b{size} ?(?:x|×|by) ?{size}\b|\b(?:of|in) {size}\b|\b{size}-(?=vec)", text)
    if m is None:
        return None
    rows = m[1] or m[3] or m[4]
    columns = m[2] or rows
    words = set(re.findall(r"[a-z]+", text.replace(m[0], " ").lower()))
    for word in words & set(ALSO):
        words |= ALSO[word]
    shape = next((s for s, needed in SHAPES.items() if needed <= words), None)
    if shape is None or words - SHAPES[shape] - FILLERS - set(ALSO):
        return None
    if shape == "mat" and rows != columns:
        both = rows.isdigit() and columns.isdigit()
        return f"mat{rows}x{columns}" if both else f"mat({rows},{columns})"
    if rows != columns:
        return None
    if rows.isdigit() and (shape == "mat" or rows in "23"):
        return "rot" if (shape, rows) == ("rot", "2") else shape + rows
    return f"{shape}({rows})" if shape != "mat" else f"mat({rows},{rows})"
