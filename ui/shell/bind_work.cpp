#include "ui/shell/bind_work.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/locators/build_rig.h"
#include "skinning/linear_blend_skinning.h"
#include "ui/shell/shell.h"
#include "ui/shell/window/input.h"

namespace stretch::ui {

namespace {

bool isBinding(const Shell& shell) {
  return shell.beside.binding.job != nullptr;
}

bool hasBoundMesh(const Scene& scene) {
  return std::ranges::any_of(skinning::drawnMeshNodes(scene),
                             [&](NodeIndex node) { return scene.nodes[at(node)].skin >= 0; });
}

bool hasJoints(const app::Document& document) {
  return !document.scene->skins.empty() || document.body.hips.exists();
}

// Joints are made at the locators, or moved to them where they are there already.
app::BindRequest requestFor(const app::Document& document) {
  app::BindRequest request;
  const bool areAsked = !hasJoints(document) || app::areLocatorsMoved(document);
  if (areAsked && !document.locators.empty()) {
    request.locators = document.locators;
  }
  return request;
}

bool canBind(const Shell& shell) {
  const app::Session* const session = shell.open.character();
  return session != nullptr &&
         (isBinding(shell) || hasJoints(session->document()) || !session->document().locators.empty());
}

Status bindOrStop(Shell& shell) {
  BindWork& work = shell.beside.binding;
  if (isBinding(shell)) {
    work.job->cancel();
    return Success{};
  }
  work.from = shell.open.character()->document();
  work.job = std::make_unique<app::Job<app::BoundMeshes>>(
      [document = work.from, request = requestFor(work.from)](const skinning::Proceed& proceed) {
        return app::bindMeshes(document, request, proceed);
      });
  return Success{};
}

std::string replacedText(const Shell& shell) {
  const std::vector<app::Chord> chords = shell.keymap.chordsOf(command::undo);
  return fmt::format(". The weights that were there are replaced: Undo{} brings them back",
                     chords.empty() ? "" : " (" + shell.keyboard.chordText(chords.front()) + ")");
}

void takeUp(Shell& shell, const app::BoundMeshes& bound) {
  app::Session& session = *shell.open.character();
  const bool isAgain = hasBoundMesh(*session.document().scene);
  Result<app::Document> changed = app::withBoundMeshes(session.document(), bound);
  if (!changed) {
    tellProblem(shell, changed.error());
    return;
  }
  session.view().showLocators = false;
  app::selectLocators(session, {});
  session.edit(std::move(changed).value(), isAgain ? "Bind again" : "Bind");
  tell(shell, ToastKind::success,
       fmt::format("Bound: {} vertices follow {} joints{}", bound.report.vertices, bound.report.joints,
                   isAgain ? replacedText(shell) : ""));
  for (const std::string& warning : bound.report.warnings) {
    tell(shell, ToastKind::warning, warning);
  }
}

std::string bindLabel(const Shell& shell) {
  if (isBinding(shell)) {
    return "Stop binding";
  }
  const app::Session* const session = shell.open.character();
  return session != nullptr && hasBoundMesh(*session->document().scene) ? "Bind again" : "Bind";
}

} // namespace

void updateBinding(Shell& shell) {
  BindWork& work = shell.beside.binding;
  if (!isBinding(shell) || !work.job->isFinished()) {
    return;
  }
  const app::Session* const session = shell.open.character();
  if (session != nullptr && session->isDragging()) {
    return; // taken up when the drag is over
  }
  const bool isStopped = work.job->isCancelled();
  const Result<app::BoundMeshes> made = work.job->take();
  work.job.reset();
  const bool isOpen = session != nullptr && session->document().source == work.from.source;
  if (isStopped || !isOpen) {
    return; // another file, or another step of the history, is shown by now
  }
  if (!made) {
    tellProblem(shell, made.error());
    return;
  }
  takeUp(shell, *made);
}

std::vector<app::Command<Shell>> bindCommands() {
  app::Command<Shell> bind;
  bind.id = command::bindMesh;
  bind.label = "Bind";
  bind.help = "Makes the meshes follow the joints: weights by the way inside the body, beside the window. "
              "Weights that are there are replaced. The same again stops it.";
  bind.keys = {"Ctrl+B"};
  bind.enabled = canBind;
  bind.run = bindOrStop;
  bind.labelNow = bindLabel;
  bind.needs = [](const Shell& shell) -> std::string {
    return canBind(shell) ? "" : "open a character with joints or locators first";
  };
  return {bind};
}

} // namespace stretch::ui
