#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "rig/limb.h"
#include "tests/support/rig/synthetic_biped.h"
#include "tests/support/row.h"

namespace stretch::test {

/// Endings of the keys of joints on either side.
inline const std::vector<std::string> bothSides{".l", ".r"};

/// A limb that a reading should have: keys of joints, alternatives apart by "|".
struct WantedLimb {
  std::string first;   ///< Its first joint.
  std::string through; ///< A joint that it has in any case; empty: none is asked for.
  std::string end;     ///< Its end joint; "estimated" where the rig has none.
};

/// A made-up character of one family of rigs, with what a person sees in it.
struct FamilyRig {
  std::string family;
  std::string title; ///< Everything that was drawn for it.
  std::string plan;  ///< Alternatives apart by "|".
  SyntheticBiped body;
  std::map<std::string, WantedLimb> wanted; ///< By the limb's id.
  std::vector<std::string> absent;          ///< Ids of limbs that the character lacks.
};

/// Names of joints that are drawn for a rig.
struct DrawnNames {
  std::string title;
  bool tell = true; ///< False: no word of any language in them.
};

/// Gives the joints names of a scheme that is drawn: one of any program and language, none, numbers, UUIDs.
DrawnNames drawNames(SyntheticBiped& body, Row& row);

/// Names of joints that no scheme has, for a body whose names tell: "skirt.l" becomes "skirt_l" or "Skirt.L".
void nameOthers(SyntheticBiped& body, const DrawnNames& names, Row& row);

/// Turns what hangs from a joint about it, the joint's own bone included.
void turnBelow(SyntheticBiped& body, const std::string& key, const Quat& turn);

/// Turns every joint but the root about an axis of its own by up to `degrees`, as in a moment of an action.
void moveEachJoint(SyntheticBiped& body, double degrees, Row& row);

/// Scales the length of one joint's bone to its parent by moving all that hangs from it.
void moveBelow(SyntheticBiped& body, const std::string& key, const Vec3& offset);

/// Lifts or lowers the body until its lowest joint stands at `height`.
void standOn(SyntheticBiped& body, double height);

/// Rigs of every family of bipeds and of other bodies, `each` of every family, all drawn from a fixed row.
[[nodiscard]] std::vector<FamilyRig> bipedFamilies(int each);
[[nodiscard]] std::vector<FamilyRig> beastFamilies(int each);

/// Bipeds whose bind pose is a moment of an action: trunk bent and turned, each limb anywhere.
[[nodiscard]] std::vector<FamilyRig> bipedsInAction(int each);

/// Beasts that are rarer, or named as programs name them.
[[nodiscard]] std::vector<FamilyRig> rareBeasts(int each);

/// Rigs as programs and games export them, `each` of every one, in drawn poses and proportions.
[[nodiscard]] std::vector<FamilyRig> wholeBipeds(int each);

} // namespace stretch::test
