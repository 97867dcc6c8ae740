#include "skinning/export/clip_writer.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace stretch::skinning {
namespace {

bool isConstant(const Course& course, std::size_t width, double tolerance) {
  for (std::size_t i = width; i < course.size(); ++i) {
    if (std::abs(static_cast<double>(course[i] - course[i % width])) > tolerance) {
      return false;
    }
  }
  return true;
}

} // namespace

bool areAlike(const Course& a, const Course& b, double tolerance) {
  if (a.size() != b.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(static_cast<double>(a[i] - b[i])) > tolerance) {
      return false;
    }
  }
  return true;
}

ClipWriter::ClipWriter(gltf::Json& json, GltfBuffers& buffers, const std::string& name,
                       const ClipEncoding& encoding)
    : json_(json), buffers_(buffers), encoding_(encoding) {
  json_["animations"] = gltf::Json::array(
      {{{"name", name}, {"channels", gltf::Json::array()}, {"samplers", gltf::Json::array()}}});
  if (!encoding.keys.empty()) { // The keys that are left would tell another rate.
    json_["animations"][0]["extras"]["stretch_engine"] = {{"frames_per_second", encoding.framesPerSecond}};
  }
}

void ClipWriter::setProperty(std::size_t node, const char* path, const Course& course, std::size_t width,
                             double tolerance) {
  const auto valueAt = [&](std::size_t frame) {
    const auto first = course.begin() + static_cast<std::ptrdiff_t>(frame * width);
    return std::vector<float>(first, first + static_cast<std::ptrdiff_t>(width));
  };
  json_["nodes"][node][path] = valueAt(0);
  if (isConstant(course, width, tolerance)) {
    return;
  }
  const StoredCourse& stored = storedFor(course, width, tolerance);
  if (stored.keys.size() == 1) {
    json_["nodes"][node][path] = valueAt(stored.keys.front());
    return;
  }
  json_["animations"][0]["channels"].push_back(
      {{"sampler", stored.sampler}, {"target", {{"node", node}, {"path", path}}}});
}

const ClipWriter::StoredCourse& ClipWriter::storedFor(const Course& course, std::size_t width,
                                                      double tolerance) {
  for (const StoredCourse& stored : stored_) {
    if (stored.width == width && areAlike(stored.course, course, tolerance)) {
      return stored;
    }
  }
  StoredCourse made{course, width, std::vector<std::size_t>(course.size() / width), 0};
  std::iota(made.keys.begin(), made.keys.end(), std::size_t{0});
  if (!encoding_.keys.empty()) {
    made.keys = encoding_.keys.at(stored_.size());
  }
  gltf::Json& samplers = json_["animations"][0]["samplers"];
  made.sampler = samplers.size();
  if (made.keys.size() > 1) {
    const std::size_t input = timesOf(made.keys);
    const std::size_t output = valuesOf(course, width, made.keys);
    samplers.push_back({{"input", input}, {"output", output}, {"interpolation", "LINEAR"}});
    keys_ += made.keys.size();
  }
  stored_.push_back(std::move(made));
  return stored_.back();
}

std::size_t ClipWriter::samplers() const {
  return json_.contains("animations") ? json_["animations"][0]["samplers"].size() : 0;
}

std::size_t ClipWriter::timesOf(const std::vector<std::size_t>& keys) {
  if (const auto found = times_.find(keys); found != times_.end()) {
    return found->second;
  }
  std::vector<float> seconds;
  seconds.reserve(keys.size());
  for (const std::size_t key : keys) {
    seconds.push_back(static_cast<float>(static_cast<double>(key) / encoding_.framesPerSecond));
  }
  const std::size_t accessor = buffers_.addFloats(seconds, "SCALAR", 1, GltfBuffers::Target::none, true);
  times_[keys] = accessor;
  accessors_.push_back(accessor);
  return accessor;
}

std::size_t ClipWriter::valuesOf(const Course& course, std::size_t width,
                                 const std::vector<std::size_t>& keys) {
  Course values;
  for (const std::size_t key : keys) {
    const auto first = course.begin() + static_cast<std::ptrdiff_t>(key * width);
    values.insert(values.end(), first, first + static_cast<std::ptrdiff_t>(width));
  }
  const bool rotation = width == 4;
  const std::size_t accessor =
      rotation && encoding_.quantise
          ? buffers_.addNormalised(values, "VEC4", 4)
          : buffers_.addFloats(values, rotation ? "VEC4" : "VEC3", width, GltfBuffers::Target::none, false);
  accessors_.push_back(accessor);
  return accessor;
}

void ClipWriter::finish() {
  if (json_["animations"][0]["channels"].empty()) {
    json_.erase("animations");
  }
}

} // namespace stretch::skinning
