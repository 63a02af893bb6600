// Path files contain every point of every path.
#include "meshes/path_file.h"

#include <gtest/gtest.h>

#include "harness/base/json.h"
#include "meshes/formats/bytes.h"
#include "meshes/oracles/random_meshes.h"
#include "tests/message_of.h"
#include "tests/paths/oracle_paths.h"
#include "tests/shapes.h"

namespace geodesic {
namespace {

class PathFile : public testing::Test {
 protected:
  const Mesh mesh_{rough_terrain(4, 5, 5, 0.5)};
  const Paths all_ = oracle_paths(mesh_, {.sources = {{.at = 3}, {.at = 30}}});
  const std::vector<Path> paths_{all_.to_vertex(35), all_.to_vertex(3), all_.to_vertex(0)};
};

TEST_F(PathFile, as_json_brings_every_number_back) {
  const harness::Json json = harness::parse_json(path_bytes(paths_, "a.json"), "a.json");
  ASSERT_EQ(json.at("paths").size(), paths_.size());
  for (std::size_t p = 0; p < paths_.size(); ++p) {
    const harness::Json& path = json.at("paths").at(p);
    EXPECT_EQ(path.at("source"), paths_[p].source);
    EXPECT_EQ(path.at("length"), paths_[p].length());
    ASSERT_EQ(path.at("points").size(), paths_[p].points.size());
    for (std::size_t i = 0; i < paths_[p].points.size(); ++i) {
      const PathPoint& point = paths_[p].points[i];
      const harness::Json& got = path.at("points").at(i);
      EXPECT_EQ(got.at("position"), harness::Json(point.position));
      EXPECT_EQ(got.at("travelled"), point.travelled);
      if (point.at.is_vertex()) {
        EXPECT_EQ(got.at("vertex"), point.at.vertex);
      } else {
        EXPECT_EQ(got.at("face"), point.at.face);
        EXPECT_EQ(got.at("weights"), harness::Json(point.at.weights));
      }
      const bool last = i + 1 == paths_[p].points.size();
      EXPECT_EQ(got.at("next_face"), last ? harness::Json() : harness::Json(point.face));
    }
  }
}

TEST_F(PathFile, as_obj_has_a_line_for_each_path_of_two_points_and_more) {
  std::istringstream text(path_bytes(paths_, "a.OBJ"));
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::size_t>> lines;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v") {
      Vec3 p;
      words >> p[0] >> p[1] >> p[2];
      vertices.push_back(p);
    } else {
      ASSERT_EQ(keyword, "l");
      lines.emplace_back();
      for (std::size_t v; words >> v;) lines.back().push_back(v);
    }
  }
  ASSERT_EQ(lines.size(), 2u);  // the path to a source is a point, not a line
  const Path* const longer[] = {&paths_[0], &paths_[2]};
  for (std::size_t l = 0; l < 2; ++l) {
    ASSERT_EQ(lines[l].size(), longer[l]->points.size());
    for (std::size_t i = 0; i < lines[l].size(); ++i) {
      EXPECT_EQ(vertices.at(lines[l][i] - 1), longer[l]->points[i].position);
    }
  }
}

TEST_F(PathFile, as_ply_has_vertices_and_edges) {
  const std::string bytes = path_bytes(paths_, "a.ply");
  std::size_t points = 0;
  for (const Path& path : paths_) points += path.points.size();
  const std::size_t edges = points - paths_.size();
  EXPECT_NE(bytes.find("element vertex " + std::to_string(points) + "\n"), std::string::npos);
  EXPECT_NE(bytes.find("element edge " + std::to_string(edges) + "\n"), std::string::npos);
  const std::string end = "end_header\n";
  const char* at = bytes.data() + bytes.find(end) + end.size();
  ASSERT_EQ(bytes.size() - static_cast<std::size_t>(at - bytes.data()), 32 * points + 12 * edges);
  const auto real = [&] {
    return load_number<double>(std::exchange(at, at + 8), std::endian::little);
  };
  const auto number = [&] {
    return load_number<std::int32_t>(std::exchange(at, at + 4), std::endian::little);
  };
  for (const Path& path : paths_) {
    for (const PathPoint& point : path.points) {
      for (const double coordinate : point.position) EXPECT_EQ(real(), coordinate);
      EXPECT_EQ(real(), point.travelled);
    }
  }
  std::int32_t vertex = 0;
  for (std::int32_t p = 0; p < 3; ++p, ++vertex) {
    for (std::size_t i = 1; i < paths_[static_cast<std::size_t>(p)].points.size(); ++i, ++vertex) {
      EXPECT_EQ(number(), vertex);
      EXPECT_EQ(number(), vertex + 1);
      EXPECT_EQ(number(), p);
    }
  }
}

// A closed line, and one that ends at the border.
std::vector<Isoline> closed_and_open_line() {
  const Mesh mesh(fan(5, 0, 0));
  std::vector<Isoline> lines = isolines(mesh, std::vector<double>{0, 1, 1, 1, 1, 1}, {0.25});
  for (Isoline& line : isolines(mesh, std::vector<double>{1, 0, 1, 1, 1, 1}, {0.5})) {
    lines.push_back(std::move(line));
  }
  return lines;
}

TEST(IsolineFile, as_json_brings_every_number_back) {
  const std::vector<Isoline> lines = closed_and_open_line();
  const harness::Json json = harness::parse_json(isoline_bytes(lines, "a.json"), "a.json");
  const harness::Json& all = json.at("isolines");
  ASSERT_EQ(all.size(), 2u);
  for (std::size_t l = 0; l < 2; ++l) {
    EXPECT_EQ(all.at(l).at("level"), lines[l].level);
    EXPECT_EQ(all.at(l).at("closed"), l == 0);
    EXPECT_EQ(all.at(l).at("length"), lines[l].length());
    ASSERT_EQ(all.at(l).at("points").size(), lines[l].points.size());
    for (std::size_t i = 0; i < lines[l].points.size(); ++i) {
      const harness::Json& point = all.at(l).at("points").at(i);
      EXPECT_EQ(point.at("position"), harness::Json(lines[l].points[i].position));
      const bool last = i + 1 == lines[l].points.size();
      EXPECT_EQ(point.at("next_face"),
                last ? harness::Json() : harness::Json(lines[l].points[i].face));
    }
  }
}

TEST(IsolineFile, as_obj_closes_lines_at_their_first_vertex) {
  std::istringstream text(isoline_bytes(closed_and_open_line(), "a.obj"));
  std::string others;
  std::size_t vertices = 0;
  for (std::string line; std::getline(text, line);) {
    line.starts_with("v ") ? void(++vertices) : void(others += line + '\n');
  }
  EXPECT_EQ(vertices, 8u);
  EXPECT_EQ(others, "g 0.25\nl 1 2 3 4 5 1\ng 0.5\nl 6 7 8\n");
}

TEST(IsolineFile, as_ply_closes_lines_at_their_first_vertex) {
  const std::string bytes = isoline_bytes(closed_and_open_line(), "a.ply");
  for (const char* part :
       {"element vertex 8\n", "element edge 7\n", "double level\n", "int isoline\n"}) {
    EXPECT_NE(bytes.find(part), std::string::npos) << part;
  }
  const std::string end = "end_header\n";
  const char* at = bytes.data() + bytes.find(end) + end.size();
  ASSERT_EQ(bytes.data() + bytes.size() - at, 8 * 32 + 7 * 12);
  for (int v = 0; v < 8; ++v, at += 32) {
    EXPECT_EQ(load_number<double>(at + 24, std::endian::little), v < 5 ? 0.25 : 0.5);
  }
  std::vector<std::array<std::int32_t, 3>> edges(7);
  for (auto& edge : edges) {
    for (std::int32_t& part : edge) {
      part = load_number<std::int32_t>(std::exchange(at, at + 4), std::endian::little);
    }
  }
  EXPECT_EQ(edges,
            (std::vector<std::array<std::int32_t, 3>>{
                {0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 0, 0}, {5, 6, 1}, {6, 7, 1}}));
}

TEST_F(PathFile, of_another_kind_is_refused_in_one_line) {
  EXPECT_THROW(path_bytes(paths_, "a.txt"), MeshError);
  EXPECT_EQ(message_of<MeshError>([] { check_path_file("paths.csv"); }),
            "cannot write 'paths.csv': paths and isolines are written as .json, .obj or .ply");
}

TEST_F(PathFile, may_hold_no_path) {
  EXPECT_EQ(isoline_bytes({}, "a.json"), "{\"isolines\":[]}\n");
  EXPECT_TRUE(harness::parse_json(path_bytes({}, "a.json"), "a.json").at("paths").empty());
  EXPECT_EQ(path_bytes({}, "a.obj"), "");
}

}  // namespace
}  // namespace geodesic
