// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorCommands.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include "colortool/samples/SampleFile.h"
#include "robotlink/commands/CommandCatalog.h"
#include "tests/widgets/CameraBench.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/color/ColorFrameFinder.h"
#include "widgets/color/ColorSender.h"

namespace widgets::test {

/// The color table as a script makes it.
class ColorCommandsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() {
    world_ = std::make_unique<CameraBench>();
    for (const auto& row : robotlink::colorCatalog()) world_->commands.add(row);
    addColorCommands(world_->context);
    addColorCommands(world_->context);  // a second window adds none
    bench_ = world_->context.colors.get();
  }

  void aScriptMakesATable() {
    bench_->setFrame(world_->frame());
    for (const char* line :
         {"color.preset bhuman2009", "color.class orange", "color.stroke 8 7 3", "color.class green",
          "color.weight 2", "color.stroke 30 7 3", "color.must-not on", "color.stroke 8 22 3",
          "color.must-not off", "color.class background", "color.stroke 30 22 3"})
      does(line);
    const auto& strokes = bench_->samples().strokes;
    QCOMPARE(strokes.size(), std::size_t{4});
    QCOMPARE(strokes[1]->weight, 2.0);
    QVERIFY(strokes[2]->mustNotBe && !strokes[3]->mustNotBe);
    QTRY_VERIFY(bench_->upToDate());
    QCOMPARE(int{bench_->colors()->classes->row(3)[3]}, 1);
    does("color.undo");
    QCOMPARE(bench_->samples().strokes.size(), std::size_t{3});
    does("color.redo");
    QVERIFY(fails("color.redo").find("nothing") != std::string::npos);
    does("color.send");
    QVERIFY(world_->requests.back().has_set_color_table());
    does("color.auto-send on");
    QVERIFY(widgets::colorSender(*bench_).autoSend());
    does("color.auto-send off");
    does("color.method gaussians");
    does("color.option gaussian-distance 20");
    QCOMPARE(bench_->samples().settings.gaussians.mostSquaredDistance, 20.0);
  }

  void framesAreSearched() {
    QVERIFY(fails("color.find-frames").find("no images to search") != std::string::npos);
    world_->show();
    bench_->setFrame(world_->frame());
    does("color.find-frames");
    ColorFrameFinder& finder = colorFrameFinder(world_->context);
    QTRY_VERIFY(!finder.busy());
    QCOMPARE(finder.progress().seen, std::uint64_t{1});
  }

  void filesAreWrittenAndChangesAreNotLost() {
    const QTemporaryDir folder;
    const std::string samples = folder.filePath(QStringLiteral("a.samples")).toStdString(),
                      table = folder.filePath(QStringLiteral("a.c64")).toStdString();
    bench_->setDocument(colortool::quarterSamples(), true);
    for (const char* line : {"color.new", "color.open"})
      QVERIFY(fails(line + (line == std::string("color.open") ? " \"" + samples + "\"" : ""))
                  .find("color.discard") != std::string::npos);
    QVERIFY(fails("color.save").find("color.save-as") != std::string::npos);
    does("color.save-as \"" + samples + "\"");
    does("color.export \"" + table + "\"");
    does("color.compare \"" + table + "\"");
    QVERIFY(bench_->reference() != nullptr);
    does("color.compare none");
    QVERIFY(bench_->reference() == nullptr);
    does("color.compare now");
    QTRY_VERIFY(bench_->upToDate());
    QVERIFY(*bench_->reference() == *bench_->colors()->table);
    does("color.preset 2002");
    does("color.discard");  // as saved
    QCOMPARE(bench_->samples(), colortool::quarterSamples());
    does("color.new");
    QVERIFY(bench_->samples().strokes.empty());
    does("color.merge \"" + samples + "\"");
    QCOMPARE(bench_->samples().strokes.size(), std::size_t{4});
    does("color.discard");
    does("color.open \"" + samples + "\"");
    QCOMPARE(colorFiles(world_->context).title(), QStringLiteral("a.samples"));
  }

  void whatCannotBeIsRefusedWithWhatCan() {
    QVERIFY(fails("color.stroke 1 1 3").find("no image") != std::string::npos);
    bench_->setFrame(world_->frame());
    QVERIFY(fails("color.stroke 100 100 3").find("outside") != std::string::npos);
    QVERIFY(fails("color.stroke 1 1 -1").find("radius") != std::string::npos);
    QVERIFY(fails("color.class violet").find("orange, ") != std::string::npos);
    QVERIFY(fails("color.weight 11").find("0.1 and 10") != std::string::npos);
    QVERIFY(fails("color.preset 1999").find("bhuman2009") != std::string::npos);
    QVERIFY(fails("color.method magic").find("votes") != std::string::npos);
    QVERIFY(fails("color.option radius 99").find("between 2 and 24") != std::string::npos);
    QVERIFY(fails("color.undo").find("nothing to undo") != std::string::npos);
    QVERIFY(!colorFiles(world_->context).changed());
  }

  void commandsOutliveTheirWindow() {
    world_->context.colors.reset();
    bench_ = nullptr;
    QVERIFY(fails("color.undo").find("closed") != std::string::npos);
  }

 private:
  void does(const std::string& line) {
    const auto done = world_->commands.runLine(line);
    QVERIFY2(done.has_value(), done ? "" : done.error().describe().c_str());
  }
  std::string fails(const std::string& line) {
    const auto done = world_->commands.runLine(line);
    return done ? line + " was done" : done.error().describe();
  }

  std::unique_ptr<CameraBench> world_;
  ColorBench* bench_ = nullptr;
};

const GuiTest<ColorCommandsTest> kColorCommandsTest;

}  // namespace widgets::test

#include "ColorCommandsTest.moc"
