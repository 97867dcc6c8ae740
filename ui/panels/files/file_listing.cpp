#include "ui/panels/files/file_listing.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "app/reference/image_series.h"
#include "app/reference/sound.h"
#include "core/base/lower_case.h"
#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

namespace {

namespace fs = std::filesystem;

bool comesBefore(const FileEntry& a, const FileEntry& b) {
  return a.isFolder != b.isFolder ? a.isFolder : lowerCase(a.name) < lowerCase(b.name);
}

} // namespace

bool hasExtension(const fs::path& path, const std::vector<std::string>& extensions) {
  const std::string extension = lowerCase(path.extension().string());
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

std::vector<FileType> fileTypesOf(FilePurpose purpose) {
  if (purpose != FilePurpose::openModel) {
    return {};
  }
  return {{"All", extensionsOf(purpose)},
          {"Characters", {".glb", ".gltf", ".vrm", ".vrma", ".fbx", ".bvh", ".dae"}},
          {"Sequences", {".obj", ".ply", ".pc2", ".mdd"}}};
}

std::vector<fs::path> recentFolders(const std::vector<fs::path>& recentFiles, std::size_t most) {
  std::vector<fs::path> folders;
  for (const fs::path& file : recentFiles) {
    const fs::path folder = file.parent_path();
    const bool isNew = std::find(folders.begin(), folders.end(), folder) == folders.end();
    if (isNew && !folder.empty() && folders.size() < most) {
      folders.push_back(folder);
    }
  }
  return folders;
}

std::vector<std::string> extensionsOf(FilePurpose purpose) {
  switch (purpose) {
  case FilePurpose::openModel:
    return {".glb", ".gltf", ".vrm", ".vrma", ".fbx", ".bvh", ".dae", ".pc2", ".mdd", ".obj", ".ply"};
  case FilePurpose::saveModel:
  case FilePurpose::exportClean:
  case FilePurpose::exportSequence:
  case FilePurpose::openProp:
    return {".glb", ".gltf"};
  case FilePurpose::openRecipe:
  case FilePurpose::saveRecipe:
  case FilePurpose::openStyle:
  case FilePurpose::saveStyle:
  case FilePurpose::openModuli:
  case FilePurpose::saveModuli:
    return {".json"};
  case FilePurpose::openSkeleton:
    return {".glb", ".gltf", ".vrm", ".fbx", ".bvh", ".dae"};
  case FilePurpose::openClip:
    return {".glb", ".gltf", ".vrm", ".vrma", ".fbx", ".bvh", ".dae"};
  case FilePurpose::saveFilm:
    return {".mp4", ".webm", ".gif", ".png"};
  case FilePurpose::openReferenceImages:
    return app::imageEndings();
  case FilePurpose::openReferenceSound:
    return app::soundEndings();
  }
  return {};
}

bool isSaving(FilePurpose purpose) {
  return purpose != FilePurpose::openModel && purpose != FilePurpose::openRecipe &&
         purpose != FilePurpose::openProp && purpose != FilePurpose::openClip &&
         purpose != FilePurpose::openStyle && purpose != FilePurpose::openModuli &&
         purpose != FilePurpose::openSkeleton && purpose != FilePurpose::openReferenceImages &&
         purpose != FilePurpose::openReferenceSound;
}

const char* titleOf(FilePurpose purpose) {
  switch (purpose) {
  case FilePurpose::openModel:
    return "Open a character or a mesh sequence";
  case FilePurpose::saveModel:
    return "Save as";
  case FilePurpose::exportClean:
    return "Export clean";
  case FilePurpose::openProp:
    return "Add a prop";
  case FilePurpose::openClip:
    return "Import a clip";
  case FilePurpose::openRecipe:
    return "Load a recipe";
  case FilePurpose::saveRecipe:
    return "Save the recipe";
  case FilePurpose::openStyle:
    return "Import a style";
  case FilePurpose::saveStyle:
    return "Export the style";
  case FilePurpose::exportSequence:
    return "Export the skinned clip";
  case FilePurpose::openModuli:
    return "Load moduli";
  case FilePurpose::saveModuli:
    return "Save moduli";
  case FilePurpose::openSkeleton:
    return "Take the bones of a file";
  case FilePurpose::saveFilm:
    return "Save a video or numbered pictures";
  case FilePurpose::openReferenceImages:
    return "Choose the first image";
  case FilePurpose::openReferenceSound:
    return "Choose a sound";
  }
  return "";
}

Result<std::vector<FileEntry>> listFolder(const fs::path& folder, FilePurpose purpose) {
  std::error_code problem;
  fs::directory_iterator iterator(folder, fs::directory_options::skip_permission_denied, problem);
  if (problem) {
    return Error{"the folder cannot be read (" + problem.message() + ")", folder.string(),
                 "choose another folder"};
  }
  const std::vector<std::string> extensions = extensionsOf(purpose);
  std::vector<FileEntry> entries;
  for (const fs::directory_iterator end; iterator != end && !problem; iterator.increment(problem)) {
    const fs::directory_entry& entry = *iterator;
    const std::string name = entry.path().filename().string();
    std::error_code ignored;
    const bool isFolder = entry.is_directory(ignored);
    if (name.empty() || name.front() == '.' || (!isFolder && !hasExtension(entry.path(), extensions))) {
      continue;
    }
    const std::uintmax_t bytes = isFolder ? 0 : entry.file_size(ignored);
    entries.push_back({name, isFolder, ignored ? 0 : bytes});
  }
  std::sort(entries.begin(), entries.end(), comesBefore);
  return entries;
}

fs::path typedPath(const fs::path& folder, const std::string& typed) {
  if (typed == "~" || typed.rfind("~/", 0) == 0) {
    return homeFolder() / fs::path(typed.size() > 2 ? typed.substr(2) : std::string());
  }
  return (folder / fs::path(typed)).lexically_normal();
}

fs::path homeFolder() {
  const char* home = std::getenv("HOME");
  return home != nullptr && home[0] != '\0' ? fs::path(home) : fs::path("/");
}

std::string sizeText(std::uintmax_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size >= 1e6) {
    return shortNumber(size / 1e6, 1) + " MB";
  }
  return size >= 1e3 ? shortNumber(size / 1e3, 0) + " kB" : shortNumber(size, 0) + " B";
}

fs::path withExtension(fs::path path, FilePurpose purpose) {
  const std::vector<std::string> extensions = extensionsOf(purpose);
  if (!extensions.empty() && !hasExtension(path, extensions)) {
    path += extensions.front();
  }
  return path;
}

} // namespace stretch::ui
