#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/style_edits.h"
#include "app/evaluate/quality.h"
#include "app/evaluate/seen.h"
#include "app/evaluate/stopped.h"
#include "app/evaluate/way_back.h"
#include "rig/motion/solve.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/panels/trails/trail_sections.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

using rig::TrailSettings;

/// Styles for every limb at once: each gets its own scale.
void styleRow(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const Help help{"Style",
                  "How the limbs are exaggerated: measured in cartoons of the 1940s and 1950s, made for this "
                  "program, or your own. Arms, body and legs each get their scale.",
                  {}};
  labelledRow(widgets, "Style", help);
  TrailPanels& panels = context.ui.trails;
  const app::Document& document = context.character().document();
  const std::vector<int> trails = app::targetTrails(context.character());
  const ShownStyle shown = shownStyle(panels, document, trails);
  if (const int chosen = dropdown(widgets, "trail/style", styleChoices(panels.styles), shown.index, help,
                                  0.0F, shown.otherwise.c_str());
      chosen >= 0) {
    panels.takenStyle = {document.scene, trails, chosen};
    editOnce(context, "Take a style",
             app::applyStyle(document, trails, panels.styles[static_cast<std::size_t>(chosen)]));
  }
}

/// The range of the slider of scales: that of the style which was taken for the trails, else the widest.
RowExtras scaleExtras(const PanelContext& context, const rig::Trail& trail) {
  const TrailPanels& panels = context.ui.trails;
  const app::Session& session = context.character();
  const rig::Limb* const limb = app::findLimb(session.document(), trail.limb);
  if (limb == nullptr || !panels.takenStyle.isFor(session.document().scene, app::targetTrails(session))) {
    return {};
  }
  const rig::ScaleRange& range =
      rig::scalesOf(panels.styles[static_cast<std::size_t>(panels.takenStyle.style)], limb->kind);
  return {.minimum = range.least, .maximum = range.most};
}

void proposeRangeEnd(PanelContext& context, const rig::SolvedTrail& solved) {
  const auto sample = static_cast<std::size_t>(std::max(0, solved.tip.farthestSample));
  const std::size_t tip = solved.settings.pivot == rig::Pivot::start ? solved.path.samples.size() - 1 : 0;
  if (sample >= solved.path.samples.size() || sample == tip) {
    return;
  }
  const double rate = app::clipOf(context.character().document(), solved.trail.clip).framesPerSecond;
  const double frame = std::round(solved.path.samples[sample].timeSeconds * rate);
  ButtonSpec propose;
  propose.id = "trail/use-farthest";
  propose.text = "End the range at frame " + shortNumber(frame, 0);
  propose.help = {propose.text, "There the limb is farthest from the pivot.", {}};
  propose.width = ImGui::GetContentRegionAvail().x;
  if (button(widgetsOf(context), propose)) {
    const bool tipIsEnd = solved.settings.pivot == rig::Pivot::start;
    editRange(context, {true, true},
              [&](TrailSettings& s) { (tipIsEnd ? s.endFrame : s.startFrame) = frame; });
  }
}

std::string tipProblem(const rig::SolvedTrail& solved) {
  if (solved.tip.outcome == rig::TipOutcome::nothingToScale) {
    return "Nothing to scale: the path does not move along the active axes. Turn on an axis, or choose "
           "another range.";
  }
  if (solved.tip.outcome == rig::TipOutcome::pulled) {
    return "The path's line does not reach that length: the tip is pulled the rest of the way.";
  }
  return {};
}

/// Why the limb does not get as long or as short as it should, and what to do.
std::string reachProblem(const PanelContext& context, const rig::SolvedTrail& solved) {
  const rig::TipSolution& tip = solved.tip;
  if (tip.outcome == rig::TipOutcome::nothingToScale || tip.reached() || tip.seen) {
    return {}; // as seen: the trail's own warning says it
  }
  const bool tooLong = tip.reachedLength > tip.wantedLength;
  const std::string limb = app::limbTitle(context.character().document(), solved.trail.limb);
  return "The " + limb + " gets no " + (tooLong ? "shorter" : "longer") + " than " +
         shortNumber(tip.reachedLength, 3) + " at the tip, of the " + shortNumber(tip.wantedLength, 3) +
         " that are wanted: its path, made " + (tooLong ? "smaller" : "larger") +
         " in a straight line, does not pass " + (tooLong ? "nearer to" : "farther from") +
         " where the limb begins. " +
         (solved.settings.pull ? "Turn on another axis." : "Turn on Pull the rest, or another axis.");
}

/// The mesh costs more than the limb alone: on long trails it is left to saving by the command line.
app::LookAt whatToLookAt(const rig::MotionState& motion, const rig::SolvedTrail& solved) {
  constexpr double longest = 600.0; // frames
  const double frames = (solved.windowEndSeconds - solved.windowStartSeconds) * motion.framesPerSecond;
  return frames <= longest ? app::LookAt::limbAndMesh : app::LookAt::limb;
}

bool bodyTravels(const app::Document& document, const rig::SolvedTrail& solved) {
  return rig::startingSpace(*document.scene, app::clipOf(document, solved.trail.clip), solved.limb,
                            document.body.hips,
                            {solved.settings.startFrame, solved.settings.endFrame}) == rig::TrailSpace::root;
}

LookState lookNow(const app::Document& document, std::shared_ptr<const rig::MotionState> motion,
                  const rig::SolvedTrail& solved) {
  LookState look;
  look.trailId = solved.trail.id;
  look.warnings = app::motionWarnings(document, *motion, solved, whatToLookAt(*motion, solved));
  for (const std::string& warning : app::seenWarnings(document, *motion, solved)) {
    look.warnings.push_back(warning);
  }
  if (const auto wayBack = app::wayBackProblem(document, *motion, solved)) {
    look.warnings.push_back(wayBack->what);
    look.clipCouldLoop = wayBack->loopHelps;
  }
  if (const std::string kept = app::keptFromLength(document, *motion, solved); !kept.empty()) {
    look.warnings.push_back(kept + ", it does not get as long at the tip as it is to be");
  }
  look.bodyTravels = solved.settings.space == rig::TrailSpace::root && bodyTravels(document, solved);
  look.motion = std::move(motion);
  return look;
}

/// Every frame of the trail is posed for it, so during a drag it waits until the hand rests: what was found
/// last stands until then.
const LookState& lookAt(PanelContext& context, const rig::SolvedTrail& solved) {
  constexpr double restSeconds = 0.25;
  const app::Session& session = context.character();
  LookState& look = context.ui.trails.look;
  const std::shared_ptr<const rig::MotionState> motion = context.character().sharedMotion();
  if (look.motion == motion && look.trailId == solved.trail.id) {
    return look;
  }
  if (look.waiting != motion) {
    look.waiting = motion;
    look.waitingSince = ImGui::GetTime();
  }
  if (session.isDragging() && ImGui::GetTime() - look.waitingSince < restSeconds) {
    look = look.trailId == solved.trail.id ? look
                                           : LookState{.waiting = motion, .waitingSince = look.waitingSince};
    return look;
  }
  look = lookNow(session.document(), motion, solved);
  return look;
}

struct Message {
  NoticeKind kind = NoticeKind::warning;
  std::string text;
};

/// What there is to know of a trail, what matters most first.
std::vector<Message> messagesOf(PanelContext& context, const rig::SolvedTrail& solved) {
  std::vector<Message> messages;
  const std::string reach = reachProblem(context, solved);
  if (!reach.empty()) {
    messages.push_back({NoticeKind::warning, reach});
  }
  for (const std::string& warning : solved.warnings) {
    // Said in full already, or below.
    const bool isTold =
        (!reach.empty() && warning.starts_with("not reachable")) || warning.starts_with("nothing to scale");
    if (!isTold) {
      messages.push_back({NoticeKind::warning, capitalised(warning) + "."});
    }
  }
  const LookState& look = lookAt(context, solved);
  const std::string limb = limbHeading(context.character().document(), solved.trail.limb);
  for (const std::string& warning : look.warnings) {
    messages.push_back({NoticeKind::warning, limb + ": " + warning + "."});
  }
  if (const std::string problem = tipProblem(solved); !problem.empty()) {
    messages.push_back({NoticeKind::info, problem});
  }
  if (look.bodyTravels) {
    messages.push_back(
        {NoticeKind::info,
         "Seen from the hips (space Root): in this range the body travels farther than half of the limb's "
         "own way, which would drag the path along."});
  }
  return messages;
}

/// Scrolls the panel so far that what was drawn from `top` on is seen, as much of it as the panel holds.
void scrollTo(float top) {
  const float panelTop = ImGui::GetWindowPos().y;
  const float hidden = ImGui::GetCursorScreenPos().y - (panelTop + ImGui::GetWindowHeight());
  if (hidden > 0.0F) {
    ImGui::SetScrollY(ImGui::GetScrollY() + std::min(hidden, top - panelTop));
  }
}

/// Two lines for all messages, so that the settings below keep their place; a click lists them in full.
void messageRows(PanelContext& context, const std::vector<Message>& messages) {
  if (messages.empty()) {
    return;
  }
  const float top = ImGui::GetCursorScreenPos().y;
  const std::size_t others = messages.size() - 1;
  bool& open = context.ui.trails.allWarnings;
  const std::string more = open ? "less" : others > 0 ? fmt::format("+{} more", others) : "more";
  const bool clicked = noticeLines(widgetsOf(context), "trail/messages", messages.front().kind,
                                   messages.front().text, more, open);
  open = clicked ? !open : open;
  for (std::size_t i = 1; open && i < messages.size(); ++i) {
    notice(widgetsOf(context), messages[i].kind, messages[i].text);
  }
  if (clicked && open) {
    scrollTo(top);
  }
}

} // namespace

std::vector<Choice> styleChoices(const std::vector<rig::Style>& styles) {
  const auto times = [](const rig::ScaleRange& range) { return "\xC3\x97" + shortNumber(range.usual); };
  std::vector<Choice> choices;
  for (const rig::Style& style : styles) {
    const std::string origin = style.origin == rig::StyleOrigin::measured ? "Measured"
                               : style.origin == rig::StyleOrigin::ours   ? "Made for this program"
                                                                          : "Your own";
    Choice choice{style.name};
    choice.help = {style.name,
                   origin + ": arms " + times(style.arm) + ", body " + times(style.torso) + ", legs " +
                       times(style.leg),
                   {}};
    const char* const whose = style.origin == rig::StyleOrigin::measured ? "measured"
                              : style.origin == rig::StyleOrigin::ours   ? "ours"
                                                                         : "yours";
    choice.note = fmt::format("{}  {} arms  {} legs  {} torso", whose, times(style.arm), times(style.leg),
                              times(style.torso));
    choices.push_back(std::move(choice));
  }
  return choices;
}

ShownStyle shownStyle(const TrailPanels& panels, const app::Document& document,
                      const std::vector<int>& trails) {
  const TakenStyle& taken = panels.takenStyle;
  if (!taken.isFor(document.scene, trails)) {
    return {};
  }
  const rig::Style& style = panels.styles[static_cast<std::size_t>(taken.style)];
  const bool areAsMade = std::ranges::all_of(trails, [&](int id) {
    const auto made = std::ranges::find(taken.made, id, &rig::Trail::id);
    const rig::Trail* const now = app::findTrail(document, id);
    return made != taken.made.end() && now != nullptr && made->settings == now->settings;
  });
  return {areAsMade || app::hasStyle(document, trails, style) ? taken.style : -1, style.name + ", changed"};
}

void rangeRow(PanelContext& context, const rig::Trail& trail) {
  const WidgetContext widgets = widgetsOf(context);
  labelledRow(widgets, "Range", {"Range", "First and last frame of the trail.", {}});
  const double last = app::lastFrame(context.character().document(), trail.clip);
  const float width = columnWidth(2);
  SliderSpec spec{.id = "trail/range-start",
                  .minimum = 0.0,
                  .maximum = last,
                  .step = 1.0,
                  .decimals = 0,
                  .showsFill = false,
                  .width = width};
  spec.help = {"First frame", "Drag, or click and type.", keyOf(context, command::rangeStart)};
  double start = trail.settings.startFrame;
  spec.decimals = frameDecimals(start); // After a change of the rate it may lie between frames.
  EditPhase phase = slider(widgets, spec, start);
  editRange(context, phase, [&](TrailSettings& s) { s.startFrame = std::min(start, s.endFrame - 1.0); });
  ImGui::SameLine();
  spec.id = "trail/range-end";
  spec.help = {"Last frame", "Drag, or click and type.", keyOf(context, command::rangeEnd)};
  double end = trail.settings.endFrame;
  spec.decimals = frameDecimals(end);
  phase = slider(widgets, spec, end);
  editRange(context, phase, [&](TrailSettings& s) { s.endFrame = std::max(end, s.startFrame + 1.0); });
}

void scaleRows(PanelContext& context, const rig::Trail& trail) {
  trailRow(context, trail, "scale", {}, scaleExtras(context, trail));
  styleRow(context);
  trailSection(context, trail, "tip", {}, {"scale"});
}

void tipMessages(PanelContext& context, int trailId) {
  const rig::SolvedTrail* solved = app::solvedTrail(context.character(), trailId);
  if (solved == nullptr) {
    return;
  }
  const TipLengths lengths = tipLengths(context.character(), *solved);
  valueRow(widgetsOf(context), "Tip length", lengthsText(lengths),
           {.title = "Length of the limb at the tip",
            .text = "Straight from its base to its end: in the source clip, and as it is now."});
  if (!solved->trail.exaggerated) {
    return;
  }
  messageRows(context, messagesOf(context, *solved));
  if (lookAt(context, *solved).clipCouldLoop) {
    commandButton(context, {.command = command::clipLoop,
                            .text = "Let the clip loop",
                            .width = ImGui::GetContentRegionAvail().x});
  }
  if (solved->tip.moved) {
    proposeRangeEnd(context, *solved);
  }
}

} // namespace stretch::ui
