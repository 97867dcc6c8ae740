#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "tests/support/ui_driver/document_watch.h"
#include "tests/support/ui_driver/monkey.h"
#include "ui/shell/editor.h"
#include "ui/shell/window/gui.h"

namespace stretch::test {

/// Returns GLFW's key for one of ours; none for keys that no keyboard has.
[[nodiscard]] std::optional<int> toGlfwKey(app::Key key);

/// Drives the editor without a hand: feeds keys and mouse through the same callbacks as the window does,
/// finds widgets by their ids, takes pictures and checks the document. One step per line, '#' begins a
/// comment:
///   key Ctrl+Z | 1 | Enter      press and release a key, as the US layout names it
///   tap KEY                     press and release it within one frame, as a quick hand on a slow screen
///   hold KEY, release KEY       of a key that acts while it is held
///   type TEXT                   characters into a text field
///   click ID [X Y] [shift|ctrl|alt]  left button on a widget's centre; rightclick, doubleclick likewise
///   move ID [X Y]               the mouse to a share of the widget's box, the centre if not given
///   press [BUTTON], lift        a mouse button where the mouse is: what comes between happens in a drag
///   drag ID X Y ID X Y [BUTTON] from a place to a place, each a share of a widget's box
///   wheel STEPS
///   drop FILE                   as if the file was dropped on the window
///   command ID                  as the palette would
///   wait FRAMES
///   until NAME VALUE            waits (at most half a minute) until a state is so
///   expect NAME VALUE           fails unless the state is so; numbers agree within a thousandth
///   picture FILE.png            what the window shows; fails when that is one colour
///   touch FILE                  as another program would change it
///   calm                        Escape, until nothing is open and no tool runs; fails when that does not
///   undo-all, redo-all          fails unless the file is as it was opened, and then as it was before
///   tally                       prints how many keys, clicks and drags the hand took so far, and the seconds
///   monkey SEED STEPS           that many steps at random (monkey.h), kept in the file monkey.script
///   quit                        ends the program without questions
///   abandon                     ends it as a crash would: nothing is closed
/// A relative FILE is taken from the script's folder for drop, from the working folder for picture. States:
/// see script_state.h.
class Script : public ui::EditorHand {
public:
  [[nodiscard]] static Result<Script> read(const std::filesystem::path& path);

  /// Before a frame: feeds input. Answers false when the script is over.
  bool beforeFrame(ui::Shell& shell, ui::Window& window) override;
  /// Frames of which a picture is taken, those of a monkey, and now and then one: drawn in software, all of
  /// them would be most of what a script takes.
  [[nodiscard]] bool paints() const override;
  /// After a frame was drawn and before it is shown: checks and pictures.
  void afterFrame(ui::Shell& shell, const ui::WindowSize& size) override;

  [[nodiscard]] const ui::DrivenMouse& mouse() const override { return mouse_; }
  /// The line that failed and why; empty while all is well.
  [[nodiscard]] const std::string& failure() const { return failure_; }
  /// The program is to end without closing anything.
  [[nodiscard]] bool abandons() const override { return abandoned_; }

private:
  struct Step {
    int line = 0;
    std::string verb;
    std::vector<std::string> words;
  };
  /// What one frame is told: at most one change of the mouse or the keys.
  struct Action {
    enum class Kind {
      moveTo,
      press,
      releaseButton,
      wheel,
      keyDown,
      keyUp,
      keyTap,
      character,
      wait
    } kind = Kind::wait;
    float x = 0.0F;
    float y = 0.0F;
    int value = 0; ///< Button, key, codepoint, or frames.
    int mods = 0;
  };

  /// What the hand did so far. A key with its modifiers counts once, as does each letter that is typed.
  struct Tally {
    int keys = 0;
    int clicks = 0;
    int drags = 0;
    double since = 0.0; ///< Of the clock: when the hand began; 0 before.
  };

  /// Nothing for an empty line.
  [[nodiscard]] static std::optional<Step> stepOf(const std::string& line, int number);
  void fail(const std::string& why);
  void begin(const Step& step, ui::Shell& shell);
  void beginMouse(const Step& step, const ui::Shell& shell);
  void beginDrag(const Step& step, const ui::Shell& shell);
  void beginKey(const Step& step);
  void beginCheck(const Step& step, ui::Shell& shell);
  void calm(const Step& step, ui::Shell& shell);
  /// The next step of the file, else of the monkey.
  std::optional<Step> nextStep(ui::Shell& shell);
  void requestCommand(const std::string& id, ui::Shell& shell);
  void act(const Action& action, ui::Window& window);
  void count(const Action& action);
  void moveTo(float x, float y);
  std::optional<ImVec2> placeOf(const ui::Shell& shell, const std::string& id, float x, float y);

  std::filesystem::path folder_;
  std::deque<Step> steps_;
  std::deque<Action> actions_;
  std::optional<Step> check_; ///< Done after the frame.
  std::optional<Step> until_;
  double untilSeconds_ = 0.0; ///< Of the clock: when waiting ends.
  int settleFrames_ = 3;      ///< Frames between steps: the widgets settle.
  int line_ = 0;
  int frames_ = 0; ///< So far.
  bool over_ = false;
  bool abandoned_ = false;
  ui::DrivenMouse mouse_;
  Tally tally_;
  bool movedSincePress_ = false;
  std::string failure_;
  std::optional<Monkey> monkey_;
  DocumentWatch watch_;
};

} // namespace stretch::test
