"""From the raw logs of a benchmark to one table, with all that limits it (lecture 10).

`evaluate` computes every number from the logs again; it holds one world at a time. What the
figures of a report need is kept in a few hundred numbers per trial.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from amrmetrics._results import Result
from amrmetrics.alignment import MODES
from amrmetrics.benchmark import logs
from amrmetrics.benchmark.data import Protocol
from amrmetrics.benchmark.gathering import gather
from amrmetrics.benchmark.measuring import columns, empty_row
from amrmetrics.benchmark.summarizing import STATISTICS, Summary, summarize
from amrmetrics.benchmark.workers import measured
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from amrmetrics._types import Path as PathLike

# Decisions that the logs do not depend on: another choice can be tried on the same logs.
FREE = (
    "align",
    "max_difference",
    "deltas",
    "minimum_coverage",
    "maximum_ate",
    "metric",
    "better",
    "failures",
    "statistic",
    "confidence",
)
# What a saved evaluation says of itself.
KIND = "amrmetrics benchmark evaluation 1"
TEXTS = ("system", "scenario", "split", "status", "kind", "reason", "skipped")


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Evaluation(Result):
    """All trials of a benchmark with their numbers, and what they were computed under.

    Attributes
    ----------
    name, folder : str
        Of the benchmark; where its logs are, "" of one that was loaded from a file.
    decisions : dict
        The fields of the `Protocol` that was applied.
    departures : dict
        Of the decisions that differ from the recorded protocol: (recorded, applied).
    recorded : dict
        The recorded protocol.
    selection : dict
        For "systems", "scenarios" and "seeds": those that were evaluated, and how many are
        recorded, where these differ.
    rows : tuple of dict
        One per trial of the test scenarios, as in `table`.
    tuning : tuple of dict
        Likewise of the scenarios that parameters were tuned on. They are in no result.
    consistency : tuple of dict
        For each scenario and system the verdicts on NEES and NIS, over the seeds.
    notes : tuple of str
        What else was found in the folder.
    profiles, traces, frames : dict
        Thinned series for the figures of a report.
    known : dict
        Summaries that were asked for already.
    """

    name: str
    folder: str
    decisions: dict
    departures: dict
    recorded: dict
    selection: dict
    rows: tuple
    tuning: tuple
    consistency: tuple
    notes: tuple
    profiles: dict
    traces: dict
    frames: dict
    known: dict = field(default_factory=dict, repr=False)

    @property
    def title(self) -> str:
        """What was evaluated, and whether that is all of it under the recorded protocol."""
        return "; ".join([self._matrix(), *self.limits])

    @property
    def limits(self) -> tuple[str, ...]:
        """What keeps this from being the whole benchmark under its recorded protocol."""
        found = [
            f"SELECTION: {len(chosen)} of {known} {what} ({_few(chosen)})"
            for what, (chosen, known) in self.selection.items()
        ]
        missing = sum(row["status"] == "missing" for row in self.rows)
        if missing:
            found.append(f"INCOMPLETE: {missing} of {len(self.rows)} trials have not run")
        found += [
            f"DEPARTS from the recorded protocol: {name} is {applied!r}, recorded {recorded!r}"
            for name, (recorded, applied) in self.departures.items()
        ]
        return tuple(found)

    @property
    def systems(self) -> tuple[str, ...]:
        """Names, in the order of the protocol."""
        return tuple(dict.fromkeys(row["system"] for row in (*self.rows, *self.tuning)))

    @property
    def scenarios(self) -> tuple[str, ...]:
        """Names of the test scenarios, in the order of the protocol."""
        return tuple(dict.fromkeys(row["scenario"] for row in self.rows))

    @property
    def seeds(self) -> tuple[int, ...]:
        """All seeds."""
        return tuple(sorted({row["seed"] for row in (*self.rows, *self.tuning)}))

    @property
    def failures(self) -> tuple[dict, ...]:
        """System, scenario, seed, kind and reason of each failed trial of the test scenarios."""
        names = ("system", "scenario", "seed", "kind", "reason")
        failed = (row for row in self.rows if row["status"] == "failed")
        return tuple({name: row[name] for name in names} for row in failed)

    @property
    def skipped(self) -> dict[str, dict[str, int]]:
        """What could not be computed, and in how many trials for which reason."""
        found: dict[str, Counter] = {}
        for row in self.rows:
            for what, why in row["skipped"].items():
                found.setdefault(what, Counter())[why] += 1
        return {what: dict(whys) for what, whys in found.items()}

    def table(self) -> list[dict[str, Any]]:
        """Return one dictionary per trial, numbers or None, ready for pandas.

        ``skipped`` is a text that says why numbers are missing.
        """
        return [row | {"skipped": _as_text(row["skipped"])} for row in self.rows]

    def summary(self, metric: str | None = None) -> dict[tuple[str | None, str], Summary]:
        """Return the numbers over the trials, by (scenario, system); scenario None is all.

        Parameters
        ----------
        metric : str, optional
            A column of the table; that of the protocol by default.
        """
        metric = metric or self.decisions["metric"]
        if metric not in self.known:
            self.known[metric] = summarize(self.rows, metric, self.decisions)
        return dict(self.known[metric])

    def as_dict(self):
        """Return all rows, verdicts and limits, ready for JSON."""
        overall = {s: x.as_dict() for (where, s), x in self.summary().items() if where is None}
        return _without_nan(
            {
                "title": self.title,
                "decisions": self.decisions,
                "departures": self.departures,
                "selection": self.selection,
                "rows": self.table(),
                "tuning": [row | {"skipped": _as_text(row["skipped"])} for row in self.tuning],
                "consistency": list(self.consistency),
                "overall": overall,
                "failures": list(self.failures),
            }
        )

    def save(self, path: PathLike, digits: int = 4, traces: bool = True) -> None:
        """Write everything into one compact JSON file.

        Parameters
        ----------
        path : str or Path
            Where to.
        digits : int
            Significant digits of the numbers.
        traces : bool
            Whether to keep the trajectories that a report draws, every second point of them.
        """
        content = {
            "kind": KIND,
            "name": self.name,
            "decisions": self.decisions,
            "departures": self.departures,
            "recorded": self.recorded,
            "selection": self.selection,
            "rows": _columnar(self.rows, digits),
            "tuning": _columnar(self.tuning, digits),
            "consistency": _rounded(list(self.consistency), digits),
            "notes": list(self.notes),
            "profiles": _rounded(self.profiles, digits),
            "traces": _rounded(_thinned(self.traces), digits) if traces else {},
            "frames": self.frames,
        }
        text = json.dumps(_without_nan(_plain(content)), separators=(",", ":"), allow_nan=False)
        Path(path).write_text(text + "\n", encoding="utf-8")

    @staticmethod
    def load(path: PathLike) -> Evaluation:
        """Return an evaluation that was saved.

        Raises
        ------
        AmrError
            If the file is something else.
        """
        try:
            content = json.loads(Path(path).read_text(encoding="utf-8"))
        except ValueError:
            content = None
        if not isinstance(content, dict) or content.pop("kind", None) != KIND:
            raise AmrError(f"{path} is no saved evaluation of a benchmark.")
        pairs = {"departures": tuple, "selection": tuple}
        for name, kind in pairs.items():
            content[name] = {key: kind(value) for key, value in content[name].items()}
        for name in ("rows", "tuning"):
            content[name] = _rows_of(content[name])
        for name in ("consistency", "notes"):
            content[name] = tuple(content[name])
        content["profiles"] = _arrays(content["profiles"])
        content["traces"] = _arrays(content["traces"])
        return Evaluation(folder="", **content)

    def _matrix(self):
        k, m, n = len(self.systems), len(self.scenarios), len(self.seeds)
        sizes = ((k, "system"), (m, "scenario"), (n, "seed"))
        return f"{self.name}: " + ", ".join(f"{x} {name}{'s' * (x != 1)}" for x, name in sizes)

    def _title(self):
        return self.title

    def _rows(self):
        overall = {s: x for (where, s), x in self.summary().items() if where is None}
        rows = [("decides", self.decides)]
        rows += [(system, repr(x)) for system, x in overall.items()]
        kinds = Counter(f"{x['system']}, {x['kind']}" for x in self.failures)
        rows += [(f"failed: {kind}", f"{count}") for kind, count in kinds.items()]
        if self.tuning:
            names = ", ".join(dict.fromkeys(row["scenario"] for row in self.tuning))
            rows.append(("not in any result", f"{names}, for tuning"))
        return rows

    @property
    def decides(self) -> str:
        """The number that decides, and how failed trials count in it."""
        d = self.decisions
        meaning = columns(d)[d["metric"]].meaning
        rule = {"worst": "counts as the worst value of any system on its scenario"}
        return (
            f"What decides is the {d['statistic']} of {d['metric']} ({meaning}), {d['better']} is "
            f"better; a failed trial {rule.get(d['failures'], 'is counted beside the others')}"
        )

    def __repr__(self):
        rows = self._rows()
        width = max(len(name) for name, _ in rows)
        return "\n".join([self.title, *(f"  {name:{width}}  {text}" for name, text in rows)])


def evaluate(
    folder: PathLike,
    *,
    systems: Iterable[str] | None = None,
    scenarios: Iterable[str] | None = None,
    seeds: Iterable[int] | None = None,
    protocol: Protocol | Mapping[str, Any] | None = None,
    jobs: int | None = None,
) -> Evaluation:
    """Compute every number of a benchmark from its raw logs.

    Parameters
    ----------
    folder : str or Path
        As `run` or `adopt` left it; complete or not.
    systems, scenarios : sequence of str, optional
        Which ones; all by default. A selection says so in its title.
    seeds : sequence of int, optional
        Likewise.
    protocol : Protocol or dict, optional
        Other decisions than the recorded ones, all or those that differ; the title names them.
        What the logs depend on, such as the limit of time, cannot be changed afterwards.
    jobs : int, optional
        How many processes at most; as many as there are processors by default. The result is
        the same.

    Returns
    -------
    Evaluation
        One row per trial; failures and missing trials are rows, too.

    Raises
    ------
    AmrError
        If the folder is no benchmark, a file was changed, a trial was run under another
        protocol, or a name is unknown.

    References
    ----------
    Lecture 10.

    Examples
    --------
    >>> import tempfile
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t, rng = np.arange(0.0, 20.0, 0.1), np.random.default_rng(10)
    >>> xy = np.c_[5 * np.cos(t / 2), 3 * np.sin(t)]
    >>> truth = am.Trajectory(t, am.planar_poses(xy, 0 * t))
    >>> def drive(noise):
    ...     noisy = xy + noise * rng.normal(size=xy.shape)
    ...     return am.Trajectory(t, am.planar_poses(noisy, 0 * t))
    >>> table = [
    ...     {"system": name, "scenario": "yard", "seed": seed, "reference": truth,
    ...      "estimate": drive(noise)}
    ...     for name, noise in (("orb", 0.02), ("vins", 0.04)) for seed in range(8)
    ... ]
    >>> folder = tempfile.mkdtemp()
    >>> _ = am.benchmark.adopt(table, folder)
    >>> evaluation = am.benchmark.evaluate(folder)
    >>> len(evaluation.table()), len(evaluation.failures)
    (16, 0)
    >>> round(evaluation.summary()["yard", "orb"].value, 2)
    0.03
    """
    index = logs.index(folder)
    recorded = recorded_decisions(index.protocol)
    decisions, departures = _decisions(recorded, protocol)
    entries, selection = _selected(index, systems, scenarios, seeds)
    found = measured(entries, decisions, _first_seeds(entries), jobs)
    for k, entry in enumerate(entries):
        found[k] = found[k] or _nothing(entry, decisions)
    test = [one for one in found if one.row["split"] != "tuning"]
    tuning = [one for one in found if one.row["split"] == "tuning"]
    profiles, traces, frames, consistency = gather(test, decisions)
    return Evaluation(
        name=Path(folder).resolve().name,
        folder=str(folder),
        decisions=decisions,
        departures=departures,
        recorded=index.protocol,
        selection=selection,
        rows=tuple(one.row for one in test),
        tuning=tuple(one.row for one in tuning),
        consistency=consistency,
        notes=_notes(index),
        profiles=profiles,
        traces=traces,
        frames=frames,
    )


def recorded_decisions(recorded: dict) -> dict:
    """Return the fields of a `Protocol` as a protocol.json has them."""
    return {name: _frozen(recorded["protocol"][name]) for name in asdict(Protocol())}


def _frozen(value):
    return tuple(map(_frozen, value)) if isinstance(value, list | tuple) else value


def _decisions(recorded, wanted):
    """Return the decisions to apply, and where they depart from the recorded ones."""
    if wanted is None:
        wanted = {}
    given = asdict(wanted) if isinstance(wanted, Protocol) else dict(wanted)
    unknown = [name for name in given if name not in recorded]
    if unknown:
        raise AmrError(f"protocol has no {unknown[0]!r}; its fields are {', '.join(recorded)}.")
    given = {name: _frozen(value) for name, value in given.items()}
    departures = {
        name: (recorded[name], value) for name, value in given.items() if value != recorded[name]
    }
    for name, (was, value) in departures.items():
        if name not in FREE:
            raise AmrError(
                f"protocol.{name} is {value!r}, but the logs were made under {was!r}, which cannot "
                "be changed afterwards. Give only what differs, such as "
                "protocol={'align': 'none'}, or run the benchmark again in another folder."
            )
    decisions = recorded | given
    _check_decisions(decisions)
    return decisions, departures


def _check_decisions(decisions):
    allowed = {
        "align": MODES,
        "failures": ("worst", "separate"),
        "statistic": STATISTICS,
        "better": ("lower", "higher"),
    }
    for name, values in allowed.items():
        if decisions[name] not in values:
            raise AmrError(
                f"protocol.{name} is {decisions[name]!r}; expected one of {', '.join(values)}."
            )
    if decisions["metric"] not in columns(decisions):
        raise AmrError(
            f"protocol.metric is {decisions['metric']!r}; the table has "
            f"{', '.join(columns(decisions))}."
        )
    if not 0 < decisions["confidence"] < 1:
        raise AmrError(f"protocol.confidence is {decisions['confidence']!r}; expected in (0, 1).")


def _selected(index, systems, scenarios, seeds):
    """Return the entries that were asked for, and what of the whole they are."""
    entries, selection = list(index.entries), {}
    for what, wanted in (("system", systems), ("scenario", scenarios), ("seed", seeds)):
        known = list(dict.fromkeys(getattr(entry, what) for entry in index.entries))
        if wanted is None:
            continue
        if isinstance(wanted, str | int):
            wanted = [wanted]
        wanted = list(wanted)
        strange = [x for x in wanted if x not in known]
        if strange:
            raise AmrError(f"there is no {what} {strange[0]!r}; there are {_few(known)}.")
        entries = [entry for entry in entries if getattr(entry, what) in wanted]
        if set(wanted) != set(known):
            selection[f"{what}s"] = ([x for x in known if x in wanted], known)
    if not entries:
        raise AmrError("nothing is selected: no trial has this system, scenario and seed.")
    return entries, {what: (done, len(known)) for what, (done, known) in selection.items()}


def _first_seeds(entries):
    """Return the first seed of each scenario: the one that is drawn, whatever it shows."""
    first = {}
    for entry in entries:
        if entry.split != "tuning":
            first[entry.scenario] = min(entry.seed, first.get(entry.scenario, entry.seed))
    return first


def _nothing(entry, decisions):
    from amrmetrics.benchmark.measuring import Measured

    return Measured(empty_row(entry, decisions, entry.split))


def _notes(index):
    if not index.strangers:
        return ()
    few = _few(index.strangers)
    return (f"{len(index.strangers)} folders of trials are not in the protocol: {few}",)


def _few(values):
    shown = [str(x) for x in values[:8]]
    return ", ".join(shown) + (", ..." if len(values) > len(shown) else "")


def _as_text(skipped):
    return "; ".join(f"{what}: {why}" for what, why in skipped.items())


# --- To JSON and back ---------------------------------------------------------------------------


def _columnar(rows, digits):
    """Return a table by columns; each text once, and its number in every row."""
    if not rows:
        return {}
    table = {}
    for name in rows[0]:
        values = [row[name] for row in rows]
        if name in TEXTS:
            words = [json.dumps(x) if name == "skipped" else x for x in values]
            known = list(dict.fromkeys(words))
            number = {word: k for k, word in enumerate(known)}
            table[name] = {"texts": known, "rows": [number[word] for word in words]}
        else:
            table[name] = _rounded(values, digits)
    return table


def _thinned(value):
    """Return the arrays with every second point and the last one."""
    if isinstance(value, dict):
        return {key: _thinned(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return value[np.unique(np.r_[0 : len(value) : 2, len(value) - 1])]
    return value


def _rows_of(table):
    columns_ = {}
    for name, values in table.items():
        if name in TEXTS:
            texts = values["texts"]
            if name == "skipped":
                texts = [json.loads(text) for text in texts]
            values = [texts[k] for k in values["rows"]]
        columns_[name] = values
    names = list(columns_)
    return tuple(dict(zip(names, row, strict=True)) for row in zip(*columns_.values(), strict=True))


def _rounded(value, digits):
    if isinstance(value, dict):
        return {key: _rounded(item, digits) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return _rounded(value.tolist(), digits)
    if isinstance(value, list | tuple):
        return [_rounded(item, digits) for item in value]
    if isinstance(value, float) and np.isfinite(value):
        short = float(f"{value:.{digits}g}")
        return int(short) if short == int(short) and abs(short) < 1e15 else short
    return value


def _plain(value):
    """Return lists in place of tuples and arrays, text in place of numbers as keys."""
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return value


def _without_nan(value):
    """Return plain data with None in place of nan, which JSON does not have."""
    if isinstance(value, dict):
        return {key: _without_nan(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_without_nan(item) for item in value]
    if isinstance(value, float) and not np.isfinite(value):
        return None
    return value


def _arrays(value):
    """Return arrays of doubles in place of lists, nan in place of None."""
    if isinstance(value, dict):
        return {key: _arrays(item) for key, item in value.items()}
    return np.array(value, float) if isinstance(value, list) else value
