"""A ranking as Markdown, LaTeX and JSON."""

from __future__ import annotations

import json
import statistics
from typing import Any

from results.reader import Run
from results.table import (
    Table, escape_latex, escape_markdown, four_digits, text_fields, to_markdown, to_tabular,
)  # fmt: skip

from gate.measured import MEMORY
from gate.ranking import ERROR, WINDOWS, OnMesh, Ranking, Ratio, Standing

NOTHING = "-"


def _number(value: float | None) -> str:
    if value is None:
        return NOTHING
    return f"{value:.3f}" if value < 10 else f"{value:.1f}"


def _error(value: float | None) -> str:
    return NOTHING if value is None else f"{value:.1e}"


def _median(time: Ratio) -> str:
    """Returns the median, with `~` before it if the pairs do not resolve a difference."""
    return ("" if time.resolved else "~ ") + _number(time.estimate.value)


def _interval(time: Ratio) -> str:
    """Returns the 95% interval, or NOTHING if there are too few pairs for one."""
    if not time.has_interval:
        return NOTHING
    return f"{_number(time.estimate.low)} to {_number(time.estimate.high)}"


def _with_interval(time: Ratio) -> str:
    return _median(time) + (f" ({_interval(time)})" if time.has_interval else "")


def _meshes(count: int) -> str:
    return "1 mesh" if count == 1 else f"{count} meshes"


def verdict(ranking: Ranking) -> str:
    """Returns sentences about the times of the other solvers and about wrong distances."""
    name, own = ranking.candidate, ranking.of_candidate
    text = ""
    if ranking.wrong:
        text = f"WRONG ANSWERS of {', '.join(ranking.wrong)}, see the remarks. "
    times = [
        f"{one.solver} {_with_interval(one.time)}"
        + (f" on {_meshes(len(one.meshes))}" if len(one.meshes) < one.all else "")
        for one in ranking.standings if one.time is not None
    ]  # fmt: skip
    if times:
        text += f"Times relative to {name} on {_meshes(own.all)}: {', '.join(times)}. "
    else:
        text += f"{name} could not be timed against any of the others. "
    text += f"The distances of {name} are correct on {own.right} of {_meshes(own.all)}"
    if own.max_relative_error is not None:
        text += f", to {_error(own.max_relative_error)} of their length"
    return text + "."


def _explanation(ranking: Ranking) -> str:
    name = ranking.candidate
    ranks = " A rank begins where the pairs resolve every solver above as faster than every one below."
    return (
        f"Ratios are the solver's numbers over those of {name}: above 1 the solver takes more."
        " Times are CPU times of a solve in interleaved pairs; ~ marks a difference from"
        f" {name} that they do not resolve."
        + (ranks if any(one.rank is not None for one in ranking.standings) else "")
    )


def _overall(ranking: Ranking) -> Table:
    rows = []
    for one in ranking.standings:
        own = "1" if one.solver == ranking.candidate and one.right else NOTHING
        rows.append([
            one.solver,
            NOTHING if one.rank is None else str(one.rank),
            _median(one.time) if one.time else own,
            _interval(one.time) if one.time else NOTHING,
            _number(one.windows) if one.windows is not None else own,
            _number(one.memory) if one.memory is not None else own,
            _error(one.max_relative_error),
            f"{one.right} of {one.all}",
        ])  # fmt: skip
    header = ["solver", "rank", "time", "95% interval", "windows", "memory", "largest error",
              "meshes with correct distances"]  # fmt: skip
    return Table("", "", header, 1, [text_fields(row) for row in rows])


def _of_mesh(ranking: Ranking, run: Run, mesh: str) -> Table:
    count = len(run.sources[mesh])
    sources = "1 source" if count == 1 else f"{count} sources"
    title = f"{mesh}, {run.meshes[mesh].vertices} vertices, {sources}"
    header = ["solver", "ms", "time", "95% interval", "range", "windows", "peak MB",
              "largest error"]  # fmt: skip
    rows = [text_fields(_mesh_row(ranking, one, mesh)) for one in ranking.standings]
    return Table("", title, header, 1, rows)


def _mesh_row(ranking: Ranking, standing: Standing, mesh: str) -> list[str]:
    measurements = ranking.measurements
    failed = measurements.failure(standing.solver, mesh)
    if failed is not None:
        return [standing.solver, failed.outcome, *[NOTHING] * 6]

    def typical(key: str, unit: float, digits: int) -> str:
        values = measurements.numbers(standing.solver, mesh, key)
        return f"{statistics.median(values) / unit:.{digits}f}" if values else NOTHING

    times = [time for cell in measurements.of(standing.solver, mesh) for time in cell.times]
    on = standing.on(mesh)
    milliseconds = on.milliseconds if on else statistics.median(times)
    return [
        standing.solver, four_digits(milliseconds), *_ratios(on),
        typical(WINDOWS, 1, 0), typical(MEMORY, 1e6, 2),
        _error(max(measurements.numbers(standing.solver, mesh, ERROR), default=None)),
    ]  # fmt: skip


def _ratios(on_mesh: OnMesh | None) -> list[str]:
    if on_mesh is None:
        return [NOTHING] * 3
    spread = f"{_number(min(on_mesh.ratios))} to {_number(max(on_mesh.ratios))}"
    return [_median(on_mesh.time), _interval(on_mesh.time), spread if len(on_mesh.ratios) > 1 else NOTHING]


def summary(ranking: Ranking) -> str:
    """Returns the verdict, the ranking and the remarks as Markdown."""
    others = [one.solver for one in ranking.standings if one.solver != ranking.candidate]
    remarks = "".join(f"- {escape_markdown(remark)}\n" for remark in ranking.remarks)
    return "\n".join([
        f"# {ranking.candidate} against {', '.join(others)}\n",
        f"{escape_markdown(verdict(ranking))}\n",
        to_markdown(_overall(ranking)),
        f"{_explanation(ranking)}\n",
        *([remarks] if remarks else []),
    ])  # fmt: skip


def as_markdown(ranking: Ranking, run: Run) -> str:
    """Returns the summary, and a table for each mesh."""
    meshes = ranking.measurements.meshes
    return "\n".join([summary(ranking), *(to_markdown(_of_mesh(ranking, run, m)) for m in meshes)])


def as_latex(ranking: Ranking, run: Run) -> str:
    name = ranking.candidate
    others = [one for one in ranking.standings if one.solver != name]
    rows = []
    for mesh in ranking.measurements.meshes:
        found = [one.on(mesh) for one in others]
        times = [_with_interval(on.time) if on else NOTHING for on in found]
        rows.append(text_fields([mesh, str(run.meshes[mesh].vertices), *times]))
    by_mesh = Table("", "", ["mesh", "vertices", *(one.solver for one in others)], 1, rows)
    figure = (
        f"Time of each solver over that of {name}: medians of pairs on every mesh with their 95%"
        " intervals, thin lines from the least to the most of the pairs, and geometric means over"
        f" the meshes. Right of 1 the solver is slower than {name}; hollow marks are not resolved."
    )
    return (
        "% \\input this file; needs \\usepackage{adjustbox,booktabs,graphicx}\n"
        + _latex_table(_overall(ranking), f"{verdict(ranking)} {_explanation(ranking)}")
        + "\n"
        + _latex_table(by_mesh, f"Time of the solver in the column over that of {name} on every"
                                " mesh: median of pairs, with its 95% interval.")
        + "\n\\IfFileExists{rank.pdf}{%\n\\begin{figure}\n\\centering\n"
        + f"\\includegraphics[width=\\linewidth]{{rank.pdf}}\n\\caption{{{escape_latex(figure)}}}\n"
        + "\\end{figure}}{}\n"
    )  # fmt: skip


def _latex_table(table: Table, caption: str) -> str:
    return (
        f"\\begin{{table}}\n\\centering\\small\n\\caption{{{escape_latex(caption)}}}\n"
        f"{to_tabular(table)}\n\\end{{table}}\n"
    )


def as_json(ranking: Ranking) -> str:
    data = {
        "schema_version": 1,
        "candidate": ranking.candidate,
        "verdict": verdict(ranking),
        "standings": [_standing(one) for one in ranking.standings],
        "remarks": ranking.remarks,
    }
    return json.dumps(data, indent=1) + "\n"


def _standing(standing: Standing) -> dict[str, Any]:
    def mesh(on_mesh: OnMesh) -> dict[str, Any]:
        return {"mesh": on_mesh.mesh, "time": _time(on_mesh.time), "least": min(on_mesh.ratios),
                "most": max(on_mesh.ratios), "windows": on_mesh.windows, "memory": on_mesh.memory}  # fmt: skip

    return vars(standing) | {"time": _time(standing.time), "meshes": [mesh(on) for on in standing.meshes]}


def _time(time: Ratio | None) -> dict[str, Any] | None:
    if time is None:
        return None
    ends = (time.estimate.low, time.estimate.high) if time.has_interval else (None, None)
    return {"value": time.estimate.value, "low": ends[0], "high": ends[1], "pairs": time.pairs,
            "resolved": time.resolved}  # fmt: skip
