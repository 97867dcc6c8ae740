#include "ui/shell/stroke_news.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/commands/ranges.h"
#include "app/commands/selection.h"

namespace stretch::ui {

namespace {

/// The trail that leads, its limb, and the stroke of the limb that its range is.
struct TakenStroke {
  const rig::Trail* trail = nullptr;
  const rig::Limb* limb = nullptr;
  const rig::Stroke* stroke = nullptr; ///< Null where the range is none.
  std::size_t place = 0;               ///< Of the stroke, in time.
  std::size_t count = 0;               ///< Of the limb's strokes.
};

TakenStroke takenStroke(const app::Session& session, const ExaggerateTool& tool) {
  TakenStroke taken;
  taken.trail = app::findTrail(session.document(), tool.targets.trailIds.front());
  taken.limb = taken.trail == nullptr ? nullptr : app::findLimb(session.document(), taken.trail->limb);
  if (taken.limb == nullptr) {
    return taken;
  }
  const std::vector<rig::Stroke>& strokes = session.strokesOf(*taken.limb);
  const auto found = std::find_if(strokes.begin(), strokes.end(), [&](const rig::Stroke& stroke) {
    return stroke.startFrame == taken.trail->settings.startFrame;
  });
  taken.count = strokes.size();
  taken.stroke = found == strokes.end() ? nullptr : &*found;
  taken.place = static_cast<std::size_t>(found - strokes.begin());
  return taken;
}

std::string framesText(const rig::Trail& trail) {
  return fmt::format("frames {:.4g} to {:.4g}", trail.settings.startFrame, trail.settings.endFrame);
}

std::string whyThere(const app::Session& session, const TakenStroke& taken) {
  const rig::TrailSettings& settings = taken.trail->settings;
  const std::string limb = app::limbTitle(session.document(), taken.trail->limb);
  const double frame = session.view().frame;
  const bool here = settings.startFrame - 0.5 <= frame && frame <= settings.endFrame + 0.5;
  if (taken.stroke == nullptr) {
    return taken.count > 0 ? std::string()
                           : fmt::format("The {} makes no stroke in this clip: {} are taken", limb,
                                         framesText(*taken.trail));
  }
  if (frame < 0.5 && taken.count > 1) {
    return fmt::format("The strongest stroke of the {} is taken, {}", limb, framesText(*taken.trail));
  }
  return here ? std::string()
              : fmt::format("Frame {:.4g} lies in no stroke of the {}: one beside it is taken, {}", frame,
                            limb, framesText(*taken.trail));
}

/// Empty where the stroke lies inside the clip.
std::string seamText(const app::Session& session, const TakenStroke& taken) {
  const bool crosses = taken.stroke != nullptr && app::crossesSeam(session, *taken.limb, *taken.stroke);
  return crosses ? "The stroke goes on across the seam of the loop, where a range ends" : "";
}

/// Sentences, one after the other.
std::string joinedText(const std::string& first, const std::string& second) {
  return first + (first.empty() || second.empty() ? "" : ". ") + second;
}

} // namespace

std::string strokeNews(const app::Session& session, const ExaggerateTool& tool) {
  const TakenStroke taken = takenStroke(session, tool);
  if (taken.trail == nullptr || taken.limb == nullptr) {
    return {};
  }
  std::string text = whyThere(session, taken);
  text += text.empty() || !tool.modal.hasStrokes ? "" : "; N goes to the next";
  text = joinedText(text, seamText(session, taken));
  if (tool.targets.madeLoop) {
    text = joinedText(text, "The clip ends as it begins: Clip loops is on now");
  }
  return text;
}

std::string strokeReached(const app::Session& session, const ExaggerateTool& tool) {
  const TakenStroke taken = takenStroke(session, tool);
  if (taken.stroke == nullptr) {
    return {};
  }
  std::string text = framesText(*taken.trail);
  text.front() = 'F';
  text += fmt::format(", stroke {} of {} of the {}", taken.place + 1, taken.count,
                      app::limbTitle(session.document(), taken.trail->limb));
  return joinedText(text, seamText(session, taken));
}

} // namespace stretch::ui
