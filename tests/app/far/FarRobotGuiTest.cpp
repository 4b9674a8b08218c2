// SPDX-License-Identifier: GPL-3.0-or-later
// Robots whose programs run in processes of their own on this machine, over a relay that can be silenced.
#include "tests/app/far/FarRobotSteps.h"
#include "tests/app/far/RelayLine.h"
#include "tests/widgets/GuiTest.h"

namespace app::test {

class FarRobotGuiTest : public FarRobotSteps {
  Q_OBJECT
 protected:
  std::unique_ptr<FarLine> makeLine() override { return std::make_unique<RelayLine>(); }
};

const widgets::test::GuiTest<FarRobotGuiTest> kFarRobotGuiTest;

}  // namespace app::test

#include "FarRobotGuiTest.moc"
