#include "harness/commands/solving/distance_file.h"

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <vector>

#include "harness/base/error.h"
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

std::string as_text(std::span<const double> distances, std::span<const Index> sources) {
  std::string text;
  if (sources.empty()) append_separated(text, distances, '\n');
  for (std::size_t v = 0; v < sources.size(); ++v) {
    append_text(text, distances[v]);
    append_text(text += ' ', number_of(sources[v]));
    text += '\n';
  }
  return text;
}

std::string as_csv(std::span<const double> distances, std::span<const Index> sources,
                   const std::string& numbered) {
  std::string text = numbered + (sources.empty() ? ",distance\n" : ",distance,source\n");
  for (std::size_t v = 0; v < distances.size(); ++v) {
    append_text(text, static_cast<std::int64_t>(v));
    append_text(text += ',', distances[v]);
    if (!sources.empty()) append_text(text += ',', number_of(sources[v]));
    text += '\n';
  }
  return text;
}

std::string as_npy(std::span<const double> distances, std::span<const Index> sources) {
  if (sources.empty()) return npy_bytes(distances);
  struct Row {
    double distance;
    std::int64_t source;
  };
  std::vector<Row> rows;
  for (std::size_t v = 0; v < distances.size(); ++v) {
    rows.push_back({distances[v], number_of(sources[v])});
  }
  return npy_table_bytes(rows, npy_column<double>("distance", &Row::distance),
                         npy_column<std::int64_t>("source", &Row::source));
}

}  // namespace

DistanceFile::Format DistanceFile::format_of(const std::string& file) {
  const std::filesystem::path path(file);
  const std::string extension = lower_extension(path);
  if (extension == ".txt") return Format::text;
  if (extension == ".csv") return Format::csv;
  if (extension == ".npy") return Format::npy;
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(path, unknown);
  // A folder counts as text: opening it fails with a message that says what is wrong.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return Format::text;
  }
  throw HarnessError("cannot write '" + file +
                     "': distances are written as .txt, .csv or .npy; - is standard output");
}

DistanceFile::DistanceFile(const std::string& file)
    : format_(file == "-" ? Format::text : format_of(file)) {
  to_ = file == "-" ? &std::cout : &file_.emplace(file).stream();
}

void DistanceFile::write(std::span<const double> distances, std::span<const Index> sources,
                         const std::string& numbered) {
  switch (format_) {
    case Format::text:
      *to_ << as_text(distances, sources);
      break;
    case Format::csv:
      *to_ << as_csv(distances, sources, numbered);
      break;
    case Format::npy:
      *to_ << as_npy(distances, sources);
      break;
  }
}

void DistanceFile::begin_rows(std::size_t sources, std::size_t vertices) {
  if (format_ == Format::npy) {
    *to_ << npy_header("'<f8'",
                       "(" + std::to_string(sources) + ", " + std::to_string(vertices) + ")");
  }
  if (format_ != Format::csv) return;
  std::string text = "source";
  for (std::size_t v = 0; v < vertices; ++v) append_text(text += ',', static_cast<std::int64_t>(v));
  *to_ << text << '\n';
}

std::string DistanceFile::row(const std::string& source, std::span<const double> distances) const {
  std::string bytes;
  if (format_ == Format::npy) {
    for (const double d : distances) append_little_endian(bytes, d);
    return bytes;
  }
  const char separator = format_ == Format::csv ? ',' : ' ';
  if (format_ == Format::csv) bytes = '"' + source + "\",";  // points may contain commas
  append_separated(bytes, distances, separator);
  if (!bytes.empty()) bytes.back() = '\n';
  return bytes;
}

void DistanceFile::commit() {
  if (file_) file_->commit();
}

}  // namespace geodesic::harness
