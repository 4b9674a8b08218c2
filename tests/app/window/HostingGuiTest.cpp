// SPDX-License-Identifier: GPL-3.0-or-later
// Where programs run and how they are executed, as a person chooses it in the window; and modules that never
// return, which keep neither the window nor its user.
#include <QToolButton>

#include "app/core/program/Abandoned.h"
#include "robotcontrol/Hosting.pb.h"
#include "tests/app/stuck/StuckSolution.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

using robotcontrol::HostingStatus;
using robotcontrol::HostProgram;

/// Where the program of red1 runs; null: not known yet.
const HostingStatus* hosting(Desk& desk) {
  return desk.workbench.session().store().latestAs<HostingStatus>("red1/hosting", robotlink::Instant::max());
}

/// A desk with a robot whose program has a module that never returns.
class StuckDesk : public EmptyDesk {
 public:
  explicit StuckDesk(const std::filesystem::path& home) : EmptyDesk(home) {
    StuckSolution::prepare(true);
    RunOptions options = defaultSimulation();
    options.layout = StuckSolution::writeLayout(home);
    workbench.open(SimulationFeed::opening(options));
  }
  void hang() {
    QTRY_VERIFY_WITH_TIMEOUT(loaded(), kWaitMs);
    QVERIFY(workbench.commands().runLine("simulation.start").has_value());
    QTRY_VERIFY_WITH_TIMEOUT(
        hosting(*this) != nullptr && hosting(*this)->state() == HostingStatus::NOT_ANSWERING, kWaitMs);
  }
};

/// Modules that hang return when a test is over. What they used is destroyed before the program ends, since
/// afterwards libraries such as Embree's are gone.
class LetGo {
 public:
  ~LetGo() {
    StuckSolution::release();
    const auto nothingIsLeft = [] { return abandonedCount() == 0; };
    if (!comes(nothingIsLeft)) QTest::qFail("modules still hang", __FILE__, __LINE__);
  }
};

}  // namespace

class HostingGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void howProcessesAreExecutedIsRememberedForTheNextStart() {
    {
      Desk desk(home_);
      QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && hosting(desk) != nullptr, kWaitMs);
      QVERIFY(!hosting(desk)->threads());
      robotcontrol::Request request;
      request.mutable_host_program()->set_executor(HostProgram::THREADS);
      desk.workbench.ask(request);
      QTRY_VERIFY_WITH_TIMEOUT(hosting(desk)->threads(), kWaitMs);
      QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(home_ / "hosting.json"), kWaitMs);
    }
    {
      // As a person finds it again, who has said nothing about it.
      EmptyDesk desk(home_);
      QVERIFY(desk.workbench.commands().run("simulation.open", {std::string("field2002")}).has_value());
      QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && hosting(desk) != nullptr, kWaitMs);
      QVERIFY(hosting(desk)->threads());
      robotcontrol::Request request;
      request.mutable_host_program()->set_executor(HostProgram::LOCKSTEP);
      desk.workbench.ask(request);
      QTRY_VERIFY_WITH_TIMEOUT(!hosting(desk)->threads(), kWaitMs);
    }
    EmptyDesk desk(home_);
    QVERIFY(desk.workbench.commands().run("simulation.open", {std::string("field2002")}).has_value());
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded() && hosting(desk) != nullptr, kWaitMs);
    QVERIFY(!hosting(desk)->threads());
  }

  void aModuleThatNeverReturnsDoesNotKeepTheWindow() {
    const LetGo letGo;
    {
      StuckDesk desk(home_);
      desk.hang();
      QVERIFY(hosting(desk)->text().find("hang") != std::string::npos);
      // STOP, other commands and closing work all the same.
      QTest::mouseClick(&desk.find<QToolButton>("stopButton"), Qt::LeftButton);
      QTRY_VERIFY_WITH_TIMEOUT(desk.status()->stopped_robots_size() == 1, kWaitMs);
      QSignalSpy closed(&desk.window, &MainWindow::closed);
      QVERIFY(desk.window.close());
      QCOMPARE(closed.count(), 1);
      QVERIFY(StuckSolution::hanging > 0);
    }
    // The module still hangs, and the workbench is gone.
    QVERIFY(StuckSolution::hanging > 0);
    QVERIFY(abandonedCount() > 0);
    StuckSolution::release();
    QTRY_COMPARE_WITH_TIMEOUT(abandonedCount(), 0, kWaitMs);
  }

  void anotherSceneIsOpenedAlthoughAModuleNeverReturns() {
    const LetGo letGo;
    StuckDesk desk(home_);
    desk.hang();
    desk.workbench.open(SimulationFeed::opening(defaultSimulation()));
    QTRY_VERIFY_WITH_TIMEOUT(!desk.workbench.loading(), kWaitMs);
    QVERIFY(StuckSolution::hanging > 0);
    QTRY_VERIFY_WITH_TIMEOUT(hosting(desk) != nullptr && hosting(desk)->state() == HostingStatus::RUNNING,
                             kWaitMs);
  }
};

const widgets::test::GuiTest<HostingGuiTest> kHostingGuiTest;

}  // namespace app::test

#include "HostingGuiTest.moc"
