// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/keys/KeyEntries.h"

#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/StreamStore.h"

namespace widgets {
namespace {

using robotcontrol::KeyMode;

robotlink::StreamMessage tableOfKeys(const char* solution, KeyMode::Kind mode, bool inUse) {
  auto table = std::make_shared<robotcontrol::KeyTable>();
  auto& key = *table->add_keys();
  key.set_name("ball/circle");
  key.set_help("Draws a circle");
  key.mutable_mode()->set_kind(mode);
  key.set_in_use(inUse);
  key.add_solutions(solution);
  key.add_solutions("ball/shared");
  robotlink::StreamMessage message;
  message.value = std::move(table);
  return message;
}

TEST(KeyEntries, aKeyOfSeveralProcessesHasTheModeOfTheOneThatUsesIt) {
  const auto idle = tableOfKeys("ball/a", KeyMode::OFF, false);
  const auto busy = tableOfKeys("ball/b", KeyMode::ALWAYS, true);
  const auto other = tableOfKeys("ball/c", KeyMode::OFF, true);
  const auto keys = mergeKeys({&idle, nullptr, &busy, &other});
  ASSERT_EQ(keys.size(), 1U);
  EXPECT_EQ(keys[0].value.kind, KeyValue::Kind::kAlways);
  EXPECT_TRUE(keys[0].inUse);
  EXPECT_EQ(keys[0].solutions.join(QLatin1Char(' ')).toStdString(), "ball/a ball/shared ball/b ball/c");
}

TEST(KeyEntries, aModeOfANewerProgramCountsAsTheLastOneKnown) {
  KeyMode mode;
  mode.set_kind(static_cast<KeyMode::Kind>(77));
  EXPECT_EQ(keyValue(mode).kind, KeyValue::Kind::kEveryMs);
  mode.set_kind(static_cast<KeyMode::Kind>(-3));
  EXPECT_EQ(keyValue(mode).kind, KeyValue::Kind::kOff);
}

TEST(KeyEntries, onlyModesWithANumberKeepIt) {
  for (const KeyValue::Kind kind : {KeyValue::Kind::kOff, KeyValue::Kind::kAlways, KeyValue::Kind::kTimes,
                                    KeyValue::Kind::kEveryNth, KeyValue::Kind::kEveryMs}) {
    KeyMode mode;
    assign(mode, {kind, 5});
    EXPECT_EQ(keyValue(mode), (KeyValue{kind, hasNumber(kind) ? 5U : 0U}));
  }
  EXPECT_EQ(keyValueText({KeyValue::Kind::kTimes, 5}).toStdString(), "5 left");
  EXPECT_EQ(keyValueText({KeyValue::Kind::kEveryMs, 5}).toStdString(), "5 ms");
  EXPECT_TRUE(keyValueText({KeyValue::Kind::kAlways, 5}).isEmpty());
}

}  // namespace
}  // namespace widgets
