#include "core/gltf/read/extensions.h"

#include <algorithm>
#include <array>

#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

struct KnownExtension {
  std::string_view name;
  ExtensionSupport support = ExtensionSupport::read;
};

constexpr auto knownExtensions = std::to_array<KnownExtension>({
    {"KHR_draco_mesh_compression"},
    {"EXT_meshopt_compression"},
    {"KHR_mesh_quantization"},
    {"KHR_animation_pointer"},
    {"KHR_texture_transform"},
    {"KHR_materials_unlit"},
    {"KHR_materials_emissive_strength"},
    {"KHR_materials_pbrSpecularGlossiness"},
    {"EXT_texture_webp"},
    {"VRMC_vrm"},
    {"VRMC_vrm_animation"},
    {"VRM"},
    {"KHR_texture_basisu", ExtensionSupport::told},
    {"KHR_meshopt_compression", ExtensionSupport::hiding},
    {"MPEG_buffer_circular", ExtensionSupport::hiding},
});

} // namespace

ExtensionSupport supportOf(std::string_view extension) {
  const auto* const found = std::ranges::find_if(
      knownExtensions, [&](const KnownExtension& known) { return known.name == extension; });
  return found == knownExtensions.end() ? ExtensionSupport::ignored : found->support;
}

std::vector<ExtensionUse> extensionsOf(const Json& json) {
  std::vector<ExtensionUse> uses;
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    for (std::size_t i = 0; i < sizeOf(json, list); ++i) {
      const Json& name = element(json, list, i);
      const bool isNew = name.is_string() && std::ranges::none_of(uses, [&](const auto& use) {
                           return use.name == name.get_ref<const std::string&>();
                         });
      if (isNew) {
        const auto text = name.get<std::string>();
        uses.push_back({text, listsText(json, "extensionsRequired", text), supportOf(text)});
      }
    }
  }
  return uses;
}

} // namespace stretch::gltf
