#pragma once

#include <string>

namespace stretch::test {

/// A BVH of a person of four joints 160 units high that turns its upper leg by 90 degrees about x from frame
/// 0 to 2: `said` and `held` frames at 50 a second. `unit` scales all lengths.
[[nodiscard]] std::string personBvh(int said = 3, int held = 3, double unit = 1.0);

/// What an FBX as text is varied by.
struct FbxText {
  double centimetresOfUnit = 2.54;
  bool isZUp = false;
  int version = 7400;
  int childInherits = 1; ///< InheritType of the lower bone.
  double upperScale = 1.0;
  double upperStretch = 1.0; ///< Factor along its y, on top of that.
  bool upperPivots = false;  ///< It turns and scales about (0, 1, 0), which keeps its scale apart from its
                             ///< turn.
  bool lowerPivots = true;
  int layers = 1;
  int keyFlags = 4; ///< KeyAttrFlags: 4 straight, 8 bent.
};

/// Two bones, "upper" 10 units above the ground with a pre-rotation of 90 degrees about z, and "lower" 5
/// units along its y, with a pivot at (0, 2, 0) if `lowerPivots`, about which it turns from 0 to 120 degrees
/// about x in one second, 24 frames; a triangle on "lower" with a coloured material and a morph target
/// "smile"; "upper" is in a skin with it.
[[nodiscard]] std::string twoBonesFbx(const FbxText& text = {});

/// A Collada scene in inches, Z up: a node "post" 10 inches high with a triangle, that rises by 10 inches in
/// one second.
[[nodiscard]] std::string postCollada();

} // namespace stretch::test
