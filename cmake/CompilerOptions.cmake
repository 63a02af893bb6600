# The options every target of this project is compiled with: link to geodesic_options.
add_library(geodesic_options INTERFACE)
target_include_directories(geodesic_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_features(geodesic_options INTERFACE cxx_std_20)
# Contraction off: distances and counters must be the same bits on every machine.
# Nobody reads errno after a square root: with it, every one is followed by a test and a call.
target_compile_options(
  geodesic_options INTERFACE -ffp-contract=off -fno-math-errno -Wall -Wextra -Wshadow -Wpedantic -Wconversion
                             -Wsign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
if(GEODESIC_WERROR)
  target_compile_options(geodesic_options INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC bug 105651: a false warning for `literal + std::string`, which GCC 13 no longer gives.
  target_compile_options(geodesic_options INTERFACE -Wno-restrict)
endif()

# geodesic_compile_together(TARGET [OPTION])
#
# With GEODESIC_UNITY a few large translation units stand for a target's files, not optimised much: a
# build from scratch takes half the time, a build after a change longer. OPTION, such as -O2, is for
# what users wait for. Never for solvers: what is measured is compiled in one way only.
function(geodesic_compile_together target)
  if(GEODESIC_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
    set(optimisation -O1 ${ARGN})
    list(GET optimisation -1 optimisation)
    target_compile_options(${target} PRIVATE ${optimisation})
  endif()
endfunction()
