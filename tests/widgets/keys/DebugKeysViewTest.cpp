// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/keys/DebugKeysView.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeView>

#include "robotcontrol/Linking.pb.h"
#include "tests/widgets/Bench.h"

namespace widgets::test {

using robotcontrol::KeyMode;
using robotcontrol::KeyTable;

namespace {

void addKey(KeyTable& table, const std::string& name, KeyMode::Kind kind, bool inUse, unsigned n = 0) {
  auto& key = *table.add_keys();
  key.set_name(name);
  key.set_help("Help of " + name);
  key.mutable_mode()->set_kind(kind);
  key.mutable_mode()->set_n(n);
  key.set_in_use(inUse);
  key.add_solutions(name.substr(0, name.find('/')) + "/scan-lines");
}

KeyTable someKeys() {
  KeyTable table;
  addKey(table, "ball-percept/circle", KeyMode::OFF, true);
  addKey(table, "ball-percept/edges", KeyMode::ALWAYS, true);
  addKey(table, "ball-model/position", KeyMode::EVERY_MS, true, 200);
  addKey(table, "self-localization/particles", KeyMode::OFF, false);
  return table;
}

}  // namespace

class DebugKeysViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void keysStandInATreeByTheirNamesAndInactiveOnesAreGrayedButSettable() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    auto& tree = child<QTreeView>(*view, "keysTree");
    QAbstractItemModelTester tester(tree.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QVERIFY(child<QLabel>(*view, "emptyHint").isVisible());
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    QVERIFY(!child<QLabel>(*view, "emptyHint").isVisible());
    QCOMPARE(tree.model()->rowCount(), 3);
    QCOMPARE(find(tree, QStringLiteral("position"), 1).data().toString(), QStringLiteral("every n ms"));
    QCOMPARE(find(tree, QStringLiteral("position"), 2).data().toString(), QStringLiteral("200 ms"));
    QCOMPARE(find(tree, QStringLiteral("ball-percept"), 1).data().toString(), QStringLiteral("1 of 2 on"));
    const QModelIndex inactive = find(tree, QStringLiteral("particles"), 1);
    QVERIFY(inactive.data(Qt::ForegroundRole).value<QColor>().isValid());
    QVERIFY(inactive.data(Qt::ToolTipRole).toString().contains(QStringLiteral("Inactive")));
    QVERIFY(inactive.flags().testFlag(Qt::ItemIsEditable));
  }

  void theToolTipOfAKeySaysWhichClientsAskForIt() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    robotcontrol::KeySubscribers subscribers;
    subscribers.add_keys()->set_name("ball-percept/circle");
    subscribers.mutable_keys(0)->add_clients("RobotControl at 10.0.0.7:5123");
    bench.push("red1/tables/subscribers", subscribers, 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    const auto toolTip = [&](const QString& key) {
      return find(tree, key, 0).data(Qt::ToolTipRole).toString();
    };
    QVERIFY(
        toolTip(QStringLiteral("circle")).contains(QStringLiteral("Requested by: RobotControl at 10.0.0.7")));
    QVERIFY(!toolTip(QStringLiteral("edges")).contains(QStringLiteral("Requested by")));
    bench.push("red1/tables/subscribers", robotcontrol::KeySubscribers(), 2);
    bench.tick(*view);
    QVERIFY(!toolTip(QStringLiteral("circle")).contains(QStringLiteral("Requested by")));
  }

  void aClickOnTheModeOpensAListAndTheChoiceIsRequested() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    clickCell(tree, find(tree, QStringLiteral("circle"), 1));
    auto& list = child<QComboBox>(tree, "keyModeEditor");
    QTest::keyClick(list.view(), Qt::Key_Down);
    QTest::keyClick(list.view(), Qt::Key_Down);
    QTest::keyClick(list.view(), Qt::Key_Return);
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests[0].robot(), std::string("red1"));
    QCOMPARE(bench.requests[0].set_key().name(), std::string("ball-percept/circle"));
    QCOMPARE(bench.requests[0].set_key().mode().kind(), KeyMode::N_TIMES);
    QCOMPARE(bench.requests[0].set_key().mode().n(), 1U);
    QCOMPARE(find(tree, QStringLiteral("circle"), 1).data().toString(), QStringLiteral("n times"));
  }

  void oneClickSwitchesAKeyOrAGroupInAllOtherRobotsAsItIsHere() {
    Bench bench;
    bench.session.setRobots({"red1", "red2", "blue1"});
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    auto& inAll = child<QAction>(*view, "keysInAllRobotsAction");
    QVERIFY(tree.actions().contains(&inAll));
    tree.setCurrentIndex(find(tree, QStringLiteral("position")));
    inAll.trigger();
    QCOMPARE(bench.requests.size(), std::size_t{2});
    QCOMPARE(bench.requests[0].robot(), std::string("red2"));
    QCOMPARE(bench.requests[1].robot(), std::string("blue1"));
    QCOMPARE(bench.requests[1].set_key().name(), std::string("ball-model/position"));
    QCOMPARE(bench.requests[1].set_key().mode().kind(), KeyMode::EVERY_MS);
    QCOMPARE(bench.requests[1].set_key().mode().n(), 200U);
    bench.answer(false, "there is no such key");
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "keysState").text().contains(QStringLiteral("blue1")));
    tree.setCurrentIndex(find(tree, QStringLiteral("ball-percept")));
    inAll.trigger();
    QCOMPARE(bench.requests.size(), std::size_t{6});
    bench.session.setRobots({"red1"});
    bench.tick(*view);
    QVERIFY(!inAll.isEnabled());
  }

  void theNumberIsEditedInPlace() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    clickCell(tree, find(tree, QStringLiteral("position"), 2));
    auto& number = child<QSpinBox>(tree, "keyNumberEditor");
    QTest::keyClicks(&number, QStringLiteral("500"));
    QTest::keyClick(&number, Qt::Key_Return);
    QCoreApplication::processEvents();  // item views commit from the event loop
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests[0].set_key().mode().kind(), KeyMode::EVERY_MS);
    QCOMPARE(bench.requests[0].set_key().mode().n(), 500U);
  }

  void spaceSwitchesTheCurrentKeyAndAllKeysOfAGroup() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    tree.setCurrentIndex(find(tree, QStringLiteral("circle")));
    QTest::keyClick(&tree, Qt::Key_Space);
    QCOMPARE(bench.requests.back().set_key().mode().kind(), KeyMode::ALWAYS);
    tree.setCurrentIndex(find(tree, QStringLiteral("ball-percept")));
    QTest::keyClick(&tree, Qt::Key_Space);
    QCOMPARE(bench.requests.size(), std::size_t{3});
    QCOMPARE(bench.requests[1].set_key().mode().kind(), KeyMode::OFF);
    QCOMPARE(bench.requests[2].set_key().mode().kind(), KeyMode::OFF);
  }

  void typingInTheListSearches() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    QTest::keyClicks(&tree, QStringLiteral("e"));
    QTest::keyClicks(&child<QLineEdit>(*view, "keysSearch"), QStringLiteral("dge"));
    QCOMPARE(child<QLineEdit>(*view, "keysSearch").text(), QStringLiteral("edge"));
    QCOMPARE(tree.model()->rowCount(), 1);
    QVERIFY(find(tree, QStringLiteral("edges")).isValid());
    QVERIFY(!find(tree, QStringLiteral("circle")).isValid());
    QTest::keyClick(&child<QLineEdit>(*view, "keysSearch"), Qt::Key_Escape);
    QCOMPARE(tree.model()->rowCount(), 3);
  }

  void enterGoesFromTheSearchToTheFirstKeyThatWasFound() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    auto& search = child<QLineEdit>(*view, "keysSearch");
    auto& tree = child<QTreeView>(*view, "keysTree");
    search.setFocus();
    QTest::keyClicks(&search, QStringLiteral("edge"));
    QTest::keyClick(&search, Qt::Key_Return);
    QVERIFY(tree.hasFocus());
    QCOMPARE(tree.currentIndex().data().toString(), QStringLiteral("ball-percept"));
    QTest::keyClick(&tree, Qt::Key_Space);
    QCOMPARE(bench.requests.back().set_key().mode().kind(), KeyMode::OFF);
  }

  void onlyKeysThatAreOnAreShownOnWishAndAllAreSwitchedOff() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    click(child<QToolButton>(*view, "keysActiveOnly"));
    auto& tree = child<QTreeView>(*view, "keysTree");
    QCOMPARE(tree.model()->rowCount(), 2);
    QVERIFY(!find(tree, QStringLiteral("circle")).isValid());
    click(child<QToolButton>(*view, "keysAllOff"));
    QCOMPARE(bench.requests.size(), std::size_t{2});
    for (const auto& request : bench.requests) QCOMPARE(request.set_key().mode().kind(), KeyMode::OFF);
    QVERIFY(!child<QToolButton>(*view, "keysAllOff").isEnabled());
  }

  void aRefusalTakesTheWishBackAndSaysWhy() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    tree.setCurrentIndex(find(tree, QStringLiteral("circle")));
    QTest::keyClick(&tree, Qt::Key_Space);
    bench.answer(false, "the process has failed");
    bench.tick(*view);
    QCOMPARE(find(tree, QStringLiteral("circle"), 1).data().toString(), QStringLiteral("off"));
    QVERIFY(child<QLabel>(*view, "keysState").text().contains(QStringLiteral("the process has failed")));
  }

  void whatOneRobotRefusedIsNotShownAtAnother() {
    Bench bench;
    bench.session.setRobots({"red1", "red2"});
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.push("red2/tables/keys", someKeys(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    const auto refused = [&] {
      return find(tree, QStringLiteral("circle"))
          .data(Qt::ToolTipRole)
          .toString()
          .contains(QStringLiteral("Refused"));
    };
    tree.setCurrentIndex(find(tree, QStringLiteral("circle")));
    QTest::keyClick(&tree, Qt::Key_Space);
    bench.answer(false, "the process has failed");
    bench.tick(*view);
    QVERIFY(refused());
    bench.session.selectRobot("red2");
    bench.tick(*view);
    QVERIFY(!refused());
    tree.setCurrentIndex(find(tree, QStringLiteral("circle")));
    QTest::keyClick(&tree, Qt::Key_Space);
    bench.session.selectRobot("red1");
    bench.tick(*view);
    bench.answer(false, "the process has failed");
    bench.tick(*view);
    QVERIFY(!refused());
  }

  void theViewFollowsTheChosenRobot() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    KeyTable other;
    addKey(other, "motion/legs", KeyMode::ALWAYS, true);
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.push("blue1/tables/keys", other, 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    QVERIFY(!find(tree, QStringLiteral("legs")).isValid());
    bench.session.selectRobot("blue1");
    bench.tick(*view);
    QVERIFY(find(tree, QStringLiteral("legs")).isValid());
    QVERIFY(!find(tree, QStringLiteral("circle")).isValid());
  }

  void aPresetIsSavedByNameAndBringsItsKeysBack() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    bench.push("red1/tables/keys", someKeys(), 1);
    bench.tick(*view);
    QTest::keyClicks(&child<QLineEdit>(*view, "keysPresetName"), QStringLiteral("ball only"));
    click(child<QToolButton>(*view, "keysSavePreset"));
    bench.push("red1/tables/keys", someKeys(), 1.5);
    bench.tick(*view);
    QVERIFY(
        child<QLabel>(*view, "keysState").text().startsWith(QStringLiteral("Saved the preset ball only")));
    KeyTable others;
    addKey(others, "ball-percept/circle", KeyMode::ALWAYS, true);
    addKey(others, "ball-percept/edges", KeyMode::OFF, true);
    addKey(others, "ball-model/position", KeyMode::EVERY_MS, true, 200);
    bench.push("red1/tables/keys", others, 2);
    auto again = bench.open<widgets::DebugKeysView>();
    auto& list = child<QComboBox>(*again, "keysPresets");
    QCOMPARE(list.itemText(0), QStringLiteral("ball only"));
    list.showPopup();
    list.view()->setCurrentIndex(list.model()->index(0, 0));
    QTest::keyClick(list.view(), Qt::Key_Return);
    QCOMPARE(bench.requests.size(), std::size_t{2});
    QCOMPARE(bench.requests[0].set_key().name(), std::string("ball-percept/circle"));
    QCOMPARE(bench.requests[0].set_key().mode().kind(), KeyMode::OFF);
    QCOMPARE(bench.requests[1].set_key().mode().kind(), KeyMode::ALWAYS);
    click(child<QToolButton>(*again, "keysRemovePreset"));
    QCOMPARE(list.findText(QStringLiteral("ball only")), -1);
  }

  void theShippedPresetIsInTheListAndCannotBeReplacedOrDeleted() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    KeyTable keys;
    addKey(keys, "ball-percept/disc", KeyMode::OFF, true);
    addKey(keys, "ball-percept/edges", KeyMode::ALWAYS, true);
    bench.push("red1/tables/keys", keys, 1);
    bench.tick(*view);
    auto& list = child<QComboBox>(*view, "keysPresets");
    auto& state = child<QLabel>(*view, "keysState");
    const int shipped = list.findText(QStringLiteral("start (shipped)"));
    QVERIFY(shipped >= 0);
    list.showPopup();
    list.view()->setCurrentIndex(list.model()->index(shipped, 0));
    QTest::keyClick(list.view(), Qt::Key_Return);
    QCOMPARE(bench.requests.size(), std::size_t{2});
    QCOMPARE(bench.requests[0].set_key().mode().kind(), KeyMode::ALWAYS);
    QCOMPARE(bench.requests[1].set_key().mode().kind(), KeyMode::OFF);
    click(child<QToolButton>(*view, "keysSavePreset"));
    QVERIFY2(state.text().contains(QStringLiteral("Type another name")), qPrintable(state.text()));
    click(child<QToolButton>(*view, "keysRemovePreset"));
    QVERIFY2(state.text().contains(QStringLiteral("cannot be deleted")), qPrintable(state.text()));
    QVERIFY(list.findText(QStringLiteral("start (shipped)")) >= 0);
  }

  void theColumnOfNumbersIsThereOnlyWhileAKeyHasOne() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>({300, 400});
    KeyTable keys;
    addKey(keys, "ball-model/position", KeyMode::ALWAYS, true);
    bench.push("red1/tables/keys", keys, 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "keysTree");
    QVERIFY(tree.isColumnHidden(widgets::KeyTreeModel::kNumber));
    keys.mutable_keys(0)->mutable_mode()->set_kind(KeyMode::EVERY_MS);
    keys.mutable_keys(0)->mutable_mode()->set_n(200);
    bench.push("red1/tables/keys", keys, 2);
    bench.tick(*view);
    QVERIFY(!tree.isColumnHidden(widgets::KeyTreeModel::kNumber));
  }

  void searchAndFilterAreKept() {
    Bench bench;
    auto view = bench.open<widgets::DebugKeysView>();
    child<QLineEdit>(*view, "keysSearch").setText(QStringLiteral("ball"));
    click(child<QToolButton>(*view, "keysActiveOnly"));
    auto again = bench.open<widgets::DebugKeysView>();
    again->restoreState(view->saveState());
    QCOMPARE(child<QLineEdit>(*again, "keysSearch").text(), QStringLiteral("ball"));
    QVERIFY(child<QToolButton>(*again, "keysActiveOnly").isChecked());
  }
};

const GuiTest<DebugKeysViewTest> kDebugKeysViewTest;

}  // namespace widgets::test

#include "DebugKeysViewTest.moc"
