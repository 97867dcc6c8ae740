#pragma once

#include <string>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// Parameters of the spatio-temporal edge difference (Vasa and Skala 2011).
struct StedSettings {
  int rings = 1;  ///< Edges of the neighbourhood of a vertex: those of the triangles within so many rings
                  ///< around it.
  int window = 3; ///< Frame steps over which the temporal part takes its deviation, around each frame step;
                  ///< odd.
  double timeStep = 0.0; ///< dt: length that a step in time counts for, in mesh units; 0 takes the mean edge
                         ///< length / 10.
  double c = 1.0;        ///< Weight of the temporal part.
};

/// How far an animated mesh is from a reference with the same topology and number of frames.
struct SequenceMetrics {
  double mse = 0.0; ///< Mean over frames and vertices of the squared distance, squared units of the sequence.
  double rmsePercent = 0.0;    ///< Its root in percent of the diagonal of the reference (extentOf); 100 where
                               ///< that has no extent. 0 for equal ones alone.
  double largestPercent = 0.0; ///< The largest distance, in percent of the same diagonal.
  double kgError = 0.0;        ///< Karni and Gotsman: 100 ||A - B|| / ||A - mean(A)||, mean(A) = each frame's
                               ///< centroid.
  double sted = 0.0;           ///< sqrt(spatial^2 + c^2 temporal^2).
  double stedSpatial = 0.0;
  double stedTemporal = 0.0;
  StedSettings stedSettings; ///< Settings in use: the time step filled in.
};

/// The distances alone, without STED; both must have the same vertices and frames, at least one of each.
[[nodiscard]] SequenceMetrics distancesOf(const MeshSequence& reference, const MeshSequence& other);

/// Says which frame's diagonal errors are parts of; empty where it is the first.
[[nodiscard]] std::string frameOfErrors(const MeshSequence& reference);

/// An error when vertices, triangles or frames differ in number.
[[nodiscard]] Result<SequenceMetrics>
compareSequences(const MeshSequence& reference, const MeshSequence& other, const StedSettings& settings = {});

} // namespace stretch::skinning
