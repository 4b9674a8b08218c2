// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/transport/TransportStream.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <functional>
#include <optional>
#include <thread>

#include "robotlink/base/Random.h"

namespace robotlink::websocket::test {
namespace {

using asio::ip::tcp;

/// A stream, and a plain socket at its other end.
class TransportStreamTest : public testing::Test {
 protected:
  TransportStreamTest() {
    tcp::acceptor acceptor(context_, {asio::ip::address_v4::loopback(), 0});
    TransportSocket socket(context_);
    socket.connect(acceptor.local_endpoint());
    acceptor.accept(peer_);
    stream_.emplace(std::move(socket));
  }
  /// Writes a text in one go; counts if it is done.
  void write(const std::string& text) {
    stream_->async_write_some(asio::buffer(text), [this](error_code error, std::size_t bytes) {
      EXPECT_FALSE(error);
      ++done_;
      written_ += bytes;
    });
  }
  void run() {
    context_.restart();
    context_.run();
  }
  std::string received(std::size_t bytes) {
    std::string text(bytes, ' ');
    asio::read(peer_, asio::buffer(text));
    return text;
  }

  asio::io_context context_{1};
  tcp::socket peer_{context_};
  std::optional<TransportStream> stream_;
  int done_ = 0;
  std::size_t written_ = 0;
};

TEST_F(TransportStreamTest, smallWritesAreGatheredUntilTheyAreFlushed) {
  stream_->gather(true);
  for (const char* text : {"a", "bc", "def"}) write(text);
  EXPECT_EQ(done_, 3) << "they count as done";
  EXPECT_EQ(peer_.available(), 0U);
  stream_->flush();
  run();
  EXPECT_EQ(received(6), "abcdef");
}

TEST_F(TransportStreamTest, theWriteAfterGatheringTakesAllWithIt) {
  stream_->gather(true);
  write("ab");
  stream_->gather(false);
  EXPECT_EQ(peer_.available(), 0U);
  write("c");
  EXPECT_EQ(done_, 1);
  run();
  EXPECT_EQ(done_, 2);
  EXPECT_EQ(received(3), "abc");
}

TEST_F(TransportStreamTest, noMoreIsGatheredThanItsBound) {
  stream_->gather(true);
  const std::string text(TransportStream::kGatheredBytes / 2 + 1, 'x');
  write(text);
  EXPECT_EQ(done_, 1);
  write(text);
  EXPECT_EQ(done_, 1) << "this one waits for the system";
  run();
  EXPECT_EQ(done_, 2);
  EXPECT_EQ(received(2 * text.size()).size(), 2 * text.size());
}

TEST_F(TransportStreamTest, allArrivesInItsOrder) {
  Random random(7);
  std::string all;
  std::vector<std::string> texts;
  for (int i = 0; i < 3000; ++i) {
    const bool isLarge = random.uniform() < 0.05;
    texts.emplace_back(1 + static_cast<std::size_t>(random.uniform() * (isLarge ? 40'000 : 300)),
                       static_cast<char>('a' + i % 26));
    all += texts.back();
  }
  std::size_t next = 0;
  const std::function<void()> writeNext = [&] {
    if (next == texts.size()) return stream_->flush();
    stream_->gather(next % 7 != 6);
    const std::string& text = texts[next++];
    asio::async_write(*stream_, asio::buffer(text), [&](error_code error, std::size_t bytes) {
      EXPECT_FALSE(error);
      EXPECT_EQ(bytes, text.size());
      asio::post(context_, writeNext);
    });
  };
  std::string arrived;
  std::thread reader([&] { arrived = received(all.size()); });
  writeNext();
  run();
  reader.join();
  EXPECT_TRUE(arrived == all);
}

TEST_F(TransportStreamTest, muchIsReadInSmallPieces) {
  std::string all(300'000, ' ');
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<char>('a' + i % 23);
  std::thread writer([&] { asio::write(peer_, asio::buffer(all)); });
  std::string arrived;
  std::array<char, 3> piece{};
  const std::function<void()> readNext = [&] {
    if (arrived.size() == all.size()) return;
    stream_->async_read_some(asio::buffer(piece), [&](error_code error, std::size_t bytes) {
      ASSERT_FALSE(error);
      arrived.append(piece.data(), bytes);
      readNext();
    });
  };
  readNext();
  run();
  writer.join();
  EXPECT_TRUE(arrived == all);
}

TEST_F(TransportStreamTest, aWriteAfterTheEndOfTheLineFails) {
  peer_.set_option(asio::socket_base::linger(true, 0));
  peer_.close();
  error_code failed;
  for (int i = 0; i < 1000 && !failed; ++i) {
    stream_->gather(true);
    stream_->async_write_some(asio::buffer("x", 1), [&](error_code error, std::size_t) { failed = error; });
    stream_->flush();
    run();
  }
  EXPECT_TRUE(failed);
}

TEST_F(TransportStreamTest, whatIsUnderWayEndsWithTheStream) {
  bool hasEnded = false;
  std::array<char, 8> buffer{};
  stream_->async_read_some(asio::buffer(buffer), [&](error_code error, std::size_t) {
    EXPECT_TRUE(error);
    hasEnded = true;
  });
  stream_.reset();
  run();
  EXPECT_TRUE(hasEnded);
}

}  // namespace
}  // namespace robotlink::websocket::test
