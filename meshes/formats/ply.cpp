// PLY (Turk 1994): ASCII, binary little-endian and binary big-endian. Read are the x, y, z of the
// element "vertex" and the list "vertex_indices" (or "vertex_index") of the element "face"; other
// properties and elements are walked over.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "meshes/formats/bytes.h"
#include "meshes/formats/parsers.h"
#include "meshes/formats/polygons.h"
#include "meshes/formats/text.h"

namespace geodesic {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct TypeName {
  std::string_view name;
  Type type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{{"char", Type::int8},
                                                  {"int8", Type::int8},
                                                  {"uchar", Type::uint8},
                                                  {"uint8", Type::uint8},
                                                  {"short", Type::int16},
                                                  {"int16", Type::int16},
                                                  {"ushort", Type::uint16},
                                                  {"uint16", Type::uint16},
                                                  {"int", Type::int32},
                                                  {"int32", Type::int32},
                                                  {"uint", Type::uint32},
                                                  {"uint32", Type::uint32},
                                                  {"float", Type::float32},
                                                  {"float32", Type::float32},
                                                  {"double", Type::float64},
                                                  {"float64", Type::float64}}};

std::size_t size_of(Type type) {
  switch (type) {
    case Type::int8:
    case Type::uint8:
      return 1;
    case Type::int16:
    case Type::uint16:
      return 2;
    case Type::int32:
    case Type::uint32:
    case Type::float32:
      return 4;
    case Type::float64:
      break;
  }
  return 8;
}

bool is_real(Type type) { return type == Type::float32 || type == Type::float64; }

// What the reader does with the values of a property.
enum class Role { skip, x, y, z, corners };

struct Property {
  std::string name;
  Type type = Type::float32;
  std::optional<Type> count_type;  // of a list
  Role role = Role::skip;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { ascii, little_endian, big_endian };

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

class HeaderParser {
 public:
  explicit HeaderParser(TextReader& reader) : reader_(reader) {}

  Header parse() {
    next_line();
    reader_.word();  // "ply", which recognised the format
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
    const std::string_view encoding = reader_.word();
    if (encoding == "ascii") {
      header_.encoding = Encoding::ascii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = Encoding::little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = Encoding::big_endian;
    } else {
      reader_.fail("unknown encoding " + in_quotes(encoding) +
                   "; there are ascii, binary_little_endian and binary_big_endian");
    }
    const std::string_view version = reader_.word();
    if (version != "1.0") reader_.fail("version " + in_quotes(version) + " is not 1.0");
  }

  void read_element() {
    Element element;
    element.name = reader_.word();
    const std::int64_t count = reader_.integer("number of elements");
    if (count < 0) reader_.fail("the number of elements is negative");
    element.count = static_cast<std::uint64_t>(count);
    if (to_index(count) == kNone) {
      reader_.fail(std::to_string(count) + " elements are more than can be numbered");
    }
    for (const Element& other : header_.elements) {
      if (other.name == element.name) reader_.fail("two elements " + in_quotes(element.name));
    }
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) reader_.fail("a property before the first element");
    Property property;
    std::string_view word = reader_.word();
    if (word == "list") {
      property.count_type = type(reader_.word());
      if (is_real(*property.count_type)) reader_.fail("a list is counted with whole numbers");
      word = reader_.word();
    }
    property.type = type(word);
    property.name = reader_.word();
    if (property.name.empty()) reader_.fail("a property without a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  Type type(std::string_view word) const {
    for (const TypeName& known : kTypeNames) {
      if (known.name == word) return known.type;
    }
    reader_.fail("unknown type " + in_quotes(word) + " of a property");
  }

  void assign_roles() {
    for (Element& element : header_.elements) {
      if (element.properties.empty() && element.count > 0) {
        reader_.fail("the element " + in_quotes(element.name) + " has no properties");
      }
      if (element.name == "vertex") {
        assign(element, {"x"}, Role::x);
        assign(element, {"y"}, Role::y);
        assign(element, {"z"}, Role::z);
      } else if (element.name == "face") {
        assign(element, {"vertex_indices", "vertex_index"}, Role::corners);
      }
    }
    require("vertex", "positions");
    require("face", "polygons (triangle strips are not supported)");
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
    if (found->count_type.has_value() != (role == Role::corners)) {
      reader_.fail(wanted + (role == Role::corners ? " is no list" : " is a list"));
    }
    if (role == Role::corners && is_real(found->type)) reader_.fail(wanted + " has real numbers");
    found->role = role;
  }

  void require(std::string_view name, const std::string& holding) const {
    for (const Element& element : header_.elements) {
      if (element.name == name) return;
    }
    reader_.fail("there is no element '" + std::string(name) + "' with " + holding);
  }

  TextReader& reader_;
  Header header_;
};

// What is being read, for messages.
struct Row {
  std::string_view element;
  std::uint64_t number = 0;
  std::string text() const {
    return "element " + std::to_string(number) + " of " + in_quotes(element);
  }
};

// The values of an ASCII file: a line a row.
class AsciiValues {
 public:
  explicit AsciiValues(TextReader& reader) : reader_(reader) {}

  std::size_t bytes_left() const { return reader_.bytes_left() + 1; }  // a last line end may lack
  static std::size_t least_bytes(const Property& /*property*/) { return 2; }
  std::uint32_t line() const { return reader_.line(); }

  void begin_row(Row row) {
    if (!reader_.next_line()) reader_.fail_truncated(row.text());
  }
  double real(Type /*type*/) { return reader_.number("number"); }
  std::int64_t integer(Type /*type*/) { return reader_.integer("whole number"); }
  void skip(Type /*type*/) { reader_.number("number"); }
  void end_row() {
    if (!reader_.at_line_end()) reader_.fail("more numbers than the header's properties");
  }
  void end_file(MeshFile& file) {
    if (reader_.next_line()) reader_.fail("more lines than the header's counts; correct them");
    if (!reader_.ends_with_line_end()) file.warnings.push_back(kNoLineEnd);
  }
  [[noreturn]] void fail(const std::string& what) const { reader_.fail(what); }

 private:
  TextReader& reader_;
};

// The values of a binary file.
class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, std::size_t offset, std::endian order,
               const std::string& name)
      : bytes_(bytes), offset_(offset), order_(order), name_(name) {}

  std::size_t bytes_left() const { return bytes_.size() - offset_; }
  static std::size_t least_bytes(const Property& property) {
    return size_of(property.count_type.value_or(property.type));
  }
  static std::uint32_t line() { return 0; }

  void begin_row(Row row) { row_ = row; }
  double real(Type type) {
    if (type == Type::float32) return take<float>();
    if (type == Type::float64) return take<double>();
    return static_cast<double>(integer(type));
  }
  std::int64_t integer(Type type) {
    switch (type) {
      case Type::int8:
        return take<std::int8_t>();
      case Type::uint8:
        return take<std::uint8_t>();
      case Type::int16:
        return take<std::int16_t>();
      case Type::uint16:
        return take<std::uint16_t>();
      case Type::int32:
        return take<std::int32_t>();
      case Type::uint32:
        return take<std::uint32_t>();
      case Type::float32:
      case Type::float64:
        break;
    }
    fail("a real number where a whole one is needed");
  }
  void skip(Type type) { advance(size_of(type)); }
  void end_row() {}
  void end_file(MeshFile& /*file*/) const {
    if (bytes_.find_first_not_of(" \t\r\n", offset_) == std::string_view::npos) return;
    fail(std::to_string(bytes_left()) +
         " bytes behind the last element of the header; correct its counts");
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw MeshError(name_ + ", byte " + std::to_string(offset_) + ": " + what);
  }

 private:
  const char* advance(std::size_t size) {
    if (size > bytes_left()) {
      fail("the file ends inside " + row_.text() + ": it is truncated; get a whole copy");
    }
    const char* const at = bytes_.data() + offset_;
    offset_ += size;
    return at;
  }

  template <class T>
  T take() {
    return load_number<T>(advance(sizeof(T)), order_);
  }

  std::string_view bytes_;
  std::size_t offset_;
  std::endian order_;
  const std::string& name_;
  Row row_;
};

template <class Values>
class BodyParser {
 public:
  BodyParser(Values values, MeshFile& file, Polygons& polygons)
      : values_(std::move(values)), file_(file), polygons_(polygons) {}

  void parse(const std::vector<Element>& elements) {
    for (const Element& element : elements) {
      check_room(element);
      for (std::uint64_t i = 0; i < element.count; ++i) read_row(element, i);
    }
    values_.end_file(file_);
  }

 private:
  // Nothing is allocated for a count that the rest of the file cannot hold.
  void check_room(const Element& element) {
    std::size_t row = 0;
    for (const Property& property : element.properties) row += Values::least_bytes(property);
    if (element.count * row > values_.bytes_left()) {
      values_.fail("the header promises " + std::to_string(element.count) + " times " +
                   in_quotes(element.name) + ", at least " + std::to_string(element.count * row) +
                   " bytes, but only " + std::to_string(values_.bytes_left()) +
                   " are left: the file is truncated; get a whole copy");
    }
    if (element.name == "vertex") file_.soup.positions.reserve(element.count);
    if (element.name == "face") polygons_.reserve(element.count);
  }

  void read_row(const Element& element, std::uint64_t i) {
    values_.begin_row({element.name, i});
    Vec3 position = {};
    for (const Property& property : element.properties) {
      switch (property.role) {
        case Role::x:
          position[0] = values_.real(property.type);
          break;
        case Role::y:
          position[1] = values_.real(property.type);
          break;
        case Role::z:
          position[2] = values_.real(property.type);
          break;
        case Role::corners:
          read_corners(property, i);
          break;
        case Role::skip:
          skip(property);
          break;
      }
    }
    values_.end_row();
    if (element.name == "vertex") {
      file_.soup.positions.push_back(position);
      if (values_.line() > 0) file_.lines.vertices.push_back(values_.line());
    }
  }

  void skip(const Property& property) {
    std::int64_t count = 1;
    if (property.count_type) {
      count = values_.integer(*property.count_type);
      if (count < 0)
        values_.fail("the list " + in_quotes(property.name) + " has a negative length");
    }
    for (std::int64_t k = 0; k < count; ++k) values_.skip(property.type);
  }

  void read_corners(const Property& property, std::uint64_t face) {
    const std::int64_t count = values_.integer(*property.count_type);
    if (count < 3) {
      values_.fail("face " + std::to_string(face) + " has " + std::to_string(count) +
                   " corners and needs three");
    }
    for (std::int64_t k = 0; k < count; ++k) {
      polygons_.add_corner(to_index(values_.integer(property.type)));
    }
    polygons_.end_polygon(values_.line());
  }

  Values values_;
  MeshFile& file_;
  Polygons& polygons_;
};

}  // namespace

MeshFile parse_ply(std::string_view bytes, const std::string& name) {
  TextReader reader(bytes, name);
  const Header header = HeaderParser(reader).parse();
  MeshFile file;
  Polygons polygons;
  if (header.encoding == Encoding::ascii) {
    file.format = "PLY ASCII";
    BodyParser(AsciiValues(reader), file, polygons).parse(header.elements);
  } else {
    const bool little = header.encoding == Encoding::little_endian;
    file.format = little ? "PLY binary little-endian" : "PLY binary big-endian";
    const BinaryValues values(bytes, bytes.size() - reader.bytes_left(),
                              little ? std::endian::little : std::endian::big, name);
    BodyParser(values, file, polygons).parse(header.elements);
  }
  polygons.triangulate(file, name);
  return file;
}

}  // namespace geodesic
