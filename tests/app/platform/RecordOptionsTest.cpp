// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/RecordOptions.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "logplayer/file/LogFile.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

using namespace app;
using robotcontrol::ControlRecording;

TEST(RecordOptions, namesStandForCodingsAndCompressions) {
  EXPECT_EQ(imageCodingNamed("as-is"), ControlRecording::AS_IS);
  EXPECT_EQ(imageCodingNamed("jpeg"), ControlRecording::JPEG);
  EXPECT_EQ(imageCodingNamed("png"), ControlRecording::PNG);
  EXPECT_EQ(imageCodingNamed("gif"), std::nullopt);
  EXPECT_EQ(compressionNamed("none"), ControlRecording::NONE);
  EXPECT_EQ(compressionNamed("lz4"), ControlRecording::LZ4);
  EXPECT_EQ(compressionNamed("zstd"), ControlRecording::ZSTD);
  EXPECT_EQ(compressionNamed(""), std::nullopt);
}

TEST(RecordOptions, withoutAFileNothingIsRecorded) {
  const auto recorder = RecordOptions{}.start();
  ASSERT_TRUE(recorder.has_value());
  EXPECT_EQ(*recorder, nullptr);
}

TEST(RecordOptions, theirFormatNeedsAFile) {
  CLI::App command;
  RecordOptions options;
  options.addTo(command);
  EXPECT_THROW(command.parse("--images jpeg"), CLI::ParseError);
  EXPECT_THROW(command.parse("--record a.mcap --images gif"), CLI::ParseError);
  command.parse("--record a.mcap --images jpeg --compression lz4");
  EXPECT_EQ(options.file, "a.mcap");
  EXPECT_EQ(options.images, "jpeg");
  EXPECT_EQ(options.compression, "lz4");
}

TEST(RecordOptions, whatWasRecordedIsReported) {
  const TestFolder folder;
  RecordOptions options;
  options.file = (folder.path() / "a.mcap").string();
  const auto recorder = options.start();
  ASSERT_TRUE(recorder.has_value()) << recorder.error().text;
  std::ostringstream out;
  EXPECT_EQ(finishRecording(**recorder, out), kDone);
  EXPECT_EQ(out.str().find(options.file + ": 0 messages, "), 0U) << out.str();
  EXPECT_FALSE(options.start().has_value()) << "it exists already";
}
