// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/window/WindowTest.h"

#include "tests/widgets/Bench.h"

namespace app::test {

void WindowTest::initTestCase() {
  home_ = widgets::test::BenchHome::path() / "robotcontrol";
}

void WindowTest::init() {
  std::filesystem::remove_all(home_);
  std::filesystem::create_directories(home_);
}

}  // namespace app::test
