// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/file/LogFormat.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace logplayer {
namespace {

TEST(LogFormat, builtInFormatsRegisterThemselvesAndAreOrderedByName) {
  std::vector<std::string> names;
  for (const LogFormat& format : registeredLogFormats()) names.emplace_back(format.name);
  EXPECT_THAT(names, testing::ElementsAre("B-Human message queue", "folder of pictures", "video"));
}

}  // namespace
}  // namespace logplayer
