// OFF (Geomview): a header, three counts, the vertices and the faces, as text or binary. Any white
// space separates numbers, including line ends, with two exceptions. The words after a face's
// corners on the same line are its colour, unless fewer lines are left than faces: then they are
// the next face. The colour of a vertex has four numbers, or three if the line ends after them. The
// variants with texture coordinates, colours and normals per vertex (ST, C, N before OFF, in any
// order) are also read, and headers that announce them although each vertex has three numbers;
// vertices in another dimension are rejected. Binary files have 32-bit integers and floats in
// big-endian order; the corners of a face are followed by the count of its colour's numbers.
#include <charconv>
#include <optional>
#include <utility>

#include "meshes/formats/parsing.h"
#include "meshes/formats/polygons.h"

namespace geodesic {
namespace {

bool remove_prefix(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

class OffParser {
 public:
  OffParser(std::string_view text, const std::string& name)
      : reader_(text, name, {.comment = '#'}), bytes_(text), name_(name) {}

  MeshFile parse() {
    read_header();
    check_room();
    if (!binary_ && vertices_ > 0) check_announced();
    if (homogeneous_) reject_dimension();
    for (number_ = 0; number_ < vertices_; ++number_) read_vertex();
    for (number_ = 0; number_ < faces_; ++number_) read_face();
    check_end();
    file_.format = binary_ ? "OFF binary" : "OFF";
    polygons_.triangulate(file_);
    return std::move(file_);
  }

 private:
  void read_header() {
    if (!reader_.next_line()) reader_.fail_truncated("the header");
    std::string_view word = reader_.word();
    keyword_ = word.substr(0, word.find("OFF") + 3);
    while (!remove_prefix(word, "OFF")) {
      if (remove_prefix(word, "ST")) {
        vertex_numbers_ += 2;
      } else if (remove_prefix(word, "N")) {
        vertex_numbers_ += 3;
      } else if (remove_prefix(word, "C")) {
        vertex_numbers_ += 4;
        colours_ = true;
      } else if (remove_prefix(word, "4")) {
        vertex_numbers_ += 1;
        homogeneous_ = true;
      } else if (word.starts_with("n")) {
        reject_dimension();
      } else {
        reader_.fail("unknown header " + in_quotes(keyword_) + "; it is [ST][C][N]OFF");
      }
    }
    // Some writers put the counts directly after the keyword: OFF490 518 0.
    if (word.empty() && reader_.at_line_end() && !reader_.next_line()) {
      reader_.fail_truncated("the counts");
    }
    if (word.empty()) word = reader_.word();
    binary_ = word == "BINARY";
    if (binary_) {
      if (!reader_.at_line_end()) reader_.fail("binary OFF has its counts on the next line");
      offset_ = bytes_.size() - reader_.bytes_left();
      vertices_ = binary_count("vertices");
      faces_ = binary_count("faces");
      load<std::int32_t>();  // edges
      return;
    }
    vertices_ = reader_.count(word, "vertices");
    faces_ = reader_.count(reader_.word(), "faces");
    if (!reader_.at_line_end()) reader_.integer("number of edges");
    if (!reader_.at_line_end()) reader_.fail("a header has three counts: vertices, faces, edges");
  }

  // Rejects counts that the rest of the file cannot hold, before memory is allocated. A vertex
  // takes at least six bytes ("0 0 0" and a line end, which only the last line may lack), a face
  // without corners two; a binary one has two numbers.
  void check_room() {
    const std::size_t vertex = binary_ ? 4 * vertex_numbers_ : 6;
    const std::size_t face = binary_ ? 4 * 2 : 2;
    const std::size_t left = binary_ ? bytes_.size() - offset_ : reader_.bytes_left();
    if (vertex * vertices_ + face * faces_ > left + (binary_ ? 0 : 1)) {
      fail("the header declares " + std::to_string(vertices_) + " vertices and " +
           std::to_string(faces_) + " faces, but only " + std::to_string(left) +
           " bytes follow: the file is truncated; get a whole copy");
    }
    file_.soup.positions.reserve(vertices_);
    if (!binary_) file_.lines.vertices.reserve(vertices_);
    polygons_.reserve(faces_);
  }

  [[noreturn]] void reject_dimension() const {
    reader_.fail("vertices of another dimension than three (" + in_quotes(keyword_) +
                 ") are not supported");
  }

  // Compares the header with the lines of vertices, where these decide it.
  void check_announced() {
    const std::optional<std::size_t> numbers = other_numbers_per_vertex();
    if (!numbers) return;
    const std::string header = "the header " + in_quotes(keyword_) + " announces " +
                               std::to_string(vertex_numbers_) + " numbers a vertex";
    if (*numbers != 3) {
      reader_.next_line();
      reader_.fail(header + ", but each has " + std::to_string(*numbers) +
                   "; correct it: ST announces 2 of a texture, C 4 of a colour, N 3 of a normal");
    }
    file_.warnings.push_back(header + ", but each has 3, its coordinates");
    vertex_numbers_ = 3;
    colours_ = homogeneous_ = false;
  }

  // The number of numbers of each vertex, if it is not the announced one and every vertex and every
  // face has a line of its own. Such a text cannot be read in another way.
  std::optional<std::size_t> other_numbers_per_vertex() const {
    TextReader rest = reader_;
    const auto next_words = [&rest] {
      std::vector<std::string_view> words;
      if (rest.next_line()) {
        while (!rest.at_line_end()) words.push_back(rest.word());
      }
      return words;
    };
    const std::size_t numbers = next_words().size();
    if (numbers == vertex_numbers_ || (colours_ && numbers + 1 == vertex_numbers_)) return {};
    for (std::size_t v = 1; v < vertices_; ++v) {
      if (next_words().size() != numbers) return {};
    }
    for (std::size_t f = 0; f < faces_; ++f) {
      const std::vector<std::string_view> words = next_words();
      std::size_t corners = 0;
      if (!words.empty()) {
        std::from_chars(words[0].data(), words[0].data() + words[0].size(), corners);
      }
      if (corners < 3 || words.size() <= corners) return {};
    }
    if (rest.next_line()) return {};
    return numbers;
  }

  void read_vertex() {
    const std::uint32_t line = begin("vertex");
    Vec3 position;
    for (std::size_t k = 0; k < vertex_numbers_; ++k) {
      const bool colour_of_three = colours_ && !binary_ && k + 1 == vertex_numbers_;
      if (colour_of_three && reader_.at_line_end()) break;
      if (k < 3) {
        position[k] = real("coordinate");
      } else {
        skip();
      }
    }
    file_.soup.positions.push_back(position);
    if (line > 0) file_.lines.vertices.push_back(line);
  }

  void read_face() {
    const std::uint32_t line = begin("face");
    const std::int64_t corners = integer("number of corners");
    if (corners < 0 || (corners < 3 && remarked_)) {  // on a shared line, it is another number
      fail("face " + std::to_string(number_) + " has " + std::to_string(corners) +
           " corners and needs three; remove it and correct the count of faces");
    }
    for (std::int64_t k = 0; k < corners; ++k) {
      polygons_.add_corner(to_index(integer("vertex of a face")));
    }
    std::int64_t colours = binary_ ? integer("number of colours") : 0;
    for (std::int64_t k = 0; binary_ && k < colours && k <= 4; ++k) real("colour of a face");
    if (!binary_ && !reader_.at_line_end() && !faces_share_lines()) {
      for (; !reader_.at_line_end(); ++colours) reader_.number("colour of a face");
    }
    if (colours < 0 || colours > 4) {
      fail("face " + std::to_string(number_) + " has " + std::to_string(colours) +
           " numbers of a colour, not 0 to 4");
    }
    polygons_.end_polygon(line);
  }

  // Called after a face that does not end its line; computed once.
  bool faces_share_lines() {
    if (!share_lines_) {
      TextReader rest = reader_;
      std::size_t left = faces_ - number_ - 1;
      while (left > 0 && rest.next_line()) --left;
      share_lines_ = left > 0;
    }
    return *share_lines_;
  }

  void check_end() {
    const std::string declared = "the header's " + std::to_string(vertices_) + " vertices and " +
                                 std::to_string(faces_) + " faces; correct the counts";
    if (binary_) {
      if (bytes_.find_first_not_of(" \t\r\n", offset_) == std::string_view::npos) return;
      fail(std::to_string(bytes_.size() - offset_) + " bytes more than " + declared);
    }
    if (!reader_.at_line_end() || reader_.next_line()) fail("more numbers than " + declared);
    if (!reader_.ends_with_line_end()) file_.warnings.push_back(kNoLineEnd);
  }

  // Begins a vertex or face and returns its line; 0 in a binary file.
  std::uint32_t begin(std::string_view element) {
    element_ = element;
    if (binary_) return 0;
    if (!reader_.at_line_end()) {
      remark_on_line();
    } else if (!reader_.next_line()) {
      reader_.fail_truncated(rest_of_element());
    }
    return reader_.line();
  }

  double real(std::string_view what) {
    return binary_ ? load<float>() : reader_.to_number(word(), what);
  }
  // Passes over a number of a colour, a texture or a normal; it need not be one in a text.
  void skip() {
    if (binary_) {
      load<float>();
    } else {
      word();
    }
  }
  std::int64_t integer(std::string_view what) {
    return binary_ ? load<std::int32_t>() : reader_.to_integer(word(), what);
  }

  std::string_view word() {
    std::string_view found = reader_.word();
    if (!found.empty()) return found;
    remark_on_line();
    found = reader_.word_across_lines();
    if (found.empty()) reader_.fail_truncated(rest_of_element());
    return found;
  }

  // An error in a line may become apparent only much later.
  void remark_on_line() {
    if (std::exchange(remarked_, true)) return;
    reader_.add_to_messages(" (line " + std::to_string(reader_.line()) +
                            " is the first that is not one vertex or one face; a header COFF "
                            "announces colours of vertices, NOFF normals)");
  }

  // Reads the next binary number.
  template <class T>
  T load() {
    if (bytes_.size() - offset_ < sizeof(T)) {
      fail("the file ends before " + rest_of_element() + ": it is truncated; get a whole copy");
    }
    offset_ += sizeof(T);
    return load_number<T>(bytes_.data() + offset_ - sizeof(T), std::endian::big);
  }

  std::size_t binary_count(const std::string& what) {
    const auto count = load<std::int32_t>();
    if (count < 0) fail("the number of " + what + " is negative");
    return static_cast<std::size_t>(count);
  }

  std::string rest_of_element() const {
    if (element_.empty()) return "the end of the counts";
    return "the end of " + std::string(element_) + " " + std::to_string(number_) + " of " +
           std::to_string(element_ == "face" ? faces_ : vertices_);
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (!binary_) reader_.fail(what);
    throw MeshError(name_ + ", byte " + std::to_string(offset_) + ": " + what);
  }

  TextReader reader_;
  std::string_view bytes_;
  const std::string& name_;
  MeshFile file_;
  Polygons polygons_;
  bool binary_ = false;
  std::size_t offset_ = 0;  // position of the next binary number
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  std::string_view keyword_;        // "STCNOFF"
  std::size_t vertex_numbers_ = 3;  // coordinates and the numbers that the header announces
  bool colours_ = false;            // the last number of a vertex in text may be missing
  bool homogeneous_ = false;        // a fourth coordinate is announced
  std::string_view element_;        // present element, "vertex" or "face"; number_ is its index
  std::size_t number_ = 0;
  std::optional<bool> share_lines_;  // whether faces share lines, once known
  bool remarked_ = false;
};

}  // namespace

MeshFile parse_off(std::string_view text, const std::string& name) {
  return OffParser(text, name).parse();
}

}  // namespace geodesic
