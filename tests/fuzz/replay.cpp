// Replays inputs without a fuzzer: replay_<target> FOLDER reads every file of the folder. It fails
// at the first finding and names the file.
#include <exception>
#include <filesystem>
#include <iostream>

#include "meshes/mesh_file.h"
#include "tests/fuzz/input.h"

namespace fs = std::filesystem;
using namespace geodesic::harness;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: " << argv[0] << " FOLDER\n";
    return 1;
  }
  int files = 0;
  for (const fs::directory_entry& file : fs::directory_iterator(argv[1])) {
    // The name is written before the file is read: some findings end the process.
    std::cout << file.path().filename().string() << std::endl;
    try {
      fuzz::check_input(geodesic::read_bytes(file.path()));
    } catch (const std::exception& finding) {
      std::cerr << "finding: " << finding.what() << '\n';
      return 1;
    }
    ++files;
  }
  std::cout << files << " files replayed\n";
  return files > 0 ? 0 : 1;
}
