# What the CMake file of a peer needs. peers/build.py sets PEER_FLAGS for the build with our flags,
# PEER_REMARK, what is said of the flags, and PEER_ORIGIN, a mirror.
include(FetchContent)
set(PEER_FLAGS "-O3 -DNDEBUG" CACHE STRING "compiler flags of the authors: CMake's Release")
set(PEER_REMARK "${PEER_FLAGS}" CACHE STRING "what the solver's remarks say of the flags")
set(PEER_ORIGIN "https://github.com" CACHE STRING "address or folder of the repositories")
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_FLAGS_RELEASE "${PEER_FLAGS}")
find_package(GeodesicBench REQUIRED)

# peer_needs(PACKAGE...): ends with the command that installs what is missing of Debian's packages.
# On other systems find_package reports it.
function(peer_needs)
  foreach(package ${ARGN})
    execute_process(COMMAND dpkg-query -W -f "\${db:Status-Status}" ${package}
                    RESULT_VARIABLE result OUTPUT_VARIABLE status ERROR_QUIET)
    if(result MATCHES "^[01]$" AND NOT status STREQUAL "installed")
      string(APPEND missing " ${package}")
    endif()
  endforeach()
  if(DEFINED missing)
    message(FATAL_ERROR " needs${missing}: apt-get install --no-install-recommends${missing}")
  endif()
endfunction()

# peer_sources(OWNER/NAME COMMIT PATTERNS... [EDIT FILES...])
#
# Sets PEER_SOURCES to a folder with the paths of a repository that match the patterns (of .gitignore).
# A commit is a sum of all contents, which git checks; the sum of an archive changes with its
# compression. EDIT: files that edits.sed of the peer is applied to since they do not compile
# unchanged: as few edits as possible, no line of the authors. FETCHCONTENT_SOURCE_DIR_<NAME> names a
# folder to take in place of the repository, as it is.
function(peer_sources repository commit)
  cmake_parse_arguments(PARSE_ARGV 2 peer "" "" "EDIT")
  peer_needs(git)
  get_filename_component(name ${repository} NAME)
  set(git git -C <SOURCE_DIR>)
  if(peer_EDIT)
    set(patch PATCH_COMMAND sed -i -E -f ${CMAKE_CURRENT_SOURCE_DIR}/edits.sed ${peer_EDIT})
  endif()
  FetchContent_Declare(
    ${name}
    DOWNLOAD_COMMAND ${git} init -q
    COMMAND ${git} config remote.origin.url ${PEER_ORIGIN}/${repository}
    COMMAND ${git} sparse-checkout set --no-cone ${peer_UNPARSED_ARGUMENTS}
    COMMAND ${git} fetch -q --depth 1 --filter=blob:none origin ${commit}
    COMMAND ${git} checkout -q ${commit}
    ${patch}
    SOURCE_SUBDIR none)  # their CMake files are not used
  FetchContent_MakeAvailable(${name})
  FetchContent_GetProperties(${name} SOURCE_DIR PEER_SOURCES)
  set(PEER_SOURCES ${PEER_SOURCES} PARENT_SCOPE)
endfunction()

# geodesic_add_peer(NAME SOURCES...): the plug-in of a peer.
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
