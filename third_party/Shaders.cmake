# The shaders of assets/shaders, written into a source file of the user interface: the program finds them wherever it runs.
function(stretch_shaders)
  if(NOT TARGET stretch_ui OR NOT EXISTS ${CMAKE_SOURCE_DIR}/ui/render/gl/shader_sources.h)
    return()
  endif()
  file(GLOB shaders CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/assets/shaders/*)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${shaders})
  set(table "")
  foreach(shader IN LISTS shaders)
    get_filename_component(name ${shader} NAME)
    file(READ ${shader} text)
    string(APPEND table "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
  endforeach()
  list(LENGTH shaders count)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/shader_table.cpp @ONLY CONTENT [[
#include "ui/render/gl/shader_sources.h"

#include <array>
#include <utility>

namespace stretch::ui {

std::string_view shaderSource(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, @count@> table{{
@table@  }};
  for (const auto& [shaderName, text] : table) {
    if (shaderName == name) {
      return text;
    }
  }
  return {};
}

} // namespace stretch::ui
]])
  target_sources(stretch_ui PRIVATE ${CMAKE_BINARY_DIR}/generated/shader_table.cpp)
endfunction()
