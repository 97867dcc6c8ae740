#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "core/base/file.h"
#include "core/base/lower_case.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/json_text.h"
#include "core/gltf/source/problems.h"
#include "core/gltf/source/uri.h"

namespace stretch::gltf {

namespace {

namespace fs = std::filesystem;

bool isSameFolder(const fs::path& a, const fs::path& b) {
  const auto absolute = [](const fs::path& folder) {
    return fs::weakly_canonical(folder.empty() ? "." : folder);
  };
  return absolute(a) == absolute(b);
}

// What a save writes, in this order, and what it takes away when all of it is in its place.
struct SavePlan {
  std::vector<OutputFile> files;
  std::vector<fs::path> bridges;
};

// A name beside `file` that nothing has.
fs::path bridgeOf(const fs::path& file) {
  for (int number = 0;; ++number) {
    fs::path name = file;
    name.replace_extension();
    name += number == 0 ? ".saving.bin" : fmt::format(".saving-{}.bin", number);
    std::error_code ignored;
    if (!fs::exists(name, ignored)) {
      return name;
    }
  }
}

std::string uriOf(const fs::path& file) {
  const std::u8string text = file.filename().u8string();
  return percentEncoded(std::string(text.begin(), text.end()));
}

// Whether a buffer or an image holds its bytes as text, which may be most of the file: it is not copied.
bool isEmbedded(const Json& thing) {
  const Json* const uri = find(thing, "uri");
  return uri != nullptr && uri->is_string() && isDataUri(uri->get_ref<const std::string&>());
}

// The files that the glTF names by relative paths; of its buffers from `firstBuffer` on.
std::vector<fs::path> referencesOf(const Source& source, std::size_t firstBuffer = 0) {
  std::vector<fs::path> files;
  for (const char* list : {"buffers", "images"}) {
    for (std::size_t i = std::string(list) == "buffers" ? firstBuffer : 0; i < sizeOf(source.json, list);
         ++i) {
      const Json& thing = element(source.json, list, i);
      if (const auto relative = isEmbedded(thing) ? std::nullopt : relativePath(textOr(thing, "uri"))) {
        files.push_back(relative->lexically_normal());
      }
    }
  }
  return files;
}

// Likewise of a .gltf on the disk, whose buffers need not be read for that; none where there is no such file.
std::vector<fs::path> referencesOfFile(const fs::path& path) {
  if (lowerCase(path.extension().string()) != ".gltf") {
    return {};
  }
  const Result<std::string> text = readText(path);
  const Json json = text ? parseAnyJson(*text) : Json();
  if (!json.is_object()) {
    return {};
  }
  Source source;
  source.json = json;
  return referencesOf(source);
}

// The files of one save: the JSON gets its final form while buffers and images find their place.
class Saving {
public:
  Saving(Source source, const fs::path& path, bool isBinary)
      : source_(std::move(source)), path_(path), isBinary_(isBinary), referredTo_(referencesOf(source_)) {}

  Result<SavePlan> plan() {
    if (Status placed = placeBuffers(); !placed) {
      return placed.error();
    }
    if (Status copied = copyImages(); !copied) {
      return copied.error();
    }
    Result<OutputFile> main = isBinary_ ? binaryFile() : textFile();
    if (!main) {
      return main.error();
    }
    SavePlan plan;
    if (Status bridged = bridge(plan); !bridged) {
      return bridged.error();
    }
    std::move(files_.begin(), files_.end(), std::back_inserter(plan.files));
    plan.files.push_back(std::move(main.value()));
    return plan;
  }

private:
  // A .gltf and the buffers that are replaced with it cannot change at one moment. So the new buffers come
  // under names of their own first, then a .gltf that refers to those, and only then what it refers to in the
  // end: at every moment the .gltf that is there has its own buffers.
  Status bridge(SavePlan& plan) {
    std::error_code ignored;
    if (replaced_.empty() || !fs::exists(path_, ignored)) {
      return Success{};
    }
    Json bridged = json_;
    for (const auto& [buffer, file] : replaced_) {
      const fs::path name = bridgeOf(files_[file].path);
      bridged["buffers"][buffer]["uri"] = uriOf(name);
      plan.files.push_back({name, files_[file].bytes});
      plan.bridges.push_back(name);
    }
    std::swap(bridged, json_);
    Result<OutputFile> text = textFile();
    std::swap(bridged, json_);
    if (!text) {
      return text.error();
    }
    plan.files.push_back(std::move(text.value()));
    return Success{};
  }

  // The BIN chunk takes the first buffer; a chunk that was there without a buffer of its own keeps its place.
  [[nodiscard]] bool hasRoomInBinary() const {
    return isBinary_ && std::ranges::none_of(source_.otherChunks, [](const GlbChunk& chunk) {
             return chunk.type == GlbChunk::binaryType;
           });
  }

  [[nodiscard]] Bytes takenWithinLength(std::size_t buffer) {
    Bytes bytes = std::move(source_.buffers[buffer]);
    const auto length = static_cast<std::size_t>(wholeOr(element(json_, "buffers", buffer), "byteLength", 0));
    bytes.resize(std::min(length, bytes.size()));
    return bytes;
  }

  Status placeBuffers() {
    for (std::size_t i = 0; i < source_.buffers.size(); ++i) {
      if (Status placed = placeBuffer(i); !placed) {
        return placed;
      }
    }
    return Success{};
  }

  Status placeBuffer(std::size_t index) {
    const bool isText = isEmbedded(element(json_, "buffers", index));
    const std::string uri = isText ? std::string() : textOr(element(json_, "buffers", index), "uri");
    const bool isBinaryChunk = index == 0 && source_.hasBinaryChunk;
    if (index == 0 && hasRoomInBinary() && (isBinaryChunk || !source_.buffers[0].empty())) {
      hasBinary_ = true;
      binary_ = isBinaryChunk ? std::move(source_.buffers[0]) : takenWithinLength(0);
      json_["buffers"][0].erase("uri");
      return Success{};
    }
    if (source_.buffers[index].empty() || isText) {
      return Success{};
    }
    if (!uri.empty()) {
      return placeBeside(uri, source_.buffers[index], at("buffers", index));
    }
    const fs::path name = freeName(index);
    json_["buffers"][index]["uri"] = uriOf(name);
    std::error_code ignored;
    if (fs::exists(name, ignored)) {
      replaced_.emplace_back(index, files_.size());
    }
    files_.push_back({name, takenWithinLength(index)});
    return Success{};
  }

  // "OUT.bin", or a numbered name where that is the file of another: named by the source, or there before and
  // not named by the output that is written over.
  [[nodiscard]] fs::path freeName(std::size_t index) const {
    for (std::size_t number = index;; ++number) {
      fs::path name = path_;
      name.replace_extension();
      name += number == 0 ? ".bin" : fmt::format("_{}.bin", number);
      const bool isPlannedToo =
          std::ranges::any_of(files_, [&](const OutputFile& file) { return file.path == name; });
      std::error_code ignored;
      if (!isPlannedToo && !refersTo(name) && (!fs::exists(name, ignored) || isOfOutputAlone(name))) {
        return name;
      }
    }
  }

  // Whether the file that is written over names it, and the source is that file or does not.
  [[nodiscard]] bool isOfOutputAlone(const fs::path& name) const {
    const auto isNamedBy = [&](const fs::path& file) { // a source that is no .gltf is asked by refersTo
      return isSameFolder(file.parent_path(), name.parent_path()) &&
             std::ranges::count(referencesOfFile(file), name.filename()) > 0;
    };
    std::error_code ignored;
    return isNamedBy(path_) && (fs::equivalent(path_, source_.path, ignored) || !isNamedBy(source_.path));
  }

  [[nodiscard]] bool refersTo(const fs::path& file) const {
    if (!isSameFolder(source_.path.parent_path(), file.parent_path())) {
      return false;
    }
    return std::ranges::find(referredTo_, file.filename()) != referredTo_.end();
  }

  // The bytes of a file that the glTF refers to, put where the reference finds them.
  Status placeBeside(const std::string& uri, const Bytes& bytes, const std::string& where) {
    const std::optional<fs::path> relative = relativePath(uri);
    if (!relative) {
      return Success{}; // an absolute reference finds its file from anywhere
    }
    const fs::path target = path_.parent_path() / *relative;
    const Result<Bytes> present = readFile(target);
    if (present && *present == bytes) {
      return Success{};
    }
    if (present) {
      return Error{fmt::format("'{}' is already there with other content", target.string()), where,
                   "save into another folder"};
    }
    files_.push_back({target, bytes});
    return Success{};
  }

  // A reference that leaves the folder: its file is neither read nor copied, so it has to be found from here.
  [[nodiscard]] Status keepOutside(const fs::path& relative, const std::string& uri,
                                   const std::string& where) const {
    std::error_code ignored;
    const fs::path file = source_.path.parent_path() / relative;
    if (!fs::exists(file, ignored) || fs::equivalent(file, path_.parent_path() / relative, ignored)) {
      return Success{};
    }
    return Error{fmt::format("its file '{}' lies outside the folder of the output", uri), where,
                 "save beside the source"};
  }

  Status copyImages() {
    if (isSameFolder(source_.path.parent_path(), path_.parent_path())) {
      return Success{};
    }
    for (std::size_t i = 0; i < sizeOf(json_, "images"); ++i) {
      const std::string uri = textOr(element(json_, "images", i), "uri");
      const std::optional<fs::path> relative = relativePath(uri);
      if (relative && escapesFolder(*relative)) {
        if (Status kept = keepOutside(*relative, uri, at("images", i)); !kept) {
          return kept;
        }
        continue;
      }
      const Result<Bytes> bytes =
          relative ? readFile(source_.path.parent_path() / *relative) : Result<Bytes>(Error{});
      if (!bytes || isPlanned(path_.parent_path() / *relative)) {
        continue; // what the source does not have cannot be copied
      }
      if (Status placed = placeBeside(uri, *bytes, at("images", i)); !placed) {
        return placed;
      }
    }
    return Success{};
  }

  [[nodiscard]] bool isPlanned(const fs::path& path) const {
    return std::ranges::any_of(files_, [&](const OutputFile& file) { return file.path == path; });
  }

  [[nodiscard]] Result<std::string> jsonText(int indent) const {
    try {
      return json_.dump(indent);
    } catch (const Json::exception&) {
      return Error{"a name in it is not valid UTF-8", "JSON", "rename it"};
    }
  }

  [[nodiscard]] Result<OutputFile> textFile() const {
    constexpr int indent = 2;
    const Result<std::string> text = jsonText(indent);
    if (!text) {
      return text.error();
    }
    return OutputFile{path_, Bytes(text->begin(), text->end())};
  }

  [[nodiscard]] Result<OutputFile> binaryFile() {
    Result<std::string> text = jsonText(-1);
    if (!text) {
      return text.error();
    }
    Glb glb;
    glb.json = std::move(text.value());
    glb.hasBinary = hasBinary_;
    glb.binary = std::move(binary_);
    glb.others = std::move(source_.otherChunks);
    Result<std::vector<Bytes>> pieces = glbInPieces(std::move(glb));
    return pieces ? Result<OutputFile>(OutputFile{path_, {}, std::move(pieces.value())})
                  : Result<OutputFile>(pieces.error());
  }

  Source source_;
  const fs::path& path_;
  bool isBinary_;
  std::vector<fs::path> referredTo_;
  Json& json_ = source_.json;
  bool hasBinary_ = false;
  Bytes binary_;
  std::vector<OutputFile> files_;
  std::vector<std::pair<std::size_t, std::size_t>> replaced_; ///< Buffers and their places in `files_`.
};

} // namespace

std::vector<fs::path> filesBeside(const Source& source, const fs::path& path) {
  if (isSameFolder(source.path.parent_path(), path.parent_path())) {
    return {};
  }
  std::vector<fs::path> files = referencesOf(source, 1);
  std::erase_if(files, [&](const fs::path& file) {
    std::error_code ignored;
    return escapesFolder(file) || !fs::exists(source.path.parent_path() / file, ignored);
  });
  std::ranges::sort(files);
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

Status save(Source source, const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter;
  });
  const bool isText = extension == ".gltf";
  if (!isText && extension != ".glb" && extension != ".vrm" && extension != ".vrma") {
    return Error{"an output has to end in .glb or .gltf", path.string(), "give it such a name"};
  }
  std::error_code ignored;
  const fs::path folder = path.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored)) {
    return Error{"there is no such folder", folder.string(), "make it, or save elsewhere"};
  }
  try {
    const Result<SavePlan> plan = Saving(std::move(source), path, !isText).plan();
    if (!plan) {
      return plan.error();
    }
    Status written = writeFiles(plan->files, MissingFolder::isMade);
    for (const fs::path& bridge : plan->bridges) {
      fs::remove(bridge, ignored);
    }
    return written;
  } catch (const fs::filesystem_error&) {
    return Error{"cannot be written", path.string(), "check the path"};
  }
}

} // namespace stretch::gltf
