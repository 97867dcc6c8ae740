#include "core/interchange/file_kind.h"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::interchange;
using namespace std::string_literals;

namespace {

std::vector<std::uint8_t> textBytes(const std::string& text) {
  return {text.begin(), text.end()};
}

std::string toldOf(const std::string& text) {
  const std::optional<Error> error = otherKind(textBytes(text));
  return error ? error->what : "";
}

std::string remedyFor(const std::string& text) {
  const std::optional<Error> error = otherKind(textBytes(text));
  return error ? error->remedy : "";
}

} // namespace

TEST_CASE("What is taken for a character is told by its first bytes") {
  const std::vector<std::pair<std::string, std::string>> kinds{
      {"PK\x03\x04 and more", "a ZIP archive"},
      {"PK\x05\x06", "an empty ZIP archive"},
      {"Rar!\x1A", "a RAR archive"},
      {"7z\xBC\xAF\x27\x1C", "a 7z archive"},
      {"\x1F\x8B\x08", "a file packed by gzip"},
      {"BZh9", "a file packed by bzip2"},
      {"\xFD" + "7zXZ"s, "a file packed by xz"},
      {"\x28\xB5\x2F\xFD", "a file packed by zstd, as Blender saves"},
      {std::string(257, 'a') + "ustar", "a tar archive"},
      {"\x89PNG\r\n", "a picture (PNG)"},
      {"\xFF\xD8\xFF\xE0", "a picture (JPEG)"},
      {"GIF89a", "a picture (GIF)"},
      {"RIFF\x10\x20\x30\x40WEBPVP8", "a picture (WebP)"},
      {"8BPS", "a picture (PSD)"},
      {"II*\0 "s, "a picture (TIFF)"},
      {"MM\0* "s, "a picture (TIFF)"},
      {"DDS |", "a picture (DDS)"},
      {"\xABKTX 20", "a picture (KTX)"},
      {"BM\x36", "a picture (BMP)"},
      {"v/1\x01", "a picture (EXR)"},
      {"BLENDER-v300", "a scene of Blender"},
      {"PXR-USDC", "a scene in USD"},
      {"#usda 1.0", "a scene in USD"},
      {"Ogawa\xFF", "a cache of meshes (Alembic)"},
      {"//Maya ASCII 2022", "a scene of Maya"},
      {"FOR4", "a scene of Maya"},
      {"FOR8", "a scene of Maya"},
      {"xof 0303txt", "a mesh of DirectX (.x)"},
      {"ply\nformat ascii", "a PLY mesh"},
      {"solid cube", "an STL mesh"},
      {"POINTCACHE2", "a cache of points (PC2)"},
      {"%PDF-1.7", "a PDF"},
      {"\x01\x02\x03\x20" + "ftypmp42"s, "a video"},
      {"\x1A\x45\xDF\xA3", "a video"},
      {"RIFF\x10\x20\x30\x40WAVE", "a sound or a video"},
      {"OggS", "a sound or a video"},
      {"ID3\x03", "a sound"},
      {"\x7F" + "ELF"s, "a program"},
      {"MZ\x90", "a program"},
      {"<!DOCTYPE html><p>", "a page of the web"},
      {"<html><body>", "a page of the web"},
  };
  for (const auto& [text, name] : kinds) {
    CAPTURE(name);
    CHECK(toldOf(text) == "is " + name + ", no character");
    CHECK_FALSE(remedyFor(text).empty());
    CHECK_FALSE(formatOf(textBytes(text)));
  }
  CHECK(remedyFor("Rar!\x1A") == "unpack it, and give the character in it");
  CHECK(remedyFor("solid cube").find("'bind' gives it a skeleton") != std::string::npos);
}

TEST_CASE("A text is a mesh where it has vertices with faces or normals, or is too long to tell") {
  CHECK(toldOf("# made\nv 1 2 3\nf 1 2 3\n") == "is an OBJ mesh, no character");
  CHECK(toldOf("v 1 2 3\nvn 0 1 0\n") == "is an OBJ mesh, no character");
  CHECK(toldOf("v 1 2 3\n") == "is a text, no character");
  CHECK(toldOf("f 1 2 3\n") == "is a text, no character");
  CHECK(toldOf("vertices: v 1 2 3, f 1\n") == "is a text, no character"); // not at the start of a line
  std::string vertices;
  while (vertices.size() < 5000) {
    vertices += "v 1 2 3\n";
  }
  CHECK(toldOf(vertices) == "is an OBJ mesh, no character");
  CHECK(toldOf("hello") == "is a text, no character");
  CHECK(toldOf("<scene>") == "is a text in XML, no character");
  CHECK(toldOf("\x01\x02 unknown") == "is a file of a kind that is not known, no character");
  CHECK(toldOf("\xEF\xBB\xBF#usda 1.0") == "is a scene in USD, no character"); // behind a byte order mark
  for (const char* const mayBe : {"", "  \n\t", "{\"asset\":", "  {", "[1]"}) {
    CAPTURE(mayBe);
    CHECK_FALSE(otherKind(textBytes(mayBe)));
  }
}

TEST_CASE("What may be used some other way says how: meshes, caches, pictures, scenes and pages") {
  const std::pair<std::string, std::string> remedies[] = {
      {"\x89PNG\r\n", "give the character that it belongs to"},
      {"8BPS", "give the character that it belongs to"},
      {"\x28\xB5\x2F\xFD", "export it as .glb or .fbx"},
      {"BLENDER-v300", "export it as .glb or .fbx"},
      {"FOR8", "export it as .glb or .fbx"},
      {"Ogawa\xFF", "export its frames as OBJ into a folder"},
      {"ply\nformat ascii", "'bind' gives it a skeleton"},
      {"solid cube", "'bind' gives it a skeleton"},
      {"v 1 2 3\nf 1 2 3\n", "'bind' gives it a skeleton"},
      {"POINTCACHE2", "open it together with its base mesh"},
      {"%PDF-1.7", "give a character or a clip"},
      {"OggS", "give a character or a clip"},
      {"<!DOCTYPE html><p>", "download the file that the page is about"},
      {"<html><body>", "download the file that the page is about"}};
  for (const auto& [text, remedy] : remedies) {
    CAPTURE(text);
    CHECK_THAT(remedyFor(text), Catch::Contains(remedy));
  }
}

TEST_CASE("Files of other programs are told by what they begin with, names by their ends") {
  CHECK(formatOf(textBytes("Kaydara FBX Binary  \x1A")) == Format::fbx);
  CHECK(formatOf(textBytes("; FBX 7.4.0\nFBXHeaderExtension: {")) == Format::fbx);
  CHECK_FALSE(formatOf(textBytes("{\"note\": \"FBXHeaderExtension\"}")));
  CHECK(formatOf(textBytes("\n HIERARCHY\nROOT Hips")) == Format::bvh);
  CHECK_FALSE(formatOf(textBytes("a HIERARCHY")));
  CHECK(formatOf(textBytes("<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">")) == Format::collada);
  CHECK_FALSE(formatOf(textBytes("<?xml version=\"1.0\"?><scene>")));
  CHECK_FALSE(formatOf(textBytes("text of <COLLADA")));
  CHECK_FALSE(formatOf({}));
  CHECK(nameOf(Format::fbx) == "FBX");
  CHECK(nameOf(Format::bvh) == "BVH");
  CHECK(nameOf(Format::collada) == "Collada");
  for (const char* const name : {".fbx", ".FBX", ".bvh", ".Bvh", ".dae"}) {
    CHECK(isForeignName(name));
  }
  for (const char* const name : {".glb", ".gltf", "", ".fb", ".fbxx", "fbx"}) {
    CHECK_FALSE(isForeignName(name));
  }
}
