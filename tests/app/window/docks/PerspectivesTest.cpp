// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/Perspectives.h"

#include <QtTest>

#include <fstream>

#include "app/core/platform/PlatformFeed.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/app/window/WindowTest.h"
#include "tests/widgets/GuiTest.h"

namespace app::test {

/// The file of the perspectives and their names; DocksGuiTest shows them.
class PerspectivesTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void withoutAFileThereAreTheShippedOnes() {
    const Perspectives perspectives(file());
    QCOMPARE(perspectives.names().join(QLatin1Char(' ')),
             QStringLiteral("Play Log Colour Motion Processes Drive"));
    QCOMPARE(perspectives.current(), QStringLiteral("Play"));
    QVERIFY(perspectives.isShipped(QStringLiteral("Drive")));
    QVERIFY(!perspectives.isShipped(QStringLiteral("Mine")));
    QVERIFY(perspectives.problems().empty());
  }

  void whatBelongsToTheWindowIsFoundAgain() {
    {
      Perspectives perspectives(file());
      perspectives.setWindow({{QStringLiteral("recent"), QStringLiteral("game.mcap")}});
      QVERIFY(perspectives.save().has_value());
    }
    const Perspectives perspectives(file());
    QCOMPARE(perspectives.window().value(QStringLiteral("recent")).toString(), QStringLiteral("game.mcap"));
  }

  void anUnchangedFileIsNotWrittenAgain() {
    Perspectives perspectives(file());
    QVERIFY(perspectives.save().has_value());
    std::filesystem::remove(file());
    QVERIFY(perspectives.save().has_value());
    QVERIFY(!std::filesystem::exists(file()));
    perspectives.setWindow({{QStringLiteral("a"), 1}});
    QVERIFY(perspectives.save().has_value());
    QVERIFY(std::filesystem::exists(file()));
  }

  void perspectivesOfTheUserFollowTheShippedOnes() {
    write(R"({"version": 1, "current": "Mine", "perspectives": {"Mine": {}, "Play": {}}})");
    Perspectives perspectives(file());
    QCOMPARE(perspectives.names().last(), QStringLiteral("Mine"));
    QCOMPARE(perspectives.names().count(QStringLiteral("Play")), 1);
    QCOMPARE(perspectives.current(), QStringLiteral("Mine"));
    perspectives.remove(QStringLiteral("Mine"));
    QVERIFY(!perspectives.names().contains(QStringLiteral("Mine")));
  }

  void aNameThatIsGoneIsNotTheCurrentOne() {
    write(R"({"version": 1, "current": "Gone", "perspectives": {}})");
    QCOMPARE(Perspectives(file()).current(), QStringLiteral("Play"));
  }

  void oneIsWrittenToAFileAndReadElsewhere() {
    write(R"({"version": 1, "perspectives": {"Mine": {"a": 1}}})");
    const Perspectives here(file());
    const std::filesystem::path out = file().parent_path() / "mine.perspective.json";
    QVERIFY(here.write(QStringLiteral("Mine"), out).has_value());
    QVERIFY(!here.write(QStringLiteral("Other"), out).has_value());
    QVERIFY(!here.write(QStringLiteral("Mine"), out / "below.json").has_value());
    std::filesystem::remove(file());
    Perspectives there(file());
    QCOMPARE(there.read(out).value(), QStringLiteral("Mine"));
    QCOMPARE(there.read(out).value(), QStringLiteral("Mine 2"));
    QVERIFY(there.names().contains(QStringLiteral("Mine 2")));
  }

  void whatIsNoPerspectiveIsRefusedWithAReason() {
    Perspectives perspectives(file());
    const std::filesystem::path other = file().parent_path() / "other.json";
    QVERIFY(!perspectives.read(other).has_value());
    const std::pair<const char*, const char*> cases[] = {
        {"{", "byte 1"},
        {"[]", "no perspective"},
        {R"({"version": 1, "perspective": " ", "docks": {}})", "no perspective"},
        {R"({"version": 1, "perspective": "A", "docks": 7})", "no perspective"},
        {R"({"version": 9, "perspective": "A", "docks": {}})", "newer version"}};
    for (const auto& [text, reason] : cases) {
      std::ofstream(other) << text;
      const auto read = perspectives.read(other);
      QVERIFY2(!read && read.error().describe().find(reason) != std::string::npos, text);
    }
    QCOMPARE(perspectives.names().size(), 6);
  }

  void whatWasChosenForASceneIsRememberedForTheNewestOnes() {
    {
      write(R"({"version": 1, "current": "Mine", "perspectives": {"Mine": {}}})");
      Perspectives perspectives(file());
      QVERIFY(perspectives.chosenFor("a.sdf").isEmpty());
      for (int i = 0; i < Perspectives::kMaxSources; ++i) perspectives.chooseFor(std::to_string(i));
      perspectives.chooseFor("0");
      perspectives.chooseFor("a.sdf");
      QVERIFY(perspectives.save().has_value());
    }
    Perspectives perspectives(file());
    QCOMPARE(perspectives.chosenFor("a.sdf"), QStringLiteral("Mine"));
    QCOMPARE(perspectives.chosenFor("0"), QStringLiteral("Mine"));
    QVERIFY(perspectives.chosenFor("1").isEmpty());
    perspectives.remove(QStringLiteral("Mine"));
    QVERIFY(perspectives.chosenFor("a.sdf").isEmpty());
  }

  void aFileThatCannotBeReadIsKeptAsideAndReported() {
    for (const char* text : {"{ no JSON", R"({"version": 2})", "[]"}) {
      write(text);
      const Perspectives perspectives(file());
      QCOMPARE(perspectives.problems().size(), std::size_t{1});
      QVERIFY(perspectives.problems()[0].describe().find("window.json.broken") != std::string::npos);
      QVERIFY(!std::filesystem::exists(file()) && std::filesystem::exists(home_ / "window.json.broken"));
      QCOMPARE(perspectives.current(), QStringLiteral("Play"));
    }
  }

  void ofVeryManyOnlyTheFirstAreLoaded() {
    std::string all;
    for (int i = 1000; i < 1300; ++i) all += (i > 1000 ? ", \"" : "\"") + std::to_string(i) + "\": {}";
    write(R"({"version": 1, "perspectives": {)" + all + "}}");
    const Perspectives perspectives(file());
    QCOMPARE(perspectives.names().size(), 206);
    QVERIFY(perspectives.names().contains(QStringLiteral("1199")));
    QCOMPARE(perspectives.problems().size(), std::size_t{1});
  }

  void whatIsLoadedChoosesThePerspectiveToBeginWith() {
    LoadedPlatform loaded;
    QCOMPARE(Perspectives::beginningWith(loaded), QString());
    auto dog = std::make_shared<robotlink::RobotDescription>();
    auto rover = std::make_shared<robotlink::RobotDescription>();
    rover->drive = robotlink::RobotDescription::Drive();
    loaded.robots["p3at"] = rover;
    QCOMPARE(Perspectives::beginningWith(loaded), QStringLiteral("Drive"));
    loaded.robots["red1"] = dog;
    QCOMPARE(Perspectives::beginningWith(loaded), QStringLiteral("Play"));
    loaded.time = TimeKind::kLogged;
    QCOMPARE(Perspectives::beginningWith(loaded), QStringLiteral("Log"));
  }

 private:
  std::filesystem::path file() const { return home_ / "window.json"; }
  void write(const std::string& text) { std::ofstream(file()) << text; }
};

const widgets::test::GuiTest<PerspectivesTest> kPerspectivesTest;

}  // namespace app::test

#include "PerspectivesTest.moc"
