#include "tests/bench/graph_bench.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <imgui.h>

#include "app/commands/keys/keys.h"
#include "app/commands/table/selection.h"
#include "app/edits/keys/key_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/open_document.h"
#include "core/base/check.h"
#include "core/math/rotation.h"
#include "ui/panels/context/panels.h"
#include "ui/panels/rows/graph_model.h"

namespace stretch::bench {

namespace {

constexpr int tracks = 400;
constexpr int keysOfTrack = 600;
constexpr double rate = 30.0;
constexpr float width = 1280.0F;
constexpr float height = 400.0F;

Track swingingTrack(NodeIndex node) {
  Track track;
  track.node = node;
  track.channel = Channel::rotation;
  track.width = 4;
  for (int key = 0; key < keysOfTrack; ++key) {
    const double phase = 0.07 * key + 0.31 * node.value;
    const Quat turn = axisAngle(glm::normalize(Vec3(1.0, 0.3, std::sin(0.1 * node.value))), std::sin(phase));
    track.times.push_back(static_cast<float>(key / rate));
    for (const double number : {turn.x, turn.y, turn.z, turn.w}) {
      track.values.push_back(static_cast<float>(number));
    }
  }
  return track;
}

/// The character with one clip that keys that many joints.
app::Document manyKeys(app::Document document) {
  Scene scene = *document.scene;
  const NodeIndex carrier = document.body.limbs.front().joints.front();
  Clip clip;
  clip.name = "Many keys";
  for (int i = 0; i < tracks; ++i) {
    const NodeIndex node(static_cast<int>(scene.nodes.size()));
    Node& joint = scene.nodes.emplace_back();
    joint.name = "Joint " + std::to_string(i);
    joint.parent = carrier;
    scene.nodes[static_cast<std::size_t>(carrier.value)].children.push_back(node);
    clip.tracks.emplace_back(swingingTrack(node));
  }
  clip.endSeconds = (keysOfTrack - 1) / rate;
  clip.framesPerSecond = rate;
  document.scene = std::make_shared<const Scene>(std::move(scene));
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{std::move(clip)});
  document.sourceClips = nullptr;
  return document;
}

/// The bottom pane alone, drawn into lists.
class Pane {
public:
  explicit Pane(const app::Document& document) : gui_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {width, height};
    io.DeltaTime = 1.0F / 60.0F;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset; // As the window has it.
    io.MousePos = {600.0F, 200.0F};
    theme_ = ui::makeTheme(ui::ThemeKind::dark, 1.0F);
    ui::applyStyle(theme_);
    unsigned char* pixels = nullptr;
    int atlasWidth = 0;
    int atlasHeight = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &atlasWidth, &atlasHeight);
    open_.open(document);
    app::selectLimb(session(), document.body.limbs.front().id, false);
    ui.time.graph.joint = 1 << 20; // The last of the list: the whole body.
  }
  ~Pane() { ImGui::DestroyContext(gui_); }
  Pane(const Pane&) = delete;
  Pane& operator=(const Pane&) = delete;

  [[nodiscard]] app::Session& session() { return *open_.character(); }

  /// Until nothing waits for a later frame.
  void settle() {
    do {
      frame(true);
    } while (!ui.time.graph.complete);
  }

  void frame(bool shows) {
    ImGui::NewFrame();
    ui::PanelContext context{open_, ui, theme_, commands_, requested_, items_, status_};
    ui::beginPanels(context);
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin("bottom", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    if (shows) {
      ui::drawBottomPanel(context);
    }
    ImGui::End();
    ImGui::Render();
    session().view().frame = std::fmod(session().view().frame + 1.0, keysOfTrack - 1.0);
  }

  ui::UiState ui;

private:
  ImGuiContext* gui_;
  app::OpenDocument open_;
  ui::EditorStatus status_;
  ui::Theme theme_;
  ui::ItemRegistry items_;
  std::vector<ui::CommandInfo> commands_;
  std::vector<std::string> requested_;
};

/// One key of one curve, as a drag of the mouse does.
void dragKey(Pane& pane, const app::KeySelection& picked, double value) {
  app::Session& session = pane.session();
  const Result<app::EditedKeys> moved = app::moveKeys(session.atBegin(), 0, picked, {0.0, value});
  check(moved.ok(), "the key of a bench can be moved");
  session.preview(moved->document);
}

} // namespace

void measureGraph(const app::Document& character, const Options& options) {
  Pane pane(manyKeys(character));
  Table table("a frame of the graph and the dope sheet, 400 tracks of 600 keys", options);
  table.add("a frame of that clip, solved",
            [&] { static_cast<void>(app::evaluateOriginal(pane.session().document(), 0, 5.0)); });
  pane.ui.time.tab = ui::BottomTab::graph;
  pane.settle();
  table.add("the graph, while it plays", [&] { pane.frame(true); });
  double start = 0.0;
  table.add("the graph, zoomed or panned", [&] {
    start = std::fmod(start + 1.0, 200.0);
    pane.ui.time.timeline.viewStart = start;
    pane.ui.time.timeline.viewEnd = start + 300.0;
    pane.frame(true);
  });
  const app::KeySelection picked{{pane.ui.time.graph.rows.front(), {{150, 1U}}}};
  app::pickKeys(pane.session(), picked, false);
  pane.session().begin("Move a key");
  double value = 0.0;
  table.add("a key dragged, without the graph", [&] {
    value = std::fmod(value + 1.0, 40.0);
    dragKey(pane, picked, value);
    static_cast<void>(pane.session().sharedMotion());
    pane.frame(false);
  });
  table.add("the graph, a key dragged", [&] {
    value = std::fmod(value + 1.0, 40.0);
    dragKey(pane, picked, value);
    pane.frame(true);
  });
  pane.session().cancel();
  pane.ui.time.tab = ui::BottomTab::dopeSheet;
  pane.frame(true);
  table.add("the dope sheet, while it plays", [&] { pane.frame(true); });
  const std::vector<app::KeyRow> all = app::keyedRows(pane.session().document(), 0);
  app::pickKeys(pane.session(), app::allKeys(pane.session().document(), 0, all), false);
  table.add("the dope sheet, all keys picked", [&] { pane.frame(true); });
  pane.ui.time.tab = ui::BottomTab::graph;
  pane.settle();
  table.add("the graph, all keys picked", [&] { pane.frame(true); });
  table.print();
}

} // namespace stretch::bench
