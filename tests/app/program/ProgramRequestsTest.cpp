// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ProgramRequests.h"

#include <gmock/gmock.h>

#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "tests/app/Requests.h"
#include "tests/app/program/FakeProgram.h"

namespace app {
namespace {

using robotcontrol::Request;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Request numbered(std::uint64_t id, Request request) {
  request.set_id(id);
  return request;
}

/// A request for a key, or, as people know it, "key drawings"; "solution scan"; "goal".
std::string nameOfRequest(const Request& request) {
  if (request.has_set_key()) return "key " + request.set_key().name();
  if (request.has_select_solution()) return "solution " + request.select_solution().solution();
  if (request.has_set_goal())
    return "goal " + std::to_string(std::lround(request.set_goal().pose_in_field().x()));
  return robotlink::inWords(request);
}

/// The requests to a program that only notes them.
class ProgramRequestsTest : public testing::Test {
 protected:
  static Request key(std::uint64_t id, const std::string& name) {
    return numbered(id, test::keyRequest("red1", name));
  }
  static Request solution(std::uint64_t id, const std::string& name) {
    return numbered(id, test::selectRequest("red1", "ball-percept", name));
  }
  static Request goal(std::uint64_t id, double x) {
    Request request;
    request.set_id(id);
    request.mutable_set_goal()->mutable_pose_in_field()->set_x(x);
    return request;
  }
  static Request cancelGoal(std::uint64_t id) {
    Request request;
    request.set_id(id);
    request.mutable_set_goal()->set_cancelled(true);
    return request;
  }
  /// The names of the requests that are handed over now, at most so many.
  std::vector<std::string> handed(std::size_t limit = 1000) {
    std::vector<std::string> names;
    requests_.hand([&](const Request& request) {
      if (names.size() == limit) return false;
      names.push_back(nameOfRequest(request));
      return true;
    });
    return names;
  }
  /// The same without the request for tables, which ends the overrides.
  std::vector<std::string> handedChoices() {
    auto names = handed();
    std::erase(names, "send tables of red1");
    return names;
  }
  void answer(std::uint64_t id, bool accepted) {
    robotlink::SharedDebugQueue queue;
    auto& result = queue.add<robotcontrol::RequestResult>("results");
    result.set_id(id);
    result.set_accepted(accepted);
    requests_.answered(queue);
  }
  /// The user asks, the program gets the request and accepts it.
  void choose(const Request& request) {
    ASSERT_TRUE(requests_.ask(request));
    handed();
    answer(request.id(), true);
  }

  robotlink::ManualClock clock_;
  test::FakeProgram program_{clock_}, next_{clock_};
  std::vector<std::string> overridden_;
  ProgramRequests requests_{
      "red1", {}, [this](const Request& request) { overridden_.push_back(nameOfRequest(request)); }};
};

TEST_F(ProgramRequestsTest, whatTheProgramDoesNotTakeWaitsInItsOrder) {
  for (std::uint64_t id = 1; id <= 3; ++id) ASSERT_TRUE(requests_.ask(key(id, std::to_string(id))));
  EXPECT_THAT(handed(1), ElementsAre("key 1"));
  EXPECT_THAT(handed(0), IsEmpty());
  EXPECT_THAT(handed(), ElementsAre("key 2", "key 3"));
  EXPECT_THAT(handed(), IsEmpty()) << "each only once";
}

TEST_F(ProgramRequestsTest, onlyWhatWasAcceptedBecomesAnOverride) {
  ASSERT_TRUE(requests_.ask(key(1, "kept")));
  ASSERT_TRUE(requests_.ask(key(2, "refused")));
  handed();
  answer(7, true);
  EXPECT_THAT(overridden_, IsEmpty()) << "an answer to somebody else";
  answer(2, false);
  answer(1, true);
  answer(1, true);
  EXPECT_THAT(overridden_, ElementsAre("key kept"));
  EXPECT_TRUE(requests_.overrides().keys().contains("kept"));
  EXPECT_FALSE(requests_.overrides().keys().contains("refused"));
}

TEST_F(ProgramRequestsTest, whatHasNoNumberCountsWhenItIsHandedOver) {
  ASSERT_TRUE(requests_.ask(key(0, "drawings")));
  EXPECT_THAT(overridden_, IsEmpty());
  handed();
  EXPECT_THAT(overridden_, ElementsAre("key drawings"));
  requests_.beginOverridden();
  EXPECT_THAT(handed(), IsEmpty()) << "no answer will come for which it would wait";
}

TEST_F(ProgramRequestsTest, aProgramStartsWithTheOverridesAndThenWithWhatIsOpen) {
  choose(solution(1, "scan"));
  choose(key(2, "drawings"));
  ASSERT_TRUE(requests_.ask(key(3, "open")));
  handed();
  EXPECT_THAT(requests_.begin(next_), IsEmpty());
  std::vector<bool> areRepeated;
  std::vector<std::string> names;
  requests_.hand([&](const Request& request) {
    names.push_back(nameOfRequest(request));
    areRepeated.push_back(robotlink::isRepeated(request));
    return true;
  });
  EXPECT_THAT(names, ElementsAre("key drawings", "solution scan", "send tables of red1", "key open"));
  EXPECT_THAT(areRepeated, ElementsAre(true, true, true, false));
}

TEST_F(ProgramRequestsTest, answersToWhatIsRepeatedOverrideNothingAgain) {
  choose(key(1, "drawings"));
  overridden_.clear();
  requests_.begin(next_);
  std::vector<std::uint64_t> ids;
  requests_.hand([&](const Request& request) {
    ids.push_back(request.id());
    return true;
  });
  for (const std::uint64_t id : ids) answer(id, true);
  EXPECT_THAT(overridden_, IsEmpty());
}

TEST_F(ProgramRequestsTest, whatTheNextProgramLacksIsSaidOnlyIfSomebodyMissesIt) {
  choose(solution(1, "scan"));
  choose(key(2, "drawings"));
  next_.unknown = {"scan", "drawings"};
  EXPECT_THAT(requests_.begin(next_),
              ElementsAre("red1 could not keep solution scan of task ball-percept: there is no scan"));
  EXPECT_THAT(handedChoices(), IsEmpty());
  EXPECT_EQ(requests_.overrides().solutions().at("ball-percept"), "scan") << "for a program that has it";
}

TEST_F(ProgramRequestsTest, aGoalGoesOnUntilItIsTakenBack) {
  choose(goal(1, 2));
  choose(goal(2, 5));
  EXPECT_THAT(overridden_, IsEmpty()) << "it does not hold for later robots";
  requests_.begin(next_);
  EXPECT_THAT(handedChoices(), ElementsAre("goal 5"));
  EXPECT_FALSE(requests_.takeBack(goal(3, 7))) << "another goal takes nothing back";
  EXPECT_TRUE(requests_.takeBack(cancelGoal(4)));
  EXPECT_FALSE(requests_.takeBack(cancelGoal(4)));
  requests_.begin(next_);
  EXPECT_THAT(handedChoices(), IsEmpty());
}

TEST_F(ProgramRequestsTest, aGoalThatWasCanceledByTheProgramIsOver) {
  choose(goal(1, 2));
  choose(cancelGoal(2));
  requests_.begin(next_);
  EXPECT_THAT(handedChoices(), IsEmpty());
}

TEST_F(ProgramRequestsTest, aRobotAtItsStartHasItsChoicesButNoGoal) {
  choose(goal(1, 2));
  choose(key(2, "drawings"));
  requests_.startOver();
  requests_.begin(next_);
  EXPECT_THAT(handedChoices(), ElementsAre("key drawings"));
}

TEST_F(ProgramRequestsTest, otherChoicesReplaceAllThatWasChosenAndAsked) {
  choose(goal(1, 2));
  choose(key(2, "drawings"));
  ASSERT_TRUE(requests_.ask(key(3, "open")));
  ProgramOverrides others;
  others.note(key(0, "other"));
  requests_.startOverWith(others);
  requests_.begin(next_);
  EXPECT_THAT(handedChoices(), ElementsAre("key other"));
}

TEST_F(ProgramRequestsTest, whatTheUserChoseWinsAgainstFilesUnlessTheyAreNew) {
  choose(solution(1, "scan"));
  requests_.choose({solution(0, "disc"), key(0, "drawings")});
  EXPECT_EQ(requests_.overrides().solutions().at("ball-percept"), "scan");
  EXPECT_TRUE(requests_.overrides().keys().contains("drawings"));
  requests_.replaceChoices({solution(0, "disc")});
  EXPECT_EQ(requests_.overrides().solutions().at("ball-percept"), "disc");
}

TEST_F(ProgramRequestsTest, aProgramThatWasMadeWithTheOverridesIsAskedOnlyWhatIsOpen) {
  choose(key(1, "drawings"));
  ASSERT_TRUE(requests_.ask(key(2, "open")));
  EXPECT_THAT(handed(), ElementsAre("key open"));
  requests_.beginOverridden();
  EXPECT_THAT(handed(), ElementsAre("key open"));
}

TEST_F(ProgramRequestsTest, aThousandMayWait) {
  for (std::uint64_t id = 1; id <= 1000; ++id) ASSERT_TRUE(requests_.ask(key(id, std::to_string(id))));
  EXPECT_FALSE(requests_.ask(key(1001, "more")));
  handed();
  EXPECT_FALSE(requests_.ask(key(1001, "more"))) << "they have no answer yet";
  answer(1, false);
  EXPECT_TRUE(requests_.ask(key(1001, "more")));
}

TEST_F(ProgramRequestsTest, inAPauseASliderLeavesOneRequest) {
  ASSERT_TRUE(requests_.ask(solution(1, "scan")));
  requests_.answersToCome(program_, {});
  EXPECT_THAT(overridden_, ElementsAre("solution scan")) << "the answer is known";
  ASSERT_TRUE(requests_.ask(solution(2, "disc")));
  requests_.answersToCome(program_, {});
  EXPECT_THAT(overridden_, ElementsAre("solution scan", "solution disc"));
  ASSERT_TRUE(requests_.ask(key(3, "drawings")));
  EXPECT_THAT(handed(), ElementsAre("solution disc", "key drawings"));
  answer(2, true);
  EXPECT_EQ(overridden_.size(), 2U) << "it was noted in the pause";
}

TEST_F(ProgramRequestsTest, whatWasNotAnsweredInAPauseIsReplacedByNothing) {
  ASSERT_TRUE(requests_.ask(solution(1, "scan")));
  ASSERT_TRUE(requests_.ask(solution(2, "disc")));
  EXPECT_THAT(handed(), ElementsAre("solution scan", "solution disc"));
}

TEST_F(ProgramRequestsTest, whatWillBeRefusedInAPauseIsNotAskedOfTheNextProgram) {
  program_.unknown = {"scan"};
  ASSERT_TRUE(requests_.ask(solution(1, "scan")));
  requests_.answersToCome(program_, {});
  EXPECT_THAT(overridden_, IsEmpty());
  requests_.begin(next_);
  EXPECT_THAT(handedChoices(), IsEmpty()) << "the user knows already";
}

}  // namespace
}  // namespace app
