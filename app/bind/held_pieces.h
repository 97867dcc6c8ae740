#pragma once

#include <string>
#include <vector>

#include "app/bind/body_to_bind.h"
#include "skinning/skinned_sequence.h"

namespace stretch::app {

/// Things that a hand of the body holds: meshes, and pieces of meshes that nothing joins to the rest, that
/// follow one hand alone, most of them by its fingers, and are more than twice as long as the hand reaches
/// from its joint to those of the fingers. Each follows the hand from then on, as one piece, since fingers
/// that curl would swing it; where the arm ends in a forearm that carries fingers, the forearm. `rows`: one
/// for each vertex of the body, by joints of the skeleton. Returns a line for each that was changed; none
/// where the body has no hand with two joints of fingers or more.
[[nodiscard]] std::vector<std::string> holdPieces(const Document& document, const SkeletonToBind& skeleton,
                                                  const BodyToBind& body,
                                                  std::vector<skinning::Influences>& rows);

/// Things of the file's own skin: pieces of meshes that nothing joins to the rest, each of which follows one
/// joint alone at the end of a row that no limb goes through, such as an eye, a shield or a hat. Each goes on
/// following it, since no shape tells what moves it. Returns one line where some would have followed others;
/// none of a file without limbs.
[[nodiscard]] std::vector<std::string> keepThings(const Document& document, const SkeletonToBind& skeleton,
                                                  const BodyToBind& body,
                                                  std::vector<skinning::Influences>& rows);

} // namespace stretch::app
