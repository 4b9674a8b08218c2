// SPDX-License-Identifier: GPL-3.0-or-later
// What the views of robots on wheels cost with a large map and many packets.
#include <benchmark/benchmark.h>

#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QPalette>

#include "robotcontrol/Driving.pb.h"
#include "robotlink/arcos/codec/Packet.h"
#include "widgets/field/FieldViewport.h"
#include "widgets/field/MapPainter.h"
#include "widgets/packets/PacketFilter.h"
#include "widgets/packets/PacketModel.h"

namespace {

constexpr int kPoints = 63'000;

/// As many points as the largest map that is known, along the walls of rooms in a building of 24 m by 52 m,
/// and 470 lines.
std::shared_ptr<const robotcontrol::GroundMap> building() {
  auto map = std::make_shared<robotcontrol::GroundMap>();
  for (int i = 0; i < kPoints; ++i) {
    const int wall = i / 300;
    const double along = 0.02 * (i % 300), jitter = 0.01 * (i % 7);
    const double x = (wall % 4) * 6.0, y = (wall / 8) * 2.0;
    map->add_points(static_cast<float>(wall % 8 < 4 ? x + along : x + jitter));
    map->add_points(static_cast<float>(wall % 8 < 4 ? y + jitter : y + along));
  }
  for (int i = 0; i < 470; ++i) {
    auto& line = *map->add_lines();
    line.set_x1(0.05 * i), line.set_y1(0.1 * i), line.set_x2(0.05 * i + 1), line.set_y2(0.1 * i);
  }
  return map;
}

/// A picture that is as it was: each frame while nobody moves it.
void paintMapAgain(benchmark::State& state) {
  const widgets::MapGround ground(building());
  QImage image(1200, 900, QImage::Format_RGB32);
  QPainter painter(&image);
  const QTransform transform = widgets::fieldToWidget({}, ground.extent(), image.size());
  for (auto _ : state) ground.paint(painter, image.size(), transform, QPalette(Qt::gray), 1, -1);
}
BENCHMARK(paintMapAgain)->Unit(benchmark::kMillisecond);

/// While it is dragged or zoomed: each frame is painted again. The argument: how many times it is enlarged.
void paintMapMoved(benchmark::State& state) {
  const widgets::MapGround ground(building());
  QImage image(1200, 900, QImage::Format_RGB32);
  QPainter painter(&image);
  widgets::FieldViewport viewport{false, 17.0 * static_cast<double>(state.range(0)), {12, 26}, 0};
  for (auto _ : state) {
    viewport.center.x() += 0.01;
    ground.paint(painter, image.size(), widgets::fieldToWidget(viewport, ground.extent(), image.size()),
                 QPalette(Qt::gray), 1, -1);
  }
}
BENCHMARK(paintMapMoved)->Arg(1)->Arg(8)->Arg(64)->Unit(benchmark::kMillisecond);

/// An information packet with sixteen sonar readings.
std::string information() {
  robotlink::arcos::Bytes data(83 - 1, 0);
  data[18] = 16;
  for (std::size_t i = 0; i < 16; ++i) data[19 + 3 * i] = static_cast<std::uint8_t>(i);
  const auto bytes = encode(robotlink::arcos::Packet{0x32, data});
  return {bytes.begin(), bytes.end()};
}

void decodePacket(benchmark::State& state) {
  const std::string bytes = information();
  for (auto _ : state) benchmark::DoNotOptimize(widgets::packetEntry({}, true, bytes));
}
BENCHMARK(decodePacket)->Unit(benchmark::kMicrosecond);

std::vector<widgets::PacketEntry> entries(std::size_t count) {
  return {count, widgets::packetEntry({}, true, information())};
}

/// A second of one robot with its laser, into a full table that is filtered.
void appendToFullTable(benchmark::State& state) {
  widgets::PacketModel model;
  model.append(entries(100'000));
  widgets::PacketFilter filter;
  filter.setText(QStringLiteral("information"));
  filter.setSourceModel(&model);
  const auto news = entries(70);
  benchmark::DoNotOptimize(filter.rowCount());  // from now on it keeps up with the model
  for (auto _ : state) {
    model.append(news);
    benchmark::DoNotOptimize(filter.rowCount());
  }
}
BENCHMARK(appendToFullTable)->Unit(benchmark::kMillisecond);

void filterFullTable(benchmark::State& state) {
  widgets::PacketModel model;
  model.append(entries(100'000));
  widgets::PacketFilter filter;
  filter.setSourceModel(&model);
  int i = 0;
  for (auto _ : state) {
    filter.setText(QStringLiteral("battery %1").arg(++i));
    benchmark::DoNotOptimize(filter.rowCount());
  }
}
BENCHMARK(filterFullTable)->Unit(benchmark::kMillisecond);

}  // namespace
