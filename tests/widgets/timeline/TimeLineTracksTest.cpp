// SPDX-License-Identifier: GPL-3.0-or-later
// Values as curves in the timeline.
#include <QAction>
#include <QContextMenuEvent>
#include <QDropEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QMimeData>
#include <QToolTip>
#include <memory>

#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "tests/widgets/FieldBench.h"
#include "tests/widgets/LogBench.h"
#include "tests/widgets/timeline/MadeUpArchive.h"
#include "widgets/Theme.h"
#include "widgets/plots/PlotTreeModel.h"
#include "widgets/timeline/TimeLineCanvas.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets::test {
namespace {

constexpr char kFrameNumber[] = "red1/frames/cognition: number";

TimeLineCanvas& trackCanvas(TimeLineView& view) {
  return child<TimeLineCanvas>(view, "timeLineCanvas");
}

/// The lane of a value; empty: there is none.
QRectF laneOf(TimeLineView& view, const char* source) {
  const TimeLineLayout all = trackCanvas(view).layout();
  for (const auto& lane : all.lanes) {
    if (lane.kind == TimeLineLayout::Kind::kTrack && lane.stream == source) return lane.rect;
  }
  return {};
}

void drop(TimeLineView& view, const QString& sources) {
  QMimeData data;
  data.setData(QString::fromLatin1(PlotTreeModel::kMimeType), sources.toUtf8());
  QWidget& viewport = *trackCanvas(view).viewport();
  QDragEnterEvent enter({300, 40}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&viewport, &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent event({300, 40}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&viewport, &event);
}

/// The band of the values, or null.
const TimeLineBand* values(TimeLineView& view) {
  const auto& bands = trackCanvas(view).bands();
  return bands.empty() || bands.back().tracks.empty() ? nullptr : &bands.back();
}

/// A robot that has sent something every 0.1 s.
void run(Bench& bench, int frames) {
  for (int frame = 1; frame <= frames; ++frame) {
    robotcontrol::FrameInfo info;
    info.set_number(static_cast<std::uint64_t>(frame));
    bench.push("red1/frames/cognition", info, 0.1 * frame);
  }
  bench.session.tick();
}

}  // namespace

class TimeLineTracksTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aValueIsDroppedAndShownWhileTheRobotContinues() {
    Bench bench;
    run(bench, 100);
    auto view = bench.open<TimeLineView>();
    drop(*view, QLatin1String(kFrameNumber));
    bench.tick(*view);
    QVERIFY(values(*view) != nullptr);
    QCOMPARE(values(*view)->tracks.front().points, std::size_t{100});
    QVERIFY(laneOf(*view, kFrameNumber).height() > trackCanvas(*view).look().row);
    robotcontrol::FrameInfo info;
    info.set_number(500);
    bench.push("red1/frames/cognition", info, 10.1);
    bench.tick(*view);
    QCOMPARE(values(*view)->tracks.front().points, std::size_t{101});
    QCOMPARE(values(*view)->tracks.front().series->back().value, 500.0);
  }

  void whatOfAValueIsOnDiskIsReadAndWhatIsLostIsHatched() {
    Bench bench;
    auto archive = std::make_unique<MadeUpArchive>(true);
    archive->lost = {{at(2), at(3)}};
    bench.session.history().setArchive(std::move(archive));
    bench.session.store().setBytes(10'000);
    run(bench, 100);
    QVERIFY(bench.session.store().find("red1/frames/cognition")->messages.size() < 100);
    auto view = bench.open<TimeLineView>();
    QVERIFY(view->addTrack(QLatin1String(kFrameNumber)));
    const bool isRead = QTest::qWaitFor([&] {
      bench.tick(*view);
      return values(*view) != nullptr && values(*view)->tracks.front().points == 100;
    });
    QVERIFY(isRead);
    const TimeLineTrack& track = values(*view)->tracks.front();
    for (std::size_t i = 0; i < track.points; ++i)
      QCOMPARE((*track.series)[i].value, static_cast<double>(i + 1));
    QCOMPARE(track.missing.size(), std::size_t{1});
    QVERIFY((track.missing.front() == MissingValues{2, 3, MissingValues::Why::kLost}));
    QVERIFY(!view->grab().isNull());
  }

  void whatCannotBeReadFromDiskIsHatched() {
    Bench bench;
    bench.session.history().setArchive(std::make_unique<MadeUpArchive>());
    bench.session.store().setBytes(10'000);
    run(bench, 100);
    auto view = bench.open<TimeLineView>();
    QVERIFY(view->addTrack(QLatin1String(kFrameNumber)));
    bench.tick(*view);
    QVERIFY(values(*view) != nullptr);
    QVERIFY(values(*view)->tracks.front().missing.front().why == MissingValues::Why::kUnread);
    const bool isRead = QTest::qWaitFor([&] {
      bench.tick(*view);
      return values(*view)->tracks.front().missing.front().why != MissingValues::Why::kUnread;
    });
    QVERIFY(isRead);
    const TimeLineTrack& track = values(*view)->tracks.front();
    QVERIFY(track.points < 100);
    QCOMPARE(track.missing.size(), std::size_t{1});
    QVERIFY(track.missing.front().why == MissingValues::Why::kTooMany);
    QCOMPARE(track.missing.front().from, 0.1);
    QCOMPARE(track.missing.front().to, track.series->front().time);
    QVERIFY(!view->grab().isNull());
  }

  void theKeyOfWhatNobodyPublishesIsSwitchedOnOnce() {
    Bench bench;
    run(bench, 3);
    robotcontrol::KeyTable table;
    auto& key = *table.add_keys();
    key.set_name("package/models/ball");
    key.set_stream("models/ball");
    key.set_in_use(true);
    key.mutable_mode()->set_kind(robotcontrol::KeyMode::OFF);
    bench.push("red1/tables/keys", table, 0.3);
    auto view = bench.open<TimeLineView>();
    QVERIFY(view->addTrack(QStringLiteral("red1/models/ball: position_in_robot.x")));
    bench.tick(*view);
    bench.tick(*view);
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(bench.requests.front().set_key().name()),
             QStringLiteral("package/models/ball"));
  }

  void theCurveIsPaintedAndItsTipSaysTheValue() {
    Bench bench;
    run(bench, 100);
    auto view = bench.open<TimeLineView>();
    QVERIFY(view->addTrack(QLatin1String(kFrameNumber)));
    bench.tick(*view);
    const TimeLineCanvas& canvas = trackCanvas(*view);
    const QRectF lane = laneOf(*view, kFrameNumber);
    const QImage image = canvas.viewport()->grab().toImage();
    const QColor color = curveColor(0, canvas.palette());
    // The number rises: its curve is low at the left and high at the right.
    const auto heightAt = [&](double seconds) {
      const int x = static_cast<int>(canvas.look().scale.x(at(seconds)));
      double best = 1e9;
      int found = -1;
      for (int y = static_cast<int>(lane.top()) + 1; y < lane.bottom() - 1; ++y) {
        const QColor there = image.pixelColor(x, y);
        const double off = std::abs(there.redF() - color.redF()) + std::abs(there.greenF() - color.greenF()) +
                           std::abs(there.blueF() - color.blueF());
        if (off < best) {
          best = off;
          found = y;
        }
      }
      return found;
    };
    QVERIFY(heightAt(2) > heightAt(9) + 8);
    const QPoint point(static_cast<int>(canvas.look().scale.x(at(5.05))),
                       static_cast<int>(lane.center().y()));
    QHelpEvent event(QEvent::ToolTip, point, canvas.viewport()->mapToGlobal(point));
    QApplication::sendEvent(canvas.viewport(), &event);
    QVERIFY2(QToolTip::text().contains(QStringLiteral("50 ")), qPrintable(QToolTip::text()));
  }

  void theContextMenuRemovesIt() {
    Bench bench;
    run(bench, 100);
    auto view = bench.open<TimeLineView>();
    QVERIFY(view->addTrack(QLatin1String(kFrameNumber)));
    QVERIFY(view->addTrack(QLatin1String(kFrameNumber)));
    QCOMPARE(view->tracks().size(), 1);
    bench.tick(*view);
    const QPoint point = laneOf(*view, kFrameNumber).center().toPoint();
    QWidget& viewport = *trackCanvas(*view).viewport();
    QContextMenuEvent event(QContextMenuEvent::Mouse, point, viewport.mapToGlobal(point));
    QApplication::sendEvent(&viewport, &event);
    auto& menu = child<QMenu>(*view, "timeLineMenu");
    child<QAction>(menu, "removeTrack").trigger();
    menu.close();
    QVERIFY(view->tracks().isEmpty());
    QVERIFY(values(*view) == nullptr);
  }

  void whatIsWrongOrTooMuchIsRefused() {
    Bench bench;
    run(bench, 3);
    auto view = bench.open<TimeLineView>();
    QVERIFY(!view->addTrack(QStringLiteral("= 1 +")));
    // What plots compute is not shown as something that it is not.
    for (const char* computed : {"red1/frames/cognition: number | derivative",
                                 "red1/frames/cognition: number over red1/models/pose: pose.x"}) {
      QVERIFY2(!view->addTrack(QLatin1String(computed)), computed);
    }
    QVERIFY(view->tracks().isEmpty());
    for (int i = 0; i < TimeLineTracks::kMax; ++i)
      QVERIFY(view->addTrack(QStringLiteral("red1/models/ball: values[%1]").arg(i)));
    const auto refused = view->addTrack(QLatin1String(kFrameNumber));
    QVERIFY(!refused && refused.error().text.find("at most") != std::string::npos);
    bench.tick(*view);
    QVERIFY(values(*view)->tracks.front().series->empty());
    QVERIFY(!trackCanvas(*view).viewport()->grab().isNull());
  }

  void theValuesOfAWholeLogAreReadWithoutPlayingIt() {
    const TestFolder folder;
    const std::filesystem::path file = folder / "game.mcap";
    auto writer = logplayer::LogWriter::create(file, {});
    QVERIFY(writer.has_value());
    for (int i = 0; i < 60; ++i) {
      auto ball = std::make_shared<robotcontrol::BallModel>();
      ball->mutable_position_in_robot()->set_x(i);
      QVERIFY((*writer)->write({{"red1/models/ball", at(i * 0.04), ball}}).has_value());
    }
    QVERIFY((*writer)->container().close().has_value());
    LogBench bench;
    bench.shapeOverview = [](LogOverview& overview) {
      overview.robots = {"red1"};
      overview.streams.push_back({"red1/models/ball", "robotcontrol.BallModel", 60, 0, at(0), at(2.4)});
    };
    bench.openLog(file.string());
    auto view = bench.openView<TimeLineView>();
    QVERIFY(view->addTrack(QStringLiteral("red1/models/ball: position_in_robot.x")));
    const bool isRead = QTest::qWaitFor([&] {
      bench.tick(*view);
      return values(*view) != nullptr && values(*view)->tracks.front().points == 60;
    });
    QVERIFY(isRead);
    QCOMPARE(values(*view)->tracks.front().series->back().value, 59.0);
  }

  void theyAreRememberedWithTheView() {
    Bench bench;
    run(bench, 3);
    auto view = bench.open<TimeLineView>();
    QVERIFY(view->addTrack(QLatin1String(kFrameNumber)));
    auto other = bench.open<TimeLineView>();
    other->restoreState(view->saveState());
    QCOMPARE(other->tracks(), QStringList{QLatin1String(kFrameNumber)});
  }
};

const GuiTest<TimeLineTracksTest> kTimeLineTracksTest;

}  // namespace widgets::test

#include "TimeLineTracksTest.moc"
