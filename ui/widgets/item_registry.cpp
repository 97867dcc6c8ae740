#include "ui/widgets/item_registry.h"

#include <algorithm>

namespace stretch::ui {

void ItemRegistry::add(std::string id, const ImVec2& min, const ImVec2& max, bool enabled) {
  items.push_back({std::move(id), min, max, enabled, false});
}

const Item* ItemRegistry::find(std::string_view id) const {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.id == id; });
  return found == items.end() ? nullptr : &*found;
}

} // namespace stretch::ui
