// The steps that make a measurable mesh of a raw scan; clean.cpp has their order.
//
// Each works in place, keeps the order of what it keeps, and returns what it did, with counts that
// are never 0: nothing for a mesh that it finds in order.
#pragma once

#include <span>
#include <vector>

#include "meshes/repair.h"
#include "solvers/core/geometry.h"

namespace geodesic {

/// Removes pairs of faces that have the same three vertices and run opposite ways, the flaps that
/// collapsed edges leave: the edges around a pair get back the two faces they had without it. Where
/// nothing would be left of a connected group of faces, a surface stored twice, the pairs stay.
/// Faces that name a vertex twice or one that is not there are left alone.
std::vector<RepairAction> cancel_opposite_faces(TriangleSoup& soup);

/// Joins vertices that an edge of length zero connects to the one of least id, and the ends of an
/// edge that is shorter than the rounding of its face's longest, then drops the faces that are left
/// with two corners.
std::vector<RepairAction> weld_edges(TriangleSoup& soup);

/// Gives each fan of faces at a vertex a vertex of its own, so that every edge has one face, or two
/// that run along it in opposite directions. The first fan keeps the vertex, copies follow all
/// others. Faces at an edge of three or more stay connected when they are in the same fans at both
/// of its ends: two tubes that touch along an edge come apart, a fin comes off.
std::vector<RepairAction> separate_sheets(TriangleSoup& soup);

/// Removes faces without area whose longest edge has the third vertex on it: the edge is flipped,
/// which cuts the face beyond it in two at that vertex and leaves the surface as it is. Where no
/// face lies beyond, the face is dropped.
std::vector<RepairAction> remove_flat_faces(TriangleSoup& soup);

/// Keeps the group of connected faces that has the most, of equal ones the first.
std::vector<RepairAction> keep_largest_component(TriangleSoup& soup);

/// True when a solver, or the harness's report of defects, sees no area or an edge of length zero.
bool is_flat(std::span<const Vec3> positions, const Triangle& face);

/// For each half-edge the one of the face beyond, where the edge has exactly two faces that run
/// along it in opposite directions; kNone elsewhere.
std::vector<Index> pair_half_edges(const TriangleSoup& soup);

}  // namespace geodesic
