"""`geodesic-bench merge`: joins the shards of a run (`geodesic-bench run --shard K/N`) into one.

Shards belong together when they had the same suite, program and meshes. The rows of the merged
run.json are those of the run in one piece, in its order; each says on which processor it was
measured, where there are several.
"""

from __future__ import annotations

import argparse
import json
import os
import shlex
import shutil
import sys
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench merge")  # before imports that may fail

import numpy as np

from results import environment
from results.checksum import computed, of_file
from results.columns import Columns
from results.reader import ResultError, Run, Source, read_file

MUCH = 20_000_000
"""Total bytes of run.json files above which several processes read them. One process reads fewer faster."""
MOST_IN_JSON = 50_000
"""Largest number of rows in JSON. More are written as columns, read in a tenth of the time and memory."""
RUN, ROWS, REQUEST = "run.json", "rows.npz", "request.json"
RECORDINGS, SOURCES = "recordings", "sources"
BELONGING = {
    "suite": "its solvers, options or suite differ",
    "program": "another build of geodesic-bench, or other plug-ins, measured it",
    "meshes": "it was planned for other meshes, or files of other sizes",
}
"""Keys that all shards of a run have in common, and the meaning of a difference."""
VISIBLE = ("revision", "corpus", "seed", "repetitions", "time_limit")
"""Keys of the context that may show how two shards differ."""


@dataclass(frozen=True)
class Part:
    """A shard and its folder."""

    folder: Path
    run: Run

    @property
    def shard(self) -> dict[str, Any]:
        return self.run.ours["shard"]  # type: ignore[no-any-return]

    @property
    def index(self) -> int:
        return int(self.shard["index"])

    def described(self, out: Path) -> dict[str, Any]:
        """Returns the entry of this shard in the merged file."""
        ours = self.run.ours
        found = {
            "shard": self.index,
            "folder": os.path.relpath(self.folder, out),
            "sha256": of_file(self.run.file),
            "host": str(self.run.context.get("host_name", "")),
            "processors": self.run.processors or [ours["processor"]],
        }
        keys = ("started", "finished", "memory_limit", "command")
        return found | {key: ours[key] for key in keys if key in ours}


def folders_of(words: Iterable[Path]) -> Iterator[Path]:
    """Yields the run folders. A word names a run folder or a folder that contains run folders.

    @raises ResultError for a word that names neither"""
    for word in words:
        if not word.is_dir():
            raise ResultError(f"{word}: no such folder")
        if _holds_run(word / "shards"):  # the folder of a run that was merged before
            word = word / "shards"
        if _is_run(word):
            yield word
        elif _holds_run(word):
            yield from sorted(filter(_is_run, word.iterdir()))
        else:
            raise ResultError(f"{word}: neither the folder of a run nor one with such folders in it")


def _is_run(folder: Path) -> bool:
    return (folder / RUN).is_file() or (folder / REQUEST).is_file()


def _holds_run(folder: Path) -> bool:
    return folder.is_dir() and any(map(_is_run, folder.iterdir()))


def read_parts(folders: Sequence[Path]) -> tuple[list[Part], list[Path]]:
    """Returns the shards, ordered by index, and the folders of the unfinished shards.

    @raises ResultError when shards do not belong together or overlap"""
    unfinished = [folder for folder in folders if not (folder / RUN).is_file()]
    finished = [folder for folder in folders if folder not in unfinished]
    parts: list[Part] = []
    for part in _read_all(finished):
        _check_belongs(part, parts)
        parts.append(part)
    return sorted(parts, key=lambda part: part.index), unfinished


def _read(folder: Path) -> Part:
    return Part(folder, read_file(folder / RUN))


def _read_all(folders: Sequence[Path]) -> Iterator[Part]:
    """Reads the shards, with several processes if there is much to read."""
    if sum((folder / RUN).stat().st_size for folder in folders) < MUCH:
        yield from map(_read, folders)
        return
    with ProcessPoolExecutor() as pool:
        yield from pool.map(_read, folders)


def _check_belongs(part: Part, parts: Sequence[Part]) -> None:
    file, shard = part.run.file, part.run.shard
    if shard is None:
        raise ResultError(f"{file}: not a shard of a run: run --shard K/N makes them")
    if not 1 <= shard["index"] <= shard["of"]:
        raise ResultError(f"{file}: shard {shard['index']} of {shard['of']}")
    for other in parts[:1]:
        if shard["of"] != other.shard["of"]:
            raise ResultError(
                f"{file} is one of {shard['of']} shards, and {other.run.file} of {other.shard['of']}"
            )
        for key, why in BELONGING.items():
            if shard[key] != other.shard[key]:
                raise ResultError(
                    f"{file} does not belong to {other.run.file}: {why}{_seen(part, other)}"
                )
    for other in parts:
        if shard["index"] == other.index:
            raise ResultError(
                f"shard {part.index}/{shard['of']} is in both {other.folder} and {part.folder}"
            )


def _seen(part: Part, other: Part) -> str:
    """Returns the differences that the context shows, as in " (seed: 2, not 1)"; may be empty."""
    ours, theirs = part.run.ours, other.run.ours
    found = [
        f"{key}: {ours.get(key)}, not {theirs.get(key)}"
        for key in VISIBLE
        if ours.get(key) != theirs.get(key)
    ]
    if part.run.solvers.keys() != other.run.solvers.keys():
        found.append(f"solvers: {', '.join(part.run.solvers)}, not {', '.join(other.run.solvers)}")
    return f" ({'; '.join(found)})" if found else ""


def gaps(parts: Sequence[Part], unfinished: Sequence[Path]) -> tuple[list[int], list[str]]:
    """Returns the indices of the missing shards, and lines about missing and unfinished shards."""
    of = parts[0].shard["of"]
    missing = sorted(set(range(1, of + 1)) - {part.index for part in parts})
    lines = [f"{folder} is not finished: geodesic-bench run --resume {shlex.quote(str(folder))}"
             for folder in unfinished]  # fmt: skip
    if missing:
        few = ", ".join(map(str, missing[:20])) + (", ..." if len(missing) > 20 else "")
        lines.append(f"missing: {len(missing)} of {of} shards: {few}")
    return missing, lines


def pairs_of(parts: Sequence[Part]) -> list[tuple[str, Source]]:
    """Returns the pairs of mesh and source, in the order of the unsharded run.

    @raises ResultError when two shards have the same pair"""
    found: dict[tuple[int, int], tuple[Part, str, Source]] = {}
    for part in parts:
        for mesh, sources in part.run.sources.items():
            of_run = part.shard["sources"].get(mesh, [])
            for source in sources:
                if mesh not in part.shard["places"] or source not in of_run:
                    raise ResultError(
                        f"{part.run.file}: shard: {mesh}, source {source}, has no place in the run"
                    )
                place = (part.shard["places"][mesh], of_run.index(source))
                other = found.setdefault(place, (part, mesh, source))[0]
                if other is not part:
                    raise ResultError(
                        f"{mesh}, source {source}, is in both {other.folder} and {part.folder}"
                    )
    return [found[place][1:] for place in sorted(found)]


def check_meshes(parts: Sequence[Part]) -> None:
    """@raises ResultError when a mesh is a different file in two shards"""
    first: dict[str, Part] = {}
    for part in parts:
        for name, mesh in part.run.meshes.items():
            other = first.setdefault(name, part)
            if other.run.meshes[name].sha256 != mesh.sha256:
                raise ResultError(
                    f"mesh {name} is another file in {part.run.file} (SHA-256 {mesh.sha256[:12]}...)"
                    f" than in {other.run.file} ({other.run.meshes[name].sha256[:12]}...)"
                )


def rows_of(parts: Sequence[Part], pairs: Sequence[tuple[str, Source]]) -> Columns:
    """Returns the rows in the order of the unsharded run. Each row names its processor.

    @raises ResultError when there are no rows"""
    ours = parts[0].run.ours
    repetitions = ours["repetitions"] if ours.get("interleaved") else 1
    cells = len(ours["solvers"]) * max(1, len(ours.get("programs", []))) * repetitions
    filled = [part.run.columns for part in parts if part.run.columns.length]
    if not filled:
        raise ResultError("nothing was measured: no shard has a row")
    rows = Columns.together(filled)
    place_of = {pair: place for place, pair in enumerate(pairs)}
    _, first, pair_of = np.unique(
        np.stack([rows.arrays["mesh"], rows.arrays["source"]]),
        axis=1, return_index=True, return_inverse=True,
    )  # fmt: skip
    found = [place_of[str(rows.text("mesh", row)), rows.source(row)] for row in first.tolist()]
    places = np.array(found)[pair_of]
    arrays = dict(rows.arrays)
    if "family_index" in arrays:
        arrays["family_index"] = places * cells + arrays["family_index"] % cells
    return replace(rows, arrays=arrays).take(np.argsort(places, kind="stable"))


def context_of(parts: Sequence[Part], out: Path) -> dict[str, Any]:
    """Returns the context of the first shard, with the additions of the other shards."""
    context = dict(parts[0].run.context)
    places = {mesh: place for part in parts for mesh, place in part.shard["places"].items()}
    whole = {mesh: of for part in parts for mesh, of in part.shard["sources"].items()}
    meshes = {m["name"]: m for part in parts for m in part.run.ours["meshes"]}
    skips = {
        (skip["mesh"], skip["solver"]): skip for part in parts for skip in part.run.ours["skipped"]
    }
    order = sorted(meshes, key=places.__getitem__)
    ours = {key: value for key, value in parts[0].run.ours.items() if key not in ("shard", "checksum")}
    ours |= {
        "started": min(part.run.ours["started"] for part in parts),
        "finished": max(part.run.ours["finished"] for part in parts),
        "meshes": [meshes[mesh] for mesh in order],
        "sources": {mesh: whole[mesh] for mesh in order},
        "skipped": sorted(skips.values(), key=lambda skip: places.get(skip["mesh"], len(places))),
        "parts": [part.described(out) for part in parts],
    }
    if len({part.run.ours.get("memory_limit") for part in parts}) > 1:
        ours.pop("memory_limit", None)  # each part has its own
    if sets := source_sets(parts):
        ours["source_sets"] = sets
    if found := [one for part in parts for one in part.run.environments]:
        ours["environments"] = environment.distinct(found)
    changes = [f"shard {part.index}: {change}" for part in parts
               for change in part.run.ours.get("changes", [])]  # fmt: skip
    if changes:
        ours["changes"] = changes
    return context | {"geodesic_bench": ours}


def source_sets(parts: Sequence[Part]) -> dict[str, dict[str, Any]]:
    """Returns the source sets of all shards, by mesh and name."""
    found: dict[str, dict[str, Any]] = {}
    for part in parts:
        for mesh, sets in part.run.ours.get("source_sets", {}).items():
            found.setdefault(mesh, {}).update(sets)
    return found


def write(context: dict[str, Any], rows: Columns, out: Path, most_in_json: int) -> Path:
    """Writes the merged run.json and, if there are many rows, the file with the columns.

    @returns the path of run.json"""
    data: dict[str, Any] = {"context": context}
    if rows.length <= most_in_json:
        data["benchmarks"] = [rows.data(row) for row in range(rows.length)]
    else:
        part = out / f"{ROWS}.{os.getpid()}.part"
        rows.save(part)
        data["columns"] = {
            "file": ROWS, "sha256": of_file(part), "rows": rows.length, "texts": rows.texts,
        }  # fmt: skip
        part.replace(out / ROWS)
    ours = context["geodesic_bench"]
    ours["checksum"] = computed(json.dumps(data, ensure_ascii=False))
    part = out / f"{RUN}.{os.getpid()}.part"
    part.write_text(json.dumps(data, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
    part.replace(out / RUN)
    return out / RUN


def check_out(out: Path) -> None:
    """@raises ResultError when the folder holds a run that was measured there"""
    if (out / REQUEST).exists() or (out / "cells").exists():
        raise ResultError(f"{out}: holds a run of its own: merge into another folder with --out")
    if (out / RUN).exists() and "parts" not in read_file(out / RUN).ours:
        raise ResultError(f"{out / RUN}: is no merged run: merge into another folder with --out")


def join_files(parts: Sequence[Part], subfolder: str, out: Path) -> None:
    """Joins the files of a subfolder of all shards, by hard links if the file system has them. Shards
    that recorded on one mesh have the same files for it."""
    for part in parts:
        source = part.folder / subfolder
        for folder, _, names in os.walk(source):
            into = out / subfolder / os.path.relpath(folder, source)
            into.mkdir(parents=True, exist_ok=True)
            for name in names:
                file, copy = Path(folder, name), into / name
                if file.is_symlink() or not file.is_file() or copy.exists():
                    continue
                try:
                    os.link(file, copy)
                except OSError:
                    shutil.copyfile(file, copy)


def summary(parts: Sequence[Part], rows: Columns, meshes: int) -> str:
    """Returns a line such as "8 shards: 240 rows of 5 meshes, measured on ..."."""
    counts = {name: int(rows.where("processor", name).sum()) for name in rows.names("processor")}
    machines = next(iter(counts)) if len(counts) == 1 else "; ".join(
        f"{name} ({of} rows)" for name, of in counts.items()
    )
    return f"{len(parts)} shards: {rows.length} rows of {meshes} meshes, measured on {machines}"


def merge(
    words: Sequence[Path], out: Path, *, allow_gaps: bool, command: str,
    most_in_json: int = MOST_IN_JSON,
) -> Path:
    """@returns the path of the merged run.json
    @raises ResultError when the shards do not form a run"""
    check_out(out)
    parts, unfinished = read_parts(list(dict.fromkeys(folders_of(words))))
    if not parts:
        raise ResultError("no shard is finished: " + ", ".join(map(str, unfinished)))
    check_meshes(parts)
    pairs = pairs_of(parts)
    missing, lines = gaps(parts, unfinished)
    if lines and not allow_gaps:
        raise ResultError("; ".join(lines) + " (--allow-gaps merges without them)")
    for line in lines:
        print(f"geodesic-bench merge: {line}", file=sys.stderr)
    rows = rows_of(parts, pairs)
    processor = str(rows.text("processor", 0))
    context = context_of(parts, out)
    context["geodesic_bench"] |= {"processor": processor, "command": command}
    if missing:
        context["geodesic_bench"]["missing_shards"] = missing
    out.mkdir(parents=True, exist_ok=True)
    for subfolder in (RECORDINGS, SOURCES):
        join_files(parts, subfolder, out)
    print(summary(parts, rows, len(context["geodesic_bench"]["meshes"])))
    return write(context, rows.without("processor", processor), out, most_in_json)


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.Parser(
        __doc__,
        "geodesic-bench merge results/runs/mine/shards --out results/runs/mine",
        "geodesic-bench merge node1/run node2/run --out both",
    )
    parser.add_argument(
        "folders", nargs="+", type=Path, metavar="DIR",
        help="folder of a shard, or a folder with such folders in it",
    )  # fmt: skip
    parser.add_argument("--out", type=Path, metavar="DIR", required=True, help="folder to write to")
    parser.add_argument(
        "--allow-gaps", action="store_true",
        help="merge the shards that exist; check then names the missing ones",
    )  # fmt: skip
    parser.add_argument(
        "--rows-in-json", type=int, default=MOST_IN_JSON, metavar="N",
        help=f"more rows than this are written as columns to {ROWS} (default: {MOST_IN_JSON})",
    )  # fmt: skip
    words = list(sys.argv[1:] if arguments is None else arguments)
    options = parser.parse_args(words)
    try:
        print(merge(
            options.folders, options.out, allow_gaps=options.allow_gaps,
            command=shlex.join(["geodesic-bench", "merge", *words]),
            most_in_json=options.rows_in_json,
        ))  # fmt: skip
    except (ResultError, OSError) as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
