#include "ui/render/overlay/overlay_renderer.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>

#include "ui/render/overlay/arrow_mesh.h"

namespace stretch::ui {

namespace {

constexpr float hiddenOpacity = 0.32F;

// As line.vert reads it: one instance for each segment.
struct LineInstance {
  glm::vec3 before;
  glm::vec3 from;
  glm::vec3 to;
  glm::vec3 after;
  glm::vec4 fromColor;
  glm::vec4 toColor;
  glm::vec4 style;
  glm::vec2 along;
};

// As marker.vert reads it.
struct MarkerInstance {
  glm::vec3 centre;
  glm::vec4 fill;
  glm::vec4 edge;
  glm::vec4 shape;
};

// World positions relative to the eye: small numbers, exact in single precision wherever the character
// stands.
glm::vec3 relative(const View& view, const Vec3& world) {
  return glm::vec3(world - view.eye);
}

glm::mat4 relativeProjection(const View& view) {
  Mat4 rotation = view.view;
  rotation[3] = view.view * Vec4(view.eye, 1.0);
  return glm::mat4(view.projection * rotation);
}

// What lies nearer than this (clip w) is cut off; orthographic views cut nothing (w is 1).
float nearestDrawn(const View& view) {
  const bool orthographic = view.projection[3][3] != 0.0;
  if (orthographic) {
    return 0.5F;
  }
  const double nearPlane = view.projection[3][2] / (view.projection[2][2] - 1.0);
  return static_cast<float>(nearPlane);
}

double pixelsApart(const View& view, const Vec3& a, const Vec3& b) {
  const std::optional<ScreenPoint> from = projectToPixels(view, a);
  const std::optional<ScreenPoint> to = projectToPixels(view, b);
  return from && to ? glm::length(to->pixels - from->pixels) : 0.0;
}

void addSegments(const View& view, const Polyline& line, std::vector<LineInstance>& instances) {
  const auto scale = static_cast<float>(view.viewport.pixelsPerPoint);
  const std::vector<LinePoint>& points = line.points;
  double along = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const LinePoint& from = points[i];
    const LinePoint& to = points[i + 1];
    const double length = line.dashPoints > 0.0F ? pixelsApart(view, from.world, to.world) : 0.0;
    instances.push_back({relative(view, points[i == 0 ? 0 : i - 1].world), relative(view, from.world),
                         relative(view, to.world),
                         relative(view, points[std::min(i + 2, points.size() - 1)].world), from.color,
                         to.color,
                         scale * glm::vec4(from.widthPoints, to.widthPoints, line.dashPoints, line.gapPoints),
                         glm::vec2(along, along + length)});
    along += length;
  }
}

constexpr double outlinePoints = 1.5;

struct LineGroup {
  OverlayDepth depth = OverlayDepth::faded;
  bool outlined = false;
};

MarkerInstance instanceOf(const View& view, const Marker& marker) {
  const double scale = view.viewport.pixelsPerPoint;
  return {relative(view, marker.world), marker.fill, marker.edge,
          glm::vec4(static_cast<double>(marker.radiusPoints) * scale,
                    static_cast<double>(marker.edgePoints) * scale, static_cast<double>(marker.shape),
                    marker.turnRadians)};
}

std::vector<MarkerInstance> farthestFirst(const View& view, const std::vector<Marker>& markers,
                                          OverlayDepth depth) {
  std::vector<std::pair<double, const Marker*>> ordered;
  for (const Marker& marker : markers) {
    if (marker.depth == depth) {
      ordered.emplace_back(glm::dot(marker.world - view.eye, view.forward), &marker);
    }
  }
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<MarkerInstance> instances;
  instances.reserve(ordered.size());

  for (const auto& [distance, marker] : ordered) {
    instances.push_back(instanceOf(view, *marker));
  }
  return instances;
}

// Draws in full where the surface does not hide it and, where asked, weaker where it does.
template <typename DrawCall>
void drawWithDepth(const ShaderProgram& program, OverlayDepth depth, const DrawCall& drawCall) {
  program.set("opacity", 1.0F);
  if (depth == OverlayDepth::onTop) {
    glDisable(GL_DEPTH_TEST);
    drawCall();
    return;
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  program.set("opacity", hiddenOpacity);
  drawCall();
  glDepthFunc(GL_LEQUAL);
  program.set("opacity", 1.0F);
  drawCall();
}

void setView(const ShaderProgram& program, const View& view) {
  program.use();
  program.set("viewProjection", relativeProjection(view));
  program.set("viewportSize", glm::vec2(view.viewport.widthPixels, view.viewport.heightPixels));
  program.set("nearest", nearestDrawn(view));
}

} // namespace

Result<OverlayRenderer> OverlayRenderer::create() {
  OverlayRenderer renderer;
  const std::array<std::pair<ShaderProgram OverlayRenderer::*, ShaderFiles>, 3> programs{
      {{&OverlayRenderer::line_, {"line.vert", "line.frag", {}, {}}},
       {&OverlayRenderer::marker_, {"marker.vert", "marker.frag", {}, {}}},
       {&OverlayRenderer::solid_, {"solid.vert", "solid.frag", {}, {}}}}};
  for (const auto& [member, files] : programs) {
    Result<ShaderProgram> program = ShaderProgram::build(files);
    if (!program) {
      return program.error();
    }
    renderer.*member = std::move(program).value();
  }
  const GlStateGuard guard;
  renderer.instances_ = GlBuffer::create();
  renderer.lineArray_ = GlVertexArray::create();
  renderer.markerArray_ = GlVertexArray::create();
  renderer.solidArray_ = GlVertexArray::create();
  const auto add = [&](const GlVertexArray& array, unsigned location, int width, std::size_t stride,
                       std::size_t offset, bool perInstance) {
    addAttribute(array, renderer.instances_, {location, width, stride, offset, false, perInstance});
  };
  constexpr std::size_t lineStride = sizeof(LineInstance);
  add(renderer.lineArray_, 0, 3, lineStride, offsetof(LineInstance, before), true);
  add(renderer.lineArray_, 1, 3, lineStride, offsetof(LineInstance, from), true);
  add(renderer.lineArray_, 2, 3, lineStride, offsetof(LineInstance, to), true);
  add(renderer.lineArray_, 3, 3, lineStride, offsetof(LineInstance, after), true);
  add(renderer.lineArray_, 4, 4, lineStride, offsetof(LineInstance, fromColor), true);
  add(renderer.lineArray_, 5, 4, lineStride, offsetof(LineInstance, toColor), true);
  add(renderer.lineArray_, 6, 4, lineStride, offsetof(LineInstance, style), true);
  add(renderer.lineArray_, 7, 2, lineStride, offsetof(LineInstance, along), true);
  constexpr std::size_t markerStride = sizeof(MarkerInstance);
  add(renderer.markerArray_, 0, 3, markerStride, offsetof(MarkerInstance, centre), true);
  add(renderer.markerArray_, 1, 4, markerStride, offsetof(MarkerInstance, fill), true);
  add(renderer.markerArray_, 2, 4, markerStride, offsetof(MarkerInstance, edge), true);
  add(renderer.markerArray_, 3, 4, markerStride, offsetof(MarkerInstance, shape), true);
  constexpr std::size_t solidStride = sizeof(SolidVertex);
  add(renderer.solidArray_, 0, 3, solidStride, offsetof(SolidVertex, position), false);
  add(renderer.solidArray_, 1, 3, solidStride, offsetof(SolidVertex, normal), false);
  add(renderer.solidArray_, 2, 4, solidStride, offsetof(SolidVertex, color), false);
  return renderer;
}

void OverlayRenderer::draw(const View& view, const Overlay& overlay, const Palette& palette) const {
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  const GlStateGuard guard;
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
  glViewport(0, 0, static_cast<GLsizei>(view.viewport.widthPixels),
             static_cast<GLsizei>(view.viewport.heightPixels));
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  drawLines(view, overlay, palette);
  drawMarkers(view, overlay);
  drawArrows(view, overlay);
}

void OverlayRenderer::drawLines(const View& view, const Overlay& overlay, const Palette& palette) const {
  setView(line_, view);
  line_.set("outlineColor", palette.outline);
  glBindVertexArray(lineArray_.name());
  constexpr std::array<LineGroup, 4> groups{{{OverlayDepth::faded, false},
                                             {OverlayDepth::faded, true},
                                             {OverlayDepth::onTop, false},
                                             {OverlayDepth::onTop, true}}};
  for (const LineGroup& group : groups) {
    std::vector<LineInstance> instances;
    for (const Polyline& line : overlay.lines) {
      if (line.depth == group.depth && line.outlined == group.outlined) {
        addSegments(view, line, instances);
      }
    }
    if (instances.empty()) {
      continue;
    }
    replaceBuffer(instances_, bytesOf(instances));
    line_.set("outline",
              group.outlined ? static_cast<float>(outlinePoints * view.viewport.pixelsPerPoint) : 0.0F);
    drawWithDepth(line_, group.depth, [&] {
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
    });
  }
}

void OverlayRenderer::drawMarkers(const View& view, const Overlay& overlay) const {
  setView(marker_, view);
  glBindVertexArray(markerArray_.name());
  for (const OverlayDepth depth : {OverlayDepth::faded, OverlayDepth::onTop}) {
    const std::vector<MarkerInstance> instances = farthestFirst(view, overlay.markers, depth);
    if (instances.empty()) {
      continue;
    }
    replaceBuffer(instances_, bytesOf(instances));
    drawWithDepth(marker_, depth, [&] {
      glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
    });
  }
}

void OverlayRenderer::drawArrows(const View& view, const Overlay& overlay) const {
  const std::vector<SolidVertex> vertices = arrowMeshes(view, overlay.arrows);
  if (vertices.empty()) {
    return;
  }
  solid_.use();
  solid_.set("viewProjection", relativeProjection(view));
  solid_.set("view", glm::mat4(view.view));
  solid_.set("opacity", 1.0F);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  replaceBuffer(instances_, bytesOf(vertices));
  glBindVertexArray(solidArray_.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

} // namespace stretch::ui
