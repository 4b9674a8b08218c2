// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/OpenPlatform.h"

#include <gmock/gmock.h>

#include <future>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/session/KeyPresets.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/Requests.h"
#include "tests/app/open/FakeFeed.h"

namespace app {
namespace {

using robotcontrol::Request;
using test::failingOpening;
using test::fakeOpening;
using test::fakePlatform;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What is open, with platforms that only note what they are asked.
class OpenPlatformTest : public testing::Test {
 protected:
  OpenPlatformTest() {
    open_.onLoaded([this](const LoadedPlatform& loaded) { loaded_.push_back(loaded.title); });
    open_.onErrors([this](const robotlink::Errors& errors) {
      for (const auto& error : errors) errors_.push_back(error.text);
    });
  }
  template <typename Condition>
  bool soon(Condition condition) {
    return eventually([&] {
      open_.tick();
      return condition();
    });
  }
  bool opened(const std::string& title, TimeKind time = TimeKind::kReal) {
    const std::size_t before = loaded_.size();
    open_.open(fakeOpening(fakePlatform(title, time), notes_));
    return soon([&] { return loaded_.size() > before && !open_.loading(); });
  }
  /// The keys that the platform was asked to switch, in the order of their names.
  std::vector<std::string> keysAsked() const {
    std::vector<std::string> names;
    for (const Request& request : notes_->requests())
      if (request.has_set_key()) names.push_back(request.set_key().name());
    std::ranges::sort(names);
    return names;
  }
  /// Those that are on at first, in the same order.
  static std::vector<std::string> shippedKeys() {
    const auto shipped = robotlink::KeyPresets(robotlink::resource("presets")).load("start").value();
    std::vector<std::string> names;
    for (const auto& key : shipped.keys()) names.push_back(key.name());
    std::ranges::sort(names);
    return names;
  }
  /// The robot publishes that only this key is on.
  void publishKey(const std::string& name) {
    auto table = std::make_shared<robotcontrol::KeyTable>();
    auto& key = *table->add_keys();
    key.set_name(name);
    key.mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    open_.session().push({"red1/tables/keys", robotlink::Instant(std::chrono::seconds(1)), table});
    open_.tick();
  }
  std::filesystem::path savedKeys() const { return home_ / "session" / "red1.keys.json"; }

  const TestFolder home_;
  const std::shared_ptr<test::FeedNotes> notes_ = std::make_shared<test::FeedNotes>();
  std::vector<std::string> loaded_, errors_;
  OpenPlatform open_{home_.path()};
};

TEST_F(OpenPlatformTest, thereIsNothingUntilSomethingWasOpened) {
  open_.tick();
  EXPECT_EQ(open_.loaded(), nullptr);
  EXPECT_FALSE(open_.loading());
  EXPECT_EQ(open_.progress(), std::nullopt);
  EXPECT_EQ(open_.openingName(), "");
  open_.cancelOpening();
  EXPECT_THAT(open_.takeOpeningErrors(), IsEmpty());
}

TEST_F(OpenPlatformTest, whatIsOpenIsKnownInTheTickInWhichItsResultArrives) {
  open_.open(fakeOpening(fakePlatform("rover"), notes_));
  EXPECT_TRUE(open_.loading()) << "at once";
  EXPECT_THAT(open_.session().robots(), IsEmpty());
  ASSERT_TRUE(soon([this] { return !open_.loading(); }));
  EXPECT_THAT(loaded_, ElementsAre("rover"));
  EXPECT_EQ(open_.loaded()->title, "rover");
  EXPECT_THAT(open_.session().robots(), ElementsAre("red1"));
}

TEST_F(OpenPlatformTest, whatCannotBeOpenedLeavesWhatRan) {
  ASSERT_TRUE(opened("rover"));
  open_.open(failingOpening("robot.gone", "nobody answers"));
  ASSERT_TRUE(soon([this] { return !open_.loading(); }));
  EXPECT_EQ(open_.loaded()->title, "rover");
  EXPECT_THAT(open_.session().robots(), ElementsAre("red1"));
  EXPECT_THAT(errors_, testing::Contains("nobody answers"));
  const robotlink::Errors why = open_.takeOpeningErrors();
  ASSERT_FALSE(why.empty());
  EXPECT_EQ(why.front().id, "robot.gone");
  EXPECT_THAT(open_.takeOpeningErrors(), IsEmpty()) << "once";
}

TEST_F(OpenPlatformTest, closingLeavesNoRobots) {
  ASSERT_TRUE(opened("rover"));
  open_.close();
  ASSERT_TRUE(soon([this] { return !open_.loading(); }));
  ASSERT_NE(open_.loaded(), nullptr);
  EXPECT_EQ(open_.loaded()->adapter, "");
  EXPECT_THAT(open_.loaded()->ended, ElementsAre("rover was shut down."));
  EXPECT_THAT(open_.session().robots(), IsEmpty());
}

TEST_F(OpenPlatformTest, whatWasCanceledIsNoErrorToShowButOneForScripts) {
  std::promise<void> mayGoOn;
  PlatformOpening opening = failingOpening("", "");
  opening.file = "/logs/game.mcap";
  opening.make = [going = mayGoOn.get_future().share()](const PlatformContext& context) {
    const bool before = context.progress(0.25);
    going.wait();
    const char* id = before && !context.progress(0.5) ? "log.given-up" : "log.went-on";
    return PlatformOpening::Made(tl::unexpected(robotlink::Errors{{id, "canceled", {}, {}}}));
  };
  open_.open(std::move(opening));
  EXPECT_EQ(open_.openingName(), "game.mcap");
  EXPECT_TRUE(soon([this] { return open_.progress() == 0.25; }));
  open_.cancelOpening();
  mayGoOn.set_value();
  ASSERT_TRUE(soon([this] { return !open_.loading(); }));
  EXPECT_EQ(open_.progress(), std::nullopt);
  EXPECT_THAT(errors_, IsEmpty());
  const robotlink::Errors why = open_.takeOpeningErrors();
  ASSERT_EQ(why.size(), 1U);
  EXPECT_EQ(why.front().id, "log.given-up");
}

TEST_F(OpenPlatformTest, onlyARealRobotIsConnectedAtOnce) {
  EXPECT_EQ(open_.connectNow().error().id, "robot.not-real");
  ASSERT_TRUE(opened("field", TimeKind::kSimulated));
  EXPECT_EQ(open_.connectNow().error().id, "robot.not-real");
  ASSERT_TRUE(opened("rover"));
  EXPECT_TRUE(open_.connectNow());
  EXPECT_TRUE(soon([this] { return notes_->events().back() == "rover: connects"; }));
}

TEST_F(OpenPlatformTest, aRobotThatIsNewHasTheKeysOfTheShippedPreset) {
  const auto wanted = shippedKeys();
  ASSERT_GT(wanted.size(), 1U);
  ASSERT_TRUE(opened("rover"));
  ASSERT_TRUE(soon([&] { return keysAsked().size() == wanted.size(); }));
  EXPECT_EQ(keysAsked(), wanted);
}

TEST_F(OpenPlatformTest, keysThatWereOnAreOnAgainInTheNextPlatform) {
  ASSERT_TRUE(opened("rover"));
  publishKey("package/models/ball");
  ASSERT_TRUE(soon([this] { return open_.keepKeys() && std::filesystem::exists(savedKeys()); }));
  const auto before = keysAsked().size();
  ASSERT_TRUE(opened("other rover"));
  ASSERT_TRUE(soon([&] { return keysAsked().size() > before; }));
  EXPECT_EQ(keysAsked().size(), before + 1);
  EXPECT_EQ(notes_->requests().back().set_key().name(), "package/models/ball");
  EXPECT_EQ(notes_->requests().back().robot(), "red1");
}

TEST_F(OpenPlatformTest, keysStayAsTheyWereSavedWhileTheRobotHasNotSwitchedThemOn) {
  notes_->answers = false;
  ASSERT_TRUE(opened("rover"));
  ASSERT_TRUE(soon([this] { return !keysAsked().empty(); }));
  publishKey("package/models/ball");
  EXPECT_TRUE(open_.keepKeys());
  EXPECT_FALSE(std::filesystem::exists(savedKeys())) << "the table may be the one from before";
}

TEST_F(OpenPlatformTest, aScriptKeepsNothing) {
  ASSERT_TRUE(opened("rover"));
  publishKey("package/models/ball");
  open_.keepNothing();
  ASSERT_TRUE(opened("other rover"));
  EXPECT_TRUE(open_.keepKeys());
  EXPECT_FALSE(std::filesystem::exists(savedKeys()));
}

TEST_F(OpenPlatformTest, keysThatCannotBeKeptAreReported) {
  ASSERT_TRUE(opened("rover"));
  home_.write("session", "a file where the folder has to be");
  publishKey("package/models/ball");
  ASSERT_TRUE(soon([this] { return !open_.keepKeys(); }));
  ASSERT_TRUE(opened("other rover"));
  EXPECT_THAT(errors_, testing::Contains(HasSubstr("Not a directory")));
}

TEST_F(OpenPlatformTest, anotherLayoutIsNoOtherPlatform) {
  ASSERT_TRUE(opened("rover"));
  const auto before = shippedKeys();
  ASSERT_TRUE(soon([&] { return keysAsked() == before; }));
  open_.setLayout("walk.yaml");
  ASSERT_TRUE(soon([this] { return !open_.loading(); }));
  EXPECT_THAT(loaded_, ElementsAre("rover", "rover"));
  EXPECT_EQ(open_.loaded()->layout, "walk.yaml");
  EXPECT_EQ(keysAsked(), before) << "the robot was there before";
  open_.setLayout("bad.yaml");
  ASSERT_TRUE(soon([this] { return !open_.loading(); }));
  EXPECT_THAT(errors_, ElementsAre("the layout is bad"));
  EXPECT_EQ(open_.loaded()->layout, "walk.yaml");
}

TEST_F(OpenPlatformTest, aRefusalOfWhatIsAskedIsReported) {
  open_.ask(test::keyRequest("red1", "package/models/ball"));
  ASSERT_TRUE(soon([this] { return !errors_.empty(); }));
  EXPECT_THAT(errors_, ElementsAre(HasSubstr("nothing is running that can do this")));
  ASSERT_TRUE(opened("rover"));
  open_.ask(test::keyRequest("blue9", "package/models/ball"));
  ASSERT_TRUE(soon([this] { return errors_.size() == 2; }));
  EXPECT_EQ(errors_.back(), "there is no robot blue9");
}

TEST_F(OpenPlatformTest, choicesThatALayoutCannotFulfillAreReportedOnceItRuns) {
  LoadedPlatform loaded = fakePlatform("rover");
  loaded.lostChoices = {"red1 could not keep its goal: there is none", "red1 could not keep its motion"};
  open_.open(fakeOpening(loaded, notes_));
  ASSERT_TRUE(soon([this] { return !errors_.empty(); }));
  EXPECT_EQ(errors_, loaded.lostChoices);
  EXPECT_THAT(loaded_, ElementsAre("rover"));
}

TEST_F(OpenPlatformTest, aRecordingIsNoBusinessOfThePlatform) {
  const auto resultOf = [this](robotcontrol::ControlRecording::Action action, const std::string& path) {
    Request request;
    request.mutable_control_recording()->set_action(action);
    request.mutable_control_recording()->set_path(path);
    std::optional<robotcontrol::RequestResult> result;
    open_.session().request(request, [&](const auto& answer) { result = answer; });
    open_.tick();
    return result.value_or(robotcontrol::RequestResult());
  };
  const auto wrong = resultOf(robotcontrol::ControlRecording::START, (home_ / "none" / "a.mcap").string());
  EXPECT_FALSE(wrong.accepted());
  EXPECT_NE(wrong.reason(), "");
  EXPECT_TRUE(resultOf(robotcontrol::ControlRecording::START, (home_ / "a.mcap").string()).accepted());
  EXPECT_TRUE(resultOf(robotcontrol::ControlRecording::STOP, "").accepted());
  EXPECT_TRUE(std::filesystem::exists(home_ / "a.mcap"));
}

TEST_F(OpenPlatformTest, limitsOfAConnectionAreRememberedBeforeThereIsOne) {
  LinkLimits limits;
  limits.bytesPerSecond = 1e5;
  EXPECT_FALSE(open_.limitRemote("http://10.0.0.7", limits));
  ASSERT_TRUE(open_.limitRemote("ws://10.0.0.7", limits));
  open_.tick();
  EXPECT_EQ(LinkLimitsMemory(home_ / "links.json").limits("ws://10.0.0.7:8765"), limits)
      << "with the usual port";
}

TEST_F(OpenPlatformTest, onlyARobotThatIsThereIsSteered) {
  const auto done = open_.steer("red1", false);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().id, "robot.unknown");
  EXPECT_EQ(done.error().text, "there is no robot red1");
}

}  // namespace
}  // namespace app
