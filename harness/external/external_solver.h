// A solver that runs in another process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/base/scratch_folder.h"
#include "harness/external/external_program.h"

namespace geodesic::harness {

class ExternalSolver final : public Solver {
 public:
  /// Writes the mesh for the program. @throws HarnessError when it cannot be written
  ExternalSolver(const Mesh& mesh, const Description& description, const ExternalProgram& program);

  /// Times of the last solve, in seconds.
  struct Times {
    double real = 0, cpu = 0;
    double prepare = 0;  ///< 0 where the program does not report it
    /// "reported", "process less reading" or "process": see docs/external-solvers.md.
    const char* of = "process";
    std::int64_t peak_bytes = 0;  ///< resident set of the program's process
  };
  const Times& last() const { return last_; }

 private:
  struct Process {
    double real, cpu;
    std::int64_t peak_bytes;
  };

  void run(const Start& start, std::span<double> distances) override;
  Process start_program(const std::string& sources) const;
  std::vector<double> read_distances() const;
  void note_times(const Process& process);
  /// Times of a process without sources, which reads the mesh and ends; empty if it fails.
  std::optional<Process> reading() const;

  const ExternalProgram& program_;
  ScratchFolder folder_;  // for files that both processes read
  std::optional<std::optional<Process>> reading_;
  Times last_;
};

}  // namespace geodesic::harness
