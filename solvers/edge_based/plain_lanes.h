// Vectors of two doubles from the compiler's portable vector types, under the names of highway's
// operations: the lanes of processors for which no wider kernels are compiled. (Highway 1.0 itself
// has only one lane there.) Every operation rounds as its scalar form does.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace geodesic::edge_based::plain {

struct Tag {};
using Double2 = double __attribute__((vector_size(16)));
using Vec = Double2;
using Mask = std::int64_t __attribute__((vector_size(16)));  // lanes of 0 or -1

inline constexpr std::size_t kLanes = 2;

// NOLINTBEGIN(readability-identifier-naming): highway's names

inline Vec Set(Tag, double x) { return Vec{x, x}; }
inline Vec Zero(Tag) { return Vec{0, 0}; }
inline Vec Add(Vec a, Vec b) { return a + b; }
inline Vec Sub(Vec a, Vec b) { return a - b; }
inline Vec Mul(Vec a, Vec b) { return a * b; }
inline Vec Div(Vec a, Vec b) { return a / b; }
inline Vec Neg(Vec a) { return -a; }
inline Vec Sqrt(Vec a) { return Vec{std::sqrt(a[0]), std::sqrt(a[1])}; }
inline Vec Min(Vec a, Vec b) { return a < b ? a : b; }
inline Vec Max(Vec a, Vec b) { return a > b ? a : b; }

inline Mask Lt(Vec a, Vec b) { return a < b; }
inline Mask Le(Vec a, Vec b) { return a <= b; }
inline Mask Gt(Vec a, Vec b) { return a > b; }
inline Mask Ge(Vec a, Vec b) { return a >= b; }
inline Mask And(Mask a, Mask b) { return a & b; }
inline Mask Or(Mask a, Mask b) { return a | b; }
inline Mask AndNot(Mask a, Mask b) { return ~a & b; }
inline Mask FirstN(Tag, std::size_t n) { return n == 0 ? Mask{0, 0} : Mask{-1, n > 1 ? -1 : 0}; }
inline Vec IfThenElse(Mask m, Vec yes, Vec no) { return m ? yes : no; }

inline unsigned bits(Mask m) {
  return (static_cast<unsigned>(m[0]) & 1) | (static_cast<unsigned>(m[1]) & 2);
}
inline Mask LoadMaskBits(Tag, const std::uint8_t* p) { return Mask{-(*p & 1), -(*p >> 1 & 1)}; }

inline Vec LoadU(Tag, const double* p) {
  Vec v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
inline void StoreU(Vec v, Tag, double* p) { __builtin_memcpy(p, &v, sizeof v); }
inline Vec Load(Tag t, const double* p) { return LoadU(t, p); }
inline void Store(Vec v, Tag t, double* p) { StoreU(v, t, p); }

// NOLINTEND(readability-identifier-naming)

}  // namespace geodesic::edge_based::plain
