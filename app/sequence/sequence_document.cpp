#include "app/sequence/sequence_document.h"

#include <algorithm>

#include <glm/common.hpp>

#include "core/gltf/edits.h"
#include "skinning/body/body_skeleton.h"
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
    analysis.measured.push_back({skinning::totalCurvature(joints), skinning::polylineLength(joints)});
  }
}

} // namespace

bool sameDocument(const SequenceDocument& a, const SequenceDocument& b) {
  return a.paths == b.paths && a.mesh == b.mesh && a.analysis == b.analysis && a.settings == b.settings &&
         a.quantise == b.quantise && a.result == b.result;
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

std::vector<Vec3> jointsAt(const SequenceDocument& document, std::size_t frame) {
  if (document.result == nullptr) {
    return frame < document.analysis->joints.size() ? document.analysis->joints[frame] : std::vector<Vec3>{};
  }
  const skinning::SkinnedSequence& skinned = document.result->compressed.skinned;
  std::vector<Vec3> joints;
  for (std::size_t bone = 0; bone < skinned.bones.size(); ++bone) {
    joints.push_back(skinned.pose(frame, bone).position);
  }
  const skinning::SkinBone& last = skinned.bones.back();
  const Mat4 matrix = skinning::skinMatrix(last, skinned.pose(frame, skinned.bones.size() - 1));
  joints.emplace_back(matrix * Vec4(last.end, 1.0));
  return joints;
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
  for (const bool quantise : {false, true}) {
    skinning::EncodeSettings encoding;
    encoding.quantise = quantise;
    result.encoded[quantise ? 1 : 0] = skinning::encodeGltf(result.compressed.skinned, encoding);
  }
  return result;
}

const skinning::EncodedClip& exported(const SequenceDocument& document) {
  return document.result->encoded[document.quantise ? 1 : 0];
}

Status exportResult(const SequenceDocument& document, const std::filesystem::path& path) {
  if (document.result == nullptr) {
    return Error{"nothing was compressed yet", path.string(), "compress the sequence first"};
  }
  return gltf::save(exported(document).source, path);
}

} // namespace stretch::app
