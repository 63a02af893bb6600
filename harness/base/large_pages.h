// Large pages for the program's large blocks of memory.
#pragma once

namespace geodesic::harness {

/// While it exists, the operating system is asked for large pages (2 MB) for blocks of operator new
/// of 4 MB and more, where it grants them on request (Linux: transparent_hugepage is "madvise" or
/// "always"). Most of the time of reading and building a large mesh is otherwise that of getting
/// its memory page by page. Runs measure without it. One at a time.
class LargePages {
 public:
  LargePages();
  ~LargePages();
  LargePages(const LargePages&) = delete;
  LargePages& operator=(const LargePages&) = delete;
};

}  // namespace geodesic::harness
