// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/ProcessesView.h"

#include <QAbstractItemModelTester>
#include <QHelpEvent>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QToolTip>

#include "tests/widgets/Bench.h"
#include "widgets/processes/ProcessGraphWidget.h"
#include "widgets/processes/TableGraph.h"

namespace widgets::test {

using robotcontrol::ProcessTable;

namespace {

ProcessTable::Process& addProcess(ProcessTable& table, const char* name, std::uint64_t frames) {
  auto& process = *table.add_processes();
  process.set_name(name);
  process.set_state("running");
  process.set_frames(frames);
  if (std::string(name) != "platform") process.add_tasks(std::string(name) + "-task");
  return process;
}

void link(ProcessTable& table, int from, int to, const char* package, std::uint64_t count, bool blocking,
          std::uint64_t missed = 0) {
  auto& sender = *table.mutable_processes(from)->add_senders();
  sender.set_package(package);
  sender.set_count(count);
  auto& receiver = *table.mutable_processes(to)->add_receivers();
  receiver.set_package(package);
  receiver.set_count(count - missed);
  receiver.set_missed(missed);
  receiver.set_blocking(blocking);
  receiver.set_peer(table.processes(from).name());
}

/// platform -> cognition -> motion -> platform, and a debug process.
ProcessTable someProcesses(std::uint64_t n) {
  ProcessTable table;
  addProcess(table, "platform", 5 * n);
  addProcess(table, "cognition", n);
  addProcess(table, "motion", 5 * n);
  addProcess(table, "debug", n);
  link(table, 0, 1, "camera/image", n, true);
  link(table, 1, 2, "behavior/motion", n, false, n / 5);
  link(table, 2, 0, "joints/request", 5 * n, false);
  link(table, 1, 3, "debug/queue/cognition", n, false);
  return table;
}

}  // namespace

class ProcessesViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void thePictureKnowsWhichPackagesAreHeld() {
    auto table = someProcesses(10);
    table.mutable_processes(1)->mutable_senders(0)->set_held(true);
    const ProcessGraph graph = processGraph(table, nullptr, {}, {});
    QVERIFY(graph.nodes[1].outputs[0].held);
    QVERIFY(!graph.nodes[2].inputs[0].held);
  }

  void dataFlowFromLeftToRightAndCyclesAreTurned() {
    const ProcessGraph graph = widgets::processGraph(someProcesses(10), nullptr, {}, {});
    const auto rect = [&](const char* name) {
      return graph.nodes[static_cast<std::size_t>(graph.find(QString::fromLatin1(name)))].rect;
    };
    QVERIFY(rect("platform").right() < rect("cognition").left());
    QVERIFY(rect("cognition").right() < rect("motion").left());
    QCOMPARE(graph.edges.size(), std::size_t{3});
    QCOMPARE(
        std::count_if(graph.edges.begin(), graph.edges.end(), [](const auto& edge) { return edge.back; }), 1);
    for (std::size_t a = 0; a < graph.nodes.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) QVERIFY(!graph.nodes[a].rect.intersects(graph.nodes[b].rect));
    }
  }

  void aProgramThatEndedSaysWhatHappenedAndIsStartedAgainByAClick() {
    Bench bench;
    auto view = bench.open<widgets::ProcessesView>({900, 600});
    QVERIFY(!child<QWidget>(*view, "hostingBar").isVisible());
    robotcontrol::HostingStatus status;
    status.set_own_process(true);
    status.set_pid(4711);
    bench.push("red1/hosting", status, 1);
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "hostingText").text().contains(QStringLiteral("gdb -p 4711")));
    QVERIFY(!child<QWidget>(*view, "hostingStack").isVisible());
    QVERIFY(child<QToolButton>(*view, "hostingOwn").isChecked());
    status.set_state(robotcontrol::HostingStatus::ENDED);
    status.set_text("The program of red1 crashed in ball-percept (region).");
    status.set_stack("Ball::find()");
    bench.push("red1/hosting", status, 2);
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "hostingText").text().contains(QStringLiteral("crashed in ball-percept")));
    QVERIFY(child<QWidget>(*view, "hostingStack").isVisible());
    click(child<QToolButton>(*view, "hostingStartAgain"));
    QVERIFY(bench.requests.back().host_program().start_again());
    QCOMPARE(bench.requests.back().robot(), std::string("red1"));
    click(child<QToolButton>(*view, "hostingOwn"));
    QCOMPARE(bench.requests.back().host_program().where(), robotcontrol::HostProgram::IN_WORKBENCH);
    bench.tick(*view);
    // Until the robot reports that it is so.
    QVERIFY(child<QToolButton>(*view, "hostingOwn").isChecked());
    click(child<QToolButton>(*view, "hostingThreads"));
    QCOMPARE(bench.requests.back().host_program().executor(), robotcontrol::HostProgram::THREADS);
    QCOMPARE(bench.requests.back().robot(), std::string());  // all robots
    status.Clear();
    status.set_threads(true);
    bench.push("red1/hosting", status, 3);
    bench.tick(*view);
    QVERIFY(child<QToolButton>(*view, "hostingThreads").isChecked());
    QVERIFY(child<QLabel>(*view, "hostingText").text().contains(QStringLiteral("its own thread")));
  }

  void whatDoesNotBlockFollowsTheOrderOfTheLayout() {
    ProcessTable table;
    addProcess(table, "cognition", 1);
    addProcess(table, "motion", 1);
    link(table, 1, 0, "motion/status", 1, false);
    link(table, 0, 1, "behavior/motion", 1, false);
    const ProcessGraph graph = widgets::processGraph(table, nullptr, {}, {});
    QVERIFY(graph.nodes[0].rect.right() < graph.nodes[1].rect.left());
  }

  void ratesFollowFromTwoTables() {
    const ProcessGraph graph = widgets::processGraph(someProcesses(60),
                                                     [] {
                                                       static const auto before = someProcesses(10);
                                                       return &before;
                                                     }(),
                                                     std::chrono::seconds(2), {});
    const auto& cognition = graph.nodes[static_cast<std::size_t>(graph.find(QStringLiteral("cognition")))];
    QCOMPARE(cognition.rate, 25.0);
    QCOMPARE(cognition.inputs[0].rate, 25.0);
    const auto& motion = graph.nodes[static_cast<std::size_t>(graph.find(QStringLiteral("motion")))];
    QCOMPARE(motion.inputs[0].missedRate, 5.0);
    QCOMPARE(motion.missed(), quint64{12});
  }

  void onlyAProcessThatDoesNotKeepUpWithWhatItWaitsForIsWarnedOf() {
    // Joints come with 125 Hz and images with 25 Hz; cognition waits for both, motion for joints, the logger
    // has a period.
    const auto table = [](std::uint64_t n, std::uint64_t motionMisses) {
      ProcessTable all;
      addProcess(all, "platform", 5 * n);
      addProcess(all, "cognition", n);
      addProcess(all, "motion", 5 * n);
      addProcess(all, "logger", n).set_period(0.04);
      link(all, 0, 1, "camera/image", n, true);
      link(all, 0, 1, "joints/states", 5 * n, true, 4 * n);
      link(all, 0, 2, "joints/states", 5 * n, true, motionMisses);
      link(all, 0, 3, "joints/states", 5 * n, true, 4 * n);
      link(all, 1, 2, "behavior/motion", n, false, n / 2);
      return all;
    };
    const auto falls = [](const ProcessTable& before, const ProcessTable& now) {
      QStringList names;
      for (const auto& node : widgets::processGraph(now, &before, std::chrono::seconds(2), {}).nodes) {
        if (node.fallsBehind()) names << node.name;
      }
      return names;
    };
    QCOMPARE(falls(table(10, 0), table(60, 0)), QStringList());
    QCOMPARE(falls(table(10, 0), table(60, 50)), QStringList{QStringLiteral("motion")});
  }

  void theTableAndTheGraphChooseTheSameProcess() {
    Bench bench;
    auto view = bench.open<widgets::ProcessesView>({900, 600});
    bench.push("red1/tables/processes", someProcesses(10), 1);
    bench.push("red1/tables/processes", someProcesses(60), 3);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "processesTable");
    QAbstractItemModelTester tester(table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(table.model()->index(1, widgets::ProcessTableModel::kRate).data().toString(),
             QStringLiteral("25.0"));
    auto& graph = child<widgets::ProcessGraphWidget>(*view, "processGraph");
    QTest::mouseClick(&graph, Qt::LeftButton, {},
                      graph.nodeRect(QStringLiteral("motion")).center().toPoint());
    QCOMPARE(table.currentIndex().row(), 2);
    const QImage before = graph.grab().toImage();
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualRect(table.model()->index(1, 0)).center());
    QVERIFY(graph.grab().toImage() != before);
  }

  void zoomPanAndFit() {
    Bench bench;
    auto view = bench.open<widgets::ProcessesView>({900, 600});
    bench.push("red1/tables/processes", someProcesses(10), 1);
    bench.tick(*view);
    auto& graph = child<widgets::ProcessGraphWidget>(*view, "processGraph");
    const double fitted = graph.scale();
    click(child<QToolButton>(*view, "processesZoomIn"));
    QVERIFY(graph.scale() > fitted);
    const QRectF before = graph.nodeRect(QStringLiteral("motion"));
    QTest::mousePress(&graph, Qt::MiddleButton, {}, {100, 100});
    QMouseEvent move(QEvent::MouseMove, QPointF(130, 90), Qt::NoButton, Qt::MiddleButton, {});
    QCoreApplication::sendEvent(&graph, &move);
    QCOMPARE(graph.nodeRect(QStringLiteral("motion")).topLeft() - before.topLeft(), QPointF(30, -10));
    QTest::keyClick(&graph, Qt::Key_F);
    QCOMPARE(graph.scale(), fitted);
    QTest::keyClick(&graph, Qt::Key_Plus);
    QVERIFY(graph.scale() > fitted);
    QTest::keyClick(&graph, Qt::Key_Minus);
    const QPointF place = graph.nodeRect(QStringLiteral("motion")).topLeft();
    for (const int key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Up}) QTest::keyClick(&graph, Qt::Key(key));
    QCOMPARE(graph.nodeRect(QStringLiteral("motion")).topLeft() - place, QPointF(40, 80));
    for (const int key : {Qt::Key_Right, Qt::Key_Down, Qt::Key_Down}) QTest::keyClick(&graph, Qt::Key(key));
    QCOMPARE(graph.nodeRect(QStringLiteral("motion")).topLeft(), place);
    click(child<QToolButton>(*view, "processesZoomOut"));
    QVERIFY(graph.scale() < fitted);
    click(child<QToolButton>(*view, "processesFit"));
    QCOMPARE(graph.scale(), fitted);
  }

  void theTableIsHiddenOnWish() {
    Bench bench;
    auto view = bench.open<widgets::ProcessesView>({900, 600});
    auto& table = child<QTableView>(*view, "processesTable");
    QVERIFY(table.isVisible());
    click(child<QToolButton>(*view, "processesDetails"));
    QVERIFY(!table.isVisible());
    click(child<QToolButton>(*view, "processesDetails"));
    QVERIFY(table.isVisible());
  }

  void aFailedProcessIsRedAndItsRowSaysWhy() {
    Bench bench;
    auto view = bench.open<widgets::ProcessesView>({900, 600});
    ProcessTable table = someProcesses(10);
    bench.push("red1/tables/processes", table, 1);
    bench.tick(*view);
    auto& graph = child<widgets::ProcessGraphWidget>(*view, "processGraph");
    const QImage before = graph.grab().toImage();
    table.mutable_processes(1)->set_state("failed: division by zero");
    bench.push("red1/tables/processes", table, 2);
    bench.tick(*view);
    QVERIFY(graph.grab().toImage() != before);
    auto& rows = child<QTableView>(*view, "processesTable");
    QCOMPARE(rows.model()->index(1, widgets::ProcessTableModel::kState).data().toString(),
             QStringLiteral("failed: division by zero"));
    const QPoint at = graph.nodeRect(QStringLiteral("cognition")).topLeft().toPoint() + QPoint(20, 8);
    QHelpEvent help(QEvent::ToolTip, at, graph.mapToGlobal(at));
    QCoreApplication::sendEvent(&graph, &help);
    QVERIFY(QToolTip::text().contains(QStringLiteral("division by zero")));
    QToolTip::hideText();
  }

  void aBlockingOutputEndsAtABarAndSaysSo() {
    Bench bench;
    auto view = bench.open<widgets::ProcessesView>({900, 600});
    ProcessTable table = someProcesses(10);
    bench.push("red1/tables/processes", table, 1);
    bench.tick(*view);
    auto& graph = child<widgets::ProcessGraphWidget>(*view, "processGraph");
    const QImage before = graph.grab().toImage();
    table.mutable_processes(1)->mutable_senders(0)->set_blocking(true);
    bench.push("red1/tables/processes", table, 1);
    bench.tick(*view);
    const auto& cognition =
        graph.graph().nodes[static_cast<std::size_t>(graph.graph().find(QStringLiteral("cognition")))];
    const auto output =
        std::find_if(cognition.outputs.begin(), cognition.outputs.end(),
                     [](const auto& port) { return port.package == QStringLiteral("behavior/motion"); });
    QVERIFY(output != cognition.outputs.end() && output->blocking);
    QVERIFY(graph.grab().toImage() != before);
    // From places in the graph to those in the widget, as the node is drawn.
    const QRectF node = graph.nodeRect(QStringLiteral("cognition"));
    const double scale = node.width() / cognition.rect.width();
    const QPoint at = (node.topLeft() + (output->rect.center() - cognition.rect.topLeft()) * scale).toPoint();
    QHelpEvent help(QEvent::ToolTip, at, graph.mapToGlobal(at));
    QCoreApplication::sendEvent(&graph, &help);
    QVERIFY2(QToolTip::text().contains(QStringLiteral("waits until all receivers have taken it")),
             qPrintable(QToolTip::text()));
    QToolTip::hideText();
  }

  void debugLinksAreShownOnWish() {
    Bench bench;
    auto view = bench.open<widgets::ProcessesView>({900, 600});
    bench.push("red1/tables/processes", someProcesses(10), 1);
    bench.tick(*view);
    auto& graph = child<widgets::ProcessGraphWidget>(*view, "processGraph");
    QCOMPARE(graph.graph().edges.size(), std::size_t{3});
    click(child<QToolButton>(*view, "processesDebugLinks"));
    QCOMPARE(graph.graph().edges.size(), std::size_t{4});
    click(child<QToolButton>(*view, "processesRefresh"));
    QVERIFY(bench.requests.back().has_send_tables());
  }
};

const GuiTest<ProcessesViewTest> kProcessesViewTest;

}  // namespace widgets::test

#include "ProcessesViewTest.moc"
