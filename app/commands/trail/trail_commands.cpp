#include <algorithm>
#include <utility>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/needs.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/commands/trail/applied.h"
#include "app/commands/trail/exaggerate.h"
#include "app/commands/trail/spheres.h"
#include "app/edits/trail/mirror_edits.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/edits/trail/trail_edits.h"

namespace stretch::app {

namespace {

bool hasTarget(const Session& session) {
  return !targetTrails(session).empty();
}
bool hasLimb(const Session& session) {
  return !session.view().selection.limbs().empty() && hasClip(session.document(), session.view().clip);
}
Error noTrail() {
  return {"no trail is selected", "", "select a limb and press T or E to make one"};
}

/// Runs an edit on every target trail, as one undo step.
template <typename Edit>
Status editTargets(Session& session, const char* label, Edit&& edit) {
  const std::vector<int> targets = targetTrails(session);
  if (targets.empty()) {
    return noTrail();
  }
  Document document = session.document();
  for (const int id : targets) {
    Result<Document> changed = edit(document, *findTrail(document, id));
    if (!changed) {
      return changed.error();
    }
    document = std::move(changed).value();
  }
  return finish(session, std::move(document), label);
}

template <typename Predicate>
bool allTargets(const Session& session, Predicate&& predicate) {
  const std::vector<int> targets = targetTrails(session);
  return std::ranges::all_of(targets, [&](int id) { return predicate(*findTrail(session.document(), id)); });
}

Status finishNew(Session& session, Result<ExaggerateTargets> made, const char* label) {
  if (!made) {
    return made.error();
  }
  session.edit(made->document, label);
  session.view().selection.dropSpheres();
  selectTrail(session, made->trailIds.front());
  return Success{};
}

bool makesTrail(const Session& session) {
  const ViewState& view = session.view();
  const bool newRange = selectedTrail(session) == nullptr && view.rangeEnd > view.rangeStart;
  return !hasTarget(session) || newRange;
}

bool isShown(const Session& session) {
  return hasTarget(session) && allTargets(session, [](const rig::Trail& trail) { return trail.visible; });
}

/// What the key of trails does now.
std::string toggleLabel(const Session& session) {
  return makesTrail(session) ? "Motion trail" : isShown(session) ? "Hide the trail" : "Show the trail";
}

Status toggleTrails(Session& session) {
  if (makesTrail(session)) {
    return finishNew(session, newTrails(session, false), "Make a trail");
  }
  const bool visible = isShown(session);
  return editTargets(session, visible ? "Hide the trail" : "Show the trail",
                     [&](const Document& document, const rig::Trail& trail) {
                       return setTrailDisplay(document, trail.id, {trail.colour, !visible, trail.pinned});
                     });
}

Status toggleConnected(Session& session) {
  const bool connected = allTargets(session, [](const rig::Trail& trail) { return trail.connected; });
  return editTargets(session, connected ? "Disconnect" : "Connect",
                     [&](const Document& document, const rig::Trail& trail) {
                       return setConnected(document, trail.id, !connected);
                     });
}

Status toggleFollow(Session& session) {
  const bool follow = allTargets(session, [](const rig::Trail& trail) { return trail.follow; });
  return editTargets(session, follow ? "Follow off" : "Follow on",
                     [&](const Document& document, const rig::Trail& trail) {
                       return setFollow(document, trail.id, !follow);
                     });
}

/// Exaggerated, half, original, and round again.
Status cycleBlend(Session& session) {
  const std::vector<int> targets = targetTrails(session);
  if (targets.empty()) {
    return noTrail();
  }
  const double blend = findTrail(session.document(), targets.front())->settings.blend;
  const double next = blend > 1.0 ? 1.0 : blend > 0.0 ? 0.0 : 2.0;
  return editTargets(session, "Blend", [&](const Document& document, const rig::Trail& trail) {
    return setBlend(document, trail.id, next);
  });
}

Status applyTargets(Session& session) {
  return editTargets(session, "Apply the new motion", [](const Document& document, const rig::Trail& trail) {
    return applyTrail(document, trail.id);
  });
}

/// What is disconnected stays out: that is how the artist keeps it aside.
Status applyAll(Session& session) {
  Document document = session.document();
  for (const int id : waitingTrails(session)) {
    Result<Document> applied = applyTrail(document, id);
    if (!applied) {
      return applied.error();
    }
    document = std::move(applied).value();
  }
  return finish(session, std::move(document), "Apply all trails");
}

/// Each trail goes on by one, so that those that stood apart stay apart.
Status nextColour(Session& session) {
  return editTargets(session, "Change the trail's colour",
                     [&](const Document& document, const rig::Trail& trail) {
                       const int colour = (trail.colour + 1) % dealtColours;
                       return setTrailDisplay(document, trail.id, {colour, trail.visible, trail.pinned});
                     });
}

Status deleteTargets(Session& session) {
  return editTargets(session, "Delete the trail", [](const Document& document, const rig::Trail& trail) {
    return deleteTrail(document, trail.id);
  });
}

Status deleteSelection(Session& session) {
  const rig::Trail* trail = selectedTrail(session);
  if (trail == nullptr || session.view().selection.spheres().empty()) {
    return deleteTargets(session);
  }
  return removeSelectedSpheres(session);
}

Status deleteAllOfLimbs(Session& session) {
  Document document = session.document();
  for (const std::string& limbId : session.view().selection.limbs()) {
    document = deleteTrailsOfLimb(document, limbId, session.view().clip);
  }
  return finish(session, std::move(document), "Delete all trails of the limb");
}

Status copySelected(Session& session) {
  const rig::Trail* trail = selectedTrail(session);
  if (trail == nullptr) {
    return noTrail();
  }
  session.view().copiedTrail = *trail;
  return Success{};
}

Status pasteOnLimbs(Session& session) {
  const ViewState& view = session.view();
  if (!view.copiedTrail || view.selection.limbs().empty()) {
    return Error{"there is nothing to paste, or no limb to paste it on", "",
                 "copy a trail with Ctrl+C, select a limb"};
  }
  Document document = session.document();
  int trailId = 0;
  for (const std::string& limbId : view.selection.limbs()) {
    Result<CreatedTrail> pasted = pasteTrail(document, *view.copiedTrail, limbId, view.clip);
    if (!pasted) {
      return pasted.error();
    }
    document = std::move(pasted->document);
    trailId = pasted->trailId;
  }
  session.edit(std::move(document), "Paste the trail");
  selectTrail(session, trailId);
  return Success{};
}

/// Each as it was before the command: trails of both sides change places.
Status mirrorTargets(Session& session) {
  return editTargets(session, "Mirror the trail",
                     [&](const Document& document, const rig::Trail& trail) -> Result<Document> {
                       Result<CreatedTrail> mirrored =
                           mirrorTrail(document, *findTrail(session.document(), trail.id));
                       if (!mirrored) {
                         return mirrored.error();
                       }
                       return std::move(mirrored->document);
                     });
}

Status exaggerateOnce(Session& session) {
  return finishNew(session, exaggerateTargets(session), "Exaggerate");
}

bool canPaste(const Session& session) {
  return session.view().copiedTrail && hasLimb(session);
}
bool canDelete(const Session& session) {
  return hasTarget(session) || !session.view().selection.spheres().empty();
}
bool isToBeApplied(const Session& session) {
  return hasTarget(session) && !allTargets(session, [](const rig::Trail& trail) { return trail.applied; });
}
bool isExaggerated(const Session& session) {
  return hasTarget(session) && allTargets(session, [](const rig::Trail& trail) { return trail.exaggerated; });
}
bool hasTrailsOfLimbs(const Session& session) {
  const std::vector<rig::Trail>& trails = session.document().trails;
  return std::any_of(trails.begin(), trails.end(), [&](const rig::Trail& trail) {
    return trail.clip == session.view().clip && isSelected(session, trail.limb);
  });
}
bool canMirror(const Session& session) {
  return hasTarget(session) && allTargets(session, [&](const rig::Trail& trail) {
           return static_cast<bool>(otherSide(session.document(), trail.limb));
         });
}
bool isConnected(const Session& session) {
  return hasTarget(session) && allTargets(session, [](const rig::Trail& trail) { return trail.connected; });
}
bool isFollowing(const Session& session) {
  return hasTarget(session) && allTargets(session, [](const rig::Trail& trail) { return trail.follow; });
}
/// "Blend: half-way", of the first trail.
std::string blendLabel(const Session& session) {
  const std::vector<int> targets = targetTrails(session);
  if (targets.empty()) {
    return "Blend";
  }
  const double blend = findTrail(session.document(), targets.front())->settings.blend;
  return blend > 1.0 ? "Blend: exaggerated" : blend > 0.0 ? "Blend: half-way" : "Blend: original";
}

std::vector<DocumentCommand> copyingCommands() {
  return {
      orElse(entry(command::copyTrail, "Copy trail",
                   "Copies the selected trail with its spheres; of selected controllers the pose.",
                   {"Ctrl+C"}, {hasSelectedTrail, "select a trail first"}, copySelected),
             command::poseCopy),
      orElse(entry(command::pasteTrail, "Paste trail",
                   "Pastes the copied trail on the selected limbs; without one the copied pose.", {"Ctrl+V"},
                   {canPaste, "copy a trail and select a limb first"}, pasteOnLimbs),
             command::posePaste),
      orElse(
          entry(command::mirrorTrail, "Mirror trail",
                "Makes the same trail on the other side of the body; of selected controllers the same pose.",
                {"Ctrl+M"}, {canMirror, "select a trail of an arm or a leg first"}, mirrorTargets),
          command::poseMirror),
  };
}

} // namespace

std::vector<DocumentCommand> trailCommands() {
  std::vector<DocumentCommand> commands{
      labelled(entry(command::trailToggle, "Motion trail",
                     "Makes a trail: the path of the limb's end over the range. Where there is one, hides or "
                     "shows it.",
                     {"T"}, limbNeeded(), toggleTrails),
               toggleLabel),
      entry(command::trailExaggerateOnce, "Exaggerate at 2",
            "Makes the trail if there is none, exaggerates it to twice the length and "
            "connects the limb.",
            {}, limbNeeded(), exaggerateOnce),
      labelled(entry(command::trailConnect, "Connect",
                     "Lets the limb follow the exaggerated trail; again lets it go.", {"C"}, targetNeeded(),
                     toggleConnected),
               [](const Session& session) -> std::string {
                 return isConnected(session) ? "Disconnect" : "Connect";
               }),
      ticked(entry(command::trailFollow, "Follow",
                   "The limb follows while its spheres are dragged, or waits until it is connected.",
                   {"Shift+C"}, targetNeeded(), toggleFollow),
             isFollowing),
      labelled(entry(command::trailBlend, "Blend",
                     "Goes on from exaggerated to half-way, to original, and round again.", {"B"},
                     {isExaggerated, "exaggerate the trail first"}, cycleBlend),
               blendLabel),
      entry(
          command::trailApply, "Apply new motion",
          "Re-keys the clip with the exaggerated motion and shows the new keys; the trail goes quiet, stays, "
          "and "
          "can be changed. Saving needs no Apply: what is connected is saved as it is seen.",
          {"Enter", "Numpad Enter"}, {isToBeApplied, "select a trail that is not applied yet"}, applyTargets),
      entry(command::trailApplyAll, "Apply all",
            "Applies every connected trail of the clip; disconnected ones stay as they are.",
            {"Ctrl+Enter", "Ctrl+Numpad Enter"},
            {[](const Session& session) { return !waitingTrails(session).empty(); },
             "no connected trail waits to be applied"},
            applyAll),
      entry(command::trailNextColour, "Next colour", "Gives each trail the next colour of the palette.", {},
            targetNeeded(), nextColour),
      orElse(entry(command::editDelete, "Delete",
                   "Takes the selected spheres away (the first and the last are put back); with none "
                   "selected deletes "
                   "the trail. Of selected controllers it takes the keys at the playhead.",
                   {"Delete"}, {canDelete, "select a trail or its spheres first"}, deleteSelection),
             command::poseDeleteKey),
      entry(command::trailDelete, "Delete trail",
            "Deletes the trail and gives its range back as the file had it.", {}, targetNeeded(),
            deleteTargets),
      entry(command::trailDeleteAll, "Delete all trails of the limb",
            "Deletes every trail of the selected limbs in this clip.", {"Shift+Delete"},
            {hasTrailsOfLimbs, "select a limb that has trails"}, deleteAllOfLimbs),
  };
  for (DocumentCommand& command : copyingCommands()) {
    commands.push_back(std::move(command));
  }
  return commands;
}

} // namespace stretch::app
