// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/message.h>

#include "logplayer/bhuman/QueueImport.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/logplayer/bhuman/MemoryBytes.h"
#include "tests/logplayer/bhuman/QueueBuilder.h"

namespace bhuman_queue_fuzz {

using namespace logplayer;
using namespace logplayer::bhuman;

namespace {

std::uint64_t sumOf(const std::map<std::string, std::uint64_t>& counts) {
  std::uint64_t sum = 0;
  for (const auto& [kind, count] : counts) sum += count;
  return sum;
}

std::string textOf(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

/// The beginning of the real log: images as a robot's code wrote them.
std::string beginningOfRealLog() {
  const auto log = realLog();
  return textOf(
      {log.begin(), log.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(log.size(), 32000))});
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const auto source = bytesInMemory({data, size});
  static_cast<void>(MessageQueueReader::recognizes(*source));
  std::size_t bytes = 0;
  const auto report =
      importQueue(*source, "nao",
                  [&bytes](const FrameConverter::Frame& frame) {
                    require(!frame.empty(), "a frame has something");
                    for (const auto& message : frame) {
                      require(message.process == frame.front().process, "a frame is of one process");
                      bytes += message.value->ByteSizeLong();
                    }
                    return robotlink::Result<void>();
                  },
                  {});
  require(report.has_value(), "there is no reason to fail");
  require(sumOf(report->imported) + sumOf(report->notUnderstood) == report->messages,
          "every message is accounted for");
  // An image may decode to more than its JPEG has; nothing else grows much.
  require(bytes <= (std::size_t{8} << 20U) * (report->messages + 1), "what is reported is bounded");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  const QueueBuilder whole = QueueBuilder()
                                 .begin('m')
                                 .joints(100)
                                 .sensors(100)
                                 .keys()
                                 .odometry(0.1, 20, 30)
                                 .end('m')
                                 .begin('c')
                                 .jpegImage(150, 16, 8)
                                 .cameraMatrix(true)
                                 .imageCoordinateSystem()
                                 .text("hello")
                                 .end('c')
                                 .begin('c')
                                 .image(200, 8, 4)
                                 .message(13, "a percept")
                                 .message(200, "later code")
                                 .end('c');
  std::vector<std::string> seeds = {textOf(whole.file()), textOf(whole.appendableFile()),
                                    textOf(QueueBuilder().file())};
  if (std::string real = beginningOfRealLog(); !real.empty()) seeds.push_back(std::move(real));
  return seeds;
}

const FuzzRegistration kTarget({"bhuman_queue", &fuzzSeeds, &runInput});

}  // namespace bhuman_queue_fuzz
