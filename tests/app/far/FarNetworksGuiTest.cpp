// SPDX-License-Identifier: GPL-3.0-or-later
// Robots on machines with networks of their own, which reach the desk by a cable that is pulled out. Skipped
// where the system does not let tests make networks.
#include <QTest>

#include "tests/app/far/FarRobot.h"
#include "tests/app/far/FarRobotSteps.h"
#include "tests/app/far/NetworkLine.h"
#include "tests/widgets/GuiTest.h"

namespace app::test {

class FarNetworksGuiTest : public FarRobotSteps {
  Q_OBJECT
 protected:
  std::unique_ptr<FarLine> makeLine() override {
    auto line = NetworkLine::make();
    if (line) return std::move(*line);
    QTest::qSkip(line.error().text.c_str(), __FILE__, __LINE__);
    return nullptr;
  }

 private Q_SLOTS:
  void robotsThatAnnounceThemselvesAreListed() {
    const auto line = makeLine();
    if (!line) return;
    const FarRobot robot(*line, home_ / "robot",
                         {"sim", ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf"});
    QVERIFY(!robot.url().empty());
    const std::string known =
        robot.url() + "  red1 (ers210, layout compact)  fingerprint " + robot.fingerprint() + "\n";
    std::string listed;
    QVERIFY2(eventually([&] {
               FarProgram desk({}, home_ / "desk", {"robots", "--seconds", "1"});
               if (desk.program().wait() != 0) return false;
               listed = desk.program().text();
               return listed == known;
             }),
             listed.c_str());
    // Not while the cable is out.
    line->unplug(true);
    FarProgram desk({}, home_ / "desk", {"robots", "--seconds", "1"});
    desk.program().wait();
    QCOMPARE(desk.program().text(), std::string());
  }
};

const widgets::test::GuiTest<FarNetworksGuiTest> kFarNetworksGuiTest;

}  // namespace app::test

#include "FarNetworksGuiTest.moc"
