// SPDX-License-Identifier: GPL-3.0-or-later
// How old an image of a robot is when it is in the session at the other end of a loopback connection: from
// its publication by a robot that is served as robotctl does it (a look every 5 ms) until a session here has
// it, which looks every millisecond. 99 of 100 are to be at most 20 ms old; the window shows them at its next
// tick.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <mutex>
#include <thread>

#include "foxglove/Image.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/SessionServer.h"
#include "robotlink/foxglove/session/remote/SessionClient.h"

namespace robotlink::websocket::test {
namespace {

using namespace std::chrono_literals;
using robotcontrol::KeyMode;
using robotcontrol::Request;
using SteadyTime = std::chrono::steady_clock;

constexpr char kPath[] = "red1/camera/image";

/// Publishes images until it is destroyed; an image's width is its number.
class FarRobot {
 public:
  FarRobot(std::size_t bytes, Duration period) : period_(period), data_(bytes, 'x') {
    session_.setRobots({"red1"});
    session_.setRequestSink([this](const Request& request) { accept(request); });
    Listener::Options options;
    options.address.port = 0;
    listener_ = Listener::open(server_.server(), options).value();
    thread_ = std::thread([this] { run(); });
  }
  ~FarRobot() {
    isOver_ = true;
    thread_.join();
  }
  FarRobot(const FarRobot&) = delete;
  FarRobot& operator=(const FarRobot&) = delete;

  std::uint16_t port() const { return listener_->address().port; }
  SteadyTime::time_point publishedAt(std::size_t image) {
    const std::lock_guard lock(mutex_);
    return publishedAt_.at(image);
  }

 private:
  void run() {
    auto& key = *keys_.add_keys();
    key.set_name("package/camera/image");
    key.set_stream("camera/image");
    session_.push({"red1/tables/keys", clock_.now(), std::make_shared<robotcontrol::KeyTable>(keys_)});
    std::thread camera([this] { publishImages(); });
    while (!isOver_) {
      session_.tick();
      server_.tick();
      std::this_thread::sleep_for(5ms);
    }
    camera.join();
  }
  void publishImages() {
    auto next = SteadyTime::now();
    for (std::uint32_t number = 0; !isOver_; ++number) {
      auto image = std::make_shared<foxglove::RawImage>();
      image->set_width(number);
      image->set_data(data_);
      {
        const std::lock_guard lock(mutex_);
        publishedAt_.push_back(SteadyTime::now());
      }
      session_.push({kPath, clock_.now(), image});
      std::this_thread::sleep_until(next += period_);
    }
  }
  void accept(const Request& request) {
    if (request.has_set_key()) *keys_.mutable_keys(0)->mutable_mode() = request.set_key().mode();
    robotcontrol::RequestResult result;
    result.set_id(request.id());
    result.set_accepted(true);
    session_.pushResult(result);
  }

  const Duration period_;
  const std::string data_;
  const SteadyClock clock_;
  robotcontrol::KeyTable keys_;
  Session session_;
  SessionServer server_{session_};
  std::unique_ptr<Listener> listener_;
  std::mutex mutex_;
  std::vector<SteadyTime::time_point> publishedAt_;
  std::atomic<bool> isOver_{false};
  std::thread thread_;
};

/// A session with a far robot, whose images it receives.
class Watcher {
 public:
  explicit Watcher(std::uint16_t port) : client_(session_, optionsFor(port)) {
    session_.setRequestSink([this](const Request& request) { client_.request(request); });
    while (session_.store().find("red1/tables/keys") == nullptr) tick();
    Request request;
    request.set_robot("red1");
    request.mutable_set_key()->set_name("package/camera/image");
    request.mutable_set_key()->mutable_mode()->set_kind(KeyMode::ALWAYS);
    session_.request(request);
  }
  void tick() {
    client_.tick();
    session_.tick();
    std::this_thread::sleep_for(1ms);
  }
  /// The number of the newest image.
  std::optional<std::uint32_t> newest() {
    const auto* image = session_.store().latestAs<foxglove::RawImage>(kPath, Instant::max());
    return image == nullptr ? std::nullopt : std::optional(image->width());
  }

 private:
  static SessionClient::Options optionsFor(std::uint16_t port) {
    SessionClient::Options options;
    options.connection.url = {false, "127.0.0.1", port, "/"};
    return options;
  }
  Session session_;
  SessionClient client_;
};

double quantile(std::vector<double>& values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, values.begin() + place);
  return values[static_cast<std::size_t>(place)];
}

void imageOfAFarRobot(benchmark::State& state) {
  constexpr std::size_t kImages = 300;
  FarRobot robot(static_cast<std::size_t>(state.range(0)), std::chrono::milliseconds(state.range(1)));
  Watcher watcher(robot.port());
  std::vector<double> ages;
  std::uint32_t last = 0, missed = 0;
  for (auto unused : state) {
    static_cast<void>(unused);
    while (ages.size() < kImages) {
      watcher.tick();
      const auto newest = watcher.newest();
      if (!newest || *newest == last) continue;
      if (!ages.empty()) missed += *newest - last - 1;
      last = *newest;
      ages.push_back(std::chrono::duration<double>(SteadyTime::now() - robot.publishedAt(last)).count());
    }
  }
  state.counters["p50_ms"] = quantile(ages, 0.5) * 1e3;
  state.counters["p99_ms"] = quantile(ages, 0.99) * 1e3;
  state.counters["max_ms"] = quantile(ages, 1) * 1e3;
  state.counters["missed"] = missed;
}
// Images of an ERS-210 (208 x 160 pixels), and of 640 x 480.
BENCHMARK(imageOfAFarRobot)
    ->ArgNames({"bytes", "period_ms"})
    ->Args({66'560, 40})
    ->Args({614'400, 33})
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace robotlink::websocket::test
