// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of rUNSWift: what is read is a motion that can be written and read again.
#include <cstdio>
#include <cstdlib>

#include "robotlink/motions/MotionImport.h"
#include "robotlink/motions/MotionReader.h"
#include "robotlink/motions/MotionWriter.h"
#include "tests/fuzz/FuzzTarget.h"

namespace pos_motion_fuzz {

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto motion = robotlink::readPosMotion(text, "fuzz.pos");
  if (!motion && !motion.error().empty()) return 0;
  if (motion && robotlink::readMotion(robotlink::writeMotion(*motion), "fuzz.mof")) return 0;
  std::fputs("an import is no motion, or a refusal has no errors\n", stderr);
  std::abort();
}

std::vector<std::string> fuzzSeeds() {
  return {"1\n40 1 2 3  1 2 3  4 5 6  7 8 9  10 11 12\n",
          "2\r\n# a \"kick\" // left\r\n40 ? ? ?  -1 2.5 3  4 5 6  7 8 9  10 11 12\r\n"
          "15 1 2 3  1 2 3  4 5 6  7 8 9  10 11 12"};
}

const FuzzRegistration kTarget({"pos_motion", &fuzzSeeds, &runInput});

}  // namespace pos_motion_fuzz
