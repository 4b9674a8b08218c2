// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates, tokens and known servers in files.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <thread>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/foxglove/security/Certificate.h"
#include "robotlink/foxglove/security/KnownServers.h"
#include "robotlink/foxglove/security/RememberedTokens.h"
#include "robotlink/foxglove/security/SecretFile.h"
#include "robotlink/foxglove/security/Tokens.h"
#include "tests/TestFolder.h"

namespace robotlink::websocket::test {
namespace {

using testing::HasSubstr;

unsigned modeOf(const std::filesystem::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0 ? status.st_mode & 0777U : 0;
}

TEST(Certificate, isMadeOnceAndReadForItsOwnerOnly) {
  const TestFolder folder;
  const auto file = folder.path() / "state/certificate.pem";
  const auto made = loadOrMakeCertificate(file), again = loadOrMakeCertificate(file);
  ASSERT_TRUE(made && again);
  EXPECT_THAT(made->fingerprint, testing::MatchesRegex("SHA256:[A-Za-z0-9+/]{43}"));
  EXPECT_EQ(made->fingerprint, again->fingerprint);
  EXPECT_EQ(modeOf(file), 0600U);
  EXPECT_EQ(modeOf(file.parent_path()), 0700U);
  ::chmod(file.c_str(), 0640);
  EXPECT_THAT(loadOrMakeCertificate(file).error().text, HasSubstr("other users"));
}

TEST(Certificate, ofTwoProgramsThatMakeOneAtTheSameTimeBothHaveTheSame) {
  const TestFolder folder;
  const auto file = folder.path() / "certificate.pem";
  std::string seen[4];
  std::vector<std::thread> programs;
  for (std::string& fingerprint : seen)
    programs.emplace_back([&] { fingerprint = loadOrMakeCertificate(file).value().fingerprint; });
  for (std::thread& program : programs) program.join();
  for (const std::string& fingerprint : seen) EXPECT_EQ(fingerprint, seen[0]);
}

TEST(Certificate, aDamagedFileIsNamedWithWhatToDo) {
  const Certificate one = makeCertificate("a").value(),
                    other = makeCertificate(std::string(500, 'b')).value();
  EXPECT_NE(one.fingerprint, other.fingerprint);
  // The key of one, the certificate of the other.
  const std::string mixed = one.pem.substr(0, one.pem.find("-----BEGIN CERT")) +
                            other.pem.substr(other.pem.find("-----BEGIN CERT"));
  for (const std::string& text : {std::string("nonsense"), mixed, std::string()}) {
    const auto parsed = parseCertificate(text, "c.pem");
    ASSERT_FALSE(parsed);
    EXPECT_THAT(parsed.error().describe(), testing::AllOf(HasSubstr("c.pem"), HasSubstr("remove the file")));
  }
  EXPECT_EQ(parseCertificate(one.pem, "").value().fingerprint, one.fingerprint);
}

TEST(Tokens, areMadeOnce) {
  const TestFolder folder;
  const auto file = folder.path() / "tokens";
  const auto made = loadOrMakeTokens(file), again = loadOrMakeTokens(file);
  ASSERT_TRUE(made && again);
  EXPECT_TRUE(made->isNew);
  EXPECT_FALSE(again->isNew);
  EXPECT_EQ(made->tokens, again->tokens);
  EXPECT_EQ(made->tokens.control.size(), 32U);
  EXPECT_NE(made->tokens.control, made->tokens.watch);
  EXPECT_EQ(modeOf(file), 0600U);
}

TEST(Tokens, mistakesAreNamedWithTheirLine) {
  const auto problem = [](const std::string& lines) {
    const auto parsed = parseTokens("robotcontrol-tokens 1\n" + lines, "t");
    return parsed ? "none" : parsed.error().describe();
  };
  EXPECT_EQ(problem("# my own\n\n control  abcdefghijklmnop\t\r\n"), "none");
  EXPECT_EQ(problem("watch abcdefghijklmnop"), "none");
  EXPECT_THAT(problem("control short"), HasSubstr("t:2"));
  EXPECT_THAT(problem("control abcdefghijklmnop q"), HasSubstr("letters"));
  EXPECT_THAT(problem("control"), HasSubstr("characters"));
  EXPECT_THAT(problem("root abcdefghijklmnop"), HasSubstr("'control TOKEN'"));
  EXPECT_THAT(problem("watch abcdefghijklmnop\nwatch abcdefghijklmnoq"), HasSubstr("t:3"));
  EXPECT_THAT(problem("watch abcdefghijklmnop\ncontrol abcdefghijklmnop"), HasSubstr("the same"));
  EXPECT_THAT(problem(""), HasSubstr("no token"));
  EXPECT_THAT(parseTokens("abcdefghijklmnop", "t").error().text, HasSubstr("first line"));
  const Tokens tokens{"abcdefghijklmnop", "0123456789abcdef"};
  EXPECT_EQ(parseTokens(toText(tokens), "t"), tokens);
}

TEST(KnownServers, aServerIsNewThenKnownAndAChangeIsAnError) {
  const TestFolder folder;
  const KnownServers known(folder.path() / "a/known_robots");
  EXPECT_EQ(known.isKnown("red1:8765", "SHA256:abc"), false);
  ASSERT_TRUE(known.add("red1:8765", "SHA256:abc"));
  ASSERT_TRUE(known.add("[::1]:1", "SHA256:def"));
  EXPECT_EQ(known.isKnown("red1:8765", "SHA256:abc"), true);
  EXPECT_EQ(known.isKnown("red1:8766", "SHA256:abc"), false);
  const auto changed = known.isKnown("red1:8765", "SHA256:xyz");
  ASSERT_FALSE(changed);
  EXPECT_THAT(changed.error().text, testing::AllOf(HasSubstr("SHA256:abc"), HasSubstr("SHA256:xyz"),
                                                   HasSubstr("known_robots"), HasSubstr("remove its line")));
  ASSERT_TRUE(known.add("red1:8765", "SHA256:xyz"));
  EXPECT_EQ(known.isKnown("red1:8765", "SHA256:xyz"), true);
  EXPECT_EQ(known.isKnown("[::1]:1", "SHA256:def"), true);
}

TEST(KnownServers, damagedLinesAreIgnoredAndAnotherFileIsNotOverwritten) {
  const auto known = KnownServers::parse(
      "robotcontrol-known-robots 1\n#x\nred1:1 SHA256:a\nred2:1\nred3:1 md5\n SHA256:b\nred4:1 SHA256:c",
      "k");
  ASSERT_TRUE(known);
  EXPECT_EQ(known->size(), 2U);
  EXPECT_TRUE(known->contains("red4:1"));
  const TestFolder folder;
  const auto file = folder.path() / "f";
  ASSERT_TRUE(writeFileAtomically(file, "something else\n"));
  EXPECT_THAT(KnownServers(file).isKnown("a:1", "SHA256:b").error().text, HasSubstr("first line"));
  EXPECT_FALSE(KnownServers(file).add("a:1", "SHA256:b"));
  EXPECT_EQ(readFile(file), "something else\n");
}

TEST(RememberedTokens, areKeptByUrlForTheirOwnerOnlyAndForgotten) {
  const TestFolder folder;
  const auto file = folder.path() / "state/robot_tokens";
  const RememberedTokens tokens(file);
  EXPECT_FALSE(tokens.find("wss://red1:8765"));
  ASSERT_TRUE(tokens.add("wss://red1:8765", "one"));
  ASSERT_TRUE(tokens.add("wss://red2:8765", "two"));
  ASSERT_TRUE(tokens.add("wss://red1:8765", "three"));
  EXPECT_EQ(modeOf(file), 0600U);
  EXPECT_EQ(tokens.find("wss://red1:8765"), "three");
  // What is for an encrypted line is not shown on one that is not.
  EXPECT_FALSE(tokens.find("ws://red1:8765"));
  ASSERT_TRUE(tokens.forget("wss://red1:8765"));
  EXPECT_FALSE(tokens.find("wss://red1:8765"));
  EXPECT_EQ(tokens.find("wss://red2:8765"), "two");
  EXPECT_EQ(modeOf(file), 0600U);
  EXPECT_FALSE(tokens.add("wss://red3:8765", "with blank"));
  ::chmod(file.c_str(), 0640);
  EXPECT_FALSE(tokens.find("wss://red2:8765"));
  EXPECT_THAT(tokens.add("wss://red3:8765", "four").error().text, HasSubstr("other users"));
}

TEST(RememberedTokens, damagedLinesAreIgnoredAndOtherFilesAreNotTouched) {
  const auto tokens = RememberedTokens::parse(
      "robotcontrol-robot-tokens 1\n# a comment\n\nws://a:1\nws://b:2 two three\nws://c:3 good\n", "f");
  ASSERT_TRUE(tokens);
  EXPECT_EQ(*tokens, (RememberedTokens::ByUrl{{"ws://c:3", "good"}}));
  EXPECT_EQ(RememberedTokens::parse("mine", "f").error().where.line, 1);
}

}  // namespace
}  // namespace robotlink::websocket::test
