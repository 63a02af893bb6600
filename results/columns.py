"""Rows of result files as columns. Every run is stored in this form, whatever its number of rows.

A column is a key of the schema's rows; a key inside an object is written "phase_seconds.queue". Numbers
are arrays, in which -1 (for integers) or NaN (for others) stands for a missing number; the schema allows
neither value. A text is stored as an index into a list of distinct texts, -1 if missing. A source is
a vertex, or -2 - p for the set whose name has the index p in the texts of "source". Values that follow
from other keys are not stored: names, and values that are equal in all rows.
"""

from __future__ import annotations

import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .schema import ResultError, is_valid, resolved, schema

Array = NDArray[Any]
FOLLOWS = ("name", "run_name", "run_type", "time_unit", "error_occurred")
"""Keys that `Columns.data` derives from others."""
NONE = -1
OUTCOME, OK = "outcome", "ok"
SOURCE, FIRST_SET = "source", -2
TYPES: dict[str, Any] = {"integer": np.int64, "number": np.float64, "string": np.int32}


@cache
def parts() -> dict[str, dict[str, Any]]:
    """Returns the part of the schema that describes the values, by column."""

    def leaves(properties: dict[str, Any], prefix: str) -> Iterator[tuple[str, dict[str, Any]]]:
        for key, part in properties.items():
            part = resolved(part)
            if "properties" in part:
                yield from leaves(part["properties"], f"{prefix}{key}.")
            elif prefix or key not in FOLLOWS:
                yield prefix + key, part

    return dict(leaves(schema()["$defs"]["row"]["properties"], ""))


@cache
def kinds() -> dict[str, str]:
    """Returns "integer", "number" or "string" by column."""
    # An enumeration has texts.
    return {
        key: "integer" if key == SOURCE else part.get("type", "string")
        for key, part in parts().items()
    }


@dataclass(frozen=True)
class Columns:
    length: int
    arrays: dict[str, Array]
    """The arrays by key. A key that no row has is left out."""
    texts: dict[str, list[str]] = field(default_factory=dict)
    """The distinct texts of the columns with texts, by key."""
    whole: bool = True
    """Whether no key was left out, so that `data` returns the rows exactly as in JSON."""

    @staticmethod
    def of(rows: Sequence[Mapping[str, Any]]) -> Columns:
        """Converts rows of JSON. Keys that are not in the schema are left out.

        @raises ValueError, TypeError, AttributeError or OverflowError for values whose type is not
                that of the schema"""
        arrays: dict[str, Array] = {}
        texts: dict[str, list[str]] = {}
        found = 0
        for key, kind in kinds().items():
            values = _values(rows, key)
            present = len(values) - values.count(None)
            if not present:
                continue
            found += present
            if key == SOURCE and (sets := list(dict.fromkeys(filter(_is_set, values)))):
                texts[key] = sets
                values = [FIRST_SET - sets.index(v) if _is_set(v) else _vertex(v) for v in values]
                arrays[key] = np.array(values, np.int64)
            elif kind == "string":
                places: dict[Any, int] = {}
                arrays[key] = np.array(
                    [NONE if v is None else places.setdefault(v, len(places)) for v in values],
                    np.int32,
                )
                if not all(isinstance(text, str) for text in places):
                    raise ValueError(f"{key} is not a text")
                texts[key] = list(places)
            else:
                arrays[key] = _numbers(key, kind, values)
        whole = found == sum(map(_kept, rows)) and all(map(_named, rows))
        return Columns(len(rows), arrays, texts, whole)

    def has(self, key: str) -> Array:
        """Returns a mask of the rows that have a value for the key."""
        array = self.arrays.get(key)
        if array is None:
            return np.zeros(self.length, bool)
        there: Array = ~np.isnan(array) if array.dtype == np.float64 else array != NONE
        return there

    def numbers(self, key: str) -> NDArray[np.float64]:
        """Returns the numbers of a column, NaN where a row has none."""
        array = self.arrays.get(key)
        if array is None:
            return np.full(self.length, np.nan)
        return np.where(self.has(key), array, np.nan)

    def where(self, key: str, *any_of: str) -> Array:
        """Returns a mask of the rows that have one of these texts."""
        places = [place for place, text in enumerate(self.texts.get(key, ())) if text in any_of]
        return np.isin(self.arrays[key], places) if places else np.zeros(self.length, bool)

    def text(self, key: str, row: int) -> str | None:
        array = self.arrays.get(key)
        place = NONE if array is None else int(array[row])
        return None if place == NONE else self.texts[key][place]

    def source(self, row: int) -> int | str:
        """Returns the vertex or the name of the set. Every row has a source."""
        value = int(self.arrays[SOURCE][row])
        return value if value >= 0 else self.texts[SOURCE][FIRST_SET - value]

    def names(self, key: str) -> list[str]:
        """Returns the distinct texts in the order of the rows. Every row must have a text."""
        _, first = np.unique(self.arrays[key], return_index=True)
        return [str(self.text(key, row)) for row in sorted(first.tolist())]

    def by_texts(self, *keys: str) -> dict[tuple[str, ...], Array]:
        """Returns the indices of the rows, by their texts for the keys. Every row must have these texts."""
        code = np.zeros(self.length, np.int64)
        for key in keys:
            code = code * len(self.texts.get(key, ())) + self.arrays[key] if self.length else code
        order = np.argsort(code, kind="stable")
        starts = np.flatnonzero(np.diff(code[order], prepend=NONE))
        groups = np.split(order, starts[1:]) if self.length else []
        return {tuple(str(self.text(key, int(rows[0]))) for key in keys): rows for rows in groups}

    def cells(self, rows: Array) -> int:
        """Returns the number of distinct cells of some rows. @param rows mask, as `where` returns it"""
        keys = np.stack([self.arrays[key][rows] for key in ("solver", "mesh", "source")])
        return int(np.unique(keys, axis=1).shape[1])

    def data(self, row: int) -> dict[str, Any]:
        """Returns the row as in JSON."""
        found: dict[str, Any] = {}
        for key, kind in kinds().items():
            if key == SOURCE and key in self.arrays:
                value: Any = self.source(row)
            elif kind == "string":
                value = self.text(key, row)
            else:
                value = self.number(key, row)
            if value is not None:
                into, _, last = key.rpartition(".")
                (found.setdefault(into, {}) if into else found)[last] = value
        constant = {"run_type": "iteration", "time_unit": "ms"}
        failed = {} if found[OUTCOME] == OK else {"error_occurred": True}
        return {"name": _name(found), "run_name": _name(found)} | constant | failed | found

    def number(self, key: str, row: int) -> float | None:
        """Returns the number of a row, an int for integer columns; None if the row has none."""
        array = self.arrays.get(key)
        value: float = NONE if array is None else array[row].item()
        return None if value == NONE or value != value else value  # NaN differs from itself

    def take(self, rows: Array) -> Columns:
        """Returns the given rows. @param rows indices in the desired order, or a mask"""
        arrays = {key: array[rows] for key, array in self.arrays.items()}
        return Columns(len(next(iter(arrays.values()), rows)), arrays, self.texts)

    def filled(self, key: str, text: str) -> Columns:
        """Returns the columns with this text in the rows that have none."""
        texts = list(dict.fromkeys([*self.texts.get(key, ()), text]))
        array = self.arrays.get(key, np.full(self.length, NONE))
        array = np.where(array == NONE, texts.index(text), array).astype(np.int32)
        return replace(self, arrays=self.arrays | {key: array}, texts=self.texts | {key: texts})

    def without(self, key: str, text: str) -> Columns:
        """Returns the columns without this text: the rows that had it have none."""
        array = np.where(self.where(key, text), NONE, self.arrays[key]).astype(np.int32)
        arrays = self.arrays | {key: array}
        if (array == NONE).all():
            del arrays[key]
        texts = {name: of for name, of in self.texts.items() if name in arrays}
        return replace(self, arrays=arrays, texts=texts)

    @staticmethod
    def together(parts: Sequence[Columns]) -> Columns:
        """Returns all rows of all parts, in their order."""
        texts: dict[str, list[str]] = {}
        arrays: dict[str, Array] = {}
        for key, kind in kinds().items():
            if not any(key in part.arrays for part in parts):
                continue
            places: dict[str, int] = {}
            pieces = []
            for part in parts:
                array = part.arrays.get(key)
                if array is None:
                    absent = np.nan if kind == "number" else NONE
                    array = np.full(part.length, absent, TYPES[kind])
                elif kind == "string":
                    own = [places.setdefault(text, len(places)) for text in part.texts[key]]
                    array = np.array([*own, NONE], np.int32)[array]  # place -1 is the last
                elif key == SOURCE and key in part.texts:
                    own = [FIRST_SET - places.setdefault(text, len(places)) for text in part.texts[key]]
                    of_sets = array <= FIRST_SET
                    array = array.copy()
                    array[of_sets] = np.array(own)[FIRST_SET - array[of_sets]]
                pieces.append(array)
            arrays[key] = np.concatenate(pieces)
            if places:
                texts[key] = list(places)
        return Columns(sum(part.length for part in parts), arrays, texts)

    def save(self, file: Path) -> None:
        """Writes compressed arrays of NumPy. The texts are not written."""
        with file.open("wb") as stream:
            np.savez_compressed(stream, **self.arrays)

    @staticmethod
    def load(file: Path, length: int, texts: dict[str, list[str]]) -> Columns:
        """@raises ResultError when the file is not one that `save` wrote"""
        try:
            with np.load(file, allow_pickle=False) as stored:
                arrays = {key: stored[key] for key in stored.files}
        except FileNotFoundError:
            raise ResultError(f"{file}: no such file; run.json has its rows there") from None
        except (OSError, ValueError, EOFError, zipfile.BadZipFile) as error:
            raise ResultError(f"{file}: not arrays of numpy: {error}") from None
        for key, array in arrays.items():
            kind = kinds().get(key)
            if kind is None:
                raise ResultError(f"{file}: {key}: no column of a result file")
            if array.shape != (length,) or array.dtype != TYPES[kind]:
                raise ResultError(f"{file}: {key}: not {length} values of {TYPES[kind].__name__}")
            if kind == "string" and not (
                array.min(initial=NONE) >= NONE
                and array.max(initial=NONE) < len(texts.get(key, ()))
            ):
                raise ResultError(f"{file}: {key}: a text that run.json does not have")
            if key == SOURCE and array.min(initial=0) < FIRST_SET + 1 - len(texts.get(key, ())):
                raise ResultError(f"{file}: {key}: a set that run.json does not have")
        return Columns(length, arrays, {key: texts[key] for key in arrays if key in texts})

    def is_valid(self, data: dict[str, Any]) -> bool:
        """Whether all rows and the rest of the result file conform to the schema. The schema bounds
        numbers and lengths of texts by intervals. So only the extremes of rows with equal keys and
        outcome are validated, and each distinct text."""
        if not self.whole or (self.length and OUTCOME not in self.arrays):
            return False
        texts = ((parts()[key], text) for key, of in self.texts.items() for text in of)
        return all(is_valid(text, part) for part, text in texts) and is_valid(
            data | {"benchmarks": self._extreme_rows() if self.length else []}
        )

    def _extreme_rows(self) -> list[dict[str, Any]]:
        """Returns two rows for each group of rows with equal keys and outcome: one with the least
        numbers and shortest texts, and one with the greatest numbers and longest texts."""
        of_texts = {key: texts for key, texts in self.texts.items() if kinds()[key] == "string"}
        arrays = {key: array for key, array in self.arrays.items() if key not in of_texts}
        for key, texts in of_texts.items():  # by length; the lower half keeps the index of the text
            lengths = np.array([*map(len, texts), 0], np.int64)
            arrays[key] = (lengths[self.arrays[key]] << 32) + self.arrays[key] - NONE
        bits = np.packbits([self.has(key) for key in self.arrays], axis=0)
        shapes = np.vstack([bits, self.arrays[OUTCOME][None].astype(np.uint8)])
        _, group = np.unique(shapes, axis=1, return_inverse=True)
        order = np.argsort(group, kind="stable")
        starts = np.searchsorted(group[order], np.arange(group.max() + 1))
        found = []
        for reduceat in (np.minimum.reduceat, np.maximum.reduceat):
            of = {key: reduceat(array[order], starts) for key, array in arrays.items()}
            for key in of_texts:
                of[key] = ((of[key] & 0xFFFFFFFF) + NONE).astype(np.int32)
            bounds = Columns(len(starts), of, self.texts)
            found += [bounds.data(row) for row in range(len(starts))]
        return found


def _values(rows: Sequence[Mapping[str, Any]], key: str) -> list[Any]:
    into, _, last = key.rpartition(".")
    return [row.get(last) for row in ([row.get(into, {}) for row in rows] if into else rows)]


def _is_set(source: Any) -> bool:
    return isinstance(source, str)


def _vertex(source: Any) -> int:
    if type(source) is not int or source < 0:
        raise ValueError(f"{SOURCE} is neither a vertex nor the name of a set")
    return source


def _numbers(key: str, kind: str, values: list[Any]) -> Array:
    if not {type(value) for value in values} <= {int, float, type(None)}:
        raise ValueError(f"{key} is not a number")
    if kind == "number":
        return np.array([np.nan if value is None else value for value in values], np.float64)
    found = np.array([NONE if value is None else value for value in values])
    with np.errstate(invalid="ignore"):
        whole = found.astype(np.int64)
    # A value of -1 would count as missing.
    if (whole != found).any() or (whole == NONE).sum() != values.count(None):
        raise ValueError(f"{key} is not a whole number of at least 0")
    return whole


def _kept(row: Mapping[str, Any]) -> int:
    """Returns the number of values whose key is not in FOLLOWS."""
    return sum(
        len(value) if isinstance(value, dict) else 1
        for key, value in row.items()
        if key not in FOLLOWS
    )


def _name(row: Mapping[str, Any]) -> str:
    return f"{row.get('solver')}/{row.get('mesh')}/src:{row.get('source')}"


def _named(row: Mapping[str, Any]) -> bool:
    """Whether the values of the keys FOLLOWS are those that `data` derives."""
    found = [row.get(key) for key in FOLLOWS[:-1]] + [row.get("error_occurred", False)]
    return found == [_name(row), _name(row), "iteration", "ms", row.get(OUTCOME) != OK]
