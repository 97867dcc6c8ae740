#include <cstring>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <tiny_gltf.h>

#include "app/edits/trail/trail_edits.h"
#include "app/files/save.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;

namespace {

tinygltf::Model readByOthers(const std::filesystem::path& path) {
  tinygltf::Model model;
  tinygltf::TinyGLTF reader;
  std::string problem;
  std::string warning;
  const bool isRead = reader.LoadBinaryFromFile(&model, &problem, &warning, path.string());
  INFO(problem);
  REQUIRE(isRead);
  CHECK(problem.empty());
  CHECK(warning.empty());
  return model;
}

std::vector<float> floatsOf(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
  REQUIRE(accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT);
  const auto& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  const auto& buffer = model.buffers[static_cast<std::size_t>(view.buffer)];
  const int width = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  std::vector<float> numbers(accessor.count * static_cast<std::size_t>(width));
  std::memcpy(numbers.data(), buffer.data.data() + view.byteOffset + accessor.byteOffset,
              numbers.size() * sizeof(float));
  return numbers;
}

std::string_view pathName(Channel channel) {
  switch (channel) {
  case Channel::translation:
    return "translation";
  case Channel::rotation:
    return "rotation";
  case Channel::scale:
    return "scale";
  case Channel::weights:
    break;
  }
  return "weights";
}

// The keys of a track as the other reader finds them.
void checkTrack(const tinygltf::Model& model, const tinygltf::Animation& animation, const Track& track) {
  int found = 0;
  for (const tinygltf::AnimationChannel& channel : animation.channels) {
    if (channel.target_node == track.node.value && channel.target_path == pathName(track.channel)) {
      const auto& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
      CHECK(floatsOf(model, sampler.input) == track.times);
      CHECK(floatsOf(model, sampler.output) == track.values);
      ++found;
    }
  }
  CHECK(found == 1);
}

} // namespace

TEST_CASE("Another reader finds the stretched joints, skins and keys that were written") {
  const Result<Document> source = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(source);
  NewTrail trail;
  trail.limb = "left-arm";
  trail.settings.startFrame = 12.0;
  trail.settings.endFrame = 27.0;
  trail.settings.scale = 3.0;
  const Result<CreatedTrail> created = createTrail(*source, trail);
  REQUIRE(created);
  const Result<Document> applied = applyTrail(created->document, created->trailId);
  REQUIRE(applied);
  const test::TemporaryFolder folder;
  REQUIRE(saveDocument(*applied, folder / "punch.glb", {}));

  const tinygltf::Model model = readByOthers(folder / "punch.glb");
  const Result<gltf::Loaded> ours = gltf::loadAsItStands(folder / "punch.glb");
  REQUIRE(ours);
  CHECK(model.nodes.size() == ours->scene->nodes.size());
  CHECK(model.nodes.size() > source->scene->nodes.size());
  REQUIRE(model.animations.size() == ours->clips.size());
  for (const CopyOnWrite<Track>& track : ours->clips.front().tracks) {
    checkTrack(model, model.animations.front(), *track);
  }
  for (const tinygltf::Skin& skin : model.skins) {
    CHECK(floatsOf(model, skin.inverseBindMatrices).size() == 16 * skin.joints.size());
  }
  for (const BindChain& chain : ours->scene->bindChains) {
    const std::vector<int>& joints = model.skins.front().joints;
    CHECK(std::find(joints.begin(), joints.end(), chain.lastLeaf().value) != joints.end());
    // The joint that lost its slot stays, behind those that vertices name.
    const auto kept = std::find(joints.begin(), joints.end(), chain.joint.value);
    CHECK(static_cast<std::size_t>(kept - joints.begin()) >= source->scene->skins.front().joints.size());
    CHECK(kept != joints.end());
  }
}
