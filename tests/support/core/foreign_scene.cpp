#include "tests/support/core/foreign_scene.h"

#include <catch2/catch.hpp>

#include "core/gltf/source/glb.h"

namespace stretch::test {

using gltf::Json;

namespace {

aiMatrix4x4 rowsOf(const Mat4& m) {
  const auto at = [&](int column, int row) { return static_cast<float>(m[column][row]); };
  return {at(0, 0), at(1, 0), at(2, 0), at(3, 0), at(0, 1), at(1, 1), at(2, 1), at(3, 1),
          at(0, 2), at(1, 2), at(2, 2), at(3, 2), at(0, 3), at(1, 3), at(2, 3), at(3, 3)};
}

aiVector3D vectorFrom(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The library's lists are arrays that their owner deletes.
template <typename Thing>
Thing& append(std::unique_ptr<Thing> one, Thing**& list, unsigned& count) {
  auto longer = std::make_unique<Thing*[]>(count + 1);
  std::copy(list, list + count, longer.get());
  const std::unique_ptr<Thing*[]> before(list);
  list = longer.release();
  list[count] = one.release();
  return *list[count++];
}

aiVector3D* placesOf(const std::vector<Vec3>& places) {
  auto all = std::make_unique<aiVector3D[]>(places.size());
  std::ranges::transform(places, all.get(), vectorFrom);
  return all.release();
}

template <typename Key, typename Value, typename Convert>
Key* keysFrom(const std::vector<std::pair<double, Value>>& keys, const Convert& convert) {
  auto all = std::make_unique<Key[]>(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    all[i] = Key(keys[i].first, convert(keys[i].second));
  }
  return all.release();
}

} // namespace

ForeignScene::ForeignScene(const std::string& root, const Mat4& matrix)
    : scene_(std::make_unique<aiScene>()) {
  scene_->mRootNode = std::make_unique<aiNode>(root).release();
  scene_->mRootNode->mTransformation = rowsOf(matrix);
}

aiNode& ForeignScene::addNode(aiNode& parent, const std::string& name, const Vec3& place) {
  return addNode(parent, name, toMatrix({place, Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0)}));
}

aiNode& ForeignScene::addNode(aiNode& parent, const std::string& name, const Mat4& matrix) {
  aiNode* node = std::make_unique<aiNode>(name).release();
  node->mTransformation = rowsOf(matrix);
  parent.addChildren(1, &node);
  return *node;
}

aiMesh& ForeignScene::addTriangle(const std::string& name, const std::vector<Vec3>& places) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName = name;
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = static_cast<unsigned>(places.size());
  mesh->mVertices = placesOf(places);
  mesh->mNumFaces = 1;
  mesh->mFaces = std::make_unique<aiFace[]>(1).release();
  mesh->mFaces[0].mNumIndices = 3;
  mesh->mFaces[0].mIndices = std::unique_ptr<unsigned[]>(new unsigned[3]{0, 1, 2}).release();
  return append(std::move(mesh), scene_->mMeshes, scene_->mNumMeshes);
}

void ForeignScene::show(aiNode& node, unsigned mesh) {
  auto longer = std::make_unique<unsigned[]>(node.mNumMeshes + 1);
  std::copy(node.mMeshes, node.mMeshes + node.mNumMeshes, longer.get());
  longer[node.mNumMeshes++] = mesh;
  const std::unique_ptr<unsigned[]> before(node.mMeshes);
  node.mMeshes = longer.release();
}

aiBone& ForeignScene::addBone(aiMesh& mesh, const std::string& name,
                              const std::vector<aiVertexWeight>& weights, const Mat4& offset) {
  auto bone = std::make_unique<aiBone>();
  bone->mName = name;
  bone->mOffsetMatrix = rowsOf(offset);
  bone->mNumWeights = static_cast<unsigned>(weights.size());
  auto all = std::make_unique<aiVertexWeight[]>(weights.size());
  std::ranges::copy(weights, all.get());
  bone->mWeights = all.release();
  return append(std::move(bone), mesh.mBones, mesh.mNumBones);
}

aiAnimMesh& ForeignScene::addTarget(aiMesh& mesh, const std::string& name, const std::vector<Vec3>& places) {
  auto target = std::make_unique<aiAnimMesh>();
  target->mName = name;
  target->mNumVertices = static_cast<unsigned>(places.size());
  target->mVertices = placesOf(places);
  return append(std::move(target), mesh.mAnimMeshes, mesh.mNumAnimMeshes);
}

aiMaterial& ForeignScene::addMaterial(const std::string& name) {
  auto material = std::make_unique<aiMaterial>();
  const aiString called(name);
  material->AddProperty(&called, AI_MATKEY_NAME);
  return append(std::move(material), scene_->mMaterials, scene_->mNumMaterials);
}

aiAnimation& ForeignScene::addClip(const std::string& name, double ticksPerSecond) {
  auto clip = std::make_unique<aiAnimation>();
  clip->mName = name;
  clip->mTicksPerSecond = ticksPerSecond;
  return append(std::move(clip), scene_->mAnimations, scene_->mNumAnimations);
}

aiNodeAnim& ForeignScene::addChannel(aiAnimation& clip, const std::string& node) {
  auto channel = std::make_unique<aiNodeAnim>();
  channel->mNodeName = node;
  return append(std::move(channel), clip.mChannels, clip.mNumChannels);
}

aiTexture& ForeignScene::addPicture(const std::string& name, const gltf::Bytes& packed) {
  auto picture = std::make_unique<aiTexture>();
  picture->mFilename = name;
  picture->mWidth = static_cast<unsigned>(packed.size());
  auto texels = std::make_unique<aiTexel[]>(packed.size() / sizeof(aiTexel) + 1);
  std::memcpy(texels.get(), packed.data(), packed.size());
  picture->pcData = texels.release();
  return append(std::move(picture), scene_->mTextures, scene_->mNumTextures);
}

void ForeignScene::say(const std::vector<std::pair<std::string, int>>& numbers) {
  scene_->mMetaData = aiMetadata::Alloc(static_cast<unsigned>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    scene_->mMetaData->Set(static_cast<unsigned>(i), numbers[i].first, numbers[i].second);
  }
}

void ForeignScene::sayUnit(double centimetres) {
  scene_->mMetaData = aiMetadata::Alloc(1);
  scene_->mMetaData->Set(0, "UnitScaleFactor", centimetres);
}

void setPlaces(aiNodeAnim& channel, const std::vector<std::pair<double, Vec3>>& keys) {
  channel.mNumPositionKeys = static_cast<unsigned>(keys.size());
  channel.mPositionKeys = keysFrom<aiVectorKey>(keys, vectorFrom);
}

void setTurns(aiNodeAnim& channel, const std::vector<std::pair<double, Quat>>& keys) {
  channel.mNumRotationKeys = static_cast<unsigned>(keys.size());
  channel.mRotationKeys = keysFrom<aiQuatKey>(keys, [](const Quat& q) {
    return aiQuaternion(static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y),
                        static_cast<float>(q.z));
  });
}

void setScales(aiNodeAnim& channel, const std::vector<std::pair<double, Vec3>>& keys) {
  channel.mNumScalingKeys = static_cast<unsigned>(keys.size());
  channel.mScalingKeys = keysFrom<aiVectorKey>(keys, vectorFrom);
}

MadeOfForeign madeOfForeign(const ForeignScene& from, interchange::Format format,
                            const std::filesystem::path& file) {
  MadeOfForeign made;
  const aiScene& scene = from.scene();
  const interchange::Figure figure = interchange::figureOf(scene, format);
  interchange::GlbParts parts;
  std::vector<gltf::JsonDocument> nodes;
  Json roots = Json::array();
  for (std::size_t i = 0; i < figure.nodes.size(); ++i) {
    const interchange::FigureNode& node = figure.nodes[i];
    const Transform rest = toTransform(interchange::localOf(figure, node, interchange::restOf));
    nodes.emplace_back(
        Json{{"name", node.name},
             {"translation", {rest.translation.x, rest.translation.y, rest.translation.z}},
             {"rotation", {rest.rotation.x, rest.rotation.y, rest.rotation.z, rest.rotation.w}},
             {"scale", {rest.scale.x, rest.scale.y, rest.scale.z}}});
    if (node.parent < 0) {
      roots.push_back(i);
    } else {
      (*nodes[static_cast<std::size_t>(node.parent)])["children"].push_back(i);
    }
  }
  const std::vector<int> materials = interchange::addMaterials(scene, file, parts, made.warnings);
  made.meshes = interchange::addMeshes(scene, figure, materials, nodes, parts);
  made.clips = interchange::addClips(scene, figure, made.meshes.nodeOfMesh, "figure", parts);
  for (const gltf::JsonDocument& node : nodes) {
    parts.add("nodes", *node);
  }
  parts.add("scenes", {{"nodes", roots}});
  const Result<gltf::Bytes> bytes = parts.finish();
  REQUIRE(bytes);
  Result<gltf::Loaded> loaded = loadBytes(*bytes, gltf::Tolerance::warn);
  if (!loaded) {
    FAIL(loaded.error().line());
  }
  made.file = std::move(loaded).value();
  made.json = *made.file.source->json;
  return made;
}

} // namespace stretch::test
