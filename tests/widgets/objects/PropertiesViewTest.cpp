// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/PropertiesView.h"

#include <QAction>
#include <QLabel>
#include <QTableView>

#include "tests/widgets/objects/ObjectsBench.h"
#include "widgets/world/SceneSelection.h"

namespace widgets::test {
namespace {

/// The cell with the value of a property; invalid if there is none.
QModelIndex valueOf(const QWidget& view, const char* title) {
  const auto& model = *child<QTableView>(view, "propertiesTable").model();
  for (int row = 0; row < model.rowCount(); ++row) {
    if (model.index(row, PropertiesModel::kName).data().toString() == QLatin1String(title))
      return model.index(row, PropertiesModel::kValue);
  }
  return {};
}

}  // namespace

class PropertiesViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theSelectedObjectIsShownWithItsPose() {
    ObjectsBench bench;
    auto view = bench.open<PropertiesView>();
    QCOMPARE(child<QTableView>(*view, "propertiesTable").model()->rowCount(), 0);
    sceneSelection(bench.context).select("red1");
    QCOMPARE(valueOf(*view, "x").data().toString(), QStringLiteral("0.5000"));
    sceneSelection(bench.context).select("red1/link:body");
    QCOMPARE(valueOf(*view, "mass").data().toString(), QStringLiteral("2"));
  }

  void aModelOfOneLinkShowsItsPartsToo() {
    ObjectsBench bench;
    bench.context.writeScene = [](const auto&) -> robotlink::Result<void> { return {}; };
    auto view = bench.open<PropertiesView>();
    sceneSelection(bench.context).select("red1");
    const QModelIndex mass = valueOf(*view, "mass (body)");
    QVERIFY(mass.isValid());
    QVERIFY(mass.flags() & Qt::ItemIsEditable);
    bench.add(robotcontrol::WorldObject::LINK, "red1/link:head", "red1/joint:pan");
    bench.push("objects", bench.objects, 1);
    bench.tick(*view);
    QVERIFY(!valueOf(*view, "mass (body)").isValid());
  }

  void anEditedPoseMovesTheModel() {
    ObjectsBench bench;
    auto view = bench.open<PropertiesView>();
    sceneSelection(bench.context).select("red1");
    auto& model = *child<QTableView>(*view, "propertiesTable").model();
    QVERIFY(model.setData(valueOf(*view, "y"), QStringLiteral("-0.25")));
    const auto& place = bench.requests.back().place_model();
    QCOMPARE(place.model(), std::string("red1"));
    QCOMPARE(place.pose_in_field().x(), 0.5);
    QCOMPARE(place.pose_in_field().y(), -0.25);
    QCOMPARE(place.height(), 0.0);
    QVERIFY(!model.setData(valueOf(*view, "y"), QStringLiteral("far")));
  }

  void whatCannotBeWrittenIsNotEdited() {
    ObjectsBench bench;
    auto view = bench.open<PropertiesView>();
    sceneSelection(bench.context).select("red1/link:body");
    QVERIFY(!(valueOf(*view, "mass").flags() & Qt::ItemIsEditable));
    QVERIFY(!child<QAction>(*view, "propertiesSaveAction").isEnabled());
  }

  void onlyWhatWasChangedIsWritten() {
    ObjectsBench bench;
    std::vector<SceneFileEdit> written;
    bench.context.writeScene = [&](const auto& edits) -> robotlink::Result<void> {
      written = edits;
      return {};
    };
    auto view = bench.open<PropertiesView>();
    sceneSelection(bench.context).select("red1/link:body");
    auto& model = *child<QTableView>(*view, "propertiesTable").model();
    QVERIFY(model.setData(valueOf(*view, "mass"), QStringLiteral("3.5")));
    bench.tick(*view);
    QCOMPARE(valueOf(*view, "mass").data().toString(), QStringLiteral("3.5"));
    QVERIFY(written.empty());
    child<QAction>(*view, "propertiesSaveAction").trigger();
    QCOMPARE(written.size(), std::size_t(1));
    QCOMPARE(written.front().file, std::string("/scenes/model.sdf"));
    QCOMPARE(written.front().element.back(), std::string("mass"));
    QCOMPARE(written.front().value, std::string("3.5"));
    QVERIFY(!child<QAction>(*view, "propertiesSaveAction").isEnabled());
  }

  void thePoseOfAModelIsWrittenOnRequest() {
    ObjectsBench bench;
    std::vector<SceneFileEdit> written;
    bench.context.writeScene = [&](const auto& edits) -> robotlink::Result<void> {
      written = edits;
      return {};
    };
    auto view = bench.open<PropertiesView>();
    sceneSelection(bench.context).select("red1");
    child<QAction>(*view, "propertiesKeepPoseAction").trigger();
    child<QAction>(*view, "propertiesSaveAction").trigger();
    QCOMPARE(written.size(), std::size_t(1));
    QCOMPARE(written.front().value, std::string("0.5 0 0 0 0 0"));
  }

  void aFailureIsSaidAndTheChangeIsKept() {
    ObjectsBench bench;
    bench.context.writeScene = [](const auto&) {
      return robotlink::failure("scene.file", "the disk is full");
    };
    auto view = bench.open<PropertiesView>();
    sceneSelection(bench.context).select("red1");
    child<QAction>(*view, "propertiesKeepPoseAction").trigger();
    child<QAction>(*view, "propertiesSaveAction").trigger();
    QVERIFY(child<QLabel>(*view, "propertiesOutcome").text().contains(QStringLiteral("the disk is full")));
    QVERIFY(child<QAction>(*view, "propertiesSaveAction").isEnabled());
    child<QAction>(*view, "propertiesDiscardAction").trigger();
    QVERIFY(!child<QAction>(*view, "propertiesSaveAction").isEnabled());
  }
};

const GuiTest<PropertiesViewTest> kPropertiesViewTest;

}  // namespace widgets::test

#include "PropertiesViewTest.moc"
