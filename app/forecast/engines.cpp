#include "app/forecast/engines.h"

namespace stretch::app {

namespace {

constexpr const char* shading = "shading";
constexpr const char* influences = "influences of a vertex";
constexpr const char* joints = "number of joints";
constexpr const char* culling = "culling";

} // namespace

const std::vector<Engine>& engines() {
  static const std::vector<Engine> all{
      {.id = "three",
       .name = "three.js",
       .turnsNormalsPlainly = true,
       .cullsByRestBox = true,
       .mostInfluences = 4,
       .knowsAllInterpolations = true,
       .cullingRemedy = "set frustumCulled = false on the mesh, or compute its bounds in each frame",
       .notJudged = {joints}},
      {.id = "godot",
       .name = "Godot 4",
       .turnsNormalsPlainly = true,
       .notJudged = {influences, joints, culling}},
      {.id = "babylon",
       .name = "Babylon.js",
       .turnsNormalsPlainly = true,
       .cullsByRestBox = true,
       .knowsAllInterpolations = true,
       .cullingRemedy =
           "set alwaysSelectAsActiveMesh = true on the mesh, or refresh its bounds with the skeleton",
       .notJudged = {influences, joints}},
      {.id = "unity-generic",
       .name = "Unity, generic rig",
       .cullsByRestBox = true,
       .cullingRemedy = "switch Update When Offscreen on, or enlarge the bounds of the renderer",
       .notJudged = {shading, influences, joints}},
      {.id = "unity-humanoid",
       .name = "Unity, humanoid rig",
       .dropsMappedChannels = true,
       .cullsByRestBox = true,
       .cullingRemedy = "switch Update When Offscreen on, or enlarge the bounds of the renderer",
       .notJudged = {shading, influences, joints}},
      {.id = "unreal",
       .name = "Unreal",
       .scale = JointScale::mayBeDropped,
       .holdsShear = false,
       .notJudged = {shading, influences, joints, culling}},
      {.id = "roblox",
       .name = "Roblox",
       .scale = JointScale::notSupported,
       .notJudged = {shading, influences, joints, culling}},
  };
  return all;
}

} // namespace stretch::app
