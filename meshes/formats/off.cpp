// OFF (Geomview): a header, three counts, one line a vertex, and the faces. A line with more
// numbers than its face has corners ends with a colour; with fewer, the face continues on the next
// line. The variants with texture coordinates, colours and normals a vertex (ST, C, N before OFF)
// are read too, those in another dimension and the binary one are refused.
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
      : reader_(text, name, {.comment = '#'}), name_(name) {
    file_.format = "OFF";
  }

  MeshFile parse() {
    read_header();
    for (std::size_t i = 0; i < vertices_; ++i) read_vertex(i);
    for (std::size_t i = 0; i < faces_; ++i) read_face(i);
    if (reader_.next_line()) {
      reader_.fail("more lines than the header's " + std::to_string(vertices_) + " vertices and " +
                   std::to_string(faces_) + " faces; correct the counts");
    }
    if (!reader_.ends_with_line_end()) file_.warnings.push_back(kNoLineEnd);
    polygons_.triangulate(file_, name_);
    return std::move(file_);
  }

 private:
  void read_header() {
    if (!reader_.next_line()) reader_.fail_truncated("the header");
    const std::string_view header = reader_.word();
    std::string_view word = header;
    const bool texture = remove_prefix(word, "ST");
    colours_ = remove_prefix(word, "C");
    const bool normals = remove_prefix(word, "N");
    extras_ = (texture ? 2u : 0u) + (normals ? 3u : 0u);
    if (word.starts_with("4") || word.starts_with("n")) {
      reader_.fail("vertices of another dimension than three (" + in_quotes(header) +
                   ") are not supported");
    }
    remove_prefix(word, "OFF");
    // Some writers put the counts directly behind the keyword: OFF490 518 0.
    if (word.empty() && reader_.at_line_end() && !reader_.next_line()) {
      reader_.fail_truncated("the counts");
    }
    if (word.empty()) word = reader_.word();
    if (word == "BINARY") {
      reader_.fail("binary OFF is not supported; convert the file to ASCII OFF or to PLY");
    }
    vertices_ = reader_.count(word, "vertices");
    faces_ = reader_.count(reader_.word(), "faces");
    if (!reader_.at_line_end()) reader_.integer("number of edges");
    if (!reader_.at_line_end()) reader_.fail("a header has three counts: vertices, faces, edges");
    check_room();
  }

  // Nothing is allocated for counts that the rest of the file cannot hold: a vertex takes at least
  // six bytes ("0 0 0" and a line end, which only the last line may lack), a face eight.
  void check_room() {
    if (6 * vertices_ + 8 * faces_ > reader_.bytes_left() + 1) {
      reader_.fail("the header declares " + std::to_string(vertices_) + " vertices and " +
                   std::to_string(faces_) + " faces, but only " +
                   std::to_string(reader_.bytes_left()) +
                   " bytes follow: the file is truncated; get a whole copy");
    }
    file_.soup.positions.reserve(vertices_);
    file_.lines.vertices.reserve(vertices_);
    polygons_.reserve(faces_);
  }

  void next_line_of(const std::string& what, std::size_t i, std::size_t declared) {
    if (reader_.next_line()) return;
    fail_truncated(what + " " + std::to_string(i) + " of " + std::to_string(declared));
  }

  void read_vertex(std::size_t i) {
    next_line_of("vertex", i, vertices_);
    Vec3 position;
    for (double& coordinate : position) coordinate = reader_.number("coordinate");
    std::size_t extras = 0;
    for (; !reader_.at_line_end(); ++extras) reader_.number("number behind the coordinates");
    // A colour has three or four numbers.
    const bool fits = colours_ ? extras == extras_ + 3 || extras == extras_ + 4 : extras == extras_;
    if (!fits) {
      reader_.fail("vertex " + std::to_string(i) + " has " + std::to_string(3 + extras) +
                   " numbers, which does not fit the header; a header COFF announces colours, "
                   "NOFF normals, and every vertex has a line of its own");
    }
    file_.soup.positions.push_back(position);
    file_.lines.vertices.push_back(reader_.line());
  }

  // A count of corners and their vertices, which may continue on later lines, and perhaps a colour
  // at the end of the last line.
  void read_face(std::size_t i) {
    next_line_of("face", i, faces_);
    const std::uint32_t line = reader_.line();
    const std::int64_t corners = reader_.integer("number of corners");
    if (corners < 3) {
      reader_.fail("face " + std::to_string(i) + " has " + std::to_string(corners) +
                   " corners and needs three; remove it and correct the count of faces");
    }
    for (std::int64_t k = 0; k < corners; ++k) {
      if (reader_.at_line_end() && first_continued_ == 0) first_continued_ = line;
      const std::string_view word = reader_.word_across_lines();
      if (word.empty())
        fail_truncated("corner " + std::to_string(k) + " of face " + std::to_string(i));
      polygons_.add_corner(to_index(reader_.to_integer(word, "vertex of a face")));
    }
    std::size_t colours = 0;
    for (; !reader_.at_line_end(); ++colours) reader_.number("colour of a face");
    if (colours > 4) reader_.fail("face " + std::to_string(i) + " has too many numbers");
    polygons_.end_polygon(line);
  }

  // A count of corners that is too high takes the next face for its own continuation: the end of
  // the file is then missed far from the mistake.
  [[noreturn]] void fail_truncated(const std::string& missing) const {
    reader_.fail_truncated(missing +
                           (first_continued_ == 0
                                ? ""
                                : " (the face of line " + std::to_string(first_continued_) +
                                      " is the first that continues on the next line)"));
  }

  TextReader reader_;
  const std::string& name_;
  MeshFile file_;
  Polygons polygons_;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  std::size_t extras_ = 0;  // numbers of a vertex besides coordinates and colour
  bool colours_ = false;
  std::uint32_t first_continued_ = 0;  // line of the first face that continues on the next line
};

}  // namespace

MeshFile parse_off(std::string_view text, const std::string& name) {
  return OffParser(text, name).parse();
}

}  // namespace geodesic
