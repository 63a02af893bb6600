// The filter of Xin and Wang 2009, "Improving Chen and Han's algorithm on the discrete geodesic
// problem" (ACM TOG 28(4), Theorem 3.2): windows that a path through a vertex beats everywhere.
//
// A window on the edge (v1, v2) came through the face (v1, v2, v3). Its points from A to B, A
// nearer to v1, are seen from the source image I. It is useless when the known distance d of a
// vertex gives
//
//   d(v1) + |v1 B| < sigma + |I B|,
//   d(v2) + |v2 A| < sigma + |I A|, or
//   d(v3) + |v3 P| < sigma + |I P|, P the end of the window farther round the face from v3: A when
//                                   it came through (v1, v3), B when it came through (v3, v2),
//
// because by the triangle inequality the vertex then beats every line of the window before the line
// has left the face. Strictly, by a margin above rounding: d may come from the same (pseudo-)source
// or from lines of this very window, and a tie must not drop what it depends on.
#pragma once

#include "solvers/core/window_predicates.h"

namespace geodesic::chen_han {

/// The end of the window's edge that is shared with the edge through which the window's lines
/// entered the face that they are leaving.
enum class Entry : Index { at_origin, at_head };

/// The face that a window's lines are leaving, in the frame of the window's half-edge.
struct PassedFace {
  double third_x, third_y;  ///< position of the vertex opposite the window's edge, y <= 0
  double at_third;          ///< known distance of that vertex
  EndpointBounds ends;      ///< of the window's edge
};

struct XinWangFilter {
  static constexpr bool kFilters = true;

  // Inlining is forced, because it would depend on the rest of the file.
  [[gnu::always_inline]] static bool is_useless(const Window& w, Entry entry,
                                                const PassedFace& face) {
    if (face.ends.beat(w)) return true;
    const double far = entry == Entry::at_origin ? w.begin : w.end;
    const double dx = far - face.third_x, dy = face.third_y;
    return is_beaten_at(w, far, with_margin(face.at_third + std::sqrt(dx * dx + dy * dy)));
  }
};

/// Chen-Han as published in 1990. Only the length of its strip ends a window: a shortest path
/// crosses no face twice.
struct NoFilter {
  static constexpr bool kFilters = false;
};

}  // namespace geodesic::chen_han
