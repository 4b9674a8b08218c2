// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QTest>

#include "tests/widgets/ColorWorld.h"

namespace widgets::test {

/// The table that all color views share: strokes become a table and a segmented image, and back.
class ColorBenchTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() {
    world_ = std::make_unique<ColorWorld>();
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
    QVERIFY(bench_->colors()->margins != nullptr);
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

 private:
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

  std::unique_ptr<ColorWorld> world_;
  ColorBench* bench_ = nullptr;
};

}  // namespace widgets::test

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  widgets::test::ColorBenchTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "ColorBenchTest.moc"
