// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <future>
#include <mutex>
#include <ostream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <utility>

#include "app/core/ServedPlatform.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "logplayer/record/Recorder.h"

namespace app::test {

/// A remote simulated robot, as `robotctl sim --listen` serves it, with all its services; or another
/// platform. The constructor throws the reason if it cannot be served.
class ServedHall {
 public:
  explicit ServedHall(ServeOptions options = {},
                      PlatformOpening opening = SimulationFeed::opening(defaultSimulation()))
      : served_(std::async(std::launch::async,
                           [this, options = std::move(options), opening = std::move(opening)] {
                             printed_.end(serve(
                                 opening, options, recorder_, [this] { return ended_.load(); }, out_));
                           })),
        url_(printed_.url()) {}
  ~ServedHall() {
    ended_ = true;
    served_.wait();
  }
  ServedHall(const ServedHall&) = delete;
  ServedHall& operator=(const ServedHall&) = delete;

  /// "ws://127.0.0.1:40123"
  const std::string& url() const { return url_; }
  /// Where it listens; for another one at the same place.
  robotlink::websocket::ListenAddress address() const { return {"127.0.0.1", port()}; }
  std::uint16_t port() const {
    return static_cast<std::uint16_t>(std::stoi(url_.substr(url_.rfind(':') + 1)));
  }

 private:
  /// What the robot prints, up to the line that says where it is.
  class Printed : public std::streambuf {
   public:
    /// Waits for that line; throws if nothing is served any more.
    std::string url() { return url_.get_future().get(); }
    void end(const robotlink::Errors& errors) {
      if (std::exchange(isTold_, true)) return;
      url_.set_exception(std::make_exception_ptr(std::runtime_error(describe(errors))));
    }

   protected:
    int_type overflow(int_type c) override {
      if (c != '\n') {
        line_ += static_cast<char>(c);
        return c;
      }
      const std::size_t at = line_.find(" at ws");
      if (at != std::string::npos && !isTold_) {
        isTold_ = true;
        url_.set_value(line_.substr(at + 4));
      }
      line_.clear();
      return c;
    }

   private:
    std::string line_;
    bool isTold_ = false;
    std::promise<std::string> url_;
  };

  Printed printed_;
  std::ostream out_{&printed_};
  logplayer::Recorder recorder_{{}};
  std::atomic<bool> ended_{false};
  std::future<void> served_;
  const std::string url_;
};

}  // namespace app::test
