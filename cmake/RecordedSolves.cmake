# geodesic_add_recorded_sources(TARGET SOURCES...)
#
# Adds source files of solvers that record (solvers/core/recorders.h), each as it is, for timed
# solves, and by way of recorded/FILE, for recorded ones: compiled apart, so that what the compiler
# inlines into a timed solve does not depend on instrumentation.
function(geodesic_add_recorded_sources target)
  foreach(source ${ARGN})
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE file)
    set(recorded ${CMAKE_CURRENT_BINARY_DIR}/recorded/${source})
    file(CONFIGURE OUTPUT ${recorded} CONTENT "#define GEODESIC_RECORDED\n#include \"${file}\"\n" @ONLY)
    target_sources(${target} PRIVATE ${source} ${recorded})
  endforeach()
endfunction()
