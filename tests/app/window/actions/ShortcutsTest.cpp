// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/Shortcuts.h"

#include <QAction>
#include <QWidget>
#include <QtTest>

#include "app/robotcontrol/actions/WindowKeys.h"
#include "tests/TestFolder.h"
#include "tests/widgets/GuiTest.h"

namespace app::test {
namespace {

QKeySequence keys(const char* text) {
  return QKeySequence(QLatin1String(text));
}

/// A window with three actions and one key of its own, whose choices are in a file. Another one with the same
/// file is a restart.
struct KeyedWindow {
  explicit KeyedWindow(const std::filesystem::path& file) {
    addAction("save", "&Save", "Ctrl+S");
    addAction("open", "&Open…", "Ctrl+O");
    addAction("", "Nameless", "Ctrl+N");
    WindowKeys::Binding space;
    space.key = keys("Space");
    space.text = QStringLiteral("Plays");
    space.run = [] {};
    windowKeys = new WindowKeys(window);
    windowKeys->add(space);
    shortcuts = new Shortcuts(*windowKeys, file, window);
  }
  void addAction(const char* name, const char* text, const char* key) {
    auto* action = new QAction(QString::fromUtf8(text), &window);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(keys(key));
    action->setToolTip(QStringLiteral("Does it (%1)").arg(action->shortcut().toString()));
    window.addAction(action);
  }
  Shortcut find(const char* text) const {
    for (const Shortcut& each : shortcuts->all())
      if (each.text == QString::fromUtf8(text)) return each;
    qFatal("nothing has the text %s", text);
  }
  QAction& action(const char* name) const {
    auto* found = window.findChild<QAction*>(QLatin1String(name));
    if (found == nullptr) qFatal("there is no action %s", name);
    return *found;
  }
  /// Why a key is refused; empty: it is not.
  QString assign(const char* text, const char* key) const {
    const auto done = shortcuts->assign(find(text), keys(key));
    return done ? QString() : QString::fromStdString(done.error().text);
  }

  QWidget window;
  WindowKeys* windowKeys = nullptr;
  Shortcuts* shortcuts = nullptr;
};

}  // namespace

class ShortcutsTest : public QObject {
  Q_OBJECT
 private:
  std::filesystem::path file() const { return *folder_ / "shortcuts.json"; }
  std::unique_ptr<TestFolder> folder_;

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<TestFolder>(); }

  void allKeysAreListedWithWhatTheyDo() {
    const KeyedWindow shown(file());
    QCOMPARE(shown.shortcuts->all().size(), std::size_t{4});
    const Shortcut save = shown.find("Save"), plays = shown.find("Plays");
    QCOMPARE(save.key, keys("Ctrl+S"));
    QCOMPARE(save.view, QString());
    QCOMPARE(save.owner, static_cast<QObject*>(&shown.action("save")));
    QVERIFY(plays.owner == nullptr);
    QCOMPARE(plays.shipped, keys("Space"));
    QVERIFY(!shown.shortcuts->problem());
  }

  void anotherKeyIsRemembered() {
    {
      const KeyedWindow shown(file());
      QCOMPARE(shown.assign("Save", "Ctrl+Alt+S"), QString());
      QCOMPARE(shown.assign("Plays", "P"), QString());
      QCOMPARE(shown.action("save").shortcut(), keys("Ctrl+Alt+S"));
      QCOMPARE(shown.windowKeys->bindings().front().key, keys("P"));
    }
    const KeyedWindow again(file());
    QCOMPARE(again.action("save").shortcut(), keys("Ctrl+Alt+S"));
    QCOMPARE(again.find("Save").shipped, keys("Ctrl+S"));
    QCOMPARE(again.find("Plays").key, keys("P"));
    QCOMPARE(again.action("open").shortcut(), keys("Ctrl+O"));
  }

  void aKeyThatDoesSomethingElseIsRefusedWithWhatItDoes() {
    const KeyedWindow shown(file());
    QCOMPARE(
        shown.assign("Save", "Ctrl+O"),
        QStringLiteral("Ctrl+O is the key of \"Open…\" already, everywhere; give that another one first."));
    QCOMPARE(
        shown.assign("Save", "Space"),
        QStringLiteral("Space is the key of \"Plays\" already, everywhere; give that another one first."));
    QCOMPARE(shown.action("save").shortcut(), keys("Ctrl+S"));
    QCOMPARE(shown.assign("Save", "Ctrl+S"), QString());
    QCOMPARE(shown.assign("Open…", "F2"), QString());
    QCOMPARE(shown.assign("Save", "Ctrl+O"), QString());
  }

  void whatHasNoNameKeepsItsKey() {
    const KeyedWindow shown(file());
    QCOMPARE(shown.assign("Nameless", "F2"), QStringLiteral("The key of \"Nameless\" cannot be changed."));
    QVERIFY(!std::filesystem::exists(file()));
  }

  void aKeyOfTheWindowIsASingleOne() {
    const KeyedWindow shown(file());
    QCOMPARE(shown.assign("Plays", "Ctrl+K, P"), QStringLiteral("\"Plays\" needs a single key."));
    QCOMPARE(shown.assign("Save", "Ctrl+K, S"), QString());
  }

  void aRemovedKeyIsListedSoThatItCanBeGivenAgain() {
    {
      const KeyedWindow shown(file());
      QCOMPARE(shown.assign("Save", ""), QString());
      QCOMPARE(shown.assign("Open…", "Ctrl+S"), QString());
    }
    const KeyedWindow again(file());
    QCOMPARE(again.find("Save").key, QKeySequence());
    QCOMPARE(again.find("Save").shipped, keys("Ctrl+S"));
    QVERIFY2(!again.shortcuts->reset(again.find("Save")), "its key does something else now");
    QCOMPARE(again.assign("Save", "F3"), QString());
    QCOMPARE(again.action("save").shortcut(), keys("F3"));
  }

  void theTipSaysTheKeyThatThereIs() {
    const KeyedWindow shown(file());
    const QAction& save = shown.action("save");
    QCOMPARE(shown.assign("Save", "F3"), QString());
    QCOMPARE(save.toolTip(), QStringLiteral("Does it (F3)"));
    QCOMPARE(shown.assign("Save", ""), QString());
    QCOMPARE(save.toolTip(), QStringLiteral("Does it"));
    QCOMPARE(shown.assign("Save", "F4"), QString());
    QCOMPARE(save.toolTip(), QStringLiteral("Does it (F4)"));
  }

  void allIsAsItWasShippedAgain() {
    {
      const KeyedWindow shown(file());
      QCOMPARE(shown.assign("Save", "F3"), QString());
      QCOMPARE(shown.assign("Plays", ""), QString());
      QVERIFY(shown.shortcuts->resetAll());
      QCOMPARE(shown.action("save").shortcut(), keys("Ctrl+S"));
      QCOMPARE(shown.find("Plays").key, keys("Space"));
    }
    const KeyedWindow again(file());
    QCOMPARE(again.action("save").shortcut(), keys("Ctrl+S"));
    QCOMPARE(again.find("Plays").key, keys("Space"));
  }

  void aFileThatCannotBeReadIsPutAsideAndSaidSo() {
    folder_->write("shortcuts.json", "{broken");
    const KeyedWindow shown(file());
    QVERIFY(shown.shortcuts->problem().has_value());
    QCOMPARE(shown.action("save").shortcut(), keys("Ctrl+S"));
    QCOMPARE(QString::fromStdString(folder_->contents()), QStringLiteral("shortcuts.json.broken"));
    QCOMPARE(shown.assign("Save", "F3"), QString());
    QVERIFY(std::filesystem::exists(file()));
  }

  void whatMakesNoSenseInAFileIsIgnored() {
    folder_->write("shortcuts.json", R"({"format": "robotcontrol-shortcuts", "version": 1, "shortcuts": {
        "/save": 5, "/open": "F5", "/gone": "F6"}})");
    const KeyedWindow shown(file());
    QVERIFY(!shown.shortcuts->problem());
    QCOMPARE(shown.action("save").shortcut(), keys("Ctrl+S"));
    QCOMPARE(shown.action("open").shortcut(), keys("F5"));
    QCOMPARE(shown.assign("Save", "F6"), QString());
  }

  void aKeyThatCannotBeRememberedCountsUntilTheEnd() {
    folder_->write("taken", "no folder");
    const KeyedWindow shown(*folder_ / "taken" / "shortcuts.json");
    QVERIFY(!shown.assign("Save", "F3").isEmpty());
    QCOMPARE(shown.action("save").shortcut(), keys("F3"));
  }
};

const widgets::test::GuiTest<ShortcutsTest> kShortcutsTest;

}  // namespace app::test

#include "ShortcutsTest.moc"
