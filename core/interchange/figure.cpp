#include "core/interchange/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <set>

#include <assimp/scene.h>
#include <fmt/core.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/interchange/assimp_values.h"
#include "core/math/finite.h"

namespace stretch::interchange {

namespace {

constexpr int inheritsNoParentScale = 2; // InheritType of the FBX SDK: RrSs 0, RSrs 1, Rrs 2

int metaNumber(const aiMetadata* data, const char* key, int otherwise) {
  int value = otherwise;
  return data != nullptr && data->Get(key, value) ? value : otherwise;
}

// Metres, by what FBX says of its unit: centimetres in one unit.
double metresOfFbx(const aiScene& scene) {
  double centimetres = 1.0;
  float shorter = 1.0F;
  if (scene.mMetaData == nullptr) {
    return 0.01;
  }
  if (!scene.mMetaData->Get("UnitScaleFactor", centimetres) &&
      scene.mMetaData->Get("UnitScaleFactor", shorter)) {
    centimetres = shorter;
  }
  return std::isfinite(centimetres) && centimetres > 0.0 ? 0.01 * centimetres : 0.01;
}

// The axes that FBX calls up, front and right, as the rows that bring them to Y, Z and X.
Mat4 axesOfFbx(const aiScene& scene) {
  const aiMetadata* const data = scene.mMetaData;
  const std::array<int, 3> axis{metaNumber(data, "CoordAxis", 0), metaNumber(data, "UpAxis", 1),
                                metaNumber(data, "FrontAxis", 2)};
  const std::array<int, 3> sign{metaNumber(data, "CoordAxisSign", 1), metaNumber(data, "UpAxisSign", 1),
                                metaNumber(data, "FrontAxisSign", 1)};
  Mat4 turn(0.0);
  turn[3][3] = 1.0;
  for (int row = 0; row < 3; ++row) {
    const int column = axis[static_cast<std::size_t>(row)];
    if (column < 0 || column > 2) {
      return Mat4(1.0);
    }
    turn[column][row] = sign[static_cast<std::size_t>(row)] < 0 ? -1.0 : 1.0;
  }
  // Left-handed axes, or one that is named twice, are no turn.
  return glm::determinant(turn) > 0.5 ? turn : Mat4(1.0);
}

// Extent of the nodes at rest in each direction.
Vec3 extentOf(const std::vector<Mat4>& worlds) {
  Vec3 least(0.0);
  Vec3 greatest(0.0);
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    const Vec3 place = positionOf(worlds[i]);
    least = i == 0 ? place : glm::min(least, place);
    greatest = i == 0 ? place : glm::max(greatest, place);
  }
  return greatest - least;
}

double largestOf(const Vec3& v) {
  return std::max({v.x, v.y, v.z});
}

Vec3 extentOfMeshes(const aiScene& scene) {
  Vec3 extent(0.0);
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned v = 1; v < mesh.mNumVertices; ++v) {
      extent = glm::max(extent, glm::abs(vectorOf(mesh.mVertices[v]) - vectorOf(mesh.mVertices[0])));
    }
  }
  return extent;
}

// BVH names no unit. People are between a half and three metres high.
double metresOfBvh(double height, std::string& note) {
  constexpr double person = 1.7;
  const bool isMetres = height > 0.5 && height < 3.0;
  const bool isCentimetres = height >= 50.0 && height < 300.0;
  const double metres = isMetres ? 1.0 : isCentimetres ? 0.01 : height > 0.0 ? person / height : 1.0;
  note =
      fmt::format("names no unit: the figure, {:.4g} high, is taken to be {:.2f} m", height, metres * height);
  return metres;
}

class FigureMaker {
public:
  FigureMaker(const aiScene& scene, Format format) : scene_(scene) {
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
      for (unsigned b = 0; b < scene.mMeshes[m]->mNumBones; ++b) {
        bones_.insert(scene.mMeshes[m]->mBones[b]->mName.C_Str());
      }
    }
    for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
      for (unsigned c = 0; c < scene.mAnimations[a]->mNumChannels; ++c) {
        animated_.insert(scene.mAnimations[a]->mChannels[c]->mNodeName.C_Str());
      }
    }
    const aiNode& root = *scene.mRootNode;
    const std::string name = root.mName.C_Str();
    leavesRoot_ = format != Format::bvh && root.mNumChildren > 0 && root.mNumMeshes == 0 &&
                  !bones_.contains(name) && !animated_.contains(name);
  }

  Figure make() {
    if (leavesRoot_) {
      for (unsigned i = 0; i < scene_.mRootNode->mNumChildren; ++i) {
        visit(*scene_.mRootNode->mChildren[i], -1, {});
      }
    } else {
      visit(*scene_.mRootNode, -1, {});
    }
    return std::move(figure_);
  }

  [[nodiscard]] Mat4 root() const { return leavesRoot_ ? restOf(*scene_.mRootNode) : Mat4(1.0); }

private:
  // A pivot moves its children and nothing else: it goes into each of them.
  void visit(const aiNode& node, int parent, std::vector<const aiNode*> chain) {
    chain.push_back(&node);
    if (isPivot(node) && node.mNumMeshes == 0 && !bones_.contains(node.mName.C_Str())) {
      for (unsigned i = 0; i < node.mNumChildren; ++i) {
        visit(*node.mChildren[i], parent, chain);
      }
      return;
    }
    const int index = static_cast<int>(figure_.nodes.size());
    FigureNode made;
    made.name = node.mName.C_Str();
    made.parent = parent;
    made.chain = std::move(chain);
    made.shedsScale = parent >= 0 && metaNumber(node.mMetaData, "InheritType", 1) == inheritsNoParentScale;
    figure_.byName.try_emplace(made.name, index);
    figure_.nodes.push_back(std::move(made));
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      visit(*node.mChildren[i], index, {});
    }
  }

  const aiScene& scene_;
  std::set<std::string> bones_;
  std::set<std::string> animated_;
  bool leavesRoot_ = false;
  Figure figure_;
};

// The scale of the file stands on a topmost node that undoes it (Blender's armatures are 100 times as large),
// else in every length below.
void placeTop(const Mat4& whole, Figure& figure) {
  const Transform parts = toTransform(whole);
  const double scale = parts.scale.y;
  for (FigureNode& node : figure.nodes) {
    if (node.parent >= 0) {
      node.lengths = figure.nodes[static_cast<std::size_t>(node.parent)].lengths;
      continue;
    }
    constexpr double near = 0.01;
    const Vec3 own = toTransform(localOf(figure, node, restOf)).scale * scale;
    const bool undoes = std::abs(scale - 1.0) > near && largestOf(glm::abs(own - Vec3(1.0))) < near;
    node.lengths = undoes ? 1.0 : scale;
    node.before = undoes ? whole : toMatrix({parts.translation, parts.rotation, Vec3(1.0)});
  }
}

} // namespace

bool isPivot(const aiNode& node) {
  return std::strstr(node.mName.C_Str(), "_$AssimpFbx$_") != nullptr;
}

Mat4 restOf(const aiNode& node) {
  const Mat4 matrix = matrixOf(node.mTransformation);
  return isFinite(matrix) ? matrix : Mat4(1.0);
}

namespace {

Mat4 chainMatrix(const FigureNode& node, const ElementMatrix& matrixOf) {
  Mat4 product(1.0);
  for (const aiNode* const element : node.chain) {
    product = product * matrixOf(*element);
  }
  return product;
}

} // namespace

Mat4 localOf(const Figure& figure, const FigureNode& node, const ElementMatrix& matrixOf) {
  Mat4 local = chainMatrix(node, matrixOf);
  if (node.shedsScale) {
    const Vec3 parent =
        toTransform(chainMatrix(figure.nodes[static_cast<std::size_t>(node.parent)], matrixOf)).scale;
    // What the parent scales is taken back in the parent's axes.
    for (int axis = 0; axis < 3; ++axis) {
      for (int row = 0; row < 3; ++row) {
        local[axis][row] /= std::abs(parent[row]) > 1e-9 ? parent[row] : 1.0;
      }
    }
  }
  local[3] = Vec4(node.lengths * Vec3(local[3]), 1.0);
  return node.before * local;
}

std::vector<Mat4> restWorlds(const Figure& figure) {
  std::vector<Mat4> worlds;
  worlds.reserve(figure.nodes.size());
  for (const FigureNode& node : figure.nodes) {
    const Mat4 local = localOf(figure, node, restOf);
    worlds.push_back(node.parent < 0 ? local : worlds[static_cast<std::size_t>(node.parent)] * local);
  }
  return worlds;
}

namespace {

// A BVH rests about the place of its root, mostly 0, and its motion carries that over a floor at 0: at rest
// it stands on the same floor.
void standOnFloor(const aiScene& scene, Figure& figure) {
  const std::vector<Mat4> worlds = restWorlds(figure);
  double lowest = 0.0;
  for (const Mat4& world : worlds) {
    lowest = std::min(lowest, positionOf(world).y);
  }
  FigureNode& root = figure.nodes.front();
  for (unsigned c = 0; scene.mNumAnimations > 0 && c < scene.mAnimations[0]->mNumChannels; ++c) {
    const aiNodeAnim& channel = *scene.mAnimations[0]->mChannels[c];
    if (root.name == channel.mNodeName.C_Str() && channel.mNumPositionKeys > 0) {
      const double carried =
          root.lengths * vectorOf(channel.mPositionKeys[0].mValue).y - positionOf(worlds[0]).y;
      root.restLift = carried > -0.5 * lowest ? -lowest : 0.0;
    }
  }
}

} // namespace

Figure figureOf(const aiScene& scene, Format format) {
  FigureMaker maker(scene, format);
  Figure figure = maker.make();
  Mat4 whole = maker.root();
  if (format == Format::fbx) {
    figure.worldOfUnit = metresOfFbx(scene);
    whole = glm::scale(axesOfFbx(scene), Vec3(figure.worldOfUnit)) * whole;
  } else if (format == Format::bvh) {
    const Vec3 extent = extentOf(restWorlds(figure));
    figure.worldOfUnit = metresOfBvh(extent.y > 0.0 ? extent.y : largestOf(extent), figure.unitNote);
    whole = glm::scale(whole, Vec3(figure.worldOfUnit));
  }
  placeTop(whole, figure);
  if (format == Format::bvh) {
    standOnFloor(scene, figure);
  }
  const double ofNodes = largestOf(extentOf(restWorlds(figure)));
  const double ofMeshes = largestOf(extentOfMeshes(scene)) * toTransform(whole).scale.y;
  figure.height = ofNodes > 0.0 ? ofNodes : ofMeshes > 0.0 ? ofMeshes : 1.0;
  return figure;
}

} // namespace stretch::interchange
