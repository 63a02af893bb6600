# The options every target of this project is compiled with: link to geodesic_options.
add_library(geodesic_options INTERFACE)
target_include_directories(geodesic_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_features(geodesic_options INTERFACE cxx_std_20)
# Contraction off: distances and counters must be the same bits on every x86-64 machine.
target_compile_options(
  geodesic_options INTERFACE -ffp-contract=off -Wall -Wextra -Wshadow -Wpedantic -Wconversion
                             -Wsign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
if(GEODESIC_WERROR)
  target_compile_options(geodesic_options INTERFACE -Werror)
endif()
