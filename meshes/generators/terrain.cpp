// Fractal value noise: random heights on the points of ever finer square lattices, blended with the
// quintic of Perlin 2002, "Improving noise", and added with falling amplitude.
#include <cmath>
#include <vector>

#include "meshes/generators/families.h"
#include "meshes/generators/sheet.h"
#include "meshes/random.h"

namespace geodesic {
namespace {

/// 0 at 0, 1 at 1, with first and second derivatives of 0 at both.
double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

double mix(double a, double b, double t) { return a + t * (b - a); }

/// One octave of noise over rows of points.
class Octave {
 public:
  /// @param frequency lattice cells along a row
  Octave(std::uint64_t seed, double frequency, double amplitude)
      : seed_(split_mix(seed)), frequency_(frequency), amplitude_(amplitude) {}

  /// Adds the noise at (i / cells, y), i = 0 ... heights.size() - 1.
  void add_to_row(std::vector<double>& heights, double cells, double y) {
    const double row = std::floor(y * frequency_);
    blend_rows(static_cast<std::uint64_t>(row), fade(y * frequency_ - row));
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const double x = static_cast<double>(i) * frequency_ / cells;
      const double column = std::floor(x);
      const auto k = static_cast<std::size_t>(column);
      heights[i] += amplitude_ * mix(blended_[k], blended_[k + 1], fade(x - column));
    }
  }

 private:
  /// The lattice's values between row `row` (t = 0) and the next (t = 1).
  void blend_rows(std::uint64_t row, double t) {
    blended_.resize(static_cast<std::size_t>(frequency_) + 2);
    for (std::size_t k = 0; k < blended_.size(); ++k)
      blended_[k] = mix(value(k, row), value(k, row + 1), t);
  }

  double value(std::uint64_t column, std::uint64_t row) const {
    return to_signed_unit(split_mix(split_mix(seed_ ^ row) ^ column));
  }

  std::uint64_t seed_;
  double frequency_;
  double amplitude_;
  std::vector<double> blended_;
};

std::vector<Octave> make_octaves(const CheckedParameters& parameters) {
  std::vector<Octave> octaves;
  double frequency = parameters.real("features");
  double amplitude = parameters.real("height") / frequency;
  for (Index k = 0; k < parameters.integer("octaves"); ++k) {
    octaves.emplace_back(std::uint64_t{parameters.integer("seed")} << 8 | k, frequency, amplitude);
    frequency *= 2;
    amplitude *= parameters.real("gain");
  }
  return octaves;
}

TriangleSoup make_terrain(const CheckedParameters& parameters) {
  const Sheet sheet{.columns = parameters.integer("columns"),
                    .rows = parameters.integer("rows"),
                    .diagonal = diagonal_of(parameters)};
  std::vector<Octave> octaves = make_octaves(parameters);
  const double cells = sheet.columns;
  std::vector<double> heights(sheet.vertex_columns());
  return make_sheet(sheet, [&](Index i, Index j) {
    const double y = j / cells;
    if (i == 0) {
      heights.assign(heights.size(), 0);
      for (Octave& octave : octaves) octave.add_to_row(heights, cells, y);
    }
    return Vec3{i / cells, y, heights[i]};
  });
}

}  // namespace

Family terrain() {
  return {{.name = "terrain",
           .description = "bumpy open terrain of fractal value noise, 1 wide along x, "
                          "(columns + 1)(rows + 1) vertices on square cells",
           .closed_form = "",
           .parameters =
               {integer_parameter("columns", 56, 1, 40000, "cells along x"),
                integer_parameter("rows", 56, 1, 40000, "cells along y"),
                integer_parameter("seed", 1, 0, kNone - 1, "of the random heights"),
                integer_parameter("octaves", 5, 1, 12, "layers of noise, each twice as fine"),
                real_parameter("features", 4, 1, 1000, "lattice cells of the first layer along x"),
                real_parameter("height", 0.6, 0, 100, "of the first layer by its lattice cell"),
                real_parameter("gain", 0.5, 0, 1, "height of a layer by that of the one before"),
                diagonal_parameter()}},
          make_terrain};
}

}  // namespace geodesic
