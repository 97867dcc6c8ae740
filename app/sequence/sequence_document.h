#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/compress/compress.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/sequence/read_sequence.h"

namespace stretch::app {

/// Measures of a body, taken before anything is compressed.
struct SequenceAnalysis {
  std::vector<double> vertexDiameters;     ///< Shape diameter around each vertex, mesh units; empty where the
                                           ///< surface encloses nothing.
  std::vector<std::vector<Vec3>> joints;   ///< The centre line of each frame; empty for a body without one.
  std::vector<std::size_t> vertexSegments; ///< Segment of the centre line that each vertex belongs to; empty
                                           ///< for a body without one.
  std::vector<skinning::CurvatureLength> measured; ///< Lengths of the centre line, one for each frame.
  std::string problem;                             ///< Why something is missing, one line; empty otherwise.
  Vec3 low{0.0};                                   ///< The box around all frames.
  Vec3 high{0.0};
};

/// A sequence as a skinned clip, as the editor keeps it.
struct Compression {
  skinning::CompressSettings settings; ///< That it was made with.
  skinning::CompressedSequence compressed;
};

/// A result as it would be written.
struct ExportedClip {
  skinning::EncodeSettings settings; ///< That it was made with.
  std::shared_ptr<const Compression> result;
  skinning::EncodedClip clip;
};

/// A result that was written, and what a reader makes of the file.
struct WrittenClip {
  std::filesystem::path path;
  std::shared_ptr<const ExportedClip> clip;
  skinning::SequenceMetrics metrics; ///< Metrics of the file that was read back, against the sequence.
};

/// A mesh sequence that is open: a value whose large parts are shared and never change.
struct SequenceDocument {
  std::vector<std::filesystem::path> paths; ///< Paths as opened: a folder or file, or a base mesh and its
                                            ///< cache.
  std::shared_ptr<const MeshSequence> mesh;
  std::shared_ptr<const SequenceAnalysis> analysis;
  skinning::CompressSettings settings; ///< For the next compression.
  std::filesystem::path skeletonFile;  ///< That the skeleton of the settings is from; empty without one.
  skinning::EncodeSettings encoding{.quantise = true}; ///< Settings of the export.
  std::shared_ptr<const Compression> result;           ///< Null: nothing was compressed yet.
};

/// Equal by value (shared parts by identity).
[[nodiscard]] bool sameDocument(const SequenceDocument& a, const SequenceDocument& b);

/// Bytes that a document takes and does not share with another one, about.
[[nodiscard]] std::size_t bytesBeyond(const SequenceDocument& document, const SequenceDocument& other);

/// The path that names the sequence: the folder, the file, or the cache.
[[nodiscard]] const std::filesystem::path& pathOf(const SequenceDocument& document);

[[nodiscard]] Result<SequenceDocument> openSequence(const std::vector<std::filesystem::path>& named,
                                                    const skinning::Progress& progress = {});

/// Centre line of the paper's 30 segments and shape diameters. What a body does not have stays empty.
[[nodiscard]] SequenceAnalysis analyseSequence(const MeshSequence& mesh);

/// Curvature and length of every frame, as the result measured them or else the analysis; empty for a body
/// without a centre line.
[[nodiscard]] const std::vector<skinning::CurvatureLength>& measuredFrames(const SequenceDocument& document);

/// The line and the monotone curve over the frames that the settings use.
[[nodiscard]] skinning::LengthFunction fittedLength(const SequenceDocument& document);

/// A bone as it is drawn.
struct ShownBone {
  Vec3 start{0.0};
  Vec3 end{0.0};
  bool isLast = false; ///< No other bone hangs on it.
};

/// The bones in a frame: the result's, or else the pieces of the centre line; empty where there is neither.
[[nodiscard]] std::vector<ShownBone> bonesAt(const SequenceDocument& document, std::size_t frame);

/// Whether the settings differ from those that the result was made with.
[[nodiscard]] bool isOutdated(const SequenceDocument& document);

[[nodiscard]] Result<Compression> makeCompression(const MeshSequence& mesh,
                                                  const skinning::CompressSettings& settings,
                                                  const skinning::Proceed& proceed = {});

/// The document with the bones of a file's skin in place of own ones. A tolerance, which asks for a number of
/// bones, goes. Errors name the file: it cannot be read, has no skin, or stands elsewhere than the mesh.
[[nodiscard]] Result<SequenceDocument> withSkeleton(const SequenceDocument& document,
                                                    const std::filesystem::path& path);
/// The document with bones of its own again.
[[nodiscard]] SequenceDocument withoutSkeleton(const SequenceDocument& document);

/// Whether the clip is the document's result, written as the document asks for.
[[nodiscard]] bool isClipOf(const ExportedClip& clip, const SequenceDocument& document);

/// A result as it would be written. Errors: there is none, stopped by `proceed`.
[[nodiscard]] Result<ExportedClip> makeClip(const std::shared_ptr<const Compression>& result,
                                            const skinning::EncodeSettings& settings,
                                            const skinning::Proceed& proceed = {});

/// Writes the result as .glb or .gltf and reads it back; `known` is its clip where that was made before, or
/// null. Errors: there is no result, stopped before anything was written, or the file cannot be written or
/// read back.
[[nodiscard]] Result<WrittenClip> writeClip(const SequenceDocument& document,
                                            const std::shared_ptr<const ExportedClip>& known,
                                            const std::filesystem::path& path,
                                            const skinning::Proceed& proceed = {});

} // namespace stretch::app
