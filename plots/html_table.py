"""A table as HTML for the report: sortable by its headers, footnotes under it."""

from __future__ import annotations

from html import escape

from results.table import Cell, Table, mark

LONG = 48
"""Longer texts are broken into lines."""


def to_html(table: Table) -> str:
    """Wants report.css and report.js; the caller writes the heading, with the id NAME-title."""
    notes = table.notes()
    head = "".join(
        f'<th scope="col" aria-sort="none" data-name="{escape(name)}"{_class(table, i)}>'
        f'<button type="button">{escape(name)}</button></th>'
        for i, name in enumerate(table.header)
    )
    rows: list[str] = []
    group: object = None
    for row in table.rows:
        cells = "".join(_cell(table, i, cell, notes) for i, cell in enumerate(row))
        new_group = rows and row[0].value != group
        rows.append(f"<tr{' class=group' if new_group else ''}>{cells}</tr>")
        group = row[0].value
    remarks = "".join(f"<p>{escape(remark)}</p>" for remark in table.remarks)
    footnotes = "".join(
        f'<li id="{_note_id(table, i)}"><sup>{mark(i)}</sup> {escape(note)}</li>'
        for i, note in enumerate(notes)
    )
    return (
        f'<div class="scroll" role="region" tabindex="0" aria-labelledby="{table.name}-title">'
        f"<table><thead><tr>{head}</tr></thead>\n<tbody>\n" + "\n".join(rows) + "\n</tbody></table>"
        f'</div>\n<div class="remarks">{remarks}'
        + (f"<ul>{footnotes}</ul>" if footnotes else "")
        + "</div>"
    )


def _class(table: Table, column: int, text: str = "") -> str:
    if column >= table.text_columns:
        return ' class="number"'
    return ' class="words"' if len(text) > LONG else ""


def _note_id(table: Table, index: int) -> str:
    return f"{table.name}-{mark(index)}"


def _cell(table: Table, column: int, cell: Cell, notes: list[str]) -> str:
    """`data-value` is what the column is sorted by: a number, or words that the text abridges."""
    text = escape(cell.text)
    value = ""
    if cell.value is not None:
        value = f' data-value="{escape(str(cell.value))}"'
        if isinstance(cell.value, str) and cell.value != cell.text and column == 0:
            text = f"<span class=first>{text}</span><span class=again>{escape(cell.value)}</span>"
    if cell.note:
        index = notes.index(cell.note)
        link = f'<a href="#{_note_id(table, index)}">{mark(index)}</a>'
        text += f" <sup>{link}</sup>"
    return f"<td{_class(table, column, cell.text)}{value}>{text}</td>"
