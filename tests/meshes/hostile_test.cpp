// Files with false counts, without their end or of another type are quickly refused with one line.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "meshes/defects.h"
#include "meshes/mesh_file.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic {
namespace {

struct Sample {
  std::string name, bytes;
};

std::vector<Sample> all_formats() {
  return {{"a.obj", kObj},
          {"a.off", kOff},
          {"binary.off", binary_off()},
          {"ascii.ply", kPly},
          {"little.ply", binary_ply<float>(std::endian::little)},
          {"big.ply", binary_ply<double>(std::endian::big)},
          {"ascii.stl", ascii_stl()},
          {"binary.stl", binary_stl("binary")},
          {"solid.stl", binary_stl("solid")}};
}

TEST(Hostile, ATruncatedFileIsRefusedOrWarnedAbout) {
  for (const Sample& sample : all_formats()) {
    const MeshFile whole = parse_mesh(sample.bytes, sample.name);
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      const std::string cut = sample.bytes.substr(0, size);
      try {
        const MeshFile file = parse_mesh(cut, sample.name);
        const bool complete = file.soup.positions == whole.soup.positions &&
                              file.soup.triangles == whole.soup.triangles;
        // OBJ files have no counts: a file that is cut after a whole line looks complete.
        const bool after_a_line = sample.name == "a.obj" && cut.ends_with('\n');
        EXPECT_TRUE(complete || after_a_line || !file.warnings.empty())
            << sample.name << " cut to " << size << " bytes";
      } catch (const MeshError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with(sample.name)) << error.what();
        EXPECT_FALSE(contains(error.what(), "\n")) << error.what();
      }
    }
  }
}

TEST(Hostile, NoDamagedByteLeadsToAnythingButAMeshOrAMessage) {
  for (const Sample& sample : all_formats()) {
    for (std::size_t at = 0; at < sample.bytes.size(); ++at) {
      for (const char byte : {'\0', '\xff', '9', '-', '\n', ' ', '/', '\\'}) {
        std::string damaged = sample.bytes;
        damaged[at] = byte;
        try {
          MeshFile file = parse_mesh(damaged, sample.name);
          find_defects(file.soup, file.lines);
        } catch (const MeshError&) {
        }
      }
    }
  }
}

std::size_t peak_kilobytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss);
}

TEST(Hostile, CountsThatTheFileCannotHoldAreRefusedWithoutMemoryForThem) {
  const std::string x_y_z = "property float x\nproperty float y\nproperty float z\n";
  const std::string vertices = "element vertex 4000000000\n" + x_y_z;
  const std::string few = "element vertex 3\n" + x_y_z;
  const std::string corners = "property list uchar int vertex_indices\n";
  const auto ply = [](const std::string& format, const std::string& elements) {
    return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + std::string(36, '0');
  };
  std::string stl(100, '\0');
  stl.replace(80, 4, bytes_of(std::uint32_t{4000000000}));
  const std::vector<Sample> samples = {
      {"a.off", "OFF\n4000000000 1 0\n0 0 0\n1 0 0\n"},
      {"b.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"c.off", "OFF\n9223372036854775807 9223372036854775807 0\n0 0 0\n"},
      {"d.off", "OFF BINARY\n\x7f\xff\xff\xff" + binary_off("").substr(4)},
      {"e.off", "OFF BINARY\n" + binary_off("").replace(4, 1, "\x7f")},
      {"f.off", "OFF BINARY\n" + binary_off("").replace(60, 1, "\x7f")},  // corners of a face
      {"g.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"},
      {"a.ply", ply("ascii", vertices + "element face 1\n" + corners)},
      {"b.ply", ply("binary_little_endian", vertices + "element face 1\n" + corners)},
      {"c.ply", ply("binary_big_endian", few + "element face 4000000000\n" + corners)},
      {"d.ply", ply("ascii", few + "element face 1\n" + corners + "element e 4000000000\n")},
      {"e.ply", ply("binary_little_endian", "element e 4000000000\nproperty char c\n" + few +
                                                "element face 1\n" + corners)},
      // The header of one face claims four billion corners.
      {"f.ply", ply("binary_little_endian",
                    few + "element face 1\nproperty list uint uchar vertex_indices\n") +
                    std::string(4, '\xee') + "123"},
      {"a.stl", stl}};
  const std::size_t before = peak_kilobytes();
  for (const Sample& sample : samples) {
    expect_refusal(sample.bytes, sample.name, sample.name + ", ");
  }
  EXPECT_LT(peak_kilobytes(), before + 32'768);
}

TEST(Hostile, OtherFilesAreOfTheWrongFormat) {
  const std::vector<std::pair<Sample, std::string>> cases = {
      {{"a.obj", ""}, "a.obj: the file is empty"},
      {{"a.off", "hello world\n"}, "wrong format"},
      {{"a.ply", "plywood\n"}, "wrong format"},
      {{"a.txt", "some prose\n"}, "wrong format"},
      {{"a.obj", "some prose\n"}, "unknown statement 'some'"},
      {{"a.obj", std::string("\x7f"
                             "ELF\0\1\2",
                             7)},
       "wrong format"},
      {{"a.obj.gz", "\x1f\x8b\x08"}, "unpack it first"},
      {{"a.zip", "PK\x03\x04"}, "unpack it first"},
      {{"a.obj", "# only a comment\n"}, "empty mesh: no vertices"},
      {{"a.obj", "v 0 0 0\n"}, "empty mesh: no faces"},
      {{"a.off", "OFF\n0 0 0\n"}, "empty mesh: no vertices"},
      {{"a.stl", std::string(84, '\0')}, "empty mesh: no vertices"},
      {{"a.stl", "short"}, "wrong format"},
  };
  for (const auto& [sample, expected] : cases) {
    expect_refusal(sample.bytes, sample.name, expected);
  }
}

TEST(Hostile, TheByteOrderMarkOfUtf8IsNoPartOfTheText) {
  for (const Sample& sample : all_formats()) {
    if (sample.name.ends_with(".stl") && sample.name != "ascii.stl") continue;
    const MeshFile file = parse_mesh("\xef\xbb\xbf" + sample.bytes, sample.name);
    const MeshFile without = parse_mesh(sample.bytes, sample.name);
    EXPECT_EQ(file.soup.positions, without.soup.positions) << sample.name;
    EXPECT_EQ(file.soup.triangles, without.soup.triangles) << sample.name;
    EXPECT_EQ(file.format, without.format);
  }
}

TEST(Hostile, ABinaryHeaderMayBeginWithAnyBytes) {
  for (const char* mark : {"\xef\xbb\xbf", "\xff\xfe", "\xfe\xff"}) {
    EXPECT_EQ(parse_mesh(binary_stl(mark), "a.stl").format, "STL binary");
  }
}

TEST(Hostile, TheContentDecidesAgainstTheExtensionAndSaysSo) {
  for (const Sample& sample : all_formats()) {
    const bool is_ply = sample.name.ends_with(".ply");
    const MeshFile file = parse_mesh(sample.bytes, is_ply ? "wrong.obj" : "WRONG.PLY");
    EXPECT_EQ(file.soup.triangles.size(), 4u) << sample.name;
    ASSERT_EQ(file.warnings.size(), 1u) << sample.name;
    EXPECT_TRUE(contains(file.warnings[0], "the content is " + file.format)) << file.warnings[0];
    EXPECT_TRUE(parse_mesh(sample.bytes, "without-extension").warnings.empty()) << sample.name;
  }
}

}  // namespace
}  // namespace geodesic
