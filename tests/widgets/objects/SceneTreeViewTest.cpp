// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/SceneTreeView.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTimer>
#include <QTreeView>

#include "tests/widgets/objects/ObjectsBench.h"
#include "widgets/world/SceneSelection.h"

namespace widgets::test {

using robotcontrol::Request;

class SceneTreeViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void objectsLieBelowWhatTheyBelongTo() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    auto& tree = child<QTreeView>(*view, "sceneTree");
    const QAbstractItemModelTester tester(tree.model(),
                                          QAbstractItemModelTester::FailureReportingMode::Fatal);
    tree.expandAll();
    QCOMPARE(tree.model()->rowCount(), 2);
    const QModelIndex servo = find(tree, QStringLiteral("red1/pan/request"));
    QVERIFY(servo.isValid());
    QCOMPARE(servo.parent().data().toString(), QStringLiteral("pan"));
    QCOMPARE(servo.sibling(servo.row(), SceneTreeModel::kKind).data().toString(), QStringLiteral("actuator"));
  }

  void whatIsUnselectedElsewhereIsUnselectedHereAndSelectedByAClickAgain() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    auto& tree = child<QTreeView>(*view, "sceneTree");
    auto& selection = sceneSelection(bench.context);
    selection.select("red1");
    QVERIFY(tree.currentIndex().isValid());
    selection.select({});
    QVERIFY(!tree.currentIndex().isValid());
    QVERIFY(!child<QAction>(*view, "sceneTreeAloneAction").isEnabled());
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {},
                      tree.visualRect(find(tree, QStringLiteral("red1"))).center());
    QCOMPARE(selection.object(), std::string("red1"));
  }

  void searchShowsWhatMatchesWithItsParents() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    auto& tree = child<QTreeView>(*view, "sceneTree");
    child<QLineEdit>(*view, "sceneTreeSearch").setText(QStringLiteral("LASER"));
    QCOMPARE(tree.model()->rowCount(), 1);
    QVERIFY(find(tree, QStringLiteral("red1/laser")).isValid());
    QVERIFY(!find(tree, QStringLiteral("red1/pan/request")).isValid());
  }

  void sensorsInViewAreReadOnce() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    QVERIFY(bench.requests.empty());
    child<QTreeView>(*view, "sceneTree").expandAll();
    bench.tick(*view);
    bench.tick(*view);
    QCOMPARE(bench.requests.size(), std::size_t(1));
    const Request& request = bench.requests.front();
    QCOMPARE(request.robot(), std::string("red1"));
    QCOMPARE(request.read_ports().ports_size(), 2);  // images are not rendered for the tree
  }

  void valuesAreShownAtTheShownInstant() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    auto& tree = child<QTreeView>(*view, "sceneTree");
    tree.expandAll();
    bench.publishReadings(0.25);
    bench.tick(*view);
    const QModelIndex sensor = find(tree, QStringLiteral("red1/pan/position"));
    QCOMPARE(sensor.sibling(sensor.row(), SceneTreeModel::kValue).data().toString(),
             QStringLiteral("0.25 rad"));
  }

  void objectsAreShownHiddenAndFollowedInThreeDimensions() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    auto& tree = child<QTreeView>(*view, "sceneTree");
    tree.expandAll();
    auto& alone = child<QAction>(*view, "sceneTreeAloneAction");
    QVERIFY(!alone.isEnabled());
    tree.setCurrentIndex(find(tree, QStringLiteral("red1")));
    QVERIFY(alone.isEnabled());
    alone.trigger();
    QVERIFY2(!bench.lines.empty(), qPrintable(child<QLabel>(*view, "sceneTreeOutcome").text()));
    auto& showAgain = child<QAction>(*view, "sceneTreeShowAgainAction");
    QVERIFY2(!showAgain.isEnabled(), "nothing is hidden");
    bench.hidden = {"red1"};
    QTest::keyClick(&tree, Qt::Key_H, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(showAgain.isEnabled());
    for (const char* action :
         {"sceneTreeShowAgainAction", "sceneTreeTurnWithAction", "sceneTreeLookOutAction"})
      child<QAction>(*view, action).trigger();
    const std::vector<std::string> expected{"scene.open red1 alone", "scene.hide red1 ", "scene.show red1 ",
                                            "scene.follow red1 heading ", "scene.follow red1 first-person "};
    std::string said;
    for (const std::string& line : bench.lines) said += line + "; ";
    QVERIFY2(bench.lines == expected, said.c_str());
  }

  void whatIsNowhereIsNotShown() {
    ObjectsBench bench;
    bench.add(robotcontrol::WorldObject::CONTROLLER, "keeper", "");
    bench.push("objects", bench.objects, 1.5);
    auto view = bench.open<SceneTreeView>();
    sceneSelection(bench.context).select("red1/laser");
    for (const char* name : {"sceneTreeAloneAction", "sceneTreeHideAction", "sceneTreeFollowAction"})
      QVERIFY2(child<QAction>(*view, name).isEnabled(), name);
    sceneSelection(bench.context).select("keeper");
    for (const char* name : {"sceneTreeAloneAction", "sceneTreeHideAction", "sceneTreeFollowAction"})
      QVERIFY2(!child<QAction>(*view, name).isEnabled(), name);
    QVERIFY(child<QAction>(*view, "sceneTreePropertiesAction").isEnabled());
  }

  void theMenuChoosesHowObjectsAreDrawn() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    auto& tree = child<QTreeView>(*view, "sceneTree");
    tree.expandAll();
    const QModelIndex robot = find(tree, QStringLiteral("red1"));
    clickCell(tree, robot);
    for (const char* entry : {"sceneTreeDrawn-wire", "sceneTreeThrough-75"}) {
      bool found = false;
      QTimer::singleShot(0, view.get(), [&] {
        auto* menu = view->findChild<QMenu*>(QStringLiteral("sceneTreeMenu"));
        if (menu == nullptr) return;
        auto* action = view->findChild<QAction*>(QLatin1String(entry));
        found = action != nullptr;
        if (found) action->trigger();
        menu->close();
      });
      Q_EMIT tree.customContextMenuRequested(tree.visualRect(robot).center());
      QVERIFY2(found, entry);
    }
    const std::vector<std::string> expected{"scene.draw red1 wire ", "scene.opacity red1 0.250000 "};
    QCOMPARE(bench.lines, expected);
  }

  void aSliderHoldsItsActuatorUntilItIsReleased() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    auto& tree = child<QTreeView>(*view, "sceneTree");
    tree.expandAll();
    clickCell(tree, find(tree, QStringLiteral("red1/pan/request")));
    bench.requests.clear();
    auto& slider = child<QSlider>(*view, "actuator-red1/pan/request-0");
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_End);
    QCOMPARE(bench.requests.size(), std::size_t(1));
    QCOMPARE(bench.requests.back().set_actuator().port(), std::string("red1/pan/request"));
    QCOMPARE(bench.requests.back().set_actuator().values(0), 1.0);
    bench.publishReadings(0, 1.0);
    bench.tick(*view);
    click(child<QPushButton>(*view, "actuatorsRelease"));
    QVERIFY(bench.requests.back().set_actuator().released());
  }

  void aModelHasTheSlidersOfAllItsActuators() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    sceneSelection(bench.context).select("red1");
    bench.tick(*view);
    QVERIFY(view->findChild<QDoubleSpinBox*>(QStringLiteral("actuatorValue-red1/pan/request-0")) != nullptr);
    sceneSelection(bench.context).select("light 1");
    QVERIFY(!child<QWidget>(*view, "actuatorPanel").isVisible());
  }

  void aSensorIsPlottedShownAsColumnsOrAsAnImage() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    sceneSelection(bench.context).select("red1/pan/position");
    child<QAction>(*view, "sceneTreePlotAction").trigger();
    QCOMPARE(bench.lines.back(),
             std::string("plots.add ports: readings[port=\"red1/pan/position\"].values[0]"));
    sceneSelection(bench.context).select("red1/laser");
    child<QAction>(*view, "sceneTreeColumnsAction").trigger();
    QCOMPARE(bench.lines.back(), std::string("columns.show red1/laser"));
    sceneSelection(bench.context).select("red1/cam/image");
    child<QAction>(*view, "sceneTreeStereogramAction").trigger();
    QCOMPARE(bench.lines.at(bench.lines.size() - 2), std::string("image.stream image red1/cam/image"));
    QCOMPARE(bench.lines.back(), std::string("image.show image stereogram"));
    QVERIFY(!child<QAction>(*view, "sceneTreePlotAction").isEnabled());
  }

  void ofManyValuesTheFirstTwelveArePlotted() {
    ObjectsBench bench;
    bench.addPort(robotcontrol::WorldObject::SENSOR, "red1/wide", "red1/link:body", "range").add_shape(720);
    bench.push("objects", bench.objects, 1.5);
    auto view = bench.open<SceneTreeView>();
    sceneSelection(bench.context).select("red1/wide");
    auto& plot = child<QAction>(*view, "sceneTreePlotAction");
    QVERIFY(plot.isEnabled() && plot.toolTip().contains(QStringLiteral("first twelve")));
    plot.trigger();
    QCOMPARE(bench.lines.size(), std::size_t(12));
    QCOMPARE(bench.lines.back(), std::string("plots.add ports: readings[port=\"red1/wide\"].values[11]"));
  }

  void theTextOfAnObjectIsReachedAndChangedFromHere() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    auto& tree = child<QTreeView>(*view, "sceneTree");
    tree.expandAll();
    clickCell(tree, find(tree, QStringLiteral("red1/laser")));
    QTest::keyClick(&tree, Qt::Key_G, Qt::ControlModifier);
    QVERIFY2(!child<QAction>(*view, "sceneTreeEraseAction").isEnabled(), "it is a part of red1");
    clickCell(tree, find(tree, QStringLiteral("red1")));
    QTest::keyClick(&tree, Qt::Key_D, Qt::ControlModifier);
    QTest::keyClick(&tree, Qt::Key_Delete);
    QTimer::singleShot(0, view.get(), [&] {
      auto* dialog = view->findChild<QInputDialog*>();
      if (dialog == nullptr) return;
      dialog->setTextValue(QStringLiteral("redder"));
      dialog->accept();
    });
    QTest::keyClick(&tree, Qt::Key_F2);
    const std::vector<std::string> expected{"scene.edit red1/laser", "scene.copy red1", "scene.erase red1",
                                            "scene.rename red1 redder"};
    std::string said;
    for (const std::string& line : bench.lines) said += line + "; ";
    QVERIFY2(bench.lines == expected, said.c_str());
  }

  void whatIsUnfoldedIsKept() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    child<QTreeView>(*view, "sceneTree").expandAll();
    SceneTreeView other(bench.context);
    other.restoreState(view->saveState());
    const auto& tree = child<QTreeView>(other, "sceneTree");
    QVERIFY(tree.isExpanded(find(tree, QStringLiteral("pan"))));
  }

  void numbersHaveATabBetweenColumns() {
    ObjectsBench bench;
    auto view = bench.open<SceneTreeView>();
    QVERIFY(view->numbers()->startsWith(QStringLiteral("Object\tKind\tValue\n")));
  }
};

const GuiTest<SceneTreeViewTest> kSceneTreeViewTest;

}  // namespace widgets::test

#include "SceneTreeViewTest.moc"
