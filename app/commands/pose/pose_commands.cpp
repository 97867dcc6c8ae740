#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "app/commands/pose/posing.h"
#include "app/commands/pose/seen_posing.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/needs.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/pose_edits.h"

namespace stretch::app {

namespace {

bool hasPosable(const Session& session) {
  return hasControllers(session) && clipNeeded().holds(session);
}

bool hasAdjustments(const Session& session) {
  return !adjustedIds(session.document(), session.view().clip).empty() || !session.view().unkeyed.empty();
}

Need adjustmentsNeeded() {
  return {hasAdjustments, "nothing is offset in this clip"};
}

bool hasKeyHere(const Session& session) {
  const ViewState& view = session.view();
  return std::ranges::any_of(posedIds(session), [&](const std::string& id) {
    return offsetKeyAt(session.document(), view.clip, view.frame, id) != nullptr;
  });
}

Need keyHereNeeded() {
  return {hasKeyHere, "select a controller that has a key at the playhead"};
}

Status keySelected(Session& session) {
  ViewState& view = session.view();
  OffsetPose pose = shownPose(session, posedIds(session));
  // An attribute that nobody touched needs no key.
  std::erase_if(pose.values, [&](const AttributeValue& value) {
    return !view.unkeyed.values.contains(value.id) &&
           adjustmentAt(session.document(), view.clip, view.frame, value.id) == nullptr;
  });
  return keyPose(session, pose, poseLabel(session.document(), "Key", view.selection.controllers()));
}

Status deleteKeys(Session& session) {
  const ViewState& view = session.view();
  return finish(session, removeOffsetKeys(session.document(), view.clip, view.frame, posedIds(session)),
                poseLabel(session.document(), "Delete the key of", view.selection.controllers()).c_str());
}

void forgetUnkeyedOf(ViewState& view, const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    view.unkeyed.offsets.erase(id);
    view.unkeyed.values.erase(id);
  }
}

/// What is posed without a key goes first; then, with the step, what is keyed.
Status resetAt(Session& session, const std::vector<std::string>& ids, const std::string& label) {
  forgetUnkeyedOf(session.view(), ids);
  return finish(session, resetOffsets(session.document(), session.view().clip, session.view().frame, ids),
                label.c_str());
}

Status resetOver(Session& session, const std::vector<std::string>& ids, const std::string& label) {
  const int clip = session.view().clip;
  forgetUnkeyedOf(session.view(), ids);
  if (isRangeSet(session.view())) {
    return finish(session, resetOffsetsOver(session.document(), clip, shownRange(session), ids),
                  label.c_str());
  }
  Document document = session.document();
  for (const std::string& id : ids) {
    document = removeAdjustments(document, id, clip);
  }
  return finish(session, std::move(document), label.c_str());
}

std::vector<std::string> everyPosedId(const Session& session) {
  std::vector<std::string> ids = adjustedIds(session.document(), session.view().clip);
  for (const auto& [id, offset] : session.view().unkeyed.offsets) {
    ids.push_back(id);
  }
  for (const auto& [id, value] : session.view().unkeyed.values) {
    ids.push_back(id);
  }
  return ids;
}

Status resetSelected(Session& session) {
  return resetAt(session, posedIds(session),
                 poseLabel(session.document(), "Reset", session.view().selection.controllers()));
}

Status resetSelectedRange(Session& session) {
  return resetOver(session, posedIds(session),
                   poseLabel(session.document(), "Reset", session.view().selection.controllers()));
}

/// What is the same on both sides gets no key.
Status mirrorSelected(Session& session) {
  const ViewState& view = session.view();
  const Document& document = session.document();
  OffsetPose pose = shownPose(session, posedIds(session));
  std::erase_if(pose.values, [&](const AttributeValue& value) {
    const std::string other = otherSideOf(document, value.id);
    return other.empty() || shownValue(session, other) == value.value;
  });
  const Result<OffsetPose> mirrored = mirroredPose(document, view.clip, view.frame, pose);
  if (!mirrored) {
    return mirrored.error();
  }
  OffsetPose needed = *mirrored;
  std::erase_if(needed.offsets,
                [&](const ControllerOffset& offset) { return shownOffset(session, offset.id) == offset; });
  return poseAll(session, needed, poseLabel(document, "Mirror", view.selection.controllers()));
}

Error noneOfCopied() {
  return {"this character has none of the controllers that were copied", "",
          "copy a pose of controllers that it has"};
}

std::vector<std::string> idsOf(const std::vector<ControllerOffset>& offsets) {
  std::vector<std::string> ids;
  std::ranges::transform(offsets, std::back_inserter(ids), &ControllerOffset::id);
  return ids;
}

Status pasteSeen(Session& session, const SeenPose& pose, const char* verb) {
  if (std::ranges::none_of(pose.controllers, [&](const SeenController& seen) {
        return findController(session.document(), controllersOf(session.document()), seen.id).ok();
      })) {
    return noneOfCopied();
  }
  const Result<PosedAsSeen> posed = posedAsSeen(session, pose);
  if (!posed) {
    return posed.error();
  }
  if (posed->offsets.empty()) {
    return Error{"the character stands so already", "", "move the playhead, or copy another pose"};
  }
  return poseAsSeen(session, posed->offsets,
                    poseLabel(session.document(), verb, idsOf(posed->offsets.offsets)) +
                        (posed->missed.empty() ? "" : "; " + missedText(session.document(), posed->missed)));
}

/// By names; the attributes that are as they were on both sides get no key.
Status pasteOffsets(Session& session, const OffsetPose& copied) {
  const ViewState& view = session.view();
  OffsetPose pose = inWorldUnits(session.document(), copied);
  if (pose.empty()) {
    return noneOfCopied();
  }
  std::erase_if(pose.values,
                [&](const AttributeValue& value) { return shownValue(session, value.id) == value.value; });
  const std::string label = poseLabel(session.document(), "Paste the offsets on", idsOf(pose.offsets));
  std::erase_if(pose.offsets, [&](const ControllerOffset& offset) {
    return offset == ControllerOffset{offset.id, Vec3(0.0), Vec3(0.0)} &&
           adjustmentAt(session.document(), view.clip, view.frame, offset.id) == nullptr;
  });
  return poseAll(session, pose, label);
}

Status pastePose(Session& session) {
  const auto copied = *session.view().copiedPose;
  const SeenPose* const seen = std::get_if<SeenPose>(&copied);
  return seen != nullptr ? pasteSeen(session, *seen, "Paste the pose on")
                         : pasteOffsets(session, std::get<OffsetPose>(copied));
}

bool canPastePose(const Session& session) {
  return session.view().copiedPose && clipNeeded().holds(session);
}

bool canPasteMirrored(const Session& session) {
  return canPastePose(session) && std::holds_alternative<SeenPose>(*session.view().copiedPose);
}

bool canCopyPose(const Session& session) {
  return clipNeeded().holds(session) && !controllersOf(session.document()).controllers.empty();
}

std::vector<DocumentCommand> copyingCommands() {
  return {
      entry(command::poseCopy, "Copy the pose",
            "Copies how the selected controllers or limbs are seen at the playhead, whatever moves them; the "
            "whole character where none is selected.",
            {}, {canCopyPose, "open a character that has controllers"}, doing([](Session& session) {
              session.view().copiedPose = seenAtPlayhead(session, chosenControllers(session));
            })),
      entry(command::poseCopyOffsets, "Copy the offsets",
            "Copies what the selected controllers are offset by at the playhead.", {},
            {hasPosable, "select a controller first"}, doing([](Session& session) {
              session.view().copiedPose =
                  inLengths(session.document(), shownPose(session, posedIds(session)));
            })),
      entry(command::posePaste, "Paste the pose",
            "Poses the character at the playhead as it was copied; another character in proportion to its "
            "limbs. Copied offsets are set on the controllers of the same names.",
            {}, {canPastePose, "copy a pose first"}, pastePose),
      entry(command::posePasteMirrored, "Paste the pose mirrored",
            "Poses the character at the playhead as it was copied, with left and right exchanged.",
            {"Ctrl+Shift+V"}, {canPasteMirrored, "copy a pose first"},
            [](Session& session) {
              const SeenPose copied = std::get<SeenPose>(*session.view().copiedPose);
              return pasteSeen(session, mirroredPose(session.document(), copied), "Paste mirrored on");
            }),
  };
}

/// Curl of hands, roll of feet.
std::vector<rig::Attribute> bendsOf(const Session& session) {
  std::vector<rig::Attribute> bends = attributesOf(session, selectedControllers(session));
  std::erase_if(bends, [](const rig::Attribute& attribute) {
    return attribute.kind != rig::AttributeKind::curl && attribute.kind != rig::AttributeKind::roll;
  });
  return bends;
}

Status curl(Session& session, double step) {
  OffsetPose pose;
  std::vector<std::string> ids;
  for (const rig::Attribute& bend : bendsOf(session)) {
    const double value = std::round(10.0 * (shownValue(session, bend.id) + step)) / 10.0;
    pose.values.push_back({bend.id, std::clamp(value, bend.minimum, bend.maximum)});
    ids.push_back(bend.id);
  }
  return poseAll(session, pose, poseLabel(session.document(), "Change", ids));
}

Need bendNeeded() {
  return {[](const Session& session) { return hasPosable(session) && !bendsOf(session).empty(); },
          "select the controller of a hand with fingers, or of a foot"};
}

/// The whole clip for what is adjusted at the playhead, or the working range again; else for what comes.
Status toggleWholeClip(Session& session) {
  ViewState& view = session.view();
  const bool whole = !isWholeClip(session);
  const bool wasWhole = std::exchange(view.wholeClip, whole);
  const KeyRange range = keyRange(session);
  const std::vector<std::string> ids = posedIds(session);
  const bool any = std::ranges::any_of(ids, [&](const std::string& id) {
    return adjustmentAt(session.document(), view.clip, view.frame, id) != nullptr;
  });
  if (!any) {
    return Success{};
  }
  if (!whole && !range.rangeFrames) {
    view.wholeClip = wasWhole;
    return Error{"no range holds the playhead", "", "set one with [ and ], or drag its ends in the timeline"};
  }
  Status done = finish(session, setOffsetRange(session.document(), view.clip, view.frame, ids, range),
                       "Change the range");
  if (!done) {
    view.wholeClip = wasWhole;
  }
  return done;
}

struct InterpolationCommand {
  const char* id;
  rig::KeyInterpolation interpolation;
  const char* name;
  const char* help;
};

constexpr std::array<InterpolationCommand, 5> interpolationCommands{{
    {command::poseKeyAutomatic, rig::KeyInterpolation::automatic, "auto",
     "The curve passes the key at the playhead smoothly and never beyond its value."},
    {command::poseKeyFlat, rig::KeyInterpolation::flat, "flat",
     "The curve comes to rest at the key at the playhead."},
    {command::poseKeyLinear, rig::KeyInterpolation::linear, "linear",
     "The curve runs straight to and from the key at the playhead."},
    {command::poseKeyStepped, rig::KeyInterpolation::stepped, "stepped",
     "The key at the playhead is held up to the next one."},
    {command::poseKeyFree, rig::KeyInterpolation::free, "free",
     "The key at the playhead keeps the slope that it has now, whatever its neighbours do."},
}};

DocumentCommand interpolationCommand(const InterpolationCommand& row) {
  DocumentCommand command =
      entry(row.id, std::string("Key: ") + row.name, row.help, {}, keyHereNeeded(), [row](Session& session) {
        const ViewState& view = session.view();
        return finish(session,
                      setKeyInterpolation(session.document(), view.clip, view.frame, posedIds(session),
                                          row.interpolation),
                      (std::string("Make the key ") + row.name).c_str());
      });
  return ticked(std::move(command),
                [row](const Session& session) { return interpolationHere(session) == row.interpolation; });
}

std::vector<DocumentCommand> keyingCommands() {
  return {
      entry(command::poseKey, "Set a key",
            "Keys the selected controllers at the playhead, as they are shown there.", {"S"},
            {hasPosable, "select a controller first"}, keySelected),
      ticked(
          entry(command::poseAutoKey, "Auto-key",
                "What is posed is keyed at once. Off: it is shown until the playhead moves, and S keys it.",
                {"Shift+S"}, clipNeeded(),
                doing([](Session& session) { session.view().autoKey = !session.view().autoKey; })),
          [](const Session& session) { return session.view().autoKey; }),
      ticked(entry(command::poseWholeClip, "Key the whole clip",
                   "The change is held to both ends of the clip, not inside the range alone.", {},
                   clipNeeded(), toggleWholeClip),
             isWholeClip),
      entry(command::poseDeleteKey, "Delete the key",
            "Takes the selected controllers' keys at the playhead away.", {}, keyHereNeeded(), deleteKeys),
  };
}

std::vector<DocumentCommand> resetCommands() {
  return {
      entry(command::poseReset, "Reset",
            "Gives the selected controllers back what the clip has at the playhead.", {},
            {hasPosable, "select a controller first"}, resetSelected),
      entry(command::poseResetRange, "Reset over the range",
            "Takes every offset of the selected controllers out of the range, or out of the clip where no "
            "range "
            "is set.",
            {}, {hasPosable, "select a controller first"}, resetSelectedRange),
      entry(command::poseResetRig, "Reset the whole character",
            "Gives every controller back what the clip has at the playhead.", {}, adjustmentsNeeded(),
            [](Session& session) {
              return resetAt(session, everyPosedId(session), "Reset the whole character");
            }),
      entry(command::poseResetRigRange, "Reset the whole character over the range",
            "Takes every offset out of the range, or out of the clip where no range is set.", {},
            adjustmentsNeeded(),
            [](Session& session) {
              return resetOver(session, everyPosedId(session), "Reset the whole character");
            }),
  };
}

} // namespace

std::vector<DocumentCommand> poseCommands() {
  std::vector<DocumentCommand> commands = keyingCommands();
  for (DocumentCommand& command : resetCommands()) {
    commands.push_back(std::move(command));
  }
  commands.push_back(
      entry(command::poseMirror, "Mirror the pose",
            "Poses the other side of the body as the selected controllers are; with both sides "
            "selected they change places.",
            {}, {hasPosable, "select a controller first"}, mirrorSelected));
  for (DocumentCommand& command : copyingCommands()) {
    commands.push_back(std::move(command));
  }
  commands.push_back(entry(
      command::poseTween, "Tween half-way",
      "Poses the selected controllers half-way between the key before the playhead and the key after it.",
      {"Shift+T"}, {canTween, "move the playhead between two keys of the selected controllers"},
      [](Session& session) { return poseAll(session, tweened(session, 0.5), "Tween"); }));
  commands.push_back(entry(command::poseCurlMore, "Curl or roll on",
                           "Closes the selected hand, lifts the heel of the selected foot, by a tenth.",
                           {"Alt+Up"}, bendNeeded(), [](Session& session) { return curl(session, 0.1); }));
  commands.push_back(entry(command::poseCurlLess, "Curl or roll back",
                           "Opens the selected hand, lowers the heel of the selected foot, by a tenth.",
                           {"Alt+Down"}, bendNeeded(), [](Session& session) { return curl(session, -0.1); }));
  for (const InterpolationCommand& row : interpolationCommands) {
    commands.push_back(interpolationCommand(row));
  }
  return commands;
}

} // namespace stretch::app
