"""A small peer for the tests: the repository of its authors in a mirror, its CMake file and its adapter."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
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
inline void leave() { std::edited(0); }
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
  void run(const Start& start, std::span<double> distances) override {
    behave();
    const Index source = start.vertices.front().vertex;
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
project(NAME LANGUAGES CXX)
set(PEER_FLAGS -O1 CACHE STRING "of this test")
include(peer)
peer_needs(PACKAGES)
peer_sources(somebody/codes COMMIT /*.h EDIT authors.h)
geodesic_add_peer(NAME adapter.cpp)
target_include_directories(NAME PRIVATE ${PEER_SOURCES})
"""


class PeerWorld:
    """A folder of peers that contains the peer `fake`, and a mirror with the repository of its authors."""

    def __init__(self, folder: Path, bench: Path) -> None:
        self.bench = bench
        self.peers = folder / "peers"
        self.mirror = folder / "mirror"
        self.built = folder / "built"
        authors = self.mirror / "somebody" / "codes"
        authors.mkdir(parents=True)
        (authors / HEADER).write_text(AUTHORS)
        git = ["git", "-C", str(authors), "-c", "user.name=x", "-c", "user.email=x"]
        for words in (["init", "-q"], ["add", HEADER], ["commit", "-q", "-m", "x"]):
            subprocess.run([*git, *words], check=True)
        said = subprocess.run([*git, "rev-parse", "HEAD"], capture_output=True, text=True, check=True)
        self.commit = said.stdout.strip()
        self.add("fake")

    def add(self, name: str, adapter: str = ADAPTER, packages: str = "", commit: str = "") -> None:
        """Writes a peer; replaces an earlier one of this name. It is correct except for the given values."""
        folder = self.peers / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "adapter.cpp").write_text(adapter)
        (folder / "edits.sed").write_text("s/edited/exit/\n")
        lists = LISTS.replace("NAME", name).replace("PACKAGES", packages)
        (folder / "CMakeLists.txt").write_text(lists.replace("COMMIT", commit or self.commit))

    @property
    def plugin(self) -> Path:
        return self.built / "fake" / "libfake.so"

    def build(self, *words: str, mirror: str | None = None) -> subprocess.CompletedProcess[str]:
        environment = {**os.environ, "GEODESIC_PEERS_MIRROR": mirror or str(self.mirror)}
        return subprocess.run(
            [
                sys.executable, ROOT / "peers" / "build.py", "--bench", self.bench,
                "--peers", self.peers, "--out", self.built, *words,
            ],
            env=environment, capture_output=True, text=True, check=False,
        )  # fmt: skip

    def run(self, *words: str) -> subprocess.CompletedProcess[str]:
        """Runs geodesic-bench with the plug-in."""
        return subprocess.run(
            [self.bench, "--plugin", self.plugin, *words],
            capture_output=True, text=True, check=False,
        )  # fmt: skip
