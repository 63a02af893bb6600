"""One figure of a run: what it shows in words, and its picture; PDF to print, PNG to look at."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from matplotlib.figure import Figure

from plots import style


@dataclass(frozen=True)
class Drawing:
    name: str
    """Of its files."""
    title: str
    caption: str
    """Sentences: what is drawn from which numbers, and how to read the marks."""
    figure: Figure

    @property
    def alternative(self) -> str:
        """For those who do not see the picture."""
        return f"{self.title}. {self.caption}"



def to_markdown(drawing: Drawing) -> str:
    return f"## {drawing.title}\n\n![{drawing.title}]({drawing.name}.png)\n\n{drawing.caption}\n"


def write(drawing: Drawing, folder: Path) -> list[Path]:
    """Writes the figure as PNG and PDF, its caption as Markdown, and returns the files."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{drawing.name}{extension}" for extension in (".png", ".pdf", ".md")]
    *pictures, caption = files
    for file in pictures:
        style.save(drawing.figure, file)
    caption.write_text(to_markdown(drawing), encoding="utf-8")
    return files
