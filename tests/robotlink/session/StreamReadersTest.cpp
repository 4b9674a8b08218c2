// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/StreamReaders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"

using namespace robotlink;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

namespace {

/// A store with the streams "a" and "b", and who reads them.
struct ReadStore {
  StreamStore store{{}};
  StreamReaders readers{store};

  ReadStore() {
    for (const char* path : {"a", "b"})
      store.add({path, Instant(std::chrono::seconds(1)), std::make_shared<robotcontrol::PlotValue>()});
  }
  std::vector<std::string> of(const char* path) { return readers.of(*store.find(path)); }
  void read(const std::string& reader, const char* path) {
    const StreamReaders::Scope reading(readers, reader, reader);
    store.latest(path, Instant::max());
  }
};

TEST(StreamReaders, whoeverLooksAStreamUpReadsIt) {
  ReadStore test;
  test.read("Plots", "a");
  test.read("Image", "a");
  test.store.latest("b", Instant::max());
  EXPECT_THAT(test.of("a"), ElementsAre("Image", "Plots"));
  EXPECT_THAT(test.of("b"), IsEmpty()) << "by nobody who is counted";
}

TEST(StreamReaders, whoNoLongerReadsIsForgottenWithThePeriod) {
  ReadStore test;
  test.read("Plots", "a");
  test.readers.beginPeriod();
  EXPECT_THAT(test.of("a"), IsEmpty());
  test.read("Image", "a");
  EXPECT_THAT(test.of("a"), ElementsAre("Image"));
}

TEST(StreamReaders, aReaderWithinAnotherHasItToItself) {
  ReadStore test;
  {
    const StreamReaders::Scope outer(test.readers, "1", "Outer");
    test.read("Inner", "a");
    test.store.find("b");
  }
  EXPECT_THAT(test.of("a"), ElementsAre("Inner"));
  EXPECT_THAT(test.of("b"), ElementsAre("Outer"));
}

TEST(StreamReaders, aReaderMayChangeItsName) {
  ReadStore test;
  for (const char* name : {"Image: red1", "Image: blue1"}) {
    const StreamReaders::Scope reading(test.readers, "dock", name);
    test.store.find("a");
  }
  EXPECT_THAT(test.of("a"), ElementsAre("Image: blue1"));
}

TEST(StreamReaders, moreReadersThanThereAreNamesForDoNoHarm) {
  ReadStore test;
  for (std::size_t i = 0; i < 3 * StreamReaders::kMaxReaders; ++i)
    test.read("view " + std::to_string(i), "a");
  EXPECT_EQ(test.of("a").size(), StreamReaders::kMaxReaders);
}

TEST(StreamReaders, bytesASecondAreThoseOfTheLastSecond) {
  StreamStore store({});
  for (int i = 0; i <= 100; ++i) {
    auto value = std::make_shared<robotcontrol::PlotValue>();
    value->set_unit(std::string(10'000, 'm'));
    store.add({"a", Instant(std::chrono::milliseconds(40 * i)), std::move(value)});
  }
  EXPECT_NEAR(store.find("a")->byteRate, 25 * 10'500, 25 * 1000);
}

}  // namespace
