// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "logplayer/mcap/RecordBytes.h"
#include "tests/logplayer/mcap/TemporaryLog.h"

// Files of ours, read by the MCAP project's own library for JavaScript.
using namespace logplayer::mcap;
using namespace logplayer::mcap::test;

namespace {

const std::string kScript = ROBOTCONTROL_SOURCE_DIR "/tests/logplayer/mcap/read_with_mcap_core.mjs";

struct Output {
  int status = -1;
  std::string text;
};

Output runScript(const std::string& argument) {
  Output output;
  FILE* const pipe = ::popen(("node '" + kScript + "' '" + argument + "' 2>&1").c_str(), "r");
  if (pipe == nullptr) return output;
  char buffer[4096];
  for (std::size_t count; (count = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    output.text.append(buffer, count);
  const int status = ::pclose(pipe);
  output.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return output;
}

std::string lineOf(const std::string& reader, const Expected& expected) {
  std::ostringstream line;
  line << reader << " c" << expected.channelId << ' ' << expected.sequence << ' ' << expected.time << ' '
       << expected.time + 1 << ' ';
  for (const char c : expected.data) {
    char hex[3];
    std::snprintf(hex, sizeof hex, "%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
    line << hex;
  }
  return line.str();
}

class InteropTest : public testing::TestWithParam<Compression> {
 protected:
  static void SetUpTestSuite() { check_ = runScript("--check"); }
  void SetUp() override {
    if (check_.status == 0) return;
    GTEST_SKIP()
        << "it takes node with the packages @mcap/core and @mcap/support: npm install them anywhere, "
           "and set ROBOTCONTROL_NODE_MODULES to the folder node_modules there ("
        << check_.text << ")";
  }
  /// What the script must print of these messages, given in the order of the file.
  static std::vector<std::string> expectedLines(std::vector<Expected> messages) {
    std::vector<std::string> lines;
    for (const Expected& expected : messages) lines.push_back(lineOf("stream", expected));
    std::ranges::stable_sort(messages, {}, &Expected::time);
    for (const Expected& expected : messages) lines.push_back(lineOf("indexed", expected));
    return lines;
  }
  void expectRead(const std::vector<Expected>& messages, std::size_t chunks) {
    const Output output = runScript(log_);
    ASSERT_EQ(output.status, 0) << output.text;
    std::vector<std::string> lines, others;
    std::istringstream text(output.text);
    for (std::string line; std::getline(text, line);) {
      const bool isMessage = line.starts_with("indexed ") || line.starts_with("stream ");
      (isMessage ? lines : others).push_back(line);
    }
    // The stream reader's come last in the output, first here.
    std::stable_partition(lines.begin(), lines.end(),
                          [](const std::string& line) { return line.starts_with("stream"); });
    EXPECT_EQ(lines, expectedLines(messages));
    EXPECT_THAT(others, testing::Contains("statistics " + std::to_string(messages.size()) + " in " +
                                          std::to_string(chunks) + " chunks"));
    others_ = others;
  }
  Writer::Options options() const {
    Writer::Options options;
    options.compression = GetParam();
    options.chunkBytes = 2000;
    return options;
  }

  static inline Output check_;
  TemporaryFolder folder_;
  std::filesystem::path log_ = folder_ / "log.mcap";
  std::vector<std::string> others_;
};

TEST_P(InteropTest, severalChunksAreRead) {
  const std::vector<Expected> messages = someMessages(300);
  writeLog(log_, messages, options());
  expectRead(messages, test::open(log_)->chunks().size());
}

TEST_P(InteropTest, overlappingChunksAreRead) {
  std::vector<Expected> messages = someMessages(300);
  for (std::size_t i = 0; i < messages.size(); i += 7)
    messages[i].time += 1000;  // some are late by many chunks
  writeLog(log_, messages, options());
  expectRead(messages, test::open(log_)->chunks().size());
}

TEST_P(InteropTest, aFileThatWasAppendedToIsRead) {
  std::vector<Expected> messages = someMessages(100);
  writeLog(log_, messages, options());
  {
    auto writer = Writer::append(log_, options());
    ASSERT_TRUE(writer);
    messages.push_back({2, 5, 5000, "appended"});
    write(**writer, messages.back());
    ASSERT_TRUE((*writer)->attach({at(1), at(2), "notes", "text/plain", "ab"}));
    ASSERT_TRUE((*writer)->addMetadata({"m", {{"key", "value"}}}));
    ASSERT_TRUE((*writer)->close());
  }
  expectRead(messages, test::open(log_)->chunks().size());
  EXPECT_THAT(others_, testing::Contains("attachment notes 6162"));
  EXPECT_THAT(others_, testing::Contains(R"(metadata m [["key","value"]])"));
}

TEST_P(InteropTest, aRepairedFileIsRead) {
  const std::vector<Expected> messages = someMessages(300);
  writeLog(folder_ / "whole.mcap", messages, options());
  const std::string bytes = readBytes(folder_ / "whole.mcap");
  writeBytes(folder_ / "cut.mcap", bytes.substr(0, bytes.size() / 2));
  const auto report = repair(folder_ / "cut.mcap", log_);
  ASSERT_TRUE(report);
  ASSERT_GT(report->messages, 50U);
  const auto end = messages.begin() + static_cast<std::ptrdiff_t>(report->messages);
  expectRead({messages.begin(), end}, test::open(log_)->chunks().size());
}

INSTANTIATE_TEST_SUITE_P(Compressions, InteropTest,
                         testing::Values(Compression::kNone, Compression::kLz4, Compression::kZstd));

}  // namespace
