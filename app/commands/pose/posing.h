#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/edits/pose/offset_edits.h"
#include "app/session.h"
#include "rig/controllers/controller.h"

namespace stretch::app {

// Posing the viewed clip at the playhead, as commands, tools and panels do it.

/// Returns the range in which a first key acts: in the working range, on the whole clip where none is set or
/// the user chose so.
[[nodiscard]] KeyRange keyRange(const Session& session);

/// Returns the range in which a pose acts that is taken as it was seen elsewhere: that of a first key, and
/// where no range is set between the keys of the clip beside the playhead, a sixth of a second from it or
/// more. On the whole clip where the user chose so, or the clip has no key there.
[[nodiscard]] KeyRange seenPoseRange(const Session& session);

/// Returns the offset of a controller at the playhead, keyed or not.
[[nodiscard]] ControllerOffset shownOffset(const Session& session, const std::string& id);
[[nodiscard]] double shownValue(const Session& session, const std::string& id);

/// The selected controllers, in the order of their selection.
[[nodiscard]] std::vector<rig::Controller> selectedControllers(const Session& session);

/// The attributes of the limbs of these controllers, each once.
[[nodiscard]] std::vector<rig::Attribute> attributesOf(const Session& session,
                                                       std::span<const rig::Controller> controllers);

/// These controllers, each followed by the attributes that go with it (attributesHeldBy).
[[nodiscard]] std::vector<std::string> withAttributes(const Session& session,
                                                      std::span<const std::string> controllers);

/// Lists what posing acts on: the selected controllers and the attributes that go with them
/// (attributesHeldBy).
[[nodiscard]] std::vector<std::string> posedIds(const Session& session);

/// Lists the controllers that a pose is copied from and, out of the library, put on: the selected ones, else
/// those of the selected limbs; none: the whole character.
[[nodiscard]] std::vector<std::string> chosenControllers(const Session& session);

/// "the left hand", "4 controllers", "the whole character": what chosenControllers lists.
[[nodiscard]] std::string chosenText(const Session& session);

/// Returns the offsets of these at the playhead, keyed or not.
[[nodiscard]] OffsetPose shownPose(const Session& session, std::span<const std::string> ids);

/// Frames at which these have keys in the viewed clip, in order, each once.
[[nodiscard]] std::vector<double> offsetKeyFrames(const Session& session);

/// Lets the range in which the selection is offset start or end at the playhead: the range there, else the
/// next one towards which it would grow. What holds over the whole clip is left alone.
Status endOffsetsHere(Session& session, bool start);

/// How the selected keys at the playhead are passed; nothing without one, or where they differ.
[[nodiscard]] std::optional<rig::KeyInterpolation> interpolationHere(const Session& session);

/// Posing acts on something that has a key before the playhead and one after it; ends of ranges count.
[[nodiscard]] bool canTween(const Session& session);
/// Returns the pose of what posing acts on, between these keys (tweenedPose).
[[nodiscard]] OffsetPose tweened(const Session& session, double between);

/// Whether what posing acts on holds over the whole clip: as it is adjusted at the playhead, else as a first
/// key would.
[[nodiscard]] bool isWholeClip(const Session& session);

/// Returns whether what posing acts on comes or goes at once, since a key that is off the clip's pose stands
/// at the playhead, at the first (`first`) or last frame of its range; never at the ends of the clip.
[[nodiscard]] bool endsAtOnce(const Session& session, bool first);

/// Tells how far a pose reaches that was taken at the playhead as it was seen, where no range was set: over
/// the whole clip, or between keys of the clip; else empty.
[[nodiscard]] std::string heldPoseText(const Session& session);

/// Keys at the playhead, as one step, whether auto-key is on or not.
Status keyPose(Session& session, const OffsetPose& pose, const std::string& label);

/// Shows what was keyed without a key no longer.
void forgetUnkeyed(ViewState& view, const OffsetPose& pose);

/// Keys what is posed without a key at the playhead, as one step. A drag that is on is taken back first.
/// Nothing happens where nothing is posed so.
Status keyUnkeyedPose(Session& session);

/// One finished step: keyed at the playhead, or shown without a key while auto-key is off. The second one
/// acts in seenPoseRange.
Status poseAll(Session& session, const OffsetPose& pose, const std::string& label);
Status poseAsSeen(Session& session, const OffsetPose& pose, const std::string& label);

/// Poses within a drag that was begun; each preview is made from the state at its beginning.
Status previewPose(Session& session, const OffsetPose& pose);
/// Poses as seen elsewhere, with keys, also while auto-key is off.
Status previewAsSeen(Session& session, const OffsetPose& pose);

/// "Move the left hand", "Turn 3 controllers".
[[nodiscard]] std::string poseLabel(const Document& document, const std::string& verb,
                                    std::span<const std::string> ids);

} // namespace stretch::app
