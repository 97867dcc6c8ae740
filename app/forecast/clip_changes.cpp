#include "app/forecast/clip_changes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/evaluate/cache.h"
#include "app/evaluate/evaluate.h"
#include "app/standing_floor.h"
#include "core/anim/frames.h"
#include "core/gltf/json/json.h"
#include "core/math/rotation.h"
#include "rig/motion/evaluate.h"
#include "rig/motion/seam.h"
#include "rig/rekey/rekey.h"
#include "rig/retarget/standing.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

constexpr double mostVerticesAtTimes = 1e6; // looked at in one clip
constexpr double mostFrames = 20000.0;      // in which feet that stand are looked for

// What is compared of one clip.
struct Measures {
  double seamPlace = 0.0;     // of the height
  double seamTurn = 0.0;      // degrees
  double seamSpeed = 0.0;     // heights per second
  std::vector<double> slides; // of the height, by leg
  double below = 0.0;         // of the height
  double flips = 0.0;         // pairs of keys
};

struct Standing {
  std::size_t leg = 0;
  rig::Stand frames;
};

class ClipMeasuring {
public:
  ClipMeasuring(const Document& body, int clip, const WatchedClip& source)
      : body_(body), source_(source), floor_(floorHeight(body, clip)),
        loop_(rig::loopTravel(*source.scene, source.clip, body.body.hips, body.body.height)) {
    for (const rig::Limb& limb : body.body.limbs) {
      if (rig::isLeg(limb)) {
        legs_.push_back(limb);
      }
    }
    const std::vector<std::vector<Vec3>> feet = feetOfFrames();
    for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
      for (const rig::Stand& frames : rig::standingIn(feet[leg], rate(), body_.body.height)) {
        standing_.push_back({leg, frames});
      }
    }
  }

  [[nodiscard]] const std::vector<rig::Limb>& legs() const { return legs_; }

  /// The depth is left 0 where it is not wanted: it is told by the mesh, which costs most.
  [[nodiscard]] Measures of(const WatchedClip& watched, bool wantsDepth = true) const {
    Measures measures;
    measures.slides.assign(legs_.size(), 0.0);
    for (const Standing& standing : standing_) {
      double& slide = measures.slides[standing.leg];
      slide = std::max(slide, wanderOf(watched, standing));
    }
    if (loop_) {
      measureSeam(watched, measures);
    }
    measures.below = wantsDepth ? depthOf(watched) : 0.0;
    measures.flips = flipsOf(watched.clip);
    return measures;
  }

private:
  [[nodiscard]] double rate() const { return source_.clip.framesPerSecond; }

  [[nodiscard]] Vec3 footAt(const WatchedClip& watched, std::size_t leg, double frame) const {
    return rig::endPosition(legs_[leg], watched.at(frame / rate()));
  }

  // Where each leg's foot is in every frame; nothing of a clip of a length that no animator looks through.
  [[nodiscard]] std::vector<std::vector<Vec3>> feetOfFrames() const {
    std::vector<std::vector<Vec3>> feet(legs_.size());
    if (lastFrame(source_.clip) > mostFrames) {
      return feet;
    }
    for (double frame = 0.0; frame <= lastFrame(source_.clip); frame += 1.0) {
      const FrameState shown = source_.at(frame / rate());
      for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
        feet[leg].push_back(rig::endPosition(legs_[leg], shown));
      }
    }
    return feet;
  }

  [[nodiscard]] double wanderOf(const WatchedClip& watched, const Standing& standing) const {
    std::vector<Vec3> feet;
    for (std::size_t frame = standing.frames.first; frame <= standing.frames.last; ++frame) {
      feet.push_back(footAt(watched, standing.leg, static_cast<double>(frame)));
    }
    return rig::wanderIn(feet, {0, feet.size() - 1}) / body_.body.height;
  }

  void measureSeam(const WatchedClip& watched, Measures& measures) const {
    const double start = source_.clip.startSeconds;
    const double end = source_.clip.endSeconds;
    const double step = std::min(1.0 / rate(), 0.5 * (end - start));
    const FrameState first = watched.at(start);
    const FrameState second = watched.at(start + step);
    const FrameState last = watched.at(end);
    const FrameState before = watched.at(end - step);
    const Vec3 travel = *loop_; // the source's: a body that jumps aside is no travel of its own
    for (const NodeIndex node : skinJoints(*source_.scene)) {
      const auto place = [&](const FrameState& frame) { return positionOf(frame.worlds[at(node)]); };
      const double apart = glm::length(place(last) - place(first) - travel);
      const double speed = glm::length((place(last) - place(before)) - (place(second) - place(first))) / step;
      const double radians =
          angleBetween(rotationOf(first.worlds[at(node)]), rotationOf(last.worlds[at(node)]));
      measures.seamPlace = std::max(measures.seamPlace, apart / body_.body.height);
      measures.seamSpeed = std::max(measures.seamSpeed, speed / body_.body.height);
      measures.seamTurn = std::max(measures.seamTurn, radians * 180.0 / pi);
    }
  }

  [[nodiscard]] double depthOf(const WatchedClip& watched) const {
    if (!floor_) {
      return 0.0;
    }
    const double vertices = static_cast<double>(std::max<std::size_t>(1, vertexCount(*watched.scene)));
    const double step = std::max(1.0, std::ceil(lastFrame(source_.clip) * vertices / mostVerticesAtTimes));
    double lowest = *floor_;
    for (double frame = 0.0; frame <= lastFrame(source_.clip); frame += step) {
      const FrameState shown = watched.at(frame / rate());
      if (watched.surface != nullptr) {
        const std::optional<Vec3> lower = watched.surface->lowest(watched.surface->posed(shown), lowest);
        lowest = lower ? lower->y : lowest;
      } else {
        for (const Vec3& place : skinning::skinnedPositions(*watched.scene, shown)) {
          lowest = std::min(lowest, place.y);
        }
      }
    }
    return (*floor_ - lowest) / body_.body.height;
  }

  [[nodiscard]] static double flipsOf(const Clip& clip) {
    double flips = 0.0;
    for (const CopyOnWrite<Track>& track : clip.tracks) {
      const bool isLinearTurn =
          track->channel == Channel::rotation && track->interpolation == Interpolation::linear;
      for (std::size_t key = 1; isLinearTurn && key < track->times.size(); ++key) {
        double dot = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
          dot += static_cast<double>(track->values[4 * key + i]) *
                 static_cast<double>(track->values[4 * key - 4 + i]);
        }
        flips += dot < 0.0 ? 1.0 : 0.0;
      }
    }
    return flips;
  }

  const Document& body_;
  const WatchedClip& source_;
  std::optional<double> floor_;
  std::optional<Vec3> loop_;
  std::vector<rig::Limb> legs_;
  std::vector<Standing> standing_;
};

WatchedClip watchedClip(const Document& document, int clip,
                        const std::shared_ptr<const skinning::SurfacePart>& surface) {
  const Clip& own = clipOf(document, clip);
  return {document.scene.get(), own,
          [&document, &own](double time) { return rig::sampledFrame(*document.scene, own, time); }, surface};
}

// The index of the clip of a name, the one at the same place before others; -1: none.
int clipNamed(const Document& document, const std::string& name, int place) {
  const std::vector<Clip>& clips = *document.clips;
  if (at(place) < clips.size() && clips[at(place)].name == name) {
    return place;
  }
  const auto found = std::ranges::find(clips, name, &Clip::name);
  return found == clips.end() ? -1 : static_cast<int>(found - clips.begin());
}

bool sharesLimbs(const Document& result, const Document& source) {
  return std::ranges::all_of(source.body.limbs, [&](const rig::Limb& limb) {
    return std::ranges::all_of(limb.joints, [&](NodeIndex joint) {
      return at(joint) < result.scene->nodes.size() &&
             result.scene->nodes[at(joint)].name == source.scene->nodes[at(joint)].name;
    });
  });
}

} // namespace

std::shared_ptr<const skinning::SurfacePart> wholeSurface(const Scene& scene) {
  const bool morphs = std::ranges::any_of(scene.meshes, [](const Mesh& mesh) {
    return std::ranges::any_of(mesh.primitives, [](const Primitive& p) { return !p.morphTargets.empty(); });
  });
  return morphs ? nullptr
                : std::make_shared<const skinning::SurfacePart>(skinning::SurfacePart::whole(scene));
}

std::vector<ClipChange> worseThanSource(const Document& body, int clip, const WatchedClip& source,
                                        const WatchedClip& result) {
  constexpr double seenPlace = 1e-3; // of the height
  constexpr double seenTurn = 0.5;   // degrees
  constexpr double seenSpeed = 1e-2; // of the height per second
  const ClipMeasuring measuring(body, clip, source);
  const Measures after = measuring.of(result);
  const Measures before = measuring.of(source, after.below > seenPlace); // less is never worse
  std::vector<ClipChange> changes;
  const auto compare = [&](const char* id, double a, double b, double seen, double factor, const char* unit,
                           const std::string& limb = {}) {
    if (b > a + seen) {
      changes.push_back({id, source.clip.name, limb, factor * a, factor * b, unit});
    }
  };
  compare("loop-seam-place", before.seamPlace, after.seamPlace, seenPlace, 100.0, "% of the height");
  compare("loop-seam-turn", before.seamTurn, after.seamTurn, seenTurn, 1.0, "degrees");
  compare("loop-seam-speed", before.seamSpeed, after.seamSpeed, seenSpeed, 100.0,
          "% of the height per second");
  for (std::size_t leg = 0; leg < measuring.legs().size(); ++leg) {
    compare("foot-slide", before.slides[leg], after.slides[leg], seenPlace, 100.0, "% of the height",
            measuring.legs()[leg].id);
  }
  compare("below-floor", before.below, after.below, seenPlace, 100.0, "% of the height");
  compare("hemisphere-flips", before.flips, after.flips, 0.5, 1.0, "keys");
  return changes;
}

std::vector<ClipChange> worseThanSource(const Document& document,
                                        const std::vector<std::pair<int, std::vector<Track>>>& edited,
                                        EvaluationCache& cache) {
  std::vector<ClipChange> all;
  const int known = static_cast<int>(document.clips->size() - document.importedClips);
  const std::shared_ptr<const skinning::SurfacePart> surface = wholeSurface(*document.scene);
  for (const auto& [clip, tracks] : edited) {
    if (clip >= known) {
      continue; // it came from another file: nothing stands before it
    }
    const Clip& own = sourceClipOf(document, clip);
    const std::shared_ptr<const rig::MotionState> motion = cache.motion(document, clip);
    const WatchedClip source{document.scene.get(), own,
                             [&](double time) { return rig::sampledFrame(*document.scene, own, time); },
                             surface};
    const WatchedClip result{document.scene.get(), rig::withTracks(own, tracks),
                             [&](double time) { return evaluate(document, *motion, time); }, surface};
    const std::vector<ClipChange> changes = worseThanSource(document, clip, source, result);
    all.insert(all.end(), changes.begin(), changes.end());
  }
  return all;
}

Result<FileChanges> worseThanFile(const Document& result, const Document& source) {
  if (!sharesLimbs(result, source)) {
    return Error{"is not the file that the other was made from: its limbs have other joints",
                 source.source->path.string(), "name the file that was opened for the edit"};
  }
  FileChanges all;
  const std::shared_ptr<const skinning::SurfacePart> before = wholeSurface(*source.scene);
  const std::shared_ptr<const skinning::SurfacePart> after = wholeSurface(*result.scene);
  std::vector<bool> isCompared(result.clips->size());
  for (int clip = 0; clip < static_cast<int>(source.clips->size()); ++clip) {
    const std::string& name = clipOf(source, clip).name;
    const int other = clipNamed(result, name, clip);
    (other < 0 ? all.gone : all.compared).push_back(name);
    if (other < 0) {
      continue;
    }
    isCompared[at(other)] = true;
    const std::vector<ClipChange> changes =
        worseThanSource(source, clip, watchedClip(source, clip, before), watchedClip(result, other, after));
    all.worse.insert(all.worse.end(), changes.begin(), changes.end());
  }
  for (std::size_t clip = 0; clip < isCompared.size(); ++clip) {
    if (!isCompared[clip]) {
      all.added.push_back((*result.clips)[clip].name);
    }
  }
  if (all.compared.empty()) {
    return Error{"has no clip of the same name as one of the other, so nothing can be compared",
                 source.source->path.string(), "name the file that was opened for the edit"};
  }
  return all;
}

gltf::Json changesToJson(const std::vector<ClipChange>& changes) {
  gltf::Json list = gltf::Json::array();
  for (const ClipChange& change : changes) {
    gltf::Json json = {{"id", change.id},
                       {"clip", change.clip},
                       {"source", change.source},
                       {"result", change.result},
                       {"unit", change.unit}};
    if (!change.limb.empty()) {
      json["limb"] = change.limb;
    }
    list.push_back(std::move(json));
  }
  return list;
}

void printChanges(const gltf::Json& changes) {
  for (const gltf::Json& change : changes) {
    fmt::print("worse  {}{} in '{}': {:.2f} {}, and {:.2f} before\n", change["id"].get<std::string>(),
               change.contains("limb") ? " of " + change["limb"].get<std::string>() : "",
               change["clip"].get<std::string>(), change["result"].get<double>(),
               change["unit"].get<std::string>(), change["source"].get<double>());
  }
}

} // namespace stretch::app
