#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "app/commands/keys/clips.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/needs.h"
#include "app/commands/table/tables.h"
#include "app/edits/keys/rate_edits.h"

namespace stretch::app {

namespace {

bool isClipShown(const Session& session) {
  return hasClip(session.document(), session.view().clip);
}

bool hasSeveralClips(const Session& session) {
  return isClipShown(session) && session.document().clips->size() > 1;
}

/// The next or previous clip, round and round.
Status stepClip(Session& session, int direction) {
  const auto count = static_cast<int>(session.document().clips->size());
  showClip(session, (session.view().clip + direction + count) % count);
  return Success{};
}

Need severalClipsNeeded() {
  return {hasSeveralClips, "the file has one clip"};
}

bool isWorkedAt(const Session& session, double framesPerSecond) {
  return isClipShown(session) &&
         std::abs(clipOf(session.document(), session.view().clip).framesPerSecond - framesPerSecond) < 1e-6;
}

bool isWorkedAtOwnRate(const Session& session) {
  return isClipShown(session) && isWorkedAt(session, ownRate(session.document(), session.view().clip));
}

DocumentCommand rateCommand(const char* id, double framesPerSecond) {
  return ticked(
      entry(id, fmt::format("Work at {:g} frames per second", framesPerSecond),
            fmt::format("Counts the clip's frames at {:g} per second; its keys stay where they are.",
                        framesPerSecond),
            {}, clipNeeded(),
            [framesPerSecond](Session& session) {
              return finish(session, workAtRate(session.document(), session.view().clip, framesPerSecond),
                            "Change the frame rate");
            }),
      // The clip's own rate has an entry of its own, and one of them is ticked.
      [framesPerSecond](const Session& session) {
        return isWorkedAt(session, framesPerSecond) && !isWorkedAtOwnRate(session);
      });
}

} // namespace

void showClip(Session& session, int clip) {
  ViewState& view = session.view();
  if (clip == view.clip) {
    return;
  }
  view.clip = clip;
  view.frame = 0.0;
  view.rangeStart = 0.0;
  view.rangeEnd = -1.0;
  view.selection.dropTrail();
  session.followSelection();
}

std::vector<DocumentCommand> clipCommands() {
  return {
      entry(command::clipNext, "Next clip", "Goes to the next clip of the file.", {"Alt+Page Down"},
            severalClipsNeeded(), [](Session& session) { return stepClip(session, 1); }),
      entry(command::clipPrevious, "Previous clip", "Goes to the clip before.", {"Alt+Page Up"},
            severalClipsNeeded(), [](Session& session) { return stepClip(session, -1); }),
      rateCommand(command::clipRate24, 24.0),
      rateCommand(command::clipRate25, 25.0),
      rateCommand(command::clipRate30, 30.0),
      ticked(entry(command::clipRateOwn, "Work at the clip's own rate",
                   "Counts frames at the rate that the clip's keys suggest.", {}, clipNeeded(),
                   [](Session& session) {
                     const int clip = session.view().clip;
                     return finish(session,
                                   workAtRate(session.document(), clip, ownRate(session.document(), clip)),
                                   "Change the frame rate");
                   }),
             isWorkedAtOwnRate),
  };
}

} // namespace stretch::app
