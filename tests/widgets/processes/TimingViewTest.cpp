// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/TimingView.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QToolButton>

#include "tests/widgets/Bench.h"

namespace widgets::test {

using robotcontrol::KeyMode;

namespace {

robotcontrol::StopwatchTimes times(double ball, double pose) {
  robotcontrol::StopwatchTimes result;
  auto add = [&](const char* task, const char* solution, double seconds) {
    auto& entry = *result.add_entries();
    entry.set_task(task);
    entry.set_solution(solution);
    entry.set_seconds(seconds);
  };
  add("ball-percept", "scan-lines", ball);
  add("pose", "particles", pose);
  add("", "", ball + pose);
  return result;
}

QString shownCell(const QTableView& table, const QString& task, int column) {
  for (int row = 0; row < table.model()->rowCount(); ++row) {
    if (table.model()->index(row, widgets::TimingModel::kTask).data().toString() == task) {
      return table.model()->index(row, column).data().toString();
    }
  }
  return {};
}

/// A bench with the view, whose model is watched.
struct Watched : Bench {
  std::unique_ptr<widgets::TimingView> view = open<widgets::TimingView>();
  QTableView& table = child<QTableView>(*view, "timingTable");
  QAbstractItemModelTester tester{table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal};
};

}  // namespace

class TimingViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void showsMinimumMeanMaximumRateAndShare() {
    Watched bench;
    const auto& table = bench.table;
    bench.push("red1/stopwatches/cognition", times(0.001, 0.003), 1.0);
    bench.push("red1/stopwatches/cognition", times(0.003, 0.005), 1.04);
    bench.tick(*bench.view);
    QCOMPARE(table.model()->rowCount(), 3);
    using Model = widgets::TimingModel;
    const QString ball = QStringLiteral("ball-percept");
    QCOMPARE(shownCell(table, ball, Model::kProcess), QStringLiteral("cognition"));
    QCOMPARE(shownCell(table, ball, Model::kSolution), QStringLiteral("scan-lines"));
    QCOMPARE(shownCell(table, ball, Model::kLast), QStringLiteral("3.000"));
    QCOMPARE(shownCell(table, ball, Model::kMean), QStringLiteral("2.000"));
    QCOMPARE(shownCell(table, ball, Model::kMinimum), QStringLiteral("1.000"));
    QCOMPARE(shownCell(table, ball, Model::kMax), QStringLiteral("3.000"));
    QCOMPARE(shownCell(table, ball, Model::kRate), QStringLiteral("25.0"));
    QCOMPARE(shownCell(table, ball, Model::kShare), QStringLiteral("5.00 %"));
    QCOMPARE(shownCell(table, QStringLiteral("frame"), Model::kMean), QStringLiteral("6.000"));
  }

  void theRateIsThatOfTheLastSecondsThoughTimesWereNotPublishedOrTheClockWentBack() {
    using Model = widgets::TimingModel;
    Model model;
    const auto at = [](double time) { return robotlink::Instant(robotlink::fromSeconds(time)); };
    const auto rate = [&] {
      model.update();
      return model.index(0, Model::kRate).data().toString();
    };
    // 10 Hz at first; then nobody measures for ten seconds; then 25 Hz, of which every second frame is told.
    for (std::uint64_t i = 1; i <= 10; ++i)
      model.add("cognition", i, at(0.1 * double(i)), times(0.001, 0.002));
    QCOMPARE(rate(), QStringLiteral("10.0"));
    for (std::uint64_t i = 0; i < 100; i += 2)
      model.add("cognition", 110 + i, at(11 + 0.04 * double(i)), times(0.001, 0.002));
    QCOMPARE(rate(), QStringLiteral("25.0"));
    // The simulation is reset.
    for (std::uint64_t i = 1; i <= 5; ++i)
      model.add("cognition", i, at(0.04 * double(i)), times(0.001, 0.002));
    QCOMPARE(rate(), QStringLiteral("25.0"));
  }

  void aSolutionThatDoesNotRunAnyMoreHasNoRateAndNoShare() {
    using Model = widgets::TimingModel;
    Model model;
    const auto at = [](double time) { return robotlink::Instant(robotlink::fromSeconds(time)); };
    model.add("cognition", 1, at(1), times(0.001, 0.002));
    model.add("cognition", 2, at(1.04), times(0.001, 0.002));
    robotcontrol::StopwatchTimes other = times(0.001, 0.002);
    other.mutable_entries(0)->set_solution("oracle");
    model.add("cognition", 3, at(1.08), other);
    model.update();
    QCOMPARE(model.index(0, Model::kSolution).data().toString(), QStringLiteral("scan-lines"));
    QCOMPARE(model.index(0, Model::kRate).data().toString(), QString());
    QCOMPARE(model.index(0, Model::kShare).data().toString(), QString());
    QCOMPARE(model.index(1, Model::kRate).data().toString(), QStringLiteral("25.0"));
  }

  void whatAnotherLayoutDoesNotHaveIsNotListedAnyMore() {
    Watched bench;
    const auto& table = bench.table;
    bench.push("red1/stopwatches/cognition", times(0.001, 0.002), 1);
    bench.push("red1/stopwatches/sensing", times(0.001, 0.002), 1);
    bench.tick(*bench.view);
    QCOMPARE(table.model()->rowCount(), 6);
    robotcontrol::ProcessTable program;
    auto& process = *program.add_processes();
    process.set_name("cognition");
    process.add_tasks("pose");
    bench.push("red1/tables/processes", program, 2);
    bench.tick(*bench.view);
    QCOMPARE(table.model()->rowCount(), 2);
    QCOMPARE(shownCell(table, QStringLiteral("pose"), widgets::TimingModel::kProcess),
             QStringLiteral("cognition"));
    QCOMPARE(shownCell(table, QStringLiteral("frame"), widgets::TimingModel::kProcess),
             QStringLiteral("cognition"));
  }

  void asksForTimesAndStopsAskingOnWish() {
    Bench bench;
    auto view = bench.open<widgets::TimingView>();
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests[0].set_key().name(), std::string("timing/tasks"));
    QCOMPARE(bench.requests[0].set_key().mode().kind(), KeyMode::ALWAYS);
    click(child<QToolButton>(*view, "timingMeasure"));
    QCOMPARE(bench.requests.back().set_key().mode().kind(), KeyMode::OFF);
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "emptyHint").text().contains(QStringLiteral("does not measure")));
  }

  void resetBeginsAnewAndTheTableIsCopied() {
    Bench bench;
    auto view = bench.open<widgets::TimingView>();
    bench.push("red1/stopwatches/cognition", times(0.5, 0.5), 1.0);
    bench.tick(*view);
    click(child<QToolButton>(*view, "timingReset"));
    bench.push("red1/stopwatches/cognition", times(0.001, 0.003), 1.04);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "timingTable");
    QCOMPARE(shownCell(table, QStringLiteral("pose"), widgets::TimingModel::kMax), QStringLiteral("3.000"));
    click(child<QToolButton>(*view, "timingCopy"));
    QVERIFY(
        QApplication::clipboard()->text().contains(QStringLiteral("cognition,pose,particles,3,3,3,3,0,0")));
  }

  void aClickOnAHeaderSorts() {
    Bench bench;
    auto view = bench.open<widgets::TimingView>();
    bench.push("red1/stopwatches/cognition", times(0.010, 0.009), 1.0);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "timingTable");
    auto& header = *table.horizontalHeader();
    const int x = header.sectionViewportPosition(widgets::TimingModel::kMean) + 10;
    QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, {x, header.height() / 2});
    const auto first = [&] { return table.model()->index(0, widgets::TimingModel::kTask).data().toString(); };
    const QString ascending = first();
    QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, {x, header.height() / 2});
    QCOMPARE(QSet<QString>({ascending, first()}),
             QSet<QString>({QStringLiteral("pose"), QStringLiteral("frame")}));
  }
};

const GuiTest<TimingViewTest> kTimingViewTest;

}  // namespace widgets::test

#include "TimingViewTest.moc"
