#pragma once

#include <memory>
#include <vector>

#include "app/bind/bind_mesh.h"
#include "app/commands/table/command.h"
#include "app/sequence/job.h"

namespace stretch::ui {

struct Shell;

/// A binding that is made beside the window.
struct BindWork {
  std::unique_ptr<app::Job<app::BoundMeshes>> job; ///< Null: none is being made.
  app::Document from;                              ///< Document that it was started with.
};

/// Once per frame: takes up a binding that is finished, as one edit.
void updateBinding(Shell& shell);

[[nodiscard]] std::vector<app::Command<Shell>> bindCommands();

} // namespace stretch::ui
