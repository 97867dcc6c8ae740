#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/commands/table/command.h"
#include "app/locators/fit_locators.h"
#include "app/sequence/job.h"

namespace stretch::ui {

struct Shell;

/// Locators that are fitted to a mesh beside the window.
struct FitWork {
  std::unique_ptr<app::Job<app::FittedLocators>> job; ///< Null: none is being made.
  std::shared_ptr<const Scene> scene;                 ///< That they are fitted to.
  std::string label;                                  ///< Label of the step that takes them up.
};

/// Lets the commands that fit locators work beside the window where there is a mesh alone.
void fitBesideWindow(std::vector<app::Command<Shell>>& commands);

/// Once per frame: takes up locators that are found, as one edit.
void updateFitting(Shell& shell);

/// "Stop": what is bound, fitted or imported. What it would have changed is left as it is.
[[nodiscard]] std::vector<app::Command<Shell>> stopCommands();

} // namespace stretch::ui
