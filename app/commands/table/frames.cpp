#include "app/commands/table/frames.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/anim/frames.h"

namespace stretch::app {

namespace {

/// The limbs' nodes; empty: every node.
std::set<NodeIndex> nodesOf(const Document& document, const std::vector<std::string>& limbIds) {
  std::set<NodeIndex> nodes;
  for (const std::string& id : limbIds) {
    if (const rig::Limb* limb = findLimb(document, id)) {
      nodes.insert(limb->joints.begin(), limb->joints.end());
      nodes.insert(limb->endNode);
    }
  }
  return nodes;
}

} // namespace

bool hasClip(const Document& document, int clip) {
  return document.clips != nullptr && clip >= 0 && clip < static_cast<int>(document.clips->size());
}

double lastFrame(const Document& document, int clip) {
  return hasClip(document, clip) ? lastFrame(clipOf(document, clip)) : 0.0;
}

namespace {

std::vector<double> keyFramesOf(const Document& document, const Clip& motion,
                                const std::vector<std::string>& limbIds) {
  const std::set<NodeIndex> nodes = nodesOf(document, limbIds);
  std::vector<double> frames;
  for (const CopyOnWrite<Track>& track : motion.tracks) {
    if (!nodes.empty() && nodes.find(track->node) == nodes.end()) {
      continue;
    }
    for (const float seconds : track->times) {
      frames.push_back(std::round(static_cast<double>(seconds) * motion.framesPerSecond * 1000.0) / 1000.0);
    }
  }
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

} // namespace

std::vector<double> keyFrames(const Document& document, int clip, const std::vector<std::string>& limbIds) {
  return hasClip(document, clip) ? keyFramesOf(document, clipOf(document, clip), limbIds)
                                 : std::vector<double>{};
}

std::vector<double> shownKeyFrames(Session& session, const std::vector<std::string>& limbIds) {
  return hasClip(session.document(), session.view().clip)
             ? keyFramesOf(session.document(), session.shownClip(), limbIds)
             : std::vector<double>{};
}

} // namespace stretch::app
