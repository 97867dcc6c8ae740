#include "app/files/user_poses.h"

#include <algorithm>
#include <utility>

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
           false, [](const SeenController& seen) { return seen.fromBase.has_value(); }}};
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

Result<LibraryPose> poseOf(const Json& json) {
  PoseFile file;
  if (const Status read = readEntry(json, poseSchema(), unknownKey, file); !read) {
    return read.error();
  }
  if (file.version != poseVersion) {
    return Error{"this program does not know this version of a pose", "version",
                 "open it with the program that wrote it"};
  }
  if (file.name.empty() || file.pose.controllers.empty()) {
    return Error{"has no name, or no controller", file.name.empty() ? "name" : "controllers",
                 "keep the pose again"};
  }
  const double length = glm::length(file.pose.leftOnItsWay);
  if (!(length > 0.0)) {
    return Error{"is no direction", "left_on_its_way", "give a vector that is not zero"};
  }
  file.pose.leftOnItsWay /= length;
  return LibraryPose{file.name, file.pose};
}

bool hasPose(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  return fs::exists(fileOfName(folder, name), ignored);
}

} // namespace

Result<LibraryPose> loadPose(const fs::path& path) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return text.error();
  }
  const Result<Json> json = gltf::parseHandwrittenJson(*text, "give a pose, as the editor keeps it");
  Result<LibraryPose> pose = json ? poseOf(*json) : Result<LibraryPose>(json.error());
  return pose ? pose : Result<LibraryPose>(inFile(pose.error(), path));
}

Status savePose(const LibraryPose& pose, const fs::path& path) {
  return writeText(path,
                   writeEntry(poseSchema(), PoseFile{poseVersion, pose.name, pose.pose}).dump(2) + "\n");
}

fs::path posesFolder() {
  return configFolder() / "poses";
}

fs::path pictureOfPose(const fs::path& folder, const std::string& name) {
  return fileOfName(folder, name).replace_extension(".png");
}

std::vector<LibraryPose> userPoses(const fs::path& folder) {
  std::vector<LibraryPose> poses;
  for (const fs::path& file : jsonFilesIn(folder)) {
    if (Result<LibraryPose> pose = loadPose(file)) {
      poses.push_back(std::move(*pose));
    }
  }
  std::ranges::sort(poses, {}, &LibraryPose::name);
  return poses;
}

Status renamePose(const fs::path& folder, const LibraryPose& pose, const std::string& newName) {
  if (newName.empty() || hasPose(folder, newName)) {
    return Error{newName.empty() ? "a pose needs a name" : "another pose is called '" + newName + "'", "",
                 "give a name that no other pose has"};
  }
  if (Status saved = savePose({newName, pose.pose}, fileOfName(folder, newName)); !saved) {
    return saved;
  }
  std::error_code ignored; // A pose may have no picture.
  fs::rename(pictureOfPose(folder, pose.name), pictureOfPose(folder, newName), ignored);
  removePose(folder, pose.name);
  return Success{};
}

void removePose(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  fs::remove(fileOfName(folder, name), ignored);
  fs::remove(pictureOfPose(folder, name), ignored);
}

Result<LibraryPose> findPose(const std::string& text, const fs::path& folder) {
  if (fs::path(text).extension() == ".json") {
    return loadPose(text);
  }
  const std::vector<LibraryPose> poses = userPoses(folder);
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
