# Files of `cmake --install`: the library with its headers and the package GeodesicBench, the program,
# and in share/geodesic-bench the files that the program reads, in the folders of the checkout.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/GeodesicBench)

install(
  TARGETS geodesic geodesic_meshes geodesic-bench
  EXPORT GeodesicBenchTargets
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/geodesic-bench)
install(EXPORT GeodesicBenchTargets NAMESPACE GeodesicBench:: DESTINATION ${package_folder})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/GeodesicBenchConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/GeodesicBenchConfig.cmake
              ${PROJECT_BINARY_DIR}/GeodesicBenchConfigVersion.cmake
        DESTINATION ${package_folder})

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
