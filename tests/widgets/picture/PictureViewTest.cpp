// SPDX-License-Identifier: GPL-3.0-or-later
// What all views that show a picture have from their shell: copying, saving, zooming, and a state that window
// layouts of earlier versions still restore.
#include "widgets/picture/PictureView.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDataStream>
#include <QJsonArray>
#include <QJsonDocument>
#include <QMessageBox>
#include <QSplitter>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/widgets/Bench.h"
#include "tests/widgets/DialogAnswer.h"
#include "widgets/drawings/DrawingsModel.h"

namespace widgets::test {
namespace {

/// The kind of a view, the beginning of its object names, and what an earlier version saved of it.
struct PictureKind {
  const char* id;
  const char* name;
  const char* state;
};

constexpr PictureKind kPictureKinds[] = {
    {"image", "image",
     R"({"stream": "red2/camera/image", "drawings": {"order": ["image/b", "image/a"], "hidden": ["image/a"]},
         "panel": true, "fit": false, "zoom": 3.5, "center": [20, 30]})"},
    {"field", "field",
     R"({"robot": "*", "send": true, "drawings": {"order": ["field/b", "robot/a"], "hidden": ["field/b"]},
         "panel": true, "move": false, "trails": true, "fit": false, "scale": 250, "center": [1.5, -0.5],
         "quarterTurns": 3})"},
    {"scene", "scene",
     R"({"robot": "red2", "drawings": {"order": ["field/b"], "hidden": []}, "panel": true, "overview": false,
         "follow": false, "behind": true, "wireFrame": true, "grid": false, "labels": false, "move": false})"},
    {"radar", "radar",
     R"({"robot": "burger", "range": 3, "northUp": true, "panel": true,
         "drawings": {"order": ["robot/path"], "hidden": ["robot/path"]}})"},
    {"color-image", "color",
     R"({"stream": "red2/camera/image", "two": false, "strokes": false, "strip": false, "right": 2})"},
    {"color-space", "colorSpace",
     R"({"space": "HSI", "pixels": false, "samples": false, "table": true, "surfaces": 1, "opacity": 0.25,
         "cut": 1, "cutAt": 0.75, "cutOther": true, "panel": false})"}};

/// What Qt's splitter of two parts saves.
QString dividedAt(qint32 first, qint32 second) {
  QByteArray bytes;
  QDataStream stream(&bytes, QIODevice::WriteOnly);
  stream << qint32{0xff} << qint32{1} << quint32{2} << first << second << true << qint32{4} << true
         << qint32{Qt::Horizontal} << true;
  return QString::fromLatin1(bytes.toBase64());
}

struct ShownPicture {
  Bench bench;
  std::unique_ptr<View> view;

  explicit ShownPicture(const PictureKind& kind)
      : view(ViewRegistry::find(kind.id)->create(bench.context, nullptr)) {
    view->resize(700, 400);
    view->show();
  }
  PictureView& picture() { return dynamic_cast<PictureView&>(*view); }
  QAction& action(const PictureKind& kind, const char* what) {
    const QString name = QLatin1String(kind.name) + QLatin1String(what) + QStringLiteral("Action");
    return child<QAction>(*view, qPrintable(name));
  }
};

}  // namespace

class PictureViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aStateOfAnEarlierVersionIsRestored() {
    for (const PictureKind& kind : kPictureKinds) {
      const QJsonObject before = QJsonDocument::fromJson(kind.state).object();
      QVERIFY2(!before.isEmpty(), kind.id);
      ShownPicture shown(kind);
      shown.view->restoreState(before);
      const QJsonObject after = shown.view->saveState();
      for (const QString& key : before.keys()) {
        QVERIFY2(after.contains(key), qPrintable(key));
        QVERIFY2(after[key] == before[key], qPrintable(QLatin1String(kind.id) + QLatin1Char(' ') + key));
      }
    }
  }

  void ofAVeryLongStateOnlyTheFirstDrawingsAreTaken() {
    QJsonArray order;
    for (int i = 0; i < 200'000; ++i) order.append(QStringLiteral("image/%1").arg(i));
    ShownPicture shown(kPictureKinds[0]);
    shown.view->restoreState({{QStringLiteral("drawings"), QJsonObject{{QStringLiteral("order"), order},
                                                                       {QStringLiteral("hidden"), order}}}});
    const QJsonObject after = shown.view->saveState()[QStringLiteral("drawings")].toObject();
    for (const char* list : {"order", "hidden"})
      QCOMPARE(after[QLatin1String(list)].toArray().size(), DrawingsModel::kMaxRestored);
  }

  void howTheViewWasDividedIsRestored() {
    for (const PictureKind& kind : kPictureKinds) {
      ShownPicture shown(kind);
      const QString name = QLatin1String(kind.name) + QStringLiteral("Splitter");
      const auto* splitter = shown.view->findChild<QSplitter*>(name);
      QVERIFY2(splitter != nullptr, kind.id);
      QJsonObject state = shown.view->saveState();
      state[QStringLiteral("panel")] = true;
      state[QStringLiteral("splitter")] = dividedAt(400, 300);
      shown.view->restoreState(state);
      const auto restored = [&] {
        const QList<int> sizes = splitter->sizes();
        return std::abs(sizes[0] * 3 - sizes[1] * 4) < 30;
      };
      QTRY_VERIFY2(restored(), kind.id);
    }
  }

  void everyPictureIsCopiedAndSaved() {
    const QTemporaryDir folder;
    for (const PictureKind& kind : kPictureKinds) {
      ShownPicture shown(kind);
      if (QLatin1String(kind.id) == QLatin1String("scene")) continue;  // its pictures need OpenGL
      QApplication::clipboard()->clear();
      shown.action(kind, "Copy").trigger();
      const QImage copied = QApplication::clipboard()->image();
      QVERIFY2(copied.width() > 100 && copied.height() > 100, kind.id);
      const QString file = folder.filePath(QLatin1String(kind.id));
      const QString other = file + QStringLiteral("-2.png");
      QVERIFY2(shown.picture().savePicture(other), kind.id);
      QCOMPARE(QImage(other).size(), copied.size());
      // A name without a suffix gets it.
      DialogAnswer answer = DialogAnswer::file(file);
      shown.action(kind, "Save").trigger();
      QVERIFY2(answer.asked(), kind.id);
      QCOMPARE(QImage(file + QStringLiteral(".png")).size(), copied.size());
    }
  }

  void aPictureThatCannotBeSavedNamesItsFile() {
    const QString file = QStringLiteral("/no/such/folder/picture.png");
    for (const PictureKind& kind : kPictureKinds) {
      ShownPicture shown(kind);
      QString said;
      DialogAnswer answer([&](QDialog& dialog) {
        said = dynamic_cast<QMessageBox&>(dialog).text();
        DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
      });
      QVERIFY2(!shown.picture().savePicture(file), kind.id);
      QVERIFY2(answer.asked() && said.contains(file), qPrintable(said));
    }
  }

  void theKeysOfZoomingAreTheSameInAllPictures() {
    for (const PictureKind& kind : kPictureKinds) {
      ShownPicture shown(kind);
      QCOMPARE(shown.action(kind, "ZoomIn").shortcut(), QKeySequence(Qt::Key_Plus));
      QCOMPARE(shown.action(kind, "ZoomOut").shortcut(), QKeySequence(Qt::Key_Minus));
      shown.action(kind, "ZoomIn").trigger();
      shown.action(kind, "ZoomOut").trigger();
    }
  }
};

const GuiTest<PictureViewTest> kPictureViewTest;

}  // namespace widgets::test

#include "PictureViewTest.moc"
