#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/interchange/file_kind.h"
#include "core/math/transform.h"

struct aiMesh;
struct aiNode;
struct aiScene;

namespace stretch::interchange {

/// One node of the glTF: what the library splits into a chain of nodes, one for each pivot, put together
/// again.
struct FigureNode {
  std::string name;
  int parent = -1;
  std::vector<const aiNode*> chain; ///< Outermost first; the last one bears the name. At least one.
  Mat4 before{1.0};                 ///< Units, axes and root of the file, on the topmost nodes.
  double lengths = 1.0;    ///< Factor of its translation and of its vertices, where `before` does not scale.
  double restLift = 0.0;   ///< Metres by which it rests higher than the file says: see standOnFloor.
  bool shedsScale = false; ///< The parent's own scale does not reach it (FBX, InheritType Rrs).
};

struct Figure {
  std::vector<FigureNode> nodes; ///< Parents before children.
  std::map<std::string, int> byName;
  double height = 1.0;      ///< Largest extent of the nodes at rest, else of the meshes; metres, above 0.
  double worldOfUnit = 1.0; ///< Metres of one unit of the file.
  std::string unitNote;     ///< How a unit that the file does not name was guessed; empty without one.
};

/// The nodes of the scene in metres and Y up, pivots collapsed. A root that only carries units and axes is
/// left out.
[[nodiscard]] Figure figureOf(const aiScene& scene, Format format);

/// Matrix of a node of the library at some time; at rest its own.
using ElementMatrix = std::function<Mat4(const aiNode&)>;
[[nodiscard]] Mat4 restOf(const aiNode& node);

/// Local matrix of a node of the figure: its chain put together, in the figure's units.
[[nodiscard]] Mat4 localOf(const Figure& figure, const FigureNode& node, const ElementMatrix& matrixOf);

/// World matrices at rest.
[[nodiscard]] std::vector<Mat4> restWorlds(const Figure& figure);

/// Whether the library made this node up, to hold one pivot.
[[nodiscard]] bool isPivot(const aiNode& node);

} // namespace stretch::interchange
