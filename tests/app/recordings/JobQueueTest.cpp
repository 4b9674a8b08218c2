// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/recordings/JobQueue.h"

#include <gmock/gmock.h>

#include <future>
#include <memory>
#include <vector>

#include "tests/Eventually.h"

namespace app {
namespace {

using testing::ElementsAre;

/// Jobs that note that they were done; the first one waits until it may go on.
class JobQueueTest : public testing::Test {
 protected:
  JobQueue::Job note(int number) {
    return [this, number] {
      const std::lock_guard lock(mutex_);
      done_.push_back(number);
    };
  }
  /// Adds a job that is in progress until mayGoOn_ is fulfilled.
  void block() {
    jobs_.add([this, going = mayGoOn_.get_future().share()] {
      hasBegun_.set_value();
      going.wait();
      note(0)();
    });
    hasBegun_.get_future().wait();
  }
  std::vector<int> done() {
    const std::lock_guard lock(mutex_);
    return done_;
  }

  std::promise<void> hasBegun_, mayGoOn_;
  std::mutex mutex_;
  std::vector<int> done_;
  JobQueue jobs_;
};

TEST_F(JobQueueTest, allJobsAreDoneInTheirOrder) {
  block();
  for (int number = 1; number <= 3; ++number) jobs_.add(note(number));
  mayGoOn_.set_value();
  ASSERT_TRUE(eventually([this] { return done().size() == 4; }));
  EXPECT_THAT(done(), ElementsAre(0, 1, 2, 3));
  jobs_.add(note(4));
  EXPECT_TRUE(eventually([this] { return done().size() == 5; })) << "also after a rest";
}

TEST_F(JobQueueTest, whatHasNotBegunIsDroppedAndWhatIsAddedLaterIsDone) {
  block();
  jobs_.add(note(1));
  jobs_.clear();
  jobs_.add(note(2));
  mayGoOn_.set_value();
  ASSERT_TRUE(eventually([this] { return done().size() == 2; }));
  EXPECT_THAT(done(), ElementsAre(0, 2));
}

TEST_F(JobQueueTest, aClosedQueueHasEndedTheJobInProgressAndDoesNoOther) {
  block();
  jobs_.add(note(1));
  auto closing = std::async(std::launch::async, [this] { jobs_.close(); });
  mayGoOn_.set_value();
  closing.get();
  ASSERT_FALSE(done().empty());
  EXPECT_EQ(done().front(), 0);
  const auto atTheEnd = done();
  jobs_.add(note(2));
  jobs_.close();
  EXPECT_EQ(done(), atTheEnd);
}

TEST_F(JobQueueTest, aJobMayAddAnother) {
  jobs_.add([this] {
    jobs_.add(note(2));
    note(1)();
  });
  ASSERT_TRUE(eventually([this] { return done().size() == 2; }));
  EXPECT_THAT(done(), ElementsAre(1, 2));
}

TEST_F(JobQueueTest, whatADroppedJobHoldsMayUseTheQueueWhenItEnds) {
  block();
  struct Held {
    explicit Held(std::function<void()> atEnd) : end(std::move(atEnd)) {}
    ~Held() { end(); }
    std::function<void()> end;
  };
  jobs_.add([held = std::make_shared<Held>([this] { jobs_.add(note(1)); })] {});
  jobs_.clear();
  mayGoOn_.set_value();
  EXPECT_TRUE(eventually([this] { return done().size() == 2; }));
}

}  // namespace
}  // namespace app
