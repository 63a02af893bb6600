"""The reader of result files. It validates a file and returns typed rows.

Reads run.json or one file of cells/, as described by results/README.md. Runs may be interleaved, and
the rows of a large run may be in a separate file beside run.json. Every fault of a file is
a ResultError of one line with the file and the key.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any, NoReturn, TypeVar

import numpy as np

from .columns import OK as OK
from .columns import SOURCE, Array, Columns
from .console import ROOT, printable
from .names import unknown_name
from .schema import SCHEMA as SCHEMA
from .schema import ResultError as ResultError
from .schema import key_of, validate
from .text import NotText, read_text

RUNS = ROOT / "results" / "runs"

ERRORS = (
    "max_relative_error", "mean_relative_error", "rms_relative_error", "p99_relative_error",
    "unreachable_mismatches",
)  # fmt: skip
CLOSED_FORM = "closed-form"
"""The reference of rows whose distances were compared with a formula, not with a solver."""


@dataclass(frozen=True)
class Mesh:
    name: str
    sha256: str
    vertices: int
    faces: int
    mean_edge_length: float
    thesis_model: str | None
    stand_in: bool
    why: str = ""
    """Why the mesh is in the corpus."""
    reports: tuple[str, ...] = ()
    """Addresses of reports about such a mesh by users of other codes."""

    @property
    def label(self) -> str:
        """The name and the replaced mesh, if any: "dragon-res2 (stand-in for lucy)"."""
        return f"{self.name} (stand-in for {self.thesis_model})" if self.stand_in else self.name


@dataclass(frozen=True)
class Solver:
    name: str
    family: str
    paper: str
    exact: bool
    independent_oracle: bool
    remarks: str
    exactness: str = "exact"
    """One of "exact", "bounded", "upper_bound" and "unbounded"."""
    error_bound: float | None = None
    """Bound of the relative error of a bounded solver."""
    values: dict[str, float | str] = field(default_factory=dict)
    """Values of all parameters, by name."""

    @property
    def base(self) -> str:
        """The name without parameters."""
        return self.name.split("?")[0]

    @property
    def promise(self) -> str:
        """The guarantee for its distances: "exact", "within 0.01", "upper bound" or "unbounded"."""
        if self.exactness == "bounded":
            return f"within {self.error_bound:g}"
        return self.exactness.replace("_", " ")


Source = int | str
"""A vertex, or the name of a set of vertices from which one query starts."""


@dataclass(frozen=True)
class Cell:
    """A solver on a mesh from a source."""

    solver: str
    mesh: str
    source: Source

    def __lt__(self, other: Cell) -> bool:
        """Orders by solver, mesh and source; sets come after vertices."""
        return self._place < other._place

    @property
    def _place(self) -> tuple[str, str, bool, Source]:
        return self.solver, self.mesh, isinstance(self.source, str), self.source

    def __str__(self) -> str:
        return f"{self.solver}/{self.mesh}/src:{self.source}"


@dataclass(frozen=True)
class Row:
    """One repetition of a cell, or the only row of a failed cell."""

    solver: str
    mesh: str
    source: Source
    repetition: int
    outcome: str
    message: str
    reference: str | None
    recordings: str | None
    """Folder of the solver's recordings, relative to the run folder."""
    program: str | None
    """Label of the timed program in an interleaved run with several programs, else None."""
    processor: str
    """The processor of the measurement. Times of different processors are not compared."""
    columns: Columns = field(repr=False, compare=False)
    place: int
    """Index of the row in the columns."""

    def number(self, key: str) -> float | None:
        """Returns a number by its key in the file, None if missing; "phase_seconds.queue" is a key inside
        an object. A row that is not ok has only ERRORS. Times are in milliseconds."""
        return self.columns.number(key, self.place) if self.ok or key in ERRORS else None

    @property
    def numbers(self) -> dict[str, float]:
        """All numbers of the row, by key."""
        keys = (key for key in self.columns.arrays if key not in self.columns.texts)
        return {key: value for key in keys if (value := self.number(key)) is not None}

    @property
    def data(self) -> dict[str, Any]:
        """The row as in the file, with its processor."""
        return self.columns.data(self.place)

    @property
    def ok(self) -> bool:
        return self.outcome == OK

    @property
    def time(self) -> float:
        """Time of one solve in milliseconds, for tables and verdicts: the CPU time, or the wall time if
        several threads share the work. @raises KeyError for a row that is not ok"""
        key = "real_time" if (self.number("threads") or 1) > 1 else "cpu_time"
        if (time := self.number(key)) is None:
            raise KeyError(key)
        return time

    @property
    def cell(self) -> Cell:
        return Cell(self.solver, self.mesh, self.source)

    @property
    def against_truth(self) -> bool:
        return self.reference == CLOSED_FORM


@dataclass(frozen=True)
class Skip:
    mesh: str
    solver: str | None
    why: str
    unreadable: bool = False
    """Whether the mesh is there and was named, but cannot be solved: an error of the run."""


@dataclass(frozen=True, eq=False)
class Run:
    file: Path
    context: dict[str, Any]
    meshes: dict[str, Mesh]
    solvers: dict[str, Solver]
    sources: dict[str, list[Source]]
    skipped: list[Skip]
    columns: Columns
    """The rows as columns, by key, for operations on all rows."""
    stored: dict[str, Any] = field(default_factory=dict)
    """The object `columns` of the file, if its rows are in a separate file; else empty."""

    def row(self, place: int) -> Row:
        columns = self.columns

        def text(key: str) -> str | None:
            return columns.text(key, place)

        return Row(
            solver=text("solver") or "", mesh=text("mesh") or "",
            source=columns.source(place),
            repetition=int(columns.number("repetition_index", place) or 0),
            outcome=text("outcome") or "", message=text("error_message") or "",
            reference=text("reference"), recordings=text("recordings"), program=text("program"),
            processor=text("processor") or "", columns=columns, place=place,
        )  # fmt: skip

    @property
    def rows(self) -> Iterator[Row]:
        return map(self.row, range(self.columns.length))

    @property
    def rows_file(self) -> Path | None:
        """The separate file with the rows; None if the rows are in `file`."""
        return self.file.parent / self.stored["file"] if self.stored else None

    @property
    def ours(self) -> dict[str, Any]:
        """The part of the context that belongs to geodesic-bench."""
        found: dict[str, Any] = self.context["geodesic_bench"]
        return found

    @property
    def environments(self) -> list[dict[str, Any]]:
        """What else times depend on (results/README.md), of each start of the run that had another one.
        Empty where the file is older."""
        found: list[dict[str, Any]] = self.ours.get("environments", [])
        return found

    @cached_property
    def processors(self) -> list[str]:
        """The processors that measured the rows, in the order of the rows."""
        return self.columns.names("processor")

    @cached_property
    def of_single_sources(self) -> Run:
        """The run without cells of source sets; unchanged if a mesh has no other sources."""
        if SOURCE not in self.columns.texts:
            return self
        single = {
            mesh: [source for source in of if isinstance(source, int)]
            for mesh, of in self.sources.items()
        }
        if not all(single.values()):
            return self
        columns = self.columns.take(self.columns.arrays[SOURCE] >= 0)
        return replace(self, columns=columns, sources=single)

    def set_size(self, mesh: str, source: Source) -> int:
        """Returns the number of vertices of a source."""
        if isinstance(source, int):
            return 1
        return int(self.ours["source_sets"][mesh][source]["vertices"])

    def source_vertices(self, mesh: str, source: Source) -> list[int]:
        """@raises ResultError when the file of a set is missing"""
        if isinstance(source, int):
            return [source]
        file = self.file.parent / self.ours["source_sets"][mesh][source]["file"]
        vertices = load(file)
        if not isinstance(vertices, list) or not all(type(v) is int for v in vertices):
            raise ResultError(f"{file}: not a list of vertices")
        return vertices

    @property
    def shard(self) -> dict[str, Any] | None:
        """Description of the shard (results/README.md); None for a run that is not a shard."""
        found: dict[str, Any] | None = self.ours.get("shard")
        return found

    @property
    def of_plugins(self) -> set[str]:
        """Names, without parameters, of the solvers of plug-ins, such as public codes."""
        plugins = self.context.get("geodesic_bench", {}).get("plugins", [])
        return {solver for plugin in plugins for solver in plugin["solvers"]}

    @cached_property
    def of_others(self) -> set[str]:
        """Names of the solvers of plug-ins and of the independent oracles."""
        plugins = self.of_plugins
        return {name for name, solver in self.solvers.items() if solver.base in plugins or solver.independent_oracle}

    @property
    def interleaved(self) -> bool:
        """Whether the rows of one mesh, source and repetition were measured in direct succession."""
        return bool(self.ours.get("interleaved", False))

    @lru_cache(maxsize=256)  # a table asks for the cells of one mesh again and again
    def cell(self, mesh: str, solver: str) -> tuple[Row, ...]:
        """Returns the rows of a solver on a mesh, for all sources, in the file's order."""
        return tuple(self.row(int(place)) for place in self._places.get((mesh, solver), ()))

    @cached_property
    def without_a_time(self) -> list[Row]:
        """The rows that are not ok."""
        return [self.row(int(place)) for place in np.flatnonzero(~self.columns.where("outcome", OK))]

    @cached_property
    def _places(self) -> dict[tuple[str, ...], Array]:
        """Indices of the rows, by mesh and solver."""
        return self.columns.by_texts("mesh", "solver")

    def cells(self, program: str | None = None) -> dict[Cell, list[Row]]:
        """Returns the rows by cell, in the file's order.

        @param program label of the program whose rows are returned; None for all programs"""
        found: dict[Cell, list[Row]] = {}
        for row in self.rows:
            if program is None or row.program == program:
                found.setdefault(row.cell, []).append(row)
        return found

    def of_meshes(self, names: Sequence[str]) -> Run:
        """Returns the run with only these meshes. @raises ResultError for an unknown mesh"""
        for name in names:
            if name not in self.meshes:
                raise ResultError(f"{self.file}: {unknown_name('mesh', name, self.meshes)}")
        return replace(
            self,
            meshes={name: mesh for name, mesh in self.meshes.items() if name in names},
            skipped=[skip for skip in self.skipped if skip.mesh in names],
            columns=self.columns.take(self.columns.where("mesh", *names)),
        )

    @property
    def not_measured(self) -> list[Skip]:
        """Meshes that were skipped with all solvers."""
        return [skip for skip in self.skipped if skip.solver is None]

    def skip(self, mesh: str, solver: str) -> Skip | None:
        """Returns the entry for this solver on this mesh; None if the run did not skip it."""
        return next(
            (s for s in self.skipped if s.mesh == mesh and s.solver in (None, solver)), None
        )


def read_run(path: Path) -> Run:
    """@param path a run folder with a run.json in it, or a result file
    @raises ResultError for the reasons of read_file()"""
    return read_file(path if path.is_file() else run_folder(path) / "run.json")


def run_folder(path: Path | None) -> Path:
    """Returns the folder of --run, or the newest one. @raises ResultError when it is missing"""
    folder = path or newest_run()
    if not folder.is_dir():
        raise ResultError(f"{folder}: no such folder; ./run_all.sh run makes one")
    return folder


def read_file(file: Path, *, of_any_revision: bool = False) -> Run:
    """Reads a result file.

    @param of_any_revision ignores keys that are not in this revision's schema. The keys that a Run
           needs are still required.
    @raises ResultError when the file is missing, broken or does not conform to the schema"""
    return run_of(file, load(file), of_any_revision=of_any_revision)


def run_of(file: Path, data: Any, *, of_any_revision: bool = False) -> Run:
    """Converts the data that `load` returned. @raises ResultError for the reasons of read_file()"""
    try:
        columns = _columns(file, data, check=not of_any_revision)
        run = _typed(file, data, columns)
    except ResultError:
        raise
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError) as error:
        if not of_any_revision:
            validate(file, data)  # names the row
        raise ResultError(f"{file}: not a result file of geodesic-bench: {error}") from None
    _check_names(run)
    return run


def _columns(file: Path, data: dict[str, Any], *, check: bool) -> Columns:
    """@raises ResultError, and the exceptions of `Columns.of`"""
    if "columns" not in data:
        columns = Columns.of(data["benchmarks"])
        if check and not columns.is_valid(data):
            validate(file, data)  # names the row, unless the columns only lack keys that the schema allows
        for key in ("solver", "mesh", "source", "outcome"):
            if not columns.has(key).all():
                raise KeyError(key)
        return columns
    validate(file, data)
    stored = data["columns"]
    columns = Columns.load(file.parent / stored["file"], stored["rows"], stored["texts"])
    if not columns.is_valid(data):
        raise ResultError(f"{file.parent / stored['file']}: has rows that are not to the schema")
    return columns


def load(file: Path) -> Any:
    """Reads JSON with finite numbers, and escapes control characters. @raises ResultError"""
    try:
        text = read_text(file)
        data = json.loads(text)
        if _ESCAPED.search(text) or not text.replace("\n", "").isprintable():
            data = _harmless(data)
        if _NON_FINITE.search(text):
            _refuse_non_finite(file, data)
    except ResultError:
        raise
    except NotText as error:
        raise ResultError(str(error)) from None
    except RecursionError:
        raise ResultError(f"{file}: nested too deep for a result file") from None
    except FileNotFoundError:
        raise ResultError(f"{file}: no such file; was the run interrupted?") from None
    except OSError as error:
        raise ResultError(f"{file}: cannot be read: {error.strerror}") from None
    except ValueError as error:  # invalid UTF-8 or JSON
        raise ResultError(f"{file}: not JSON, perhaps truncated: {error}") from None
    return data


_ESCAPED = re.compile(r"\\[^\"\\/]")
"""Matches every escape that may stand for a character that cannot be printed."""
_NON_FINITE = re.compile(r"NaN|Infinity|[eE]\+?\d{3}|\d{300}")
"""Matches every text that may stand for a number that is not finite."""


def _harmless(data: Any) -> Any:
    """Makes every text printable, because file names and error messages are arbitrary."""
    if isinstance(data, str):
        return printable(data)
    if isinstance(data, dict):
        return {printable(key): _harmless(value) for key, value in data.items()}
    return [_harmless(value) for value in data] if isinstance(data, list) else data


def newest_run() -> Path:
    """Returns the last run folder of results/runs. Their names begin with the start time."""
    folders = sorted(file.parent for file in RUNS.glob("*/run.json"))
    if not folders:
        raise ResultError(f"{RUNS}: no run there yet; ./run_all.sh run makes one")
    return folders[-1]


def _refuse_non_finite(file: Path, data: Any) -> None:
    for path, value in _leaves(data, []):
        if isinstance(value, float) and not math.isfinite(value):
            raise ResultError(f"{file}: {key_of(path)}: {value} is not a finite number")


def _leaves(value: Any, path: list[str | int]) -> Iterator[tuple[list[str | int], Any]]:
    if isinstance(value, dict):
        for key, item in value.items():
            yield from _leaves(item, [*path, key])
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from _leaves(item, [*path, index])
    else:
        yield path, value


Kind = TypeVar("Kind", Mesh, Solver, Skip)


def _typed(file: Path, data: Any, columns: Columns) -> Run:
    ours = data["context"]["geodesic_bench"]
    meshes = [
        _of(Mesh, mesh, reports=tuple(mesh.get("reports", ()))) for mesh in ours["meshes"]
    ]
    solvers = [_of(Solver, each, exact=each["exactness"] == "exact") for each in ours["solvers"]]
    return Run(
        file=file,
        context=data["context"],
        meshes={mesh.name: mesh for mesh in meshes},
        solvers={solver.name: solver for solver in solvers},
        sources={mesh: list(sources) for mesh, sources in ours["sources"].items()},
        skipped=[_of(Skip, skip) for skip in ours["skipped"]],
        columns=columns.filled("processor", ours["processor"]),
        stored=data.get("columns", {}),
    )


def _of(kind: type[Kind], found: dict[str, Any], **others: Any) -> Kind:
    """Builds an object from the JSON keys that are its fields, and from `others`, which take precedence."""
    copied = {one.name: found[one.name] for one in fields(kind) if one.name in found}
    return kind(**copied | others)


def _check_names(run: Run) -> None:
    """Checks that the meshes, solvers and sources of the rows are in the context, and that one
    processor measured all rows of a mesh and source."""
    columns = run.columns
    if not columns.length:
        return

    def refuse(key: str, place: int, why: str) -> NoReturn:
        raise ResultError(f"{run.file}: benchmarks[{place}].{key}: {why}")

    for key, plural, known in (("mesh", "meshes", set(run.meshes)), ("solver", "solvers", set(run.solvers))):
        for name in columns.names(key):
            if name not in known:
                place = int(np.argmax(columns.where(key, name)))
                refuse(key, place, f"{name!r} is not among the context's {plural}")
    numbers = np.stack([columns.arrays[key] for key in ("mesh", "source", "processor")])
    _, first = np.unique(numbers, axis=1, return_index=True)
    seen: set[tuple[str | None, Source]] = set()
    for place in sorted(first.tolist()):
        mesh, source = columns.text("mesh", place), columns.source(place)
        if source not in run.sources.get(str(mesh), []):
            refuse("source", place, f"{source} is not among the context's sources of {mesh}")
        if (mesh, source) in seen:
            refuse("processor", place, f"{mesh}, source {source}, was measured on two processors, "
                   "whose times cannot be compared")  # fmt: skip
        seen.add((mesh, source))
