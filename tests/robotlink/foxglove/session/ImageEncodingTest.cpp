// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/ImageEncoding.h"

#include <gmock/gmock.h>

#include <atomic>

#include "foxglove/Image.pb.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/server/Server.h"

namespace robotlink::websocket::test {
namespace {

using testing::ElementsAre;

/// A channel with one subscriber, and an encoder that waits until it may go on.
class ImageEncodingTest : public testing::Test {
 protected:
  ImageEncodingTest() {
    const Frame frame = encode(ClientMessage(Subscribe{{{1, channel_->id()}}}));
    server_->received(client_, frame.kind, frame.bytes);
    sentTimes();
  }
  ~ImageEncodingTest() override { release(); }
  void post(int number) {
    encoding_.post(channel_, Instant(Duration(number)), std::make_shared<foxglove::RawImage>(), encoder_);
  }
  void release() {
    mayGoOn_ = true;
    mayGoOn_.notify_all();
  }
  /// The times of the images that were sent since the last call.
  std::vector<int> sentTimes() {
    std::vector<int> times;
    while (const auto next = server_->next(*client_, Instant())) {
      if (next->headSize != kMessageHeadSize) continue;
      const std::string bytes =
          std::string(reinterpret_cast<const char*>(next->head.data()), next->headSize) + *next->payload;
      const ServerMessage message = decodeServerMessage(next->kind, bytes).value();
      times.push_back(static_cast<int>(std::get<MessageData>(message).time.time_since_epoch().count()));
    }
    return times;
  }
  StreamCounters counters() const { return client_->outbox.counters(channel_->id()); }

  const std::shared_ptr<Server> server_ = Server::make({}, {});
  const ClientPtr client_ = *server_->connect({0, "127.0.0.1:1", "x"}, [] {});
  // All that are sent wait, so that only those count as thinned that were not encoded.
  const ChannelPtr channel_ =
      server_->addChannels({{"a/jpeg", "protobuf", "", "", {}, Delivery::kComplete}})[0];
  std::atomic<bool> mayGoOn_{false}, hasBegun_{false}, fails_{false};
  const ImageEncoder encoder_ = [this](const auto&) -> PackagePtr {
    hasBegun_ = true;
    hasBegun_.notify_all();
    mayGoOn_.wait(false);
    if (fails_) throw std::bad_alloc();
    return std::make_shared<foxglove::CompressedImage>();
  };
  // Last, since its thread uses the others.
  ImageEncoding encoding_;
};

TEST_F(ImageEncodingTest, whoHasAnImageDoesNotWaitUntilItIsEncoded) {
  post(1);
  hasBegun_.wait(false);
  EXPECT_THAT(sentTimes(), ElementsAre());
  release();
  encoding_.finish();
  EXPECT_THAT(sentTimes(), ElementsAre(1));
}

TEST_F(ImageEncodingTest, whereImagesComeTooFastTheNewestAreEncodedInOrderAndTheOthersCounted) {
  post(1);
  hasBegun_.wait(false);
  for (int i = 2; i <= 10; ++i) post(i);
  release();
  encoding_.finish();
  EXPECT_THAT(sentTimes(), ElementsAre(1, 7, 8, 9, 10));
  EXPECT_EQ(counters().thinned, 5U);
  EXPECT_EQ(counters().sent, 5U);
}

TEST_F(ImageEncodingTest, nothingIsEncodedForThoseWhoHaveGone) {
  post(1);
  hasBegun_.wait(false);
  post(2);
  server_->disconnected(client_);
  hasBegun_ = false;
  release();
  encoding_.finish();
  EXPECT_FALSE(hasBegun_);
}

TEST_F(ImageEncodingTest, anImageThatCannotBeEncodedIsCountedAndTheNextOneComes) {
  fails_ = true;
  release();
  post(1);
  encoding_.finish();
  fails_ = false;
  post(2);
  encoding_.finish();
  EXPECT_THAT(sentTimes(), ElementsAre(2));
  EXPECT_EQ(counters().thinned, 1U);
}

}  // namespace
}  // namespace robotlink::websocket::test
