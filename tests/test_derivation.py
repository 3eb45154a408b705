"""The derivation checker: verdicts on labelled steps, mistakes and rewrites; chains; limits."""

import json
import random
import subprocess
import sys
import threading
from pathlib import Path

import pytest
import sympy as sp

from amrmetrics.derivation import Derivation, check_step, searching
from amrmetrics.derivation.arithmetic import Arithmetic, as_float
from amrmetrics.derivation.checking import Step
from amrmetrics.derivation.limits import bounded

sys.path.insert(0, str(Path(__file__).parent / "derivations"))
import evaluate

REAL = {"x": "real", "y": "real"}


def none_wrong(tally):
    assert tally.times
    assert not tally.bad, "\n".join(tally.bad)
    assert max(tally.times) < 10


@pytest.mark.parametrize("name", evaluate.CORPORA)
def test_labelled_steps(name, request, monkeypatch):
    sweep = request.config.getoption("--sweep", default=False)
    part = {"own": 4, "own_2": 10, "own_3": 10, "own_4": 10}.get(name, 2)
    if not sweep:
        some = evaluate.load(name)[1::part]
        monkeypatch.setattr(evaluate, "load", lambda name: some)
    none_wrong(evaluate.labelled(name, range(5 if sweep else 1)))


def test_corpora_are_what_they_say():
    own = evaluate.load("own")
    assert len(own) >= 150 and len({s["id"] for s in own}) == len(own)
    assert {s["topic"] for s in own} >= {"poses", "alignment", "trajectory", "consistency", "maps"}


@pytest.mark.parametrize("make", ["mutated", "rewritten", "objects"])
def test_variants_of_labelled_steps(make, request, monkeypatch):
    if not request.config.getoption("--sweep", default=False):
        steps = [
            s for n in evaluate.CORPORA for s in evaluate.load(n) if "Integral" not in s["before"]
        ]
        some = random.Random(3).sample(steps, 16)
        monkeypatch.setattr(evaluate, "load", lambda name: some if name == "public" else [])
    none_wrong(getattr(evaluate, make)(evaluate.CORPORA, [0]))


def test_hostile_text_is_harmless(tmp_path, monkeypatch, request):
    monkeypatch.chdir(tmp_path)
    tally = evaluate.hostile(3 if request.config.getoption("--sweep", default=False) else 1)
    assert max(tally.times) < 10 and not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("before", "after", "domains", "status", "needs"),
    [
        ("x*y/x", "y", REAL, "proved", ("x != 0",)),
        ("x*y/x", "y", {"x": "nonzero", "y": "real"}, "proved", ()),
        ("y", "x*y/x", REAL, "refuted", None),  # a point of the domain is lost
        ("(x**3)**(1/3)", "x", REAL, "sampled", ("x >= 0",)),
        ("sqrt(x**2)", "x", REAL, "refuted", None),
        ("log(x**2)", "2*log(x)", REAL, "refuted", None),
        ("2*log(x)", "log(x**2)", REAL, "sampled", None),
        ("atan2(2*y,2*x)", "atan2(y,x)", REAL, "proved|sampled", None),
        ("Derivative(Abs(x),x)", "sign(x)", REAL, "proved", ("x != 0",)),
        ("x*(1+1/1000000000)", "x", REAL, "refuted", None),
        ("atan2(sin(a),cos(a))", "a", {"a": "angle"}, "refuted", None),
        ("Max(x,-10**12)", "x", REAL, "refuted", None),
    ],
)
def test_policy(before, after, domains, status, needs):
    verdict = check_step(before, after, domains)
    assert verdict.status in status.split("|")
    assert needs is None or verdict.conditions == needs


TURN = "Matrix([[cos(x),-sin(x)],[sin(x),cos(x)]])"
SEQUENCE = {"x": "seq", "N": "int>=2", "i": "index", "r": "int>=1", "k": "index"}
NOT_PROVED = "sampled|refuted|undecided"


@pytest.mark.parametrize(
    ("before", "after", "domains", "status"),
    [
        # No proof across an empty range, at an end of a range, over a pole or a bend.
        ("Sum(k,(k,r,9))", "45-r*(r-1)/2", SEQUENCE, "refuted"),
        ("Product(1-1/k,(k,r,10))", "(r-1)/10", SEQUENCE, "refuted"),
        ("Sum(1,(k,r,N))", "N-r+1", SEQUENCE, "refuted"),
        ("Sum(1,(k,3,N+2))", "N", SEQUENCE, "proved"),
        ("Sum(k,(k,1,N))", "N*(N+1)/2", {"N": "int>=0"}, "proved"),
        ("Sum(k,(k,1,N-2))", "(N-2)*(N-1)/2", {"N": "int>=1"}, "sampled"),
        ("Sum(1,(k,1,N-2))", "N-2", {"N": "int>=1"}, "refuted"),
        (
            "Derivative(Sum((x[j+1]-x[j])**2,(j,0,N-1)),x[i])",
            "4*x[i]-2*x[i-1]-2*x[i+1]",
            SEQUENCE,
            "refuted",
        ),
        ("Derivative(Sum(x[j]**2,(j,1,N)),x[i])", "2*x[i]", SEQUENCE, "proved"),
        ("Integral(1/(x-2)**2,(x,0,a))", "a/(2*(2-a))", {"a": ">0"}, "refuted"),
        ("Integral(1/(x-2)**2,(x,0,a))", "a/(2*(2-a))", {"a": "(0,2)"}, "proved"),
        ("Integral(1/x**2,(x,-1,1))", "-2", {}, "refuted"),
        ("Integral(Abs(x),(x,0,b))", "b**2/2", {"b": "(-1/100,3)"}, "refuted"),
        ("Integral(Abs(x),(x,0,b))", "b*Abs(b)/2", {"b": "(-1,3)"}, NOT_PROVED),
        ("Integral(exp(-a*x),(x,0,oo))", "1/a", {"a": "nonzero"}, "refuted"),
        ("Integral(exp(-x**2),(x,0,5))", "sqrt(pi)/2", {}, "refuted"),
        # No accusation by a tolerance, by a stand-in for pi, by letters that are called alike.
        ("", "exp(-x**2)>0", REAL, "proved"),
        ("", "exp(-300*x)>0", {"x": ">0"}, "proved|sampled"),
        ("", "erf(x)<1", REAL, "sampled"),
        ("", "tanh(x)**2<1", REAL, "sampled"),
        ("", "exp(-200*x)<=0", {"x": "(1,2)"}, "refuted"),
        ("acos(cos(x))", "x", {"x": "(0,pi)"}, "sampled|proved"),
        ("acos(cos(x))", "x", {"x": "(0,4)"}, "refuted"),
        ("", "sin(x)>0", {"x": "(0,pi)"}, "sampled|proved"),
        ("atan2(sin(x),cos(x))", "x", {"x": "(0,pi)"}, "sampled|proved"),
        ("Derivative(Integral(z**2+1,(z,0,z)),z)", "z**2+1", {"z": "real"}, "proved"),
        (
            "Derivative(exp(-(x-m)**2/2),x)",
            "-(x-m)*exp(-(x-m)**2/2)",
            {**REAL, "m": "real"},
            "proved",
        ),
        # What holds for small numbers, at most points, or to many digits.
        ("", "(1+1/n)**n<=27/10", {"n": "int>=1"}, "refuted"),
        ("", "Sum(1/k,(k,1,n))<=3", {"n": "int>=1"}, "refuted"),
        ("", "2**n>=n**2", {"n": "int>=1"}, "refuted"),
        ("Mod(2**n-2,n)", "0", {"n": "int>=1"}, "refuted"),
        ("ceiling(95*n/100)", "floor(95*n/100)+1", {"n": "int>=1"}, "refuted"),
        ("ceiling(log(n)/log(2))", "floor(log(n)/log(2))+1", {"n": "int>=3"}, "refuted"),
        ("ceiling(x)", "floor(x)+1", {"x": "(0,7)"}, "refuted"),
        ("", "cos(n)>-1+10**(-9)", {"n": "int>=0"}, "refuted"),
        ("k/(n+1)", "1/(n+1)", {"k": "index", "n": "int>=1"}, "refuted"),
        ("Sum(x[j],(j,1,i))", "x[i]", SEQUENCE, "refuted"),
        ("Derivative(f(x,y),y,3)", "0", {**REAL, "f": "function"}, "refuted"),
        ("Max(0,sin(x)-9999/10000)", "0", REAL, "refuted"),
        ("", "exp(-1000*(x-7)**2)<=1/2", REAL, "refuted"),
        ("", "x**x>=0.69221", {"x": ">0"}, "refuted"),
        ("", "(x-1)**2+(y-2)**2>0", REAL, "refuted"),
        ("", "x/(1+x**2)**2<3*sqrt(3)/16", REAL, "refuted"),
        ("sqrt(2)", "1.4142135623730951", {}, "refuted"),
        ("1-cos(x)", "x**2/2", {"x": "(0,1/1000)"}, "refuted"),
        # Corners: everything zero or one, an angle that is part of a turn, a diagonal matrix.
        (
            "Sum(x[i]**2,(i,1,N))",
            "Sum(x[i]**2,(i,1,N))**2/Sum(x[i]**2,(i,1,N))",
            SEQUENCE,
            "refuted",
        ),
        ("", "x*cos(a)+y*sin(a)<sqrt(x**2+y**2)", {"a": "angle", "x": ">0", "y": ">0"}, "refuted"),
        ("", "P.inv()[0,0]>1/P[0,0]", {"P": "spd3"}, "refuted"),
        ("x-2*pi*floor((x+pi)/(2*pi))", "atan2(sin(x),cos(x))", REAL, "refuted"),
        ("", "x**4-3*x**2+9/4>0", REAL, "refuted"),
        ("", "(x-sqrt(2))**2>0", REAL, "refuted"),
        ("", "(x-sqrt(2))**2>=0", REAL, "proved"),
        # What 200 bits cannot tell, terms of a series that still rise, roots that touch zero.
        ("sqrt(10**40+x)-10**20", "x/(2*10**20)", {"x": ">0"}, "refuted"),
        (
            "Sum((1-q)**m*binomial(k+m-1,k)*q**k,(k,0,oo))",
            "1",
            {"m": "int>=1", "q": "(0,1)"},
            NOT_PROVED,
        ),
        ("Integral(sqrt(1-cos(x)),(x,0,4*pi))", "8*sqrt(2)", {}, "sampled"),
        (
            "Integral(cos(t*z)*exp(-z**2/2)/sqrt(2*pi),(z,-oo,oo))",
            "1-t**2/2",
            {"t": "(0,1/10)"},
            "refuted",
        ),
        # Both parities, where few points can be afforded.
        (
            "Integral(z**n*exp(-z**2/2)/sqrt(2*pi),(z,-oo,oo))",
            "(1+(-1)**n)/2*factorial(n)/(2**(2*n)*gamma(n/2+1))",
            {"n": "int>=0"},
            "refuted",
        ),
        # Limits, series and integrals that do not exist; a point that only the line after loses.
        ("Limit(exp(-a*x),x,oo)", "0", {"a": "nonzero"}, "refuted"),
        ("Limit(floor(x),x,1)", "1", {}, "refuted"),
        ("Limit((a*x+1)/(b*x+1),x,oo)", "a/b", {"a": "real", "b": "real"}, "refuted"),
        ("Limit((a*x+1)/(b*x+1),x,oo)", "a/b", {"a": "real", "b": ">0"}, "proved|sampled"),
        ("Sum((-1)**k,(k,0,oo))", "1/2", {}, "refuted"),
        ("Sum((-1)**k/(2*k+1),(k,0,oo))", "pi/4", {}, "proved|sampled"),
        ("Integral(1/(1-x**2),(x,-1,1))", "0", {}, "refuted"),
        ("Integral(1/sqrt(1-x**2),(x,-1,1))", "pi", {}, "proved|sampled"),
        # Small regions in more than one letter, and between two places where a line breaks.
        ("Max(0,1-1000*(x-1)**2-1000*(y-2)**2)", "0", REAL, "refuted"),
        ("Piecewise((1,And(x>3,x<3+1/1000)),(0,True))", "0", REAL, "refuted"),
        ("Max(Trace(P),1/1000)", "Trace(P)", {"P": "spd2"}, "refuted"),
        # Whole numbers: pairs, those next to a zero, and the many terms of a sum.
        ("", "n**2-2*m**2 != 1", {"m": "int>=1", "n": "int>=1"}, "refuted"),
        ("", "Abs(n/m-sqrt(2))>1/1000", {"m": "int>=1", "n": "int>=1"}, "refuted"),
        ("", "Sum(1/k,(k,1,n))<=6", {"n": "int>=1"}, "refuted"),
        # All digits that were written; numbers too large to be written out.
        ("", "pi<3.14159265358979323847", {}, "proved"),
        ("", "pi<3.14159265358979323846", {}, "refuted"),
        ("", "factorial(n)<=100**n", {"n": "int>=1"}, "refuted"),
        ("(x+y)**(x+y)**(x+y)**(x+y)", "x", REAL, "refuted"),
        ("floor(log(8)/log(2))", "3", {}, "proved|sampled"),
        # Conditions are said.
        ("Derivative(Max(x,0,y)**2,x)", "0", REAL, "refuted"),
        ("Derivative(Max(x,0)**2,x)", "2*Max(x,0)", REAL, "sampled|proved"),
        ("cot(x)*sin(x)", "cos(x)", REAL, "proved"),
        ("Sum(x[i]/x[i],(i,1,N))", "N", SEQUENCE, "proved"),
    ],
)
@pytest.mark.parametrize("seed", [0, 1])
def test_kinds_of_fault(before, after, domains, status, seed):
    verdict = check_step(before, after, domains, seed=seed)
    assert verdict.status in status.split("|"), verdict


@pytest.mark.parametrize(
    ("before", "needed"),
    [
        ("cot(x)*sin(x)", "sin(x) != 0"),
        ("Sum(y[i]/y[i],(i,1,N))", "y[i] != 0 for every i"),
        ("tr((x*P).inv()*(x*P))", "Determinant(x*P) != 0"),
        ("Derivative(Max(0,x),x)", "x != 0"),
    ],
)
def test_what_a_line_needs_is_said(before, needed):
    after = {"cot": "cos(x)", "Der": "Derivative(Max(x,0),x)"}.get(before[:3], "N")
    domains = {"x": "real", "y": "seq", "N": "int>=1", "P": "spd(N)"}
    verdict = check_step(before, after, domains)
    assert verdict.conditions == (needed,) and needed in verdict.message


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("Limit(sin(x)/x, x, 0)", "1"),
        ("limit(x*exp(-x), x, oo)", "0"),
        ("Limit(1/x, x, oo)", "0"),
        ("Piecewise((x, x <= 0), (0, True))", "Min(x, 0)"),
        ("trace(P)", "P[0,0]+P[1,1]"),
        ("tr(P*Q)", "tr(Q*P)"),
        ("inv(L*L.T)", "L.T.inv()*inv(L)"),
        ("diff(x**2, x)", "2*x"),
        ("integrate(x**2, (x, 0, 1))", "1/3"),
        ("summation(k, (k, 1, N))", "N*(N+1)/2"),
        ("Sum(1/2**k, (k, 1, oo))", "1"),
        ("E**x", "exp(x)"),
        ("log(Product(p[i], (i, 1, N)))", "Sum(log(p[i]), (i, 1, N))"),
        ("x == y", "x − y == 0"),
        ("0 < x < 1", "And(x > 0, x < 1)"),
        ("norm(v)**2", "v.T*v"),
        ("u.T*cross(u, w)", "0"),
        ("det(diag(x, y))", "x*y"),
        (f"Derivative({TURN}, x)", f"Matrix([[0,-1],[1,0]])*{TURN}"),
    ],
)
def test_reads_what_students_write(before, after):
    domains = {**REAL, "P": "spd2", "Q": "spd2", "L": "chol2", "N": "int>=1", "i": "index"}
    domains |= {"p": "positive sequence", "v": "vec2", "u": "vec3", "w": "vec3"}
    verdict = check_step(before, after, domains)
    assert verdict.status in ("proved", "sampled"), verdict


ANY_SIZE = {"m": "int>=1", "n": "int>=1", "A": "mat(m,n)", "B": "mat(n,m)", "M": "mat(n,n)"}
ANY_SIZE |= {"P": "spd(n)", "L": "chol(n)", "R": "rot(n)", "u": "vec(n)", "v": "vec(n)"}


@pytest.mark.parametrize(
    ("before", "after", "status"),
    [
        ("Trace(A*B)", "Trace(B*A)", "proved"),
        ("(A*B).T", "B.T*A.T", "proved"),
        ("v.T*(L*L.T).inv()*v", "(L.inv()*v).T*(L.inv()*v)", "proved"),
        ("Trace(P.inv()*v*v.T)", "v.T*P.inv()*v", "proved"),
        ("Trace(v*v.T*P*v*v.T)", "(v.T*v)*(v.T*P*v)", "proved"),
        ("L.inv()*(L*L.T)*L.inv().T", "eye(n)", "proved"),
        ("Trace(R.T*P*R)", "Trace(P)", "proved"),
        ("Trace(P.inv()*P)", "n", "proved"),
        ("det(L*L.T)", "det(L)**2", "proved"),
        ("u.T*P*v", "v.T*P*u", "proved"),
        ("(P+u*u.T).inv()*(P+u*u.T)", "eye(n)", "sampled"),
        ("R*P*R.T", "P", "refuted"),
        ("u.T*M*v", "v.T*M*u", "refuted"),
        ("(P*M).inv()", "P.inv()*M.inv()", "refuted"),
        ("Trace(P*M)", "Trace(P)*Trace(M)", "refuted"),
        ("det(2*P)", "2*det(P)", "refuted"),
        ("Trace(M*M.T)", "Trace(M*M)", "refuted"),
        ("(A*B).T", "A.T*B.T", "unreadable"),
    ],
)
def test_matrices_of_any_size(before, after, status):
    assert check_step(before, after, ANY_SIZE).status == status


@pytest.mark.parametrize(
    ("before", "after", "status"),
    [
        ("tr(eye(n))", "n", "proved"),
        ("tr(eye(m)-J*(J.T*J).inv()*J.T)", "tr(eye(m))-tr(J*(J.T*J).inv()*J.T)", "proved"),
        ("tr(J*(J.T*J).inv()*J.T)", "tr((J.T*J).inv()*(J.T*J))", "proved"),
        ("m-tr((J.T*J).inv()*(J.T*J))", "m-n", "proved"),
        ("tr(J*(J.T*J).inv()*J.T)", "m", "refuted"),
        ("J*(J.T*J).inv()*J.T", "eye(m)", "refuted"),
        ("(J.T*J).inv()*J.T*J", "eye(n)", "proved"),
        ("J*(J.T*J).inv()*J.T*J", "J", "proved"),
        ("(J.T*J).inv().T", "(J.T*J).inv()", "proved"),
        ("G*(J.T*J)", "eye(n)", "refuted"),
    ],
)
def test_projections_onto_the_columns_of_a_matrix(before, after, status):
    domains = {"m": "int>=1", "n": "int>=1", "J": "mat(m,n)", "G": "spd(n)"}
    assert check_step(before, after, domains).status == status


def test_a_product_that_is_not_square_is_inverted_as_a_whole():
    """No word of it cancels, whatever the points say: J is no square matrix."""
    domains = {"m": "int>=1", "n": "int>=1", "J": "mat(m,n)"}
    for pair in (("J*(J.T*J).inv()*J.T", "eye(m)"), ("det(J.T*J)", "det(J*J.T)")):
        assert not Step(*pair, domains, "iff", None, 0).proved()
    assert Step("det(J.T*J)", "det(J.T*J)", domains, "iff", None, 0).proved()


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("Limit(x+y,y,0)/Limit(2+y,y,0)", "x/2"),
        ("x/Sum(k,(k,1,3))", "x/6"),
        ("x/Integral(z,(z,0,2))", "x/2"),
    ],
)
def test_numbers_with_bound_letters_may_be_divided_by(before, after):
    assert check_step(before, after, REAL).status == "proved"


@pytest.mark.parametrize("line", ["det(R)", "R.T*R", "(R*v).T*(R*v)"])
def test_rotations_in_space(line):
    after = {"det(R)": "1", "R.T*R": "eye(3)"}.get(line, "v.T*v")
    assert check_step(line, after, {"R": "rot3", "v": "vec3"}).status == "proved"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("Sum(binomial(n,k)*q**k*(1-q)**(n-k),(k,0,n))", "1"),
        ("Sum(k*binomial(n,k)*q**k*(1-q)**(n-k),(k,0,n))", "n*q"),
        ("Sum(k**2*binomial(n,k)*q**k*(1-q)**(n-k),(k,0,n))", "n*q*(1-q)+n**2*q**2"),
        ("Sum(q*(1-q)**(k-1),(k,1,n))", "1-(1-q)**n"),
        ("Sum(q**k,(k,0,oo))", "1/(1-q)"),
    ],
)
def test_sums_with_powers_of_probabilities(before, after):
    verdict = check_step(before, after, {"n": "int>=1", "q": "(0,1)"})
    assert (verdict.status, verdict.conditions) == ("proved", ())


def test_a_place_between_two_whole_numbers_is_none():
    for delta, place, known in (("k,m", "m", True), ("2*k,m+1", "(m+1)/2", False)):
        line = f"Sum(KroneckerDelta({delta})*k,(k,1,m))"
        assert Step(line, place, {"m": "int>=1"}, "iff", None, 0).proved() is known


def test_a_real_root_may_be_written_with_imaginary_numbers():
    four = sp.cbrt(2 + 11 * sp.I) + sp.cbrt(2 - 11 * sp.I)
    low, high = searching.number(four, Arithmetic(100))
    assert abs(as_float((low, high)) - 4) < 1e-12


def test_no_verdict_hangs_on_the_seed():
    for seed in range(8):
        assert check_step("", "exp(-x)>0", REAL, seed=seed).status == "proved"
        assert check_step("sqrt(x**2)", "x", REAL, seed=seed).status == "refuted"


def test_what_is_sampled_says_where():
    message = check_step("", "log(1+x)<=x", {"x": ">0"}).message
    assert "not a proof" in message and "downhill" in message and "very large" in message
    nested = "Sum(Sum(1/(j+k),(j,1,n)),(k,1,n))<=n*n"
    assert "one by one and up to 10000" not in check_step("", nested, {"n": "int>=1"}).message


@pytest.mark.parametrize(
    ("before", "after", "relation", "status"),
    [
        ("Eq(x**2,4)", "Eq(x,2)", "iff", "refuted"),
        ("Eq(x**2,4)", "Eq(x,2)", "implies", "refuted"),
        ("Eq(x**2,4)", "Eq(x,2)", "implied_by", "proved"),
        ("Eq(x**2,4)", "Or(Eq(x,2),Eq(x,-2))", "iff", "sampled"),
        ("Eq(x*y,y)", "Eq(x,1)", "iff", "refuted"),
        ("Eq(2*x,y)", "Eq(x,y/2)", "iff", "proved"),
        ("Gt(-2*x,y)", "Lt(x,-y/2)", "iff", "proved"),
        ("Gt(-2*x,y)", "Gt(x,-y/2)", "iff", "refuted"),
    ],
)
def test_equations(before, after, relation, status):
    assert check_step(before, after, REAL, relation, unknown="x").status == status


@pytest.mark.parametrize(
    ("before", "after", "relation", "status"),
    [
        ("And(x+2*y == 4, 3*x-y == 5)", "And(x == 2, y == 1)", "iff", "sampled"),
        ("And(x+2*y == 4, 3*x-y == 5)", "And(x == 1, y == 2)", "iff", "refuted"),
        ("And(x*y == 6, x+y == 5)", "And(x == 2, y == 3)", "implies", "refuted"),
        ("And(x*y == 6, x+y == 5)", "And(x == 2, y == 3)", "implied_by", "sampled"),
        ("Not(x < y)", "x >= y", "iff", "sampled"),
        ("Not(x < y)", "x > y", "iff", "refuted"),
    ],
)
def test_claims_that_are_joined(before, after, relation, status):
    assert check_step(before, after, REAL, relation).status == status


@pytest.mark.parametrize(
    ("before", "after", "kind", "status"),
    [
        # Solutions beyond a pole, a solution where the line touches zero, one side that is zero.
        ("Eq(tan(x),tan(y))", "Eq(x,y)", "real", "refuted"),
        ("Eq(cos(x),1)", "Eq(x,0)", "real", "refuted"),
        ("Eq(cos(x-y),1)", "Eq(x,y)", "real", "refuted"),
        ("Eq(sin(x)**2,1)", "Eq(x,pi/2)", "real", "refuted"),
        ("Eq(sin(x-y),0)", "Eq(x,y)", "angle", "refuted"),
        # Angles are equal up to whole turns, whichever letter the line is solved for.
        ("Eq(cos(x-y),1)", "Eq(x,y)", "angle", "sampled"),
        ("Eq(cos(x-y),1)", "Eq(x,y+2*pi)", "angle", "sampled"),
        ("And(Eq(cos(x),cos(y)),Eq(sin(x),sin(y)))", "Eq(x,y)", "angle", "sampled"),
        ("Eq(cos(x),0)", "Or(Eq(x,pi/2),Eq(x,-pi/2))", "angle", "sampled"),
        ("Eq(cos(x),0)", "Eq(x,pi/2)", "angle", "refuted"),
        # A line that is not defined where the other one holds, at no turn of the angle either.
        ("Eq(sin(x)*y,sin(x))", "Eq(y,sin(x)/sin(x))", "angle", "refuted"),
    ],
)
@pytest.mark.parametrize("unknown", [None, "x"])
def test_equations_with_many_solutions(before, after, kind, status, unknown):
    domains = {"x": kind, "y": kind}
    assert check_step(before, after, domains, "implies", unknown).status == status


def test_one_point_alone_is_no_sample():
    inner = "Integral(a*b*exp(-a*x-b*y),(y,x,oo))"
    domains = {"a": "(1/2,3)", "b": "(1/2,3)"}
    verdict = check_step(f"Integral({inner},(x,0,oo))", "b/(a+b)", domains)
    assert verdict.points == 1 and verdict.status == "undecided"


def test_no_proof_without_its_conditions(monkeypatch):
    def endless(*_):
        while True:
            abs(1)

    step = "x*y/x", "y", REAL
    assert check_step(*step).status == "proved"
    monkeypatch.setattr("amrmetrics.derivation.checking.conditions", endless)
    assert check_step(*step).status == "sampled"


def test_a_vector_can_be_the_unknown():
    domains = {"P": "spd2", "x": "vec2", "b": "vec2"}
    assert check_step("Eq(P*x,b)", "Eq(x,P.inv()*b)", domains, unknown="x").status == "proved"
    assert check_step("Eq(P*x,b)", "Eq(x,P*b)", domains, unknown="x").status == "refuted"


@pytest.mark.parametrize(
    ("line", "hint"),
    [
        ("2x", "2*x"),
        ("|x|", "Abs(x)"),
        ("n!", "factorial(n)"),
        ("1e-400*x", "'1e-400' is not a number"),
        ("x^2", "**"),
        ("x = 1", "Eq(left, right)"),
        ("lambda*x", "lam"),
        ("sinn(x)", "did you mean sin"),
        ("z+1", "declare"),
        ("q+1", "q is not declared; declare it"),
        ("x(y+1)", "product"),
        ("", "claims nothing|empty"),
        ("__import__('os')", "not declared|number"),
        ("x.__class__", "matrices have"),
    ],
)
def test_hints(line, hint):
    verdict = check_step("x", line, REAL)
    assert verdict.status == "unreadable"
    assert any(h in verdict.message for h in hint.split("|")), verdict.message


def test_feedback_names_the_difference_and_not_the_answer():
    def message(after):
        domains = {"N": "int>=2", "d": "seq", "s": ">0", "i": "index"}
        return check_step("Sum(d[i]**2,(i,1,N))/(N-1)+s", after, domains).message

    assert "factor 2" in message("2*(Sum(d[i]**2,(i,1,N))/(N-1)+s)")
    assert "differ by the sign" in message("-Sum(d[i]**2,(i,1,N))/(N-1)-s")
    assert (
        "equal if N in the line after were N - 1"
        in check_step("s/(N-1)", "s/N", {"N": "int>=2", "s": ">0"}).message
    )
    assert "multiple of the term 3*s" in message("Sum(d[i]**2,(i,1,N))/(N-1)+3*s")


def test_witness_is_the_simplest_and_drops_what_is_not_used():
    verdict = check_step("(x+y)**2", "x**2+y**2", {**REAL, "unused": "angle"})
    assert verdict.witness == {"x": 1, "y": 1}
    assert (verdict.before_value, verdict.after_value) == (4, 2)
    verdict = check_step("R*P*R.T", "P", {"R": "rot", "P": "spd2"})
    assert sp.Matrix(verdict.before_value).shape == (2, 2)
    with pytest.raises(TypeError, match="status"):
        bool(verdict)


def test_same_seed_same_verdict():
    step = ("log(Max(x,y))", "Max(log(x),log(y))", {"x": ">0", "y": ">0"})
    assert check_step(*step, seed=4) == check_step(*step, seed=4)


def endless():
    while True:
        len("a call, as all of SymPy makes them")


def test_time_limits_need_no_thread_and_leave_nothing_behind():
    seen = []

    def profiler(*event):
        seen.append(event)

    sys.setprofile(profiler)
    try:
        for _ in range(5):
            assert bounded(endless, 0.01) == (False, None)
            assert bounded(lambda: sum(range(1000)), 0.05) == (True, 499500)
        assert sys.getprofile() is profiler
    finally:
        sys.setprofile(None)
    with pytest.raises(ZeroDivisionError):
        bounded(lambda: 1 / 0, 1)
    assert sys.getprofile() is None


def test_a_limit_never_stops_its_own_end(monkeypatch):
    monkeypatch.setattr("amrmetrics.derivation.limits.CHUNK", 1)
    spent = []
    for work in range(12):  # some of them end just where the limit is
        try:
            spent.append(bounded(lambda work=work: [abs(k) for k in range(work)], 1.5e-6)[0])
        finally:
            assert sys.getprofile() is None
    assert {True, False} == set(spent)


def test_a_profiler_goes_on_after_a_limit():
    import cProfile

    profiler = cProfile.Profile()
    profiler.enable()
    bounded(lambda: sum(range(10)), 1)
    abs(-1)
    profiler.disable()
    names = [entry.code for entry in profiler.getstats()]
    assert any("abs" in str(name) for name in names)


def test_a_limit_inside_a_limit_keeps_both():
    inner = []

    def outer():
        inner.append(bounded(endless, 10))

    assert bounded(outer, 0.05) == (False, None)
    assert inner == []  # the outer limit ended both
    assert bounded(lambda: bounded(endless, 0.01), 1) == (True, (False, None))


def test_a_library_may_give_up_and_this_package_may_not(monkeypatch):
    assert bounded(
        lambda: sp.Poly(sp.sin(sp.Symbol("x")) ** sp.Symbol("x"), sp.Symbol("x")), 1
    ) == (
        False,
        None,
    )

    def mistaken(*_):
        raise TypeError("a mistake in the checker")

    monkeypatch.setattr("amrmetrics.derivation.checking.conditions", mistaken)
    with pytest.raises(TypeError, match="a mistake in the checker"):
        check_step("x+x", "2*x", REAL)


def test_runs_where_no_thread_can_start():
    """As in a browser: no new threads, no thread clock, no signals."""
    code = """
import _thread, signal, sys, threading, time
def refuse(*_, **__):
    raise RuntimeError("cannot start a new thread")
_thread.start_new_thread = threading._start_new_thread = threading.Thread.start = refuse
absent = [(time, "thread_time"), (time, "pthread_getcpuclockid")]
for module, name in [*absent, (signal, "setitimer"), (signal, "alarm")]:
    if hasattr(module, name):
        delattr(module, name)
for name in ("numpy", "scipy", "multiprocessing"):
    sys.modules[name] = None
from amrmetrics.derivation import check_step
print(check_step("sin(x)**2+cos(x)**2", "1", {"x": "real"}).status)
print(check_step("Integral(x*exp(-a*x),(x,0,oo))", "1/a**2", {"a": ">0"}).status)
print(check_step("sqrt(x**2)", "x", {"x": "real"}).status)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stdout.split() == ["proved", "proved", "refuted"], done.stderr


def test_a_check_outside_the_main_thread():
    out = []
    check = threading.Thread(target=lambda: out.append(check_step("x+x", "2*x", REAL)))
    check.start()
    check.join(30)
    assert out[0].status == "proved"


# --- chains ---------------------------------------------------

DOMAINS = {"p": "seq", "q": "seq", "t": "real", "N": "int>=1", "i": "index"}
GIVEN = "Eq(Derivative(Sum((q[i]-p[i]-t)**2,(i,1,N)),t),0)"
MIDDLE = "Eq(-2*Sum(q[i]-p[i],(i,1,N))+2*N*t,0)"
GOAL = "Eq(t,Sum(q[i],(i,1,N))/N-Sum(p[i],(i,1,N))/N)"


def chain(**changes):
    task = {"goal": GOAL, "given": GIVEN, "domains": DOMAINS, "must_pass": [MIDDLE]}
    return Derivation(**{**task, **changes})


def test_a_chain_reaches_its_goal():
    D = chain().check([GIVEN, MIDDLE, (GOAL, "divide by 2N")])
    assert D.complete and D.problems == []
    assert [v.status for v in D.verdicts] == ["proved", "proved"]
    assert "⇔" in D.text() and "divide by 2N" in str(D)
    assert D._repr_html_() == chain().check([MIDDLE, (GOAL, "divide by 2N")])._repr_html_()
    assert r"\sum_{i=1}^{N}" in D.steps[0]._repr_html_()


@pytest.mark.parametrize(
    ("lines", "problem"),
    [
        ([], "no lines"),
        ([GOAL], "leaps over a step"),
        ([MIDDLE], "goal is not reached"),
        ([MIDDLE, MIDDLE, GOAL], "changes nothing"),
        ([MIDDLE, "Eq(2*N*t-2*Sum(q[i]-p[i],(i,1,N)),0)", GOAL], "changes nothing"),
        ([MIDDLE, "Eq(t,Sum(q[i]-p[i],(i,1,N)))", GOAL], "line 2: wrong"),
        ([MIDDLE, "Eq(t,,)", GOAL], "line 2: unreadable"),
        ([MIDDLE.replace("N*t", "t"), MIDDLE, GOAL], "line 1: wrong"),
    ],
)
def test_what_a_chain_is_told(lines, problem):
    D = chain().check(lines)
    assert not D.complete
    assert any(problem in p for p in D.problems), D.problems


def test_a_lemma_is_assumed_and_must_be_declared():
    task = {"goal": "1", "given": "E2/s**2", "domains": {"E2": ">0", "s": ">0"}}
    D = Derivation(**task, lemmas={"variance": "Eq(E2,s**2)"})
    assert "assumed: variance" in repr(D.step("1", lemma="variance"))
    assert D.complete and "assumed: variance" in D.text()
    D = Derivation(**task)
    D.step("1", lemma="variance")
    assert not D.complete and "not declared" in D.problems[0]
    D = Derivation(**task, lemmas={"variance": "Eq(E2,s**2)"})
    D.step("E2*s**(-2)*s/s", lemma="variance")
    assert D.check(["1"]).verdicts[-1].status == "refuted"


def test_sympy_objects_and_text_give_the_same_chain():
    C, S, a = sp.symbols("C S a", real=True)
    f = C * sp.cos(a) + S * sp.sin(a)
    task = {"domains": {"C": "real", "S": "real", "a": "angle"}}
    one = Derivation(goal=sp.diff(f, a), given=sp.Derivative(f, a), **task)
    one.step(sp.diff(f, a))
    two = Derivation(goal="-C*sin(a)+S*cos(a)", given="Derivative(C*cos(a)+S*sin(a),a)", **task)
    two.step("S*cos(a)-C*sin(a)")
    assert one.complete and two.complete


@pytest.mark.parametrize(
    ("line", "latex"),
    [
        ("1/(1-p)", r"\frac{1}{1 - p}"),
        ("1/2*p", r"\frac{1}{2} p"),
        ("11/p", r"\frac{11}{p}"),
        ("p*1*2", r"p \cdot 1 \cdot 2"),
    ],
)
def test_a_line_is_set_as_it_is_written(line, latex):
    assert Derivation(line, domains={"p": "(0,1)"}).step(line).latex == latex


def test_the_task_itself_is_checked():
    with pytest.raises(ValueError, match="goal cannot be read"):
        Derivation(goal="2x", domains=REAL)
    with pytest.raises(ValueError, match="relation"):
        check_step("x", "x", REAL, relation="equal")
    assert check_step("x", "x", {"x": "complex"}).status == "unreadable"


def test_public_corpus_is_unchanged():
    steps = json.loads((Path(__file__).parent / "derivations/public.json").read_text("utf-8"))
    assert len(steps) == 112 and sum(s["valid"] for s in steps) == 52


@pytest.mark.parametrize(
    ("before", "after", "status"),
    [
        (None, "c - y > 0", {"sampled", "proved"}),
        (None, "c - y > y", {"refuted"}),
        ("s - c > j*(c - y)", "j < (s - c)/(c - y)", {"sampled", "proved"}),
        ("(c - y)**2", "c**2 - 2*c*y + y**2", {"proved"}),
        ("y*z == c", "z == c/y", {"proved", "sampled"}),
    ],
)
def test_an_interval_may_end_in_a_letter(before, after, status):
    names = {"c": ">0", "y": "(0,c)", "j": "int>=1", "s": ">0", "z": ">0"}
    assert check_step(before, after, names).status in status


@pytest.mark.parametrize("n", [">0", "int>=1"])
@pytest.mark.parametrize("seed", range(3))
def test_an_integrand_may_grow_at_an_end(n, seed):
    names = {"n": n, "w": ">0"}
    right = "Integral(w**(n/2 - 1/2)*exp(-w), (w, 0, oo))", "gamma((n + 1)/2)"
    assert check_step(*right, names, seed=seed).status in ("proved", "sampled")
    near = f"({right[1]})*(1 + 10**-9)"
    assert check_step(right[0], near, names, seed=seed).status == "refuted"
