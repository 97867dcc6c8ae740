#include <algorithm>
#include <optional>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/needs.h"
#include "app/commands/table/tables.h"
#include "app/edits/keys/track_edits.h"

namespace stretch::app {

namespace {

Need pickedNeeded() {
  return {hasPickedKeys, "pick a key in the graph or the dope sheet first"};
}

bool hasKeyRows(const Session& session) {
  return !session.view().keyRows.empty();
}

Need rowsNeeded() {
  return {hasKeyRows, "open the graph or the dope sheet first"};
}

Need snapNeeded() {
  return {[](const Session& session) { return hasPickedKeys(session) || hasKeyRows(session); },
          "open the graph or the dope sheet first"};
}

Need copiedNeeded() {
  return {[](const Session& session) { return session.view().copiedKeys.has_value(); }, "copy keys first"};
}

Need editedNeeded() {
  return {[](const Session& session) { return hasEditedKeys(session.document()); },
          "the clip's own keys are as the file has them"};
}

bool canRestore(const Session& session) {
  const Selection& selection = session.view().selection;
  const bool anySelected = !selection.limbs().empty() || !selection.controllers().empty();
  return hasEditedKeys(session.document()) && (anySelected || hasPickedKeys(session));
}

std::string whyNotRestored(const Session& session) {
  return hasEditedKeys(session.document()) ? "pick keys, or select a limb or a controller first"
                                           : editedNeeded().text;
}

Status insertHere(Session& session) {
  const ViewState& view = session.view();
  return editKeys(session, insertKeys(session.document(), view.clip, view.keyRows, view.frame), "Insert");
}

Status deletePicked(Session& session) {
  return editKeys(session, removeKeys(session.document(), session.view().clip, pickedKeys(session)),
                  "Delete");
}

void copyPicked(Session& session) {
  session.view().copiedKeys = copyKeys(session.document(), session.view().clip, pickedKeys(session));
}

Status pasteHere(Session& session) {
  const ViewState& view = session.view();
  const std::optional<KeyRow> target =
      view.keyRows.size() == 1 ? std::optional(view.keyRows.front()) : std::nullopt;
  return editKeys(session, pasteKeys(session.document(), view.clip, *view.copiedKeys, view.frame, target),
                  "Paste");
}

// Without a pick, every key of the clip that stands between frames.
Status snapPicked(Session& session) {
  const Document& document = session.document();
  const int clip = session.view().clip;
  if (hasPickedKeys(session)) {
    return editKeys(session, snapKeys(document, clip, pickedKeys(session)), "Snap");
  }
  const KeySelection keys = keysOffFrames(document, clip);
  if (keys.empty()) {
    return Error{"every key of the clip stands on a whole frame", "", "pick keys to move them"};
  }
  Status done = editKeys(session, snapKeys(document, clip, keys), "Snap");
  pickKeys(session, {}, false); // rows that do not show are among them
  return done;
}

void pickAll(Session& session) {
  const ViewState& view = session.view();
  KeySelection shown = allKeys(session.document(), view.clip, view.keyRows);
  for (PickedRow& row : shown) {
    const auto components = view.keyComponents.find(row.row);
    for (PickedKey& key : row.keys) {
      key.components = components == view.keyComponents.end() ? key.components : components->second;
    }
  }
  pickKeys(session, shown, false);
}

// The rows of the picked keys; without any those of the selected limbs and controllers.
std::vector<KeyRow> rowsToRestore(const Session& session) {
  std::vector<KeyRow> rows;
  for (const PickedRow& picked : pickedKeys(session)) {
    rows.push_back(picked.row);
  }
  return rows.empty() ? rowsOfSelection(session) : rows;
}

Status restoreSelected(Session& session) {
  const std::vector<KeyRow> rows = rowsToRestore(session);
  return finish(session,
                restoreTracks(session.document(), session.view().clip,
                              [&](NodeIndex node, Channel channel) {
                                return std::any_of(rows.begin(), rows.end(), [&](const KeyRow& row) {
                                  return row.node == node && row.channel == channel;
                                });
                              }),
                "Restore the source's keys");
}

Status restoreEverything(Session& session) {
  return finish(session, restoreAllTracks(session.document()), "Restore all of the source's keys");
}

DocumentCommand kindCommand(const char* id, const char* label, const char* help, rig::KeyInterpolation kind) {
  return entry(id, label, help, {}, pickedNeeded(), [kind](Session& session) {
    return editKeys(session, setKeyKind(session.document(), session.view().clip, pickedKeys(session), kind),
                    "Change the tangents of");
  });
}

} // namespace

std::vector<DocumentCommand> keyCommands() {
  DocumentCommand restore = entry(
      command::keysRestore, "Restore the source's keys",
      "Gives the tracks of the picked keys, or of the selected limbs and controllers, back as the file has "
      "them.",
      {}, {canRestore, ""}, restoreSelected);
  restore.needsNow = whyNotRestored;
  return {
      entry(command::keysInsert, "Insert keys",
            "Sets a key on each curve that the graph shows, at the playhead; the curve stays as it is.", {},
            rowsNeeded(), insertHere),
      entry(command::keysDelete, "Delete keys", "Takes the picked keys away.", {}, pickedNeeded(),
            deletePicked),
      entry(command::keysCopy, "Copy keys", "Remembers the picked keys.", {}, pickedNeeded(),
            doing(copyPicked)),
      entry(command::keysPaste, "Paste keys", "Puts the copied keys at the playhead.", {}, copiedNeeded(),
            pasteHere),
      entry(command::keysAll, "Pick all keys", "Picks every key that the graph or the dope sheet shows.", {},
            rowsNeeded(), doing(pickAll)),
      entry(command::keysSnap, "Snap keys",
            "Moves the picked keys to whole frames; with none picked, every key of the clip that stands "
            "between.",
            {}, snapNeeded(), snapPicked),
      kindCommand(command::keysAuto, "Auto tangents", "The curve passes the keys without overshooting.",
                  rig::KeyInterpolation::automatic),
      kindCommand(command::keysFlat, "Flat tangents", "The curve is level at the keys.",
                  rig::KeyInterpolation::flat),
      kindCommand(command::keysLinear, "Linear tangents", "The curve goes straight to the neighbours.",
                  rig::KeyInterpolation::linear),
      kindCommand(command::keysStepped, "Stepped tangents",
                  "The value is held to the next key; a track of the clip steps as a whole.",
                  rig::KeyInterpolation::stepped),
      kindCommand(command::keysFree, "Free tangents", "The slopes are those of the handles.",
                  rig::KeyInterpolation::free),
      restore,
      entry(command::keysRestoreAll, "Restore all of the source's keys",
            "Gives every track of every clip back as the file has it.", {}, editedNeeded(),
            restoreEverything),
  };
}

} // namespace stretch::app
