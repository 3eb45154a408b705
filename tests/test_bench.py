"""The benchmark runs, and what it times computes the same as its peers; no test is timed."""

import bench


def test_runs_and_says_what_it_measured(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(bench, "ENOUGH", 0)
    monkeypatch.setattr(bench, "GRAPHS", (800, 1_600))
    monkeypatch.setattr(bench, "SCALE", 1000)
    monkeypatch.setattr(bench, "CLOCKED_SIZE", 200)
    assert bench.main(["100", "100"], tmp_path / "new" / "bench.png") == 0
    said = capsys.readouterr().out
    for row in (
        "\nATE of positions planar",
        "RPE spatial, 1 m",
        "associate",
        "\nread_tum  ",
        "chamfer",
        "precision_recall",
    ):
        assert said.count(row) == 1
    assert said.count("Manhattan world  ") == 2
    for where in ("alone", "busy core"):
        rows = [row for row in said.splitlines() if row.startswith(f"{where:10} ")]
        assert sum("ATE of poses spatial" in row and row.endswith("  evo") for row in rows) == 1
        assert sum(row.split()[-1] == "pandas" for row in rows) == 1
        assert said.count(f" {where}, ATE of positions spatial: ") == 1
        assert said.count(f" {where}, ATE translation of poses spatial: ") == 1
    assert "times faster than\n" in said
    assert "times faster than evo (at least 300)" in said
    assert "times the time of positions (at most 2)" in said
    for row in ("microseconds a frame", "latency, correlated", "compare_bootstrap, 1e4"):
        assert said.count(row) == 1
    assert "from 800 to 1600 edges, time per iteration grows like" in said
    assert (tmp_path / "new" / "bench.png").read_bytes().startswith(b"\x89PNG")


def test_judges_by_the_targets(capsys):
    bench.conclude({"RPE planar, 1 frame": [(100_000, 0.01, 14.0, 0.001, 200, 1)]})
    bench.conclude({"RPE planar, 1 frame": [(100_000, 0.01, 16.0, 0.001, 251, 1)]})
    bench.conclude({"associate": [(10_000, 1.0, 1.0, 1, 1, 1), (100_000, 10.0, 1510.0, 1, 1, 1)]})
    said = capsys.readouterr().out
    assert said.count("MISSED RPE planar, 1 frame") == 2
    assert "met    associate: 151 times evo (at least 150)" in said
    assert "from 10000 to 100000, time grows like N^1.00" in said
