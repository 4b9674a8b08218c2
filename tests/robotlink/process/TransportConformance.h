// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <thread>

#include "tests/robotlink/process/TestProcess.h"

namespace robotlink::test {

/// The conformance suite of transports: the semantics of senders and receivers (DESIGN.md, "Processes"). A
/// transport runs the suite by means of a class like this:
///
///     struct MyTransport {
///       // Connects the two ends.
///       void connect(AnySender& sender, AnyReceiver& receiver);
///       // Returns when everything sent has arrived and the sender knows of all requests.
///       void settle();
///     };
///     INSTANTIATE_TYPED_TEST_SUITE_P(Mine, TransportConformance, MyTransport);
template <typename Transport>
class TransportConformance : public ::testing::Test {
 protected:
  using End = Receiver<Ball>;

  void connect(AnySender& sender, AnyReceiver& receiver) { transport_.connect(sender, receiver); }
  void send(Sender<Ball>& sender, double number) {
    sender.send(ball(number));
    transport_.settle();
  }
  bool mayBegin(Process& process) {
    const bool may = process.tryBeginFrame();
    transport_.settle();
    return may;
  }
  bool step(TestProcess& process) {
    const bool ran = process.step();
    transport_.settle();
    return ran;
  }

  ManualClock clock_;
  Transport transport_;
  TestProcess from_{"from", clock_};
  TestProcess to_{"to", clock_};
};
TYPED_TEST_SUITE_P(TransportConformance);

TYPED_TEST_P(TransportConformance, whatIsSentArrivesOnceAndStays) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kNo);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  this->connect(sender, receiver);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_EQ(-1, numberIn(receiver));
  EXPECT_FALSE(receiver.isNew());
  this->send(sender, 7);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_EQ(7, numberIn(receiver));
  EXPECT_TRUE(receiver.isNew());
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_EQ(7, numberIn(receiver));
  EXPECT_FALSE(receiver.isNew());
  EXPECT_EQ("from", receiver.peer());
  EXPECT_EQ("robotcontrol.BallPercept", receiver.typeName());
}

TYPED_TEST_P(TransportConformance, theNewestWinsAndTheOthersAreCountedAsMissed) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kNo);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  this->connect(sender, receiver);
  for (int i = 1; i <= 5; ++i) this->send(sender, i);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_EQ(5, numberIn(receiver));
  EXPECT_EQ(5U, sender.sent());
  EXPECT_EQ(4U, receiver.missed());
}

TYPED_TEST_P(TransportConformance, aBlockingReceiverNeedsANewPackageForEachFrame) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kNo);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kYes);
  this->connect(sender, receiver);
  EXPECT_FALSE(this->step(this->to_));
  EXPECT_EQ("package ball of from", this->to_.waitsFor());
  this->send(sender, 1);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_FALSE(this->step(this->to_));
  EXPECT_EQ(1, numberIn(receiver));
}

TYPED_TEST_P(TransportConformance, aNewerPackageReplacesOneThatWasTakenButNotUsed) {
  TestProcess other("other", this->clock_);
  Sender<Ball> sender(this->from_, "ball", Blocking::kNo);
  Sender<Ball> late(other, "late", Blocking::kNo);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kYes);
  Receiver<Ball> lateReceiver(this->to_, "late", Blocking::kYes);
  this->connect(sender, receiver);
  this->connect(late, lateReceiver);
  this->send(sender, 1);
  EXPECT_FALSE(this->mayBegin(this->to_));
  this->send(sender, 2);
  EXPECT_FALSE(this->mayBegin(this->to_));
  this->send(late, 3);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_EQ(2, numberIn(receiver));
  EXPECT_TRUE(receiver.isNew());
  EXPECT_EQ(1U, receiver.missed());
}

TYPED_TEST_P(TransportConformance, allBlockingEndsAreRequired) {
  TestProcess third("third", this->clock_);
  Sender<Ball> a(this->from_, "a", Blocking::kNo);
  Sender<Ball> b(this->from_, "b", Blocking::kNo);
  Receiver<Ball> receiverA(this->to_, "a", Blocking::kYes);
  Receiver<Ball> receiverB(this->to_, "b", Blocking::kYes);
  Sender<Ball> out(this->to_, "out", Blocking::kYes);
  Receiver<Ball> outReceiver(third, "out", Blocking::kNo);
  this->connect(a, receiverA);
  this->connect(b, receiverB);
  this->connect(out, outReceiver);
  this->to_.body = [&] {
    out.send(ball(1));
    out.send(ball(2));  // undelivered until the third process takes the first
  };
  this->send(a, 1);
  EXPECT_FALSE(this->step(this->to_));
  this->send(b, 1);
  EXPECT_TRUE(this->step(this->to_));
  this->send(a, 2);
  this->send(b, 2);
  EXPECT_FALSE(this->step(this->to_));
  EXPECT_EQ("its package out to be taken", this->to_.waitsFor());
  EXPECT_TRUE(this->step(third));
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_EQ(2U, this->to_.frames());
}

TYPED_TEST_P(TransportConformance, aBlockingSenderWaitsForARequest) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kYes);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  this->connect(sender, receiver);
  EXPECT_TRUE(this->mayBegin(this->from_)) << "satisfied before its first send";
  this->send(sender, 1);
  EXPECT_TRUE(this->mayBegin(this->from_)) << "the receiver had asked for one";
  this->send(sender, 2);
  EXPECT_FALSE(this->mayBegin(this->from_)) << "it has not asked for another";
  EXPECT_FALSE(sender.delivered());
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_TRUE(this->mayBegin(this->from_));
  EXPECT_TRUE(sender.delivered());
}

TYPED_TEST_P(TransportConformance, aBlockingSenderWaitsForItsSlowestReceiver) {
  TestProcess slow("slow", this->clock_);
  Sender<Ball> sender(this->from_, "ball", Blocking::kYes);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  Receiver<Ball> slowReceiver(slow, "ball", Blocking::kNo);
  this->connect(sender, receiver);
  this->connect(sender, slowReceiver);
  this->send(sender, 1);
  this->send(sender, 2);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_FALSE(this->mayBegin(this->from_));
  EXPECT_TRUE(this->step(slow));
  EXPECT_TRUE(this->mayBegin(this->from_));
  EXPECT_EQ(2, numberIn(slowReceiver));
}

TYPED_TEST_P(TransportConformance, whatIsSentInPhaseTwoArrivesWhileTheNextIsComputed) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kYes);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kYes);
  this->connect(sender, receiver);
  double computed = 0;
  std::vector<double> seen;
  this->to_.body = [&] { seen.push_back(numberIn(receiver)); };
  this->from_.body = [&] {
    sender.send(ball(computed));
    this->transport_.settle();
    EXPECT_TRUE(this->step(this->to_)) << "while the sender is in phase 2";
    computed += 1;  // for the next frame
  };
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(this->step(this->from_));
  EXPECT_EQ((std::vector<double>{0, 1, 2}), seen);
}

TYPED_TEST_P(TransportConformance, tapsSeeEverythingAndHoldNothingBack) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kYes);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  this->connect(sender, receiver);
  std::vector<double> seen;
  sender.addTap([&](const PackagePtr& package) {
    seen.push_back(static_cast<const Ball&>(*package).radius_in_image());
  });
  for (int i = 1; i <= 3; ++i) this->send(sender, i);
  EXPECT_EQ((std::vector<double>{1, 2, 3}), seen);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_TRUE(this->mayBegin(this->from_));
}

TYPED_TEST_P(TransportConformance, receiversOfStoppedProcessesNeverCount) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kYes);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  this->connect(sender, receiver);
  this->send(sender, 1);
  this->send(sender, 2);
  EXPECT_FALSE(this->mayBegin(this->from_));
  this->to_.stop();
  this->transport_.settle();
  EXPECT_TRUE(this->mayBegin(this->from_));
  this->send(sender, 3);
  this->send(sender, 4);
  EXPECT_TRUE(this->mayBegin(this->from_));
  EXPECT_FALSE(sender.connected());
}

TYPED_TEST_P(TransportConformance, whatAStoppedProcessHadDeliveredCanStillBeTaken) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kNo);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kYes);
  this->connect(sender, receiver);
  this->send(sender, 1);
  this->from_.stop();
  this->send(sender, 2);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_EQ(1, numberIn(receiver));
  EXPECT_FALSE(this->step(this->to_));
  EXPECT_EQ("package ball of from, which has stopped", this->to_.waitsFor());
}

TYPED_TEST_P(TransportConformance, aProcessThatThrowsStopsAndSetsItsPartnersFree) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kYes);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  this->connect(sender, receiver);
  this->send(sender, 1);
  this->to_.body = [] { throw std::runtime_error("no ball"); };
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_TRUE(this->to_.stopped());
  EXPECT_EQ("no ball", this->to_.failure());
  EXPECT_EQ(0U, this->to_.frames());
  EXPECT_FALSE(this->step(this->to_));
  this->send(sender, 2);
  this->send(sender, 3);
  EXPECT_TRUE(this->mayBegin(this->from_));
}

TYPED_TEST_P(TransportConformance, aReceiverCanBeGivenAnotherSenderAndKeepsItsValue) {
  TestProcess next("next", this->clock_);
  Sender<Ball> sender(this->from_, "ball", Blocking::kNo);
  Sender<Ball> nextSender(next, "ball", Blocking::kNo);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  this->connect(sender, receiver);
  this->send(sender, 1);
  EXPECT_TRUE(this->step(this->to_));
  this->connect(nextSender, receiver);
  this->send(sender, 2);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_EQ(1, numberIn(receiver));
  EXPECT_FALSE(sender.connected());
  this->send(nextSender, 3);
  EXPECT_TRUE(this->step(this->to_));
  EXPECT_EQ(3, numberIn(receiver));
  EXPECT_EQ("next", receiver.peer());
}

TYPED_TEST_P(TransportConformance, periodsDoNotDrift) {
  using namespace std::chrono_literals;
  Sender<Ball> sender(this->from_, "ball", Blocking::kNo);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  this->connect(sender, receiver);
  this->to_.setPeriod(20ms);
  std::vector<int> ran;  // ms; the clock has steps of 8 ms, so that each frame is late by up to 7 ms
  for (int ms = 0; ms <= 200; ms += 8, this->clock_.advance(8ms)) {
    this->send(sender, ms);
    if (this->step(this->to_)) ran.push_back(ms);
  }
  EXPECT_EQ((std::vector<int>{0, 24, 40, 64, 80, 104, 120, 144, 160, 184, 200}), ran);
}

TYPED_TEST_P(TransportConformance, aPeriodAndABlockingEndAreBothRequired) {
  using namespace std::chrono_literals;
  Sender<Ball> sender(this->from_, "ball", Blocking::kNo);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kYes);
  this->connect(sender, receiver);
  this->to_.setPeriod(20ms);
  this->send(sender, 1);
  EXPECT_TRUE(this->step(this->to_));
  this->send(sender, 2);
  EXPECT_FALSE(this->step(this->to_));
  EXPECT_EQ("its period", this->to_.waitsFor());
  this->clock_.advance(20ms);
  EXPECT_TRUE(this->step(this->to_));
  this->clock_.advance(20ms);
  EXPECT_FALSE(this->step(this->to_));
}

TYPED_TEST_P(TransportConformance, aWaitingProcessIsWokenByAPackage) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kYes);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kYes);
  Sender<Ball> answer(this->to_, "answer", Blocking::kYes);
  Receiver<Ball> answerReceiver(this->from_, "answer", Blocking::kYes);
  this->connect(sender, receiver);
  this->connect(answer, answerReceiver);
  constexpr int kRounds = 200;
  this->to_.body = [&] { answer.send(ball(numberIn(receiver) + 1)); };
  std::thread thread([&] {
    while (this->to_.waitForFrame(std::chrono::seconds(10))) this->to_.runFrame();
  });
  sender.send(ball(0));
  this->from_.body = [&] { sender.send(ball(numberIn(answerReceiver))); };
  for (int i = 0; i < kRounds && this->from_.waitForFrame(std::chrono::seconds(10)); ++i)
    this->from_.runFrame();
  EXPECT_EQ(kRounds, numberIn(answerReceiver));
  this->to_.stop();
  thread.join();
  EXPECT_EQ(0U, receiver.missed());
}

TYPED_TEST_P(TransportConformance, aProcessThatWaitsCanBeStopped) {
  Sender<Ball> sender(this->from_, "ball", Blocking::kYes);
  Receiver<Ball> receiver(this->to_, "ball", Blocking::kNo);
  Receiver<Ball> never(this->to_, "never", Blocking::kYes);
  this->connect(sender, receiver);
  this->send(sender, 1);
  this->send(sender, 2);  // to_ has no thread yet, so nobody takes the first one
  std::atomic<int> ended{0};
  const auto wait = [&ended](Process* process) {
    if (!process->waitForFrame(std::chrono::seconds(60))) ++ended;
  };
  std::thread sending(wait, &this->from_);
  this->from_.stop();
  sending.join();
  std::thread receiving(wait, &this->to_);
  this->to_.stop();
  receiving.join();
  EXPECT_EQ(2, ended);
}

REGISTER_TYPED_TEST_SUITE_P(
    TransportConformance, whatIsSentArrivesOnceAndStays, theNewestWinsAndTheOthersAreCountedAsMissed,
    aBlockingReceiverNeedsANewPackageForEachFrame, aNewerPackageReplacesOneThatWasTakenButNotUsed,
    allBlockingEndsAreRequired, aBlockingSenderWaitsForARequest, aBlockingSenderWaitsForItsSlowestReceiver,
    whatIsSentInPhaseTwoArrivesWhileTheNextIsComputed, tapsSeeEverythingAndHoldNothingBack,
    receiversOfStoppedProcessesNeverCount, whatAStoppedProcessHadDeliveredCanStillBeTaken,
    aProcessThatThrowsStopsAndSetsItsPartnersFree, aReceiverCanBeGivenAnotherSenderAndKeepsItsValue,
    periodsDoNotDrift, aPeriodAndABlockingEndAreBothRequired, aWaitingProcessIsWokenByAPackage,
    aProcessThatWaitsCanBeStopped);

}  // namespace robotlink::test
