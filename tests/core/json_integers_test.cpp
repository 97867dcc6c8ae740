#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/json/json_integers.h"

using namespace stretch;
using gltf::Json;

TEST_CASE("an integer is read however it is written") {
  CHECK(gltf::integerOf(Json(7)) == 7);
  CHECK(gltf::integerOf(Json(-1)) == -1);
  CHECK(gltf::integerOf(Json(7.0)) == 7);
  CHECK(gltf::integerOf(Json(2147483647)) == 2147483647);
  CHECK(gltf::integersOf(Json{1, 2.0, 3}) == std::vector{1, 2, 3});
}

TEST_CASE("what is no integer, or larger than one can be, is refused rather than cut") {
  for (const Json& value : {Json(0.5), Json(2147483648), Json(-2147483648.0), Json(3.3e35), Json("7"),
                            Json(true), Json(nullptr), Json::array({7})}) {
    CAPTURE(value.dump());
    CHECK_THROWS_AS(gltf::integerOf(value), Json::type_error);
    CHECK_THROWS_AS(gltf::integersOf(Json::array({1, value})), Json::type_error);
  }
  CHECK_THROWS_AS(gltf::integersOf(Json{{"a", 1}}), Json::type_error);
}
