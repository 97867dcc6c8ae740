#include "core/interchange/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace stretch::interchange {

namespace {

using namespace std::string_view_literals;

constexpr std::size_t lookedAt = 4096; // A head that comments may stand before.

std::string_view headOf(std::span<const std::uint8_t> bytes) {
  std::string_view head(reinterpret_cast<const char*>(bytes.data()), std::min(bytes.size(), lookedAt));
  return head.starts_with("\xEF\xBB\xBF") ? head.substr(3) : head;
}

std::string_view withoutBlanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

struct Kind {
  std::string_view start; // Bytes that it begins with, from `at` on.
  std::size_t at;
  std::string_view name;
  std::string_view remedy;
};

constexpr std::string_view unpack = "unpack it, and give the character in it";
constexpr std::string_view asPicture = "give the character that it belongs to (.glb, .gltf, .vrm, .fbx)";
constexpr std::string_view exportIt = "export it as .glb or .fbx from the program that made it";
constexpr std::string_view bindIt = "it has no joints and no clip: 'bind' gives it a skeleton, and a folder "
                                    "of such frames opens as a sequence";
constexpr std::string_view noCharacter =
    "give a character or a clip (.glb, .gltf, .vrm, .vrma, .fbx, .bvh, .dae)";

constexpr std::array kinds{
    Kind{"PK\x03\x04", 0, "a ZIP archive", unpack},
    Kind{"PK\x05\x06", 0, "an empty ZIP archive", unpack},
    Kind{"Rar!", 0, "a RAR archive", unpack},
    Kind{"7z\xBC\xAF\x27\x1C", 0, "a 7z archive", unpack},
    Kind{"\x1F\x8B", 0, "a file packed by gzip", unpack},
    Kind{"BZh", 0, "a file packed by bzip2", unpack},
    Kind{"\xFD"
         "7zXZ",
         0, "a file packed by xz", unpack},
    Kind{"\x28\xB5\x2F\xFD", 0, "a file packed by zstd, as Blender saves", exportIt},
    Kind{"ustar", 257, "a tar archive", unpack},
    Kind{"\x89PNG", 0, "a picture (PNG)", asPicture},
    Kind{"\xFF\xD8\xFF", 0, "a picture (JPEG)", asPicture},
    Kind{"GIF8", 0, "a picture (GIF)", asPicture},
    Kind{"WEBP", 8, "a picture (WebP)", asPicture},
    Kind{"8BPS", 0, "a picture (PSD)", asPicture},
    Kind{"II*\0"sv, 0, "a picture (TIFF)", asPicture},
    Kind{"MM\0*"sv, 0, "a picture (TIFF)", asPicture},
    Kind{"DDS ", 0, "a picture (DDS)", asPicture},
    Kind{"\xABKTX", 0, "a picture (KTX)", asPicture},
    Kind{"BM", 0, "a picture (BMP)", asPicture},
    Kind{"v/1\x01", 0, "a picture (EXR)", asPicture},
    Kind{"BLENDER", 0, "a scene of Blender", exportIt},
    Kind{"PXR-USDC", 0, "a scene in USD", exportIt},
    Kind{"#usda", 0, "a scene in USD", exportIt},
    Kind{"Ogawa", 0, "a cache of meshes (Alembic)", "export its frames as OBJ into a folder, and open that"},
    Kind{"//Maya ASCII", 0, "a scene of Maya", exportIt},
    Kind{"FOR4", 0, "a scene of Maya", exportIt},
    Kind{"FOR8", 0, "a scene of Maya", exportIt},
    Kind{"xof ", 0, "a mesh of DirectX (.x)", exportIt},
    Kind{"ply", 0, "a PLY mesh", bindIt},
    Kind{"solid ", 0, "an STL mesh", bindIt},
    Kind{"POINTCACHE2", 0, "a cache of points (PC2)", "open it together with its base mesh"},
    Kind{"%PDF", 0, "a PDF", noCharacter},
    Kind{"ftyp", 4, "a video", noCharacter},
    Kind{"\x1A\x45\xDF\xA3", 0, "a video", noCharacter},
    Kind{"RIFF", 0, "a sound or a video", noCharacter},
    Kind{"OggS", 0, "a sound or a video", noCharacter},
    Kind{"ID3", 0, "a sound", noCharacter},
    Kind{"\x7F"
         "ELF",
         0, "a program", noCharacter},
    Kind{"MZ", 0, "a program", noCharacter},
    Kind{"<!DOCTYPE html", 0, "a page of the web", "download the file that the page is about"},
    Kind{"<html", 0, "a page of the web", "download the file that the page is about"},
};

Error errorOf(std::string_view name, std::string_view remedy) {
  return {"is " + std::string(name) + ", no character", "", std::string(remedy)};
}

bool hasLine(std::string_view head, std::string_view start) {
  return head.starts_with(start) || head.find("\n" + std::string(start)) != std::string_view::npos;
}

bool isText(std::string_view head) {
  return std::ranges::none_of(head, [](unsigned char c) { return c < ' ' && std::isspace(c) == 0; });
}

} // namespace

std::string nameOf(Format format) {
  return format == Format::fbx ? "FBX" : format == Format::bvh ? "BVH" : "Collada";
}

std::optional<Format> formatOf(std::span<const std::uint8_t> bytes) {
  const std::string_view head = headOf(bytes);
  const std::string_view text = withoutBlanks(head);
  if (head.starts_with("Kaydara FBX Binary") ||
      (!text.starts_with('{') && text.find("FBXHeaderExtension") != std::string_view::npos)) {
    return Format::fbx;
  }
  if (text.starts_with("HIERARCHY")) {
    return Format::bvh;
  }
  return text.starts_with('<') && text.find("<COLLADA") != std::string_view::npos
             ? std::optional(Format::collada)
             : std::nullopt;
}

std::optional<Error> otherKind(std::span<const std::uint8_t> bytes) {
  const std::string_view head = headOf(bytes);
  const std::string_view text = withoutBlanks(head);
  const auto* const found = std::ranges::find_if(kinds, [&](const Kind& kind) {
    return head.size() >= kind.at && head.substr(kind.at).starts_with(kind.start);
  });
  if (found != kinds.end()) {
    return errorOf(found->name, found->remedy);
  }
  if (text.empty() || text.starts_with('{') || text.starts_with('[')) {
    return std::nullopt;
  }
  if (!isText(head)) {
    return errorOf("a file of a kind that is not known", noCharacter);
  }
  if (hasLine(head, "v ") && (hasLine(head, "f ") || hasLine(head, "vn ") || head.size() == lookedAt)) {
    return errorOf("an OBJ mesh", bindIt);
  }
  return errorOf(text.starts_with('<') ? "a text in XML" : "a text", noCharacter);
}

bool isForeignName(const std::string& extension) {
  constexpr std::array names{".fbx"sv, ".bvh"sv, ".dae"sv};
  return std::ranges::any_of(names, [&](std::string_view name) {
    return std::ranges::equal(extension, name, [](unsigned char a, char b) { return std::tolower(a) == b; });
  });
}

} // namespace stretch::interchange
