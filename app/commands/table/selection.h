#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/edits/trail/sphere_edits.h"
#include "app/session.h"

namespace stretch::app {

// Selection that commands act on: pure questions to the session's view state, and the few ways of changing
// it.

/// Selects a limb alone, or adds it (again: takes it away). Its trail at the playhead becomes the selected
/// one, else none: the next one is made where the playhead stands.
void selectLimb(Session& session, const std::string& limbId, bool add);

/// Selects a trail with its limb; 0 deselects.
void selectTrail(Session& session, int trailId);

/// Selects a trail as a list does: it alone with its limb, or (`add`) beside the one that leads; again takes
/// it away. A limb goes with its last trail.
void selectTrailInList(Session& session, int trailId, bool add);

/// Selects a trail with all others of its group and their limbs; a trail that stands alone as selectTrail().
void selectGroup(Session& session, int trailId);

/// Ids of the trails that commands act on: the selected trail, those that were added to it, and of the other
/// selected limbs those of its group, else those that share time with it; without a selected trail those of
/// the selected limbs in which the playhead stands, else each limb's only one.
[[nodiscard]] std::vector<int> targetTrails(const Session& session);

/// Returns those of these trails that lie over the selected one's range: its ends are changed together, other
/// ranges stay. While something is dragged, as it was when that began.
[[nodiscard]] std::vector<int> targetsOfRange(const Session& session);

/// The limbs that commands about a limb's weight act on: the selected ones, else the selected trail's.
[[nodiscard]] std::vector<std::string> targetLimbs(const Session& session);

/// Null when none is selected.
[[nodiscard]] const rig::Trail* selectedTrail(const Session& session);
[[nodiscard]] bool hasSelectedTrail(const Session& session);

[[nodiscard]] bool isSelected(const Session& session, const std::string& limbId);

/// Selects a controller alone, or adds it (again: takes it away). Limbs, trails and spheres are then selected
/// no longer.
void selectController(Session& session, const std::string& id, bool add);
/// Selects these controllers and nothing else.
void selectControllers(Session& session, std::vector<std::string> ids);
void clearControllers(Session& session);
[[nodiscard]] bool isControllerSelected(const Session& session, const std::string& id);
[[nodiscard]] bool hasControllers(const Session& session); ///< At least one is selected.

/// Whether locators are shown and can be moved.
[[nodiscard]] bool showsLocators(const Session& session);

/// Selects a locator alone, or adds it (again: takes it away). Nothing else is then selected.
void selectLocator(Session& session, const std::string& name, bool add);
/// Selects these locators and nothing else.
void selectLocators(Session& session, std::vector<std::string> names);

/// How people call a controller or an attribute: "left hand", "left arm stretch", or the joint's name.
[[nodiscard]] std::string controllerTitle(const Document& document, const std::string& id);

/// The prepared trail; null when it is not in the viewed clip.
[[nodiscard]] const rig::SolvedTrail* solvedTrail(Session& session, int trailId);

/// Control spheres of a trail as they stand in the world, in order of time.
[[nodiscard]] std::vector<PlacedSphere> placedSpheres(Session& session, int trailId);

/// The limbs that the keys 1 to 9 go to, in the order of the diagram: those of the body's plan that were
/// found or are usual for it; of a body of no known plan its chains.
[[nodiscard]] std::vector<std::string> limbsByKey(const Document& document);

/// How people call a limb, of a body that may lack it: "left arm", or the chain's id.
[[nodiscard]] std::string limbTitle(const Document& document, const std::string& limbId);

/// Returns the title of the limb that a key goes to, from 0; "eighth limb" where the body has fewer.
[[nodiscard]] std::string limbTitleOfKey(const Document& document, std::size_t key);

/// Returns a trail's title: its own name, else that of its limb.
[[nodiscard]] std::string trailTitle(const Document& document, const rig::Trail& trail);

/// Returns a group's title: its own name, else its limbs: "left arm, right arm and spine".
[[nodiscard]] std::string groupTitle(const Document& document, const std::vector<int>& members);

/// The members of the selected trail's group while the limbs of all of them are selected; else none.
[[nodiscard]] std::vector<int> wholeGroupSelected(const Session& session);

/// "left arm, right arm and spine".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

/// World units that one arrow key nudges a sphere: a two-hundredth of the character's height.
[[nodiscard]] double nudgeUnits(const Document& document);

} // namespace stretch::app
