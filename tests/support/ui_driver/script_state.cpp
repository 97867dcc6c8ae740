#include "tests/support/ui_driver/script_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <imgui_internal.h>

#include "app/commands/keys/keys.h"
#include "app/commands/pose/posing.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/spheres.h"
#include "app/edits/keys/key_edits.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/pose/offset_edits.h"
#include "app/edits/trail/group_edits.h"
#include "core/anim/sampling.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "rig/limb.h"
#include "skinning/linear_blend_skinning.h"
#include "tests/support/ui_driver/kept_state.h"
#include "tests/support/ui_driver/shown_places.h"
#include "ui/panels/context/view_schema.h"
#include "ui/shell/file_work.h"
#include "ui/shell/style_work.h"

namespace stretch::test {

using namespace ui;

namespace {

std::string yesNo(bool value) {
  return value ? "yes" : "no";
}
std::string number(double value) {
  return fmt::format("{:.6g}", value);
}

/// Of a clip, where there is one.
std::size_t editedTrackCount(const app::Document& document, int clip) {
  return app::hasClip(document, clip) ? app::editedTracks(document, clip).size() : 0;
}

std::string placeText(const Vec3& place) {
  const auto rounded = [](double x) { return std::round(1000.0 * x) / 1000.0 + 0.0; }; // No -0.
  return fmt::format("{:.6g} {:.6g} {:.6g}", rounded(place.x), rounded(place.y), rounded(place.z));
}

std::string placeOfLocator(const app::Document& document, std::string_view name) {
  const rig::Locator* const locator = rig::findLocator(document.locators, name);
  return locator == nullptr ? "none" : placeText(locator->position);
}

std::string placeOfJoint(const Scene& scene, std::string_view name) {
  const std::vector<Mat4> worlds = worldMatrices(scene, restPose(scene));
  const auto found = std::ranges::find(scene.nodes, name, &Node::name);
  return found == scene.nodes.end()
             ? "none"
             : placeText(positionOf(worlds[static_cast<std::size_t>(found - scene.nodes.begin())]));
}

bool hasBoundMesh(const Scene& scene) {
  return std::ranges::any_of(scene.nodes, [](const Node& node) { return node.mesh >= 0 && node.skin >= 0; });
}

std::string axesOf(const rig::TrailSettings& settings) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    text += settings.axes[i] ? std::string(1, "xyz"[i]) : std::string();
  }
  return text;
}

/// "1 0 0 0 1 0 0 0 1": the world directions to the right, up and towards the viewer, to a hundredth.
std::string viewAxesText(const Mat3& axes) {
  std::vector<double> values;
  for (glm::length_t column = 0; column < 3; ++column) {
    for (glm::length_t row = 0; row < 3; ++row) {
      values.push_back(std::round(100.0 * axes[column][row]) / 100.0 + 0.0); // No -0.
    }
  }
  return fmt::format("{:.6g}", fmt::join(values, " "));
}

std::string spaceText(rig::TrailSpace space) {
  constexpr std::array<const char*, 4> names{"world", "root", "base", "view"};
  return names[static_cast<std::size_t>(space)];
}

std::optional<std::string> trailState(const rig::Trail& trail, std::string_view name) {
  const rig::TrailSettings& settings = trail.settings;
  const std::map<std::string_view, std::string> states{
      {"trail.limb", trail.limb},
      {"trail.name", trail.name},
      {"trail.colour", std::to_string(trail.colour)},
      {"trail.scale", number(settings.scale)},
      {"trail.axes", axesOf(settings)},
      {"trail.start", number(settings.startFrame)},
      {"trail.end", number(settings.endFrame)},
      {"trail.pivot", settings.pivot == rig::Pivot::start ? "start" : "end"},
      {"trail.blend", number(settings.blend)},
      {"trail.volume", number(settings.volume)},
      {"trail.release", settings.releaseFrames ? number(*settings.releaseFrames) : "default"},
      {"trail.ease-in", number(settings.easeIn.percent)},
      {"trail.ease-out", number(settings.easeOut.percent)},
      {"trail.space", spaceText(settings.space)},
      {"trail.view-axes", viewAxesText(settings.viewAxes)},
      {"trail.spheres", std::to_string(settings.spheres.size())},
      {"trail.exaggerated", yesNo(trail.exaggerated)},
      {"trail.connected", yesNo(trail.connected)},
      {"trail.follow", yesNo(trail.follow)},
      {"trail.visible", yesNo(trail.visible)},
      {"trail.applied", yesNo(trail.applied)},
  };
  const auto found = states.find(name);
  return found == states.end() ? std::nullopt : std::optional(found->second);
}

/// How many times as long as in the source the limb is at its trail's tip.
std::string tipRatio(app::Session& session) {
  const rig::Trail* trail = app::selectedTrail(session);
  const rig::Limb* limb = trail == nullptr ? nullptr : app::findLimb(session.document(), trail->limb);
  if (limb == nullptr) {
    return "none";
  }
  const rig::TrailSettings& settings = trail->settings;
  const double tip = settings.pivot == rig::Pivot::start ? settings.endFrame : settings.startFrame;
  const double source = rig::limbLength(*limb, session.originalAt(tip));
  return fmt::format("{:.3f}", rig::limbLength(*limb, session.frameAt(tip)) / source);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

/// Limbs with weight in the viewed clip: "left-arm left-leg".
std::string heavyLimbs(const app::Session& session) {
  std::vector<std::string> limbs;
  for (const app::WeightedLimb& entry : session.document().weights) {
    if (entry.on && entry.clip == session.view().clip) {
      limbs.push_back(entry.limb);
    }
  }
  return joined(limbs);
}

std::string heavyStiffness(const app::Session& session) {
  const std::vector<std::string> limbs = app::targetLimbs(session);
  const app::WeightedLimb* const entry =
      limbs.empty() ? nullptr : app::findWeight(session.document(), limbs.front(), session.view().clip);
  return entry == nullptr ? "none" : number(entry->settings.stiffness);
}

/// Whether a program that knows nothing of the work plays the saved file as it is drawn here: every vertex at
/// every frame, within a thousandth of the character's height. "yes" where there is no clip to play.
std::string playsAsDrawn(app::Session& session) {
  const Result<gltf::Loaded> saved = gltf::loadAsItStands(session.savePath());
  if (!saved) {
    return saved.error().line();
  }
  const int clip = session.view().clip;
  if (!app::hasClip(session.document(), clip)) {
    return "yes";
  }
  const Clip& played = saved->clips[static_cast<std::size_t>(clip)];
  const double rate = app::clipOf(session.document(), clip).framesPerSecond;
  for (double frame = 0.0; frame <= app::lastFrame(session.document(), clip); frame += 1.0) {
    const double seconds = frame / rate;
    const std::vector<Vec3> drawn =
        skinning::skinnedPositions(*session.document().scene, session.frameAt(frame));
    const std::vector<Vec3> seen = skinning::skinnedPositions(
        *saved->scene, frameOf(*saved->scene, samplePose(*saved->scene, played, seconds), seconds));
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (i >= seen.size() || !(glm::length(drawn[i] - seen[i]) <= 1e-3 * session.document().body.height)) {
        return fmt::format("not at frame {}", frame);
      }
    }
  }
  return "yes";
}

/// Limbs of the selected trail's group: "left-arm spine"; empty where it stands alone.
std::string groupLimbs(const app::Session& session) {
  std::vector<std::string> limbs;
  for (const int id : app::groupMembers(session.document(), session.view().selection.trail())) {
    limbs.push_back(app::findTrail(session.document(), id)->limb);
  }
  return joined(limbs);
}

/// Of all trails of the viewed clip, in their order, by their places in the palette: "0 1".
std::string coloursOf(const app::Session& session) {
  std::vector<std::string> colours;
  for (const rig::Trail& trail : session.document().trails) {
    if (trail.clip == session.view().clip) {
      colours.push_back(std::to_string(trail.colour));
    }
  }
  return joined(colours);
}

/// Of all trails of the viewed clip, in their order: "3 3 2".
std::string scalesOf(const app::Session& session) {
  std::vector<std::string> scales;
  for (const rig::Trail& trail : session.document().trails) {
    if (trail.clip == session.view().clip) {
      scales.push_back(number(trail.settings.scale));
    }
  }
  return joined(scales);
}

std::string tangentCount(const app::Session& session) {
  const rig::Trail* const trail = app::selectedTrail(session);
  return trail == nullptr ? "none"
                          : std::to_string(std::count_if(
                                trail->settings.spheres.begin(), trail->settings.spheres.end(),
                                [](const rig::SphereOffset& sphere) { return sphere.tangent.has_value(); }));
}

/// "left-arm 21 to 27, left-leg 3 to 9".
std::string pinsText(const app::Document& document, int clip) {
  std::string text;
  for (const rig::Pin& pin : app::holdsOfClip(document.holds, clip).pins) {
    text += (text.empty() ? "" : ", ") + pin.limb + " " + number(pin.time.rangeFrames.x) + " to " +
            number(pin.time.rangeFrames.y);
  }
  return text;
}

/// Three numbers of what the first selected controller is offset by at the playhead.
std::string offsetText(const app::Session& session, Vec3 app::ControllerOffset::*vector, double unit) {
  if (!app::hasControllers(session)) {
    return "none";
  }
  const app::ControllerOffset offset =
      app::shownOffset(session, session.view().selection.controllers().front());
  const Vec3 shown = unit * (offset.*vector);
  return joined({number(shown.x), number(shown.y), number(shown.z)});
}

std::size_t followingCount(const app::Document& document) {
  std::size_t count = 0;
  for (const app::FollowingKeys& following : document.followingKeys) {
    count += following.keys.size();
  }
  return count;
}

/// Frame and first picked value of the first picked key, or its slopes before and after.
std::string firstPicked(const app::Session& session, bool slopes) {
  const app::KeySelection picked = app::pickedKeys(session);
  if (picked.empty()) {
    return "none";
  }
  const app::PickedKey& first = picked.front().keys.front();
  const app::KeyedRow row = app::readRow(session.document(), session.view().clip, picked.front().row);
  const app::RowKey& key = row.keys[at(first.key)];
  std::size_t component = 0;
  while (component + 1 < row.components && (first.components >> component & 1U) == 0) {
    ++component;
  }
  return slopes ? joined({number(key.inSlopes[component]), number(key.outSlopes[component])})
                : joined({number(key.frame), number(key.values[component])});
}

/// States of graph, dope sheet and what they edit.
std::optional<std::string> keyState(const Shell& shell, std::string_view name) {
  const app::Session& session = *shell.open.character();
  const app::ViewState& view = session.view();
  const std::map<std::string_view, std::function<std::string()>> states{
      {"keys.picked", [&] { return std::to_string(app::keyCount(view.pickedKeys)); }},
      {"keys.auto", [&] { return std::to_string(followingCount(session.document())); }},
      {"holds",
       [&] {
         const rig::Holds& holds = session.document().holds;
         return std::to_string(holds.pins.size() + holds.grips.size() + holds.props.size());
       }},
      {"added-files",
       [&] {
         std::vector<std::string> files;
         for (const gltf::AddedFile& file : session.document().addedFiles) {
           files.push_back(file.file);
         }
         return joined(files);
       }},
      {"keys.first", [&] { return firstPicked(session, false); }},
      {"keys.slopes", [&] { return firstPicked(session, true); }},
      {"keys.rows", [&] { return std::to_string(view.pickedKeys.size()); }},
      {"keys.edited", [&] { return std::to_string(editedTrackCount(session.document(), view.clip)); }},
      {"graph.curves",
       [&] { return std::to_string(std::ranges::count(shell.ui.time.graph.curves, false, &Curve::hidden)); }},
      {"retime", [&] { return yesNo(shell.ui.time.retime.open); }},
      {"retime.past", [&] { return std::to_string(shell.ui.time.retime.past.size()); }},
  };
  const auto found = states.find(name);
  return found == states.end() ? std::nullopt : std::optional(found->second());
}

std::optional<std::string> sessionState(Shell& shell, std::string_view name) {
  app::Session& session = *shell.open.character();
  const app::ViewState& view = session.view();
  const std::map<std::string_view, std::function<std::string()>> states{
      {"trails", [&] { return std::to_string(session.document().trails.size()); }},
      {"frame", [&] { return number(view.frame); }},
      {"on-a-frame", [&] { return yesNo(view.frame > 0.0 && view.frame == std::round(view.frame)); }},
      {"on-a-two", [&] { return yesNo(view.frame > 0.0 && std::fmod(view.frame, 2.0) == 0.0); }},
      {"last-frame", [&] { return number(app::lastFrame(session.document(), view.clip)); }},
      {"limbs", [&] { return joined(view.selection.limbs()); }},
      {"plan", [&] { return session.document().body.plan; }},
      {"controllers", [&] { return joined(view.selection.controllers()); }},
      {"locators", [&] { return joined(view.selection.locators()); }},
      {"locator-count", [&] { return std::to_string(session.document().locators.list.size()); }},
      {"adjusted", [&] { return joined(app::adjustedIds(session.document(), view.clip)); }},
      {"pins", [&] { return pinsText(session.document(), view.clip); }},
      {"moved", [&] { return offsetText(session, &app::ControllerOffset::move, 1.0); }},
      {"turned", [&] { return offsetText(session, &app::ControllerOffset::turn, 180.0 / pi); }},
      {"offset-keys", [&] { return std::to_string(app::offsetKeyFrames(session).size()); }},
      {"auto-key", [&] { return yesNo(view.autoKey); }},
      {"spheres", [&] { return std::to_string(view.selection.spheres().size()); }},
      {"range.start", [&] { return number(view.rangeStart); }},
      {"range.end", [&] { return number(view.rangeEnd); }},
      {"undo", [&] { return session.history().undoLabel(); }},
      {"redo", [&] { return session.history().redoLabel(); }},
      {"original", [&] { return yesNo(view.showOriginal); }},
      {"saved-path", [&] { return session.savePath().filename().string(); }},
      {"tip-ratio", [&] { return tipRatio(session); }},
      {"plays-as-drawn", [&] { return playsAsDrawn(session); }},
      {"shown-keys",
       [&] { return std::to_string(app::shownKeyFrames(session, view.selection.limbs()).size()); }},
      {"fps", [&] { return number(app::clipOf(session.document(), view.clip).framesPerSecond); }},
      {"history", [&] { return std::to_string(session.history().position()); }},
      {"group", [&] { return groupLimbs(session); }},
      {"colours", [&] { return coloursOf(session); }},
      {"scales", [&] { return scalesOf(session); }},
      {"tangents", [&] { return tangentCount(session); }},
      {"shown-spheres", [&] { return std::to_string(app::sphereFrames(session).size()); }},
      {"clips", [&] { return std::to_string(session.document().clips->size()); }},
      {"clip", [&] { return std::to_string(view.clip); }},
      {"trail", [&] { return std::to_string(view.selection.trail()); }},
      {"loops", [&] { return yesNo(app::isLooping(session.document(), view.clip)); }},
      {"warnings", [&] { return std::to_string(shell.ui.trails.look.warnings.size()); }},
      {"tip-told-out", [&] { return yesNo(shell.viewport.tipWatch.toldOutOfView); }},
      {"tip-ghost", [&] { return shell.viewport.tipFrame ? number(*shell.viewport.tipFrame) : "none"; }},
      {"autosaved", [&] { return yesNo(shell.files.isKeptAside(session)); }},
      {"weight.limbs", [&] { return heavyLimbs(session); }},
      {"weight.stiffness", [&] { return heavyStiffness(session); }},
      {"chains", [&] { return std::to_string(session.document().chains.size()); }},
  };
  if (const auto found = states.find(name); found != states.end()) {
    return found->second();
  }
  if (constexpr std::string_view value = "value."; name.starts_with(value)) {
    return number(app::shownValue(session, std::string(name.substr(value.size()))));
  }
  const rig::Trail* trail = app::selectedTrail(session);
  return trail == nullptr ? std::nullopt : trailState(*trail, name);
}

std::string nameOf(app::SequenceLook look) {
  return sequenceViewSchema().front().choices[static_cast<std::size_t>(look)].name;
}

std::optional<std::string> sequenceState(const app::SequenceSession& session, std::string_view name) {
  const app::SequenceDocument& document = session.document();
  const std::map<std::string_view, std::string> states{
      {"sequence", document.mesh->name},
      {"sequence.frames", std::to_string(document.mesh->frameCount())},
      {"sequence.compressed", yesNo(document.result != nullptr)},
      {"sequence.outdated", yesNo(app::isOutdated(document))},
      {"sequence.bones", document.result == nullptr
                             ? "none"
                             : std::to_string(document.result->compressed.skinned.bones.size())},
      {"sequence.original", yesNo(session.view().showOriginal)},
      {"sequence.skinned", yesNo(session.view().showSkinned)},
      {"sequence.look", nameOf(session.view().look)},
      {"sequence.skip", std::to_string(document.settings.body.firstFittedFrame)},
      {"sequence.skeleton",
       document.skeletonFile.empty() ? "none" : document.skeletonFile.filename().string()},
      {"sequence.encoded", yesNo(session.clip() != nullptr)},
      {"sequence.moduli", std::to_string(document.settings.body.moduli.ranges.size())},
      {"frame", number(session.view().frame)},
      {"last-frame", number(app::lastFrame(session))},
      {"undo", session.history().undoLabel()},
      {"redo", session.history().redoLabel()},
  };
  const auto found = states.find(name);
  return found == states.end() ? std::nullopt : std::optional(found->second);
}

/// In the frame before.
bool showsTooltip() {
  const auto& windows = ImGui::GetCurrentContext()->Windows;
  return std::any_of(windows.begin(), windows.end(), [](const ImGuiWindow* window) {
    return window->WasActive && !window->Hidden && (window->Flags & ImGuiWindowFlags_Tooltip) != 0;
  });
}

/// "1280x720"
std::string windowSize() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  return fmt::format("{}x{}", size.x, size.y);
}

/// The file that the dialog's list stands on, as its facts tell of it.
std::string dialogRow(const FileDialogState& dialog) {
  return dialog.factsPath.filename().string();
}

std::string weightsOf(const Shell& shell) {
  const NodeIndex joint = shell.viewport.weightsOf;
  return joint.exists() ? shell.open.character()->document().scene->nodes[at(joint)].name : "none";
}

/// States of locators, joints and weights.
std::optional<std::string> skinState(const Shell& shell, std::string_view name) {
  const app::Session& session = *shell.open.character();
  const Scene& scene = *session.document().scene;
  if (constexpr std::string_view locator = "locator."; name.starts_with(locator)) {
    return placeOfLocator(session.document(), name.substr(locator.size()));
  }
  if (constexpr std::string_view joint = "joint."; name.starts_with(joint)) {
    return placeOfJoint(scene, name.substr(joint.size()));
  }
  const std::map<std::string_view, std::string> states{
      {"locators-shown", yesNo(app::showsLocators(session))},
      {"bound", yesNo(hasBoundMesh(scene))},
      {"weights-of", weightsOf(shell)},
      {"working", yesNo(isBusy(shell))},
  };
  const auto found = states.find(name);
  return found == states.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::string> characterState(Shell& shell, std::string_view name) {
  if (std::optional<std::string> kept = keptState(shell, name)) {
    return kept;
  }
  if (std::optional<std::string> skin = skinState(shell, name)) {
    return skin;
  }
  const std::optional<std::string> key = keyState(shell, name);
  return key ? key : sessionState(shell, name);
}

/// States of what stands over the picture: messages, the tour's card, the clip in a style.
std::optional<std::string> messageState(const Shell& shell, std::string_view name) {
  const std::vector<Toast>& toasts = shell.ui.toasts;
  const std::map<std::string_view, std::string> states{
      {"toast", toasts.empty() ? std::string() : toasts.back().text},
      {"toasts-in-picture", toastsInPicture(shell)},
      {"toasts", std::to_string(toasts.size())},
      {"toast.share", shareOfPicture(shell, "toast/0")},
      {"toasts-on-figure", yesNo(toastsCoverFigure(shell))},
      {"tour.share", shareOfPicture(shell, "tour")},
      {"pane.bottom", shareBelowPicture(shell)},
      {"pane.left", shareLeftOfPicture(shell)},
      {"clip-style-open", yesNo(shell.ui.trails.clipStyle.open)},
      {"clip-style-working", yesNo(shell.ui.trails.clipStyle.open &&
                                   (shell.ui.trails.clipStyle.working || shell.ui.trails.clipStyle.changed))},
      {"clip-style", chosenStyle(shell).name},
  };
  const auto found = states.find(name);
  return found == states.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

std::optional<std::string> stateOf(Shell& shell, std::string_view name) {
  using Kind = app::FileQuestion::Kind;
  const Kind asked = shell.files.question().kind;
  const std::map<std::string_view, std::string> states{
      {"file", shell.files.path().filename().string()},
      {"unsaved", yesNo(app::hasUnsavedWork(shell.open))},
      {"tour", number(shell.ui.tour.step + 1)},
      {"welcome", number(shell.open.isEmpty() ? shell.ui.welcome.highlighted + 1 : 0)},
      {"busy", yesNo(shell.files.isOpening())},
      {"compressing", yesNo(shell.open.sequence() != nullptr && shell.open.sequence()->isCompressing())},
      {"exporting", yesNo(shell.open.sequence() != nullptr && shell.open.sequence()->isExporting())},
      {"modal", statusOf(shell).modalText},
      {"playing", yesNo(shell.ui.time.timeline.playing)},
      {"ghosts", yesNo(shell.ui.overlays.ghosts)},
      {"navigation", shell.ui.navigation == NavigationStyle::maya ? "maya" : "blender"},
      {"dialog", yesNo(shell.ui.dialogs.file.open)},
      {"dialog.folder", shell.ui.dialogs.file.folder.filename().string()},
      {"dialog.row", dialogRow(shell.ui.dialogs.file)},
      {"dialog.asks", yesNo(shell.ui.dialogs.file.confirmOverwrite)},
      {"dialog.joints", std::to_string(shell.ui.dialogs.file.facts.joints)},
      {"dialog.clips", std::to_string(shell.ui.dialogs.file.facts.clips.size())},
      {"palette", yesNo(shell.ui.dialogs.palette.open)},
      {"keys", yesNo(shell.ui.dialogs.keys.open)},
      {"settings", yesNo(shell.ui.dialogs.settingsOpen)},
      {"popup", yesNo(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))},
      {"asks-unsaved", yesNo(asked == Kind::unsaved)},
      {"asks-overwrite", yesNo(asked == Kind::overwrite)},
      {"offers-restore", yesNo(asked == Kind::restore)},
      {"asks-drop", yesNo(!shell.ui.dialogs.dropped.path.empty())},
      {"asks-clip", yesNo(!shell.ui.dialogs.clipPick.file.empty())},
      {"asks-clash", yesNo(shell.ui.dialogs.rangeClash.has_value())},
      {"view.start", number(shell.ui.time.timeline.viewStart)},
      {"view.fitted", yesNo(shell.ui.time.timeline.viewEnd < shell.ui.time.timeline.viewStart)},
      {"window", windowSize()},
      {"dialog.typed", shell.ui.dialogs.file.typed},
      {"menu-over-bars", yesNo(menuCoversBar(shell))},
      {"menu-in-window", yesNo(menuIsInWindow(shell))},
      {"rename.typed", shell.ui.trails.rename.typed},
      {"rename-open", yesNo(shell.ui.trails.rename.open)},
      {"history-open", yesNo(shell.ui.dialogs.history.open)},
      {"every-frame", yesNo(shell.ui.time.timeline.everyFrame)},
      {"on-twos", yesNo(shell.ui.time.timeline.onTwos)},
      {"left-pane", yesNo(shell.panes.leftOpen)},
      {"hovered-limb", shell.viewport.hoveredLimb},
      {"hovered-controller", shell.viewport.hoveredController},
      {"tooltip", yesNo(showsTooltip())},
      {"camera.distance", number(shell.viewport.camera.distance)},
      {"camera.yaw", number(shell.viewport.camera.yawRadians)},
  };
  if (const auto found = states.find(name); found != states.end()) {
    return found->second;
  }
  if (std::optional<std::string> message = messageState(shell, name)) {
    return message;
  }
  if (shell.open.sequence() != nullptr) {
    return sequenceState(*shell.open.sequence(), name);
  }
  return shell.open.character() == nullptr ? std::nullopt : characterState(shell, name);
}

bool sameState(const std::string& a, const std::string& b) {
  char* endOfA = nullptr;
  char* endOfB = nullptr;
  const double first = std::strtod(a.c_str(), &endOfA);
  const double second = std::strtod(b.c_str(), &endOfB);
  const bool numbers = !a.empty() && !b.empty() && *endOfA == '\0' && *endOfB == '\0';
  return numbers ? std::abs(first - second) < 1e-3 : a == b;
}

} // namespace stretch::test
