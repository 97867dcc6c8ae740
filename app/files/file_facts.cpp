#include "app/files/file_facts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <set>
#include <system_error>

#include "core/gltf/json/json.h"
#include "core/gltf/source/glb.h"
#include "core/gltf/source/json_text.h"

namespace stretch::app {

namespace {

using gltf::Json;

constexpr std::uint64_t longestJson = 32ULL << 20U; ///< A preview is not worth reading more.

std::uint32_t littleEndian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) {
    value = value << 8U | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

/// The JSON of a .glb or .gltf; `problem` says why there is none.
std::string jsonText(const std::filesystem::path& path, std::uintmax_t bytes, std::string& problem) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 20> head{};
  file.read(head.data(), head.size());
  const auto got = static_cast<std::size_t>(file.gcount());
  const bool isBinary = got >= 4 && std::equal(head.begin(), head.begin() + 4, "glTF");
  const bool hasJson = isBinary && got == head.size() && littleEndian(&head[16]) == gltf::GlbChunk::jsonType;
  const std::uint64_t length = isBinary ? littleEndian(&head[12]) : bytes;
  if (!file.is_open() || (isBinary && !hasJson)) {
    problem = "cannot be read";
  } else if (length > longestJson || length > bytes) {
    problem = length > bytes ? "is shorter than it says" : "is too long for a preview";
  }
  if (!problem.empty()) {
    return {};
  }
  file.clear();
  file.seekg(isBinary ? static_cast<std::streamoff>(head.size()) : 0);
  std::string text(static_cast<std::size_t>(length), '\0');
  file.read(text.data(), static_cast<std::streamsize>(length));
  return text;
}

/// A list of the file; empty where it has none, or something else in its place.
const Json& listOf(const Json& object, const char* key) {
  static const Json none = Json::array();
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() && found->is_array() ? *found : none;
}

const Json& entryOf(const Json& list, const Json& object, const char* key) {
  static const Json none;
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (!object.is_object() || found == object.end() || !found->is_number_unsigned()) {
    return none;
  }
  const auto index = found->get<std::size_t>();
  return index < list.size() ? list[index] : none;
}

double secondsOf(const Json& json, const Json& animation) {
  double seconds = 0.0;
  for (const Json& sampler : listOf(animation, "samplers")) {
    const Json& latest = listOf(entryOf(listOf(json, "accessors"), sampler, "input"), "max");
    if (!latest.empty() && latest[0].is_number()) {
      seconds = std::max(seconds, latest[0].get<double>());
    }
  }
  return seconds;
}

void readScene(const Json& json, FileFacts& facts) {
  facts.isScene = true;
  facts.meshes = static_cast<int>(listOf(json, "meshes").size());
  std::set<std::int64_t> joints;
  for (const Json& skin : listOf(json, "skins")) {
    for (const Json& joint : listOf(skin, "joints")) {
      if (joint.is_number_integer()) {
        joints.insert(joint.get<std::int64_t>());
      }
    }
  }
  facts.joints = static_cast<int>(joints.size());
  for (const Json& animation : listOf(json, "animations")) {
    const bool named = animation.is_object() && animation.contains("name") && animation["name"].is_string();
    facts.clips.push_back(
        {named ? animation["name"].get<std::string>() : std::string(), secondsOf(json, animation)});
  }
  facts.carriesWork =
      json.contains("extras") && json["extras"].is_object() && json["extras"].contains("stretch_engine");
}

std::string kindOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::pair<const char*, const char*> kinds[] = {{".glb", "Binary glTF"},
                                                       {".gltf", "glTF with files beside it"},
                                                       {".vrm", "VRM avatar"},
                                                       {".vrma", "VRM animation"},
                                                       {".fbx", "FBX scene"},
                                                       {".bvh", "BVH motion capture"},
                                                       {".dae", "Collada scene"},
                                                       {".obj", "OBJ mesh"},
                                                       {".ply", "PLY mesh"},
                                                       {".pc2", "Cache of a mesh sequence"},
                                                       {".mdd", "Cache of a mesh sequence"},
                                                       {".json", "JSON text"}};
  for (const auto& [known, kind] : kinds) {
    if (extension == known) {
      return kind;
    }
  }
  return {};
}

} // namespace

FileFacts factsOf(const std::filesystem::path& path) {
  FileFacts facts;
  std::error_code problem;
  if (!std::filesystem::is_regular_file(path, problem)) {
    return facts;
  }
  facts.kind = kindOf(path);
  const std::uintmax_t bytes = std::filesystem::file_size(path, problem);
  facts.bytes = problem ? 0 : bytes;
  if (facts.kind.find("glTF") == std::string::npos && facts.kind.find("VRM") == std::string::npos) {
    return facts;
  }
  const std::string text = jsonText(path, facts.bytes, facts.problem);
  const Json json = gltf::parseAnyJson(text);
  if (json.is_object()) {
    readScene(json, facts);
  } else if (facts.problem.empty()) {
    facts.problem = "is no glTF";
  }
  return facts;
}

} // namespace stretch::app
