#include "harness/results/counters.h"

#include <algorithm>
#include <cmath>

namespace geodesic::harness {
namespace {

// Space by the thesis's rule: windows left at the end for MMP, which alone has a window limit, and
// the peak of the wavefront for all others.
std::optional<double> windows_in_space(const Recording& recording) {
  const auto& windows = recording.window_limit ? recording.window_limit : recording.peak_wavefront;
  if (!windows) return std::nullopt;
  return static_cast<double>(*windows);
}

}  // namespace

Json counters(const Recording& recording, const Mesh& mesh) {
  Json json = Json::object();
  const auto put = [&](const char* name, const auto& value) {
    if (value) json[name] = *value;
  };
  put("window_propagations", recording.window_propagations);
  put("windows_created", recording.windows_created);
  put("valid_windows", recording.valid_windows);
  put("reinsertions", recording.reinsertions);
  put("window_limit", recording.window_limit);
  put("peak_wavefront", recording.peak_wavefront);
  put("strip_depth", recording.strip_depth);
  if (recording.strip_depth && *recording.strip_depth > 0) {
    json["strip_b"] =
        std::pow(mesh.vertex_count(), 1 / static_cast<double>(*recording.strip_depth));
  }
  if (recording.wavefront_sd && std::isfinite(*recording.wavefront_sd)) {
    json["wavefront_sd"] = *recording.wavefront_sd;
    if (mesh.mean_edge_length() > 0) {
      json["wavefront_sd_edges"] = *recording.wavefront_sd / mesh.mean_edge_length();
    }
  }
  put("window_bytes", recording.window_bytes);
  if (const auto windows = windows_in_space(recording)) {
    constexpr double kMegabyte = 1e6;
    json["space_thesis_mb"] = *windows * kThesisWindowBytes / kMegabyte;
    if (recording.window_bytes) {
      json["space_mb"] = *windows * static_cast<double>(*recording.window_bytes) / kMegabyte;
    }
  }
  return json;
}

const std::vector<std::string>& counter_names() {
  static const std::vector<std::string> names{"window_propagations",
                                              "windows_created",
                                              "valid_windows",
                                              "reinsertions",
                                              "window_limit",
                                              "peak_wavefront",
                                              "strip_depth",
                                              "strip_b",
                                              "wavefront_sd",
                                              "wavefront_sd_edges",
                                              "window_bytes",
                                              "space_thesis_mb",
                                              "space_mb"};
  return names;
}

const std::vector<std::string>& integer_counters() {
  static const std::vector<std::string> names{
      "window_propagations", "reinsertions",   "windows_created", "valid_windows",
      "window_limit",        "peak_wavefront", "strip_depth"};
  return names;
}

std::size_t unreachable_vertices(std::span<const double> distances) {
  return static_cast<std::size_t>(std::count(distances.begin(), distances.end(), kInfinity));
}

}  // namespace geodesic::harness
