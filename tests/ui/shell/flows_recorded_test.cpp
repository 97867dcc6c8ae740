#include <functional>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/commands/table/command_ids.h"
#include "core/base/file.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/editor_stage.h"

using namespace stretch;
using test::EditorStage;
using test::Work;
namespace command = app::command;

// Work that takes several steps of the user and the files that it reads and writes, step by step.

namespace {

struct FlowStep {
  std::string name;
  std::function<void(EditorStage&)> make;
};

struct Flow {
  const char* name;
  void (*prepare)(const Work&);
  std::vector<FlowStep> steps;
};

FlowStep key(const std::string& chord) {
  return {"key " + chord, [chord](EditorStage& stage) { stage.press(chord); }};
}
FlowStep ask(const char* id) {
  return {std::string("command ") + id, [id](EditorStage& stage) { stage.run(id); }};
}
/// Until a dialog that was just opened has its place.
FlowStep look() {
  return {"look", [](EditorStage& stage) { stage.frames(3); }};
}
FlowStep click(const std::string& widget) {
  return {"click " + widget, [widget](EditorStage& stage) { stage.click(widget); }};
}
FlowStep enter() {
  return {"Enter in the dialog", [](EditorStage& stage) { stage.pressWidgetKey(ImGuiKey_Enter); }};
}
FlowStep escape() {
  return {"Esc in the dialog", [](EditorStage& stage) { stage.pressWidgetKey(ImGuiKey_Escape); }};
}
FlowStep typeText(const std::string& text) {
  return {"type " + text, [text](EditorStage& stage) { stage.type(text); }};
}
/// A file that an earlier step wrote.
FlowStep typeSaved(const std::string& name) {
  return {"type the path of " + name,
          [name](EditorStage& stage) { stage.type((stage.folder / ("HOME/" + name)).string()); }};
}
FlowStep drop(const std::string& file) {
  return {"drop " + file, [file](EditorStage& stage) { stage.drop({STRETCH_SOURCE_DIR "/" + file}); }};
}
FlowStep damaged(const std::string& name) {
  return {"a file that holds nothing useful: " + name,
          [name](EditorStage& stage) { REQUIRE(writeText(stage.folder / ("HOME/" + name), "{\"x\": [1,")); }};
}
FlowStep closeWindow() {
  return {"close the window", [](EditorStage& stage) { stage.askToClose(); }};
}

/// What is kept under a name.
std::vector<Flow> keptFlows() {
  return {
      {"poses of the library, tried, taken, named and deleted",
       test::withLimb,
       {ask(command::poseLibrary),
        look(),
        click("pose.keep"),
        look(),
        click("pose-library/name"),
        typeText("Guard"),
        enter(),
        escape(),
        ask(command::momentNext),
        ask(command::poseLibrary),
        look(),
        click("pose-library/pose-0"),
        look(),
        click("pose-library/mirrored"),
        click("pose-library/Pose"),
        key("Ctrl+Z"),
        ask(command::poseLibrary),
        look(),
        click("pose-library/pose-0"),
        look(),
        click("pose-library/Cancel"),
        ask(command::poseKeep),
        look(),
        click("pose.forget"),
        escape()}},
      {"selection sets, kept, named and forgotten",
       test::withLimb,
       {click("selection.keep"), key("F2"), typeText("Punch"), enter(), key("0"), ask(command::selectionNext),
        click("selection.forget"), key("Ctrl+Z")}},
  };
}

std::vector<Flow> flows() {
  return {
      {"the tour",
       test::withLimb,
       {key("0"), ask(command::tour), key("1"), key("E"), key("3"), key("Y"), key("Enter"), key("Space"),
        key("Space"), key("Enter"), key("Ctrl+S"), enter()}},
      {"the tour, left by its key",
       test::withLimb,
       {ask(command::tour), key("Esc"), ask(command::tour), ask(command::tourEnd)}},
      {"the tour, with a tool that is ended early",
       test::withLimb,
       {key("0"), ask(command::tour), key("1"), key("E"), key("Esc")}},
      {"saving under a name, again and closing",
       test::withTrail,
       {key("Ctrl+S"), enter(), key("Ctrl+S"), key("Ctrl+Alt+S"), key("Ctrl+Z"), key("Ctrl+E"), enter(),
        closeWindow()}},
      {"closing with work that no file has",
       test::withTwoTrails,
       {closeWindow(), escape(), closeWindow(), click("unsaved/Cancel"), closeWindow(), click("unsaved/Save"),
        escape(), closeWindow(), click("unsaved/Don't save")}},
      {"closing, with a name for what is saved",
       test::withTwoTrails,
       {closeWindow(), click("unsaved/Save"), enter()}},
      {"a recipe, written and read",
       test::withTrail,
       {ask(command::recipeSave), enter(), key("Delete"), ask(command::recipeLoad),
        typeSaved("dummy-stretched-recipe.json"), enter(), damaged("bad.json"), ask(command::recipeLoad),
        typeSaved("bad.json"), enter()}},
      {"styles of the user's own",
       test::withTrail,
       {ask(command::styleTake), ask(command::styleTake), ask(command::styleExport), enter(),
        damaged("bad.json"), ask(command::styleImport), typeSaved("bad.json"), enter()}},
      {"the clip in a style, kept",
       test::withLimb,
       {ask(command::clipExaggerate), click("clip-style/Exaggerate"), key("Ctrl+Z"),
        ask(command::clipExaggerate), click("clip-style/Cancel"), ask(command::clipExaggerate), escape()}},
      {"a thing that is dropped on a character",
       test::withLimb,
       {drop("tests/ui/things/bat.gltf"), escape(), drop("tests/ui/things/bat.gltf"), enter()}},
      {"a motion that is dropped on a character",
       test::withLimb,
       {drop("tests/ui/files/marching.bvh"), escape(), drop("tests/ui/files/marching.bvh"), enter()}},
      {"a character that is dropped on nothing", test::withNothing, {drop("tests/ui/things/bat.gltf")}},
      {"clips of a file that has several",
       test::withLimb,
       {ask(command::clipImport), typeText(STRETCH_SOURCE_DIR "/assets/dummy_leap.glb"), enter(), enter()}},
      {"a thing for the hands",
       test::withLimb,
       {ask(command::propAdd), typeText(STRETCH_SOURCE_DIR "/tests/ui/things/bat.gltf"), enter(), key("2"),
        ask(command::propAdd), damaged("bad.gltf"), typeSaved("bad.gltf"), enter()}},
      {"a sequence that is exported",
       test::withCompression,
       {key("Ctrl+S"), enter(), key("Ctrl+E"), escape(), ask(command::moduliSave), enter(),
        ask(command::moduliLoad), damaged("bad.json"), typeSaved("bad.json"), enter(), key("Ctrl+Z")}},
      {"the entries of the welcome, walked by keys",
       test::withNothing,
       {key("Right"), key("Down"), key("Left"), key("Up"), key("Down"), key("Down"), key("Down"),
        key("Down")}},
  };
}

std::string flowText(const Flow& flow) {
  EditorStage stage;
  flow.prepare(stage.work());
  stage.frames(2);
  stage.settle();
  std::string text = std::string(flow.name) + "\n";
  for (const FlowStep& step : flow.steps) {
    const test::Lines before = stage.lines();
    step.make(stage);
    stage.settle();
    constexpr int most = 14;
    const std::size_t source = step.name.find(STRETCH_SOURCE_DIR);
    text += "    " + step.name.substr(0, source) + "\n" + test::changeText(before, stage.lines(), most);
    if (const std::optional<ui::TourCard> card = ui::statusOf(stage.shell).tour) {
      text += fmt::format("      card {} of {} : {} : {} : {}\n", card->step + 1, card->steps, card->title,
                          card->text, card->key);
    }
    text += fmt::format("      welcome {} , {} files\n", stage.shell.ui.welcome.highlighted,
                        stage.folder.fileCount());
    stage.shell.ui.toasts.clear();
  }
  return text;
}

} // namespace

TEST_CASE("What several steps of work do, and what they write, is as it was looked at") {
  std::string text;
  for (const std::vector<Flow>& some : {flows(), keptFlows()}) {
    for (const Flow& flow : some) {
      text += flowText(flow);
    }
  }
  test::compareWithRecord("flows-of-work", text);
}
