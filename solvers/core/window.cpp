#include "solvers/core/window.h"

namespace geodesic {

FaceFrame face_frame(const Mesh& mesh, Index h) {
  const HalfEdge& e = mesh.half_edge(h);
  const double right = mesh.half_edge(Mesh::next(h)).length;
  const double left = mesh.half_edge(Mesh::previous(h)).length;
  // An edge of length zero takes no window; any unit vector does for it.
  const double per_left = left > 0 ? 1 / left : 0;
  const double per_right = right > 0 ? 1 / right : 0;
  return {.length = e.length,
          .apex_x = e.apex_x,
          .apex_y = e.apex_y,
          .left = left,
          .right = right,
          .left_x = e.apex_x * per_left,
          .left_y = e.apex_y * per_left,
          .right_x = (e.length - e.apex_x) * per_right,
          .right_y = -e.apex_y * per_right};
}

}  // namespace geodesic
