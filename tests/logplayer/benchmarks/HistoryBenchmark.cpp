// SPDX-License-Identifier: GPL-3.0-or-later
// What a session's history costs for a second of one ERS-210 with all that views show: in the thread of the
// GUI (Time), and in all threads (CPU).
#include <benchmark/benchmark.h>

#include <array>
#include <random>

#include "foxglove/Image.pb.h"
#include "foxglove/Scene.pb.h"
#include "logplayer/scratch/ScratchLog.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/Session.h"

using namespace robotlink;

namespace {

/// Small, so that it is full soon and messages leave it as in a session of hours.
constexpr std::size_t kMemory = 64U << 20U;

/// The messages of 1 s, made before anything is measured: 25 images, 20 drawings in each, 40 other streams of
/// motion at 125 Hz.
std::vector<StreamMessage> secondOfMessages() {
  std::mt19937 random(1);
  std::vector<StreamMessage> messages;
  for (int i = 0; i < 125; ++i) {
    const Instant time = Instant(std::chrono::milliseconds(8 * i));
    if (i % 5 == 0) {
      auto image = std::make_shared<foxglove::RawImage>();
      image->mutable_data()->resize(176 * 144 * 3 / 2);
      for (char& byte : *image->mutable_data()) byte = static_cast<char>(random() % 64);
      messages.push_back({"red1/camera/image", time, image, "cognition"});
      for (int key = 0; key < 20; ++key) {
        auto drawing = std::make_shared<foxglove::SceneUpdate>();
        auto& line = *drawing->add_entities()->add_lines();
        for (int point = 0; point < 50; ++point) line.add_points()->set_x(point);
        messages.push_back({"red1/drawings/field/" + std::to_string(key), time, drawing, "cognition"});
      }
    }
    for (int stream = 0; stream < 40; ++stream) {
      auto value = std::make_shared<robotcontrol::PlotValue>();
      value->set_value(static_cast<double>(random()));
      messages.push_back({"red1/plots/" + std::to_string(stream), time, value, "motion"});
    }
  }
  for (StreamMessage& message : messages) message.bytes = sizeOf(message);
  return messages;
}

enum Kind : int { kOneMinute, kBytes, kDisk, kPaused };

void keepHistory(benchmark::State& state) {
  const std::vector<StreamMessage> messages = secondOfMessages();
  const auto kind = static_cast<Kind>(state.range(0));
  StreamStore::Limits limits{.bytes = kMemory};
  if (kind == kOneMinute) limits = {.age = std::chrono::seconds(60), .bytes = 512U << 20U};
  Session session(limits);
  logplayer::ScratchLog* disk = nullptr;
  if (kind >= kDisk) {
    auto log = std::make_unique<logplayer::ScratchLog>(
        logplayer::ScratchLog::Options{.bytes = 256U << 20U, .reserve = 0, .waiting = ~std::uint64_t{0}});
    disk = log.get();
    session.history().setArchive(std::move(log));
  }
  int second = 0;
  const auto play = [&] {
    for (std::size_t i = 0; i < messages.size(); ++i) {
      StreamMessage message = messages[i];
      message.time += std::chrono::seconds(second);
      session.push(std::move(message));
      if (i % (messages.size() / 30) == 0) session.tick();
    }
    ++second;
  };
  while (second < 90) play();
  if (kind == kPaused) session.history().show(Instant(std::chrono::seconds(85)));
  for (auto _ : state) {
    play();
    if (disk == nullptr || second % 10 != 0) continue;
    state.PauseTiming();
    disk->finish();
    state.ResumeTiming();
  }
  constexpr std::array kNames{"a minute", "bytes", "bytes and disk", "the same, paused"};
  state.SetLabel(kNames[static_cast<std::size_t>(kind)]);
  state.counters["messages"] = static_cast<double>(messages.size());
}
BENCHMARK(keepHistory)
    ->DenseRange(kOneMinute, kPaused)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
