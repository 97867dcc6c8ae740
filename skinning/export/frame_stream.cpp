#include "skinning/export/frame_stream.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/check.h"
#include "core/gltf/json/json.h"
#include "skinning/export/encode_gltf.h"

namespace stretch::skinning {
namespace {

using gltf::Json;

/// What changes from frame to frame in the same way: the values of one sampler, and the nodes that take them.
struct StreamCourse {
  std::string path; ///< "rotation", "translation" or "scale".
  Json nodes;
  int componentType = 0;
  std::size_t valueBytes = 0;            ///< Of one frame.
  std::vector<std::uint8_t> values = {}; ///< Of all frames.
};

std::span<const std::uint8_t> bytesOfView(const gltf::Source& source, const Json& view) {
  const std::span<const std::uint8_t> buffer(source.buffers.front());
  return buffer.subspan(view.value("byteOffset", std::size_t{0}), view["byteLength"].get<std::size_t>());
}

StreamCourse courseOf(const gltf::Source& source, const Json& sampler, std::size_t frames) {
  const Json& json = source.json;
  const Json& accessor = json["accessors"][sampler["output"].get<std::size_t>()];
  StreamCourse course;
  course.nodes = Json::array();
  course.componentType = accessor["componentType"].get<int>();
  const auto values = bytesOfView(source, json["bufferViews"][accessor["bufferView"].get<std::size_t>()]);
  course.values.assign(values.begin(), values.end());
  check(accessor["count"].get<std::size_t>() == frames, "a value for each frame");
  course.valueBytes = course.values.size() / frames;
  return course;
}

/// In the order of the samplers.
std::vector<StreamCourse> coursesOf(const gltf::Source& source, std::size_t frames) {
  std::vector<StreamCourse> courses;
  const Json& json = source.json;
  if (!json.contains("animations")) {
    return courses; // nothing moves
  }
  const Json& clip = json["animations"][0];
  for (const Json& sampler : clip["samplers"]) {
    courses.push_back(courseOf(source, sampler, frames));
  }
  for (const Json& channel : clip["channels"]) {
    StreamCourse& course = courses[channel["sampler"].get<std::size_t>()];
    course.path = channel["target"]["path"].get<std::string>();
    course.nodes.push_back(channel["target"]["node"]);
  }
  return courses;
}

/// Copies a document with one buffer, the accessors of its clips left out.
class StillCopy {
public:
  explicit StillCopy(const gltf::Source& source) : source_(source), json_(*source.json) {}

  gltf::Source make() {
    json_.erase("animations");
    json_.erase("bufferViews");
    json_.erase("accessors");
    for (Json& mesh : json_["meshes"]) {
      for (Json& primitive : mesh["primitives"]) {
        for (Json& attribute : primitive["attributes"]) {
          takeAccessor(attribute);
        }
        takeAccessor(primitive["indices"]);
      }
    }
    for (Json& skin : json_["skins"]) {
      takeAccessor(skin["inverseBindMatrices"]);
    }
    if (json_.contains("images")) {
      for (Json& image : json_["images"]) {
        takeView(image["bufferView"]);
      }
    }
    json_["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    gltf::Source copy;
    copy.json = std::move(json_);
    copy.buffers.push_back(std::move(bytes_));
    copy.hasBinaryChunk = true;
    return copy;
  }

private:
  void takeAccessor(Json& reference) {
    const auto index = reference.get<std::size_t>();
    if (const auto known = accessors_.find(index); known != accessors_.end()) {
      reference = known->second;
      return;
    }
    Json accessor = (*source_.json)["accessors"][index];
    takeView(accessor["bufferView"]);
    json_["accessors"].push_back(std::move(accessor));
    reference = accessors_[index] = json_["accessors"].size() - 1;
  }

  void takeView(Json& reference) {
    const auto index = reference.get<std::size_t>();
    if (const auto known = views_.find(index); known != views_.end()) {
      reference = known->second;
      return;
    }
    Json view = (*source_.json)["bufferViews"][index];
    const std::span<const std::uint8_t> content = bytesOfView(source_, view);
    view["byteOffset"] = bytes_.size();
    bytes_.insert(bytes_.end(), content.begin(), content.end());
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    json_["bufferViews"].push_back(std::move(view));
    reference = views_[index] = json_["bufferViews"].size() - 1;
  }

  const gltf::Source& source_;
  Json json_;
  std::vector<std::uint8_t> bytes_;
  std::map<std::size_t, std::size_t> accessors_;
  std::map<std::size_t, std::size_t> views_;
};

Json describe(const std::vector<StreamCourse>& courses, std::size_t frameBytes, double framesPerSecond) {
  Json told{{"version", streamVersion},
            {"framesPerSecond", framesPerSecond},
            {"frameBytes", frameBytes},
            {"courses", Json::array()}};
  for (const StreamCourse& course : courses) {
    told["courses"].push_back(
        {{"path", course.path}, {"componentType", course.componentType}, {"nodes", course.nodes}});
  }
  return told;
}

void putFrame(const std::vector<StreamCourse>& courses, std::size_t frame, std::vector<std::uint8_t>& bytes) {
  putStreamHeader(frame, bytes);
  for (const StreamCourse& course : courses) {
    const auto value = std::span(course.values).subspan(frame * course.valueBytes, course.valueBytes);
    bytes.insert(bytes.end(), value.begin(), value.end());
  }
}

/// A course of its own for each node that takes it.
std::vector<StreamCourse> apart(const std::vector<StreamCourse>& courses) {
  std::vector<StreamCourse> single;
  for (const StreamCourse& course : courses) {
    for (const Json& node : course.nodes) {
      single.push_back(course);
      single.back().nodes = Json::array({node});
    }
  }
  return single;
}

bool hasCourse(const std::vector<StreamCourse>& courses, const Json& node, const std::string& path) {
  return std::ranges::any_of(courses, [&](const StreamCourse& course) {
    return course.path == path && std::ranges::find(course.nodes, node) != course.nodes.end();
  });
}

/// What a node has in every frame, as a course.
StreamCourse heldCourse(const Json& node, std::size_t index, const std::string& path, std::size_t frames,
                        bool isShort) {
  constexpr int floats = 5126;
  constexpr int shorts = 5122;
  StreamCourse course;
  course.path = path;
  course.nodes = Json::array({index});
  course.componentType = isShort ? shorts : floats;
  std::vector<std::uint8_t> value;
  const auto append = [&value](const auto& number) {
    const auto* const raw = reinterpret_cast<const std::uint8_t*>(&number);
    value.insert(value.end(), raw, raw + sizeof(number));
  };
  for (const Json& told : node[path]) {
    const auto number = told.get<float>();
    if (isShort) {
      append(static_cast<std::int16_t>(std::lround(number * 32767.0F)));
    } else {
      append(number);
    }
  }
  course.valueBytes = value.size();
  for (std::size_t k = 0; k < frames; ++k) {
    course.values.insert(course.values.end(), value.begin(), value.end());
  }
  return course;
}

/// Every property of every bone that the document tells, whether it changes or not.
std::vector<StreamCourse> allCourses(const gltf::Source& source, const std::vector<StreamCourse>& changing,
                                     std::size_t frames, bool quantise) {
  std::vector<StreamCourse> courses = apart(changing);
  const Json& nodes = (*source.json)["nodes"];
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const bool holdsConstant = nodes[n].value("name", "").starts_with("bind_"); // A factor of its own.
    for (const char* const path : {"translation", "rotation", "scale"}) {
      if (nodes[n].contains(path) && !holdsConstant && !hasCourse(courses, Json(n), path)) {
        const bool isRotation = std::string_view(path) == "rotation";
        courses.push_back(heldCourse(nodes[n], n, path, frames, isRotation && quantise));
      }
    }
  }
  return courses;
}

} // namespace

void putStreamHeader(std::size_t number, std::vector<std::uint8_t>& bytes) {
  bytes.insert(bytes.end(), {std::uint8_t{'S'}, std::uint8_t{'F'}, streamVersion, std::uint8_t{0}});
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>((number >> static_cast<unsigned>(shift)) & 0xFFU));
  }
}

FrameStream streamOf(const SkinnedSequence& sequence, bool quantise, StreamCourses which) {
  EncodeSettings settings;
  settings.quantise = quantise;
  const gltf::Source clip = encodeGltf(sequence, settings).source;
  std::vector<StreamCourse> courses = coursesOf(clip, sequence.frameCount());
  if (which == StreamCourses::all) {
    courses = allCourses(clip, courses, sequence.frameCount(), quantise);
  }
  FrameStream stream;
  stream.frameBytes = streamHeaderBytes;
  for (const StreamCourse& course : courses) {
    stream.frameBytes += course.valueBytes;
  }
  for (std::size_t frame = 0; frame < sequence.frameCount(); ++frame) {
    putFrame(courses, frame, stream.frames);
  }
  stream.base = StillCopy(clip).make();
  (*stream.base.json)["extras"]["stretch_stream"] =
      describe(courses, stream.frameBytes, sequence.framesPerSecond);
  return stream;
}

} // namespace stretch::skinning
