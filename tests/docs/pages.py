"""Reads pages of docs/ that contain commands, and follows them in a copy of the checkout.

The fenced blocks of a page are:

- ```sh: Bash runs it in the root of the checkout. The exit code must be 0. The output is that of
  both streams.
- ```text right after it: the complete output. In it, ... stands for any text in a line, and a line
  that is only ... stands for any number of lines.
- ```diff: a change to files, applied with git.
- a block whose first line names a language and a path, as in ```python plots/x.py: a complete file.

Other blocks have no effect. If a command takes minutes, a comment right before its block contains the
commands that the test runs instead, and the reason. The output is then not compared:

    <!-- The test does this instead, since a build takes minutes:
    commands
    -->
"""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

BLOCK = re.compile(
    r"^(?:<!-- The test does this instead, since [^\n]+:\n(?P<instead>.*?)^-->\n)?"
    r"^```(?P<language>\w+)(?: (?P<path>\S+))?\n(?P<text>.*?)^```$",
    re.MULTILINE | re.DOTALL,
)


class PageError(Exception):
    """A page is wrong. The message is "docs/page.md:12: what happened"."""


@dataclass(frozen=True)
class Block:
    line: int
    """Line of the opening fence, counted from 1."""
    language: str
    path: str | None
    text: str
    instead: str | None


@dataclass(frozen=True)
class Checkout:
    folder: Path
    environment: dict[str, str]


def blocks(page: str) -> list[Block]:
    return [
        Block(
            line=page.count("\n", 0, match.start("language")) + 1,
            language=match["language"],
            path=match["path"],
            text=match["text"],
            instead=match["instead"],
        )
        for match in BLOCK.finditer(page)
    ]


def checkout_files(pattern: str = "*") -> list[Path]:
    """Returns the files that git tracks or would track, relative to the root of the checkout."""
    command = ["git", "-C", str(ROOT), "ls-files", "-z", "--cached", "--others"]
    command += ["--exclude-standard", pattern]
    listed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    files = [Path(name) for name in listed.split("\0") if name]
    return [file for file in files if (ROOT / file).is_file()]  # a file may have been removed


def copy_checkout(target: Path) -> None:
    for name in checkout_files():
        file = target / name
        file.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, file)


def follow(page: Path, checkout: Path, environment: dict[str, str]) -> None:
    """Follows the blocks of a page in order. Raises PageError at the first block that fails or whose output
    differs."""
    printed: str | None = None
    for block in blocks(page.read_text("utf-8")):
        try:
            if block.language == "text" and printed is not None:
                _compare(block.text, printed)
            printed = _do(block, checkout, environment)
        except PageError as error:
            where = page.relative_to(ROOT) if page.is_relative_to(ROOT) else page
            raise PageError(f"{where}:{block.line}: {error}") from None


def _do(block: Block, checkout: Path, environment: dict[str, str]) -> str | None:
    """Follows a block. Returns its output if it must be compared with the page, otherwise None."""
    if block.path is not None:
        file = checkout / block.path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(block.text, "utf-8")
    elif block.language == "diff":
        _run(["git", "apply", "-"], checkout, environment, block.text)
    elif block.language == "sh":
        script = block.text if block.instead is None else block.instead
        output = _run(["bash", "-euo", "pipefail", "-c", script], checkout, environment)
        return output if block.instead is None else None
    return None


def _run(command: list[str], folder: Path, environment: dict[str, str], words: str = "") -> str:
    ended = subprocess.run(
        command, cwd=folder, env=environment, input=words, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=600,
    )  # fmt: skip
    if ended.returncode != 0:
        raise PageError(f"ends with exit code {ended.returncode}:\n{ended.stdout}")
    return ended.stdout


def _compare(said: str, printed: str) -> None:
    if re.fullmatch("".join(_patterns(said)), _without_trailing_blanks(printed)) is None:
        raise PageError(f"is not what was printed:\n{printed}")


def _patterns(said: str) -> Iterator[str]:
    for line in _without_trailing_blanks(said).splitlines():
        if line == "...":
            yield r"(?:[^\n]*\n)*?"
        else:
            yield ".*".join(map(re.escape, line.split("..."))) + r"\n"


def _without_trailing_blanks(text: str) -> str:
    return "".join(f"{line.rstrip()}\n" for line in text.rstrip().splitlines())
