"""The one reader of result files: validates them and gives typed rows.

Reads run.json, or one file of cells/, as described by results/README.md, of ordinary and of
interleaved runs, and of large ones whose rows are columns beside run.json. Every fault of a file is
a ResultError of one line with the file and the key.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path
from typing import Any, TypeVar, overload

import numpy as np

from .columns import Columns, NotColumns
from .console import ROOT, printable
from .schema import SCHEMA as SCHEMA
from .schema import ResultError as ResultError
from .schema import key_of, validate

RUNS = ROOT / "results" / "runs"

OK = "ok"
ERRORS = (
    "max_relative_error", "mean_relative_error", "rms_relative_error", "p99_relative_error",
    "unreachable_mismatches",
)  # fmt: skip
CLOSED_FORM = "closed-form"
"""The reference of rows whose distances were compared with a formula, not with another solver."""


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
    """It is in the corpus."""
    reports: tuple[str, ...] = ()
    """Addresses of reports by users of other codes on such a mesh."""

    @property
    def label(self) -> str:
        """The name, and what it stands for: "dragon-res2 (stand-in for lucy)"."""
        return f"{self.name} (stand-in for {self.thesis_model})" if self.stand_in else self.name


@dataclass(frozen=True)
class Solver:
    name: str
    family: str
    paper: str
    data_structure: str
    time_complexity: str
    space_complexity: str
    propagation: str
    spatial_order: bool
    exact: bool
    independent_oracle: bool
    remarks: str
    exactness: str = "exact"
    """Or "bounded", "upper_bound", "unbounded"."""
    error_bound: float | None = None
    """Relative, of a bounded solver."""
    values: dict[str, float | str] = field(default_factory=dict)
    """Of all its parameters, by their names."""

    @property
    def base(self) -> str:
        """The name without parameters."""
        return self.name.split("?")[0]

    @property
    def promise(self) -> str:
        """What is known of its distances: "exact", "within 0.01", "upper bound", "unbounded"."""
        if self.exactness == "bounded":
            return f"within {self.error_bound:g}"
        return self.exactness.replace("_", " ")


@dataclass(frozen=True, order=True)
class Cell:
    """A solver on a mesh from a source vertex."""

    solver: str
    mesh: str
    source: int

    def __str__(self) -> str:
        return f"{self.solver}/{self.mesh}/src:{self.source}"


@dataclass(frozen=True)
class Row:
    """One repetition of one cell, or the one row of a cell that failed."""

    solver: str
    mesh: str
    source: int
    repetition: int
    outcome: str
    message: str
    reference: str | None
    numbers: Mapping[str, float]
    """Every number of the row by its key in the file, those of an object as
    "phase_seconds.queue"; unless the outcome is ok, those of ERRORS alone, which a wrong answer
    has. Times are in milliseconds."""
    recordings: str | None = None
    """Folder of the solver's recordings, relative to the run folder."""
    program: str | None = None
    """Of an interleaved run with several programs: the label of the one that was timed."""
    processor: str = ""
    """The one that measured it: times of different ones are not compared."""
    data: Mapping[str, Any] = field(default_factory=dict, repr=False, compare=False)
    """The row as it is in the file."""

    @property
    def ok(self) -> bool:
        return self.outcome == OK

    @property
    def time(self) -> float:
        """Of one solve in milliseconds, what tables and verdicts go by: of the CPU, and of the wall
        where several threads share the work. @raises KeyError for a row that is not ok"""
        several = self.numbers.get("threads", 1) > 1
        return self.numbers["real_time" if several else "cpu_time"]

    @property
    def cell(self) -> Cell:
        return Cell(self.solver, self.mesh, self.source)

    @property
    def against_truth(self) -> bool:
        return self.reference == CLOSED_FORM


class ColumnRows(Sequence[Row]):
    """Rows that are made of columns when they are looked at."""

    def __init__(self, columns: Columns, processor: str) -> None:
        """@param processor of rows that name none"""
        self.columns, self._processor = columns, processor

    def __len__(self) -> int:
        return self.columns.length

    @overload
    def __getitem__(self, place: int) -> Row: ...
    @overload
    def __getitem__(self, place: slice) -> list[Row]: ...
    def __getitem__(self, place: int | slice) -> Row | list[Row]:
        if isinstance(place, slice):
            return [self._row(row) for row in range(*place.indices(len(self)))]
        return self._row(range(len(self))[place])

    def __iter__(self) -> Iterator[Row]:
        return map(self._row, range(len(self)))

    def _row(self, row: int) -> Row:
        def text(key: str) -> str | None:
            return self.columns.text(key, row)

        numbers = self.columns.numbers(row)
        outcome = str(text("outcome"))
        return Row(
            solver=str(text("solver")), mesh=str(text("mesh")), source=int(numbers["source"]),
            repetition=int(numbers.get("repetition_index", 0)), outcome=outcome,
            message=text("error_message") or "", reference=text("reference"),
            numbers=numbers if outcome == OK else {k: numbers[k] for k in ERRORS if k in numbers},
            recordings=text("recordings"), program=text("program"),
            processor=text("processor") or self._processor, data=_Data(self.columns, row),
        )  # fmt: skip


class _Data(Mapping[str, Any]):
    """A row as it would be in JSON, made when it is looked at."""

    __slots__ = ("_columns", "_row")

    def __init__(self, columns: Columns, row: int) -> None:
        self._columns, self._row = columns, row

    def __getitem__(self, key: str) -> Any:
        return self._columns.data(self._row)[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns.data(self._row))

    def __len__(self) -> int:
        return len(self._columns.data(self._row))


@dataclass(frozen=True)
class Skip:
    mesh: str
    solver: str | None
    why: str


@dataclass(frozen=True)
class Run:
    file: Path
    context: dict[str, Any]
    meshes: dict[str, Mesh]
    solvers: dict[str, Solver]
    sources: dict[str, list[int]]
    skipped: list[Skip]
    rows: Sequence[Row]
    stored: dict[str, Any] = field(default_factory=dict)
    """The file's `columns`, where its rows are in a file beside it."""

    @property
    def rows_file(self) -> Path | None:
        """The file beside it that its rows are in."""
        return self.file.parent / self.stored["file"] if self.stored else None

    @property
    def ours(self) -> dict[str, Any]:
        """The part of the context that is geodesic-bench's own."""
        found: dict[str, Any] = self.context["geodesic_bench"]
        return found

    @cached_property
    def processors(self) -> list[str]:
        """Those that the rows were measured on, in the order of the rows."""
        if isinstance(self.rows, ColumnRows) and not self.rows.columns.has("processor").any():
            return [self.ours["processor"]]
        return list(dict.fromkeys(row.processor for row in self.rows))

    def of_processor(self, processor: str) -> Run:
        """The same run with what this processor measured only."""
        rows: Sequence[Row]
        if isinstance(self.rows, ColumnRows):
            columns = self.rows.columns
            own = columns.where("processor", processor)
            if processor == self.ours["processor"]:
                own |= ~columns.has("processor")
            rows = ColumnRows(columns.take(np.flatnonzero(own)), processor)
        else:
            rows = [row for row in self.rows if row.processor == processor]
        part = replace(self, rows=rows)
        pairs = set(part.columns.sources())
        sources = {name: [s for s in of if (name, s) in pairs] for name, of in self.sources.items()}
        return replace(
            part,
            meshes={name: mesh for name, mesh in self.meshes.items() if sources.get(name)},
            sources={name: of for name, of in sources.items() if of},
        )

    @property
    def shard(self) -> dict[str, Any] | None:
        """Of a part of a run: which one (results/README.md)."""
        found: dict[str, Any] | None = self.ours.get("shard")
        return found

    @property
    def of_plugins(self) -> set[str]:
        """Solvers that plug-ins brought, such as public codes, without parameters."""
        plugins = self.context.get("geodesic_bench", {}).get("plugins", [])
        return {solver for plugin in plugins for solver in plugin["solvers"]}

    @property
    def interleaved(self) -> bool:
        """Whether rows of one mesh, source and repetition are neighbours in time."""
        return bool(self.ours.get("interleaved", False))

    def cell(self, mesh: str, solver: str) -> list[Row]:
        """The rows of one solver on one mesh, over all sources, in the file's order."""
        return [self.rows[place] for place in self._places.get((mesh, solver), [])]

    @cached_property
    def columns(self) -> Columns:
        """The rows by key: what is looked at in all rows of a large run is looked at here."""
        if isinstance(self.rows, ColumnRows):
            return self.rows.columns
        return Columns.of([row.data for row in self.rows], whole=False)

    @cached_property
    def without_a_time(self) -> list[Row]:
        """The rows that are not ok."""
        return [self.rows[int(row)] for row in np.flatnonzero(~self.columns.where("outcome", OK))]

    @cached_property
    def _places(self) -> Mapping[tuple[str, str], Iterable[int]]:
        """Of rows, by mesh and solver."""
        if isinstance(self.rows, ColumnRows):
            places = self.rows.columns.by_texts("mesh", "solver")
            return {(mesh, solver): rows for (mesh, solver), rows in places.items()}
        found: dict[tuple[str, str], list[int]] = {}
        for place, row in enumerate(self.rows):
            found.setdefault((row.mesh, row.solver), []).append(place)
        return found

    def cells(self, program: str | None = None) -> dict[Cell, list[Row]]:
        """The rows by cell, in the file's order.

        @param program its rows only; None: those of every program"""
        found: dict[Cell, list[Row]] = {}
        for row in self.rows:
            if program is None or row.program == program:
                found.setdefault(row.cell, []).append(row)
        return found

    def of_meshes(self, names: Sequence[str]) -> Run:
        """The same run with these meshes only. @raises ResultError for one that it does not have"""
        for name in names:
            if name not in self.meshes:
                raise ResultError(f"{self.file}: no mesh {name!r}; it has {', '.join(self.meshes)}")
        return replace(
            self,
            meshes={name: mesh for name, mesh in self.meshes.items() if name in names},
            skipped=[skip for skip in self.skipped if skip.mesh in names],
            rows=[row for row in self.rows if row.mesh in names],
        )

    @property
    def not_measured(self) -> list[Skip]:
        """Meshes that were skipped whole."""
        return [skip for skip in self.skipped if skip.solver is None]

    def skip(self, mesh: str, solver: str) -> Skip | None:
        """The reason if the run skipped this solver on this mesh."""
        return next(
            (s for s in self.skipped if s.mesh == mesh and s.solver in (None, solver)), None
        )


def read_run(path: Path) -> Run:
    """@param path a run folder with a run.json in it, or a result file
    @raises ResultError as read_file does"""
    return read_file(path if path.is_file() else run_folder(path) / "run.json")


def run_folder(path: Path | None) -> Path:
    """The folder of --run, or the newest. @raises ResultError when it is not there"""
    folder = path or newest_run()
    if not folder.is_dir():
        raise ResultError(f"{folder}: no such folder; ./run_all.sh run makes one")
    return folder


def read_file(file: Path, *, of_any_revision: bool = False, as_columns: bool = False) -> Run:
    """A result file.

    @param as_columns of any number of rows: takes a tenth of the time and memory of a row each

    @param of_any_revision accept keys that this revision's schema does not have; those that a Run
           needs must be there
    @raises ResultError when the file is missing, broken or not to the schema"""
    data = load(file)
    if isinstance(data, dict) and "columns" in data:
        return _of_columns(file, data, _stored_columns(file, data))
    if as_columns and (columns := _own_columns(data)) is not None:
        return _of_columns(file, data, columns)
    return run_of(file, data, of_any_revision=of_any_revision)


def _stored_columns(file: Path, data: dict[str, Any]) -> Columns:
    """@raises ResultError"""
    validate(file, data)
    said = data["columns"]
    columns = Columns.load(file.parent / said["file"], said["rows"], said["texts"])
    if not columns.is_valid(data["context"]):
        raise ResultError(f"{file.parent / said['file']}: has rows that are not to the schema")
    return columns


def _own_columns(data: Any) -> Columns | None:
    """The rows of JSON as columns; None when they are not to the schema."""
    try:
        columns = Columns.of(data["benchmarks"])
        return columns if columns.is_valid(data["context"]) else None
    except (NotColumns, KeyError, TypeError, AttributeError):
        return None


def _of_columns(file: Path, data: dict[str, Any], columns: Columns) -> Run:
    """@raises ResultError as read_file does"""
    run = _typed(file, data | {"benchmarks": []})
    run = replace(run, rows=ColumnRows(columns, run.ours["processor"]))
    _check_columns(run, columns)
    return run


def run_of(file: Path, data: Any, *, of_any_revision: bool = False) -> Run:
    """What `load` returned, as a run. @raises ResultError as read_file does"""
    if not of_any_revision:
        validate(file, data)
    try:
        run = _typed(file, data)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise ResultError(f"{file}: not a result file of geodesic-bench: {error}") from None
    _check_names(run)
    return run


def load(file: Path) -> Any:
    """JSON with finite numbers, control characters escaped. @raises ResultError"""
    try:
        text = _text(file)
        data = _parsed(file, text)
        if _ESCAPED.search(text) or not text.replace("\n", "").isprintable():
            data = _harmless(data)
        if _NON_FINITE.search(text):
            _refuse_non_finite(file, data)
    except RecursionError:
        raise ResultError(f"{file}: nested too deep for a result file") from None
    return data


_ESCAPED = re.compile(r"\\[^\"\\/]")
"""What may stand for a character that cannot be printed."""
_NON_FINITE = re.compile(r"NaN|Infinity|[eE]\+?\d{3}|\d{300}")
"""What may stand for a number that is not finite."""


def _harmless(data: Any) -> Any:
    """The same with every text printable: file names and error messages are arbitrary."""
    if isinstance(data, str):
        return printable(data)
    if isinstance(data, dict):
        return {printable(key): _harmless(value) for key, value in data.items()}
    return [_harmless(value) for value in data] if isinstance(data, list) else data


def newest_run() -> Path:
    """The last run folder of results/runs, whose names begin with the time of their start."""
    folders = sorted(file.parent for file in RUNS.glob("*/run.json"))
    if not folders:
        raise ResultError(f"{RUNS}: no run there yet; ./run_all.sh run makes one")
    return folders[-1]


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise ResultError(f"{file}: no such file; was the run interrupted?") from None
    except OSError as error:
        raise ResultError(f"{file}: cannot be read: {error.strerror}") from None
    except ValueError as error:  # of UTF-8
        raise ResultError(f"{file}: not JSON, perhaps truncated: {error}") from None


def _parsed(file: Path, text: str) -> Any:
    try:
        return json.loads(text)
    except ValueError as error:
        raise ResultError(f"{file}: not JSON, perhaps truncated: {error}") from None


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


Kind = TypeVar("Kind", Mesh, Solver, Skip, Row)


def _typed(file: Path, data: Any) -> Run:
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
        sources={mesh: [int(v) for v in sources] for mesh, sources in ours["sources"].items()},
        skipped=[_of(Skip, skip) for skip in ours["skipped"]],
        rows=[_row(row, ours["processor"]) for row in data["benchmarks"]],
        stored=data.get("columns", {}),
    )


def _of(kind: type[Kind], found: dict[str, Any], **others: Any) -> Kind:
    """The members that the object in JSON has by these names, and the others."""
    copied = {one.name: found[one.name] for one in fields(kind) if one.name in found}
    return kind(**copied | others)


def _row(row: dict[str, Any], processor: str) -> Row:
    return _of(
        Row, row,
        source=int(row["source"]),
        repetition=int(row.get("repetition_index", 0)),
        message=row.get("error_message", ""),
        reference=row.get("reference"),
        processor=row.get("processor", processor),
        numbers=_numbers(row),
        data=row,
    )  # fmt: skip


def _numbers(row: dict[str, Any]) -> dict[str, float]:
    leaves = (([str(key) for key in path], value) for path, value in _leaves(row, []))
    numbers = {".".join(path): value for path, value in leaves if type(value) in (int, float)}
    ok = row["outcome"] == OK
    return {key: value for key, value in numbers.items() if ok or key in ERRORS}


def _check_columns(run: Run, columns: Columns) -> None:
    """As `_check_names`."""
    for key, known in (("mesh", list(run.meshes)), ("solver", list(run.solvers))):
        present = columns.by_texts(key)
        for (name,) in present.keys() - {(name,) for name in known}:
            raise ResultError(f"{run.file}: {key}: {name!r} is not among the context's")
    for mesh, source in columns.sources():
        if source not in run.sources.get(mesh, []):
            raise ResultError(f"{run.file}: source: {source} is not among the context's of {mesh}")
    if columns.has("processor").any() and (mixed := columns.sources_of_two("processor")):
        mesh, source = mixed[0]
        raise ResultError(
            f"{run.file}: processor: {mesh}, source {source}, was measured on two processors, "
            "whose times cannot be compared"
        )


def _check_names(run: Run) -> None:
    """The meshes, solvers and sources of the rows must be in the context, and all that one
    processor measured of a source."""
    processors: dict[tuple[str, int], str] = {}
    for index, row in enumerate(run.rows):
        where = f"{run.file}: benchmarks[{index}]"
        if row.mesh not in run.meshes:
            raise ResultError(f"{where}.mesh: {row.mesh!r} is not among the context's meshes")
        if row.solver not in run.solvers:
            raise ResultError(f"{where}.solver: {row.solver!r} is not among the context's solvers")
        if row.source not in run.sources.get(row.mesh, []):
            raise ResultError(
                f"{where}.source: {row.source} is not among the context's sources of {row.mesh}"
            )
        if processors.setdefault((row.mesh, row.source), row.processor) != row.processor:
            raise ResultError(
                f"{where}.processor: {row.mesh}, source {row.source}, was measured on two "
                "processors, whose times cannot be compared"
            )
