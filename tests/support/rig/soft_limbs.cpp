#include "tests/support/rig/soft_limbs.h"
#include "rig/limb.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace stretch::test {

rig::WeightSample softSample(const rig::Limb& limb, const FrameState& frame, const SoftBones& bones) {
  rig::WeightSample sample{frame.timeSeconds, {}, bones.planted, bones.kept};
  const std::vector<Vec3> points = rig::limbPoints(limb, frame.worlds);
  for (std::size_t i = 0; i < limb.joints.size(); ++i) {
    const Mat4 toJoint = glm::inverse(frame.worlds[at(limb.joints[i])]);
    const Vec3 along = glm::normalize(transformVector(toJoint, points[i + 1] - points[i]));
    const Vec3 load = transformVector(toJoint, bones.acrossWorld);
    const Vec3 across = glm::normalize(load - glm::dot(load, along) * along);
    const Vec3 sideways = glm::cross(along, across);
    sample.strains.push_back((bones.along - 1.0) * glm::outerProduct(along, along) +
                             (bones.withLoad - 1.0) * glm::outerProduct(across, across) +
                             (bones.sideways - 1.0) * glm::outerProduct(sideways, sideways));
  }
  return sample;
}

rig::MotionState softMotion(const MovingBiped& moving, const std::vector<rig::Trail>& trails,
                            const std::vector<rig::LimbWeight>& weights) {
  const rig::MotionInput input = motionInput(moving, trails);
  rig::MotionState motion = rig::solveMotion(input);
  rig::setWeight(input, weights, motion);
  return motion;
}

} // namespace stretch::test
