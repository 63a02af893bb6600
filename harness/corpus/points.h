// Points of the surface, and numbers of vertices and faces, as users write them, on the command
// line and in files.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/base/json.h"
#include "meshes/nearest_point.h"
#include "solvers/core/query.h"

namespace geodesic::harness {

/// The forms of a point, for help and messages.
inline constexpr const char* kPointForms =
    "12 (a vertex), edge:3-7:0.25, face:345:0.2,0.3,0.5 or at:0.1,2,-3 (the point nearest to this "
    "place in space)";

/// A point as it was written, before a mesh is read.
struct WrittenPoint {
  enum class Kind { vertex, edge, face, place };

  std::string text;  ///< the point and its origin, for messages: "--source 12"
  Kind kind = Kind::vertex;
  std::array<Index, 2> elements = {};  ///< the vertex; the ends of an edge; the face
  std::array<double, 3> numbers = {};  ///< the share of an edge; weights; coordinates
  std::optional<double> initial = {};  ///< initial distance, of a source
};

/// Parses points separated by commas: "12,edge:3-7:0.25+0.5". The last has an initial distance.
///
///     VERTEX | edge:VERTEX-VERTEX:SHARE | face:FACE:WEIGHT,WEIGHT,WEIGHT | at:X,Y,Z
///
/// +DISTANCE after a point is its initial distance. SHARE is the part of the way from the first
/// vertex to the second. The weights belong to the face's corners in their order and sum up to 1.
/// Vertices and faces are numbered from 0 in the order of the mesh file.
/// @param where start of the messages: "--source"
/// @throws HarnessError for text in another form, and for numbers that no mesh could have
std::vector<WrittenPoint> parse_points(std::string_view text, const std::string& where);

/// Reads the points of a file, in the forms above. In text (CSV) they are separated by commas or
/// white space and may be between double quotes; a line of three numbers of which one is not whole
/// is a place, and so is every line after a first one "x,y,z", and in a file of such lines only.
/// JSON has a list of vertex numbers, of strings with one point each, and of such lists of three.
/// @param flag option that named the file, for messages
/// @throws HarnessError when it cannot be read, has no point, has three whole numbers that may be
///         three vertices or a place, or has anything else
std::vector<WrittenPoint> read_points(const std::filesystem::path& file, const std::string& flag);

/// Like read_points, for the bytes of a file. @param where start of the messages
std::vector<WrittenPoint> parse_points_file(std::string_view bytes, const std::string& where);

/// Reads the numbers of vertices, or of faces, from a file: in text between commas or white space,
/// or a JSON list. They are numbered from 0 in the order of the mesh file.
/// @param flag option that named the file, for messages
/// @throws HarnessError when it cannot be read, has no number, or has anything else
std::vector<Index> read_numbers(const std::filesystem::path& file, const std::string& flag);

/// Like read_numbers, for the bytes of a file. @param where start of the messages
std::vector<Index> parse_numbers_file(std::string_view bytes, const std::string& where);

using WrittenPair = std::array<WrittenPoint, 2>;

/// Reads pairs of points. In text each line is a pair; six numbers are two places. JSON has a list
/// of pairs, each a list of two points. The points have the forms of read_points, without initial
/// distances.
/// @throws HarnessError as read_points, and for a line or an item that is not a pair
std::vector<WrittenPair> read_pairs(const std::filesystem::path& file, const std::string& flag);

/// Like read_pairs, for the bytes of a file. @param where start of the messages
std::vector<WrittenPair> parse_pairs_file(std::string_view bytes, const std::string& where);

using WrittenSet = std::vector<WrittenPoint>;

/// Reads sets of points. In text each line is a set. JSON has a list of sets, each a list of
/// points, or one point. The points have the forms of read_points, but in text a place is always
/// written with at:, since three numbers in a line are three vertices.
/// @throws HarnessError as read_points, and for a set without a point
std::vector<WrittenSet> read_sets(const std::filesystem::path& file, const std::string& flag);

/// Like read_sets, for the bytes of a file. @param where start of the messages
std::vector<WrittenSet> parse_sets_file(std::string_view bytes, const std::string& where);

/// A point on a mesh's surface.
struct PlacedPoint {
  SurfacePoint at;
  double initial = 0;
  /// Distance of a place in space from the surface; empty for other points.
  std::optional<double> from_surface = {};
};

/// @param surface for places in space; its mesh is that of all points
/// @throws HarnessError when the mesh has no such vertex, edge or face
PlacedPoint place(const WrittenPoint& point, const NearestPointSearch& surface);

/// Writes a point in the forms above, with all digits of its numbers: "12", "edge:3-7:0.25" with
/// the smaller vertex first, ...
std::string written(const Mesh& mesh, const SurfacePoint& point);

/// The same in JSON: a vertex without an initial distance is a number, everything else a string.
Json shown(const Mesh& mesh, const Source& source);

}  // namespace geodesic::harness
