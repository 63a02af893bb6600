"""Which solvers have the same machine code in two builds: the same bytes in their object files.

Objects depend neither on the place of the tree nor on its revision. A solver is called by the shared
code in solvers/core and solvers/paths; a family calls no other family (docs/architecture.md).
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection
from hashlib import sha256
from pathlib import Path

from results.names import registered

SHARED = "CMakeFiles"
"""The folder under solvers/ in a build with the objects of the shared code."""


def unchanged(base: Path, head: Path, tree: Path, solvers: Collection[str]) -> set[str]:
    """Returns those of the solvers whose machine code is the same. A solver outside the families,
    such as a variant, needs all objects to be the same. Builds without a list of objects have none.

    @param base, head folders of the builds
    @param tree the head's sources"""
    old, new = _objects(base), _objects(head)
    present = {Path(name).parts[1] for name in new}
    differ = {Path(name).parts[1] for name, _ in old.items() ^ new.items()}
    folders = {name: file.parent for name, file in registered(tree).items()}

    def same(solver: str) -> bool:
        folder = folders.get(solver.split("?")[0])
        if folder is None or folder.parent != tree / "solvers":
            return bool(present) and not differ
        return {SHARED, folder.name} <= present - differ

    return {solver for solver in solvers if same(solver)}


def _objects(build: Path) -> dict[str, bytes]:
    """Returns the checksum of each object under solvers/ that the build contains. A folder also keeps
    objects of files that are gone, so the build's own list is read."""
    try:
        listed = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
        outputs = [re.search(r" -o (solvers/\S+\.o) ", one["command"]) for one in listed]
        names = [output[1] for output in outputs if output]
        return {name: sha256((build / name).read_bytes()).digest() for name in names}
    except (OSError, ValueError, KeyError, TypeError):
        return {}
