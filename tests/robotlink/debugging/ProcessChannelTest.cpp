// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ProcessChannel.h"

#include <gtest/gtest.h>

#include "robotlink/base/Clock.h"
#include "tests/robotlink/process/TestProcess.h"

namespace robotlink {
namespace {

/// The debug process's channel to the process "idle", and that one's ends of its links.
class ProcessChannelTest : public testing::Test {
 protected:
  ProcessChannelTest() {
    connectUnchecked(queues_, *debug_.receivers().front());
    connectUnchecked(*debug_.senders().front(), requests_);
  }
  void ask(std::uint64_t id) {
    robotcontrol::Request request;
    request.set_id(id);
    channel_.add(request);
  }
  /// The process confirms requests up to a number, of which the last one has this id.
  void confirm(std::uint64_t number, std::uint64_t id) {
    auto queue = std::make_shared<SharedDebugQueue>();
    queue->process = "idle";
    queue->number = ++queue_;
    queue->requestsDone = number;
    queue->requestDone = id;
    queues_.send(packageOf(queue));
    debug_.body = [this] { channel_.takeQueue(); };
    debug_.step();
  }
  /// The ids that still wait.
  std::vector<std::uint64_t> waiting() {
    std::vector<std::uint64_t> ids;
    for (const auto& request : channel_.takePending()) ids.push_back(request.id());
    return ids;
  }

  ManualClock clock_;
  TestProcess debug_{"debug", clock_}, idle_{"idle", clock_};
  ProcessChannel channel_{debug_, "idle"};
  AnySender queues_{idle_, "debug/queue/idle", Blocking::kNo};
  AnyReceiver requests_{idle_, "debug/requests/idle", Blocking::kNo};
  std::uint64_t queue_ = 0;
};

using Ids = std::vector<std::uint64_t>;

TEST_F(ProcessChannelTest, whatIsConfirmedWaitsNoLonger) {
  for (const std::uint64_t id : {51, 52, 53}) ask(id);
  confirm(2, 52);
  confirm(2, 52);
  EXPECT_EQ(waiting(), Ids{53});
}

TEST_F(ProcessChannelTest, aQueueThatCountsTheRequestsOfAnEarlierProgramConfirmsNothing) {
  for (const std::uint64_t id : {51, 52, 53}) ask(id);
  confirm(57, 40);
  confirm(2, 40);
  EXPECT_EQ(waiting(), (Ids{51, 52, 53}));
}

}  // namespace
}  // namespace robotlink
