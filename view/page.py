"""The HTML of the page, which contains all scripts and data."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from view import three

TEMPLATES = Environment(
    loader=FileSystemLoader(Path(__file__).resolve().parent), autoescape=True,
    undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True,
)  # fmt: skip
TEMPLATES.policies["json.dumps_kwargs"] = {"allow_nan": False}


def page(title: str, summary: str, command: str, scene: dict[str, Any]) -> str:
    """@param command the command line that makes the page
    @raises Unavailable when three.js is missing"""
    return TEMPLATES.get_template("page.html").render(
        title=title,
        summary=summary,
        command=command,
        solvers=scene["solvers"],
        scene=scene,
        imports=three.import_map(),
        version=three.VERSION,
        licence=three.licence(),
    )
