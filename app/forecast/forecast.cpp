#include "app/forecast/forecast.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/edits/pose/prop_file_edits.h"
#include "app/forecast/shading.h"
#include "core/gltf/import/accessor.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "core/gltf/load/report.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/plain_source.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

namespace {

// Of the skinned meshes that are drawn.
bool hasAllNormals(const Scene& scene) {
  return std::ranges::all_of(skinning::drawnMeshNodes(scene), [&](NodeIndex node) {
    const Node& holder = scene.nodes[at(node)];
    return holder.skin < 0 ||
           std::ranges::all_of(scene.meshes[at(holder.mesh)].primitives, &Primitive::hasNormals);
  });
}

constexpr const char* useVolume =
    "save the stretch with --form volume, or translation; scale of the source's own joints is baked out "
    "where it was made";

// What the file holds, found once for all engines.
struct FileFindings {
  std::vector<ClipLooks> looks;
  Bounds rest;
  std::vector<gltf::Shear> shear;
  std::size_t beyondFour = 0; // vertices with more than four influences
  std::size_t vertices = 0;
  double tail = 0.0; // largest weight of a vertex's second set
};

// Channels of a clip that go where an engine leaves them out.
struct LostChannels {
  std::size_t channels = 0;
  std::set<std::string> limbs;
};

struct Span {
  Vec3 low{1e300};
  Vec3 high{-1e300};
};

Span spanOf(const Track& track) {
  Span span;
  const std::size_t perKey = track.interpolation == Interpolation::cubicSpline ? 3 : 1;
  for (std::size_t key = 0; key < track.times.size(); ++key) {
    const std::size_t first = (key * perKey + perKey / 2) * 3;
    const Vec3 value(track.values[first], track.values[first + 1], track.values[first + 2]);
    span.low = glm::min(span.low, value);
    span.high = glm::max(span.high, value);
  }
  return span;
}

bool scalesUnequallyOrMoves(const Track& track) {
  constexpr double seen = 1e-3;
  const Span span = spanOf(track);
  const Vec3 range = span.high - span.low;
  const double apart = std::max({std::abs(span.high.x - span.high.y), std::abs(span.high.x - span.high.z),
                                 std::abs(span.high.y - span.high.z)});
  return std::max({range.x, range.y, range.z, apart}) > seen;
}

bool movesVisibly(const Scene& scene, const Track& track) {
  constexpr double seen = 1e-2; // of the bone
  const Span span = spanOf(track);
  const double bone = glm::length(scene.nodes[at(track.node)].rest.translation);
  return glm::length(span.high - span.low) > seen * std::max(bone, 1e-9);
}

// Nodes that a mesh hangs on, as a joint or rigidly, or that lie above such nodes.
std::set<NodeIndex> deforming(const Scene& scene) {
  std::set<NodeIndex> nodes = skinJoints(scene);
  for (const BindChain& chain : scene.bindChains) {
    const std::vector<NodeIndex> own = chain.nodes();
    nodes.insert(own.begin(), own.end());
  }
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    if (scene.nodes[node].mesh >= 0 && scene.nodes[node].skin < 0) {
      nodes.insert(NodeIndex(node));
    }
  }
  return nodes;
}

// Bones that a humanoid map names and whose translation it leaves out: all but those of the spine above its
// first one, neck, shoulders and upper legs, and the hips, which carry the body.
std::set<NodeIndex> mappedAndHeld(const Document& document) {
  std::set<NodeIndex> held;
  for (const rig::Limb& limb : document.body.limbs) {
    if (limb.kind == rig::LimbKind::spine) {
      held.insert(limb.joints.front());
      continue;
    }
    const bool keepsBase = limb.kind == rig::LimbKind::neck || rig::isLeg(limb);
    held.insert(limb.joints.begin() + (keepsBase ? 1 : 0), limb.joints.end());
    held.insert(limb.endNode);
  }
  held.erase(NodeIndex::none);
  held.erase(document.body.hips);
  return held;
}

std::set<NodeIndex> mapped(const Document& document) {
  std::set<NodeIndex> nodes{document.body.hips};
  for (const rig::Limb& limb : document.body.limbs) {
    nodes.insert(limb.joints.begin(), limb.joints.end());
    nodes.insert(limb.endNode);
  }
  return nodes;
}

template <typename IsLost>
LostChannels lostChannels(const Document& document, int clip, const IsLost& isLost) {
  LostChannels lost;
  for (const CopyOnWrite<Track>& track : clipOf(document, clip).tracks) {
    if (isLost(*track)) {
      ++lost.channels;
      lost.limbs.insert(limbOfNode(document, track->node));
    }
  }
  lost.limbs.erase(std::string());
  return lost;
}

std::string joinedLimbs(const std::set<std::string>& limbs) {
  std::string text;
  for (const std::string& limb : limbs) {
    text += (text.empty() ? "" : ", ") + limb;
  }
  return text.empty() ? "no limb that was found" : text;
}

ForecastFinding findingOf(std::string id, gltf::Severity severity, const LostChannels& lost) {
  ForecastFinding finding{.id = std::move(id), .severity = severity};
  finding.limb = lost.limbs.size() == 1 ? *lost.limbs.begin() : "";
  return finding;
}

class EngineJudge {
public:
  EngineJudge(const Document& document, const FileFindings& file, const Engine& engine)
      : document_(document), file_(file), engine_(engine), deforming_(deforming(*document.scene)) {}

  EngineForecast forecast() {
    for (const ClipLooks& looks : file_.looks) {
      judgeShading(looks);
      judgeScale(looks.clip);
      judgeMapped(looks.clip);
      judgeCulling(looks);
    }
    judgeShear();
    judgeInfluences();
    result_.engine = engine_.id;
    result_.notJudged = engine_.notJudged;
    if (!engine_.knowsAllInterpolations && hasOtherInterpolations()) {
      result_.notJudged.emplace_back("keys that are not LINEAR");
    }
    if (engine_.turnsNormalsPlainly && !hasAllNormals(*document_.scene)) {
      result_.notJudged.emplace_back("shading of meshes without normals");
    }
    return std::move(result_);
  }

private:
  void add(ForecastFinding finding, int clip) {
    finding.clip = clip < 0 ? "" : clipOf(document_, clip).name;
    result_.findings.push_back(std::move(finding));
  }

  void judgeShading(const ClipLooks& looks) {
    constexpr double seen = 0.005; // of the moved vertices
    if (!engine_.turnsNormalsPlainly || looks.share() < seen) {
      return;
    }
    add({.id = "shading-plain-matrix",
         .limb = looks.limb,
         .frame = looks.frame,
         .share = looks.share(),
         .what = fmt::format(
             "{} turns normals by the joints' own matrices: at frame {:g} {} of the {} "
             "vertices that a stretch moves are shaded more than 20 degrees off, at worst {:.0f} degrees",
             engine_.name, looks.frame, looks.wronglyShaded, looks.moved, looks.worstDegrees),
         .remedy = useVolume},
        looks.clip);
  }

  void judgeScale(int clip) {
    if (engine_.scale == JointScale::plays) {
      return;
    }
    const LostChannels lost = lostChannels(document_, clip, [&](const Track& track) {
      return track.channel == Channel::scale && carriesMesh(track.node) && scalesUnequallyOrMoves(track);
    });
    if (lost.channels == 0) {
      return;
    }
    const bool isSure = engine_.scale == JointScale::notSupported;
    ForecastFinding finding = findingOf(isSure ? "scale-not-supported" : "scale-may-be-dropped",
                                        isSure ? gltf::Severity::error : gltf::Severity::warning, lost);
    finding.what = fmt::format("{} {} channels that scale joints ({})", engine_.name,
                               isSure ? "does not play" : "imports, and drops under per-bone retargeting,",
                               joinedLimbs(lost.limbs));
    finding.what.insert(finding.what.find("channels"), fmt::format("{} ", lost.channels));
    finding.remedy = isSure ? useVolume : "set the retargeting of these bones to Animation";
    add(std::move(finding), clip);
  }

  void judgeMapped(int clip) {
    if (!engine_.dropsMappedChannels) {
      return;
    }
    const std::set<NodeIndex> held = mappedAndHeld(document_);
    const std::set<NodeIndex> map = mapped(document_);
    const LostChannels moves = lostChannels(document_, clip, [&](const Track& track) {
      return track.channel == Channel::translation && held.contains(track.node) &&
             movesVisibly(*document_.scene, track);
    });
    const LostChannels scales = lostChannels(document_, clip, [&](const Track& track) {
      return track.channel == Channel::scale && map.contains(track.node) && scalesUnequallyOrMoves(track);
    });
    for (const auto& [id, lost, word] : {std::tuple("translation-of-mapped-bones", moves, "move"),
                                         std::tuple("scale-of-mapped-bones", scales, "scale")}) {
      if (lost.channels > 0) {
        ForecastFinding finding = findingOf(id, gltf::Severity::error, lost);
        finding.what =
            fmt::format("{} leaves out {} channels that {} mapped bones ({}): joints stay where the "
                        "avatar has them",
                        engine_.name, lost.channels, word, joinedLimbs(lost.limbs));
        finding.remedy = "import it with a generic rig";
        add(std::move(finding), clip);
      }
    }
  }

  void judgeCulling(const ClipLooks& looks) {
    constexpr double seen = 0.05; // of the height
    const Vec3 beyond = glm::max(file_.rest.low - looks.box.low, looks.box.high - file_.rest.high);
    const double heights = std::max({beyond.x, beyond.y, beyond.z}) / document_.body.height;
    if (!engine_.cullsByRestBox || looks.box.empty() || heights < seen) {
      return;
    }
    add({.id = "culled-by-the-box-at-rest",
         .what =
             fmt::format("{} may hide the mesh near the edge of the picture: the clip reaches {:.2f} heights "
                         "beyond the box at rest",
                         engine_.name, heights),
         .remedy = engine_.cullingRemedy},
        looks.clip);
  }

  void judgeShear() {
    for (const gltf::Shear& shear : engine_.holdsShear ? std::vector<gltf::Shear>{} : file_.shear) {
      const Node& node = document_.scene->nodes[at(shear.node)];
      add({.id = "shear",
           .limb = limbOfNode(document_, shear.node),
           .what = fmt::format("{} holds no shear: '{}' is sheared by up to {:.1f} degrees", engine_.name,
                               node.name, 90.0 - std::acos(shear.cosine) * 180.0 / pi),
           .remedy = node.isBindLeaf ? "save the stretch with --form volume"
                                     : "scale leaves alone, as this program writes them"},
          shear.clip);
    }
  }

  void judgeInfluences() {
    constexpr double seen = 1e-3;
    if (engine_.mostInfluences == 0 || engine_.mostInfluences > 4 || file_.tail < seen) {
      return;
    }
    add({.id = "influences-left-out",
         .share = static_cast<double>(file_.beyondFour) /
                  static_cast<double>(std::max<std::size_t>(1, file_.vertices)),
         .what =
             fmt::format("{} reads {} influences of a vertex: {} of {} vertices have more, the heaviest that "
                         "is left out weighs {:.2f}",
                         engine_.name, engine_.mostInfluences, file_.beyondFour, file_.vertices, file_.tail),
         .remedy = "save it with --form volume --influences 4"},
        -1);
  }

  [[nodiscard]] bool carriesMesh(NodeIndex node) const {
    return std::ranges::any_of(
        deforming_, [&](NodeIndex below) { return isAncestorOrSelf(*document_.scene, node, below); });
  }

  [[nodiscard]] bool hasOtherInterpolations() const {
    return std::ranges::any_of(*document_.clips, [](const Clip& clip) {
      return std::ranges::any_of(clip.tracks, [](const CopyOnWrite<Track>& track) {
        return track->interpolation != Interpolation::linear;
      });
    });
  }

  const Document& document_;
  const FileFindings& file_;
  const Engine& engine_;
  std::set<NodeIndex> deforming_;
  EngineForecast result_;
};

// What the second sets of influences weigh, as the file has them.
void countInfluences(const Document& document, FileFindings& file) {
  gltf::Problems known; // of a file that was read
  const std::optional<gltf::PlainSource> plain = gltf::withPlainViews(*document.source, known);
  const gltf::Source& source = plain ? plain->source : *document.source;
  for (std::size_t mesh = 0; mesh < gltf::sizeOf(source.json, "meshes"); ++mesh) {
    for (const gltf::Json& primitive : gltf::element(source.json, "meshes", mesh)["primitives"]) {
      const gltf::Json* const first = gltf::findPath(primitive, {"attributes", "WEIGHTS_0"});
      const gltf::Json* const second = gltf::findPath(primitive, {"attributes", "WEIGHTS_1"});
      file.vertices += first == nullptr ? 0 : gltf::shapeOf(source, first->get<int>())->count;
      const std::vector<float> weights =
          second == nullptr ? std::vector<float>{} : gltf::readFloats(source, second->get<int>());
      for (std::size_t v = 0; v + 3 < weights.size(); v += 4) {
        const float tail = weights[v] + weights[v + 1] + weights[v + 2] + weights[v + 3];
        file.beyondFour += tail > 0.0F ? 1 : 0;
        file.tail = std::max(file.tail, static_cast<double>(tail));
      }
    }
  }
}

FileFindings fileFindings(const Document& document) {
  FileFindings file;
  for (int clip = 0; clip < static_cast<int>(document.clips->size()); ++clip) {
    file.looks.push_back(clipLooks(document, clip));
  }
  file.rest = restBox(document);
  file.shear = gltf::residualShear(*document.scene, *document.clips);
  countInfluences(document, file);
  return file;
}

} // namespace

std::vector<EngineForecast> forecast(const Document& document, const std::vector<std::string>& engineIds) {
  const FileFindings file = fileFindings(document);
  std::vector<EngineForecast> forecasts;
  for (const Engine& engine : engines()) {
    if (std::ranges::find(engineIds, engine.id) != engineIds.end()) {
      forecasts.push_back(EngineJudge(document, file, engine).forecast());
    }
  }
  return forecasts;
}

Result<Document> openAsItStands(const std::string& path) {
  Result<gltf::Loaded> loaded = gltf::loadAsItStands(path, gltf::Pictures::headers);
  if (!loaded) {
    return loaded.error();
  }
  Document document;
  document.source = loaded->source;
  document.scene = loaded->scene;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(loaded->clips));
  document.body = bodyOfSource(document);
  return document;
}

Result<std::vector<std::string>> engineIdsOf(const std::string& text) {
  std::vector<std::string> known;
  std::string listed;
  for (const Engine& engine : engines()) {
    known.push_back(engine.id);
    listed += engine.id + ", ";
  }
  if (text == "all") {
    return known;
  }
  std::vector<std::string> ids;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    if (std::ranges::find(known, word) == known.end()) {
      return Error{fmt::format("'{}' is no engine that is known here", word), "--engine",
                   fmt::format("give some of {}or all", listed)};
    }
    ids.push_back(word);
  }
  return ids.empty() ? Result<std::vector<std::string>>(
                           Error{"names no engine", "--engine", "give all, or some of " + listed})
                     : ids;
}

} // namespace stretch::app
