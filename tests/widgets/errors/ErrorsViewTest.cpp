// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/errors/ErrorsView.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>
#include <set>

#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/Bench.h"

namespace widgets::test {
namespace {

/// A robot of a simulation that believes to be 0.1 m beside where it is.
struct Wrong : Bench {
  Wrong() : Bench({.answers = true}) {
    commands.add({.name = "plots.add",
                  .help = "Plots",
                  .arguments = {{"source"}},
                  .run = [this](const auto& values) -> robotlink::Result<void> {
                    plotted.push_back(std::get<std::string>(values[0]));
                    return {};
                  }});
  }
  void frame(double time, double error = 0.1, const std::string& path = "models/pose") {
    const robotlink::Instant at(robotlink::fromSeconds(time));
    robotcontrol::RobotPose pose;
    robotlink::assign(*pose.mutable_timestamp(), at);
    robotlink::assign(*pose.mutable_robot_in_field(), robotlink::Pose2{error, 0, 0});
    push("red1/" + path, pose, time);
    robotcontrol::OracleWorld truth;
    robotlink::assign(*truth.mutable_timestamp(), at);
    robotlink::assign(*truth.mutable_robot_in_field(), robotlink::Pose2{});
    push("red1/oracle/world", truth, time);
  }
  void pushSolution(const char* active, double time) {
    robotcontrol::SolutionTable table;
    auto& task = *table.add_tasks();
    task.set_name("self-localization");
    task.set_active(active);
    for (const char* name : {"particles", "odometry"}) {
      auto& solution = *task.add_solutions();
      solution.set_name(name);
      solution.add_outputs("models/pose");
    }
    push("red1/tables/solutions", table, time);
  }
  /// Until the table follows.
  void settle() {
    for (int i = 0; i < 12; ++i) tick(*view);
  }
  /// The cells of the row with these texts in the first columns.
  QString cell(const char* solution, const char* quantity, int column) const {
    for (int row = 0; row < table.model()->rowCount(); ++row) {
      const auto text = [&](int of) { return table.model()->index(row, of).data().toString(); };
      if (text(ErrorModel::kSolution) == QLatin1String(solution) &&
          text(ErrorModel::kError) == QLatin1String(quantity))
        return text(column);
    }
    return {};
  }
  QString hint() const { return child<QLabel>(*view, "emptyHint").text(); }

  std::vector<std::string> plotted;
  std::unique_ptr<ErrorsView> view = open<ErrorsView>({900, 300});
  QTableView& table = child<QTableView>(*view, "errorsTable");
  QAbstractItemModelTester tester{table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal};
};

}  // namespace

class ErrorsViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void switchesOnWhatItCompares() {
    Wrong bench;
    robotcontrol::KeyTable keys;
    for (const char* name : {"package/oracle/world", "package/models/pose", "package/models/ball", "other"})
      keys.add_keys()->set_name(name);
    bench.push("red1/tables/keys", keys, 1);
    bench.settle();
    std::set<std::string> asked;
    for (const auto& request : bench.requests) asked.insert(request.set_key().name());
    QVERIFY((asked ==
             std::set<std::string>{"package/oracle/world", "package/models/pose", "package/models/ball"}));
    QVERIFY(bench.hint().contains(QStringLiteral("while the robot's program runs")));
  }

  void aRobotWithoutATruthSaysSo() {
    Wrong bench;
    bench.push("red1/tables/keys", robotcontrol::KeyTable(), 1);
    bench.settle();
    QVERIFY2(bench.hint().contains(QStringLiteral("no ground truth")), qPrintable(bench.hint()));
    QVERIFY(!child<QToolButton>(*bench.view, "errorsReset").isEnabled());
    bench.session.setRobots({});
    bench.settle();
    QVERIFY(bench.hint().contains(QStringLiteral("No robot")));
  }

  void figuresAreThoseOfEachSolutionAlsoAfterReset() {
    Wrong bench;
    bench.pushSolution("particles", 1);
    bench.frame(1, 0.1);
    bench.frame(2, 0.3);
    bench.pushSolution("odometry", 3);
    bench.frame(3, 0.5);
    bench.frame(3.04, 0.7, "shadow/particles/models/pose");
    bench.frame(3.08, 0.5);
    bench.settle();
    QCOMPARE(bench.cell("particles", "position", ErrorModel::kMean), QStringLiteral("200.0"));
    QCOMPARE(bench.cell("odometry", "position", ErrorModel::kMean), QStringLiteral("500.0"));
    QCOMPARE(bench.cell("particles (shadow)", "position", ErrorModel::kMean), QStringLiteral("700.0"));
    QVERIFY(bench.hint().isEmpty());
    keepPicture(*bench.view, "errors");
    click(*bench.view, "errorsReset");
    QCOMPARE(bench.table.model()->rowCount(), 0);
    bench.frame(4, 0.4);
    bench.settle();
    QCOMPARE(bench.cell("odometry", "position", ErrorModel::kMean), QStringLiteral("400.0"));
    QCOMPARE(bench.cell("odometry", "position", ErrorModel::kSamples), QStringLiteral("1"));
  }

  void aResetOfTheSimulationStartsOver() {
    Wrong bench;
    bench.pushSolution("particles", 1);
    for (int i = 1; i <= 5; ++i) bench.frame(i, 0.1);
    bench.settle();
    QCOMPARE(bench.cell("particles", "position", ErrorModel::kSamples), QStringLiteral("5"));
    bench.frame(0.5, 0.2);
    bench.settle();
    QCOMPARE(bench.cell("particles", "position", ErrorModel::kSamples), QStringLiteral("1"));
    QCOMPARE(bench.cell("particles", "position", ErrorModel::kMax), QStringLiteral("200.0"));
  }

  void anotherRobotHasItsOwnFigures() {
    Wrong bench;
    bench.frame(1);
    bench.settle();
    QCOMPARE(bench.table.model()->rowCount(), 2);
    bench.session.selectRobot("blue1");
    bench.tick(*bench.view);
    QCOMPARE(bench.table.model()->rowCount(), 0);
    bench.session.selectRobot("red1");
    bench.tick(*bench.view);
    QCOMPARE(bench.table.model()->rowCount(), 2);
  }

  void theChosenErrorIsPlotted() {
    Wrong bench;
    bench.frame(1);
    bench.settle();
    auto& plot = child<QToolButton>(*bench.view, "errorsPlot");
    QVERIFY(!plot.isEnabled());
    bench.table.setFocus();
    bench.table.setCurrentIndex(bench.table.model()->index(0, 0));
    QVERIFY(plot.isEnabled());
    QTest::keyClick(&bench.table, Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(bench.plotted.size(), std::size_t{1});
    QVERIFY(bench.plotted[0].find("red1/models/pose") != std::string::npos);
  }

  void theTableIsCopiedFilteredAndSaved() {
    Wrong bench;
    bench.frame(1);
    bench.settle();
    child<QLineEdit>(*bench.view, "errorsSearch").setText(QStringLiteral("heading"));
    QCOMPARE(bench.table.model()->rowCount(), 1);
    child<QLineEdit>(*bench.view, "errorsSearch").clear();
    click(*bench.view, "errorsCopy");
    QVERIFY(QApplication::clipboard()->text().contains(
        QStringLiteral("models/pose\t\tposition\tmm\t100.0\t100.0\t100.0\t100.0\t100.0\t1\t\t\t0.0")));
    const TestFolder folder;
    const QString file = QString::fromStdString((folder.path() / "errors.csv").string());
    QVERIFY(bench.view->saveTo(file));
    QFile saved(file);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QVERIFY(saved.readAll().contains("models/pose,,position,mm,100.0"));
  }
};

const GuiTest<ErrorsViewTest> kErrorsViewTest;

}  // namespace widgets::test

#include "ErrorsViewTest.moc"
