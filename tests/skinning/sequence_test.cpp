#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "core/gltf/import/mesh_surface.h"
#include "core/gltf/patch/edits.h"
#include "skinning/export/encode_gltf.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/read_sequence.h"
#include "skinning/sequence/topology.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/temporary_folder.h"

using namespace stretch;
using namespace stretch::skinning;
using Catch::Matchers::Contains;

namespace {

/// A tetrahedron lifted by `height`.
std::string tetrahedron(double height) {
  const std::string y = std::to_string(height);
  return "# a comment\nv 0 " + y + " 0\nv 1 " + y + " 0\nv 0 " + y + " 1\nv 0 " +
         std::to_string(height + 1.0) + " 0\nf 1/1/1 2/1/1 3\r\nf -4 -1 -3\nf 1 3 4\nf 2 4 3\n";
}

std::string errorOf(const std::filesystem::path& folder) {
  const auto sequence = readSequence({folder});
  REQUIRE_FALSE(sequence);
  CHECK(sequence.error().line().find('\n') == std::string::npos);
  return sequence.error().line();
}

template <typename T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string pointCache(std::int32_t points, std::int32_t samples, std::size_t numbers, float value = 0.5F,
                       float framesBetween = 1.0F) {
  std::string bytes("POINTCACHE2\0", 12);
  put<std::int32_t>(bytes, 1);
  put(bytes, points);
  put(bytes, 0.0F);
  put(bytes, framesBetween);
  put(bytes, samples);
  for (std::size_t i = 0; i < numbers; ++i) {
    put(bytes, value + static_cast<float>(i));
  }
  return bytes;
}

} // namespace

TEST_CASE("a folder of frames is read in the order of its numbers, with or without zeros") {
  const test::TemporaryFolder folder;
  for (const int frame : {1, 2, 9, 10, 11, 100}) {
    folder.write("wolf-" + std::to_string(frame) + ".obj", tetrahedron(frame));
  }
  folder.write("wolf-0003.OBJ", tetrahedron(3.0));
  folder.write("notes.txt", "not a frame");
  const auto sequence = readSequence({folder.path()});
  REQUIRE(sequence);
  REQUIRE(sequence->frameCount() == 7);
  const double heights[] = {1, 2, 3, 9, 10, 11, 100};
  for (std::size_t k = 0; k < 7; ++k) {
    CHECK(static_cast<double>(sequence->frame(k)[0].y) == heights[k]);
  }
  CHECK(sequence->vertexCount == 4);
  CHECK(sequence->triangles.size() == 4);
  REQUIRE(sequence->warnings.size() == 1);
  CHECK_THAT(sequence->warnings[0], Contains("number 4 to 8, 12 to 99:"));
}

TEST_CASE("numbers that no frame has are counted in the step of the others, the first eight gaps by name") {
  const test::TemporaryFolder folder;
  for (const int frame : {1, 2, 4, 6, 8, 10, 12, 14, 16, 18}) {
    folder.write("wolf-" + std::to_string(frame) + ".obj", tetrahedron(frame));
  }
  auto sequence = readSequence({folder.path()});
  REQUIRE(sequence);
  REQUIRE(sequence->warnings.size() == 1);
  CHECK_THAT(sequence->warnings[0], Contains("number 3, 5, 7, 9, 11, 13, 15, 17:"));
  folder.write("wolf-20.obj", tetrahedron(20.0));
  sequence = readSequence({folder.path()});
  REQUIRE(sequence);
  CHECK_THAT(sequence->warnings.at(0), Contains("number 3, 5, 7, 9, 11, 13, 15, 17 and more:"));
  const test::TemporaryFolder everySecond;
  for (const int frame : {2, 4, 6, 10}) {
    everySecond.write("wolf-" + std::to_string(frame) + ".obj", tetrahedron(frame));
  }
  sequence = readSequence({everySecond.path()});
  REQUIRE(sequence);
  REQUIRE(sequence->warnings.size() == 1);
  CHECK_THAT(sequence->warnings[0], Contains("number 8:"));
}

TEST_CASE("negative indices, slashes and polygons of an OBJ are understood") {
  const auto mesh =
      parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n", "quad.obj");
  REQUIRE(mesh);
  CHECK(mesh->triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("PLY frames: ascii and both byte orders give the same mesh") {
  const std::string ascii =
      "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty uchar red\n"
      "property float x\nproperty float y\nproperty double z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n"
      "255 0 0 0.5\n0 1 0 0.5\n0 0 1 0.5\n3 0 1 2\n";
  const auto text = parsePly(ascii, "a.ply");
  REQUIRE(text);
  for (const bool big : {false, true}) {
    std::string bytes = ascii.substr(0, ascii.find("255"));
    bytes.replace(bytes.find("ascii"), 5, big ? "binary_big_endian" : "binary_little_endian");
    const auto add = [&](const auto& value) {
      std::string raw;
      put(raw, value);
      bytes.append(big ? std::string(raw.rbegin(), raw.rend()) : raw);
    };
    for (const auto& p : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)}) {
      add(std::uint8_t{7});
      add(p.x);
      add(p.y);
      add(0.5);
    }
    add(std::uint8_t{3});
    for (const std::int32_t corner : {0, 1, 2}) {
      add(corner);
    }
    const auto binary = parsePly(bytes, "b.ply");
    REQUIRE(binary);
    CHECK(binary->positions == text->positions);
    CHECK(binary->triangles == text->triangles);
    CHECK_FALSE(parsePly(bytes.substr(0, bytes.size() - 1), "b.ply"));
  }
}

TEST_CASE("each kind of number of a PLY is read in each byte order, lists of other names and properties "
          "beside it") {
  struct Kind {
    std::vector<std::string> names;
    std::function<std::string(double)> bytes;
  };
  const auto kind = []<typename T>(std::vector<std::string> names, T /*of this type*/) {
    return Kind{std::move(names), [](double value) {
                  std::string raw;
                  put(raw, static_cast<T>(value));
                  return raw;
                }};
  };
  const std::vector<Kind> kinds{
      kind({"char", "int8"}, std::int8_t{0}),    kind({"uchar", "uint8"}, std::uint8_t{0}),
      kind({"short", "int16"}, std::int16_t{0}), kind({"ushort", "uint16"}, std::uint16_t{0}),
      kind({"int", "int32"}, std::int32_t{0}),   kind({"uint", "uint32"}, std::uint32_t{0}),
      kind({"float", "float32"}, float{0}),      kind({"double", "float64"}, double{0})};
  const std::vector<glm::vec3> corners{{3, 4, 5}, {103, 4, 5}, {3, 104, 5}, {3, 4, 105}};
  for (const Kind& one : kinds) {
    for (const std::string& name : one.names) {
      for (const bool big : {false, true}) {
        CAPTURE(name, big);
        const auto number = [&](double value) {
          const std::string raw = one.bytes(value);
          return big ? std::string(raw.rbegin(), raw.rend()) : raw;
        };
        std::string bytes =
            fmt::format("ply\nformat binary_{0}_endian 1.0\nelement vertex 4\nproperty {1} x\nproperty {1} "
                        "y\nproperty {1} z\n"
                        "element face 2\nproperty {1} vertex_indices_count\nproperty list {1} {1} texcoord\n"
                        "property list {1} {1} vertex_index\nproperty {1} flags\nend_header\n",
                        big ? "big" : "little", name);
        for (const glm::vec3& corner : corners) {
          bytes += number(corner.x) + number(corner.y) + number(corner.z);
        }
        bytes += number(9) + number(2) + number(7) + number(8) + // a number and a list of other things
                 number(4) + number(0) + number(1) + number(2) + number(3) + number(1);
        bytes += number(9) + number(0) + number(3) + number(3) + number(2) + number(0) + number(1);
        const auto mesh = parsePly(bytes, "a.ply");
        REQUIRE(mesh);
        CHECK(mesh->positions == corners);
        CHECK(mesh->triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {3, 2, 0}});
      }
    }
  }
}

TEST_CASE("a PLY is refused at the vertex or the face that is none, and by its header") {
  const auto told = [](const std::string& properties, const std::string& data) {
    const auto mesh = parsePly("ply\nformat ascii 1.0\n" + properties + "end_header\n" + data, "a.ply");
    return mesh ? std::string("accepted") : mesh.error().line();
  };
  const std::string places = "property float x\nproperty float y\nproperty float z\n";
  const std::string three = "element vertex 3\n" + places;
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string tips = "0 0 0\n1 0 0\n0 1 0\n";
  CHECK(told(three + faces, tips + "3 0 1 2\n") == "accepted");
  CHECK(told(three + faces, "0 0 0 1\n0 0 0 1\n0 3 0 1 2") == "accepted"); // lines do not count
  CHECK_THAT(told(three + faces, tips + "3 0 1 3\n"), Contains("face 0") && Contains("corners that exist"));
  CHECK_THAT(told(three + faces, tips + "3 0 1 -1\n"), Contains("face 0"));
  CHECK_THAT(told(three + faces, tips + "2 0 1\n"), Contains("face 0") && Contains("three or more"));
  CHECK_THAT(told(three + faces, tips + "3 0 1\n"), Contains("face 0") && Contains("end early"));
  CHECK_THAT(told(three + faces, "0 0 0\n1 0 0\n0 1e16 0\n3 0 1 2\n"),
             Contains("vertex 2") && Contains("finite"));
  CHECK_THAT(told(three + faces, "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"), Contains("vertex 1"));
  CHECK_THAT(told(three + faces, "0 0 zero\n1 0 0\n0 1 0\n3 0 1 2\n"),
             Contains("vertex 0") && Contains("not a number"));
  CHECK_THAT(told(three + "element face 1\nproperty int vertex_indices\n", tips + "0\n"), Contains("face 0"));
  CHECK_THAT(told(three + "element face 1\nproperty list uchar int corners\n", tips + "3 0 1 2\n"),
             Contains("face 0"));
  CHECK_THAT(told(three, tips), Contains("no faces"));
  CHECK_THAT(
      told("element vertex 3\nproperty float x\nproperty float y\n" + faces, "0 0\n1 0\n0 1\n3 0 1 2\n"),
      Contains("vertex 0") && Contains("x, y and z"));
  for (const char* const header :
       {"element vertex -1\n", "element vertex many\n", "property float x\n",
        "element vertex 3\nproperty half x\n", "element vertex 3\nproperty list float\n",
        "element vertex 3\nproperty list half int x\n", "element vertex 3\nproperty float\n",
        "format text 1.0\n"}) {
    CAPTURE(header);
    CHECK_THAT(told(header, ""), Contains("header is not understood"));
  }
  CHECK_THAT(told(three + "element face 1\nproperty list int int vertex_indices\n", tips + "1000001 0 1 2\n"),
             Contains("face 0"));
  CHECK_THAT(told(three + "element face 1\nproperty list int int vertex_indices\n", tips + "-1 0 1 2\n"),
             Contains("face 0"));
}

TEST_CASE("PLY files that promise more than they hold are refused at once") {
  const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n";
  CHECK_THAT(parsePly(head + "property float x\nproperty float y\nproperty float z\nend_header\n", "x.ply")
                 .error()
                 .line(),
             Contains("x.ply"));
  CHECK_THAT(parsePly(head + "end_header\n", "x.ply").error().line(), Contains("no properties"));
  CHECK_THAT(parsePly("ply\nformat ascii 2\n", "x.ply").error().line(), Contains("header"));
}

TEST_CASE("bad folders are refused with one clear line") {
  const test::TemporaryFolder folder;
  CHECK_THAT(errorOf(folder.path()), Contains("no .obj or .ply"));
  folder.write("a1.obj", tetrahedron(0.0));
  folder.write("a2.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
  CHECK_THAT(errorOf(folder.path()), Contains("a2.obj") && Contains("3 vertices") && Contains("4"));
  folder.write("a2.obj", tetrahedron(0.0) + "f 1 2 4\n");
  CHECK_THAT(errorOf(folder.path()), Contains("a2.obj") && Contains("faces differ"));
  folder.write("a2.obj", "v 0 nan 0\n" + tetrahedron(0.0));
  CHECK_THAT(errorOf(folder.path()), Contains("a2.obj:1") && Contains("finite"));
  folder.write("a2.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 9\n");
  CHECK_THAT(errorOf(folder.path()), Contains("a2.obj") && Contains("vertex 9"));
  folder.write("a2.obj", "");
  CHECK_THAT(errorOf(folder.path()), Contains("a2.obj") && Contains("no faces"));
  folder.write("a2.ply", "ply\n");
  CHECK_THAT(errorOf(folder.path()), Contains("OBJ and PLY"));
  CHECK_THAT(errorOf(folder.path() / "none"), Contains("none"));
}

TEST_CASE("a frame of a folder that cannot be read is refused by its name") {
  const test::TemporaryFolder folder;
  folder.write("f_1.obj", tetrahedron(1.0));
  std::filesystem::create_symlink(folder.path() / "gone.obj", folder.path() / "f_2.obj");
  CHECK_THAT(errorOf(folder.path()), Contains("f_2.obj"));
}

TEST_CASE("a point cache moves the vertices of its base mesh") {
  const test::TemporaryFolder folder;
  const auto base = folder.write("base.obj", tetrahedron(0.0));
  const auto sequence = readSequence({base, folder.write("run.pc2", pointCache(4, 3, 36))});
  REQUIRE(sequence);
  CHECK(sequence->frameCount() == 3);
  CHECK(sequence->frame(1)[0].x == 12.5F);
  CHECK(sequence->frame(2)[3].z == 35.5F);
  CHECK(sequence->name == "run");
  CHECK(sequence->triangles == std::vector<Triangle>{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
  CHECK(sequence->frameNames == std::vector<std::string>{"sample 0", "sample 1", "sample 2"});
}

TEST_CASE("vertices of an OBJ that lie together in every sample of its cache stay apart") {
  const test::TemporaryFolder folder;
  std::string bytes = pointCache(4, 1, 0);
  for (int number = 0; number < 12; ++number) { // The first two at the origin.
    put(bytes, number == 7 || number == 11 ? 1.0F : 0.0F);
  }
  const auto sequence =
      readSequence({folder.write("base.obj", tetrahedron(0.0)), folder.write("run.pc2", bytes)});
  REQUIRE(sequence);
  CHECK(sequence->vertexCount == 4);
}

TEST_CASE("a point cache of every second frame is told, unless its rate is given") {
  const test::TemporaryFolder folder;
  const auto base = folder.write("base.obj", tetrahedron(0.0));
  const auto toldAt = [&](float framesBetween, double framesPerSecond) {
    const auto sequence = readSequence(
        {base, folder.write("run.pc2", pointCache(4, 3, 36, 0.5F, framesBetween))}, {}, {}, framesPerSecond);
    REQUIRE(sequence);
    CHECK(sequence->framesPerSecond == (framesPerSecond > 0.0 ? framesPerSecond : 30.0));
    return sequence->warnings.empty() ? std::string() : sequence->warnings.front();
  };
  CHECK_THAT(toldAt(2.0F, 0.0), Contains("sampled every 2 frames") && Contains("give --fps"));
  CHECK_THAT(toldAt(0.5F, 0.0), Contains("every 0.5 frames"));
  CHECK(toldAt(2.0F, 12.0).empty());
  CHECK(toldAt(1.0F, 0.0).empty());
  for (const float none : {0.0F, -2.0F, std::numeric_limits<float>::infinity(), std::nanf("")}) {
    CHECK(toldAt(none, 0.0).empty()); // some writers leave it out
  }
}

TEST_CASE("a point cache moves the triangles and looks of a PLY and of a glTF as of an OBJ") {
  const test::TemporaryFolder folder;
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 255 0 0\n1 0 0 0 255 0\n0 0 1 0 0 255\n0 1 0 0 0 0\n3 0 1 2\n3 0 3 1\n";
  const auto sequence =
      readSequence({folder.write("base.ply", ply), folder.write("run.pc2", pointCache(4, 2, 24))});
  REQUIRE(sequence);
  CHECK(sequence->triangles == std::vector<Triangle>{{0, 1, 2}, {0, 3, 1}});
  REQUIRE(sequence->surface);
  CHECK(sequence->surface->places == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(sequence->surface->triangles == sequence->triangles);
  REQUIRE(sequence->surface->colors.size() == 4);
  CHECK(sequence->surface->colors[1] == glm::vec4(0.0F, 1.0F, 0.0F, 1.0F));

  SkinnedSequence tube = test::wavingTube(3, 2);
  REQUIRE(gltf::save(encodeGltf(tube).source, folder / "tube.glb"));
  const auto count = static_cast<std::int32_t>(tube.bindPositions.size());
  const auto moved = readSequence(
      {folder / "tube.glb", folder.write("tube.pc2", pointCache(count, 2, 6 * tube.bindPositions.size()))});
  REQUIRE(moved);
  CHECK(moved->triangles == tube.triangles);
  CHECK(moved->frame(1)[0].x == 0.5F + 3.0F * static_cast<float>(count));
}

TEST_CASE("a cache alone finds the mesh beside it that it was made of, by vertices and then by name") {
  const test::TemporaryFolder folder;
  const auto cache = folder.write("run_fast.pc2", pointCache(4, 3, 36));
  CHECK(sequencePaths({cache}) == std::vector{cache});
  CHECK_THAT(readSequence({cache}).error().line(),
             Contains("no OBJ or PLY beside the cache has its 4 points"));
  folder.write("run_fast_other.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n");
  const auto far = folder.write("a.obj", tetrahedron(0.0));
  CHECK(sequencePaths({cache}) == std::vector{far, cache});
  const auto near = folder.write("run_base.obj", tetrahedron(0.0));
  CHECK(sequencePaths({cache}) == std::vector{near, cache});
  CHECK(sequencePaths({cache, far}) == std::vector{far, cache});
  REQUIRE(readSequence({cache}));
}

TEST_CASE("a cache alone finds a glTF beside it, of several the one with as many vertices") {
  const test::TemporaryFolder folder;
  const SkinnedSequence tube = test::wavingTube(3, 2);
  REQUIRE(gltf::save(encodeGltf(tube).source, folder / "tube.glb"));
  SkinnedSequence larger = tube;
  larger.bindPositions.push_back(tube.bindPositions.front());
  larger.influences.push_back(tube.influences.front());
  REQUIRE(gltf::save(encodeGltf(larger).source, folder / "run.glb"));
  const auto points = static_cast<std::int32_t>(tube.bindPositions.size());
  const auto cache = folder.write("run.pc2", pointCache(points, 1, 3 * tube.bindPositions.size()));
  CHECK(sequencePaths({cache}) == std::vector{folder / "tube.glb", cache});
}

TEST_CASE("one numbered frame stands for its folder, a single mesh for itself") {
  const test::TemporaryFolder folder;
  const auto first = folder.write("wolf-1.obj", tetrahedron(0.0));
  CHECK(sequencePaths({first}) == std::vector{first});
  folder.write("wolf-02.obj", tetrahedron(1.0));
  CHECK(sequencePaths({first}) == std::vector{folder.path()});
  const auto single = folder.write("house.obj", tetrahedron(1.0));
  CHECK(sequencePaths({single}) == std::vector{single});
  CHECK_THAT(readSequence({single}).error().line(), Contains("no mesh sequence"));
}

TEST_CASE("bad point caches are refused with one clear line") {
  const test::TemporaryFolder folder;
  const auto base = folder.write("base.obj", tetrahedron(0.0));
  const auto refuse = [&](const std::string& bytes) {
    const auto sequence = readSequence({base, folder.write("run.pc2", bytes)});
    REQUIRE_FALSE(sequence);
    return sequence.error().line();
  };
  CHECK_THAT(refuse("POINTCACHE2"), Contains("no PC2"));
  CHECK_THAT(refuse(pointCache(4, 3, 35)), Contains("cut short: 172 bytes for 4 points in 3 samples"));
  CHECK_THAT(refuse(pointCache(5, 3, 45)), Contains("5 points") && Contains("4 vertices"));
  CHECK_THAT(refuse(pointCache(4, 0, 0)), Contains("0 samples"));
  CHECK_THAT(refuse(pointCache(4, -1, 12)), Contains("-1 samples"));
  CHECK_THAT(refuse(pointCache(0, 3, 0)), Contains("0 points"));
  CHECK_THAT(refuse(pointCache(-4, 3, 36)), Contains("-4 points"));
  std::string later = pointCache(4, 3, 36);
  later[12] = 2;
  CHECK_THAT(refuse(later), Contains("version 2, 4 points, 3 samples"));
  CHECK_THAT(refuse(pointCache(4, 2000000000, 12)), Contains("cut short"));
  for (const float number : {std::nanf(""), 1e16F, -1e30F}) {
    CHECK_THAT(refuse(pointCache(4, 1, 12, number)), Contains("vertex 0") && Contains("sample 0"));
  }
}

TEST_CASE("a particle log becomes the mesh of its membranes, wound outwards") {
  const test::TemporaryFolder folder;
  // Five elastic particles, of which 1..4 carry membranes, and one liquid particle in each frame.
  std::string log;
  for (const char* number : {"0", "100", "0", "100", "0", "100", "5", "1"}) {
    log += std::string(number) + "\n";
  }
  for (int frame = 0; frame < 2; ++frame) {
    log += fmt::format(
        "9\t9\t9\t2.1\n0\t{0}\t0\t2.1\n1\t{0}\t0\t2.1\n0\t{0}\t1\t2.1\n0\t{1}\t0\t2.1\n5\t5\t5\t1.1\n", frame,
        frame + 1);
  }
  folder.write("position_buffer.txt", log);
  folder.write("membranes_buffer.txt", "4\n1\t2\t3\n1\t4\t2\n1\t4\t3\n2\t3\t4\n");
  const auto sequence = readSequence({folder.path()});
  REQUIRE(sequence);
  CHECK(sequence->vertexCount == 4);
  CHECK(sequence->frameCount() == 2);
  CHECK(sequence->frame(1)[0] == glm::vec3(0, 1, 0));
  CHECK(enclosedVolume(sequence->frame(0), sequence->triangles) == Approx(1.0 / 6.0));
  REQUIRE(sequence->warnings.size() == 1);
  CHECK_THAT(sequence->warnings[0], Contains("membranes were wound inwards"));

  folder.write("position_buffer.txt", log.substr(0, log.size() - 20));
  CHECK_THAT(errorOf(folder.path()), Contains("ends within a frame"));
  folder.write("position_buffer.txt", log + "1 2 x 4\n");
  CHECK_THAT(errorOf(folder.path()), Contains("position_buffer.txt:21"));
  folder.write("position_buffer.txt", log);
  folder.write("membranes_buffer.txt", "1\n1 2 9\n");
  CHECK_THAT(errorOf(folder.path()), Contains("membranes"));
}

TEST_CASE("the topology report counts what is odd") {
  test::Shape shape = test::tube(4.0, 0.5, 8, 8);
  const auto report = [&] { return inspectTopology(shape.positions, shape.triangles); };
  CHECK(report().warnings().empty());
  CHECK(report().components == 1);
  shape.triangles.pop_back();
  CHECK(report().boundaryEdges == 3);
  shape.triangles.push_back({0, 1, 40});
  CHECK(report().crowdedEdges == 1);
  shape.triangles.push_back({2, 2, 3});
  CHECK(report().degenerateTriangles == 1);
  shape.positions.push_back(shape.positions[0]);
  CHECK(report().duplicatePositions == 1);
  CHECK(report().looseVertices == 1);
}

TEST_CASE("triangles wound at random are all turned outwards") {
  test::Shape shape = test::torus(2.0, 0.5, 24, 12);
  const double volume = enclosedVolume(shape.positions, shape.triangles);
  CHECK(volume > 0.0);
  std::size_t turned = 0;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    if ((t * 2654435761U >> 7U) % 2 == 0) {
      std::swap(shape.triangles[t][0], shape.triangles[t][1]);
      ++turned;
    }
  }
  CHECK(orientOutwards(shape.positions, shape.triangles) == turned);
  CHECK(enclosedVolume(shape.positions, shape.triangles) == Approx(volume));
  CHECK(orientOutwards(shape.positions, shape.triangles) == 0);
}

TEST_CASE("vertices that lie on another in every frame are joined, others are not") {
  MeshSequence sequence;
  sequence.vertexCount = 4;
  sequence.triangles = {{0, 1, 2}, {3, 2, 1}};
  sequence.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0},
                        {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  CHECK(joinDuplicates(sequence) == 1);
  CHECK(sequence.vertexCount == 3);
  CHECK(sequence.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 1}});
  CHECK(sequence.frame(1)[2] == glm::vec3(1, 0, 0));
}

TEST_CASE("reading frames and samples tells how far it is, up to the whole") {
  const test::TemporaryFolder folder;
  const test::TemporaryFolder frames;
  for (const int frame : {1, 2, 3, 4}) {
    frames.write("wolf-" + std::to_string(frame) + ".obj", tetrahedron(frame));
  }
  const auto base = folder.write("base.obj", tetrahedron(0.0));
  const auto cache = folder.write("run.pc2", pointCache(4, 4, 48));
  const auto sharesOf = [](const std::vector<std::filesystem::path>& paths) {
    std::vector<double> shares;
    REQUIRE(readSequence(paths, [&](double share) { shares.push_back(share); }));
    return shares;
  };
  const std::vector<double> wanted{0.25, 0.5, 0.75, 1.0};
  CHECK(sharesOf({frames.path()}) == wanted);
  CHECK(sharesOf({base, cache}) == wanted);
}
