// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/joints/JointsView.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>

#include "tests/widgets/motions/MotionBenchSetup.h"
#include "widgets/joints/JointSlider.h"

namespace widgets::test {

using robotcontrol::MotionRequest;

namespace {

QString cellOf(const QWidget& view, int row, int column) {
  const auto& table = child<QTableView>(view, "jointsTable");
  return table.model()->index(row, column).data().toString();
}

}  // namespace

class JointsViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void anglesSpeedAndLoadOfAllJointsAreShown() {
    JointBench bench;
    bench.publishJoints(30, 32);
    auto view = bench.open<JointsView>({900, 400});
    auto& table = child<QTableView>(*view, "jointsTable");
    const QAbstractItemModelTester tester(table.model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(table.model()->rowCount(), 3);
    QCOMPARE(cellOf(*view, 1, JointsModel::kName), QStringLiteral("legFL1"));
    QCOMPARE(cellOf(*view, 1, JointsModel::kRequested), QStringLiteral("32.0"));
    QCOMPARE(table.model()->headerData(JointsModel::kSpeed, Qt::Horizontal).toString(),
             QStringLiteral("Speed, °/s"));
    QCOMPARE(cellOf(*view, 1, JointsModel::kMeasured), QStringLiteral("30.0"));
    QCOMPARE(cellOf(*view, 1, JointsModel::kError), QStringLiteral("2.0"));
    QCOMPARE(cellOf(*view, 1, JointsModel::kSpeed), QStringLiteral("28.6"));
    QCOMPARE(cellOf(*view, 1, JointsModel::kLoad), QStringLiteral("0.125"));
    QCOMPARE(cellOf(*view, 1, JointsModel::kLimits), QStringLiteral("-45.0 … 90.0"));
    for (int i = 0; i < 40; ++i) bench.publishJoints(i, i);
    bench.tick(*view);
    QCOMPARE(cellOf(*view, 0, JointsModel::kMeasured), QStringLiteral("39.0"));
    QCoreApplication::processEvents();
    keepPicture(*view, "joints");
  }

  void theTimelineShowsAnEarlierInstant() {
    JointBench bench;
    bench.publishJoints(10, 10);
    const auto earlier = robotlink::Instant(robotlink::fromSeconds(bench.time));
    bench.publishJoints(20, 20);
    auto view = bench.open<JointsView>();
    QCOMPARE(cellOf(*view, 0, JointsModel::kMeasured), QStringLiteral("20.0"));
    bench.session.timeline().show(earlier);
    bench.tick(*view);
    QCOMPARE(cellOf(*view, 0, JointsModel::kMeasured), QStringLiteral("10.0"));
  }

  void slidersAreGrayUntilTheRobotIsTakenOver() {
    JointBench bench;
    bench.publishJoints(0, 0);
    auto view = bench.open<JointsView>({900, 400});
    auto& slider = child<JointSlider>(*view, "joint-legFL1");
    QVERIFY(!slider.isEnabled());
    QVERIFY(!child<QToolButton>(*view, "jointsLimp").isEnabled());
    click(*view, "jointsTakeOver");
    QVERIFY(std::ranges::any_of(bench.requests, [](const auto& r) { return r.has_select_solution(); }));
    bench.publishBehavior("obey");
    bench.tick(*view);
    QVERIFY(slider.isEnabled());
    QVERIFY(child<QToolButton>(*view, "jointsTakeOver").isChecked());
  }

  void aSliderTurnsItsJointAndTheOthersHold() {
    JointBench bench;
    bench.publishJoints(0, 0);
    bench.takeOver();
    auto view = bench.open<JointsView>({1000, 400});
    bench.tick(*view);
    QCoreApplication::processEvents();  // the columns get their widths
    auto& slider = child<JointSlider>(*view, "joint-legFL1");
    QTest::mouseClick(&slider, Qt::LeftButton, {}, {slider.width() - 5, slider.height() / 2});
    bench.tick(*view);
    MotionRequest motion = bench.commanded();
    QCOMPARE(motion.kind(), MotionRequest::JOINTS);
    QCOMPARE(motion.joints_size(), 1);
    QCOMPARE(motion.joints(0).name(), std::string("legFL1"));
    QVERIFY(std::abs(motion.joints(0).position() - robotlink::radians(90)) < 0.01);
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_Left);
    bench.tick(*view);
    QVERIFY(std::abs(bench.commanded().joints(0).position() - robotlink::radians(89)) < 0.01);
    // The slider stays where it was put although the robot is not there yet.
    QCOMPARE(slider.value(), 890);
    click(*view, "jointsStand");
    bench.tick(*view);
    QCOMPARE(bench.commanded().kind(), MotionRequest::STAND);
    bench.tick(*view);
    QCOMPARE(slider.value(), 0);
  }

  void anAngleIsTypedAndStaysWithinTheLimits() {
    JointBench bench;
    bench.publishJoints(0, 0);
    bench.takeOver();
    auto view = bench.open<JointsView>({900, 400});
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "jointsTable");
    table.setCurrentIndex(table.model()->index(2, JointsModel::kRequested));
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_F2);
    auto* editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    QVERIFY(editor != nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("-200"));
    QTest::keyClick(editor, Qt::Key_Return);
    QCoreApplication::processEvents();  // the editor commits later
    bench.tick(*view);
    QCOMPARE(bench.commanded().joints(0).name(), std::string("legFR1"));
    QVERIFY(std::abs(bench.commanded().joints(0).position() - robotlink::radians(-45)) < 1e-9);
  }

  void limpJointsAreReleasedAndHoldWhereTheyAreAfterwards() {
    JointBench bench;
    bench.publishJoints(0, 0);
    bench.takeOver();
    auto view = bench.open<JointsView>();
    bench.tick(*view);
    click(*view, "jointsLimp");
    bench.tick(*view);
    QVERIFY(bench.commanded().limp());
    QCOMPARE(child<QLabel>(*view, "jointsState").text(),
             QStringLiteral("All joints are limp: pose the robot by hand."));
    click(*view, "jointsLimp");
    bench.tick(*view);
    QCOMPARE(bench.commanded().kind(), MotionRequest::JOINTS);
    QVERIFY(!bench.commanded().limp());
    QCOMPARE(bench.commanded().joints_size(), 0);
  }

  void poseBecomesAKeyFrameOfTheMotionInTheEditor() {
    JointBench bench;
    bench.publishJoints(12.34, 20);
    auto view = bench.open<JointsView>({900, 400});
    child<QSpinBox>(*view, "jointsDuration").setValue(250);
    click(*view, "jointsCapture");
    QCOMPARE(bench.bench().motion().name, std::string("taught"));
    QCOMPARE(bench.row(5), std::string("  12.3  12.3  12.3 1 250"));
    child<QComboBox>(*view, "jointsSource").setCurrentIndex(1);
    click(*view, "jointsCapture");
    QCOMPARE(bench.row(6), std::string("    20    20    20 1 250"));
    QCOMPARE(child<QLabel>(*view, "jointsOutcome").text(), QStringLiteral("Key frame 2 of taught added"));
    QVERIFY(bench.bench().errors().empty());
    bench.bench().undoStack().undo();
    QCOMPARE(bench.bench().frames().size(), std::size_t{1});
  }

  void robotsWithoutJointsSaySo() {
    JointBench bench;
    bench.session.selectRobot("blue1");
    auto view = bench.open<JointsView>();
    QCOMPARE(child<QTableView>(*view, "jointsTable").model()->rowCount(), 0);
    QVERIFY(!child<QToolButton>(*view, "jointsTakeOver").isEnabled());
    QVERIFY(!child<QToolButton>(*view, "jointsCapture").isEnabled());
    QCOMPARE(bench.refusal("joints.capture"), std::string("joints.none"));
    QCOMPARE(bench.refusal("joints.set legFL1 0.1"), std::string("robot.not-taken"));
  }

  void jointsOfLogsOfOtherProgramsAreShownWithoutLimits() {
    JointBench bench;
    bench.session.setRobots({});
    foxglove::JointStates states;
    for (const char* name : {"elbow", "wrist"}) states.add_joints()->set_name(name);
    states.mutable_joints(0)->set_position(robotlink::radians(90));
    bench.push("/arm", states, ++bench.time);
    states.mutable_joints()->RemoveLast();
    bench.push("/hand", states, ++bench.time);
    auto view = bench.open<JointsView>({900, 400});
    auto& table = child<QTableView>(*view, "jointsTable");
    const QAbstractItemModelTester tester(table.model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(table.model()->rowCount(), 2);
    QCOMPARE(cellOf(*view, 0, JointsModel::kName), QStringLiteral("elbow"));
    QCOMPARE(cellOf(*view, 0, JointsModel::kMeasured), QStringLiteral("90.0"));
    QCOMPARE(cellOf(*view, 0, JointsModel::kLimits), QStringLiteral("–"));
    QVERIFY(!child<QToolButton>(*view, "jointsTakeOver").isEnabled());
    QVERIFY(!child<QToolButton>(*view, "jointsCapture").isEnabled());
    QVERIFY(view->findChildren<JointSlider*>().isEmpty());
    auto& streams = child<QComboBox>(*view, "jointsStream");
    QVERIFY(streams.isVisible());
    streams.setFocus();
    QTest::keyClick(&streams, Qt::Key_Down);
    QCOMPARE(streams.currentText(), QStringLiteral("/hand"));
    QCOMPARE(table.model()->rowCount(), 1);
    bench.session.setRobots({"red1"});
    bench.tick(*view);
    QVERIFY2(!streams.isVisible(), "the robot has joints of its own");
    QCOMPARE(table.model()->rowCount(), 3);
  }

  void aLogWithoutJointsSaysSo() {
    JointBench bench;
    bench.session.setRobots({});
    bench.push("/rosout", foxglove::Log(), ++bench.time);
    auto view = bench.open<JointsView>();
    const auto& hint = child<QLabel>(child<QTableView>(*view, "jointsTable"), "emptyHint");
    QVERIFY2(hint.text().contains(QStringLiteral("no joints up to this time")), qPrintable(hint.text()));
  }

  void commandsTurnJointsWithinTheirLimits() {
    JointBench bench;
    QCOMPARE(bench.refusal("joints.set legFL1 0.5"), std::string("robot.not-taken"));
    bench.takeOver();
    QCOMPARE(bench.refusal("joints.set legFL1 0.5"), std::string());
    QCOMPARE(bench.refusal("joints.set headPan -0.25"), std::string());
    bench.step();
    QCOMPARE(bench.commanded().joints_size(), 2);
    QCOMPARE(bench.refusal("joints.set legFL1 3"), std::string("robot.joint"));
    QCOMPARE(bench.refusal("joints.set tail 0"), std::string("robot.joint"));
    QCOMPARE(bench.refusal("joints.limp"), std::string());
    bench.step();
    QVERIFY(bench.commanded().limp());
    QCOMPARE(bench.refusal("robot.walk 0.1"), std::string());
    bench.step();
    QCOMPARE(bench.commanded().kind(), MotionRequest::WALK);
    bench.publishJoints(5, 6);
    bench.step();
    QCOMPARE(bench.refusal("joints.capture 100 requested"), std::string());
    QCOMPARE(bench.row(5), std::string("     6     6     6 1 100"));
    QCOMPARE(bench.refusal("joints.capture 0"), std::string("joints.duration"));
  }

  void theTableIsSavedAsCsv() {
    JointBench bench;
    bench.publishJoints(1, 2);
    auto view = bench.open<JointsView>();
    const auto file = bench.folder / "joints.csv";
    QVERIFY(view->saveTo(QString::fromStdString(file.string())).has_value());
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    std::getline(in, line);
    QCOMPARE(line, std::string("headPan,2.0,1.0,1.0,28.6,0.125"));
  }
};

const GuiTest<JointsViewTest> kJointsViewTest;

}  // namespace widgets::test

#include "JointsViewTest.moc"
