// Generates open terrains from fractal value noise and from measured heights.
#include <cmath>
#include <utility>

#include "meshes/formats/npy.h"
#include "meshes/generators/families.h"
#include "meshes/mesh_file.h"
#include "meshes/random.h"

namespace geodesic {
namespace {

// Fractal value noise: random heights on the points of increasingly fine square lattices, blended
// with the quintic of Perlin 2002, "Improving noise", and added with decreasing amplitude.

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
  /// Computes the lattice's values between row `row` (t = 0) and the next (t = 1).
  void blend_rows(std::uint64_t row, double t) {
    blended_.resize(static_cast<std::size_t>(frequency_) + 2);
    for (std::size_t k = 0; k < blended_.size(); ++k) {
      blended_[k] = mix(value(k, row), value(k, row + 1), t);
    }
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
  const Sheet sheet = sheet_of(parameters, "columns", "rows");
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

/// Second derivatives m of the spline: m[i-1] + 4 m[i] + m[i+1] = 6 (y[i-1] - 2 y[i] + y[i+1]) at
/// the inner samples, 0 at both ends. Thomas's algorithm; the matrix is diagonally dominant.
std::vector<double> second_derivatives(const std::vector<double>& y) {
  const std::size_t n = y.size();
  std::vector<double> m(n, 0), upper(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double pivot = 4 - upper[i - 1];
    upper[i] = 1 / pivot;
    m[i] = (6 * ((y[i - 1] - y[i]) + (y[i + 1] - y[i])) - m[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) m[i] -= upper[i] * m[i + 1];
  return m;
}

// Measured heights. The grid is an array like a map: its first row lies in the north, its first
// column in the west. x runs east along a row, y runs north, against the order of rows.

/// Resamples every row at `count` + 1 points; the results are the columns of a transposed array.
Array resample_rows(const Array& array, std::size_t count) {
  Array result{.rows = count + 1, .columns = array.rows, .values = {}};
  result.values.resize(result.rows * result.columns);
  for (std::size_t row = 0; row < array.rows; ++row) {
    const auto begin = array.values.begin() + static_cast<std::ptrdiff_t>(row * array.columns);
    const NaturalSpline spline({begin, begin + static_cast<std::ptrdiff_t>(array.columns)});
    const std::vector<double> values = spline.resampled(count);
    for (std::size_t k = 0; k <= count; ++k) result.values[k * result.columns + row] = values[k];
  }
  return result;
}

TriangleSoup make_elevation(const CheckedParameters& parameters) {
  const Sheet sheet = sheet_of(parameters, "columns", "rows");
  check_face_count(2.0 * sheet.columns * sheet.rows);
  const std::string& file = parameters.text("input");
  const Array samples = parse_npy(read_bytes(file), file);
  // Distances between neighbouring vertices, in metres.
  const double dx =
      parameters.real("spacing-x") * (static_cast<double>(samples.columns - 1) / sheet.columns);
  const double dy =
      parameters.real("spacing-y") * (static_cast<double>(samples.rows - 1) / sheet.rows);
  const Array heights = resample_rows(resample_rows(samples, sheet.columns), sheet.rows);
  return make_sheet(sheet, [&](Index i, Index j) {
    return Vec3{i * dx, j * dy, heights.at(sheet.rows - j, i)};
  });
}

}  // namespace

NaturalSpline::NaturalSpline(std::vector<double> samples)
    : samples_(std::move(samples)), curvature_(second_derivatives(samples_)) {}

double NaturalSpline::at(std::size_t interval, double part) const {
  const double rest = 1 - part;
  return rest * samples_[interval] + part * samples_[interval + 1] +
         (rest * (rest * rest - 1) * curvature_[interval] +
          part * (part * part - 1) * curvature_[interval + 1]) /
             6;
}

std::vector<double> NaturalSpline::resampled(std::size_t count) const {
  std::vector<double> values;
  values.reserve(count + 1);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t steps = k * (samples_.size() - 1);  // in units of 1 / count
    values.push_back(
        at(steps / count, static_cast<double>(steps % count) / static_cast<double>(count)));
  }
  values.push_back(samples_.back());
  return values;
}

std::vector<Family> terrains() {
  return {
      {{.name = "terrain",
        .description = "bumpy open terrain of fractal value noise, 1 wide along x, "
                       "(columns + 1)(rows + 1) vertices on square cells",
        .parameters =
            {integer_parameter("columns", 56, 1, 40000, "cells along x"),
             integer_parameter("rows", 56, 1, 40000, "cells along y"),
             integer_parameter("seed", 1, 0, kNone - 1, "of the random heights"),
             integer_parameter("octaves", 5, 1, 12, "layers of noise, each twice as fine"),
             real_parameter("features", 4, 1, 1000, "lattice cells of the first layer along x"),
             real_parameter("height", 0.6, 0, 100, "of the first layer by its lattice cell"),
             real_parameter("gain", 0.5, 0, 1, "height of a layer by that of the one before"),
             diagonal_parameter()}},
       make_terrain},
      {{.name = "elevation",
        .description = "open terrain through a grid of heights in metres, an array of two "
                       "dimensions whose first row lies in the north: a natural bicubic spline at "
                       "(columns + 1)(rows + 1) vertices, x to the east, y to the north, in metres",
        .parameters = {file_parameter("input", "the heights, a .npy file"),
                       integer_parameter("columns", 1024, 1, 40000, "cells along x"),
                       integer_parameter("rows", 1536, 1, 40000, "cells along y"),
                       real_parameter("spacing-x", 1, 1e-6, 1e6, "metres from sample to sample"),
                       real_parameter("spacing-y", 1, 1e-6, 1e6, "metres from sample to sample"),
                       diagonal_parameter()}},
       make_elevation}};
}

}  // namespace geodesic
