#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "ui/shell/shell.h"

namespace stretch::test {

/// Does anything at random, by a seed: keys, clicks, drags, text and the wheel, on whatever is on the screen.
/// Every now and then it looks whether all is well: Escape gives back the plain state, undoing all gives back
/// what was opened and redoing all what was last, and what it saves plays as it is drawn. It stays in the
/// folder that the program was started in.
class Monkey {
public:
  Monkey(unsigned seed, int steps);

  /// The next line of a script (script.h), which says nothing that cannot be done; nothing at the end. All
  /// lines so far are in the file monkey.script, a script that does the same, even when the program crashes.
  [[nodiscard]] std::optional<std::string> next(ui::Shell& shell);

private:
  [[nodiscard]] std::size_t below(std::size_t count);
  [[nodiscard]] bool chance(int percent);
  [[nodiscard]] const std::string& anyOf(const std::vector<std::string>& words);
  [[nodiscard]] std::string place();
  [[nodiscard]] std::string modifiers();
  [[nodiscard]] std::string anyItem(const ui::Shell& shell);
  [[nodiscard]] std::string key(const ui::Shell& shell);
  [[nodiscard]] std::string mouse(const ui::Shell& shell);
  [[nodiscard]] std::string pressOrLift(const ui::Shell& shell);
  [[nodiscard]] std::string something(const ui::Shell& shell);
  void planChecks(const ui::Shell& shell);
  void planSave(const ui::Shell& shell);
  void tell(const std::string& line);
  [[nodiscard]] bool isAstray(const ui::Shell& shell) const;

  std::mt19937 random_;
  int stepsLeft_;
  int untilCheck_ = 0;
  int saving_ = 0;                   ///< Keys pressed for it: a dialog may ask for the name.
  bool pressed_ = false;             ///< A mouse button is held.
  std::string heldKey_;              ///< Held over several steps.
  std::vector<std::string> planned_; ///< What comes before anything else, the last one first.
  std::ofstream told_;
  std::filesystem::path home_;
};

} // namespace stretch::test
