# Script of every build: writes OUTPUT from TEMPLATE, but only if its text changes.
# Input: SOURCE_FOLDER, TEMPLATE, OUTPUT; VERSION, COMPILER, COMPILER_FLAGS, BUILD_TYPE, LIBRARIES, INSTALLED_DATA are copied.
set(REVISION "unknown")
set(MODIFIED "std::nullopt")

# The prefix is empty in the root of a checkout, and not in a folder unpacked inside another checkout.
execute_process(
  COMMAND git -C ${SOURCE_FOLDER} rev-parse --show-prefix
  OUTPUT_VARIABLE prefix OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE no_git)
execute_process(
  COMMAND git -C ${SOURCE_FOLDER} rev-parse HEAD
  OUTPUT_VARIABLE hash OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE no_commit)
if(no_git EQUAL 0 AND no_commit EQUAL 0 AND prefix STREQUAL "")
  set(REVISION ${hash})
  execute_process(
    COMMAND git --no-optional-locks -C ${SOURCE_FOLDER} status --porcelain
    OUTPUT_VARIABLE changes ERROR_QUIET RESULT_VARIABLE no_status)
  if(no_status EQUAL 0)
    if(changes STREQUAL "")
      set(MODIFIED "false")
    else()
      set(MODIFIED "true")
    endif()
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
