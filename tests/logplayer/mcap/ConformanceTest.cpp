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

/// Files and what is in them.
struct Suite {
  TemporaryFolder folder;
  std::vector<ConformanceCase> cases;
  std::map<std::string, std::filesystem::path> files;
  /// Why there are none.
  std::string problem;

  void find(const std::filesystem::path& answers) {
    cases = conformanceCases(readBytes(answers));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / ""))
      files[entry.path().stem().string()] = entry.path();
  }
};

/// The conformance suite of the MCAP project, unpacked.
std::unique_ptr<Suite> publishedSuite() {
  auto suite = std::make_unique<Suite>();
  if (!std::filesystem::exists(kData)) {
    suite->problem = "the conformance suite is not in " + kData.string();
  } else if (!runs("xz --version") || !runs("tar --version")) {
    suite->problem = "it takes the programs xz and tar";
  } else {
    const auto answers = suite->folder / "answers.json";
    EXPECT_TRUE(runs("tar -xJf '" + (kData / "files.tar.xz").string() + "' -C '" +
                     (suite->folder / "").string() + "'"));
    EXPECT_EQ(std::system(
                  ("xz -dc '" + (kData / "known-answers.json.xz").string() + "' >'" + answers.string() + "'")
                      .c_str()),
              0);
    suite->find(answers);
    EXPECT_EQ(suite->cases.size(), 416U);
  }
  return suite;
}

/// Files of our own, with more in each, by a writer that shares no code with what is tested.
std::unique_ptr<Suite> writtenSuite() {
  auto suite = std::make_unique<Suite>();
  const std::string writer = ROBOTCONTROL_SOURCE_DIR "/tests/logplayer/mcap/conformance_files.py";
  EXPECT_EQ(std::system(("'" PYTHON "' '" + writer + "' '" + (suite->folder / "").string() + "'").c_str()),
            0);
  suite->find(suite->folder / "answers.json");
  EXPECT_GT(suite->cases.size(), 400U);
  return suite;
}

/// The parameter names a suite, which is read once for all tests.
class ConformanceTest : public testing::TestWithParam<const char*> {
 protected:
  static void TearDownTestSuite() { suites_.clear(); }

  void SetUp() override {
    auto& suite = suites_[GetParam()];
    if (!suite) suite = GetParam() == std::string("published") ? publishedSuite() : writtenSuite();
    suite_ = suite.get();
    if (!suite_->problem.empty()) GTEST_SKIP() << suite_->problem;
    ASSERT_FALSE(suite_->cases.empty());
  }
  std::string bytesOf(const ConformanceCase& conformance) const {
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

  static inline std::map<std::string, std::unique_ptr<Suite>> suites_;
  const Suite* suite_ = nullptr;
};

TEST_P(ConformanceTest, everyFileIsWrittenByteForByte) {
  for (const ConformanceCase& conformance : suite_->cases) {
    EXPECT_EQ(textOf(writtenBy(conformance)), bytesOf(conformance)) << conformance.name;
  }
}

TEST_P(ConformanceTest, everyFileIsDecodedRecordForRecord) {
  for (const ConformanceCase& conformance : suite_->cases) {
    const std::string bytes = bytesOf(conformance);
    const auto records = recordsIn(logplayer::mcap::bytesOf(bytes));
    ASSERT_TRUE(records) << conformance.name;
    EXPECT_TRUE(*records == conformance.records) << conformance.name;
  }
}

TEST_P(ConformanceTest, everyFileIsReadWithAllThatIsInIt) {
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

TEST_P(ConformanceTest, everyFileIsReadInOrderOfTime) {
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

INSTANTIATE_TEST_SUITE_P(Files, ConformanceTest, testing::Values("published", "written"),
                         [](const auto& suite) { return std::string(suite.param); });

}  // namespace
