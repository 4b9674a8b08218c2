// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/snapshots/RunJournal.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/app/Requests.h"

namespace app {
namespace {

using robotcontrol::Request;
using testing::IsEmpty;
using Bytes = std::vector<std::uint8_t>;

constexpr char kSettings[] = "noise: on\nkick-offs: off\n";

RunJournal journalOfTwo() {
  RunJournal journal;
  journal.begin(7, kSettings, {test::keyRequest("red1", "drawings")});
  Request place;
  place.set_id(9);
  place.mutable_place_model()->set_model("ball");
  journal.add(0, place);
  journal.add(125, test::selectRequest("blue2", "ball-model", "kalman"));
  return journal;
}

std::vector<std::string> textsOf(const RunJournal& journal) {
  std::vector<std::string> texts;
  for (const auto& entry : journal.entries())
    texts.push_back(std::to_string(entry.step) + ": " + entry.request.ShortDebugString());
  return texts;
}

void expectDamaged(const Bytes& bytes, const std::string& what) {
  const auto read = RunJournal::decode(bytes);
  ASSERT_FALSE(read) << what;
  EXPECT_EQ(read.error().id, "snapshot.damaged") << what;
}

TEST(RunJournal, allThatDecidesARunComesBackFromItsBytes) {
  const RunJournal journal = journalOfTwo();
  const auto read = RunJournal::decode(journal.encode());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->seed(), 7U);
  EXPECT_EQ(read->settings(), kSettings);
  EXPECT_EQ(read->spoiled(), "");
  ASSERT_EQ(read->overrides().size(), 1U);
  EXPECT_EQ(read->overrides().front().set_key().name(), "drawings");
  EXPECT_EQ(textsOf(*read), textsOf(journal));
  EXPECT_EQ(read->entries().front().request.id(), 9U) << "with its number of then";
}

TEST(RunJournal, oneThatHasNotBegunCanBeRead) {
  const auto read = RunJournal::decode(RunJournal().encode());
  ASSERT_TRUE(read);
  EXPECT_THAT(read->entries(), IsEmpty());
  EXPECT_THAT(read->overrides(), IsEmpty());
}

TEST(RunJournal, theFirstReasonWhyARunCannotBeRepeatedStays) {
  RunJournal journal = journalOfTwo();
  journal.spoil("the layout was changed at 2.4 s");
  journal.spoil("the world was rewound");
  journal.add(200, test::keyRequest("red1", "more"));
  EXPECT_EQ(journal.spoiled(), "the layout was changed at 2.4 s");
  EXPECT_THAT(journal.entries(), IsEmpty());
  const auto read = RunJournal::decode(journal.encode());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->spoiled(), "the layout was changed at 2.4 s");
}

TEST(RunJournal, aNewRunKnowsNothingOfTheOneBefore) {
  RunJournal journal = journalOfTwo();
  journal.spoil("the world was rewound");
  journal.begin(8, "noise: off\n", {});
  EXPECT_EQ(journal.seed(), 8U);
  EXPECT_EQ(journal.spoiled(), "");
  EXPECT_THAT(journal.overrides(), IsEmpty());
  journal.add(1, test::keyRequest("red1", "drawings"));
  EXPECT_EQ(journal.entries().size(), 1U);
}

TEST(RunJournal, moreThanIsKeptSpoilsIt) {
  Request large = test::tableRequest();
  large.mutable_set_color_table()->mutable_table()->set_cells(std::string(RunJournal::kMaxBytes / 3, '\1'));
  RunJournal journal;
  journal.begin(1, {}, {});
  journal.add(1, large);
  journal.add(2, large);
  EXPECT_EQ(journal.spoiled(), "");
  EXPECT_EQ(journal.entries().size(), 2U);
  journal.add(3, large);
  EXPECT_EQ(journal.spoiled(), "there were more requests than are kept");
  EXPECT_THAT(journal.entries(), IsEmpty());
  journal.begin(1, {}, {});
  journal.add(1, large);
  EXPECT_EQ(journal.spoiled(), "") << "what an earlier run was asked does not count";
}

TEST(RunJournal, aPartOfItIsNone) {
  const Bytes whole = journalOfTwo().encode();
  for (std::size_t size = 0; size < whole.size(); ++size)
    expectDamaged({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}, std::to_string(size));
}

TEST(RunJournal, moreThanItIsNoneEither) {
  Bytes bytes = journalOfTwo().encode();
  bytes.push_back(0);
  expectDamaged(bytes, "a byte too many");
}

TEST(RunJournal, requestsThatAreNoneAreFound) {
  Bytes bytes = journalOfTwo().encode();
  const std::string request = journalOfTwo().entries().back().request.SerializeAsString();
  const auto at = std::search(bytes.begin(), bytes.end(), request.begin(), request.end(),
                              [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); });
  ASSERT_NE(at, bytes.end());
  *at = 0x0F;  // A field of a kind that there is not.
  expectDamaged(bytes, "the last request");
}

TEST(RunJournal, aCountThatPromisesMoreThanThereIsIsNotBelieved) {
  Bytes bytes = RunJournal().encode();
  // The seed, two empty texts, and the number of overrides.
  const std::size_t count = 8 + 4 + 4;
  std::fill_n(bytes.begin() + count, 4, std::uint8_t{0xFF});
  expectDamaged(bytes, "four billion overrides");
}

TEST(RunJournal, whatWasAskedInNoOrderIsNotRepeated) {
  RunJournal journal;
  journal.begin(1, {}, {});
  journal.add(5, test::keyRequest("red1", "later"));
  journal.add(4, test::keyRequest("red1", "sooner"));
  expectDamaged(journal.encode(), "steps go back");
}

}  // namespace
}  // namespace app
