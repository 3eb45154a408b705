"""The command ``amrmetrics REFERENCE ESTIMATE [ESTIMATE ...]``: a table, and files on request."""

import argparse
import csv
import io
import json
import os
import re
import sys
import warnings

from amrmetrics.errors import AmrError, RecordingWarning

EXAMPLES = """examples:
  amrmetrics truth.txt slam.txt                         everything, as a table
  amrmetrics truth.txt slam.txt --html report.html      a page with figures, for a review
  amrmetrics truth.txt runs/*.txt --csv table.csv       several estimates, the best first
  amrmetrics truth.csv slam.txt --align similarity      a monocular camera
  amrmetrics truth.txt slam.txt --offset auto           two clocks
  amrmetrics 00.txt est.txt --times times.txt           KITTI
  amrmetrics truth.txt run.bag:/odom --project xy       a topic of a ROS bag, in the plane
  amrmetrics truth.txt slam.txt --delta 10 --unit m     the RPE over 10 m

exit codes: 0 done, 2 something was wrong, and the last line says what
"""

# What messages of the library advise, and how it is said here.
OPTIONS = {
    "mode='": "--align '",
    "try offset=": "try --offset ",
    "(clock_offset estimates": "(--offset auto estimates",
    "max_difference=": "--max-difference ",
    "read_kitti(path, times=...)": "--times",
}

READERS = ("auto", "tum", "euroc", "kitti")


def main(arguments=None):
    """Run the command; return its exit code."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):  # names of files may have letters that it cannot show
            stream.reconfigure(errors="backslashreplace")
    try:
        code = _run(_parser().parse_args(arguments))
        sys.stdout.flush()
        return code
    except BrokenPipeError:  # somebody looked at the first lines only
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except (AmrError, OSError) as error:
        print(f"amrmetrics: {_in_words_of_the_command(str(error))}", file=sys.stderr)
    except KeyboardInterrupt:
        print("amrmetrics: interrupted", file=sys.stderr)
    return 2


def _in_words_of_the_command(text):
    """Return a message of the library with the options that do what it advises."""
    longer = r"cut the longer one: trajectory\[:(\d+)\]"
    text = re.sub(longer, r"leave the first \1 poses in the longer file", text)
    for name, option in OPTIONS.items():
        text = text.replace(name, option)
    return text


def _parser():
    from amrmetrics import __version__

    parser = argparse.ArgumentParser(
        prog="amrmetrics",
        description="Measure trajectories against a reference: ATE, RPE, drift, coverage.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("reference", help="ground truth: a file, or BAG:TOPIC")
    add("estimate", nargs="+", help="what is measured: files, or BAG:TOPIC")
    add("--version", action="version", version=f"amrmetrics {__version__}")
    files = parser.add_argument_group("files")
    add = files.add_argument
    add("--format", choices=READERS, default="auto", help="of all files; recognized by default")
    add(
        "--columns",
        action="append",
        metavar="[FILE=]NAMES",
        help='what the columns of all files, or of one, are, such as "ns x y z qw qx qy qz"',
    )
    add("--times", help="stamps of KITTI files, their times.txt")
    add("--strict", action="store_true", help="refuse what would be repaired")
    pairs = parser.add_argument_group("which samples belong together")
    add = pairs.add_argument
    add("--max-difference", type=float, default=0.01, metavar="S", help="of two stamps (0.01 s)")
    add("--offset", default="0", metavar="S", help='added to the estimate\'s stamps, or "auto"')
    add("--interpolate", action="store_true", help="the reference at the estimate's stamps")
    add("--max-gap", type=float, metavar="S", help="longest gap of the reference to interpolate")
    add("--skip", type=int, metavar="N", help="use every N-th pose of the estimate")
    add("--from", type=float, dest="start", metavar="S", help="begin at this time of the reference")
    add("--to", type=float, dest="end", metavar="S", help="end at this time of the reference")
    how = parser.add_argument_group("how to measure")
    add = how.add_argument
    modes = ("rigid", "similarity", "yaw", "origin", "none")
    add("--align", choices=modes, default="rigid", help="of the estimate, for the ATE (rigid)")
    add("--first", type=int, metavar="N", help="align on the first N poses")
    add("--project", choices=("xy", "xz", "yz"), help="to a plane first")
    add("--body", metavar="POSE", help='"x y z qx qy qz qw": reference body in estimate body')
    add("--delta", type=float, action="append", help="stretch of the RPE; may be given often")
    add("--unit", action="append", help="of --delta: frames, m, s or deg (frames)")
    out = parser.add_argument_group("output")
    add = out.add_argument
    add("--html", metavar="FILE", help="a page with figures that works offline")
    add("--json", metavar="FILE", help="every number and convention; - for the terminal")
    add("--csv", metavar="FILE", help="the table, one line per estimate; - for the terminal")
    add("--latex", metavar="FILE", help="the table for a paper; - for the terminal")
    add("--quiet", action="store_true", help="no table, no progress")
    return parser


def _run(options):
    with warnings.catch_warnings():
        # Repairs stand in the notes of the report.
        warnings.simplefilter("ignore", RecordingWarning)
        result = _evaluate(options)
    reports = result if hasattr(result, "reports") else None
    writers = {
        "html": _write_html,
        "json": _write_json,
        "csv": _write_csv,
        "latex": _write_latex,
    }
    wanted = {kind: getattr(options, kind) for kind in writers if getattr(options, kind)}
    if list(wanted.values()).count("-") > 1:
        raise AmrError("only one of --html, --json, --csv and --latex can go to the terminal.")
    if not options.quiet and "-" not in wanted.values():
        print(result)
    for kind, path in wanted.items():
        _say(options, f"writing {path}")
        writers[kind](path, result)
    if reports is not None and reports.failures:
        for name, why in reports.failures.items():
            print(f"amrmetrics: {name}: {why}", file=sys.stderr)
        return 2
    return 0


def _evaluate(options):
    from amrmetrics.evaluation import Reports, evaluate

    reference = _read(options.reference, options)
    if options.start is not None or options.end is not None:
        reference = reference.between(options.start, options.end)
    keywords = {
        "align": options.align,
        "first": options.first,
        "deltas": _deltas(options),
        "max_difference": options.max_difference,
        "offset": _offset(options.offset),
        "interpolate": options.interpolate,
        "max_gap": options.max_gap,
        "plane": options.project,
        "body": _body(options.body),
    }
    if len(options.estimate) == 1:
        return evaluate(reference, _estimate(options.estimate[0], options), **keywords)
    names = _short_names(options.estimate)
    done, failures = {}, {}
    for k, (name, path) in enumerate(zip(names, options.estimate, strict=True), 1):
        _say(options, f"reading {k} of {len(names)}: {name}")
        try:
            done[name] = _estimate(path, options)
        except (AmrError, OSError) as error:
            failures[name] = str(error)
    if not done:
        raise AmrError(f"no estimate could be read. {next(iter(failures.values()))}")
    _say(options, f"measuring {len(done)}")
    result = evaluate(reference, done, **keywords)
    return Reports(result.reports, failures | result.failures, result.comparisons)


def _read(path, options):
    from amrmetrics import files
    from amrmetrics.bags import is_bag, read_bag

    at = path.find(":/", 2)  # C:/run.txt is a file
    if at > 0 and not os.path.exists(path):
        return read_bag(path[:at], path[at + 1 :])
    if is_bag(path):
        raise AmrError(f"{path} is a bag; say which topic, such as {path}:/odom.")
    columns = _columns(path, options)
    if options.format != "auto" and columns:
        raise AmrError("--columns says what the files are; leave out --format.")
    if options.format in ("tum", "euroc") and options.times:
        raise AmrError(f"--times are the stamps of KITTI files, and --format is {options.format}.")
    if options.format == "kitti":
        return files.read_kitti(path, options.times, options.strict)
    if options.format == "tum":
        return files.read_tum(path, options.strict)
    if options.format == "euroc":
        return files.read_euroc(path, options.strict)
    try:
        return files.read(path, options.times, options.strict, columns)
    except AmrError as error:
        advice = r'(?:amrmetrics\.read\(path, )?columns="([^"]*)"\)?'
        raise AmrError(
            re.sub(advice, lambda found: f'--columns "{path}={found[1]}"', str(error))
        ) from None


def _columns(path, options):
    """Return what --columns says of a file: what is said of it alone, or of all."""
    of_all, of_one = None, {}
    for text in options.columns or []:
        name, given, names = text.rpartition("=")
        if given:
            of_one[name] = names
        else:
            of_all = names
    for name in of_one:
        if name not in (options.reference, *options.estimate):
            raise AmrError(f"--columns is given for {name}, which is not one of the files.")
    return of_one.get(path, of_all)


def _estimate(path, options):
    trajectory = _read(path, options)
    if options.skip is None:
        return trajectory
    if options.skip < 1:
        raise AmrError(f"--skip is {options.skip}; expected a whole number of at least 1.")
    return trajectory[:: options.skip]


def _short_names(paths):
    """Return the names of files, with their folders as far as they are needed."""
    parts = [os.path.normpath(path).split(os.sep) for path in paths]
    depth = 1
    while len({tuple(p[-depth:]) for p in parts}) < len(parts) and depth < max(map(len, parts)):
        depth += 1
    names = ["/".join(p[-depth:]) for p in parts]
    return [name if names.count(name) == 1 else f"{name} {k}" for k, name in enumerate(names, 1)]


def _deltas(options):
    if options.delta is None:
        if options.unit:
            raise AmrError("--unit was given without --delta.")
        return None
    units = options.unit or ["frames"]
    units = units * len(options.delta) if len(units) == 1 else units
    if len(units) != len(options.delta):
        raise AmrError(f"{len(options.delta)} --delta and {len(units)} --unit; give as many.")
    return list(zip(options.delta, units, strict=True))


def _offset(text):
    try:
        return text if text == "auto" else float(text)
    except ValueError:
        raise AmrError(f'--offset is {text!r}; expected seconds or "auto".') from None


def _body(text):
    if text is None:
        return None
    from amrmetrics.poses import planar_poses, spatial_poses

    try:
        numbers = [float(word) for word in text.replace(",", " ").split()]
    except ValueError:
        numbers = []
    if len(numbers) == 7:
        return spatial_poses([numbers[:3]], [numbers[3:]])[0]
    if len(numbers) == 3:
        return planar_poses([numbers[:2]], [numbers[2]])[0]
    raise AmrError(f'--body is {text!r}; expected "x y z qx qy qz qw", or "x y yaw" in the plane.')


def _say(options, text):
    """Tell who waits at a terminal what is going on."""
    if sys.stderr.isatty() and not options.quiet:
        print(text, file=sys.stderr)


def _write(path, text):
    if path == "-":
        sys.stdout.write(text)
        return
    with open(path, "w", encoding="utf-8", errors="backslashreplace", newline="\n") as file:
        file.write(text)


def _write_html(path, result):
    from amrmetrics.report_page import page

    _write(path, page(result))


def _write_json(path, result):
    _write(path, json.dumps(result.as_dict(), indent=1, allow_nan=False) + "\n")


def _rows(result):
    """Return the rows of a table that has all columns of all estimates."""
    from amrmetrics.evaluation import row_of

    rows = result.table() if hasattr(result, "reports") else [row_of(result)]
    columns = list(rows[0])
    failed = getattr(result, "failures", {})
    return columns, rows + [dict.fromkeys(columns) | {"estimate": name} for name in failed]


def _write_csv(path, result):
    columns, rows = _rows(result)
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    _write(path, text.getvalue())


def _write_latex(path, result):
    columns, rows = _rows(result)
    kept = [name for name in columns if any(row[name] is not None for row in rows)]
    lines = [
        f"\\begin{{tabular}}{{l{'r' * (len(kept) - 1)}}}",
        "\\hline",
        " & ".join(_tex(name.replace("_", " ")) for name in kept) + " \\\\",
        "\\hline",
        *(" & ".join(_tex_cell(row[name]) for name in kept) + " \\\\" for row in rows),
        "\\hline",
        "\\end{tabular}",
    ]
    _write(path, "\n".join(lines) + "\n")


def _tex(text):
    special = {"\\": "\\textbackslash{}", "~": "\\textasciitilde{}", "^": "\\textasciicircum{}"}
    special |= {letter: f"\\{letter}" for letter in "&%$#_{}"}
    return "".join(special.get(letter, letter) for letter in text)


def _tex_cell(value):
    if value is None:
        return "--"
    return _tex(f"{value:.4g}" if isinstance(value, float) else str(value))
