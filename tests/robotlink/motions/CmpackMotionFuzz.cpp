// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of CMPack'02: what is read is a motion that can be written and read again.
#include <cstdio>
#include <cstdlib>

#include "robotlink/motions/MotionImport.h"
#include "robotlink/motions/MotionReader.h"
#include "robotlink/motions/MotionWriter.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/motions/CmpackBytes.h"

namespace cmpack_motion_fuzz {

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto motion = robotlink::readCmpackMotion(bytes, "fuzz.mot");
  if (!motion && !motion.error().empty()) return 0;
  if (motion && robotlink::readMotion(robotlink::writeMotion(*motion), "fuzz.mof")) return 0;
  std::fputs("an import is no motion, or a refusal has no errors\n", stderr);
  std::abort();
}

std::vector<std::string> fuzzSeeds() {
  const auto frames = robotlink::cmpackKick();
  return {robotlink::cmpackBytes(frames), robotlink::cmpackBytes({frames[2]})};
}

const FuzzRegistration kTarget({"cmpack_motion", &fuzzSeeds, &runInput});

}  // namespace cmpack_motion_fuzz
