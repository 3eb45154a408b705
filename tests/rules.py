"""What a reader would notice in a notebook, as functions that return the faults that they find.

`STORED` holds for every notebook in the repository, `LECTURE` for lectures. Those of `AGAIN` run
the notebook. tests/test_rules.py plants a fault for each; CONTRIBUTING.md says them in words.
"""

import ast
import contextlib
import functools
import hashlib
import io
import json
import re
import sys
import tokenize
from dataclasses import dataclass
from pathlib import Path
from unittest import mock
from urllib.parse import unquote, urlsplit

import nbformat
import numpy as np

import amrmetrics.derivation  # noqa: F401  `Session` remembers what it says

COLUMNS = 79
LINES = 15
LINES_OF_A_PROBLEM = 20  # of a cell that a student reads; checks are folded

STORED = {}
LECTURE = {}
AGAIN = {}


def rule_of(group):
    """List a function among the rules of a group, under its name in words."""

    def enlist(function):
        group[function.__name__.replace("_", " ")] = function
        return function

    return enlist


@dataclass(frozen=True)
class Notebook:
    """A notebook and where it lies, for its links."""

    path: Path
    nb: nbformat.NotebookNode

    @classmethod
    def read(cls, path):
        return cls(path, nbformat.read(path, as_version=4))

    @functools.cached_property
    def code(self):
        return [cell for cell in self.nb.cells if cell.cell_type == "code"]

    @functools.cached_property
    def prose(self):
        return [cell for cell in self.nb.cells if cell.cell_type == "markdown"]

    @functools.cached_property
    def outputs(self):
        return [(cell, output) for cell in self.code for output in cell.outputs]

    @functools.cached_property
    def headings(self):
        """(level, text, what stands below it up to the next heading) for each heading."""
        lines = "\n\n".join(cell.source for cell in self.prose)
        lines = re.sub(r"```.*?```", "", lines, flags=re.DOTALL)
        found = re.split(r"^(#+) +(.+)$", lines, flags=re.MULTILINE)[1:]
        return [
            (len(found[k]), found[k + 1].strip(), found[k + 2]) for k in range(0, len(found), 3)
        ]


def source_of(cell):
    return ast.parse(cell.source)


# ---- how it is stored ------------------------------------------------------------------------


@rule_of(STORED)
def valid_with_an_id_for_each_cell(notebook):
    """The file is a notebook of format 4.5, and no two cells share an id."""
    stored = json.loads(notebook.path.read_text(encoding="utf-8"))
    ids = [cell.get("id") for cell in stored["cells"]]
    for name in sorted({name for name in ids if name and ids.count(name) > 1}):
        yield f"{name}: a second cell has this id"
        return  # `validate` would give it another one
    try:
        nbformat.validate(stored)
    except nbformat.ValidationError as error:
        yield str(error).splitlines()[0]


@rule_of(STORED)
def executed_in_order(notebook):
    """Each code cell was executed, from the first to the last, in a fresh kernel."""
    for number, cell in enumerate(notebook.code, 1):
        if cell.execution_count != number:
            yield f"{cell.id}: is number {number}, was executed as {cell.execution_count}"


@rule_of(STORED)
def no_errors_or_warnings(notebook):
    """No output is an error or a warning."""
    for cell, output in notebook.outputs:
        if output.output_type == "error":
            yield f"{cell.id}: {output.ename}"
        elif output.get("name") == "stderr" or "Warning" in output.get("text", ""):
            yield f"{cell.id}: a warning: {output.text.splitlines()[-1]}"


@rule_of(STORED)
def nothing_that_differs_from_run_to_run(notebook):
    """No time stamps, no state of widgets, no folders or addresses of one machine."""
    for key in set(notebook.nb.metadata) - {"kernelspec", "language_info"}:
        yield f"metadata of the notebook: {key}"
    if notebook.nb.metadata.get("kernelspec", {}).get("name") != "python3":
        yield "metadata of the notebook: the kernel is not python3"
    for cell in notebook.nb.cells:
        for key in set(cell.metadata) - {"tags", "nbgrader", "slideshow", "jupyter"}:
            yield f"{cell.id}: metadata {key}"
    places = r"/(root|home|Users|tmp|work|opt)/|[A-Z]:\\\\Users|0x[0-9a-f]{6,}"
    for place in re.finditer(places, notebook.path.read_text(encoding="utf-8")):
        yield f"names a place of one machine: {place[0]}"


@rule_of(STORED)
def small_enough_to_mail(notebook):
    """The file is smaller than 1.5 MB."""
    size = notebook.path.stat().st_size
    if size >= 1.5e6:
        yield f"{size / 1e6:.1f} MB"


@rule_of(STORED)
def pictures_have_a_text(notebook):
    """Each figure has an alt text of six words or more."""
    for cell, output in notebook.outputs:
        alt = output.get("metadata", {}).get("image/png", {}).get("alt", "")
        if "image/png" in output.get("data", {}) and len(alt.split()) < 6:
            yield f"{cell.id}: the alt text is {alt!r}"


BANNED = (
    r"\b(obviously|clearly|trivial(ly)?|of course|colour\w*|behaviour\w*|cent(re|red|res)|"
    r"(normal|minim|optim|linear|recogn|general)is(e|ed|es|ing|er|ation))\b|"
    "[\U0001f000-\U0001faff\u2600-\u26ff]"
)


@rule_of(STORED)
def spelling_and_tone(notebook):
    """American spelling, nothing that is "obvious", no emoji."""
    for cell in notebook.prose:
        for found in re.finditer(BANNED, without_code_and_math(cell.source), re.IGNORECASE):
            yield f"{cell.id}: {found[0]}"


@rule_of(STORED)
def links_lead_somewhere(notebook):
    """Each relative link leads to a file that exists, and its anchor to a heading there."""
    for cell in notebook.prose:
        for target in links(cell.source):
            url = urlsplit(target)
            if url.scheme or url.netloc:
                continue
            path = (notebook.path.parent / unquote(url.path)).resolve()
            if url.path and not path.exists():
                yield f"{cell.id}: there is no {target}"
            elif url.fragment and path.suffix in ("", ".ipynb"):
                there = Notebook.read(path) if url.path else notebook
                if unquote(url.fragment) not in anchors(there):
                    yield f"{cell.id}: {target} is no heading there"


def links(prose):
    text = without_code_and_math(prose)
    written = re.findall(r"\]\(\s*<?((?:[^()\s>]|\([^()\s]*\))+)", text)
    return written + re.findall(r"""\b(?:href|src)=["']([^"']+)""", text)


def anchors(notebook):
    """Return what JupyterLab accepts after a #: headings with dashes for blanks, and ids."""
    named = {text.replace(" ", "-") for _, text, _ in notebook.headings}
    prose = "\n".join(cell.source for cell in notebook.prose)
    return named | set(re.findall(r"""\b(?:id|name)=["']([^"']+)""", prose))


def without_code_and_math(prose):
    prose = re.sub(r"```.*?```|\$\$.*?\$\$", "", prose, flags=re.DOTALL)
    return re.sub(r"`[^`]*`|\$[^$]*\$", "", prose)


@rule_of(STORED)
def cells_fit_the_screen(notebook):
    """No cell but the check of a problem set has more than 20 lines of code."""
    for cell in notebook.code:
        if code_lines(cell) > LINES_OF_A_PROBLEM and not cell.metadata.get("nbgrader", {}).get(
            "grade"
        ):
            yield f"{cell.id}: {code_lines(cell)} lines of code"


@rule_of(STORED)
def sliders_do_not_stall(notebook):
    """A slider is made by `plotting.explore`: `interact` can stall whoever executes the page."""
    for cell in notebook.code:
        for node in ast.walk(source_of(cell)):
            words = {getattr(node, "id", None), getattr(node, "attr", None)}
            if isinstance(node, ast.ImportFrom):
                words |= {alias.name for alias in node.names}
            for word in words & {"interact", "interactive", "interactive_output", "Output"}:
                yield f"{cell.id}: {word}"


# ---- code that is read aloud -----------------------------------------------------------------


@rule_of(LECTURE)
def code_fits_the_column(notebook):
    """No line of code is wider than 79 columns."""
    for cell in notebook.code:
        for line in cell.source.splitlines():
            if len(line) > COLUMNS:
                yield f"{cell.id}: {len(line)} columns: {line.strip()[:40]}…"


@rule_of(LECTURE)
def cells_are_short(notebook):
    """No cell has more than 15 lines of code; blank lines, comments and text do not count."""
    for cell in notebook.code:
        if code_lines(cell) > LINES:
            yield f"{cell.id}: {code_lines(cell)} lines of code"


def code_lines(cell):
    """Count the lines on which a word of code begins or ends."""
    silent = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT}
    silent |= {tokenize.DEDENT, tokenize.ENDMARKER, tokenize.ENCODING}
    words = tokenize.generate_tokens(io.StringIO(cell.source).readline)
    return len({row for w in words if w.type not in silent for row in (w.start[0], w.end[0])})


@rule_of(LECTURE)
def one_statement_a_line(notebook):
    """One statement a line; no semicolon, no `a, b = 1, 2`, no `a = b = 1`."""
    for cell in notebook.code:
        lines = cell.source.encode().splitlines()
        words = tokenize.generate_tokens(io.StringIO(cell.source).readline)
        if any(word.string == ";" for word in words):
            yield f"{cell.id}: a semicolon"
        for node in ast.walk(source_of(cell)):
            if not isinstance(node, ast.stmt):
                continue
            line = lines[node.lineno - 1]
            if line[: node.col_offset].strip():
                yield f"{cell.id}: two statements: {line.decode().strip()}"
            if isinstance(node, ast.Assign) and (len(node.targets) > 1 or packs(node)):
                yield f"{cell.id}: several assignments: {line.decode().strip()}"


def packs(assignment):
    """Whether a tuple of values is assigned to a tuple of names, and they are not just swapped."""
    left, right = assignment.targets[0], assignment.value
    if not isinstance(left, ast.Tuple | ast.List) or not isinstance(right, ast.Tuple | ast.List):
        return False
    return {ast.unparse(x) for x in left.elts} != {ast.unparse(x) for x in right.elts}


PARSERS = {"re", "ast", "tokenize", "sympy.parsing", "sympy.parsing.sympy_parser"}
READS_CODE = {"eval", "exec", "compile", "sympify", "parse_expr"}
SPLITS = {"split", "rsplit", "splitlines", "partition", "rpartition"}
CHECKS = {"declare", "check_step", "Derivation"}


@rule_of(LECTURE)
def no_parser_and_no_helper_for_derivations(notebook):
    """A lecture wraps no `derive`, splits no text in a function and evaluates none."""
    derives = CHECKS | declared(notebook.code)
    for cell in notebook.code:
        for node in ast.walk(source_of(cell)):
            if isinstance(node, ast.Import | ast.ImportFrom):
                names = {getattr(node, "module", None), *(alias.name for alias in node.names)}
                for name in sorted(PARSERS & names):
                    yield f"{cell.id}: imports {name}"
            elif isinstance(node, ast.Call) and called(node) in READS_CODE:
                yield f"{cell.id}: calls {called(node)}"
            elif isinstance(node, ast.FunctionDef | ast.ClassDef | ast.Lambda):
                inside = [n for n in ast.walk(node) if isinstance(n, ast.Call)]
                for name in sorted({called(n) for n in inside} & (derives | SPLITS)):
                    yield f"{cell.id}: a function that calls {name}"
                for n in inside:
                    if isinstance(n.func, ast.Attribute) and owner(n.func) in derives:
                        yield f"{cell.id}: a function that calls {ast.unparse(n.func)}"


def declared(cells, empty=True):
    """Names of what `declare` returned in these cells, with or without those that hold nothing."""
    return {
        target.id
        for cell in cells
        for node in ast.walk(source_of(cell))
        if isinstance(node, ast.Assign)
        and isinstance(node.value, ast.Call)
        and called(node.value) == "declare"
        and (empty or getattr(node.value.args[0], "value", "") != "")
        for target in node.targets
        if isinstance(target, ast.Name)
    }


def called(call):
    return getattr(call.func, "id", getattr(call.func, "attr", None))


def owner(attribute):
    return getattr(attribute.value, "id", None)


@rule_of(LECTURE)
def derivations_are_written_out(notebook):
    """`declare` and `derive` are given the text itself, not one that is put together."""
    derives = declared(notebook.code)
    for cell in notebook.code:
        for node in ast.walk(source_of(cell)):
            if not isinstance(node, ast.Call):
                continue
            method = isinstance(node.func, ast.Attribute) and owner(node.func) in derives
            chain = method and node.func.attr in ("more", "wrong")
            if chain or called(node) == "declare" or (not method and called(node) in derives):
                texts = node.args[:1] or [k.value for k in node.keywords if k.arg == "lines"]
                if not all(isinstance(x, ast.Constant) and type(x.value) is str for x in texts):
                    yield f"{cell.id}: {ast.unparse(node)[:50]}…"


@rule_of(LECTURE)
def declarations_last(notebook):
    """A cell that declares letters does not make those forget that a later cell declares.

    `derive = declare("")` stands in the setup, and each part adds its own with `derive.more`.
    """
    for place, cell in enumerate(notebook.code):
        for name in declared([cell], empty=False):
            for later in notebook.code[place + 1 :]:
                if f"{name}.more(" in later.source:
                    yield f"{cell.id}: run again, it forgets what {later.id} declares"
                    break


# ---- what the page promises ------------------------------------------------------------------


@rule_of(LECTURE)
def opens_with_what_it_takes(notebook):
    """The first cell has a title, minutes, prerequisites and objectives."""
    first = notebook.nb.cells[0]
    if first.cell_type != "markdown" or not first.source.startswith("# "):
        yield f"{first.id}: the first cell has no title"
    for word in ("minutes", "Prerequisites", "able to"):
        if word not in first.source:
            yield f"{first.id}: says nothing of {word!r}"


@rule_of(LECTURE)
def closes_with_questions_and_sources(notebook):
    """There are questions with folded answers, a summary and references."""
    titles = [text for _, text, _ in notebook.headings]
    for title in ("Check yourself", "Summary", "References"):
        if not any(text.startswith(title) for text in titles):
            yield f"there is no heading {title!r}"
    questions = "".join(
        below for _, text, below in notebook.headings if text.startswith("Check yourself")
    )
    if "<details>" not in questions:
        yield "Check yourself has no folded answer"
    prose = "\n".join(cell.source for cell in notebook.prose)
    if prose.count("<details>") != prose.count("</details>"):
        yield "a <details> is not closed"


@rule_of(LECTURE)
def leads_to_its_neighbors(notebook):
    """Header and end link the problem set and the lectures before and after, if they exist."""
    folder, name = notebook.path.parent, notebook.path.stem
    lectures = sorted(path.name for path in folder.glob("*.ipynb"))
    place = lectures.index(notebook.path.name)
    practice = f"../exercises/{name}/{name}.ipynb"
    wanted = [practice] if (folder / practice).exists() else []
    before, after = lectures[max(place - 1, 0) : place], lectures[place + 1 : place + 2]
    header = links(notebook.nb.cells[0].source)
    for target in wanted + before + after:
        if target not in header:
            yield f"the header has no link to {target}"
    end = "".join(below for _, text, below in notebook.headings if text.startswith("Next"))
    for target in wanted + after:
        if target not in links(end):
            yield f"what stands under Next has no link to {target}"


@rule_of(LECTURE)
def minutes_add_up(notebook):
    """Each part states its minutes, and they add up to those of the header."""
    header = notebook.nb.cells[0].source
    promised = re.search(r"(\d+) minutes", header)
    promised_deeper = re.search(r"[Gg]oing deeper[^.]*?(\d+) minutes", header)
    core = deeper = 0
    for level, text, _ in notebook.headings:
        stated = re.search(r"\((\d+) minutes?\)", text)
        goes_deeper = "going deeper" in text.lower()
        if not stated and (goes_deeper or (level == 2 and text.startswith("Part "))):
            yield f"{text!r} states no minutes"
        elif stated and goes_deeper:
            deeper += int(stated[1])
        elif stated and level == 2:
            core += int(stated[1])
    if promised is None or int(promised[1]) != core:
        yield f"the parts take {core} minutes, the header says {promised and promised[1]}"
    if deeper != int(promised_deeper[1] if promised_deeper else 0):
        says = promised_deeper and promised_deeper[1]
        yield f"going deeper takes {deeper} minutes, the header says {says}"


@rule_of(LECTURE)
def prose_introduces_code(notebook):
    """No three code cells follow each other without a word."""
    cells = notebook.nb.cells
    for k in range(2, len(cells)):
        if all(cell.cell_type == "code" for cell in cells[k - 2 : k + 1]):
            yield f"{cells[k].id}: the third code cell without a word"


@rule_of(LECTURE)
def figures_are_asserted_and_said(notebook):
    """What a figure shows is asserted and printed in its cell or a code cell beside it."""
    for k, cell in enumerate(notebook.code):
        if "plotting.show(" not in cell.source or "plotting.explore(" in cell.source:
            continue
        near = "\n".join(c.source for c in notebook.code[max(k - 1, 0) : k + 2])
        for word in ("assert ", "print("):
            if word not in near:
                yield f"{cell.id}: no {word.strip(' (')} near the figure"


@rule_of(LECTURE)
def symbols_have_a_table(notebook):
    """Somewhere a table says which Python name a symbol has."""
    if not python_names(notebook):
        yield "no table has a column Python"


def python_names(notebook):
    """Names and expressions in the last column of tables whose head ends with Python."""
    names = []
    for cell in notebook.prose:
        in_table = False
        for line in cell.source.splitlines():
            columns = [column.strip() for column in line.strip().strip("|").split("|")]
            if not line.lstrip().startswith("|"):
                in_table = False
            elif in_table:
                names += re.findall(r"`([^`]+)`", columns[-1])
            else:
                in_table = columns[-1].startswith("Python")
    return names


GREEK = (
    "alpha|beta|gamma|delta|epsilon|varepsilon|zeta|eta|theta|vartheta|iota|kappa|lambda|mu|nu|xi|"
    "rho|sigma|tau|upsilon|phi|varphi|psi|omega|Gamma|Delta|Theta|Lambda|Xi|Sigma|Phi|Psi|Omega"
)
NO_LETTERS = r"\\(text\w*|mathrm|operatorname\*?|begin|end|mathsf|mathcal)\s*(\{[^}]*\}|\\?\w)"
EVERYWHERE = {"d", "I"}  # of an integral or derivative; the identity


@rule_of(LECTURE)
def letters_are_explained(notebook):
    """Each letter in the mathematics below the header stands in a column Symbol of a table."""
    explained = set(EVERYWHERE)
    used = {}
    for cell in notebook.nb.cells[1:]:
        if cell.cell_type != "markdown":
            continue
        in_table = False
        for line in cell.source.splitlines():
            first = line.strip().strip("|").split("|")[0]
            if line.lstrip().startswith("|") and in_table:
                explained |= letters(first)
            else:
                in_table = line.lstrip().startswith("|") and "Symbol" in first
        for letter in letters(cell.source):
            used.setdefault(letter, cell.id)
    for letter in sorted(set(used) - explained):
        yield f"{used[letter]}: {letter} is in no table of symbols"


def letters(prose):
    """Return the letters, Latin and Greek, in the mathematics of a text; no words in it."""
    prose = re.sub(r"```.*?```|`[^`]*`", "", prose, flags=re.DOTALL)
    found = set()
    for math in re.findall(r"\$\$(.+?)\$\$|\$([^$]+)\$", prose, re.DOTALL):
        math = re.sub(NO_LETTERS, " ", "".join(math))
        found |= set(re.findall(rf"\\({GREEK})(?![A-Za-z])", math))
        found |= set(re.findall(r"[A-Za-z]", re.sub(r"\\[A-Za-z]+", " ", math)))
    return found


# ---- random numbers, and cells that are run again --------------------------------------------


@rule_of(LECTURE)
def each_cell_that_draws_has_its_own_seed(notebook):
    """A cell draws from `rng = np.random.default_rng(…)` of its own, with a seed of its own."""
    made = [dict(generators(cell)) for cell in notebook.code]
    seeds = {}
    for cell, own in zip(notebook.code, made, strict=True):
        elsewhere = set().union(*made) - set(own)
        tree = source_of(cell)
        local = {a.arg for a in ast.walk(tree) if isinstance(a, ast.arg)}
        used = {n.id for n in ast.walk(tree) if isinstance(n, ast.Name)} & elsewhere - local
        for name in sorted(used):
            yield f"{cell.id}: draws from the {name} of another cell"
        for seed in own.values():
            if not seed.isdigit():
                yield f"{cell.id}: the seed is {seed or 'missing'}, not a number"
            elif seed in seeds:
                yield f"{cell.id}: the seed {seed} is that of {seeds[seed]}"
            seeds[seed] = cell.id


def generators(cell):
    """Yield (name, text of the seed) for each generator that a cell makes."""
    for node in ast.walk(source_of(cell)):
        made = node.value if isinstance(node, ast.Assign) else None
        if isinstance(made, ast.Call) and called(made) == "default_rng":
            yield ast.unparse(node.targets[0]), ", ".join(ast.unparse(x) for x in made.args)


@rule_of(AGAIN)
def cells_can_be_run_again(notebook):
    """Each cell shows the same when it is run again, at the end or at once.

    Two tries. After all cells have run, each one is run once more, with all names as they are at
    the end: what a later cell has overwritten is found. And, afresh, each is run twice in a row:
    what a cell changes that another made is found in its readers, and so are numbers drawn from
    a generator that goes on. A cell with the tag nbval-ignore-output shows what differs from run
    to run, such as times: it has to run again, and no more.
    """
    with Session(notebook) as once:
        first = [once.run(cell) for cell in notebook.code]
        end = dict(once.names)
        for cell, shown in zip(notebook.code, first, strict=True):
            yield from once.compare(cell, shown, "run again after the last cell")
            once.names.clear()
            once.names.update(end)
    with Session(notebook) as doubled:
        for cell, shown in zip(notebook.code, first, strict=True):
            yield from doubled.compare(cell, shown, "when the cells above have run twice")
            yield from doubled.compare(cell, shown, "run twice in a row")


@rule_of(AGAIN)
def names_keep_their_kind(notebook):
    """A name that two cells assign stands for the same kind of thing in both."""
    kinds = {}
    with Session(notebook) as session:
        for cell in notebook.code:
            before = dict(session.names)
            session.run(cell)
            for name, value in session.names.items():
                if name.startswith("_") or before.get(name, session) is value:
                    continue
                there, earlier = kinds.setdefault(name, (cell.id, kind_of(value)))
                if earlier != kind_of(value):
                    yield f"{cell.id}: {name} is {kind_of(value)}, and {earlier} in {there}"


@rule_of(AGAIN)
def names_of_the_symbol_tables_exist(notebook):
    """What stands in the column Python of a table can be evaluated after the last cell."""
    with Session(notebook) as session:
        for cell in notebook.code:
            session.run(cell)
        for name in python_names(notebook):
            try:
                eval(name, session.names)
            except Exception as error:
                yield f"`{name}`: {error!r}"


def kind_of(value):
    if isinstance(value, bool | np.bool_):
        return "a truth value"
    if isinstance(value, int | float | np.number):
        return "a number"
    if isinstance(value, np.ndarray) and value.dtype != object:
        return f"an array of {value.ndim} axes"
    return f"a {type(value).__name__}"


class Session:
    """A namespace in which cells are executed, as a kernel does it but without one.

    Steps of derivations are remembered from one execution to the next: what the checker said of a
    line it will say again.
    """

    verdicts = {}

    def __init__(self, notebook, seed=None):
        self.notebook, self.seed = notebook, seed
        self.names = {"__name__": "__main__", "display": self.display}
        self.shown = []

    def __enter__(self):
        self.patches = contextlib.ExitStack()
        # A kernel runs in the folder of its notebook, where the files lie that a lecture reads.
        self.patches.enter_context(contextlib.chdir(self.notebook.path.parent))
        self.patches.enter_context(mock.patch("IPython.display.display", self.display))
        for module in [m for name, m in sys.modules.items() if name.startswith("amrmetrics")]:
            check = vars(module).get("check_step")
            if callable(check):
                self.patches.enter_context(
                    mock.patch.object(module, "check_step", remembering(check, self.verdicts))
                )
        return self

    def __exit__(self, *error):
        self.patches.close()

    def display(self, *values, raw=False, **_):
        for value in values:
            picture = value.get("image/png") if raw else None
            text = hashlib.sha256(picture.encode()).hexdigest() if picture else repr(value)
            self.shown.append(re.sub(r"0x[0-9a-f]+", "0x…", text))

    def run(self, cell):
        """Execute a cell, and return all that it prints and shows."""
        source = cell.source
        if self.seed is not None:
            source = re.sub(r"default_rng\((\d+)\)", rf"default_rng([{self.seed + 1}, \1])", source)
        tree = ast.parse(source)
        last = ast.Expression(tree.body.pop().value) if shows(tree) else None
        place = f"{self.notebook.path.stem}, cell {cell.id}"
        self.shown = []
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(compile(tree, place, "exec"), self.names)
            value = eval(compile(last, place, "eval"), self.names) if last else None
            if value is not None:
                self.display(value)
        return "\n".join([printed.getvalue(), *self.shown])

    def compare(self, cell, expected, when):
        """Yield a fault if a cell, executed now, shows anything else than it did."""
        try:
            shown = self.run(cell)
        except Exception as error:
            yield f"{cell.id}: {when}: {type(error).__name__}: {error}"
            return
        if shown != expected and "nbval-ignore-output" not in cell.metadata.get("tags", []):
            lines = zip((expected + "\n…").splitlines(), (shown + "\n…").splitlines(), strict=False)
            old, new = next(((a, b) for a, b in lines if a != b), ("", ""))
            yield f"{cell.id}: {when}: {new[:60]!r} instead of {old[:60]!r}"


def shows(tree):
    return bool(tree.body) and isinstance(tree.body[-1], ast.Expr)


def remembering(check, verdicts):
    @functools.wraps(check)
    def remembered(*arguments, **options):
        parts = [*arguments, *sorted(options.items())]
        key = tuple(tuple(sorted(x.items())) if isinstance(x, dict) else x for x in parts)
        try:
            known = key in verdicts
        except TypeError:  # something that cannot be a key
            return check(*arguments, **options)
        if not known:
            verdicts[key] = check(*arguments, **options)
        return verdicts[key]

    return remembered
