#include "ui/render/scene/posing.h"

#include <map>

#include <epoxy/gl.h>

namespace stretch::ui {

namespace {

// The matrices as skin.vert reads them.
class SlotTable {
public:
  SlotTable(const Scene& scene, const FrameState& frame, const JointAttributes& attributes,
            const FrameState* turning)
      : scene_(scene), frame_(frame), attributes_(attributes), turning_(turning) {}

  int firstSlotOf(const DrawItem& item) {
    const std::pair key(item.skin, item.skin >= 0 ? NodeIndex::none : item.node);
    const auto [place, isNew] = first_.try_emplace(key, slotCount_);
    if (isNew) {
      addSlots(item);
    }
    return place->second;
  }

  [[nodiscard]] const std::vector<glm::vec4>& texels() const { return texels_; }

private:
  void addSlots(const DrawItem& item) {
    if (item.skin < 0) {
      const Mat4 matrix = meshMatrix(frame_, item.node);
      add(matrix, turning_ != nullptr ? meshMatrix(*turning_, item.node) : matrix, item.node);
      return;
    }
    const Skin& skin = scene_.skins[static_cast<std::size_t>(item.skin)];
    const std::vector<Mat4> matrices = skinMatrices(skin, frame_);
    const std::vector<Mat4> turns = turning_ != nullptr ? skinMatrices(skin, *turning_) : matrices;
    for (std::size_t joint = 0; joint < matrices.size(); ++joint) {
      add(matrices[joint], turns[joint], skin.joints[joint]);
    }
  }

  void add(const Mat4& matrix, const Mat4& turn, NodeIndex node) {
    const auto index = at(node);
    addRows(matrix);
    const double ratio = index < attributes_.stretchRatio.size() ? attributes_.stretchRatio[index] : 1.0;
    const float highlight = index < attributes_.highlight.size() ? attributes_.highlight[index] : 0.0F;
    texels_.emplace_back(static_cast<float>(ratio), highlight, 0.0F, 0.0F);
    if (turning_ != nullptr) {
      addRows(turn);
    }
    ++slotCount_;
  }

  void addRows(const Mat4& matrix) {
    for (glm::length_t row = 0; row < 3; ++row) {
      texels_.emplace_back(matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]);
    }
  }

  const Scene& scene_;
  const FrameState& frame_;
  const JointAttributes& attributes_;
  const FrameState* turning_;
  std::map<std::pair<int, NodeIndex>, int> first_;
  std::vector<glm::vec4> texels_;
  int slotCount_ = 0;
};

const std::vector<float>& weightsOf(const Scene& scene, const FrameState& frame, const DrawItem& item,
                                    int mesh) {
  const auto node = at(item.node);
  const auto& posed = frame.pose.weights;
  return node < posed.size() && !posed[node].empty()
             ? posed[node]
             : scene.meshes[static_cast<std::size_t>(mesh)].morphWeights;
}

std::vector<glm::vec3> readPosed(const UploadedScene& uploaded, std::size_t item, std::size_t firstFloat) {
  const auto count = static_cast<std::size_t>(uploaded.parts[uploaded.items[item].part].vertexCount);
  std::vector<float> floats(posedFloats * count);
  glBindBuffer(GL_ARRAY_BUFFER, uploaded.items[item].posed.name());
  glGetBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(floats.size() * sizeof(float)),
                     floats.data());
  std::vector<glm::vec3> vectors(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float* at = floats.data() + posedFloats * i + firstFloat;
    vectors[i] = {at[0], at[1], at[2]};
  }
  return vectors;
}

} // namespace

Result<PosingPass> PosingPass::create() {
  Result<ShaderProgram> program =
      ShaderProgram::build({"skin.vert", {}, {}, {"posedPosition", "posedNormal", "posedAttributes"}});
  if (!program) {
    return program.error();
  }
  return PosingPass(std::move(program).value());
}

PosingPass::PosingPass(ShaderProgram program)
    : program_(std::move(program)), matrices_(GlBuffer::create()), matrixTexture_(GlTexture::create()),
      unseen_(makeMaskTarget(1)) {}

void PosingPass::pose(const Scene& scene, UploadedScene& uploaded, const FrameState& frame,
                      const JointAttributes& attributes, const FrameState* turning) const {
  SlotTable table(scene, frame, attributes, turning);
  std::vector<int> firstSlots;
  for (const DrawItem& item : uploaded.items) {
    firstSlots.push_back(table.firstSlotOf(item));
  }
  replaceBuffer(matrices_, bytesOf(table.texels()));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_BUFFER, matrixTexture_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, matrices_.name());
  program_.use();
  program_.set("matrices", 0);
  program_.set("plainNormals", turning != nullptr);
  GLint boundBefore = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &boundBefore);
  glBindFramebuffer(GL_FRAMEBUFFER, unseen_.framebuffer.name());
  glEnable(GL_RASTERIZER_DISCARD);
  for (std::size_t i = 0; i < uploaded.items.size(); ++i) {
    const DrawItem& item = uploaded.items[i];
    UploadedPart& part = uploaded.parts[item.part];
    morph(part, weightsOf(scene, frame, item, part.mesh));
    program_.set("firstSlot", firstSlots[i]);
    program_.set("influenceCount", item.skin >= 0 ? part.influenceCount : 0);
    glBindVertexArray(item.poseInput.name());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, item.posed.name());
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, part.vertexCount);
    glEndTransformFeedback();
  }
  glDisable(GL_RASTERIZER_DISCARD);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(boundBefore));
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glBindTexture(GL_TEXTURE_BUFFER, 0);
}

std::vector<glm::vec3> readPosedPositions(const UploadedScene& uploaded, std::size_t item) {
  return readPosed(uploaded, item, 0);
}

std::vector<glm::vec3> readPosedNormals(const UploadedScene& uploaded, std::size_t item) {
  return readPosed(uploaded, item, 3);
}

} // namespace stretch::ui
