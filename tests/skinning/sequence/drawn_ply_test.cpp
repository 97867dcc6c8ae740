// PLY files of any columns, types, orders and encodings, and each reason for which one is refused.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "skinning/sequence/mesh_file.h"
#include "tests/support/refusal.h"
#include "tests/support/row.h"

using namespace stretch;
using skinning::MeshFile;
using skinning::parsePly;
using skinning::Polygons;
using test::Row;

namespace {

enum class Written { ascii, little, big };

/// A type of numbers: both of its names and how many bytes it takes.
struct NumberType {
  const char* name;
  const char* other;
  std::size_t bytes;
  double least;
  double most;
};

constexpr std::array<NumberType, 8> numberTypes{{{"char", "int8", 1, -100, 100},
                                                 {"uchar", "uint8", 1, 0, 200},
                                                 {"short", "int16", 2, -3000, 3000},
                                                 {"ushort", "uint16", 2, 0, 50000},
                                                 {"int", "int32", 4, -70000, 70000},
                                                 {"uint", "uint32", 4, 0, 70000},
                                                 {"float", "float32", 4, -50, 50},
                                                 {"double", "float64", 8, -50, 50}}};
constexpr std::size_t unsignedByte = 1;
constexpr std::size_t unsignedShort = 3;
constexpr std::size_t isFloatFrom = 6;

template <typename T>
void appendNumber(std::string& bytes, double value, bool turned) {
  std::array<char, sizeof(T)> raw{};
  const auto typed = static_cast<T>(value);
  std::memcpy(raw.data(), &typed, sizeof(T));
  if (turned) {
    std::ranges::reverse(raw);
  }
  bytes.append(raw.data(), raw.size());
}

void write(std::string& bytes, double value, std::size_t type, Written how) {
  const bool turned = how == Written::big;
  if (how == Written::ascii) {
    bytes += type < isFloatFrom ? fmt::format("{:.0f} ", value) : fmt::format("{:.17g} ", value);
    return;
  }
  switch (type) {
  case 0:
    appendNumber<std::int8_t>(bytes, value, turned);
    break;
  case 1:
    appendNumber<std::uint8_t>(bytes, value, turned);
    break;
  case 2:
    appendNumber<std::int16_t>(bytes, value, turned);
    break;
  case 3:
    appendNumber<std::uint16_t>(bytes, value, turned);
    break;
  case 4:
    appendNumber<std::int32_t>(bytes, value, turned);
    break;
  case 5:
    appendNumber<std::uint32_t>(bytes, value, turned);
    break;
  case 6:
    appendNumber<float>(bytes, value, turned);
    break;
  default:
    appendNumber<double>(bytes, value, turned);
    break;
  }
}

struct Column {
  std::string name;
  std::size_t type = 6;
  bool isList = false;
};

/// The value that a file of this type gives back.
double drawnValue(Row& row, std::size_t type) {
  const NumberType& number = numberTypes[type];
  const double value = row.between(number.least, number.most);
  return type < isFloatFrom ? std::round(value)
         : type == 6        ? static_cast<double>(static_cast<float>(value))
                            : value;
}

std::string headOf(const char* element, std::size_t count, const std::vector<Column>& columns, Row& row) {
  std::string text = fmt::format("element {} {}\n", element, count);
  for (const Column& column : columns) {
    const NumberType& type = numberTypes[column.type];
    text +=
        fmt::format("property {}{} {}\n", column.isList ? (row.once(2) ? "list uchar " : "list int32 ") : "",
                    row.once(2) ? type.name : type.other, column.name);
  }
  return text;
}

void shuffle(std::vector<Column>& columns, Row& row) {
  for (std::size_t i = columns.size(); i > 1; --i) {
    std::swap(columns[i - 1], columns[row.below(static_cast<std::uint32_t>(i))]);
  }
}

std::size_t anyType(Row& row) {
  return row.below(8);
}

/// The columns of a vertex: its place, and what exporters add under one of their names.
std::vector<Column> vertexColumns(Row& row) {
  std::vector<Column> columns;
  for (const char* const axis : {"x", "y", "z"}) {
    columns.push_back({axis, anyType(row)});
  }
  const auto addAll = [&](const std::vector<std::string>& names, bool one) {
    const std::size_t type = anyType(row);
    for (const std::string& name : names) {
      columns.push_back({name, one ? type : anyType(row)});
    }
  };
  if (row.once(2)) {
    addAll({"nx", "ny", "nz"}, false);
  }
  if (row.once(2)) {
    addAll(
        row.oneOf(std::vector<std::vector<std::string>>{{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}),
        false);
  }
  if (row.once(2)) {
    addAll(row.once(2) ? std::vector<std::string>{"red", "green", "blue"}
                       : std::vector<std::string>{"r", "g", "b"},
           true);
    if (row.once(2)) {
      addAll({row.once(2) ? "alpha" : "a"}, true);
    }
  }
  if (row.once(2)) {
    columns.push_back({"quality", anyType(row)});
  }
  if (row.once(3)) {
    columns.push_back({"flags", anyType(row), true});
  }
  shuffle(columns, row);
  return columns;
}

double shareOf(double value, std::size_t type) {
  const double share = type == unsignedByte ? value / 255.0 : type == unsignedShort ? value / 65535.0 : value;
  return std::clamp(share, 0.0, 1.0);
}

float lightOf(double encoded) {
  return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
}

/// The vertex that a row of numbers stands for, as a reader of names would put it together.
void expectVertex(const std::vector<Column>& columns, const std::vector<double>& values, MeshFile& mesh) {
  const auto valueOf = [&](const std::vector<std::string>& names) -> const double* {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (!columns[i].isList && std::ranges::find(names, columns[i].name) != names.end()) {
        return &values[i];
      }
    }
    return nullptr;
  };
  const auto typeOf = [&](const double* value) {
    return columns[static_cast<std::size_t>(value - values.data())].type;
  };
  const auto number = [](const double* value) { return static_cast<float>(*value); };
  mesh.positions.emplace_back(number(valueOf({"x"})), number(valueOf({"y"})), number(valueOf({"z"})));
  if (const double* const x = valueOf({"nx"})) {
    const glm::vec3 normal(number(x), number(valueOf({"ny"})), number(valueOf({"nz"})));
    mesh.normals.push_back(normal == glm::vec3(0.0F) ? glm::vec3(0.0F, 1.0F, 0.0F) : glm::normalize(normal));
  }
  if (const double* const u = valueOf({"s", "u", "texture_u"})) {
    mesh.texCoords.emplace_back(number(u), number(valueOf({"t", "v", "texture_v"})));
  }
  if (const double* const red = valueOf({"red", "r"})) {
    const double* const green = valueOf({"green", "g"});
    const double* const blue = valueOf({"blue", "b"});
    const double* const alpha = valueOf({"alpha", "a"});
    mesh.colors.emplace_back(lightOf(shareOf(*red, typeOf(red))), lightOf(shareOf(*green, typeOf(green))),
                             lightOf(shareOf(*blue, typeOf(blue))),
                             alpha != nullptr ? static_cast<float>(shareOf(*alpha, typeOf(alpha))) : 1.0F);
  }
}

struct Drawn {
  std::string bytes;
  std::size_t endOfHead = 0;
  MeshFile mesh;
};

void writeLists(std::string& data, const std::string& head, const std::vector<double>& values,
                std::size_t type, Written how) {
  const bool isByte = head.find("list uchar") != std::string::npos;
  write(data, static_cast<double>(values.size()), isByte ? 1 : 4, how);
  for (const double value : values) {
    write(data, value, type, how);
  }
}

Drawn drawnFile(std::uint32_t seed, Written how) {
  Row row(seed);
  Drawn drawn;
  const std::vector<Column> columns = vertexColumns(row);
  const std::size_t vertices = 3 + row.below(6);
  std::string head = row.once(2) ? "comment drawn\n" : "";
  std::string data;
  if (row.once(3)) { // an element that is stepped over
    const std::vector<Column> material{{"shine", anyType(row)}};
    head += headOf("material", 2, material, row);
    write(data, drawnValue(row, material[0].type), material[0].type, how);
    write(data, drawnValue(row, material[0].type), material[0].type, how);
  }
  head += headOf("vertex", vertices, columns, row);
  const std::string lists = head.substr(head.find("element vertex"));
  for (std::size_t v = 0; v < vertices; ++v) {
    std::vector<double> values;
    for (const Column& column : columns) {
      if (column.isList) {
        writeLists(data, lists, std::vector<double>(row.below(4), 7.0), column.type, how);
        values.push_back(0.0);
      } else {
        values.push_back(drawnValue(row, column.type));
        write(data, values.back(), column.type, how);
      }
    }
    data += how == Written::ascii && row.once(2) ? "\n" : "";
    expectVertex(columns, values, drawn.mesh);
  }
  const std::size_t faces = 1 + row.below(4);
  const std::vector<Column> faceColumns{{row.once(2) ? "vertex_indices" : "vertex_index", 4, true}};
  const std::string faceHead = headOf("face", faces, faceColumns, row);
  for (std::size_t f = 0; f < faces; ++f) {
    std::vector<double> corners(3 + row.below(3));
    for (double& corner : corners) {
      corner = row.below(static_cast<std::uint32_t>(vertices));
    }
    writeLists(data, faceHead, corners, 4, how);
    Polygons& polygons = drawn.mesh.polygons;
    for (const double corner : corners) {
      polygons.corners.push_back(static_cast<std::uint32_t>(corner));
    }
    polygons.ends.push_back(polygons.corners.size());
  }
  const char* const format = how == Written::ascii    ? "ascii"
                             : how == Written::little ? "binary_little_endian"
                                                      : "binary_big_endian";
  drawn.bytes = fmt::format("ply\nformat {} 1.0\n{}{}end_header\n", format, head, faceHead);
  drawn.endOfHead = drawn.bytes.size();
  drawn.bytes += data;
  return drawn;
}

template <typename Vector>
void checkAlmost(const std::vector<Vector>& found, const std::vector<Vector>& wanted) {
  REQUIRE(found.size() == wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(glm::length(found[i] - wanted[i]) <= 1e-5F * (1.0F + glm::length(wanted[i])));
  }
}

std::string asciiFile(const std::string& head, const std::string& data) {
  return "ply\nformat ascii 1.0\n" + head + "end_header\n" + data;
}

const std::string places = "property float x\nproperty float y\nproperty float z\n";
const std::string threeVertices = "element vertex 3\n" + places;
const std::string oneFace = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string threeCorners = "0 0 0\n1 0 0\n0 1 0\n";

} // namespace

TEST_CASE("A PLY of any columns is read by their names, in every encoding", "[drawn-ply]") {
  const Written how = GENERATE(Written::ascii, Written::little, Written::big);
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const Drawn drawn = drawnFile(seed, how);
    INFO(drawn.bytes.substr(0, drawn.endOfHead));
    const Result<MeshFile> mesh = parsePly(drawn.bytes, "drawn.ply");
    REQUIRE(test::refusal(mesh) == "accepted");
    checkAlmost(mesh->positions, drawn.mesh.positions);
    checkAlmost(mesh->normals, drawn.mesh.normals);
    checkAlmost(mesh->texCoords, drawn.mesh.texCoords);
    checkAlmost(mesh->colors, drawn.mesh.colors);
    CHECK(mesh->polygons == drawn.mesh.polygons);
  }
}

TEST_CASE("A binary PLY that was cut anywhere is refused, and an ascii one where a number is gone",
          "[drawn-ply]") {
  const Written how = GENERATE(Written::little, Written::big);
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const Drawn drawn = drawnFile(seed, how);
    for (std::size_t size = 0; size < drawn.bytes.size(); ++size) {
      CHECK_FALSE(parsePly(drawn.bytes.substr(0, size), "cut.ply"));
    }
  }
}

TEST_CASE("Each line of a PLY's head that is not understood is refused", "[drawn-ply]") {
  const std::string head = threeVertices + oneFace;
  const std::string data = threeCorners + "3 0 1 2\n";
  REQUIRE(parsePly(asciiFile(head, data), "a.ply"));
  REQUIRE(parsePly(asciiFile("obj_info of a scan\n" + head + "element nothing 0\n", data), "a.ply"));
  for (const auto& [of, is] :
       std::vector<std::pair<std::string, std::string>>{{"element vertex 3", "element vertex -1"},
                                                        {"element vertex 3", "element vertex three"},
                                                        {"element vertex 3", "element vertex 3.5"},
                                                        {"element vertex 3\n", ""},
                                                        {"float x", "real x"},
                                                        {"float x", "float"},
                                                        {"list uchar int", "list byte int"},
                                                        {"list uchar int", "list uchar number"},
                                                        {"ply\n", "plyx\n"},
                                                        {"format ascii", "format text"},
                                                        {"end_header\n", ""}}) {
    std::string text = asciiFile(head, data);
    text.replace(text.find(of), of.size(), is);
    CAPTURE(of, is);
    CHECK_THAT(test::refusal(parsePly(text, "a.ply")),
               Catch::Contains("a.ply: the PLY header is not understood"));
  }
}

TEST_CASE("A PLY's numbers that cannot be meant are refused by where they stand", "[drawn-ply]") {
  const auto refusal = [](const std::string& head, const std::string& data) {
    return test::refusal(parsePly(asciiFile(head, data), "a.ply"));
  };
  const std::string head = threeVertices + oneFace;
  const auto isTold = [&](const std::string& told, const char* place, const char* what) {
    CHECK_THAT(told, Catch::StartsWith(std::string("a.ply, ") + place));
    CHECK_THAT(told, Catch::Contains(what));
  };
  isTold(refusal(head, "0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"), "vertex 1", "not a number");
  isTold(refusal(head, "0 0 0\n1 1e16 0\n0 1 0\n3 0 1 2\n"), "vertex 1", "finite x, y and z");
  CHECK(refusal(head, "0 0 0\n1 1e15 0\n0 1 0\n3 0 1 2\n") == "accepted");
  CHECK(refusal(head, "0 0 0\n1 -1e15 0\n0 1 0\n3 0 1 2\n") == "accepted");
  isTold(refusal(head, "0 0 0\n1 -1.1e15 0\n0 1 0\n3 0 1 2\n"), "vertex 1", "finite x, y and z");
  isTold(refusal("element vertex 1\nproperty float x\nproperty float y\n" + oneFace, "0 0\n3 0 0 0\n"),
         "vertex 0", "finite x, y and z");
  for (const char* const face : {"3 0 1 3\n", "3 -1 1 2\n", "2 0 1\n", "0\n", "4 0 1 2 3\n"}) {
    CAPTURE(face);
    isTold(refusal(head, threeCorners + face), "face 0", "three or more corners that exist");
  }
  isTold(refusal(threeVertices + "element face 1\nproperty int vertex_indices\n", threeCorners + "0\n"),
         "face 0", "three or more corners");
  isTold(
      refusal(threeVertices + "element face 1\nproperty list uchar int strip\n", threeCorners + "3 0 1 2\n"),
      "face 0", "three or more corners");
  isTold(refusal(head, threeCorners + "-1\n"), "face 0", "not a number");
  isTold(refusal(head, threeCorners + "3 0 1\n"), "face 0", "end early");
  isTold(refusal(threeVertices + "element edge 1\nproperty list int uchar ends\n" + oneFace,
                 threeCorners + "1000001 0\n"),
         "edge 0", "not a number");
  CHECK(refusal(threeVertices, threeCorners) ==
        "a.ply: the file holds no faces; give a mesh with triangles or polygons");
  CHECK_THAT(refusal(threeVertices + "element edge 1\n" + oneFace, threeCorners + "3 0 1 2\n"),
             Catch::Contains("element 'edge' has no properties"));
  // Two rows of columns for vertices: some would have a normal, some none.
  CHECK_THAT(refusal(threeVertices + oneFace + threeVertices, threeCorners + "3 0 1 2\n" + threeCorners),
             Catch::Contains("a.ply: the header describes element 'vertex' twice"));
  // A place whose axis is a list is none, and one that comes twice is not three.
  isTold(
      refusal("element vertex 1\nproperty list uchar float x\nproperty float y\nproperty float z\n" + oneFace,
              "2 0 0 1 2\n3 0 0 0\n"),
      "vertex 0", "finite x, y and z");
}
