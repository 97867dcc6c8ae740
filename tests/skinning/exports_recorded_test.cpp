// Every number that clips and streams of made-up bodies are written with.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "core/gltf/import/mesh_surface.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "skinning/compress/compress.h"
#include "skinning/export/append_frames.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/export/frame_stream.h"
#include "skinning/export/read_back.h"
#include "tests/support/core/contents_text.h"
#include "tests/support/recorded.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;
using gltf::Json;

namespace {

constexpr double recordTolerance = 1e-3;

struct Body {
  std::string title;
  SkinnedSequence skinned;
};

SkinnedSequence compressed(const MeshSequence& sequence, StretchOption stretch, JointOption joints,
                           WeightOption weights) {
  CompressSettings settings;
  settings.bones = 4;
  settings.stretch = stretch;
  settings.joints = joints;
  settings.weights = weights;
  auto made = compress(sequence, settings);
  REQUIRE(made);
  return std::move(made).value().skinned;
}

/// Every vertex of the body twice, so that corners can differ, with looks of each kind, in parts.
std::shared_ptr<const gltf::MeshSurface> surfaceOf(const SkinnedSequence& body, bool sharesVertices) {
  auto surface = std::make_shared<gltf::MeshSurface>();
  const auto count = static_cast<std::uint32_t>(body.bindPositions.size());
  for (std::uint32_t v = 0; v < 2 * count; ++v) {
    const auto share = static_cast<float>(v) / static_cast<float>(2 * count);
    surface->places.push_back(v % count);
    surface->normals.push_back(glm::normalize(glm::vec3(share, 1.0F - share, 0.3F)));
    surface->colors.emplace_back(share, 0.25F, 1.0F - share, 1.0F);
    surface->texCoords.resize(2);
    surface->texCoords[0].emplace_back(share, 1.0F - share);
    surface->texCoords[1].emplace_back(3.0F * share - 1.0F, share);
  }
  const std::size_t half = body.triangles.size() / 2;
  for (std::size_t t = 0; t < body.triangles.size(); ++t) {
    Triangle corners = body.triangles[t];
    for (std::uint32_t& corner : corners) {
      corner += t < half ? 0 : count;
    }
    surface->triangles.push_back(corners);
  }
  surface->parts = {
      {"shirt", 0, 0, half}, {"none", 0, half, 0}, {"", -1, half, body.triangles.size() - half}};
  if (sharesVertices) { // parts that are side by side have vertices in common
    surface->parts = {{"shirt", 0, 0, half / 2},
                      {"shirt", 1, half / 2, half - half / 2},
                      {"hat", -1, half, body.triangles.size() - half}};
  }
  gltf::Source materials;
  materials.json =
      Json::parse(R"({"asset": {"version": "2.0"}, "materials": [{"name": "red"}, {"name": "blue"}]})");
  surface->materials = std::make_shared<const gltf::Source>(std::move(materials));
  return surface;
}

SkinnedSequence scaled(SkinnedSequence body, bool common, bool turned) {
  for (std::size_t k = 0; k < body.frameCount(); ++k) {
    for (std::size_t b = 0; b < body.bones.size(); ++b) {
      const double wave = 0.1 * std::sin(static_cast<double>(common ? k : k * (b + 1)));
      const double own = 1.0 + 0.05 * static_cast<double>(b);
      body.pose(k, b).scale = Vec3(own * (1.0 + wave), own * (1.0 - 0.5 * wave), own / (1.0 + wave));
      body.pose(k, b).stretchAxes =
          turned ? glm::angleAxis(0.2 * static_cast<double>(k + b), Vec3(0.0, 0.6, 0.8)) : body.bones[b].axes;
    }
  }
  return body;
}

std::vector<Body> bodies() {
  const MeshSequence tube = test::shorteningTube(6, 0.15, 0.4, 0.1);
  const MeshSequence arms = skinAllFrames(test::armedBody(6));
  std::vector<Body> made{{"waving tube", test::wavingTube(3, 5)}, {"armed body", test::armedBody(5)}};
  for (const StretchOption stretch : {StretchOption::none, StretchOption::elastic, StretchOption::measured}) {
    made.push_back({fmt::format("tube, stretch {}", static_cast<int>(stretch)),
                    compressed(tube, stretch, JointOption::tree, WeightOption::automatic)});
  }
  for (const JointOption joints : {JointOption::tree, JointOption::free}) {
    made.push_back({fmt::format("arms, joints {}", static_cast<int>(joints)),
                    compressed(arms, StretchOption::measured, joints, WeightOption::fitted)});
  }
  for (const bool common : {false, true}) {
    for (const bool turned : {false, true}) {
      made.push_back({fmt::format("scaled, common {} , turned {}", common, turned),
                      scaled(test::armedBody(5), common, turned)});
    }
  }
  for (const bool shares : {false, true}) {
    made.push_back({fmt::format("dressed, shares {}", shares), test::armedBody(4)});
    made.back().skinned.surface = surfaceOf(made.back().skinned, shares);
    made.back().skinned.clipName = "wave";
    made.back().skinned.framesPerSecond = 24.0;
  }
  return made;
}

/// How a file stores its numbers, beside what they are.
std::string storedText(const Json& json) {
  std::string text = "  stores";
  for (const Json& accessor : json.value("accessors", Json::array())) {
    text += fmt::format(" {}x{}{}", accessor.value("componentType", 0), accessor.value("count", 0),
                        accessor.value("normalized", false) ? "n" : "");
  }
  text += "\n  extensions";
  for (const Json& extension : json.value("extensionsRequired", Json::array())) {
    text += " " + extension.get<std::string>();
  }
  return text + "\n";
}

std::string clipText(const Body& body, const std::string& way, const EncodeSettings& settings) {
  const test::TemporaryFolder folder;
  const EncodedClip clip = encodeGltf(body.skinned, settings);
  REQUIRE(gltf::save(clip.source, folder / "clip.glb"));
  std::size_t places = 0;
  for (std::size_t v = 0; v < clip.places.size(); ++v) {
    places += clip.places[v] * (1 + v % 11);
  }
  const auto error = errorOfFile(folder / "clip.glb", clip, skinAllFrames(body.skinned));
  return test::contentsText(body.title + " , " + way, gltf::load(folder / "clip.glb")) +
         storedText(clip.source.json) +
         fmt::format(
             "  places {} : {} , joints {} , samplers {} , keys {} off by {:.3f} , bytes {:.3f} and {} , "
             "off by {:.3f}\n",
             clip.places.size(), places, clip.joints, clip.samplers, clip.keys, clip.keyErrorPercent,
             clip.bytesPerFrame, clip.bytesOnce, error ? error->largestPercent : -1.0);
}

/// The numbers of each frame, added up by their places: bytes would tell how a compiler rounds.
std::string framesText(const Json& format, std::span<const std::uint8_t> bytes, std::size_t frameBytes) {
  std::string text;
  for (std::size_t first = 0; first < bytes.size(); first += frameBytes) {
    std::size_t at = first + streamHeaderBytes;
    text += fmt::format("    frame {} of {} bytes , number {} :", first / frameBytes, frameBytes,
                        bytes[first + 4]);
    for (const Json& course : format["courses"]) {
      std::vector<double> values;
      for (int i = 0; i < (course["path"] == "rotation" ? 4 : 3); ++i) {
        std::int16_t whole = 0;
        float number = 0.0F;
        const bool isShort = course["componentType"] == 5122;
        std::memcpy(isShort ? static_cast<void*>(&whole) : &number, bytes.data() + at, isShort ? 2 : 4);
        values.push_back(isShort ? whole / 32767.0 : static_cast<double>(number));
        at += isShort ? 2 : 4;
      }
      // Of the two quaternions of a turn the one whose largest number is positive: which it is hangs on
      // rounding.
      const double largest =
          *std::ranges::max_element(values, {}, [](double value) { return std::abs(value); });
      double sum = 0.0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double sign = values.size() == 4 && largest < 0.0 ? -1.0 : 1.0;
        sum += sign * static_cast<double>(i + 1) * values[i];
      }
      text += fmt::format(" {:.3f}", sum);
    }
    text += at == first + frameBytes ? "\n" : " and more\n";
  }
  return text;
}

} // namespace

TEST_CASE("Clips of bodies are written, in each way to write them, as they were looked at") {
  EncodeSettings fewer;
  fewer.quantise = true;
  fewer.keyTolerancePercent = 0.3;
  EncodeSettings integers;
  integers.quantise = true;
  integers.quantiseMesh = true;
  EncodeSettings coarse;
  coarse.tolerance = 0.02;
  std::string text;
  for (const Body& body : bodies()) {
    text += clipText(body, "exact", {});
    text += clipText(body, "fewer keys", fewer);
    text += clipText(body, "integers", integers);
    text += clipText(body, "coarse", coarse);
  }
  test::compareWithRecord("exported-clips", text, recordTolerance);
}

TEST_CASE("Streams of bodies, and frames that are appended to them, are as they were looked at") {
  std::string text;
  for (const Body& body : bodies()) {
    for (const bool quantise : {false, true}) {
      for (const StreamCourses courses : {StreamCourses::changing, StreamCourses::all}) {
        const test::TemporaryFolder folder;
        const FrameStream stream = streamOf(body.skinned, quantise, courses);
        REQUIRE(gltf::save(stream.base, folder / "base.glb"));
        text += test::contentsText(
            fmt::format("{} , quantised {} , courses {}", body.title, quantise, static_cast<int>(courses)),
            gltf::load(folder / "base.glb"));
        const Json format = stream.base.json->at("extras").at("stretch_stream");
        text += "  " + format.dump() + "\n" + framesText(format, stream.frames, stream.frameBytes);
        MeshSequence later = skinAllFrames(body.skinned);
        later.surface = body.skinned.surface;
        const Result<AppendedFrames> appended =
            framesForStream(folder / "base.glb", later, 3 * stream.frameBytes, 100.0);
        if (!appended) {
          text += "  refused: " + appended.error().what + "\n";
          continue;
        }
        text += fmt::format("  appended from {} , off by {:.2f} and {:.2f}\n", appended->firstNumber,
                            appended->metrics.rmsePercent, appended->metrics.largestPercent) +
                framesText(format, appended->bytes, appended->frameBytes);
      }
    }
  }
  test::compareWithRecord("exported-streams", text, recordTolerance);
}

TEST_CASE("What a client shows of a file has the rate that it was asked at") {
  for (const double rate : {24.0, 30.0, 59.94}) {
    CHECK(framesShown(Scene{}, {}, 2, rate).framesPerSecond == rate);
  }
}
