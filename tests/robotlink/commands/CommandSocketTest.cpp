// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/CommandSocket.h"

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <optional>

#include "robotlink/commands/LineReader.h"
#include "tests/TestFolder.h"

using namespace robotlink;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

class CommandSocketTest : public testing::Test {
 protected:
  CommandSocketTest() {
    commands_.add({"say", "Notes a text.", {{"text"}}, [this](const auto& values) -> Result<void> {
                     said_.push_back(std::get<std::string>(values[0]));
                     return {};
                   }});
    const auto opened = socket_->open(folder_.path());
    EXPECT_TRUE(opened) << opened.error().describe();
  }
  CommandConnection connected() const {
    auto connection = CommandConnection::connect(folder_.path());
    EXPECT_TRUE(connection) << connection.error().text;
    return std::move(*connection);
  }
  /// Runs a line; returns why it failed.
  std::string run(CommandConnection& connection, const std::string& line) {
    EXPECT_TRUE(connection.send(line));
    for (int i = 0; i < 8; ++i) tick();  // it reads a part of a long line at a time
    const auto done = connection.receive();
    return done ? "" : done.error().text;
  }
  void tick() { socket_->tick(now_); }
  std::filesystem::path file() const {
    return folder_ / ("robotcontrol-" + std::to_string(::getpid()) + ".sock");
  }

  const TestFolder folder_;
  Session session_;
  CommandTable commands_;
  std::vector<std::string> said_;
  std::optional<CommandSocket> socket_{std::in_place, ScriptRun::Workbench{commands_, session_}};
  Instant now_{1s};
};

}  // namespace

TEST_F(CommandSocketTest, filesAreRelativeToTheFolderOfWhoeverSendsTheLine) {
  commands_.add({"open", "Notes a file.", {{"file", CommandTable::Type::kFile}}, [this](const auto& values) {
                   said_.push_back(std::get<std::string>(values[0]));
                   return Result<void>();
                 }});
  auto connection = connected();
  EXPECT_EQ(run(connection, "folder /home/a b"), "");
  EXPECT_EQ(run(connection, "open c.log"), "");
  EXPECT_EQ(run(connection, "open /d.log"), "");
  EXPECT_EQ(run(connection, "open tcp://e"), "");
  EXPECT_THAT(said_, ElementsAre("/home/a b/c.log", "/d.log", "tcp://e"));
}

TEST_F(CommandSocketTest, namesOfWhatIsShippedAreNoFilesUnlessThereAreSome) {
  commands_.add(
      {"open", "Notes a source.", {{"source", CommandTable::Type::kSource}}, [this](const auto& values) {
         said_.push_back(std::get<std::string>(values[0]));
         return Result<void>();
       }});
  auto connection = connected();
  const std::string folder = folder_.path().string();
  folder_.write("field", "");
  run(connection, "folder " + folder);
  for (const char* source : {"house", "house.map", "a/house", "field", "tcp://house"})
    EXPECT_EQ(run(connection, std::string("open ") + source), "");
  EXPECT_THAT(said_, ElementsAre("house", folder + "/house.map", folder + "/a/house", folder + "/field",
                                 "tcp://house"));
}

TEST_F(CommandSocketTest, linesRunOneAfterTheOther) {
  CommandConnection connection = connected();
  EXPECT_EQ(run(connection, "say 'a b'"), "");
  EXPECT_EQ(run(connection, "set x 5"), "");
  EXPECT_EQ(run(connection, "say $x"), "");
  EXPECT_THAT(said_, ElementsAre("a b", "5"));
}

TEST_F(CommandSocketTest, aFailureIsSaidAndTheNextLineRuns) {
  CommandConnection connection = connected();
  EXPECT_EQ(run(connection, "fly"), "there is no command fly");
  EXPECT_EQ(run(connection, "assert 1 > 2"), "expected 1 > 2");
  EXPECT_EQ(run(connection, "say \"a\\\\\\nb"), "the quote at column 5 is not closed");
  EXPECT_EQ(run(connection, "say still"), "");
}

TEST_F(CommandSocketTest, whatIsPrintedComesBeforeTheAnswer) {
  CommandConnection connection = connected();
  std::vector<std::string> printed;
  ASSERT_TRUE(connection.send("print 1 + 1"));
  tick();
  EXPECT_TRUE(connection.receive([&](const std::string& text) { printed.push_back(text); }));
  EXPECT_THAT(printed, ElementsAre("2"));
  EXPECT_EQ(run(connection, "print 3"), "") << "who does not listen loses it";
  EXPECT_EQ(run(connection, "say next"), "");
}

TEST_F(CommandSocketTest, reasonsKeepTheirLines) {
  commands_.add(
      {"fail", "", {}, [](const auto&) -> Result<void> { return failure("test", "one\ntwo \\n three"); }});
  CommandConnection connection = connected();
  EXPECT_EQ(run(connection, "fail"), "one\ntwo \\n three");
}

TEST_F(CommandSocketTest, onlyTheUserMayOpenItAndItGoesWithTheWorkbench) {
  struct stat status {};
  ASSERT_EQ(::stat(file().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  socket_.reset();
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(CommandSocketTest, whoeverClosesTheConnectionCancelsWhatItWaitsFor) {
  {
    CommandConnection connection = connected();
    ASSERT_TRUE(connection.send("wait until 1 > 2 for 1000"));
    ASSERT_TRUE(connection.send("say never"));
    tick();
  }
  CommandConnection other = connected();
  EXPECT_EQ(run(other, "say now"), "");
  now_ += 2000s;
  tick();
  EXPECT_THAT(said_, ElementsAre("now"));
}

TEST_F(CommandSocketTest, aLineThatIsTooLongEndsTheConnection) {
  CommandConnection connection = connected();
  EXPECT_THAT(run(connection, std::string(LineReader::kMaxLine + 1, 'a')), HasSubstr("longer than"));
}

TEST_F(CommandSocketTest, aWorkbenchIsChosenByItsProcess) {
  EXPECT_TRUE(CommandConnection::connect(folder_.path(), ::getpid()));
  const auto other = CommandConnection::connect(folder_.path(), 1);
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().text, HasSubstr("process id 1"));
}

TEST_F(CommandSocketTest, whatAWorkbenchLeftThatWasKilledIsRemoved) {
  socket_.reset();
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, file().c_str());
  const int left = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(left, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(left);
  EXPECT_FALSE(CommandConnection::connect(folder_.path()));
  EXPECT_THAT(folder_.files(), IsEmpty());
}

TEST(LineReader, cutsBytesIntoLines) {
  LineReader reader;
  reader.feed("a\n\nb");
  EXPECT_EQ(reader.next(), "a");
  EXPECT_EQ(reader.next(), "");
  EXPECT_EQ(reader.next(), std::nullopt);
  reader.feed("c\n");
  EXPECT_EQ(reader.next(), "bc");
  reader.feed(std::string(LineReader::kMaxLine, 'x') + "\n");
  EXPECT_EQ(reader.next()->size(), LineReader::kMaxLine);
  reader.feed(std::string(LineReader::kMaxLine + 1, 'x'));
  EXPECT_EQ(reader.next(), std::nullopt);
  EXPECT_TRUE(reader.isTooLong());
  reader.feed("\nd\n");
  EXPECT_EQ(reader.next(), std::nullopt);
}
