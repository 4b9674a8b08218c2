// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/LogAppend.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/logplayer/RecordedMessages.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using testing::ElementsAre;

std::string bytesOfFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class LogAppendTest : public testing::Test {
 protected:
  void SetUp() override {
    SampleLog{.frames = 5}.write(log_);
    before_ = bytesOfFile(log_);
  }
  static robotlink::Result<void> attach(mcap::Writer& writer) {
    return writer.attach({{}, {}, "note.txt", "text/plain", "a note"});
  }
  /// The names of the attachments; fails if the log is not complete.
  std::vector<std::string> attachments() const {
    auto reader = mcap::Reader::open(log_, {});
    EXPECT_TRUE(reader) << reader.error().describe();
    if (!reader) return {};
    EXPECT_TRUE((*reader)->complete());
    EXPECT_TRUE((*reader)->damage().empty());
    return (*reader)->attachmentNames();
  }

  const TestFolder folder_;
  const std::filesystem::path log_ = folder_ / "log.mcap";
  std::string before_;
};

TEST_F(LogAppendTest, whatIsWrittenIsBehindTheMessagesThatWereThere) {
  const auto entries = tests::readLog(log_).entries;
  ASSERT_TRUE(appendToLog(log_, &attach));
  EXPECT_THAT(attachments(), ElementsAre("note.txt"));
  EXPECT_EQ(tests::readLog(log_).entries, entries);
  ASSERT_TRUE(appendToLog(log_, &attach));
  EXPECT_THAT(attachments(), ElementsAre("note.txt", "note.txt"));
}

TEST_F(LogAppendTest, aFailureLeavesTheFileAsItWasToTheLastByte) {
  const auto failed = appendToLog(log_, [](mcap::Writer& writer) -> robotlink::Result<void> {
    if (const auto done = attach(writer); !done) return done;
    return robotlink::failure("disk.full", "the disk is full");
  });
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().text, "the disk is full");
  EXPECT_EQ(bytesOfFile(log_), before_);
}

TEST_F(LogAppendTest, aLogCanBeAppendedToAfterAFailure) {
  (void)appendToLog(log_,
                    [](mcap::Writer&) -> robotlink::Result<void> { return robotlink::failure("x", "y"); });
  ASSERT_TRUE(appendToLog(log_, &attach));
  EXPECT_THAT(attachments(), ElementsAre("note.txt"));
}

TEST_F(LogAppendTest, aFileThatIsNoCompleteLogIsRefusedAndLeftAlone) {
  bool isCalled = false;
  const auto appendedTo = [&](const std::filesystem::path& file) {
    return appendToLog(file, [&](mcap::Writer& writer) {
      isCalled = true;
      return attach(writer);
    });
  };
  const std::string cut = before_.substr(0, before_.size() - 20);
  for (const std::string& text : {std::string(), std::string("no log"), std::string(1000, '\0'), cut}) {
    const auto file = folder_.write("other.mcap", text);
    EXPECT_FALSE(appendedTo(file)) << text.size();
    EXPECT_EQ(bytesOfFile(file), text) << text.size();
  }
  EXPECT_FALSE(appendedTo(folder_ / "missing.mcap"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "missing.mcap"));
  EXPECT_FALSE(isCalled);
}

}  // namespace
}  // namespace logplayer
