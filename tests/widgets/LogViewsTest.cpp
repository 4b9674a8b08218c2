// SPDX-License-Identifier: GPL-3.0-or-later
// The lists of streams and of packages, and the models behind them.
#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>

#include "tests/widgets/FieldBench.h"
#include "tests/widgets/LogBench.h"
#include "widgets/log/ReplayPackagesView.h"
#include "widgets/log/TimeScale.h"
#include "widgets/streams/StreamsView.h"

namespace widgets::test {

using robotcontrol::ControlReplay;

namespace {

QModelIndex cell(const QTableView& table, const QString& first, int column) {
  const auto* model = table.model();
  for (int row = 0; row < model->rowCount(); ++row) {
    if (model->index(row, 0).data().toString() == first) return model->index(row, column);
  }
  return {};
}

void addPackages(robotcontrol::ReplayStatus& status) {
  const auto add = [&](const char* name, bool logged, bool can, ControlReplay::PackageSource source,
                       bool chosen, const char* why = "") {
    auto& package = *status.add_packages();
    package.set_package(name);
    package.set_logged(logged);
    package.set_can_recompute(can);
    package.set_source(source);
    package.set_chosen(chosen);
    package.set_why_not(why);
  };
  add("nao/camera/image", true, false, ControlReplay::AS_LOGGED, false, "a robot's sensor yields it");
  add("nao/percepts/ball", true, true, ControlReplay::AS_LOGGED, false);
  add("nao/models/ball", true, true, ControlReplay::RECOMPUTED, true);
  auto& difference = *status.add_differences();
  difference.set_package("nao/models/ball");
  difference.set_compared(120);
  difference.set_different(7);
  difference.set_only_logged(2);
  difference.set_first_time(at(17.5).time_since_epoch().count());
  difference.set_largest_field("position_in_robot.x");
  difference.set_largest(0.25);
  difference.set_largest_time(at(21).time_since_epoch().count());
  status.add_unavailable_tasks(
      "nao/motion: neither the robot nor another task provides requests to joints (joints/request)");
}

}  // namespace

class LogViewsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void streamsAreListedWithCountSizeRateAndSchema() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<StreamsView>();
    auto& table = child<QTableView>(*view, "streamsTable");
    QAbstractItemModelTester tester(table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(table.model()->rowCount(), 4);
    const QString image = QStringLiteral("nao/camera/image");
    QCOMPARE(cell(table, image, StreamListModel::kCount).data().toString(), QStringLiteral("151"));
    QCOMPARE(cell(table, image, StreamListModel::kBytes).data().toString(), QStringLiteral("151.0 kB"));
    QCOMPARE(cell(table, image, StreamListModel::kRate).data().toString(), QStringLiteral("5.0"));
    QCOMPARE(cell(table, image, StreamListModel::kSchema).data().toString(),
             QStringLiteral("foxglove.CompressedImage"));
    QVERIFY(
        child<QLabel>(*view, "streamsSummary").text().contains(QStringLiteral("streams: 4, messages: 2969")));
    keepPicture(*view, "streams");
  }

  void streamsAreSearchedByPathAndSchemaAndSortedByNumbers() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<StreamsView>();
    auto& table = child<QTableView>(*view, "streamsTable");
    QTest::keyClicks(&child<QLineEdit>(*view, "streamsSearch"), QStringLiteral("jointstates"));
    QCOMPARE(table.model()->rowCount(), 1);
    QTest::keyClick(&child<QLineEdit>(*view, "streamsSearch"), Qt::Key_Escape);
    auto& header = *table.horizontalHeader();
    QTest::mouseClick(header.viewport(), Qt::LeftButton, {},
                      {header.sectionViewportPosition(StreamListModel::kCount) + 20, header.height() / 2});
    QCOMPARE(table.model()->index(0, 0).data().toString(), QStringLiteral("nao/log"));
    QCOMPARE(table.model()->index(3, 0).data().toString(), QStringLiteral("nao/joints/states"));
  }

  void aDoubleClickStepsTheMessagesOfAStreamAndACheckHidesIt() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<StreamsView>();
    auto& table = child<QTableView>(*view, "streamsTable");
    const QPoint where =
        table.visualRect(cell(table, QStringLiteral("nao/joints/states"), StreamListModel::kRate)).center();
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, where);
    QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, where);
    QCOMPARE(bench.logs().replay().steppedStream(), std::string("nao/joints/states"));
    table.setCurrentIndex(cell(table, QStringLiteral("nao/joints/states"), StreamListModel::kPath));
    QTest::keyClick(&table, Qt::Key_Space);
    QVERIFY(bench.logs().logs()[0]->hidden.contains("nao/joints/states"));
    bench.tick(*view);
    QCOMPARE(cell(table, QStringLiteral("nao/joints/states"), 0).data(Qt::CheckStateRole).toInt(),
             static_cast<int>(Qt::Unchecked));
  }

  void packagesShowTheirSourceAndHowTheyDiffer() {
    LogBench bench;
    addPackages(bench.status);
    bench.openLog(kFile);
    auto view = bench.openView<ReplayPackagesView>();
    auto& table = child<QTableView>(*view, "packagesTable");
    QAbstractItemModelTester tester(table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    const QString ball = QStringLiteral("nao/models/ball");
    QCOMPARE(cell(table, ball, ReplayPackageModel::kSource).data().toString(), QStringLiteral("recomputed"));
    QCOMPARE(cell(table, ball, ReplayPackageModel::kCompared).data().toString(), QStringLiteral("120"));
    QCOMPARE(cell(table, ball, ReplayPackageModel::kDifferent).data().toString(),
             QStringLiteral("7 + 2 alone"));
    QCOMPARE(cell(table, ball, ReplayPackageModel::kFirst).data().toString(), QStringLiteral("7.500"));
    QCOMPARE(cell(table, ball, ReplayPackageModel::kLargest).data().toString(),
             QStringLiteral("position_in_robot.x: 0.25"));
    QVERIFY(cell(table, QStringLiteral("nao/percepts/ball"), ReplayPackageModel::kSource)
                .data()
                .toString()
                .contains(QStringLiteral("automatic")));
    QVERIFY(child<QLabel>(*view, "unavailableTasks")
                .text()
                .contains(QStringLiteral(
                    "neither the robot nor another task provides requests to joints (joints/request)")));
    bench.status.mutable_differences(0)->set_different(9);
    bench.publish();
    bench.tick(*view);
    QCOMPARE(cell(table, ball, ReplayPackageModel::kDifferent).data().toString(),
             QStringLiteral("9 + 2 alone"));
    keepPicture(*view, "packages");
  }

  void theSourceIsChosenInPlaceAndWhatIsImpossibleIsNot() {
    LogBench bench;
    addPackages(bench.status);
    bench.openLog(kFile);
    auto view = bench.openView<ReplayPackagesView>();
    auto& table = child<QTableView>(*view, "packagesTable");
    table.setCurrentIndex(cell(table, QStringLiteral("nao/percepts/ball"), ReplayPackageModel::kSource));
    QTest::keyClick(&table, Qt::Key_F2);
    auto& box = child<QComboBox>(*view, "packageSourceEditor");
    box.hidePopup();
    QTest::keyClick(&box, Qt::Key_End);
    QCOMPARE(bench.asked().packages_size(), 1);
    QCOMPARE(bench.asked().packages(0).package(), std::string("nao/percepts/ball"));
    QCOMPARE(bench.asked().packages(0).source(), ControlReplay::RECOMPUTED);
    const auto requests = bench.requests.size();
    const QModelIndex image = cell(table, QStringLiteral("nao/camera/image"), ReplayPackageModel::kSource);
    QVERIFY(!table.model()->setData(image, static_cast<int>(ControlReplay::RECOMPUTED), Qt::EditRole));
    QCOMPARE(bench.requests.size(), requests);
    QVERIFY(image.data(Qt::ToolTipRole).toString().contains(QStringLiteral("sensor")));
  }

  void aDoubleClickOnADifferenceGoesThere() {
    LogBench bench;
    addPackages(bench.status);
    bench.openLog(kFile);
    auto view = bench.openView<ReplayPackagesView>();
    auto& table = child<QTableView>(*view, "packagesTable");
    for (const auto& [column, seconds] :
         {std::pair(ReplayPackageModel::kFirst, 17.5), std::pair(ReplayPackageModel::kLargest, 21.0)}) {
      const QPoint where = table.visualRect(cell(table, QStringLiteral("nao/models/ball"), column)).center();
      QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, where);
      QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, where);
      QCOMPARE(bench.asked().action(), ControlReplay::JUMP_TO_TIME);
      QCOMPARE(bench.asked().time(), at(seconds).time_since_epoch().count());
      bench.answer(true);
      bench.tick(*view);
    }
  }

  void timesAreTypedAsPeopleDo() {
    using widgets::timeFromText;
    const robotlink::Duration now = std::chrono::seconds(100);
    const auto s = [](double seconds) { return robotlink::fromSeconds(seconds); };
    QCOMPARE(timeFromText(QStringLiteral("12.5"), now).value(), s(12.5));
    QCOMPARE(timeFromText(QStringLiteral(" 12,5 s"), now).value(), s(12.5));
    QCOMPARE(timeFromText(QStringLiteral("1:02.5"), now).value(), s(62.5));
    QCOMPARE(timeFromText(QStringLiteral("1:00:02"), now).value(), s(3602));
    QCOMPARE(timeFromText(QStringLiteral("+2"), now).value(), s(102));
    QCOMPARE(timeFromText(QStringLiteral("-0.5"), now).value(), s(99.5));
    for (const char* bad : {"", "soon", "1:2:3:4", "--2", "1e300", "nan", "5 m"}) {
      QVERIFY2(!timeFromText(QLatin1String(bad), now), bad);
    }
  }

  void axesHaveRoundMarksAndDensityCountsEveryMessageOnce() {
    widgets::TimeScale scale{100, at(486.749), 30e9 / 800};
    const auto marks = widgets::axisMarks(scale, 80, at(486.749));
    QCOMPARE(marks.step, robotlink::Duration(std::chrono::seconds(5)));
    QCOMPARE(marks.first, at(486.749));
    QCOMPARE(widgets::timeText(marks.first + marks.step - at(486.749), marks.step), QStringLiteral("5"));
    QCOMPARE(widgets::timeText(robotlink::fromSeconds(1.25), std::chrono::milliseconds(50)),
             QStringLiteral("1.25"));
    std::vector<robotlink::Instant> times;
    for (int i = 0; i < 100'000; ++i) times.push_back(at(10 + i * 1e-3));
    const widgets::MessageDensity longOne(times);
    QCOMPARE(longOne.between(at(0), at(1000)), 100'000U);
    QVERIFY(std::abs(static_cast<double>(longOne.between(at(20), at(30))) - 10'000) <= 10);
    std::uint64_t sum = 0;
    for (int i = 0; i < 997; ++i) sum += longOne.between(at(i * 0.2), at((i + 1) * 0.2));
    QCOMPARE(sum, 100'000U);
    times.resize(100);
    const widgets::MessageDensity shortOne(times);
    QCOMPARE(shortOne.between(at(10), at(10.001)), 1U);
    QCOMPARE(shortOne.snapped(at(10.0104), std::chrono::milliseconds(1)), at(10.010));
    QCOMPARE(shortOne.snapped(at(11), std::chrono::milliseconds(1)), at(11));
  }
};

const GuiTest<LogViewsTest> kLogViewsTest;

}  // namespace widgets::test

#include "LogViewsTest.moc"
