// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/security/SecretFile.h"

#include <gmock/gmock.h>

#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

namespace robotlink::websocket::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::perms permissionsOf(const fs::path& file) {
  return fs::status(file).permissions();
}

class SecretFileTest : public testing::Test {
 protected:
  const TestFolder folder_;
  const fs::path file_ = folder_ / "secret";
};

TEST_F(SecretFileTest, whatWasCreatedIsReadAndNobodyElseMayDoIt) {
  ASSERT_EQ(createSecret(file_, "abc"), true);
  EXPECT_EQ(permissionsOf(file_), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(readSecret(file_).value(), "abc");
  EXPECT_EQ(folder_.contents(), "secret") << "nothing is left beside it";
}

TEST_F(SecretFileTest, aSecretThatIsThereIsNotCreatedAgain) {
  ASSERT_EQ(createSecret(file_, "first"), true);
  ASSERT_EQ(createSecret(file_, "second"), false);
  EXPECT_EQ(readSecret(file_).value(), "first");
  EXPECT_EQ(folder_.contents(), "secret");
}

TEST_F(SecretFileTest, aSecretIsReplacedAsAWhole) {
  folder_.write("secret", "for everybody");
  fs::permissions(file_, fs::perms::others_read, fs::perm_options::add);
  ASSERT_TRUE(replaceSecret(file_, "for me"));
  EXPECT_EQ(permissionsOf(file_), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(readSecret(file_).value(), "for me");
  ASSERT_TRUE(replaceSecret(file_, ""));
  EXPECT_EQ(readSecret(file_).value(), "");
  EXPECT_EQ(folder_.contents(), "secret");
}

TEST_F(SecretFileTest, missingFoldersAreMadeForTheirOwnerOnlyAndOthersAreLeftAsTheyAre) {
  const fs::perms before = permissionsOf(folder_.path());
  ASSERT_EQ(createSecret(folder_ / "state/robotcontrol/secret", "x"), true);
  EXPECT_EQ(permissionsOf(folder_ / "state/robotcontrol"), fs::perms::owner_all);
  EXPECT_EQ(permissionsOf(folder_.path()), before);
}

TEST_F(SecretFileTest, aSecretThatOthersMayReadIsRefusedWithWhatToDo) {
  for (const fs::perms more : {fs::perms::group_read, fs::perms::others_read, fs::perms::others_write}) {
    ASSERT_TRUE(replaceSecret(file_, "x"));
    fs::permissions(file_, more, fs::perm_options::add);
    const auto refused = readSecret(file_);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().id, "secret.readable");
    EXPECT_THAT(refused.error().describe(),
                testing::AllOf(HasSubstr(file_.string()), HasSubstr("chmod 600")));
  }
}

TEST_F(SecretFileTest, whatCannotBeReadOrWrittenIsNamedWithItsReason) {
  const auto missing = readSecret(file_);
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().describe(),
              testing::AllOf(HasSubstr(file_.string()), HasSubstr("No such file")));
  folder_.write("file", "");
  const auto created = createSecret(folder_ / "file/secret", "x");
  ASSERT_FALSE(created);
  EXPECT_THAT(created.error().describe(), HasSubstr((folder_ / "file/secret").string()));
  EXPECT_FALSE(replaceSecret(folder_ / "file/secret", "x"));
}

TEST_F(SecretFileTest, aFolderIsNoSecret) {
  fs::create_directory(file_);
  EXPECT_FALSE(readSecret(file_));
  EXPECT_FALSE(replaceSecret(file_, "x"));
  EXPECT_EQ(createSecret(file_, "x"), false) << "something is there already";
  EXPECT_EQ(folder_.contents(), "secret");
}

TEST_F(SecretFileTest, aLinkThatLeadsNowhereIsNotFollowed) {
  fs::create_symlink(folder_ / "elsewhere", file_);
  EXPECT_EQ(createSecret(file_, "x"), false);
  ASSERT_TRUE(replaceSecret(file_, "x"));
  EXPECT_FALSE(fs::is_symlink(file_));
  EXPECT_FALSE(fs::exists(folder_ / "elsewhere"));
}

}  // namespace
}  // namespace robotlink::websocket::test
