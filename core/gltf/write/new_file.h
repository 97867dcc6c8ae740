#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/anim/clip.h"
#include "core/gltf/source/source.h"
#include "core/math/types.h"

namespace tinygltf {
class Model;
}

namespace stretch::gltf {

/// Use of a buffer view: glTF's numbers for what the graphics card takes it as.
enum class ViewTarget { none = 0, vertices = 34962, indices = 34963 };

/// Shape in which a list of numbers becomes the elements of an accessor.
struct AccessorForm {
  std::size_t width = 1; ///< Numbers of an element: 1 to 4, or 16 for a matrix.
  ViewTarget target = ViewTarget::none;
  bool normalised = false; ///< Integers that stand for -1..1, or 0..1 without a sign.
  bool bounds = false;     ///< Writes min and max.
  std::size_t stored = 0;  ///< Numbers from one element to the next, where that is more than `width`.
};

/// Triangles of a mesh; numbers are indices that `NewFile` gave.
struct NewPrimitive {
  std::map<std::string, std::size_t> attributes; ///< "POSITION" and so on: their accessors.
  std::size_t indices = 0;
  std::optional<std::size_t> material;
};

/// Material by glTF's metallic-roughness model, colours linear; textures are indices that `NewFile` gave.
struct NewMaterial {
  std::string name;
  Vec4 baseColor{1.0};
  std::optional<std::size_t> baseColorTexture = {};
  double metallic = 0.0;
  double roughness = 1.0;
  std::optional<std::size_t> normalTexture = {};
  Vec3 emissive{0.0};
  std::optional<std::size_t> emissiveTexture = {};
  bool isBlended = false; ///< Seen through by the fourth number of its colour.
  bool isDoubleSided = false;
};

struct NewFileLabels {
  std::string generator = "Stretch-Engine";
  std::string copyright = {};
  std::string scene = {};
};

/// A glTF file that is made from nothing: parts are added, each answers the index by which others name it.
/// Indices count up from 0 in the order of the calls, and the data lies in the file in that order. Names that
/// are no valid UTF-8 are made so. Files that are opened and saved again are not made here but patched
/// (core/gltf/patch).
class NewFile {
public:
  explicit NewFile(const NewFileLabels& labels = {});
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  NewFile(NewFile&&) = delete;
  NewFile& operator=(NewFile&&) = delete;

  /// Accessor over a view of its own. `Number`: float, or an integer of 8 or 16 bits, or std::uint32_t.
  template <typename Number>
  std::size_t addAccessor(const std::vector<Number>& values, const AccessorForm& form);
  /// View of bytes that no accessor describes, as an image's.
  std::size_t addView(std::span<const std::uint8_t> bytes);

  /// Image as it is encoded (PNG, JPEG, WebP), and a texture that shows it, repeated; answers the texture.
  std::size_t addTexture(std::span<const std::uint8_t> image, const std::string& name);
  std::size_t addMaterial(const NewMaterial& material);
  /// Takes over the materials of another file with all that they name (see materialsOf); this file has none
  /// yet, and gets no other.
  void takeMaterials(const Source& materials);

  std::size_t addMesh(const std::string& name);
  void addPrimitive(std::size_t mesh, const NewPrimitive& primitive);

  /// Node below another, or one of the scene's roots.
  std::size_t addNode(const std::string& name, std::optional<std::size_t> parent = {});
  /// Translation, rotation (x, y, z, w) or scale of a node.
  void setNode(std::size_t node, Channel channel, std::vector<double> values);
  void setMesh(std::size_t node, std::size_t mesh, std::optional<std::size_t> skin);
  std::size_t addSkin(const std::string& name, std::size_t inverseBind, std::size_t skeleton,
                      const std::vector<std::size_t>& joints);

  /// Clip; one that stays without channels is left out of the file, since glTF wants at least one.
  std::size_t addClip(const std::string& name);
  /// Says the rate of a clip where its keys tell another one, or none.
  void setRate(std::size_t clip, double framesPerSecond);
  std::size_t addSampler(std::size_t clip, std::size_t times, std::size_t values,
                         Interpolation interpolation = Interpolation::linear);
  void addChannel(std::size_t clip, std::size_t sampler, std::size_t node, Channel channel);

  void requireExtension(const std::string& name);

  /// The file, its data in one buffer; this one is empty afterwards.
  [[nodiscard]] Source finish();

private:
  std::size_t addView(const void* data, std::size_t size, ViewTarget target, std::size_t stride);

  std::unique_ptr<tinygltf::Model> model_;
  Bytes bytes_;
  JsonDocument taken_; ///< Lists of other files' materials, as they stand there.
};

} // namespace stretch::gltf
