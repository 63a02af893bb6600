// Large pages for the program's large blocks of memory.
#pragma once

namespace geodesic::harness {

/// While it exists, the program requests large pages (2 MB) for blocks of operator new of 4 MB and
/// more. Linux grants them if transparent_hugepage is "madvise" or "always". Without large pages,
/// most of the time to read and build a large mesh is spent on obtaining memory page by page. Runs
/// measure without it. At most one object exists at a time.
class LargePages {
 public:
  LargePages();
  ~LargePages();
  LargePages(const LargePages&) = delete;
  LargePages& operator=(const LargePages&) = delete;
};

}  // namespace geodesic::harness
