// Where the program finds the files it comes with, and leaves runs.
#pragma once

#include <filesystem>

namespace geodesic::harness {

/// The root of the checkout that the program was built from; of an installed program, the folder
/// with the same files at the same places (share/geodesic-bench beside its bin).
std::filesystem::path data_folder();

/// The folder for what is measured and was given none: results of the checkout, and of the current
/// folder where the program is installed.
std::filesystem::path results_folder();

}  // namespace geodesic::harness
