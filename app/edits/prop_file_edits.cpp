#include "app/edits/prop_file_edits.h"

#include <algorithm>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "app/edits/hold_edits.h"
#include "app/evaluate/evaluate.h"
#include "core/gltf/added_file.h"
#include "rig/motion/bind_places.h"
#include "rig/motion/solve_holds.h"

namespace stretch::app {

namespace {

namespace fs = std::filesystem;

std::string freeNodeName(const Scene& scene, const std::string& wanted) {
  const auto isTaken = [&](const std::string& name) {
    return std::ranges::find(scene.nodes, name, &Node::name) != scene.nodes.end();
  };
  std::string name = wanted;
  for (int number = 2; isTaken(name); ++number) {
    name = fmt::format("{} {}", wanted, number);
  }
  return name;
}

// Of the part of the mesh that follows the hand, else the hand's joint.
Vec3 middleOfHand(const Document& document, const rig::Limb& limb, const FrameState& frame) {
  const NodeIndex hand = limb.endNode.exists() ? limb.endNode : limb.joints.back();
  const rig::BindPlaces places = rig::bindPlaces(*document.scene);
  const Bounds& box = places.meshes[at(hand)];
  if (box.empty()) {
    return rig::endPosition(limb, frame);
  }
  const Mat4 moved = frame.worlds[at(hand)] * glm::inverse(places.worlds[at(hand)]);
  return transformPoint(moved, 0.5 * (box.low + box.high));
}

Document withoutHoldsAndTrails(Document document) {
  document.trails.clear();
  document.holds = {};
  document.weights.clear();
  return document;
}

Result<Vec3> placeInHands(const Document& document, const PropFile& file) {
  if (document.clips == nullptr || file.clip < 0 || at(file.clip) >= document.clips->size()) {
    return Error{"the file has no such clip", fmt::format("clip {}", file.clip),
                 "open a file with an animation"};
  }
  const Document adjusted = withoutHoldsAndTrails(document);
  const double seconds = file.frame / clipOf(adjusted, file.clip).framesPerSecond;
  const FrameState frame = evaluate(adjusted, prepareMotion(adjusted, file.clip), seconds);
  Vec3 sum(0.0);
  for (const std::string& hand : file.hands) {
    const rig::Limb* const limb = findLimb(document, hand);
    if (limb == nullptr) {
      return Error{"the character has no such limb", hand, "give left-arm or right-arm"};
    }
    sum += middleOfHand(document, *limb, frame);
  }
  return file.hands.empty() ? Result<Vec3>(Error{"no hand is to hold it", file.path.string(), "name one"})
                            : Result<Vec3>(sum / static_cast<double>(file.hands.size()));
}

bool isOpenFile(const Document& document, const fs::path& path) {
  std::error_code problem;
  return fs::equivalent(document.source->path, path, problem) && !problem;
}

bool isHeld(const Document& document, const gltf::AddedFile& file) {
  const NodeIndex node = rig::propNode(*document.scene, file.name);
  return std::ranges::any_of(document.holds.props, [&](const rig::Prop& prop) {
    return rig::propNode(*document.scene, prop.node) == node;
  });
}

std::string nodeText(NodeIndex node) {
  return fmt::format("#{}", node.value);
}

// Nodes of the scene by the file that they were added with: where the same nodes are once other files stay.
std::vector<NodeIndex> movedNodes(const Document& document, const std::vector<gltf::AddedFile>& kept) {
  std::vector<NodeIndex> moved;
  std::size_t sourceCount = document.scene->nodes.size();
  for (const gltf::AddedFile& file : document.addedFiles) {
    sourceCount -= gltf::addedNodeCount(file);
  }
  for (std::size_t i = 0; i < sourceCount; ++i) {
    moved.emplace_back(i);
  }
  std::size_t next = sourceCount;
  for (const gltf::AddedFile& file : document.addedFiles) {
    const bool stays = std::ranges::find(kept, file) != kept.end();
    for (std::size_t i = 0; i < gltf::addedNodeCount(file); ++i) {
      moved.push_back(stays ? NodeIndex(next++) : NodeIndex::none);
    }
  }
  return moved;
}

// Keys that the user gave to added nodes go with them.
void moveTracks(const std::vector<NodeIndex>& moved, Document& document) {
  const auto isMoved = [&](const CopyOnWrite<Track>& track) { return moved[at(track->node)] != track->node; };
  const bool changes =
      document.clips != nullptr && std::ranges::any_of(*document.clips, [&](const Clip& clip) {
        return std::ranges::any_of(clip.tracks, isMoved);
      });
  if (!changes) {
    return;
  }
  std::vector<Clip> clips = *document.clips;
  for (Clip& clip : clips) {
    std::erase_if(clip.tracks,
                  [&](const CopyOnWrite<Track>& track) { return !moved[at(track->node)].exists(); });
    for (CopyOnWrite<Track>& track : clip.tracks) {
      if (isMoved(track)) {
        Track changed = *track;
        changed.node = moved[at(track->node)];
        track = CopyOnWrite<Track>(std::move(changed));
      }
    }
  }
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
}

} // namespace

Result<Document> withAddedFiles(const Document& document, std::vector<gltf::AddedFile> files) {
  if (files == document.addedFiles) {
    return document;
  }
  Result<std::shared_ptr<const Scene>> scene = gltf::sceneWith(*document.source, files);
  if (!scene) {
    return scene.error();
  }
  Document changed = document;
  const std::vector<NodeIndex> moved = movedNodes(document, files);
  moveTracks(moved, changed);
  for (rig::Prop& prop : changed.holds.props) {
    const NodeIndex node = rig::propNode(*document.scene, prop.node);
    if (prop.node.starts_with('#') && node.exists() && moved[at(node)].exists()) {
      prop.node = nodeText(moved[at(node)]);
    }
  }
  changed.scene = std::move(scene).value();
  changed.addedFiles = std::move(files);
  return changed;
}

Result<AddedProp> withPropFile(const Document& document, const PropFile& file) {
  if (isOpenFile(document, file.path)) {
    return Error{"is the open file itself", file.path.string(), "give the file of a thing"};
  }
  const std::string fileName = file.path.filename().string();
  const auto known = std::ranges::find(document.addedFiles, fileName, &gltf::AddedFile::file);
  if (known != document.addedFiles.end()) {
    return AddedProp{document, known->name};
  }
  Result<std::shared_ptr<const gltf::Source>> thing = gltf::readThing(file.path);
  if (!thing) {
    return thing.error();
  }
  const Result<Vec3> place = placeInHands(document, file);
  if (!place) {
    return place.error();
  }
  gltf::AddedFile added{fileName, freeNodeName(*document.scene, file.path.stem().string()), {}, *thing};
  added.place.translation = *place;
  std::vector<gltf::AddedFile> files = document.addedFiles;
  files.push_back(added);
  Result<Document> changed = withAddedFiles(document, std::move(files));
  return changed ? Result<AddedProp>(AddedProp{std::move(changed).value(), added.name})
                 : Result<AddedProp>(changed.error());
}

Result<AddedProp> holdPropFile(const Document& document, const PropFile& file) {
  Result<AddedProp> added = withPropFile(document, file);
  if (!added) {
    return added;
  }
  rig::Prop prop;
  prop.node = added->node;
  prop.clip = file.clip;
  prop.boundFrame = file.frame;
  for (const std::string& hand : file.hands) {
    rig::OffsetKey firm;
    firm.value = 1.0;
    prop.hands.push_back({hand, {firm}});
  }
  rig::Holds holds;
  holds.props.push_back(std::move(prop));
  Result<Document> held = placeHolds(added->document, holds);
  if (!held) {
    return held.error();
  }
  added->document = std::move(held).value();
  return added;
}

Result<Document> withoutUnheldFiles(const Document& document) {
  std::vector<gltf::AddedFile> held;
  std::ranges::copy_if(document.addedFiles, std::back_inserter(held),
                       [&](const gltf::AddedFile& file) { return isHeld(document, file); });
  return withAddedFiles(document, std::move(held));
}

} // namespace stretch::app
