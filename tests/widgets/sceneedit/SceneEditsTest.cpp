// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneEdits.h"

#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/widgets/Bench.h"
#include "tests/widgets/sceneedit/ToyLanguage.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneFile.h"

namespace widgets::test {
namespace {

const std::string kHall =
    "<sdf>\n"
    "  <world name=\"hall\">\n"
    "    <!-- a desk -->\n"
    "    <model name=\"desk\"><pose>1 0 0 0 0 0</pose></model>\n"
    "    <include>\n"
    "      <uri>model://rover</uri>\n"
    "      <pose>0 1 0 0 0 0</pose>\n"
    "    </include>\n"
    "    <light name=\"lamp\"><pose>0 0 3 0 0 0</pose></light>\n"
    "  </world>\n"
    "</sdf>\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) qFatal("the text has no such part");
  return text.replace(at, from.size(), to);
}

/// A window in which a scene is simulated that can be changed.
struct HallBench : Bench {
  HallBench() : file(folder.write("hall.sdf", kHall)) {
    context.sceneLanguage = std::make_shared<ToyLanguage>();
    robotcontrol::SimulationStatus status;
    status.set_scene(file.string());
    push("simulation", status, 2);
    session.tick();
    edits().setHost(
        [this](const SceneEdits::Texts& unsaved) -> robotlink::Result<void> {
          texts.push_back(unsaved);
          return {};
        },
        [this](const std::filesystem::path& path) { return path.parent_path() == file.parent_path(); });
  }
  SceneEdits& edits() { return sceneEdits(context); }
  /// The text with which the simulation went on last.
  std::string running() const { return texts.empty() ? std::string() : texts.back().begin()->second; }
  std::string saved() const { return robotlink::readFile(file).value_or(""); }

  const TestFolder folder;
  const std::filesystem::path file;
  std::vector<SceneEdits::Texts> texts;
};

/// The reason; empty: it was done.
template <typename T>
std::string reason(const robotlink::Result<T>& done) {
  return done ? std::string() : done.error().text;
}

}  // namespace

class SceneEditsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aPoseIsWrittenIntoTheTextAndNothingElse() {
    HallBench b;
    QCOMPARE(reason(b.edits().setPose("desk", {2, 0.5, 0, 0, 0, 1})), std::string());
    QCOMPARE(b.running(), with(kHall, "1 0 0 0 0 0", "2 0.5 0 0 0 1"));
    QCOMPARE(b.saved(), kHall);
    QVERIFY(sceneBench(b.context).hasUnsaved());
    QVERIFY(sceneBench(b.context).saveAll().has_value());
    QCOMPARE(b.saved(), b.running());
  }

  void objectsAreAddedCopiedRenamedAndErased() {
    HallBench b;
    const auto added = b.edits().insert("box", 3, 4);
    QCOMPARE(added.value_or(""), std::string("box"));
    QVERIFY(b.running().find("<model name=\"box\"><pose>3 4 0 0 0 0</pose></model>\n  </world>") !=
            std::string::npos);
    QCOMPARE(b.edits().insert("box", 0, 0).value_or(""), std::string("box2"));
    QCOMPARE(b.edits().copy("desk", {5, 5, 0, 0, 0, 0}).value_or(""), std::string("desk2"));
    QVERIFY(b.running().find("<model name=\"desk2\"><pose>5 5 0 0 0 0</pose></model>") != std::string::npos);
    QCOMPARE(b.edits().copy("rover", {5, 6, 0, 0, 0, 0}).value_or(""), std::string("rover2"));
    QVERIFY(b.running().find("<name>rover2</name>") != std::string::npos);
    QCOMPARE(b.edits().copy("light:lamp", {1, 1, 3, 0, 0, 0}).value_or(""), std::string("light:lamp2"));
    QCOMPARE(reason(b.edits().rename("desk", "table")), std::string());
    QVERIFY(b.running().find("<model name=\"table\"><pose>1 0") != std::string::npos);
    for (const char* object : {"table", "desk2", "rover2", "light:lamp2", "box", "box2"})
      QCOMPARE(reason(b.edits().erase(object)), std::string());
    QCOMPARE(b.running(), with(kHall, "    <model name=\"desk\"><pose>1 0 0 0 0 0</pose></model>\n", ""));
  }

  void everythingIsUndoneAndRedone() {
    HallBench b;
    QVERIFY(!b.edits().canUndo());
    QVERIFY(!b.edits().undo().has_value());
    QVERIFY(b.edits().setPose("desk", {2, 0, 0, 0, 0, 0}).has_value());
    const std::string moved = b.running();
    QVERIFY(b.edits().erase("rover").has_value());
    const std::string erased = b.running();
    QVERIFY(b.edits().undoTitle().contains(QStringLiteral("rover")));
    QVERIFY(b.edits().undo().has_value());
    QCOMPARE(b.running(), moved);
    QVERIFY(b.edits().redo().has_value());
    QCOMPARE(b.running(), erased);
    QVERIFY(b.edits().undo().has_value() && b.edits().undo().has_value());
    QCOMPARE(sceneBench(b.context).current()->text().toStdString(), kHall);
    QVERIFY(!b.edits().canUndo());
  }

  void whatWasRequestedIsTakenBackInTheSameHistory() {
    HallBench b;
    robotcontrol::Request there, back;
    there.mutable_place_model()->set_model("rover");
    back.mutable_place_model()->set_model("rover");
    back.mutable_place_model()->set_height(2);
    b.edits().addRequests(QStringLiteral("Move rover"), back, there);
    QVERIFY(b.edits().setPose("desk", {2, 0, 0, 0, 0, 0}).has_value());
    QVERIFY(b.edits().undo().has_value());
    QVERIFY(b.requests.empty());
    QVERIFY(b.edits().undo().has_value());
    QCOMPARE(b.requests.back().place_model().height(), 2.0);
    QVERIFY(b.edits().redo().has_value());
    QCOMPARE(b.requests.back().place_model().height(), 0.0);
  }

  void whatWasEditedByHandSinceIsNotLost() {
    HallBench b;
    QVERIFY(b.edits().setPose("desk", {2, 0, 0, 0, 0, 0}).has_value());
    SceneFile& file = *sceneBench(b.context).current();
    file.replaceText(file.text() + QStringLiteral("<!-- mine -->"));
    QVERIFY(reason(b.edits().undo()).find("by hand") != std::string::npos);
    QVERIFY(file.text().endsWith(QStringLiteral("<!-- mine -->")));
    QVERIFY(b.edits().canUndo());
  }

  void whatTheSimulatorRefusesChangesNothing() {
    HallBench b;
    QCOMPARE(reason(b.edits().rename("desk", "wrong")), std::string("this is wrong"));
    QVERIFY(b.texts.empty() && !b.edits().canUndo());
    QVERIFY(!sceneBench(b.context).hasUnsaved());
  }

  void namesObjectsAndFilesThatCannotBeAreExplained() {
    HallBench b;
    QVERIFY(reason(b.edits().rename("desk", "a b")).find("letters") != std::string::npos);
    QVERIFY(reason(b.edits().rename("desk", "rover")).find("another") != std::string::npos);
    QVERIFY(reason(b.edits().erase("nobody")).find("nobody") != std::string::npos);
    QVERIFY(reason(b.edits().insert("nothing", 0, 0)).find("kind") != std::string::npos);
    QVERIFY(reason(b.edits().change({{"/etc/passwd", {"model", "pose"}, "0"}}, {})).find("no file of") !=
            std::string::npos);
    QVERIFY(b.texts.empty());
  }

  void withoutASceneHereNothingCanBeChanged() {
    Bench bench;
    QVERIFY(!sceneEdits(bench.context).canChange());
    QVERIFY(!sceneEdits(bench.context).insert("box", 0, 0).has_value());
  }
};

const GuiTest<SceneEditsTest> kSceneEditsTest;

}  // namespace widgets::test

#include "SceneEditsTest.moc"
