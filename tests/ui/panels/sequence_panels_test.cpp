#include <algorithm>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/panels/sequence/sequence_rows.h"
#include "ui/widgets/scatter_plot.h"

using namespace stretch;
using test::PanelDriver;

namespace {

/// The panels with a bending tube of 12 frames open.
struct SequencePanels {
  SequencePanels() : driver(std::nullopt) {
    app::SequenceDocument document;
    document.paths = {"tube"};
    document.mesh = std::make_shared<const MeshSequence>(test::shorteningTube(12, 2.0, 0.06, 0.1));
    document.analysis = std::make_shared<const app::SequenceAnalysis>(app::analyseSequence(*document.mesh));
    document.settings.bones = 8;
    driver.open.open(std::move(document));
    driver.frames(3);
  }
  void compress() {
    auto made = app::makeCompression(*driver.open.sequence()->document().mesh, settings());
    REQUIRE(made);
    app::SequenceDocument changed = driver.open.sequence()->document();
    changed.result = std::make_shared<const app::Compression>(std::move(made).value());
    driver.open.sequence()->edit(std::move(changed), "Compress");
    driver.frames(3);
  }
  [[nodiscard]] const skinning::CompressSettings& settings() {
    return driver.open.sequence()->document().settings;
  }

  PanelDriver driver;
};

} // namespace

TEST_CASE("A sequence has panels of its own in the places of the character's") {
  SequencePanels panels;
  CHECK(panels.driver.find("sequence/bones") != nullptr);
  CHECK(panels.driver.find("sequence/plot") != nullptr);
  CHECK(panels.driver.find("timeline") != nullptr);
  CHECK(panels.driver.find("limb/left-arm") == nullptr);
  CHECK(panels.driver.find("trail/scale") == nullptr);
}

TEST_CASE("Stretch, weights and length are chosen by click") {
  SequencePanels panels;
  panels.driver.click("sequence/stretch/Measured");
  CHECK(panels.settings().stretch == skinning::StretchOption::measured);
  panels.driver.click("sequence/stretch/None");
  CHECK(panels.settings().stretch == skinning::StretchOption::none);
  panels.driver.click("sequence/weights/Geodesic");
  CHECK(panels.settings().weights == skinning::WeightOption::geodesic);
  panels.driver.click("sequence/length/Monotone");
  CHECK(panels.settings().body.lengthModel == skinning::LengthModel::monotone);
  panels.driver.drag("sequence/bones", 60.0F, 0.0F);
  CHECK(panels.settings().bones > 8);
}

TEST_CASE("Compress is asked for by its command, the result shows metrics and can be exported") {
  SequencePanels panels;
  CHECK(panels.driver.find(ui::command::fileExportClean) == nullptr);
  panels.driver.click(ui::command::sequenceCompress);
  CHECK(panels.driver.requested == std::vector<std::string>{ui::command::sequenceCompress});
  panels.compress();
  CHECK(panels.driver.find("sequence/quantise") != nullptr);
  const bool before = panels.driver.open.sequence()->document().encoding.quantise;
  panels.driver.click("sequence/quantise");
  CHECK(panels.driver.open.sequence()->document().encoding.quantise != before);
  panels.driver.click(ui::command::fileExportClean);
  CHECK(panels.driver.requested.back() == ui::command::fileExportClean);
}

TEST_CASE("While a compression is made there is progress and a way to stop it") {
  SequencePanels panels;
  REQUIRE(panels.driver.open.sequence()->startCompression());
  panels.driver.frames(2);
  CHECK(panels.driver.find("sequence/progress") != nullptr);
  CHECK(panels.driver.find(ui::command::sequenceCancel) != nullptr);
  CHECK(panels.driver.find(ui::command::sequenceCompress) == nullptr);
}

TEST_CASE("The progress of a compression is told in percent of it, up to its end") {
  SequencePanels panels;
  app::SequenceSession& session = *panels.driver.open.sequence();
  app::SequenceDocument document = session.document();
  document.mesh = std::make_shared<const MeshSequence>(test::shorteningTube(60, 2.0, 0.06, 0.05));
  document.analysis = std::make_shared<const app::SequenceAnalysis>(app::analyseSequence(*document.mesh));
  session.restore(std::move(document));
  REQUIRE(session.startCompression());
  double most = 0.0;
  for (int frames = 0; frames < 20000 && most < 60.0; ++frames) {
    const double before = session.compressedShare();
    panels.driver.frame();
    const double after = session.compressedShare();
    for (const std::string& words : test::shownWords()) {
      if (words.starts_with("Compressing ")) {
        CHECK_THAT(words, Catch::EndsWith(" %"));
        const double percent = std::stod(words.substr(std::string("Compressing ").size()));
        CHECK(percent >= 100.0 * before - 0.5);
        CHECK(percent <= 100.0 * after + 0.5);
        most = std::max(most, percent);
      }
    }
  }
  CHECK(most >= 60.0); // All of it is told until it is taken up.
  session.cancelWork();
}

TEST_CASE("A skeleton that was taken is told by its file and how many bones it has, one of them as one") {
  SequencePanels panels;
  const int bones = GENERATE(1, 2, 7);
  app::SequenceDocument document = panels.driver.open.sequence()->document();
  document.skeletonFile = "folder/tail.glb";
  document.settings.skeleton.resize(static_cast<std::size_t>(bones));
  panels.driver.open.sequence()->edit(std::move(document), "Take the skeleton");
  panels.driver.frames(3);
  const std::vector<std::string> words = test::shownWords();
  const std::string wanted = "tail.glb, " + std::to_string(bones) + (bones == 1 ? " bone" : " bones");
  CHECK(std::ranges::count(words, wanted) == 1);
  CHECK(panels.driver.find("sequence/bones") == nullptr);
  panels.driver.click(app::command::skeletonLeave);
  CHECK(panels.driver.requested.back() == app::command::skeletonLeave);
}

TEST_CASE("Numbers of the elastic model are typed, and an empty field leaves them to the program") {
  SequencePanels panels;
  panels.driver.click("sequence/young");
  panels.driver.type("3770");
  panels.driver.frames(2);
  CHECK(panels.settings().body.youngModulus == 3770.0);
  panels.driver.click("sequence/gravity");
  panels.driver.type("0 0 -9.8");
  panels.driver.frames(2);
  CHECK(panels.settings().body.gravity == Vec3(0.0, 0.0, -9.8));
  panels.driver.click("sequence/mass");
  panels.driver.type("heavy");
  panels.driver.frames(2);
  CHECK_FALSE(panels.settings().body.mass);
  panels.driver.click("sequence/metres_per_unit");
  panels.driver.type("2.03e-6");
  panels.driver.frames(2);
  CHECK(panels.settings().body.metresPerUnit == 2.03e-6);
}

TEST_CASE("Settings of a sequence are undone, each gesture by one step, and typed numbers follow") {
  SequencePanels panels;
  app::SequenceSession& session = *panels.driver.open.sequence();
  panels.driver.click("sequence/stretch/Measured");
  CHECK(session.history().undoLabel() == "Change the stretch");
  panels.driver.drag("sequence/bones", 60.0F, 0.0F);
  CHECK(session.history().undoLabel() == "Change the bones");
  session.undo();
  CHECK(panels.settings().bones == 8);
  CHECK(panels.settings().stretch == skinning::StretchOption::measured);
  session.undo();
  CHECK(panels.settings().stretch == skinning::StretchOption::elastic);
  CHECK_FALSE(session.history().canUndo());

  panels.driver.click("sequence/young");
  panels.driver.type("3");
  panels.driver.type("7");
  panels.driver.click("sequence/mass"); // leaves the field
  CHECK(panels.settings().body.youngModulus == 37.0);
  CHECK(session.history().undoLabel() == "Change the modulus");
  panels.driver.click("sequence/stretch/None");
  session.undo();
  session.undo();
  CHECK_FALSE(panels.settings().body.youngModulus);
  CHECK_FALSE(session.history().canUndo());
  panels.driver.frames(2);
  CHECK(panels.driver.ui.typedTexts["sequence/young"].empty());
  session.redo();
  panels.driver.frames(2);
  CHECK(panels.driver.ui.typedTexts["sequence/young"] == "37");
}

TEST_CASE("Segments get a modulus of their own, and lose it") {
  SequencePanels panels;
  panels.driver.click("sequence/moduli/add");
  REQUIRE(panels.settings().body.moduli.ranges.size() == 1);
  panels.driver.drag("sequence/moduli/0/to", 40.0F, 0.0F);
  CHECK(panels.settings().body.moduli.ranges[0].last > 4);
  CHECK(panels.settings().body.moduli.ranges[0].last < 8);
  panels.driver.click("sequence/moduli/0/remove");
  CHECK(panels.settings().body.moduli.ranges.empty());
}

TEST_CASE("What colours the surface is chosen over the viewport, the error needs a result") {
  SequencePanels panels;
  panels.driver.click("sequence/look/Error");
  CHECK(panels.driver.open.sequence()->view().look == app::SequenceLook::material);
  panels.driver.click("sequence/look/Thickness");
  CHECK(panels.driver.open.sequence()->view().look == app::SequenceLook::thickness);
  panels.compress();
  panels.driver.click("sequence/look/Error");
  CHECK(panels.driver.open.sequence()->view().look == app::SequenceLook::error);
}

TEST_CASE("A click on a point of the plot goes to its frame") {
  SequencePanels panels;
  const ui::Item* plot = panels.driver.find("sequence/plot");
  REQUIRE(plot != nullptr);
  // The straight body, frame 0, is the longest and the least bent: the point at the top left.
  panels.driver.open.sequence()->view().frame = 7.0;
  int found = 0;
  for (float x = plot->min.x + 42.0F; x < plot->min.x + 80.0F && found == 0; x += 4.0F) {
    for (float y = plot->min.y + 18.0F; y < plot->min.y + 60.0F && found == 0; y += 4.0F) {
      ImGui::GetIO().MousePos = {x, y};
      panels.driver.frame();
      panels.driver.pressMouse();
      panels.driver.releaseMouse();
      found = panels.driver.open.sequence()->view().frame == 0.0 ? 1 : 0;
    }
  }
  CHECK(found == 1);
}

TEST_CASE("Dragging the start of the range leaves settling frames out of the fits") {
  SequencePanels panels;
  panels.driver.drag("timeline/range-start", 300.0F, 0.0F);
  CHECK(panels.settings().body.firstFittedFrame > 0);
  CHECK(panels.settings().body.firstFittedFrame < 12);
}

TEST_CASE("A plot covers points and lines with a margin, and one point all the same") {
  ui::ScatterPlotModel model;
  model.points = {{Vec2(1.0, 10.0)}};
  const ui::Span single = ui::plottedSpan(model, 0);
  CHECK(single.start < 1.0);
  CHECK(single.end > 1.0);
  model.lines = {{0, {Vec2(0.0, 20.0), Vec2(4.0, 0.0)}}};
  CHECK(ui::plottedSpan(model, 0).end > 4.0);
  CHECK(ui::plottedSpan(model, 1).start < 0.0);
}

TEST_CASE("A new range of segments ends within the body, and its ends are never typed past one another") {
  SequencePanels panels;
  const auto range = [&] { return panels.settings().body.moduli.ranges.at(0); };
  const auto typeInto = [&](const char* field, const char* text) {
    panels.driver.click(field);
    panels.driver.type(text);
    panels.driver.pressKey(ImGuiKey_Enter);
    panels.driver.frames(2);
  };
  panels.driver.click("sequence/moduli/add");
  CHECK(range().first == 0);
  CHECK(range().last == 4);
  typeInto("sequence/moduli/0/from", "6");
  CHECK(range().first == 6);
  CHECK(range().last == 6);
  typeInto("sequence/moduli/0/to", "2");
  CHECK(range().first == 6);
  CHECK(range().last == 6);
  app::SequenceDocument document = panels.driver.open.sequence()->document();
  document.settings.bones = 3;
  document.settings.body.moduli.ranges.clear();
  panels.driver.open.sequence()->edit(std::move(document), "Fewer bones");
  panels.driver.frames(3);
  panels.driver.click("sequence/moduli/add");
  CHECK(range().last == 2);
}
