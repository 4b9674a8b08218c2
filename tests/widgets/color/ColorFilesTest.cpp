// SPDX-License-Identifier: GPL-3.0-or-later
// The files of samples and tables as a person handles them: saved, merged, damaged, lost in a crash.
#include "widgets/color/ColorFiles.h"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <set>

#include "colortool/samples/SampleFile.h"
#include "colortool/table/NamedColorTable.h"
#include "colortool/training/TableTrainer.h"
#include "tests/widgets/CameraBench.h"
#include "tests/widgets/DialogAnswer.h"
#include "widgets/color/ColorFileActions.h"
#include "widgets/color/ColorRecovery.h"
#include "widgets/color/samples/ColorClassesView.h"

namespace widgets::test {

constexpr int kTicksUntilKept = 61;

/// A workbench's color view, and what it would say.
struct Sitting {
  Sitting() : bench(colorBench(world.context)), files(colorFiles(world.context)) {
    bench.setFrame(world.frame());
    QObject::connect(&bench, &ColorBench::failed, [this](const QString& reason) { failed << reason; });
    QObject::connect(&files, &ColorFiles::reported, [this](const QString& text) { reported << text; });
  }
  void stroke(int colorClass, double x, double y) {
    bench.setCurrentClass(colorClass);
    const colortool::ImagePoint at[] = {{x, y}};
    bench.addStroke(colortool::brushArea(40, 30, at, 3), "brush");
  }
  void passTime() {
    for (int i = 0; i < kTicksUntilKept; ++i) files.tick();
  }
  std::size_t strokes() const { return bench.samples().strokes.size(); }

  CameraBench world;
  ColorBench& bench;
  ColorFiles& files;
  QStringList failed, reported;
};

class ColorFilesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void samplesAreSavedAndComeBack() {
    Sitting first;
    ColorClassesView view(first.world.context);
    QSignalSpy titles(&view, &View::titleChanged);
    first.bench.setDocument(colortool::quarterSamples());
    first.stroke(1, 10, 8);
    QCOMPARE(titles.last()[0].toString(), QStringLiteral("Color classes: unnamed*"));
    const auto file = path("game.samples");
    {
      const auto name = DialogAnswer::file(text(file));
      click(view, "colorSave");
      QVERIFY(name.asked());
    }
    QCOMPARE(titles.last()[0].toString(), QStringLiteral("Color classes: game.samples"));
    QVERIFY(!first.files.changed());
    first.stroke(1, 12, 8);
    click(view, "colorSave");  // asks nothing any more
    QVERIFY(!first.files.changed());

    Sitting second;
    ColorClassesView other(second.world.context);
    const auto name = DialogAnswer::file(text(file));
    click(other, "colorOpen");
    QCOMPARE(second.bench.samples(), first.bench.samples());
    QCOMPARE(second.files.title(), QStringLiteral("game.samples"));
    QVERIFY(second.failed.isEmpty());
  }

  void undoingBackToWhatWasSavedIsNoChange() {
    Sitting at;
    at.stroke(1, 8, 7);
    QVERIFY(at.files.saveAs(path("a.samples")));
    at.stroke(2, 30, 7);
    QVERIFY(at.files.changed());
    at.bench.undoStack().undo();
    QVERIFY(!at.files.changed());
  }

  void nobodyIsAskedWithoutChangesAndCancelKeepsThem() {
    Sitting at;
    QVERIFY(mayLoseSamples(at.files, nullptr));
    at.stroke(1, 8, 7);
    const DialogAnswer cancel(
        [](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::RejectRole); });
    QVERIFY(!mayLoseSamples(at.files, nullptr));
    QVERIFY(cancel.asked());
    ColorClassesView view(at.world.context);
    {
      const DialogAnswer no(
          [](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::RejectRole); });
      click(view, "colorNew");
      QVERIFY(no.asked());
    }
    QCOMPARE(at.strokes(), std::size_t{1});
    const DialogAnswer discard(
        [](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::DestructiveRole); });
    click(view, "colorNew");
    QVERIFY(discard.asked());
    QCOMPARE(at.strokes(), std::size_t{0});
    QVERIFY(!at.files.changed());
  }

  void savingOnTheWayOutKeepsTheChanges() {
    Sitting at;
    at.stroke(1, 8, 7);
    QVERIFY(at.files.saveAs(path("a.samples")));
    at.stroke(2, 30, 7);
    const DialogAnswer save(
        [](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole); });
    QVERIFY(mayLoseSamples(at.files, nullptr));
    QCOMPARE(colortool::loadSamples(path("a.samples"))->samples.strokes.size(), std::size_t{2});
  }

  void aFileThatIsNoneChangesNothing() {
    Sitting at;
    at.stroke(1, 8, 7);
    std::ofstream(path("no.samples")) << "GIF89a";
    for (const auto& file : {path("no.samples"), path("missing.samples")}) {
      const auto opened = at.files.open(file);
      QVERIFY(!opened);
      QVERIFY(opened.error().describe().find(file.filename().string()) != std::string::npos);
      QVERIFY(!at.files.merge(file));
      QVERIFY(!at.files.importReference(file));
    }
    QCOMPARE(at.strokes(), std::size_t{1});
    QVERIFY(at.bench.reference() == nullptr);
  }

  void aDamagedFileIsOpenedInPartAndStaysAsItIs() {
    const auto file = path("damaged.samples");
    QVERIFY(colortool::saveSamples(colortool::quarterSamples(), file));
    const std::string damaged = damageLastLine(file);
    Sitting at;
    ColorClassesView view(at.world.context);
    const auto name = DialogAnswer::file(text(file));
    click(view, "colorOpen");
    QCOMPARE(at.strokes(), std::size_t{3});
    QCOMPARE(at.failed.size(), 1);
    QVERIFY(at.failed[0].contains(QStringLiteral("damaged.samples:")));
    QVERIFY(child<QLabel>(view, "colorMessage").text().contains(QStringLiteral("Only a part")));
    QVERIFY(at.files.file().empty());
    QVERIFY(at.files.changed());
    QVERIFY2(!at.files.save(), "there must be no file that it could be saved to by mistake");
    QCOMPARE(read(file), damaged);
  }

  void mergedStrokesAreOneStep() {
    QVERIFY(colortool::saveSamples(colortool::quarterSamples(), path("other.samples")));
    Sitting at;
    at.bench.setDocument(colortool::emptySamples());
    at.stroke(1, 8, 7);
    QVERIFY(at.files.merge(path("other.samples")));
    QCOMPARE(at.strokes(), std::size_t{5});
    QVERIFY(at.reported.last().contains(QStringLiteral("4 strokes")));
    at.bench.undoStack().undo();
    QCOMPARE(at.strokes(), std::size_t{1});
  }

  void theTableIsExportedWithItsClassesAndReadToCompare() {
    Sitting at;
    QVERIFY2(!at.files.exportTable(path("none.c64"), false), "there is nothing to make a table of");
    at.bench.setDocument(colortool::quarterSamples());
    ColorClassesView view(at.world.context);
    const auto name = DialogAnswer::file(text(path("t.c64")));
    menuAction(view, "colorExport")->trigger();
    const auto table = colortool::NamedColorTable::load(path("t.c64"));
    QVERIFY(table.has_value());
    QCOMPARE(table->classes, at.bench.samples().classes);
    colortool::TableTrainer trainer;
    const auto cells = trainer.train(at.bench.samples()).cells();
    QVERIFY(std::ranges::equal(table->file.singleClasses(), cells));

    // Compared by the names of classes, whatever their numbers are.
    at.bench.setDocument({});
    QVERIFY(at.files.importReference(path("t.c64")));
    QCOMPARE(at.bench.referenceName(), QStringLiteral("t.c64"));
    const auto green = at.bench.samples().classes.index("green");
    QCOMPARE(at.bench.reference()->classOf({90, 110, 90}), green);
  }

  void exportedCellsMayHaveSeveralClasses() {
    Sitting at;
    auto samples = colortool::quarterSamples();
    samples.settings.votes.radius = 24;  // so that classes meet
    samples.settings.votes.rejection = 0;
    at.bench.setDocument(samples);
    QVERIFY(at.files.exportTable(path("one.c64"), false));
    QVERIFY(at.files.exportTable(path("several.c64"), true));
    const auto isSeveral = [](std::uint8_t cell) {
      return (cell & colortool::ColorTableFile::kSeveral) != 0;
    };
    const auto one = colortool::ColorTableFile::load(path("one.c64")),
               several = colortool::ColorTableFile::load(path("several.c64"));
    QCOMPARE(std::ranges::count_if(one->cells, isSeveral), std::ptrdiff_t{0});
    QVERIFY(std::ranges::count_if(several->cells, isSeveral) > 100);
  }

  void classesThatAMaskHasNoRoomForAreReported() {
    Sitting at;
    auto samples = colortool::quarterSamples();
    std::vector<colortool::NamedColor> many;
    for (int i = 1; i <= 8; ++i) many.push_back({"class " + std::to_string(i), {}});
    const std::uint8_t numbers[] = {0, 7, 8, 1};
    colortool::changeClasses(samples, colortool::ColorClasses(many),
                             {std::begin(numbers), std::end(numbers)});
    samples.settings.votes.radius = 24;
    samples.settings.votes.rejection = 0;
    at.bench.setDocument(samples);
    QVERIFY(at.files.exportTable(path("t.c64"), true));
    QVERIFY(at.reported.last().contains(QStringLiteral("no room")));
  }

  void whatWasNotSavedComesBackAfterACrash() {
    colortool::Samples lost;
    {
      Sitting crashed;
      crashed.files.startRecovery(path("colors"));
      crashed.stroke(1, 8, 7);
      crashed.stroke(2, 30, 7);
      lost = crashed.bench.samples();
      crashed.files.tick();
      QVERIFY2(!std::filesystem::exists(recoveryFile()), "it was not yet time");
      crashed.passTime();
    }  // neither saved nor discarded
    QVERIFY(std::filesystem::exists(recoveryFile()));
    {
      Sitting next;
      next.files.startRecovery(path("colors"));
      QCOMPARE(next.bench.samples(), lost);
      QVERIFY(next.files.changed());
      QVERIFY(next.reported.last().contains(QStringLiteral("2 strokes")));
      QVERIFY(next.files.saveAs(path("saved.samples")));
    }
    QVERIFY(!std::filesystem::exists(recoveryFile()));
    Sitting third;
    third.files.startRecovery(path("colors"));
    QCOMPARE(third.strokes(), std::size_t{0});
    QVERIFY(third.reported.isEmpty());
  }

  void whatWasDiscardedDoesNotComeBack() {
    {
      Sitting at;
      at.files.startRecovery(path("colors"));
      at.stroke(1, 8, 7);
      at.passTime();
      at.files.discard();
      at.files.keepNow();
    }
    QVERIFY(!std::filesystem::exists(recoveryFile()));
  }

  void twoProgramsKeepTheirsApart() {
    Sitting first, second;
    first.files.startRecovery(path("colors"));
    first.stroke(1, 8, 7);
    first.files.keepNow();
    second.files.startRecovery(path("colors"));
    QCOMPARE(second.strokes(), std::size_t{0});
    second.stroke(2, 30, 7);
    second.stroke(2, 32, 7);
    second.files.keepNow();
    QCOMPARE(colortool::loadSamples(recoveryFile())->samples.strokes.size(), std::size_t{1});
    QCOMPARE(colortool::loadSamples(path("colors/recovery-2.samples"))->samples.strokes.size(),
             std::size_t{2});
  }

  void aDozenProgramsKeepTheirsApartAndAllOfItComesBack() {
    constexpr std::size_t kPrograms = 12;
    {
      std::vector<std::unique_ptr<widgets::ColorRecovery>> programs;
      std::set<std::filesystem::path> files;
      for (std::size_t i = 0; i < kPrograms; ++i) {
        programs.push_back(
            std::make_unique<widgets::ColorRecovery>(path("colors"), [](const robotlink::Error&) {}));
        files.insert(programs.back()->file());
        QVERIFY(!programs.back()->left());
        programs.back()->keep(colortool::quarterSamples());
        programs.back()->finish();
      }
      QCOMPARE(files.size(), kPrograms);
    }  // all of them crashed
    std::vector<std::unique_ptr<widgets::ColorRecovery>> next;
    for (std::size_t i = 0; i < kPrograms; ++i) {
      next.push_back(
          std::make_unique<widgets::ColorRecovery>(path("colors"), [](const robotlink::Error&) {}));
      const auto left = next.back()->left();
      QVERIFY2(left && *left, std::to_string(i).c_str());
      QCOMPARE((*left)->samples, colortool::quarterSamples());
    }
  }

  void aDamagedRecoveryFileIsSetAside() {
    std::filesystem::create_directories(path("colors"));
    QVERIFY(colortool::saveSamples(colortool::quarterSamples(), recoveryFile()));
    const std::string damaged = damageLastLine(recoveryFile());
    Sitting at;
    at.files.startRecovery(path("colors"));
    QCOMPARE(at.strokes(), std::size_t{3});
    QCOMPARE(at.failed.size(), 1);
    QVERIFY(at.failed[0].contains(QStringLiteral("recovery-damaged-1.samples")));
    QCOMPARE(read(path("colors/recovery-damaged-1.samples")), damaged);
  }

  void whatCannotBeKeptIsReported() {
    std::ofstream(path("colors")) << "a file where the folder should be";
    Sitting at;
    at.files.startRecovery(path("colors"));
    at.stroke(1, 8, 7);
    at.files.keepNow();
    QTRY_VERIFY(!at.failed.isEmpty());
    QVERIFY(at.failed[0].contains(QStringLiteral("cannot be backed up")));
  }

 private:
  std::filesystem::path path(const char* name) const {
    return std::filesystem::path(folder_->path().toStdString()) / name;
  }
  std::filesystem::path recoveryFile() const { return path("colors/recovery.samples"); }
  static QString text(const std::filesystem::path& file) { return QString::fromStdString(file.string()); }
  static std::string read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// Cuts a file within its last line; what is left.
  static std::string damageLastLine(const std::filesystem::path& file) {
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 40);
    return read(file);
  }
  static QAction* menuAction(QWidget& view, const char* name) {
    return &child<QAction>(child<QMenu>(view, "colorFileMenu"), name);
  }

  std::unique_ptr<QTemporaryDir> folder_;
};

const GuiTest<ColorFilesTest> kColorFilesTest;

}  // namespace widgets::test

#include "ColorFilesTest.moc"
