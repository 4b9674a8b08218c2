// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/export/ExportPlan.h"

#include <QtTest>
#include <limits>

#include "robotlink/session/Session.h"
#include "tests/TestFolder.h"
#include "tests/widgets/GuiTest.h"
#include "widgets/log/ReplayControl.h"

namespace widgets::test {
namespace {

/// Images of the field from 0 on, 10 a second, in a folder that is not there yet.
ExportPlan fieldImages(const TestFolder& folder, double seconds) {
  ExportPlan plan;
  plan.kind = ExportPlan::Kind::kImages;
  plan.target = folder / "images";
  plan.name = "field";
  plan.to = robotlink::Instant(robotlink::fromSeconds(seconds));
  plan.rate = 10;
  plan.size = {640, 480};
  return plan;
}

QString problemOf(const ExportPlan& plan) {
  const auto done = check(plan);
  return done ? QString() : QString::fromStdString(done.error().text);
}

}  // namespace

class ExportPlanTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theLastInstantIsNotLostByRounding() {
    const TestFolder folder;
    QCOMPARE(fieldImages(folder, 0).frames(), std::int64_t{1});
    QCOMPARE(fieldImages(folder, 0.09).frames(), std::int64_t{1});
    for (int tenths = 1; tenths <= 30; ++tenths)
      QCOMPARE(fieldImages(folder, 0.1 * tenths).frames(), std::int64_t{tenths + 1});
  }

  void noInstantIsBehindTheEnd() {
    const TestFolder folder;
    ExportPlan plan = fieldImages(folder, 1);
    plan.rate = 3;
    QCOMPARE(plan.instant(0), plan.from);
    for (std::int64_t frame = 0; frame < plan.frames(); ++frame) QVERIFY(plan.instant(frame) <= plan.to);
    QCOMPARE(plan.instant(plan.frames()), plan.to);
  }

  void ratesAndSizesHaveLimits() {
    const TestFolder folder;
    for (const double rate : {0.0, 0.09, 240.1, -1.0, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()}) {
      ExportPlan plan = fieldImages(folder, 1);
      plan.rate = rate;
      QVERIFY2(problemOf(plan).contains(QStringLiteral("0.1 to 240")), qPrintable(QString::number(rate)));
    }
    for (const QSize size : {QSize(15, 480), QSize(640, 15), QSize(8193, 480), QSize(640, 8193), QSize()}) {
      ExportPlan plan = fieldImages(folder, 1);
      plan.size = size;
      QVERIFY(problemOf(plan).contains(QStringLiteral("16x16 to 8192x8192")));
    }
    ExportPlan plan = fieldImages(folder, 1);
    plan.size = {16, 8192};
    QCOMPARE(problemOf(plan), QString());
  }

  void aWeekIsTooLong() {
    const TestFolder folder;
    const QString problem = problemOf(fieldImages(folder, 7 * 24 * 3600));
    QVERIFY2(problem.contains(QStringLiteral("6048001 pictures, more than 200000")), qPrintable(problem));
    QVERIFY2(!std::filesystem::exists(folder / "images"), "what is refused makes no folder");
  }

  void onlyImagesOfTheSameViewAreInTheWay() {
    const TestFolder folder;
    for (const char* other : {"field-2-00001.png", "field-notes.png", "field-.png", "field-00001.jpg",
                              "infield-00001.png", "field.png"}) {
      folder.write((std::string("images/") + other).c_str(), "");
      QVERIFY2(problemOf(fieldImages(folder, 1)).isEmpty(), other);
    }
    folder.write("images/field-100000.png", "");
    QVERIFY(problemOf(fieldImages(folder, 1)).contains(QStringLiteral("such as field-100000.png")));
  }

  void aFileIsNoFolder() {
    const TestFolder folder;
    folder.write("images", "");
    QVERIFY(!problemOf(fieldImages(folder, 1)).isEmpty());
  }

  void withoutASessionThereIsNothing() {
    robotlink::Session session;
    const ReplayControl replay(session);
    QVERIFY(!exportable(session, replay));
    for (const char* text : {"start", "end", "1", "soon"})
      QCOMPARE(instantOf(text, session, replay).error().id, std::string("export.nothing"));
  }

  void aSizeIsTwoNumbers() {
    for (const char* wrong :
         {"640", "640x", "x480", "640x480x3", "-640x480", "640 x 480", "6.4x480", "123456x480", "640X480"})
      QVERIFY2(!sizeOf(wrong, {}), wrong);
  }
};

const GuiTest<ExportPlanTest> kExportPlanTest;

}  // namespace widgets::test

#include "ExportPlanTest.moc"
