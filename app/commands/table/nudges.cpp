#include "app/commands/table/nudges.h"

#include <array>

#include "app/commands/table/command_ids.h"

namespace stretch::app {

namespace {

struct Direction {
  const char* id;
  const char* title;
  Key key;
  const char* otherwise;     ///< What the key does while nothing can be nudged: a command;
  const char* otherwiseDoes; ///< and its words.
};
constexpr std::array<Direction, 6> directions{
    {{"left", "left", Key::left, command::timeBack, "steps a frame back"},
     {"right", "right", Key::right, command::timeForward, "steps a frame on"},
     {"up", "up", Key::up, command::timeNextKey, "jumps to the next key"},
     {"down", "down", Key::down, command::timePreviousKey, "jumps to the key before"},
     {"away", "away", Key::pageUp, "", ""},
     {"towards", "towards the viewer", Key::pageDown, "", ""}}};

struct Reach {
  const char* idSuffix;
  const char* title;
  bool ctrl;
  bool shift;
};
constexpr std::array<Reach, 3> reaches{{{"", "", false, false},
                                        {"-far", ", ten times as far", false, true},
                                        {"-fine", ", a tenth", true, false}}};

DocumentCommand nudgeCommand(const NudgeSubject& subject, const Direction& direction, const Reach& reach) {
  const Chord chord{direction.key, reach.ctrl, reach.shift, false};
  const std::string idEnd = std::string(direction.id) + reach.idSuffix;
  DocumentCommand command;
  command.id = subject.idPrefix + idEnd;
  command.label = std::string("Nudge ") + direction.title + reach.title;
  command.help =
      "Moves " + subject.words + " " + direction.title + ", as the view shows it" + reach.title + ".";
  if (subject.ownsKeys) {
    command.keys = {chordText(chord)};
  } else {
    command.label += ": " + subject.words;
  }
  command.enabled = subject.need.holds;
  command.needs = subject.need.text;
  const bool stepsTime = direction.otherwise[0] != '\0' && reach.idSuffix[0] == '\0';
  if (!subject.otherwisePrefix.empty()) {
    command.otherwise = subject.otherwisePrefix + idEnd;
  } else if (stepsTime) {
    command.otherwise = direction.otherwise;
  }
  if (stepsTime) {
    command.help += std::string(" With nothing to move the key ") + direction.otherwiseDoes + ".";
  }
  command.run = [chord, nudge = subject.nudge](Session& session) { return nudge(session, chord); };
  return command;
}

} // namespace

std::vector<DocumentCommand> nudgeCommands(const NudgeSubject& subject) {
  std::vector<DocumentCommand> commands;
  for (const Reach& reach : reaches) {
    for (const Direction& direction : directions) {
      commands.push_back(nudgeCommand(subject, direction, reach));
    }
  }
  return commands;
}

} // namespace stretch::app
