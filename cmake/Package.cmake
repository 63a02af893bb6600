# Files of `cmake --install`: the component `library`, which is the library with its headers, the package
# GeodesicBench and a file for pkg-config; then the program, and in share/geodesic-bench the files that
# the program reads, in the folders of the checkout.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/GeodesicBench)

install(
  TARGETS geodesic geodesic_meshes
  EXPORT GeodesicBenchTargets
  LIBRARY COMPONENT library
  ARCHIVE COMPONENT library
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/geodesic-bench COMPONENT library)
install(EXPORT GeodesicBenchTargets NAMESPACE GeodesicBench:: DESTINATION ${package_folder}
        COMPONENT library)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/GeodesicBenchConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/GeodesicBenchConfig.cmake
              ${PROJECT_BINARY_DIR}/GeodesicBenchConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT library)
file(RELATIVE_PATH GEODESIC_PREFIX_FROM_PKGCONFIG
     ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/geodesic-bench.pc.in geodesic-bench.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/geodesic-bench.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT library)
if(NOT GEODESIC_PROGRAM)
  return()
endif()

install(TARGETS geodesic-bench EXPORT GeodesicBenchProgram)
install(EXPORT GeodesicBenchProgram NAMESPACE GeodesicBench:: DESTINATION ${package_folder})
install(FILES CITATION.cff LICENSE README.md DESTINATION ${GEODESIC_DATA_FOLDER})
install(PROGRAMS datasets/fetch.py DESTINATION ${GEODESIC_DATA_FOLDER}/datasets)
install(FILES datasets/README.md datasets/manifest.json datasets/manifest.schema.json
        DESTINATION ${GEODESIC_DATA_FOLDER}/datasets)
install(FILES results/README.md results/fingerprints.json results/run.schema.json
        DESTINATION ${GEODESIC_DATA_FOLDER}/results)
install(DIRECTORY datasets/fetching DESTINATION ${GEODESIC_DATA_FOLDER}/datasets
        FILES_MATCHING PATTERN "*.py" PATTERN __pycache__ EXCLUDE)
install(DIRECTORY harness/suites DESTINATION ${GEODESIC_DATA_FOLDER}/harness)
install(FILES harness/relative_times.json harness/suite.schema.json
        DESTINATION ${GEODESIC_DATA_FOLDER}/harness)
install(DIRECTORY results/baseline results/published DESTINATION ${GEODESIC_DATA_FOLDER}/results)
install(FILES results/__init__.py results/checksum.py results/columns.py results/console.py results/merge.py results/names.py
              results/outcomes.py results/pairs.py results/published.py results/reader.py results/schema.py
              results/statistics.py results/table.py results/text.py
        DESTINATION ${GEODESIC_DATA_FOLDER}/results)
install(DIRECTORY gate plots view docs examples DESTINATION ${GEODESIC_DATA_FOLDER}
        USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE PATTERN build EXCLUDE)
