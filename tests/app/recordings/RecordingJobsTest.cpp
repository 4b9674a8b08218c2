// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/RecordingJobs.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "app/core/recordings/RecordingFolder.h"
#include "robotlink/foxglove/client/Client.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using nlohmann::json;
using Kind = RecordingJobs::Kind;

/// A robot that answers at once, but for the pieces of a recording behind `pieces`: those are never answered.
class RecordingJobsTest : public testing::Test {
 protected:
  RecordingJobsTest() { files_.write("robot/game.mcap", std::string(1'000'000, 'x')); }

  void answer(const std::string& service, const json& argument,
              const std::function<void(RecordingFetch::Answer)>& handler) {
    const std::string name = argument.value("name", "");
    if (service == "recordings/list") {
      json all = json::array();
      const auto entries = folder_.list().value();
      for (const auto& entry : entries)
        all.push_back({{"name", entry.name}, {"bytes", entry.bytes}, {"whole", entry.isWhole}});
      return handler(json{{"recordings", all}}.dump());
    }
    if (service == "recordings/check") {
      const auto checked = folder_.extend(name, {}, argument["bytes"], UINT64_MAX);
      if (!checked) return handler(robotlink::failure(robotlink::websocket::kServiceFailure, "none"));
      return handler(json{{"bytes", checked->bytes}, {"crc32", checked->crc}}.dump());
    }
    if (service == "recordings/read") {
      if (pieces_-- <= 0) return held_.push_back(handler);
      return handler(folder_.read(name, argument["offset"], argument["bytes"]).value());
    }
    if (service == "recordings/delete") static_cast<void>(folder_.remove(name));
    if (service == "recordings/start") files_.write("robot/new.mcap", "cut off");
    handler("{}");
  }
  /// The next thing that was done.
  RecordingJobs::Outcome next() {
    std::vector<RecordingJobs::Outcome> outcomes;
    EXPECT_TRUE(eventually([&] {
      outcomes = jobs_->takeOutcomes();
      return !outcomes.empty();
    }));
    return outcomes.empty() ? RecordingJobs::Outcome{Kind::kList, "nothing"} : outcomes.front();
  }
  bool has(std::size_t recordings) {
    return eventually([&] { return jobs_->recordings() && jobs_->recordings()->size() == recordings; });
  }

  TestFolder files_;
  RecordingFolder folder_{files_ / "robot"};
  /// In the thread that fetches.
  std::atomic<int> pieces_ = 1000;
  std::vector<std::function<void(RecordingFetch::Answer)>> held_;
  std::unique_ptr<RecordingJobs> jobs_ = std::make_unique<RecordingJobs>(
      [this](const std::string& service, const std::string& argument, auto handler) {
        answer(service, json::parse(argument), handler);
      });
};

TEST_F(RecordingJobsTest, recordingsAreListedStartedAndDeleted) {
  EXPECT_FALSE(jobs_->recordings());
  jobs_->list();
  ASSERT_TRUE(has(1));
  EXPECT_FALSE(jobs_->recordings()->front().isWhole);
  jobs_->start();
  EXPECT_EQ(next().kind, Kind::kStart);
  EXPECT_TRUE(has(2));
  jobs_->remove("game.mcap");
  const auto removed = next();
  EXPECT_EQ(removed.kind, Kind::kRemove);
  EXPECT_EQ(removed.name, "game.mcap");
  EXPECT_FALSE(removed.error);
  EXPECT_TRUE(has(1));
}

TEST_F(RecordingJobsTest, aFetchThatWasCanceledGoesOnWhereItWas) {
  pieces_ = 5;
  jobs_->fetch("game.mcap", files_ / "here.mcap", false);
  ASSERT_TRUE(eventually([&] { return jobs_->fetching() && jobs_->fetching()->share > 0.3; }));
  // Meanwhile the robot can be asked other things.
  jobs_->list();
  EXPECT_TRUE(has(1));
  jobs_->fetch("other.mcap", files_ / "other.mcap", false);
  jobs_->cancel();
  const auto canceled = next();
  ASSERT_TRUE(canceled.error);
  EXPECT_EQ(canceled.error->id, "canceled");
  EXPECT_FALSE(jobs_->fetching());
  pieces_ = 1000;
  jobs_->fetch("game.mcap", files_ / "here.mcap", false);
  const auto fetched = next();
  EXPECT_FALSE(fetched.error) << fetched.error->text;
  EXPECT_EQ(fetched.name, "game.mcap");  // the one that waited was dropped
  EXPECT_EQ(fetched.fetched.resumedAt, 5U * 64 * 1024);
  EXPECT_EQ(std::filesystem::file_size(files_ / "here.mcap"), 1'000'000U);
}

TEST_F(RecordingJobsTest, itEndsWhileTheRobotDoesNotAnswer) {
  pieces_ = 0;
  jobs_->fetch("game.mcap", files_ / "here.mcap", false);
  ASSERT_TRUE(eventually([&] { return jobs_->fetching().has_value(); }));
  jobs_.reset();
}

TEST_F(RecordingJobsTest, whatTheRobotDoesNotHaveIsSaid) {
  jobs_->fetch("none.mcap", files_ / "here.mcap", false);
  const auto outcome = next();
  ASSERT_TRUE(outcome.error);
  EXPECT_EQ(outcome.error->text, "none");
}

TEST(WholeRecordings, aRecordingThatEndsAsItShouldIsWhole) {
  const TestFolder files;
  const std::string magic("\x89MCAP0\r\n", 8);
  files.write("whole.mcap", magic + "contents" + magic);
  files.write("cut.mcap", magic + "contents");
  files.write("short.mcap", "");
  const auto entries = RecordingFolder(files.path()).list().value();
  for (const auto& entry : entries) EXPECT_EQ(entry.isWhole, entry.name == "whole.mcap") << entry.name;
}

}  // namespace
}  // namespace app
