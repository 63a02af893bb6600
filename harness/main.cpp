// geodesic-bench: measures exact geodesic-distance solvers on triangle meshes.
#include "harness/commands/commands.h"

int main(int argc, char** argv) { return geodesic::harness::run_command_line(argc, argv); }
