#include "ui/panels/trails/trail_group_row.h"

#include <algorithm>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "ui/panels/context/panel_support.h"
#include "ui/panels/menus/context_menu.h"
#include "ui/panels/trails/trail_list_row.h"
#include "ui/widgets/icons.h"

namespace stretch::ui {

namespace {

const rig::Trail& trailOf(const PanelContext& context, int id) {
  return *app::findTrail(context.open.character()->document(), id);
}

/// "3 trails, 21-27, x3": range and scale where all of them share it.
std::string groupDetail(const PanelContext& context, const std::vector<int>& members) {
  const rig::TrailSettings& first = trailOf(context, members.front()).settings;
  const auto shared = [&](auto&& same) {
    return std::ranges::all_of(members, [&](int id) { return same(trailOf(context, id).settings); });
  };
  std::string text = std::to_string(members.size()) + " trails";
  if (shared([&](const rig::TrailSettings& s) {
        return s.startFrame == first.startFrame && s.endFrame == first.endFrame;
      })) {
    text += ", " + shortNumber(first.startFrame, 1) + "\xE2\x80\x93" + shortNumber(first.endFrame, 1);
  }
  if (shared([&](const rig::TrailSettings& s) { return s.scale == first.scale; })) {
    text += ", \xC3\x97" + shortNumber(first.scale);
  }
  return text;
}

/// One edit of all members, one undo step.
template <typename Edit>
void editMembers(PanelContext& context, const std::vector<int>& members, const char* label, Edit&& edit) {
  Result<app::Document> document = context.character().document();
  for (const int id : members) {
    document = document ? edit(*document, id) : document;
  }
  editOnce(context, label, document);
}

void groupButtons(PanelContext& context, const std::string& id, const std::vector<int>& members) {
  const bool visible =
      std::ranges::all_of(members, [&](int member) { return trailOf(context, member).visible; });
  if (rowButton(context, id + "/visible", visible ? icon::visible : icon::hidden, visible ? "o" : "-", false,
                {"Visible", "Shows or hides every trail of the group in the viewport.", {}})) {
    editMembers(context, members, visible ? "Hide the trails" : "Show the trails",
                [&](const app::Document& document, int member) {
                  const rig::Trail& trail = *app::findTrail(document, member);
                  return app::setTrailDisplay(document, member, {trail.colour, !visible, trail.pinned});
                });
  }
  if (rowButton(context, id + "/apart", icon::unlink, "/", false,
                {"Take the group apart", "The trails stay as they are, each by itself.",
                 keyOf(context, command::trailTakeApart)})) {
    editOnce(context, "Take the group apart", app::takeApart(context.character().document(), members));
  }
  if (rowButton(context, id + "/delete", icon::trash, "x", false,
                {"Delete the trails of this group", "Gives their range back exactly as the source has it.",
                 keyOf(context, command::trailDelete)})) {
    editMembers(context, members, "Delete the trails", app::deleteTrail);
  }
}

/// The arrow in front; a click folds the members away, or brings them back.
bool foldArrow(PanelContext& context, const std::string& id, float height) {
  std::vector<std::string>& closed = context.ui.closedSections;
  const auto found = std::find(closed.begin(), closed.end(), id);
  bool open = found == closed.end();
  const Control arrow = takePlace(widgetsOf(context), id + "/fold", {context.theme.px(24.0F), height});
  tooltip(widgetsOf(context), {"Trails of the group", open ? "Folds them away." : "Lists them.", {}});
  if (arrow.clicked && open) {
    closed.push_back(id);
  } else if (arrow.clicked) {
    closed.erase(found);
  }
  open = open != arrow.clicked;
  // A drawn triangle needs no font of icons.
  const ImVec2 middle = arrow.box.centre();
  const float r = context.theme.px(4.0F);
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const ImU32 colour = arrow.hovered ? context.theme.colours.text : context.theme.colours.quietText;
  if (open) {
    list->AddTriangleFilled({middle.x - r, middle.y - 0.6F * r}, {middle.x + r, middle.y - 0.6F * r},
                            {middle.x, middle.y + 0.8F * r}, colour);
  } else {
    list->AddTriangleFilled({middle.x - 0.6F * r, middle.y - r}, {middle.x + 0.8F * r, middle.y},
                            {middle.x - 0.6F * r, middle.y + r}, colour);
  }
  return open;
}

void groupText(PanelContext& context, const std::string& id, const std::vector<int>& members, bool selected) {
  const Theme& theme = context.theme;
  const std::string title = capitalised(app::groupTitle(context.open.character()->document(), members));
  const std::string detail = groupDetail(context, members);
  const RowClicks mouse =
      rowText(context,
              {.id = id,
               .title = title,
               .detail = detail,
               .colour = selected ? theme.colours.accent : theme.colours.text,
               .help = {title,
                        detail + ". Click selects all of them: what is set then is set for each. A double "
                                 "click renames the group, a right click opens its menu.",
                        keyOf(context, command::trailSelectGroup)}},
              3);
  if (mouse.clicked || mouse.renames || mouse.asksMenu) {
    app::selectGroup(context.character(), members.front());
  }
  if (mouse.renames) {
    request(context, command::trailRename);
  }
  if (mouse.asksMenu) {
    askForMenu(context.ui, MenuTarget::group);
  }
}

} // namespace

bool trailGroupRow(PanelContext& context, const std::vector<int>& members) {
  const Theme& theme = context.theme;
  const std::string id = "trails/group-" + std::to_string(trailOf(context, members.front()).group);
  const float height = rowLines(theme).whole;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool selected = app::wholeGroupSelected(*context.open.character()) == members;
  fillRow(context, selected);
  ImGui::BeginGroup();
  const bool open = foldArrow(context, id, height);
  ImGui::SameLine(0.0F, theme.px(4.0F));
  groupText(context, id, members, selected);
  groupButtons(context, id, members);
  ImGui::EndGroup();
  ImGui::SetCursorScreenPos({corner.x, corner.y + height});
  return open;
}

} // namespace stretch::ui
