"""Own data as a benchmark: recordings and estimates that are there already."""

from __future__ import annotations

import csv
import hashlib
import os
import pathlib
import warnings
from collections import Counter
from dataclasses import asdict
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics.bags import is_bag, read_bag
from amrmetrics.benchmark import logs
from amrmetrics.benchmark import protocol as protocols
from amrmetrics.benchmark.data import Estimate, Protocol, Truth
from amrmetrics.benchmark.running import Run, said_clearly
from amrmetrics.errors import AmrError, RecordingWarning
from amrmetrics.files import read
from amrmetrics.recording import Trajectory

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from typing import Any

    from amrmetrics._types import Path

NEEDED = ("system", "scenario", "seed", "reference", "estimate")
OPTIONAL = ("split", "times")
RECORDED = Protocol(
    calibration="not stated",
    synchronization="as recorded; nearest stamps",
)


def adopt(
    table: Path | Iterable[Mapping[str, Any]],
    folder: Path,
    *,
    protocol: Protocol = RECORDED,
) -> Run:
    """Make the folder of a benchmark out of recordings and estimates, without running anything.

    `evaluate`, `compare` and `report` then work on it as on one that `run` made. What cannot be
    read is a recorded failure, with the reason.

    Parameters
    ----------
    table : str, Path, or sequence of dict
        One row per trial, with the columns ``system``, ``scenario``, ``seed`` (the number of the
        repetition), ``reference`` and ``estimate``: a trajectory file as `amrmetrics.read` takes
        it, ``run.bag:/topic``, or a Trajectory. All systems share the reference of a scenario and
        seed. Columns that may be missing: ``split`` ("test" or "tuning") and ``times`` (the file
        with the stamps of KITTI files). A CSV file has these names in its first line; paths in it
        are relative to its folder, and commas, semicolons or tabs separate its columns.
    folder : str or Path
        For the logs; made if it is not there.
    protocol : Protocol
        Decisions taken before the evaluation. Say where calibration and clocks come from.

    Returns
    -------
    Run
        How many trials were read now, were there before, and could not be read.

    Raises
    ------
    AmrError
        If the table has no such columns, names a trial twice, or gives a scenario and seed two
        references; if the folder was begun with other data or another protocol.
    OSError
        If the table cannot be opened.

    References
    ----------
    Lecture 10.

    Examples
    --------
    >>> import os, tempfile
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> here = tempfile.mkdtemp()
    >>> t = np.arange(0, 10, 0.1)
    >>> for name, error in (("truth", 0.0), ("mine", 0.1)):
    ...     poses = am.planar_poses(np.c_[t, error * np.sin(t)], 0 * t)
    ...     am.write_tum(os.path.join(here, name), t, poses)
    >>> row = {"system": "mine", "scenario": "hall", "seed": 0}
    >>> row |= {name: os.path.join(here, name) for name in ("mine", "truth")}
    >>> row |= {"reference": row.pop("truth"), "estimate": row.pop("mine")}
    >>> am.benchmark.adopt([row], os.path.join(here, "logs")).failed
    0
    """
    rows = _rows(table)
    content = _written(rows, protocols.as_protocol(protocol))
    folder = pathlib.Path(folder)
    with said_clearly(folder):
        content = logs.begin(folder, content, protocols.refuse_other)
        with logs.locked(folder), logs.without_unfinished(folder):
            return _adopt(folder, content, rows)


def _rows(table):
    """Return the rows of a table, checked, with paths that can be opened."""
    if isinstance(table, str | os.PathLike):
        rows = [(f"line {k}", row) for k, row in _lines(table)]
        home, what = os.path.dirname(os.path.abspath(table)), os.fspath(table)
    else:
        rows = [(f"row {k}", row) for k, row in enumerate(table)]
        home, what = os.getcwd(), "table"
    if not rows:
        raise AmrError(f"{what} has no rows; one per trial is needed.")
    rows = [_row(row, home, f"{what}, {where}") for where, row in rows]
    _refuse_contradictions(rows, what)
    return rows


def _lines(table):
    """Yield the number and the entries of each line of a CSV file that has any."""
    with open(table, encoding="utf-8-sig", newline="") as file:
        try:
            text = file.read()
        except UnicodeDecodeError:
            raise AmrError(f"{table} is no text in UTF-8; save it as 'CSV UTF-8'.") from None
    head = text.partition("\n")[0]
    separator = max(",;\t", key=head.count)  # spreadsheets write what the country does
    lines = csv.DictReader(text.splitlines(), delimiter=separator)
    for row in lines:
        if None in row:
            raise AmrError(
                f"{table}, line {lines.line_num}: more entries than columns; put a path with a "
                f"{separator!r} in it into quotes."
            )
        if any(map(str.strip, filter(None, row.values()))):
            yield lines.line_num, row


def _row(row, home, where):
    row = {str(k).strip(): v.strip() if isinstance(v, str) else v for k, v in dict(row).items()}
    lacking = [name for name in NEEDED if row.get(name) in (None, "")]
    if lacking:
        raise AmrError(
            f"{where}: no {', '.join(lacking)}. A row needs {', '.join(NEEDED)}; the columns here "
            f"are {', '.join(row)}."
        )
    unknown = [name for name in row if name not in (*NEEDED, *OPTIONAL)]
    if unknown:
        raise AmrError(
            f"{where}: unknown column {unknown[0]!r}; known are {', '.join((*NEEDED, *OPTIONAL))}."
        )
    for name in ("system", "scenario"):
        protocols.check_name(row[name], f"{where}: {name}")
    row["split"] = row.get("split") or "test"
    if row["split"] not in ("test", "tuning"):
        raise AmrError(f"{where}: split is {row['split']!r}; expected 'test' or 'tuning'.")
    row["seed"] = _seed(row["seed"], where)
    for name in ("reference", "estimate", "times"):
        row[name] = _source(row.get(name), home, f"{where}: {name}")
    return row


def _seed(value, where):
    try:
        number = int(value)
    except (TypeError, ValueError):
        number = -1
    if number < 0 or str(number) != str(value).strip():
        raise AmrError(
            f"{where}: seed is {value!r}; expected a whole number: 0 for the first repetition of a "
            "scenario, 1 for the second ..."
        )
    return number


def _source(value, home, what):
    """Return a Trajectory as it is, and a path so that it can be opened from anywhere."""
    if value is None or value == "" or isinstance(value, Trajectory):
        return value or None
    if not isinstance(value, str | os.PathLike):
        raise AmrError(
            f"{what} is of type {type(value).__name__}; expected the path of a file or a "
            "Trajectory."
        )
    path = os.path.normpath(os.path.join(home, value))
    if "\\" in path and not os.path.exists(path):  # a table from Windows, read elsewhere
        other = os.path.normpath(path.replace("\\", "/"))
        path = other if os.path.exists(_bag_and_topic(other)[0]) else path
    return path


def _refuse_contradictions(rows, what):
    keys = Counter((row["scenario"], row["system"], row["seed"]) for row in rows)
    (scenario, system, seed), count = keys.most_common(1)[0]
    if count > 1:
        raise AmrError(f"{what} has system {system}, scenario {scenario}, seed {seed} twice.")
    for column in ("system", "scenario"):
        protocols.refuse_repeats(dict.fromkeys(row[column] for row in rows), what)
    shared: dict = {}
    for row in rows:
        _refuse_two(shared, (row["scenario"], row["seed"]), row, "reference", what)
        _refuse_two(shared, (row["scenario"],), row, "split", what)


def _refuse_two(shared, key, row, column, what):
    first = shared.setdefault((column, *key), row[column])
    if first is not row[column] and first != row[column]:
        where = f"scenario {row['scenario']}" + (f", seed {key[1]}" if len(key) > 1 else "")
        raise AmrError(
            f"{what} gives {where} two different entries in column {column}: {first} and "
            f"{row[column]}. Systems are compared on the same one."
        )


def _written(rows, protocol):
    """Return the content of protocol.json, which pins the data down to the bit."""
    splits = {row["scenario"]: row["split"] for row in rows}
    systems = dict.fromkeys(row["system"] for row in rows)
    known: dict = {}
    return {
        "format": protocols.FORMAT,
        "origin": "recordings",
        "protocol": protocols.as_plain(asdict(protocol), "protocol"),
        "scenarios": [{"name": n, "split": s, "description": ""} for n, s in splits.items()],
        "systems": [{"name": name, "description": ""} for name in systems],
        "rules": protocols.rules(protocol),
        "seeds": sorted({row["seed"] for row in rows}),
        "trials": [[row["scenario"], row["system"], row["seed"]] for row in rows],
        "sources": {_name(row): _sources(row, known) for row in rows},
        "versions": protocols.versions(),
    }


def _name(row):
    return f"{row['scenario']}/{row['system']}/{row['seed']}"


def _sources(row, known):
    """Return the names and the SHA-256 of what a trial is made of."""
    found = {}
    for column in ("reference", "estimate", "times"):
        source = row[column]
        if source is not None:
            key = id(source) if isinstance(source, Trajectory) else source
            if key not in known:
                known[key] = _digest(source)
            found[column] = {"name": _shown(source), "sha256": known[key]}
    return found


def _shown(source):
    return (
        source.source or "a Trajectory"
        if isinstance(source, Trajectory)
        else os.path.basename(source)
    )


def _digest(source):
    """Return the SHA-256 of a recording, None if it is not there."""
    digest = hashlib.sha256()
    if isinstance(source, Trajectory):
        for array in (source.stamps, source.poses):
            digest.update(b"" if array is None else np.ascontiguousarray(array).tobytes())
        return digest.hexdigest()
    path = pathlib.Path(_bag_and_topic(source)[0])
    files = sorted(p for p in path.rglob("*") if p.is_file()) if path.is_dir() else [path]
    try:
        for file in files:
            with open(file, "rb") as data:
                digest.update(hashlib.file_digest(data, "sha256").digest())
    except OSError:
        return None
    return digest.hexdigest()


def _bag_and_topic(path):
    """Return the path of a recording and the topic behind it, "" if there is none."""
    at = path.find(":/", 2)  # C:/run.txt is a file
    return (path[:at], path[at + 1 :]) if at > 0 and not os.path.exists(path) else (path, "")


# --- Reading ------------------------------------------------------------------------------------


def _adopt(folder, content, rows):
    entries = logs.index(folder).entries
    done, failed = 0, Counter()
    for entry, row in zip(entries, rows, strict=True):
        if entry.status == "missing" or not (
            logs.is_intact(entry) and logs.has_intact_world(entry)
        ):
            done += 1
            _record(folder, content, entry, row)
    for entry in logs.index(folder).entries:
        failed[entry.kind] += entry.status == "failed"
    kinds = {kind: n for kind, n in failed.items() if n}
    return Run(str(folder), len(rows), done, len(rows) - done, sum(kinds.values()), kinds)


def _record(folder, content, entry, row):
    """Log one trial."""
    common = {"scenario": entry.scenario, "seed": entry.seed, "protocol": content["digest"]}
    truth, why = _read(row["reference"], row["times"], "reference")
    if truth is not None and not logs.has_intact_world(entry):
        files = logs.truth_files(Truth(truth.stamps, truth.poses))
        said = {**common, **logs.shape_of(truth.poses), "repairs": list(truth.repairs)}
        logs.put_folder(folder, entry.world, logs.with_digests(files, logs.WORLD, said))
    estimate = None
    if truth is not None:
        estimate, why = _read(row["estimate"], row["times"], "estimate")
    files, said = {}, {"system": entry.system, **common, "status": "ok", "kind": "", "reason": ""}
    if estimate is None:
        said |= {"status": "failed", "kind": "not read", "reason": why, "detail": ""}
    else:
        repairs = "; ".join(f"repaired: {what}" for what in estimate.repairs)
        files = logs.estimate_files(Estimate(estimate.poses, estimate.stamps))
        said |= {"detail": repairs, **logs.shape_of(estimate.poses)}
    logs.put_folder(folder, entry.path, logs.with_digests(files, logs.TRIAL, said))


def _read(source, times, what):
    """Return a Trajectory with stamps, or None and why there is none."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RecordingWarning)  # repairs are logged
            found = _trajectory(source, times)
        if found.stamps is None:
            raise AmrError("it has no stamps; the column times names the file that has them")
    except Exception as error:
        said = " ".join(str(error).split()) or type(error).__name__
        if not isinstance(source, Trajectory):  # the same reason wherever the data lie
            home = os.path.dirname(_bag_and_topic(source)[0])
            said = said.replace(os.path.join(home, ""), "")
        return None, f"{what}: {said}"
    return found, ""


def _trajectory(source, times):
    if isinstance(source, Trajectory):
        return source
    path, topic = _bag_and_topic(source)
    if topic:
        return read_bag(path, topic)
    if is_bag(path):
        raise AmrError(
            f"{path} is a bag; write the topic behind it: {os.path.basename(path)}:/odom"
        )
    if times is not None:
        try:
            return read(path, times=times)
        except AmrError as error:
            if "times were given" not in str(error):
                raise
    return read(path)
