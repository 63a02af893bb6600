#include "solvers/straight_graph/builder.h"

#include <bit>

#include "solvers/straight_graph/assemble.h"
#include "solvers/straight_graph/sectors.h"
#include "solvers/straight_graph/unfold.h"

namespace geodesic::straight_graph {
namespace {

class Builder {
 public:
  Builder(const Mesh& mesh, const Sectors& sectors, double angle)
      : mesh_(mesh),
        sectors_(sectors),
        slack_(kSlack * angle),
        unfolder_(mesh, angle),
        first_(mesh.vertex_count(), {kNone, 0}) {}

  /// Appends the block of a vertex and its links.
  void operator()(Index v, std::vector<Block>& lines) {
    find_links(v);
    Block block{};
    edges_.clear();
    links_.clear();
    std::array<std::uint32_t, kSectors> leaving{};
    unsigned last = 0;
    for (const Line& line : lines_) {
      if (line.target == kNone) continue;
      const Link link = link_along(line);
      if (line.is_edge) {
        edges_.push_back(link);
        continue;
      }
      links_.push_back(link);
      // Rounding must not put a link into an earlier sector than its predecessor.
      last = std::max(last, sectors_.sector(v, line.out + rough_angle(line.to.y, line.to.x)));
      ++leaving[last];
    }
    block.edge_count = static_cast<std::uint32_t>(edges_.size());
    block.link_count = static_cast<std::uint32_t>(links_.size());
    block.unit = static_cast<std::uint8_t>(std::bit_width(block.link_count >> 8));
    std::uint32_t sum = 0;
    for (unsigned s = 0; s < kSectors; ++s) {
      block.before[s] = static_cast<std::uint8_t>(sum >> block.unit);
      sum += leaving[s];
    }
    sectors_.set_straight_on(v, slack_, block);
    edges_.insert(edges_.end(), links_.begin(), links_.end());
    append_block(block, edges_, lines);
  }

 private:
  /// A straight line from the vertex, in the plane of its corner: the vertex is at the origin, the
  /// corner's half-edge along the x axis.
  struct Line {
    Index target;  ///< kNone if another one to this vertex is shorter
    bool is_edge;
    float out;        ///< direction of the x axis at the vertex
    float in;         ///< direction at the target of the half-edge that leaves along `back`
    Point2 to, back;  ///< the target; a vector in the face there
    double length;
  };
  struct First {
    Index of;  ///< the vertex whose line it is
    Index at;
  };

  /// Sets lines_ to all lines from v, in the order of their directions.
  void find_links(Index v) {
    lines_.clear();
    corners_.assign(mesh_.outgoing(v).begin(), mesh_.outgoing(v).end());
    std::ranges::sort(corners_, {}, [&](Index h) { return sectors_.direction(h); });
    for (const Index h : corners_) {
      const HalfEdge& e = mesh_.half_edge(h);
      const auto out = static_cast<float>(sectors_.direction(h));
      const Index next = Mesh::next(h), into = Mesh::previous(h);
      const HalfEdge& far = mesh_.half_edge(next);
      const Point2 apex = {e.apex_x, e.apex_y};
      const double back = sectors_.direction(next) + corner_angle(far);
      add({mesh_.head(h), true, out, static_cast<float>(back), {e.length, 0}, {-1, 0}, e.length},
          v);
      unfolder_.follow_from_vertex(h, [&](Index entered, const Point2& to, const Point2& side) {
        const auto in = static_cast<float>(sectors_.direction(Mesh::previous(entered)));
        add({mesh_.apex(entered), false, out, in, to, {-side.x, -side.y}, norm(to)}, v);
      });
      if (mesh_.is_last_of_fan(h)) {
        add({mesh_.origin(into),
             true,
             out,
             static_cast<float>(sectors_.direction(into)),
             apex,
             {-apex.x, -apex.y},
             mesh_.half_edge(into).length},
            v);
      }
    }
  }

  /// Adds a line from v. Of two to one vertex the edge stays, else the shorter one. No line is
  /// shorter than an edge but by rounding.
  void add(const Line& line, Index v) {
    if (line.target == v) return;
    First& first = first_[line.target];
    if (first.of == v) {
      Line& other = lines_[first.at];
      if (other.is_edge || (!line.is_edge && other.length <= line.length)) return;
      other.target = kNone;
    }
    first = {v, static_cast<Index>(lines_.size())};
    lines_.push_back(line);
  }

  Link link_along(const Line& line) const {
    const Point2 home = {-line.to.x, -line.to.y};
    const double turn = rough_angle(cross(line.back, home), dot(line.back, home));
    return {line.target, line.length, sectors_.sector(line.target, line.in + turn)};
  }

  const Mesh& mesh_;
  const Sectors& sectors_;
  double slack_;
  Unfolder unfolder_;
  std::vector<First> first_;  // by vertex: the line that reaches it
  std::vector<Index> corners_;
  std::vector<Line> lines_;
  std::vector<Link> edges_, links_;
};

}  // namespace

Graph build_graph(const Mesh& mesh, double angle, unsigned threads) {
  const Sectors sectors(mesh);
  return assemble(mesh.vertex_count(), threads, [&] { return Builder(mesh, sectors, angle); });
}

FollowLinks follow_links_by_angle(const Mesh& mesh, double angle) {
  return [&mesh, unfolder = Unfolder(mesh, angle)](Index v, const auto& visit) mutable {
    for (const Index h : mesh.outgoing(v)) {
      unfolder.follow_from_vertex(h, [&](Index entered, const Point2& apex, const Point2& side) {
        visit(line_of(mesh, entered, apex, side));
      });
    }
  };
}

}  // namespace geodesic::straight_graph
