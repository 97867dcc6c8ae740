// The places and faces of an OBJ: which are taken, and where one that cannot be meant is refused.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "skinning/sequence/mesh_file.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

const std::string threePlaces = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string toldOfObj(const std::string& text) {
  return test::refusal(parseObj(text, "a.obj"));
}

} // namespace

TEST_CASE("a face of an OBJ with fewer than three corners is refused by its line, the first and later ones") {
  const std::string told = "a face has fewer than three corners; export the frame again";
  CHECK(toldOfObj(threePlaces + "f 1 2\n") == "a.obj:4: " + told);
  CHECK(toldOfObj(threePlaces + "f\n") == "a.obj:4: " + told);
  CHECK(toldOfObj(threePlaces + "f 1 2 3\nf 1 2\n") == "a.obj:5: " + told);
  CHECK(toldOfObj(threePlaces + "# a remark\n\nf 1 2 3\nf 1 2 3\nf 3\n") == "a.obj:8: " + told);
}

TEST_CASE("a corner of an OBJ that names no vertex is refused by its line, as far as the line shows it") {
  const std::string told = "a face names a vertex that does not exist; export the frame again";
  for (const char* const corner : {"0", "-4", "x", "/1", "4294967296"}) {
    CAPTURE(corner);
    CHECK(toldOfObj(threePlaces + "f 1 2 " + corner + "\n") == "a.obj:4: " + told);
  }
  CHECK(toldOfObj("f 1 2 -1\n" + threePlaces) == "a.obj:1: " + told); // Counted from the end of nothing.
  CHECK(toldOfObj(threePlaces + "f 1 2 4\n") == "a.obj: a face names vertex 4 of 3; export the frame again");
}

TEST_CASE("faces of an OBJ may stand before their vertices, and count back from where they stand") {
  const auto before = parseObj("f 1 2 3\n" + threePlaces, "a.obj");
  REQUIRE(before);
  CHECK(before->triangles == std::vector<Triangle>{{0, 1, 2}});
  const auto between = parseObj(threePlaces + "f -3 -2 -1\n" + threePlaces + "f -3 -1 1\n", "a.obj");
  REQUIRE(between);
  CHECK(between->triangles == std::vector<Triangle>{{0, 1, 2}, {3, 5, 0}});
}

TEST_CASE("places of an OBJ are three numbers of at most 1e+15 to either side") {
  const std::string told = "a vertex needs three finite numbers of at most 1e+15; export the frame again";
  const auto toldOfPlace = [](const std::string& place) {
    return toldOfObj("v " + place + "\n" + threePlaces + "f 1 2 3\n");
  };
  CHECK(toldOfPlace("1e15 -1e15 0") == "accepted");
  CHECK(toldOfPlace("1 2 3 0.5") == "accepted");
  for (const char* const place : {"1 2", "", "1.1e15 0 0", "0 0 -1.1e15", "0 1e 0"}) {
    CAPTURE(place);
    CHECK(toldOfPlace(place) == "a.obj:1: " + told);
  }
}
