"""The schema of result files, and the error for a file that cannot be used."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema

from .console import ROOT

SCHEMA = ROOT / "results" / "run.schema.json"


class ResultError(ValueError):
    """A result file that cannot be used; its message is one line."""


@cache
def schema() -> dict[str, Any]:
    found: dict[str, Any] = json.loads(SCHEMA.read_text(encoding="utf-8"))
    return found


@cache
def _validator() -> Any:
    return jsonschema.Draft202012Validator(schema())


def validate(file: Path, data: Any) -> None:
    """@raises ResultError with the first key of the file that does not conform to the schema"""
    error = next(_validator().iter_errors(data), None)
    if error is not None:
        line = " ".join(error.message.split())
        if len(line) > 200:
            line = f"{line[:120]} ... {line[-70:]}"
        raise ResultError(f"{file}: {key_of(list(error.absolute_path))}: {line}")


def is_valid(data: Any, part: dict[str, Any] | None = None) -> bool:
    """Whether data conforms to the schema. @param part a part of the schema; None for the whole"""
    validator = _validator() if part is None else _validator().evolve(schema=resolved(part))
    return next(validator.iter_errors(data), None) is None


def resolved(part: dict[str, Any]) -> dict[str, Any]:
    """Follows the references of a part of the schema."""
    while "$ref" in part:
        part = schema()["$defs"][part["$ref"].removeprefix("#/$defs/")]
    return part


def key_of(path: list[str | int]) -> str:
    """Converts ["benchmarks", 3, "source"] to "benchmarks[3].source"."""
    steps = (f"[{step}]" if isinstance(step, int) else f".{step}" for step in path)
    return "".join(steps).lstrip(".") or "the file"
