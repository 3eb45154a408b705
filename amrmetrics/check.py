"""Feedback in problem sets: what is wrong with an answer, without giving the answer away.

Each check returns nothing when the answer is right and raises :class:`NotYet` when it
is not. A check tries the answer on many cases, says on which one it fails, and, when
the result is one that a known mistake produces, names the mistake.
"""

import contextlib
import copy
import itertools
import re
import sys
from collections import Counter

import numpy as np


class NotYet(AssertionError):
    """The answer is missing or wrong; the message is written for the student."""

    def _render_traceback_(self):
        # Jupyter calls this instead of printing the traceback: the lines of this
        # module say nothing to a student.
        return [f"Not yet: {self}"]


def value(name, yours, expected, mistakes=None, rtol=1e-6):
    """Check a number, an array, a string or a truth value.

    Parameters
    ----------
    name : str
        What is asked, as the student knows it.
    yours : object
        The student's answer; ``...`` stands for none.
    expected : object
        The right answer; it is never shown.
    mistakes : dict of str to object, optional
        Wrong answers by the misconception that leads to them.
    rtol : float
        Relative tolerance of numbers, 0 < rtol < 1.

    Raises
    ------
    NotYet
        With the student's value and the misconception, if it is a known one.

    Examples
    --------
    >>> from amrmetrics import check
    >>> check.value("the angle", 0.5, 0.5)
    >>> check.value("theta", -0.5, 0.5, {"this is the inverse": -0.5})
    Traceback (most recent call last):
    amrmetrics.check.NotYet: theta: -0.5 is not right. It looks as if this is the inverse.
    """
    _require_answer(name, yours)
    _require_kind(name, yours, expected)
    if _same(yours, expected, rtol):
        return
    raise NotYet(f"{name}: {_show(yours)} is not right.{_diagnosis(yours, mistakes, rtol)}")


def function(yours, cases, expected, mistakes=None, rtol=1e-9, without=()):
    """Check a function on many cases.

    Parameters
    ----------
    yours : callable
        The student's function.
    cases : dict of str to tuple
        Arguments by a description of the case; the first ones should be the simplest.
    expected : callable
        What it should compute, called with the same arguments. If it raises a
        ``ValueError``, so must the student's function.
    mistakes : dict of str to callable, optional
        Wrong functions by the misconception that leads to them. A result ``...`` in
        what they return stands for any.
    rtol : float
        Relative tolerance of numbers, 0 < rtol < 1.
    without : tuple of callable
        Library functions that the student's function is to replace, and must not call.

    Raises
    ------
    NotYet
        With the first case that fails, what came out, and the misconception, if it is
        a known one.

    Examples
    --------
    >>> from amrmetrics import check
    >>> def spread(x):
    ...     return max(x) - min(x)
    >>> check.function(spread, {"three numbers": ([1, 5, 2],)}, lambda x: 4)
    """
    if not callable(yours):
        raise NotYet(f"a function is asked, you have {_show(yours)}.")
    name = getattr(yours, "__name__", "your function")
    for case, arguments in cases.items():
        right, refused = _call(expected, arguments)
        given = copy.deepcopy(arguments)
        with _unavailable(without, yours):
            result, error = _call(yours, given)
        if isinstance(error, NotYet):
            raise error
        if refused is not None:
            if not isinstance(error, ValueError):
                got = f"returns {_show(result)}" if error is None else f"raises {error!r}"
                raise NotYet(
                    f"{name} {got} for {case}. There is no answer in this case: "
                    "raise a ValueError that says so."
                )
            continue
        if error is not None:
            raise NotYet(f"{name} stops for {case} with {_describe(error)}.")
        if result is None or result is ...:
            raise NotYet(f"{name}: there is no answer yet. It returns nothing for {case}.")
        _require_kind(f"{name}, {case}", result, right)
        if not _same(result, right, rtol):
            outcomes = {
                why: outcome
                for why, wrong in (mistakes or {}).items()
                for outcome, failed in [_call(wrong, arguments)]
                if failed is None and not _same(right, outcome, rtol)
            }
            raise NotYet(
                f"{name} is wrong for {case}: it returns {_show(result)}."
                f"{_diagnosis(result, outcomes, rtol)}"
            )
        if not _same(given, arguments, 1e-15):
            raise NotYet(f"{name} changes its input for {case}. Work on a copy.")


def test_function(yours, right, wrong, without=()):
    """Check a test that the student designed: right code must pass it, wrong code must not.

    Parameters
    ----------
    yours : callable
        Takes an implementation and raises an ``AssertionError`` if it is wrong.
    right, wrong : dict of str to callable
        Implementations by what they do.
    without : tuple of callable
        Library functions that would settle it, which the test must not call. The
        implementations may.

    Raises
    ------
    NotYet
        With the implementation that the test misjudges.

    Examples
    --------
    >>> from amrmetrics import check
    >>> def is_positive(square):
    ...     assert square(-2) > 0
    >>> check.test_function(is_positive, {"x * x": lambda x: x * x}, {"x": lambda x: x})
    """
    if not callable(yours):
        raise NotYet(f"a function is asked, you have {_show(yours)}.")
    _require_acceptance(yours, right, without)
    for what, implementation in wrong.items():
        result, error, _ = _judgment(yours, implementation, without)
        if error is None:
            hint = "" if result is None else f" It returns {_show(result)}; use assert instead."
            raise NotYet(f"your test accepts an implementation that {what}.{hint}")
        if not isinstance(error, AssertionError):
            raise NotYet(
                f"your test breaks with {_describe(error)} on an implementation that {what}. "
                "It should end with a failed assertion."
            )
    # Once more: some tests only count how often they ran.
    _require_acceptance(yours, right, without)


def _require_acceptance(yours, right, without):
    for what, implementation in right.items():
        _, error, called = _judgment(yours, implementation, without)
        if error is not None:
            failed = isinstance(error, AssertionError)
            how = "rejects" if failed else f"breaks with {_describe(error)} on"
            why = f": {error}" if failed and str(error) else ""
            raise NotYet(f"your test {how} an implementation that is right ({what}){why}.")
        if not called:
            raise NotYet("there is no answer yet: your test never calls what it is to test.")


def _judgment(yours, implementation, without):
    """Return what a student's test returns and raises, and whether it called what it tests.

    Right and wrong implementations come in the same wrapping, so that no test can tell them by it.
    """
    called = False
    running = []

    def tested(*arguments, **options):
        nonlocal called
        called = True
        running.append(True)
        try:
            return implementation(*arguments, **options)
        finally:
            running.pop()

    with _unavailable(without, yours, running):
        result, error = _call(yours, (tested,))
    if isinstance(error, NotYet):
        raise error
    return result, error, called


test_function.__test__ = False  # for pytest, which takes every test_* for a test


def formula(name, yours, expected, domains, into="{}", mistakes=None, without=()):
    """Check a formula that was entered as text, or as a SymPy object.

    Parameters
    ----------
    name : str
        What is asked, as the student knows it.
    yours : str or SymPy object
        The student's formula.
    expected : str
        A formula that it must equal on the whole domain, in a form that does not show it.
    domains : dict of str to str, or amrmetrics.derivation.written.Declaration
        What each symbol stands for, as in :func:`amrmetrics.derivation.check_step`; or what
        `declare` returned, whose abbreviations the student may use.
    into : str
        Where the answer is put before it is compared: ``{}`` stands for it.
    mistakes : dict of str to str, optional
        What comes out instead of `expected`, by the misconception that leads there.
    without : tuple of str
        Operators that the answer must have carried out, such as ``"Derivative"``.

    Raises
    ------
    NotYet
        With a point at which the formula is wrong, or the misconception, if it is a known one.

    Examples
    --------
    >>> from amrmetrics import check
    >>> check.formula("the slope", "2*x", "Derivative(x**2, x)", {"x": "real"})
    """
    from amrmetrics.derivation import check_step

    entered = _as_text(name, yours)
    yours = getattr(domains, "expand", str)(entered)
    known, domains = _names_of(domains), getattr(domains, "domains", domains)
    if re.search(r"(?<![=<>!])=(?!=)|^\s*Eq\(", yours):
        raise NotYet(f"{name}: enter the right side alone, without an equals sign and a left side.")
    alone = check_step(yours, yours, domains)
    if alone.status == "unreadable":
        said = _with_names(alone.message, known)
        if "invalid syntax" in said:
            said += ". Write * between factors."
        raise NotYet(f"{name} is {said}")
    for operator in without:
        if operator in yours:
            raise NotYet(f"{name}: {operator} still stands in your formula. Carry it out.")
    outcome = into.format(f"({yours})")
    verdict = check_step(expected, outcome, domains)
    if verdict.status in ("proved", "sampled"):
        return
    for why, wrong in (mistakes or {}).items():
        if check_step(outcome, wrong, domains).status in ("proved", "sampled"):
            raise NotYet(f"{name}: {entered} is not right. It looks as if {why}.")
    if verdict.status != "refuted":
        raise NotYet(f"{name}: {_show(entered)} cannot be checked ({verdict.message}).")
    sequences = "[" in yours  # their values say nothing about an answer without them
    point = ", ".join(f"{k} = {v}" for k, v in verdict.witness.items() if sequences or "[" not in k)
    raise NotYet(
        f"{name}: {entered} is not right. At {point} it makes {into.format(name)} equal to "
        f"{verdict.after_value} instead of {verdict.before_value}."
    )


def derivation(
    lines, goal, *, given, domains=None, declared=None, at_least=1, shows=None, name="", **rules
):
    """Check a derivation that was entered line by line.

    Parameters
    ----------
    lines : str or list
        The student's lines, without the given one: a text in the written form, in which signs and
        reasons may be left out, or a list of lines or of pairs (line, reason).
    goal, given : str
        The last line and the one to start from.
    domains : dict of str to str, optional
        What each symbol stands for, as in :class:`amrmetrics.derivation.Derivation`.
    declared : amrmetrics.derivation.written.Declaration, optional
        What `declare` returned, instead of `domains`.
    at_least : int
        How many lines with a form of their own the derivation takes if each makes one move.
    shows : dict of str to callable, optional
        What some line has to show, by what a student reads if none does. Each is called with
        the line before and the line, SymPy objects in which nothing is computed; see `terms`,
        `one_change` and `limit_by_rules`.
    name : str
        What the derivation is called; it stands before whatever is said.
    **rules
        Further arguments of Derivation, such as ``must_pass``. A notebook that shows a
        required form shows a line of the answer; `at_least` does not.

    Returns
    -------
    amrmetrics.derivation.Derivation
        The checked chain, to be shown.

    Raises
    ------
    NotYet
        With the first line that fails and a counterexample, or with what is missing.

    Examples
    --------
    >>> from amrmetrics import check
    >>> D = check.derivation(
    ...     ["x**2 + 2*x + 1"], "x**2 + 2*x + 1", given="(x + 1)**2", domains={"x": "real"}
    ... )
    >>> D.complete
    True
    """
    from amrmetrics.derivation import Derivation

    names = domains if declared is None else declared
    try:
        _require_answer("the derivation", lines)
        chain = Derivation(goal, given=given, domains=names, **rules).check(_lines_of(lines))
        _require_derived(chain, names, at_least, shows or {})
    except NotYet as error:
        raise NotYet(f"{name}: {error}" if name else str(error)) from None
    return chain


def _require_derived(chain, names, at_least, shows):
    """Raise unless a chain is complete, takes its steps one by one and shows what it should."""
    asked = chain.asked
    if asked in ("<", ">") and asked not in [step.relation for step in chain.steps]:
        raise NotYet(f"lines begin with = or {asked}, and none of yours with {asked}.")
    if not chain.complete:
        first = chain.problems[0]  # what follows it is often its consequence
        raise NotYet(_with_names(first, _names_of(names)))
    if chain.moves < at_least:
        raise NotYet(
            f"every line follows, but you leap: {chain.moves} of at least {at_least} lines bring "
            "something new. Make one move a line."
        )
    pairs = list(itertools.pairwise(map(_by_names, chain.read_lines)))
    for missing, shown in shows.items():
        if not any(shown(before, line) for before, line in pairs):
            raise NotYet(f"every line follows, but {missing}.")


def _by_names(line):
    """Return a line whose symbols have their names alone: a SymPy object may bring assumptions."""
    import sympy as sp

    names = {x: sp.Symbol(x.name) for x in line.free_symbols if x.is_Symbol}
    # To replace a symbol is to compute, so leave a line alone in which there is none to replace.
    return line.xreplace({x: plain for x, plain in names.items() if x != plain})


def terms(line):
    """Return the terms of a line: sums multiplied out, like terms put together, the rest as it is.

    Parameters
    ----------
    line : SymPy object
        A formula in which nothing is computed, such as `derivation` hands to `shows`.

    Returns
    -------
    list of SymPy object
        The terms, in the order in which they stand; none that the others cancel.

    Examples
    --------
    >>> import sympy as sp
    >>> x, y = sp.symbols("x y")
    >>> terms(sp.Mul(2, x - y, evaluate=False))
    [2*x, -2*y]
    >>> terms(sp.Add(x, 1, -1, evaluate=False))
    [x]
    """
    import sympy as sp

    from amrmetrics.derivation.forms import key

    found = {}
    for factors in _multiplied_out(line):
        numbers = [f.doit() for f in factors if f.is_number]
        letters = [f for f in factors if not f.is_number]
        like = tuple(sorted((key(f) for f in letters), key=repr))
        before, _ = found.get(like, (0, None))
        found[like] = before + sp.prod(numbers), letters
    parts = [([] if n == 1 else [n]) + letters for n, letters in found.values() if n != 0]
    return [sp.Mul(*factors, evaluate=False) if factors else sp.S.One for factors in parts]


def _multiplied_out(line):
    """Return the terms of a line, each as the list of its factors."""
    if line.is_Add:
        return [factors for part in line.args for factors in _multiplied_out(part)]
    if not line.is_Mul:
        return [[line]]
    choices = [_multiplied_out(factor) for factor in line.args]
    products = itertools.product(*choices)
    return [list(itertools.chain.from_iterable(chosen)) for chosen in products]


def one_change(before, after):
    """Whether one term, factor, numerator or denominator differs, and something stays as it is.

    That is what makes an inequality visible: the reader compares the two parts alone.

    Parameters
    ----------
    before, after : SymPy object
        Two lines in which nothing is computed.

    Returns
    -------
    bool

    Examples
    --------
    >>> import sympy as sp
    >>> x, y = sp.symbols("x y")
    >>> one_change(x / (x + y), x / y), one_change(x / (x + y), sp.S.One)
    (True, False)
    """
    import sympy as sp

    written_one = after.is_Mul and sp.S.One in after.args
    before, after = _without_detours(before), _without_detours(after)
    old, new = (Counter(map(_spelled, terms(w))) for w in (before, after))
    if old & new and (old - new).total() <= 1 and (new - old).total() <= 1 and old != new:
        return True
    above, below = zip(_fraction_of(before), _fraction_of(after), strict=True)
    changed = [old != new for old, new in (above, below)]
    stays = any(old & new for old, new in (above, below))
    replaced_by_one = written_one and not any(new - old for old, new in (above, below))
    return stays and (sum(changed) == 1 or (all(changed) and replaced_by_one))


def _spelled(w):
    from amrmetrics.derivation.forms import key

    return repr(key(w))


def _without_detours(w):
    """Return a line without terms that cancel each other, also within its factors."""
    import sympy as sp

    if w.is_Add:
        parts = [_without_detours(term) for term in terms(w)]
        return sp.Add(*parts, evaluate=False) if len(parts) > 1 else sum(parts, sp.S.Zero)
    if w.is_Mul or w.is_Pow:
        return w.func(*map(_without_detours, w.args), evaluate=False)
    return w


def _fraction_of(w):
    """Return the factors above and below the line of a fraction, counted; ones are left out."""
    above, below = [], []
    for factor in _factors_of(w):
        under = factor.is_Pow and factor.exp.is_number and factor.exp.is_negative
        if factor != 1:
            (below if under else above).append(_spelled(factor))
    return Counter(above), Counter(below)


def _factors_of(w):
    return [f for part in w.args for f in _factors_of(part)] if w.is_Mul else [w]


def limit_by_rules(line):
    """Whether the rules for sums, products and quotients settle every limit that a line has.

    They do not where a line leads to infinity over infinity, zero over zero, zero times infinity
    or a difference of infinities.

    Parameters
    ----------
    line : SymPy object
        A line in which nothing is computed.

    Returns
    -------
    bool
        False also for a line without a limit.

    Examples
    --------
    >>> import sympy as sp
    >>> x = sp.Symbol("x")
    >>> limit_by_rules(sp.Limit(x / (1 + x), x, sp.oo))
    False
    >>> limit_by_rules(sp.Limit(1 / (1 / x + 1), x, sp.oo))
    True
    """
    import sympy as sp

    limits = line.atoms(sp.Limit)
    values = [_by_rules(*limit.args[:3]) for limit in limits]
    return bool(limits) and all(value not in (None, sp.oo) for value in values)


def _by_rules(w, x, end):
    """Return what a formula tends to, infinity of either sign as oo; None where no rule says it."""
    import sympy as sp

    if isinstance(w, sp.Derivative):
        w = w.doit()
    if not w.has(x):
        return w.doit()
    if w == x:
        return abs(end)
    parts = [_by_rules(part, x, end) for part in w.args]
    infinite = parts.count(sp.oo)
    if None in parts:
        return None
    if w.is_Add and infinite < 2:
        return sp.oo if infinite else sp.Add(*parts)
    vanishing = [part != sp.oo and sp.simplify(part) == 0 for part in parts]
    if w.is_Mul and not (infinite and any(vanishing)):
        return sp.oo if infinite else sp.Mul(*parts)
    if w.is_Pow and parts[1].is_number and parts[1] != 0:
        grows = parts[1].is_positive
        if infinite or vanishing[0]:
            return sp.oo if grows == bool(infinite) else sp.S.Zero
        return sp.Pow(*parts)
    return None


def _lines_of(lines):
    """Return the lines of a derivation as they were entered, without the dots of the exercise."""
    if isinstance(lines, str):
        entered = [line for line in lines.splitlines() if line.strip(" .")]
    elif isinstance(lines, list | tuple | np.ndarray):
        entered = [line for line in lines if line is not ...]
    else:
        raise NotYet(f"a list of lines is asked, one string each; you have {_show(lines)}.")
    if not entered:
        raise NotYet("the derivation: there is no answer yet. Enter one line per row or string.")
    for number, line in enumerate(entered, 1):
        pair = isinstance(line, tuple | list) and len(line) == 2
        text = line[0] if pair else line
        if not hasattr(text, "free_symbols"):  # SymPy's objects are lines as well
            _require_kind(f"line {number}", text, "text")
    return lines if isinstance(lines, str) else entered


def wrong_line(number, corrected, lines, domains):
    """Check that the mistake in a given derivation was found and put right.

    Number and line have to be right at once, and of a wrong answer only the student's own
    line is judged: otherwise one could try all numbers.

    Parameters
    ----------
    number : int
        The line that does not follow from the one above it, counted from 1.
    corrected : str or SymPy object
        What the student writes in its place.
    lines : list of str
        The given derivation, with one wrong step.
    domains : dict of str to str
        What each symbol stands for, as in :func:`amrmetrics.derivation.check_step`.

    Raises
    ------
    NotYet
        With what is wrong with the student's line, or that one of the two is wrong.

    Examples
    --------
    >>> from amrmetrics import check
    >>> lines = ["x*(x + 1)", "x**2 + 1", "1 + x**2"]
    >>> check.wrong_line(2, "x**2 + x", lines, {"x": "real"})
    """
    from amrmetrics.derivation import Derivation, check_step

    _require_answer("the number of the line", number)
    _require_answer("the corrected line", corrected)
    if isinstance(number, bool) or np.ndim(number) or number not in range(2, len(lines) + 1):
        raise NotYet(
            f"the number of the line: a whole number from 2 to {len(lines)} is asked, you have "
            f"{_show(number)}. The first line is given."
        )
    corrected = _as_text("the corrected line", corrected)
    number = int(number)
    above, given = lines[number - 2 : number]
    step = check_step(above, corrected, domains)
    if step.status != "unreadable":
        for k, line in enumerate(lines, 1):
            if Derivation(corrected, given=line, domains=domains).reached:
                raise NotYet(f"the corrected line: this is line {k} as it stands.")
    if step.status not in ("proved", "sampled"):
        said = _with_names(step.message, domains)
        raise NotYet(f"the corrected line, compared with line {number - 1}: {said}")
    if check_step(above, given, domains).status != "refuted":
        raise NotYet(
            f"the corrected line follows from line {number - 1}, but that is not all: line "
            f"{number} was right as it stood."
        )


def _names_of(declared):
    """Return the names of a dict of domains, or of what `declare` returned."""
    return getattr(declared, "names", declared)


def _with_names(message, names):
    """Tell a student, who cannot declare a name, which names there are."""
    if "is not declared" not in message:
        return message
    message = message.replace("; declare it in the domains", ".")
    return f"{message} This part knows the names {', '.join(names)} only."


def _call(function, arguments):
    """Return (result, None) or (None, the exception)."""
    try:
        return function(*arguments), None
    except (Exception, SystemExit) as error:  # students' code may raise anything
        return None, error


@contextlib.contextmanager
def _unavailable(forbidden, yours, running=()):
    """Let `forbidden` functions refuse every call that `yours` makes, by whatever name.

    While `running` is not empty, code that is not the student's runs, and may call them.
    """
    holders = [vars(m) for name, m in sys.modules.items() if name.split(".")[0] == "amrmetrics"]
    holders.append(getattr(yours, "__globals__", {}))
    places = [
        (names, name, original)
        for names in holders
        for name, original in list(names.items())
        if any(original is function for function in forbidden)
    ]
    try:
        for names, name, original in places:
            names[name] = _refusing(original, running)
        yield
    finally:
        for names, name, original in places:
            names[name] = original


def _refusing(original, running):
    def refuse(*arguments, **options):
        if running:
            return original(*arguments, **options)
        raise NotYet(f"the library's {original.__name__} would do your work here; do without it.")

    return refuse


def _describe(error):
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__


def _require_answer(name, yours):
    if yours is ... or yours is None:
        raise NotYet(f"{name}: there is no answer yet. Replace the dots.")


def _as_text(name, yours):
    """Return a formula as text, also if it was entered as a SymPy object."""
    _require_answer(name, yours)
    if not isinstance(yours, str) and hasattr(yours, "free_symbols"):
        return str(yours)
    _require_kind(name, yours, "text")
    if not yours.strip(" .\n"):
        _require_answer(name, ...)
    return yours


def _require_kind(name, yours, expected):
    """Raise unless the answer has the type and shape that is asked."""
    if isinstance(expected, str | bool):
        if not isinstance(yours, str | bool | np.bool_) or isinstance(yours, str) != isinstance(
            expected, str
        ):
            kind = "a string" if isinstance(expected, str) else "True or False"
            raise NotYet(f"{name}: {kind} is asked, you have {_show(yours)}.")
    elif isinstance(expected, tuple):
        if not isinstance(yours, tuple | list) or len(yours) != len(expected):
            raise NotYet(
                f"{name}: a tuple of {len(expected)} results is asked, you have {_show(yours)}."
            )
        for k, (mine, right) in enumerate(zip(yours, expected, strict=True)):
            _require_kind(f"{name}, result {k + 1}", mine, right)
    else:
        try:
            found = np.asarray(yours)
            if yours is None or found.dtype.kind in "bcSU":  # NumPy would read "2" as 2.0
                raise TypeError
            found = found.astype(float)
        except OverflowError:
            raise NotYet(f"{name}: you have a number beyond all doubles.") from None
        except (TypeError, ValueError):
            raise NotYet(f"{name}: numbers are asked, you have {_show(yours)}.") from None
        if found.shape != np.shape(expected):
            asked = f"shape {np.shape(expected)}" if np.shape(expected) else "one number"
            raise NotYet(f"{name}: {asked} is asked, you have {_show(yours)}.")
        if expected is not ... and np.isfinite(expected).all() and not np.isfinite(found).all():
            raise NotYet(f"{name}: you have {_show(yours)}, which is not finite.")


def _same(a, b, rtol):
    if b is ...:
        return True
    if isinstance(b, tuple | list):
        return len(a) == len(b) and all(_same(x, y, rtol) for x, y in zip(a, b, strict=True))
    if isinstance(b, str | bool):
        return a == b
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    scale = np.abs(b[np.isfinite(b)]).max(initial=0.0) or 1.0
    return a.shape == b.shape and bool(np.allclose(a, b, rtol=0, atol=rtol * scale, equal_nan=True))


def _diagnosis(yours, mistakes, rtol):
    for why, outcome in (mistakes or {}).items():
        try:
            if _same(yours, outcome, rtol):
                return f" It looks as if {why}."
        except (TypeError, ValueError):
            continue
    return ""


def _show(answer):
    """Write an answer as a student would, in at most 80 characters."""
    if isinstance(answer, np.ndarray | np.generic):
        answer = answer.tolist()
    if isinstance(answer, tuple | list):
        text = ", ".join(map(_show, answer))
        text = f"({text})" if isinstance(answer, tuple) else f"[{text}]"
    else:
        text = f"{answer:.6g}" if isinstance(answer, float) else " ".join(repr(answer).split())
    return text if len(text) < 80 else text[:77] + "..."
