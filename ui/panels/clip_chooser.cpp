#include "ui/panels/clip_chooser.h"

#include <algorithm>

#include "ui/panels/panel_support.h"
#include "ui/widgets/dropdown.h"

namespace stretch::ui {

namespace {

std::string clipName(const Clip& clip, std::size_t index) {
  return clip.name.empty() ? "Clip " + std::to_string(index) : clip.name;
}

/// ", 2 trails": the work in a clip; empty without any.
std::string workText(const app::Document& document, int clip) {
  const auto trails = std::count_if(document.trails.begin(), document.trails.end(),
                                    [&](const rig::Trail& trail) { return trail.clip == clip; });
  std::string text = trails == 0 ? "" : trails == 1 ? ", 1 trail" : ", " + std::to_string(trails) + " trails";
  return text + (app::hasWeight(document, clip) ? ", weight" : "");
}

void chooseClip(PanelContext& context, int clip) {
  app::ViewState& view = context.open.character()->view();
  view.clip = clip;
  view.frame = 0.0;
  view.rangeStart = 0.0;
  view.rangeEnd = -1.0;
  view.selectedTrail = 0;
  view.selectedSpheres.clear();
  context.ui.timeline.viewEnd = context.ui.timeline.viewStart - 1.0;
  context.ui.graph.fitPending = true;
}

} // namespace

void clipChooser(PanelContext& context, const std::string& id, float width) {
  const std::vector<Clip>& clips = *context.open.character()->document().clips;
  std::vector<Choice> choices;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const std::string seconds = shortNumber(clips[i].endSeconds) + " s";
    const std::string work = workText(context.open.character()->document(), static_cast<int>(i));
    choices.push_back({clipName(clips[i], i),
                       {.title = clipName(clips[i], i), .text = seconds + work},
                       true,
                       !work.empty()});
  }
  const Help help{.title = "Clip",
                  .text = "The animation to work on. Trails belong to the clip that they were made in."};
  const int chosen =
      dropdown(widgetsOf(context), id, choices, context.open.character()->view().clip, help, width);
  if (chosen >= 0 && chosen != context.open.character()->view().clip) {
    chooseClip(context, chosen);
  }
}

} // namespace stretch::ui
