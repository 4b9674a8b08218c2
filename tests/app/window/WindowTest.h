// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>

namespace app::test {

/// What all tests of the window have in common: each test finds an empty home.
class WindowTest : public QObject {
  Q_OBJECT
 protected:
  std::filesystem::path home_;

 protected Q_SLOTS:
  void initTestCase();
  void init();
};

}  // namespace app::test
