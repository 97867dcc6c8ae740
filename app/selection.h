#pragma once

#include <string>
#include <variant>
#include <vector>

namespace stretch::app {

/// Limbs and what is on them.
struct TrailSelection {
  std::vector<std::string> limbs; ///< Ids, in the order in which they were selected.
  int trail = 0;                  ///< Id; 0 none.
  std::vector<double> spheres;    ///< Frames of selected control spheres of that trail.
  std::vector<int> beside = {};   ///< Ids of trails that were added to it, of selected limbs.

  friend bool operator==(const TrailSelection&, const TrailSelection&) = default;
};

/// Controllers, by id, in the order in which they were selected.
struct ControllerSelection {
  std::vector<std::string> ids;

  friend bool operator==(const ControllerSelection&, const ControllerSelection&) = default;
};

/// Locators, by name, in the order in which they were selected.
struct LocatorSelection {
  std::vector<std::string> names;

  friend bool operator==(const LocatorSelection&, const LocatorSelection&) = default;
};

/// Selected things of one kind at a time: limbs with a trail and its spheres, or controllers, or locators, so
/// that a key has one meaning. Readers answer nothing for the kinds that are not selected; their lists are
/// valid until the selection is changed. Ids need not exist: the session drops those that are gone.
class Selection {
public:
  [[nodiscard]] const std::vector<std::string>& limbs() const;
  [[nodiscard]] int trail() const; ///< 0 none.
  [[nodiscard]] const std::vector<double>& spheres() const;
  [[nodiscard]] const std::vector<int>& trailsBeside() const;
  [[nodiscard]] const std::vector<std::string>& controllers() const;
  [[nodiscard]] const std::vector<std::string>& locators() const;

  /// Limbs, trail and spheres, to be changed; controllers and locators are dropped.
  [[nodiscard]] TrailSelection& editTrails();
  /// Selects these alone. An empty list drops what is selected of this kind, and nothing else.
  void setControllers(std::vector<std::string> ids);
  void setLocators(std::vector<std::string> names);

  /// Drops the spheres; or the trail, those beside it and its spheres, limbs stay selected. Other kinds stay
  /// as they are.
  void dropSpheres();
  void dropTrail();
  /// Drops controllers and locators; limbs, trail and spheres stay.
  void dropHandles();

  friend bool operator==(const Selection&, const Selection&) = default;

private:
  std::variant<TrailSelection, ControllerSelection, LocatorSelection> selected_;
};

} // namespace stretch::app
