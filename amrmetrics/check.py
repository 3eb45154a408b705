"""Feedback in problem sets: what is wrong with an answer, without giving the answer away.

Each check returns nothing when the answer is right and raises :class:`NotYet` when it
is not. A check tries the answer on many cases, says on which one it fails, and, when
the result is one that a known mistake produces, names the mistake.

:func:`part` runs the checks of a part where no name of the student's reaches them, on what
:func:`keep` has kept.
"""

import builtins
import contextlib
import copy
import functools
import hashlib
import inspect
import itertools
import re
import sys
import types
import warnings
from collections import Counter
from numbers import Number

import numpy as np

from amrmetrics import _progress
from amrmetrics._progress import model_answer as model_answer

GIVEN = "__given__"


class NotYet(AssertionError):
    """The answer is missing or wrong; the message is written for the student."""

    def _render_traceback_(self):
        # Jupyter calls this instead of printing the traceback: the lines of this
        # module say nothing to a student.
        return [f"Not yet: {self}"]


def keep(namespace, names):
    """Remember what a problem set gives, at the end of the cell that gives it.

    Parameters
    ----------
    namespace : dict
        The notebook's ``globals()``.
    names : str
        The names that the cell has made, imported ones included, with spaces between them.

    Examples
    --------
    >>> from amrmetrics import check
    >>> notebook = {"times": [3, 1, 2]}
    >>> check.keep(notebook, "times")
    >>> notebook["times"].sort()
    >>> check.restore(notebook)
    ['times']
    >>> notebook["times"]
    [3, 1, 2]
    """
    new = {name: namespace[name] for name in names.split()}
    made, kept = namespace.get(GIVEN, ({}, {}))
    namespace[GIVEN] = made | new, kept | _renewed(new, namespace, namespace)


def restore(namespace):
    """Give the names that a problem set gives the values that they had.

    Parameters
    ----------
    namespace : dict
        The notebook's ``globals()``.

    Returns
    -------
    list of str
        The names that had another value.
    """
    if GIVEN not in namespace:
        return []
    made, kept = namespace[GIVEN]
    changed = [
        name
        for name in made
        if namespace.get(name) is not made[name] or not _unchanged(made[name], kept[name])
    ]
    again = _renewed({name: kept[name] for name in changed}, namespace, namespace)
    namespace.update(again)
    made.update(again)
    return changed


def _renewed(x, old, new):
    """Return a copy in which no array and no container is shared.

    Functions that look up names in `old` look them up in `new`.
    """
    kind = type(x)
    if kind is dict:
        return {key: _renewed(value, old, new) for key, value in x.items()}
    if kind in (list, tuple):
        return kind(_renewed(value, old, new) for value in x)
    if kind is types.FunctionType and x.__globals__ is old:
        again = types.FunctionType(x.__code__, new, x.__name__, x.__defaults__, x.__closure__)
        again.__kwdefaults__ = x.__kwdefaults__
        return functools.update_wrapper(again, x)
    if kind in (types.ModuleType, type):
        return x
    try:
        return copy.deepcopy(x)
    except Exception:  # an open file, say: nothing that could be given twice
        return x


def _unchanged(x, kept):
    if isinstance(x, dict) and isinstance(kept, dict):
        return list(x) == list(kept) and all(_unchanged(x[key], kept[key]) for key in kept)
    if isinstance(x, list | tuple) and isinstance(kept, list | tuple):
        return len(x) == len(kept) and all(map(_unchanged, x, kept))
    if isinstance(x, np.ndarray) and isinstance(kept, np.ndarray):
        return x.dtype == kept.dtype and x.shape == kept.shape and x.tobytes() == kept.tobytes()
    return type(x) is type(kept) and (not isinstance(x, str | Number) or x == kept)


def part(namespace):
    """Run the checks of a part on the student's answers; a decorator that calls at once.

    The function's parameters are the names that are asked, its body is the check. In the body
    stand, besides them, only the names that :func:`keep` has kept, as they were, whatever the
    student has done to them. Warnings cost nothing, and the names given are restored.

    Parameters
    ----------
    namespace : dict
        The notebook's ``globals()``.

    Returns
    -------
    callable
        The decorator, which leaves None in the function's place.

    Raises
    ------
    NotYet
        What the check says.

    Examples
    --------
    >>> from amrmetrics import check
    >>> notebook = {"side": 3, "len": "a student may take any name"}
    >>> check.keep(notebook, "side")
    >>> notebook["area"] = 9
    >>> @check.part(notebook)
    ... def check_a(area):
    ...     check.value("area", area, side**2)
    """

    def run(body):
        names = list(inspect.signature(body).parameters)
        answers = [namespace.get(name, ...) for name in names]
        _, kept = namespace.get(GIVEN, ({}, {}))
        space = {"__name__": "__main__", "__builtins__": builtins, "check": sys.modules[__name__]}
        space |= _renewed(kept, namespace, space)
        check = types.FunctionType(body.__code__, space, body.__name__)
        try:
            with _harmless():
                if all(answer is ... for answer in answers):
                    raise NotYet("there is no answer yet. Replace the dots.")
                check(*answers)
        except NotYet as error:
            changed = restore(namespace)
            _record(body.__name__, answers, held=False)
            raise NotYet(f"{error}{_if_changed(changed)}") from None
        finally:
            restore(namespace)
        _record(body.__name__, answers, held=True)

    return run


def _record(name, answers, held):
    text = "\n".join(map(_text_of, answers))
    said = _progress.record(name.removeprefix("check_"), text, held)
    if said:
        print(said)


def _if_changed(changed):
    if not changed:
        return ""
    return (
        f" (You had given {', '.join(changed)} another value. They are as given again: if this "
        "part needs them, run its cell once more.)"
    )


@contextlib.contextmanager
def _harmless():
    """Let warnings pass unseen: what a check writes to stderr costs its marks with nbgrader."""
    with (
        warnings.catch_warnings(action="ignore"),
        np.errstate(all="ignore"),
        contextlib.redirect_stderr(sys.stdout),
    ):
        yield


def draws(*answers):
    """Return a generator of random numbers whose seed is what the answers say.

    The same answer meets the same cases whenever it is checked, and another answer meets others:
    results that were typed in for the cases of one do not fit those of the next.

    Parameters
    ----------
    *answers : object
        Functions of the student's, or values.

    Returns
    -------
    numpy.random.Generator

    Examples
    --------
    >>> from amrmetrics import check
    >>> first, second = (check.draws(lambda x: x + 1).random() for _ in range(2))
    >>> first == second, first == check.draws(lambda x: x + 2).random()
    (True, False)
    """
    text = "\n".join(map(_text_of, answers))
    return np.random.default_rng(list(hashlib.sha256(text.encode()).digest()))


def _text_of(answer):
    """Return what an answer says: its code, without names of files and places in memory."""
    if hasattr(answer, "__answer__"):  # a function of another process, which has its cell's text
        return str(answer.__answer__)
    code = answer if isinstance(answer, types.CodeType) else getattr(answer, "__code__", None)
    if not isinstance(code, types.CodeType):
        return repr(answer)
    return repr((code.co_code, code.co_names, [*map(_text_of, code.co_consts)]))


def value(name, yours, expected, mistakes=None, rtol=1e-6):
    """Check a number, an array, a word, a truth value or several of them.

    Lists, tuples and arrays are the same, and so are numbers of Python, NumPy and SymPy, 1 and
    True, words in capitals and in small letters.

    Parameters
    ----------
    name : str
        What is asked, as the student knows it.
    yours : object
        The student's answer; ``...`` stands for none.
    expected : object
        The right answer; it is never shown. A tuple stands for results of several kinds.
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
    yours = _alike(yours, expected)
    if isinstance(yours, np.ndarray) and yours.squeeze().shape == np.shape(expected):
        yours = yours.squeeze()  # a column for a row, one number in brackets
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
        with _unavailable(without):
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
        result = _alike(result, right)
        _require_kind(f"{name}, {case}", result, right)
        if not _same(result, right, rtol):
            why = _misconception(yours, cases, expected, case, mistakes or {}, rtol, without)
            raise NotYet(f"{name} is wrong for {case}: it returns {_show(result)}.{why}")
        if not _same(given, arguments, 1e-15):
            raise NotYet(f"{name} changes its input for {case}. Work on a copy.")


def _misconception(yours, cases, expected, failing, mistakes, rtol, without):
    """Name the mistake that gives the student's result in the failing case, and in most others.

    One case alone may give two different mistakes the same result.
    """

    right = {case: _call(expected, copy.deepcopy(given)) for case, given in cases.items()}
    answered = [case for case, (_, refused) in right.items() if refused is None]

    def results(function):
        found = {}
        for case in answered:
            outcome, error = _call(function, copy.deepcopy(cases[case]))
            found[case] = None if error else _alike(outcome, right[case][0])
        return found

    with _unavailable(without):
        mine = results(yours)
    for why, wrong in mistakes.items():
        outcomes = results(wrong)
        votes = [
            _agrees(mine[case], outcome, rtol)
            for case, outcome in outcomes.items()
            if outcome is not None and not _agrees(right[case][0], outcome, rtol)
        ]
        if _agrees(mine[failing], outcomes[failing], rtol) and sum(votes) > len(votes) / 2:
            return f" It looks as if {why}."
    return ""


def _agrees(yours, outcome, rtol):
    try:
        return yours is not None and _same(yours, outcome, rtol)
    except (TypeError, ValueError):
        return False


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
    try:
        _require_acceptance(yours, right, without)
    except NotYet as error:
        taken = [what for what, f in wrong.items() if not _judgment(yours, f, without)[1]]
        instead = f" It accepts one that {taken[0]}." if len(taken) == 1 else ""
        raise NotYet(f"{error}{instead}") from None
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

    with _unavailable(without, running):
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
    number = _as_line_number(number, len(lines))
    spelled = isinstance(corrected, str)
    corrected = _as_text("the corrected line", corrected).strip().removeprefix("=")
    above, given = lines[number - 2 : number]
    step = check_step(above, corrected, domains)
    follows = step.status in ("proved", "sampled")
    wrong_above = check_step(above, given, domains).status == "refuted"
    if step.status != "unreadable" and spelled:  # SymPy may have brought an object to this form
        for k, line in enumerate(lines, 1):
            if Derivation(corrected, given=line, domains=domains).reached:
                raise NotYet(f"the corrected line: this is line {k} as it stands.")
    if not follows:
        later = not wrong_above and step.status != "unreadable"
        if later and check_step(lines[0], corrected, domains).status in ("proved", "sampled"):
            raise NotYet(
                f"the corrected line equals line 1, as it should. But line {number}, which you "
                f"blame, does follow from line {number - 1}, and carries on what is wrong there."
            )
        said = _with_names(step.message, domains)
        raise NotYet(f"the corrected line, compared with line {number - 1}: {said}")
    if not wrong_above:
        raise NotYet(
            f"the corrected line follows from line {number - 1}, but that is not all: line "
            f"{number} was right as it stood."
        )


def _as_line_number(number, last):
    """Return the number of a line other than the first, also if it was entered as text."""
    text = str(number).strip() if isinstance(number, str | Number | np.ndarray) else ""
    if text.removesuffix(".0").isdigit() and not isinstance(number, bool):
        found = int(text.removesuffix(".0"))
        if 2 <= found <= last:
            return found
    raise NotYet(
        f"the number of the line: a whole number from 2 to {last} is asked, you have "
        f"{_show(number)}. The first line is given."
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
def _unavailable(forbidden, running=()):
    """Let `forbidden` functions and classes refuse every call that a student's function makes.

    Calls are watched, and not names, so that no default argument, closure, reload or private
    function behind it leads around. While `running` is not empty, code that is not the student's
    runs, and may call them.
    """
    classes = tuple(target for target in forbidden if isinstance(target, type))
    names = {
        (worker.__code__.co_filename, worker.__code__.co_name): target.__name__
        for target in reversed(forbidden)  # what two of them call counts for the first
        for worker in workers_of(target)
    }

    def watch(frame, event, _):
        if event != "call" or running:
            return
        code = frame.f_code
        name = names.get((code.co_filename, code.co_name))
        if name is None and classes and code.co_name == "__init__":
            made = frame.f_locals.get("self")
            name = type(made).__name__ if isinstance(made, classes) else None
        if name is not None:
            raise NotYet(f"the library's {name} would do your work here; do without it.")

    before = sys.getprofile()
    if names or classes:
        sys.setprofile(watch)
    try:
        yield
    finally:
        sys.setprofile(before)


def workers_of(target):
    """Return a function and those of its module that it calls and that are offered to nobody.

    By these, another function of the library would have its answer as well.
    """
    import amrmetrics

    if not isinstance(target, types.FunctionType):
        return []
    called = (target.__globals__.get(name) for name in target.__code__.co_names)
    return [target] + [
        function
        for function in called
        if isinstance(function, types.FunctionType)
        and function.__module__ == target.__module__
        and getattr(amrmetrics, function.__name__, None) is not function
    ]


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


def _alike(yours, expected):
    """Return an answer in the kind that is expected, if it is of a kind that says the same."""
    if isinstance(yours, np.ndarray) and yours.ndim == 0:
        yours = yours.item()
    if isinstance(expected, tuple):
        several = isinstance(yours, list | tuple) or getattr(yours, "shape", ())
        items = list(yours) if several else ()
        if len(items) != len(expected):
            return yours
        return tuple(_alike(*pair) for pair in zip(items, expected, strict=True))
    if isinstance(expected, bool):
        if getattr(yours, "is_Boolean", False):  # SymPy's
            return bool(yours)
        return bool(yours) if isinstance(yours, Number | np.bool_) and yours in (0, 1) else yours
    if isinstance(expected, str):
        return yours.strip() if isinstance(yours, str) else yours
    exact = hasattr(yours, "free_symbols") or isinstance(yours, list | tuple)
    with contextlib.suppress(TypeError, ValueError):
        if exact and np.asarray(yours).dtype == object:  # SymPy's numbers, or fractions
            return np.asarray(yours).astype(float)
    return yours


def _require_kind(name, yours, expected):
    """Raise unless the answer has the type and shape that is asked."""
    if isinstance(expected, str | bool):
        if not isinstance(yours, str | bool) or isinstance(yours, str) != isinstance(expected, str):
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
    if isinstance(b, str):
        return isinstance(a, str) and a.casefold() == b.casefold()
    if isinstance(b, bool):
        return a == b
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    scale = np.abs(b[np.isfinite(b)]).max(initial=0.0) or 1.0
    return a.shape == b.shape and bool(np.allclose(a, b, rtol=0, atol=rtol * scale, equal_nan=True))


def _diagnosis(yours, mistakes, rtol):
    named = [why for why, wrong in (mistakes or {}).items() if _agrees(yours, wrong, rtol)]
    return f" It looks as if {named[0]}." if named else ""


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
