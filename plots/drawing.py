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


@dataclass(frozen=True)
class Picture:
    """A figure in a file, with its caption."""

    title: str
    caption: str
    png: Path
    inches: tuple[float, float]

    @classmethod
    def of(cls, drawing: Drawing, png: Path) -> Picture:
        width, height = drawing.figure.get_size_inches()
        return cls(drawing.title, drawing.caption, png, (float(width), float(height)))


def write(drawing: Drawing, name: str, folder: Path) -> tuple[Picture, list[Path]]:
    """Writes the figure as PNG and PDF and its caption as Markdown. Returns it with these files."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{name}{extension}" for extension in (".png", ".pdf", ".md")]
    *pictures, caption = files
    for file in pictures:
        style.save(drawing.figure, file)
    title, words = escape_markdown(drawing.title), escape_markdown(drawing.caption)
    caption.write_text(f"## {title}\n\n![{title}]({name}.png)\n\n{words}\n", encoding="utf-8")
    return Picture.of(drawing, files[0]), files
