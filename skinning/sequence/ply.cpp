#include "skinning/sequence/mesh_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <string>

#include <glm/geometric.hpp>

#include "core/base/number.h"
#include "core/math/srgb.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

enum class Encoding { ascii, littleEndian, bigEndian };
enum class Number { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Number type = Number::float32;
  std::optional<Number> listCount; ///< Set for a list: the type of its length.
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

std::optional<Number> numberType(std::string_view word) {
  struct Spelling {
    std::string_view word;
    Number type;
  };
  constexpr std::array<Spelling, 16> spellings{{{"char", Number::int8},
                                                {"int8", Number::int8},
                                                {"uchar", Number::uint8},
                                                {"uint8", Number::uint8},
                                                {"short", Number::int16},
                                                {"int16", Number::int16},
                                                {"ushort", Number::uint16},
                                                {"uint16", Number::uint16},
                                                {"int", Number::int32},
                                                {"int32", Number::int32},
                                                {"uint", Number::uint32},
                                                {"uint32", Number::uint32},
                                                {"float", Number::float32},
                                                {"float32", Number::float32},
                                                {"double", Number::float64},
                                                {"float64", Number::float64}}};
  const auto* const found =
      std::ranges::find_if(spellings, [&](const Spelling& spelling) { return spelling.word == word; });
  return found == spellings.end() ? std::nullopt : std::optional(found->type);
}

bool parseProperty(std::string_view words, Element& element) {
  Property property;
  std::string_view type = nextWord(words);
  if (type == "list") {
    property.listCount = numberType(nextWord(words));
    if (!property.listCount) {
      return false;
    }
    type = nextWord(words);
  }
  const auto number = numberType(type);
  property.name = std::string(nextWord(words));
  property.type = number.value_or(Number::float32);
  element.properties.push_back(property);
  return number.has_value() && !element.properties.back().name.empty();
}

bool parseFormat(std::string_view word, Encoding& encoding) {
  if (word == "ascii") {
    encoding = Encoding::ascii;
  } else if (word == "binary_little_endian") {
    encoding = Encoding::littleEndian;
  } else if (word == "binary_big_endian") {
    encoding = Encoding::bigEndian;
  } else {
    return false;
  }
  return true;
}

/// Reads up to and including "end_header"; `bytes` is left at the data.
std::optional<Header> parseHeader(std::string_view& bytes) {
  Header header;
  std::string_view line;
  if (!nextLine(bytes, line) || line != "ply") {
    return std::nullopt;
  }
  bool understood = true;
  while (understood && nextLine(bytes, line)) {
    const std::string_view keyword = nextWord(line);
    if (keyword == "end_header") {
      return header;
    }
    if (keyword == "format") {
      understood = parseFormat(nextWord(line), header.encoding);
    } else if (keyword == "element") {
      const std::string name(nextWord(line));
      const auto count = parseNumber<long long>(nextWord(line));
      understood = count && *count >= 0;
      header.elements.push_back({name, understood ? static_cast<std::size_t>(*count) : 0, {}});
    } else if (keyword == "property") {
      understood = !header.elements.empty() && parseProperty(line, header.elements.back());
    }
  }
  return std::nullopt;
}

// Two lists of vertices would make one whose rows have different columns.
std::optional<std::string> describedTwice(const Header& header) {
  std::vector<std::string> names;
  std::ranges::transform(header.elements, std::back_inserter(names), &Element::name);
  std::ranges::sort(names);
  const auto twice = std::ranges::adjacent_find(names);
  return twice == names.end() ? std::nullopt : std::optional(*twice);
}

template <typename T>
std::optional<double> takeBinary(std::string_view& bytes, bool swap) {
  if (bytes.size() < sizeof(T)) {
    return std::nullopt;
  }
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), bytes.data(), sizeof(T));
  bytes.remove_prefix(sizeof(T));
  if (swap) {
    std::reverse(raw.begin(), raw.end());
  }
  return static_cast<double>(std::bit_cast<T>(raw));
}

/// Hands out the numbers of the data part one after the other.
class NumberReader {
public:
  NumberReader(std::string_view bytes, Encoding encoding) : bytes_(bytes), encoding_(encoding) {}

  std::optional<double> next(Number type) {
    if (encoding_ == Encoding::ascii) {
      return nextAscii();
    }
    const bool swap = (encoding_ == Encoding::bigEndian) == (std::endian::native == std::endian::little);
    switch (type) {
    case Number::int8:
      return takeBinary<std::int8_t>(bytes_, swap);
    case Number::uint8:
      return takeBinary<std::uint8_t>(bytes_, swap);
    case Number::int16:
      return takeBinary<std::int16_t>(bytes_, swap);
    case Number::uint16:
      return takeBinary<std::uint16_t>(bytes_, swap);
    case Number::int32:
      return takeBinary<std::int32_t>(bytes_, swap);
    case Number::uint32:
      return takeBinary<std::uint32_t>(bytes_, swap);
    case Number::float32:
      return takeBinary<float>(bytes_, swap);
    case Number::float64:
      break;
    }
    return takeBinary<double>(bytes_, swap);
  }

private:
  std::optional<double> nextAscii() {
    std::string_view word = nextWord(line_);
    while (word.empty()) {
      if (!nextLine(bytes_, line_)) {
        return std::nullopt;
      }
      word = nextWord(line_);
    }
    return parseNumber(word);
  }

  std::string_view bytes_;
  std::string_view line_;
  Encoding encoding_;
};

/// One property of one row; lists are returned whole. Empty when the data end or are no numbers.
std::optional<std::vector<double>> readProperty(NumberReader& reader, const Property& property) {
  constexpr double longestList = 1e6;
  double count = 1.0;
  if (property.listCount) {
    const auto length = reader.next(*property.listCount);
    if (!length || !(*length >= 0.0 && *length <= longestList)) {
      return std::nullopt;
    }
    count = *length;
  }
  std::vector<double> values;
  for (double i = 0.0; i < count; i += 1.0) {
    const auto value = reader.next(property.type);
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values;
}

bool addVertex(const Element& element, const std::vector<std::vector<double>>& row, MeshFile& mesh) {
  glm::vec3 position(0.0F);
  int found = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string& name = element.properties[i].name;
    const std::size_t axis = std::string_view("xyz").find(name);
    if (name.size() == 1 && axis != std::string_view::npos && row[i].size() == 1) {
      if (!(std::abs(row[i][0]) <= largestCoordinate)) {
        return false;
      }
      position[static_cast<glm::length_t>(axis)] = static_cast<float>(row[i][0]);
      ++found;
    }
  }
  mesh.positions.push_back(position);
  return found == 3;
}

/// What exporters call the parts of a vertex beyond its place.
struct VertexColumns {
  std::array<std::optional<std::size_t>, 3> normal;
  std::array<std::optional<std::size_t>, 2> texCoord;
  std::array<std::optional<std::size_t>, 4> color;
};

VertexColumns columnsOf(const Element& element) {
  const auto column = [&](std::initializer_list<std::string_view> names) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (!element.properties[i].listCount &&
          std::find(names.begin(), names.end(), element.properties[i].name) != names.end()) {
        return i;
      }
    }
    return std::nullopt;
  };
  return {{column({"nx"}), column({"ny"}), column({"nz"})},
          {column({"s", "u", "texture_u"}), column({"t", "v", "texture_v"})},
          {column({"red", "r"}), column({"green", "g"}), column({"blue", "b"}), column({"alpha", "a"})}};
}

/// A colour as linear light: integers stand for 0 to 1, red, green and blue encoded as sRGB.
glm::vec4 colorOf(const Element& element, const std::vector<std::vector<double>>& row,
                  const VertexColumns& columns) {
  glm::vec4 color(1.0F);
  for (std::size_t i = 0; i < 4; ++i) {
    if (!columns.color[i]) {
      continue;
    }
    const Number type = element.properties[*columns.color[i]].type;
    const double largest = type == Number::uint8 ? 255.0 : type == Number::uint16 ? 65535.0 : 1.0;
    const double part = row[*columns.color[i]][0] / largest;
    const double value = part > 0.0 ? std::min(part, 1.0) : 0.0; // No number is black.
    color[static_cast<glm::length_t>(i)] = static_cast<float>(i < 3 ? linearFromSrgb(value) : value);
  }
  return color;
}

void addLook(const Element& element, const std::vector<std::vector<double>>& row,
             const VertexColumns& columns, MeshFile& mesh) {
  const auto number = [&](const std::optional<std::size_t>& column) {
    const double value = row[*column][0];
    return std::abs(value) <= largestCoordinate ? static_cast<float>(value) : 0.0F;
  };
  if (columns.normal[0] && columns.normal[1] && columns.normal[2]) {
    const glm::vec3 normal(number(columns.normal[0]), number(columns.normal[1]), number(columns.normal[2]));
    const float length = glm::length(normal);
    mesh.normals.push_back(length > 0.0F ? normal / length : glm::vec3(0.0F, 1.0F, 0.0F));
  }
  if (columns.texCoord[0] && columns.texCoord[1]) {
    mesh.texCoords.emplace_back(number(columns.texCoord[0]), number(columns.texCoord[1]));
  }
  if (columns.color[0] && columns.color[1] && columns.color[2]) {
    mesh.colors.push_back(colorOf(element, row, columns));
  }
}

bool addFace(const Element& element, const std::vector<std::vector<double>>& row, MeshFile& mesh) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!element.properties[i].listCount || element.properties[i].name.rfind("vertex_ind", 0) != 0) {
      continue;
    }
    for (const double corner : row[i]) {
      if (!(corner >= 0.0 && corner < static_cast<double>(mesh.positions.size()))) {
        return false;
      }
      mesh.polygons.corners.push_back(static_cast<std::uint32_t>(corner));
    }
    mesh.polygons.ends.push_back(mesh.polygons.corners.size());
    return row[i].size() >= 3;
  }
  return false;
}

Status readElement(NumberReader& reader, const Element& element, MeshFile& mesh, std::string_view name) {
  const VertexColumns columns = columnsOf(element);
  for (std::size_t i = 0; i < element.count; ++i) {
    const std::string place = std::string(name) + ", " + element.name + " " + std::to_string(i);
    std::vector<std::vector<double>> row;
    for (const Property& property : element.properties) {
      auto values = readProperty(reader, property);
      if (!values) {
        return Error{"the data end early or hold something that is not a number", place,
                     "export the frame again"};
      }
      row.push_back(std::move(*values));
    }
    if (element.name == "vertex" && !addVertex(element, row, mesh)) {
      return Error{"a vertex needs finite x, y and z", place, "export the frame again"};
    }
    if (element.name == "vertex") {
      addLook(element, row, columns, mesh);
    }
    if (element.name == "face" && !addFace(element, row, mesh)) {
      return Error{"a face needs three or more corners that exist", place, "export the frame again"};
    }
  }
  return Success{};
}

} // namespace

Result<MeshFile> parsePly(std::string_view bytes, std::string_view name) {
  const auto header = parseHeader(bytes);
  if (!header) {
    return Error{"the PLY header is not understood", std::string(name),
                 "export the frame as ascii or binary PLY 1.0"};
  }
  if (const std::optional<std::string> twice = describedTwice(*header)) {
    return Error{"the header describes element '" + *twice + "' twice", std::string(name),
                 "export the frame again"};
  }
  MeshFile mesh;
  NumberReader reader(bytes, header->encoding);
  for (const Element& element : header->elements) {
    if (element.properties.empty() && element.count > 0) {
      return Error{"element '" + element.name + "' has no properties", std::string(name),
                   "export the frame again"};
    }
    const auto done = readElement(reader, element, mesh, name);
    if (!done) {
      return done.error();
    }
  }
  if (mesh.polygons.ends.empty()) {
    return Error{"the file holds no faces", std::string(name), "give a mesh with triangles or polygons"};
  }
  cutIntoTriangles(mesh);
  return mesh;
}

} // namespace stretch::skinning
