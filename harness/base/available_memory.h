// Memory that is left for new processes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>

namespace geodesic::harness {

/// Memory in bytes that new processes may use together: nine tenths of what Linux calls available,
/// or of what the control groups of this process have left, if that is less.
std::uint64_t available_memory();

/// Bytes left in the control groups of a process and in all groups above them, in which batch
/// systems and services set limits. The greatest number where there is no limit.
/// @param groups text of /proc/PID/cgroup: lines such as "0::/system.slice/job.scope" (version 2)
/// or
///        "9:memory:/slurm/job_7" (version 1)
/// @param root folder where the groups are mounted: /sys/fs/cgroup
std::uint64_t left_in_control_groups(std::istream& groups, const std::filesystem::path& root);

}  // namespace geodesic::harness
