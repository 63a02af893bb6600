#include "harness/corpus/points.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "harness/base/error.h"
#include "meshes/formats/bytes.h"
#include "meshes/mesh_file.h"
#include "meshes/nearest_point.h"

namespace geodesic::harness {
namespace {

using Kind = WrittenPoint::Kind;

// Weights that were written with few digits do not sum up to 1 exactly.
constexpr double kWeightRounding = 1e-6;

// What numbers of one point must be, wherever they were written.
void check(const WrittenPoint& point) {
  const auto refuse = [&](const std::string& why) { throw HarnessError(point.text + ": " + why); };
  const auto& numbers = point.numbers;
  if (!std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); })) {
    refuse("a number is not finite");
  }
  if (point.kind == Kind::edge && !(numbers[0] >= 0 && numbers[0] <= 1)) {
    refuse("the share of an edge must lie between 0 and 1");
  }
  if (point.kind == Kind::face) {
    if (std::ranges::min(numbers) < 0) refuse("a weight is negative");
    const double sum = numbers[0] + numbers[1] + numbers[2];
    if (std::abs(sum - 1) > kWeightRounding) {
      refuse("the weights sum up to " + significant(sum, 7) + "; their sum must be 1");
    }
  }
  if (point.initial && !(*point.initial >= 0 && std::isfinite(*point.initial))) {
    refuse("an initial distance must be finite and not negative");
  }
}

// Reads points from a list.
class PointParser {
 public:
  PointParser(std::string_view text, const std::string& where) : rest_(text), where_(where) {}

  std::vector<WrittenPoint> parse() {
    std::vector<WrittenPoint> points;
    do {
      points.push_back(point());
    } while (take(","));
    skip_blanks();
    if (!rest_.empty()) refuse();
    return points;
  }

 private:
  [[noreturn]] void refuse(const std::string& why = "") const {
    // Of a list, the point that is wrong: up to the comma behind what was understood.
    const std::size_t understood = static_cast<std::size_t>(rest_.data() - begin_.data());
    const std::string_view wrong = begin_.substr(0, begin_.find(',', understood));
    throw HarnessError(where_ + ": '" + excerpt(wrong) + "' " +
                       (why.empty() ? std::string("is not a point, such as ") + kPointForms +
                                          "; +0.5 behind it is an initial distance"
                                    : why));
  }

  WrittenPoint point() {
    begin_ = rest_;
    WrittenPoint point;
    if (take("edge:")) {
      point.kind = Kind::edge;
      point.elements[0] = index();
      expect("-");
      point.elements[1] = index();
      expect(":");
      point.numbers[0] = number();
    } else if (take("face:")) {
      point.kind = Kind::face;
      point.elements[0] = index();
      expect(":");
      three_numbers(point);
    } else if (take("at:")) {
      point.kind = Kind::place;
      three_numbers(point);
    } else {
      point.elements[0] = index();
    }
    if (take("+")) point.initial = number();
    const std::string_view read = begin_.substr(0, begin_.size() - rest_.size());
    point.text = where_ + ' ' + std::string(read.substr(0, read.find_last_not_of(' ') + 1));
    check(point);
    return point;
  }

  void three_numbers(WrittenPoint& point) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (k > 0) expect(",");
      point.numbers[k] = number();
    }
  }

  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }
  bool take(std::string_view word) {
    skip_blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  void expect(std::string_view word) {
    if (!take(word)) refuse();
  }

  template <class Number>
  Number parsed() {
    skip_blanks();
    Number value{};
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error == std::errc::result_out_of_range) refuse("has a number that is too large");
    if (error != std::errc()) refuse();
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  Index index() { return parsed<Index>(); }
  double number() { return parsed<double>(); }

  std::string_view rest_;
  const std::string& where_;
  std::string_view begin_;  // of the point that is being read
};

// Points of a text file: words without quotes, joined by commas again.
std::vector<WrittenPoint> parse_text(std::string_view text, const std::string& where) {
  std::string list;
  bool between = false;  // two words
  for (const char c : text) {
    if (c == '"') continue;
    const bool separates = c == ',' || c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!separates) {
      if (between && !list.empty()) list += ',';
      list += c;
    }
    between = separates;
  }
  if (list.empty()) throw HarnessError(where + ": there is no point in it");
  return parse_points(list, where);
}

class JsonPoints {
 public:
  JsonPoints(const Json& list, const std::string& where) : list_(list), where_(where) {}

  std::vector<WrittenPoint> parse() const {
    if (!list_.is_array()) throw HarnessError(where_ + ": a list of points is expected");
    if (list_.empty()) throw HarnessError(where_ + ": there is no point in it");
    std::vector<WrittenPoint> points;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      const std::string at = where_ + ", point " + std::to_string(i);
      points.push_back(point(list_[i], at));
      points.back().text = at;
      check(points.back());
    }
    return points;
  }

 private:
  static WrittenPoint point(const Json& json, const std::string& at) {
    if (json.is_string()) {
      std::vector<WrittenPoint> points = parse_points(json.get<std::string>(), at);
      if (points.size() > 1) throw HarnessError(at + ": a string holds one point");
      return points.front();
    }
    WrittenPoint point;
    if (json.is_number()) {
      point.elements[0] = index(json, at);
      return point;
    }
    if (!json.is_object()) {
      throw HarnessError(at + ": " + shown(json) + " is not a number, a string or an object");
    }
    const auto read = [&](const std::string& key) { return of(json, key, at); };
    std::vector<std::string> keys;
    if (json.contains("edge")) {
      keys = {"edge", "share"};
      point.kind = Kind::edge;
      const Json ends = list(read("edge"), 2, at + ", edge");
      for (std::size_t k = 0; k < 2; ++k) point.elements[k] = index(ends[k], at + ", edge");
      point.numbers[0] = number(read("share"), at + ", share");
    } else if (json.contains("face")) {
      keys = {"face", "weights"};
      point.kind = Kind::face;
      point.elements[0] = index(read("face"), at + ", face");
      numbers(read("weights"), at + ", weights", point);
    } else if (json.contains("at")) {
      keys = {"at"};
      point.kind = Kind::place;
      numbers(read("at"), at + ", at", point);
    } else {
      keys = {"vertex"};
      point.elements[0] = index(read("vertex"), at + ", vertex");
    }
    keys.emplace_back("initial");
    if (json.contains("initial")) point.initial = number(read("initial"), at + ", initial");
    for (const auto& [key, value] : json.items()) {
      if (std::ranges::find(keys, key) == keys.end()) {
        throw HarnessError(at + ": " + unknown_name("key", key, keys));
      }
    }
    return point;
  }

  static Json of(const Json& object, const std::string& key, const std::string& at) {
    if (object.contains(key)) return object.at(key);
    if (key != "vertex") throw HarnessError(at + ": '" + key + "' is missing");
    std::vector<std::string> keys;
    for (const auto& [name, value] : object.items()) keys.push_back(name);
    throw HarnessError(
        at + ": " +
        unknown_name("key", keys.empty() ? "" : keys.front(),
                     {"vertex", "edge", "share", "face", "weights", "at", "initial"}));
  }

  static Index index(const Json& json, const std::string& at) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() >= kNone) {
      throw HarnessError(at + ": " + shown(json) + " is not the number of a vertex or face");
    }
    return json.get<Index>();
  }

  static double number(const Json& json, const std::string& at) {
    if (!json.is_number()) throw HarnessError(at + ": " + shown(json) + " is not a number");
    return json.get<double>();
  }

  static Json list(const Json& json, std::size_t size, const std::string& at) {
    if (!json.is_array() || json.size() != size) {
      throw HarnessError(at + ": a list of " + std::to_string(size) + " numbers is expected");
    }
    return json;
  }

  static void numbers(const Json& json, const std::string& at, WrittenPoint& point) {
    const Json three = list(json, 3, at);
    for (std::size_t k = 0; k < 3; ++k) point.numbers[k] = number(three[k], at);
  }

  const Json& list_;
  const std::string& where_;
};

SurfacePoint on_surface(const WrittenPoint& point, const Mesh& mesh) {
  switch (point.kind) {
    case Kind::edge:
      return point_on_edge(mesh, point.elements[0], point.elements[1], point.numbers[0]);
    case Kind::face:
      return point_in_face(mesh, point.elements[0], point.numbers);
    default:
      const std::string defect = defect_of(mesh, SurfacePoint(point.elements[0]));
      if (!defect.empty()) throw std::invalid_argument(defect);
      return point.elements[0];
  }
}

}  // namespace

std::vector<WrittenPoint> parse_points(std::string_view text, const std::string& where) {
  return PointParser(text, where).parse();
}

std::vector<WrittenPoint> read_points(const std::filesystem::path& file, const std::string& flag) {
  const std::string where = flag + " '" + file.string() + "'";
  std::string bytes;
  try {
    bytes = read_bytes(file);
  } catch (const MeshError& error) {
    throw HarnessError(flag + ' ' + error.what());
  }
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) throw HarnessError(where + ": the file is empty");
  if (bytes[first] == '[' || bytes[first] == '{') {
    return JsonPoints(parse_json(bytes, where), where).parse();
  }
  return parse_text(bytes, where);
}

PlacedPoint place(const WrittenPoint& point, const Mesh& mesh) {
  try {
    const double initial = point.initial.value_or(0);
    if (point.kind != Kind::place) return {.at = on_surface(point, mesh), .initial = initial};
    const NearestPoint nearest = nearest_point(mesh, point.numbers);
    return {.at = nearest.at, .initial = initial, .from_surface = nearest.distance};
  } catch (const std::invalid_argument& error) {
    throw HarnessError(point.text + ": " + error.what());
  }
}

std::string written(const Mesh& mesh, const SurfacePoint& point) {
  std::string text;
  if (point.is_vertex()) {
    append_text(text, point.vertex);
    return text;
  }
  const Index under = edge_under(point);
  if (under == kNone) {
    append_text(text = "face:", point.face);
    char before = ':';
    for (const double weight : point.weights) {
      append_text(text += before, weight);
      before = ',';
    }
    return text;
  }
  const Triangle corners = mesh.triangle(mesh.numbers().internal_face(point.face));
  const auto end = [&](Index k) {
    return std::pair(mesh.numbers().external_vertex(corners[k]), point.weights[k]);
  };
  const auto [low, high] = std::minmax({end(under % 3), end((under % 3 + 1) % 3)});
  append_text(text = "edge:", low.first);
  append_text(text += '-', high.first);
  append_text(text += ':', high.second);
  return text;
}

Json shown(const Mesh& mesh, const Source& source) {
  if (source.at.is_vertex() && source.distance == 0) return source.at.vertex;
  std::string text = written(mesh, source.at);
  if (source.distance > 0) append_text(text += '+', source.distance);
  return text;
}

}  // namespace geodesic::harness
