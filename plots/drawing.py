"""A figure of a run with its caption, as PDF for print and as PNG for screens."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from matplotlib.figure import Figure

from plots import style
from results.table import escape_markdown


@dataclass(frozen=True)
class Drawing:
    title: str
    caption: str
    """Sentences: what is drawn from which numbers, and how to read the marks."""
    figure: Figure


def write(drawing: Drawing, name: str, folder: Path) -> list[Path]:
    """Writes the figure as PNG and PDF, its caption as Markdown, and returns the files."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{name}{extension}" for extension in (".png", ".pdf", ".md")]
    *pictures, caption = files
    for file in pictures:
        style.save(drawing.figure, file)
    title, words = escape_markdown(drawing.title), escape_markdown(drawing.caption)
    caption.write_text(f"## {title}\n\n![{title}]({name}.png)\n\n{words}\n", encoding="utf-8")
    return files
