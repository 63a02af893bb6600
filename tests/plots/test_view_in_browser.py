"""The page of `geodesic-bench view` in a browser: it loads alone, draws, plays and turns."""

from __future__ import annotations

import io
import subprocess
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread
from synthetic import mean_edge_length, torus

from plots.recordings import Recording
from results.reader import Mesh, Run
from view import __main__ as command

pytest.importorskip("selenium", reason="python3-selenium is not installed")
import chromium
from selenium.webdriver.common.by import By
from selenium.webdriver.support.wait import WebDriverWait

pytestmark = pytest.mark.usefixtures("with_three")
SECONDS = 60
"""Time limit for a software renderer on a busy machine."""


@pytest.fixture(scope="module", autouse=True)
def small_window(browser: Any) -> Iterator[None]:
    """A software renderer takes seconds for a large picture."""
    size = browser.get_window_size()
    browser.set_window_size(600, 600)
    yield
    browser.set_window_size(size["width"], size["height"])


def until(holds: Callable[[], object]) -> None:
    WebDriverWait(None, SECONDS, 0.05).until(lambda _: holds())


def is_drawn(page: Any) -> bool:
    return bool(page.execute_script("return document.body.dataset.rests === 'true'"))


def picture(page: Any) -> Any:
    """Returns a picture of the models at rest."""
    until(lambda: is_drawn(page))
    return imread(io.BytesIO(page.find_element(By.ID, "views").screenshot_as_png))[:, :, :3]


def press(page: Any, key: str) -> None:
    page.execute_script(
        "document.body.dispatchEvent(new KeyboardEvent('keydown', {key: arguments[0], bubbles: true}))",
        key,
    )


def frame(page: Any) -> int:
    return int(page.find_element(By.ID, "frame").get_property("value"))


@pytest.fixture(scope="module")
def address(complete_run: Run, tmp_path_factory: pytest.TempPathFactory) -> str:
    file = tmp_path_factory.mktemp("view") / "a page.html"
    words = [str(complete_run.file.parent), "--solvers", "mmp,edge-based", "--mesh", "flat-grid"]
    assert command.main([*words, "--output", str(file)]) == 0
    return file.as_uri()


def test_it_is_drawn_without_any_request(page: Any) -> None:
    shown = picture(page)
    assert (shown < 0.95).any(axis=2).mean() > 0.05
    asked = "return performance.getEntriesByType('resource').map(entry => entry.name)"
    assert [name for name in page.execute_script(asked) if not name.startswith("data:")] == []
    licence = page.find_element(By.CSS_SELECTOR, "footer pre").get_property("textContent")
    assert "The MIT License" in licence and "three.js authors" in licence


@pytest.mark.usefixtures("browser")
def test_a_screenshot_that_waits_for_the_load_alone_shows_the_model(address: str, tmp_path: Path) -> None:
    words = [str(chromium.BROWSER), "--headless", "--no-sandbox", "--disable-gpu", "--window-size=600,600"]
    subprocess.run([*words, "--screenshot=shot.png", address], cwd=tmp_path, capture_output=True, timeout=SECONDS)
    shown = imread(tmp_path / "shot.png")[:, :, :3]
    assert (np.ptp(shown, axis=2) > 0.1).mean() > 0.05, "no colours of distances"


def test_the_slider_and_the_keys_change_the_frame_and_what_is_seen(page: Any) -> None:
    before, start = picture(page), frame(page)
    numbers = page.find_element(By.CSS_SELECTOR, ".panel p").text
    press(page, ".")
    assert frame(page) == start + 1
    for _ in range(12):
        press(page, ".")
    assert page.find_element(By.CSS_SELECTOR, ".panel p").text != numbers
    assert (picture(page) != before).any(axis=2).mean() > 0.005
    for _ in range(13):
        press(page, ",")
    assert frame(page) == start and (picture(page) == before).all()


def test_it_plays_to_the_end_and_stops(page: Any) -> None:
    until(lambda: is_drawn(page))
    start, last = frame(page), int(page.find_element(By.ID, "frame").get_property("max"))
    press(page, " ")
    until(lambda: start < frame(page) < last)
    until(lambda: frame(page) == last)
    until(lambda: page.find_element(By.ID, "play").get_attribute("aria-label") == "Play")


def test_arrow_keys_turn_the_model_and_0_turns_it_back(page: Any) -> None:
    before = picture(page)
    press(page, "ArrowRight")
    press(page, "ArrowUp")
    assert (picture(page) != before).any(axis=2).mean() > 0.01
    press(page, "0")
    assert np.abs(picture(page) - before).max() < 0.02


def test_choices_change_what_is_seen(page: Any) -> None:
    before = picture(page)
    for name in ("isolines", "paths", "edges of the mesh", "wavefront"):
        page.find_element(By.CSS_SELECTOR, f"input[name='{name}']").click()
        now = picture(page)
        assert (now != before).any(axis=2).mean() > 0.001, name
        before = now
    for name in ("cells", "none", "distance"):
        page.find_element(By.XPATH, f"//fieldset[@id='colour']/label[.='{name}']/input").click()
        now = picture(page)
        assert (now != before).any(axis=2).mean() > 0.02, name
        before = now
    panels = page.find_elements(By.CLASS_NAME, "panel")
    page.find_element(By.CSS_SELECTOR, "#shown input").click()
    assert [panel.is_displayed() for panel in panels] == [False, True]


@pytest.mark.parametrize("width", [400, 1280])
def test_nothing_overlaps_or_reaches_over_the_edge(
    page: Any, with_width: Callable[[int], None], width: int
) -> None:
    with_width(width)
    assert (picture(page) < 0.95).any(axis=2).mean() > 0.03
    boxes, scroll = page.execute_script(
        """const all = '.panel h2, .panel p, .stage, .play > *, fieldset, #legend, .help, h1';
           return [[...document.querySelectorAll(all)].map(element => {
             const {left, top, right, bottom} = element.getBoundingClientRect();
             return [left, top, right, bottom];
           }), document.documentElement.scrollWidth]"""
    )
    assert scroll <= width and all(left >= 0 and right <= width for left, _, right, _ in boxes)
    for i, (left, top, right, bottom) in enumerate(boxes):
        for a, b, c, d in boxes[:i]:
            assert right <= a + 1 or c <= left + 1 or bottom <= b + 1 or d <= top + 1


def test_100_000_faces_are_drawn_and_turned(browser: Any, tmp_path: Path) -> None:
    vertices, faces = torus(316, 159)
    assert len(faces) > 100_000
    folder = tmp_path / "recordings" / "torus" / "src0"
    folder.mkdir(parents=True)
    np.save(folder.parent / "vertices.npy", vertices.astype("<f4"))
    np.save(folder.parent / "faces.npy", faces.astype("<u4"))
    np.save(folder / "distances.npy", np.linalg.norm(vertices - vertices[0], axis=1))
    edge = mean_edge_length(vertices, faces)
    mesh = Mesh("torus", "", len(vertices), len(faces), edge, None, False)
    command.write(Recording(mesh, 0, [0], folder, {}), [], None, "the test", tmp_path / "torus.html")
    browser.get((tmp_path / "torus.html").as_uri())
    before = picture(browser)
    press(browser, "ArrowRight")
    assert (picture(browser) != before).any(axis=2).mean() > 0.02


def test_without_webgl_one_line_says_so(browser: Any, address: str) -> None:
    without = {"source": "HTMLCanvasElement.prototype.getContext = () => null"}
    added = browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", without)
    try:
        browser.get(address)
        message = browser.find_element(By.ID, "message")
        until(message.is_displayed)
        assert "WebGL" in message.text and "\n" not in message.text
        assert not browser.find_element(By.ID, "views").is_displayed()
    finally:
        browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)
