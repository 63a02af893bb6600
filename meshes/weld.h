// Joins the vertices of a mesh that lie at the same place.
#pragma once

#include <vector>

#include "meshes/repair.h"
#include "solvers/core/geometry.h"

namespace geodesic {

/// Joins the vertices at the same place, or within a distance of each other, so that paths pass
/// from the faces of one to the faces of the other. Of each set, the vertex of least number stands
/// for all: it keeps its position, and the triangles name it. Sets are transitive: two vertices are
/// joined if a chain of vertices leads from one to the other in steps of the distance at most. Only
/// vertices of faces are joined.
///
/// No number changes. A joined vertex remains a name of the vertex that stands for it
/// (TriangleSoup::joined_to), and gets the same distance. A face that two joined corners make
/// collapse is left out, and other faces keep their numbers (TriangleSoup::left_out). Faces that
/// are then the same, or edges that then have more than two faces, are defects like others.
///
/// Deterministic; expected linear time. A second weld with the same distance changes nothing.
/// @param distance in the mesh's unit of length; 0 joins only vertices with equal coordinates
/// @return what was done; empty if no two vertices were joined
/// @throws std::invalid_argument for a distance that is negative or not finite
std::vector<RepairAction> weld(TriangleSoup& soup, double distance = 0);

}  // namespace geodesic
