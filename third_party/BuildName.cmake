# The version that --version prints. Written anew at each build, and compiled only when it has changed. Run as a script
# (cmake -P), this file is what writes it.
if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND git -C ${SOURCE} describe --always --dirty=-modified --exclude=* OUTPUT_VARIABLE commit
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  set(name "${VERSION} (")
  if(commit)
    string(APPEND name "commit ${commit}, ")
  endif()
  string(APPEND name "${COMPILER}, ${MACHINE})")
  file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "app/build_name.h"

namespace stretch::app {

std::string_view buildName() { return "@name@"; }

} // namespace stretch::app
]])
  return()
endif()

function(stretch_build_name)
  set(source ${CMAKE_BINARY_DIR}/generated/build_name.cpp)
  add_custom_target(build-name BYPRODUCTS ${source} COMMENT "Naming the build"
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${CMAKE_SOURCE_DIR} -DVERSION=${PROJECT_VERSION} -DOUTPUT=${source}
      "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" -DMACHINE=${CMAKE_SYSTEM_PROCESSOR}
      -P ${CMAKE_SOURCE_DIR}/third_party/BuildName.cmake VERBATIM)
  add_dependencies(stretch-engine build-name)
  target_sources(stretch-engine PRIVATE ${source})
endfunction()
