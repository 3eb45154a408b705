"""The public interface as a type checker sees it: a program that is right, and one that is not."""

import subprocess
import sys

RIGHT = """
import numpy as np

import amrmetrics as am
from amrmetrics import comparison

t = np.arange(10.0)
X = am.planar_poses(np.c_[t, t], t)
error = am.ate(X, X, align="none", first=5)
rmse: float = error.rmse
n: int = error.n
number: float = float(error)
relative = am.rpe(X, X, delta=2, unit="m").translation.rmse
truth = am.read_tum("a.txt", strict=True)
pair = am.match(truth, truth, interpolate=True, max_gap=3)
duration: float = pair.coverage.duration
part: am.Trajectory = truth.between(1, 2)
i, j = am.associate(t, [1, 2, 3])
offset: float = am.clock_offset(truth, truth)
rotation = am.align(X, X, mode="yaw").rotation
values = am.nees(np.zeros((3, 2)), np.zeros((3, 2, 2)))
p99: float = am.latency([0.1, 0.2]).p99
runs: int = comparison.runs_needed(0.1, 0.2)
verdict: str = am.compare_paired([1, 2], [3, 4]).verdict
graph = am.read_g2o("a.g2o")
chi_square: float = am.optimize(graph, loss="huber").chi_square
score: float = am.brier([[0, 1]], [[0.1, 0.9]]).value
am.write_tum("b.txt", truth)
text: str = am.page(am.evaluate("a.txt", ["b.txt", "c.txt"], offset="auto"))
plan = am.benchmark.Protocol(align="yaw", maximum_ate=2)
still = am.benchmark.System("still", lambda log: am.benchmark.Estimate(X))
done: int = am.benchmark.run(still, am.benchmark.scenarios(), 3, "logs", protocol=plan).done
lever: float = am.lever_arm(truth, X).rmse
failed: int = am.benchmark.adopt("table.csv", "logs", protocol=plan).failed
"""

WRONG = {
    "am.ate([[0.0]], [[0.0]], align=3)": "arg-type",
    "am.read_tum(7)": "arg-type",
    "am.associate([1.0], [2.0])[2]": "misc",
    "am.latency([0.1]).p98": "attr-defined",
    "am.no_such_function()": "attr-defined",
    'am.match("a.txt", "b.txt")': "arg-type",
    "x: str = am.path_length([[0, 0]])": "assignment",
    "am.rpe([[0.0]], [[0.0]], pair='all')": "call-arg",
    'am.benchmark.run(7, am.benchmark.scenarios(), 3, "logs")': "arg-type",
    'am.benchmark.System("still", 7)': "arg-type",
    'am.benchmark.adopt(7, "logs")': "arg-type",
}


def checked(path, program):
    path.write_text(program, encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--follow-imports=silent", "--ignore-missing-imports"]
    command += ["--cache-dir", str(path.parent / "cache"), str(path)]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, done.stdout


def test_a_right_program_has_no_error(tmp_path):
    code, said = checked(tmp_path / "right.py", RIGHT)
    assert code == 0, said


def test_each_wrong_line_has_its_error(tmp_path):
    lines = ["import amrmetrics as am", *WRONG]
    code, said = checked(tmp_path / "wrong.py", "\n".join(lines) + "\n")
    assert code == 1
    for number, kind in enumerate(WRONG.values(), 2):
        assert any(f":{number}: error:" in x and f"[{kind}]" in x for x in said.splitlines()), said
