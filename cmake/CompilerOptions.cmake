# Compiler options of every target of this project. Targets link to geodesic_options.
add_library(geodesic_options INTERFACE)
target_include_directories(geodesic_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_features(geodesic_options INTERFACE cxx_std_20)
# Contraction is off: distances and counters must have the same bits on every machine.
# No code reads errno after a square root; setting it needs a test and a call after each one.
target_compile_options(
  geodesic_options INTERFACE -ffp-contract=off -fno-math-errno -Wall -Wextra -Wshadow -Wpedantic -Wconversion
                             -Wsign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
if(GEODESIC_WERROR)
  target_compile_options(geodesic_options INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC bug 105651: a false warning for `literal + std::string`, which is fixed in GCC 13.
  target_compile_options(geodesic_options INTERFACE -Wno-restrict)
endif()

# geodesic_compile_together(TARGET [OPTION])
#
# With GEODESIC_UNITY, the files of a target are compiled in a few large units with little optimisation.
# A build from scratch takes half the time, a build after a change longer. OPTION, such as -O2, is for
# targets whose speed matters to users. Never for solvers: measured code is always compiled in the same way.
function(geodesic_compile_together target)
  if(GEODESIC_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
    set(optimisation -O1 ${ARGN})
    list(GET optimisation -1 optimisation)
    target_compile_options(${target} PRIVATE ${optimisation})
  endif()
endfunction()
