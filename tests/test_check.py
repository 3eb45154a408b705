"""Feedback in problem sets: right answers pass, wrong ones are told why and nothing more."""

import functools
import importlib.util
import re
import sys
import warnings
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from sympy.parsing.sympy_parser import parse_expr

import amrmetrics as am
from amrmetrics import check
from amrmetrics.check import NotYet
from amrmetrics.derivation import declare


def message(call, *arguments, **options):
    """Return what a student reads, on one line."""
    with pytest.raises(NotYet) as caught:
        call(*arguments, **options)
    text = str(caught.value)
    assert "\n" not in text
    return text


def test_a_student_reads_the_message_and_no_traceback():
    assert NotYet("the sign.")._render_traceback_() == ["Not yet: the sign."]
    assert issubclass(NotYet, AssertionError)


class TestValue:
    @pytest.mark.parametrize(
        ("yours", "expected"),
        [
            (2, 2.0),
            (2.0000001, 2),
            (np.float64(2), 2),
            ([1, 2], np.array([1.0, 2.0])),
            ((1, 2), (1, 2)),
            (0, 0.0),
            ("yes", "yes"),
            (True, True),
            (np.True_, True),
            (float("nan"), float("nan")),
            ((float("inf"), 2), (..., 2)),
            (1, True),
            (0.0, False),
            (sp.true, True),
            (" Yes ", "yes"),
            (np.array(2.0), 2),
            (np.array([2.0]), 2),
            (sp.Rational(5, 2), 2.5),
            (sp.sqrt(2) * 3, 18**0.5),
            ([sp.Rational(1, 2), 1], np.array([0.5, 1])),
            (sp.Matrix([1, 2]), np.array([1, 2])),
            (Fraction(1, 3), 1 / 3),
            ([1, 2], (1, 2)),
            (np.array([1, 2]), (1, 2)),
            (np.array(["a", "b"]), ("a", "b")),
            (np.array([True, False]), (True, False)),
            ([1, 0], (True, False)),
            ([[1, 2], True], (np.array([1, 2]), True)),
        ],
    )
    def test_accepts_what_is_right(self, yours, expected):
        check.value("x", yours, expected)

    @pytest.mark.parametrize(
        ("yours", "expected", "says"),
        [
            (..., 2, "no answer yet"),
            (None, 2, "no answer yet"),
            (2.1, 2, "2.1 is not right"),
            (1e-3, 0, "0.001 is not right"),
            (-2, 2, "-2 is not right"),
            ("2", 2, "numbers are asked, you have '2'"),
            ("two", 2, "numbers are asked"),
            (["1", "2"], [1, 2], "numbers are asked"),
            (2j, 2, "numbers are asked"),
            ([1, 2], 1, "one number is asked, you have [1, 2]"),
            ([1, 2, 3], [1, 2], "shape (2,) is asked"),
            (5, (1, 2), "a tuple of 2 results is asked"),
            ((1, 2, 3), (1, 2), "a tuple of 2 results is asked"),
            (float("nan"), 2, "not finite"),
            (float("inf"), 2, "not finite"),
            (1, "yes", "a string is asked"),
            (2, True, "True or False is asked"),
            ("1", True, "True or False is asked"),
            ({1, 2}, (1, 2), "a tuple of 2 results is asked"),
            ("yes", True, "True or False is asked"),
            (False, True, "False is not right"),
            ("no", "yes", "'no' is not right"),
            (object, 2, "numbers are asked"),
            ((None, 2), (float("nan"), 2), "result 1: numbers are asked, you have None"),
        ],
    )
    def test_says_what_is_wrong(self, yours, expected, says):
        assert says in message(check.value, "x", yours, expected)

    def test_names_the_misconception_and_not_the_answer(self):
        mistakes = {"the sign is turned": -1234.5, "this is in degrees": 70731.6}
        text = message(check.value, "x", -1234.5, 1234.5, mistakes)
        assert text == "x: -1234.5 is not right. It looks as if the sign is turned."
        assert message(check.value, "x", 7, 1234.5, mistakes) == "x: 7 is not right."

    def test_the_tolerance_is_relative(self):
        check.value("x", 1.0005e6, 1e6, rtol=1e-3)
        assert message(check.value, "x", 1.002e6, 1e6, rtol=1e-3)
        assert message(check.value, "x", [1e6, 0.9], [1e6, 1.0], rtol=1e-9)

    def test_long_answers_are_cut(self):
        assert len(message(check.value, "x", "long" * 500, "short")) < 120


def double(x):
    return 2 * x


class TestFunction:
    CASES = {"three": (3.0,), "an array": (np.array([1.0, -2.0]),)}

    def test_accepts_what_is_right(self):
        check.function(lambda x: x + x, self.CASES, double)

    @pytest.mark.parametrize(
        ("yours", "says"),
        [
            (lambda x: x, "wrong for three: it returns 3. It looks as if nothing is doubled."),
            (lambda x: 7.0, "wrong for three: it returns 7."),
            (lambda x: 6.0, "an array: shape (2,) is asked, you have 6"),
            (lambda x: None, "no answer yet"),
            (lambda x: ..., "no answer yet"),
            (lambda x: "6", "numbers are asked"),
            (lambda x: 1 / 0, "stops for three with ZeroDivisionError: division by zero"),
            (lambda: 6, "stops for three with TypeError"),
            (6.0, "a function is asked, you have 6"),
            (..., "a function is asked"),
        ],
    )
    def test_says_what_is_wrong(self, yours, says):
        mistakes = {"nothing is doubled": lambda x: x, "x is zero": lambda x: 1 / 0}
        assert says in message(check.function, yours, self.CASES, double, mistakes)

    def test_survives_code_that_never_ends_or_leaves(self):
        def endless(x):
            return endless(x)

        def leaves(x):
            raise SystemExit

        assert "RecursionError" in message(check.function, endless, self.CASES, double)
        assert "SystemExit" in message(check.function, leaves, self.CASES, double)

    def test_sees_that_the_input_was_changed(self):
        def spoils(x):
            x *= 2
            return x

        cases = {"an array": (np.array([1.0, 2.0]),)}
        assert "changes its input" in message(check.function, spoils, cases, double)
        assert cases["an array"][0].tolist() == [1.0, 2.0]

    def test_demands_the_error_that_the_right_function_raises(self):
        def root(x):
            if x < 0:
                raise ValueError("x is negative")
            return x**0.5

        def other_error(x):
            raise KeyError("x")

        cases = {"a negative number": (-1.0,)}
        check.function(root, cases, root)
        assert "raise a ValueError" in message(check.function, lambda x: 0.0, cases, root)
        assert "raises KeyError" in message(check.function, other_error, cases, root)

    def test_a_mistake_may_leave_a_result_open(self):
        def pair(x):
            return x, 2 * x

        mistakes = {"the first sign is turned": lambda x: (-x, ...)}
        cases = {"three": (3.0,)}
        text = message(check.function, lambda x: (-x, 99.0), cases, pair, mistakes)
        assert text.endswith("It looks as if the first sign is turned.")
        text = message(check.function, lambda x: (x, 99.0), cases, pair, mistakes)
        assert text.endswith("it returns (3, 99).")

    @pytest.mark.parametrize("name", ["am.align", "am.alignment.align", "align"])
    def test_the_function_that_is_to_be_written_cannot_be_called(self, name):
        def answer(p, q):
            return am.align(p, q).angle

        p = np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 1.0]])
        cases = {"a triangle": (p, p @ [[0.6, 0.8], [-0.8, 0.6]])}
        original = am.align
        student = {"am": am, "align": original}
        exec(f"def theirs(p, q):\n    return {name}(p, q).angle", student)
        check.function(student["theirs"], cases, answer)
        text = message(check.function, student["theirs"], cases, answer, without=(original,))
        assert "the library's align would do your work here" in text
        assert am.align is am.alignment.align is student["align"] is original
        check.function(answer, cases, answer)


class TestFormula:
    DOMAINS = {"x": "real", "y": ">0"}

    X, Y = sp.symbols("x y")

    @pytest.mark.parametrize("yours", ["2*x*y", "x*y + y*x", "(2*x)*y", 2 * X * Y, (X + X) * Y])
    def test_accepts_every_form(self, yours):
        check.formula("slope", yours, "Derivative(x**2*y, x)", self.DOMAINS)

    @pytest.mark.parametrize(
        ("yours", "says"),
        [
            (..., "slope: there is no answer yet"),
            (2, "slope: a string is asked, you have 2"),
            ("2*x y", "slope is unreadable"),
            ("2*z", "slope is unreadable: z is not declared. This part knows the names x, y only."),
            ("np.arctan2(y, x)", "slope is unreadable: write atan2, without np."),
            ("slope = 2*x*y", "slope: enter the right side alone"),
            ("Eq(slope, 2*x*y)", "slope: enter the right side alone"),
            ("Derivative(x**2*y, x)", "slope: Derivative still stands in your formula"),
            ("-2*x*y", "slope: -2*x*y is not right. It looks as if the sign is turned."),
            ("x*y", "it makes slope equal to 1 instead of 2."),
        ],
    )
    def test_says_what_is_wrong(self, yours, says):
        mistakes = {"the sign is turned": "-2*x*y"}
        text = message(
            check.formula,
            *("slope", yours, "Derivative(x**2*y, x)", self.DOMAINS),
            mistakes=mistakes,
            without=("Derivative",),
        )
        assert says in text

    def test_may_use_what_is_declared(self):
        letters = declare("x y > 0\n area := x*y")
        check.formula("twice", "2*area", "2*x*y", letters)
        check.formula("twice", "\n 2*area ", "2*x*y", letters)
        text = message(check.formula, "twice", "area + z", "2*x*y", letters)
        assert "z is not declared. This part knows the names x, y, area only." in text

    def test_a_missing_sign_between_factors_is_named(self):
        text = message(check.formula, "slope", "2 x", "2*x", self.DOMAINS)
        assert text.endswith("Write * between factors.")

    @pytest.mark.parametrize("dots", ["...", "  ", "\n ... \n"])
    def test_dots_in_a_text_are_no_answer(self, dots):
        text = message(check.formula, "slope", dots, "2*x", self.DOMAINS)
        assert text == "slope: there is no answer yet. Replace the dots."

    def test_judges_an_angle_by_what_it_leads_to(self):
        into = "C*cos({0}) + S*sin({0})"
        domains = {"C": "real", "S": "real"}
        mistakes = {"this is the opposite": "-sqrt(C**2 + S**2)"}
        task = ("theta", "sqrt(C**2 + S**2)", domains, into, mistakes)

        def judged(yours):
            return message(check.formula, task[0], yours, *task[1:])

        check.formula(task[0], "atan2(S, C)", *task[1:])
        check.formula(task[0], "atan2(S, C) - 2*pi", *task[1:])
        assert "this is the opposite" in judged("atan2(-S, -C)")
        assert "it makes C*cos(theta) + S*sin(theta) equal to" in judged("atan2(C, S)")


class TestWrongLine:
    LINES = ("x*(x + y)", "x**2 + y", "y*(x**2/y + 1)", "(y**2 + x**2*y)/y")
    DOMAINS = {"x": ">0", "y": ">0"}

    @pytest.mark.parametrize("line", ["x**2 + x*y", "y*x + x*x"])
    @pytest.mark.parametrize("number", [2, 2.0, np.int64(2)])
    def test_accepts_the_right_pair(self, number, line):
        check.wrong_line(number, line, self.LINES, self.DOMAINS)

    @pytest.mark.parametrize(
        ("number", "line", "says"),
        [
            (..., "x**2 + x*y", "no answer yet"),
            (2, ..., "no answer yet"),
            (1, "x**2", "a whole number from 2 to 4 is asked"),
            (5, "x**2", "a whole number from 2 to 4 is asked"),
            (2.5, "x**2", "a whole number from 2 to 4 is asked"),
            ([2], "x**2", "a whole number from 2 to 4 is asked"),
            (True, "x**2", "a whole number from 2 to 4 is asked"),
            ("two", "x**2", "a whole number from 2 to 4 is asked"),
            (2.5, "x**2", "a whole number from 2 to 4 is asked"),
            (2, 5, "a string is asked"),
            (2, "2x", "unreadable"),
            (2, "z", "z is not declared"),
            (2, "sqrt(-1 - x**2)", "compared with line 1"),
            (2, "y + x**2", "this is line 2 as it stands"),
            (3, "y*(1 + x**2/y)", "this is line 3 as it stands"),
            (2, "x**2 + 2*y", "compared with line 1: wrong: at x = 1"),
            (2, "(x + y)*x", "this is line 1 as it stands"),
            (3, "y + x**2", "this is line 2 as it stands"),
            (2, "y*(x**2/y + 1)", "this is line 3 as it stands"),
            (3, "x*(y + x)", "this is line 1 as it stands"),
            (3, "(x**3 + x*y)/x", "that is not all"),
            (4, "x*x + y", "this is line 2 as it stands"),
            (4, "(x**3 + x*y)/x", "that is not all"),
        ],
    )
    def test_says_what_is_wrong_with_the_line(self, number, line, says):
        assert says in message(check.wrong_line, number, line, self.LINES, self.DOMAINS)

    def test_takes_sympy_objects(self):
        x, y = sp.symbols("x y")
        wrong = ["x*(x + y)", "x**2 + y", "y + x**2"]
        check.wrong_line(2, x**2 + x * y, wrong, self.DOMAINS)
        assert "compared with line 1" in message(check.wrong_line, 2, x**2 - y, wrong, self.DOMAINS)

    def test_a_wrong_number_and_a_wrong_line_sound_alike(self):
        """Else the number could be found by trying all of them."""
        said = set()
        for k in (2, 3, 4):
            above = self.LINES[k - 2]
            text = message(check.wrong_line, k, f"0 + {above}", self.LINES, self.DOMAINS)
            said.add(re.sub(r"\d", "#", text))
        assert len(said) == 1


class TestTestFunction:
    RIGHT = {"abs": abs}
    WRONG = {"forgets the sign": lambda x: x, "is constant": lambda x: 1}

    def test_accepts_a_test_that_tells_them_apart(self):
        def sound(size):
            assert size(-2) == 2
            assert size(3) == 3

        check.test_function(sound, self.RIGHT, self.WRONG)

    @pytest.mark.parametrize(
        ("yours", "says"),
        [
            (..., "a function is asked"),
            (lambda size: None, "no answer yet: your test never calls"),
            (lambda size: ..., "no answer yet: your test never calls"),
            (lambda size: size(2), "accepts an implementation that forgets the sign"),
            (lambda size: size(-2) == 2, "It returns False; use assert instead"),
            (lambda size: size(), "breaks with TypeError"),
        ],
    )
    def test_says_what_is_wrong(self, yours, says):
        assert says in message(check.test_function, yours, self.RIGHT, self.WRONG)

    def test_a_test_that_rejects_everything_rejects_what_is_right(self):
        def grumpy(size):
            raise AssertionError(f"{size(2)} is not good enough")

        text = message(check.test_function, grumpy, self.RIGHT, self.WRONG)
        assert text == (
            "your test rejects an implementation that is right (abs): 2 is not good enough."
        )

    def test_a_failed_assertion_is_asked_for_not_any_error(self):
        def clumsy(size):
            if size(-2) != 2:
                raise RuntimeError("no")

        text = message(check.test_function, clumsy, self.RIGHT, self.WRONG)
        assert "breaks with RuntimeError: no" in text

    def test_the_second_wrong_implementation_has_to_be_found_too(self):
        def half(size):
            assert size(-1) == 1

        text = message(check.test_function, half, self.RIGHT, self.WRONG)
        assert text == "your test accepts an implementation that is constant."

    def test_sees_a_test_that_only_counts(self):
        seen = []

        def counting(size):
            size(-2)
            seen.append(size)
            if len(seen) > len(self.RIGHT):
                raise AssertionError

        text = message(check.test_function, counting, self.RIGHT, self.WRONG)
        assert "rejects an implementation that is right" in text

    def test_right_and_wrong_look_alike(self):
        def nosy(size):
            size(-2)
            assert size.__name__ != "<lambda>"

        assert "accepts" in message(check.test_function, nosy, self.RIGHT, self.WRONG)

    @pytest.mark.parametrize("name", ["am.yaw", "am.poses.yaw", "yaw"])
    def test_the_library_cannot_be_asked(self, name):
        original = am.yaw
        student = {"am": am, "np": np, "yaw": original}
        kinds = {"the library": lambda X: am.yaw(X)}, {"is 1": lambda X: 1.0}
        exec(f"def theirs(f):\n    assert f(np.eye(3)) == {name}(np.eye(3))", student)
        check.test_function(student["theirs"], *kinds)
        text = message(check.test_function, student["theirs"], *kinds, without=(original,))
        assert text == "the library's yaw would do your work here; do without it."
        assert am.yaw is am.poses.yaw is student["yaw"] is original

    def test_implementations_may_ask_the_library(self):
        def sound(f):
            assert f(np.eye(3)) == 0

        kinds = {"the library": lambda X: am.yaw(X)}, {"adds 1": lambda X: am.yaw(X) + 1}
        check.test_function(sound, *kinds, without=(am.yaw,))


class TestDerivation:
    TASK = {
        "goal": "x**2 + 2*x + 1",
        "given": "(x + 1)**2",
        "domains": {"x": "real"},
        "must_pass": {"one bracket": "x*(x + 1) + x + 1"},
    }
    LINES = ("x*(x + 1) + x + 1", "x**2 + 2*x + 1")

    def test_returns_the_chain_to_be_shown(self):
        assert check.derivation(list(self.LINES), **self.TASK).complete
        assert check.derivation(self.LINES, **self.TASK).complete

    def test_sees_a_leap(self):
        task = {**self.TASK, "at_least": 3, "must_pass": ()}
        text = message(check.derivation, list(self.LINES), **task)
        assert text.startswith("every line follows, but you leap: 2 of at least 3 lines")
        check.derivation([self.LINES[0], "x**2 + x + x + 1", self.LINES[1]], **task)

    @pytest.mark.parametrize(
        "lines",
        [
            "= x*(x + 1) + x + 1  # multiply out\n = x**2 + 2*x + 1  # collect",
            "(x + 1)**2\n = x*(x + 1)\n   + x + 1\n = x**2 + 2*x + 1",
            "x*(x + 1) + x + 1\nx**2 + 2*x + 1",
            ["= x*(x + 1) + x + 1  # multiply out", "= x**2 + 2*x + 1"],
            [("x*(x + 1) + x + 1", "multiply out"), ["x**2 + 2*x + 1", ""]],
            ["x*(x + 1) + x + 1", parse_expr("x**2 + 2*x + 1")],
            np.array(["x*(x + 1) + x + 1", "x**2 + 2*x + 1"]),
        ],
    )
    def test_lines_may_be_entered_in_many_ways(self, lines):
        chain = check.derivation(lines, **self.TASK, at_least=2)
        assert chain.complete and chain.moves == 2

    def test_lines_may_use_what_is_declared(self):
        derive = declare("x real\n y := x + 1")
        task = {"goal": "x**2 + 2*x + 1", "given": "y**2", "declared": derive}
        check.derivation("= x*y + y\n = x**2 + 2*x + 1", **task, at_least=2)
        assert "names x, y only" in message(check.derivation, "= x*y + z", **task)

    def test_some_line_has_to_show_what_is_asked(self):
        def taken_apart(before, line):
            return before.is_Pow and line.is_Add

        told = "no line takes the square apart"
        task = {**self.TASK, "must_pass": (), "shows": {told: taken_apart}}
        check.derivation(list(self.LINES), **task)
        text = message(check.derivation, ["(x + 1)*(x + 1)", self.LINES[1]], **task)
        assert text == f"every line follows, but {told}."

    def test_what_a_line_shows_does_not_depend_on_assumptions_of_its_symbols(self):
        x = sp.Symbol("x", positive=True)
        task = {**self.TASK, "must_pass": ()}
        task["shows"] = {"no sum has x": lambda before, line: line.has(sp.Symbol("x"))}
        check.derivation([(x + 1) * (x + 1), self.LINES[1]], **task)

    def test_says_which_derivation_is_meant(self):
        for lines in (..., 7, ["x + 1"], ["x**2"]):
            assert message(check.derivation, lines, **self.TASK, name="mine").startswith("mine: ")

    def test_a_bound_needs_a_line_with_its_sign(self):
        task = {"goal": "x + 1", "given": "x", "domains": {"x": "real"}, "relation": "<"}
        check.derivation("< x + 1", **task)
        text = message(check.derivation, ["x + 1"], **task)
        assert text == "lines begin with = or <, and none of yours with <."
        both = message(check.derivation, "< x + 2\n > x + 1", **task)
        assert "compose to is nothing" in both

    @pytest.mark.parametrize("padding", ["1*x*(x + 1) + x + 1 + 0", "1 + x + x*(1 + 0 + x)/1"])
    def test_does_not_count_padding(self, padding):
        task = {**self.TASK, "at_least": 3, "must_pass": ()}
        text = message(check.derivation, [self.LINES[0], padding, self.LINES[1]], **task)
        assert "2 of at least 3 lines bring something new" in text

    @pytest.mark.parametrize("last", ["Eq(x, b - a)", "Eq(x, -(a - b))", "Eq((2*b - 2*a)/2, x)"])
    def test_an_equation_may_be_solved_in_any_form(self, last):
        names = dict.fromkeys("abx", "real")
        task = {"goal": "Eq(x, 3*(b - a)/3)", "given": "Eq(2*(x + a), 2*b)", "domains": names}
        check.derivation(["Eq(x + a, b)", last], **task)

    @pytest.mark.parametrize(
        "last",
        ["Eq(x + a, b)", "Eq(-x, a - b)", "Eq(x, 2*b - 2*a - x)", "Eq(x, Subs(b - y, y, a))"],
    )
    def test_an_equation_that_is_not_solved_is_not_the_goal(self, last):
        names = dict.fromkeys("abx", "real")
        task = {"goal": "Eq(x, b - a)", "given": "Eq(2*(x + a), 2*b)", "domains": names}
        assert "the goal is not reached" in message(check.derivation, [last], **task)
        task |= {"goal": "Eq(x, a**2 - b**2)", "given": "Eq(x, (a - b)*(a + b))"}
        text = message(check.derivation, ["Eq(x, a*(a + b) - b*(a + b))"], **task)
        assert "does not have its form yet" in text

    @pytest.mark.parametrize(
        ("lines", "says"),
        [
            ([], "no answer yet"),
            ([...], "no answer yet"),
            (["x*(x + 1) + z"], "z is not declared. This part knows the names x only."),
            (..., "no answer yet"),
            (None, "no answer yet"),
            ("...", "no answer yet"),
            ("  \n", "no answer yet"),
            (7, "a list of lines is asked"),
            ("x**2 + 2*x + 1", "one bracket"),
            ("= x*(x + 1) + x + 1  # out\n = x**2 + 1  # add", "line 2"),
            ("<=> x*(x + 1) + x + 1\n < x**2 + 2*x + 2", "task asks ="),
            ("x*(x + 1) + x + 1\n => x**2 + 2*x + 1", "⇒ stands between two formulas"),
            ([("x*(x + 1) + x + 1", "out"), ("x**2 + 2*x", "add")], "line 2"),
            (["x**2 + 2*x + 1"], "one bracket"),
            (["x*(x + 1) + x + 1"], "goal"),
            (["x*(x + 1) + x + 1", "x**2 + 1", "x**2 + 2*x + 1"], "line 2"),
            (["x*(x + 1) + x + 1", 5], "line 2"),
            (["x*(x + 1) + x + 1", ("2x",)], "line 2"),
        ],
    )
    def test_says_what_is_wrong(self, lines, says):
        assert says in message(check.derivation, lines, **self.TASK)


def written(line):
    """A line as `shows` gets it: nothing is computed."""
    from amrmetrics.derivation import Derivation

    return Derivation("0", given=line, domains=dict.fromkeys("xyzc", ">0")).given.meaning


class TestWhatALineShows:
    @pytest.mark.parametrize(
        ("line", "terms"),
        [
            ("x", ["x"]),
            ("2*c*(1/c - x)", ["2*c/c", "-2*c*x"]),
            ("x*(x + 1)*(y - 2)", ["x*x*y", "-2*x*x", "x*y", "-2*x"]),
            ("x + y - x", ["y"]),
            ("2*y - (2*y - x)", ["x"]),
            ("x/2 + x/2", ["x"]),
            ("1 + x - 1 + 1", ["1", "x"]),
        ],
    )
    def test_terms(self, line, terms):
        from amrmetrics.derivation.forms import key

        assert list(map(key, check.terms(written(line)))) == list(map(key, map(written, terms)))

    @pytest.mark.parametrize(
        ("before", "after"),
        [
            ("2*x/(1 + x/c)", "2*x/(x/c)"),
            ("2*x/(1 + x/c)", "2*c*(1 + x/c)/(1 + x/c)"),
            ("2*c*x/(c + x)", "2*c*x/x"),
            ("2*c*x/(c + x)", "2*c*1"),
            ("2*c/(c/x + 1)", "2*c"),
            ("2*c - 2*c/(1 + x/c)", "2*c"),
            ("2*c*(1 - c/(c + x))", "2*c"),
            ("x + y", "x + y + z"),
            ("x + y", "x + z"),
        ],
    )
    def test_one_change(self, before, after):
        assert check.one_change(written(before), written(after))

    @pytest.mark.parametrize(
        ("before", "after"),
        [
            ("2*x/(1 + x/c)", "2*c"),
            ("2*x/(1 + x/c)", "2*c + x - x"),
            ("2*x/(1 + x/c)", "2*c*(1 + x)/(1 + x)"),
            ("2*c*x/(c + x)", "2*c"),
            ("2*c*x/(c + x)", "2*c*(1 + x)/(1 + x)"),
            ("2*c - (2*c - 2*x/(1 + x/c))", "2*c"),
            ("2*(c - (c - c*x/(c + x)))", "2*c"),
            ("2*x/(1 + x/c)", "2*x/(1 + x/c) + (2*c - 2*c*x/(c + x))"),
            ("x + y", "z"),
            ("x", "y"),
        ],
    )
    def test_more_than_one_change(self, before, after):
        assert not check.one_change(written(before), written(after))

    @pytest.mark.parametrize(
        "line",
        [
            "Limit(2/(1/x + 1/c), x, oo)",
            "2*Limit(1/(1/x + 1/c), x, oo)",
            "Limit(2*c - 2*c/(1 + x/c), x, oo)",
            "Limit(2, x, oo)/Limit(1/x + 1/c, x, oo)",
            "Limit(Derivative(2*x, x)/Derivative(1 + x/c, x), x, oo)",
            "Limit(2/(y + 1/c), y, 0)",
            "Limit((1 + 1/x)**2, x, oo)",
        ],
    )
    def test_limits_that_the_rules_settle(self, line):
        assert check.limit_by_rules(written(line))

    @pytest.mark.parametrize(
        "line",
        [
            "2*c",
            "Limit(2*x/(1 + x/c), x, oo)",
            "Limit(2*x/(1 + x/c) + 3, x, oo) - 3",
            "Limit(2*x, x, oo)/Limit(1 + x/c, x, oo)",
            "Limit(2*(x/x)/(1/x + 1/c), x, oo)",
            "Limit(x*(1/x), x, oo)",
            "Limit(x - (x - c), x, oo)",
            "Limit(sin(y)/y, y, 0)",
        ],
    )
    def test_limits_that_they_leave_open(self, line):
        assert not check.limit_by_rules(written(line))


def test_an_integer_beyond_all_doubles_is_wrong_and_breaks_nothing():
    text = message(check.value, "p", 1 - 1999**1800, 0.5)
    assert text == "p: you have a number beyond all doubles."


SETUP = """
import numpy as np
from amrmetrics import check
p = np.array([[0.0, 0], [1, 2]])
rules = {"square": lambda x: np.square(x)}
def moved(x): return p + x
check.keep(globals(), "np p rules moved")
"""


class TestPart:
    @pytest.fixture
    def notebook(self):
        space = {"__name__": "__main__"}
        exec(SETUP, space)
        return space

    @staticmethod
    def run(notebook, answer, body):
        exec(answer, notebook)
        exec(f"@check.part(globals())\ndef check_a(yours):\n    {body}", notebook)

    @pytest.mark.parametrize(
        "before",
        [
            "p = p - p.mean(axis=0)",
            "p -= 1",
            "p[1, 1] = 7",
            "np = sum = len = moved = 3",
            "rules['square'] = None",
            "rules.clear()",
            "del p, np",
            "from math import *",
            "import warnings; warnings.simplefilter('error')",
            "np.seterr(all='raise')",
        ],
    )
    def test_no_name_of_the_student_reaches_the_check(self, notebook, before):
        body = (
            "check.value('x', [moved(1)[1, 1], rules['square'](3), sum([1, 2]), np.log(0)], yours)"
        )
        with np.errstate(), warnings.catch_warnings():
            self.run(notebook, f"{before}\nyours = [3, 9, 3, -float('inf')]", body)
            assert notebook["moved"](0).tolist() == [[0, 0], [1, 2]]  # as given, for the next part

    def test_says_that_a_given_name_had_another_value(self, notebook):
        with pytest.raises(NotYet, match=r"not right.*had given p another value.*once more"):
            self.run(notebook, "p = 0 * p\nyours = p.sum()", "check.value('sum', yours, p.sum())")
        self.run(notebook, "yours = p.sum()", "check.value('sum', yours, p.sum())")
        with pytest.raises(NotYet, match=r"not right\.$"):
            self.run(notebook, "yours = 4", "check.value('sum', yours, p.sum())")

    def test_a_missing_answer_is_no_answer_yet(self, notebook):
        for answer in ("", "yours = ..."):
            with pytest.raises(NotYet, match="no answer yet"):
                self.run(notebook, answer, "raise AssertionError('ran')")

    def test_leaves_no_name_behind(self, notebook):
        self.run(notebook, "yours = 1", "cases = yours")
        assert "cases" not in notebook
        assert notebook["check_a"] is None

    def test_an_error_of_the_check_is_not_dressed_up(self, notebook):
        with pytest.raises(ZeroDivisionError):
            self.run(notebook, "p = 1\nyours = 1", "1 / 0")
        assert notebook["p"].shape == (2, 2)

    def test_writes_nothing_that_costs_marks(self, notebook, capfd):
        noisy = "import sys, warnings; warnings.warn('x'); print('mine', file=sys.stderr)"
        self.run(notebook, f"def yours():\n    {noisy}", "yours()")
        assert capfd.readouterr() == ("mine\n", "")

    def test_an_answer_keeps_its_own_names(self, notebook):
        self.run(
            notebook, "half = 0.5\ndef yours(x): return half * x", "check.value('y', yours(3), 1.5)"
        )


class TestDraws:
    def test_other_code_meets_other_cases_and_the_same_code_the_same(self):
        def first(x):
            return [x + 1 for x in x]

        def second(x):
            return [x + 2 for x in x]

        again = eval(compile("lambda x: x", "elsewhere", "eval"))
        numbers = [check.draws(f).integers(1 << 60) for f in (first, second, again, lambda x: x)]
        assert numbers[2] == numbers[3]
        assert len(set(numbers)) == 3

    def test_a_function_of_another_process_brings_its_text(self):
        def remote():
            pass

        remote.__answer__ = "def f(x): return 1"
        before = check.draws(remote).random()
        remote.__answer__ = "def f(x): return 2"
        assert check.draws(remote).random() != before


def test_a_mistake_that_fits_one_case_only_is_not_named():
    cases = {f"{x}": (x,) for x in (0, 1, 2, 3, 4)}
    mistakes = {"you double": lambda x: 2 * x + 1, "you triple": lambda x: 3 * x + 1}
    text = message(check.function, lambda x: 3 * x + 1, cases, lambda x: x, mistakes)
    assert "you triple" in text
    text = message(check.function, lambda x: 5 * x + 1, cases, lambda x: x, mistakes)
    assert text.endswith("it returns 1.")


def test_a_mistake_is_named_though_the_right_function_is_taken_from_the_student():
    cases = {"a row": (np.array([1.0, 2, 4]), np.ones(3))}
    mistakes = {"you forgot the square": lambda p, y: np.mean(abs(p - y))}
    forgot = mistakes["you forgot the square"]

    def right(p, y):
        return am.brier(y > 0, p / 8).value

    text = message(check.function, forgot, cases, right, mistakes, without=(am.brier,))
    assert "forgot the square" in text


@pytest.mark.parametrize("way", ["default", "closure", "partial", "name", "reload"])
def test_a_blocked_function_is_reached_by_no_reference(way):
    kept = am.brier

    def by_default(y, p, score=am.brier):
        return score(y, p).value

    def by_closure(y, p):
        return kept(y, p).value

    def by_name(y, p):
        from amrmetrics.scoring import brier

        return brier(y, p).value

    def by_reload(y, p):
        spec = importlib.util.spec_from_file_location("scores_again", am.scoring.__file__)
        again = sys.modules["scores_again"] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(again)
        return again.brier(y, p).value

    yours = {"default": by_default, "closure": by_closure, "name": by_name, "reload": by_reload}
    yours |= {"partial": functools.partial(by_default, score=kept)}
    cases = {"two cells": (np.array([0, 1]), np.array([0.2, 0.7]))}
    arguments = (yours[way], cases, lambda y, p: am.brier(y, p).value)
    assert "brier would do your work" in message(check.function, *arguments, without=(am.brier,))
    check.function(*arguments)


def test_a_blocked_class_is_not_made_and_what_stands_behind_a_function_is_blocked():
    def by_class(tp):
        return am.Confusion(tp=tp, fp=0, fn=0, tn=0, threshold=0.5).iou

    def by_another_way(tp):
        return am.ate(np.eye(3)[:, :2] * tp, np.eye(3)[:, :2]).alignment.scale

    cases = {"one": (1,)}
    text = message(check.function, by_class, cases, float, without=(am.Confusion,))
    assert "Confusion would do your work" in text
    text = message(check.function, by_another_way, cases, float, without=(am.align,))
    assert "align would do your work" in text


def test_a_mistake_in_one_of_two_results_is_not_named_for_a_slip_in_the_other():
    cases = {f"{x}": (x,) for x in (1.0, 2.0, 3.0)}
    mistakes = {"the second is lost": lambda x: (..., 0.0)}
    text = message(check.function, lambda x: (-x, x), cases, lambda x: (x, x), mistakes)
    assert "lost" not in text
    text = message(check.function, lambda x: (-x, 0.0), cases, lambda x: (x, x), mistakes)
    assert "the second is lost" in text


def test_a_test_that_takes_one_wrong_function_for_right_is_told_which():
    wrong = {"doubles": lambda x: 2 * x, "triples": lambda x: 3 * x}

    def mine(f):
        if (f(2), f(3)) != (4, 6):
            raise AssertionError

    text = message(check.test_function, mine, {"square": lambda x: x * x}, wrong)
    assert text.endswith("It accepts one that doubles.")


def test_the_right_line_in_a_later_place_is_told_from_a_wrong_one():
    lines = ["(x + 1)**2", "x**2 + 1", "1 + x**2", "x**2 + 1 + 0*x"]
    said = message(check.wrong_line, 3, "x**2 + 2*x + 1", lines, {"x": "real"})
    assert "does follow from line 2" in said
    check.wrong_line("2", "= x**2 + 2*x + 1", lines, {"x": "real"})
    x = sp.Symbol("x")
    check.wrong_line(2, x**2 + 2 * x + 1, lines, {"x": "real"})
