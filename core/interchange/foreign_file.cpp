#include "core/interchange/foreign_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/core.h>

#include "core/gltf/json/json.h"
#include "core/interchange/assimp_values.h"
#include "core/interchange/fbx_head.h"
#include "core/interchange/figure.h"
#include "core/interchange/figure_clips.h"
#include "core/interchange/figure_meshes.h"
#include "core/interchange/glb_parts.h"
#include "core/interchange/one_name.h"
#include "core/math/finite.h"

namespace stretch::interchange {

namespace {

using gltf::Json;

constexpr const char* exportAgain = "export it again, or as .glb";

const char* hintOf(Format format) {
  return format == Format::fbx ? "fbx" : format == Format::bvh ? "bvh" : "dae";
}

// The library's own word for what is wrong, as one line.
std::string oneLine(std::string text) {
  // Files that are read from memory have this name there.
  constexpr std::string_view inMemory = "$$$___magic___$$$.";
  for (std::size_t at = text.find(inMemory); at != std::string::npos; at = text.find(inMemory)) {
    const std::size_t end = text.find(':', at);
    text.replace(at, end == std::string::npos ? std::string::npos : end + 1 - at, "line ");
  }
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  constexpr std::size_t most = 160;
  return text.substr(0, most);
}

// What the library leaves out without a word but in its log.
class LeftOut : public Assimp::LogStream {
public:
  void write(const char* message) override {
    const std::string_view text(message);
    if (text.find("setting default material") != std::string_view::npos) {
      return; // Nothing is lost.
    }
    ++count;
    const std::size_t origin = text.find(": "); // "Error, T0: "
    first = first.empty()
                ? oneLine(std::string(text.substr(origin == std::string_view::npos ? 0 : origin + 2)))
                : first;
    isOutOfMemory = isOutOfMemory || text.find("bad_alloc") != std::string_view::npos;
  }

  std::size_t count = 0;
  std::string first;
  bool isOutOfMemory = false;
};

// Listens to the log while it lives.
class Listening {
public:
  explicit Listening(LeftOut& to) : to_(to) {
    Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(&to, Assimp::Logger::Err);
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;
  ~Listening() {
    Assimp::DefaultLogger::get()->detachStream(&to_, Assimp::Logger::Err);
    Assimp::DefaultLogger::kill();
  }

private:
  LeftOut& to_;
};

const aiScene* readScene(Assimp::Importer& importer, const Bytes& bytes, Format format) {
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_CAMERAS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_LIGHTS, false);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  // What the library calls a valid scene has a mesh, which a clip alone lacks: what is used is checked where
  // it is.
  constexpr unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                             aiProcess_JoinIdenticalVertices | aiProcess_FlipUVs;
  return importer.ReadFileFromMemory(bytes.data(), bytes.size(), steps, hintOf(format));
}

// What the bytes show and the library does not tell.
std::vector<std::string> warningsOfBytes(const Bytes& bytes, Format format, const ClipNotes& clips,
                                         const FbxHead& head) {
  std::vector<std::string> warnings;
  if (head.layersOnTop > 0) {
    warnings.emplace_back("the file has animation layers on top of each other; they are not blended: one of "
                          "them is played. Bake them before exporting");
  }
  if (head.hasTangents && clips.hasGaps) {
    warnings.emplace_back(
        "curves that bend or step between keys are read as straight lines: bake the clip at every "
        "frame when exporting");
  }
  if (head.hasRepetition) {
    warnings.emplace_back(
        "curves that go on beyond their keys are held there instead: bake the whole clip when exporting");
  }
  if (clips.hasUnevenShed) {
    warnings.emplace_back(
        "a scale that is not inherited is uneven above a joint: what hangs there is as near as can be");
  }
  const BvhFrames frames = format == Format::bvh ? bvhFramesOf(bytes) : BvhFrames{};
  if (frames.said != frames.held) {
    warnings.push_back(fmt::format("says {} frames and holds {}: the first {} are read", frames.said,
                                   frames.held, std::min(frames.said, frames.held)));
  }
  return warnings;
}

bool hasNoRate(const aiScene& scene) {
  return std::ranges::any_of(std::span(scene.mAnimations, scene.mNumAnimations), [](const aiAnimation* clip) {
    return !(std::isfinite(clip->mTicksPerSecond) && clip->mTicksPerSecond > 0.0);
  });
}

Json nodeJson(const std::string& name, const Mat4& local) {
  const Transform parts = toTransform(local);
  Json json{{"name", name}};
  if (parts.translation != Vec3(0.0)) {
    json["translation"] = {parts.translation.x, parts.translation.y, parts.translation.z};
  }
  if (parts.rotation != Quat(1.0, 0.0, 0.0, 0.0)) {
    json["rotation"] = {parts.rotation.x, parts.rotation.y, parts.rotation.z, parts.rotation.w};
  }
  if (parts.scale != Vec3(1.0)) {
    json["scale"] = {parts.scale.x, parts.scale.y, parts.scale.z};
  }
  return json;
}

std::size_t placelessNodes(const Figure& figure) {
  return static_cast<std::size_t>(std::ranges::count_if(figure.nodes, [](const FigureNode& node) {
    return std::ranges::any_of(
        node.chain, [](const aiNode* element) { return !isFinite(matrixOf(element->mTransformation)); });
  }));
}

// Nodes whose matrix is no translation, turn and scale: an uneven scale above a turn, collapsed into one.
std::size_t shearedNodes(const Figure& figure) {
  return static_cast<std::size_t>(std::ranges::count_if(figure.nodes, [&](const FigureNode& node) {
    const Mat4 local = localOf(figure, node, restOf);
    const Mat4 again = toMatrix(toTransform(local));
    double apart = 0.0;
    for (int column = 0; column < 3; ++column) {
      apart =
          std::max(apart, glm::length(local[column] - again[column]) / (glm::length(local[column]) + 1e-12));
    }
    return apart > 1e-3;
  }));
}

// `sharesRoot`: the roots get a parent, at rest where the scene is.
void addNodes(std::vector<gltf::JsonDocument>& nodes, const Figure& figure, bool sharesRoot,
              GlbParts& parts) {
  Json roots = Json::array();
  for (std::size_t i = 0; i < figure.nodes.size(); ++i) {
    if (figure.nodes[i].parent < 0) {
      roots.push_back(i);
    } else {
      (*nodes[static_cast<std::size_t>(figure.nodes[i].parent)])["children"].push_back(i);
    }
  }
  for (const gltf::JsonDocument& node : nodes) {
    parts.add("nodes", node);
  }
  if (sharesRoot) {
    roots = Json::array({parts.add("nodes", {{"name", "Common root"}, {"children", std::move(roots)}})});
  }
  parts.add("scenes", {{"nodes", std::move(roots)}});
}

// Joints that share their name with another one and that a channel or a bone means: the library takes the
// first for all of them.
std::vector<std::string> ambiguousJoints(const aiScene& scene, const Figure& figure,
                                         const NamesApart& names) {
  std::map<std::string, int> counts;
  for (const FigureNode& node : figure.nodes) {
    ++counts[node.name];
  }
  std::set<std::string> meant;
  for (const aiAnimation* const clip : std::span(scene.mAnimations, scene.mNumAnimations)) {
    for (const aiNodeAnim* const channel : std::span(clip->mChannels, clip->mNumChannels)) {
      meant.insert(channel->mNodeName.C_Str());
    }
  }
  for (const aiMesh* const mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    for (const aiBone* const bone : std::span(mesh->mBones, mesh->mNumBones)) {
      meant.insert(bone->mName.C_Str());
    }
  }
  std::vector<std::string> told;
  for (const auto& [name, count] : counts) {
    if (count > 1 && meant.contains(name)) {
      told.push_back(
          fmt::format("{} joints are called '{}': what moves one of them moves the first; give each "
                      "a name of its own where it was made",
                      count, names.nameOf(name)));
    }
  }
  return told;
}

Result<Converted> convertedScene(const aiScene& scene, const std::filesystem::path& file, Format format,
                                 const NamesApart& names, const FbxHead& head) {
  const Figure figure = figureOf(scene, format);
  Converted made;
  GlbParts parts;
  std::vector<gltf::JsonDocument> nodes;
  for (const FigureNode& node : figure.nodes) {
    Mat4 local = localOf(figure, node, restOf);
    local[3].y += node.restLift;
    nodes.emplace_back(nodeJson(names.nameOf(node.name), local));
  }
  const std::vector<int> materials = addMaterials(scene, file, parts, made.warnings);
  const MeshNotes meshes = addMeshes(scene, figure, materials, nodes, parts);
  const ClipNotes clips = addClips(scene, figure, meshes.nodeOfMesh, file.stem().string(), parts);
  addNodes(nodes, figure, meshes.spansRoots, parts);
  for (std::string& told : warningsOfBytes(names.bytes, format, clips, head)) {
    made.warnings.push_back(std::move(told));
  }
  for (std::string& told : ambiguousJoints(scene, figure, names)) {
    made.warnings.push_back(std::move(told));
  }
  if (!figure.unitNote.empty()) {
    made.warnings.push_back(figure.unitNote);
  }
  if (const std::size_t lost = placelessNodes(figure); lost > 0) {
    made.warnings.push_back(fmt::format(
        "nodes that rest at no place, since it is no number, are where their parents are: {}", lost));
  }
  if (const std::size_t sheared = shearedNodes(figure); sheared > 0) {
    made.warnings.push_back(
        fmt::format("{} nodes are sheared, which glTF cannot say: they are as near as can be", sheared));
  }
  if (meshes.unweightedVertices > 0) {
    made.warnings.push_back(fmt::format(
        "{} vertices of skinned meshes follow no bone: they stay where they are", meshes.unweightedVertices));
  }
  if (meshes.lostBones > 0) {
    made.warnings.push_back(
        fmt::format("{} bones of skins are not in the file: what they move stays", meshes.lostBones));
  }
  Result<Bytes> glb = parts.finish();
  if (!glb) {
    return glb.error();
  }
  made.glb = std::move(glb).value();
  return made;
}

// Nodes that hang on none that begins at the top, such as on each other: the library says nothing of them.
void tellLostNodes(const aiScene& scene, const NamesApart& names, std::vector<std::string>& warnings) {
  std::unordered_set<std::string_view> held;
  std::vector<const aiNode*> open{scene.mRootNode};
  while (!open.empty()) {
    const aiNode& node = *open.back();
    open.pop_back();
    held.insert(node.mName.C_Str());
    open.insert(open.end(), node.mChildren, node.mChildren + node.mNumChildren);
  }
  const auto isLost = [&](const std::string& name) { return !name.empty() && !held.contains(name); };
  const auto count = std::ranges::count_if(names.names, isLost);
  if (count > 0) {
    warnings.push_back(fmt::format("{} not hang on the top of the file, and {} left out (such as '{}')",
                                   count == 1 ? "1 node does" : fmt::format("{} nodes do", count),
                                   count == 1 ? "is" : "are",
                                   names.nameOf(*std::ranges::find_if(names.names, isLost))));
  }
}

} // namespace

Result<Converted> converted(const std::filesystem::path& file) {
  const Result<Bytes> bytes = readFile(file);
  if (!bytes) {
    return bytes.error();
  }
  const std::optional<Format> format = formatOf(*bytes);
  if (!format) {
    return Error{"changed while it was read", "", "try again"};
  }
  FbxHead head;
  if (*format == Format::fbx) {
    const Result<FbxHead> known = fbxHeadOf(*bytes);
    if (!known) {
      return known.error();
    }
    head = *known;
  }
  Assimp::Importer importer;
  LeftOut leftOut;
  const Listening listening(leftOut);
  const NamesApart names = withNamesApart(*bytes, *format);
  const aiScene* const scene = readScene(importer, names.bytes, *format);
  if (leftOut.isOutOfMemory ||
      std::string_view(importer.GetErrorString()).find("bad_alloc") != std::string_view::npos) {
    throw std::bad_alloc();
  }
  if (scene == nullptr || scene->mRootNode == nullptr) {
    return Error{fmt::format("is {} that cannot be read ({})",
                             nameOf(*format) == "FBX" ? "an FBX" : "a " + nameOf(*format) + " file",
                             oneLine(importer.GetErrorString())),
                 "", exportAgain};
  }
  if (scene->mNumMeshes == 0 && scene->mRootNode->mNumChildren == 0) {
    return Error{"holds neither a mesh nor a skeleton that begins at its top", "", exportAgain};
  }
  if (*format == Format::collada && toTransform(restOf(*scene->mRootNode)).scale.x <= 0.0) {
    return Error{"says that its unit has no length or a negative one", "unit meter",
                 "write the metres of a unit there, such as 0.01"};
  }
  if (*format == Format::bvh && hasNoRate(*scene)) {
    return Error{"says of a frame that it takes no time, or is no number", "Frame Time",
                 "write the seconds of a frame there, such as 0.0333333"};
  }
  Result<Converted> made = convertedScene(*scene, file, *format, names, head);
  if (made && *format == Format::fbx) {
    tellLostNodes(*scene, names, made.value().warnings);
  }
  if (made && leftOut.count > 0) {
    made.value().warnings.push_back(fmt::format(
        "what the reader calls faulty is left out ({} times, first: {})", leftOut.count, leftOut.first));
  }
  return made;
}

} // namespace stretch::interchange
