// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the workbench: that they mean the same wherever the focus is, and that no two of them clash.
#include <qtadvanceddocking/DockWidget.h>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QShortcut>
#include <QStatusBar>
#include <QToolBar>
#include <QTreeWidget>
#include <QUndoStack>
#include <QtTest>
#include <map>
#include <utility>

#include "app/robotcontrol/actions/ShortcutsDialog.h"
#include "app/robotcontrol/actions/UndoOrder.h"
#include "app/robotcontrol/actions/WindowKeys.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/app/window/ReplayDesk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/DialogAnswer.h"
#include "widgets/ColumnFit.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFiles.h"

namespace app::test {

using robotcontrol::ControlReplay;

namespace {

/// The entries of a menu that Alt and the same letter would choose: "Robot: \"C&onnect\" and \"Rob&ots\"".
QStringList mnemonicClashes(const QString& menu, const QList<QAction*>& entries) {
  QStringList clashes;
  std::map<QString, QString> taken;
  for (const QAction* entry : entries) {
    const QString key = QKeySequence::mnemonic(entry->text()).toString();
    if (key.isEmpty() || !entry->isVisible()) continue;
    const auto [first, isNew] = taken.emplace(key, entry->text());
    if (!isNew) clashes << QStringLiteral("%1: \"%2\" and \"%3\"").arg(menu, first->second, entry->text());
  }
  return clashes;
}

struct KeysDesk : ReplayDesk {
  using ReplayDesk::ReplayDesk;

  widgets::View* open(const char* id) {
    ads::CDockWidget* dock = window.docks().open(QLatin1String(id));
    dock->setAsCurrentTab();
    window.tick();
    return qobject_cast<widgets::View*>(dock->widget());
  }
  WindowKeys& keys() { return find<WindowKeys>("windowKeys"); }
};

/// All below a widget that can have the focus now, and are no text fields.
std::vector<QWidget*> focusable(QWidget& in) {
  std::vector<QWidget*> found;
  for (QWidget* widget : in.findChildren<QWidget*>()) {
    if (widget->isVisible() && widget->isEnabled() && widget->focusPolicy() != Qt::NoFocus &&
        !app::isTextField(*widget))
      found.push_back(widget);
  }
  return found;
}

QByteArray nameOf(const QWidget& widget) {
  return widget.window()->objectName().toUtf8() + " " + widget.metaObject()->className() + " " +
         widget.objectName().toUtf8();
}

/// Plays, steps, jumps, chooses a class, takes back and saves with the focus on a widget.
void pressAll(KeysDesk& desk, QWidget& widget, bool colors) {
  const QByteArray name = nameOf(widget);
  const auto asks = [&](int key, Qt::KeyboardModifiers modifiers, ControlReplay::Action action, int count) {
    desk.asked.clear();
    widget.setFocus();
    QTest::keyClick(&widget, static_cast<Qt::Key>(key), modifiers);
    if (desk.asked.size() != 1 || desk.asked.front().action() != action ||
        desk.asked.front().count() != count)
      qFatal("%s: the key %s does something else", name.constData(),
             qPrintable(QKeySequence(key).toString()));
    desk.answer();
  };
  asks(Qt::Key_Space, {}, ControlReplay::PLAY, 0);
  asks(Qt::Key_Left, {}, ControlReplay::STEP_FRAME, -1);
  asks(Qt::Key_Right, {}, ControlReplay::STEP_FRAME, 1);
  asks(Qt::Key_Right, Qt::ShiftModifier, ControlReplay::STEP_FRAME, 10);
  asks(Qt::Key_Left, Qt::ControlModifier, ControlReplay::JUMP_TO_TIME, 0);
  asks(Qt::Key_Home, {}, ControlReplay::JUMP_TO_TIME, 0);
  asks(Qt::Key_End, {}, ControlReplay::JUMP_TO_TIME, 0);
  if (colors) {
    for (const int digit : {3, 0, 5}) {
      QTest::keyClick(&widget, static_cast<Qt::Key>(Qt::Key_0 + digit));
      if (desk.colors().currentClass() != digit)
        qFatal("%s: the digit %d chose nothing", name.constData(), digit);
    }
  }
  QUndoStack& stack = desk.colors().undoStack();
  stack.push(new QUndoCommand);
  const int index = stack.index();
  QTest::keyClick(&widget, Qt::Key_Z, Qt::ControlModifier);
  if (stack.index() != index - 1) qFatal("%s: Ctrl+Z took nothing back", name.constData());
  for (const auto& [key, modifiers] : {std::pair{Qt::Key_Y, Qt::KeyboardModifiers(Qt::ControlModifier)},
                                       {Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier}}) {
    QTest::keyClick(&widget, key, modifiers);
    if (stack.index() != index) qFatal("%s: nothing was done again", name.constData());
    stack.undo();
  }
  stack.clear();
  desk.window.statusBar()->clearMessage();
  QTest::keyClick(&widget, Qt::Key_S, Qt::ControlModifier);
  if (!desk.window.statusBar()->currentMessage().startsWith(QStringLiteral("Everything is saved")))
    qFatal("%s: Ctrl+S saved nothing", name.constData());
}

/// Keys with Ctrl or Alt, and those of the top row, mean one thing in the whole program.
bool meansOneThing(const QKeySequence& key) {
  const int code = key[0];
  const int plain = code & ~static_cast<int>(Qt::KeyboardModifierMask);
  return (code & static_cast<int>(Qt::ControlModifier | Qt::AltModifier)) != 0 ||
         (plain >= Qt::Key_F1 && plain <= Qt::Key_F35);
}

/// What the texts of actions come down to: "Copy picture" is a way to copy.
QString meaning(const QKeySequence& key, const QString& text) {
  static const std::map<QString, QString> families = {
      {QStringLiteral("Ctrl+C"), QStringLiteral("copies what is chosen or seen")},
      {QStringLiteral("Ctrl+Shift+E"), QStringLiteral("writes what is seen to a file")},
      {QStringLiteral("Ctrl+Return"), QStringLiteral("does it with what is chosen")},
      {QStringLiteral("Ctrl+Backspace"), QStringLiteral("gives it what it was at first")},
      {QStringLiteral("Shift+F5"), QStringLiteral("asks the robot again")}};
  const auto family = families.find(key.toString());
  return family != families.end() ? family->second : text;
}

}  // namespace

class KeysGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void everyKeyMeansTheSameInEveryView() {
    KeysDesk desk(home_);
    desk.openLog();
    for (const widgets::ViewType& type : widgets::ViewRegistry::all()) {
      desk.window.docks().closeAll();
      widgets::View* view = desk.open(type.id);
      QVERIFY2(view != nullptr, type.id);
      const bool colors = QByteArray(type.id).startsWith("color-");
      pressAll(desk, *view, colors);
      for (QWidget* widget : focusable(*view)) pressAll(desk, *widget, colors);
    }
  }

  void everyKeyMeansTheSameInTheToolBarsAndInAFloatingDock() {
    KeysDesk desk(home_);
    desk.openLog();
    desk.window.showPerspective(QStringLiteral("Colour"));
    for (QToolBar* bar : desk.window.findChildren<QToolBar*>()) {
      if (!bar->isVisible()) continue;
      for (QWidget* widget : focusable(*bar)) pressAll(desk, *widget, true);
    }
    auto* dock = desk.window.docks().docks(QStringLiteral("time-line")).front();
    dock->setFloating();
    desk.window.tick();
    for (QWidget* widget : focusable(*dock->widget())) pressAll(desk, *widget, true);
  }

  void aTextFieldKeepsItsKeys() {
    KeysDesk desk(home_);
    desk.openLog();
    desk.open("color-image");
    auto* keys = desk.open("debug-keys");
    auto& search = child<QLineEdit>(*keys, "keysSearch");
    search.setFocus();
    desk.asked.clear();
    const int before = desk.colors().currentClass();
    QTest::keyClicks(&search, QStringLiteral("a 3.,5"));
    for (const auto key : {Qt::Key_Home, Qt::Key_End, Qt::Key_Left, Qt::Key_Right})
      QTest::keyClick(&search, key);
    QTest::keyClick(&search, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(desk.asked.empty());
    QCOMPARE(desk.colors().currentClass(), before);
  }

  void digitsChooseClassesAgainAfterANumberWasEntered() {
    KeysDesk desk(home_);
    desk.openLog();
    auto* image = desk.open("color-image");
    auto& radius = child<QDoubleSpinBox>(*image, "colorRadius");
    radius.setFocus();
    radius.selectAll();
    QTest::keyClicks(&radius, QStringLiteral("8"));
    QTest::keyClick(&radius, Qt::Key_Return);
    QTRY_VERIFY(!radius.hasFocus());
    QCOMPARE(radius.value(), 8.0);
    QWidget* focus = desk.window.focusWidget();
    QVERIFY(focus != nullptr && image->isAncestorOf(focus));
    QTest::keyClick(focus, Qt::Key_3);
    QCOMPARE(desk.colors().currentClass(), 3);
    QCOMPARE(radius.value(), 8.0);
  }

  void aDialogKeepsItsKeys() {
    KeysDesk desk(home_);
    desk.openLog();
    desk.asked.clear();
    QDialog dialog(&desk.window);
    QPushButton button(&dialog);
    dialog.show();
    QSignalSpy clicked(&button, &QPushButton::clicked);
    QTest::keyClick(&button, Qt::Key_Space);
    QCOMPARE(clicked.count(), 1);
    QVERIFY(desk.asked.empty());
  }

  void theFocusBelongsToAViewAtTheStartAndAfterAPerspectiveWasChosen() {
    KeysDesk desk(home_);
    const auto inView = [&desk] {
      const QWidget* widget = desk.window.focusWidget();
      while (widget != nullptr && qobject_cast<const widgets::View*>(widget) == nullptr)
        widget = widget->parentWidget();
      return widget != nullptr;
    };
    QVERIFY(inView());
    for (const char* perspective : {"Log", "Colour", "Play"}) {
      desk.window.showPerspective(QLatin1String(perspective));
      QCoreApplication::processEvents();
      QTRY_VERIFY2(inView(), perspective);
    }
  }

  void noTwoKeysClash() {
    KeysDesk desk(home_);
    desk.openLog();
    for (const widgets::ViewType& type : widgets::ViewRegistry::all()) desk.open(type.id);
    const auto all = desk.window.shortcuts().all();
    QVERIFY2(all.size() > 60, qPrintable(QString::number(all.size())));
    QStringList clashes;
    for (const app::Shortcut& a : all) {
      for (const app::Shortcut& b : all) {
        if (&a >= &b || a.key != b.key || meaning(a.key, a.text) == meaning(b.key, b.text)) continue;
        const bool together = a.view.isEmpty() || b.view.isEmpty() || a.view == b.view;
        if (!together && !meansOneThing(a.key)) continue;
        clashes << QStringLiteral("%1: %2 \"%3\" and %4 \"%5\"")
                       .arg(a.key.toString(), a.view, a.text, b.view, b.text);
      }
    }
    QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join(QLatin1Char('\n'))));
  }

  void noTwoEntriesOfAMenuHaveTheSameLetter() {
    KeysDesk desk(home_);
    desk.openLog();
    QStringList clashes = mnemonicClashes(QStringLiteral("menu bar"), desk.window.menuBar()->actions());
    const QList<QMenu*> menus = desk.window.findChildren<QMenu*>();
    QVERIFY(menus.size() > 10);
    for (const QMenu* menu : menus) clashes += mnemonicClashes(menu->title(), menu->actions());
    QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join(QLatin1Char('\n'))));
  }

  void theListOfKeysFitsTheScreenAndIsSearched() {
    KeysDesk desk(home_);
    app::ShortcutsDialog dialog(desk.window.shortcuts(), &desk.window);
    dialog.show();
    const QSize screen = desk.window.screen()->availableSize();
    QVERIFY(dialog.height() <= screen.height() && dialog.width() <= screen.width());
    auto& list = child<QTreeWidget>(dialog, "shortcutsList");
    QVERIFY(list.topLevelItemCount() > 3);
    QCOMPARE(list.topLevelItem(0)->text(0), QStringLiteral("Everywhere"));
    QVERIFY(widgets::ColumnFit::of(*list.header()) != nullptr);
    dialog.resize(360, dialog.height());
    QCoreApplication::processEvents();
    QVERIFY2(list.columnWidth(0) + list.columnWidth(1) <= list.viewport()->width(), "no key is out of sight");
    QTest::keyClicks(&child<QLineEdit>(dialog, "shortcutsSearch"), QStringLiteral("frame back"));
    int shown = 0;
    for (int i = 0; i < list.topLevelItem(0)->childCount(); ++i)
      shown += list.topLevelItem(0)->child(i)->isHidden() ? 0 : 1;
    QCOMPARE(shown, 1);
    QVERIFY(list.topLevelItem(1)->isHidden());
  }

  void aShortcutIsChangedRememberedAndReset() {
    const auto keyOf = [](Desk& desk) { return desk.find<QAction>("help.commands").shortcut(); };
    const QKeySequence shipped(QStringLiteral("Ctrl+P")), chosen(QStringLiteral("Ctrl+Alt+K"));
    {
      KeysDesk desk(home_);
      app::ShortcutsDialog dialog(desk.window.shortcuts(), &desk.window);
      dialog.show();
      auto& list = child<QTreeWidget>(dialog, "shortcutsList");
      list.setCurrentItem(
          list.findItems(shipped.toString(), Qt::MatchExactly | Qt::MatchRecursive, 1).first());
      child<QKeySequenceEdit>(dialog, "shortcutsKey").setKeySequence(QKeySequence(QStringLiteral("Ctrl+Z")));
      click(child<QPushButton>(dialog, "shortcutsAssign"));
      QVERIFY(child<QLabel>(dialog, "shortcutsState").text().contains(QStringLiteral("\"Undo\"")));
      QCOMPARE(keyOf(desk), shipped);
      child<QKeySequenceEdit>(dialog, "shortcutsKey").setKeySequence(chosen);
      click(child<QPushButton>(dialog, "shortcutsAssign"));
      QCOMPARE(keyOf(desk), chosen);
      QCOMPARE(list.currentItem()->text(1), chosen.toString());
      widgets::test::keepPicture(dialog, "shortcuts-edited");
    }
    {
      KeysDesk desk(home_);
      QCOMPARE(keyOf(desk), chosen);
      app::ShortcutsDialog dialog(desk.window.shortcuts(), &desk.window);
      dialog.show();
      click(child<QPushButton>(dialog, "shortcutsResetAll"));
      QCOMPARE(keyOf(desk), shipped);
    }
    KeysDesk desk(home_);
    QCOMPARE(keyOf(desk), shipped);
  }

  void keysOfTheWindowAndOfViewsThatOpenLaterAreChangedToo() {
    const auto find = [](Desk& desk, const QString& key, const QString& view) {
      const auto all = desk.window.shortcuts().all();
      const auto found = std::ranges::find_if(all, [&](const app::Shortcut& each) {
        return each.shipped == QKeySequence(key) && each.view == view;
      });
      if (found == all.end()) qFatal("there is no such shortcut");
      return *found;
    };
    const QString solutions = QStringLiteral("Solutions"), parameters = QStringLiteral("Ctrl+Shift+I");
    const QKeySequence another(QStringLiteral("Ctrl+Alt+F9"));
    KeysDesk desk(home_);
    desk.open("solutions");
    QVERIFY(desk.window.shortcuts().assign(find(desk, parameters, solutions), another));
    desk.window.docks().closeAll();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    desk.open("solutions");
    QCOMPARE(find(desk, parameters, solutions).key, another);
    QVERIFY(desk.find<QAction>("solutionsParametersAction").toolTip().contains(another.toString()));
    QVERIFY(desk.window.shortcuts().assign(find(desk, QStringLiteral("Ctrl+S"), QString()), {}));
    QCOMPARE(find(desk, QStringLiteral("Ctrl+S"), QString()).key, QKeySequence());
    QVERIFY(desk.window.shortcuts().resetAll());
    QCOMPARE(find(desk, QStringLiteral("Ctrl+S"), QString()).key, QKeySequence(QStringLiteral("Ctrl+S")));
  }

  void undoTakesBackWhatWasEditedLast() {
    QUndoStack first, second;
    app::UndoOrder order;
    order.add(&first);
    order.add(&second);
    QVERIFY(order.undo() == nullptr);
    first.push(new QUndoCommand);
    second.push(new QUndoCommand);
    second.push(new QUndoCommand);
    QVERIFY(order.undo() == &second);
    QVERIFY(order.redo() == &second);
    QVERIFY(order.undo() == &second);
    QVERIFY(order.undo() == &second);
    QVERIFY(order.undo() == &first);
    first.redo();
    {
      QUndoStack third;
      order.add(&third);
      third.push(new QUndoCommand);
      QVERIFY(order.undo() == &third);
    }
    QVERIFY(order.undo() == &first);
  }

  void whatIsOpenIsNotReplacedUnaskedWhileSamplesAreUnsaved() {
    KeysDesk desk(home_);
    desk.workbench.open(SimulationFeed::opening(defaultSimulation()));
    QTRY_VERIFY_WITH_TIMEOUT(desk.workbench.loaded() != nullptr, 20000);
    desk.colors().undoStack().push(new QUndoCommand);
    QVERIFY(widgets::colorFiles(const_cast<widgets::ViewContext&>(desk.window.context())).changed());
    auto& scenes = child<QComboBox>(desk.window, "sceneBox");
    const auto choose = [&scenes] { Q_EMIT scenes.activated(0); };
    DialogAnswer cancel([](QDialog& dialog) {
      if (dialog.objectName() != QStringLiteral("unsavedWork")) qFatal("another dialog");
      DialogAnswer::press(dialog, QDialogButtonBox::RejectRole);
    });
    choose();
    QVERIFY(cancel.asked());
    QVERIFY(!desk.workbench.loading());
    DialogAnswer proceed(
        [](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::DestructiveRole); });
    choose();
    QVERIFY(proceed.asked());
    QVERIFY(desk.workbench.loading());
    QTRY_VERIFY_WITH_TIMEOUT(!desk.workbench.loading() || (desk.window.tick(), false), 20000);
    desk.colors().undoStack().clear();
  }
};

const widgets::test::GuiTest<KeysGuiTest> kKeysGuiTest;

}  // namespace app::test

#include "KeysGuiTest.moc"
