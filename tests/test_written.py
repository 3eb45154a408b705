"""The written form: what is declared, what a chain says and shows, and how lines are set."""

import html
import itertools
import json
import random
import re
from pathlib import Path

import pytest
import sympy as sp

from amrmetrics.derivation import Derivation, declare
from amrmetrics.derivation.chain import composed, entered_lines, follows, written_lines
from amrmetrics.derivation.forms import normal
from amrmetrics.derivation.reading import Unreadable, read
from amrmetrics.derivation.spelling import canonical
from amrmetrics.derivation.typesetting import parse, plain, typeset
from amrmetrics.derivation.written import WrongDeclaration, WrongLine

LETTERS = """
    x y t z     real
    u           > 0
    p           in (0, 1)
    n           integer >= 1
    N           integer >= 1
    d xhat      sequence k = 1..N
    P           positive definite 2 x 2
    L           lower triangular 2 x 2
    e           vector of 2
    g           := exp(-z**2/2)/sqrt(2*pi)
    square(a)   := a**2
"""


@pytest.fixture
def derive():
    return declare(LETTERS)


# --- spelling -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("spelling", "words"),
    {
        "real": ["real", "real number", "numbers"],
        ">0": ["> 0", "positive", "Positive number", "positive real"],
        ">=0": [">= 0", "≥ 0", "non-negative", "nonnegative"],
        "<0": ["< 0", "negative"],
        "nonzero": ["non-zero", "not zero"],
        "(0,1)": ["in (0, 1)", "probability", "real in (0, 1)"],
        "(-oo,1/2)": ["in (-oo, 1/2)", "< 1/2", "in (-inf, 1/2)"],
        "[0,2*pi)": ["in [0, 2*pi)", "angle in [0, 2*pi)"],
        "(c,oo)": ["> c"],
        "int>=1": ["integer >= 1", "natural", "positive integer", "whole number >= 1"],
        "int>0": ["integer > 0", "int > 0"],
        "int[1,N]": ["integer 1..N", "integer from 1 to N", "integers in [1, N]"],
        "int[m,oo]": ["integer >= m"],
        "index": ["index"],
        "index[0,N-1]": ["index 0..N - 1"],
        "function": ["function"],
        "seq": ["sequence"],
        "seq>0": ["positive sequence", "sequence > 0", "sequence of positive numbers"],
        "seq(0,1)": ["sequence in (0,1)", "sequence of probabilities"],
        "seqint": ["sequence of integers"],
        "seqint[0,1]": ["sequence of 0 or 1", "sequence of integers 0..1"],
        "vec2": ["vector of 2", "2-vector"],
        "mat2": ["matrix 2 x 2", "2x2 matrix"],
        "mat2x3": ["matrix 2 x 3", "matrix 2 by 3"],
        "sym3": ["symmetric 3 x 3"],
        "spd2": ["symmetric positive definite 2x2", "covariance 2 x 2"],
        "chol2": ["lower triangular 2 x 2, positive diagonal", "Cholesky factor 2 x 2"],
        "rot": ["rotation", "rotation 2 x 2"],
        "rot3": ["rotation 3 x 3"],
        "se2": ["pose", "pose in the plane"],
    }.items(),
)
def test_words_are_spelled(spelling, words):
    assert {canonical(w) for w in words} == {spelling}
    assert canonical(spelling) == spelling


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        ("posetive", "did you mean 'positive'"),
        ("covariance", "did you mean 'covariance 2 x 2'"),
        ("complex", "Write for example real, positive"),
        ("(0, 1", "did you mean '(0,1)'"),
        ("sequence of sequences", "does not say"),
        ("positive definite 2 x 3", "does not say"),
    ],
)
def test_a_word_that_is_no_kind_gets_examples(words, hint):
    with pytest.raises(Unreadable, match=re.escape(hint)):
        canonical(words)


# --- declaring ------------------------------------------------------------------------------------


def test_a_declaration_goes_on_while_a_bracket_is_open():
    derive = declare("""
        a      angle
        R      := Matrix([[cos(a), -sin(a)],   # a rotation
                          [sin(a), cos(a)]])
        x      in [0, 1)
    """)
    assert derive("det(R)\n = 1   # cos² + sin² = 1").complete
    assert "x" in derive.domains
    with pytest.raises(WrongDeclaration, match="M"):
        declare("M := Matrix([[1, 2]\n\nx > 0")


def test_a_declaration_shows_itself():
    derive = declare(
        "xhat_0, t  real   # with a comment\n\n d sequence k = 1..3\n g := x**2\n".replace(
            "x**2", "t**2"
        )
    )
    assert repr(derive) == "xhat_0, t  real\nd          sequence k = 1..3\ng          := t**2"
    shown = derive._repr_html_()
    assert r"$\hat{x}_{0}, t$" in shown and r"$\displaystyle t^{2}$" in shown
    assert "&gt;= 1" not in declare("n integer >= 1")._repr_html_()


def test_more_is_the_same_declaration_and_shows_what_is_new(derive):
    more = derive.more("w  > 0\n h := w*g")
    assert repr(more) == "w  > 0\nh  := w*g"
    for one in (derive, more):
        assert one("2*h\n = 2*w*g  # what h is").complete
    derive("Q1: x + x\n = 2*x # add")
    assert more("x + x + 1\n = 2*x + 1  # by Q1").status == ("by lemma",)


def test_the_same_declaration_again_is_harmless(derive):
    assert repr(derive.more(LETTERS)) == repr(derive)
    assert derive.names == declare(LETTERS).names


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("x  > 0", "x stands for something else already (real): one letter, one meaning"),
        ("g  real", "something else already (g := "),
        ("g  := x", "something else already"),
        ("k  real", "something else already (index[1,N])"),
        ("lambda  real", "call it lam"),
        ("pi  real", "has a meaning already"),
        ("w  posetive", "did you mean 'positive'"),
        ("w", "names, then what they stand for"),
        ("w  in (0, c)", "is not a domain"),
        ("w  real k = 1..N", "belongs to a sequence"),
        ("h := x + nobody", "nobody is not declared yet"),
        ("h := x +", "an abbreviation is written"),
        ("h(2) := x", "an abbreviation is written"),
    ],
)
def test_a_wrong_declaration_says_why(derive, line, says):
    with pytest.raises(WrongDeclaration, match=re.escape(says)) as caught:
        derive.more(line)
    assert caught.value._render_traceback_() == [str(caught.value)]


def test_names_are_told_from_kinds():
    derive = declare("a b positive\n c, f  in (0, 1)\n h(0,1)\n m positive definite 2 x 2")
    kinds = {"a": ">0", "b": ">0", "c": "(0,1)", "f": "(0,1)", "h": "(0,1)", "m": "spd2"}
    assert derive.domains == kinds


# --- what a line means ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "meaning"),
    [
        ("Sum(d[k], k)", "Sum(d[k], (k, 1, N))"),
        ("Sum(Sum(d[j]*d[k], (j, 1, k)), k)", "Sum(Sum(d[j] * d[k], (j, 1, k)), (k, 1, N))"),
        ("Product(d[k], k)", "Product(d[k], (k, 1, N))"),
        ("2**square(x)", "2 ** x ** 2"),
        ("square(x + y)/x", "(x + y) ** 2 / x"),
        ("-square(-x)", "-(-x) ** 2"),
        ("square(square(x))", "(x ** 2) ** 2"),
        ("Integral(r, (x, 0, 1))", "Integral(x + y, (x, 0, 1))"),  # as on paper
        ("F(x)", "Integral(x * s, (s, 0, 1))"),
        ("F(s)", "Integral(s * s_1, (s_1, 0, 1))"),  # and not the s that is bound
        ("F(s + s_1)", "Integral((s + s_1) * s_11, (s_11, 0, 1))"),
        ("H(y)", "Integral(Integral(x * y, (x, 0, t)), (t, 0, y))"),
        ("H(t)", "Integral(Integral(x * t, (x, 0, t_1)), (t_1, 0, t))"),
        ("At(t)", "Subs(t * x, x, t)"),
        ("x == y", "x == y"),
        ("2x", "2x"),
    ],
)
def test_what_a_line_means(derive, line, meaning):
    derive.more("""
        s s_1 real
        r := x + y
        F(a) := Integral(a*s, (s, 0, 1))
        H(a) := Integral(x*a, (x, 0, t), (t, 0, a))
        At(a) := Subs(a*x, x, a)
    """)
    meaning = meaning.replace(
        "Integral(Integral(x * y, (x, 0, t)), (t", "Integral(x * y, (x, 0, t), (t"
    )
    meaning = meaning.replace(
        "Integral(Integral(x * t, (x, 0, t_1)), (", "Integral(x * t, (x, 0, t_1), ("
    )
    assert derive.expand(line) == meaning


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("Sum(d[j], j)", "j has no range"),
        ("square", "write square(a)"),
        ("square(x, y)", "write square(a)"),
        ("g(x)", "g is an abbreviation: write g"),
        ("Derivative(x, g)", "Derivative needs a letter there"),
        ("Integral(x, (g, 0, 1))", "Integral needs a letter there"),
        ("Limit(x, g, 0)", "Limit needs a letter there"),
        ("nobody + 1", "nobody is not declared"),
        ("2x", "a product needs its sign"),
    ],
)
def test_a_line_that_cannot_be_read(derive, line, says):
    with pytest.raises(WrongLine, match=re.escape(says)):
        derive(f"{line}\n = x  # whatever")


def test_a_range_gives_the_index_its_domain(derive):
    assert derive.domains["k"] == "index[1,N]"
    derive.more("i  index 0..N\n b  sequence i2 = 1..2, k2 = 1..N")
    assert derive.expand("Sum(xhat[i], i)") == "Sum(xhat[i], (i, 0, N))"
    assert derive.expand("Sum(b[i2, k2], k2, i2)") == "Sum(b[i2, k2], (k2, 1, N), (i2, 1, 2))"
    assert derive("k >= 1  # the first is 1").status == ("proved",)


def test_an_abbreviation_is_shown_by_its_name(derive):
    chain = derive("Integral(z*g, (z, -oo, oo)) + square(x)\n = x**2  # an odd function")
    assert chain.lines[0] == "Integral(z*g, (z, -oo, oo)) + square(x)"
    assert chain.given.latex.endswith(r"z g \,dz + \mathrm{square}(x)")


# --- the lines of a chain -------------------------------------------------------------------------


def test_the_lines_of_a_chain():
    text = """
        D7:
        f(x,
          y)            # what is given
        = x + y
          - y           # a reason
                        # in two rows
        == 1
        <= 2*(x         # at most
           < 3)
        ≥ y == 1        # at least
    """
    name, lines = written_lines(text)
    assert name == "D7"
    assert lines == [
        ("", "f(x, y)", "what is given"),
        ("=", "x + y - y == 1", "a reason in two rows"),
        ("<=", "2*(x < 3)", "at most"),
        ("≥", "y == 1", "at least"),
    ]
    assert written_lines("D7a: x == 1  # so") == ("D7a", [("", "x == 1", "so")])


def test_students_may_leave_out_signs_and_reasons():
    expected = [("", "x + 1", ""), ("=", "y", "so")]
    assert entered_lines("x + 1\n = y  # so") == expected
    assert entered_lines(["x + 1", "= y # so"]) == expected
    assert entered_lines([("x + 1", ""), ("= y", "so")]) == expected
    assert entered_lines("x + 1\n\n y # so\n") == [("", "x + 1", ""), ("", "y", "so")]
    x = sp.Symbol("x")
    assert entered_lines([x, (x, "so")]) == [("", x, ""), ("", x, "so")]


@pytest.mark.parametrize(
    ("relations", "together"),
    [
        (["equal", "equal"], "equal"),
        (["equal", "<="], "<="),
        (["<=", "<"], "<"),
        ([">=", "equal", ">="], ">="),
        (["<", ">"], None),
        (["iff", "iff"], "iff"),
        (["iff", "implies"], "implies"),
        (["implied_by", "implied_by"], "implied_by"),
        (["implies", "implied_by"], None),
        ([""], "equal"),
    ],
)
def test_what_relations_compose_to(relations, together):
    assert composed(relations) == together


def test_what_a_relation_says_of_another():
    says = {
        (a, b) for a, b in itertools.product(("equal", "<", "<=", ">="), repeat=2) if follows(a, b)
    }
    assert says == {
        *(("equal", x) for x in ("equal", "<=", ">=")),
        ("<", "<"),
        ("<", "<="),
        ("<=", "<="),
        (">=", ">="),
    }
    assert follows("iff", "implies") and not follows("implies", "iff") and not follows(None, "iff")


# --- checking -------------------------------------------------------------------------------------

BLOCK = """
    D5: x*Sum((d[k] - t)**2, k)/x/u
    = Sum((d[k] - t)**2, k)/u                            # cancel
    = Sum(d[k]**2 - 2*t*d[k] + t**2, k)/u                # expand each square
    = (Sum(d[k]**2, k) - 2*t*Sum(d[k], k) + N*t**2)/u
      # `t` does not depend on `k`
    = Sum(d[k]**2, k)/u - 2*t*Sum(d[k], k)/u
      + N*square(t)/u                                    # three fractions
    <= Sum(d[k]**2, k)/u - 2*t*Sum(d[k], k)/u + N*(square(t) + 1)/u
      # by hand: `1` is positive
    = Sum(d[k]**2, k)/u - 2*t*Sum(d[k], k)/u + (N*t**2 + N)/u   # cited: a book, p. 3
"""
SHOWN = """\
D5: x*Sum((d[k] - t)**2, k)/x/u
    = Sum((d[k] - t)**2, k)/u                                  cancel  ✓, if x != 0
    = Sum(d[k]**2 - 2*t*d[k] + t**2, k)/u                      expand each square  ✓
    = (Sum(d[k]**2, k) - 2*t*Sum(d[k], k) + N*t**2)/u          t does not depend on k  ✓
    = Sum(d[k]**2, k)/u - 2*t*Sum(d[k], k)/u + N*square(t)/u   three fractions  ✓
    ≤ Sum(d[k]**2, k)/u - 2*t*Sum(d[k], k)/u + N*(square(t) + 1)/u  by hand: 1 is positive
    = Sum(d[k]**2, k)/u - 2*t*Sum(d[k], k)/u + (N*t**2 + N)/u  cited: a book, p. 3
    Together: x*Sum((d[k] - t)**2, k)/x/u ≤ \
Sum(d[k]**2, k)/u - 2*t*Sum(d[k], k)/u + (N*t**2 + N)/u"""


@pytest.fixture(scope="module")
def block():
    return declare(LETTERS)(BLOCK)


def test_a_block_in_plain_text(block):
    assert repr(block) == SHOWN


def test_a_cell_can_be_run_again(derive, block):
    once, again = derive(BLOCK), derive(BLOCK)
    shown = (repr(block), block._repr_html_())
    assert shown == (repr(once), once._repr_html_()) == (repr(again), again._repr_html_())
    assert list(derive.results) == ["D5"]
    assert repr(derive.summary()) == "D5  4 proved, 1 by hand, 1 cited"
    well_formed(derive.summary()._repr_html_())


def test_the_block_in_html(derive, block):
    shown = block._repr_html_()
    assert shown.count("<tr") == 8 and shown.count("✓") == 4
    assert "<strong>D5</strong>" in shown and r"$\le$" in shown and "by hand: $1$ is" in shown
    well_formed(shown)
    shown = derive("x*y/x\n = y  # <b>cancel</b> & `x**2`")._repr_html_()
    assert "&lt;b&gt;cancel&lt;/b&gt; &amp; $x^{2}$&nbsp;&nbsp;✓, if $x \\ne 0$" in shown
    for text in (shown, derive("t <= t + u  # u > 0")._repr_html_(), derive._repr_html_()):
        well_formed(text)


def well_formed(text):
    """Every tag is closed, and between tags nothing is left that HTML would take for one."""
    tags = re.findall(r"<(/?)(\w+)[^<>]*>", text)
    stack = []
    for end, tag in tags:
        if end:
            assert stack.pop() == tag
        else:
            stack.append(tag)
    assert not stack
    between = re.sub(r"<[^<>]*>", "", text)
    assert not re.search(r"[<>]|&(?!(amp|lt|gt|quot|ensp|nbsp|#x27);)", between)


def test_a_chain_says_how_its_steps_are_known(block):
    assert block.status == ("proved",) * 4 + ("by hand", "cited")
    assert block.counts == {"proved": 4, "by hand": 1, "cited": 1}
    assert block.complete and block.relation == "<=" and block.conditions == ("x != 0",)


def test_a_sampled_step_is_said_to_be_sampled(derive):
    chain = derive("Eq(x**2, 4)\n <=> Or(Eq(x, 2), Eq(x, -2))  # two roots")
    if chain.status == ("sampled",):
        assert repr(chain).endswith("two roots  ≈ sampled, not proved")
    assert not re.search(r"\d+ points", repr(chain) + chain._repr_html_())


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("x + x\n = 3*x  # add", "= 3*x\n  ✗ wrong: at x = 1"),
        ("Q2: x + x\n = 3*x  # add", "Q2: = 3*x\n  ✗ wrong: at x = 1"),
        ("x + x\n = 3*x  # by hand: add", "✗ wrong: at x = 1"),
        ("x + x\n = 3*x  # cited: a book", "✗ wrong: at x = 1"),
        ("x + x\n = 2*x", "a reason is missing"),
        ("x + x\n = x + x # nothing", "the step changes nothing"),
        ("x + x\n = 2*w # add", "w is not declared"),
        ("x + x\n = 2*w # by hand: add", "w is not declared"),
        ("= x + x\n = 2*x # add", "the first line is what is given"),
        ("", "the first line is what is given"),
        ("x + x", "a formula alone claims nothing"),
        ("x**2 > 0  # a square", "✗ wrong: at x = 0"),
        ("x\n < x + 1  # more\n > x  # less", "the chain has both < and >"),
        ("x\n <=> x + 1 - 1  # so", "⇔ stands between two formulas: write =, <, >"),
        ("x == 1\n = 2*x == 2  # so", "= stands between two claims: write <=>"),
        ("x == 1\n = 2*x  # so", "one line is a formula and the other an equation"),
        ("x == 1\n < x == 2  # so", "< stands between two claims"),
        ("x == 1\n => x == 2  # so", "✗ wrong: x = 1 holds"),
        ("x**2 == 1\n <=> x == 1  # the root", "✗ wrong: x = -1 holds"),
        ("x*0 + u\n < u  # so", "✗ wrong: at x = 1, u = 1"),
        ("x + 1\n = 1 + x # by D9", "there is no result of this name (there are: none yet)"),
    ],
)
def test_a_wrong_chain_raises(derive, text, says):
    with pytest.raises(WrongLine, match=re.escape(says)) as caught:
        derive(text)
    assert caught.value._render_traceback_() == [str(caught.value)]
    assert not derive.results


def test_what_a_chain_of_claims_says_together(derive):
    chain = derive("x == 1\n <=> 2*x == 2 # double\n => x**2 == 1  # square\n => x**4 == 1 # again")
    assert chain.relation == "implies"
    assert repr(chain).endswith("Together: the first line implies the last.")
    chain = derive("Q1: x == 1\n => x**2 == 1  # square\n <= x == -1  # square")
    assert chain.relation is None and not chain.complete
    assert "nothing follows from the first line to the last" in repr(chain)
    with pytest.raises(WrongLine, match="no result of this name"):
        derive("x == 1\n => x == 1 + 0 # by Q1")
    assert derive("u\n = u + 0 # add 0\n <= u + 1 # more").relation == "<="


def test_wrong_expects_a_wrong_line(derive):
    chain = derive.wrong("x + x\n = 3*x  # add\n = x + 2*x  # split")
    assert chain.status == ("refuted", "proved") and not chain.complete
    assert repr(chain).splitlines()[2].startswith("    ✗ wrong: at x = 1")
    assert "✗ wrong" in chain._repr_html_()
    with pytest.raises(WrongLine, match="every line holds"):
        derive.wrong("x + x\n = 2*x  # add")
    with pytest.raises(WrongLine, match="not declared"):
        derive.wrong("x + x\n = 3*x  # add\n = w # so")


def test_sympy_objects(derive):
    x, t = sp.symbols("x t", real=True)
    chain = derive(
        [(x + t) ** 2, ("=", sp.expand((x + t) ** 2), "multiply out"), ("≥", "2*t*x", "so")], "Q3"
    )
    assert chain.status == ("proved", "proved") and chain.relation == ">="
    assert chain.given.latex == r"\left(t + x\right)^{2}" and "Q3" in derive.results


# --- results that are used ------------------------------------------------------------------------


@pytest.fixture(scope="module")
def known():
    derive = declare(LETTERS)
    derive("A1: cos(x)**2\n = 1 - sin(x)**2  # Pythagoras")
    derive("A2: Integral(z*g, (z, -oo, oo))\n = 0  # an odd function")
    derive("A3: x**2 + 1 >= 2*x  # by hand: a square is not negative")
    derive("A4: x == 1\n => x**2 == 1  # square")
    derive("A5: gamma(n + 1) == n*gamma(n)  # cited: a book")
    derive("A6: x*u/x\n = u  # cancel")
    return derive


@pytest.mark.parametrize(
    "step",
    [
        "2*cos(x)**2 - y\n = 2*(1 - sin(x)**2) - y  # by A1",
        "1 - sin(x)**2\n = cos(x)**2  # by A1",
        "cos(x)**2 + Integral(z*g, (z, -oo, oo))\n = 1 - sin(x)**2  # 0 + it, by A1 and A2",
        "cos(y + t)**2\n = 1 - sin(y + t)**2  # by A1 with x = y + t",
        "cos(3)**2\n = 1 - sin(3)**2  # by A1 with x = 3: three",
        "x**2 + 1 + y\n >= 2*x + y  # by A3",
        "4*t**2 + 1\n >= 4*t  # by A3 with x = 2*t",
        "x == 1\n => x**2 == 1  # by A4",
        "x**2 == 1\n <= x == 1  # by A4",
        "gamma(n + 2)\n = (n + 1)*gamma(n + 1)  # by A5 with n = n + 1",
        "cos(x)**2 == 1\n <=> 1 - sin(x)**2 == 1  # by A1",
        "2*cos(x)**2*y*d[k]\n = 2*y*(1 - sin(x)**2)*d[k]  # by A1",
    ],
)
def test_a_result_is_used(known, step):
    chain = known(step)
    assert chain.counts == {"by lemma": 1}
    assert repr(chain).endswith("✓")


@pytest.mark.parametrize(
    ("step", "says"),
    [
        ("cos(x)**2\n = 2 - sin(x)**2  # by A1", "wrong"),
        ("cos(y)**2\n = 2 - sin(y)**2  # by A1", "wrong"),
        ("gamma(n)\n = (n - 1)*gamma(n - 1)  # by A5 with n = n - 1", "it is not proved that"),
        ("gamma(u + 1)\n = u*gamma(u)  # by A5 with n = u", "it is not proved that"),
        ("gamma(n/2 + 1)\n = n/2*gamma(n/2)  # by A5 with n = n/2", "it is not proved that"),
        ("cos(x)**2\n = 1 - sin(x)**2  # by A1 with q = 2", "write letter = value"),
        ("x**2 + 1\n <= 2*x  # by A3", "wrong"),
        ("x**2 == 1\n => x == 1  # by A4", "wrong"),
        ("cos(x)**2\n = 1 - sin(x)**2  # by A99", "there is no result of this name"),
    ],
)
def test_a_result_that_does_not_fit(known, step, says):
    with pytest.raises(WrongLine, match=says):
        known(step)


def test_a_step_that_needs_no_result_is_proved_and_conditions_are_inherited(known):
    assert known("x + x\n = 2*x  # by A1").status == ("proved",)
    assert known("y + x*u/x\n = y + u  # by A6").conditions == ("x != 0",)


def test_a_result_is_not_used_where_its_letter_is_bound(known):
    """A result about u > 0 says nothing about an u that runs over other values."""
    known("A7: Abs(u)\n = u  # u is positive")
    assert known("Abs(u) + 1\n = u + 1  # by A7").counts == {"by lemma": 1}
    with pytest.raises(WrongLine, match="wrong"):
        known("Integral(Abs(u), (u, -1, 1))\n = Integral(u, (u, -1, 1))  # by A7")


def test_a_doubtful_result_does_not_hide_a_wrong_step(known):
    known("A8: x + y\n = y + x + 0  # by hand: so")
    slip = known.results["A8"].steps[0].line
    object.__setattr__(slip, "meaning", sp.Symbol("y"))
    with pytest.raises(WrongLine, match="wrong"):
        known("x + y\n = y + 0  # by A8")


@pytest.mark.parametrize("letter", ["x", "u", "p", "n", "i", "w", "q"])
def test_a_value_has_to_be_in_the_domain(letter):
    inside = {"x": "y - 3", "u": "v + u", "p": "p/2", "n": "2*n + 1", "i": "3", "w": "-w", "q": "Q"}
    outside = {"u": "u - v", "p": "2*p", "n": "n - 1", "i": "4", "w": "x*w", "q": "2*q"}
    derive = declare(
        "x y real\n u v > 0\n p in (0, 1)\n n integer >= 1\n i index 1..3\n w nonzero\nq Q rotation"
    )
    kept = {"w": "(w + 1)**2", "q": "Trace(q)"}.get(letter, f"2*{letter} + 1")
    derive(f"A1: {kept} == {kept} + 0  # by hand: so it is")
    changed = re.sub(rf"\b{letter}\b", f"({inside[letter]})", kept)
    derive(f"{changed}\n = {changed} + 0  # by A1 with {letter} = {inside[letter]}")
    if letter in outside:
        with pytest.raises(WrongLine, match="it is not proved"):
            derive(f"{changed}\n = {changed} + 0  # by A1 with {letter} = {outside[letter]}")


# --- a derivation from a given line to a goal -----------------------------------------------------

TASK = {"goal": "x**2 + 2*x + 1", "given": "(x + 1)**2", "domains": {"x": "real", "u": "nonzero"}}


@pytest.mark.parametrize(
    "padding",
    """(x+1)**2*2/2; 2*(x+1)**2/2; (x+1)**2+1/u-1/u; (x+1)**2/2+(x+1)**2/2; -(-(x+1)**2); (1+x)**2
    3*(x+1)**2-2*(x+1)**2; u*(x+1)**2/u; x**2/2+x**2/2+2*x+1; x**2+(2*x+1); -(-x**2-2*x-1)
    x**2-(-2*x-1); 2*(x**2/2+x+1/2); (x**2+2*x+1)*u/u; x**2+2*x+1+u-u; 1*(x+1)**2+0; (x+1)*(x+1)
    """.replace("\n", ";").split(";")[:-1],
)
def test_padding_is_no_move(padding):
    chain = Derivation(**TASK).check([padding, TASK["goal"]])
    assert chain.reached and chain.moves == 1


def test_padding_of_matrices_is_no_move():
    domains = {"L": "chol2", "e": "vec2"}
    task = {"goal": "(L.inv()*e).T*(L.inv()*e)", "given": "e.T*(L*L.T).inv()*e", "domains": domains}
    for line in (
        "e.T.T.T*(L*L.T).inv()*e",
        "e.T*eye(2)*(L*L.T).inv()*e*2/2",
        "e.T*(L*L.T).inv()*e/2*2",
    ):
        assert Derivation(**task).check([line, task["goal"]]).moves == 1
    assert Derivation(**task).check(["e.T*L.T.inv()*L.inv()*e", task["goal"]]).moves == 2


def test_a_move_is_a_move():
    assert Derivation(**TASK).check(["x*(x+1)+x+1", "x**2+x+x+1", TASK["goal"]]).moves == 3
    assert Derivation(**TASK).check([TASK["goal"]]).moves == 1
    task = {"goal": "y", "given": "x*y/x", "domains": {"x": "nonzero", "y": "real"}}
    assert Derivation(**task).check(["y"]).moves == 1
    assert Derivation(**task).check(["x*y/x"]).moves == 0


def test_what_the_signs_compose_to_is_asked():
    task = {"goal": "Eq(x, -1)", "given": "Eq(x, 1)", "domains": {"x": "real"}}
    chain = Derivation(**task).check("=> x**2 == 1\n <= x == -1")
    assert chain.reached and [v.status for v in chain.verdicts].count("refuted") == 0
    assert not chain.complete and "compose to is nothing" in chain.problems[0]
    task = {"goal": "Eq(x, 1)", "given": "Eq(x**2, 1)", "domains": {"x": "real"}}
    chain = Derivation(**task).check("<= x == 1")
    assert "the task asks ⇒" in chain.problems[0] and "is ⇐" in chain.problems[0]
    assert Derivation(**task, relation="implied_by").check("<= x == 1").complete
    task = {"goal": "u + 1", "given": "u", "domains": {"u": ">0"}}
    assert "the task asks =" in Derivation(**task).check("< u + 1").problems[0]
    assert Derivation(**task, relation="<=").check("< u + 1").complete


def test_a_derivation_takes_a_declaration(derive):
    chain = Derivation("N*square(t)", given="Sum(square(t), k)", domains=derive)
    chain.check("= Sum(t**2, k)  # what a square is\n = N*t**2   # N times")
    assert chain.complete and chain.lines[0] == "Sum(square(t), k)"


# --- setting --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("line", "latex"),
    [
        ("a - b + c*2", r"a - b + c \cdot 2"),
        ("a - (b + c)", "a - (b + c)"),
        ("(a*b)*c", "(a b) c"),
        ("(a + b)/2*c", r"\frac{a + b}{2} c"),
        ("a/b*c/d", r"\frac{a}{b} \frac{c}{d}"),
        ("-(a + b)/2", r"-\frac{a + b}{2}"),
        ("a*-b", "a (-b)"),
        ("a**b**c", "a^{b^{c}}"),
        ("(a**b)**c", "(a^{b})^{c}"),
        ("x**(n/2 - 1)", "x^{n/2 - 1}"),
        ("exp(-z**2/2)", "e^{-z^{2}/2}"),
        ("exp(Sum(x[k], k))", r"\exp\left(\sum_{k} x_{k}\right)"),
        ("(Q*R).T", r"(Q R)^{\mathsf{T}}"),
        ("A.inv().T", r"(A^{-1})^{\mathsf{T}}"),
        ("A.T.inv()", r"\left(A^{\mathsf{T}}\right)^{-1}"),
        ("inv(A)*transpose(A)", r"A^{-1} A^{\mathsf{T}}"),
        (
            "tr(A) + A.trace() + Trace(A)",
            r"\operatorname{tr}(A) + \operatorname{tr}(A) + \operatorname{tr}(A)",
        ),
        ("det(A)**2", r"(\det A)^{2}"),
        ("sqrt(x)", r"\sqrt{x}"),
        ("cos(theta)*x + sin(2*theta)**2", r"\cos(\theta) x + \sin^{2}(2 \theta)"),
        ("Sum(d[k], k)*x", r"\left(\sum_{k} d_{k}\right) x"),
        ("Sum(a[i, j], (i, 1, j), (j, 1, N))", r"\sum_{j=1}^{N} \sum_{i=1}^{j} a_{i,j}"),
        ("Sum(a + b, (k, 0, oo))", r"\sum_{k=0}^{\infty} (a + b)"),
        ("Product(a, (k, 1, n))", r"\prod_{k=1}^{n} a"),
        ("Integral(f(x, y), (y, 0, x), (x, 0, 1))", r"\int_{0}^{1} \int_{0}^{x} f(x, y) \,dy \,dx"),
        ("integrate(x, (x, 0, 1))", r"\int_{0}^{1} x \,dx"),
        ("Derivative(-g, z)", r"\frac{d}{d z} (-g)"),
        ("diff(f(x, y), x, 2, y)", r"\frac{\partial^{3}}{\partial x^{2}\,\partial y} f(x, y)"),
        ("Subs(f(t), t, 0)", r"\left. f(t) \right|_{t=0}"),
        ("Limit(1/x, x, 0, '+')", r"\lim_{x \to 0^{+}} \frac{1}{x}"),
        (
            "Piecewise((x, x > 0), (0, True))",
            r"\begin{cases} x & \text{if } x > 0 \text{} \\ 0 & \text{otherwise} \end{cases}",
        ),
        ("Matrix([[a, b], [c, d]])", r"\begin{pmatrix} a & b \\ c & d \end{pmatrix}"),
        ("Matrix([a, b])", r"\begin{pmatrix} a \\ b \end{pmatrix}"),
        ("P[0, 1]", "P_{0,1}"),
        ("norm(v)", r"\left\lVert v\right\rVert "),
        ("abs(x)", r"\left\lvert x\right\rvert "),
        ("cross(u, v)", r"u \times v"),
        ("diag(a, b)", r"\operatorname{diag}(a, b)"),
        ("eye(2)", "I_{2}"),
        ("gamma(n/2)", r"\Gamma\left(\frac{n}{2}\right)"),
        ("factorial(n + 1)", "(n + 1)!"),
        ("binomial(n, k)", r"\binom{n}{k}"),
        ("a % b", r"a \bmod b"),
        ("Max(a, 0)", r"\max(a, 0)"),
        ("atan2(y, x)", r"\operatorname{atan2}(y, x)"),
        ("log(x, 2)", r"\log_{2}(x)"),
        ("x == y", "x = y"),
        ("Eq(x, y)", "x = y"),
        ("0 < x <= 1", r"0 < x \le 1"),
        ("x != 1 and not (y > 1)", r"x \ne 1 \text{ and } \text{not } (y > 1)"),
        ("Or(x > 1, Eq(x, 0))", r"x > 1 \text{ or } x = 0"),
        ("x − 1 ≤ y", r"x - 1 \le y"),
        ("2.50*x + 1e-5", r"2.50 x + 1 \cdot 10^{-5}"),
        ("pi + E + oo", r"\pi + e + \infty"),
        ("epsilon + epsl", r"\varepsilon + \mathrm{epsl}"),
        ("ell + ell_1 + ellipse", r"\ell + \ell_{1} + \mathrm{ellipse}"),
        ("xhat + dbar + thetahat_k", r"\hat{x} + \bar{d} + \hat{\theta}_{k}"),
        ("x_k + d[k + 1] + x_a[k]", "x_{k} + d_{k + 1} + x_{a,k}"),
        ("z1 + s_pp + q_odo + lam", r"z_{1} + s_{pp} + q_{\mathrm{odo}} + \lambda"),
    ],
)
def test_a_line_is_set_as_it_was_typed(line, latex):
    assert typeset(line) == latex


def test_a_declared_letter_is_a_letter():
    assert typeset("beta*gamma + E", ["beta", "gamma", "E"]) == r"\beta \gamma + E"
    assert typeset("2x") is None and typeset("f(*x)") is None


def test_a_wide_line_is_broken_between_its_terms():
    terms = " + ".join(f"(a_{k} + b_{k})**2*c_{k}" for k in range(12))
    latex = typeset(f"x == {terms}")
    assert latex.count(r"\displaystyle") > 2 and balanced(latex)
    added = r"\\(begin|end)\{array\}(\{l\})?|\\displaystyle|\\\\\[1ex\]|\\quad|\{\}|\s"
    term = r"(a_{%s}+b_{%s})^{2}c_{%s}"
    rows = "x=" + "+".join(term % (k, k, k) for k in range(12))
    assert re.sub(added, "", latex) == rows


def balanced(latex):
    depth = 0
    for m in re.finditer(r"\\[{}]|[{}]", latex):
        depth += {"{": 1, "}": -1}.get(m[0], 0)
        if depth < 0:
            return False
    pairs = ((r"\left", r"\right"), (r"\begin", r"\end"), ("(", ")"))
    return depth == 0 and all(latex.count(a) == latex.count(b) for a, b in pairs)


def corpus_lines():
    for path in sorted((Path(__file__).parent / "derivations").glob("*.json")):
        for step in json.loads(path.read_text("utf-8")):
            yield from ((step[x], step["symbols"]) for x in ("before", "after") if step[x].strip())


def test_every_line_of_the_labelled_steps_can_be_set():
    for line, letters in corpus_lines():
        latex = typeset(line, letters)
        if parse(line) is not None:
            assert latex and balanced(latex), line
            assert plain(line) == " ".join(line.split())


def test_lines_that_look_alike_say_the_same():
    """Two formulas with the same LaTeX have the same value: no bracket is lost that matters."""
    rng = random.Random(1)
    names = ("x", "y", "d[k]", "2", "f(x)")
    wrap = ("exp({})", "sin({})", "Sum({}, (k, 1, 2))", "sqrt({})", "-({})", "log({})", "Abs({})")
    join = ("({}) + ({})", "({}) - ({})", "({}) * ({})", "({}) / ({})", "({}) ** ({})")

    def formula(depth):
        if depth == 0:
            return rng.choice(names)
        if rng.random() < 0.35:
            return rng.choice(wrap).format(formula(depth - 1))
        return rng.choice(join).format(formula(depth - 1), formula(rng.randrange(depth)))

    kinds = {"x": "number", "y": "number", "k": "number", "d": "sequence", "f": "function"}
    seen = {}
    for _ in range(4000):
        line = formula(rng.randint(1, 3))
        written = re.sub(r"\((x|y|2|d\[k\]|f\(x\))\)", r"\1", line)
        latex = typeset(written).replace(" ", "")
        assert balanced(latex), written
        if latex in seen and seen[latex] != written:
            pair = [read(w, kinds) for w in (seen[latex], written)]
            assert normal(pair[0]) == normal(pair[1]), (seen[latex], written, latex)
        seen[latex] = written
    assert len(seen) > 1500


def test_html_of_lines_is_escaped(derive):
    shown = derive("x < 1\n <=> 1 > x  # turned").given.html()
    assert shown == "$\\displaystyle x &lt; 1$" and html.unescape(shown) == "$\\displaystyle x < 1$"
