// SPDX-License-Identifier: GPL-3.0-or-later
// Images, warnings and errors of live robots in the timeline.
#include <algorithm>
#include <memory>
#include <string>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "tests/widgets/LogBench.h"
#include "tests/widgets/timeline/MadeUpArchive.h"
#include "widgets/timeline/TimeLineCanvas.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets::test {
namespace {

constexpr char kStripCamera[] = "red1/camera/image";

/// A robot that has sent a gray image every 0.1 s, which gets brighter, and a text every 2 s, of which each
/// second one is a warning.
void sendStrip(Bench& bench, int from, int to) {
  for (int i = from; i < to; ++i) {
    foxglove::RawImage image;
    image.set_width(8);
    image.set_height(6);
    image.set_encoding("mono8");
    image.set_step(8);
    image.set_data(std::string(48, static_cast<char>(i)));
    bench.push(kStripCamera, image, 0.1 * i);
    foxglove::Log log;
    log.set_level(i % 40 == 0 ? foxglove::Log::WARNING : foxglove::Log::INFO);
    log.set_message("text " + std::to_string(i));
    if (i % 20 == 0) bench.push("red1/log", log, 0.1 * i);
    if (i % 10 == 0) bench.session.tick();
  }
  bench.session.tick();
}

TimeLineCanvas& stripCanvas(TimeLineView& view) {
  return child<TimeLineCanvas>(view, "timeLineCanvas");
}

bool hasLane(TimeLineView& view, TimeLineLayout::Kind kind) {
  const TimeLineLayout all = stripCanvas(view).layout();
  return std::ranges::any_of(all.lanes,
                             [kind](const auto& lane) { return lane.band == 0 && lane.kind == kind; });
}

/// Ticks until no visible image is missing. False if that does not happen.
bool makeAll(Bench& bench, TimeLineView& view) {
  return QTest::qWaitFor([&] {
    bench.tick(view);
    return !stripCanvas(view).bands().front().thumbnails.empty() &&
           stripCanvas(view).missingThumbnails(0).empty();
  });
}

}  // namespace

class HistoryStripsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void imagesAndWarningsInMemoryAreShown() {
    Bench bench;
    sendStrip(bench, 20, 200);
    auto view = bench.open<TimeLineView>({1000, 300});
    QVERIFY(makeAll(bench, *view));
    QVERIFY(hasLane(*view, TimeLineLayout::Kind::kImages));
    QVERIFY(hasLane(*view, TimeLineLayout::Kind::kTexts));
    const TimeLineBand& band = stripCanvas(*view).bands().front();
    QCOMPARE(band.said->size(), std::size_t{4});
    QVERIFY(band.said->front().time == at(4) && band.said->front().text == QStringLiteral("text 40"));
    for (const auto& [time, image] : band.thumbnails) {
      const int wanted = static_cast<int>((time - at(0)) / std::chrono::milliseconds(100));
      QVERIFY(std::abs(qGray(image.pixel(0, 0)) - wanted) <= 1);
    }
    keepPicture(*view, "timeline-strips");
  }

  void whatIsOnDiskIsReadLikewise() {
    Bench bench;
    bench.session.history().setArchive(std::make_unique<MadeUpArchive>(true));
    bench.session.store().setBytes(20'000);
    sendStrip(bench, 20, 200);
    QVERIFY(!bench.session.store().has(at(6)));
    auto view = bench.open<TimeLineView>({1000, 300});
    QVERIFY(makeAll(bench, *view));
    const bool isRead = QTest::qWaitFor([&] {
      bench.tick(*view);
      return stripCanvas(*view).bands().front().said->size() == 4;
    });
    QVERIFY(isRead);
    const auto& thumbnails = stripCanvas(*view).bands().front().thumbnails;
    QVERIFY(std::ranges::any_of(
        thumbnails, [](const auto& each) { return each.first < at(6) && !each.second.isNull(); }));
  }

  void nothingIsMadeWithoutTicksAndWhatCameMeanwhileIsMadeUpFor() {
    Bench bench;
    bench.session.history().setArchive(std::make_unique<MadeUpArchive>(true));
    bench.session.store().setBytes(20'000);
    sendStrip(bench, 20, 60);
    auto view = bench.open<TimeLineView>({1000, 300});
    QVERIFY(makeAll(bench, *view));
    const auto made = stripCanvas(*view).bands().front().thumbnails.size();
    sendStrip(bench, 60, 250);
    QCOMPARE(stripCanvas(*view).bands().front().thumbnails.size(), made);
    const bool isRead = QTest::qWaitFor([&] {
      bench.tick(*view);
      return stripCanvas(*view).bands().front().said->size() == 6;
    });
    QVERIFY(isRead);
  }

  void aRestartForgetsAll() {
    Bench bench;
    sendStrip(bench, 20, 200);
    auto view = bench.open<TimeLineView>({1000, 300});
    QVERIFY(makeAll(bench, *view));
    bench.session.restart([] {});
    foxglove::Log log;
    bench.push("red1/log", log, 0.1);
    bench.tick(*view);
    const TimeLineBand& band = stripCanvas(*view).bands().front();
    QVERIFY(band.thumbnails.empty() && !band.hasImages && band.said->empty());
  }

  void imagesKeepTheirTimesWhileTheHistoryGrows() {
    TimeLineBand band;
    band.hasImages = true;
    band.kept = {{at(0), at(100)}};
    TimeLineLook look;
    look.size = {1000, 300};
    look.begin = at(0);
    look.scale = {look.gutter, at(0), 1.2e8};
    const auto before = thumbnailSlots(band, look);
    look.scale.nsPerPixel = 1.3e8;
    const auto after = thumbnailSlots(band, look);
    QVERIFY(before.size() > 3 && after.size() >= before.size());
    for (std::size_t i = 0; i < before.size(); ++i) QVERIFY(before[i].time == after[i].time);
    // When they get too close, each second one stays.
    look.scale.nsPerPixel = 2.6e8;
    const auto fewer = thumbnailSlots(band, look);
    for (std::size_t i = 0; i < fewer.size() && 2 * i < after.size(); ++i)
      QVERIFY(fewer[i].time == after[2 * i].time);
  }
};

const GuiTest<HistoryStripsTest> kHistoryStripsTest;

}  // namespace widgets::test

#include "HistoryStripsTest.moc"
