#include "ui/shell/stroke_news.h"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/place_trails.h"
#include "app/evaluate/stopped.h"
#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

namespace {

/// The trail that leads, its limb, and the stroke of the limb that its range is.
struct TakenStroke {
  const rig::Trail* trail = nullptr;
  const rig::Limb* limb = nullptr;
  std::optional<rig::Moment> stroke; ///< Nothing where the range is none.
  std::size_t place = 0;             ///< Of the stroke, in time.
  std::size_t count = 0;             ///< Of the limb's strokes.
};

TakenStroke takenStroke(const app::Session& session, const ExaggerateTool& tool) {
  TakenStroke taken;
  taken.trail = app::findTrail(session.document(), tool.targets.trailIds.front());
  taken.limb = taken.trail == nullptr ? nullptr : app::findLimb(session.document(), taken.trail->limb);
  if (taken.limb == nullptr) {
    return taken;
  }
  const std::vector<rig::Moment> strokes = session.momentsOf(taken.limb->id);
  const auto found = std::ranges::find_if(strokes, [&](const rig::Moment& stroke) {
    return stroke.startFrame == taken.trail->settings.startFrame;
  });
  taken.count = strokes.size();
  taken.stroke = found == strokes.end() ? std::nullopt : std::optional(*found);
  taken.place = static_cast<std::size_t>(found - strokes.begin());
  return taken;
}

std::string framesText(const rig::Trail& trail) {
  return fmt::format("frames {:.4g} to {:.4g}", trail.settings.startFrame, trail.settings.endFrame);
}

/// Where the limb's strongest stroke is, after what was said of the one that was taken; empty where it is
/// that one.
std::string strongestText(const app::Session& session, const TakenStroke& taken) {
  const std::vector<rig::Moment> strokes = session.momentsOf(taken.limb->id);
  const rig::Moment* const strongest = rig::strongestMoment(strokes);
  if (!taken.stroke || strongest == nullptr || *strongest == *taken.stroke) {
    return {};
  }
  const bool hasTrail = app::overlappingTrail(session.atBegin(), taken.limb->id, taken.trail->clip,
                                              strongest->startFrame, strongest->endFrame) != nullptr;
  return fmt::format("; the strongest, {:.4g} to {:.4g}{}", strongest->startFrame, strongest->endFrame,
                     hasTrail ? ", has a trail" : ", is free");
}

std::string whyThere(const app::Session& session, const TakenStroke& taken) {
  const rig::TrailSettings& settings = taken.trail->settings;
  const std::string limb = app::limbTitle(session.document(), taken.trail->limb);
  const double frame = session.view().frame;
  const bool here = settings.startFrame - 0.5 <= frame && frame <= settings.endFrame + 0.5;
  if (app::findTrail(session.atBegin(), taken.trail->id) != nullptr) {
    return here ? std::string()
                : fmt::format("The {} has a trail at its strongest stroke: that goes on, {}", limb,
                              framesText(*taken.trail));
  }
  if (!taken.stroke) {
    return {};
  }
  if (frame < 0.5 && taken.count > 1) {
    return fmt::format("The strongest stroke of the {} is taken, {}", limb, framesText(*taken.trail));
  }
  const std::string strongest = strongestText(session, taken);
  if (!here) {
    return fmt::format("Frame {:.4g} lies in no stroke of the {}: one beside it is taken, {}{}", frame, limb,
                       framesText(*taken.trail), strongest);
  }
  return strongest.empty()
             ? std::string()
             : fmt::format("The {}'s stroke here is taken, {}{}", limb, framesText(*taken.trail), strongest);
}

/// Empty where the stroke lies inside the clip.
std::string seamText(const app::Session& session, const TakenStroke& taken) {
  const bool crosses = taken.stroke && app::crossesSeam(session, *taken.limb, *taken.stroke);
  return crosses ? "The stroke goes on across the seam of the loop, where a range ends" : "";
}

/// Empty where all limbs have one range, or none was made just now.
std::string othersText(const app::Session& session, const ExaggerateTool& tool) {
  const std::vector<int>& ids = tool.targets.trailIds;
  const bool areNew =
      std::ranges::all_of(ids, [&](int id) { return app::findTrail(session.atBegin(), id) == nullptr; });
  const rig::TrailSettings& leading = app::findTrail(session.document(), ids.front())->settings;
  const bool isOneRange = std::ranges::all_of(ids, [&](int id) {
    const rig::TrailSettings& settings = app::findTrail(session.document(), id)->settings;
    return settings.startFrame == leading.startFrame && settings.endFrame == leading.endFrame;
  });
  return areNew && !isOneRange ? "Each limb has its own stroke; a range that is set before counts for all"
                               : "";
}

/// Sentences, one after the other.
std::string joinedText(const std::string& first, const std::string& second) {
  return first + (first.empty() || second.empty() ? "" : ". ") + second;
}

/// The limb that makes the clip's first moment; null where none makes any.
const rig::Limb* strongestLimb(const app::Session& session) {
  for (const rig::Moment& moment : session.moments()) {
    if (const rig::Limb* const limb = app::findLimb(session.document(), moment.limb)) {
      return limb;
    }
  }
  return nullptr;
}

/// The limbs of E's trails: "left leg and right leg".
std::string limbsOf(const app::Session& session, const ExaggerateTool& tool) {
  std::vector<std::string> names;
  for (const int id : tool.targets.trailIds) {
    names.push_back(app::limbTitle(session.document(), app::findTrail(session.document(), id)->limb));
  }
  return app::listed(names);
}

/// Whether the first scale leaves the limb as long as it was: it does not move, or makes no stroke and the
/// floor is in its way.
bool showsNothing(app::Session& session, const rig::SolvedTrail& solved) {
  constexpr double noticed = 0.02;
  const TipLengths lengths = tipLengths(session, solved);
  const bool isAsLong = std::abs(lengths.after - lengths.before) < noticed * lengths.before;
  return solved.tip.outcome == rig::TipOutcome::nothingToScale ||
         (isAsLong && session.momentsOf(solved.limb.id).empty());
}

/// "The left leg does not move in this clip", "makes no stroke", or what keeps it from getting longer.
std::string whyNothing(app::Session& session, const ExaggerateTool& tool, const TakenStroke& taken) {
  const bool one = tool.targets.trailIds.size() == 1;
  const auto told = [&](const char* why, const std::string& where) {
    return fmt::format("The {} {} in {}", limbsOf(session, tool), why, where);
  };
  const rig::SolvedTrail* const solved = app::solvedTrail(session, tool.targets.trailIds.front());
  const bool moves = solved != nullptr && solved->tip.outcome != rig::TipOutcome::nothingToScale;
  const std::string frames = taken.trail == nullptr ? "this clip" : framesText(*taken.trail);
  if (moves && app::isStoppedAtTip(session.document(), session.motion(), *solved)) {
    return told("would get longer only into the floor", frames);
  }
  if (makesNoStroke(session, tool)) {
    return told(moves ? (one ? "makes no stroke" : "make no stroke")
                : one ? "does not move"
                      : "do not move",
                "this clip");
  }
  return told(moves ? "would not get longer" : one ? "does not move" : "do not move", frames);
}

} // namespace

bool makesNoStroke(const app::Session& session, const ExaggerateTool& tool) {
  return std::ranges::all_of(tool.targets.trailIds, [&](int id) {
    const rig::Trail* const trail = app::findTrail(session.document(), id);
    return app::findTrail(session.atBegin(), id) == nullptr && trail != nullptr &&
           session.momentsOf(trail->limb).empty();
  });
}

bool standsStill(app::Session& session, const ExaggerateTool& tool) {
  const std::vector<int>& ids = tool.targets.trailIds;
  return std::all_of(ids.begin(), ids.end(), [&](int id) {
    const rig::SolvedTrail* const solved = app::solvedTrail(session, id);
    return app::findTrail(session.atBegin(), id) == nullptr && solved != nullptr &&
           showsNothing(session, *solved);
  });
}

std::string stillNews(app::Session& session, const ExaggerateTool& tool,
                      const std::function<std::string(const std::string&)>& keyOf) {
  const TakenStroke taken = takenStroke(session, tool);
  const std::string text = whyNothing(session, tool, taken);
  const rig::Limb* const other = strongestLimb(session);
  if (other == nullptr || (taken.limb != nullptr && other->id == taken.limb->id)) {
    return text + (taken.count > 0 ? ": choose another range" : ": set a range, or choose another clip");
  }
  const std::string key = keyOf("limb." + other->id);
  return fmt::format("{}. The {} makes the strongest stroke{}", text,
                     app::limbTitle(session.document(), other->id),
                     key.empty() ? "" : fmt::format(": {} selects it", key));
}

std::string strokeNews(const app::Session& session, const ExaggerateTool& tool) {
  const TakenStroke taken = takenStroke(session, tool);
  if (taken.trail == nullptr || taken.limb == nullptr) {
    return {};
  }
  std::string text = whyThere(session, taken);
  text += text.empty() || !tool.modal.hasStrokes ? "" : "; N goes to the next";
  text = joinedText(text, othersText(session, tool));
  text = joinedText(text, seamText(session, taken));
  if (tool.targets.madeLoop) {
    text = joinedText(text, "The clip ends as it begins: Clip loops is on now");
  }
  return text;
}

std::string strokeReached(const app::Session& session, const ExaggerateTool& tool) {
  const TakenStroke taken = takenStroke(session, tool);
  if (!taken.stroke) {
    return {};
  }
  std::string text = framesText(*taken.trail);
  text.front() = 'F';
  text += fmt::format(", stroke {} of {} of the {}", taken.place + 1, taken.count,
                      app::limbTitle(session.document(), taken.trail->limb));
  return joinedText(text, seamText(session, taken));
}

} // namespace stretch::ui
