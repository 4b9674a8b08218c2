// SPDX-License-Identifier: GPL-3.0-or-later
// What all views make of a layout that somebody else's file says.
#include <QDataStream>
#include <QJsonArray>
#include <QJsonObject>
#include <QLineEdit>
#include <QSplitter>
#include <QtTest>
#include <memory>

#include "robotlink/commands/CommandTable.h"
#include "robotlink/session/Session.h"
#include "tests/widgets/GuiTest.h"
#include "widgets/SplitterState.h"
#include "widgets/View.h"
#include "widgets/world/SceneRename.h"

namespace widgets::test {
namespace {

constexpr int kUsualHandle = 40;  // pixels; no style has a wider one

/// A splitter's state as Qt writes it, with any number of sizes and any handle.
QJsonValue stateWith(quint32 count, const QList<qint32>& sizes, qint32 handle) {
  QByteArray bytes;
  QDataStream stream(&bytes, QIODevice::WriteOnly);
  stream << qint32{0xff} << qint32{1} << count;
  for (const qint32 size : sizes) stream << size;
  stream << true << handle << true << qint32{Qt::Horizontal} << true;
  return QString::fromLatin1(bytes.toBase64());
}

/// Any view, on a session with nothing in it.
struct ShownView {
  robotlink::Session session;
  robotlink::CommandTable commands;
  widgets::ViewContext context{session, commands, nullptr, {}};
  std::unique_ptr<widgets::View> view;

  explicit ShownView(const widgets::ViewType& type) : view(type.create(context, nullptr)) {}
};

}  // namespace

class ViewStateTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aHandleThatIsWiderThanAnyScreenIsNotTakenFromAState() {
    const QJsonObject state{{QStringLiteral("splitter"), stateWith(2, {100, 100}, 1 << 24)}};
    int splitters = 0;
    for (const widgets::ViewType& type : widgets::ViewRegistry::all()) {
      ShownView shown(type);
      shown.view->restoreState(state);
      for (const QSplitter* splitter : shown.view->findChildren<QSplitter*>()) {
        QVERIFY2(splitter->handleWidth() < kUsualHandle, type.id);
        ++splitters;
      }
      QVERIFY2(shown.view->minimumSizeHint().width() < 4000, type.id);
    }
    QVERIFY(splitters >= 9);
  }

  void onlyWhatNamesObjectsFollowsARename() {
    struct NamingView final : View {
      explicit NamingView(ViewContext& context)
          : View(context), title(new QLineEdit(this)), object(new QLineEdit(this)) {
        keep("title", title);
        keep("object", object, Names::kObjects);
      }
      void tick() override {}
      QLineEdit *const title, *const object;
    };
    robotlink::Session session;
    robotlink::CommandTable commands;
    ViewContext context{session, commands, nullptr, {}};
    const auto renamed = [](const QJsonValue& names) {
      return withRename(names, SceneRename{"field", "pitch"});
    };
    NamingView view(context);
    view.restoreState({{QStringLiteral("title"), QStringLiteral("field")},
                       {QStringLiteral("object"), QStringLiteral("field")}});
    view.followNames(renamed);
    QCOMPARE(view.title->text(), QStringLiteral("field"));
    QCOMPARE(view.object->text(), QStringLiteral("pitch"));
    // The first part of a drawing's name is its kind.
    const QJsonObject drawings{{QStringLiteral("order"), QJsonArray{QStringLiteral("field/ball")}},
                               {QStringLiteral("hidden"), QJsonArray()}};
    const ShownView shown(*ViewRegistry::find("field"));
    shown.view->restoreState({{QStringLiteral("drawings"), drawings}});
    shown.view->followNames(renamed);
    QCOMPARE(shown.view->saveState()[QStringLiteral("drawings")].toObject(), drawings);
    const QJsonArray curves{QStringLiteral("ports: readings[port=\"field/laser\"].x")};
    const ShownView plots(*ViewRegistry::find("plots"));
    plots.view->restoreState({{QStringLiteral("curves"), curves}});
    plots.view->followNames(renamed);
    QCOMPARE(plots.view->saveState()[QStringLiteral("curves")].toArray(),
             QJsonArray{QStringLiteral("ports: readings[port=\"pitch/laser\"].x")});
  }

  void aFieldWithTheFocusSaysNothingToAViewThatIsBeingDestroyed() {
    struct FieldView final : View {
      FieldView(ViewContext& context, int& edits) : View(context), field(new QLineEdit(this)) {
        const auto count = [&edits] { ++edits; };
        connect(field, &QLineEdit::editingFinished, this, count);
        connect(field, &QLineEdit::cursorPositionChanged, this, count);
      }
      void tick() override {}
      QLineEdit* const field;
    };
    robotlink::Session session;
    robotlink::CommandTable commands;
    ViewContext context{session, commands, nullptr, {}};
    int edits = 0;
    auto view = std::make_unique<FieldView>(context, edits);
    view->show();
    QVERIFY(QTest::qWaitForWindowActive(view.get()));
    view->field->setFocus();
    QVERIFY(view->field->hasFocus());
    QTest::keyClicks(view->field, QStringLiteral("7"));
    edits = 0;
    view.reset();
    QCOMPARE(edits, 0);
  }

  void aListThatIsLongerThanItsStateChangesNothing() {
    QSplitter splitter;
    splitter.addWidget(new QWidget);
    splitter.addWidget(new QWidget);
    const QByteArray before = splitter.saveState();
    for (const quint32 count : {3U, 0x7fffffffU, 0xffffffffU})
      widgets::restoreSplitter(splitter, stateWith(count, {1, 2}, 5));
    for (const char* text : {"", "/wAA", "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"})
      widgets::restoreSplitter(splitter, QString::fromLatin1(text));
    QCOMPARE(splitter.saveState(), before);
  }

  void theSizesOfASplitterComeBackFromItsState() {
    const auto make = [](QSplitter& splitter) {
      splitter.addWidget(new QWidget);
      splitter.addWidget(new QWidget);
      splitter.resize(605, 100);
      splitter.show();
    };
    QSplitter first, second;
    make(first);
    make(second);
    first.setSizes({450, 150});
    widgets::restoreSplitter(second, widgets::splitterState(first));
    QCOMPARE(second.sizes(), first.sizes());
    QVERIFY(second.sizes().at(0) > 2 * second.sizes().at(1));
    widgets::restoreSplitter(second, stateWith(2, {0x7fffffff, 100}, 5));
    QVERIFY(second.minimumSizeHint().width() < 1000);
  }
};

const GuiTest<ViewStateTest> kViewStateTest;

}  // namespace widgets::test

#include "ViewStateTest.moc"
