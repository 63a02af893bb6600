#include "solvers/core/window.h"

namespace geodesic {

FaceFrame face_frame(const Mesh& mesh, Index h) {
  const HalfEdge& e = mesh.half_edge(h);
  const HalfEdge& next = mesh.half_edge(Mesh::next(h));
  const double right = next.length;
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
          // The cosine at the head, from the frame that has it as a scalar product: the difference
          // of length and apex_x has no digits left when the right edge is very short.
          .right_x = e.length > 0 ? next.apex_x / e.length : 0,
          .right_y = -e.apex_y * per_right};
}

}  // namespace geodesic
