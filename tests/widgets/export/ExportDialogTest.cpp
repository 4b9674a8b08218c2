// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/export/ExportDialog.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

#include "tests/widgets/LogBench.h"

namespace widgets::test {
namespace {

/// The dialog for two views of a log from 10 to 40 s.
struct ExportedLog : LogBench {
  explicit ExportedLog(const QJsonObject& choices = {}) {
    openLog(kFile);
    dialog.emplace(
        std::vector<ExportDialog::Offer>{{QStringLiteral("image#1"), QStringLiteral("Image"), {320, 200}},
                                         {QStringLiteral("field#2"), QStringLiteral("Field"), {640, 400}}},
        QStringLiteral("field#2"), session, logs().replay(), choices, nullptr);
    dialog->show();
  }
  void choose(const char* box, int index) { child<QComboBox>(*dialog, box).setCurrentIndex(index); }
  QString target() const { return child<QLineEdit>(*dialog, "exportTarget").text(); }
  void type(const QString& text) { child<QLineEdit>(*dialog, "exportTarget").setText(text); }

  std::optional<ExportDialog> dialog;
};

enum : std::uint8_t { kAsMp4, kAsAvi, kAsImages };

}  // namespace

class ExportDialogTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theProposedNameIsThatOfTheViewAndTheKind() {
    ExportedLog log;
    const QString folder = QDir::currentPath() + QLatin1Char('/');
    QCOMPARE(log.target(), folder + QStringLiteral("field-2.mp4"));
    log.choose("exportKind", kAsImages);
    QCOMPARE(log.target(), folder + QStringLiteral("field-2-images"));
    log.choose("exportView", 0);
    QCOMPARE(log.target(), folder + QStringLiteral("image-1-images"));
  }

  void aTypedNameFollowsTheKind() {
    ExportedLog log;
    log.type(QStringLiteral("/films/match.1.mp4"));
    log.choose("exportKind", kAsAvi);
    QCOMPARE(log.target(), QStringLiteral("/films/match.1.avi"));
    log.choose("exportKind", kAsImages);
    QVERIFY2(log.target() == QStringLiteral("/films/match.1-images"), "images need a folder");
    log.choose("exportView", 0);
    QCOMPARE(log.target(), QStringLiteral("/films/match.1-images"));
    log.type(QStringLiteral("/films/match-images"));
    log.choose("exportKind", kAsMp4);
    QCOMPARE(log.target(), QStringLiteral("/films/match.mp4"));
    log.type(QStringLiteral("/films/old-images.mp4"));
    log.choose("exportView", 1);
    QCOMPARE(log.target(), QStringLiteral("/films/old-images.mp4"));
  }

  void aFolderThatIsTypedStays() {
    ExportedLog log;
    log.choose("exportKind", kAsImages);
    log.type(QStringLiteral("/films/match"));
    log.choose("exportView", 0);
    QCOMPARE(log.target(), QStringLiteral("/films/match"));
  }

  void withoutATargetNothingIsExported() {
    ExportedLog log;
    auto& ok = child<QPushButton>(*log.dialog, "exportOk");
    QVERIFY(ok.isEnabled());
    log.type(QStringLiteral("  "));
    QVERIFY(!ok.isEnabled());
    QCOMPARE(child<QLabel>(*log.dialog, "exportSummary").text(),
             QStringLiteral("Choose the output file or folder."));
  }

  void aFileThatWouldBeReplacedIsMentioned() {
    ExportedLog log;
    const TestFolder folder;
    const auto summary = [&] { return child<QLabel>(*log.dialog, "exportSummary").text(); };
    log.type(QString::fromStdString(folder.write("old.mp4", "").string()));
    QVERIFY(summary().contains(QStringLiteral("will be replaced")));
    log.type(QString::fromStdString((folder / "new.mp4").string()));
    QVERIFY(!summary().contains(QStringLiteral("will be replaced")));
  }

  void choicesThatMakeNoSenseAreNotTaken() {
    ExportedLog log({{QStringLiteral("kind"), 17},
                     {QStringLiteral("rate"), -3},
                     {QStringLiteral("width"), 1'000'000},
                     {QStringLiteral("height"), 1},
                     {QStringLiteral("folder"), QStringLiteral("/no/such/folder")}});
    QCOMPARE(child<QComboBox>(*log.dialog, "exportKind").currentIndex(), int{kAsImages});
    QCOMPARE(log.dialog->answer().rate, 0.1);
    QCOMPARE(log.dialog->answer().size, std::string("8192x16"));
    QVERIFY(log.target().startsWith(QDir::currentPath()));
    child<QToolButton>(*log.dialog, "exportAsShown").click();
    QCOMPARE(log.dialog->answer().size, std::string("640x400"));
  }

  void theWholeLogIsOneClickAway() {
    ExportedLog log;
    log.setRange(20, 25);
    QVERIFY(!child<QToolButton>(*log.dialog, "exportRange").isEnabled());
    child<QToolButton>(*log.dialog, "exportAll").click();
    const auto answer = log.dialog->answer();
    QCOMPARE(std::stod(answer.to) - std::stod(answer.from), 30.0);
  }
};

const GuiTest<ExportDialogTest> kExportDialogTest;

}  // namespace widgets::test

#include "ExportDialogTest.moc"
