#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/shell/shell.h"

namespace stretch::test {

/// A state of the program by name, as text; nothing for a name that there is not:
/// dialog, dialog.folder, dialog.row, dialog.asks (whether to replace), dialog.joints, dialog.clips, file,
/// unsaved, saved-path, trails, frame, last-frame, playing, limbs ("left-arm spine"), plan (of the body:
/// "quadruped"), trail (of the selected one: trail.scale, trail.axes "xz", trail.start, trail.end,
/// trail.pivot, trail.exaggerated, trail.connected, trail.applied, trail.visible, trail.spheres, trail.blend,
/// trail.release, trail.ease-in, trail.space, trail.view-axes "0 0 -1 0 1 0 1 0 0" of the document), spheres
/// (selected), modal, undo, redo, ghosts, navigation, original, tip-ratio (length of the limb at the tip over
/// the source's), group (limbs of the selected trail's), group.name, colours ("0 1", of all trails),
/// rename.typed, on-a-two (the playhead stands on an even frame), scales ("3 2", of all trails),
/// shown-spheres and tangents (of the selected trail), loops (the clip), warnings (in the panel), tip-ghost
/// (the frame whose pose is shown, or none), tip-told-out (of the picture), tooltip, weight.limbs
/// ("left-arm left-leg"), weight.stiffness (of the selected limb), busy, toast. While a mesh sequence is
/// open: sequence (its name), sequence.frames, sequence.compressed, sequence.outdated, sequence.bones,
/// sequence.original, sequence.skinned, sequence.look, sequence.skip, sequence.moduli; compressing.
/// tour (its step, from 1; 0: it does not run), welcome (its highlighted entry, from 1; 0: a file is open).
/// keys.picked (in graph and dope sheet), keys.rows (in how many rows), keys.first (frame and value of the
/// first of them), keys.slopes (before and after it), keys.auto (whose
/// tangents follow their neighbours), holds (pins, grips and props), added-files (whose things the character
/// holds), asks-drop (what a dropped file is for), keys.edited (tracks of the viewed clip that are not the
/// source's), graph.curves (that are seen), retime (its dialog is open), retime.past (what will stand past
/// the end). Of poses: controllers (that are selected), adjusted (ids in the clip), moved and turned ("0 -0.1
/// 0" and degrees, of the first selected one at the playhead), offset-keys (how many the selection has),
/// auto-key, value.ID (of an attribute at the playhead), pins ("left-arm 21 to 27, left-leg 3 to 9", of the
/// clip), working (beside the window), locator.NAME (where it stands, "0.1 1.2 0"), joint.NAME (where a joint
/// stands at rest), bound (whether a mesh follows a skin),
/// locators-shown, weights-of (the joint whose weights are drawn, or none). toasts-in-picture (they cover
/// nothing else), toasts-on-figure (one covers the character), tour.share (of the picture's height, that of
/// the tour's card), menu-over-bars (the menu at the mouse covers a bar), menu-in-window.
[[nodiscard]] std::optional<std::string> stateOf(ui::Shell& shell, std::string_view name);

/// Whether two states are the same: as numbers within a thousandth, else as text.
[[nodiscard]] bool sameState(const std::string& a, const std::string& b);

} // namespace stretch::test
