// Limits of the control groups of Linux, in which batch systems and services set them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>

namespace geodesic::harness {

/// Memory in bytes that new processes may use together: nine tenths of what Linux calls available,
/// or of what the control groups of this process have left, if that is less.
std::uint64_t available_memory();

/// Bytes left in the control groups of a process and in all groups above them. The greatest number
/// where there is no limit.
/// @param groups text of /proc/PID/cgroup: lines such as "0::/system.slice/job.scope" (version 2)
///        or "9:memory:/slurm/job_7" (version 1)
/// @param root folder where the groups are mounted: /sys/fs/cgroup
std::uint64_t left_in_control_groups(std::istream& groups, const std::filesystem::path& root);

/// The number of processors whose time the control groups of a process, and the groups above them,
/// let it use: 1.5 means 150 ms in each 100 ms of wall time. Empty where there is no limit.
/// Parameters as above.
std::optional<double> processors_in_control_groups(std::istream& groups,
                                                   const std::filesystem::path& root);

}  // namespace geodesic::harness
