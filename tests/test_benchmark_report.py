"""A report is complete whatever became of the trials, works offline, and opens in a browser."""

import errno
import html
import json
import os
import re
import shutil
import subprocess
from html.parser import HTMLParser
from urllib.parse import unquote

import matplotlib.pyplot as plt
import numpy as np
import pytest
from benchmark_logs import estimate_of, write

import amrmetrics as am
from amrmetrics import plotting
from amrmetrics.benchmark.data import Estimate, Truth

HOSTILE = "ValueError: <script>alert(1)</script> | a *pipe* & [a link](http://x.y)"
SECTIONS = (
    "In short",
    "Protocol",
    "Results",
    "Who is better",
    "Trajectories",
    "Error over time",
    "Consistency: NEES",
    "Consistency: NIS",
    "Map scores",
    "Loop closures",
    "Latency",
    "Failures",
    "Raw logs",
    "How to read the numbers",
)


def good(truth, rng, scenario, seed):
    return estimate_of(truth, rng, 0.05)


def over(truth, rng, scenario, seed):
    return estimate_of(truth, rng, 0.08, claim=0.5)


def bare(truth, rng, scenario, seed):
    return ("raised", HOSTILE) if seed == 1 else estimate_of(truth, rng, 0.3, full=False)


def crash(truth, rng, scenario, seed):
    return "too slow", "stopped after 60 s"


def nothing(truth, rng, scenario, seed):
    return None


class Page(HTMLParser):
    """What a page has: pictures, links, headings, its title."""

    def __init__(self, text):
        super().__init__()
        self.images, self.links, self.open, self.found = [], [], [], {}
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "img":
            self.images.append(attributes)
        if tag == "a":
            self.links.append(attributes["href"])
        if tag in ("meta", "img", "br"):
            return
        self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.found.setdefault(self.open[-1] if self.open else "", []).append(data)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    systems = {"good": good, "over": over, "bare": bare, "crash": crash}
    return write(tmp_path_factory.mktemp("bench") / "demo", systems)


@pytest.fixture(scope="module")
def paths(folder):
    return am.benchmark.report(folder)


@pytest.fixture(scope="module")
def text(paths):
    return paths.html.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def page(text):
    return Page(text)


class TestPage:
    def test_has_every_section_and_every_element_is_closed(self, page):
        assert page.open == []
        assert set(SECTIONS) <= set(page.found["h2"])
        assert page.found["title"] == ["demo: 4 systems, 2 scenarios, 6 seeds"]

    def test_is_one_file_that_asks_no_place_for_anything(self, text, page):
        assert "default-src 'none'" in html.unescape(text)
        assert not re.search(r"""(src|href)\s*=\s*["']\s*(https?:)?//""", text)
        assert not re.search(r"url\(|@import|<script|<link", text)
        assert all(image["src"].startswith("data:image/png;base64,") for image in page.images)

    def test_every_figure_has_a_text_with_numbers(self, page):
        assert len(page.images) >= 8
        for image in page.images:
            assert len(re.findall(r"\d", image["alt"])) > 5, image["alt"]
            assert len(image["alt"]) > 100

    def test_contents_lead_to_the_sections(self, text, page):
        anchors = [link[1:] for link in page.links if link.startswith("#")]
        assert len(anchors) == len(page.found["h2"])
        for anchor in anchors:
            assert text.count(f"id='{anchor}'") == 1

    def test_links_lead_to_the_raw_logs(self, page, paths):
        links = [link for link in page.links if not link.startswith("#")]
        assert len(set(links)) == 4 * 3 * 6 + 1
        for link in links:
            assert not os.path.isabs(link)
            assert (paths.html.parent / unquote(link)).is_file()

    def test_shows_light_dark_and_on_paper(self, text):
        assert "prefers-color-scheme: dark" in text
        assert "@media print" in text

    def test_failures_are_counted_with_their_reasons(self, text, page):
        assert "16 of 48" not in text
        assert "14 of 48 trials that have run failed" in text
        assert html.escape(HOSTILE) in text
        assert text.count("stopped after 60 s") == 12
        assert "0.167 [0.0209, 0.484]" in text  # 2 of 12, Clopper and Pearson

    def test_says_why_something_is_missing(self, text):
        assert "Not shown: bare (the system hands in no map); crash (every trial failed)." in text
        assert "Not shown: bare (the system hands in no covariances)" in text

    def test_shows_numbers_with_their_conventions(self, text, folder):
        evaluation = am.benchmark.evaluate(folder)
        x = evaluation.summary()[None, "good"]
        assert f"{x.value:.3g} [{x.lower:.3g}, {x.upper:.3g}]" in text
        assert "rmse of the ATE after rigid alignment" in text
        row = am.benchmark.compare(evaluation).rows[0]
        assert f"{row['mean']:.3g} [{row['lower']:.3g}, {row['upper']:.3g}]" in text
        assert "p after Holm" in text
        assert "Primary: all test scenarios together" in text
        assert "Secondary: each scenario for itself" in text

    def test_says_what_the_verdict_on_nees_is_about(self, text):
        assert "a run is one trial, not as many as it has instants" in text
        assert "overconfident" in text

    def test_the_protocol_is_there(self, text, folder):
        recorded = json.loads((folder / "protocol.json").read_text(encoding="utf-8"))
        assert recorded["digest"] in text
        for shown in (
            "one clock; nearest stamps",
            "gain 1",
            "tuning",
            recorded["versions"]["numpy"],
        ):
            assert shown in text

    def test_tuning_scenarios_are_in_no_result(self, text):
        before, after = text.split("<h2 id='tuning-scenarios'>")
        results = before.split("<h2 id='results'>")[1]
        assert not re.search(r"\btune\b", results)
        assert "<th scope='row'>tune</th>" in after


class TestMarkdown:
    def test_says_the_same(self, paths, page):
        text = paths.markdown.read_text(encoding="utf-8")
        assert text.startswith("# demo: 4 systems, 2 scenarios, 6 seeds\n")
        for section in page.found["h2"]:
            assert f"\n## {section}\n" in text
        assert text.count("*Figure (in the HTML page): ") == len(page.images)

    def test_tables_are_tables(self, paths):
        rows = [
            line
            for line in paths.markdown.read_text(encoding="utf-8").splitlines()
            if line.startswith("|")
        ]
        bars = [len(re.findall(r"(?<!\\)\|", row)) for row in rows]
        for k, row in enumerate(rows):
            if set(row) <= set("|- "):
                assert bars[k - 1] == bars[k]
        assert all(row.endswith("|") for row in rows)

    def test_what_a_system_said_is_no_markup(self, paths):
        text = paths.markdown.read_text(encoding="utf-8")
        assert r"\<script\>" in text
        assert r"\| a \*pipe\* & \[a link\](http://x.y)" in text

    def test_links_lead_to_the_raw_logs(self, paths):
        text = paths.markdown.read_text(encoding="utf-8")
        links = set(re.findall(r"(?<!\\)\[[^\]]*\]\(([^)]*)\)", text)) - {"http://x.y"}
        assert len(links) == 4 * 3 * 6 + 1
        assert all((paths.markdown.parent / link).is_file() for link in links)


class TestChoices:
    def test_a_selection_and_other_decisions_stand_in_the_title(self, folder, tmp_path):
        names = tmp_path / "part.html", tmp_path / "part.md"
        change = {"systems": ["good", "over"], "protocol": {"align": "none"}}
        found = am.benchmark.report(folder, *names, **change)
        assert found == names
        page = Page(names[0].read_text(encoding="utf-8"))
        for title in (page.found["title"][0], page.found["h1"][0]):
            assert "SELECTION: 2 of 4 systems (good, over)" in title
            assert "DEPARTS from the recorded protocol: align is 'none'" in title
        assert "SELECTION" in names[1].read_text(encoding="utf-8").splitlines()[0]
        links = [link for link in page.links if not link.startswith("#")]
        assert all((tmp_path / unquote(link)).resolve().is_file() for link in links)

    def test_an_evaluation_has_made_its_choice(self, folder):
        evaluation = am.benchmark.evaluate(folder)
        with pytest.raises(am.AmrError, match="seeds is given, but this Evaluation"):
            am.benchmark.report(evaluation, seeds=[1])

    def test_from_a_file(self, folder, tmp_path):
        am.benchmark.evaluate(folder).save(tmp_path / "e.json")
        loaded = am.benchmark.Evaluation.load(tmp_path / "e.json")
        with pytest.raises(am.AmrError, match="say where to write"):
            am.benchmark.report(loaded)
        found = am.benchmark.report(loaded, tmp_path / "r.html", tmp_path / "r.md")
        page = Page(found.html.read_text(encoding="utf-8"))
        assert all(link.startswith("#") for link in page.links)
        assert len(page.images) >= 8
        assert "The raw logs are not here" in found.html.read_text(encoding="utf-8")


def space(rng):
    t = np.arange(100) * 0.1
    xyz = np.c_[np.cos(t), np.sin(t), 0.3 * t]
    return Truth(t, am.spatial_poses(xyz, np.tile([0, 0, 0, 1.0], (100, 1))))


def flown(truth, rng, scenario, seed):
    poses = truth.poses.copy()
    poses[:, :3, 3] += 0.02 * rng.normal(size=(len(poses), 3))
    return Estimate(poses, truth.stamps)


def tracked(truth, rng, scenario, seed):
    return Estimate(truth.poses[:, :3, 3] + 0.05 * rng.normal(size=(100, 3)), truth.stamps)


CASES = {
    "a system of which every trial failed": (
        {"systems": {"good": good, "crash": crash}, "seeds": range(2)},
        ["4 of 8 trials that have run failed", "crash (every trial failed)"],
    ),
    "every trial failed": (
        {"systems": {"a": crash, "b": crash}, "seeds": range(2)},
        ["8 of 8 trials that have run failed", "No latency: a, b (every trial failed)"],
    ),
    "no trial has run": (
        {"systems": {"a": nothing, "b": nothing}, "seeds": range(2)},
        ["INCOMPLETE: 8 of 8 trials have not run", "No NEES: a, b (no trial has run)"],
    ),
    "one system, one scenario, one seed": (
        {"systems": {"a": good}, "seeds": [7], "scenarios": ["loop"], "tuning": ()},
        ["There is one system only", "1 system, 1 scenario, 1 seed"],
    ),
    "one trial that failed": (
        {"systems": {"a": crash}, "seeds": [7], "scenarios": ["loop"], "tuning": ()},
        ["1 of 1 trials that have run failed"],
    ),
    "only tuning scenarios": (
        {"systems": {"a": good, "b": over}, "seeds": [0], "scenarios": ()},
        ["0 scenarios", "Tuning scenarios"],
    ),
    "own data in space": (
        {"systems": {"flown": flown, "tracked": tracked}, "truth": space, "seeds": range(3)},
        [
            "No map scores: flown, tracked (the truth has no landmarks)",
            "No loop closures: flown, tracked (the truth does not say which closures are true)",
            "No NEES: flown, tracked (the system hands in no covariances)",
            "only positions were given",
        ],
    ),
}


def test_a_report_that_cannot_be_written_leaves_the_old_one(folder, tmp_path, monkeypatch):
    def full(_):
        raise OSError(errno.ENOSPC, "No space left on device")

    old = tmp_path / "report.html"
    old.write_text("old")
    monkeypatch.setattr("os.fsync", full)
    evaluation = am.benchmark.evaluate(folder, systems=["good"], jobs=1)
    with pytest.raises(OSError, match="No space"):
        am.benchmark.report(evaluation, old, tmp_path / "report.md")
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [
        ("report.html", "old")
    ]


@pytest.mark.parametrize("case", CASES)
def test_a_report_is_complete_whatever_happened(tmp_path, case):
    options, expected = CASES[case]
    paths = am.benchmark.report(write(tmp_path / "b", **options))
    text = html.unescape(paths.html.read_text(encoding="utf-8"))
    page = Page(paths.html.read_text(encoding="utf-8"))
    assert page.open == []
    assert set(SECTIONS) <= set(page.found["h2"])
    for part in expected:
        assert part in text, part
    assert not re.search(r"\bnan\b|None\b", re.sub('base64,[^"]*', "", text))
    assert "## Failures" in paths.markdown.read_text(encoding="utf-8")


class TestFigures:
    def test_looks_differ_in_color_line_and_marker(self):
        names = [f"s{k}" for k in range(168)]
        look = plotting.looks(names)
        assert len({tuple(map(str, x.values())) for x in look.values()}) == 168
        first = list(look.values())[:6]
        for part in ("color", "linestyle", "marker"):
            assert len({str(x[part]) for x in first}) == 6

    def test_each_function_draws_each_system(self):
        look = plotting.looks(["a", "b", "absent"])
        x = np.linspace(1, 100, 50)
        two = {"a": x, "b": 2 * x}
        fig, axes = plt.subplots(2, 3)
        (one, two_, three), (four, five, six) = axes
        path = np.c_[x, np.sin(x)]
        plotting.plans(one, path, {"a": path, "b": path + 1}, look)
        plotting.series(two_, x, two, look, "time [s]", "ATE [m]", log=True)
        plotting.band(two_, x, x, 2 * x, 3.0)
        plotting.series(three, x, two, look, "time [s]", "ATE [m]")
        recall = np.linspace(0, 1, 50)
        plotting.closure_curves(four, recall, {"a": 1 - recall}, {"a": (0.5, 0.5)}, look)
        plotting.latency_tails(five, {"a": (x, 1 / x), "b": (2 * x, 1 / x)}, look)
        values = {("w", "a"): (1.0, 0.5, 2.0), ("w", "b"): (3.0, np.nan, np.nan)}
        plotting.intervals(six, ["w", "empty"], values, look, "ATE [m]")
        for ax, wanted in ((one, {"truth", "a", "b"}), (three, {"a", "b"}), (four, {"a"})):
            assert set(ax.get_legend_handles_labels()[1]) == wanted
        assert set(two_.get_legend_handles_labels()[1]) == {"a", "b", "95 % band", "expected"}
        assert set(six.get_legend_handles_labels()[1]) == {"a", "b"}
        assert three.get_ylim()[0] == 0
        fig.canvas.draw()
        assert [text.get_text() for text in six.get_yticklabels()] == ["w", "empty"]
        plt.close(fig)


CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("chrome")
# Says in the title of the page what the browser made of it.
PROBE = """<script>
addEventListener("load", () => {
  const images = [...document.images];
  document.title = JSON.stringify({
    title: document.title,
    images: images.length,
    broken: images.filter((x) => !x.complete || !x.naturalWidth).length,
    wide: document.documentElement.scrollWidth > innerWidth,
    fetched: performance.getEntriesByType("resource").map((x) => x.name)
      .filter((x) => !x.startsWith("data:")),
    paper: getComputedStyle(document.body).backgroundColor,
  });
});
</script>"""


# In the log of the network: requests of a page in a file. The browser makes some of its own.
OF_A_PAGE = '"initiator":"null"'


def opened(path, profile, *flags):
    """Return what Chromium makes of a page, and what it asked of the network."""
    log = profile / "net.json"
    command = [CHROMIUM, "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run"]
    command += ["--disable-background-networking", "--disable-component-update", "--disable-sync"]
    command += ["--host-resolver-rules=MAP * ~NOTFOUND"]
    command += [f"--user-data-dir={profile}", f"--log-net-log={log}", "--window-size=1200,900"]
    done = subprocess.run(
        [*command, *flags, "--dump-dom", path.as_uri()],
        capture_output=True, timeout=60, text=True, encoding="utf-8",
    )  # fmt: skip
    return done.stdout, log.read_text(encoding="utf-8", errors="replace")


@pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
class TestBrowser:
    def probed(self, text, tmp_path, *flags):
        # The page forbids all scripts; this copy has one in place of the prohibition.
        text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', PROBE, text)
        (tmp_path / "probe.html").write_text(text, encoding="utf-8")
        dom, _ = opened(tmp_path / "probe.html", tmp_path / "profile", *flags)
        return json.loads(html.unescape(re.search("<title>(.*?)</title>", dom, re.S)[1]))

    @pytest.fixture(autouse=True)
    def profile(self, tmp_path):
        (tmp_path / "profile").mkdir()

    def test_everything_loads_and_nothing_is_fetched(self, text, page, tmp_path):
        found = self.probed(text, tmp_path)
        assert found["title"] == "demo: 4 systems, 2 scenarios, 6 seeds"
        assert found["images"] == len(page.images) >= 8
        assert found["broken"] == 0
        assert found["fetched"] == []
        assert not found["wide"]  # nothing but tables scrolls sideways
        assert found["paper"] == "rgb(255, 255, 255)"

    def test_in_the_dark(self, text, tmp_path):
        found = self.probed(text, tmp_path, "--blink-settings=preferredColorScheme=0")
        assert found["paper"] == "rgb(22, 24, 27)"

    def test_the_page_itself_asks_for_nothing(self, paths, tmp_path):
        dom, log = opened(paths.html, tmp_path / "profile")
        assert "<title>demo: 4 systems, 2 scenarios, 6 seeds</title>" in dom
        assert OF_A_PAGE not in log

    def test_and_one_that_asks_would_be_seen(self, tmp_path):
        page = tmp_path / "page.html"
        page.write_text('<img src="http://example.invalid/x.png">', encoding="utf-8")
        _, log = opened(page, tmp_path / "profile")
        assert OF_A_PAGE in log

    def test_on_paper(self, paths, tmp_path):
        pdf = tmp_path / "report.pdf"
        opened(paths.html, tmp_path / "profile", f"--print-to-pdf={pdf}")
        assert pdf.read_bytes().startswith(b"%PDF")
