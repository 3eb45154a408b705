"""Run the large matrix of lecture 10 and store its numbers: ``python3 tools/matrix.py``.

Six systems, six scenarios to test on and one to tune on, 25 seeds: 1050 trials. On two cores this
takes about ten minutes, and half a gigabyte for the raw logs, which are thrown away unless
``--logs`` names a folder for them. (A folder of an earlier run is not run again.) Written are

notebooks/10_matrix.json         what `amrmetrics.benchmark.evaluate` found, saved
notebooks/10_matrix.csv          for each trial its error in percent of the path, rms, under other
                                 conventions, and if it covers enough of the truth
notebooks/10_matrix_tuning.csv   the same for settings of the EKF on one scenario, at 50 seeds

Times of frames are measured. All else is the same on each run, whatever the machine; nearly, as
no two libraries of linear algebra round alike.
"""

import argparse
import sys
import tempfile
from dataclasses import replace
from itertools import product
from pathlib import Path
from zlib import crc32

import numpy as np

import amrmetrics as am
from amrmetrics.benchmark import estimators, logs

FOLDER = Path(__file__).parents[1] / "notebooks"
NAMES = ("10_matrix.json", "10_matrix.csv", "10_matrix_tuning.csv")
SEEDS = range(25)
PROTOCOL = am.benchmark.Protocol(metric="drift_percent", statistic="mean")
# What a table holds: an alignment, and by how many frames the stamps of the estimate are late.
CONVENTIONS = {
    "rigid": ("rigid", 0),
    "none": ("none", 0),
    "origin": ("origin", 0),
    "similarity": ("similarity", 0),
    "late": ("rigid", 1),
}
TUNED_ON = "dropout"
GATES = (9.2, 11.3, 13.8, 16.0, 18.0, 21.0, 25.0, 35.0, 50.0)
PATIENCES = (5.0, 10.0, 15.0, 20.0)
TUNING_SEEDS = range(50)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--logs", type=Path, help="folder for the raw logs, kept; or go on there")
    parser.add_argument("--into", type=Path, default=FOLDER, help="folder for what is written")
    given = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as temporary:
        folder = given.logs or Path(temporary) / "matrix"
        run = am.benchmark.run(
            am.benchmark.systems(), am.benchmark.scenarios(), SEEDS, folder, protocol=PROTOCOL
        )
        print(run, file=sys.stderr)
        store(folder, given.into)
    store_tuning(given.into)


def store(folder, into):
    """Write what the trials in a folder give."""
    evaluation = am.benchmark.evaluate(folder)
    # A folder of this machine means nothing elsewhere.
    replace(evaluation, name="matrix", folder="").save(into / NAMES[0], digits=5, traces=False)
    entries = [entry for entry in logs.index(folder).entries if entry.split == "test"]
    lines = ["scenario,system,seed,covered," + ",".join(CONVENTIONS)]
    for entry in entries:
        trial = logs.read_trial(entry)
        name = f"{entry.scenario},{entry.system},{entry.seed}"
        lines.append(f"{name},{in_words(*judged(trial.truth, trial.estimate))}")
    write(into / NAMES[1], lines)


def judged(truth, estimate):
    """Return if enough of the truth is covered, and the error in % of the path it drove."""
    n = len(estimate.poses)
    covered = (n - 1) / (len(truth.poses) - 1) >= PROTOCOL.minimum_coverage
    return covered, [error(truth, estimate.poses, *c) for c in CONVENTIONS.values()]


def error(truth, poses, align, late):
    """Return the ATE in percent of the path, where stamps are late by so many frames."""
    n = min(len(poses), len(truth.poses) - late)
    reference = truth.poses[late : n + late]
    return 100 * am.ate(reference, poses[:n], align).rmse / am.path_length(truth.poses[:n])


def in_words(covered, errors):
    return f"{covered:d}," + ",".join(f"{x:.5g}" for x in errors)


def settings():
    """Yield what the EKF is tuned over, and last the system that it is compared with."""
    for gate, patience in product(GATES, PATIENCES):
        yield f"{gate:g},{patience:g}", estimators.ekf_localization, (gate, patience)
    robust = am.benchmark.systems()[-1]
    yield "pose_graph_robust,", robust.run, robust.settings


def tuned(log, truth, run, given):
    """Return the error in % of one trial, nan if it covers too little."""
    if isinstance(given, tuple):
        given = dict(zip(("gate", "lost_after"), given, strict=True))
    covered, errors = judged(truth, run(log, **given))
    return errors[0] if covered else float("nan")


def world(name, seed):
    """Return the log and the truth of a scenario at a seed, as `amrmetrics.benchmark.run` does."""
    scenario = next(x for x in am.benchmark.scenarios() if x.name == name)
    sequence = np.random.SeedSequence([seed, crc32(name.encode())])
    return scenario.make(np.random.default_rng(sequence), **scenario.settings)


def store_tuning(into):
    worlds = [world(TUNED_ON, seed) for seed in TUNING_SEEDS]
    lines = ["gate,patience," + ",".join(f"seed{seed}" for seed in TUNING_SEEDS)]
    for name, run, given in settings():
        errors = [tuned(log, truth, run, given) for log, truth in worlds]
        lines.append(f"{name}," + ",".join(f"{x:.4g}" for x in errors))
    write(into / NAMES[2], lines)


def write(path, lines):
    path.write_text("\n".join(lines) + "\n", encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
