#pragma once

#include <vector>

#include "app/session.h"

namespace stretch::app {

// Control spheres of the selected trail, as commands and the mouse set them.

/// Frames of its control spheres, ascending; none without a selected trail.
[[nodiscard]] std::vector<double> sphereFrames(Session& session);

/// Adds one at a frame within the trail's range and selects it; one that is there is only selected.
Status addSphere(Session& session, double frame);

/// Takes the selected ones away; the first and the last of the trail are put back.
Status removeSelectedSpheres(Session& session);

/// A tangent handle of a control sphere. The path leaves the sphere along it, as along the handle of a Bezier
/// curve.
struct TangentHandle {
  double sphereFrame = 0.0;
  double frames = 0.0; ///< How far the handle reaches in time; below 0 it is the one before the sphere.
  Vec3 sphereWorld{0.0};
  Vec3 tipWorld{0.0};
  Vec3 towardsNeighbour{0.0}; ///< Unit length: where a handle without length points.
};

/// The handles of a sphere of the selected trail, before and after it, a third of the way to its neighbours;
/// a sphere at an end of the trail has one. None without an exaggerated path.
[[nodiscard]] std::vector<TangentHandle> tangentHandles(Session& session, double sphereFrame);

} // namespace stretch::app
