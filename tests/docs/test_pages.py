"""Tests follow the tutorials. A wrong page fails at the right line."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from pages import ROOT, Checkout, PageError, blocks, follow

PAGES = ["adding-a-solver.md", "adding-a-mesh.md", "adding-a-figure.md", "python.md",
         "external-solvers.md"]  # fmt: skip


@pytest.mark.parametrize("page", PAGES)
def test_the_page_does_what_it_says(page: str, checkout: Checkout) -> None:
    before = set(os.listdir(checkout.folder))
    follow(ROOT / "docs" / page, checkout.folder, checkout.environment)
    if page == "python.md":
        made = set(os.listdir(checkout.folder)) - before - {"geodesic_bench", "scan.ply"}  # by the test only
        assert made > {"venv", "first-run", "path.png"} and made == ignored_by_git(made)


def ignored_by_git(names: set[str]) -> set[str]:
    command = ["git", "-C", str(ROOT), "check-ignore", "--stdin"]
    return set(subprocess.run(command, input="\n".join(names), capture_output=True, text=True).stdout.split())


def follow_text(text: str, folder: Path) -> None:
    page = folder / "page.md"
    page.write_text(text)
    follow(page, folder, dict(os.environ))


def test_blocks_are_done_in_order_in_one_folder(tmp_path: Path) -> None:
    follow_text(
        "Make it:\n```text notes/a.txt\none\n```\nChange it:\n"
        "```diff\n--- a/notes/a.txt\n+++ b/notes/a.txt\n@@ -1 +1,2 @@\n one\n+two\n```\n"
        "```sh\ncat notes/a.txt\n```\nwhich prints\n```text\none\ntwo\n```\n",
        tmp_path,
    )


@pytest.mark.parametrize(
    ("said", "printed"),
    [
        ("took ... s", "took 3.2 s"),
        ("first\n...\nlast", "first\na\nb\nlast"),
        ("first\n...\nlast", "first\nlast"),
        ("a b", "a b  \n\n"),
    ],
)
def test_dots_stand_for_what_varies(said: str, printed: str, tmp_path: Path) -> None:
    follow_text(f"```sh\nprintf '%s\\n' '{printed}'\n```\n```text\n{said}\n```\n", tmp_path)


@pytest.mark.parametrize(
    ("said", "printed"),
    [("one", "two"), ("one", "one\ntwo"), ("one\ntwo", "one"), ("a.c", "abc"), ("a ... c", "a\nc")],
)
def test_other_output_than_the_page_shows_is_an_error(
    said: str, printed: str, tmp_path: Path
) -> None:
    with pytest.raises(PageError, match=r"page\.md:6: is not what was printed:\n"):
        follow_text(
            f"Words.\n\n```sh\nprintf '%s\\n' '{printed}'\n```\n```text\n{said}\n```\n".replace(
                printed, printed.replace("\n", "' '"), 1
            ),
            tmp_path,
        )


@pytest.mark.parametrize(
    ("block", "message"),
    [
        ("```sh\necho why >&2\nfalse\ntrue\n```\n", "exit code 1:\nwhy"),
        ("```sh\nfalse | true\n```\n", "exit code 1"),
        ("```sh\necho $no_such_name\n```\n", "no_such_name"),
        ("```diff\n--- a/gone\n+++ b/gone\n@@ -1 +1 @@\n-x\n+y\n```\n", "gone"),
    ],
)
def test_what_fails_is_named_with_page_and_line(block: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(PageError, match=r"page\.md:2: ") as caught:
        follow_text(f"Words.\n{block}", tmp_path)
    assert message in str(caught.value)


def test_a_stand_in_is_done_in_place_of_its_block_and_of_no_other(tmp_path: Path) -> None:
    follow_text(
        "<!-- The test does this instead, since a build takes minutes:\n"
        "touch built\n-->\n```sh\nexit 1\n```\n```text\nbuilt in 100 s\n```\n"
        "```sh\nls built\n```\n```text\nbuilt\n```\n",
        tmp_path,
    )


@pytest.mark.parametrize("page", PAGES)
def test_no_fence_of_a_page_is_overlooked(page: str) -> None:
    text = (ROOT / "docs" / page).read_text("utf-8")
    fences = sum(line.startswith("```") for line in text.splitlines())
    assert fences == 2 * len(blocks(text)) > 0
    assert text.count("<!--") == sum(block.instead is not None for block in blocks(text))
