// Strategy I: windows of one edge that cannot all be geodesic (thesis section 5.1.1).
//
// Two paths that meet at a point P cannot both be shortest beyond it. If the path of window W is
// the shorter one at P, every line of window V that crosses the segment from W's source to P is
// beaten there: the lines of V between the direction of P and the direction of W's source. Nothing
// has to be disjoint afterwards; what is removed is certainly useless.
#pragma once

#include "solvers/core/window.h"

namespace geodesic::edge_based {

/// Pseudo-sources often lie exactly on the line that bounds a neighbour's pencil: the vertex that
/// split the pencil became a source itself. Relative to the lengths whose products are compared.
inline constexpr double kOnLine = 1e-11;

/// The edge that carries the windows, and the face below it through which they all came.
struct Crossed {
  double length;            ///< of the edge
  double below_x, below_y;  ///< third vertex of the face below, below_y <= 0
};

/// @param h the half-edge that carries the windows; it must have a twin
Crossed crossed_face(const Mesh& mesh, Index h);

/// True when a path of length a beats one of length b by more than rounding.
bool is_shorter(double a, double b);

/// True when the windows follow one another so that neither can beat more of the other than the
/// part of their overlap behind the bisector, which is not worth trimming: their ends are in order,
/// and each source lies on its own side of the line that bounds the other window's pencil.
bool in_order(const Window& first, const Window& second);

/// True when too narrow to matter, or emptied by trimming.
bool is_void(const Window& w, double length);

/// Compares two windows of one edge and trims what one beats of the other; a window that is beaten
/// wholly becomes void. Looks at their overlap on the edge, or, when they are apart, at the place
/// inside the face below where the lines that bound them cross.
void trim_pair(Window& first, Window& second, const Crossed& face);

/// True when the point (px, py) lies to the right of the window's line through t of the edge, or on
/// it within rounding.
bool is_right_of_line(const Window& w, double t, double px, double py);
/// The same for the left.
bool is_left_of_line(const Window& w, double t, double px, double py);

}  // namespace geodesic::edge_based
