// SPDX-License-Identifier: GPL-3.0-or-later
// robotctl sim --arcos as its users start it: a process of its own, in real time.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/arcos/stream/OpenStream.h"

namespace {

using namespace robotlink::arcos;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using testing::HasSubstr;

const std::string kRoom = ROBOTCONTROL_SOURCE_DIR "/resources/scenes/pioneer.sdf";

/// robotctl as a child, with its outputs.
class Robotctl {
 public:
  explicit Robotctl(std::vector<std::string> arguments) {
    int out[2], errors[2];
    if (::pipe(out) != 0 || ::pipe(errors) != 0) throw std::runtime_error("no pipes");
    arguments.insert(arguments.begin(), ROBOTCTL);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(out[1], 1);
      ::dup2(errors[1], 2);
      ::execv(argv[0], argv.data());
      ::_exit(127);
    }
    ::close(out[1]);
    ::close(errors[1]);
    out_ = out[0];
    errors_ = errors[0];
  }
  ~Robotctl() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
    ::close(out_);
    ::close(errors_);
  }
  Robotctl(const Robotctl&) = delete;
  Robotctl& operator=(const Robotctl&) = delete;

  /// The next line on stderr that has this text in it; empty if none comes.
  std::string lineWith(const std::string& text) {
    for (const auto end = Clock::now() + 20s; Clock::now() < end;) {
      if (const auto newline = pending_.find('\n'); newline != std::string::npos) {
        const std::string line = pending_.substr(0, newline);
        pending_.erase(0, newline + 1);
        if (line.find(text) != std::string::npos) return line;
        continue;
      }
      if (!readMore(errors_, pending_)) break;
    }
    return {};
  }
  void interrupt() const { ::kill(process_, SIGINT); }
  /// Waits for its end; its exit status, and what it printed.
  int finish(std::string& printed) {
    while (readMore(out_, printed)) {
    }
    int status = -1;
    ::waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  static bool readMore(int descriptor, std::string& text) {
    pollfd wait{descriptor, POLLIN, 0};
    if (::poll(&wait, 1, 20000) <= 0) return false;
    char bytes[4096];
    const auto count = ::read(descriptor, bytes, sizeof bytes);
    if (count > 0) text.append(bytes, static_cast<std::size_t>(count));
    return count > 0;
  }

  pid_t process_ = 0;
  int out_ = -1, errors_ = -1;
  std::string pending_;
};

std::string urlIn(const std::string& line) {
  return line.substr(line.find("tcp://"));
}

TEST(RobotctlArcos, c3InformationComesAtTenHertzByTheClockAndCtrlCEndsInGoodOrder) {
  Robotctl robotctl({"sim", kRoom, "--arcos", "0", "--json"});
  const std::string line = robotctl.lineWith("p3at1 listens at tcp://127.0.0.1:");
  ASSERT_FALSE(line.empty());
  auto stream = open(urlIn(line));
  ASSERT_TRUE(stream) << stream.error().text;
  const auto start = Clock::now();
  for (const auto id : {CommandId::kSync0, CommandId::kSync1, CommandId::kSync2, CommandId::kOpen}) {
    ASSERT_TRUE((*stream)->write(encode(toPacket(command(id)))));
  }
  PacketParser parser;
  std::vector<Clock::time_point> informed;
  Bytes bytes(4096);
  while (informed.size() < 20 && Clock::now() < start + 30s) {
    const auto count = (*stream)->read(bytes, 50ms);
    ASSERT_TRUE(count);
    parser.push(std::span(bytes).first(*count));
    while (const auto found = parser.next()) {
      const auto* packet = std::get_if<Packet>(&*found);
      if (packet != nullptr && (packet->id & 0xF0) == 0x30) informed.push_back(Clock::now());
    }
  }
  // A busy machine may be late, but time must neither stop nor run away.
  ASSERT_GE(informed.size(), 20U);
  EXPECT_GT(informed[19] - start, 1600ms);
  robotctl.interrupt();
  std::string printed;
  EXPECT_EQ(robotctl.finish(printed), 0);
  const auto figures = nlohmann::json::parse(printed, nullptr, false);
  ASSERT_TRUE(figures.is_object()) << printed;
  EXPECT_EQ(figures["robots"][0]["name"], "p3at1");
  EXPECT_EQ(figures["robots"][0]["clients"], 1);
  EXPECT_EQ(figures["robots"][0]["contacts"], 0);
  EXPECT_GE(figures["robots"][0]["packets_sent"], 15);
}

TEST(RobotctlArcos, itEndsAfterItsSecondsAndWarnsWhenItIsOpenToTheNetwork) {
  Robotctl robotctl({"sim", kRoom, "--arcos", "0", "--bind", "0.0.0.0", "--seconds", "3", "--speed", "0",
                     "--json", "--kinematic"});
  EXPECT_THAT(robotctl.lineWith("Warning"), HasSubstr("0.0.0.0"));
  std::string printed;
  EXPECT_EQ(robotctl.finish(printed), 0);
  const auto figures = nlohmann::json::parse(printed, nullptr, false);
  ASSERT_TRUE(figures.is_object()) << printed;
  EXPECT_NEAR(figures["simulated_seconds"].get<double>(), 3, 0.01);
  EXPECT_EQ(figures["kinematic"], true);
}

TEST(RobotctlArcos, aClientMayEndTheSimulation) {
  Robotctl robotctl({"sim", kRoom, "--arcos", "0", "--seconds", "20"});
  auto stream = open(urlIn(robotctl.lineWith("listens at")));
  ASSERT_TRUE(stream);
  for (const auto id : {CommandId::kSync0, CommandId::kSync1, CommandId::kSync2}) {
    ASSERT_TRUE((*stream)->write(encode(toPacket(command(id)))));
  }
  ASSERT_TRUE((*stream)->write(encode(toPacket(command(CommandId::kSimExit, 0)))));
  std::string printed;
  EXPECT_EQ(robotctl.finish(printed), 0);
  EXPECT_THAT(printed, HasSubstr("touched nothing"));
}

TEST(RobotctlArcos, whatDoesNotGoTogetherIsSaid) {
  Robotctl robotctl({"sim", kRoom, "--arcos", "0", "--record", "x.mcap"});
  EXPECT_THAT(robotctl.lineWith("--arcos"), HasSubstr("omit"));
  std::string printed;
  EXPECT_EQ(robotctl.finish(printed), 2);
}

}  // namespace
