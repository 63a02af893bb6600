"""A small peer of the tests: its authors' archive in a mirror, its description, its adapter."""

from __future__ import annotations

import hashlib
import io
import json
import os
import subprocess
import sys
import tarfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
COMMIT = "0123456789" * 4
HEADER = "authors.h"

AUTHORS = r"""
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

inline void crash() { *(volatile int*)nullptr = 1; }
inline void hang() {
  for (;;) std::this_thread::sleep_for(std::chrono::milliseconds(10));
}
inline void eat() {
  std::vector<std::vector<char>> all;
  for (int gigabyte = 0; gigabyte < 40; ++gigabyte) all.emplace_back(1 << 30, 'x');
}
inline void leave() { std::exit(0); }
inline void talk() { std::puts("{\"benchmarks\": []}"); std::fputs("noise\n", stderr); }
"""

ADAPTER = r"""
#include <authors.h>

#include "peer.h"

namespace {
using namespace geodesic;

// Right on a mesh of one triangle.
template <void (*behave)()>
class Fake final : public Solver {
 public:
  using Solver::Solver;
  Fake(const Mesh& mesh, const Description& description) : Solver(mesh, description) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording*) override {
    behave();
    const Index source = query.sources.front().at.vertex;
    for (Index v = 0; v < distances.size(); ++v) {
      const Vec3 way = subtract(mesh().position(v), mesh().position(source));
      distances[v] = norm(way);
    }
  }
};

Description named(const char* name) {
  return {.name = name, .family = "fake", .paper = "none", .remarks = peer::remarks("a test's")};
}

const RegisterSolver<Fake<talk>> talks{named("talks")};
const RegisterSolver<Fake<crash>> crashes{named("crashes")};
const RegisterSolver<Fake<hang>> hangs{named("hangs")};
const RegisterSolver<Fake<eat>> eats{named("eats")};
const RegisterSolver<Fake<leave>> leaves{named("leaves")};
}  // namespace
"""

LISTS = """cmake_minimum_required(VERSION 3.25)
project(fake LANGUAGES CXX)
include(peer)
geodesic_add_peer(fake adapter.cpp)
target_include_directories(fake PRIVATE ${PEER_SOURCES}/codes)
"""


class PeerWorld:
    """A folder of peers with one, `fake`, and a mirror with its authors' archive."""

    def __init__(self, folder: Path, bench: Path) -> None:
        self.bench = bench
        self.peers = folder / "peers"
        self.mirror = folder / "mirror"
        self.built = folder / "built"
        self.fake = self.peers / "fake"
        self.fake.mkdir(parents=True)
        (self.fake / "adapter.cpp").write_text(ADAPTER)
        (self.fake / "CMakeLists.txt").write_text(LISTS)
        self.archive = self.mirror / "somebody" / "codes" / "archive" / f"{COMMIT}.tar.gz"
        self.archive.parent.mkdir(parents=True)
        with tarfile.open(self.archive, "w:gz") as archive:
            info = tarfile.TarInfo(f"codes-{COMMIT}/{HEADER}")
            info.size = len(AUTHORS)
            archive.addfile(info, io.BytesIO(AUTHORS.encode()))
        self.describe()

    def describe(self, **changes: Any) -> None:
        """Writes peer.json: the right one but for the changes."""
        sha256 = hashlib.sha256(AUTHORS.encode()).hexdigest()
        repository = {
            "repository": "somebody/codes", "commit": COMMIT, "licence": "MIT",
            "files": {HEADER: sha256},
        }  # fmt: skip
        description = {
            "what": "A fake.", "promise": "exact distances", "paper": "none",
            "upstream": [repository],
            "flags": {"authors": "-O1", "from": "this test", "ours": "-O1"},
            **changes,
        }  # fmt: skip
        (self.fake / "peer.json").write_text(json.dumps(description))

    def describe_repository(self, **changes: Any) -> None:
        self.describe()
        description = json.loads((self.fake / "peer.json").read_text())
        description["upstream"][0] |= changes
        self.describe(upstream=description["upstream"])

    @property
    def plugin(self) -> Path:
        return self.built / "fake" / "libfake.so"

    def build(self, *words: str, mirror: str | None = None) -> subprocess.CompletedProcess[str]:
        environment = {**os.environ, "GEODESIC_PEERS_MIRROR": mirror or str(self.mirror)}
        return subprocess.run(
            [
                sys.executable, ROOT / "peers" / "build.py", "--bench", self.bench,
                "--peers", self.peers, "--folder", self.built, *words,
            ],
            env=environment, capture_output=True, text=True, check=False,
        )  # fmt: skip

    def run(self, *words: str) -> subprocess.CompletedProcess[str]:
        """geodesic-bench with the plug-in."""
        return subprocess.run(
            [self.bench, "--plugin", self.plugin, *words],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
