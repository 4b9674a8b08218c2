// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <memory>

#include "tests/TestFolder.h"

/// A Qt application without a display for fuzzers, whose settings are in a folder of its own. One at a time.
class OffscreenApplication {
 public:
  OffscreenApplication() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("XDG_RUNTIME_DIR", folder_.path().c_str());
    qputenv("XDG_CONFIG_HOME", folder_.path().c_str());
    qputenv("ROBOTCONTROL_RESOURCES", ROBOTCONTROL_SOURCE_DIR "/resources");
    static int count = 1;
    static char name[] = "fuzz", *names[] = {name, nullptr};
    application_ = std::make_unique<QApplication>(count, names);
  }

  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  TestFolder folder_;
  std::unique_ptr<QApplication> application_;
};
