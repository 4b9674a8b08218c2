// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/window/WindowTest.h"

#include "tests/widgets/Bench.h"

void WindowTest::initTestCase() {
  Bench::prepare(ROBOTCONTROL_SOURCE_DIR);
  home_ = std::filesystem::path(qgetenv("XDG_CONFIG_HOME").toStdString()) / "robotcontrol";
}

void WindowTest::init() {
  std::filesystem::remove_all(home_);
  std::filesystem::create_directories(home_);
}

void WindowTest::cleanupTestCase() {
  Bench::tidyUp();
}
