#include "app/commands/table/keymap.h"

#include <algorithm>

#include "core/gltf/json/json.h"
#include "core/gltf/source/json_text.h"

namespace stretch::app {

namespace {

using Json = nlohmann::ordered_json;

std::vector<Chord> parsedChords(const std::vector<std::string>& texts) {
  std::vector<Chord> chords;
  for (const std::string& text : texts) {
    if (const auto chord = parseChord(text)) {
      chords.push_back(*chord);
    }
  }
  return chords;
}

Error badKeyFile(const std::string& what, const std::string& where) {
  return Error{what, where, "correct the key file, or reset the keys"};
}

Result<std::vector<Chord>> readChords(const std::string& commandId, const Json& list) {
  if (!list.is_array()) {
    return badKeyFile("keys must be a list of texts", commandId);
  }
  std::vector<Chord> chords;
  for (const Json& entry : list) {
    const auto chord = entry.is_string() ? parseChord(entry.get<std::string>()) : std::nullopt;
    if (!chord) {
      return badKeyFile("there is no key " + entry.dump(), commandId);
    }
    chords.push_back(*chord);
  }
  return chords;
}

} // namespace

Keymap::Keymap(std::vector<KeyedCommand> commands) : commands_(std::move(commands)) {}

const KeyedCommand* Keymap::find(std::string_view commandId) const {
  const auto found =
      std::ranges::find_if(commands_, [&](const KeyedCommand& command) { return command.id == commandId; });
  return found == commands_.end() ? nullptr : &*found;
}

std::vector<Chord> Keymap::chordsOf(std::string_view commandId) const {
  if (const auto changed = changed_.find(std::string(commandId)); changed != changed_.end()) {
    return changed->second;
  }
  const KeyedCommand* command = find(commandId);
  return command == nullptr ? std::vector<Chord>{} : parsedChords(command->defaultKeys);
}

std::string Keymap::commandOf(const Chord& chord) const {
  for (const KeyedCommand& command : commands_) {
    const std::vector<Chord> chords = chordsOf(command.id);
    if (std::find(chords.begin(), chords.end(), chord) != chords.end()) {
      return command.id;
    }
  }
  return {};
}

Result<std::string> Keymap::rebind(const std::string& commandId, const std::optional<Chord>& chord) {
  if (find(commandId) == nullptr) {
    return Error{"there is no such command", commandId, "choose one from the list of keys"};
  }
  std::string loser;
  if (chord) {
    loser = commandOf(*chord);
  }
  if (!loser.empty() && loser != commandId) {
    std::vector<Chord> rest = chordsOf(loser);
    std::erase(rest, *chord);
    unknown_.erase(loser);
    changed_[loser] = std::move(rest);
  }
  unknown_.erase(commandId);
  changed_[commandId] = chord ? std::vector<Chord>{*chord} : std::vector<Chord>{};
  return loser == commandId ? std::string() : loser;
}

void Keymap::resetToDefaults() {
  changed_.clear();
  unknown_.clear();
}

std::string Keymap::toJson(bool all) const {
  Json keys = Json::object();
  for (const KeyedCommand& command : commands_) {
    if (!all && changed_.find(command.id) == changed_.end()) {
      continue;
    }
    Json list = Json::array();
    for (const Chord& chord : chordsOf(command.id)) {
      list.push_back(chordText(chord));
    }
    keys[command.id] = std::move(list);
  }
  for (const auto& [commandId, entry] : unknown_) {
    if (!all) {
      keys[commandId] = gltf::parseAnyJson(entry);
    }
  }
  return Json{{"version", 1}, {"keys", std::move(keys)}}.dump(2) + "\n";
}

Status Keymap::readJson(const std::string& text) {
  const Json json = gltf::parseAnyJson(text);
  if (!json.is_object() || !json.contains("keys") || !json["keys"].is_object()) {
    return badKeyFile("this is not a file of keys", "keys");
  }
  changed_.clear();
  unknown_.clear();
  Status read = Success{};
  for (const auto& [commandId, list] : json["keys"].items()) {
    Result<std::vector<Chord>> chords = find(commandId) == nullptr
                                            ? badKeyFile("there is no such command", commandId)
                                            : readChords(commandId, list);
    if (chords) {
      changed_[commandId] = std::move(chords).value();
      continue;
    }
    read = unknown_.empty() ? Status(chords.error())
                            : badKeyFile(std::to_string(unknown_.size() + 1) + " entries are not understood",
                                         "the first is " + unknown_.begin()->first);
    unknown_[commandId] = list.dump();
  }
  return read;
}

} // namespace stretch::app
