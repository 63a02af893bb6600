# geodesic_add_peer(NAME SOURCES...)
#
# The plug-in of a peer. peers/build.py sets PEER_SOURCES, the folder of its authors' sources, one
# folder a repository, PEER_FLAGS, what they are compiled with, and PEER_REMARK, what is said of it.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_FLAGS_RELEASE "${PEER_FLAGS}")
find_package(GeodesicBench REQUIRED)

function(geodesic_add_peer name)
  # Of its own, so that another remark compiles nothing else again.
  file(CONFIGURE OUTPUT built_with.cpp
       CONTENT "namespace geodesic::peer { const char* built_with() { return \"@PEER_REMARK@\"; } }\n" @ONLY)
  geodesic_add_solver(${name} BY_NAME_ONLY ${ARGN} ${CMAKE_CURRENT_BINARY_DIR}/built_with.cpp)
  # The authors' warnings are not ours to repair. Contraction stays off, as geodesic_add_solver has
  # it: with it, exact codes answer differently by the processor that they are compiled for.
  target_compile_options(${name} PRIVATE -w)
  target_link_options(${name} PRIVATE LINKER:--no-undefined)
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR})
endfunction()
