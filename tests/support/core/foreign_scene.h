#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <assimp/scene.h>

#include "core/interchange/figure.h"
#include "core/interchange/figure_clips.h"
#include "core/interchange/figure_meshes.h"
#include "tests/support/core/glb_builder.h"

namespace stretch::test {

/// A scene as the library reads one from a foreign file, made piece by piece. It owns what is added.
class ForeignScene {
public:
  /// A scene with nothing but its topmost node.
  explicit ForeignScene(const std::string& root = "RootNode", const Mat4& matrix = Mat4(1.0));

  aiNode& addNode(aiNode& parent, const std::string& name, const Vec3& place = Vec3(0.0));
  aiNode& addNode(aiNode& parent, const std::string& name, const Mat4& matrix);
  /// A mesh of one triangle with corners at these places; nobody shows it yet.
  aiMesh& addTriangle(const std::string& name, const std::vector<Vec3>& places);
  /// A node shows a mesh that was added.
  void show(aiNode& node, unsigned mesh);
  aiBone& addBone(aiMesh& mesh, const std::string& name, const std::vector<aiVertexWeight>& weights,
                  const Mat4& offset = Mat4(1.0));
  aiAnimMesh& addTarget(aiMesh& mesh, const std::string& name, const std::vector<Vec3>& places);
  aiMaterial& addMaterial(const std::string& name);
  aiAnimation& addClip(const std::string& name, double ticksPerSecond);
  aiNodeAnim& addChannel(aiAnimation& clip, const std::string& node);
  /// A picture inside the file, packed as these bytes.
  aiTexture& addPicture(const std::string& name, const gltf::Bytes& packed);
  /// Says whole numbers of the file, such as its axes.
  void say(const std::vector<std::pair<std::string, int>>& numbers);
  void sayUnit(double centimetres);

  [[nodiscard]] aiNode& root() { return *scene_->mRootNode; }
  [[nodiscard]] aiScene& scene() { return *scene_; }
  [[nodiscard]] const aiScene& scene() const { return *scene_; }

private:
  std::unique_ptr<aiScene> scene_;
};

void setPlaces(aiNodeAnim& channel, const std::vector<std::pair<double, Vec3>>& keys);
void setTurns(aiNodeAnim& channel, const std::vector<std::pair<double, Quat>>& keys);
void setScales(aiNodeAnim& channel, const std::vector<std::pair<double, Vec3>>& keys);

/// What becomes of such a scene.
struct MadeOfForeign {
  gltf::Json json;
  gltf::Loaded file;
  interchange::MeshNotes meshes;
  interchange::ClipNotes clips;
  std::vector<std::string> warnings; ///< Of its materials.
};

/// Makes a glTF of it and opens that, with the weaknesses that foreign files have. `file`: where it came
/// from.
[[nodiscard]] MadeOfForeign madeOfForeign(const ForeignScene& from,
                                          interchange::Format format = interchange::Format::collada,
                                          const std::filesystem::path& file = "none.dae");

} // namespace stretch::test
