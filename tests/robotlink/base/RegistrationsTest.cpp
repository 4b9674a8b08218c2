// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Registrations.h"

#include <gmock/gmock.h>

using namespace robotlink;
using testing::ElementsAre;

namespace {

bool isBefore(const std::string& a, const std::string& b) {
  return a < b;
}

/// As programs have them: it exists until the end.
Registry<std::string>& words() {
  static Registry<std::string> registry(isBefore);
  return registry;
}

void add(const std::string& word, const std::string& problem = {}) {
  words().add(word, "word " + word, problem);
}

TEST(RegistrationsTest, entriesAreInTheirOrderAndWhatATrialAddsIsUndoneUnlessKept) {
  add("pear");
  add("apple");
  EXPECT_THAT(words().all(), ElementsAre("apple", "pear"));
  {
    RegistrationTrial trial;
    add("fig");
    EXPECT_THAT(words().all(), ElementsAre("apple", "fig", "pear"));
  }
  EXPECT_THAT(words().all(), ElementsAre("apple", "pear"));
  {
    RegistrationTrial trial;
    add("plum");
    trial.keep();
  }
  EXPECT_THAT(words().all(), ElementsAre("apple", "pear", "plum"));
}

TEST(RegistrationsTest, aTrialNotesWhatIsRefusedInsteadOfEndingTheProgram) {
  RegistrationTrial trial;
  EXPECT_EQ(RegistrationTrial::problem(), "");
  add("kiwi", "there is one already");
  add("lime", "it is sour");
  EXPECT_EQ(RegistrationTrial::problem(), "word kiwi: there is one already; word lime: it is sour");
  EXPECT_THAT(words().all(), testing::Not(testing::Contains("kiwi")));
}

TEST(RegistrationsTest, aRegistryThatBeginsInATrialIsEmptyAfterIt) {
  static Registry<int>* late = nullptr;
  {
    RegistrationTrial trial;
    static Registry<int> registry;
    late = &registry;
    late->add(1, "one", {});
    EXPECT_THAT(late->all(), ElementsAre(1));
  }
  EXPECT_THAT(late->all(), ElementsAre());
}

TEST(RegistrationsDeathTest, outsideOfATrialWhatIsRefusedEndsTheProgram) {
  EXPECT_DEATH(add("kiwi", "there is one already"), "word kiwi: there is one already");
  EXPECT_DEATH(
      {
        Registrations::seal();
        add("date");
      },
      "word date: registered after programs were opened");
}

}  // namespace
