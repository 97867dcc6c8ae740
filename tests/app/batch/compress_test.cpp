#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/batch/sequence_report.h"
#include "app/batch/verb.h"
#include "core/gltf/json/json.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "core/gltf/source/source.h"
#include "skinning/metrics.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/app/captured_stream.h"
#include "tests/support/app/run_verb.h"
#include "tests/support/core/two_sheets.h"
#include "tests/support/rig/character_file.h"
#include "tests/support/rig/moving_biped.h"

namespace fs = std::filesystem;
using namespace stretch;

namespace {

constexpr int rings = 24;
constexpr int sides = 8;

/// A folder of OBJ frames of a tube that bends, with an end in the middle of a ring's fan at both sides.
class BendingTube {
public:
  explicit BendingTube(int frames)
      : path_(fs::temp_directory_path() / ("stretch-tube-" + std::to_string(getpid()))) {
    fs::create_directories(path_ / "frames");
    for (int frame = 1; frame <= frames; ++frame) {
      write(frame, 0.02 * frame);
    }
  }
  BendingTube(const BendingTube&) = delete;
  BendingTube& operator=(const BendingTube&) = delete;
  ~BendingTube() { fs::remove_all(path_); }

  [[nodiscard]] std::string frames() const { return (path_ / "frames").string(); }
  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

private:
  void write(int frame, double curvature) const {
    std::ofstream out(path_ / "frames" / ("tube-" + std::to_string(frame) + ".obj"));
    const auto place = [&](double along, double across, double up) {
      const double angle = curvature * along;
      out << "v " << along * std::cos(angle) - across * std::sin(angle) << ' ' << up << ' '
          << along * std::sin(angle) + across * std::cos(angle) << '\n';
    };
    for (int ring = 0; ring < rings; ++ring) {
      for (int side = 0; side < sides; ++side) {
        const double angle = 2.0 * 3.14159265358979 * side / sides;
        place(0.5 * ring, std::cos(angle), std::sin(angle));
      }
    }
    place(-0.3, 0.0, 0.0);
    place(0.5 * (rings - 1) + 0.3, 0.0, 0.0);
    const int first = rings * sides + 1;
    for (int side = 0; side < sides; ++side) {
      const int next = (side + 1) % sides;
      for (int ring = 0; ring + 1 < rings; ++ring) {
        const int a = ring * sides + side + 1;
        const int b = ring * sides + next + 1;
        out << "f " << a << ' ' << b << ' ' << b + sides << '\n'
            << "f " << a << ' ' << b + sides << ' ' << a + sides << '\n';
      }
      out << "f " << first << ' ' << next + 1 << ' ' << side + 1 << '\n';
      const int last = (rings - 1) * sides + 1;
      out << "f " << first + 1 << ' ' << last + side << ' ' << last + next << '\n';
    }
  }

  fs::path path_;
};

} // namespace

TEST_CASE("a sequence becomes a skinned clip that compares with itself without error") {
  const BendingTube tube(6);
  const std::string output = tube.file("tube.glb");
  REQUIRE(test::exitCodeOf({"compress", tube.frames(), "-o", output, "--bones", "6", "--stretch", "measured",
                            "--json"}) == 0);
  const Result<gltf::Loaded> written = gltf::load(output);
  REQUIRE(written);
  CHECK(written->scene->skins.size() == 1);
  CHECK(written->clips.size() == 1);
  CHECK(test::exitCodeOf({"compare", output, output, "--json"}) == 0);
}

TEST_CASE("a stretched file is compared as it is shown, not as the source that it carries") {
  const BendingTube folder(1);
  const std::string dummy = STRETCH_SOURCE_DIR "/assets/dummy.glb";
  const std::string output = folder.file("punch.glb");
  REQUIRE(test::exitCodeOf({"exaggerate", dummy, "-o", output, "--limb", "left-arm", "--scale", "2"}) == 0);
  const Result<MeshSequence> before = skinning::readAnimatedGltf(dummy);
  REQUIRE(before);
  const Result<MeshSequence> after = skinning::readAnimatedGltf(output, {}, {}, before->framesPerSecond);
  REQUIRE(after);
  const Result<skinning::SequenceMetrics> metrics = skinning::compareSequences(*before, *after);
  REQUIRE(metrics);
  CHECK(metrics->largestPercent > 10.0);
}

TEST_CASE("a sequence that cannot be used gives status 1 and writes nothing") {
  const BendingTube tube(3);
  const std::string output = tube.file("tube.glb");
  std::ofstream(fs::path(tube.frames()) / "tube-2.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  CHECK(test::exitCodeOf({"compress", tube.frames(), "-o", output}) == 1);
  CHECK_FALSE(fs::exists(output));
}

TEST_CASE("the report names the frames of the fits, the line, the monotone curve and what explains gravity") {
  const BendingTube tube(8);
  const Result<MeshSequence> sequence = skinning::readSequence({tube.frames()});
  REQUIRE(sequence);
  skinning::CompressSettings settings;
  settings.bones = 6;
  settings.body.firstFittedFrame = 2;
  const auto compressed = skinning::compress(*sequence, settings);
  REQUIRE(compressed);
  const gltf::Json report =
      app::compressionJson(*sequence, *compressed, skinning::encodeGltf(compressed->skinned));
  CHECK(report["fitted_frames"] == gltf::Json({{"first", 2}, {"last", 7}, {"count", 6}}));
  const gltf::Json& length = report["length_by_curvature"];
  CHECK(length["frames"] == 6);
  CHECK(length["line"]["slope"].is_number());
  CHECK(length["line"]["r_squared"].is_number());
  CHECK(length["monotone"]["curvatures"].size() == length["monotone"]["lengths"].size());
  CHECK(report["gravity_compression"].size() == 6);
  CHECK(report["young_fitted"] == true);
  CHECK(report["metrics_of_fitted_frames"]["mse"].is_number());
}

TEST_CASE("the report tells of the file that was written, read back") {
  const BendingTube tube(6);
  const std::string output = tube.file("tube.glb");
  const auto reported = [&](std::vector<std::string> options) {
    std::vector<std::string> words{"compress", tube.frames(), "-o",       output,  "--bones",
                                   "6",        "--stretch",   "measured", "--json"};
    words.insert(words.end(), options.begin(), options.end());
    const test::VerbAnswer answer = test::runVerb(words);
    REQUIRE(answer.exitCode == 0);
    return gltf::Json::parse(answer.output);
  };
  const gltf::Json plain = reported({});
  CHECK(plain["file"]["bytes"] == fs::file_size(output));
  CHECK(plain["file"]["rmse_percent"].get<double>() ==
        Approx(plain["rmse_percent"].get<double>()).margin(1e-4));
  const gltf::Json small =
      reported({"--quantise", "--quantise-mesh", "--meshopt", "--key-tolerance", "0.5%"});
  CHECK(small["file"]["bytes"].get<std::size_t>() < plain["file"]["bytes"].get<std::size_t>());
  CHECK(small["keys"].get<int>() <= plain["keys"].get<int>());
  CHECK(small["file"]["largest_percent"].get<double>() <
        plain["file"]["largest_percent"].get<double>() + 0.51);
}

TEST_CASE("the report tells which weights were taken, and how good either was") {
  const BendingTube tube(6);
  const test::VerbAnswer answer = test::runVerb({"compress", tube.frames(), "-o", tube.file("tube.glb"),
                                                 "--bones", "6", "--stretch", "none", "--json"});
  REQUIRE(answer.exitCode == 0);
  const gltf::Json report = gltf::Json::parse(answer.output);
  const gltf::Json& weights = report["weights"];
  const double geodesic = weights["geodesic_rmse_percent"].get<double>();
  const double fitted = weights["fitted_rmse_percent"].get<double>();
  CHECK(weights["used"] == (geodesic < fitted ? "geodesic" : "fitted"));
  CHECK(report["rmse_percent"].get<double>() == Approx(std::min(geodesic, fitted)));
}

TEST_CASE("as few bones as a tolerance asks for, told in percent or without the sign") {
  const BendingTube tube(6);
  for (const char* const tolerance : {"0.3%", "0.3"}) {
    const test::VerbAnswer answer =
        test::runVerb({"compress", tube.frames(), "-o", tube.file("tube.glb"), "--stretch", "measured",
                       "--tolerance", tolerance, "--json"});
    REQUIRE(answer.exitCode == 0);
    const gltf::Json report = gltf::Json::parse(answer.output);
    CHECK(report["rmse_percent"].get<double>() <= 0.3);
    CHECK(report["joints"].get<int>() < 30);
  }
}

TEST_CASE("a clip's bones can be given to another one, what cannot be given is told in one line") {
  const BendingTube tube(6);
  const std::string output = tube.file("tube.glb");
  const std::string again = tube.file("again.glb");
  REQUIRE(test::exitCodeOf(
              {"compress", tube.frames(), "-o", output, "--bones", "5", "--stretch", "measured"}) == 0);
  REQUIRE(test::exitCodeOf(
              {"compress", tube.frames(), "-o", again, "--stretch", "measured", "--skeleton", output}) == 0);
  const Result<gltf::Loaded> written = gltf::load(again);
  REQUIRE(written);
  CHECK(written->scene->skins[0].joints.size() == 5);
  const auto told = [&](const std::string& skeleton) {
    const test::CapturedStream errors(stderr);
    CHECK(test::exitCodeOf({"compress", tube.frames(), "-o", tube.file("none.glb"), "--stretch", "measured",
                            "--skeleton", skeleton}) == 1);
    return errors.text();
  };
  CHECK_THAT(told(STRETCH_SOURCE_DIR "/assets/dummy.glb"), Catch::Contains("--skeleton"));
  CHECK_THAT(told(tube.frames() + "/tube-1.obj"), Catch::Contains("tube-1.obj"));
  CHECK_FALSE(fs::exists(tube.file("none.glb")));
}

TEST_CASE("compare takes two things, of which each may be a mesh and its cache") {
  const BendingTube tube(2);
  const std::string frames = tube.frames();
  CHECK(test::exitCodeOf({"compare", frames, frames}) == 0);
  CHECK(test::exitCodeOf({"compare", frames, frames, frames}) == 1);
  CHECK(test::exitCodeOf({"compare", frames + "/tube-1.obj", frames + "/none.pc2", frames}) == 1);
  CHECK(test::exitCodeOf({"compare", frames, frames, "--flattening", "--gravity", "0,0,0"}) == 1);
  CHECK(test::exitCodeOf({"compare", frames, frames, "--flattening"}) == 0);
}

TEST_CASE("options that name nothing are wrong arguments") {
  CHECK(test::exitCodeOf({"compress", "frames", "-o", "x.glb", "--stretch", "rubber"}) == 2);
  CHECK(test::exitCodeOf({"compress", "frames"}) == 2);
  CHECK(test::exitCodeOf({"compare", "one.glb"}) == 2);
}

TEST_CASE(
    "Skipping all frames, moduli beyond the bones and a folder that is not there are told in one line") {
  const BendingTube tube(4);
  const std::string output = tube.file("out.glb");
  const std::string moduli = tube.file("moduli.json");
  std::ofstream(moduli) << R"({"segments": [{"from": 3, "to": 6, "young": 5000}]})";
  const auto told = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"-o", output});
    const test::CapturedStream errors(stderr);
    CHECK(test::exitCodeOf(words) == 1);
    return errors.text();
  };
  CHECK_THAT(told({"compress", tube.frames(), "--skip", "100"}),
             Catch::Contains("--skip: 100 frames are skipped, and the sequence has 4; give at most 3"));
  CHECK_THAT(told({"compress", tube.frames(), "--bones", "6", "--moduli", moduli}),
             Catch::Contains("names bone 6, and the last one is 5"));
  CHECK_THAT(told({"compress", tube.file("none")}), Catch::Contains("there is no such file or folder"));
  CHECK_FALSE(fs::exists(output));
}

TEST_CASE("curvature and length of every frame are in the report and in a table") {
  const BendingTube tube(6);
  const std::string table = tube.file("curvature.csv");
  const test::VerbAnswer answer = test::runVerb({"compress", tube.frames(), "-o", tube.file("tube.glb"),
                                                 "--bones", "8", "--curvature", table, "--json"});
  REQUIRE(answer.exitCode == 0);
  const gltf::Json frames = gltf::Json::parse(answer.output)["curvature_and_length"];
  REQUIRE(frames["curvatures"].size() == 6);
  CHECK(frames["curvatures"][5].get<double>() > 2.0 * frames["curvatures"][0].get<double>());
  std::ifstream file(table);
  std::string line;
  std::getline(file, line);
  CHECK(line == "frame,name,curvature_radians,length,modelled_length");
  std::getline(file, line);
  CHECK_THAT(line, Catch::StartsWith("0,\"tube-1.obj\","));
  CHECK_THAT(line, Catch::Contains(fmt::format("{}", frames["lengths"][0].get<double>())));
}

TEST_CASE("STED is measured with the parameters that are asked for, and names them") {
  const BendingTube tube(6);
  const std::string output = tube.file("tube.glb");
  REQUIRE(test::exitCodeOf({"compress", tube.frames(), "-o", output, "--bones", "4", "--stretch", "none"}) ==
          0);
  const auto measured = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"compare", tube.frames(), output, "--json"};
    words.insert(words.end(), options.begin(), options.end());
    return gltf::Json::parse(test::runVerb(words).output);
  };
  const gltf::Json usual = measured({});
  const gltf::Json spatial = measured({"--sted-c", "0"});
  CHECK(spatial["sted"].get<double>() == Approx(usual["sted_spatial"].get<double>()));
  CHECK(spatial["sted"].get<double>() < usual["sted"].get<double>());
  const gltf::Json wide = measured({"--sted-rings", "2", "--sted-window", "5", "--sted-dt", "0.5"});
  CHECK(wide["sted_parameters"]["rings"] == 2);
  CHECK(wide["sted_parameters"]["window"] == 5);
  CHECK(wide["sted_spatial"].get<double>() != usual["sted_spatial"].get<double>());
  CHECK(test::exitCodeOf({"compare", tube.frames(), output, "--sted-window", "4"}) == 2);
}

TEST_CASE("compare looks at both files on the frames of the first, whatever keys the second has") {
  const BendingTube folder(1);
  const auto written = [&](const char* name, int keys) {
    test::GlbBuilder glb = test::twoSheets();
    std::vector<float> times;
    std::vector<float> places;
    for (int key = 0; key <= keys; ++key) {
      const float share = static_cast<float>(key) / static_cast<float>(keys);
      times.push_back(share);
      places.insert(places.end(), {0.0F, share, 0.0F});
    }
    const int input = glb.floats(times, "SCALAR", 1);
    glb.json["accessors"][static_cast<std::size_t>(input)]["min"] = {0.0F};
    glb.json["accessors"][static_cast<std::size_t>(input)]["max"] = {1.0F};
    const int output = glb.floats(places, "VEC3", 3);
    glb.json["animations"] = {
        {{"samplers", {{{"input", input}, {"output", output}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
    glb.write(folder.file(name));
    return folder.file(name);
  };
  const std::string at24 = written("at24.glb", 24);
  const std::string at30 = written("at30.glb", 30);
  const Result<MeshSequence> few = skinning::readAnimatedGltf(at24);
  const Result<MeshSequence> many = skinning::readAnimatedGltf(at30);
  REQUIRE(few);
  REQUIRE(many);
  REQUIRE(few->frameCount() < many->frameCount());
  for (const auto& [first, second] : {std::pair{at24, at30}, std::pair{at30, at24}}) {
    const test::VerbAnswer answer = test::runVerb({"compare", first, second, "--json"});
    INFO(answer.told);
    REQUIRE(answer.exitCode == 0);
    CHECK(gltf::Json::parse(answer.output)["rmse_percent"].get<double>() < 1e-4);
  }
}

TEST_CASE("compress --fps sets how long the clip lasts, not how many frames it has") {
  const BendingTube tube(7);
  const auto clipAt = [&](const std::vector<std::string>& rate) {
    std::vector<std::string> words{"compress", tube.frames(), "-o", tube.file("tube.glb"), "--bones", "3"};
    words.insert(words.end(), rate.begin(), rate.end());
    REQUIRE(test::exitCodeOf(words) == 0);
    const Result<gltf::Loaded> written = gltf::load(tube.file("tube.glb"));
    REQUIRE(written);
    return written->clips.front();
  };
  CHECK(clipAt({}).endSeconds == Approx(6.0 / 30.0));
  const Clip slow = clipAt({"--fps", "12"});
  CHECK(slow.endSeconds == Approx(6.0 / 12.0));
  CHECK(slow.tracks.front()->times.size() == clipAt({}).tracks.front()->times.size());
}

TEST_CASE("compress --fps samples a glTF at the rate, and its clip lasts as long as it did") {
  const test::TemporaryFolder folder;
  const std::string output = (folder / "sheets.glb").string();
  test::twoSheets().write(folder / "two.glb");
  const auto answer = test::runVerb({"compress", (folder / "two.glb").string(), "-o", output, "--bones", "2",
                                     "--stretch", "measured", "--fps", "12", "--json"});
  REQUIRE(answer.exitCode == 0);
  CHECK(gltf::Json::parse(answer.output)["frames"] == 13);
  CHECK(gltf::load(output)->clips.front().endSeconds == Approx(1.0));
}

TEST_CASE("a body that stands still becomes a clip of its frames, and one frame alone has no ratio to it") {
  const BendingTube tube(1);
  const auto compress = [&](const std::string& output) {
    return test::runVerb({"compress", tube.frames(), "-o", output, "--bones", "3"});
  };
  const test::VerbAnswer one = compress(tube.file("one.glb"));
  REQUIRE(one.exitCode == 0);
  CHECK(one.output.find("1 :") == std::string::npos);
  fs::copy(fs::path(tube.frames()) / "tube-1.obj", fs::path(tube.frames()) / "tube-2.obj");
  REQUIRE(compress(tube.file("still.glb")).exitCode == 0);
  CHECK(test::runVerb({"compare", tube.frames(), tube.file("still.glb")}).exitCode == 0);
}

TEST_CASE("compress takes the clip that is asked for, tells when it took the first of several, and knows no "
          "other") {
  test::MovingBiped moving = test::punchingBiped();
  Clip late = moving.clip;
  moving.clip.name = "punch";
  late.name = "half a punch";
  for (CopyOnWrite<Track>& track : late.tracks) {
    track.edit([](Track& keys) {
      for (float& seconds : keys.times) {
        seconds *= 0.5F;
      }
    });
  }
  const test::TemporaryFolder folder;
  const std::string file = (folder / "two.glb").string();
  test::characterFile(moving.scene, {moving.clip, late}).write(file);
  const std::string output = (folder / "small.glb").string();
  const auto compress = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"compress", file, "-o", output, "--bones", "4", "--fps", "24", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return test::runVerb(words);
  };
  const auto written = [&] { return gltf::loadAsItStands(output)->clips.front(); };
  const test::VerbAnswer first = compress({});
  REQUIRE(first.exitCode == 0);
  CHECK(first.output.find("the first of 2 clips was taken, 'punch'") != std::string::npos);
  const Clip whole = written();
  CHECK(whole.name == "punch");
  for (const std::string clip : {"half a punch", "#1"}) {
    const test::VerbAnswer second = compress({"--clip", clip});
    REQUIRE(second.exitCode == 0);
    CHECK(second.output.find("clips was taken") == std::string::npos);
    CHECK(written().name == "half a punch");
    CHECK(written().endSeconds == Approx(0.5 * whole.endSeconds).margin(0.05));
  }
  const test::VerbAnswer none = compress({"--clip", "kick"});
  CHECK(none.exitCode == 1);
  CHECK(none.told.find("there is no clip 'kick'; clips of this file: 'punch', 'half a punch'") !=
        std::string::npos);
  const BendingTube tube(4);
  const test::VerbAnswer plain =
      test::runVerb({"compress", tube.frames(), "-o", tube.file("out.glb"), "--clip", "punch"});
  CHECK(plain.exitCode == 1);
  CHECK(plain.told.find("only a glTF has clips") != std::string::npos);
}
