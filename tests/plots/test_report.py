"""The report page is complete, needs no other files, and lists all failures."""

from __future__ import annotations

import io
import re
import sys
from html.parser import HTMLParser
from pathlib import Path

import pytest

from plots import catalogue, report
from plots.catalogue import EVERYTHING
from results import console
from results.reader import Run
from results.table import Field, Table


class Page(HTMLParser):
    """Tags of a page, with their attributes, and its text."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.pieces: list[str] = []
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.pieces.append(data)

    @property
    def text(self) -> str:
        return " ".join(" ".join(self.pieces).split())

    def all_of(self, name: str) -> list[str]:
        return [value for _, attributes in self.tags if (value := attributes.get(name))]


@pytest.fixture(scope="module")
def page(reported: Path) -> Page:
    return Page((reported / "report.html").read_text(encoding="utf-8"))


def test_the_page_shows_every_table_and_figure_and_needs_no_other_file(
    reported: Path, page: Page
) -> None:
    drawn = {file.stem for name in ["tables", "figures"] for file in (reported / name).iterdir()}
    ids = page.all_of("id")
    assert len(drawn) >= 9 and drawn <= set(ids)
    assert len(ids) == len(set(ids))
    for address in [*page.all_of("src"), *page.all_of("href")]:
        assert address.startswith(("data:", "#")), address[:80]
        assert not address.startswith("#") or address[1:] in ids


def test_every_picture_has_words_in_its_place(page: Page) -> None:
    pictures = [attributes for tag, attributes in page.tags if tag == "img" and "src" in attributes]
    assert len(pictures) == 5
    assert all(len(attributes["alt"] or "") > 50 for attributes in pictures)


def test_every_command_on_the_page_is_there(page: Page) -> None:
    commands = set(re.findall(r"python3 -m plots (\w+) --run", page.text))
    assert len(commands) > 8 and commands <= set(EVERYTHING)


def test_failed_skipped_and_left_out_are_all_on_the_page(page: Page) -> None:
    for words in [
        "ich/rocker-arm/src:4711: crashed", "fwp-ch/flat-grid/src:0: wrong answer",
        "stanford-bunny: not in the dataset cache", "Without a time ch: skipped on horse: ",
        "phases: no verified cell has phase_seconds", "3 answers failed or missing",
    ]:  # fmt: skip
        assert words in page.text


def test_words_of_a_result_file_are_never_markup(page: Page) -> None:
    assert "<script>alert(1)</script>" in page.text and "a < b & </table><img src=x>" in page.text
    assert "x" not in page.all_of("src")


def test_the_same_run_gives_the_same_page(golden_run: Run, tmp_path: Path) -> None:
    def made() -> str:
        (written, left_out), (figures, _) = (
            catalogue.draw_files(golden_run, tmp_path, [name]) for name in ("performance", "speedup")
        )
        return report.page(golden_run, written | figures, left_out)

    assert made() == made()


def test_cells_carry_the_number_they_are_sorted_by_and_their_footnote(golden_run: Run) -> None:
    table = Table(
        "t", "T", ["Model", "Time"], 1,
        [[Field("10 vertices", "horse"), Field("1,234", 1234, note="why")],
         [Field("knot"), Field("crashed")]],
    )  # fmt: skip
    page = Page(report.page(golden_run, {"t": table}, {}))
    cells = [attributes for tag, attributes in page.tags if tag == "td"]
    assert [cell.get("data-value") for cell in cells] == ["horse", "1234", None, None]
    assert "#t-a" in page.all_of("href") and "t-a" in page.all_of("id")
    assert "10 vertices horse 1,234" in page.text


@pytest.mark.parametrize("on_terminal", [True, False])
def test_a_terminal_shows_what_is_being_drawn(
    golden_run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, on_terminal: bool
) -> None:
    stream = io.StringIO()
    monkeypatch.setattr(stream, "isatty", lambda: on_terminal)
    monkeypatch.setattr(sys, "stderr", stream)
    catalogue.draw_files(golden_run, tmp_path, ["times", "solvers"])
    erase = console.ERASE_LINE
    shown = [f"{erase}drawing 1 of 2: times{erase}", f"{erase}drawing 2 of 2: solvers{erase}", erase]
    assert stream.getvalue() == ("".join(shown) if on_terminal else "")
