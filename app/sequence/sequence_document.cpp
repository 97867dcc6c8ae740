#include "app/sequence/sequence_document.h"

#include <algorithm>

#include <glm/common.hpp>

#include "core/gltf/patch/edits.h"
#include "core/math/polyline.h"
#include "skinning/body/body_skeleton.h"
#include "skinning/body/given_skeleton.h"
#include "skinning/export/read_back.h"
#include "skinning/geometry/shape_diameter.h"

namespace stretch::app {

namespace {

constexpr int segmentsOfAnalysis = 30;

void measureBox(const MeshSequence& mesh, SequenceAnalysis& analysis) {
  glm::vec3 low = mesh.positions.front();
  glm::vec3 high = low;
  for (const glm::vec3& position : mesh.positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  analysis.low = Vec3(low);
  analysis.high = Vec3(high);
}

void measureCentreLine(const MeshSequence& mesh, SequenceAnalysis& analysis) {
  const auto skeleton =
      skinning::skeletonOfBody(mesh.frame(0), mesh.triangles, analysis.vertexDiameters, segmentsOfAnalysis);
  if (!skeleton) {
    analysis.problem = skeleton.error().what;
    return;
  }
  for (const double along : skeleton->along) {
    analysis.vertexSegments.push_back(skinning::segmentAt(*skeleton, along));
  }
  const skinning::JointTracker tracker(*skeleton, mesh.frame(0));
  for (std::size_t frame = 0; frame < mesh.frameCount(); ++frame) {
    analysis.joints.push_back(tracker.joints(mesh.frame(frame)));
    const std::vector<Vec3>& joints = analysis.joints.back();
    analysis.measured.push_back({skinning::totalCurvature(joints), polylineLength(joints)});
  }
}

} // namespace

std::size_t bytesBeyond(const SequenceDocument& document, const SequenceDocument& other) {
  std::size_t bytes = sizeof document;
  if (document.result != nullptr && document.result != other.result) {
    const skinning::SkinnedSequence& skinned = document.result->compressed.skinned;
    bytes += skinned.bindPositions.size() * (sizeof(glm::vec3) + sizeof(skinning::Influences)) +
             skinned.triangles.size() * sizeof(Triangle) + skinned.poses.size() * sizeof(skinning::BonePose);
  }
  return bytes;
}

bool sameDocument(const SequenceDocument& a, const SequenceDocument& b) {
  return a.paths == b.paths && a.mesh == b.mesh && a.analysis == b.analysis && a.settings == b.settings &&
         a.skeletonFile == b.skeletonFile && a.encoding == b.encoding && a.result == b.result;
}

const std::filesystem::path& pathOf(const SequenceDocument& document) {
  return document.paths.back();
}

SequenceAnalysis analyseSequence(const MeshSequence& mesh) {
  SequenceAnalysis analysis;
  measureBox(mesh, analysis);
  auto diameters = skinning::shapeDiameters(mesh.frame(0), mesh.triangles);
  if (!diameters) {
    analysis.problem = diameters.error().what;
    return analysis;
  }
  analysis.vertexDiameters = std::move(diameters->vertices);
  measureCentreLine(mesh, analysis);
  return analysis;
}

Result<SequenceDocument> openSequence(const std::vector<std::filesystem::path>& named,
                                      const skinning::Progress& progress) {
  SequenceDocument document;
  document.paths = skinning::sequencePaths(named);
  Result<MeshSequence> mesh = skinning::readSequence(document.paths, progress);
  if (!mesh) {
    return mesh.error();
  }
  document.analysis = std::make_shared<const SequenceAnalysis>(analyseSequence(*mesh));
  const auto most = std::max<std::size_t>(1, mesh->vertexCount / 4);
  document.settings.bones = static_cast<int>(std::min<std::size_t>(segmentsOfAnalysis, most));
  if (document.analysis->joints.empty()) {
    document.settings.stretch = skinning::StretchOption::measured;
  }
  document.mesh = std::make_shared<const MeshSequence>(std::move(mesh).value());
  return document;
}

const std::vector<skinning::CurvatureLength>& measuredFrames(const SequenceDocument& document) {
  const bool hasModel = document.result != nullptr && document.result->compressed.model;
  return hasModel ? document.result->compressed.model->measured : document.analysis->measured;
}

skinning::LengthFunction fittedLength(const SequenceDocument& document) {
  const std::vector<skinning::CurvatureLength>& frames = measuredFrames(document);
  const std::size_t first =
      std::min(document.settings.body.firstFittedFrame, frames.empty() ? 0 : frames.size() - 1);
  return skinning::fitLength({frames.begin() + static_cast<std::ptrdiff_t>(first), frames.end()},
                             document.settings.body.lengthModel);
}

std::vector<ShownBone> bonesAt(const SequenceDocument& document, std::size_t frame) {
  std::vector<ShownBone> shown;
  if (document.result == nullptr) {
    const auto& lines = document.analysis->joints;
    for (std::size_t i = 0; frame < lines.size() && i + 1 < lines[frame].size(); ++i) {
      shown.push_back({lines[frame][i], lines[frame][i + 1], i + 2 == lines[frame].size()});
    }
    return shown;
  }
  const skinning::SkinnedSequence& skinned = document.result->compressed.skinned;
  for (std::size_t b = 0; b < skinned.bones.size(); ++b) {
    const Mat4 matrix = skinning::skinMatrix(skinned.bones[b], skinned.pose(frame, b));
    const bool isLast = skinned.chained
                            ? b + 1 == skinned.bones.size()
                            : std::ranges::none_of(skinned.bones, [&](const skinning::SkinBone& other) {
                                return other.parent == static_cast<int>(b);
                              });
    shown.push_back(
        {skinned.pose(frame, b).position, Vec3(matrix * Vec4(skinned.bones[b].end, 1.0)), isLast});
  }
  return shown;
}

bool isOutdated(const SequenceDocument& document) {
  return document.result != nullptr && !(document.result->settings == document.settings);
}

Result<Compression> makeCompression(const MeshSequence& mesh, const skinning::CompressSettings& settings,
                                    const skinning::Proceed& proceed) {
  Result<skinning::CompressedSequence> compressed = skinning::compress(mesh, settings, proceed);
  if (!compressed) {
    return compressed.error();
  }
  Compression result;
  result.settings = settings;
  result.compressed = std::move(compressed).value();
  return result;
}

Result<SequenceDocument> withSkeleton(const SequenceDocument& document, const std::filesystem::path& path) {
  auto skeleton = skinning::readSkeleton(path);
  if (!skeleton) {
    Error error = skeleton.error();
    error.where.replace(0, path.string().size(), path.filename().string());
    return error;
  }
  if (const Status fits = skinning::checkSkeleton(*skeleton, *document.mesh); !fits) {
    return Error{fits.error().what, path.filename().string(), fits.error().remedy};
  }
  SequenceDocument changed = document;
  changed.settings.skeleton = std::move(skeleton).value();
  changed.settings.tolerancePercent.reset();
  changed.skeletonFile = path;
  return changed;
}

SequenceDocument withoutSkeleton(const SequenceDocument& document) {
  SequenceDocument changed = document;
  changed.settings.skeleton.clear();
  changed.skeletonFile.clear();
  return changed;
}

bool isClipOf(const ExportedClip& clip, const SequenceDocument& document) {
  return clip.result == document.result && clip.settings == document.encoding;
}

Result<ExportedClip> makeClip(const std::shared_ptr<const Compression>& result,
                              const skinning::EncodeSettings& settings, const skinning::Proceed& proceed) {
  if (result == nullptr) {
    return Error{"nothing was compressed yet", "", "compress the sequence first"};
  }
  auto clip = skinning::encodeGltf(result->compressed.skinned, settings, proceed);
  if (!clip) {
    return Error{"the encoding was stopped", result->compressed.skinned.name, "start it again"};
  }
  return ExportedClip{settings, result, std::move(*clip)};
}

Result<WrittenClip> writeClip(const SequenceDocument& document,
                              const std::shared_ptr<const ExportedClip>& known,
                              const std::filesystem::path& path, const skinning::Proceed& proceed) {
  constexpr double encoded = 0.8;
  constexpr double saved = 0.9;
  WrittenClip written{path, known, {}};
  if (known == nullptr || !isClipOf(*known, document)) {
    auto made = makeClip(document.result, document.encoding,
                         [&](double share) { return !proceed || proceed(encoded * share); });
    if (!made) {
      return made.error();
    }
    written.clip = std::make_shared<const ExportedClip>(std::move(made).value());
  }
  if (proceed && !proceed(encoded)) {
    return Error{"the export was stopped", path.string(), "start it again"};
  }
  if (const Status done = gltf::save(written.clip->clip.source, path); !done) {
    return done.error();
  }
  if (proceed) {
    (void)proceed(saved);
  }
  const auto metrics = skinning::errorOfFile(path, written.clip->clip, *document.mesh);
  if (!metrics) {
    return metrics.error();
  }
  written.metrics = *metrics;
  return written;
}

} // namespace stretch::app
