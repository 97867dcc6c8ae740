#include <algorithm>
#include <cmath>
#include <set>

#include "app/commands/pose/posing.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/moments.h"
#include "app/commands/table/needs.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/pops.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

Status goTo(Session& session, double frame) {
  session.view().frame = std::clamp(frame, 0.0, lastFrame(session.document(), session.view().clip));
  return Success{};
}

Status stepBack(Session& session) {
  return goTo(session, wholeFrameAtLeast(session.view().frame) - 1.0);
}

Status stepForward(Session& session) {
  return goTo(session, wholeFrameAtMost(session.view().frame) + 1.0);
}

constexpr double farFrames = 10.0;

/// Keys of the selected controllers, where they have some, else those of the selected limbs, or all.
std::vector<double> framesToGoTo(Session& session) {
  std::vector<double> frames = offsetKeyFrames(session);
  return frames.empty() ? shownKeyFrames(session, session.view().selection.limbs()) : frames;
}

Status goToKey(Session& session, bool next) {
  const ViewState& view = session.view();
  const std::vector<double> frames = framesToGoTo(session);
  if (next) {
    const auto found =
        std::ranges::find_if(frames, [&](double frame) { return frame > view.frame + frameTolerance; });
    return found == frames.end() ? Status(Success{}) : goTo(session, *found);
  }
  const auto found = std::find_if(frames.rbegin(), frames.rend(),
                                  [&](double frame) { return frame < view.frame - frameTolerance; });
  return found == frames.rend() ? Status(Success{}) : goTo(session, *found);
}

bool alwaysOnSequence(const SequenceSession& /*session*/) {
  return true;
}

Status goToFrame(SequenceSession& session, double frame) {
  session.view().frame = std::clamp(frame, 0.0, lastFrame(session));
  return Success{};
}

Vec2 rangeFrom(const Session& session, bool start) {
  const ViewState& view = session.view();
  const bool wasSet = isRangeSet(view);
  if (start) {
    return {view.frame,
            wasSet && view.rangeEnd > view.frame ? view.rangeEnd : lastFrame(session.document(), view.clip)};
  }
  return {wasSet && view.rangeStart < view.frame ? view.rangeStart : 0.0, view.frame};
}

/// The selected trail's range, which the working range follows; without one the working range alone.
Status setRange(Session& session, bool start) {
  const rig::Trail* trail = selectedTrail(session);
  if (trail == nullptr) {
    const Vec2 range = rangeFrom(session, start);
    if (!(range.y > range.x)) {
      return Error{"the range would have no length", "", "move the playhead first"};
    }
    if (Status ended = hasControllers(session) ? endOffsetsHere(session, start) : Success{}; !ended) {
      return ended;
    }
    setRangeByHand(session, range);
    return Success{};
  }
  Document document = session.document();
  for (const int id : targetsOfRange(session)) {
    rig::TrailSettings settings = findTrail(document, id)->settings;
    (start ? settings.startFrame : settings.endFrame) = session.view().frame;
    Result<Document> changed = setTrailSettings(document, id, settings);
    if (!changed) {
      return changed.error();
    }
    document = std::move(changed).value();
  }
  return finish(session, std::move(document), "Change the range");
}

Status forgetRange(Session& session) {
  session.view().rangeStart = 0.0;
  session.view().rangeEnd = -1.0;
  return Success{};
}

Status goToNextMoment(Session& session, bool forwards) {
  const std::optional<rig::Moment> moment = nextMoment(session, forwards);
  if (!moment) {
    return Error{"nothing strikes, steps or lands in this clip", "", "choose another clip"};
  }
  goToMoment(session, *moment);
  return Success{};
}

Status goToNextWarning(Session& session) {
  std::set<double> frames;
  for (const LimbPop& pop : session.pops()) {
    frames.insert(pop.frame);
  }
  if (frames.empty()) {
    return Error{"nothing is warned of", "", "pose the character first"};
  }
  const auto next = frames.upper_bound(session.view().frame + frameTolerance);
  return goTo(session, next == frames.end() ? *frames.begin() : *next);
}

bool loops(const Session& session) {
  return isLooping(session.document(), session.view().clip);
}

Status toggleLoop(Session& session) {
  const Document& document = session.document();
  const int clip = session.view().clip;
  const bool looped = isLooping(document, clip);
  return finish(session, setLooping(document, clip, !looped), looped ? "Clip does not loop" : "Clip loops");
}

} // namespace

std::vector<DocumentCommand> timeCommands() {
  return {
      entry(command::rangeStart, "Range starts here",
            "Starts the range at the playhead: of the selected trail or controllers, else of the next trail.",
            {"[", "Alt+,"}, clipNeeded(), [](Session& session) { return setRange(session, true); }),
      entry(command::rangeEnd, "Range ends here",
            "Ends the range at the playhead: of the selected trail or controllers, else of the next trail.",
            {"]", "Alt+."}, clipNeeded(), [](Session& session) { return setRange(session, false); }),
      entry(command::rangeDefault, "Forget the range",
            "The next trail takes the stroke around the playhead again.", {},
            {[](const Session& session) { return isRangeSet(session.view()); }, "no range was set"},
            forgetRange),
      entry(
          command::timeBack, "Frame back", "Steps to the frame before.", {","}, clipNeeded(), stepBack,
          alwaysOnSequence,
          [](SequenceSession& session) { return goToFrame(session, std::ceil(session.view().frame) - 1.0); }),
      entry(command::timeForward, "Frame forward", "Steps to the next frame.", {"."}, clipNeeded(),
            stepForward, alwaysOnSequence,
            [](SequenceSession& session) {
              return goToFrame(session, std::floor(session.view().frame) + 1.0);
            }),
      entry(
          command::timeFarBack, "Ten frames back", "Goes ten frames back, or to the start.", {"Shift+,"},
          clipNeeded(), [](Session& session) { return goTo(session, session.view().frame - farFrames); },
          alwaysOnSequence,
          [](SequenceSession& session) { return goToFrame(session, session.view().frame - farFrames); }),
      entry(
          command::timeFarForward, "Ten frames on", "Goes ten frames on, or to the end.", {"Shift+."},
          clipNeeded(), [](Session& session) { return goTo(session, session.view().frame + farFrames); },
          alwaysOnSequence,
          [](SequenceSession& session) { return goToFrame(session, session.view().frame + farFrames); }),
      entry(command::momentNext, "Next moment",
            "Goes to where the clip strikes, steps or lands next: its limb, its range, its tip.", {"N"},
            clipNeeded(), [](Session& session) { return goToNextMoment(session, true); }),
      entry(command::momentPrevious, "Previous moment",
            "Goes to where the clip struck, stepped or landed before: its limb, its range, its tip.",
            {"Shift+N"}, clipNeeded(), [](Session& session) { return goToNextMoment(session, false); }),
      entry(command::warningNext, "Next warning", "Goes to the next warning of a pose, round and round.", {},
            clipNeeded(), goToNextWarning),
      entry(command::timePreviousKey, "Previous key",
            "Jumps to the key before, of the selected limbs or controllers if there are any.", {"Ctrl+,"},
            clipNeeded(), [](Session& session) { return goToKey(session, false); }),
      entry(command::timeNextKey, "Next key",
            "Jumps to the next key, of the selected limbs or controllers if there are any.", {"Ctrl+."},
            clipNeeded(), [](Session& session) { return goToKey(session, true); }),
      entry(
          command::timeStart, "To the start", "Jumps to the clip's first frame.", {"Home"}, clipNeeded(),
          [](Session& session) { return goTo(session, 0.0); }, alwaysOnSequence,
          [](SequenceSession& session) { return goToFrame(session, 0.0); }),
      entry(
          command::timeEnd, "To the end", "Jumps to the clip's last frame.", {"End"}, clipNeeded(),
          [](Session& session) { return goTo(session, lastFrame(session.document(), session.view().clip)); },
          alwaysOnSequence, [](SequenceSession& session) { return goToFrame(session, lastFrame(session)); }),
      ticked(entry(command::clipLoop, "Clip loops",
                   "The clip is played as a loop: a limb's way back at its end goes on at its start.", {},
                   clipNeeded(), toggleLoop),
             loops),
  };
}

} // namespace stretch::app
