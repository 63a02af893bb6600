#include "harness/commands/solving/distance_file.h"

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <vector>

#include "harness/base/error.h"
#include "meshes/connectivity.h"
#include "meshes/field_file.h"
#include "meshes/formats/bytes.h"
#include "meshes/formats/npy.h"
#include "meshes/mesh_file.h"

namespace geodesic::harness {
namespace {

std::int64_t number_of(Index source) {
  return source == kNone ? -1 : static_cast<std::int64_t>(source);
}

void append_separated(std::string& text, std::span<const double> distances, char separator) {
  for (const double d : distances) {
    append_text(text, d);
    text += separator;
  }
}

/// Appends the numbers of vertex v in all columns.
void append_columns(std::string& text, std::size_t v, std::span<const double> distances,
                    const VertexColumns& more, char separator) {
  append_text(text, distances[v]);
  if (!more.sources.empty()) append_text(text += separator, number_of(more.sources[v]));
  if (!more.angles.empty()) append_text(text += separator, more.angles[v]);
  text += '\n';
}

std::string as_text(std::span<const double> distances, const VertexColumns& more) {
  std::string text;
  for (std::size_t v = 0; v < distances.size(); ++v) append_columns(text, v, distances, more, ' ');
  return text;
}

std::string as_csv(std::span<const double> distances, const VertexColumns& more,
                   const std::string& numbered) {
  std::string text = numbered + ",distance";
  if (!more.sources.empty()) text += ",source";
  if (!more.angles.empty()) text += ",angle";
  text += '\n';
  for (std::size_t v = 0; v < distances.size(); ++v) {
    append_text(text, static_cast<std::int64_t>(v));
    append_columns(text += ',', v, distances, more, ',');
  }
  return text;
}

std::string as_npy(std::span<const double> distances, const VertexColumns& more) {
  if (more.sources.empty() && more.angles.empty()) return npy_bytes(distances);
  struct Row {
    double distance;
    std::int64_t source;
    double angle;
  };
  std::vector<Row> rows;
  for (std::size_t v = 0; v < distances.size(); ++v) {
    rows.push_back({distances[v], more.sources.empty() ? 0 : number_of(more.sources[v]),
                    more.angles.empty() ? 0 : more.angles[v]});
  }
  const auto distance = npy_column<double>("distance", &Row::distance);
  const auto source = npy_column<std::int64_t>("source", &Row::source);
  const auto angle = npy_column<double>("angle", &Row::angle);
  if (more.angles.empty()) return npy_table_bytes(rows, distance, source);
  if (more.sources.empty()) return npy_table_bytes(rows, distance, angle);
  return npy_table_bytes(rows, distance, source, angle);
}

}  // namespace

DistanceFile::Format DistanceFile::format_of(const std::string& file) {
  const std::filesystem::path path(file);
  const std::string extension = lower_extension(path);
  if (extension == ".txt") return Format::text;
  if (extension == ".csv") return Format::csv;
  if (extension == ".npy") return Format::npy;
  if (has_field_extension(path)) return Format::mesh;
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(path, unknown);
  // A folder counts as text: opening it fails with a message that says what is wrong.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return Format::text;
  }
  throw HarnessError(
      "cannot write '" + file +
      "': distances are written as .txt, .csv or .npy, with the mesh as .ply or .vtk; - is "
      "standard output");
}

DistanceFile::DistanceFile(const std::string& file)
    : name_(file), format_(file == "-" ? Format::text : format_of(file)) {
  to_ = file == "-" ? &std::cout : &file_.emplace(file).stream();
}

void DistanceFile::write(const Mesh& mesh, std::span<const double> distances,
                         const VertexColumns& more) {
  if (is_mesh()) {
    *to_ << field_bytes(soup_of(mesh), distances, more.sources, name_);
  } else {
    write_table(distances, more, "vertex");
  }
}

void DistanceFile::write_table(std::span<const double> distances, const VertexColumns& more,
                               const std::string& numbered) {
  if (format_ == Format::csv) {
    *to_ << as_csv(distances, more, numbered);
  } else {
    *to_ << (format_ == Format::npy ? as_npy(distances, more) : as_text(distances, more));
  }
}

void DistanceFile::begin_rows(std::size_t rows, std::size_t vertices, const std::string& named) {
  if (format_ == Format::npy) {
    *to_ << npy_header("'<f8'", "(" + std::to_string(rows) + ", " + std::to_string(vertices) + ")");
  }
  if (format_ != Format::csv) return;
  std::string text = named;
  for (std::size_t v = 0; v < vertices; ++v) append_text(text += ',', static_cast<std::int64_t>(v));
  *to_ << text << '\n';
}

std::string DistanceFile::row(const std::string& sources, std::span<const double> distances) const {
  std::string bytes;
  if (format_ == Format::npy) {
    for (const double d : distances) append_little_endian(bytes, d);
    return bytes;
  }
  const char separator = format_ == Format::csv ? ',' : ' ';
  if (format_ == Format::csv) bytes = '"' + sources + "\",";  // points may contain commas
  append_separated(bytes, distances, separator);
  if (!bytes.empty()) bytes.back() = '\n';
  return bytes;
}

void DistanceFile::commit() {
  if (file_) file_->commit();
}

}  // namespace geodesic::harness
