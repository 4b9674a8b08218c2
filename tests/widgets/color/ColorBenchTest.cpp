// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QTest>
#include <algorithm>
#include <numeric>

#include "tests/widgets/CameraBench.h"

namespace widgets::test {

/// The table that all color views share: strokes become a table and a segmented image, and back.
class ColorBenchTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() {
    world_ = std::make_unique<CameraBench>();
    bench_ = &colorBench(world_->context);
    bench_->setFrame(world_->frame());
  }
  void cleanup() { world_.reset(); }

  void strokesSegmentTheImage() {
    stroke("orange", 8, 7);
    stroke("green", 30, 7);
    waitForColors();
    QCOMPARE(classAt(3, 3), QStringLiteral("orange"));
    QCOMPARE(classAt(36, 3), QStringLiteral("green"));
    QCOMPARE(bench_->undoStack().count(), 2);
    bench_->undoStack().undo();
    waitForColors();
    QCOMPARE(classAt(3, 3), QStringLiteral("orange"));
    QCOMPARE(classAt(36, 3), QStringLiteral("none"));
    bench_->undoStack().redo();
    waitForColors();
    QCOMPARE(classAt(36, 3), QStringLiteral("green"));
  }

  void aStrokeThatIsDrawnIsOneStep() {
    choose("orange");
    for (double x = 3; x < 12; ++x) {
      const colortool::ImagePoint way[] = {{3, 7}, {x, 7}};
      bench_->addStroke(colortool::brushArea(40, 30, way, 2), "brush", "stroke 1");
    }
    QCOMPARE(bench_->undoStack().count(), 1);
    QCOMPARE(bench_->samples().strokes.size(), std::size_t{1});
    QVERIFY(bench_->samples().strokes[0]->area[2].end > 10);
    bench_->undoStack().undo();
    QVERIFY(bench_->samples().strokes.empty());
  }

  void theEraserTakesAStrokeBack() {
    stroke("orange", 8, 7);
    bench_->erase(colortool::rectangleArea(40, 30, {0, 0}, {39, 29}));
    QVERIFY(bench_->samples().strokes.empty());
    waitForColors();
    QCOMPARE(classAt(3, 3), QStringLiteral("none"));
    bench_->undoStack().undo();
    waitForColors();
    QCOMPARE(classAt(3, 3), QStringLiteral("orange"));
  }

  void marginsAndScoresFollow() {
    LabeledFrame labeled{world_->frame(), std::vector<std::uint8_t>(40 * 30, 0), {"none", "orange"}};
    for (int y = 0; y < 15; ++y) std::fill_n(labeled.labels.begin() + y * 40, 20, std::uint8_t{1});
    bench_->setLabeled({labeled});
    stroke("orange", 8, 7);
    waitForColors();
    QTRY_VERIFY(bench_->quality() != nullptr && bench_->quality()->task == bench_->colors()->task);
    QTRY_VERIFY(bench_->colors()->margins != nullptr);
    QVERIFY(bench_->quality()->labeled);
    QCOMPARE(bench_->quality()->labeled->recall(bench_->samples().classes.index("orange")), 1.0);
  }

  void correctionsChangeWhatTheTableSees() {
    stroke("orange", 8, 7);
    waitForColors();
    QVERIFY(bench_->colors()->corrected == nullptr);
    colortool::Samples next = bench_->samples();
    colortool::ColorCorrection darker;
    darker.channels[0] = {1, -60};
    next.corrections = {{"red1", darker}};
    next.settings.correctCameras = true;
    bench_->change(QStringLiteral("correct"), std::move(next));
    waitForColors();
    QVERIFY(bench_->colors()->corrected != nullptr);
    const auto color = robotlink::pixelYCbCr(bench_->colors()->seen(), 3, 3);
    QVERIFY(std::abs(color.y - 80) <= 1);
    QCOMPARE(classAt(3, 3), QStringLiteral("orange"));
    QCOMPARE(bench_->colors()->table->classOf(color), bench_->samples().classes.index("orange"));
  }

  void imagesAreCollectedOnce() {
    bench_->collect();
    bench_->collect();
    QCOMPARE(bench_->collected().size(), std::size_t{1});
    QVERIFY(!bench_->collected()[0].thumbnail.isNull());
    bench_->removeCollected(0);
    QVERIFY(bench_->collected().empty());
  }

  void anImageThatIsPutAsideAgainCountsOnceInTheScore() {
    const ColorFramePtr first = world_->frame(40, 30, 10), second = world_->frame(40, 30, 20);
    QCOMPARE(bench_->collect({first, second, first}), std::size_t{2});
    bench_->removeCollected(0);
    QCOMPARE(bench_->collect({first}), std::size_t{1});
    stroke("orange", 8, 7);
    waitForColors();
    QTRY_VERIFY(bench_->quality() != nullptr && bench_->quality()->task == bench_->colors()->task);
    QCOMPARE(bench_->quality()->others.images, 3);  // with the one that is worked on
  }

  void suspiciousPixelsAreCountedInTheCorrectedImage() {
    colortool::ColorTable brightIsOrange;
    const auto& classes = bench_->samples().classes;
    for (int y = 32; y < colortool::ColorTable::kCells; ++y)
      brightIsOrange.setCell(y, 32, 32, classes.index("orange"));
    robotlink::Image image(320, 240, robotlink::PixelFormat::kYuyv);
    std::ranges::fill(image.data, std::uint8_t{128});
    for (std::size_t i = 0; i < image.data.size(); i += 2) image.data[i] = 20;
    for (int x = 0; x < 4; ++x) image.row(100)[200 + 2 * x] = 200;
    auto message = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*message, image.view(), {}, "camera");
    colortool::Samples samples = bench_->samples();
    QCOMPARE(suspiciousPixels(samples, brightIsOrange, message), std::uint64_t{4});
    colortool::ColorCorrection darker;
    darker.channels[0] = {1, -100};
    samples.corrections = {{"red1", darker}};
    samples.settings.correctCameras = true;
    QCOMPARE(suspiciousPixels(samples, brightIsOrange, message), std::uint64_t{0});
  }

 private:
  /// As a scorer counts them in an image of red1.
  static std::uint64_t suspiciousPixels(const colortool::Samples& samples, const colortool::ColorTable& table,
                                        const std::shared_ptr<const foxglove::RawImage>& image) {
    ColorScorer scorer([] {});
    const auto frame = std::make_shared<ColorFrame>(image, CameraBench::kStream, "", robotlink::Instant{});
    scorer.ask({1, samples, std::make_shared<colortool::ColorTable>(table), {}, {}, {frame}});
    std::optional<ColorQuality> quality;
    if (!QTest::qWaitFor([&] { return (quality = scorer.take()).has_value(); })) return 0;
    return std::accumulate(quality->others.suspicious.begin(), quality->others.suspicious.end(),
                           std::uint64_t{0});
  }
  void choose(const char* name) { bench_->setCurrentClass(bench_->samples().classes.index(name)); }
  void stroke(const char* name, double x, double y) {
    choose(name);
    const colortool::ImagePoint at[] = {{x, y}};
    bench_->addStroke(colortool::brushArea(40, 30, at, 3), "brush");
  }
  void waitForColors() { QTRY_VERIFY(bench_->upToDate()); }
  QString classAt(int x, int y) {
    return QString::fromStdString(bench_->samples().classes.name(bench_->colors()->classes->row(y)[x]));
  }

  std::unique_ptr<CameraBench> world_;
  ColorBench* bench_ = nullptr;
};

const GuiTest<ColorBenchTest> kColorBenchTest;

}  // namespace widgets::test

#include "ColorBenchTest.moc"
