// The work of a cell, done in a process of its own.
#pragma once

#include "harness/cells/spec.h"

namespace geodesic::harness {

/// Prepares the solver, verifies a warm-up solve, times solves, and, in a counted cell, records
/// some more on fresh solver objects; then writes the result file, after the recordings of a
/// pictured cell. Distances that are wrong, or that differ between these solves, make a file with
/// an error row and no time.
/// @throws whatever the reader, the solver or the disk does; the run makes an error row of it
void run_cell(const CellSpec& spec);

/// Solves once and writes the distances. @throws as run_cell
void run_reference(const ReferenceSpec& spec);

}  // namespace geodesic::harness
