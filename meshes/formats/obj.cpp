// Wavefront OBJ: v and f statements. Appearance is skipped; other geometry (lines, points,
// free-form surfaces) is reported. OBJ files contain no counts: a file cut off between two lines
// seems complete, and a file cut off inside its last line causes at least a warning.
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "meshes/formats/parsing.h"
#include "meshes/formats/polygons.h"

namespace geodesic {
namespace {

using namespace std::string_view_literals;

// Statements that do not concern the shape of the surface.
constexpr std::array kAppearance = {
    "vt"sv,     "vn"sv,     "g"sv,          "s"sv,         "o"sv,    "mg"sv,       "usemtl"sv,
    "mtllib"sv, "usemap"sv, "maplib"sv,     "bevel"sv,     "lod"sv,  "c_interp"sv, "d_interp"sv,
    "ctech"sv,  "stech"sv,  "shadow_obj"sv, "trace_obj"sv, "call"sv, "csh"sv};

// Geometry other than polygons.
constexpr std::array kOtherGeometry = {
    "l"sv,     "p"sv,    "vp"sv,   "cstype"sv, "deg"sv,  "bmat"sv, "step"sv, "curv"sv,
    "curv2"sv, "surf"sv, "parm"sv, "trim"sv,   "hole"sv, "scrv"sv, "sp"sv,   "end"sv,
    "con"sv,   "cdc"sv,  "cdp"sv,  "bzp"sv,    "bsp"sv,  "res"sv};

template <class Words>
bool contains(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& name)
      : reader_(text, name, {.comment = '#', .continuations = true}) {
    file_.format = "OBJ";
  }

  MeshFile parse() {
    while (reader_.next_line()) statement(reader_.word());
    for (const auto& [keyword, count] : ignored_) {
      file_.warnings.push_back(std::to_string(count) + " statements '" + keyword +
                               "' are ignored: only polygons are read");
    }
    if (!reader_.ends_with_line_end()) file_.warnings.push_back(kNoLineEnd);
    polygons_.triangulate(file_);
    return std::move(file_);
  }

 private:
  void statement(std::string_view keyword) {
    if (keyword == "v") {
      vertex();
    } else if (keyword == "f") {
      face();
    } else if (contains(kOtherGeometry, keyword)) {
      ++ignored_[std::string(keyword)];
    } else if (!contains(kAppearance, keyword)) {
      reader_.fail("unknown statement " + in_quotes(keyword) +
                   "; is the file OBJ, and is it damaged or truncated?");
    }
  }

  // Reads x y z, then a weight or a colour, or both.
  void vertex() {
    Vec3 position;
    position[0] = reader_.number("x coordinate");
    position[1] = reader_.number("y coordinate");
    position[2] = reader_.number("z coordinate");
    file_.soup.positions.push_back(position);
    file_.lines.vertices.push_back(reader_.line());
    constexpr int kMostExtras = 5;
    int extras = 0;
    for (; !reader_.at_line_end(); ++extras) reader_.number("weight or colour");
    if (extras > kMostExtras) {
      reader_.fail("a vertex has " + std::to_string(3 + extras) +
                   " numbers; are two lines joined into one?");
    }
  }

  void face() {
    while (!reader_.at_line_end()) polygons_.add_corner(corner(reader_.word()));
    polygons_.end_polygon(reader_.line());
  }

  // Reads v, v/vt, v//vn or v/vt/vn, where a number may be missing after its slash. Numbers count
  // from 1, or backwards from -1, the last vertex read.
  Index corner(std::string_view word) const {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::int64_t number = reader_.to_integer(word.substr(0, slash), "vertex of a face");
    if (slash < word.size()) check_references(word.substr(slash + 1));
    const auto read = static_cast<std::int64_t>(file_.soup.positions.size());
    return to_index(number > 0 ? number - 1 : number < 0 ? read + number : -1);
  }

  // Checks the texture and the normal of a corner: vt, /vn or vt/vn, each of which may be empty.
  void check_references(std::string_view references) const {
    const std::size_t slash = std::min(references.find('/'), references.size());
    const std::string_view texture = references.substr(0, slash);
    if (!texture.empty()) reader_.to_integer(texture, "texture of a corner");
    if (slash + 1 < references.size()) {
      reader_.to_integer(references.substr(slash + 1), "normal of a corner");
    }
  }

  TextReader reader_;
  MeshFile file_;
  Polygons polygons_;
  std::map<std::string, std::size_t> ignored_;
};

}  // namespace

MeshFile parse_obj(std::string_view text, const std::string& name) {
  return ObjParser(text, name).parse();
}

}  // namespace geodesic
