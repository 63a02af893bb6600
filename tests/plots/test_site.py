"""Pages of many runs: their contents, and that they work in a browser from disk."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import pytest

from plots import site
from results import merge
from results.columns import Columns
from results.reader import read_run

GOLDEN = Path(__file__).parent / "golden" / "run" / "run.json"
PHONE = 360
"""Width of a phone, in pixels."""


def a_run(file: Path, change: Callable[[dict[str, Any], list[dict[str, Any]]], None]) -> Path:
    """@param change gets the context and the rows of a copy of the golden run"""
    data = json.loads(GOLDEN.read_text())
    change(data["context"]["geodesic_bench"], data["benchmarks"])
    file.write_text(json.dumps(data))
    return file


def faster(ours: dict[str, Any], rows: list[dict[str, Any]]) -> None:
    ours |= {"started": "2026-03-02T03:04:05Z", "revision": "f" * 40}
    for row in rows:
        if row["solver"] == "mmp" and "cpu_time" in row:
            row["cpu_time"] *= 0.5


def elsewhere(ours: dict[str, Any], rows: list[dict[str, Any]]) -> None:
    ours |= {"started": "2026-02-02T03:04:05Z", "processor": "Another processor"}


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Pages of three runs: two revisions on one processor, and another processor."""
    folder = tmp_path_factory.mktemp("many runs")
    runs = [a_run(folder / "b.json", faster), a_run(folder / "c.json", elsewhere)]
    shutil.copy(GOLDEN, folder / "a.json")
    out = folder / "site"
    assert site.main([*map(str, [*runs, folder / "a.json"]), "--out", str(out)]) == 0
    return out


class Links(HTMLParser):
    def __init__(self, page: Path) -> None:
        super().__init__()
        self.found: list[str] = []
        self.feed(page.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.found += [value for key, value in attributes if key in ("href", "src") and value]


def test_every_link_leads_to_a_file_of_the_site(pages: Path) -> None:
    every = list(pages.rglob("*.html"))
    assert len(every) == 1 + 7 + 3, "no page of accuracy against time, which would be empty"
    for page in every:
        for link in Links(page).found:
            if not link.startswith(("data:", "#")):
                assert (page.parent / unquote(link)).is_file(), f"{page.name}: {link}"


def test_the_raw_file_of_every_run_is_there_unchanged(pages: Path) -> None:
    raw = sorted(pages.glob("runs/*/run.json"))
    assert len(raw) == 3
    assert GOLDEN.read_bytes() in [file.read_bytes() for file in raw]


def test_the_rows_of_a_run_in_columns_are_there_too(tmp_path: Path) -> None:
    data = json.loads(GOLDEN.read_text())
    file = merge.write(data["context"], Columns.of(data["benchmarks"]), tmp_path, 0)
    assert site.main([str(file), "--out", str(tmp_path / "site")]) == 0
    [raw] = tmp_path.glob("site/runs/*")
    assert list(read_run(raw).rows) == list(read_run(GOLDEN).rows)


def test_a_history_compares_runs_on_one_processor(pages: Path) -> None:
    table = site.history_table(site.history(entries_of(pages, "mmp")))
    shown = [(row[0].text, row[2].text, row[5].text.split()[0]) for row in table.rows]
    assert sorted(shown) == [
        ("Another processor", "2026-02-02", "1.000"),
        ("Some processor", "2026-01-02", "1.000"),
        ("Some processor", "2026-03-02", "0.500"),
    ]


def test_rows_of_two_runs_are_told_apart_and_what_is_alike_stands_above(tmp_path: Path) -> None:
    files = [tmp_path / name / "run.json" for name in ("a/mine", "b/mine", "c/yours")]
    for file in files:
        file.parent.mkdir(parents=True)
        shutil.copy(GOLDEN, file)
    runs = site.shown(map(read_run, files))
    assert [one.label for one in runs] == ["mine", "mine (2)", "yours"]
    table = site.results("results", "Results", site.entries(runs), "")
    column = table.header.index("Run")
    assert {row[column].text for row in table.rows} == {"mine", "mine (2)", "yours"}
    assert not {"Processor", "Revision", "Date"} & set(table.header)
    assert table.remarks[0].startswith("In all rows: Processor Some processor; Revision 0123456789")


def entries_of(pages: Path, solver: str) -> list[site.Entry]:
    runs = site.shown(read_run(file) for file in pages.glob("runs/*/run.json"))
    return [entry for entry in site.entries(runs) if entry.solver.name == solver]


@pytest.mark.parametrize("text", ["", "{", '{"context": {}, "benchmarks": []}'])
def test_a_broken_file_is_one_line_and_an_exit_code(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], text: str
) -> None:
    file = tmp_path / "broken.json"
    file.write_text(text)
    assert site.main([str(file), "--out", str(tmp_path / "site")]) == 1
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and str(file) in said
    assert not (tmp_path / "site").exists()


@pytest.fixture
def address(pages: Path) -> str:
    return (pages / "index.html").as_uri()


def rows(page: Any) -> list[list[str]]:
    script = """return [...document.querySelectorAll('#results tbody tr')].filter(row => !row.hidden)
        .map(row => [...row.cells].map(cell => cell.innerText.trim()))"""
    return [[str(text) for text in row] for row in page.execute_script(script)]


def press(page: Any, *keys: str) -> None:
    from selenium.webdriver.common.action_chains import ActionChains

    ActionChains(page).send_keys(*keys).perform()


def test_rows_are_filtered_by_words_with_the_keyboard_alone(page: Any) -> None:
    from selenium.webdriver.common.keys import Keys

    whole = rows(page)
    press(page, *[Keys.TAB] * 2, "MMP horse another")
    left = rows(page)
    assert 0 < len(left) < len(whole)
    assert left == [row for row in whole if "mmp" in row[1] and row[0] == "horse" and "Another" in row[3]]
    assert f"{len(left)} of {len(whole)}" in page.page_source
    press(page, *[Keys.BACKSPACE] * 20)
    assert rows(page) == whole


def test_a_filtered_table_is_sorted_too(page: Any) -> None:
    from selenium.webdriver.common.by import By

    page.find_element(By.CSS_SELECTOR, ".filter input").send_keys("edge-based some")
    for button in page.find_elements(By.CSS_SELECTOR, "#results thead button"):
        if button.text.startswith("Time (ms)"):
            button.click()
    times = [float(row[6]) for row in rows(page)]
    assert len(times) > 2 and times == sorted(times)


def test_links_lead_to_pages_with_figures_that_open(page: Any, pages: Path) -> None:
    from selenium.webdriver.common.by import By

    page.find_element(By.LINK_TEXT, "mmp").click()
    assert page.title == "mmp"
    page.find_element(By.CSS_SELECTOR, "figure button").click()
    large = page.find_element(By.CSS_SELECTOR, "dialog img")
    assert page.execute_script("return arguments[0].naturalWidth", large) > 500
    page.find_element(By.CSS_SELECTOR, "dialog button").click()
    page.find_element(By.LINK_TEXT, "All results").click()
    assert page.current_url == (pages / "index.html").as_uri()


@pytest.mark.parametrize("name", ["index.html", "solvers/edge-based.html"])
def test_nothing_is_wider_than_a_phone(
    page: Any, pages: Path, with_width: Callable[[int], None], name: str
) -> None:
    with_width(PHONE)
    page.get((pages / name).as_uri())
    assert page.execute_script("return document.documentElement.scrollWidth") <= PHONE
