// SPDX-License-Identifier: GPL-3.0-or-later
// robotctl sim --arcos while clients of ten robots send without limit, by the clock.
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <mutex>
#include <thread>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/arcos/stream/OpenStream.h"
#include "tests/Eventually.h"

namespace {

using namespace robotlink::arcos;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int kFlooders = 10;
const std::string kMap = ROBOTCONTROL_SOURCE_DIR "/resources/scenes/house.map";

/// The simulation as a child process; what it writes on stderr is read to the end.
class Simulator {
 public:
  Simulator() {
    int errors[2];
    if (::pipe(errors) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      ::dup2(errors[1], 1);
      ::dup2(errors[1], 2);
      const std::string robots = std::to_string(kFlooders + 1);
      ::execl(ROBOTCTL, ROBOTCTL, "sim", kMap.c_str(), "--robots", robots.c_str(), "--arcos", "0", nullptr);
      ::_exit(127);
    }
    ::close(errors[1]);
    reader_ = std::thread([this, descriptor = errors[0]] { read(descriptor); });
    eventually([this] { return urls().size() > kFlooders; });
  }
  ~Simulator() { interrupt(); }
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  std::vector<std::string> urls() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> found;
    for (std::size_t at = 0; (at = text_.find("tcp://", at)) != std::string::npos;) {
      const auto end = text_.find('\n', at);
      if (end == std::string::npos) break;
      found.push_back(text_.substr(at, end - at));
      at = end;
    }
    return found;
  }
  std::size_t written() const {
    const std::lock_guard lock(mutex_);
    return text_.size();
  }
  /// Ctrl-C; how long it took to end.
  std::chrono::duration<double> interrupt() {
    const auto begin = Clock::now();
    if (process_ > 0) {
      ::kill(process_, SIGINT);
      ::waitpid(process_, nullptr, 0);
      process_ = 0;
      reader_.join();
    }
    return Clock::now() - begin;
  }

 private:
  void read(int descriptor) {
    char bytes[4096];
    for (ssize_t count = 0; (count = ::read(descriptor, bytes, sizeof bytes)) > 0;) {
      const std::lock_guard lock(mutex_);
      text_.append(bytes, static_cast<std::size_t>(count));
    }
    ::close(descriptor);
  }
  pid_t process_ = 0;
  std::thread reader_;
  mutable std::mutex mutex_;  // protects the following
  std::string text_;
};

void handshake(ByteStream& stream) {
  for (const auto id : {CommandId::kSync0, CommandId::kSync1, CommandId::kSync2, CommandId::kOpen}) {
    if (!stream.write(encode(toPacket(command(id))))) return;
  }
}

/// A client that sends one kind of bytes as fast as it can, and reads nothing.
Bytes floodOf(int kind) {
  Bytes flood;
  while (flood.size() < 60'000) {
    switch (kind % 5) {
      case 0:
        flood.push_back(static_cast<std::uint8_t>(flood.size() * 37));
        break;
      case 1:
        append(toPacket(command(CommandId::kConfig)), flood);
        break;
      case 2:
        append(toPacket(command(CommandId::kSimMessage, "all work and no play makes a dull robot")), flood);
        break;
      case 3:
        append({224, {0x2B, 0xFF, 0xFF, 0xFF, 0x7F, 0, 0, 0, 0, 0, 0, 0, 0}}, flood);
        break;
      default:
        flood.insert(flood.end(), {0xFA, 0xFB, 0x20});
    }
  }
  return flood;
}

struct Regularity {
  double rate = 0;        ///< Hz, of information packets
  double longestGap = 0;  ///< s
};

Regularity observe(ByteStream& stream, std::chrono::seconds time) {
  PacketParser parser;
  std::vector<Clock::time_point> informed;
  Bytes bytes(4096);
  auto pulsed = Clock::now();
  for (const auto end = Clock::now() + time; Clock::now() < end;) {
    if (Clock::now() - pulsed > 500ms) {
      pulsed = Clock::now();
      if (!stream.write(encode(toPacket(command(CommandId::kPulse))))) break;
    }
    const auto count = stream.read(bytes, 50ms);
    if (!count) break;
    parser.push(std::span(bytes).first(*count));
    while (const auto found = parser.next()) {
      const auto* packet = std::get_if<Packet>(&*found);
      if (packet != nullptr && (packet->id & 0xF0) == 0x30) informed.push_back(Clock::now());
    }
  }
  Regularity regularity;
  if (informed.size() < 2) return regularity;
  const std::chrono::duration<double> span = informed.back() - informed.front();
  regularity.rate = static_cast<double>(informed.size() - 1) / span.count();
  for (std::size_t i = 1; i < informed.size(); ++i) {
    const std::chrono::duration<double> gap = informed[i] - informed[i - 1];
    regularity.longestGap = std::max(regularity.longestGap, gap.count());
  }
  return regularity;
}

bool isRegular(const Regularity& regularity) {
  return std::abs(regularity.rate - 10) <= 0.1 && regularity.longestGap < 0.25;
}

TEST(ArcosFlood, anotherRobotsInformationStaysRegularAndCtrlCIsAnswered) {
  Simulator simulator;
  const auto urls = simulator.urls();
  ASSERT_EQ(urls.size(), kFlooders + 1U);
  auto client = open(urls.back());
  ASSERT_TRUE(client) << client.error().text;
  handshake(**client);
  observe(**client, 1s);
  // What this machine can do besides whatever else it does.
  const Regularity before = observe(**client, 10s);

  std::atomic<bool> end{false};
  std::vector<std::thread> flooders;
  for (int i = 0; i < kFlooders; ++i) {
    flooders.emplace_back([&end, i, url = urls[static_cast<std::size_t>(i)]] {
      auto stream = open(url);
      if (!stream) return;
      handshake(**stream);
      const Bytes flood = floodOf(i);
      while (!end && (*stream)->write(flood)) {
      }
    });
  }
  const Regularity during = observe(**client, 10s);
  const std::size_t written = simulator.written();
  const auto ending = simulator.interrupt();
  end = true;
  for (auto& flooder : flooders) flooder.join();

  std::printf(
      "alone %.2f Hz, longest gap %.0f ms; with %d floods %.2f Hz, %.0f ms; Ctrl-C %.0f ms; %zu bytes of "
      "text\n",
      before.rate, before.longestGap * 1000, kFlooders, during.rate, during.longestGap * 1000,
      ending.count() * 1000, written);
  EXPECT_LT(written, 100'000U) << "texts are limited";
  if (!isRegular(before)) GTEST_SKIP() << "this machine is too busy to tell, even without floods";
  EXPECT_NEAR(during.rate, 10, 0.1);
  EXPECT_LT(during.longestGap, 0.25);
  EXPECT_LT(ending.count(), 0.5);
}

}  // namespace
