#include "solvers/core/prepared_file.h"

#include <array>
#include <span>
#include <stdexcept>
#include <vector>

#include "solvers/core/prepared_arrays.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

constexpr std::string_view kMagic = "geodesic-bench preparation ";
constexpr int kFormat = 1;  // raised when any solver writes something else
constexpr std::uint64_t kByteOrder = 0x0102030405060708;

/// Of the connectivity and the lengths of all edges, in the mesh's internal numbers.
std::uint64_t sum_of(const Mesh& mesh) {
  ByteSum sum;
  std::vector<double> lengths(mesh.half_edge_count());
  std::vector<std::array<Index, 2>> links(mesh.half_edge_count());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const HalfEdge& e = mesh.half_edge(h);
    lengths[h] = e.length;
    links[h] = {e.origin, e.twin};
  }
  const Index vertices = mesh.vertex_count();
  sum.add(std::as_bytes(std::span(&vertices, 1)));
  sum.add(std::as_bytes(std::span(lengths)));
  sum.add(std::as_bytes(std::span(links)));
  return sum.value();
}

std::string line_of(std::istream& from) {
  constexpr std::size_t kMost = 200;
  std::string line;
  for (char c = 0; line.size() < kMost && from.get(c) && c != '\n';) line += c;
  return line;
}

/// Reads up to the name of the solver.
std::string read_name(std::istream& from, PreparedReader& reader) {
  const std::string first = line_of(from);
  if (!first.starts_with(kMagic)) {
    throw std::invalid_argument("this is not the preparation of a solver");
  }
  if (first != std::string(kMagic) + std::to_string(kFormat)) {
    throw std::invalid_argument("the preparation has format " + first.substr(kMagic.size()) +
                                ", and this program reads " + std::to_string(kFormat) +
                                ": prepare again");
  }
  if (reader.read_one<std::uint64_t>() != kByteOrder) {
    throw std::invalid_argument(
        "the preparation was written on a machine of another byte order: prepare again");
  }
  const std::vector<char> name = reader.read<char>();
  return {name.data(), name.size()};
}

}  // namespace

void save_prepared(const Solver& solver, std::ostream& to) {
  if (!solver.description().abilities.saves) {
    throw std::invalid_argument(solver.description().name +
                                ": has no preparation that could be saved");
  }
  to << kMagic << kFormat << '\n';
  PreparedWriter writer(to);
  writer.write_one(kByteOrder);
  writer.write(std::span<const char>(solver.description().name));
  writer.write_one(sum_of(solver.mesh()));
  solver.save(writer);
  writer.write_one(writer.sum());
}

std::string name_in_prepared(std::istream& from) {
  PreparedReader reader(from);
  return read_name(from, reader);
}

std::unique_ptr<Solver> read_prepared(const Mesh& mesh, std::istream& from) {
  PreparedReader reader(from);
  const std::string name = read_name(from, reader);
  if (reader.read_one<std::uint64_t>() != sum_of(mesh)) {
    throw std::invalid_argument("the preparation is of another mesh");
  }
  std::unique_ptr<Solver> solver = make_solver(name, mesh, &reader);
  const std::uint64_t sum = reader.sum();
  PreparedReader::check(reader.read_one<std::uint64_t>() == sum);
  return solver;
}

}  // namespace geodesic
