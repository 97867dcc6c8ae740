#include "ui/panels/context/key_bar.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "app/commands/keys/keys.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/past_end.h"
#include "app/commands/table/selection.h"
#include "app/edits/keys/retime.h"
#include "app/named.h"
#include "ui/panels/context/dialog_frame.h"
#include "ui/panels/context/panel_support.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

void editPicked(PanelContext& context, const EditPhase& phase, const std::string& verb,
                const PickedChange& change) {
  app::Session& session = context.character();
  GraphState& graph = context.ui.time.graph;
  if (!phase.changed && !phase.ended) {
    return;
  }
  if (!session.isDragging()) {
    graph.heldKeys = app::pickedKeys(session);
  }
  app::KeySelection picked = graph.heldKeys;
  const std::string label = verb + " " + app::selectionTitle(session.document(), graph.heldKeys);
  editThrough(context, {phase.changed && !graph.heldKeys.empty(), phase.ended}, label,
              [&](const app::Document& start) -> Result<app::Document> {
                Result<app::EditedKeys> edited = change(start, graph.heldKeys);
                if (!edited) {
                  return edited.error();
                }
                picked = std::move(edited->picked);
                return std::move(edited->document);
              });
  if (phase.changed && !picked.empty()) {
    app::pickKeys(session, picked, false);
  }
}

namespace {

bool selectsTheSame(const KeptPicks& a, const KeptPicks& b) {
  return a.clip == b.clip && a.limbs == b.limbs && a.controllers == b.controllers;
}

KeptPicks picksNow(const app::Session& session) {
  const app::ViewState& view = session.view();
  return {app::pickedKeys(session), view.clip, view.selection.limbs(), view.selection.controllers(),
          session.document().clips};
}

} // namespace

void followPicks(TimePanes& time, app::Session& session) {
  KeptPicks now = picksNow(session);
  const bool isOther = time.picks != nullptr && !selectsTheSame(now, *time.picks);
  if (isOther && !now.keys.empty() && now.keys == time.picks->keys && !session.isDragging()) {
    app::pickKeys(session, {}, false);
    now.keys.clear();
  }
  const bool areOtherClips = time.picks == nullptr || now.clips.lock() != time.picks->clips.lock();
  if (areOtherClips || isOther || now.keys != time.picks->keys) {
    time.picks = std::make_shared<const KeptPicks>(std::move(now));
  }
  if (!session.isDragging()) { // what is tried is no step yet, and its keys stand at other places
    time.picksAt[session.history().position()] = time.picks;
  }
}

void bringBackPicks(const TimePanes& time, app::Session& session) {
  const auto kept = time.picksAt.find(session.history().position());
  const bool isKept = kept != time.picksAt.end() && kept->second->clips.lock() == session.document().clips;
  if (isKept && selectsTheSame(*kept->second, picksNow(session))) {
    app::pickKeys(session, app::stillThere(session.document(), session.view().clip, kept->second->keys),
                  false);
  }
}

namespace {

/// Where the first picked key of the selection stands, and its first picked value.
struct FirstKey {
  double frame = 0.0;
  double value = 0.0;
};
FirstKey firstKey(const app::Session& session, const app::KeySelection& picked) {
  const app::PickedRow& row = picked.front();
  const app::KeyedRow read = app::readRow(session.document(), session.view().clip, row.row);
  const app::PickedKey& key = row.keys.front();
  std::size_t component = 0;
  while (component + 1 < read.components && (key.components >> component & 1U) == 0) {
    ++component;
  }
  const app::RowKey& stored = read.keys[at(key.key)];
  return {stored.frame, stored.values[component]};
}

void keyNumbers(PanelContext& context, bool isNarrow) {
  const float width = context.theme.px(isNarrow ? 74.0F : 92.0F);
  app::Session& session = context.character();
  const app::KeySelection& picked = app::pickedKeys(session);
  const FirstKey first = firstKey(session, picked);
  const int clip = session.view().clip;
  const double last = app::lastFrame(session.document(), clip);
  double frame = first.frame;
  const EditPhase inTime =
      slider(widgetsOf(context),
             {.id = "keys/frame",
              .minimum = 0.0,
              .maximum = std::max(1.0, last),
              .step = 1.0,
              .fineStep = 0.1,
              .decimals = frameDecimals(frame),
              .prefix = isNarrow || frameDecimals(frame) > 0 ? "" : "Frame ",
              .hardMaximum = 1e5,
              .showsFill = false,
              .width = width,
              .help = {"Frame of the key", "Of several, the first: all move with it.", {}}},
             frame);
  editPicked(context, inTime, "Move", [&](const app::Document& start, const app::KeySelection& held) {
    const std::vector<double> before = app::keyFramesOf(start, clip, held.front().row);
    return app::moveKeys(start, clip, held, {frame - before[at(held.front().keys.front().key)], 0.0});
  });
  ImGui::SameLine();
  double value = first.value;
  const double reach = std::max(1.0, 2.0 * std::abs(value));
  const EditPhase inValue =
      slider(widgetsOf(context),
             {.id = "keys/value",
              .minimum = -reach,
              .maximum = reach,
              .step = 0.01,
              .decimals = 3,
              .hardMinimum = -1e6,
              .hardMaximum = 1e6,
              .showsFill = false,
              .width = width,
              .help = {"Value of the key", "What is typed goes to every picked value.", {}}},
             value);
  editPicked(context, inValue, "Set", [&](const app::Document& start, const app::KeySelection& held) {
    return app::setKeyValue(start, clip, held, value);
  });
}

void tangentChooser(PanelContext& context) {
  const std::vector<std::pair<const char*, const char*>> kinds{{"Auto", command::keysAuto},
                                                               {"Flat", command::keysFlat},
                                                               {"Linear", command::keysLinear},
                                                               {"Stepped", command::keysStepped},
                                                               {"Free", command::keysFree}};
  std::vector<Choice> choices;
  for (const auto& [name, id] : kinds) {
    const CommandInfo* const info = findCommand(context, id);
    choices.push_back({name, {name, info != nullptr ? info->help : "", {}}});
  }
  const int chosen = dropdown(widgetsOf(context), "keys/tangents", choices, -1,
                              {"Tangents", "How the curve passes the picked keys.", {}},
                              context.theme.px(112.0F), "Tangents");
  if (chosen >= 0) {
    request(context, kinds[static_cast<std::size_t>(chosen)].second);
  }
}

} // namespace

void drawKeyBar(PanelContext& context, bool keysAlone) {
  if (!keysAlone) {
    commandButton(
        context,
        {.command = command::keysRetime, .icon = icon::clock, .text = "Retime", .emphasis = Emphasis::quiet});
  }
  if (!app::hasPickedKeys(context.character())) {
    return;
  }
  if (!keysAlone) {
    ImGui::SameLine();
  }
  tangentChooser(context);
  ImGui::SameLine();
  keyNumbers(context, keysAlone);
}

namespace {

void framesSlider(PanelContext& context, const char* id, const char* label, const char* help, double& frame) {
  static_cast<void>(slider(widgetsOf(context),
                           {.id = id,
                            .minimum = 0.0,
                            .maximum = std::max(100.0, 2.0 * frame),
                            .step = 1.0,
                            .decimals = frameDecimals(frame),
                            .prefix = label,
                            .hardMaximum = 1e5,
                            .showsFill = false,
                            .help = {label, help, {}}},
                           frame));
}

/// The limb that is selected, or whose controller is; empty for none.
std::string limbOfRetime(const app::Session& session) {
  const app::Selection& selection = session.view().selection;
  if (!selection.limbs().empty() || selection.controllers().empty()) {
    return selection.limbs().empty() ? std::string() : selection.limbs().front();
  }
  const rig::ControllerList list = app::controllersOf(session.document());
  const rig::Controller* const controller = list.controller(selection.controllers().front());
  return controller == nullptr ? std::string() : controller->limb;
}

void retimeRows(PanelContext& context) {
  RetimeState& state = context.ui.time.retime;
  framesSlider(context, "retime/first", "From frame ", "The first frame of what is made slower or faster.",
               state.firstFrame);
  framesSlider(context, "retime/last", "To frame ", "Its last frame.", state.lastFrame);
  framesSlider(context, "retime/length", "Frames that it takes: ",
               "How many frames it is to take. Left and Right take one away, and add one.", state.newFrames);
  const double length = state.lastFrame - state.firstFrame;
  double percent = length > 0.0 ? 100.0 * length / std::max(state.newFrames, 1e-6) : 100.0;
  const EditPhase sped = slider(widgetsOf(context),
                                {.id = "retime/speed",
                                 .minimum = 10.0,
                                 .maximum = 190.0,
                                 .step = 5.0,
                                 .decimals = 0,
                                 .prefix = "Speed ",
                                 .suffix = " %",
                                 .defaultValue = 100.0,
                                 .hardMinimum = 1.0,
                                 .hardMaximum = 10000.0,
                                 .help = {"Speed", "100 % is as it was; 50 % takes twice as long.", {}}},
                                percent);
  if (sped.changed && length > 0.0) {
    state.newFrames = length * 100.0 / percent;
  }
  const double frames = ImGui::GetIO().WantTextInput            ? 0.0
                        : keyPressed(ImGuiKey_RightArrow, true) ? 1.0
                        : keyPressed(ImGuiKey_LeftArrow, true)  ? -1.0
                                                                : 0.0;
  if (frames != 0.0) {
    state.newFrames = std::max(1.0, std::round(state.newFrames) + frames);
  }
  if (toggle(widgetsOf(context), "retime/after", "What comes after moves along", state.movesAfter,
             {"What comes after", "Off: it stays, and gives way where the range reaches it.", {}})) {
    state.movesAfter = !state.movesAfter;
  }
  const std::string limb = limbOfRetime(context.character());
  const std::string name = limb.empty() ? "a limb" : app::limbTitle(context.character().document(), limb);
  if (toggle(widgetsOf(context), "retime/limb", "Only " + name, !state.limb.empty(),
             {"Only the selected limb",
              limb.empty() ? "Select a limb or one of its controllers first."
                           : "Off: the whole body, with trails and controllers.",
              {}},
             !limb.empty())) {
    state.limb = state.limb.empty() ? limb : std::string();
  }
}

app::Retime wantedRetime(const RetimeState& state) {
  return {state.firstFrame, state.lastFrame, state.newFrames, state.movesAfter, state.limb};
}

/// What the clip will be like, looked at again where another retime is asked for.
void lookAhead(PanelContext& context) {
  RetimeState& state = context.ui.time.retime;
  const app::Retime wanted = wantedRetime(state);
  if (state.looked == wanted) {
    return;
  }
  const app::Document& document = context.character().document();
  const int clip = context.character().view().clip;
  const Result<app::Document> made = app::retimed(document, clip, wanted);
  state.looked = wanted;
  state.past.clear();
  state.problem = made ? std::string() : made.error().line();
  if (!made) {
    return;
  }
  const std::string now = shortNumber(app::lastFrame(document, clip));
  const std::string then = shortNumber(app::lastFrame(*made, clip));
  state.ends = now == then ? fmt::format("The clip ends at frame {}, as now.", now)
                           : fmt::format("The clip will end at frame {}; now it ends at {}.", then, now);
  if (app::lastFrame(*made, clip) < app::lastFrame(document, clip)) {
    state.past = app::standingPastEnd(*made, clip);
  }
}

void aheadRows(PanelContext& context) {
  const WidgetContext widgets = widgetsOf(context);
  const RetimeState& state = context.ui.time.retime;
  if (!state.problem.empty()) {
    notice(widgets, NoticeKind::error, state.problem);
    return;
  }
  note(widgets, state.ends);
  if (!state.past.empty()) {
    constexpr std::size_t most = 5;
    std::string text = "Past that end, where it has no effect: ";
    for (std::size_t i = 0; i < std::min(most, state.past.size()); ++i) {
      text += (i > 0 ? ", " : "") + state.past[i];
    }
    text += state.past.size() > most ? fmt::format(" and {} more.", state.past.size() - most) : ".";
    notice(widgets, NoticeKind::warning, text);
  }
}

/// Picks the keys that a retime has left between frames, for a clip that had none there, and says how they
/// come onto whole ones.
void pickLeftBetweenFrames(PanelContext& context, bool hadSome) {
  app::Session& session = context.character();
  const app::KeySelection off = app::keysOffFrames(session.document(), session.view().clip);
  if (hadSome || off.empty()) {
    return;
  }
  app::pickKeys(session, off, false);
  const CommandInfo* const snap = findCommand(context, command::keysSnap);
  tell(context.ui, ToastKind::info,
       fmt::format("Between frames now, and picked: {}. Keys, {} moves what is picked to whole frames",
                   app::selectionTitle(session.document(), off),
                   snap == nullptr ? "Snap keys" : snap->label));
}

void retime(PanelContext& context) {
  const RetimeState& state = context.ui.time.retime;
  const app::Session& session = context.character();
  const bool hadSome = !app::keysOffFrames(session.document(), session.view().clip).empty();
  const app::Retime wanted = wantedRetime(state);
  const std::string whose = state.limb.empty() ? "the clip" : app::limbTitle(session.document(), state.limb);
  editOnce(context,
           fmt::format("Retime {}: frames {:g} to {:g} take {:g}", whose, state.firstFrame, state.lastFrame,
                       std::round(state.newFrames * 100.0) / 100.0),
           app::retimed(session.document(), session.view().clip, wanted));
  pickLeftBetweenFrames(context, hadSome);
}

} // namespace

void drawRetimeDialog(PanelContext& context) {
  RetimeState& state = context.ui.time.retime;
  state.wasOpen = state.open;
  if (!beginDialog(context, {.id = "retime", .icon = icon::clock, .title = "Retime", .width = 380.0F},
                   state.open)) {
    return;
  }
  retimeRows(context);
  lookAhead(context);
  aheadRows(context);
  const bool changes = state.newFrames != state.lastFrame - state.firstFrame;
  const bool entered = enterPressed() && !ImGui::GetIO().WantTextInput && changes;
  const int clicked = dialogButtons(
      context, "retime", {{.id = "", .text = "Cancel"}, {.id = "", .text = "Retime", .enabled = changes}});
  if (entered || clicked == 1) {
    retime(context);
  }
  if (entered || clicked >= 0) {
    state.open = false;
    ImGui::CloseCurrentPopup();
  }
  endDialog();
}

} // namespace stretch::ui
