// SPDX-License-Identifier: GPL-3.0-or-later
// Made-up motions in the format of CMPack'02.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robotlink/base/bytes/LittleEndian.h"

namespace robotlink {

struct CmpackLimb {
  std::int32_t attributes = 0;
  std::array<double, 3> point{};  // mm
  std::array<double, 3> angles{};
};
struct CmpackFrame {
  std::array<double, 6> body{};  // place in mm, rotation in rad
  std::array<CmpackLimb, 5> limbs{};
  std::int32_t timeMs = 100;
};

template <typename Number>
void appendNumber(std::string& bytes, Number number) {
  std::uint8_t buffer[sizeof(Number)];
  storeNumber(buffer, number);
  bytes.append(reinterpret_cast<const char*>(buffer), sizeof(Number));
}

inline std::string cmpackBytes(const std::vector<CmpackFrame>& frames) {
  std::string bytes;
  appendNumber(bytes, static_cast<std::int32_t>(frames.size()));
  for (const CmpackFrame& frame : frames) {
    for (const double number : frame.body) appendNumber(bytes, number);
    for (const CmpackLimb& limb : frame.limbs) {
      appendNumber(bytes, limb.attributes);
      appendNumber(bytes, std::int32_t{0});
      for (const double number : limb.point) appendNumber(bytes, number);
      for (const double number : limb.angles) appendNumber(bytes, number);
    }
    appendNumber(bytes, frame.timeMs);
    appendNumber(bytes, std::int32_t{0});
  }
  return bytes;
}

/// A frame that leaves all joints as they are, one with angles, and one that stands on its paws with the nose
/// down.
inline std::vector<CmpackFrame> cmpackKick() {
  CmpackFrame rest, angles, standing;
  rest.timeMs = 300;
  for (CmpackLimb& limb : angles.limbs) limb = {1, {}, {0.5, 0.25, 1.0}};
  standing.body = {0, 0, 104, 0, 0.28, 0};
  standing.limbs = {CmpackLimb{2, {124, 85, 0}, {}}, CmpackLimb{2, {124, -85, 0}, {}},
                    CmpackLimb{2, {-80, 75, 0}, {}}, CmpackLimb{2, {-80, -75, 0}, {}},
                    CmpackLimb{1, {}, {-0.3, 1.5, 0}}};
  standing.timeMs = 200;
  return {rest, angles, standing};
}

}  // namespace robotlink
