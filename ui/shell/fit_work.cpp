#include "ui/shell/fit_work.h"

#include <utility>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "ui/shell/shell.h"

namespace stretch::ui {

namespace {

Status startFitting(Shell& shell, const std::string& label, const std::string& plan) {
  const app::Document& document = shell.open.character()->document();
  shell.beside.fitting.scene = document.scene;
  shell.beside.fitting.label = label;
  shell.beside.fitting.job =
      std::make_unique<app::Job<app::FittedLocators>>([document, plan](const skinning::Proceed& proceed) {
        return app::fitLocators(document, plan, proceed);
      });
  return Success{};
}

bool canStop(const Shell& shell) {
  const app::SequenceSession* const sequence = shell.open.sequence();
  return shell.beside.fitting.job != nullptr || shell.beside.binding.job != nullptr ||
         shell.beside.clipImport.job != nullptr || shell.beside.film.job != nullptr ||
         (sequence != nullptr && sequence->isWorking());
}

Status stop(Shell& shell) {
  const auto cancel = [](auto& job) {
    if (job != nullptr) {
      job->cancel();
    }
  };
  cancel(shell.beside.fitting.job);
  cancel(shell.beside.binding.job);
  cancel(shell.beside.clipImport.job);
  cancel(shell.beside.film.job);
  if (shell.open.sequence() != nullptr) {
    shell.open.sequence()->cancelWork();
  }
  tell(shell, ToastKind::info, "Stopped: nothing was changed");
  return Success{};
}

} // namespace

void fitBesideWindow(std::vector<app::Command<Shell>>& commands) {
  for (app::Command<Shell>& fit : commands) {
    const bool isReset = fit.id == app::command::locatorsReset;
    if (!isReset && !fit.id.starts_with(app::command::locatorsFit)) {
      continue;
    }
    const std::string label = isReset ? "Reset the locators" : "Fit locators";
    fit.enabled = [enabled = fit.enabled](const Shell& shell) {
      return shell.beside.fitting.job == nullptr && enabled(shell);
    };
    fit.run = [label, id = fit.id, run = fit.run](Shell& shell) {
      const app::Session* const session = shell.open.character();
      return session != nullptr && app::isMeshAlone(*session)
                 ? startFitting(shell, label, app::planToFit(*session, id))
                 : run(shell);
    };
  }
}

void updateFitting(Shell& shell) {
  FitWork& work = shell.beside.fitting;
  app::Session* const session = shell.open.character();
  if (work.job == nullptr || !work.job->isFinished() || (session != nullptr && session->isDragging())) {
    return;
  }
  const bool isStopped = work.job->isCancelled();
  Result<app::FittedLocators> fitted = work.job->take();
  const FitWork done = std::exchange(work, {});
  if (isStopped || session == nullptr || session->document().scene != done.scene) {
    return; // another file, or another step of the history, is shown by now
  }
  if (!fitted) {
    tellProblem(shell, fitted.error());
    return;
  }
  app::takeLocators(*session, std::move(fitted->locators), done.label);
  for (const std::string& warning : fitted->warnings) {
    tell(shell, ToastKind::warning, warning);
  }
}

std::vector<app::Command<Shell>> stopCommands() {
  app::Command<Shell> command;
  command.id = app::command::workStop;
  command.label = "Stop what is in progress";
  command.help =
      "Ends binding, fitting locators, importing a clip, drawing a video, compressing or exporting before "
      "it is done; what is open stays as it is.";
  command.keys = {"Esc"};
  command.enabled = canStop;
  command.run = stop;
  command.needs = [](const Shell&) -> std::string { return "nothing is in progress"; };
  return {command};
}

} // namespace stretch::ui
