#pragma once

#include <glm/mat3x2.hpp>

namespace stretch {

/// Behaviour of a texture beyond its edges.
enum class TextureWrap { repeat, mirror, clamp };

/// An image as a material uses it.
struct TextureUse {
  int image = -1; ///< Index into Scene::images; -1: none that can be shown.
  glm::mat3x2 uvTransform{1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F}; ///< Times (u, v, 1): where the image is read
                                                               ///< (KHR_texture_transform).
  bool nearestFilter = false;
  TextureWrap wrapU = TextureWrap::repeat;
  TextureWrap wrapV = TextureWrap::repeat;
};

} // namespace stretch
