// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the real workbench one with a module that never returns. It makes the file in $STUCK_FILE as soon as
// that is the case.
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/app/stuck/StuckSolution.h"

namespace {

const bool kIsWatched = [] {
  const char* file = std::getenv("STUCK_FILE");
  if (file == nullptr) return false;
  std::thread([file] {
    app::test::StuckSolution::hanging.wait(0);
    const std::ofstream made(file);
  }).detach();
  return true;
}();

}  // namespace
