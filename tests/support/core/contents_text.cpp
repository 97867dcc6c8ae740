#include "tests/support/core/contents_text.h"

#include <fmt/format.h>

#include "tests/support/refusal.h"

namespace stretch::test {
namespace {

/// Numbers added up, each by its place in the list, so that none can take another one's.
class Sum {
public:
  void add(double number) { sum_ += number * static_cast<double>(1 + count_++ % 11); }
  template <typename Vector>
  void addVector(const Vector& vector) {
    for (glm::length_t i = 0; i < vector.length(); ++i) {
      add(static_cast<double>(vector[i]));
    }
  }
  [[nodiscard]] std::string text() const { return fmt::format("{} : {:.3f}", count_, sum_); }

private:
  double sum_ = 0.0;
  std::size_t count_ = 0;
};

template <typename List>
std::string sumOf(const List& vectors) {
  Sum sum;
  for (const auto& vector : vectors) {
    sum.addVector(vector);
  }
  return sum.text();
}

std::string primitiveText(const Primitive& primitive) {
  Sum indices;
  for (const std::uint32_t index : primitive.indices) {
    indices.add(index);
  }
  Sum influences;
  for (const VertexInfluences& vertex : primitive.influences) {
    for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
      influences.add(vertex.joints[i] * static_cast<double>(vertex.weights[i]));
      influences.add(static_cast<double>(vertex.weights[i]));
    }
  }
  std::string text = fmt::format(
      "    places {} , normals {} , texture {} and {} , colours {} , indices {} , follow {} mended {} , "
      "material {}\n",
      sumOf(primitive.positions), sumOf(primitive.normals), sumOf(primitive.texCoords),
      sumOf(primitive.emissiveTexCoords), sumOf(primitive.colors), indices.text(), influences.text(),
      primitive.areInfluencesMended, primitive.material);
  for (const MorphTarget& target : primitive.morphTargets) {
    text +=
        fmt::format("      target places {} , normals {}\n", sumOf(target.positions), sumOf(target.normals));
  }
  return text;
}

std::string textureText(const TextureUse& use) {
  Sum transform;
  for (glm::length_t column = 0; column < 3; ++column) {
    transform.addVector(use.uvTransform[column]);
  }
  return fmt::format("picture {} , at {} , nearest {} , wraps {} {}", use.image, transform.text(),
                     use.nearestFilter, static_cast<int>(use.wrapU), static_cast<int>(use.wrapV));
}

std::string sceneText(const Scene& scene) {
  std::string text;
  for (const Node& node : scene.nodes) {
    Sum rest;
    rest.addVector(node.rest.translation);
    rest.addVector(
        Vec4(node.rest.rotation.x, node.rest.rotation.y, node.rest.rotation.z, node.rest.rotation.w));
    rest.addVector(node.rest.scale);
    text += fmt::format("  node {} under {} , rests {} , mesh {} , skin {} , matrix {}\n", node.name,
                        node.parent.value, rest.text(), node.mesh, node.skin, node.matrix.has_value());
  }
  text += "  roots";
  for (const NodeIndex root : scene.roots) {
    text += fmt::format(" {}", root.value);
  }
  text += "\n";
  for (const Skin& skin : scene.skins) {
    Sum bind;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      bind.add(skin.joints[i].value);
      for (glm::length_t column = 0; column < 4; ++column) {
        bind.addVector(skin.inverseBind[i][column]);
      }
    }
    text += fmt::format("  skin {} of {} joints {}\n", skin.name, skin.joints.size(), bind.text());
  }
  for (const Mesh& mesh : scene.meshes) {
    text += "  mesh " + mesh.name + " , weights";
    for (const float weight : mesh.morphWeights) {
      text += fmt::format(" {:.3f}", weight);
    }
    text += "\n";
    for (const Primitive& primitive : mesh.primitives) {
      text += primitiveText(primitive);
    }
  }
  for (const Material& material : scene.materials) {
    Sum colours;
    colours.addVector(material.baseColor);
    colours.addVector(material.emissive);
    text += fmt::format(
        "  material {} , colours {} , {} , emits {} , alpha {} {:.3f} , both sides {} , unlit {}\n",
        material.name, colours.text(), textureText(material.baseColorTexture),
        textureText(material.emissiveTexture), static_cast<int>(material.alphaMode), material.alphaCutoff,
        material.doubleSided, material.unlit);
  }
  for (const Image& image : scene.images) {
    Sum bytes;
    for (const std::uint8_t byte : image.rgba) {
      bytes.add(byte);
    }
    text += fmt::format("  picture {} by {} , {}\n", image.width, image.height, bytes.text());
  }
  for (const SceneCamera& camera : scene.cameras) {
    text += fmt::format("  camera {} on {} , kind {} , sees {:.4f} {:.4f} {:.4f}\n", camera.name,
                        camera.node.value, static_cast<int>(camera.kind), camera.fieldOfViewRadians,
                        camera.halfHeight, camera.aspect.value_or(-1.0));
  }
  return text;
}

} // namespace

std::string contentsText(const std::string& title, const Result<gltf::Loaded>& file) {
  if (!file) {
    return title + "\n  refused: " + refusal(file) + "\n";
  }
  std::string text = title + "\n";
  for (const std::string& warning : file->warnings) {
    text += "  warns: " + warning + "\n";
  }
  text += sceneText(*file->scene);
  for (const Clip& clip : file->clips) {
    text += fmt::format("  clip {} , {:.4f} to {:.4f} at {:.3f}\n", clip.name, clip.startSeconds,
                        clip.endSeconds, clip.framesPerSecond);
    for (const CopyOnWrite<Track>& track : clip.tracks) {
      Sum times;
      Sum values;
      for (const float time : track->times) {
        times.add(static_cast<double>(time));
      }
      for (const float value : track->values) {
        values.add(static_cast<double>(value));
      }
      text += fmt::format("    {} channel {} , kind {} , width {} , times {} , values {}\n",
                          track->node.value, static_cast<int>(track->channel),
                          static_cast<int>(track->interpolation), track->width, times.text(), values.text());
    }
  }
  return text;
}

} // namespace stretch::test
