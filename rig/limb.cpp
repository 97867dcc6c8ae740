#include "rig/limb.h"

namespace stretch::rig {

std::string_view limbName(LimbKind kind) {
  switch (kind) {
  case LimbKind::leftArm:
    return "left-arm";
  case LimbKind::rightArm:
    return "right-arm";
  case LimbKind::leftLeg:
    return "left-leg";
  case LimbKind::rightLeg:
    return "right-leg";
  case LimbKind::spine:
    return "spine";
  case LimbKind::neck:
    return "neck";
  case LimbKind::chain:
    break;
  }
  return "chain";
}

} // namespace stretch::rig
