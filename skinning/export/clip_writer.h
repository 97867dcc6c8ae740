#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/gltf/json.h"
#include "skinning/export/gltf_buffers.h"
#include "skinning/export/key_reduction.h"

namespace stretch::skinning {

/// How the courses of a clip become keys.
struct ClipEncoding {
  double framesPerSecond = 30.0;
  bool quantise = false; ///< Rotations as normalised 16-bit integers.
  double keyBound = 0.0; ///< How far keys that are left out may move the mesh, each by itself: a length. 0:
                         ///< every frame is a key.
};

/// Writes the one clip of a document: channels, samplers that are shared wherever courses are alike, times
/// that are shared wherever keys are the same.
class ClipWriter {
public:
  ClipWriter(gltf::Json& json, GltfBuffers& buffers, const std::string& name, const ClipEncoding& encoding);

  /// The property of a node: the value itself where it does not change, a channel where it does. Courses that
  /// differ by less than `tolerance` are alike. `reach`: how far a vertex is moved by a change of 1 (of a
  /// radian).
  void setProperty(std::size_t node, const char* path, const Course& course, std::size_t width,
                   double tolerance, double reach);

  /// Takes a clip without channels out of the document: glTF wants at least one.
  void finish();

  [[nodiscard]] const std::vector<std::size_t>& accessors() const { return accessors_; }
  [[nodiscard]] std::size_t samplers() const { return stored_.size(); }
  [[nodiscard]] std::size_t keys() const { return keys_; }

private:
  struct StoredCourse {
    Course course;
    std::size_t width = 3;
    double bound = 0.0;
  };

  std::size_t samplerFor(const Course& course, std::size_t width, double tolerance, double bound);
  std::size_t timesOf(const std::vector<std::size_t>& keys);
  std::size_t valuesOf(const Course& course, std::size_t width, const std::vector<std::size_t>& keys);

  gltf::Json& json_;
  GltfBuffers& buffers_;
  ClipEncoding encoding_;
  std::map<std::vector<std::size_t>, std::size_t> times_; ///< Accessors by the frames that they name.
  std::vector<StoredCourse> stored_;                      ///< By sampler.
  std::vector<std::size_t> accessors_;
  std::size_t keys_ = 0;
};

/// Whether two courses differ by no more than `tolerance` in any number.
[[nodiscard]] bool areAlike(const Course& a, const Course& b, double tolerance);

} // namespace stretch::skinning
