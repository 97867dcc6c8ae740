#include "app/edits/pose/prop_file_edits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "core/gltf/source/added_file.h"
#include "rig/body/reading/planned_body.h"
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

bool isUsablePlace(const Document& document, const Vec3& place) {
  constexpr double farthest = 1000.0; // heights of the character
  return std::isfinite(place.x + place.y + place.z) && glm::length(place) <= farthest * document.body.height;
}

bool isOpenFile(const Document& document, const fs::path& path) {
  std::error_code problem;
  return document.source != nullptr && fs::equivalent(document.source->path, path, problem) && !problem;
}

bool isHeld(const Document& document, const gltf::AddedFile& file) {
  const NodeIndex node = rig::propNode(*document.scene, file.name);
  return std::ranges::any_of(document.holds.props, [&](const rig::Prop& prop) {
    return rig::propNode(*document.scene, prop.node) == node;
  });
}

std::size_t sourceNodeCount(const Document& document) {
  std::size_t count = document.scene->nodes.size();
  for (const gltf::AddedFile& file : document.addedFiles) {
    count -= gltf::addedNodeCount(file);
  }
  return count;
}

// Chains name nodes by index, which would be others once a file is gone.
bool hasChainOnFiles(const Document& document) {
  const NodeIndex past(sourceNodeCount(document));
  return std::ranges::any_of(document.chains, [&](const rig::Limb& chain) {
    return chain.endNode >= past ||
           std::ranges::any_of(chain.joints, [&](NodeIndex joint) { return joint >= past; });
  });
}

std::string nodeText(NodeIndex node) {
  return fmt::format("#{}", node.value);
}

// Nodes of the scene by the file that they were added with: where the same nodes are once other files stay.
std::vector<NodeIndex> movedNodes(const Document& document, const std::vector<gltf::AddedFile>& kept) {
  std::vector<NodeIndex> moved;
  const std::size_t sourceCount = sourceNodeCount(document);
  for (std::size_t i = 0; i < sourceCount; ++i) {
    moved.emplace_back(i);
  }
  for (const gltf::AddedFile& file : document.addedFiles) {
    const auto place = std::ranges::find(kept, file.name, &gltf::AddedFile::name);
    std::size_t next = sourceCount;
    for (auto before = kept.begin(); before != place; ++before) {
      next += gltf::addedNodeCount(*before);
    }
    for (std::size_t i = 0; i < gltf::addedNodeCount(file); ++i) {
      moved.push_back(place != kept.end() ? NodeIndex(next + i) : NodeIndex::none);
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
    setEndsFromKeys(clip);
    for (CopyOnWrite<Track>& track : clip.tracks) {
      if (isMoved(track)) {
        Track changed = *track;
        changed.node = moved[at(track->node)];
        track = CopyOnWrite<Track>(std::move(changed));
      }
    }
  }
  const auto sameKeys = [](const Clip& a, const Clip& b) { return a.tracks == b.tracks; };
  if (document.sourceClips != nullptr && std::ranges::equal(clips, *document.sourceClips, sameKeys)) {
    document.sourceClips = nullptr;
  }
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  std::erase_if(document.followingKeys,
                [&](const FollowingKeys& keys) { return !moved[at(keys.node)].exists(); });
  for (FollowingKeys& keys : document.followingKeys) {
    keys.node = moved[at(keys.node)];
  }
}

} // namespace

Result<Document> withAddedFiles(const Document& document, std::vector<gltf::AddedFile> files) {
  if (files == document.addedFiles) {
    return document;
  }
  if (document.source == nullptr) {
    return Error{"the character is of no file", "", "open one"};
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
  Result<gltf::Thing> thing = gltf::readThing(file.path);
  if (!thing) {
    return thing.error();
  }
  gltf::AddedFile added{file.path.filename().string(),
                        freeNodeName(*document.scene, file.path.stem().string()),
                        {},
                        std::move(thing->source)};
  added.place.translation = file.place;
  if (!isUsablePlace(document, file.place)) {
    return Error{"its place is out of proportion", file.path.string(),
                 "give one within a thousand heights of the character from the origin"};
  }
  std::vector<gltf::AddedFile> files = document.addedFiles;
  files.push_back(added);
  Result<Document> changed = withAddedFiles(document, std::move(files));
  if (!changed) {
    return Error{changed.error().line(), file.path.string(), "give another file"};
  }
  changed->warnings.insert(changed->warnings.end(), thing->warnings.begin(), thing->warnings.end());
  return AddedProp{std::move(*changed), added.name, std::move(thing->warnings)};
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
  if (hasChainOnFiles(document)) {
    return document;
  }
  std::vector<gltf::AddedFile> held;
  std::ranges::copy_if(document.addedFiles, std::back_inserter(held),
                       [&](const gltf::AddedFile& file) { return isHeld(document, file); });
  return withAddedFiles(document, std::move(held));
}

Result<Document> takeHoldAway(const Document& document, const HoldPlace& place) {
  return withoutUnheldFiles(removeHold(document, place));
}

namespace {

std::shared_ptr<const Scene> sceneOfSource(const Document& document) {
  const Result<std::shared_ptr<const Scene>> own =
      document.addedFiles.empty() ? document.scene : gltf::sceneWith(*document.source, {});
  return own ? *own : document.scene;
}

// The file's first clip, as the file has it.
const Clip* firstClip(const Document& document) {
  const std::shared_ptr<const std::vector<Clip>>& clips = sourceClipsOf(document);
  return clips == nullptr || clips->size() <= document.importedClips ? nullptr : &clips->front();
}

} // namespace

rig::Body bodyOfSource(const Document& document) {
  return rig::detectBody(*sceneOfSource(document), firstClip(document));
}

rig::Body bodyOfSource(const Document& document, const rig::BodyPlan& plan) {
  return rig::bodyAsPlan(*sceneOfSource(document), plan, firstClip(document));
}

} // namespace stretch::app
