// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/MissingValues.h"

#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/Session.h"
#include "tests/widgets/timeline/MadeUpArchive.h"

namespace widgets::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

robotlink::Instant missingTime(double seconds) {
  return robotlink::Instant(robotlink::fromSeconds(seconds));
}

TEST(MissingValuesTest, whatIsUnreadOnDiskOrLostIsSaid) {
  using enum MissingValues::Why;
  robotlink::Session session{robotlink::StreamStore::Limits{.bytes = 10'000}};
  auto made = std::make_unique<MadeUpArchive>();
  made->lost = {{missingTime(3), missingTime(4)}};
  session.history().setArchive(std::move(made));
  for (int i = 0; i < 100; ++i) {
    session.push({"red1/a", missingTime(1 + 0.1 * i), std::make_shared<robotcontrol::PlotValue>()});
    session.tick();
  }
  const double to = robotlink::seconds(session.history().archive()->stretch()->to);
  ASSERT_GT(to, 5);
  EXPECT_THAT(missingValues(session, {"red1/a"}, {to, 11}, std::nullopt),
              ElementsAre(MissingValues{1, to, kTooMany}, MissingValues{3, 4, kLost}));
  EXPECT_THAT(missingValues(session, {"red1/a"}, {1, 11}, std::pair(2.0, to)),
              ElementsAre(MissingValues{2, to, kUnread}, MissingValues{3, 4, kLost}));
  EXPECT_THAT(missingValues(session, {"red1/a"}, {1, 11}, std::nullopt),
              ElementsAre(MissingValues{3, 4, kLost}));
  EXPECT_THAT(missingValues(session, {"red1/b"}, {to, 11}, std::nullopt), IsEmpty());
}

TEST(MissingValuesTest, whatOverlapsIsJoined) {
  using enum MissingValues::Why;
  EXPECT_THAT(
      joined({{5, 6, kLost}, {2, 4, kUnread}, {1, 3, kUnread}, {3.5, 4.5, kLost}}),
      ElementsAre(MissingValues{1, 4, kUnread}, MissingValues{3.5, 4.5, kLost}, MissingValues{5, 6, kLost}));
}

}  // namespace
}  // namespace widgets::test
