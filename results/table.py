"""Tables in four formats: Markdown and aligned text to read, LaTeX for the floats of a paper, and CSV
(unrounded) to reuse. Also the escapes for LaTeX and Markdown."""

from __future__ import annotations

import csv
import io
import itertools
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
    short: str | None = None
    """Text on an HTML page, without the interval; None for the text."""


BLANK = Field("")
PAGE_ROWS = 60
"""Largest number of rows that can be read on one page."""


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
    """Formats the content of a float, to be \\input, with the remarks and footnotes under the tabular. The
    first line is a comment that shows the float."""
    lines = [
        rf"% \usepackage{{adjustbox,booktabs}} \begin{{table*}} \caption{{{escape_latex(table.title)}}} "
        rf"\label{{tab:{table.name.replace('_', '-')}}} \input{{{table.name}}} \end{{table*}}",
        r"\begingroup\footnotesize\centering",
        to_tabular(table) + r"\par\smallskip\raggedright",
        *(rf"\noindent {escape_latex(remark)}\par" for remark in table.remarks),
        *(
            rf"\noindent \textsuperscript{{{mark(index)}}} {escape_latex(note)}\par"
            for index, note in enumerate(table.notes())
        ),
        r"\endgroup",
    ]
    return "\n".join(lines) + "\n"


def to_tabular(table: Table) -> str:
    """Formats the header and rows as a LaTeX tabular, shrunk where it would be wider than a line or higher
    than a page. Rules separate the rows of each value of the first column, if one has several rows."""
    notes = table.notes()
    values = [row[0].value for row in table.rows]
    is_grouped = len(set(values)) < len(values)

    def shown(field: Field) -> str:
        text = escape_latex(field.text) if field.latex is None else field.latex
        return f"{text}\\textsuperscript{{{mark(notes.index(field.note))}}}" if field.note else text

    lines = [
        r"\begin{adjustbox}{max width=\linewidth,max totalheight=0.8\textheight}",
        rf"\begin{{tabular}}{{{_alignment(table)}}}",
        rf"\toprule {_latex_head(table)} \midrule",
    ]
    for index, row in enumerate(table.rows):
        if is_grouped and index and values[index] != values[index - 1]:
            lines.append(r"\midrule")
        lines.append(" & ".join(map(shown, row)) + r" \\")
    return "\n".join([*lines, r"\bottomrule", r"\end{tabular}", r"\end{adjustbox}"])


def pages(table: Table) -> list[Table]:
    """Returns tables of at most PAGE_ROWS rows, since a float takes one page. They are cut where the value
    of the first column changes, if one value has no more rows than that. The second one is NAME_2."""
    parts: list[list[list[Field]]] = [[]]
    for _, group in itertools.groupby(table.rows, key=lambda row: row[0].value):
        rows = list(group)
        for begin in range(0, len(rows), PAGE_ROWS):
            some = rows[begin : begin + PAGE_ROWS]
            if len(parts[-1]) + len(some) > PAGE_ROWS:
                parts.append([])
            parts[-1] += some
    last = len(parts)
    return [
        replace(table, rows=rows, name=table.name + (f"_{number}" if number > 1 else ""),
                title=f"{table.title} ({number} of {last})" if last > 1 else table.title)
        for number, rows in enumerate(parts, start=1)
    ]  # fmt: skip


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
    """Writes the table in every format and returns the files, Markdown first. LaTeX has a file a page."""
    folder.mkdir(parents=True, exist_ok=True)
    files = []
    for extension, render in FORMATS.items():
        for part in pages(table) if extension == ".tex" else [table]:
            file = folder / f"{part.name}{extension}"
            file.write_text(render(part), encoding="utf-8")
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
