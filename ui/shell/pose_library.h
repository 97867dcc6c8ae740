#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/commands/pose/library_posing.h"
#include "app/commands/table/command.h"
#include "app/sequence/job.h"
#include "ui/panels/state/body_state.h"
#include "ui/render/gl/gl_objects.h"

namespace stretch::ui {

struct Shell;

/// A pose of the library that is tried on the character, and the picture of one that was kept.
struct PoseLibraryWork {
  std::optional<app::PoseBlend> blend;      ///< Way to the chosen pose; nothing where it cannot be taken.
  int blendOf = -1;                         ///< The pose that it leads to, of the list; -1: none.
  bool isMirrored = false;                  ///< And how.
  bool begun = false;                       ///< The session shows what comes of it.
  app::UnkeyedPose unkeyed;                 ///< Pose without a key from before that: not shown meanwhile.
  std::unique_ptr<app::Job<Image>> picture; ///< Null: none is being drawn.
  std::filesystem::path pictureFile;        ///< File of its pose; empty: the pose is gone.
};

/// Pictures of the library's poses on the graphics card.
struct PosePictures {
  std::vector<GlTexture> textures;
  std::uint64_t version = 0; ///< Version of the list that they show.
};

/// "Pose library", keeping a pose in it and deleting one.
[[nodiscard]] std::vector<app::Command<Shell>> poseLibraryCommands();

/// Takes off what is tried and closes the library: another file is about to be opened.
void closePoseLibrary(Shell& shell);

/// Once per frame: shows the chosen pose on the character, keeps or drops it as one step, renames.
void updatePoseLibrary(Shell& shell);

/// Loads the pictures anew after the list has changed. Needs the window's graphics context.
void updatePosePictures(PosePictures& pictures, PoseLibraryState& state);

} // namespace stretch::ui
