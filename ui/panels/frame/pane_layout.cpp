#include "ui/panels/frame/pane_layout.h"

#include <algorithm>

#include "app/commands/table/frames.h"

namespace stretch::ui {

namespace {

constexpr float splitterWidth = 6.0F; ///< What the mouse can take, design pixels.

/// How wide two panes beside the viewport may be together, shrunk alike.
void shrinkToFit(float& first, float& second, float available) {
  const float wanted = first + second;
  if (wanted > available && wanted > 0.0F) {
    const float share = std::max(0.0F, available) / wanted;
    first *= share;
    second *= share;
  }
}

struct Splitter {
  const char* id;
  Rect box;
  bool upright;        ///< Drags left and right.
  float growDirection; ///< +1: dragging to the right or down makes the pane larger.
  float shown;         ///< Size that it starts from, window units.
  float* size;
  bool* open;
};

void drawSplitter(PanelContext& context, const Splitter& splitter) {
  ImGui::SetNextWindowPos(splitter.box.min);
  ImGui::SetNextWindowSize({splitter.box.width(), splitter.box.height()});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                                 ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                 ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin(splitter.id, nullptr, flags)) {
    const WidgetContext widgets{context.theme, context.items};
    const Control control = takePlace(widgets, splitter.id, {splitter.box.width(), splitter.box.height()});
    if (control.hovered || control.held) {
      ImGui::SetMouseCursor(splitter.upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
      ImGui::GetWindowDrawList()->AddRectFilled(splitter.box.min, splitter.box.max,
                                                context.theme.colours.accent, context.theme.px(2.0F));
    }
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    const float moved = splitter.upright ? delta.x : delta.y;
    if (control.held && moved != 0.0F) {
      const float grown = splitter.shown + splitter.growDirection * moved;
      *splitter.size = std::clamp(grown / context.theme.scale, smallestPane, 900.0F);
    }
    if (control.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      *splitter.open = false;
    }
    tooltip(widgets, {"Drag to resize", "A double click folds the pane away.", {}});
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

} // namespace

bool showsGraph(const app::OpenDocument& open, BottomTab tab) {
  const app::Session* const session = open.character();
  return tab == BottomTab::graph && session != nullptr &&
         app::hasClip(session->document(), session->view().clip);
}

PaneSizes sizesBeside(const PaneSizes& sizes, bool graphShows, float windowHeight) {
  PaneSizes shown = sizes;
  if (graphShows) {
    shown.bottom = sizes.graph > 0.0F ? std::max(sizes.graph, smallestPane)
                                      : std::max(sizes.bottom, windowHeight / 3.0F);
  }
  return shown;
}

PaneRects dividePanes(const PaneSizes& sizes, float width, float height, float scale, float menuHeight,
                      float statusHeight) {
  float left = sizes.leftOpen ? sizes.left * scale : 0.0F;
  float right = sizes.rightOpen ? sizes.right * scale : 0.0F;
  shrinkToFit(left, right, width - smallestViewport * scale);
  float bottom = sizes.bottomOpen ? sizes.bottom * scale : 0.0F;
  float none = 0.0F;
  const float middleHeight = std::max(0.0F, height - menuHeight - statusHeight);
  shrinkToFit(bottom, none, middleHeight - 160.0F * scale);

  PaneRects rects;
  const float statusTop = std::max(menuHeight, height - statusHeight);
  const float bottomTop = statusTop - bottom;
  const float rightEdge = std::max(left, width - right);
  rects.menu = {{0.0F, 0.0F}, {width, menuHeight}};
  rects.left = {{0.0F, menuHeight}, {left, bottomTop}};
  rects.viewport = {{left, menuHeight}, {rightEdge, bottomTop}};
  rects.right = {{rightEdge, menuHeight}, {width, bottomTop}};
  rects.bottom = {{0.0F, bottomTop}, {width, statusTop}};
  rects.status = {{0.0F, statusTop}, {width, height}};
  return rects;
}

void drawSplitters(PanelContext& context, const PaneRects& rects, PaneSizes& sizes) {
  const float half = 0.5F * context.theme.px(splitterWidth);
  if (sizes.leftOpen) {
    drawSplitter(context,
                 {"splitter/left",
                  {{rects.left.max.x - half, rects.left.min.y}, {rects.left.max.x + half, rects.left.max.y}},
                  true,
                  1.0F,
                  sizes.left * context.theme.scale,
                  &sizes.left,
                  &sizes.leftOpen});
  }
  if (sizes.rightOpen) {
    drawSplitter(context, {"splitter/right",
                           {{rects.right.min.x - half, rects.right.min.y},
                            {rects.right.min.x + half, rects.right.max.y}},
                           true,
                           -1.0F,
                           sizes.right * context.theme.scale,
                           &sizes.right,
                           &sizes.rightOpen});
  }
  if (sizes.bottomOpen) {
    drawSplitter(context, {"splitter/bottom",
                           {{rects.bottom.min.x, rects.bottom.min.y - half},
                            {rects.bottom.max.x, rects.bottom.min.y + half}},
                           false,
                           -1.0F,
                           rects.bottom.height(),
                           showsGraph(context.open, context.ui.time.tab) ? &sizes.graph : &sizes.bottom,
                           &sizes.bottomOpen});
  }
}

} // namespace stretch::ui
