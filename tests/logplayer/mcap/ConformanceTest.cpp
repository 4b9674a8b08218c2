// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cstdlib>

#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/read/MessageCursor.h"
#include "tests/logplayer/mcap/ConformanceCase.h"
#include "tests/logplayer/mcap/TemporaryLog.h"

using namespace logplayer::mcap;
using namespace logplayer::mcap::test;

namespace {

const std::filesystem::path kData = ROBOTCONTROL_SOURCE_DIR "/../shared/data/mcap-conformance";

bool runs(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

/// All files of the MCAP project's conformance suite, unpacked once.
class ConformanceTest : public testing::Test {
 protected:
  struct Suite {
    TemporaryFolder folder;
    std::vector<ConformanceCase> cases;
    std::map<std::string, std::filesystem::path> files;
  };

  static void SetUpTestSuite() {
    if (!std::filesystem::exists(kData))
      return void(problem_ = "the conformance suite is not in " + kData.string());
    if (!runs("xz --version") || !runs("tar --version"))
      return void(problem_ = "it takes the programs xz and tar");
    suite_ = std::make_unique<Suite>();
    const std::string json = (suite_->folder / "answers.json").string();
    const std::string unpackJson =
        "xz -dc '" + (kData / "known-answers.json.xz").string() + "' >'" + json + "'";
    const std::string unpackFiles =
        "tar -xJf '" + (kData / "files.tar.xz").string() + "' -C '" + (suite_->folder / "").string() + "'";
    ASSERT_EQ(std::system(unpackJson.c_str()), 0);
    ASSERT_EQ(std::system(unpackFiles.c_str()), 0);
    suite_->cases = conformanceCases(readBytes(json));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(suite_->folder / "")) {
      suite_->files[entry.path().stem().string()] = entry.path();
    }
  }
  static void TearDownTestSuite() { suite_.reset(); }

  void SetUp() override {
    if (suite_ == nullptr) GTEST_SKIP() << problem_;
    ASSERT_EQ(suite_->cases.size(), 416U);
  }
  static std::string bytesOf(const ConformanceCase& conformance) {
    return readBytes(suite_->files.at(conformance.name));
  }
  template <typename Kind>
  static std::vector<Kind> dataOf(const ConformanceCase& conformance) {
    std::vector<Kind> found;
    for (const Record& record : conformance.records) {
      if (std::holds_alternative<DataEnd>(record)) break;
      if (const Kind* kind = std::get_if<Kind>(&record)) found.push_back(*kind);
    }
    return found;
  }

  static inline std::unique_ptr<Suite> suite_;
  static inline std::string problem_;
};

TEST_F(ConformanceTest, everyFileIsWrittenByteForByte) {
  for (const ConformanceCase& conformance : suite_->cases) {
    EXPECT_EQ(textOf(writtenBy(conformance)), bytesOf(conformance)) << conformance.name;
  }
}

TEST_F(ConformanceTest, everyFileIsDecodedRecordForRecord) {
  for (const ConformanceCase& conformance : suite_->cases) {
    const std::string bytes = bytesOf(conformance);
    const auto records = recordsIn(logplayer::mcap::bytesOf(bytes));
    ASSERT_TRUE(records) << conformance.name;
    EXPECT_TRUE(*records == conformance.records) << conformance.name;
  }
}

TEST_F(ConformanceTest, everyFileIsReadWithAllThatIsInIt) {
  for (const ConformanceCase& conformance : suite_->cases) {
    SCOPED_TRACE(conformance.name);
    const auto reader = test::open(suite_->files.at(conformance.name));
    ASSERT_NE(reader, nullptr);
    std::vector<OwnedMessage> messages;
    reader->readAll([&](const Message& message) {
      messages.push_back(OwnedMessage::of(message));
      return true;
    });
    EXPECT_TRUE(messages == dataOf<OwnedMessage>(conformance));
    for (const Schema& schema : dataOf<Schema>(conformance))
      EXPECT_EQ(reader->schemas().at(schema.id), schema);
    for (const Channel& channel : dataOf<Channel>(conformance))
      EXPECT_EQ(reader->channels().at(channel.id), channel);
    for (const Attachment& attachment : dataOf<Attachment>(conformance)) {
      EXPECT_EQ(reader->attachment(attachment.name).value(), attachment);
    }
    EXPECT_EQ(reader->metadata(), dataOf<Metadata>(conformance));
    EXPECT_EQ(reader->statistics().messageCount, messages.size());
    EXPECT_TRUE(reader->complete());
    EXPECT_TRUE(reader->verify());
    EXPECT_TRUE(reader->damage().empty()) << reader->damage().front().what;
  }
}

TEST_F(ConformanceTest, everyFileIsReadInOrderOfTime) {
  for (const ConformanceCase& conformance : suite_->cases) {
    const auto reader = test::open(suite_->files.at(conformance.name));
    std::vector<std::uint16_t> channels;
    for (const auto& [id, channel] : reader->channels()) channels.push_back(id);
    std::vector<OwnedMessage> expected = dataOf<OwnedMessage>(conformance);
    std::ranges::stable_sort(expected, {}, &OwnedMessage::logTime);
    std::vector<OwnedMessage> messages;
    MessagePosition position{Instant::min(), 0, 0, 0};
    while (const auto next = reader->next(position, channels)) {
      messages.push_back(OwnedMessage::of(reader->read(*next).value().message));
      position = *next;
    }
    EXPECT_TRUE(messages == expected) << conformance.name;
    messages.clear();
    for (MessageCursor cursor(*reader, channels); cursor.next();)
      messages.push_back(OwnedMessage::of(cursor.message()));
    EXPECT_TRUE(messages == expected) << conformance.name;
  }
}

}  // namespace
