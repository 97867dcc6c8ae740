#include "app/files/user_poses.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/files/user_files.h"
#include "app/schema/entry_schema.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/json_text.h"

namespace stretch::app {

namespace {

namespace fs = std::filesystem;
using gltf::Json;

constexpr int poseVersion = 1;

/// What a file holds, in the order of its keys.
struct PoseFile {
  double version = 0.0;
  std::string name;
  SeenPose pose;
};

EntrySchema<SeenController> controllerSchema() {
  EntryMember<SeenController> turn = entryMember("turn", 1.0, &SeenController::turnWorld);
  turn.read = [](const Json& json, SeenController& seen) -> Status {
    if (Status read = readValue(json, "turn", 1.0, seen.turnWorld); !read) {
      return read;
    }
    const double length = glm::length(seen.turnWorld);
    seen.turnWorld = length > 0.0 ? seen.turnWorld / length : seen.turnWorld;
    return length > 0.0
               ? Status(Success{})
               : Status(Error{"is no turn", "turn", "give a quaternion x, y, z, w that is not zero"});
  };
  return {needed(entryMember("controller", 1.0, &SeenController::id)),
          needed(entryMember("place", 1.0, &SeenController::placeWorld)),
          needed(std::move(turn)),
          {"from_base", [](const SeenController& seen) { return entryValue(*seen.fromBase, 1.0); },
           [](const Json& json, SeenController& seen) {
             Vec3 fromBase(0.0);
             Status read = readValue(json, "from_base", 1.0, fromBase);
             seen.fromBase = fromBase;
             return read;
           },
           false, [](const SeenController& seen) { return seen.fromBase.has_value(); }},
          {"rest_height", [](const SeenController& seen) { return Json(*seen.restHeight); },
           [](const Json& json, SeenController& seen) {
             double height = 0.0;
             Status read = readValue(json, "rest_height", 1.0, height);
             seen.restHeight = height;
             return read;
           },
           false, [](const SeenController& seen) { return seen.restHeight.has_value(); }}};
}

EntrySchema<AttributeValue> valueSchema() {
  return {needed(entryMember("attribute", 1.0, &AttributeValue::id)),
          needed(entryMember("value", 1.0, &AttributeValue::value))};
}

Status unknownKey(const std::string& key) {
  return Error{"is not a part of a pose", key, "remove it, or correct its name"};
}

/// A list of entries, each described by a schema.
template <typename Entry>
EntryMember<PoseFile> listMember(const std::string& key, std::vector<Entry> SeenPose::*list,
                                 EntrySchema<Entry> (*schemaOf)()) {
  return {key,
          [=](const PoseFile& file) {
            Json json = Json::array();
            for (const Entry& entry : file.pose.*list) {
              json.push_back(writeEntry(schemaOf(), entry));
            }
            return json;
          },
          [=](const Json& json, PoseFile& file) -> Status {
            if (!json.is_array()) {
              return Error{"is not a list", key, keysOf(schemaOf())};
            }
            for (const Json& one : json) {
              Entry entry;
              if (Status read = readEntry(one, schemaOf(), unknownKey, entry); !read) {
                return read;
              }
              (file.pose.*list).push_back(std::move(entry));
            }
            return Success{};
          }};
}

EntrySchema<PoseFile> poseSchema() {
  return {needed(entryMember("version", 1.0, &PoseFile::version)),
          needed(entryMember("name", 1.0, &PoseFile::name)),
          entryMember("left_on_its_way", 1.0, &PoseFile::pose, &SeenPose::leftOnItsWay),
          needed(listMember("controllers", &SeenPose::controllers, controllerSchema)),
          listMember("values", &SeenPose::values, valueSchema)};
}

Error inFile(const Error& error, const fs::path& path) {
  return {error.what, error.where.empty() ? path.string() : path.string() + ": " + error.where, error.remedy};
}

Status checkName(const std::string& name) {
  constexpr std::size_t longest = 100; // bytes: a file's name has room for 255
  const bool isUsable = !name.empty() && name.size() <= longest && !name.ends_with(".json");
  return isUsable ? Status(Success{})
                  : Status(Error{name.empty() ? "a pose needs a name"
                                              : "'" + name.substr(0, longest) + "' is no name of a pose",
                                 "name", "give up to 100 bytes that do not end with .json"});
}

Result<LibraryPose> poseOf(const Json& json) {
  PoseFile file;
  const bool isLater = json.is_object() && json.contains("version") && json["version"].is_number() &&
                       json["version"] != poseVersion; // which may have other keys
  if (const Status read = readEntry(json, poseSchema(), unknownKey, file); !read && !isLater) {
    return read.error();
  }
  if (isLater) {
    return Error{"this program does not know this version of a pose", "version",
                 "open it with the program that wrote it"};
  }
  if (const Status named = checkName(file.name); !named) {
    return named.error();
  }
  if (file.pose.controllers.empty()) {
    return Error{"has no controller", "controllers", "keep the pose again"};
  }
  const double length = glm::length(file.pose.leftOnItsWay);
  if (!(length > 0.0)) {
    return Error{"is no direction", "left_on_its_way", "give a vector that is not zero"};
  }
  file.pose.leftOnItsWay /= length;
  return LibraryPose{file.name, file.pose};
}

} // namespace

Result<LibraryPose> loadPose(const fs::path& path) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return text.error();
  }
  const Result<Json> json = gltf::parseHandwrittenJson(*text, "give a pose, as the editor keeps it");
  Result<LibraryPose> pose = json ? poseOf(*json) : Result<LibraryPose>(json.error());
  if (!pose) {
    return inFile(pose.error(), path);
  }
  pose->file = path;
  return pose;
}

Status savePose(const LibraryPose& pose, const fs::path& path) {
  if (Status named = checkName(pose.name); !named) {
    return named;
  }
  return writeText(path,
                   writeEntry(poseSchema(), PoseFile{poseVersion, pose.name, pose.pose}).dump(2) + "\n");
}

fs::path posesFolder() {
  return configFolder() / "poses";
}

fs::path pictureOfPose(const fs::path& file) {
  return fs::path(file).replace_extension(".png");
}

PoseFolder posesIn(const fs::path& folder) {
  PoseFolder found;
  for (const fs::path& file : jsonFilesIn(folder)) {
    Result<LibraryPose> pose = loadPose(file);
    if (pose) {
      found.poses.push_back(std::move(*pose));
    } else {
      found.refused.push_back(pose.error().line());
    }
  }
  std::ranges::sort(found.poses, {}, &LibraryPose::name);
  std::ranges::sort(found.refused);
  return found;
}

std::string freePoseName(const fs::path& folder) {
  const std::vector<LibraryPose> poses = posesIn(folder).poses;
  const auto isTaken = [&](const std::string& name) {
    std::error_code ignored;
    return fs::exists(fileOfName(folder, name), ignored) ||
           std::ranges::find(poses, name, &LibraryPose::name) != poses.end();
  };
  std::string name = "Pose 1";
  for (int number = 2; isTaken(name); ++number) {
    name = fmt::format("Pose {}", number);
  }
  return name;
}

Result<fs::path> renamePose(const LibraryPose& pose, const std::string& newName) {
  const fs::path file = fileOfName(pose.file.parent_path(), newName);
  std::error_code ignored;
  const bool stays = fs::equivalent(file, pose.file, ignored);
  if (!stays && fs::exists(file, ignored)) {
    return Error{"'" + newName + "' would take the place of another pose", file.string(),
                 "give another name"};
  }
  if (const Status saved = savePose({newName, pose.pose}, file); !saved) {
    return saved.error();
  }
  if (stays) {
    return file;
  }
  fs::rename(pictureOfPose(pose.file), pictureOfPose(file), ignored); // A pose may have no picture.
  const Status removed = removePose(pose);
  return removed ? Result<fs::path>(file) : Result<fs::path>(removed.error());
}

Status removePose(const LibraryPose& pose) {
  std::error_code problem;
  fs::remove(pose.file, problem);
  if (problem) {
    return Error{"the pose cannot be removed: " + problem.message(), pose.file.string(),
                 "look at the rights of its folder"};
  }
  fs::remove(pictureOfPose(pose.file), problem); // It may have none.
  return Success{};
}

Result<LibraryPose> findPose(const std::string& text, const fs::path& folder) {
  if (fs::path(text).extension() == ".json") {
    return loadPose(text);
  }
  const std::vector<LibraryPose> poses = posesIn(folder).poses;
  const auto found = std::ranges::find(poses, text, &LibraryPose::name);
  if (found != poses.end()) {
    return *found;
  }
  std::string names;
  for (const LibraryPose& pose : poses) {
    names += (names.empty() ? "" : ", ") + pose.name;
  }
  return Error{"'" + text + "' is no pose of the library", "--pose",
               "give a file of a pose (.json)" + (names.empty() ? "" : ", or one of: " + names)};
}

} // namespace stretch::app
