"""The written form of derivations: `declare` says what the letters are, `derive` shows a chain."""

import ast
import contextlib
import copy
import html
import keyword
import re

import sympy as sp

from .chain import GOOD, NAME, ORDER, TYPED, Chain, Lemma, written_lines
from .checking import check_step
from .domains import make
from .reading import CONSTANTS, Unreadable
from .spelling import canonical
from .typesetting import SCOPED, letter, name_of, parse, plain, typeset

USES = re.compile(rf"\bby ({NAME}(?:(?:, | and |, and ){NAME})*)(?:\s+with\s+([^;:]+))?")
LETTER = r"[^\W\d]\w*"
RANGE = re.compile(r"[\s,]((?:\w+\s*,\s*)*\w+)\s*=\s*([^=]+?)\s*\.\.\s*([^=,]+)$")
CELL = 'style="text-align:left; vertical-align:baseline"'


class WrongLine(AssertionError):
    """A line of a derivation is wrong or cannot be read, or the chain leads nowhere."""

    def _render_traceback_(self):
        # Jupyter calls this instead of printing the traceback, which says nothing to a reader.
        return [str(self)]


class WrongDeclaration(ValueError):
    """A declaration cannot be read, or gives a name a second meaning."""

    _render_traceback_ = WrongLine._render_traceback_


def declare(text):
    """Say what letters stand for; return `derive`, which checks and shows derivations.

    Parameters
    ----------
    text : str
        One declaration a line: names, then what they are, in words or as a domain is spelled
        (``theta phi  angle``; ``N  integer >= 1``; ``d  sequence k = 1..N``). Or an abbreviation,
        ``name := formula`` or ``name(x, n) := formula``, for use in later lines.

    Returns
    -------
    Declaration

    Examples
    --------
    >>> derive = declare('''
    ...     N    integer >= 1
    ...     t    real
    ...     d    sequence k = 1..N
    ... ''')
    >>> derive('''
    ...     Sum((d[k] - t)**2, k)
    ...     = Sum(d[k]**2 - 2*t*d[k] + t**2, k)            # expand each square
    ...     = Sum(d[k]**2, k) - 2*t*Sum(d[k], k) + N*t**2  # t does not depend on k
    ... ''')
    Sum((d[k] - t)**2, k)
    = Sum(d[k]**2 - 2*t*d[k] + t**2, k)            expand each square  ✓
    = Sum(d[k]**2, k) - 2*t*Sum(d[k], k) + N*t**2  t does not depend on k  ✓
    """
    return Declaration().more(text)


class Table(list):
    """Rows of two cells, each (plain text, HTML)."""

    def __repr__(self):
        wide = max((len(left) for (left, _), _ in self), default=0)
        return "\n".join(f"{left.ljust(wide)}  {right}" for (left, _), (right, _) in self)

    def _repr_html_(self):
        rows = "".join(
            f"<tr><td {CELL}>{a}</td><td {CELL}>{b}</td></tr>" for (_, a), (_, b) in self
        )
        return f"<table>{rows}</table>"


def _declared_lines(text):
    """Yield the lines of a declaration; one that leaves a bracket open goes on in the next."""
    line = ""
    for part in [*text.splitlines(), ""]:
        line = f"{line} {part.split('#')[0].strip()}".strip()
        opened = sum(line.count(x) for x in "([") - sum(line.count(x) for x in ")]")
        if opened <= 0 or not part:
            yield line
            line = ""


class Declaration:
    """What the letters of a derivation stand for; to call it is to check a chain of lines."""

    def __init__(self):
        self.domains = {}  # name: what it is, as the checker spells it
        self.ranges = {}  # letter of an index: (low, high), as texts
        self.short = {}  # abbreviation: (its parameters, the tree of what it means)
        self.said = {}  # name: what was declared, to tell a repetition from a change
        self.results = {}  # name: the chain that derives it
        self.table = Table()  # what was declared last

    # --- declaring -----------------------------------------------------------------------------

    def more(self, text):
        """Declare further letters, and return the declaration, which shows what is new.

        It is the same declaration as before: letters and results are known to both, so that
        ``derive.more(...)`` and ``derive = derive.more(...)`` do the same. A letter may be
        declared again with the same meaning (a cell can be run twice), not with another one.
        """
        more = copy.copy(self)  # the dictionaries are shared, the table is its own
        more.table = Table()
        for line in _declared_lines(text):
            try:
                if ":=" in line:
                    more._abbreviate(line)
                elif line:
                    more._letters(line)
            except Unreadable as error:
                raise WrongDeclaration(f"{line}: {error}") from None
        return more

    def _letters(self, line):
        text, ranges = line, []
        while m := RANGE.search(text):
            ranges += [(k.strip(), m[2], m[3].strip()) for k in m[1].split(",")]
            text = text[: m.start()].rstrip(" ,")
        names, words = _names_and_kind(text)
        spelled = canonical(words)
        if ranges and not spelled.startswith("seq"):
            raise Unreadable("a range such as k = 1..N belongs to a sequence")
        for name in names:
            self._keep(name, spelled)
        for k, low, high in ranges:
            self._keep(k, canonical(f"index {low}..{high}"))
        if m := re.fullmatch(r"index\[(.+),(.+)\]", spelled):
            ranges = [(name, *m.groups()) for name in names]
        self.ranges.update((k, ends) for k, *ends in ranges)
        words = plain(words + line[len(text) :])
        shown = re.sub(r"\boo\b", "∞", words.replace(">=", "≥").replace("<=", "≤"))
        left = (", ".join(names), f"${', '.join(map(letter, names))}$")
        self.table.append((left, (words, html.escape(shown))))

    def _abbreviate(self, line):
        left, formula = (plain(part) for part in line.split(":=", 1))
        m = re.fullmatch(rf"({LETTER}) ?(?:\(({LETTER}(?:, ?{LETTER})*)\))?", left)
        tree = parse(formula)
        if m is None or tree is None:
            raise Unreadable("an abbreviation is written name := formula, or name(x, n) := formula")
        parameters = tuple(x.strip() for x in (m[2] or "").split(",") if x.strip())
        tree = _Meaning(self, parameters).visit(tree)
        calls = [x for x in ast.walk(tree) if name_of(x)]
        known = {*self.domains, *CONSTANTS, *parameters, *(call.func.id for call in calls)}
        known |= {x.id for call in calls for x in _bound(call)}
        for x in ast.walk(tree):
            if isinstance(x, ast.Name) and x.id not in known:
                raise Unreadable(f"{x.id} is not declared yet")
        self._keep(m[1], f"{left} := {ast.unparse(tree)}", (parameters, tree))
        tex = html.escape(typeset(formula, self.domains), quote=False)
        right = (f":= {formula}", f":= $\\displaystyle {tex}$")
        self.table.append(((left, f"${typeset(left, self.domains)}$"), right))

    def _keep(self, name, meaning, tree=None):
        """Keep what a name stands for: the spelling of a domain, or the tree of a formula."""
        if keyword.iskeyword(name) or name in ("pi", "oo", *SCOPED):
            other = "; call it lam" if name == "lambda" else ""
            raise Unreadable(f"{name} has a meaning already{other}")
        before = self.said.get(name, meaning)
        if before != meaning:
            raise Unreadable(
                f"{name} stands for something else already ({before}): one letter, one meaning"
            )
        if tree is None:
            make(name, meaning, self.domains)  # refuses what the checker cannot take
            self.domains[name] = meaning
        else:
            self.short[name] = tree
        self.said[name] = meaning

    def expand(self, line):
        """Return the line with its abbreviations and ranges written out."""
        tree = parse(line) if isinstance(line, str) else None
        if tree is None:
            return line  # a SymPy object, or a text of which the reader says what is wrong
        with contextlib.suppress(RecursionError):
            return ast.unparse(_Meaning(self).visit(tree))
        return line

    @property
    def names(self):
        """All names that are declared, abbreviations included."""
        return [*self.domains, *self.short]

    # --- deriving ------------------------------------------------------------------------------

    def __call__(self, lines, name="", unknown=None):
        """Check a chain of lines, and return it to be shown.

        Parameters
        ----------
        lines : str, or list
            The written form; or a list of the given line, then (sign, line, reason) for each
            further one, where a line is a text or a SymPy object.
        name : str, optional
            What later lines call the result, instead of a first line ``D7: ...``.
        unknown : str, optional
            The letter that equations are solved for.

        Raises
        ------
        WrongLine
            If a line is wrong or cannot be decided or read, if a reason is missing, or if
            nothing follows from the chain.
        """
        chain = self._chain(lines, name, unknown, GOOD)
        if chain.name:
            self.results[chain.name] = chain
        return chain

    def wrong(self, lines, unknown=None):
        """Show a chain that holds a mistake, with the counterexample.

        Raises
        ------
        WrongLine
            If no line is refuted, or a line cannot be decided or read.
        """
        chain = self._chain(lines, "", unknown, (*GOOD, "refuted"))
        if "refuted" not in chain.status:
            raise WrongLine("every line holds, but a mistake was announced")
        return chain

    def _chain(self, lines, name, unknown, expected):
        if isinstance(lines, str):
            named, lines = written_lines(lines)
            name = name or named
        else:
            lines = [("", lines[0], ""), *lines[1:]]
        chain = Chain(self, name)
        if not lines or lines[0][0]:
            raise WrongLine("the first line is what is given, and has no sign before it")
        for k, (sign, line, reason) in enumerate(lines):
            if k == 0 and len(lines) > 1:
                try:
                    chain.given = chain.line(line)
                except Unreadable as error:
                    raise WrongLine(f"{line}\n  unreadable: {error}") from None
                continue
            if sign and not reason:
                raise WrongLine(f"{sign} {line}\n  a reason is missing: write it after a #")
            step = chain.add(line, relation=TYPED.get(sign), unknown=unknown, **self._why(reason))
            if step.status not in expected or step.notes:
                said = "\n  ".join([f"{step.sign} {step.text}".strip(), *step.remarks])
                raise WrongLine(f"{name}: {said}" if name else said)
        if chain.relation is None and chain.steps[-1].relation not in ("implies", "implied_by"):
            raise WrongLine(
                "the chain has both < and >: nothing follows from its first to its last"
            )
        return chain

    def _why(self, reason):
        """Return what a reason says: the words, whether by hand or cited, the results it uses."""
        if m := re.match(r"(by hand|cited)\s*[:,]?\s*", reason):
            return {"because": reason[m.end() :], "how": m[1]}
        m = USES.search(reason)
        names = re.findall(NAME, m[1]) if m else []
        try:
            return {"because": reason, "lemmas": [self._lemma(x, m[2] or "") for x in names]}
        except Unreadable as error:
            raise WrongLine(f"{reason}: {error}") from None

    def _lemma(self, name, values):
        """Return an earlier result, with other values for its letters if there are any."""
        chain = self.results.get(name)
        if chain is None or chain.relation is None:
            known = ", ".join(self.results) or "none yet"
            raise WrongLine(
                f"by {name}: there is no result of this name (there are: {known}); run the cell "
                "that derives it first"
            )
        put = _Put(self._values(name, values))
        ends = [chain.start] if chain.given is None else [chain.start, chain.steps[-1].line]
        parts = [self._put(put, chain, end) for end in ends]
        relation = chain.relation
        if chain.given is None:  # a claim alone: what it says of its two sides
            relation = {sp.Eq: "equal"} | {kind: sign for sign, kind in ORDER.items()}
            relation = relation.get(type(parts[0]))
            parts = parts[0].args if relation else parts * 2
        sure = {*chain.status} <= {"proved", "by lemma"}
        needs = chain.conditions
        if put.values:
            needs = [ast.unparse(put.visit(parse(c))) for c in needs]
        return Lemma(name, relation, *parts, sure, tuple(needs))

    def _put(self, put, chain, line):
        if not put.values:
            return line.meaning
        tree = parse(self.expand(line.text))
        return chain.line(ast.unparse(put.visit(tree))).meaning

    def _values(self, name, text):
        """Return the trees of the values in ``n = n + 1, z = 2*z``, each in its letter's domain."""
        values = {}
        for part in re.split(r",\s*(?=\w+\s*=(?!=))", text.strip()) if text else ():
            x, _, value = (side.strip() for side in part.partition("="))
            tree = parse(value)
            if x not in self.domains or tree is None:
                raise WrongLine(f"by {name} with {part}: write letter = value")
            values[x] = _Meaning(self).visit(tree)
            for claim in self._membership(x, values[x]):
                if claim is None or check_step(None, claim, self.domains).status != "proved":
                    raise WrongLine(
                        f"by {name} with {part}: it is not proved that this value is what {x} is "
                        f"declared to be ({self.domains[x]})"
                    )
        return values

    def _membership(self, x, value):
        """Return claims that say that `value` is in the domain of `x`; None for no such claim."""
        kind, text = self.domains[x], f"({ast.unparse(value)})"
        if kind in ("real", "angle") or (
            isinstance(value, ast.Name) and self.domains.get(value.id) == kind
        ):
            return []
        if kind == "nonzero":
            return [f"{text}**2 > 0"]
        m = re.fullmatch(r"(int|index)?(?:([<>]=?)(.+)|([(\[])(.+),(.+)([)\]]))?", kind)
        if m is None or (m[1] and not self._whole(value)):
            return [None]
        ends = [(">=", "1")] if kind == "index" else []
        ends += [(m[2], m[3])] if m[2] else []
        if m[4]:
            ends += [(">=" if m[4] == "[" else ">", m[5]), ("<=" if m[7] == "]" else "<", m[6])]
        return [f"{text} {sign} {end}" for sign, end in ends if "oo" not in end]

    def _whole(self, tree):
        """Whether a formula is made of integers by adding and multiplying."""
        kept = ast.BinOp | ast.UnaryOp | ast.Add | ast.Sub | ast.Mult | ast.USub | ast.Load
        return all(
            isinstance(x, kept)
            or (isinstance(x, ast.Constant) and type(x.value) is int)
            or (isinstance(x, ast.Name) and self.domains.get(x.id, "")[:3] in ("int", "ind"))
            for x in ast.walk(tree)
        )

    def summary(self):
        """Return the named results as a table: what each says, and how its steps are known."""
        table = Table()
        for name, chain in self.results.items():
            counts = ", ".join(f"{chain.counts[how]} {how}" for how in GOOD if how in chain.counts)
            table.append(((name, html.escape(name)), (counts, counts)))
        return table

    def __repr__(self):
        return repr(self.table)

    def _repr_html_(self):
        return self.table._repr_html_()


def _names_and_kind(text):
    """Split a declaration where the names end and a kind begins; the longest kind wins."""
    splits, names, rest = [], (), text
    while m := re.match(rf"({LETTER})(\s*,\s*|\s+|(?=[<>(\[]))(?=.)", rest):
        names, rest = (*names, m[1]), rest[m.end() :]
        splits.append((names, rest, "  " in m[2]))
    for names, rest, _ in splits:
        with contextlib.suppress(Unreadable):
            canonical(rest)
            return names, rest
    if not splits:
        raise Unreadable("a declaration is written: names, then what they stand for")
    return next((s for s in splits if s[2]), splits[0])[:2]  # its kind cannot be read


# --- what a line means ----------------------------------------------------------------------------


class _Meaning(ast.NodeTransformer):
    """Write out abbreviations and the ranges of indices."""

    def __init__(self, declared, own=()):
        self.declared = declared
        self.short = {n: x for n, x in declared.short.items() if n not in own}

    def visit_Name(self, node):
        parameters, tree = self.short.get(node.id, ((), node))
        if parameters:
            raise Unreadable(f"{node.id} is an abbreviation: write {node.id}({_list(parameters)})")
        return copy.deepcopy(tree)

    def visit_Call(self, node):
        name = name_of(node)
        if not name:
            return self.generic_visit(node)
        if name in ("Sum", "Product"):
            node.args[1:] = [self._range(a) for a in node.args[1:]]
        for x in node.args[1:] if name == "Derivative" else _bound(node):
            if isinstance(x, ast.Name) and x.id in self.short:
                raise Unreadable(f"{x.id} is an abbreviation, and {name} needs a letter there")
        node.args = [self.visit(a) for a in node.args]
        if node.func.id not in self.short:
            return node
        parameters, tree = self.short[node.func.id]
        if len(node.args) != len(parameters):
            said = f"{name}({_list(parameters)})" if parameters else name
            raise Unreadable(f"{name} is an abbreviation: write {said}")
        values = dict(zip(parameters, node.args, strict=True))
        return _Put(values).visit(copy.deepcopy(tree))

    def _range(self, limit):
        if not isinstance(limit, ast.Name):
            return limit
        if limit.id not in self.declared.ranges:
            raise Unreadable(
                f"{limit.id} has no range: declare it as in d sequence {limit.id} = 1..N, or "
                f"write ({limit.id}, 1, N)"
            )
        return ast.Tuple([limit, *map(parse, self.declared.ranges[limit.id])], ast.Load())


class _Put(ast.NodeTransformer):
    """Put values in the place of letters; a bound letter that would catch one is renamed."""

    def __init__(self, values):
        self.values = values

    def visit_Name(self, node):
        return copy.deepcopy(self.values.get(node.id, node))

    def visit_Call(self, node):
        name, outside = name_of(node), self.values
        if not name:
            return self.generic_visit(node)
        if name in ("Subs", "Limit"):
            node.args[2:] = [self.visit(a) for a in node.args[2:]]
            node.args[1] = self._inside(node.args[1], node)
        elif name in SCOPED:
            for limit in node.args[:0:-1]:  # from outside in: inner ends may hold outer letters
                limit.elts[1:] = [self.visit(a) for a in limit.elts[1:]]
                limit.elts[0] = self._inside(limit.elts[0], node)
        rest = 1 if name in SCOPED else len(node.args)
        node.args[:rest] = [self.visit(a) for a in node.args[:rest]]
        self.values = outside
        return node

    def _inside(self, x, scope):
        """Step into the scope of the letter `x`, and return what it is called there."""
        self.values = {n: v for n, v in self.values.items() if n != x.id}
        caught = {name for value in self.values.values() for name in _names(value)}
        if x.id not in caught:
            return x
        new = x.id + "_1"
        while new in caught | _names(scope):
            new += "1"
        self.values[x.id] = ast.Name(new, ast.Load())
        return self.values[x.id]


def _names(tree):
    return {x.id for x in ast.walk(tree) if isinstance(x, ast.Name)}


def _bound(call):
    """Return the letters that a sum, an integral, Subs or a Limit binds."""
    if name_of(call) in ("Subs", "Limit"):
        return call.args[1:2]
    limits = call.args[1:] if name_of(call) in SCOPED else ()
    return [a.elts[0] for a in limits if isinstance(a, ast.Tuple) and a.elts]


def _list(names):
    return ", ".join(names)
