#include "core/gltf/json/utf8.h"

#include "core/gltf/json/json.h"

namespace stretch::gltf {

std::string asUtf8(const std::string& text) {
  const std::string quoted = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(quoted).get<std::string>();
}

} // namespace stretch::gltf
