// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to read and to write packets, beside copying the same bytes: the least that handing them on
// needs. Both are measured in turn, so that what else the machine does hits both alike; "ratio" is the median
// of their quotients.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/arcos/codec/ServerPackets.h"

namespace robotlink::arcos {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kPackets = 7000;

/// What a robot with sonars and laser sends: an information packet, then a scan of 181 readings in six parts.
std::vector<ServerPacket> conversation() {
  StandardInformation sip;
  for (std::uint8_t i = 0; i < 16; ++i) sip.sonars.push_back({i, static_cast<std::uint16_t>(300 * i)});
  sip.gripState = sip.analogPort = sip.analog = sip.digitalIn = sip.digitalOut = std::uint8_t{1};
  sip.batteryDecivolts16 = 130;
  sip.chargeState = 0;
  sip.rotationRateDeciDegS = -5;
  sip.faultFlags = 0;
  sip.lateralSpeedMmS = 0;
  sip.temperatureDegC = 20;
  sip.stateOfChargePercent = 90;
  std::vector<ServerPacket> packets;
  while (packets.size() < kPackets) {
    ++sip.xMm;
    packets.emplace_back(sip);
    for (std::uint16_t first = 0; first < 181; first += 32) {
      LaserPacket part;
      part.total = 181;
      part.first = first;
      part.readings.resize(std::min(32, 181 - first), {static_cast<std::uint16_t>(first), 1, {}});
      packets.emplace_back(std::move(part));
    }
  }
  return packets;
}

template <typename Work>
double secondsOf(Work work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double copySeconds(const Bytes& bytes, Bytes& target) {
  return secondsOf([&] {
           for (int i = 0; i < 10; ++i) {
             std::memcpy(target.data(), bytes.data(), bytes.size());
             benchmark::DoNotOptimize(target.data());
             benchmark::ClobberMemory();
           }
         }) /
         10;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <typename Work>
void measure(benchmark::State& state, const Bytes& bytes, std::size_t packets, Work work) {
  Bytes target(bytes.size());
  std::vector<double> ratios;
  std::vector<double> times;
  for (auto unused : state) {
    static_cast<void>(unused);
    const double copying = copySeconds(bytes, target);
    const double working = secondsOf(work);
    state.SetIterationTime(working);
    ratios.push_back(working / copying);
    times.push_back(working);
  }
  const double time = median(times);
  state.counters["packets_per_s"] = static_cast<double>(packets) / time;
  state.counters["MB_per_s"] = static_cast<double>(bytes.size()) / time / 1e6;
  state.counters["ratio"] = median(ratios);
}

void encodeAll(const std::vector<ServerPacket>& packets, Bytes& bytes) {
  bytes.clear();
  for (const ServerPacket& packet : packets) append(toPacket(packet), bytes);
}

void encodePackets(benchmark::State& state) {
  const auto packets = conversation();
  Bytes bytes;
  encodeAll(packets, bytes);
  Bytes written = bytes;
  measure(state, bytes, packets.size(), [&] {
    encodeAll(packets, written);
    benchmark::DoNotOptimize(written.data());
  });
}
BENCHMARK(encodePackets)->Iterations(50)->UseManualTime()->Unit(benchmark::kMillisecond);

/// From a stream of bytes to typed packets, in pieces as lines give them.
void decodePackets(benchmark::State& state) {
  const auto packets = conversation();
  Bytes bytes;
  encodeAll(packets, bytes);
  std::size_t good = 0;
  measure(state, bytes, packets.size(), [&] {
    PacketParser parser;
    for (std::size_t at = 0; at < bytes.size(); at += 4096) {
      parser.push(std::span(bytes).subspan(at, std::min<std::size_t>(4096, bytes.size() - at)));
      while (const auto found = parser.next()) good += decodeServerPacket(std::get<Packet>(*found)) ? 1U : 0U;
    }
  });
  if (good != packets.size() * 50) state.SkipWithError("not every packet was decoded");
}
BENCHMARK(decodePackets)->Iterations(50)->UseManualTime()->Unit(benchmark::kMillisecond);

/// The frame alone: header, count, checksum.
void findPackets(benchmark::State& state) {
  const auto packets = conversation();
  Bytes bytes;
  encodeAll(packets, bytes);
  measure(state, bytes, packets.size(), [&] {
    PacketParser parser;
    for (std::size_t at = 0; at < bytes.size(); at += 4096) {
      parser.push(std::span(bytes).subspan(at, std::min<std::size_t>(4096, bytes.size() - at)));
      while (const auto found = parser.next()) benchmark::DoNotOptimize(&*found);
    }
  });
}
BENCHMARK(findPackets)->Iterations(50)->UseManualTime()->Unit(benchmark::kMillisecond);

void encodeAndDecodeCommands(benchmark::State& state) {
  std::vector<Command> commands;
  for (int i = 0; i < static_cast<int>(kPackets); ++i)
    commands.push_back(command(CommandId::kVel, i % 1000 - 500));
  Bytes bytes;
  for (const Command& one : commands) append(toPacket(one), bytes);
  measure(state, bytes, commands.size(), [&] {
    PacketParser parser;
    for (const Command& one : commands) {
      parser.push(encode(toPacket(one)));
      benchmark::DoNotOptimize(toCommand(std::get<Packet>(*parser.next())));
    }
  });
}
BENCHMARK(encodeAndDecodeCommands)->Iterations(50)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace robotlink::arcos
