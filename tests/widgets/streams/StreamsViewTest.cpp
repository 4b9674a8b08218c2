// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/streams/StreamsView.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <cmath>

#include "robotcontrol/Linking.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "tests/widgets/Bench.h"

namespace widgets::test {

namespace {

/// Two robots that publish values, one of them elsewhere; the debug key of one stream is on.
struct Published : Bench {
  std::unique_ptr<StreamsView> view;
  QTableView* table = nullptr;

  Published() {
    robotcontrol::KeyTable keys;
    auto& key = *keys.add_keys();
    key.set_name("ball-model/position");
    key.set_stream("plots/ball-model/position");
    key.mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    push("red1/tables/keys", keys, 1);
    for (int i = 0; i <= 50; ++i) {
      value("red1/plots/ball-model/position/x", 1 + i * 0.04, 10);
      if (i % 5 == 0) value("blue1/models/pose", 1 + i * 0.04, 10'000);
    }
    session.setRemoteRobots({{"blue1",
                              {.url = "ws://hall:8765",
                               .isConnected = true,
                               .state = "connected",
                               .missing = {{"blue1/models/pose", {12, 3}}}}}});
    view = open<StreamsView>({1100, 300});
    table = &child<QTableView>(*view, "streamsTable");
  }
  void value(const std::string& path, double time, std::size_t bytes) {
    robotcontrol::PlotValue published;
    published.set_unit(std::string(bytes, 'm'));
    push(path, published, time);
  }
  /// Half a second of updates, after which the list is current.
  void settle() {
    for (int i = 0; i < 15; ++i) tick(*view);
  }
  QString cell(const char* path, int column) const {
    const auto& model = *table->model();
    for (int row = 0; row < model.rowCount(); ++row)
      if (model.index(row, 0).data().toString() == QLatin1String(path))
        return model.index(row, column).data().toString();
    return QStringLiteral("not listed");
  }
};

}  // namespace

class StreamsViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void ratesBytesAndSharesAreThoseOfEachStream() {
    Published bench;
    QAbstractItemModelTester tester(bench.table->model(),
                                    QAbstractItemModelTester::FailureReportingMode::Fatal);
    const auto isNearly = [&](const char* path, double rate) {
      return std::abs(bench.cell(path, StreamListModel::kRate).toDouble() - rate) < 1.5;
    };
    QVERIFY(isNearly("red1/plots/ball-model/position/x", 25));
    QVERIFY(isNearly("blue1/models/pose", 5));
    QVERIFY(bench.cell("blue1/models/pose", StreamListModel::kByteRate).endsWith(QStringLiteral(" kB")));
    QVERIFY(bench.cell("blue1/models/pose", StreamListModel::kMeanSize).startsWith(QStringLiteral("10.")));
    const QString share = bench.cell("blue1/models/pose", StreamListModel::kShare);
    QVERIFY(share.section(QLatin1Char(' '), 0, 0).toDouble() > 50);
    const QString sums = child<QLabel>(*bench.view, "streamsSummary").text();
    QVERIFY(sums.contains(QStringLiteral("streams: 3")));
    QVERIFY(sums.contains(QStringLiteral("dropped: 0")));
    keepPicture(*bench.view, "live-streams");
  }

  void whatDidNotComeOverTheLineIsCountedAndCanBeListedAlone() {
    Published bench;
    QCOMPARE(bench.cell("blue1/models/pose", StreamListModel::kLeftOut),
             QStringLiteral("12 thinned, 3 lost"));
    QVERIFY(child<QLabel>(*bench.view, "streamsSummary").text().contains(QStringLiteral("lost: 3")));
    auto& which = child<QComboBox>(*bench.view, "streamsWhich");
    QTest::keyClicks(&which, QStringLiteral("With"));
    QTest::keyClick(&which, Qt::Key_Return);
    bench.tick(*bench.view);
    QCOMPARE(bench.table->model()->rowCount(), 1);
  }

  void theViewsThatReadAStreamAndTheClientsThatSubscribeAreNamed() {
    Published bench;
    QCOMPARE(bench.cell("red1/plots/ball-model/position/x", StreamListModel::kAskedBy),
             QStringLiteral("nobody; key ball-model/position: always"));
    {
      const robotlink::StreamReaders::Scope reading(bench.session.readers(), "plots1", "Plots");
      bench.session.store().find("red1/plots/ball-model/position/x");
    }
    robotcontrol::KeySubscribers subscribers;
    auto& key = *subscribers.add_keys();
    key.set_name("ball-model/position");
    key.add_clients("RobotControl at 10.0.0.7:5123");
    bench.push("red1/tables/subscribers", subscribers, 3);
    bench.tick(*bench.view);
    QCOMPARE(bench.cell("red1/plots/ball-model/position/x", StreamListModel::kAskedBy),
             QStringLiteral("Plots, RobotControl at 10.0.0.7:5123"));
    auto& search = child<QLineEdit>(*bench.view, "streamsSearch");
    QTest::keyClicks(&search, QStringLiteral("10.0.0.7"));
    QCOMPARE(bench.table->model()->rowCount(), 1);
    QTest::keyClick(&search, Qt::Key_Escape);
    // The view was closed: it reads no longer.
    bench.settle();
    QCOMPARE(bench.cell("red1/plots/ball-model/position/x", StreamListModel::kAskedBy),
             QStringLiteral("RobotControl at 10.0.0.7:5123"));
  }

  void theRecordingIsNamedForWhatItWrites() {
    Published bench;
    robotcontrol::RecordingStatus status;
    status.set_recording(true);
    status.mutable_selection()->add_include("red1/*");
    bench.push("recording", status, 3);
    bench.settle();
    QVERIFY(bench.cell("red1/plots/ball-model/position/x", StreamListModel::kAskedBy)
                .contains(QStringLiteral("Recording")));
    QVERIFY(
        !bench.cell("blue1/models/pose", StreamListModel::kAskedBy).contains(QStringLiteral("Recording")));
  }

  void streamsThatNobodyReadsCanBeListedAlone() {
    Published bench;
    {
      const robotlink::StreamReaders::Scope reading(bench.session.readers(), "field1", "Field");
      bench.session.store().find("blue1/models/pose");
    }
    auto& which = child<QComboBox>(*bench.view, "streamsWhich");
    which.setCurrentIndex(1);
    bench.tick(*bench.view);
    QCOMPARE(bench.cell("blue1/models/pose", StreamListModel::kPath), QStringLiteral("not listed"));
    QCOMPARE(bench.table->model()->rowCount(), 2);
  }

  void rowsAreSortedByNumbersAndCopied() {
    Published bench;
    auto& header = *bench.table->horizontalHeader();
    for (int clicks = 0; clicks < 2; ++clicks) {
      QTest::mouseClick(
          header.viewport(), Qt::LeftButton, {},
          {header.sectionViewportPosition(StreamListModel::kByteRate) + 10, header.height() / 2});
    }
    const QString first = bench.table->model()->index(0, 0).data().toString();
    const QString last = bench.table->model()->index(2, 0).data().toString();
    QVERIFY(first == QStringLiteral("blue1/models/pose") || last == QStringLiteral("blue1/models/pose"));
    bench.table->selectRow(0);
    click(*bench.view, "streamsCopy");
    QVERIFY(QApplication::clipboard()->text().startsWith(first + QLatin1Char('\t')));
  }

  void theChoiceAndTheColumnsAreRemembered() {
    Published bench;
    child<QComboBox>(*bench.view, "streamsWhich").setCurrentIndex(2);
    bench.table->sortByColumn(StreamListModel::kByteRate, Qt::DescendingOrder);
    const QJsonObject state = bench.view->saveState();
    auto other = bench.open<StreamsView>();
    other->restoreState(state);
    QCOMPARE(child<QComboBox>(*other, "streamsWhich").currentIndex(), 2);
    QCOMPARE(child<QTableView>(*other, "streamsTable").horizontalHeader()->sortIndicatorSection(),
             static_cast<int>(StreamListModel::kByteRate));
  }
};

const GuiTest<StreamsViewTest> kStreamsViewTest;

}  // namespace widgets::test

#include "StreamsViewTest.moc"
