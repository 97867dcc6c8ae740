#include <algorithm>
#include <utility>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/locators/build_rig.h"
#include "app/locators/fit_locators.h"
#include "app/locators/locator_edits.h"
#include "rig/plan/body_plan.h"

namespace stretch::app {

namespace {

bool hasShownLocators(const Session& session) {
  return showsLocators(session);
}

Status fitAnew(Session& session, const std::string& plan, const char* label) {
  Result<FittedLocators> fitted = fitLocators(session.document(), plan);
  if (!fitted) {
    return fitted.error();
  }
  takeLocators(session, std::move(fitted->locators), label);
  return Success{};
}

// Joints that nothing uses are taken away; others stay while their locators are shown.
Status showOrHide(Session& session) {
  ViewState& view = session.view();
  if (hasShownLocators(session) && areLocatorsMoved(session.document())) {
    return Error{"locators were moved away from their joints", "", "bind again, or reset them"};
  }
  if (hasShownLocators(session)) {
    selectLocators(session, {});
    view.showLocators = false;
    return Success{};
  }
  if (Result<Document> without = withoutRig(session.document())) {
    return finish(session, std::move(without), "Back to locators");
  }
  view.showLocators = true;
  return Success{};
}

std::string showOrHideLabel(const Session& session) {
  return isRigBuilt(session.document()) && hasShownLocators(session) ? "Hide the locators"
                                                                     : "Back to locators";
}

// Joints for a mesh without a skeleton; else the limbs go by the locators, which are done with then.
Status build(Session& session) {
  const Document& document = session.document();
  selectLocators(session, {});
  session.view().showLocators = false;
  if (!document.body.isBiped) {
    return finish(session, withRigAt(document, document.locators), "Build the rig");
  }
  Result<Document> corrected = withLimbsAt(document, document.locators);
  if (corrected) {
    corrected->locators = {};
  }
  return finish(session, std::move(corrected), "Correct the limbs");
}

Status snap(Session& session) {
  const std::vector<std::string> names = session.view().selection.locators();
  session.edit(snapLocators(session.document(), names, session.view().mirrorLocators), "Snap to the middle");
  return Success{};
}

std::string buildLabel(const Session& session) {
  return session.document().body.isBiped ? "Correct the limbs" : "Build rig";
}

DocumentCommand fitAsCommand(const rig::LocatorPlan& plan) {
  const std::string title = rig::planNamed(plan.id)->title;
  DocumentCommand command =
      entry(command::locatorsFitPrefix, "Fit locators of " + title,
            "Finds where the joints of " + title +
                " are in a mesh without a skeleton, whatever its shape looks like.",
            {}, {isMeshAlone, "the character has a skeleton"},
            [id = plan.id](Session& session) { return fitAnew(session, id, "Fit locators"); });
  command.id = command::locatorsFitPrefix + plan.id;
  command.checked = [id = plan.id](const Session& session) {
    return !session.document().locators.empty() && session.document().locators.plan == id;
  };
  return command;
}

} // namespace

bool isMeshAlone(const Session& session) {
  return !session.document().body.isBiped && session.document().scene->skins.empty();
}

std::string planToFit(const Session& session, const std::string& command) {
  const std::string prefix = command::locatorsFitPrefix;
  return command == command::locatorsReset ? session.document().locators.plan
         : command.starts_with(prefix)     ? command.substr(prefix.size())
                                           : std::string();
}

void takeLocators(Session& session, rig::Locators locators, const std::string& label) {
  selectLocators(session, {});
  Document changed = session.document();
  changed.locators = std::move(locators);
  session.view().showLocators = true;
  session.edit(std::move(changed), label);
}

std::vector<DocumentCommand> locatorCommands() {
  const Need shown{hasShownLocators, "fit locators first"};
  std::vector<DocumentCommand> commands{
      entry(command::locatorsFit, "Fit locators",
            "Finds where the joints are in a mesh without a skeleton, or shows them at the limbs of one.", {},
            {[](const Session& session) { return session.document().locators.empty(); },
             "locators are there already: reset them, or go back to them"},
            [](Session& session) { return fitAnew(session, {}, "Fit locators"); }),
      entry(command::locatorsReset, "Reset locators", "Forgets what was moved and fits the locators again.",
            {}, shown,
            [](Session& session) {
              return fitAnew(session, planToFit(session, command::locatorsReset), "Reset the locators");
            }),
      ticked(entry(command::locatorsMirror, "Mirror locators",
                   "What moves a locator moves its counterpart on the other side.", {}, shown,
                   doing([](Session& session) {
                     session.view().mirrorLocators = !session.view().mirrorLocators;
                   })),
             [](const Session& session) { return session.view().mirrorLocators; }),
      entry(command::locatorsSnap, "Snap to the middle",
            "Moves the selected locators across their bones to the middle of the mesh.", {},
            {[](const Session& session) {
               return hasShownLocators(session) && !session.view().selection.locators().empty();
             },
             "select a locator first"},
            snap),
      labelled(entry(command::rigBuild, "Build rig",
                     "Makes joints at the locators; where there is a skeleton its limbs go by them.", {},
                     {[](const Session& session) {
                        return hasShownLocators(session) && !isRigBuilt(session.document());
                      },
                      "fit locators first; where joints were made at them, bind again"},
                     build),
               buildLabel),
      labelled(
          entry(command::rigBack, "Back to locators",
                "Shows the locators again, to be moved and bound again; joints that nothing uses yet are "
                "taken away.",
                {},
                {[](const Session& session) { return isRigBuilt(session.document()); },
                 "no joints were made at locators"},
                showOrHide),
          showOrHideLabel),
  };
  for (const rig::LocatorPlan& plan : rig::locatorPlans()) {
    commands.push_back(fitAsCommand(plan));
  }
  return commands;
}

} // namespace stretch::app
