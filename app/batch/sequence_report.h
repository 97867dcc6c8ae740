#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/compress/compress.h"
#include "skinning/export/encode_gltf.h"

namespace stretch::app {

/// "mse", "rmse_percent", "sted" and what belongs to them, as `compress` and `compare` report them.
[[nodiscard]] gltf::Json metricsJson(const skinning::SequenceMetrics& metrics);

/// Prints the metrics as lines of text, from the JSON.
void printMetrics(const gltf::Json& report);

/// Report of `compress`: metrics, sizes, the fits with the frames they used, the parameters of the model.
[[nodiscard]] gltf::Json compressionJson(const MeshSequence& sequence,
                                         const skinning::CompressedSequence& compressed,
                                         const skinning::EncodedClip& encoded);

/// Reads a clip that was written and adds "file" to the report: bytes and how far the file is off.
[[nodiscard]] Status addWrittenFile(const MeshSequence& sequence, const std::string& path,
                                    const skinning::EncodedClip& encoded, gltf::Json& report);

/// Prints the report as lines of text, from the JSON; warnings go to standard error.
void printCompression(const gltf::Json& report);

/// Curvature and length of the centre line as CSV, a line for each frame: measured, and the length that the
/// model gives for the curvature.
[[nodiscard]] std::string curvatureTable(const MeshSequence& sequence, const skinning::BodyStretch& model);

/// A mesh sequence by the words of a command line: one path, or a base mesh and its cache. `clip`: of a glTF,
/// by name or #index; empty: the first. `framesPerSecond`: see readSequence.
[[nodiscard]] Result<MeshSequence> readSequenceWords(const std::vector<std::string>& words,
                                                     const std::string& clip = {},
                                                     double framesPerSecond = 0.0);

} // namespace stretch::app
