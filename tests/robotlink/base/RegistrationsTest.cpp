// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Registrations.h"

#include <gmock/gmock.h>

using namespace robotlink;
using testing::ElementsAre;

namespace {

bool wordPrecedes(const std::string& a, const std::string& b) {
  return a < b;
}

/// As programs have them: it exists until the end.
Registry<std::string>& wordRegistry() {
  static Registry<std::string> registry(wordPrecedes);
  return registry;
}

void addWord(const std::string& word, const std::string& problem = {}) {
  wordRegistry().add(word, "word " + word, problem);
}

TEST(RegistrationsTest, entriesAreInTheirOrderAndWhatATrialAddsIsUndoneUnlessKept) {
  addWord("pear");
  addWord("apple");
  EXPECT_THAT(wordRegistry().all(), ElementsAre("apple", "pear"));
  {
    RegistrationTrial trial;
    addWord("fig");
    EXPECT_THAT(wordRegistry().all(), ElementsAre("apple", "fig", "pear"));
  }
  EXPECT_THAT(wordRegistry().all(), ElementsAre("apple", "pear"));
  {
    RegistrationTrial trial;
    addWord("plum");
    trial.keep();
  }
  EXPECT_THAT(wordRegistry().all(), ElementsAre("apple", "pear", "plum"));
}

TEST(RegistrationsTest, aTrialNotesWhatIsRefusedInsteadOfEndingTheProgram) {
  RegistrationTrial trial;
  EXPECT_EQ(RegistrationTrial::problem(), "");
  addWord("kiwi", "there is one already");
  addWord("lime", "it is sour");
  EXPECT_EQ(RegistrationTrial::problem(), "word kiwi: there is one already; word lime: it is sour");
  EXPECT_THAT(wordRegistry().all(), testing::Not(testing::Contains("kiwi")));
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
  EXPECT_DEATH(addWord("kiwi", "there is one already"), "word kiwi: there is one already");
  EXPECT_DEATH(
      {
        Registrations::seal();
        addWord("date");
      },
      "word date: registered after programs were opened");
}

}  // namespace
