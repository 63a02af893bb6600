"""The HTML of the page: everything in one text."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup

from view import three

TEMPLATES = Environment(
    loader=FileSystemLoader(Path(__file__).resolve().parent), autoescape=True,
    undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True,
)  # fmt: skip


def page(title: str, summary: str, command: str, scene: dict[str, Any]) -> str:
    """@param command line that makes the page
    @raises Unavailable when three.js is not there"""
    return TEMPLATES.get_template("page.html").render(
        title=title,
        summary=summary,
        command=command,
        solvers=scene["solvers"],
        scene=_in_script(json.dumps(scene, allow_nan=False)),
        imports=_in_script(three.import_map()),
        version=three.VERSION,
        licence=three.licence(),
    )


def _in_script(json_text: str) -> Markup:
    r"""JSON that ends no script element: < can only be in a text, where \u003c is the same."""
    return Markup(json_text.replace("<", "\\u003c"))
