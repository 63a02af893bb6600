# find_package(GeodesicBench) provides
#   GeodesicBench::geodesic        the solvers as a library
#   GeodesicBench::meshes          mesh files, their defects and repair; static; links to the solvers and
#                                  needs OpenMesh. These two are there with add_subdirectory too
#   GeodesicBench::openmesh        meshes/editing/open_mesh.h: conversion between meshes of OpenMesh
#                                  and of the library; the component `openmesh`, if OpenMesh is found
#   GeodesicBench::geodesic-bench  the program, if it is installed
#   geodesic_add_solver            function that builds new solvers as a plug-in of the program
find_package(OpenMesh QUIET)
include(${CMAKE_CURRENT_LIST_DIR}/GeodesicBenchTargets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/GeodesicBenchProgram.cmake OPTIONAL)
if(OpenMesh_FOUND)
  add_library(GeodesicBench::openmesh INTERFACE IMPORTED)
  target_link_libraries(GeodesicBench::openmesh INTERFACE GeodesicBench::geodesic OpenMeshCore)
elseif(GeodesicBench_FIND_REQUIRED_openmesh)
  set(GeodesicBench_FOUND FALSE)
  set(GeodesicBench_NOT_FOUND_MESSAGE "the component openmesh needs OpenMesh (libopenmesh-dev)")
endif()

# geodesic_add_solver(NAME [BY_NAME_ONLY] SOURCES...)
#
# Builds the plug-in libNAME.so for geodesic-bench --plugin. With BY_NAME_ONLY, its solvers run only
# if they are named.
function(geodesic_add_solver name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "BY_NAME_ONLY" "" "")
  add_library(${name} MODULE ${arg_UNPARSED_ARGUMENTS})
  if(arg_BY_NAME_ONLY)
    target_compile_definitions(${name} PRIVATE GEODESIC_BY_NAME_ONLY)
  endif()
  target_link_libraries(${name} PRIVATE GeodesicBench::geodesic)
  # Contraction off: the same bits on every processor, as in the program. Hidden visibility: a class of
  # the plug-in is not replaced by a class of the program with the same name.
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  set_target_properties(${name} PROPERTIES PREFIX lib CXX_VISIBILITY_PRESET hidden
                                           VISIBILITY_INLINES_HIDDEN ON)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    message(STATUS "Solver ${name}: CMAKE_BUILD_TYPE is not set, taking Release")
    set(CMAKE_BUILD_TYPE Release PARENT_SCOPE)
  endif()
endfunction()
