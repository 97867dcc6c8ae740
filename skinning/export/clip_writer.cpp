#include "skinning/export/clip_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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

/// Numbers in -1..1 as normalised 16-bit integers.
std::vector<std::int16_t> normalised(const Course& values) {
  std::vector<std::int16_t> integers;
  integers.reserve(values.size());
  for (const float value : values) {
    integers.push_back(static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 32767.0F)));
  }
  return integers;
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

ClipWriter::ClipWriter(gltf::NewFile& file, const std::string& name, const ClipEncoding& encoding)
    : file_(file), encoding_(encoding), clip_(file.addClip(name)) {
  if (!encoding.keys.empty()) { // The keys that are left would tell another rate.
    file_.setRate(clip_, encoding.framesPerSecond);
  }
}

void ClipWriter::setProperty(std::size_t node, Channel channel, const Course& course, double tolerance) {
  const std::size_t width = channel == Channel::rotation ? 4 : 3;
  const auto setTo = [&](std::size_t frame) {
    const auto first = course.begin() + static_cast<std::ptrdiff_t>(frame * width);
    file_.setNode(node, channel, {first, first + static_cast<std::ptrdiff_t>(width)});
  };
  setTo(0);
  if (isConstant(course, width, tolerance)) {
    return;
  }
  const StoredCourse& stored = storedFor(course, width, tolerance);
  if (stored.keys.size() == 1) {
    setTo(stored.keys.front());
    return;
  }
  file_.addChannel(clip_, stored.sampler, node, channel);
}

void ClipWriter::holdPlace(std::size_t node, const Course& places) {
  const std::vector<std::size_t> keys{0, places.size() / 3 - 1};
  const std::size_t input = timesOf(keys);
  file_.addChannel(clip_, file_.addSampler(clip_, input, valuesOf(places, 3, {0, 0})), node,
                   Channel::translation);
  ++samplers_;
  keys_ += keys.size();
  file_.setRate(clip_, encoding_.framesPerSecond); // Two keys would tell another one.
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
  if (made.keys.size() > 1) {
    const std::size_t input = timesOf(made.keys);
    made.sampler = file_.addSampler(clip_, input, valuesOf(course, width, made.keys));
    ++samplers_;
    keys_ += made.keys.size();
  }
  stored_.push_back(std::move(made));
  return stored_.back();
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
  const std::size_t accessor = file_.addAccessor(seconds, {.bounds = true});
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
  const std::size_t accessor =
      width == 4 && encoding_.quantise
          ? file_.addAccessor(normalised(values), {.width = width, .normalised = true})
          : file_.addAccessor(values, {.width = width});
  accessors_.push_back(accessor);
  return accessor;
}

} // namespace stretch::skinning
