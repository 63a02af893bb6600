"""Tables in four formats: Markdown and aligned text to read, LaTeX to print, and CSV (unrounded) to
reuse. Also the escapes for LaTeX and Markdown."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from .console import printable
from .statistics import Estimate


@dataclass(frozen=True)
class Field:
    text: str
    """The printed text; each format escapes it."""
    value: float | int | str | None = None
    """The value in CSV; None for the text."""
    low: float | None = None
    high: float | None = None
    note: str = ""
    """A footnote. Equal notes in a table share one mark."""
    latex: str | None = None
    """LaTeX code to write instead of the escaped text."""
    title: str = ""
    """Tooltip on an HTML page."""


BLANK = Field("")


def decimals(value: float, digits: int) -> int:
    """Returns the number of decimals that shows so many significant digits of the value as it is rounded:
    9.996 has one decimal in three digits, 10.0. From 10^digits on all digits before the point are shown."""
    exponent = int(f"{value:.{digits - 1}e}".partition("e")[2])
    return max(0, digits - 1 - exponent)


def four_digits(value: float) -> str:
    """Formats four significant digits, with trailing zeros: 0.4217, 1.780, 14.74, 1234."""
    return f"{value:.{decimals(value, 4)}f}"


def estimate_field(estimate: Estimate, text: str, note: str = "") -> Field:
    return Field(text, estimate.value, estimate.low, estimate.high, note)


def text_fields(texts: Iterable[str]) -> list[Field]:
    return [Field(text) for text in texts]


@dataclass(frozen=True)
class Table:
    name: str
    """Name of the files, without extension."""
    title: str
    """Empty for a table without a heading."""
    header: list[str]
    """Names of the columns; empty for a table that is only a title."""
    text_columns: int
    """Number of columns from the left with texts. The others have numbers, aligned to the right."""
    rows: list[list[Field]]
    remarks: list[str] = field(default_factory=list)
    """Sentences under the table."""

    def notes(self) -> list[str]:
        """Returns the footnotes in the order of their fields."""
        return list(dict.fromkeys(field.note for row in self.rows for field in row if field.note))

    def has_titles(self) -> bool:
        return any(field.title for row in self.rows for field in row)


def without_empty_columns(table: Table) -> Table:
    """Returns the table without the columns in which no field has a text."""
    columns = [i for i in _columns(table) if any(row[i].text for row in table.rows)]
    return replace(
        table,
        header=[table.header[i] for i in columns],
        text_columns=sum(i < table.text_columns for i in columns),
        rows=[[row[i] for i in columns] for row in table.rows],
    )


def mark(index: int) -> str:
    """Returns the mark of a footnote: a, b, ... z, aa, ab, ..."""
    letter = chr(ord("a") + index % 26)
    return letter if index < 26 else mark(index // 26 - 1) + letter


def to_markdown(table: Table) -> str:
    notes = table.notes()

    def shown(field: Field) -> str:
        text = escape_markdown(field.text)
        return f"{text} <sup>{mark(notes.index(field.note))}</sup>" if field.note else text

    lines = [f"## {escape_markdown(table.title)}", ""] if table.title else []
    if not table.header:
        return "\n".join(lines)
    lines.append(_markdown_row([escape_markdown(name) for name in table.header]))
    lines.append(
        _markdown_row([":--" if i < table.text_columns else "--:" for i in _columns(table)])
    )
    lines += [_markdown_row([shown(field) for field in row]) for row in table.rows]
    lines += ["", *(f"{escape_markdown(remark)}\n" for remark in table.remarks)]
    lines += [
        f"<sup>{mark(index)}</sup> {escape_markdown(note)}\n" for index, note in enumerate(notes)
    ]
    return "\n".join(lines).rstrip("\n") + "\n"


def to_text(table: Table) -> str:
    """Formats for a terminal: aligned columns, indented by two spaces under the title."""
    notes = table.notes()

    def shown(field: Field) -> str:
        return f"{field.text} {mark(notes.index(field.note))}" if field.note else field.text

    rows = [table.header, *([shown(field) for field in row] for row in table.rows)]
    widths = [max(len(row[i]) for row in rows) for i in _columns(table)]
    lines = [table.title] if table.title else []
    for row in rows if table.header else []:
        padded = (
            text.ljust(width) if i < table.text_columns else text.rjust(width)
            for i, (text, width) in enumerate(zip(row, widths, strict=True))
        )
        lines.append(("  " + "  ".join(padded)).rstrip())
    lines += table.remarks + [f"{mark(index)}: {note}" for index, note in enumerate(notes)]
    return "".join(f"{printable(line)}\n" for line in lines)


def text_page(lines: Iterable[str], tables: Iterable[Table]) -> str:
    """Formats lines with the tables under them, for a terminal."""
    parts = [f"{printable(line)}\n" for line in lines]
    return "".join([*parts, *(f"\n{to_text(table)}" for table in tables)])


def markdown_page(title: str, lines: Iterable[str], tables: Iterable[Table]) -> str:
    """Formats a title, which may be empty, a list of lines, and the tables under it."""
    parts = [f"## {escape_markdown(title)}\n\n"] if title else []
    parts += [f"- {escape_markdown(line)}\n" for line in lines]
    return "".join([*parts, *(f"\n{to_markdown(table)}" for table in tables)])


def to_csv(table: Table) -> str:
    """Formats one line per row. A column with intervals is followed by columns of its low and high ends.
    The last column has the footnotes in full."""
    with_interval = [any(row[i].low is not None for row in table.rows) for i in _columns(table)]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    header: list[str] = []
    for name, interval in zip(table.header, with_interval, strict=True):
        header += [name, f"{name}, low", f"{name}, high"] if interval else [name]
    writer.writerow([*header, "notes"])
    for row in table.rows:
        line: list[object] = []
        for field, interval in zip(row, with_interval, strict=True):
            line.append(field.text if field.value is None else _number(field.value))
            line += [_number(field.low), _number(field.high)] if interval else []
        writer.writerow([*line, " ".join(dict.fromkeys(c.note for c in row if c.note))])
    return text.getvalue()


def to_latex(table: Table) -> str:
    """Formats a longtable to be \\input. A rule separates rows with different values in the first column."""
    notes = table.notes()

    def shown(field: Field) -> str:
        text = escape_latex(field.text) if field.latex is None else field.latex
        return f"{text}\\textsuperscript{{{mark(notes.index(field.note))}}}" if field.note else text

    lines = [
        r"% needs \usepackage{booktabs,longtable}",
        r"\begingroup\footnotesize",
        rf"\begin{{longtable}}{{{_alignment(table)}}}",
        rf"\caption{{{escape_latex(table.title)}}}\label{{tab:{table.name.replace('_', '-')}}}\\",
        rf"\toprule {_latex_head(table)} \midrule \endfirsthead",
        rf"\toprule {_latex_head(table)} \midrule \endhead",
        r"\bottomrule \endfoot",
    ]
    for index, row in enumerate(table.rows):
        if index and row[0].value != table.rows[index - 1][0].value:
            lines.append(r"\midrule")
        lines.append(" & ".join(map(shown, row)) + r" \\")
    lines.append(r"\end{longtable}")
    lines += [rf"\noindent {escape_latex(remark)}\par" for remark in table.remarks]
    lines += [
        rf"\noindent \textsuperscript{{{mark(index)}}} {escape_latex(note)}\par"
        for index, note in enumerate(notes)
    ]
    return "\n".join([*lines, r"\endgroup"]) + "\n"


def to_tabular(table: Table) -> str:
    """Formats only the header and rows as a LaTeX tabular, to be put into any table."""
    lines = [" & ".join(escape_latex(field.text) for field in row) + r" \\" for row in table.rows]
    return "\n".join([
        r"% needs \usepackage{booktabs}", rf"\begin{{tabular}}{{{_alignment(table)}}}", r"\toprule",
        _latex_head(table), r"\midrule", *lines, r"\bottomrule", r"\end{tabular}", "",
    ])  # fmt: skip


def _latex_head(table: Table) -> str:
    return " & ".join(map(escape_latex, table.header)) + r" \\"


def _alignment(table: Table) -> str:
    return "".join("l" if i < table.text_columns else "r" for i in _columns(table))


FORMATS: dict[str, Callable[[Table], str]] = {
    ".md": to_markdown,
    ".csv": to_csv,
    ".tex": to_latex,
}


def write(table: Table, folder: Path) -> list[Path]:
    """Writes the table in every format and returns the files, Markdown first."""
    folder.mkdir(parents=True, exist_ok=True)
    files = []
    for extension, render in FORMATS.items():
        file = folder / f"{table.name}{extension}"
        file.write_text(render(table), encoding="utf-8")
        files.append(file)
    return files


_LATEX = {
    "\\": r"\textbackslash{}",
    "&": r"\&",
    "%": r"\%",
    "$": r"\$",
    "#": r"\#",
    "_": r"\_",
    "{": r"\{",
    "}": r"\}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"$<$",
    ">": r"$>$",
    "\N{MULTIPLICATION SIGN}": r"$\times$",
    "\N{EN DASH}": "--",
    "\N{EM DASH}": "---",
}


def escape_latex(text: str) -> str:
    """Escapes the characters that have a meaning in LaTeX."""
    return "".join(_LATEX.get(character, character) for character in text)


def escape_markdown(text: str) -> str:
    """Escapes the characters of a line that have a meaning in Markdown, also in tables."""
    return re.sub(r"[\\|`*<$]", r"\\\g<0>", text)


def _markdown_row(fields: list[str]) -> str:
    return f"| {' | '.join(fields)} |"


def _number(value: float | int | str | None) -> object:
    """Formats a float with twelve digits. Further digits are rounding errors, which depend on the processor."""
    return f"{value:.12g}" if isinstance(value, float) else value


def _columns(table: Table) -> range:
    return range(len(table.header))
