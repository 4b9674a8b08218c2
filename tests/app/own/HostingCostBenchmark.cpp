// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs where the program of a robot with a camera runs, and that others watch it: the CPU time of
// `robotctl sim`, with all of its processes and its start. What is compared is measured in turn, in one run,
// so that what else the machine does hits all alike.
//
// programOfARobot: as the program runs inside, in a process of its own, and inside a simulation that is
// offered while nobody is connected, as fast as possible; medians of quotients to the first. "own_ratio" is
// to be at most 1.5, "listen_ratio" near 1.
//
// watchersOfARobot: in real time, while nobody is connected, and while somebody subscribes to all streams,
// which switches all debug keys on; medians of shares of a core, without the start: what a game costs more
// that is longer by "seconds". "all_streams" is what the latter costs beyond the former, and is to be at most
// 0.1; "streams" and "kB_per_s" say how much that is.
#include <arpa/inet.h>
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robotlink/foxglove/client/Connector.h"

namespace {

namespace websocket = robotlink::websocket;

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The CPU time of all that has ended below this process, s.
double cpuSeconds() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
}

/// The CPU time of a game of so many simulated seconds, s; nothing if it fails.
std::optional<double> costOf(std::int64_t seconds, const std::string& options) {
  const std::string line =
      std::string(ROBOTCTL " sim " ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf ") + options +
      " --seconds " + std::to_string(seconds) + " >/dev/null 2>&1";
  const double before = cpuSeconds();
  if (std::system(line.c_str()) != 0) return std::nullopt;
  return cpuSeconds() - before;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void programOfARobot(benchmark::State& state) {
  const std::int64_t seconds = state.range(0);
  std::vector<double> inside, own, served;
  for (auto unused : state) {
    static_cast<void>(unused);
    const auto base = costOf(seconds, "--speed 0");
    const auto inItsProcess = costOf(seconds, "--speed 0 --own-process all");
    const auto offered = costOf(seconds, "--speed 0 --listen 127.0.0.1:0");
    if (!base || !inItsProcess || !offered) {
      state.SkipWithError("a game failed; run robotctl sim to see why");
      return;
    }
    inside.push_back(*base);
    own.push_back(*inItsProcess / *base);
    served.push_back(*offered / *base);
    state.SetIterationTime(*base);
  }
  state.counters["cpu_per_simulated"] = median(inside) / static_cast<double>(seconds);
  state.counters["own_ratio"] = median(own);
  state.counters["listen_ratio"] = median(served);
}
BENCHMARK(programOfARobot)
    ->ArgName("seconds")
    ->Arg(20)
    ->Iterations(5)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// A port at which nobody listens now.
std::uint16_t freePort() {
  const int descriptor = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  const bool isFound =
      ::bind(descriptor, any, sizeof address) == 0 && ::getsockname(descriptor, any, &size) == 0;
  ::close(descriptor);
  return isFound ? ntohs(address.sin_port) : std::uint16_t{0};
}

/// Somebody who subscribes to all streams of a server, except images in other codings.
class Watcher {
 public:
  explicit Watcher(std::uint16_t port) {
    websocket::ClientHandlers handlers;
    handlers.channelsAdded = [this](const std::vector<websocket::Channel>& channels) { subscribe(channels); };
    handlers.message = [this](const auto&, auto, std::string_view payload) { bytes_ += payload.size(); };
    client_ = std::make_shared<websocket::Client>(std::move(handlers));
    websocket::Connector::Options options;
    options.url = {false, "127.0.0.1", port, "/"};
    connector_ = std::make_unique<websocket::Connector>(client_, std::move(options));
  }

  std::size_t streams() const { return streams_; }
  std::size_t bytes() const { return bytes_; }

 private:
  void subscribe(const std::vector<websocket::Channel>& channels) {
    std::set<std::string> topics;
    for (const websocket::Channel& channel : channels)
      if (!channel.topic.ends_with("/jpeg") && !channel.topic.ends_with("/png")) topics.insert(channel.topic);
    streams_ += topics.size();
    client_->subscribe(topics);
  }

  std::atomic<std::size_t> streams_{0}, bytes_{0};
  std::shared_ptr<websocket::Client> client_;
  std::unique_ptr<websocket::Connector> connector_;
};

/// What a short game costs that is offered, with or without somebody who watches, as costOf().
struct Served {
  std::optional<double> cost;
  std::size_t streams = 0, bytes = 0;
};

Served costOfServed(std::int64_t seconds, bool isWatched) {
  const std::uint16_t port = freePort();
  std::optional<Watcher> watcher;
  if (isWatched) watcher.emplace(port);
  const auto cost = costOf(seconds, "--listen 127.0.0.1:" + std::to_string(port));
  return watcher ? Served{cost, watcher->streams(), watcher->bytes()} : Served{cost};
}

void watchersOfARobot(benchmark::State& state) {
  const std::int64_t seconds = state.range(0);
  const std::int64_t start = seconds / 4;
  const auto length = static_cast<double>(seconds);
  std::vector<double> alone, watched, added;
  for (auto unused : state) {
    static_cast<void>(unused);
    const Served startAlone = costOfServed(start, false), allAlone = costOfServed(start + seconds, false);
    const Served startSeen = costOfServed(start, true), allSeen = costOfServed(start + seconds, true);
    if (!startAlone.cost || !allAlone.cost || !startSeen.cost || !allSeen.cost || allSeen.bytes == 0) {
      state.SkipWithError("a game failed, or nobody could watch it; run robotctl sim to see why");
      return;
    }
    alone.push_back((*allAlone.cost - *startAlone.cost) / length);
    watched.push_back((*allSeen.cost - *startSeen.cost) / length);
    added.push_back(watched.back() - alone.back());
    state.counters["streams"] = static_cast<double>(allSeen.streams);
    state.counters["kB_per_s"] = static_cast<double>(allSeen.bytes - startSeen.bytes) / 1e3 / length;
    state.SetIterationTime(length);
  }
  state.counters["alone"] = median(alone);
  state.counters["watched"] = median(watched);
  state.counters["all_streams"] = median(added);
}
BENCHMARK(watchersOfARobot)
    ->ArgName("seconds")
    ->Arg(20)
    ->Iterations(3)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
