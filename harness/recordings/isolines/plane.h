// Vectors in the plane of a face.
#pragma once

#include <cmath>

#include "solvers/core/window.h"

namespace geodesic::harness {

inline Point2 operator+(const Point2& a, const Point2& b) { return {a.x + b.x, a.y + b.y}; }
inline Point2 operator-(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
inline Point2 operator*(double s, const Point2& a) { return {s * a.x, s * a.y}; }

inline double dot(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }
/// Positive when b points to the left of a.
inline double cross(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }
inline Point2 left_of(const Point2& a) { return {-a.y, a.x}; }
inline double norm(const Point2& a) { return std::sqrt(dot(a, a)); }
inline double separation(const Point2& a, const Point2& b) { return norm(b - a); }

}  // namespace geodesic::harness
