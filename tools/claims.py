#!/usr/bin/env python3
"""Lists measured figures of README.md and docs/ that no command makes. Ends with 1 when there is one.

A figure is a number with a unit of time, memory or proportion, or with a decimal point. It is backed by a
command in its section (from one heading to the next), or by a link in its paragraph to a section that has
a command and the number: to as many digits, as a percentage, or as the reciprocal, since 0.44 of the time is
2.3 times as fast. Everything on docs/results.md and between "Made by" and "End" is made from
results/contributed/. Definitions are no figures: words in `code`, limits such as 1e-12, and the levels of
intervals.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
GENERATED = "docs/results.md"
UNIT = r"(?:n|u|µ|m)?s|min(?:utes?)?|(?:micro|milli)?seconds?|hours?|[kKMG]i?B|bytes|%|times|million"
FIGURE = re.compile(
    rf"(?<![\w.^/-])(?P<first>\d[\d,]*(?:\.\d+)?)(?: (?:to|and|or) (?P<last>\d[\d,]*(?:\.\d+)?))? ?(?:{UNIT})(?!\w)"
    r"|(?<![\w.^/-])(?P<decimal>\d+\.\d+)(?![\w.])"
)
NO_FIGURE = re.compile(
    r"`[^`]*`|\]\([^)]*\)|<[^>]*>|[\d.]+% (?:bootstrap )?intervals?|(?:9[59]|99\.9)%"
    r"|(?:sections?|[Ff]igures?|[Tt]ables?|chapter|version|Debian|Python|GCC|CMake|Clang|future work) [\d.]+(?:(?: to |, | and )[\d.]+)*"
)
COMMAND = re.compile(
    r"(?:^|`)(?:time )?(?:[A-Z_]+=\S+ )*(?:\./\w+\.sh|(?:build/\w+/(?:tests/)?)?geodesic-(?:bench|microbench)|tools/\w+|tests/\S+\.\w+"
    r"|valgrind|venv/bin/python|/usr/bin/python3) "
)
NUMBER = re.compile(r"(?<![\w.])(\d[\d,]*(?:\.\d+)?(?:e-?\d+)?)(%?)(?!\w)")
LINK = re.compile(r"\]\((?P<page>[^)#\s]*)(?:#(?P<anchor>[^)\s]*))?\)")


@dataclass(frozen=True)
class Figure:
    text: str
    value: float
    half_digit: float
    """Half a unit of its last digit."""


@dataclass
class Section:
    """The lines from one heading to the next."""

    page: str
    heading: str = ""
    lines: list[tuple[int, str]] = field(default_factory=list)
    """With their numbers in the page; without code blocks and tables that a program makes."""
    made: list[str] = field(default_factory=list)
    """The lines of these tables."""
    has_command: bool = False

    @property
    def anchor(self) -> str:
        """The anchor that GitHub gives to the heading."""
        return re.sub(r"[^\w\- ]", "", self.heading.strip("# `").lower()).replace(" ", "-")

    @cached_property
    def values(self) -> list[float]:
        """All numbers of the section, and their reciprocals."""
        text = "\n".join([*(line for _, line in self.lines), *self.made])
        found = [_value(*match.groups()) for match in NUMBER.finditer(text)]
        return found + [1 / value for value in found if value]

    def has(self, figure: Figure) -> bool:
        return any(abs(value - figure.value) <= figure.half_digit * (1 + 1e-9) for value in self.values)


def sections(page: str, text: str) -> list[Section]:
    found = [Section(page)]
    in_code = made = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("```"):
            in_code = not in_code
        elif in_code or line.startswith("    "):
            found[-1].has_command |= COMMAND.match(line.strip()) is not None
        elif line.startswith("#"):
            found.append(Section(page, line))
        elif line.startswith(("<!-- Made by", "<!-- End")):
            made = line.startswith("<!-- Made by")
        else:
            found[-1].has_command |= COMMAND.search(line) is not None
            if made:
                found[-1].made.append(line)
            else:
                found[-1].lines.append((number, line))
    return found


def paragraphs(section: Section) -> Iterator[list[tuple[int, str]]]:
    """Yields the lines of each paragraph, list or table."""
    paragraph: list[tuple[int, str]] = []
    for number, line in [*section.lines, (0, "")]:
        if line:
            paragraph.append((number, line))
        elif paragraph:
            yield paragraph
            paragraph = []


def figures(line: str) -> list[Figure]:
    found = []
    for match in FIGURE.finditer(NO_FIGURE.sub(" ", line)):
        of = "%" if match[0].endswith("%") else ""
        found += [Figure(text + of, _value(text, of), _half_digit(text, of)) for text in match.groups() if text]
    return found


def _value(text: str, percent: str) -> float:
    return float(text.replace(",", "")) * (0.01 if percent else 1)


def _half_digit(text: str, percent: str) -> float:
    return _value(f"0.{'0' * len(text.partition('.')[2])}5", percent)


def unbacked(pages: dict[str, str]) -> list[str]:
    """@param pages texts by path, as in "docs/peers.md" """
    by_page = {page: sections(page, text) for page, text in pages.items()}
    found = []
    for page, its in by_page.items():
        if page == GENERATED:
            continue
        for section in its:
            if section.has_command:
                continue
            for paragraph in paragraphs(section):
                linked = list(_linked(page, "\n".join(line for _, line in paragraph), by_page))
                for number, line in paragraph:
                    lone = [one.text for one in figures(line) if not any(section.has(one) for section in linked)]
                    if lone:
                        found.append(f"{page}:{number}: no command makes {', '.join(lone)}")
    return found


def _linked(page: str, text: str, by_page: dict[str, list[Section]]) -> Iterator[Section]:
    for match in LINK.finditer(text):
        target = page if not match["page"] else str((Path(page).parent / match["page"]).as_posix())
        target = re.sub(r"[^/]+/\.\./", "", target)
        for section in by_page.get(target, ()):
            backed = section.has_command or target == GENERATED
            if backed and match["anchor"] in (None, section.anchor):
                yield section


def main() -> int:
    files = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
    found = unbacked({str(file.relative_to(ROOT)): file.read_text("utf-8") for file in files})
    print("\n".join(found) or "every figure has a command")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
