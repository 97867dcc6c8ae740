#include "tests/support/ui_driver/shown_places.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <imgui.h>

namespace stretch::test {

using namespace ui;

std::string toastsInPicture(const Shell& shell) {
  const Item* const picture = shell.items.find("viewport");
  std::string inside = "none";
  for (const Item& item : shell.items.items) {
    if (picture == nullptr || !item.id.starts_with("toast/")) {
      continue;
    }
    const bool isInside = item.min.x >= picture->min.x && item.min.y >= picture->min.y &&
                          item.max.x <= picture->max.x && item.max.y <= picture->max.y;
    inside = isInside && inside != "no" ? "yes" : "no";
  }
  return inside;
}

std::string shareOfPicture(const Shell& shell, const char* id) {
  const Item* const picture = shell.items.find("viewport");
  const Item* const item = shell.items.find(id);
  return picture == nullptr || item == nullptr
             ? "none"
             : fmt::format("{:.2f}", (item->max.y - item->min.y) / (picture->max.y - picture->min.y));
}

std::string shareBelowPicture(const Shell& shell) {
  const Item* const handle = shell.items.find("splitter/bottom");
  const float height = ImGui::GetIO().DisplaySize.y;
  return handle == nullptr ? "none" : fmt::format("{:.2f}", 1.0F - handle->centre().y / height);
}

std::string shareLeftOfPicture(const Shell& shell) {
  const Item* const handle = shell.items.find("splitter/left");
  return handle == nullptr ? "none"
                           : fmt::format("{:.2f}", handle->centre().x / ImGui::GetIO().DisplaySize.x);
}

bool toastsCoverFigure(const Shell& shell) {
  const std::optional<Rect>& figure = shell.viewport.messages.figure;
  return figure && std::ranges::any_of(shell.items.items, [&](const Item& item) {
           return item.id.starts_with("toast/") && figure->overlaps({item.min, item.max});
         });
}

bool menuCoversBar(const Shell& shell) {
  const Item* const menu = shell.items.find("context-menu");
  return std::any_of(shell.items.items.begin(), shell.items.items.end(), [&](const Item& item) {
    const bool isBar = item.id.starts_with("timeline/trail-") && item.id.ends_with("/body");
    return menu != nullptr && isBar && Rect{menu->min, menu->max}.contains(item.centre());
  });
}

bool menuIsInWindow(const Shell& shell) {
  const Item* const menu = shell.items.find("context-menu");
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  return menu != nullptr && menu->min.x >= 0.0F && menu->min.y >= 0.0F && menu->max.x <= window.x &&
         menu->max.y <= window.y;
}

} // namespace stretch::test
