// SPDX-License-Identifier: GPL-3.0-or-later
// The same scene, seed and commands give the same bytes, in any process and on any thread, whoever looks on.
#include <gtest/gtest.h>

#include <unistd.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <thread>
#include <vector>

#include "robotlink/base/Random.h"
#include "simcore/rendering/CameraRenderer.h"
#include "tests/simcore/truth/Bodies.h"
#include "tests/simcore/truth/TruthTable.h"

namespace simcore::truth {
namespace {

/// A view that draws what a camera sees, as often as it likes.
class Onlooker {
 public:
  explicit Onlooker(const Simulation& simulation) : renderer_(simulation.renderScene(), {}) {}
  void look(const Simulation& simulation) {
    renderer_.setPoses(simulation.bodyPoses());
    renderer_.render(simulation.bodyPoses()[1], {64, 48}, robotlink::PixelFormat::kRgb8, {}, image_);
    if (!simulation.cameras().empty()) static_cast<void>(simulation.truePercepts(0));
    for (const Port& port : simulation.ports()) static_cast<void>(simulation.read(port.info.path));
  }

 private:
  CameraRenderer renderer_;
  robotlink::Image image_;
};

/// Plays for a second, and sums up all poses, velocities, and readings.
std::uint64_t play(const char* file, bool watched) {
  const auto scene = Scene::load(std::string(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/") + file);
  auto simulation = std::move(Simulation::create(scene.value(), {.seed = 5, .noise = true}).value());
  Onlooker onlooker(*simulation);
  std::uint64_t hash = 0;
  for (int i = 0; i < 250; ++i) {
    for (std::size_t s = 0; s < simulation->servos().size(); ++s)
      simulation->requestAngle(s, 0.3 * std::sin(0.05 * i + static_cast<double>(s)));
    for (std::size_t d = 0; d < simulation->drives().size(); ++d) simulation->requestWheelSpeeds(d, 0.3, 0.1);
    simulation->step();
    if (watched && i % 25 == 3) onlooker.look(*simulation);
    if (i % 50 != 0) continue;
    hash = robotlink::mixBits(hash ^ simulation->digest());
    for (const Sensor& sensor : simulation->sensors()) {
      for (const double value : sensor.values)
        hash = robotlink::mixBits(hash ^ std::bit_cast<std::uint64_t>(value));
    }
  }
  return hash;
}

constexpr const char* kScenes[] = {"field2002.sdf", "pioneer.sdf"};

/// Prints the digests, for the test below, which runs it in processes of its own.
TEST(RepeatTruth, DISABLED_printDigests) {
  for (const char* file : kScenes)
    std::printf("digest %llu\n", static_cast<unsigned long long>(play(file, false)));
}

/// The digests that a process of its own prints, with an environment of this size.
std::vector<std::uint64_t> digestsOfProcess(std::size_t padding) {
  std::vector<std::uint64_t> digests;
  // The file to which the table is written, if any, is that of this process.
  const std::string command =
      "ROBOTCONTROL_TRUTH_TABLE= PADDING=" + std::string(padding, 'x') + " /proc/" +
      std::to_string(getpid()) +
      "/exe --gtest_also_run_disabled_tests --gtest_filter=RepeatTruth.DISABLED_printDigests";
  FILE* output = popen(command.c_str(), "r");
  if (output == nullptr) return digests;
  std::array<char, 256> line;
  unsigned long long digest = 0;
  while (std::fgets(line.data(), line.size(), output) != nullptr) {
    if (std::sscanf(line.data(), "digest %llu", &digest) == 1) digests.push_back(digest);
  }
  pclose(output);
  return digests;
}

TEST(RepeatTruth, processesThreadsAndViewsChangeNothing) {
  std::vector<std::uint64_t> digests;
  for (const char* file : kScenes) digests.push_back(play(file, false));
  double differing = 0;
  for (const std::size_t padding : {0U, 5000U}) {
    const auto others = digestsOfProcess(padding);
    ASSERT_EQ(others.size(), digests.size());
    differing += others == digests ? 0 : 1;
  }
  compare({"digests after 250 steps in other processes, how many differ", "0", 0, 0, ""}, differing);
  std::vector<std::uint64_t> found(6);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < found.size(); ++i)
    threads.emplace_back([&found, i] { found[i] = play(kScenes[i % 2], i >= 4); });
  for (std::thread& thread : threads) thread.join();
  double threadsDiffer = 0;
  for (std::size_t i = 0; i < found.size(); ++i) threadsDiffer += found[i] == digests[i % 2] ? 0 : 1;
  compare({"digests on six threads, how many differ", "0", 0, 0, ""}, threadsDiffer);
  double viewsDiffer = 0;
  for (std::size_t i = 0; i < 2; ++i) viewsDiffer += play(kScenes[i], true) == digests[i] ? 0 : 1;
  compare({"digests with views and readers of all ports, how many differ", "0", 0, 0, ""}, viewsDiffer);
}

}  // namespace
}  // namespace simcore::truth
