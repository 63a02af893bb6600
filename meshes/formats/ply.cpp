// PLY (Turk 1994): ASCII, binary little-endian and binary big-endian. The parser reads x, y, z of
// the element "vertex", and the lists "vertex_indices" (or "vertex_index") of the elements "face"
// and "tristrips"; it skips other properties and elements.
//
// A list of "tristrips" contains triangle strips, as range scanners write them: each vertex forms a
// triangle with the previous two, every second triangle is reversed, and -1 starts a new strip. A
// triangle that names a vertex twice joins two parts of a strip and is not part of the surface.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "meshes/formats/parsing.h"
#include "meshes/formats/polygons.h"

namespace geodesic {
namespace {

/// Type of a number in the file. Its values are exact as doubles, except integers of 64 bits above
/// 2^53, which are no counts or indices of any file.
struct Type {
  std::size_t bytes;
  bool real;
  double (*load)(const char* bytes, std::endian order);
};

template <class T>
constexpr Type ply_type() {
  return {sizeof(T), std::is_floating_point_v<T>, [](const char* bytes, std::endian order) {
            return static_cast<double>(load_number<T>(bytes, order));
          }};
}

constexpr std::array<std::pair<std::string_view, Type>, 18> kPlyTypes = {
    {{"char", ply_type<std::int8_t>()},
     {"int8", ply_type<std::int8_t>()},
     {"uchar", ply_type<std::uint8_t>()},
     {"uint8", ply_type<std::uint8_t>()},
     {"short", ply_type<std::int16_t>()},
     {"int16", ply_type<std::int16_t>()},
     {"ushort", ply_type<std::uint16_t>()},
     {"uint16", ply_type<std::uint16_t>()},
     {"int", ply_type<std::int32_t>()},
     {"int32", ply_type<std::int32_t>()},
     {"uint", ply_type<std::uint32_t>()},
     {"uint32", ply_type<std::uint32_t>()},
     {"int64", ply_type<std::int64_t>()},
     {"uint64", ply_type<std::uint64_t>()},
     {"float", ply_type<float>()},
     {"float32", ply_type<float>()},
     {"double", ply_type<double>()},
     {"float64", ply_type<double>()}}};

/// The use of a property's values.
enum class Role { skip, x, y, z, polygon, strips };  // x, y, z: a coordinate's number plus one

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count_type;  // type of the length of a list
  Role role = Role::skip;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { ascii, little_endian, big_endian };

struct PlyHeader {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

class HeaderParser {
 public:
  explicit HeaderParser(TextReader& reader) : reader_(reader) {}

  PlyHeader parse() {
    next_line();
    reader_.word();  // "ply", which was checked before
    if (!reader_.at_line_end()) reader_.fail("expected a line with the word 'ply' alone");
    next_line();
    read_format();
    while (true) {
      next_line();
      const std::string_view keyword = reader_.word();
      if (keyword == "end_header") break;
      if (keyword == "comment" || keyword == "obj_info") continue;
      if (keyword == "element") {
        read_element();
      } else if (keyword == "property") {
        read_property();
      } else {
        reader_.fail("unknown statement " + in_quotes(keyword) + " in a PLY header");
      }
    }
    assign_roles();
    return std::move(header_);
  }

 private:
  void next_line() {
    if (!reader_.next_line()) reader_.fail_truncated("'end_header'");
  }

  void read_format() {
    if (reader_.word() != "format") reader_.fail("expected the line 'format ...'");
    constexpr std::array<std::string_view, 3> kNames = {"ascii", "binary_little_endian",
                                                        "binary_big_endian"};  // by Encoding
    const std::string_view encoding = reader_.word();
    const auto found = std::ranges::find(kNames, encoding);
    if (found == kNames.end()) {
      reader_.fail("unknown encoding " + in_quotes(encoding) +
                   "; there are ascii, binary_little_endian and binary_big_endian");
    }
    header_.encoding = static_cast<Encoding>(found - kNames.begin());
    const std::string_view version = reader_.word();
    if (version != "1.0") reader_.fail("version " + in_quotes(version) + " is not 1.0");
  }

  void read_element() {
    Element element;
    element.name = reader_.word();
    element.count = reader_.count(reader_.word(), "elements");
    if (find(element.name) != nullptr) reader_.fail("two elements " + in_quotes(element.name));
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) reader_.fail("a property before the first element");
    std::optional<Type> count_type;
    std::string_view word = reader_.word();
    if (word == "list") {
      count_type = type(reader_.word());
      if (count_type->real) reader_.fail("a list must be counted with integers");
      word = reader_.word();
    }
    Property property{.name = {}, .type = type(word), .count_type = count_type};
    property.name = reader_.word();
    if (property.name.empty()) reader_.fail("a property without a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  Type type(std::string_view word) const {
    for (const auto& [name, type] : kPlyTypes) {
      if (name == word) return type;
    }
    reader_.fail("unknown type " + in_quotes(word) +
                 " of a property; there are (u)char, (u)short, (u)int, (u)int8 to (u)int64, float, "
                 "double, float32 and float64");
  }

  Element* find(std::string_view name) {
    const auto found = std::ranges::find(header_.elements, name, &Element::name);
    return found == header_.elements.end() ? nullptr : &*found;
  }

  void assign_roles() {
    for (const Element& element : header_.elements) {
      if (element.properties.empty() && element.count > 0) {
        reader_.fail("the element " + in_quotes(element.name) + " has no properties");
      }
    }
    Element* const vertex = find("vertex");
    if (vertex == nullptr) reader_.fail("there is no element 'vertex' with positions");
    assign(*vertex, {"x"}, Role::x);
    assign(*vertex, {"y"}, Role::y);
    assign(*vertex, {"z"}, Role::z);
    Element* const face = find("face");
    Element* const strips = find("tristrips");
    if (face == nullptr && strips == nullptr) {
      reader_.fail("there is no element 'face' with polygons nor 'tristrips' with triangle strips");
    }
    if (face != nullptr) assign(*face, {"vertex_indices", "vertex_index"}, Role::polygon);
    if (strips != nullptr) assign(*strips, {"vertex_indices", "vertex_index"}, Role::strips);
  }

  void assign(Element& element, std::initializer_list<std::string_view> names, Role role) const {
    const std::string wanted =
        "the property '" + std::string(*names.begin()) + "' of '" + element.name + "'";
    Property* found = nullptr;
    for (Property& property : element.properties) {
      if (std::find(names.begin(), names.end(), property.name) == names.end()) continue;
      if (found != nullptr) reader_.fail(wanted + " occurs twice");
      found = &property;
    }
    if (found == nullptr) reader_.fail(wanted + " is missing");
    const bool is_list = role == Role::polygon || role == Role::strips;
    if (found->count_type.has_value() != is_list) {
      reader_.fail(wanted + (is_list ? " is not a list" : " is a list"));
    }
    if (is_list && found->type.real) reader_.fail(wanted + " has real numbers");
    found->role = role;
  }

  TextReader& reader_;
  PlyHeader header_;
};

// The values after the header: numbers as words, one row per line, or binary.
class Values {
 public:
  /// @param reader a reader whose header was read
  Values(TextReader& reader, std::string_view bytes, Encoding encoding, const std::string& name)
      : reader_(reader),
        bytes_(bytes),
        offset_(bytes.size() - reader.bytes_left()),
        ascii_(encoding == Encoding::ascii),
        order_(encoding == Encoding::big_endian ? std::endian::big : std::endian::little),
        name_(name) {}

  std::size_t bytes_left() const {
    return ascii_ ? reader_.bytes_left() + 1  // the last line end may be missing
                  : bytes_.size() - offset_;
  }
  /// Least number of bytes of a property in a row.
  std::size_t least_bytes(const Property& property) const {
    return ascii_ ? 2 : property.count_type.value_or(property.type).bytes;
  }
  /// Line of the row; 0 in a binary file.
  std::uint32_t line() const { return ascii_ ? reader_.line() : 0; }

  void begin_row(std::string_view element, std::uint64_t number) {
    element_ = element;
    number_ = number;
    if (ascii_ && !reader_.next_line()) reader_.fail_truncated(row());
  }
  double real(const Type& type) {
    return ascii_ ? reader_.number("value") : type.load(advance(type.bytes), order_);
  }
  std::int64_t integer(const Type& type) {
    if (ascii_) return reader_.integer("value");
    constexpr double kBeyondAnyFile = 0x1p62;  // the greatest uint64 would not fit
    return static_cast<std::int64_t>(std::clamp(real(type), -kBeyondAnyFile, kBeyondAnyFile));
  }
  // Passes over a value that is not used; it need not be a number.
  void skip(const Type& type) {
    if (!ascii_) {
      advance(type.bytes);
    } else if (reader_.word().empty()) {
      fail("the value is missing");
    }
  }
  void end_row() {
    if (ascii_ && !reader_.at_line_end()) fail("more numbers than the header's properties");
  }
  void end_file(MeshFile& file) {
    if (!ascii_) {
      if (bytes_.find_first_not_of(" \t\r\n", offset_) == std::string_view::npos) return;
      fail(std::to_string(bytes_left()) +
           " bytes behind the last element of the header; correct its counts");
    }
    if (reader_.next_line()) fail("more lines than the header's counts; correct them");
    if (!reader_.ends_with_line_end()) file.warnings.push_back(kNoLineEnd);
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (ascii_) reader_.fail(what);
    throw MeshError(name_ + ", byte " + std::to_string(offset_) + ": " + what);
  }

 private:
  std::string row() const {
    return "element " + std::to_string(number_) + " of " + in_quotes(element_);
  }

  const char* advance(std::size_t size) {
    if (size > bytes_left()) {
      fail("the file ends inside " + row() + ": it is truncated; get a whole copy");
    }
    const char* const at = bytes_.data() + offset_;
    offset_ += size;
    return at;
  }

  TextReader& reader_;
  std::string_view bytes_;
  std::size_t offset_;
  bool ascii_;
  std::endian order_;
  const std::string& name_;
  std::string_view element_;  // the present row, for messages
  std::uint64_t number_ = 0;
};

class BodyParser {
 public:
  BodyParser(Values values, MeshFile& file, Polygons& polygons)
      : values_(values), file_(file), polygons_(polygons) {}

  void parse(const std::vector<Element>& elements) {
    for (const Element& element : elements) {
      check_room(element);
      const bool is_vertex = element.name == "vertex";
      for (std::uint64_t i = 0; i < element.count; ++i) {
        const Vec3 position = read_row(element, i);
        if (is_vertex) add_vertex(position);
      }
    }
    values_.end_file(file_);
    if (joints_ > 0) {
      file_.warnings.push_back(std::to_string(joints_) +
                               " triangles of strips name a vertex twice and are left out");
    }
  }

 private:
  // Rejects a count that the rest of the file cannot hold, before memory is allocated.
  void check_room(const Element& element) {
    std::size_t row = 0;
    for (const Property& property : element.properties) row += values_.least_bytes(property);
    if (element.count * row > values_.bytes_left()) {
      values_.fail("the header declares " + std::to_string(element.count) + " times " +
                   in_quotes(element.name) + ", at least " + std::to_string(element.count * row) +
                   " bytes, but only " + std::to_string(values_.bytes_left()) +
                   " are left: the file is truncated; get a whole copy");
    }
    if (element.name == "vertex") file_.soup.positions.reserve(element.count);
    if (element.name == "face") polygons_.reserve(element.count);
  }

  /// @return x, y and z of the row
  Vec3 read_row(const Element& element, std::uint64_t i) {
    values_.begin_row(element.name, i);
    Vec3 position = {};
    for (const Property& property : element.properties) {
      switch (property.role) {
        case Role::x:
        case Role::y:
        case Role::z:
          position[static_cast<std::size_t>(property.role) - 1] = values_.real(property.type);
          break;
        case Role::polygon:
          read_polygon(property);
          break;
        case Role::strips:
          read_strips(property);
          break;
        case Role::skip:
          const std::int64_t count = property.count_type ? list_length(property) : 1;
          for (std::int64_t k = 0; k < count; ++k) values_.skip(property.type);
          break;
      }
    }
    values_.end_row();
    return position;
  }

  void add_vertex(const Vec3& position) {
    file_.soup.positions.push_back(position);
    if (values_.line() > 0) file_.lines.vertices.push_back(values_.line());
  }

  std::int64_t list_length(const Property& property) {
    const std::int64_t length = values_.integer(*property.count_type);
    if (length < 0) values_.fail("the list " + in_quotes(property.name) + " has a negative length");
    return length;
  }

  void read_polygon(const Property& property) {
    for (std::int64_t left = list_length(property); left > 0; --left) {
      polygons_.add_corner(to_index(values_.integer(property.type)));
    }
    polygons_.end_polygon(values_.line());
  }

  void read_strips(const Property& property) {
    std::array<Index, 2> last = {};
    std::size_t length = 0;
    const auto end_strip = [&] {
      if (length == 1 || length == 2) {  // a face that has too few corners
        for (std::size_t k = 2 - length; k < 2; ++k) polygons_.add_corner(last[k]);
        polygons_.end_polygon(values_.line());
      }
      length = 0;
    };
    for (std::int64_t left = list_length(property); left > 0; --left) {
      const std::int64_t value = values_.integer(property.type);
      if (value == -1) {
        end_strip();
        continue;
      }
      const Index v = to_index(value);
      if (length >= 2) add_triangle(last[length % 2], last[1 - length % 2], v);
      last = {last[1], v};
      ++length;
    }
    end_strip();
  }

  void add_triangle(Index a, Index b, Index c) {
    const auto same = [](Index v, Index w) { return v == w && v != kNone; };
    if (same(a, b) || same(b, c) || same(c, a)) {
      ++joints_;
      return;
    }
    for (const Index v : {a, b, c}) polygons_.add_corner(v);
    polygons_.end_polygon(values_.line());
  }

  Values values_;
  MeshFile& file_;
  Polygons& polygons_;
  std::size_t joints_ = 0;  // triangles of strips that name a vertex twice
};

}  // namespace

MeshFile parse_ply(std::string_view bytes, const std::string& name) {
  TextReader reader(bytes, name);
  const PlyHeader header = HeaderParser(reader).parse();
  MeshFile file;
  Polygons polygons;
  constexpr std::array kFormats = {"PLY ASCII", "PLY binary little-endian",
                                   "PLY binary big-endian"};  // by Encoding
  file.format = kFormats[static_cast<std::size_t>(header.encoding)];
  BodyParser(Values(reader, bytes, header.encoding, name), file, polygons).parse(header.elements);
  polygons.triangulate(file);
  return file;
}

}  // namespace geodesic
