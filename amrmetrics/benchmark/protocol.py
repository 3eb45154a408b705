"""What is decided before the first trial, and what is needed to repeat the last: protocol.json."""

from __future__ import annotations

import hashlib
import inspect
import json
import platform
import re
import sys
from dataclasses import asdict

import numpy as np

from amrmetrics._arguments import as_probability, as_size
from amrmetrics._version import VERSION
from amrmetrics.benchmark.data import Protocol, Scenario, System
from amrmetrics.errors import AmrError

FORMAT = 1
NAME = re.compile(r"[A-Za-z0-9_-]{1,60}")
RANDOMNESS = "numpy.random.default_rng(SeedSequence([seed, crc32(scenario name)]))"
SHOWN = 3  # differences that a refusal lists


def written(systems, scenarios, seeds, protocol):
    """Return the content of protocol.json, without its digest."""
    return {
        "format": FORMAT,
        "origin": "run",
        "protocol": as_plain(asdict(protocol), "protocol"),
        "scenarios": [_scenario(scenario) for scenario in scenarios],
        "systems": [_system(system) for system in systems],
        "seeds": list(seeds),
        "rules": rules(protocol),
        "randomness": RANDOMNESS,
        "threads": 1,
        "versions": versions(),
    }


FAILURES = {
    "worst": "counts as the worst value that any system has on its scenario; tables count them",
    "separate": "has no number; tables count them",
}


def rules(protocol):
    """Return in words what the fields of a protocol mean."""
    percent = f"{100 * protocol.confidence:g} %"
    accuracy = protocol.maximum_ate
    inaccurate = "" if accuracy is None else f", or has an ATE above {accuracy:g} m"
    return {
        "alignment": f"ATE of the estimate after alignment to the truth, mode {protocol.align!r}",
        "synchronization": f"stamps up to {protocol.max_difference:g} s apart are matched",
        "failure": (
            "a trial that raises, dies, hangs, takes too much memory, returns no valid estimate, "
            f"covers less than {100 * protocol.minimum_coverage:g} % of the truth{inaccurate} has "
            f"failed; it {FAILURES.get(protocol.failures, protocol.failures)}"
        ),
        "aggregation": (
            f"{protocol.statistic} over trials, {percent} intervals; pairs of systems by "
            f"{protocol.metric} ({protocol.better} is better) on the same scenario and seed. "
            "Primary: all scenarios together, one mean per scenario, all pairs of systems after "
            "Holm. Secondary: each scenario by itself over its seeds, after Holm among themselves"
        ),
        "splits": "results are of the scenarios of the split test; tuning ones stand apart",
    }


def recorded(content):
    """Return the Protocol that stands in the content of a protocol.json."""
    fields = dict(content["protocol"])
    fields["deltas"] = tuple((delta, unit) for delta, unit in fields["deltas"])
    return Protocol(**fields)


def versions():
    """Return what the numbers may depend on, as far as software goes."""
    import scipy

    return {
        "amrmetrics": VERSION,
        "python": platform.python_version(),
        "numpy": np.__version__,
        "scipy": scipy.__version__,
        "platform": f"{platform.system()} {platform.machine()}",
    }


def _scenario(scenario):
    return {
        "name": scenario.name,
        "split": scenario.split,
        "description": scenario.description,
        "settings": as_plain(scenario.settings, f"the settings of scenario {scenario.name}"),
        **_code(scenario.make),
    }


def _system(system):
    return {
        "name": system.name,
        "description": system.description,
        "settings": as_plain(system.settings, f"the settings of system {system.name}"),
        **_code(system.run),
    }


def _code(function):
    """Return the name of a callable, and the digest of the source it stands in.

    Of an imported module the whole text counts, as a function leans on its neighbors; of a
    notebook only the function's.
    """
    function = inspect.unwrap(function)
    while hasattr(function, "func"):  # functools.partial
        function = function.func
    named = function if hasattr(function, "__qualname__") else type(function)
    module = sys.modules.get(named.__module__)
    whole = getattr(module, "__file__", None) and named.__module__ != "__main__"
    try:
        text = inspect.getsource(module if whole else named)
    except (OSError, TypeError):
        text = None
    source = text and hashlib.sha256(text.encode()).hexdigest()
    return {"code": f"{named.__module__}:{named.__qualname__}", "source": source}


def as_plain(value, name):
    """Return numbers, text, lists and dictionaries as JSON gives them back."""
    try:
        text = json.dumps(value, allow_nan=False, default=_from_numpy)
    except (TypeError, ValueError) as error:
        raise AmrError(
            f"{name} cannot be written into protocol.json ({error}). Give finite numbers, text, "
            "lists and dictionaries; make larger things inside the function."
        ) from None
    return json.loads(text)


def _from_numpy(value):
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} is none of these")


# --- Arguments ----------------------------------------------------------------------------------


def as_systems(systems):
    """Return a tuple of Systems with names of their own."""
    return _named(systems, System, "systems", "run")


def as_scenarios(scenarios):
    """Return a tuple of Scenarios with names of their own."""
    scenarios = _named(scenarios, Scenario, "scenarios", "make")
    for scenario in scenarios:
        if scenario.split not in ("test", "tuning"):
            raise AmrError(
                f"scenario {scenario.name} has the split {scenario.split!r}; expected 'test' or "
                "'tuning'."
            )
    return scenarios


def _named(items, kind, name, part):
    items = (items,) if isinstance(items, kind) else tuple(items)
    if not items:
        raise AmrError(f"{name} is empty; at least one {kind.__name__} is needed.")
    for k, item in enumerate(items):
        if not isinstance(item, kind):
            raise AmrError(f"{name}[{k}] is {type(item).__name__}; expected a {kind.__name__}.")
        check_name(item.name, f"{name}[{k}].name")
        if not callable(getattr(item, part)):
            raise AmrError(f"{name}[{k}].{part} cannot be called; expected a function.")
    refuse_repeats([item.name for item in items], name)
    return items


def check_name(text, what):
    """Refuse what is no name of a folder on every system."""
    if not isinstance(text, str) or not NAME.fullmatch(text):
        raise AmrError(
            f"{what} is {text!r}; expected letters, digits, '_' and '-', at most 60: folders are "
            "named after it."
        )


def refuse_repeats(names, what):
    """Refuse names of which two would be one folder where upper and lower case are the same."""
    seen = set()
    for name in names:
        if name.lower() in seen:
            raise AmrError(f"{what} has the name {name!r} twice (upper or lower case is the same).")
        seen.add(name.lower())


def as_seeds(seeds):
    """Return different whole numbers in order; a single number n stands for 0 ... n-1."""
    seeds = range(seeds) if isinstance(seeds, int) else seeds
    found = tuple(seeds)
    for k, seed in enumerate(found):
        if isinstance(seed, bool) or not isinstance(seed, int | np.integer) or seed < 0:
            raise AmrError(f"seeds[{k}] is {seed!r}; expected a whole number of at least 0.")
    found = tuple(int(seed) for seed in found)
    if not found:
        raise AmrError("seeds is empty; at least one is needed.")
    if len(set(found)) < len(found):
        raise AmrError("seeds has a number twice; a repeated seed is no new trial.")
    return tuple(sorted(found))


CHOICES = {
    "align": ("rigid", "similarity", "yaw", "none", "origin"),
    "better": ("lower", "higher"),
    "failures": tuple(FAILURES),
    "statistic": ("mean", "median", "p95"),
}


def as_protocol(protocol):
    """Return a Protocol whose fields make sense, before anything is run under it."""
    from amrmetrics.benchmark.measuring import columns

    if not isinstance(protocol, Protocol):
        raise AmrError(f"protocol is {type(protocol).__name__}; expected a Protocol.")
    for name, allowed in CHOICES.items():
        value = getattr(protocol, name)
        if value not in allowed:
            raise AmrError(f"protocol.{name} is {value!r}; expected one of {', '.join(allowed)}.")
    for name in ("time_limit", "memory_limit", "max_difference", "maximum_ate"):
        if name != "maximum_ate" or protocol.maximum_ate is not None:
            as_size(getattr(protocol, name), f"protocol.{name}")
    as_probability(protocol.confidence, "protocol.confidence")
    if not 0 <= as_size(protocol.minimum_coverage, "protocol.minimum_coverage", sign=">= 0") <= 1:
        raise AmrError(
            f"protocol.minimum_coverage is {protocol.minimum_coverage}; expected 0 to 1."
        )
    for k, (delta, unit) in enumerate(_deltas(protocol.deltas)):
        as_size(delta, f"protocol.deltas[{k}][0]")
        if unit not in ("s", "m", "deg", "frames"):
            raise AmrError(
                f"protocol.deltas[{k}] has the unit {unit!r}; expected s, m, deg, frames."
            )
    known = columns(asdict(protocol))
    if protocol.metric not in known:
        raise AmrError(
            f"protocol.metric is {protocol.metric!r}; expected one of {', '.join(known)}."
        )
    return protocol


def _deltas(deltas):
    try:
        return [(delta, unit) for delta, unit in deltas]
    except (TypeError, ValueError):
        raise AmrError(
            f"protocol.deltas is {deltas!r}; expected pairs of a length and its unit, such as "
            "((1, 's'), (10, 'm'))."
        ) from None


# --- The same protocol? -------------------------------------------------------------------------


def refuse_other(there, now, folder):
    """Refuse to go on in a folder under another protocol, and say which field differs."""
    found = list(differences(there, now))
    if not found:
        return
    more = f" and {len(found) - SHOWN} more" if len(found) > SHOWN else ""
    what = "; ".join(found[:SHOWN])
    why = ""
    if any(line.startswith("seeds") for line in found):
        why = (
            " The number of seeds is fixed before the first trial: who adds seeds after a look at "
            "the results, and stops when they please, finds differences where there are none "
            "(optional stopping)."
        )
    raise AmrError(
        f"{folder} was begun under another protocol: {what}{more}.{why} Go on with the old one, or "
        "run all of the new one in a new folder."
    )


def differences(there, now, name=""):
    """Yield in words where two contents differ."""
    if isinstance(there, dict) and isinstance(now, dict):
        for key in dict.fromkeys((*there, *now)):
            if key != "digest":
                yield from differences(there.get(key), now.get(key), f"{name}.{key}".strip("."))
    elif there != now and _by_name(there) and _by_name(now):
        yield from differences(_by_name(there), _by_name(now), name)
    elif there != now:
        yield f"{name} is {_short(there)} there and {_short(now)} now"


def _by_name(items):
    """Return a list of things with names as a dictionary, None if it is none."""
    if (
        isinstance(items, list)
        and items
        and all(isinstance(x, dict) and "name" in x for x in items)
    ):
        return {item["name"]: item for item in items}
    return None


def _short(value):
    if value is None:
        return "missing"
    if isinstance(value, dict):
        return "present"
    text = json.dumps(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
