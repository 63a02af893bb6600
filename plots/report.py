"""Draws everything of a run and shows it on one page that needs nothing else: RUN/report.html."""

from __future__ import annotations

import base64
import shlex
import sys
from collections.abc import Iterable, Sequence
from html import escape
from pathlib import Path
from string import Template

from results import console

if __name__ == "__main__":
    console.prepare()  # before imports that may fail

from plots import check, differences
from plots.catalogue import Item, LeftOut, draw, write
from plots.drawing import Drawing
from plots.html_table import to_html
from plots.models import of_thesis
from plots.style import DPI
from results import published
from results.reader import ResultError, Run, read_run, run_folder
from results.table import Table

HERE = Path(__file__).resolve().parent
CSS_DPI = 96
SECTIONS = {
    "results": "Results",
    "thesis": "Compared with the thesis",
    "figures": "Figures",
    "tables": "Tables",
    "cells": "Cells",
    "machine": "Machine and revision",
    "reproduce": "How to reproduce",
}
FEW = 4
"""As many meshes are named in the title, more are counted."""


def page(run: Run, items: Sequence[Item], left_out: Sequence[LeftOut], pictures: Path) -> str:
    """@param pictures the folder that the figures' PNG files are in"""
    folder = _folder(run)
    tables = [item for item in items if isinstance(item.drawn, Table)]
    figures = [item for item in items if isinstance(item.drawn, Drawing)]
    everything = {
        "results": "\n".join(_table(item, folder) for item in tables if item.name == "summary"),
        "thesis": _thesis(run) if of_thesis(run) else "",
        "figures": "\n".join(_figure(item, folder, pictures) for item in figures),
        "tables": "\n".join(_table(item, folder) for item in tables if item.name != "summary"),
        "cells": _cells(run),
        "machine": _machine(run),
        "reproduce": _reproduce(run, folder, left_out),
    }
    bodies = {key: body for key, body in everything.items() if body}
    navigation = "".join(f'<li><a href="#{key}">{SECTIONS[key]}</a></li>' for key in bodies)
    sections = "\n".join(
        f'<section id="{key}" class="{key}"><h2>{SECTIONS[key]}</h2>\n{body}\n</section>'
        for key, body in bodies.items()
    )
    return Template(_text("report.html")).substitute(
        title=escape(_title(run)),
        summary=escape(_summary(run)),
        navigation=navigation,
        sections=sections,
        css=_text("report.css"),
        js=_text("report.js"),
    )


def _text(name: str) -> str:
    return (HERE / name).read_text(encoding="utf-8")


def _ours(run: Run, key: str) -> str:
    return str(run.ours[key])


def _title(run: Run) -> str:
    if len(run.meshes) <= FEW:
        about = ", ".join(run.meshes)
    else:
        about = f"corpus {_ours(run, 'corpus')}, {len(run.meshes)} meshes"
    return f"Geodesic distances: {about}; {_ours(run, 'started')[:10]}"


def _folder(run: Run) -> str:
    """As an argument of a command in the checkout's root."""
    folder, root = run.file.parent.resolve(), console.ROOT
    return shlex.quote(str(folder.relative_to(root) if folder.is_relative_to(root) else folder))


def _list(lines: Iterable[str], style: str = "") -> str:
    items = "".join(f"<li{style}>{escape(line)}</li>" for line in lines)
    return f"<ul>{items}</ul>" if items else ""


def _command(name: str, folder: str) -> str:
    command = f"python3 -m plots {name} --run {folder}"
    return f'<p class="command">Drawn by <code>{escape(command)}</code></p>'


def _summary(run: Run) -> str:
    passed = check.cells([row for row in run.rows if row.ok])
    failed = len(check.failures(run))
    without_a_time = check.cells(check.allowed(run))
    stand_ins = sum(mesh.stand_in for mesh in run.meshes.values())
    return (
        f"Solvers: {len(run.solvers)}. Meshes: {len(run.meshes)}"
        + (f", stand-ins among them: {stand_ins}" if stand_ins else "")
        + f". Cells: {passed} verified, {failed} failed or missing"
        + (f", {without_a_time} without a time, as declared or expected" if without_a_time else "")
        + ". Only times of solvers whose distances were verified are shown."
    )


def _thesis(run: Run) -> str:
    source = (
        f"Published numbers: {published.citation()}, measured on {published.machine()}. "
        "All means are geometric."
    )
    lines = [*differences.paragraphs(run), source]
    return "\n".join(f"<p>{escape(line)}</p>" for line in lines)


def _figure(item: Item, folder: str, pictures: Path) -> str:
    drawing = item.drawn
    assert isinstance(drawing, Drawing)
    png = (pictures / f"{item.name}.png").read_bytes()
    width, height = (
        int.from_bytes(png[start : start + 4], "big") for start in (16, 20)
    )  # of the PNG's header
    data = base64.b64encode(png).decode("ascii")
    title, alternative = escape(drawing.title), escape(drawing.alternative)
    return f"""<figure id="{item.name}">
<button type="button" data-title="{title}" aria-label="{title}, at full size">\
<img src="data:image/png;base64,{data}" alt="{alternative}" \
width="{width * CSS_DPI // DPI}" height="{height * CSS_DPI // DPI}"></button>
<figcaption><h3>{title}</h3><p>{escape(drawing.caption)}</p>
{_command(item.name, folder)}</figcaption>
</figure>"""


def _table(item: Item, folder: str) -> str:
    table = item.drawn
    assert isinstance(table, Table)
    return (
        f'<article id="{table.name}"><h3 id="{table.name}-title">{escape(table.title)}</h3>\n'
        f"{to_html(table)}\n{_command(item.name, folder)}</article>"
    )


def _cells(run: Run) -> str:
    failed = check.failures(run)
    without_a_time = [check.line(row) for row in check.allowed(run)]
    skipped = [f"{skip.mesh}, {skip.solver or 'all solvers'}: {skip.why}" for skip in run.skipped]
    parts = [
        f"<p>{escape(check.checked_against_truth(run).capitalize())}.</p>",
        "<h3>Failed or missing</h3>",
        _list(failed, " class=failed") or "<p>None.</p>",
        "<h3>Largest relative error of each exact solver</h3>",
        _list(check.largest_errors(run)),
    ]
    for title, lines in {"Without a time": without_a_time, "Skipped meshes": skipped}.items():
        if lines:
            parts += [f"<h3>{title}</h3>", _list(lines)]
    return "\n".join(parts)


def _machine(run: Run) -> str:
    modified = {"True": ", modified", "False": "", "None": ", perhaps modified"}
    facts = {
        "Revision": _ours(run, "revision") + modified[_ours(run, "modified")],
        "Started": _ours(run, "started"),
        "Finished": _ours(run, "finished"),
        "Processor": f"{_ours(run, 'processor')}, {run.context['num_cpus']} cores seen",
        "Compiler": f"{_ours(run, 'compiler')} {_ours(run, 'compiler_flags')}",
        "Build type": _ours(run, "build_type"),
        "Google Benchmark": _benchmark_library(run.context["library_build_type"]),
        "Seed of the sources": _ours(run, "seed"),
        "Sources a mesh": str(max(map(len, run.sources.values()), default=0)),
        "Repetitions": _ours(run, "repetitions"),
    }
    listed = "".join(f"<dt>{key}</dt><dd>{escape(value)}</dd>" for key, value in facts.items())
    return f"<dl>{listed}</dl>"


def _benchmark_library(build_type: str) -> str:
    if build_type != "debug":
        return build_type
    return (
        "library_build_type: debug, as Debian's package always reports. It is about the library "
        "that calls the solvers and not about the solvers, whose build type is above."
    )


def _reproduce(run: Run, folder: str, left_out: Sequence[LeftOut]) -> str:
    """The commands, from the checkout's root; what this run could not show."""
    steps = {
        "The run itself, that is run.json and cells/": _ours(run, "command"),
        "Every table and figure, and this page": f"python3 -m plots.report --run {folder}",
        "Whether every cell is there and verified": f"python3 -m plots.check --run {folder}",
    }
    listed = "".join(
        f"<dt>{key}</dt><dd><code>{escape(command)}</code></dd>" for key, command in steps.items()
    )
    why = {one: one.why.removeprefix(f"{run.file}: ") for one in left_out}
    absent = _list(f"{one.name}: {why[one]}" for one in left_out)
    return (
        "<p>From the root of a checkout of the revision above. The command under each table and "
        "figure draws it alone.</p>\n"
        f"<dl>{listed}</dl>\n"
        + (f"<h3>Left out, since the run lacks the data</h3>{absent}" if absent else "")
    )


def main(arguments: Sequence[str] | None = None) -> int:
    options = console.run_parser(__doc__).parse_args(arguments)
    try:
        folder = run_folder(options.run)
        run = read_run(folder)
        items, left_out = draw(run)
        for one in left_out:
            print(f"left out: {one.name}: {one.why}")
        for item in items:
            write(item, folder)
        file = folder / "report.html"
        file.write_text(page(run, items, left_out, folder / "figures"), encoding="utf-8")
        print(file)
    except (ResultError, OSError) as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
