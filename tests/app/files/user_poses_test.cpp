#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include "app/files/user_files.h"
#include "app/files/user_poses.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

namespace fs = std::filesystem;

/// A hand that hangs on its limb, hips that do not, and a fist.
LibraryPose guard() {
  LibraryPose pose{"Guard", {}};
  pose.pose.leftOnItsWay = Vec3(0.8, 0.0, 0.6);
  pose.pose.controllers = {
      {"left-hand", Vec3(0.25, 1.5, -0.5), Quat(0.5, 0.5, -0.5, 0.5), Vec3(0.5, 0.25, -0.125)},
      {"hips", Vec3(0.0, 1.0, 0.0), Quat(1.0, 0.0, 0.0, 0.0), std::nullopt, 1.125}};
  pose.pose.values = {{"left-hand.curl", 0.75}};
  return pose;
}

Json written(const fs::path& folder) {
  REQUIRE(savePose(guard(), folder / "Guard.json"));
  return Json::parse(*readText(folder / "Guard.json"));
}

/// What reading tells of a file with this text in the place of what was written.
std::string refusalOf(const fs::path& folder, const Json& json) {
  std::ofstream(folder / "changed.json") << json.dump();
  return test::refusal(loadPose(folder / "changed.json"));
}

} // namespace

TEST_CASE("A pose of the library is read as it was written: places, turns, bases, values and its name") {
  const test::TemporaryFolder folder;
  const LibraryPose pose = guard();
  REQUIRE(savePose(pose, folder.path() / "Guard.json"));
  const Result<LibraryPose> read = loadPose(folder.path() / "Guard.json");
  REQUIRE(read);
  CHECK(read->name == "Guard");
  CHECK(read->pose.of == nullptr);
  CHECK(read->pose.leftOnItsWay == pose.pose.leftOnItsWay);
  CHECK(read->pose.values == pose.pose.values);
  REQUIRE(read->pose.controllers.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(read->pose.controllers[i].id == pose.pose.controllers[i].id);
    CHECK(read->pose.controllers[i].placeWorld == pose.pose.controllers[i].placeWorld);
    CHECK(read->pose.controllers[i].turnWorld == pose.pose.controllers[i].turnWorld);
    CHECK(read->pose.controllers[i].fromBase == pose.pose.controllers[i].fromBase);
    CHECK(read->pose.controllers[i].restHeight == pose.pose.controllers[i].restHeight);
  }
}

TEST_CASE("Turns and the way to the left of a pose that somebody wrote are brought to unit length") {
  const test::TemporaryFolder folder;
  Json json = written(folder.path());
  json["controllers"][0]["turn"] = {0.0, 0.0, 0.0, 4.0};
  json["left_on_its_way"] = {0.0, 0.0, 3.0};
  std::ofstream(folder.path() / "long.json") << json.dump();
  const Result<LibraryPose> read = loadPose(folder.path() / "long.json");
  REQUIRE(read);
  CHECK(read->pose.controllers[0].turnWorld == Quat(1.0, 0.0, 0.0, 0.0));
  CHECK(read->pose.leftOnItsWay == Vec3(0.0, 0.0, 1.0));
}

TEST_CASE("A file that is no pose is refused with the file, the key and what to do") {
  const test::TemporaryFolder folder;
  const Json good = written(folder.path());
  const std::string file = (folder.path() / "changed.json").string();
  const auto with = [&](const char* key, const Json& value) {
    Json json = good;
    json[key] = value;
    return refusalOf(folder.path(), json);
  };
  const auto without = [&](const char* key) {
    Json json = good;
    json.erase(key);
    return refusalOf(folder.path(), json);
  };
  const auto ofController = [&](const char* key, const Json& value) {
    Json json = good;
    json["controllers"][0][key] = value;
    return refusalOf(folder.path(), json);
  };
  for (const char* const key : {"version", "name", "controllers"}) {
    CHECK_THAT(without(key), Catch::StartsWith(file + ": " + key + ": is missing"));
  }
  CHECK_THAT(with("version", 2), Catch::StartsWith(file + ": version: this program does not know"));
  Json later = good; // which may have keys that this program does not know
  later["version"] = 2;
  later["weight"] = 0.5;
  CHECK_THAT(refusalOf(folder.path(), later),
             Catch::StartsWith(file + ": version: this program does not know"));
  CHECK_THAT(with("name", std::string(101, 'a')), Catch::Contains("is no name of a pose"));
  CHECK_THAT(with("name", "Guard.json"), Catch::Contains("is no name of a pose"));
  CHECK_FALSE(with("name", std::string(100, 'a')).find("is no name") != std::string::npos);
  CHECK_THAT(with("name", ""), Catch::StartsWith(file + ": name: a pose needs a name"));
  CHECK_THAT(with("controllers", Json::array()),
             Catch::StartsWith(file + ": controllers: has no controller"));
  CHECK_THAT(with("controllers", 3), Catch::StartsWith(file + ": controllers: is not a list"));
  CHECK_THAT(with("values", Json::object()), Catch::StartsWith(file + ": values: is not a list"));
  CHECK_THAT(with("left_on_its_way", {0, 0, 0}),
             Catch::StartsWith(file + ": left_on_its_way: is no direction"));
  CHECK_THAT(with("scale", 2), Catch::StartsWith(file + ": scale: is not a part of a pose"));
  CHECK_THAT(ofController("turn", {0, 0, 0, 0}), Catch::StartsWith(file + ": turn: is no turn"));
  CHECK_THAT(ofController("turn", "up"), Catch::StartsWith(file + ": turn: "));
  CHECK_THAT(ofController("place", {1, 2}), Catch::StartsWith(file + ": place: "));
  CHECK_THAT(ofController("from_base", 1), Catch::StartsWith(file + ": from_base: "));
  CHECK_THAT(ofController("rest_height", "low"), Catch::StartsWith(file + ": rest_height: "));
  CHECK_THAT(ofController("weight", 1), Catch::StartsWith(file + ": weight: is not a part of a pose"));
  CHECK_THAT(with("values", Json::array({{{"attribute", "left-hand.curl"}}})),
             Catch::StartsWith(file + ": value: is missing"));
  CHECK_THAT(test::refusal(loadPose(folder.path() / "none.json")), Catch::Contains("none.json"));
}

TEST_CASE("Poses of the folder come by name, and files that are none are told") {
  const test::TemporaryFolder folder;
  for (const char* const name : {"Wave", "Guard", "A/B"}) {
    LibraryPose pose = guard();
    pose.name = name;
    REQUIRE(savePose(pose, fileOfName(folder.path(), name)));
  }
  std::ofstream(folder.path() / "broken.json") << "{";
  std::ofstream(folder.path() / "Guard.png") << "a picture";
  const PoseFolder found = posesIn(folder.path());
  const std::vector<LibraryPose>& poses = found.poses;
  REQUIRE(poses.size() == 3);
  REQUIRE(found.refused.size() == 1);
  CHECK_THAT(found.refused[0], Catch::Contains("broken.json"));
  CHECK(poses[0].name == "A/B");
  CHECK(poses[1].name == "Guard");
  CHECK(poses[2].name == "Wave");
  CHECK(findPose("Wave", folder.path())->name == "Wave");
  CHECK(findPose((folder.path() / "A_B.json").string(), "")->name == "A/B");
  CHECK_THAT(test::refusal(findPose("Bow", folder.path())),
             Catch::Contains("'Bow' is no pose of the library") &&
                 Catch::EndsWith("or one of: A/B, Guard, Wave"));
  CHECK_THAT(test::refusal(findPose("Bow", folder.path() / "nowhere")),
             Catch::EndsWith("give a file of a pose (.json)"));
}

TEST_CASE("A pose is renamed with its picture, never into the place of another one, and removed with it") {
  const test::TemporaryFolder folder;
  const fs::path file = fileOfName(folder.path(), "Guard");
  REQUIRE(savePose(guard(), file));
  std::ofstream(pictureOfPose(file)) << "a picture";
  LibraryPose other = guard();
  other.name = "Wave";
  REQUIRE(savePose(other, fileOfName(folder.path(), "Wave")));
  const LibraryPose kept = *loadPose(file);
  CHECK_THAT(test::refusal(renamePose(kept, "Wave")),
             Catch::Contains("'Wave' would take the place of another pose"));
  CHECK_THAT(test::refusal(renamePose(kept, "")), Catch::Contains("a pose needs a name"));
  CHECK(posesIn(folder.path()).poses.size() == 2);

  CHECK(*renamePose(kept, "Low guard") == folder.path() / "Low guard.json");
  CHECK_FALSE(fs::exists(file));
  CHECK_FALSE(fs::exists(folder.path() / "Guard.png"));
  const LibraryPose low = *findPose("Low guard", folder.path());
  CHECK(low.pose.values == guard().pose.values);
  CHECK(*readText(folder.path() / "Low guard.png") == "a picture");
  CHECK(*renamePose(low, "Low:guard") == folder.path() / "Low_guard.json");
  // Another name that its own file is kept under.
  const LibraryPose again = *findPose("Low:guard", folder.path());
  CHECK(*renamePose(again, "Low*guard") == folder.path() / "Low_guard.json");
  CHECK(findPose("Low*guard", folder.path()));
  CHECK(fs::exists(folder.path() / "Low_guard.png"));

  REQUIRE(removePose(*findPose("Low*guard", folder.path())));
  CHECK_FALSE(fs::exists(folder.path() / "Low_guard.json"));
  CHECK_FALSE(fs::exists(folder.path() / "Low_guard.png"));
  CHECK(posesIn(folder.path()).poses.size() == 1);
}

TEST_CASE("A pose is renamed and removed by the file that it was read from, whatever that is called") {
  const test::TemporaryFolder folder;
  REQUIRE(savePose(guard(), folder.path() / "from-a-friend.json"));
  LibraryPose own = guard();
  own.pose.values.clear();
  REQUIRE(savePose(own, fileOfName(folder.path(), "Guard")));
  const LibraryPose friends = *loadPose(folder.path() / "from-a-friend.json");
  SECTION("removed") {
    REQUIRE(removePose(friends));
    REQUIRE(posesIn(folder.path()).poses.size() == 1);
    CHECK(posesIn(folder.path()).poses[0].pose.values.empty());
  }
  SECTION("renamed") {
    CHECK(*renamePose(friends, "Bow") == folder.path() / "Bow.json");
    CHECK_FALSE(fs::exists(folder.path() / "from-a-friend.json"));
    CHECK(posesIn(folder.path()).poses.size() == 2);
  }
}

TEST_CASE("A free name is one that no pose and no file of the folder has") {
  const test::TemporaryFolder folder;
  CHECK(freePoseName(folder.path()) == "Pose 1");
  std::ofstream(folder.path() / "Pose 1.json") << "{";
  CHECK(freePoseName(folder.path()) == "Pose 2");
  LibraryPose pose = guard();
  pose.name = "Pose 2";
  REQUIRE(savePose(pose, folder.path() / "of-another-name.json"));
  CHECK(freePoseName(folder.path()) == "Pose 3");
}

TEST_CASE("A pose that cannot be removed says so") {
  LibraryPose pose = guard();
  pose.file = "/proc/version";
  CHECK_THAT(test::refusal(removePose(pose)), Catch::Contains("the pose cannot be removed"));
}
