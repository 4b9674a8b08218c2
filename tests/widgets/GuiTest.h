// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

namespace widgets::test {

using GuiTestMaker = std::unique_ptr<QObject> (*)();

/// The classes of tests in this program; the main() in GuiTestMain.cpp runs one of them, or all.
std::vector<GuiTestMaker>& guiTests();

/// Registers a class of tests by a constant beside it: `const GuiTest<ImageStreamViewTest>
/// kImageStreamViewTest;`
template <typename T>
struct GuiTest {
  GuiTest() {
    guiTests().push_back([]() -> std::unique_ptr<QObject> { return std::make_unique<T>(); });
  }
};

}  // namespace widgets::test
