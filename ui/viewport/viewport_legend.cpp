#include "ui/viewport/viewport_legend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "app/commands/table/selection.h"
#include "ui/panels/context/panel_support.h"
#include "ui/render/scene/value_colors.h"
#include "ui/render/view/palette.h"
#include "ui/viewport/viewport_scene.h"
#include "ui/widgets/color_legend.h"

namespace stretch::ui {

namespace {

/// How a thing looks in the picture, so that two of one colour stay apart.
enum class LegendMark { line, dashes, figure };

struct LegendRow {
  ImU32 colour;
  LegendMark mark;
  const char* text;
  std::vector<ImU32> others = {}; ///< Further colours of such lines in the picture.
};

/// The trails that are drawn: the selected one first.
std::vector<const ShownTrail*> explainedTrails(const ViewportContext& context) {
  const app::Session& session = *context.open.character();
  std::vector<const ShownTrail*> drawn;
  for (const ShownTrail& trail : context.viewport.shown.trails) {
    const rig::Trail* const source = app::findTrail(session.document(), trail.id);
    if (source != nullptr && isDrawn(*source, session.view().selection.limbs(), context.ui.overlays)) {
      const bool isSelected = trail.id == session.view().selection.trail();
      drawn.insert(isSelected ? drawn.begin() : drawn.end(), &trail);
    }
  }
  return drawn;
}

/// What the lines and ghosts are that stand in the picture.
std::vector<LegendRow> legendRows(const ViewportContext& context) {
  std::vector<LegendRow> rows;
  const std::vector<const ShownTrail*> trails = explainedTrails(context);
  if (!trails.empty()) {
    rows.push_back({originalColour(context.theme.kind), LegendMark::dashes, "original path"});
  }
  if (!trails.empty() && trails.front()->exaggerated) {
    rows.push_back({trailColour(trails.front()->colour, context.theme.kind), LegendMark::line,
                    trails.front()->applied ? "applied" : "exaggerated"});
    for (const ShownTrail* const other : trails) {
      const ImU32 colour = trailColour(other->colour, context.theme.kind);
      const bool isNew = colour != rows.back().colour && std::ranges::count(rows.back().others, colour) == 0;
      if (other->exaggerated && isNew) {
        rows.back().others.push_back(colour);
      }
    }
  }
  const Palette palette = paletteOf(context.theme.kind);
  if (context.ui.overlays.ghosts) {
    rows.push_back({packed(palette.ghostBefore), LegendMark::figure, "ghosts before"});
    rows.push_back({packed(palette.ghostAfter), LegendMark::figure, "ghosts after"});
  }
  if (context.viewport.tipFrame) {
    rows.push_back({packed(palette.ghostTip), LegendMark::figure, "pose at the tip"});
  }
  return rows;
}

/// A small person, see-through as ghosts are.
void drawFigure(ImDrawList& draw, const Theme& theme, const ImVec2& centre, ImU32 colour) {
  const ImU32 fill = faded(colour, 0.75F);
  draw.AddCircleFilled({centre.x, centre.y - theme.px(4.0F)}, theme.px(2.5F), fill);
  draw.AddRectFilled({centre.x - theme.px(3.0F), centre.y - theme.px(1.0F)},
                     {centre.x + theme.px(3.0F), centre.y + theme.px(6.0F)}, fill, theme.px(2.0F));
}

void drawMark(ImDrawList& draw, const Theme& theme, const ImVec2& left, const LegendRow& row) {
  const float half = theme.px(1.5F);
  const float width = theme.px(20.0F);
  switch (row.mark) {
  case LegendMark::line: {
    const float share = width / static_cast<float>(row.others.size() + 1);
    draw.AddRectFilled({left.x, left.y - half}, {left.x + width, left.y + half}, row.colour);
    for (std::size_t i = 0; i < row.others.size(); ++i) {
      const float from = left.x + share * static_cast<float>(i + 1);
      draw.AddRectFilled({from, left.y - half}, {from + share, left.y + half}, row.others[i]);
    }
    break;
  }
  case LegendMark::dashes:
    for (const float from : {0.0F, 12.0F}) {
      draw.AddRectFilled({left.x + theme.px(from), left.y - half},
                         {left.x + theme.px(from + 8.0F), left.y + half}, row.colour);
    }
    break;
  case LegendMark::figure:
    drawFigure(draw, theme, {left.x + 0.5F * width, left.y}, row.colour);
    break;
  }
}

/// Answers its upper edge.
float drawTrailLegend(ViewportContext& context, float bottom) {
  const Theme& theme = context.theme;
  const Rect& box = context.viewport.box;
  const std::vector<LegendRow> rows = legendRows(context);
  const float rowHeight = theme.px(18.0F);
  const float width = theme.px(132.0F);
  if (rows.empty() || box.width() < 3.0F * width) {
    return bottom;
  }
  const float height = rowHeight * static_cast<float>(rows.size()) + theme.unit();
  const ImVec2 corner{box.max.x - theme.unit() * 1.5F - width, bottom - height};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(corner, {corner.x + width, corner.y + height}, faded(theme.colours.background, 0.6F),
                      theme.corner());
  context.items.add("viewport/trail-legend", corner, {corner.x + width, corner.y + height});
  const WidgetContext widgets{theme, context.items};
  float y = corner.y + 0.5F * theme.unit();
  for (const LegendRow& row : rows) {
    drawMark(*draw, theme, {corner.x + theme.unit(), y + 0.5F * rowHeight}, row);
    drawText(
        widgets, theme.fonts.label,
        {{corner.x + theme.unit() + theme.px(28.0F), y}, {corner.x + width - theme.px(4.0F), y + rowHeight}},
        theme.colours.text, row.text);
    y += rowHeight;
  }
  return corner.y - theme.unit();
}

/// A legend in the lower right corner, above what ends at `bottom`; in one row where the picture is narrow,
/// none where it is narrower still.
void drawScale(ViewportContext& context, float bottom, const char* id, const ColorLegend& legend) {
  const Rect& box = context.viewport.box;
  const WidgetContext widgets{context.theme, context.items};
  const float right = box.max.x - context.theme.unit() * 1.5F;
  const ImVec2 size = legendSize(context.theme, legend);
  const ImVec2 row = legendRowSize(context.theme);
  if (box.width() >= 1.5F * size.x) {
    drawColorLegend(widgets, id, {right - size.x, bottom - size.y}, legend);
  } else if (box.width() >= 1.5F * row.x) {
    drawLegendRow(widgets, id, {right - row.x, bottom - row.y}, legend);
  }
}

/// What the colours of weights say, and whose they are.
void drawWeightLegend(ViewportContext& context, float bottom) {
  const Scene& scene = *context.open.character()->document().scene;
  drawScale(context, bottom, "viewport/weight-legend",
            {"Weights of " + nodeName(scene, context.viewport.weightsOf), "0", "1",
             "grey: follows other joints", [](double share) {
               const std::uint32_t hex = valueColorHex(ValueScale::weight, share);
               return packed(rgba(hex));
             }});
}

/// What the stretch colours say.
void drawHeatLegend(ViewportContext& context, float bottom) {
  const ColorLegend legend{"Stretch", fmt::format("\xC3\x97{:g}", smallestShownStretch),
                           fmt::format("\xC3\x97{:g}", largestShownStretch), "grey: as long as at rest",
                           [](double share) {
                             const double ratio = smallestShownStretch *
                                                  std::pow(largestShownStretch / smallestShownStretch, share);
                             return packed(stretchColorSrgb(ratio));
                           }};
  drawScale(context, bottom, "viewport/stretch-legend", legend);
}

} // namespace

void drawLegends(ViewportContext& context) {
  const float bottom = context.viewport.box.max.y - context.theme.unit() * 1.5F;
  const float left = drawTrailLegend(context, bottom);
  if (context.viewport.weightsOf.exists()) {
    drawWeightLegend(context, left);
  } else if (context.ui.overlays.heatMap) {
    drawHeatLegend(context, left);
  }
}

} // namespace stretch::ui
