#include <algorithm>
#include <map>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/recorded.h"
#include "tests/support/skinning/bodies.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/gui_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/picture_baseline.h"
#include "tests/support/ui/work.h"
#include "ui/viewport/tools.h"
#include "ui/viewport/viewport_scene.h"

using namespace stretch;
using namespace stretch::ui;
using test::GuiPainter;
using test::GuiStage;

namespace {

/// The bundled character in its punch, with an exaggerated trail of the left arm, seen as the window first
/// shows it.
void openCharacter(GuiStage& stage) {
  const app::Document document = test::withNewTrail(test::PanelDriver::bundledCharacter(),
                                                    {.startFrame = 18.0, .endFrame = 30.0, .scale = 1.8});
  stage.open.open(document);
  stage.open.character()->view().frame = 26.0;
  stage.viewport.look.facingYawRadians = facingYaw(document, 0);
  stage.viewport.camera =
      lookFrom(Camera{}, ViewDirection::threeQuarter, stage.viewport.look.facingYawRadians);
  stage.viewport.framePending = true;
}

int trailOf(const GuiStage& stage) {
  return stage.open.character()->document().trails.front().id;
}

void selectTrail(GuiStage& stage) {
  app::selectTrail(*stage.open.character(), trailOf(stage));
}

void openSequence(GuiStage& stage) {
  app::SequenceDocument document;
  document.paths = {"tube"};
  document.mesh = std::make_shared<const MeshSequence>(test::shorteningTube(12, 2.0, 0.06, 0.1));
  document.analysis = std::make_shared<const app::SequenceAnalysis>(app::analyseSequence(*document.mesh));
  document.settings.bones = 8;
  auto made = app::makeCompression(*document.mesh, document.settings);
  REQUIRE(made);
  document.result = std::make_shared<const app::Compression>(std::move(made).value());
  stage.open.open(std::move(document));
  stage.open.sequence()->view().frame = 8.0;
  stage.open.sequence()->view().look = app::SequenceLook::compare;
}

/// The tool that E opens, running.
void runExaggerate(GuiStage& stage) {
  selectTrail(stage);
  REQUIRE(startExaggerate(*stage.open.character(), stage.tool));
}

void changeTrail(GuiStage& stage, void (*change)(rig::Trail&)) {
  app::Document document = stage.open.character()->document();
  change(document.trails.front());
  stage.open.character()->edit(std::move(document), "Change the trail");
}

struct Overlays {
  const char* name;
  void (*set)(GuiStage&);
  bool isWide = false; ///< With room for legends and labels, in the dark theme alone.
};

const Overlays overlays[] = {
    {"trails", [](GuiStage&) {}},
    {"skeleton", [](GuiStage& stage) { stage.ui.overlays.skeleton = true; }},
    {"wire", [](GuiStage& stage) { stage.ui.overlays.wire = true; }},
    {"joint-names", [](GuiStage& stage) { stage.ui.overlays.jointNames = true; }},
    {"heat-map", [](GuiStage& stage) { stage.ui.overlays.heatMap = true; }},
    {"shade-as",
     [](GuiStage& stage) {
       changeTrail(stage, [](rig::Trail& trail) { trail.settings.scale = 3.0; });
       stage.ui.overlays.shadeAs = ShadeAs::three;
     },
     true},
    {"weights",
     [](GuiStage& stage) {
       stage.ui.overlays.weights = true;
       app::selectLimb(*stage.open.character(), "right-leg", false);
     }},
    {"ghosts", [](GuiStage& stage) { stage.ui.overlays.ghosts = true; }},
    {"grid-off", [](GuiStage& stage) { stage.ui.overlays.grid = false; }},
    {"limb-selected", [](GuiStage& stage) { app::selectLimb(*stage.open.character(), "right-leg", false); }},
    {"trail-selected", selectTrail},
    {"frame-numbers",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.ui.overlays.trailFrameNumbers = true;
     }},
    {"ticks-off",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.ui.overlays.trailTicks = false;
     }},
    {"trail-window",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.ui.overlays.trailWindow = true;
       stage.ui.overlays.trailWindowFrames = 3;
     }},
    {"trail-thick",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.ui.overlays.trailThickness = 6.0F;
       stage.ui.overlays.sphereSize = 10.0F;
     }},
    {"trails-of-selection", [](GuiStage& stage) { stage.ui.overlays.trailsOnlyWhenSelected = true; }},
    {"handles",
     [](GuiStage& stage) {
       selectTrail(stage);
       stage.open.character()->view().selection.editTrails().spheres = {
           stage.open.character()->document().trails.front().settings.endFrame};
     }},
    {"side-by-side", [](GuiStage& stage) { stage.ui.overlays.sideBySide = true; }},
    {"original", [](GuiStage& stage) { stage.open.character()->view().showOriginal = true; }},
    {"front",
     [](GuiStage& stage) {
       stage.viewport.camera =
           lookFrom(stage.viewport.camera, ViewDirection::front, stage.viewport.look.facingYawRadians);
     }},
    {"sequence", openSequence},
    {"sequence-error",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::error;
     }},
    {"sequence-thickness",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::thickness;
       stage.ui.overlays.skeleton = true;
     }},
    {"sequence-segments",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::segments;
     }},
    {"sequence-cylinders",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::cylinders;
       stage.ui.overlays.skeleton = true;
     }},
    {"empty", [](GuiStage& stage) { stage.open = {}; }},
    {"controllers", [](GuiStage& stage) { stage.ui.overlays.controllers = true; }, true},
    {"controllers-selected",
     [](GuiStage& stage) {
       app::selectControllers(*stage.open.character(), {"right-elbow", "left-hand"});
     },
     true},
    {"controllers-of-joints",
     [](GuiStage& stage) {
       stage.ui.overlays.controllers = stage.ui.overlays.skeleton = true;
       app::selectLimb(*stage.open.character(), "spine", false);
     },
     true},
    {"skeleton-of-limb",
     [](GuiStage& stage) {
       stage.ui.overlays.skeleton = true;
       app::selectLimb(*stage.open.character(), "left-leg", false);
     },
     true},
    {"tip-while-exaggerating", runExaggerate, true},
    {"path-only",
     [](GuiStage& stage) { changeTrail(stage, [](rig::Trail& trail) { trail.settings.scale = 1.0; }); },
     true},
    {"trail-applied",
     [](GuiStage& stage) {
       changeTrail(stage, [](rig::Trail& trail) { trail.applied = true; });
       selectTrail(stage);
       stage.ui.overlays.ghosts = true;
     },
     true},
    {"tangents-and-numbers",
     [](GuiStage& stage) {
       selectTrail(stage);
       app::ViewState& view = stage.open.character()->view();
       view.selection.editTrails().spheres = {
           stage.open.character()->document().trails.front().settings.startFrame};
       stage.ui.overlays.trailFrameNumbers = stage.ui.overlays.jointNames = true;
     },
     true},
    {"ghosts-far",
     [](GuiStage& stage) {
       stage.ui.overlays.ghosts = true;
       stage.ui.overlays.ghostsBefore = 1;
       stage.ui.overlays.ghostsAfter = 2;
       stage.ui.overlays.ghostStepFrames = 6;
     },
     true},
    {"weights-wide",
     [](GuiStage& stage) {
       stage.ui.overlays.weights = true;
       app::selectController(*stage.open.character(), "left-hand", false);
     },
     true},
    {"sequence-thickness-wide",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::thickness;
     },
     true},
    {"sequence-error-wide",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::error;
     },
     true},
    {"sequence-material",
     [](GuiStage& stage) {
       openSequence(stage);
       stage.open.sequence()->view().look = app::SequenceLook::material;
     },
     true},
    {"welcome-wide",
     [](GuiStage& stage) {
       stage.open = {};
       stage.ui.welcome.highlighted = 1;
       stage.ui.recentFiles = {"/characters/boxer.glb", "/characters/walk.gltf"};
     },
     true},
};

std::string numbersText(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) {
    text += fmt::format(" {:.3f}", value);
  }
  return text;
}

std::string colourText(const glm::vec4& colour) {
  return numbersText({colour.r, colour.g, colour.b, colour.a});
}

std::string vectorText(const Vec3& world) {
  return numbersText({world.x, world.y, world.z});
}

/// What is drawn over the character, mark by mark.
std::string overlayText(const Overlay& overlay) {
  std::string text;
  for (const Polyline& line : overlay.lines) {
    Vec3 sum(0.0);
    double width = 0.0;
    for (const LinePoint& point : line.points) {
      sum += point.world;
      width += static_cast<double>(point.widthPoints);
    }
    const double count = std::max<double>(1.0, static_cast<double>(line.points.size()));
    text += fmt::format("  line of {} , dashes {} {} , depth {} , outlined {} , about", line.points.size(),
                        line.dashPoints, line.gapPoints, static_cast<int>(line.depth), line.outlined) +
            vectorText(sum / count) + numbersText({width / count});
    if (!line.points.empty()) {
      text += " from" + vectorText(line.points.front().world) + colourText(line.points.front().color) +
              " to" + vectorText(line.points.back().world) + colourText(line.points.back().color);
    }
    text += "\n";
  }
  for (const Marker& marker : overlay.markers) {
    text += fmt::format("  mark {} at", static_cast<int>(marker.shape)) + vectorText(marker.world) +
            numbersText({marker.radiusPoints, marker.edgePoints, marker.turnRadians}) +
            fmt::format(" depth {}", static_cast<int>(marker.depth)) + colourText(marker.fill) +
            colourText(marker.edge) + "\n";
  }
  for (const Arrow& arrow : overlay.arrows) {
    text += "  arrow" + vectorText(arrow.from) + " to" + vectorText(arrow.to) + colourText(arrow.color) +
            numbersText({arrow.widthPoints, arrow.headPoints}) + "\n";
  }
  return text;
}

std::string drawnText(GuiStage& stage, const ViewportGpu& gpu) {
  app::Session* const session = stage.open.character();
  if (session == nullptr) {
    return "  no character\n";
  }
  const PictureContent content =
      workPicture(*session, stage.viewport, stage.ui.overlays, paletteOf(stage.theme.kind), gpu.measures);
  std::string text =
      fmt::format("  {} ghosts , shading {} , wire {} , floor {}\n", content.ghosts.size(),
                  static_cast<int>(content.style.shading), content.style.wireframe, content.style.floor);
  text += content.style.normals == skinning::NormalMatrix::plain ? "  normals by the joints' matrices\n" : "";
  for (const Ghost& ghost : content.ghosts) {
    text += "  ghost" + numbersText({ghost.frame.timeSeconds}) + colourText(ghost.tint) + "\n";
  }
  return text + overlayText(overlayOf(*gpu.uploaded, stage.viewport.view, content));
}

} // namespace

TEST_CASE("What is drawn over the character in each state of the view is as it was looked at") {
  GuiPainter painter;
  std::string text;
  std::map<std::string, std::string> firstWith; // what is drawn: in which state it was first
  for (const Overlays& wanted : overlays) {
    GuiStage stage(painter, ThemeKind::dark, 264.0F, 240.0F);
    openCharacter(stage);
    wanted.set(stage);
    stage.showViewport();
    const std::string drawn = drawnText(stage, painter.viewportGpu());
    const std::string first = firstWith.try_emplace(drawn, wanted.name).first->second;
    text += std::string(wanted.name) + "\n" + (first == wanted.name ? drawn : "  as " + first + "\n");
  }
  const std::string difference = test::differenceFromRecord("overlays", text, 2e-3);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("Labels and legends over the character in each state of the view are as they were looked at") {
  GuiPainter painter;
  std::string words;
  for (const Overlays& wanted : overlays) {
    const std::string name = wanted.name;
    if (name == "empty" || name == "welcome-wide") {
      continue; // Nothing is over a character.
    }
    GuiStage stage(painter, ThemeKind::dark, 640.0F, 420.0F);
    openCharacter(stage);
    wanted.set(stage);
    stage.showViewport();
    words += name + "\n" + test::drawnText();
  }
  test::compareWithRecord("drawn-viewports", words);
}

TEST_CASE(
    "What is offered while nothing is open is drawn as it was looked at, under each place of the mouse") {
  GuiPainter painter;
  const auto* const welcome = std::ranges::find(overlays, std::string("welcome-wide"), &Overlays::name);
  REQUIRE(welcome != std::end(overlays));
  GuiStage stage(painter, ThemeKind::dark, 640.0F, 420.0F);
  welcome->set(stage);
  std::string words;
  for (const float y : {20.0F, 120.0F, 268.0F, 315.0F, 340.0F}) {
    for (const float x : {100.0F, 320.0F, 520.0F}) {
      ImGui::GetIO().MousePos = {x, y};
      stage.showViewport();
      words += fmt::format("at {} {}\n", x, y) + test::drawnText();
    }
  }
  test::compareWithRecord("drawn-welcome", words);
}

TEST_CASE("Locators over the character, sure and guessed, are drawn as they were looked at") {
  GuiPainter painter;
  GuiStage stage(painter, ThemeKind::dark, 640.0F, 420.0F);
  openCharacter(stage);
  app::Session& session = *stage.open.character();
  if (session.document().locators.empty()) {
    test::run({stage.open, stage.ui, stage.status}, app::command::locatorsFit);
  }
  app::Document document = session.document();
  for (std::size_t i = 0; i < document.locators.list.size(); i += 3) {
    document.locators.list[i].confidence = 0.3;
  }
  session.edit(std::move(document), "Doubt locators");
  session.view().showLocators = true;
  stage.showViewport();
  std::string text = drawnText(stage, painter.viewportGpu()) + test::drawnText();
  REQUIRE(session.document().locators.list.size() > 10);
  app::selectLocators(session, {session.document().locators.list[4].name});
  stage.showViewport();
  text += "one is selected\n" + drawnText(stage, painter.viewportGpu()) + test::drawnText();
  test::compareWithRecord("drawn-locators", text);
}

TEST_CASE("What is told beside the mouse over the character is as it was looked at") {
  GuiPainter painter;
  std::string words;
  for (const Overlays& wanted : overlays) {
    const std::string name = wanted.name;
    const bool isMeant = name == "handles" || name == "controllers-selected" || name == "skeleton" ||
                         name == "sequence-thickness-wide";
    if (!isMeant) {
      continue;
    }
    GuiStage stage(painter, ThemeKind::dark, 640.0F, 420.0F);
    openCharacter(stage);
    wanted.set(stage);
    stage.showViewport();
    words += name + "\n";
    std::string before;
    for (float y = 60.0F; y < 400.0F; y += 36.0F) {
      for (float x = 80.0F; x < 600.0F; x += 40.0F) {
        ImGui::GetIO().MousePos = {x, y};
        stage.showViewport();
        const std::string drawn = test::drawnText();
        if (drawn != before) {
          words += fmt::format(" at {} {}\n", x, y) + drawn;
        }
        before = drawn;
      }
    }
  }
  test::compareWithRecord("told-beside-the-mouse", words);
}

TEST_CASE("Picture: the viewport with each of its overlays in both themes") {
  GuiPainter painter;
  for (const Overlays& wanted : overlays) {
    for (const ThemeKind kind : {ThemeKind::dark, ThemeKind::light}) {
      if (wanted.isWide && kind == ThemeKind::light) {
        continue;
      }
      GuiStage stage(painter, kind, wanted.isWide ? 560.0F : 264.0F, wanted.isWide ? 400.0F : 240.0F);
      openCharacter(stage);
      wanted.set(stage);
      stage.showViewport();
      const std::string difference = test::differenceFromBaseline(
          std::string("viewport-") + wanted.name + (kind == ThemeKind::dark ? "-dark" : "-light"),
          stage.picture());
      INFO(difference);
      CHECK(difference.empty());
    }
  }
}
