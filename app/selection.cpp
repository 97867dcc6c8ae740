#include "app/selection.h"

#include <utility>

namespace stretch::app {

namespace {

/// One member of the kind that is selected; of another kind: none.
template <typename Kind, typename Variant, typename Value>
const Value& selectedPart(const Variant& selected, Value Kind::*part) {
  static const Kind nothing;
  const Kind* const kind = std::get_if<Kind>(&selected);
  return (kind == nullptr ? nothing : *kind).*part;
}

} // namespace

const std::vector<std::string>& Selection::limbs() const {
  return selectedPart(selected_, &TrailSelection::limbs);
}

int Selection::trail() const {
  return selectedPart(selected_, &TrailSelection::trail);
}

const std::vector<double>& Selection::spheres() const {
  return selectedPart(selected_, &TrailSelection::spheres);
}

const std::vector<int>& Selection::trailsBeside() const {
  return selectedPart(selected_, &TrailSelection::beside);
}

const std::vector<std::string>& Selection::controllers() const {
  return selectedPart(selected_, &ControllerSelection::ids);
}

const std::vector<std::string>& Selection::locators() const {
  return selectedPart(selected_, &LocatorSelection::names);
}

TrailSelection& Selection::editTrails() {
  if (!std::holds_alternative<TrailSelection>(selected_)) {
    selected_ = TrailSelection{};
  }
  return std::get<TrailSelection>(selected_);
}

void Selection::setControllers(std::vector<std::string> ids) {
  if (!ids.empty()) {
    selected_ = ControllerSelection{std::move(ids)};
  } else if (std::holds_alternative<ControllerSelection>(selected_)) {
    selected_ = TrailSelection{};
  }
}

void Selection::setLocators(std::vector<std::string> names) {
  if (!names.empty()) {
    selected_ = LocatorSelection{std::move(names)};
  } else if (std::holds_alternative<LocatorSelection>(selected_)) {
    selected_ = TrailSelection{};
  }
}

void Selection::dropSpheres() {
  if (auto* const trails = std::get_if<TrailSelection>(&selected_)) {
    trails->spheres.clear();
  }
}

void Selection::dropTrail() {
  if (auto* const trails = std::get_if<TrailSelection>(&selected_)) {
    trails->trail = 0;
    trails->spheres.clear();
    trails->beside.clear();
  }
}

void Selection::dropHandles() {
  if (!std::holds_alternative<TrailSelection>(selected_)) {
    selected_ = TrailSelection{};
  }
}

} // namespace stretch::app
