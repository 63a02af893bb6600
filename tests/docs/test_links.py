"""The targets of links and paths in the documentation exist."""

from __future__ import annotations

import re
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from pages import ROOT, checkout_files

FENCED = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
ELSEWHERE = re.compile(r"[a-z]+:")
MADE_LATER = re.compile(r"(build|datasets/cache|results/(runs|ranks))\b|.*\bmy[-_]|.*[<*{]")
"""Paths that a fresh checkout does not contain, because commands or readers make them."""


PAGES = [ROOT / name for name in checkout_files("*.md")]


@cache
def anchors(page: Path) -> set[str]:
    """Returns the anchors of the headings. They have the form that GitHub uses."""
    found: Counter[str] = Counter()
    names = set()
    text = FENCED.sub("", page.read_text("utf-8"))
    for heading in re.findall(r"^#+ +(.+?)\s*$", text, re.MULTILINE):
        words = LINK.sub(lambda link: link[0][1 : link[0].index("]")], heading)
        slug = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        names.add(f"{slug}-{found[slug]}" if found[slug] else slug)
        found[slug] += 1
    return names


def dead_links(page: Path) -> list[str]:
    dead = []
    for link in LINK.findall(CODE.sub("", FENCED.sub("", page.read_text("utf-8")))):
        if ELSEWHERE.match(link):
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.exists() or (anchor and anchor not in anchors(target)):
            dead.append(link)
    return dead


def dead_paths(page: Path) -> list[str]:
    """Returns the words in code style that begin with a folder of this checkout but are no existing path."""
    folders = {path.name for path in ROOT.iterdir() if path.is_dir()}
    words = CODE.findall(FENCED.sub("", page.read_text("utf-8")))
    paths = [word for word in words if "/" in word and word.split("/")[0] in folders]
    return [p for p in paths if " " not in p and not MADE_LATER.match(p) and not (ROOT / p).exists()]


@pytest.mark.parametrize("page", PAGES, ids=[str(page.relative_to(ROOT)) for page in PAGES])
def test_every_link_and_path_of_the_page_leads_somewhere(page: Path) -> None:
    assert (dead_links(page), dead_paths(page)) == ([], [])


def test_dead_links_and_paths_are_found(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "# One `two`, three\n## Again\n## Again\n"
        "[here](#one-two-three) [twice](#again-1) [file](page.md#again) [site](https://x.org/y)\n"
        "[no anchor](#one) [no file](gone.md) [no anchor there](page.md#again-2)\n"
        "`solvers/core/solver.h` `solvers/gone.h` `build/release/x` `solvers/my_variant` `a/b`\n"
        "```sh\n[not a link](in-code.md)\n```\n"
    )
    assert dead_links(page) == ["#one", "gone.md", "page.md#again-2"]
    assert dead_paths(page) == ["solvers/gone.h"]
