// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneEdits.h"

#include <QSignalSpy>
#include <array>
#include <atomic>
#include <semaphore>
#include <string>

#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "tests/widgets/sceneedit/HallBench.h"
#include "widgets/sceneedit/SceneFile.h"
#include "widgets/world/SceneSelection.h"

namespace widgets::test {
namespace {

/// Checks no changed text before it is let.
class SlowLanguage final : public ToyLanguage {
 public:
  std::vector<SceneProblem> check(const std::string& text, const std::filesystem::path& file) const override {
    if (text == kHall) return {};
    ++begun;
    gate.acquire();
    return ToyLanguage::check(text, file);
  }
  /// How many checks were begun.
  mutable std::atomic<int> begun = 0;
  mutable std::counting_semaphore<> gate{0};
};

/// Says that what is added as a box is inside the desk at the start.
class NarrowLanguage final : public ToyLanguage {
 public:
  std::vector<SceneProblem> check(const std::string& text, const std::filesystem::path& file) const override {
    if (text.find("\"box\"") == std::string::npos) return {};
    return {{false, "'box' starts inside 'desk'", file.string(), 3, {"box", "desk"}}};
  }
};

/// Says that the desk, by whatever name, is inside the rover at the start.
class CrowdedLanguage final : public ToyLanguage {
 public:
  std::vector<SceneProblem> check(const std::string& text, const std::filesystem::path& file) const override {
    const std::string desk = text.find("\"table\"") == std::string::npos ? "desk" : "table";
    return {{false, "'" + desk + "' starts inside 'rover'", file.string(), 3, {desk, "rover"}}};
  }
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
    QCOMPARE(b.setPose("desk", {2, 0.5, 0, 0, 0, 1}), std::string("desk"));
    QCOMPARE(b.running(), with(kHall, "1 0 0 0 0 0", "2 0.5 0 0 0 1"));
    QCOMPARE(b.saved(), kHall);
    QVERIFY(sceneBench(b.context).hasUnsaved());
    QVERIFY(sceneBench(b.context).saveAll().has_value());
    QCOMPARE(b.saved(), b.running());
  }

  void objectsAreAddedCopiedRenamedAndErased() {
    HallBench b;
    QCOMPARE(b.insert("box", 3, 4), std::string("box"));
    QVERIFY(b.running().find("<model name=\"box\"><pose>3 4 0 0 0 0</pose></model>\n  </world>") !=
            std::string::npos);
    QCOMPARE(b.insert("box", 0, 0), std::string("box2"));
    QCOMPARE(b.copy("desk", {5, 5, 0, 0, 0, 0}), std::string("desk2"));
    QVERIFY(b.running().find("<model name=\"desk2\"><pose>5 5 0 0 0 0</pose></model>") != std::string::npos);
    QCOMPARE(b.copy("rover", {5, 6, 0, 0, 0, 0}), std::string("rover2"));
    QVERIFY(b.running().find("<name>rover2</name>") != std::string::npos);
    QCOMPARE(b.copy("light:lamp", {1, 1, 3, 0, 0, 0}), std::string("light:lamp2"));
    QCOMPARE(b.rename("desk", "table"), std::string("table"));
    QVERIFY(b.running().find("<model name=\"table\"><pose>1 0") != std::string::npos);
    for (const char* object : {"table", "desk2", "rover2", "light:lamp2", "box", "box2"})
      QCOMPARE(b.erase(object), std::string(object));
    QCOMPARE(b.running(), with(kHall, "    <model name=\"desk\"><pose>1 0 0 0 0 0</pose></model>\n", ""));
  }

  void everythingIsUndoneAndRedone() {
    HallBench b;
    QVERIFY(!b.edits().canUndo());
    QVERIFY(!b.edits().undo().has_value());
    QCOMPARE(b.setPose("desk", {2, 0, 0, 0, 0, 0}), std::string("desk"));
    const std::string moved = b.running();
    QCOMPARE(b.erase("rover"), std::string("rover"));
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
    QCOMPARE(b.setPose("desk", {2, 0, 0, 0, 0, 0}), std::string("desk"));
    QVERIFY(b.edits().undo().has_value());
    QVERIFY(b.requests.empty());
    QVERIFY(b.edits().undo().has_value());
    QCOMPARE(b.requests.back().place_model().height(), 2.0);
    QVERIFY(b.edits().redo().has_value());
    QCOMPARE(b.requests.back().place_model().height(), 0.0);
  }

  void eachSceneHasItsOwnHistory() {
    HallBench b;
    QCOMPARE(b.setPose("desk", {2, 0, 0, 0, 0, 0}), std::string("desk"));
    robotcontrol::Request place;
    b.edits().addRequests(QStringLiteral("Move rover"), place, place);
    QVERIFY(b.edits().undo().has_value());
    b.requests.clear();
    const auto map = b.folder.write("house.map", "");
    const QSignalSpy changed(&b.edits(), &SceneEdits::historyChanged);
    b.simulate(map);
    QVERIFY2(changed.size() > 0, "buttons are switched off");
    QVERIFY(!b.edits().canUndo() && !b.edits().canRedo() && b.edits().undoTitle().isEmpty());
    QVERIFY(!b.edits().undo().has_value() && !b.edits().redo().has_value());
    QCOMPARE(b.texts.size(), std::size_t{1});
    QVERIFY(b.requests.empty());
    QVERIFY(b.insert("box", 0, 0).find("a map has no scene text") != std::string::npos);
    b.simulate(b.file);
    QVERIFY(b.edits().redo().has_value() && b.edits().undo().has_value() && b.edits().undo().has_value());
    QCOMPARE(sceneBench(b.context).current()->text().toStdString(), kHall);
  }

  void aChangeIsGivenUpWhenAnotherSceneIsOpened() {
    HallBench b;
    std::string outcome;
    b.edits().erase("desk", HallBench::telling(outcome));
    b.simulate(b.folder.write("other.sdf", kHall));
    b.edits().finish();
    QVERIFY(outcome.find("given up") != std::string::npos);
    QVERIFY(b.texts.empty());
  }

  void whatDoesNotFitNowIsTakenBack() {
    HallBench b;
    const QSignalSpy reported(&sceneBench(b.context), &SceneBench::reported);
    QCOMPARE(b.insert("box", 3, 4), std::string("box"));
    sceneSelection(b.context).select("box");
    b.refuse("there is no room for 'box'");
    QCOMPARE(sceneBench(b.context).current()->text().toStdString(), kHall);
    QVERIFY(!b.edits().canUndo() && b.edits().canRedo());
    QVERIFY(sceneSelection(b.context).object().empty());
    QCOMPARE(reported.last()[0].toString(), QStringLiteral("there is no room for 'box'"));
    // What was undone is there again.
    QCOMPARE(b.erase("desk"), std::string("desk"));
    const std::string erased = b.running();
    QVERIFY(b.edits().undo().has_value());
    b.refuse("there is no room for 'desk'");
    QCOMPARE(sceneBench(b.context).current()->text().toStdString(), erased);
    QVERIFY(b.edits().canUndo() && !b.edits().canRedo());
  }

  void whatIsThereAgainIsSelected() {
    HallBench b;
    sceneSelection(b.context).select("desk");
    QCOMPARE(b.erase("desk"), std::string("desk"));
    sceneSelection(b.context).select({});
    QVERIFY(b.edits().undo().has_value());
    QCOMPARE(sceneSelection(b.context).object(), std::string("desk"));
    QVERIFY(b.edits().redo().has_value());
    QVERIFY(sceneSelection(b.context).object().empty());
  }

  void whatStartsInsideOthersIsRefusedUnlessTheyMayHaveMoved() {
    HallBench b(std::make_shared<NarrowLanguage>());
    robotcontrol::WorldObjects objects;
    objects.add_objects()->set_path("desk");
    b.push("objects", objects, 3);
    b.session.tick();
    QCOMPARE(b.insert("box", 3, 4),
             std::string("there is no room for 'box': it would be inside 'desk'; choose another place"));
    QVERIFY(b.texts.empty());
    objects.mutable_objects(0)->set_is_movable(true);
    b.push("objects", objects, 4);
    b.session.tick();
    const QSignalSpy reported(&sceneBench(b.context), &SceneBench::reported);
    QCOMPARE(b.insert("box", 3, 4), std::string("box"));
    QCOMPARE(reported.size(), 1);
    QVERIFY(reported[0][0].toString().contains(QStringLiteral("'box' starts inside 'desk'")));
    QCOMPARE(b.insert("box", 5, 5), std::string("box2"));
    QVERIFY2(reported.size() == 1, "it is known");
  }

  void aRenamedObjectIsWhatItWas() {
    HallBench b(std::make_shared<CrowdedLanguage>());
    robotcontrol::WorldObjects objects;
    for (const char* path : {"desk", "rover"}) objects.add_objects()->set_path(path);
    objects.mutable_objects(0)->set_is_movable(true);
    b.push("objects", objects, 3);
    b.session.tick();
    QCOMPARE(b.setPose("desk", {1, 1, 0, 0, 0, 0}), std::string("desk"));
    const QSignalSpy reported(&sceneBench(b.context), &SceneBench::reported);
    QCOMPARE(b.rename("desk", "table"), std::string("table"));
    QCOMPARE(reported.size(), 0);
  }

  void aBrokenTextIsWhyNothingCanBeFound() {
    HallBench b;
    const auto file = sceneBench(b.context).ensure(b.file);
    QVERIFY(file.has_value());
    (*file)->replaceText((*file)->text() + QStringLiteral("wrong"));
    QCOMPARE(b.setPose("nobody", {0, 0, 0, 0, 0, 0}), std::string("this is wrong"));
    QCOMPARE(b.insert("box", 0, 0), std::string("this is wrong"));
  }

  void discardedChangesAreDiscardedInTheSimulationAndCanBeUndone() {
    HallBench b;
    QCOMPARE(b.setPose("desk", {2, 0, 0, 0, 0, 0}), std::string("desk"));
    SceneFile& file = *sceneBench(b.context).current();
    file.replaceText(file.text() + QStringLiteral("<!-- mine -->"));
    const std::string mine = file.text().toStdString();
    QVERIFY(b.edits().discard(file).has_value());
    QCOMPARE(file.text().toStdString(), kHall);
    QVERIFY(!file.isChanged() && b.texts.back().empty());
    QVERIFY(b.edits().undo().has_value());
    QCOMPARE(file.text().toStdString(), mine);
    QCOMPARE(b.running(), mine);
  }

  void aCopyHasTheNextNumber() {
    HallBench b;
    QCOMPARE(b.copy("rover", {5, 6, 0, 0, 0, 0}), std::string("rover2"));
    QCOMPARE(b.copy("rover2", {6, 6, 0, 0, 0, 0}), std::string("rover3"));
    QCOMPARE(b.copy("rover", {7, 6, 0, 0, 0, 0}), std::string("rover4"));
  }

  void whatWasEditedByHandSinceIsNotLost() {
    HallBench b;
    QCOMPARE(b.setPose("desk", {2, 0, 0, 0, 0, 0}), std::string("desk"));
    SceneFile& file = *sceneBench(b.context).current();
    file.replaceText(file.text() + QStringLiteral("<!-- mine -->"));
    QVERIFY(reason(b.edits().undo()).find("by hand") != std::string::npos);
    QVERIFY(file.text().endsWith(QStringLiteral("<!-- mine -->")));
    QVERIFY(b.edits().canUndo());
  }

  void whatTheSimulatorRefusesChangesNothing() {
    HallBench b;
    QCOMPARE(b.rename("desk", "wrong"), std::string("this is wrong"));
    QVERIFY(b.texts.empty() && !b.edits().canUndo());
    QVERIFY(!sceneBench(b.context).hasUnsaved());
  }

  void namesObjectsAndFilesThatCannotBeAreExplained() {
    HallBench b;
    QVERIFY(b.rename("desk", "a b").find("letters") != std::string::npos);
    QVERIFY(b.rename("desk", "rover").find("another") != std::string::npos);
    QVERIFY(b.erase("nobody").find("nobody") != std::string::npos);
    QVERIFY(b.insert("nothing", 0, 0).find("kind") != std::string::npos);
    std::string outcome;
    b.edits().change({{"/etc/passwd", {"model", "pose"}, "0"}}, {}, HallBench::telling(outcome));
    QVERIFY(outcome.find("not a file of") != std::string::npos);
    QVERIFY(b.texts.empty());
  }

  void withoutASceneHereNothingCanBeChanged() {
    Bench bench;
    QVERIFY(!sceneEdits(bench.context).canChange());
    std::string outcome;
    sceneEdits(bench.context).insert("box", 0, 0, HallBench::telling(outcome));
    QVERIFY(outcome.find("no scene of a file") != std::string::npos);
    QVERIFY(!sceneEdits(bench.context).isBusy());
  }

  void aCheckDoesNotStopTheWindow() {
    const auto language = std::make_shared<SlowLanguage>();
    HallBench b(language);
    std::string outcome;
    b.edits().erase("desk", HallBench::telling(outcome));
    sceneBench(b.context).tick();
    QTRY_COMPARE(language->begun.load(), 1);
    sceneBench(b.context).tick();
    QVERIFY(b.edits().isBusy() && outcome.empty() && b.texts.empty());
    language->gate.release(10);
    QTRY_VERIFY((sceneBench(b.context).tick(), !b.edits().isBusy()));
    QCOMPARE(outcome, std::string("desk"));
    QVERIFY(b.running().find("desk\"") == std::string::npos);
    QVERIFY2(sceneBench(b.context).current()->isChecked(), "the text is not checked twice");
  }

  void ofChangesOfOnePlaceTheLastOneCounts() {
    const auto language = std::make_shared<SlowLanguage>();
    HallBench b(language);
    std::array<std::string, 4> outcomes;
    const auto move = [&](int i) {
      b.edits().setPose("desk", {double(i), 0, 0, 0, 0, 0}, HallBench::telling(outcomes[std::size_t(i)]));
    };
    move(0);
    sceneBench(b.context).tick();
    QTRY_COMPARE(language->begun.load(), 1);
    for (int i = 1; i < 4; ++i) move(i);
    for (const int dropped : {0, 1, 2})
      QVERIFY(outcomes[std::size_t(dropped)].find("given up") != std::string::npos);
    language->gate.release(10);
    b.edits().finish();
    QCOMPARE(outcomes[3], std::string("desk"));
    QCOMPARE(language->begun.load(), 2);
    QCOMPARE(b.texts.size(), std::size_t{1});
    QVERIFY(b.running().find("<pose>3 0 0 0 0 0</pose>") != std::string::npos);
    QVERIFY(b.edits().undo().has_value());
    QVERIFY2(!b.edits().canUndo(), "that was one step");
  }

  void whatIsTypedDuringACheckIsKept() {
    const auto language = std::make_shared<SlowLanguage>();
    HallBench b(language);
    std::string outcome;
    b.edits().erase("rover", HallBench::telling(outcome));
    sceneBench(b.context).tick();
    QTRY_COMPARE(language->begun.load(), 1);
    SceneFile& file = *sceneBench(b.context).current();
    file.replaceText(file.text().replace(QLatin1String("a desk"), QLatin1String("my desk")));
    language->gate.release(10);
    b.edits().finish();
    QCOMPARE(outcome, std::string("rover"));
    QCOMPARE(language->begun.load(), 2);
    QVERIFY(b.running().find("my desk") != std::string::npos);
    QVERIFY(b.running().find("rover") == std::string::npos);
  }

  void whatIsBeingCheckedIsTakenBackByUndo() {
    const auto language = std::make_shared<SlowLanguage>();
    HallBench b(language);
    std::string first, second;
    b.edits().erase("desk", HallBench::telling(first));
    b.edits().erase("rover", HallBench::telling(second));
    sceneBench(b.context).tick();
    QTRY_COMPARE(language->begun.load(), 1);
    QVERIFY(b.edits().undoTitle().contains(QStringLiteral("rover")));
    QVERIFY(b.edits().undo().has_value());
    QVERIFY(second.find("given up") != std::string::npos && first.empty());
    QVERIFY(b.edits().undo().has_value());
    QVERIFY(first.find("given up") != std::string::npos && !b.edits().isBusy() && !b.edits().canUndo());
    language->gate.release(10);
    b.edits().finish();
    sceneBench(b.context).tick();
    QVERIFY(b.texts.empty());
    QVERIFY(!sceneBench(b.context).hasUnsaved());
  }
};

const GuiTest<SceneEditsTest> kSceneEditsTest;

}  // namespace widgets::test

#include "SceneEditsTest.moc"
