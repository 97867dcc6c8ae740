// Polygons that are cut into triangles: all of each is covered, and nothing beside it.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/gltf/import/mesh_surface.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/read_sequence.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

using Outline = std::vector<glm::vec2>;

/// An L of area 5 whose second corner is the notch.
const Outline notched{{3, 1}, {1, 1}, {1, 3}, {0, 3}, {0, 0}, {3, 0}};

std::string face(const Outline& outline, double height = 0.0) {
  std::string text;
  std::string corners = "f";
  for (std::size_t i = 0; i < outline.size(); ++i) {
    text += fmt::format("v {} {} {}\n", outline[i].x, outline[i].y, height);
    corners += fmt::format(" {0}/{0}", i + 1);
  }
  return text + corners + "\n";
}

MeshFile meshOf(const Outline& outline) {
  auto mesh = parseObj(face(outline), "a.obj");
  REQUIRE(mesh);
  return std::move(mesh).value();
}

/// Signed areas of the triangles as they are wound.
std::vector<float> areasOf(const std::vector<glm::vec3>& places, const std::vector<Triangle>& triangles) {
  std::vector<float> areas;
  areas.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    areas.push_back(0.5F * glm::cross(places[b] - places[a], places[c] - places[a]).z);
  }
  return areas;
}

void expectCovered(const Outline& outline, float area) {
  const MeshFile mesh = meshOf(outline);
  REQUIRE(mesh.triangles.size() == outline.size() - 2);
  float sum = 0.0F;
  for (const float one : areasOf(mesh.positions, mesh.triangles)) {
    CHECK(one > -1e-5F);
    sum += one;
  }
  CHECK(sum == Approx(area).epsilon(1e-5));
}

} // namespace

TEST_CASE("a notch of a polygon stays open, whichever corner it begins with") {
  for (std::size_t turn = 0; turn < notched.size(); ++turn) {
    CAPTURE(turn);
    Outline outline = notched;
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(turn), outline.end());
    expectCovered(outline, 5.0F);
  }
  expectCovered({{0, 0}, {4, 0}, {4, 4}, {3, 1}, {2, 4}, {1, 1}, {0, 4}}, 10.0F); // teeth
  expectCovered({{0, 0}, {4, 0}, {2, 1}, {2, 4}}, 5.0F);                          // an arrow
  expectCovered({{0, 3}, {0, 0}, {1, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}}, 5.0F);  // with a corner on an edge
}

TEST_CASE("a polygon that a fan covers is a fan around its first corner, collinear corners included") {
  const std::vector<Triangle> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  CHECK(meshOf({{0, 0}, {2, 0}, {3, 1}, {2, 3}, {0, 2}}).triangles == fan);
  CHECK(meshOf({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}).triangles == fan);
  CHECK(meshOf({{0, 0}, {3, 0}, {1, 1}, {1, 2}, {0, 3}}).triangles == fan);
  CHECK(meshOf({{0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}}).triangles == fan);
}

TEST_CASE("a polygon that crosses itself is cut into as many triangles as any") {
  CHECK(meshOf({{0, 0}, {4, 4}, {4, 0}, {0, 4}, {2, 6}}).triangles.size() == 3);
}

TEST_CASE("a polygon of a PLY is cut as one of an OBJ") {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty "
                     "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const glm::vec2& corner : notched) {
    text += fmt::format("{} {} 0\n", corner.x, corner.y);
  }
  const auto mesh = parsePly(text + "6 0 1 2 3 4 5\n", "a.ply");
  REQUIRE(mesh);
  CHECK(mesh->triangles == meshOf(notched).triangles);
}

TEST_CASE("all frames have the triangles of the first, and so have their looks") {
  const test::TemporaryFolder folder;
  Outline opened = notched;
  opened[1] = {4, 4}; // No notch any more: by itself it would be cut otherwise.
  const std::string looks = "vt 0 0\nvt 1 0\nvt 2 0\nvt 3 0\nvt 4 0\nvt 5 0\n";
  folder.write("f_1.obj", looks + face(notched));
  folder.write("f_2.obj", looks + face(opened));
  REQUIRE(meshOf(opened).triangles != meshOf(notched).triangles);
  const auto sequence = readSequence({folder.path()});
  REQUIRE(sequence);
  CHECK(sequence->frameCount() == 2);
  CHECK(sequence->triangles == meshOf(notched).triangles);
  REQUIRE(sequence->surface);
  CHECK(sequence->surface->triangles == sequence->triangles);
  CHECK(sequence->surface->parts.front().triangleCount == 4);
}
