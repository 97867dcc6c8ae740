#pragma once

#include <vector>

#include "ui/render/scene/scene_renderer.h"
#include "ui/render/scene/shadow_pass.h"

namespace stretch::ui {

/// How posed items are coloured.
struct SurfaceLook {
  const Palette& palette;
  SurfaceShading shading = SurfaceShading::material;
  bool wireframe = false;
  double floorHeight = 0.0;
  double characterHeight = 1.0;
  const ShadowMaps* shadows = nullptr; ///< Never null while drawing.
};

/// Which pixels of a surface are drawn: those that hide what is behind them, or the others of a blended one.
enum class SurfacePart { solid, seeThrough };

/// Draws posed items with their materials, as wires, or as a ghost.
class SurfacePass {
public:
  [[nodiscard]] static Result<SurfacePass> create();

  /// Opaque and masked materials, the pixels of blended ones that hide what is behind them, and the wires of
  /// all.
  void drawOpaque(const Scene& scene, const UploadedScene& uploaded, const View& view,
                  const StudioLights& lights, const SurfaceLook& look, const FrameState& frame) const;
  /// The other pixels of blended materials, the farthest surface first; they hide nothing.
  void drawBlended(const Scene& scene, const UploadedScene& uploaded, const View& view,
                   const StudioLights& lights, const SurfaceLook& look, const FrameState& frame) const;
  void drawGhost(const UploadedScene& uploaded, const View& view, const glm::vec4& tint) const;

private:
  void begin(const View& view, const StudioLights& lights, const SurfaceLook& look) const;
  void drawItem(const Scene& scene, const UploadedScene& uploaded, const DrawItem& item,
                const FrameState& frame, SurfacePart drawn) const;
  /// Whether there is a texture to show.
  bool bindUse(int unit, const UploadedScene& uploaded, const TextureUse& use) const;
  void drawWires(const UploadedScene& uploaded, const View& view, const Palette& palette) const;

  ShaderProgram surface_;
  ShaderProgram ghost_;
  ShaderProgram depth_;
  ShaderProgram wire_;
  std::vector<GlSampler> samplers_; ///< One for each way to use a texture.
  GlTexture stretchColors_;
  GlTexture weightColors_;
};

} // namespace stretch::ui
