// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/platforms/body/BodyClock.h"
#include "app/platforms/body/BodyLink.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/base/BoundedQueue.h"
#include "robotlink/process/Platform.h"

namespace google::protobuf {
class Descriptor;
}

namespace app {

/// The platform of a robot whose body is remote: sends the sensor readings that come over the link, and
/// the newest commands over it as one message, which says what readings they answer. Its time is the body's
/// (BodyClock).
///
/// The owner lets it run a few hundred frames a second. While the line is cut, the program continues with
/// what it knows, and the body's watchdog stops the robot. `link` and `clock` must outlive it; `local`
/// is real time.
class RemoteBodyPlatform final : public robotlink::Platform {
 public:
  /// The link knows its body.
  /// `leftOut` are packages of the body that come and go in another way.
  RemoteBodyPlatform(BodyLink& link, BodyClock& clock, const robotlink::Clock& local,
                     const std::set<std::string>& leftOut = {});
  ~RemoteBodyPlatform() override;

  /// Processes what was received, and sends commands.
  void actuate() override;
  /// Sends the request at once, and repeats it until the body has accepted it. Any thread.
  void engageStop(bool engaged) override;
  /// Whether it is engaged, here or at the body.
  bool stopEngaged() const override { return stopWanted_.load() || stoppedThere_.load(); }
  std::vector<robotlink::AnySender*> onRequest() override;
  /// The request goes to the body; a refusal is reported as a text.
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override;
  robotlink::Result<void> setCamera(const robotcontrol::SetCamera& details) override;

  /// Counts of what was sent and received.
  struct Counts {
    std::uint64_t frames = 0, commands = 0, cuts = 0;
    /// The body's counts: commands of this program that it obeyed, and those that came too late.
    std::uint64_t obeyed = 0, late = 0;
    robotlink::Duration longestSilence{0};
  };
  const Counts& counts() const { return counts_; }
  /// For users: how link and body are.
  std::string describe() const;

 protected:
  /// Sends the packages.
  void execute() override;

 private:
  struct Sensor {
    std::unique_ptr<robotlink::AnySender> sender;
    const google::protobuf::Descriptor* type = nullptr;
    robotlink::PackagePtr waiting = nullptr;
  };
  struct Command {
    std::unique_ptr<robotlink::AnyReceiver> receiver;
    const google::protobuf::Descriptor* type = nullptr;
    /// The number of packages that were sent on.
    std::uint64_t taken = 0;
  };

  void subscribe();
  void takeArrived();
  void takeState(const robotcontrol::BodyState& state);
  void takeSensor(const std::string& package, const robotlink::PackagePtr& value);
  void followConnection();
  void sendCommands();
  bool hasNewCommands();
  void repeatStop(robotlink::Instant now);
  void sendStop(bool engaged);
  void sendStatus(robotlink::Instant now);
  robotlink::Result<void> whetherConnected() const;
  /// A handler that reports why the body refused a request to a part of it.
  std::function<void(const std::string& why)> reportRefusal(const std::string& of);

  BodyLink& link_;
  BodyClock& bodyClock_;
  const robotlink::Clock& local_;
  const double watchdog_;
  std::map<std::string, Sensor> sensors_;
  std::map<std::string, Command> commands_;
  robotlink::Sender<robotcontrol::LinkStatus> status_;
  std::set<std::string> wanted_;
  Counts counts_;
  /// Tells the body the commands of this program from those of others.
  const std::uint64_t sender_;
  std::uint64_t number_ = 0;
  /// The local times at which a command or the status was sent, and the body was last heard.
  robotlink::Instant sentAt_, statusAt_;
  std::optional<robotlink::Instant> heardAt_;
  bool isConnected_ = false, wasConnected_ = false, isOther_ = false;
  /// The newest state of the body; its text was reported.
  std::string bodyText_;
  /// The state of the body's own line, such as a serial one; null: it has none.
  std::shared_ptr<const robotcontrol::LinkStatus> bodyLine_;
  std::atomic<bool> stopWanted_{false}, stoppedThere_{false};
  /// The STOP request that the body has not accepted yet: 0 none, 1 engage, 2 release.
  std::shared_ptr<std::atomic<int>> stopOpen_ = std::make_shared<std::atomic<int>>(0);
  robotlink::Instant stopSentAt_;
  /// From the link's thread, which may be later than the end of this object.
  std::shared_ptr<robotlink::BoundedQueue<std::string>> refusals_ =
      std::make_shared<robotlink::BoundedQueue<std::string>>(20);
};

}  // namespace app
