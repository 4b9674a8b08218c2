// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files: whatever is in them, they end in errors or in a scene that can be stepped, in bounded time and
// memory.
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "tests/TestFolder.h"
#include "tests/fuzz/FuzzTarget.h"

namespace scene_fuzz {

using namespace simcore;
namespace fs = std::filesystem;

std::vector<std::string> fuzzSeeds();

namespace {

constexpr int kSteps = 20;
/// Far above what any small scene takes, and far below what hurts.
constexpr double kMaxSeconds = 20;
constexpr long kMaxMegabytes = 2000;

/// The largest memory of this process so far.
long megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

const fs::path kModels = ROBOTCONTROL_SOURCE_DIR "/tests/simcore/sdf/models";

/// The folder in which the scene is written; it has the parts and meshes that the seeds name.
const TestFolder& folder() {
  static const TestFolder kFolder(TestFolder::Where::kMemory);
  static const bool kFilled = [] {
    for (const char* part : {"meshes", "parts"})
      fs::copy(kModels / part, kFolder.path() / part, fs::copy_options::recursive);
    return true;
  }();
  static_cast<void>(kFilled);
  return kFolder;
}

void readEverything(Simulation& simulation) {
  for (const Port& port : simulation.ports()) {
    if (port.kind == Port::Kind::kCamera) continue;
    double size = 1;
    for (const int count : port.info.shape) size *= count;
    if (size < 1e5) static_cast<void>(simulation.read(port.info.path));
  }
}

void simulate(const std::shared_ptr<const Scene>& scene) {
  auto simulation = Simulation::create(scene, {});
  if (!simulation) return;
  for (int i = 0; i < kSteps; ++i) {
    for (std::size_t s = 0; s < (*simulation)->servos().size(); ++s) {
      const Servo& servo = (*simulation)->servos()[s];
      (*simulation)->requestAngle(s, i % 2 == 0 ? servo.minimum : servo.maximum);
    }
    (*simulation)->step();
  }
  for (const Pose3& pose : (*simulation)->bodyPoses())
    require(pose.matrix().allFinite(), "bodies are somewhere");
  readEverything(**simulation);
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  // The time of the processor counts, since others may use it, too.
  const std::clock_t start = std::clock();
  const fs::path file = folder().write("world.sdf", {reinterpret_cast<const char*>(data), size});
  const auto scene = Scene::load(file, {}, {}, {ROBOTCONTROL_SOURCE_DIR "/resources/scenes/models"});
  if (scene) simulate(*scene);
  if (!scene) require(!scene.error().empty(), "what is refused has an error");
  const double passed = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  require(passed < kMaxSeconds, "a scene takes little time");
  require(megabytes() < kMaxMegabytes, "a scene takes little memory");
  return 0;
}

namespace {

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The place of an element in a text: from its "<" to behind its end.
struct Span {
  std::size_t begin = 0, end = 0;
};

/// The first element that begins at a place or later; empty if there is none that ends.
Span elementFrom(const std::string& text, std::size_t at) {
  for (std::size_t begin = text.find('<', at); begin != std::string::npos;
       begin = text.find('<', begin + 1)) {
    std::size_t end = begin + 1;
    while (end < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == ':' || text[end] == '_'))
      ++end;
    const std::string name = text.substr(begin + 1, end - begin - 1);
    if (name.empty()) continue;
    const std::size_t tag = text.find('>', end);
    if (tag == std::string::npos) return {};
    if (text[tag - 1] == '/') return {begin, tag + 1};
    const std::size_t close = text.find("</" + name + ">", tag);
    if (close != std::string::npos) return {begin, close + name.size() + 3};
  }
  return {};
}

using Generator = std::minstd_rand;

std::size_t below(Generator& random, std::size_t count) {
  return count == 0 ? 0 : random() % count;
}

/// Puts an unlikely number in the place of one of those between ">" and "<".
void exchangeNumber(std::string& text, Generator& random) {
  static constexpr const char* kNumbers[] = {
      "0",   "-1",    "1e-9", "1e9",  "1e30",  "-1e30", "1e300",       "inf",  "-inf", "nan", "0 0 0",
      "1 2", "1e-30", "3.14", "1000", "0.001", "-0.5",  "7 7 7 7 7 7", "true", "",     "x",   "100000"};
  std::size_t at = text.find_first_of("0123456789", below(random, text.size()));
  if (at == std::string::npos) return;
  const std::size_t end = text.find_first_not_of("0123456789.eE-+", at);
  text.replace(at, end == std::string::npos ? end : end - at, kNumbers[below(random, std::size(kNumbers))]);
}

/// Mutates elements instead of bytes, so that what results is a scene more often: removes, doubles, moves and
/// exchanges elements and numbers.
std::string mutateElements(std::string text, unsigned seed) {
  static const std::vector<std::string> kSeeds = fuzzSeeds();
  Generator random(seed);
  for (std::size_t i = 1 + below(random, 3); i > 0; --i) {
    const Span one = elementFrom(text, below(random, text.size()));
    if (one.end == 0) continue;
    const std::string element = text.substr(one.begin, one.end - one.begin);
    switch (random() % 7) {
      case 0:
        text.erase(one.begin, element.size());
        break;
      case 1:
        text.insert(one.end, element);
        break;
      case 2:
        text.erase(one.begin, element.size());
        text.insert(elementFrom(text, below(random, text.size())).begin, element);
        break;
      case 3: {
        const std::string& other = kSeeds[below(random, kSeeds.size())];
        const Span from = elementFrom(other, below(random, other.size()));
        text.replace(one.begin, random() % 2 == 0 ? element.size() : 0,
                     other.substr(from.begin, from.end - from.begin));
        break;
      }
      default:
        exchangeNumber(text, random);
    }
  }
  return text;
}

}  // namespace

std::vector<std::string> fuzzSeeds() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kModels)) {
    // A URDF is a file of another kind, which its ending tells.
    if (entry.path().extension() == ".sdf") files.push_back(entry.path());
  }
  for (const char* name : {"ers210", "p3at", "ball", "sliding_door", "burger"})
    files.push_back(fs::path(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/models") / name / "model.sdf");
  for (const char* name : {"field2002.sdf", "pioneer.sdf"})
    files.push_back(fs::path(ROBOTCONTROL_SOURCE_DIR "/resources/scenes") / name);
  std::ranges::sort(files);
  std::vector<std::string> seeds;
  for (const fs::path& file : files) seeds.push_back(textOf(file));
  return seeds;
}

const FuzzRegistration kTarget({"scene", &fuzzSeeds, &runInput, &mutateElements});

}  // namespace scene_fuzz
