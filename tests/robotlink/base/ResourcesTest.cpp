// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Resources.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "tests/TestFolder.h"

namespace robotlink {
namespace {

using ::testing::HasSubstr;

/// Sets a variable of the environment for the time of a test.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value.c_str(), 1);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Resources, areThoseOfTheSourceTreeThatTheProgramWasBuiltIn) {
  const Variable none("ROBOTCONTROL_RESOURCES", "");
  EXPECT_TRUE(checkResources());
  EXPECT_EQ(resourceDirectory().filename(), "resources");
  EXPECT_TRUE(std::filesystem::exists(resource("fields/2002.yaml")));
}

TEST(Resources, aVariableNamesOthers) {
  const TestFolder folder;
  folder.write("robots/a.yaml", "");
  folder.write("layouts/a.yaml", "");
  const Variable chosen("ROBOTCONTROL_RESOURCES", folder.path());
  EXPECT_TRUE(checkResources());
  EXPECT_EQ(resource("robots/a.yaml"), folder.path() / "robots/a.yaml");
}

TEST(Resources, aVariableThatNamesAnotherFolderIsReportedWithItsName) {
  const TestFolder folder;
  const Variable chosen("ROBOTCONTROL_RESOURCES", folder.path());
  const auto checked = checkResources();
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().id, "resources.wrong");
  EXPECT_THAT(checked.error().text, HasSubstr(folder.path().string()));
}

TEST(Resources, filesOfTheUserAreWhereTheSystemWantsThem) {
  const Variable home("HOME", "/home/somebody");
  {
    const Variable config("XDG_CONFIG_HOME", "/elsewhere");
    EXPECT_EQ(userDirectory(), "/elsewhere/robotcontrol");
  }
  const Variable config("XDG_CONFIG_HOME", "");
  EXPECT_EQ(userDirectory(), "/home/somebody/.config/robotcontrol");
}

}  // namespace
}  // namespace robotlink
