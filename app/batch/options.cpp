#include "app/batch/options.h"

#include <cmath>

#include <fmt/core.h>

#include "app/schema/trail_description.h"
#include "core/base/file.h"
#include "core/base/number.h"

namespace stretch::app {

namespace {

std::string limbList(const Document& document) {
  std::string list;
  for (const rig::Limb& limb : document.biped.limbs) {
    list += (list.empty() ? "" : ", ") + limb.id;
  }
  return list.empty() ? "none was found" : list;
}

} // namespace

void addFileArguments(CommandLine& line, FileArguments& arguments) {
  line.option("FILE", arguments.file, "A .glb, .gltf or .vrm file").required();
  line.flag("--tolerant", arguments.tolerant,
            "Take a file that breaks the specification as well as it can be read");
}

void addFramesPerSecond(CommandLine& line, FileArguments& arguments) {
  line.option("--fps", arguments.framesPerSecond, "Frames per second; default: guessed from the keys")
      .positive();
}

Result<Document> openDocument(const FileArguments& arguments) {
  Result<Document> document =
      openDocument(arguments.file, arguments.tolerant ? gltf::Tolerance::warn : gltf::Tolerance::refuse);
  if (document && arguments.framesPerSecond > 0.0) {
    setFramesPerSecond(*document, arguments.framesPerSecond);
  }
  if (document || document.error().where == arguments.file) {
    return document;
  }
  Error error = document.error();
  error.where = arguments.file + (error.where.empty() ? "" : ": ") + error.where;
  return error;
}

Result<Vec2> rangeOf(const std::string& text, const Clip& clip) {
  const Result<Vec2> range = parseRange(text);
  const double last = std::round(clip.endSeconds * clip.framesPerSecond);
  if (range && (range->x > last || range->y < 0.0)) {
    return Error{fmt::format("{} lies outside the clip, which has the frames 0 to {:g}", text, last),
                 "--range", "give frames of the clip"};
  }
  return range;
}

Result<Vec2> parseRange(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) {
    return Error{"'" + text + "' is no range", "--range", "give the first and the last frame, such as 0:12"};
  }
  const Result<double> first = parseNumber(text.substr(0, colon), "--range");
  const Result<double> last = parseNumber(text.substr(colon + 1), "--range");
  if (!first || !last) {
    return first ? last.error() : first.error();
  }
  if (*first > *last) {
    return Error{"the first frame comes after the last", "--range", "give them in order"};
  }
  return Vec2(*first, *last);
}

Result<Vec3> parseVector(const std::string& text, const std::string& where) {
  Vec3 vector(0.0);
  std::size_t start = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? text.find(',', start) : text.size();
    if (comma == std::string::npos) {
      return Error{"'" + text + "' is no vector", where, "give three numbers, such as 0,-9.81,0"};
    }
    const Result<double> number = parseNumber(text.substr(start, comma - start), where);
    if (!number) {
      return number.error();
    }
    vector[i] = *number;
    start = comma + 1;
  }
  return vector;
}

Result<skinning::SegmentModuli> loadModuli(const std::string& path) {
  const Result<std::string> text = readText(path);
  return text ? skinning::parseModuli(*text) : Result<skinning::SegmentModuli>(text.error());
}

std::string clipList(const Document& document) {
  std::string list;
  for (std::size_t i = 0; i < document.clips->size(); ++i) {
    const std::string& name = (*document.clips)[i].name;
    list += (i == 0 ? "" : ", ") + (name.empty() ? fmt::format("#{}", i) : name);
  }
  return list;
}

Result<int> findClip(const Document& document, const std::string& text) {
  const std::vector<Clip>& clips = *document.clips;
  if (clips.empty()) {
    return Error{"the file holds no clip", "animations", "give a file with an animation"};
  }
  if (text.empty()) {
    return 0;
  }
  int found = -1;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (clips[i].name == text) {
      if (found >= 0) {
        return Error{"two clips are named '" + text + "'", "--clip",
                     fmt::format("name one by its number, such as #{}", found)};
      }
      found = static_cast<int>(i);
    }
  }
  if (found < 0 && text.front() == '#') {
    const auto index = stretch::parseNumber<std::size_t>(std::string_view(text).substr(1));
    found = index && *index < clips.size() ? static_cast<int>(*index) : -1;
  }
  if (found < 0) {
    return Error{"there is no clip '" + text + "'", "--clip", "the file has: " + clipList(document)};
  }
  return found;
}

Result<rig::Limb> findOrAddLimb(Document& document, const std::string& text) {
  if (const rig::Limb* limb = findLimb(document, text)) {
    return *limb;
  }
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    return Error{"there is no limb '" + text + "'", "--limb",
                 "limbs of this character: " + limbList(document) + "; any chain: JOINT_A..JOINT_B"};
  }
  Result<rig::Limb> chain = rig::chainLimb(*document.scene, text.substr(0, dots), text.substr(dots + 2));
  if (chain) {
    document.chains.push_back(*chain);
  }
  return chain;
}

} // namespace stretch::app
