#include "ui/render/scene/surface_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <epoxy/gl.h>

#include "ui/render/scene/draw_items.h"
#include "ui/render/scene/value_colors.h"

namespace stretch::ui {

namespace {

constexpr int baseColorUnit = 0;
constexpr int stretchColorUnit = 1;
constexpr int shadowUnit = 2;
constexpr int emissiveUnit = 3;
constexpr int weightColorUnit = 4;
constexpr std::size_t wrapCount = 3;

const Material plainMaterial{}; // what a primitive without a material looks like

bool isOrthographic(const View& view) {
  return view.projection[3][3] != 0.0;
}

GLint wrapName(TextureWrap wrap) {
  switch (wrap) {
  case TextureWrap::repeat:
    return GL_REPEAT;
  case TextureWrap::mirror:
    return GL_MIRRORED_REPEAT;
  case TextureWrap::clamp:
    break;
  }
  return GL_CLAMP_TO_EDGE;
}

std::size_t samplerIndex(const TextureUse& use) {
  return (static_cast<std::size_t>(use.wrapU) * wrapCount + static_cast<std::size_t>(use.wrapV)) * 2 +
         (use.nearestFilter ? 1 : 0);
}

GlSampler makeSampler(const TextureUse& use) {
  GlSampler sampler = GlSampler::create();
  const GLuint name = sampler.name();
  glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER,
                      use.nearestFilter ? GL_NEAREST_MIPMAP_LINEAR : GL_LINEAR_MIPMAP_LINEAR);
  glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, use.nearestFilter ? GL_NEAREST : GL_LINEAR);
  glSamplerParameteri(name, GL_TEXTURE_WRAP_S, wrapName(use.wrapU));
  glSamplerParameteri(name, GL_TEXTURE_WRAP_T, wrapName(use.wrapV));
  return sampler;
}

// One for each way to use a texture, by samplerIndex.
std::vector<GlSampler> makeSamplers() {
  std::vector<GlSampler> samplers;
  for (const TextureWrap wrapU : {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp}) {
    for (const TextureWrap wrapV : {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp}) {
      for (const bool nearest : {false, true}) {
        TextureUse use;
        use.nearestFilter = nearest;
        use.wrapU = wrapU;
        use.wrapV = wrapV;
        samplers.push_back(makeSampler(use));
      }
    }
  }
  return samplers;
}

// A row of colours for 0..1; `colorAt` says them.
template <typename ColorAt>
GlTexture makeRamp(const ColorAt& colorAt) {
  constexpr int width = 256;
  std::vector<glm::vec3> colors;
  colors.reserve(width);
  for (int i = 0; i < width; ++i) {
    colors.push_back(colorAt((i + 0.5) / width));
  }
  GlTexture texture = GlTexture::create();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB16F, width, 1, 0, GL_RGB, GL_FLOAT, colors.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  return texture;
}

GlTexture makeStretchColors() {
  const double first = std::log2(smallestShownStretch);
  const double last = std::log2(largestShownStretch);
  return makeRamp([&](double share) { return stretchColor(std::exp2(first + (last - first) * share)); });
}

GlTexture makeWeightColors() {
  return makeRamp([](double share) { return glm::vec3(valueColor(ValueScale::weight, share)); });
}

void bindTexture(int unit, unsigned texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

const Material& materialOf(const Scene& scene, int index) {
  return index >= 0 ? scene.materials[static_cast<std::size_t>(index)] : plainMaterial;
}

bool isBlended(const Scene& scene, const UploadedScene& uploaded, const DrawItem& item) {
  return materialOf(scene, uploaded.parts[item.part].material).alphaMode == AlphaMode::blend;
}

// Of a surface with two sides that is seen through the far side comes first.
void drawFaces(const UploadedScene& uploaded, const DrawItem& item, bool isDoubleSided, SurfacePart part) {
  if (isDoubleSided && part == SurfacePart::solid) {
    glDisable(GL_CULL_FACE);
    drawTriangles(uploaded, item);
    return;
  }
  glEnable(GL_CULL_FACE);
  if (isDoubleSided) {
    glCullFace(GL_FRONT);
    drawTriangles(uploaded, item);
    glCullFace(GL_BACK);
  }
  drawTriangles(uploaded, item);
}

void setEye(const ShaderProgram& program, const View& view) {
  program.set("viewProjection", glm::mat4(view.projection * view.view));
  program.set("eye", glm::vec3(view.eye));
  program.set("viewForward", glm::vec3(view.forward));
  program.set("orthographic", isOrthographic(view));
}

} // namespace

Result<SurfacePass> SurfacePass::create() {
  SurfacePass pass;
  const std::array<std::pair<ShaderProgram SurfacePass::*, ShaderFiles>, 4> programs{
      {{&SurfacePass::surface_, {"surface.vert", "surface.frag", {}, {}}},
       {&SurfacePass::ghost_, {"surface.vert", "ghost.frag", {}, {}}},
       {&SurfacePass::depth_, {"position.vert", "depth_only.frag", {}, {}}},
       {&SurfacePass::wire_, {"position.vert", "wire.frag", "wire.geom", {}}}}};
  for (const auto& [member, files] : programs) {
    Result<ShaderProgram> program = ShaderProgram::build(files);
    if (!program) {
      return program.error();
    }
    pass.*member = std::move(program).value();
  }
  pass.samplers_ = makeSamplers();
  pass.stretchColors_ = makeStretchColors();
  pass.weightColors_ = makeWeightColors();
  return pass;
}

void SurfacePass::begin(const View& view, const StudioLights& lights, const SurfaceLook& look) const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  bindTexture(stretchColorUnit, stretchColors_.name());
  bindTexture(weightColorUnit, weightColors_.name());
  bindTexture(shadowUnit, look.shadows->depthTexture);
  surface_.use();
  setEye(surface_, view);
  surface_.set("baseColorTexture", baseColorUnit);
  surface_.set("emissiveTexture", emissiveUnit);
  surface_.set("stretchColors", stretchColorUnit);
  surface_.set("weightColors", weightColorUnit);
  surface_.set("shadowMap", shadowUnit);
  surface_.set("hasShadow", look.shadows->depthTexture != 0);
  surface_.set("shadowMatrix", glm::mat4(look.shadows->worldToDepth));
  surface_.set("shadowTexel", static_cast<float>(look.shadows->depthTexelSize));
  surface_.set("shading", static_cast<int>(look.shading));
  surface_.set("stretchRange", glm::vec2(std::log2(smallestShownStretch), std::log2(largestShownStretch)));
  surface_.set("selectionLine", glm::vec3(look.palette.selectionLine));
  surface_.set("selectionGround", glm::vec3(look.palette.selectionGround));
  surface_.set("linePixels", static_cast<float>(view.viewport.pixelsPerPoint));
  surface_.set("keyDirection", glm::vec3(lights.key));
  surface_.set("fillDirection", glm::vec3(lights.fill));
  surface_.set("rimDirection", glm::vec3(lights.rim));
  surface_.set("floorHeight", static_cast<float>(look.floorHeight));
  surface_.set("characterHeight", static_cast<float>(look.characterHeight));
}

bool SurfacePass::bindUse(int unit, const UploadedScene& uploaded, const TextureUse& use) const {
  const unsigned texture =
      use.image >= 0 ? (*uploaded.textures)[static_cast<std::size_t>(use.image)].name() : 0U;
  bindTexture(unit, texture);
  glBindSampler(static_cast<GLuint>(unit), samplers_[samplerIndex(use)].name());
  return texture != 0;
}

void SurfacePass::drawItem(const Scene& scene, const UploadedScene& uploaded, const DrawItem& item,
                           const FrameState& frame, SurfacePart drawn) const {
  const UploadedPart& part = uploaded.parts[item.part];
  const Material& material = materialOf(scene, part.material);
  const bool hasEmissive = bindUse(emissiveUnit, uploaded, material.emissiveTexture);
  const bool hasBaseColor =
      bindUse(baseColorUnit, uploaded, part.hasTexCoords ? material.baseColorTexture : TextureUse{});
  const bool isEmissiveLost = material.emissiveTexture.image >= 0 && !hasEmissive;
  surface_.set("hasTexture", hasBaseColor);
  surface_.set("uvTransform", material.baseColorTexture.uvTransform);
  surface_.set("baseColor", material.baseColor);
  surface_.set("hasEmissiveTexture", hasEmissive);
  surface_.set("emissiveUvTransform", material.emissiveTexture.uvTransform);
  surface_.set("emissive", isEmissiveLost ? glm::vec3(0.0F) : material.emissive);
  surface_.set("alphaMode", static_cast<int>(material.alphaMode));
  surface_.set("alphaCutoff", material.alphaCutoff);
  surface_.set("unlit", material.unlit);
  surface_.set("solidPart", drawn == SurfacePart::solid);
  setFrontFace(scene, item, frame);
  drawFaces(uploaded, item, material.doubleSided, drawn);
  glBindSampler(baseColorUnit, 0);
  glBindSampler(emissiveUnit, 0);
}

void SurfacePass::drawOpaque(const Scene& scene, const UploadedScene& uploaded, const View& view,
                             const StudioLights& lights, const SurfaceLook& look,
                             const FrameState& frame) const {
  begin(view, lights, look);
  glDisable(GL_BLEND);
  for (const DrawItem& item : uploaded.items) {
    drawItem(scene, uploaded, item, frame, SurfacePart::solid);
  }
  glFrontFace(GL_CCW);
  if (look.wireframe) {
    drawWires(uploaded, view, look.palette);
  }
}

void SurfacePass::drawBlended(const Scene& scene, const UploadedScene& uploaded, const View& view,
                              const StudioLights& lights, const SurfaceLook& look,
                              const FrameState& frame) const {
  std::vector<std::pair<double, const DrawItem*>> farthestFirst;
  for (const DrawItem& item : uploaded.items) {
    if (isBlended(scene, uploaded, item)) {
      const Vec3 place = positionOf(frame.worlds[at(item.node)]);
      farthestFirst.emplace_back(transformPoint(view.view, place).z, &item);
    }
  }
  std::stable_sort(farthestFirst.begin(), farthestFirst.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  begin(view, lights, look);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const auto& [depth, item] : farthestFirst) {
    drawItem(scene, uploaded, *item, frame, SurfacePart::seeThrough);
  }
  glFrontFace(GL_CCW);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

// Depth first, then colour where the depth is its own: each pixel of a ghost is tinted once, whatever folds
// behind it.
void SurfacePass::drawGhost(const UploadedScene& uploaded, const View& view, const glm::vec4& tint) const {
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_CULL_FACE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  ghost_.use();
  setEye(ghost_, view);
  ghost_.set("tint", tint);
  for (const DrawItem& item : uploaded.items) {
    drawTriangles(uploaded, item);
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const DrawItem& item : uploaded.items) {
    drawTriangles(uploaded, item);
  }
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

void SurfacePass::drawWires(const UploadedScene& uploaded, const View& view, const Palette& palette) const {
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  wire_.use();
  wire_.set("viewProjection", glm::mat4(view.projection * view.view));
  wire_.set("viewportSize", glm::vec2(view.viewport.widthPixels, view.viewport.heightPixels));
  wire_.set("lineColor", palette.wire);
  wire_.set("lineWidth", static_cast<float>(view.viewport.pixelsPerPoint));
  for (const DrawItem& item : uploaded.items) {
    drawTriangles(uploaded, item);
  }
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
}

} // namespace stretch::ui
