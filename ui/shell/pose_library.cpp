#include "ui/shell/pose_library.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "app/commands/pose/posing.h"
#include "app/commands/pose/seen_posing.h"
#include "app/commands/table/command_ids.h"
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
#include "ui/widgets/control.h"

namespace stretch::ui {

namespace {

constexpr int picturePixels = 192;

bool canBePosed(const Shell& shell) {
  return showsClip(shell) && !app::controllersOf(shell.open.character()->document()).controllers.empty();
}

bool hasChosenPose(const Shell& shell) {
  return shell.ui.body.library.open && shell.ui.body.library.chosen >= 0;
}

/// The list as the folder has it; the pose of this file is chosen.
void listPoses(Shell& shell, const std::filesystem::path& chosen) {
  PoseLibraryState& state = shell.ui.body.library;
  app::PoseFolder folder = app::posesIn(app::posesFolder());
  state.poses = std::move(folder.poses);
  state.refused = folder.refused.empty() ? "" : folder.refused.front();
  const auto found = std::ranges::find(state.poses, chosen, &app::LibraryPose::file);
  state.chosen = found == state.poses.end() ? -1 : static_cast<int>(found - state.poses.begin());
  state.typedName = state.chosen < 0 ? "" : found->name;
  state.reaches = false;
  state.remark.clear();
  state.deleteAsked = false;
  state.changed = true;
  state.scrolls = true;
  shell.beside.library.blendOf = -1;
  ++state.version;
}

void openLibrary(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  state.open = true;
  state.accepted = false;
  state.amount = 1.0;
  state.mirrored = false;
  shell.ui.time.timeline.playing = false; // A pose is for the frame that is seen.
  listPoses(shell, {});
  hideNews(shell.ui);
}

/// The character without what is tried on it, and with what was posed without a key before.
void takeOffPose(Shell& shell) {
  PoseLibraryWork& work = shell.beside.library;
  if (work.begun) {
    shell.open.character()->cancel();
    shell.open.character()->view().unkeyed = std::exchange(work.unkeyed, {});
  }
  work.begun = false;
  work.blend.reset();
  work.blendOf = -1;
}

/// Draws the character at the playhead beside the window, as it is seen there.
void drawPictureFor(Shell& shell, const std::filesystem::path& file) {
  app::Session& session = *shell.open.character();
  const app::ViewState& view = session.view();
  PictureOptions options;
  options.widthPixels = options.heightPixels = picturePixels;
  options.facingYawRadians = shell.viewport.look.facingYawRadians;
  shell.beside.library.pictureFile = file;
  shell.beside.library.picture =
      std::make_unique<app::Job<Image>>([document = session.posedDocument(), clip = view.clip,
                                         frame = view.frame, options](const skinning::Proceed&) {
        const auto motion = std::make_shared<const rig::MotionState>(app::prepareMotion(document, clip));
        CharacterLook look;
        look.trails = false;
        return renderSheet(*document.scene, picturesOfCharacter(document, motion, {frame}, look), options);
      });
}

Status keepPose(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  if (shell.beside.library.picture != nullptr || shell.beside.film.job != nullptr) {
    return Error{"another picture is still being drawn", "", "try again when it is done"};
  }
  const std::string name = app::freePoseName(app::posesFolder());
  const std::filesystem::path file = app::fileOfName(app::posesFolder(), name);
  app::Session& session = *shell.open.character();
  // Of selected controllers, and not of a limb's: a whole pose can be put on a limb later.
  const app::SeenPose seen = app::seenAtPlayhead(session, session.view().selection.controllers());
  if (Status saved = app::savePose({name, app::standardised(seen)}, file); !saved) {
    return saved;
  }
  drawPictureFor(shell, file);
  if (!state.open) {
    openLibrary(shell);
  }
  takeOffPose(shell);
  listPoses(shell, file);
  return Success{};
}

/// Deletes at the second press: there is no undo for it.
Status forgetPose(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  if (!std::exchange(state.deleteAsked, true)) {
    return Success{};
  }
  const app::LibraryPose pose = state.poses[static_cast<std::size_t>(state.chosen)];
  if (Status removed = app::removePose(pose); !removed) {
    return removed;
  }
  if (shell.beside.library.pictureFile == pose.file) {
    shell.beside.library.pictureFile.clear();
  }
  takeOffPose(shell);
  listPoses(shell, {});
  tell(shell, ToastKind::info, "The pose " + pose.name + " is deleted");
  return Success{};
}

/// The order of the list stays as it is until the library is opened again, so that nothing moves under the
/// mouse.
void renameChosen(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  state.renamed = false;
  if (state.chosen < 0) {
    return;
  }
  app::LibraryPose& pose = state.poses[static_cast<std::size_t>(state.chosen)];
  if (state.typedName == pose.name) {
    return;
  }
  const Result<std::filesystem::path> renamed = app::renamePose(pose, state.typedName);
  if (!renamed) {
    tellProblem(shell, renamed.error());
    state.typedName = pose.name;
    return;
  }
  if (shell.beside.library.pictureFile == pose.file) {
    shell.beside.library.pictureFile = *renamed;
  }
  pose.name = state.typedName;
  pose.file = *renamed;
  ++state.version;
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
  state.remark = blend ? app::missedText(session.document(), blend->missed) : blend.error().line();
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
    work.unkeyed = std::exchange(session.view().unkeyed, {});
  }
  tellProblem(shell, app::previewAsSeen(session, app::blended(*work.blend, state.amount)));
}

void takePosePicture(Shell& shell) {
  PoseLibraryWork& work = shell.beside.library;
  const Result<Image> made = work.picture->take();
  work.picture.reset();
  if (!made) {
    tellProblem(shell, made.error());
  } else if (!work.pictureFile.empty()) {
    tellProblem(shell, writePng(app::pictureOfPose(work.pictureFile), *made));
  }
  ++shell.ui.body.library.version;
}

/// Keeps what is tried as one step.
void acceptPose(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  state.accepted = false;
  if (state.changed) {
    tryPose(shell);
  }
  const std::string name = state.poses[static_cast<std::size_t>(state.chosen)].name;
  const std::optional<app::PoseBlend> blend = shell.beside.library.blend;
  takeOffPose(shell);
  if (blend) {
    app::Session& session = *shell.open.character();
    const Status taken =
        app::poseAsSeen(session, app::blended(*blend, state.amount), "Take the pose " + name);
    tellProblem(shell, taken);
    if (const std::string held = app::heldPoseText(session); taken && !held.empty()) {
      tell(shell, ToastKind::info, held);
    }
  }
}

} // namespace

void closePoseLibrary(Shell& shell) {
  takeOffPose(shell);
  shell.ui.body.library.open = false;
  shell.ui.body.library.chosen = -1;
}

void updatePoseLibrary(Shell& shell) {
  PoseLibraryState& state = shell.ui.body.library;
  PoseLibraryWork& work = shell.beside.library;
  if (work.picture != nullptr && work.picture->isFinished()) {
    takePosePicture(shell);
  }
  if (shell.open.character() == nullptr) {
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
    const Result<Image> image = readImage(app::pictureOfPose(pose.file));
    pictures.textures.push_back(image ? uploadPicture(*image) : GlTexture());
    state.pictures.push_back(textureOf(pictures.textures.back().name()));
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
                   "Takes the pose that is chosen in the library away, for good, at the second press.", {},
                   {hasChosenPose, "choose a pose in the library"}, forgetPose)};
}

} // namespace stretch::ui
