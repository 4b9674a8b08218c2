// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/InProcessLink.h"

#include "tests/robotlink/process/TransportConformance.h"

namespace robotlink::test {
namespace {

struct InProcess {
  void connect(AnySender& sender, AnyReceiver& receiver) { connectUnchecked(sender, receiver); }
  void settle() {}
};
INSTANTIATE_TYPED_TEST_SUITE_P(InProcess, TransportConformance, InProcess);

TEST(InProcessLinkTest, aPackageIsNeverCopied) {
  ManualClock clock;
  TestProcess from("from", clock);
  TestProcess to("to", clock);
  Sender<Ball> sender(from, "ball", Blocking::kNo);
  Receiver<Ball> receiver(to, "ball", Blocking::kNo);
  connect(sender, receiver);
  const auto package = ball(1);
  sender.send(package);
  to.step();
  EXPECT_EQ(package.get(), receiver.get());
}

TEST(InProcessLinkTest, aProcessMayBeDestroyedWhileItsPartnersSend) {
  ManualClock clock;
  TestProcess from("from", clock);
  Sender<Ball> sender(from, "ball", Blocking::kYes);
  std::atomic<bool> end{false};
  std::thread sending([&] {
    for (int i = 0; !end; ++i) {
      sender.send(ball(i));
      std::this_thread::yield();
    }
  });
  for (int i = 0; i < 50; ++i) {
    TestProcess to("to", clock);
    Receiver<Ball> receiver(to, "ball", Blocking::kYes);
    connect(sender, receiver);
    ASSERT_TRUE(to.waitForFrame(std::chrono::seconds(10)));
    to.runFrame();
  }
  end = true;
  sending.join();
  EXPECT_FALSE(sender.connected());
}

TEST(InProcessLinkTest, aTransmissionThatWasStoppedEndsForBothWithoutLockingUp) {
  ManualClock clock;
  TestProcess a("a", clock);
  TestProcess b("b", clock);
  Sender<Ball> toB(a, "to-b", Blocking::kYes);
  Receiver<Ball> fromA(b, "to-b", Blocking::kYes);
  Sender<Ball> toA(b, "to-a", Blocking::kYes);
  Receiver<Ball> fromB(a, "to-a", Blocking::kYes);
  connect(toB, fromA);
  connect(toA, fromB);
  a.body = [&] { toB.send(ball(1)); };
  b.body = [&] { toA.send(ball(1)); };
  const auto loop = [](Process& process) {
    while (process.waitForFrame(std::chrono::seconds(10))) process.runFrame();
  };
  std::thread threadA(loop, std::ref<Process>(a));
  std::thread threadB(loop, std::ref<Process>(b));
  toB.send(ball(0));
  while (a.frames() < 20) std::this_thread::yield();
  std::thread stopping([&] { a.stop(); });
  b.stop();
  stopping.join();
  threadA.join();
  threadB.join();
  EXPECT_TRUE(a.stopped() && b.stopped());
}

}  // namespace
}  // namespace robotlink::test
