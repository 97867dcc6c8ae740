#include "tests/support/ui_driver/script.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <thread>

#include <epoxy/gl.h>
#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/support/ui_driver/script_state.h"
#include "ui/render/picture/image_edits.h"
#include "ui/shell/window/input.h"

namespace stretch::test {

using namespace ui;

std::optional<int> toGlfwKey(app::Key key) {
  for (int candidate = 1; candidate <= GLFW_KEY_LAST; ++candidate) {
    if (fromGlfwKey(candidate) == key && key != app::Key::none) {
      return candidate;
    }
  }
  return std::nullopt;
}

namespace {

constexpr int dragSteps = 8;
constexpr double untilSeconds = 30.0;

int modsOf(const std::vector<std::string>& words) {
  int mods = 0;
  for (const std::string& word : words) {
    mods |= word == "shift"  ? GLFW_MOD_SHIFT
            : word == "ctrl" ? GLFW_MOD_CONTROL
            : word == "alt"  ? GLFW_MOD_ALT
                             : 0;
  }
  return mods;
}

int modsOf(const app::Chord& chord) {
  return (chord.ctrl ? GLFW_MOD_CONTROL : 0) | (chord.shift ? GLFW_MOD_SHIFT : 0) |
         (chord.alt ? GLFW_MOD_ALT : 0);
}

float shareOf(const std::vector<std::string>& words, std::size_t index) {
  return index < words.size() ? std::strtof(words[index].c_str(), nullptr) : 0.5F;
}

int buttonOf(const std::string& name) {
  return name == "right" ? 1 : name == "middle" ? 2 : 0;
}

/// "left", "shift": no share of a widget's box.
bool isNumber(const std::string& word) {
  return !word.empty() && word.find_first_not_of("0123456789.-") == std::string::npos;
}

std::string joined(const std::vector<std::string>& words, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < words.size(); ++i) {
    text += (i > from ? " " : "") + words[i];
  }
  return text;
}

/// The window's pixels, rows from the top.
Image readWindow(const WindowSize& size) {
  Image image;
  image.width = size.framebufferWidth;
  image.height = size.framebufferHeight;
  const auto row = static_cast<std::size_t>(image.width) * 4;
  std::vector<std::uint8_t> pixels(row * static_cast<std::size_t>(image.height));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  image.rgba.reserve(pixels.size());
  for (auto y = static_cast<std::size_t>(image.height); y-- > 0;) {
    const auto from = pixels.begin() + static_cast<std::ptrdiff_t>(y * row);
    image.rgba.insert(image.rgba.end(), from, from + static_cast<std::ptrdiff_t>(row));
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    image.rgba[i] = 255;
  }
  return image;
}

bool isBlank(const Image& image) {
  const auto& rgba = image.rgba;
  for (std::size_t i = 4; i < rgba.size(); ++i) {
    if (rgba[i] != rgba[i % 4]) {
      return false;
    }
  }
  return true;
}

} // namespace

Result<Script> Script::read(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) {
    return Error{"cannot read the script", path.string(), "check the path"};
  }
  Script script;
  script.folder_ = path.parent_path();
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    if (std::optional<Step> step = stepOf(line, ++number)) {
      script.steps_.push_back(std::move(*step));
    }
  }
  return script;
}

std::optional<Script::Step> Script::stepOf(const std::string& line, int number) {
  std::istringstream text(line.substr(0, line.find('#')));
  Step step;
  step.line = number;
  if (!(text >> step.verb)) {
    return std::nullopt;
  }
  for (std::string word; text >> std::quoted(word);) {
    step.words.push_back(word);
  }
  return step;
}

void Script::fail(const std::string& why) {
  if (failure_.empty()) {
    failure_ = fmt::format("line {}: {}", line_, why);
  }
  over_ = true;
}

void Script::moveTo(float x, float y) {
  actions_.push_back({Action::Kind::moveTo, x, y, 0, 0});
}

std::optional<ImVec2> Script::placeOf(const Shell& shell, const std::string& id, float x, float y) {
  const Item* item = shell.items.find(id);
  if (item == nullptr) {
    fail("there is no widget " + id);
    return std::nullopt;
  }
  return ImVec2(item->min.x + x * (item->max.x - item->min.x), item->min.y + y * (item->max.y - item->min.y));
}

void Script::beginMouse(const Step& step, const Shell& shell) {
  const bool moves = step.verb == "move";
  const bool placed = step.words.size() > 2 && isNumber(step.words[1]);
  const auto place = placeOf(shell, step.words.empty() ? "" : step.words.front(),
                             placed ? shareOf(step.words, 1) : 0.5F, placed ? shareOf(step.words, 2) : 0.5F);
  if (!place) {
    return;
  }
  const Item* item = shell.items.find(step.words.front());
  if (!moves && item != nullptr && !item->enabled) {
    fail("the widget " + step.words.front() + " is off");
    return;
  }
  moveTo(place->x, place->y);
  actions_.push_back({Action::Kind::wait, 0.0F, 0.0F, 2, 0});
  const int clicks = moves ? 0 : step.verb == "doubleclick" ? 2 : 1;
  const int button = step.verb == "rightclick" ? 1 : 0;
  for (int i = 0; i < clicks; ++i) {
    actions_.push_back({Action::Kind::press, 0.0F, 0.0F, button, modsOf(step.words)});
    actions_.push_back({Action::Kind::wait, 0.0F, 0.0F, 1, 0});
    actions_.push_back({Action::Kind::releaseButton, 0.0F, 0.0F, button, modsOf(step.words)});
  }
}

void Script::beginDrag(const Step& step, const Shell& shell) {
  if (step.words.size() < 6) {
    fail("drag needs ID X Y ID X Y");
    return;
  }
  const auto from = placeOf(shell, step.words[0], shareOf(step.words, 1), shareOf(step.words, 2));
  const auto to = placeOf(shell, step.words[3], shareOf(step.words, 4), shareOf(step.words, 5));
  if (!from || !to) {
    return;
  }
  const int button = step.words.size() > 6 ? buttonOf(step.words[6]) : 0;
  moveTo(from->x, from->y);
  actions_.push_back({Action::Kind::wait, 0.0F, 0.0F, 2, 0});
  actions_.push_back({Action::Kind::press, 0.0F, 0.0F, button, modsOf(step.words)});
  for (int i = 1; i <= dragSteps; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(dragSteps);
    moveTo(from->x + share * (to->x - from->x), from->y + share * (to->y - from->y));
  }
  actions_.push_back({Action::Kind::wait, 0.0F, 0.0F, 1, 0});
  actions_.push_back({Action::Kind::releaseButton, 0.0F, 0.0F, button, modsOf(step.words)});
}

void Script::beginKey(const Step& step) {
  const auto chord = app::parseChord(joined(step.words, 0));
  const auto key = chord ? toGlfwKey(chord->key) : std::nullopt;
  if (!key) {
    fail("there is no key " + joined(step.words, 0));
    return;
  }
  if (step.verb == "tap") {
    actions_.push_back({Action::Kind::keyTap, 0.0F, 0.0F, *key, modsOf(*chord)});
    return;
  }
  if (step.verb != "release") {
    actions_.push_back({Action::Kind::keyDown, 0.0F, 0.0F, *key, modsOf(*chord)});
  }
  if (step.verb != "hold") {
    actions_.push_back({Action::Kind::keyUp, 0.0F, 0.0F, *key, modsOf(*chord)});
  }
}

void Script::requestCommand(const std::string& id, ui::Shell& shell) {
  if (std::ranges::find(shell.commands, id, &app::Command<Shell>::id) == shell.commands.end()) {
    fail("there is no command " + id);
  }
  shell.requested.push_back(id);
}

void Script::calm(const Step& step, Shell& shell) {
  constexpr int mostKeys = 12;
  const int pressed = step.words.empty() ? 0 : std::atoi(step.words.front().c_str());
  for (int button = 0; button < 3; ++button) {
    if (mouse_.buttons[button]) {
      actions_.push_back({Action::Kind::releaseButton, 0.0F, 0.0F, button, 0});
    }
  }
  const std::string what = actions_.empty() ? openThing(shell) : "a button held";
  if (what.empty()) {
    return;
  }
  if (pressed == mostKeys) {
    fail("Escape does not end " + what);
    return;
  }
  actions_.push_back({Action::Kind::keyDown, 0.0F, 0.0F, *toGlfwKey(app::Key::escape), 0});
  actions_.push_back({Action::Kind::keyUp, 0.0F, 0.0F, *toGlfwKey(app::Key::escape), 0});
  steps_.push_front({step.line, "calm", {std::to_string(pressed + 1)}});
}

void Script::beginCheck(const Step& step, Shell& shell) {
  if (step.verb == "monkey") {
    monkey_.emplace(static_cast<unsigned>(shareOf(step.words, 0)), static_cast<int>(shareOf(step.words, 1)));
  } else if (step.verb == "calm") {
    calm(step, shell);
  } else if (const std::string wrong =
                 step.verb == "undo-all" ? watch_.undoAll(shell) : watch_.redoAll(shell);
             !wrong.empty()) {
    fail(wrong);
  }
}

std::optional<Script::Step> Script::nextStep(Shell& shell) {
  if (!steps_.empty()) {
    Step step = std::move(steps_.front());
    steps_.pop_front();
    return step;
  }
  const std::optional<std::string> line = monkey_ ? monkey_->next(shell) : std::nullopt;
  if (!line) {
    return std::nullopt;
  }
  return stepOf(*line, line_);
}

void Script::begin(const Step& step, Shell& shell) {
  const std::string& verb = step.verb;
  if (verb == "key" || verb == "tap" || verb == "hold" || verb == "release") {
    beginKey(step);
  } else if (verb == "click" || verb == "rightclick" || verb == "doubleclick" || verb == "move") {
    beginMouse(step, shell);
  } else if (verb == "drag") {
    beginDrag(step, shell);
  } else if (verb == "press" || verb == "lift") {
    const int button = buttonOf(step.words.empty() ? "" : step.words.front());
    const auto kind = verb == "press" ? Action::Kind::press : Action::Kind::releaseButton;
    actions_.push_back({kind, 0.0F, 0.0F, button, modsOf(step.words)});
  } else if (verb == "type") {
    for (const char c : joined(step.words, 0)) {
      actions_.push_back({Action::Kind::character, 0.0F, 0.0F, static_cast<unsigned char>(c), 0});
    }
  } else if (verb == "wheel") {
    actions_.push_back({Action::Kind::wheel, shareOf(step.words, 0), 0.0F, 0, 0});
  } else if (verb == "wait") {
    actions_.push_back({Action::Kind::wait, 0.0F, 0.0F, static_cast<int>(shareOf(step.words, 0)), 0});
  } else if (verb == "command") {
    requestCommand(joined(step.words, 0), shell);
  } else if (verb == "tally") {
    fmt::print("{} keys, {} clicks, {} drags, {:.1f} s\n", tally_.keys, tally_.clicks, tally_.drags,
               tally_.since > 0.0 ? clockSeconds() - tally_.since : 0.0);
  } else if (verb == "until") {
    until_ = step;
    untilSeconds_ = clockSeconds() + untilSeconds;
  } else if (verb == "expect" || verb == "picture") {
    check_ = step;
  } else if (verb == "calm" || verb == "undo-all" || verb == "redo-all" || verb == "monkey") {
    beginCheck(step, shell);
  } else if (verb == "quit" || verb == "abandon") {
    over_ = true;
    abandoned_ = verb == "abandon";
  } else if (verb == "touch") {
    std::error_code problem;
    std::filesystem::last_write_time(joined(step.words, 0), std::filesystem::file_time_type::clock::now(),
                                     problem);
    if (problem) {
      fail("cannot touch " + joined(step.words, 0));
    }
  } else if (verb != "drop") {
    fail("there is no step " + verb);
  }
}

void Script::count(const Action& action) {
  switch (action.kind) {
  case Action::Kind::keyDown:
  case Action::Kind::keyTap:
  case Action::Kind::character:
    ++tally_.keys;
    break;
  case Action::Kind::moveTo:
    movedSincePress_ = true;
    break;
  case Action::Kind::press:
    movedSincePress_ = false;
    break;
  case Action::Kind::releaseButton:
    ++(movedSincePress_ ? tally_.drags : tally_.clicks);
    break;
  default:
    return;
  }
  tally_.since = tally_.since > 0.0 ? tally_.since : clockSeconds();
}

void Script::act(const Action& action, Window& window) {
  count(action);
  InputQueue& input = window.input();
  switch (action.kind) {
  case Action::Kind::moveTo:
    mouse_.x = action.x;
    mouse_.y = action.y;
    break;
  case Action::Kind::press:
  case Action::Kind::releaseButton: {
    const bool isPress = action.kind == Action::Kind::press;
    mouse_.buttons[action.value] = isPress;
    const std::pair<int, int> modifiers[] = {{GLFW_MOD_SHIFT, GLFW_KEY_LEFT_SHIFT},
                                             {GLFW_MOD_CONTROL, GLFW_KEY_LEFT_CONTROL},
                                             {GLFW_MOD_ALT, GLFW_KEY_LEFT_ALT}};
    for (const auto& [bit, key] : modifiers) {
      if ((action.mods & bit) != 0 && isPress) {
        receiveKey(input, window.handle(), key, 0, GLFW_PRESS, 0);
      } else if ((action.mods & bit) != 0) { // A frame after the button, as a hand lets go.
        actions_.push_front({Action::Kind::keyUp, 0.0F, 0.0F, key, 0});
      }
    }
    break;
  }
  case Action::Kind::wheel:
    mouse_.wheel = action.x;
    break;
  case Action::Kind::keyDown:
    receiveKey(input, window.handle(), action.value, 0, GLFW_PRESS, action.mods);
    break;
  case Action::Kind::keyTap:
    receiveKey(input, window.handle(), action.value, 0, GLFW_PRESS, action.mods);
    receiveKey(input, window.handle(), action.value, 0, GLFW_RELEASE, action.mods);
    break;
  case Action::Kind::keyUp:
    receiveKey(input, window.handle(), action.value, 0, GLFW_RELEASE, action.mods);
    break;
  case Action::Kind::character:
    receiveCharacter(input, window.handle(), static_cast<unsigned int>(action.value));
    break;
  case Action::Kind::wait:
    settleFrames_ = std::max(settleFrames_, action.value);
    break;
  }
}

bool Script::paints() const {
  constexpr int nowAndThen = 16;
  return monkey_ || (check_ && check_->verb == "picture") || frames_ % nowAndThen == 0;
}

bool Script::beforeFrame(Shell& shell, Window& window) {
  mouse_.wheel = 0.0F;
  ++frames_;
  if (over_) {
    return false;
  }
  if (settleFrames_ > 0) {
    --settleFrames_;
    return true;
  }
  if (until_) {
    // What is waited for may need the processor.
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return true;
  }
  if (!actions_.empty()) {
    const Action action = actions_.front();
    actions_.pop_front();
    act(action, window);
    settleFrames_ = std::max(settleFrames_, actions_.empty() ? (monkey_ ? 1 : 3) : 0);
    return true;
  }
  const std::optional<Step> next = nextStep(shell);
  if (!next) {
    return false;
  }
  const Step& step = *next;
  line_ = step.line;
  begin(step, shell);
  if (step.verb == "drop") {
    const std::filesystem::path file = joined(step.words, 0);
    window.input().drops.push_back(file.is_absolute() ? file : folder_ / file);
  }
  return !over_ || failure_.empty();
}

void Script::afterFrame(Shell& shell, const WindowSize& size) {
  watch_.look(shell);
  shell.quit = shell.quit && !monkey_; // Which leaves now and then, and is not let go.
  if (until_) {
    const std::string wanted = joined(until_->words, 1);
    const auto state = stateOf(shell, until_->words.empty() ? "" : until_->words.front());
    if (state && sameState(*state, wanted)) {
      until_.reset();
    } else if (clockSeconds() > untilSeconds_) {
      fail(fmt::format(R"({} is "{}" and did not become "{}")", until_->words.front(),
                       state.value_or("unknown"), wanted));
    }
  }
  if (!check_) {
    return;
  }
  const Step check = *std::exchange(check_, std::nullopt);
  if (check.verb == "picture") {
    const Image image = readWindow(size);
    const Status written = writePng(joined(check.words, 0), image);
    if (!written || isBlank(image)) {
      fail(written ? "the window shows nothing" : written.error().line());
    }
    return;
  }
  const std::string wanted = joined(check.words, 1);
  const auto state = stateOf(shell, check.words.empty() ? "" : check.words.front());
  if (!state || !sameState(*state, wanted)) {
    fail(fmt::format(R"({} is "{}", expected "{}")", check.words.empty() ? "" : check.words.front(),
                     state.value_or("unknown"), wanted));
  }
}

} // namespace stretch::test
