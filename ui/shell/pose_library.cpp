#include "ui/shell/pose_library.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/commands/pose/posing.h"
#include "app/commands/pose/seen_posing.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/evaluate/evaluate.h"
#include "app/files/user_files.h"
#include "app/files/user_poses.h"
#include "app/named.h"
#include "ui/batch/sequence_pictures.h"
#include "ui/panels/context/panel_support.h"
#include "ui/render/gl/picture_texture.h"
#include "ui/render/picture/image_edits.h"
#include "ui/shell/shell_command.h"

namespace stretch::ui {

namespace {

constexpr int picturePixels = 192;

bool canBePosed(const Shell& shell) {
  return showsClip(shell) && !app::controllersOf(shell.open.character()->document()).controllers.empty();
}

bool hasChosenPose(const Shell& shell) {
  return shell.ui.body.library.open && shell.ui.body.library.chosen >= 0;
}

/// The list as the folder has it; the pose of this name is chosen.
void listPoses(PoseLibraryState& state, const std::string& chosen) {
  state.poses = app::userPoses(app::posesFolder());
  const auto found = std::ranges::find(state.poses, chosen, &app::LibraryPose::name);
  state.chosen = found == state.poses.end() ? -1 : static_cast<int>(found - state.poses.begin());
  state.typedName = state.chosen < 0 ? "" : chosen;
  state.reaches = false;
  state.remark.clear();
  state.changed = true;
  ++state.version;
}

void openLibrary(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  state.open = true;
  state.accepted = false;
  state.amount = 1.0;
  state.mirrored = false;
  listPoses(state, "");
  hideNews(shell.ui);
}

/// The character without what is tried on it.
void takeOffPose(Shell& shell) {
  PoseLibraryWork& work = shell.beside.library;
  if (work.begun) {
    shell.open.character()->cancel();
  }
  work.begun = false;
  work.blend.reset();
  work.blendOf = -1;
}

std::string freePoseName(const std::vector<app::LibraryPose>& poses) {
  std::string name = "Pose 1";
  for (int number = 2; std::ranges::find(poses, name, &app::LibraryPose::name) != poses.end(); ++number) {
    name = fmt::format("Pose {}", number);
  }
  return name;
}

/// Draws the character at the playhead beside the window, with what is posed there without a key.
void drawPictureOf(Shell& shell, const std::string& name) {
  app::Session& session = *shell.open.character();
  const app::ViewState& view = session.view();
  const std::filesystem::path path = app::pictureOfPose(app::posesFolder(), name);
  PictureOptions options;
  options.widthPixels = options.heightPixels = picturePixels;
  options.facingYawRadians = shell.viewport.look.facingYawRadians;
  shell.beside.library.picture = std::make_unique<app::Job<std::filesystem::path>>(
      [document = session.posedDocument(), clip = view.clip, frame = view.frame, options,
       path](const skinning::Proceed&) -> Result<std::filesystem::path> {
        const auto motion = std::make_shared<const rig::MotionState>(app::prepareMotion(document, clip));
        CharacterLook look;
        look.trails = false;
        const std::vector<PictureFrame> pictures = picturesOfCharacter(document, motion, {frame}, look);
        const Result<Image> image = renderSheet(*document.scene, pictures, options);
        const Status written = image ? writePng(path, *image) : Status(image.error());
        return written ? Result<std::filesystem::path>(path) : Result<std::filesystem::path>(written.error());
      });
}

Status keepPose(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  if (shell.beside.library.picture != nullptr) {
    return Error{"the picture of the last pose is still being drawn", "", "try again in a moment"};
  }
  if (!state.open) {
    openLibrary(shell);
  }
  takeOffPose(shell);
  const std::string name = freePoseName(state.poses);
  const app::SeenPose seen = app::seenAtPlayhead(*shell.open.character());
  if (Status saved =
          app::savePose({name, app::standardised(seen)}, app::fileOfName(app::posesFolder(), name));
      !saved) {
    return saved;
  }
  drawPictureOf(shell, name);
  listPoses(state, name);
  return Success{};
}

void forgetPose(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  const std::string name = state.poses[static_cast<std::size_t>(state.chosen)].name;
  takeOffPose(shell);
  app::removePose(app::posesFolder(), name);
  listPoses(state, "");
  tell(shell, ToastKind::info, "The pose " + name + " is deleted");
}

void renameChosen(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  state.renamed = false;
  if (state.chosen < 0) {
    return;
  }
  const app::LibraryPose pose = state.poses[static_cast<std::size_t>(state.chosen)];
  if (state.typedName == pose.name) {
    return;
  }
  const Status renamed = app::renamePose(app::posesFolder(), pose, state.typedName);
  tellProblem(shell, renamed);
  listPoses(state, renamed ? state.typedName : pose.name);
}

/// The way to the chosen pose from the character as it was when the library was opened.
void findWayToPose(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  PoseLibraryWork& work = shell.beside.library;
  takeOffPose(shell);
  app::Session& session = *shell.open.character();
  const app::SeenPose& pose = state.poses[static_cast<std::size_t>(state.chosen)].pose;
  Result<app::PoseBlend> blend =
      app::blendInto(session, state.mirrored ? app::mirroredPose(session.document(), pose) : pose);
  state.reaches = blend.ok();
  state.remark = blend ? app::missedText(session.document(), blend->missed) : blend.error().what;
  work.blend = blend ? std::optional(std::move(*blend)) : std::nullopt;
  work.blendOf = state.chosen;
  work.isMirrored = state.mirrored;
}

/// Shows the chosen pose as far as it is taken.
void tryPose(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  PoseLibraryWork& work = shell.beside.library;
  state.changed = false;
  if (state.chosen < 0) {
    takeOffPose(shell);
    return;
  }
  if (work.blendOf != state.chosen || work.isMirrored != state.mirrored) {
    findWayToPose(shell);
  }
  if (!work.blend) {
    return;
  }
  app::Session& session = *shell.open.character();
  if (!work.begun) {
    session.begin("Take a pose");
    work.begun = true;
  }
  tellProblem(shell, app::previewPose(session, app::blended(*work.blend, state.amount)));
}

void takePosePicture(Shell& shell) {
  PoseLibraryWork& work = shell.beside.library;
  const Result<std::filesystem::path> made = work.picture->take();
  work.picture.reset();
  if (!made) {
    tellProblem(shell, made.error());
  }
  ++shell.ui.body.library.version;
}

/// Keeps what is tried as one step.
void acceptPose(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  state.accepted = false;
  const std::string name = state.poses[static_cast<std::size_t>(state.chosen)].name;
  const std::optional<app::PoseBlend> blend = shell.beside.library.blend;
  takeOffPose(shell);
  if (blend) {
    tellProblem(shell, app::poseAll(*shell.open.character(), app::blended(*blend, state.amount),
                                    "Take the pose " + name));
  }
}

} // namespace

void updatePoseLibrary(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  PoseLibraryWork& work = shell.beside.library;
  if (work.picture != nullptr && work.picture->isFinished()) {
    takePosePicture(shell);
  }
  if (shell.open.character() == nullptr) {
    state.open = false;
    work.begun = false;
    work.blendOf = -1;
    return;
  }
  if (state.renamed) {
    renameChosen(shell);
  }
  if (state.accepted) {
    acceptPose(shell);
  } else if (!state.open) {
    takeOffPose(shell);
  } else if (state.changed) {
    tryPose(shell);
  }
}

void updatePosePictures(PosePictures& pictures, PoseLibraryState& state) {
  if (!state.open || pictures.version == state.version) {
    return;
  }
  pictures.version = state.version;
  pictures.textures.clear();
  state.pictures.clear();
  for (const app::LibraryPose& pose : state.poses) {
    const Result<Image> image = readPng(app::pictureOfPose(app::posesFolder(), pose.name));
    pictures.textures.push_back(image ? uploadPicture(*image) : GlTexture());
    // Dear ImGui holds OpenGL's name of a texture as a pointer.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    state.pictures.push_back(
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(pictures.textures.back().name())));
  }
}

std::vector<ShellCommand> poseLibraryCommands() {
  constexpr ShellNeed posableNeeded{canBePosed, "open a character that has controllers and a clip"};
  return {
      shellCommand(
          app::command::poseLibrary, "Pose library",
          "Shows the poses that you keep and brings the selected controllers, or the whole character, into "
          "one.",
          {}, posableNeeded, app::doing(openLibrary)),
      shellCommand(
          app::command::poseKeep, "Keep the pose in the library",
          "Keeps how the selected controllers are seen at the playhead, or the whole character, with a "
          "picture: for any character.",
          {}, posableNeeded, keepPose),
      shellCommand(app::command::poseForget, "Delete the pose from the library",
                   "Takes the pose that is chosen in the library away, for good.", {},
                   {hasChosenPose, "choose a pose in the library"}, app::doing(forgetPose))};
}

} // namespace stretch::ui
