#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/gltf/write/new_file.h"
#include "skinning/export/key_plan.h"

namespace stretch::skinning {

/// Values of a property over the frames: 3 numbers per frame, or 4 (x, y, z, w) for rotations.
using Course = std::vector<float>;

/// How the courses of a clip become keys.
struct ClipEncoding {
  double framesPerSecond = 30.0;
  bool quantise = false; ///< Rotations as normalised 16-bit integers.
  KeyPlan keys = {};     ///< By sampler; empty: every frame is a key.
};

/// Writes the one clip of a file: channels, samplers that are shared wherever courses are alike, times
/// that are shared wherever keys are the same.
class ClipWriter {
public:
  ClipWriter(gltf::NewFile& file, const std::string& name, const ClipEncoding& encoding);

  /// The property of a node: the value itself where it does not change, a channel where it does. Courses that
  /// differ by less than `tolerance` are alike.
  void setProperty(std::size_t node, Channel channel, const Course& course, double tolerance);

  /// Two keys of a place, at the first and the last frame: a clip that moves nothing lasts by them.
  void holdPlace(std::size_t node, const Course& places);

  [[nodiscard]] const std::vector<std::size_t>& accessors() const { return accessors_; }
  [[nodiscard]] std::size_t samplers() const { return samplers_; }
  [[nodiscard]] std::size_t keys() const { return keys_; }

private:
  struct StoredCourse {
    Course course;
    std::size_t width = 3;
    std::vector<std::size_t> keys;
    std::size_t sampler = 0; ///< Sampler of the file; for a course with one key there is none.
  };

  const StoredCourse& storedFor(const Course& course, std::size_t width, double tolerance);
  std::size_t timesOf(const std::vector<std::size_t>& keys);
  std::size_t valuesOf(const Course& course, std::size_t width, const std::vector<std::size_t>& keys);

  gltf::NewFile& file_;
  ClipEncoding encoding_;
  std::size_t clip_;
  std::map<std::vector<std::size_t>, std::size_t> times_; ///< Accessors by the frames that they name.
  std::vector<StoredCourse> stored_;                      ///< In the order of the plan's samplers.
  std::vector<std::size_t> accessors_;
  std::size_t samplers_ = 0;
  std::size_t keys_ = 0;
};

/// Whether two courses differ by no more than `tolerance` in any number.
[[nodiscard]] bool areAlike(const Course& a, const Course& b, double tolerance);

} // namespace stretch::skinning
