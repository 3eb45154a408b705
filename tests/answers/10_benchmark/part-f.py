# %% right: sorted lists
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% right: a counter, and raise
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    from collections import Counter
    from itertools import product

    planned = Counter(product(protocol["systems"], protocol["scenarios"], protocol["seeds"]))
    there = Counter((x["system"], x["scenario"], x["seed"]) for x in rows)
    if planned != there:
        raise AssertionError("trials")
    for x in rows:
        good = x["status"] == "ok" and 0 <= x["ate"] < np.inf and x["reason"] == ""
        lost = x["status"] == "failed" and x["ate"] != x["ate"] and len(x["reason"].split()) > 0
        if not (good or lost):
            raise AssertionError("row")
        if (x["align"], x["digest"]) != (protocol["align"], protocol["digest"]):
            raise AssertionError("protocol")

# %% right: sets and lengths; prints and warns
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    keys = [(x["system"], x["scenario"], x["seed"]) for x in rows]
    P = protocol
    assert len(keys) == len(set(keys)) == len(P["systems"]) * len(P["scenarios"]) * len(P["seeds"])
    for system, scenario, seed in keys:
        assert system in P["systems"] and scenario in P["scenarios"] and seed in P["seeds"]
    print(np.log(np.float64(0)))
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% right: one assert of all
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    def key(x):
        return x["system"], x["scenario"], x["seed"]

    def fine(x):
        if x["status"] == "failed":
            return np.isnan(x["ate"]) and not x["reason"].isspace() and x["reason"] != ""
        return x["status"] == "ok" and x["reason"] == "" and np.isfinite(x["ate"]) and x["ate"] >= 0

    n = len(protocol["systems"]) * len(protocol["scenarios"]) * len(protocol["seeds"])
    assert len(rows) == n and len(set(map(key, rows))) == n
    assert {x["system"] for x in rows} == set(protocol["systems"])
    assert {x["scenario"] for x in rows} == set(protocol["scenarios"])
    assert {x["seed"] for x in rows} == set(protocol["seeds"])
    assert {x["align"] for x in rows} == {protocol["align"]}
    assert {x["digest"] for x in rows} == {protocol["digest"]}
    assert all(map(fine, rows))

# %% wrong: no answer
# says: there is no answer yet: your audit accepts every table.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    ...

# %% wrong: returns True and False
# says: use assert instead
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    return len(rows) == len(protocol['systems']) * len(protocol['scenarios']) * len(protocol['seeds'])

# %% wrong: the number of rows alone
# says: your audit accepts a table in which a seed stands twice, and another one not at all.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    assert len(rows) == len(protocol["systems"]) * len(protocol["scenarios"]) * len(protocol["seeds"])
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: sets of trials, so that repeats pass
# says: your audit accepts a table in which a trial stands twice.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = set(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = set((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: planned trials are there, others too
# says: your audit accepts a table in which a tuning scenario is among the rows.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    found = [(x["system"], x["scenario"], x["seed"]) for x in rows]
    for a in protocol["systems"]:
        for b in protocol["scenarios"]:
            for c in protocol["seeds"]:
                assert found.count((a, b, c)) == 1
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: each row is planned, but some may be missing
# says: your audit accepts a table in which a trial is missing.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    keys = [(x["system"], x["scenario"], x["seed"]) for x in rows]
    assert len(keys) == len(set(keys))
    for system, scenario, seed in keys:
        assert system in protocol["systems"]
        assert scenario in protocol["scenarios"]
        assert seed in protocol["seeds"]
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: order counts
# says: your audit rejects a table that is sound (two systems, two failed trials): other trials th
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = list((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: no look at the alignment
# says: your audit accepts a table in which all rows have another alignment.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: one alignment for all, whichever
# says: your audit accepts a table in which all rows have another alignment.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == rows[0]["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: no look at the digest
# says: your audit accepts a table in which one row has another digest.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: blanks are a reason
# says: your audit accepts a table in which a failed trial has blanks for a reason.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"] != ""

# %% wrong: failures need no reason
# says: your audit accepts a table in which a failed trial has blanks for a reason.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])

# %% wrong: a failed trial may have an ATE
# says: your audit accepts a table in which a failed trial has an ATE.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert x["reason"].strip() != ""

# %% wrong: an ATE may be infinite
# says: your audit accepts a table in which an ok trial has an infinite ATE.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: an ATE may be negative
# says: your audit accepts a table in which an ok trial has a negative ATE.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"])
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: an ATE of 0 is refused
# says: your audit rejects a table that is sound (an ATE of 0).
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] > 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: an ok trial may have a reason
# says: your audit accepts a table in which an ok trial has a reason to fail.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: any other status is a failure
# says: your audit accepts a table in which a trial is called skipped.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: at least one trial has to be ok
# says: your audit rejects a table that is sound (all trials failed).
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""
    assert any(x["status"] == "ok" for x in rows)

# %% wrong: a failed trial is refused
# says: your audit rejects a table that is sound (two systems, two failed trials).
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    assert all(x["status"] == "ok" for x in rows)
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: the best seed per scenario is enough
# says: your audit accepts a table in which a trial is missing.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    for a in protocol["systems"]:
        for b in protocol["scenarios"]:
            assert [x for x in rows if x["system"] == a and x["scenario"] == b]
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: an ATE above 10 m is refused
# says: your audit rejects a table that is sound (an ATE of 40 m).
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, c)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], x["seed"]) for x in rows)
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and 10 > x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: breaks with an error of its own
# says: your audit breaks with KeyError: ('graph', 'hall', 37) on a table in which a trial is miss
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    there = {(x["system"], x["scenario"], x["seed"]): x for x in rows}
    assert len(there) == len(rows)
    for a in protocol["systems"]:
        for b in protocol["scenarios"]:
            for c in protocol["seeds"]:
                there.pop((a, b, c))
    assert not there
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% wrong: seeds only counted
# says: your audit accepts a table in which a seed stands twice, and another one not at all.
def audit(rows: list[dict], protocol: dict) -> None:
    """Raise an AssertionError unless `rows` is what `protocol` asks for."""
    asked = sorted(
        (a, b, 0)
        for a in protocol["systems"]
        for b in protocol["scenarios"]
        for c in protocol["seeds"]
    )
    found = sorted((x["system"], x["scenario"], k % 1) for k, x in enumerate(rows))
    assert found == asked, "other trials than planned"
    for x in rows:
        assert x["align"] == protocol["align"]
        assert x["digest"] == protocol["digest"]
        assert x["status"] in ("ok", "failed")
        if x["status"] == "ok":
            assert np.isfinite(x["ate"]) and x["ate"] >= 0
            assert x["reason"] == ""
        else:
            assert np.isnan(x["ate"])
            assert x["reason"].strip() != ""

# %% right: with counters
def audit(rows, protocol) -> None:
    from collections import Counter
    import math
    want = Counter((a, b, c) for a in protocol["systems"] for b in protocol["scenarios"] for c in protocol["seeds"])
    if Counter((r["system"], r["scenario"], r["seed"]) for r in rows) != want: raise AssertionError("trials")
    for r in rows:
        assert r["align"] == protocol["align"] and r["digest"] == protocol["digest"]
        assert r["status"] in ("ok", "failed")
        if r["status"] == "ok":
            assert math.isfinite(r["ate"]) and r["ate"] >= 0 and not r["reason"]
        else:
            assert math.isnan(r["ate"]) and not r["reason"].isspace() and len(r["reason"]) > 0

# %% wrong: raises for any table with a failure rate
# says: a trial has a seed that was not planned
def audit(rows, protocol) -> None:
    assert len(rows) == len(protocol["systems"]) * len(protocol["scenarios"]) * len(protocol["seeds"])
    assert len({(r["system"], r["scenario"], r["seed"]) for r in rows}) == len(rows)
    for r in rows:
        assert r["scenario"] not in protocol["tuning"]
        assert (r["status"] == "ok") == (r["ate"] >= 0)
        assert (r["reason"] == "") == (r["status"] == "ok")
