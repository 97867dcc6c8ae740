#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/files/file_facts.h"

namespace stretch::ui {

enum class FilePurpose {
  openModel,
  saveModel,
  exportClean,
  openRecipe,
  openProp,
  openClip,
  saveRecipe,
  openStyle,
  saveStyle,
  exportSequence,
  openModuli,
  saveModuli,
  openSkeleton,
  saveFilm,
  openReferenceImages,
  openReferenceSound
};

/// One row of a folder's listing.
struct FileEntry {
  std::string name;
  bool isFolder = false;
  std::uintmax_t bytes = 0;
};

/// To open: set `open`, `purpose`, and, where known, `folder` and `typed` (the proposed name); the rest as it
/// is here.
struct FileDialogState {
  bool open = false;
  FilePurpose purpose = FilePurpose::openModel;
  std::filesystem::path folder;
  std::string typed;                  ///< Name, path, or part of a name, as typed.
  int highlighted = -1;               ///< Row that the keys are on; -1 none.
  std::string message;                ///< Problem that stands in the way.
  std::string remark;                 ///< Tells what is going to be saved, where there is no message.
  bool confirmOverwrite = false;      ///< The file exists; saving once more replaces it.
  std::filesystem::path listedFolder; ///< Folder that `entries` lists.
  std::vector<FileEntry> entries;
  bool listsSequence = false;           ///< The listed folder can be opened as a mesh sequence.
  int type = 0;                         ///< Type of files that are shown: index into fileTypesOf().
  std::optional<std::string> newFolder; ///< Name of a folder to be made, while it is typed.
  std::filesystem::path factsPath;      ///< File that `facts` tells of.
  app::FileFacts facts;
  bool wasOpen = false; ///< In the frame before.
};

} // namespace stretch::ui
