// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/TrueClassFrames.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>

#include "robotlink/packages/Packages.h"
#include "tests/widgets/CameraBench.h"

namespace widgets::test {

class TrueClassFramesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() {
    world_ = std::make_unique<CameraBench>();
    bench_ = &colorBench(world_->context);
    frames_ = std::make_unique<TrueClassFrames>(*bench_);
  }
  void cleanup() {
    frames_.reset();
    world_.reset();
  }

  void theRobotIsAskedAndItsImagesScoreTheTable() {
    frames_->setOn(true);
    QCOMPARE(world_->requests.size(), std::size_t{1});
    QCOMPARE(world_->requests[0].set_key().name(), std::string("package/oracle/classes"));
    report();
    QCOMPARE(bench_->labeled().size(), std::size_t{1});
    bench_->setFrame(world_->frame());
    bench_->setCurrentClass(1);
    const colortool::ImagePoint at[] = {{8, 7}};
    bench_->addStroke(colortool::brushArea(40, 30, at, 3), "brush");
    QTRY_VERIFY(bench_->upToDate() && bench_->quality() != nullptr &&
                bench_->quality()->task == bench_->colors()->task);
    QVERIFY(bench_->quality()->labeled);
    QCOMPARE(bench_->quality()->labeled->recall(1), 1.0);
    QCOMPARE(bench_->quality()->labeled->recall(bench_->samples().classes.index("green")), 0.0);
    frames_->setOn(false);
    QCOMPARE(world_->requests.back().set_key().mode().kind(), robotcontrol::KeyMode::OFF);
    QVERIFY(bench_->labeled().empty());
  }

  void oneImageASecondIsTakenAndTheLastOnesStay() {
    frames_->setOn(true);
    for (int i = 0; i < 5; ++i) report(300);
    QCOMPARE(bench_->labeled().size(), std::size_t{2});
    for (std::size_t i = 0; i < TrueClassFrames::kMax + 5; ++i) report(1000);
    QCOMPARE(bench_->labeled().size(), TrueClassFrames::kMax);
  }

  void aRefusalIsReported() {
    QSignalSpy failures(bench_, &ColorBench::failed);
    world_->refusal = "this robot has no oracle";
    frames_->setOn(true);
    world_->advance();
    QCOMPARE(failures.count(), 1);
    QVERIFY(failures[0][0].toString().contains(QStringLiteral("this robot has no oracle")));
  }

 private:
  /// The camera's image and its true classes, in the numbers of 2002.
  void report(int milliseconds = 40) {
    auto image = std::make_shared<foxglove::RawImage>(*CameraBench::image());
    robotlink::assign(*image->mutable_timestamp(), world_->now());
    robotlink::Image classes(40, 30, robotlink::PixelFormat::kMono8);
    const auto& all = bench_->samples().classes;
    for (int y = 0; y < 15; ++y) {
      for (int x = 0; x < 40; ++x) classes.row(y)[x] = x < 20 ? all.index("orange") : all.index("green");
    }
    auto labels = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*labels, classes.view(), world_->now(), "camera");
    world_->push(CameraBench::kStream, image);
    world_->push("red1/" + std::string(robotlink::kOracleClasses.name), labels);
    world_->advance(milliseconds);
    frames_->tick();
  }

  std::unique_ptr<CameraBench> world_;
  ColorBench* bench_ = nullptr;
  std::unique_ptr<TrueClassFrames> frames_;
};

const GuiTest<TrueClassFramesTest> kTrueClassFramesTest;

}  // namespace widgets::test

#include "TrueClassFramesTest.moc"
