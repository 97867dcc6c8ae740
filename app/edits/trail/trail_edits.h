#pragma once

#include <string>

#include "app/document.h"

namespace stretch::app {

// Edits of trails: pure functions from a document to a changed one. None of them evaluates motion; all of
// them refuse what would make the document contradict itself, with one line that says why.

/// Limb, range and settings of a new trail. The range must have a length and may share no time with another
/// trail of the same limb and clip; ranges that only touch at an end are fine.
struct NewTrail {
  std::string limb; ///< Limb id; must exist in the document.
  int clip = 0;     ///< Must exist in the document.
  rig::TrailSettings settings;
  bool exaggerated = false;
  bool connected = false;
};

/// A document with a trail that was not there before.
struct CreatedTrail {
  Document document;
  int trailId = 0;
};

inline constexpr int dealtColours = 5;

/// The colour of the palette that the clip's trails use least, the next in turn of those that are equal.
[[nodiscard]] int freeColour(const Document& document, int clip);

/// Colours are dealt in turn, so that trails beside each other stay apart.
[[nodiscard]] Result<CreatedTrail> createTrail(const Document& document, const NewTrail& wanted);

/// Replaces everything that shapes the trail. Where the trail of a leg stops at the ground under its tip and
/// the tip moves, it stops at the ground there, unless another stop is given. Refused: a range without length
/// or one that overlaps, numbers that are not finite.
[[nodiscard]] Result<Document> setTrailSettings(const Document& document, int trailId,
                                                const rig::TrailSettings& settings);

/// Whether the character follows the exaggerated copy; connecting makes the copy where there is none.
[[nodiscard]] Result<Document> setConnected(const Document& document, int trailId, bool connected);

/// Whether the character follows while spheres are dragged.
[[nodiscard]] Result<Document> setFollow(const Document& document, int trailId, bool follow);

/// 0 original, 1 half-way, 2 exaggerated; values outside are clamped.
[[nodiscard]] Result<Document> setBlend(const Document& document, int trailId, double blend);

/// How a trail is shown.
struct TrailDisplay {
  int colour = 0; ///< Index into the palette of trails, >= 0.
  bool visible = true;
  bool pinned = false;
};
[[nodiscard]] Result<Document> setTrailDisplay(const Document& document, int trailId,
                                               const TrailDisplay& display);

/// The artist is done with the trail as it stands: the character follows it, and it goes quiet until it is
/// changed. Saving keys every connected trail, applied or not.
[[nodiscard]] Result<Document> applyTrail(const Document& document, int trailId);

/// Gives the range back as the source has it.
[[nodiscard]] Result<Document> deleteTrail(const Document& document, int trailId);
[[nodiscard]] Document deleteTrailsOfLimb(const Document& document, const std::string& limbId, int clip);

/// Pastes a trail on a limb, at the same time in seconds: onto the trail that already shares its time (which
/// keeps its range; spheres move along with the range's start), else as a new trail.
[[nodiscard]] Result<CreatedTrail> pasteTrail(const Document& document, const rig::Trail& from,
                                              const std::string& limbId, int clip);

/// Marks a clip as a loop, or not: releases wrap.
[[nodiscard]] Document setLooping(const Document& document, int clip, bool loops);

/// The error of every edit that names a trail which is not there.
[[nodiscard]] Error missingTrail(int trailId);

} // namespace stretch::app
