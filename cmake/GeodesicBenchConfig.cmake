# find_package(GeodesicBench) gives
#   GeodesicBench::geodesic        the solvers as a library
#   GeodesicBench::geodesic-bench  the program
#   geodesic_add_solver            solvers of one's own, as a plug-in of the program
include(${CMAKE_CURRENT_LIST_DIR}/GeodesicBenchTargets.cmake)

# geodesic_add_solver(NAME SOURCES...)
#
# The plug-in libNAME.so, for geodesic-bench --plugin.
function(geodesic_add_solver name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE GeodesicBench::geodesic)
  # Contraction off: the same bits on every processor, as in the program. Hidden: a class of the
  # plug-in that is named like one of the program's stays the plug-in's.
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  set_target_properties(${name} PROPERTIES PREFIX lib CXX_VISIBILITY_PRESET hidden
                                           VISIBILITY_INLINES_HIDDEN ON)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    message(STATUS "Solver ${name}: CMAKE_BUILD_TYPE is not set, taking Release")
    set(CMAKE_BUILD_TYPE Release PARENT_SCOPE)
  endif()
endfunction()
