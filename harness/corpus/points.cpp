#include "harness/corpus/points.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "harness/base/error.h"
#include "meshes/formats/bytes.h"
#include "meshes/formats/parsing.h"
#include "meshes/mesh_file.h"
#include "meshes/nearest_point.h"
#include "solvers/core/messages.h"
#include "solvers/core/number_text.h"

namespace geodesic::harness {
namespace {

using Kind = WrittenPoint::Kind;

// Weights that were written with few digits do not sum up to 1 exactly.
constexpr double kWeightRounding = 1e-6;

// Checks the numbers of a point, for every input format.
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

// Parses a list of points.
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
    // The wrong point of a list: up to the comma after the part that was understood.
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
  std::string_view begin_;  // from the current point on
};

// A line of a file, or an item of its list in JSON.
struct Row {
  std::string where;
  std::vector<std::string> words;

  std::string text() const { return join(words, ","); }
  bool has_numbers(std::size_t count) const {
    return words.size() == count && std::ranges::all_of(words, [](const std::string& word) {
             return number_in<double>(word).has_value();
           });
  }
  bool has_three_numbers() const { return has_numbers(3); }
  // Whether the words may be vertices.
  bool is_whole() const {
    return std::ranges::all_of(words, [](const std::string& word) {
      return word.find_first_not_of("0123456789") == std::string::npos;
    });
  }
};

// The first line of a table of places.
constexpr std::string_view kNamesOfCoordinates = "x,y,z";

// A row of three numbers is a place if one of them cannot be a vertex. Three whole numbers may be
// vertices or a place: they are a place in a table, where each row has three numbers and some of
// them are not whole.
// @param named whether the file says that each row is a place
std::vector<WrittenPoint> points_of(const std::vector<Row>& rows, bool named) {
  const bool table = named || (std::ranges::all_of(rows, &Row::has_three_numbers) &&
                               !std::ranges::all_of(rows, &Row::is_whole));
  std::vector<WrittenPoint> points;
  for (const Row& row : rows) {
    const bool three = row.has_three_numbers();
    if (named && !three) {
      throw HarnessError(row.where + ": '" + excerpt(row.text()) +
                         "' is not three numbers, the x, y and z of a place");
    }
    if (three && !table && row.is_whole()) {
      throw HarnessError(row.where + ": '" + row.text() +
                         "' may be three vertices or a place: write each vertex by itself, or the "
                         "place as at:" +
                         row.text() + ", or places in a table after a first line x,y,z");
    }
    const std::vector<WrittenPoint> more =
        parse_points((three ? "at:" : "") + row.text(), row.where);
    if (more.size() > row.words.size()) {
      throw HarnessError(row.where + ": a string holds one point");
    }
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

// The words of a line, between commas or blanks, without quotes.
std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words(1);
  for (const char c : line) {
    if (c == '"') continue;
    const bool separates = c == ',' || c == ' ' || c == '\t' || c == '\r';
    if (!separates) words.back() += c;
    if (separates && !words.back().empty()) words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

// The lines that are not empty.
std::vector<Row> rows_of(std::string_view text, const std::string& where) {
  std::vector<Row> rows;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    Row row{where + ", line " + std::to_string(number), words_of(line)};
    if (!row.words.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

[[noreturn]] void refuse_empty(const std::string& where, const std::string& what) {
  throw HarnessError(where + ": there is no " + what + " in it");
}

std::vector<WrittenPoint> parse_text(std::string_view text, const std::string& where) {
  std::vector<Row> rows = rows_of(text, where);
  const bool named = !rows.empty() && rows.front().text() == kNamesOfCoordinates;
  if (named) rows.erase(rows.begin());
  if (rows.empty()) refuse_empty(where, "point");
  return points_of(rows, named);
}

std::vector<WrittenPoint> parse_list(const Json& list, const std::string& where) {
  if (!list.is_array()) throw HarnessError(where + ": a list of points is expected");
  if (list.empty()) refuse_empty(where, "point");
  std::vector<Row> rows;
  for (const Json& each : list) {
    Row row{where + ", point " + std::to_string(rows.size()), {}};
    if (each.is_array()) {
      for (const Json& coordinate : each) row.words.push_back(coordinate.dump());
      if (!row.has_three_numbers()) {
        throw HarnessError(row.where + ": a list within the list is a place, [x, y, z]");
      }
    } else if (each.is_string()) {
      row.words = {each.get<std::string>()};
    } else if (each.is_number()) {
      row.words = {each.dump()};
    } else {
      throw HarnessError(row.where + ": " + shown(each) + " is not a number, a string or a list");
    }
    rows.push_back(std::move(row));
  }
  return points_of(rows, false);
}

Index number_of(const std::string& word, const std::string& where) {
  const std::optional<Index> number = number_in<Index>(word);
  if (number) return *number;
  throw HarnessError(where + ": '" + excerpt(word) +
                     "' is not the number of a vertex or face, such as 12");
}

std::vector<Index> parse_numbers_list(const Json& list, const std::string& where) {
  if (!list.is_array()) throw HarnessError(where + ": a list of numbers is expected");
  std::vector<Index> numbers;
  for (const Json& each : list) {
    numbers.push_back(number_of(each.dump(), where + ", item " + std::to_string(numbers.size())));
  }
  return numbers;
}

std::vector<Index> parse_numbers_text(std::string_view text, const std::string& where) {
  std::vector<Index> numbers;
  for (const Row& row : rows_of(text, where)) {
    for (const std::string& word : row.words) numbers.push_back(number_of(word, row.where));
  }
  return numbers;
}

WrittenPair pair_of(const std::vector<WrittenPoint>& points, const std::string& where) {
  if (points.size() != 2) {
    throw HarnessError(where + ": a pair is two points, not " + std::to_string(points.size()));
  }
  for (const WrittenPoint& point : points) {
    if (point.initial) {
      throw HarnessError(point.text + ": a point of a pair has no initial distance");
    }
  }
  return {points[0], points[1]};
}

std::vector<WrittenPair> parse_pairs_text(std::string_view text, const std::string& where) {
  std::vector<WrittenPair> pairs;
  for (Row& row : rows_of(text, where)) {
    if (row.has_numbers(6)) {
      row.words[0].insert(0, "at:");
      row.words[3].insert(0, "at:");
    }
    pairs.push_back(pair_of(parse_points(row.text(), row.where), row.where));
  }
  return pairs;
}

std::vector<WrittenPair> parse_pairs_list(const Json& list, const std::string& where) {
  if (!list.is_array()) throw HarnessError(where + ": a list of pairs is expected");
  std::vector<WrittenPair> pairs;
  for (const Json& each : list) {
    const std::string here = where + ", pair " + std::to_string(pairs.size());
    pairs.push_back(pair_of(parse_list(each, here), here));
  }
  return pairs;
}

std::vector<WrittenSet> parse_sets_text(std::string_view text, const std::string& where) {
  std::vector<WrittenSet> sets;
  for (const Row& row : rows_of(text, where)) sets.push_back(parse_points(row.text(), row.where));
  return sets;
}

std::vector<WrittenSet> parse_sets_list(const Json& list, const std::string& where) {
  if (!list.is_array()) throw HarnessError(where + ": a list of sets is expected");
  std::vector<WrittenSet> sets;
  for (const Json& each : list) {
    const std::string here = where + ", set " + std::to_string(sets.size());
    sets.push_back(parse_list(each.is_array() ? each : Json::array({each}), here));
  }
  return sets;
}

// Whether the bytes are JSON. @throws HarnessError if there is nothing
bool are_json(std::string_view bytes, const std::string& where) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) throw HarnessError(where + ": the file is empty");
  return bytes[first] == '[' || bytes[first] == '{';
}

// Reads a file of one kind of items.
template <class Item>
std::vector<Item> read_items(const std::filesystem::path& file, const std::string& flag,
                             std::vector<Item> parse(std::string_view, const std::string&)) {
  try {
    const std::string bytes = read_bytes(file);
    return parse(text_of(bytes, file.string()), flag + " '" + file.string() + "'");
  } catch (const MeshError& error) {
    throw HarnessError(flag + ' ' + error.what());
  }
}

/// Parses a file of JSON or of text.
/// @param item what a file without any lacks
template <class Item>
std::vector<Item> parse_items(std::string_view bytes, const std::string& where, const char* item,
                              std::vector<Item> (*list)(const Json&, const std::string&),
                              std::vector<Item> (*text)(std::string_view, const std::string&)) {
  std::vector<Item> items =
      are_json(bytes, where) ? list(parse_json(bytes, where), where) : text(bytes, where);
  if (items.empty()) refuse_empty(where, item);
  return items;
}

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

std::vector<WrittenPoint> parse_points_file(std::string_view bytes, const std::string& where) {
  return are_json(bytes, where) ? parse_list(parse_json(bytes, where), where)
                                : parse_text(bytes, where);
}

std::vector<WrittenPoint> read_points(const std::filesystem::path& file, const std::string& flag) {
  return read_items(file, flag, parse_points_file);
}

std::vector<Index> parse_numbers_file(std::string_view bytes, const std::string& where) {
  return parse_items(bytes, where, "number", parse_numbers_list, parse_numbers_text);
}

std::vector<Index> read_numbers(const std::filesystem::path& file, const std::string& flag) {
  return read_items(file, flag, parse_numbers_file);
}

std::vector<WrittenPair> parse_pairs_file(std::string_view bytes, const std::string& where) {
  return parse_items(bytes, where, "pair", parse_pairs_list, parse_pairs_text);
}

std::vector<WrittenPair> read_pairs(const std::filesystem::path& file, const std::string& flag) {
  return read_items(file, flag, parse_pairs_file);
}

std::vector<WrittenSet> parse_sets_file(std::string_view bytes, const std::string& where) {
  return parse_items(bytes, where, "set", parse_sets_list, parse_sets_text);
}

std::vector<WrittenSet> read_sets(const std::filesystem::path& file, const std::string& flag) {
  return read_items(file, flag, parse_sets_file);
}

PlacedPoint place(const WrittenPoint& point, const NearestPointSearch& surface) {
  try {
    const double initial = point.initial.value_or(0);
    if (point.kind != Kind::place) {
      return {.at = on_surface(point, surface.mesh()), .initial = initial};
    }
    const NearestPoint nearest = surface.nearest_to(point.numbers);
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
  const InternalPoint own = in_internal_numbers(mesh, point);
  const Index under = edge_under(own);
  if (under == kNone) {
    append_text(text = "face:", point.face);
    char before = ':';
    for (const double weight : point.weights) {
      append_text(text += before, weight);
      before = ',';
    }
    return text;
  }
  const Triangle corners = mesh.triangle(own.face);
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
