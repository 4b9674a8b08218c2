// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings are fetched over a real connection; where it has to break at a certain place, calls fail as if
// it had.
#include "app/core/recordings/RecordingFetch.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "app/core/recordings/RecordingServices.h"
#include "logplayer/record/Recorder.h"
#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/Connector.h"
#include "robotlink/foxglove/server/Listener.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using robotlink::websocket::Client;
using robotlink::websocket::Connector;
using robotlink::websocket::Listener;
using robotlink::websocket::Server;
using testing::HasSubstr;

std::string contentsOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// 1 MB that does not repeat.
std::string manyBytes() {
  std::mt19937 random(1);
  std::string bytes(1'000'000, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

class RecordingFetchTest : public testing::Test {
 protected:
  void SetUp() override {
    files_.write("robot/game.mcap", bytes_);
    Connector::Options options;
    options.url = {.host = "127.0.0.1", .port = listener_->address().port};
    connector_ = std::make_unique<Connector>(client_, options);
  }

  static std::unique_ptr<Listener> listen(const std::shared_ptr<Server>& server) {
    Listener::Options options;
    options.address.port = 0;
    options.greetingDelay = {};
    return Listener::open(server, options).value();
  }
  RecordingFetch fetching() { return RecordingFetch(callsOf(*client_)); }
  /// As if the line broke at each of the given calls of a service, counted from 0.
  RecordingFetch::Call breakingAt(const std::string& service, std::set<int> which) {
    return [this, service, which, count = std::make_shared<int>(0)](const auto& name, const auto& argument,
                                                                    const auto& handler) {
      if (name == service && which.contains((*count)++))
        return handler(robotlink::failure("test.line", "the line is cut"));
      callsOf (*client_)(name, argument, handler);
    };
  }

  const std::string bytes_ = manyBytes();
  TestFolder files_;
  logplayer::Recorder recorder_{{}};
  std::shared_ptr<Server> server_ = Server::make({}, {});
  RecordingServices services_{server_, RecordingFolder(files_ / "robot"), recorder_};
  std::unique_ptr<Listener> listener_ = listen(server_);
  std::shared_ptr<Client> client_ = std::make_shared<Client>(robotlink::websocket::ClientHandlers{});
  std::unique_ptr<Connector> connector_;
};

TEST_F(RecordingFetchTest, recordingsAreListed) {
  const auto entries = fetching().list();
  ASSERT_TRUE(entries) << entries.error().text;
  ASSERT_EQ(entries->size(), 1U);
  EXPECT_EQ(entries->front().name, "game.mcap");
  EXPECT_EQ(entries->front().bytes, bytes_.size());
  EXPECT_FALSE(entries->front().isRecording);
}

TEST_F(RecordingFetchTest, aRecordingIsFetchedAsItIs) {
  double last = 0;
  const auto fetched = fetching().fetch("game.mcap", files_ / "here.mcap", false, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
    return true;
  });
  ASSERT_TRUE(fetched) << fetched.error().text;
  EXPECT_EQ(fetched->bytes, bytes_.size());
  EXPECT_EQ(fetched->resumedAt, 0U);
  EXPECT_GT(last, 0.9);
  EXPECT_EQ(contentsOf(files_ / "here.mcap"), bytes_);
  EXPECT_FALSE(std::filesystem::exists(files_ / "here.mcap.part"));
}

TEST_F(RecordingFetchTest, aCutLineIsWaitedFor) {
  RecordingFetch fetch(breakingAt("recordings/read", {3, 4, 5, 9}));
  const auto fetched = fetch.fetch("game.mcap", files_ / "here.mcap", false);
  ASSERT_TRUE(fetched) << fetched.error().text;
  EXPECT_EQ(contentsOf(files_ / "here.mcap"), bytes_);
}

TEST_F(RecordingFetchTest, whatWasCanceledContinuesWhereItWas) {
  const auto canceled =
      fetching().fetch("game.mcap", files_ / "here.mcap", false, [](double share) { return share < 0.5; });
  ASSERT_FALSE(canceled);
  EXPECT_EQ(canceled.error().id, "canceled");
  EXPECT_FALSE(std::filesystem::exists(files_ / "here.mcap"));
  const auto part = std::filesystem::file_size(files_ / "here.mcap.part");
  EXPECT_GT(part, bytes_.size() / 3);
  const auto fetched = fetching().fetch("game.mcap", files_ / "here.mcap", false);
  ASSERT_TRUE(fetched) << fetched.error().text;
  EXPECT_EQ(fetched->resumedAt, part);
  EXPECT_EQ(contentsOf(files_ / "here.mcap"), bytes_);
}

TEST_F(RecordingFetchTest, aPartOfSomethingElseIsFetchedAnew) {
  files_.write("here.mcap.part", std::string(5000, 'x'));
  const auto fetched = fetching().fetch("game.mcap", files_ / "here.mcap", false);
  ASSERT_TRUE(fetched) << fetched.error().text;
  EXPECT_EQ(fetched->resumedAt, 0U);
  EXPECT_EQ(contentsOf(files_ / "here.mcap"), bytes_);
}

TEST_F(RecordingFetchTest, aPartThatIsLongerThanTheRecordingIsFetchedAnew) {
  files_.write("here.mcap.part", bytes_ + "more");
  ASSERT_TRUE(fetching().fetch("game.mcap", files_ / "here.mcap", false));
  EXPECT_EQ(contentsOf(files_ / "here.mcap"), bytes_);
}

TEST_F(RecordingFetchTest, aFileOfThatNameIsOnlyReplacedIfThatIsWanted) {
  files_.write("here.mcap", "mine");
  const auto refused = fetching().fetch("game.mcap", files_ / "here.mcap", false);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().describe(), HasSubstr("exists already"));
  EXPECT_EQ(contentsOf(files_ / "here.mcap"), "mine");
  EXPECT_TRUE(fetching().fetch("game.mcap", files_ / "here.mcap", true));
  EXPECT_EQ(contentsOf(files_ / "here.mcap"), bytes_);
}

TEST_F(RecordingFetchTest, theRobotSaysWhatItDoesNotHave) {
  const auto fetched = fetching().fetch("none.mcap", files_ / "here.mcap", false);
  ASSERT_FALSE(fetched);
  EXPECT_EQ(fetched.error().text, "there is no recording 'none.mcap'");
  EXPECT_FALSE(std::filesystem::exists(files_ / "here.mcap.part"));
}

TEST_F(RecordingFetchTest, aRobotThatAnswersNonsenseIsNotBelieved) {
  for (const std::string answer : {"", "[]", "{}", R"({"bytes": -1, "crc32": 0})", R"({"recordings": 3})",
                                   R"({"recordings": [3]})", R"({"recordings": [{"name": 1}]})"}) {
    RecordingFetch fetch([&](const auto&, const auto&, const auto& handler) { handler(answer); });
    EXPECT_FALSE(fetch.list()) << answer;
    EXPECT_FALSE(fetch.fetch("game.mcap", files_ / "here.mcap", false)) << answer;
  }
  EXPECT_FALSE(std::filesystem::exists(files_ / "here.mcap"));
}

TEST(RecordingsOfAHostileRobot, areNotWrittenWhereItWantsThem) {
  const auto entry = [](const std::string& name, double modified) {
    return nlohmann::json{{"name", name}, {"bytes", 1}, {"modified", modified}};
  };
  nlohmann::json all = nlohmann::json::array({entry("good.mcap", 1e300), entry("old.mcap", -1e300)});
  for (const char* name : {"../up.mcap", "/etc/passwd", "/tmp/a.mcap", "a/b.mcap", ".hidden.mcap", "..", "",
                           ".bashrc", "a\n.mcap", "a\x1b[2J.mcap"})
    all.push_back(entry(name, 1));
  all.push_back(entry(std::string("a\0.mcap", 7), 1));
  RecordingFetch fetch([&](const auto&, const auto&, const auto& handler) {
    handler(nlohmann::json{{"recordings", all}}.dump());
  });
  const auto listed = fetch.list();
  ASSERT_TRUE(listed);
  ASSERT_EQ(listed->size(), 2U);
  EXPECT_EQ((*listed)[0].name, "good.mcap");
  // As a date.
  EXPECT_LT((*listed)[0].modified, 1e10);
  EXPECT_EQ((*listed)[1].modified, 0);
}

TEST_F(RecordingFetchTest, whatIsBeingRecordedIsNotDeleted) {
  ASSERT_TRUE(client_);
  RecordingFetch fetch = fetching();
  robotcontrol::ControlRecording start;
  start.set_action(robotcontrol::ControlRecording::START);
  ASSERT_TRUE(recorder_.control(start));
  recorder_.finish();
  const auto entries = fetch.list().value();
  const auto recording = std::ranges::find(entries, true, &RecordingFetch::Entry::isRecording);
  ASSERT_NE(recording, entries.end());
  const auto refused = fetch.remove(recording->name);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("stop the recording first"));
  EXPECT_TRUE(fetch.remove("game.mcap"));
  EXPECT_FALSE(std::filesystem::exists(files_ / "robot/game.mcap"));
}

TEST_F(RecordingFetchTest, whoMayOnlyWatchFetchesButDoesNotDelete) {
  connector_.reset();
  const std::string secret = "watchers";
  Listener::Options options;
  options.address.port = 0;
  options.greetingDelay = {};
  options.admission.watchToken = secret;
  options.admission.token = "owners";
  listener_ = Listener::open(server_, options).value();
  Connector::Options connection;
  connection.url = {.host = "127.0.0.1", .port = listener_->address().port};
  connection.token = secret;
  connector_ = std::make_unique<Connector>(client_, connection);
  EXPECT_TRUE(fetching().fetch("game.mcap", files_ / "here.mcap", false));
  EXPECT_FALSE(fetching().remove("game.mcap"));
  EXPECT_TRUE(std::filesystem::exists(files_ / "robot/game.mcap"));
}

}  // namespace
}  // namespace app
