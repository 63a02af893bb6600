"""The report in a browser: it opens from disk, sorts tables, shows a figure and fits a phone."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("selenium", reason="python3-selenium is not installed")
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys


@pytest.fixture(scope="module")
def address(reported: Path) -> str:
    return (reported / "report.html").as_uri()


def column(page: Any, table: str, index: int) -> list[str]:
    script = """return [...document.querySelectorAll(`#${arguments[0]} tbody tr`)]
        .map(row => row.cells[arguments[1]].innerText.trim())"""
    return [str(text) for text in page.execute_script(script, table, index)]


def header(page: Any, table: str, index: int) -> Any:
    return page.find_elements(By.CSS_SELECTOR, f"#{table} thead th")[index]


@pytest.mark.parametrize(
    ("index", "numbers", "without"),
    [(2, ["441", "10,044", "48,485"], []), (5, ["48,484", "241,056"], [""])],
    ids=["n", "n, published"],
)
def test_numbers_sort_as_numbers_up_and_down_and_back(
    page: Any, index: int, numbers: list[str], without: list[str]
) -> None:
    original = column(page, "strip_depth", index)
    states = []
    for _ in range(3):
        clicked = header(page, "strip_depth", index)
        clicked.find_element(By.TAG_NAME, "button").click()
        states.append((clicked.get_attribute("aria-sort"), column(page, "strip_depth", index)))
    assert states == [
        ("ascending", [*numbers, *without]),
        ("descending", [*numbers[::-1], *without]),
        ("none", original),
    ]


def test_sorted_rows_say_which_model_they_belong_to(page: Any) -> None:
    assert "" in column(page, "performance", 0)
    header(page, "performance", 2).find_element(By.TAG_NAME, "button").click()
    labels = column(page, "performance", 0)
    assert "horse" in labels and "" not in labels


def test_the_keyboard_sorts_and_one_column_at_a_time_is_sorted(page: Any) -> None:
    for index in (0, 2):
        header(page, "strip_depth", index).find_element(By.TAG_NAME, "button").send_keys(Keys.ENTER)
    states = [header(page, "strip_depth", i).get_attribute("aria-sort") for i in (0, 2)]
    assert states == ["none", "ascending"]


def test_a_click_shows_a_figure_at_full_size_and_escape_closes_it(page: Any) -> None:
    dialog = page.find_element(By.TAG_NAME, "dialog")
    assert not dialog.is_displayed()
    button = page.find_element(By.CSS_SELECTOR, "#speedup button")
    shown = button.find_element(By.TAG_NAME, "img").size["width"]
    button.click()
    assert dialog.is_displayed()
    large = dialog.find_element(By.TAG_NAME, "img")
    assert large.size["width"] > 1.5 * shown > 300
    assert "Speed-up" in dialog.text
    page.switch_to.active_element.send_keys(Keys.ESCAPE)
    assert not dialog.is_displayed()


def test_every_picture_is_drawn(page: Any) -> None:
    widths = page.execute_script(
        "return [...document.querySelectorAll('figure img')].map(image => image.naturalWidth)"
    )
    assert len(widths) == 5 and min(widths) > 1000


@pytest.mark.parametrize("width", [360, 768, 1280])
def test_nothing_reaches_over_the_edge_of_the_page(
    page: Any, with_width: Callable[[int], None], width: int
) -> None:
    with_width(width)
    inner, scroll, outside = page.execute_script(
        """const outside = [...document.querySelectorAll('body *')].filter(element =>
             !element.closest('.scroll table, dialog')
             && element.getBoundingClientRect().right > innerWidth + 1);
           return [innerWidth, document.documentElement.scrollWidth,
                   outside.map(element => element.outerHTML.slice(0, 80))]"""
    )
    assert inner == width and scroll <= width
    assert outside == []


def test_the_table_of_results_is_as_wide_as_the_page(page: Any) -> None:
    """At 1280 pixels all its solvers and numbers are visible without horizontal scrolling."""
    shown, all_of_it = page.execute_script(
        """const box = document.querySelector('#summary_by_mesh .scroll');
           return [box.clientWidth, box.scrollWidth]"""
    )
    assert 0 < all_of_it <= shown


def test_in_print_headers_have_words_and_what_is_for_clicking_is_gone(page: Any) -> None:
    page.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        words = page.execute_script(
            """const header = document.querySelector('#strip_depth thead th');
               return getComputedStyle(header, '::before').content"""
        )
        assert json.loads(words) == "Model"
        assert not page.find_element(By.TAG_NAME, "nav").is_displayed()
    finally:
        page.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
