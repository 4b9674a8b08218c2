// SPDX-License-Identifier: GPL-3.0-or-later
// What the history says that it takes, against what it takes from the heap.
#include <gtest/gtest.h>
#include <malloc.h>

#include "foxglove/Image.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotlink/session/Session.h"
#include "tests/robotlink/session/SessionMessages.h"

using namespace robotlink;
using namespace robotlink::test;

namespace {

/// In use from the heap; 0 where an instrumented one takes its place.
std::size_t heap() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

void addDrawing(robotcontrol::DebugQueue& queue, const std::string& path, double time, int points) {
  auto& line = *add(queue, path, time).mutable_scene_drawing()->add_entities()->add_lines();
  for (int i = 0; i < points; ++i) line.add_points()->set_x(i);
}

void addPackage(robotcontrol::DebugQueue& queue, const std::string& path, double time, std::size_t bytes) {
  foxglove::RawImage image;
  image.set_data(std::string(bytes, 'x'));
  auto& copy = *add(queue, path, time).mutable_package();
  copy.set_type("foxglove.RawImage");
  copy.set_data(image.SerializeAsString());
}

/// Pushes queues and says how many times of what the history counts it takes.
double takenByCounted(const std::function<void(robotcontrol::DebugQueue&, double)>& fill) {
  Session session;
  const std::size_t before = heap();
  for (int i = 1; i <= 300; ++i) {
    const double time = 0.04 * i;
    const auto queue = queueOf("cognition");
    fill(*queue, time);
    endFrame(*queue, time, static_cast<std::uint64_t>(i));
    session.pushQueue("red1", fromWire(*queue));
    session.tick();
  }
  return static_cast<double>(heap() - before) / static_cast<double>(session.store().bytes());
}

#define EXPECT_COUNTED(fill)                                   \
  if (heap() == 0) GTEST_SKIP() << "the heap cannot be asked"; \
  const double taken = takenByCounted(fill);                   \
  EXPECT_GT(taken, 0.7);                                       \
  EXPECT_LT(taken, 1.2)

}  // namespace

TEST(HistoryMemory, imagesTakeWhatIsCounted) {
  EXPECT_COUNTED([](auto& queue, double time) {
    add(queue, "camera/image", time).mutable_image()->set_data(std::string(50'000, 'x'));
  });
}

TEST(HistoryMemory, drawingsTakeWhatIsCounted) {
  EXPECT_COUNTED([](auto& queue, double time) {
    for (const char* path : {"drawings/field/a", "drawings/field/b"}) addDrawing(queue, path, time, 200);
  });
}

TEST(HistoryMemory, packagesTakeWhatIsCountedThoughTheyCameAsCopies) {
  EXPECT_COUNTED([](auto& queue, double time) { addPackage(queue, "camera/image", time, 50'000); });
}

TEST(HistoryMemory, whatOnlyRecordersWantIsNotKept) {
  EXPECT_COUNTED([](auto& queue, double time) {
    addDrawing(queue, "drawings/field/a", time, 200);
    auto& message = add(queue, "camera/image", time);
    message.mutable_image()->set_data(std::string(50'000, 'x'));
    message.set_only_recorded(true);
  });
}

TEST(HistoryMemory, manySmallMessagesTakeWhatIsCounted) {
  EXPECT_COUNTED([](auto& queue, double time) {
    for (int i = 0; i < 100; ++i)
      add(queue, "plots/ball-model/number-" + std::to_string(i), time).mutable_plot()->set_value(i);
  });
}
