# docs  API documentation, if doxygen is installed
find_program(DOXYGEN_PROGRAM doxygen)
if(DOXYGEN_PROGRAM)
  add_custom_target(
    docs
    COMMAND ${DOXYGEN_PROGRAM} docs/Doxyfile
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMENT "API documentation in build/docs/html"
    VERBATIM)
endif()
