// Spheres and stop planes of a trail as files hold them, and what is none.
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/schema/trail_schema.h"
#include "core/gltf/json/json.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

/// Where an object of a trail's settings is refused, and with what; empty where it is taken.
std::pair<std::string, std::string> refusedTrail(const Json& json) {
  rig::TrailSettings settings;
  const Status read = trailFromJson(json, 1.0, {}, settings);
  return read ? std::pair<std::string, std::string>() : std::pair(read.error().where, read.error().what);
}

} // namespace

TEST_CASE("Spheres are read in order of time, with offsets and tangents in the unit that is asked for") {
  rig::TrailSettings settings;
  REQUIRE(trailFromJson(Json::parse(R"({"spheres": [
    {"frame": 9, "offset": [0, 0, 4]},
    {"frame": 2.5, "offset": [1, 2, 3], "tangent": [0, -8, 0]}]})"),
                        0.5, {}, settings));
  const std::vector<rig::SphereOffset> wanted{{2.5, Vec3(0.5, 1.0, 1.5), Vec3(0.0, -4.0, 0.0)},
                                              {9.0, Vec3(0.0, 0.0, 2.0), {}}};
  CHECK(settings.spheres == wanted);
  const Json json = trailToJson(settings, 0.25);
  CHECK(json["spheres"] == Json::parse(R"([
    {"frame": 2.5, "offset": [2.0, 4.0, 6.0], "tangent": [0.0, -16.0, 0.0]},
    {"frame": 9.0, "offset": [0.0, 0.0, 8.0]}])"));
}

TEST_CASE("A stop plane stands where it is in the world, and null takes it away") {
  rig::TrailSettings settings;
  const Json json = Json::parse(R"({"stop_at": {"point": [1, 2, 3], "normal": [0, -1, 0]}})");
  REQUIRE(trailFromJson(json, 0.5, {}, settings));
  REQUIRE(settings.stopAt);
  CHECK(settings.stopAt->point == Vec3(1.0, 2.0, 3.0));
  CHECK(settings.stopAt->normal == Vec3(0.0, -1.0, 0.0));
  CHECK(trailToJson(settings, 0.5)["stop_at"]["point"] == Json({1.0, 2.0, 3.0}));
  REQUIRE(trailFromJson(Json{{"scale", 2.0}}, 0.5, {}, settings));
  CHECK(settings.stopAt); // what is left out stays
  REQUIRE(trailFromJson(Json{{"stop_at", nullptr}}, 0.5, {}, settings));
  CHECK_FALSE(settings.stopAt);
  CHECK_FALSE(trailToJson(settings, 0.5).contains("stop_at"));
}

TEST_CASE("What is no sphere, no stop plane or no range of a trail is told by its key") {
  using Told = std::pair<std::string, std::string>;
  const auto spheres = [](const char* list) { return refusedTrail({{"spheres", Json::parse(list)}}); };
  const auto plane = [](const char* stop) { return refusedTrail({{"stop_at", Json::parse(stop)}}); };
  const auto range = [](const char* frames) { return refusedTrail({{"range", Json::parse(frames)}}); };
  CHECK(spheres(R"([{"frame": 1, "offset": [0, 0, 0]}])") == Told());
  CHECK(spheres("3") == Told("spheres", "is not a list"));
  for (const char* const entry :
       {"3", R"({"offset":[0,0,0]})", R"({"frame":1})", R"({"frame":"1","offset":[0,0,0]})", "[1,[0,0,0]]"}) {
    const std::string list = R"([{"frame": 1, "offset": [0, 0, 0]}, )" + std::string(entry) + "]";
    CHECK(spheres(list.c_str()) == Told("spheres", Json::parse(entry).dump() + " is not a sphere"));
  }
  CHECK(spheres(R"([{"frame": 1, "offset": [0, 0]}])") == Told("spheres", "[0,0] is not a vector"));
  CHECK(spheres(R"([{"frame": 1, "offset": [0, 0, 0], "tangent": 3}])") ==
        Told("spheres.tangent", "3 is not a vector"));
  CHECK(plane(R"({"point": [0, 0, 0], "normal": [0, 1, 0]})") == Told());
  for (const char* const stop : {"3", "[0,1,0]", R"({"point":[0,0,0]})", R"({"normal":[0,1,0]})"}) {
    CHECK(plane(stop) == Told("stop_at", Json::parse(stop).dump() + " is not a plane"));
  }
  CHECK(plane(R"({"point": [0, 0], "normal": [0, 1, 0]})") == Told("stop_at.point", "[0,0] is not a vector"));
  CHECK(plane(R"({"point": [0, 0, 0], "normal": "up"})") == Told("stop_at.normal", "\"up\" is not a vector"));
  CHECK(range("[3, 12.5]") == Told());
  for (const char* const frames : {"3", "[3]", "[3,12,20]", "[3,\"12\"]", "[\"3\",12]", "[12,3]"}) {
    CHECK(range(frames) == Told("range", Json::parse(frames).dump() + " is not a range"));
  }
  CHECK(refusedTrail({{"limb", "left-arm"}}) == Told("limb", "is not a setting of a trail"));
  CHECK(refusedTrail(Json::array()) == Told("trails", "[] is not a set of settings"));
  rig::TrailSettings settings;
  CHECK(trailFromJson({{"limb", "left-arm"}}, 1.0, {"limb"}, settings)); // which the caller reads
}

TEST_CASE("A trail and its group are called in files what the user called them, and nothing by themselves") {
  rig::Trail trail;
  const auto named = [&] {
    Json json = Json::object();
    addNames(trail, json);
    return json;
  };
  CHECK(named().empty());
  trail.groupName = "both fists"; // of a group that the trail has left
  CHECK(named().empty());
  trail.group = 2;
  trail.name = "hook";
  CHECK(named() == Json{{"name", "hook"}, {"group", 2}, {"group_name", "both fists"}});
  trail.groupName.clear();
  CHECK(named() == Json{{"name", "hook"}, {"group", 2}});
}
