#pragma once

#include <memory>
#include <vector>

#include "app/bind/bind_mesh.h"
#include "app/commands/command.h"
#include "app/sequence/job.h"

namespace stretch::ui {

struct Shell;

/// A binding that is made beside the window, and what the last one began from: locators that were moved bind
/// that mesh again.
struct BindWork {
  std::unique_ptr<app::Job<app::BoundMeshes>> job; ///< Null: none is being made.
  app::Document from;                              ///< What it was started with.
  std::shared_ptr<const gltf::Source> bound;       ///< What was made last, of:
  std::shared_ptr<const gltf::Source> unbound;
  std::shared_ptr<const Scene> unboundScene;
};

/// Once per frame: takes up a binding that is finished, as one edit.
void updateBinding(Shell& shell);

[[nodiscard]] std::vector<app::Command<Shell>> bindCommands();

} // namespace stretch::ui
