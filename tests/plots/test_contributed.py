"""The pages about the contributed results agree with these files."""

from __future__ import annotations

from pathlib import Path

import pytest

from plots import contributed
from results.reader import ResultError, Run


@pytest.fixture(scope="module")
def runs() -> dict[str, Run]:
    return contributed.newest()


def test_tables_of_pages_are_those_of_the_newest_results(runs: dict[str, Run]) -> None:
    for page, made in contributed.tables(runs).items():
        assert contributed.with_tables(page, made) == page.read_text("utf-8"), page


def test_a_page_without_its_marks_is_named(
    runs: dict[str, Run], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = tmp_path / "page.md"
    page.write_text("nothing to fill in", encoding="utf-8")
    monkeypatch.setitem(contributed.RESULTS, page, "results.md")
    with pytest.raises(ResultError, match="page.md: the marks of beside_public_codes are gone"):
        contributed.with_tables(page, contributed.tables(runs)[contributed.README])
