// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/BodyLink.h"

#include "app/core/remote/BodyStreams.h"
#include "app/core/remote/ImageCodings.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Schema.h"

namespace app {

using robotcontrol::BodyCommands;
using robotcontrol::BodyOffer;
using robotcontrol::BodyState;
using robotlink::websocket::Client;
using robotlink::websocket::SessionClient;
namespace streams = robotlink::streams;

namespace {

/// The maximum number of texts of a body that wait to be taken.
constexpr std::size_t kMaxTexts = 100;
constexpr robotlink::StreamStore::Limits kBodyHistory{std::chrono::seconds(1), 16U << 20U};

/// "red1" and "camera/image" of "red1/camera/image".
std::pair<std::string, std::string> partsOf(const std::string& path) {
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) return {{}, path};
  return {path.substr(0, slash), path.substr(slash + 1)};
}

}  // namespace

BodyLink::BodyLink(Options options) : wantedRobot_(std::move(options.robot)), session_(kBodyHistory) {
  SessionClient::Options linked;
  linked.connection = std::move(options.connection);
  linked.convert = decodedImage;
  linked.alsoWanted = [this](const std::string& path) { return wants(path); };
  // Other streams, such as the poses of a whole world, would keep a slow link busy.
  linked.wantsNothingElse = true;
  linked.passed = [this](const robotlink::StreamMessage& message) { look(message); };
  client_ = std::make_unique<SessionClient>(session_, std::move(linked));
  limit(options.limits);
}

BodyLink::~BodyLink() = default;

void BodyLink::tick() {
  client_->tick();
  session_.tick();
  followLine();
  if (!body_) lookForBody();
}

void BodyLink::followLine() {
  const auto state = client_->state();
  if (state.roundTrip == roundTrip_) return;
  roundTrip_ = state.roundTrip;
  // The next connection may have another line.
  if (!roundTrip_) line_ = {};
  const double before = line_.bytesPerSecond();
  if (roundTrip_) line_.measured(*roundTrip_, state.bytesPerSecond);
  if (line_.bytesPerSecond() != before) applyLimits();
}

void BodyLink::applyLimits() {
  LinkLimits limits = limits_;
  const double line = line_.bytesPerSecond();
  if (line > 0 && (limits.bytesPerSecond == 0 || line < limits.bytesPerSecond)) limits.bytesPerSecond = line;
  apply(limits, *client_);
}

void BodyLink::limit(const LinkLimits& limits) {
  if (std::exchange(limits_, limits) != limits) applyLimits();
}

bool BodyLink::wants(const std::string& path) const {
  const auto [robot, stream] = partsOf(path);
  if (stream == kBodyOffer || stream == streams::kProgram) return true;
  return body_ && robot == body_->offer.robot() &&
         (stream == kBodyState || stream == streams::kLog || packages_.contains(stream));
}

void BodyLink::look(const robotlink::StreamMessage& message) {
  const auto [robot, stream] = partsOf(message.path);
  if (stream == kBodyOffer) {
    if (const auto* offer = dynamic_cast<const BodyOffer*>(message.value.get())) {
      offers_[robot] = *offer;
      offers_[robot].set_robot(robot);
    }
    if (body_ && robot == body_->offer.robot())
      isOther_ = offers_[robot].SerializeAsString() != body_->offer.SerializeAsString();
  } else if (stream == streams::kProgram) {
    setups_[robot] = message.value;
  }
  if (!body_ || robot != body_->offer.robot()) return;
  if (stream == kBodyState) {
    if (auto state = std::dynamic_pointer_cast<const BodyState>(message.value)) arrived_.state = state;
  } else if (stream == streams::kLog) {
    const auto* text = dynamic_cast<const foxglove::Log*>(message.value.get());
    // The body's state already says whether it stands still, and why.
    if (text != nullptr && text->name() != "program" && arrived_.texts.size() < kMaxTexts)
      arrived_.texts.push_back(text->name() + ": " + text->message());
  } else if (packages_.contains(stream)) {
    arrived_.sensors[stream] = message.value;
  }
}

void BodyLink::lookForBody() {
  const auto offer = wantedRobot_.empty() ? offers_.begin() : offers_.find(wantedRobot_);
  if (offer == offers_.end()) return;
  const auto setup = setups_.find(offer->first);
  if (setup == setups_.end()) return;
  const auto program = std::dynamic_pointer_cast<const robotcontrol::ProgramSetup>(setup->second);
  if (!program) return;
  body_ = Body{offer->second, knownRobot(*program), program};
  client_->client().advertise({0, offer->first + "/" + kBodyCommands, "protobuf",
                               BodyCommands::descriptor()->full_name(),
                               robotlink::schemaOf(*BodyCommands::descriptor()), "protobuf"});
  client_->updateSubscriptions();
}

BodyLink::Kind BodyLink::kindOf(const std::string& robot) const {
  const auto found = setups_.find(robot);
  const auto* setup =
      found == setups_.end() ? nullptr : dynamic_cast<const robotcontrol::ProgramSetup*>(found->second.get());
  if (setup == nullptr) return Kind::kUnknown;
  return setup->is_body() ? Kind::kBody : Kind::kWithProgram;
}

std::uint64_t BodyLink::progress() const {
  // The names of the robots come behind many channels. What this end asks for from time to time is less than
  // that.
  constexpr std::uint64_t kPart = 4096;
  const std::size_t known = robots().size() + setups_.size() + offers_.size();
  return known > 0 ? known : state().bytes / kPart;
}

void BodyLink::want(const std::set<std::string>& packages) {
  packages_ = packages;
  client_->updateSubscriptions();
}

void BodyLink::send(const BodyCommands& commands) {
  if (body_)
    client_->client().publish(body_->offer.robot() + "/" + kBodyCommands, commands.SerializeAsString());
}

void BodyLink::engageStop(bool engaged, std::function<void(const std::string&)> done) {
  robotcontrol::Stop stop;
  stop.set_engaged(engaged);
  call("stop", stop.SerializeAsString(), true, std::move(done));
}

void BodyLink::control(const robotcontrol::ControlDrive& details,
                       std::function<void(const std::string&)> done) {
  call("control_drive", details.SerializeAsString(), false, std::move(done));
}

void BodyLink::setCamera(const robotcontrol::SetCamera& details,
                         std::function<void(const std::string&)> done) {
  call("set_camera", details.SerializeAsString(), false, std::move(done));
}

void BodyLink::call(const std::string& service, const std::string& argument, bool isUrgent,
                    std::function<void(const std::string&)> done) {
  if (!body_) return done("its body is not known yet");
  Client::Call call;
  call.service = body_->offer.robot() + "/" + service;
  call.encoding = "protobuf";
  call.payload = argument;
  call.urgency = isUrgent ? Client::Urgency::kUrgent : Client::Urgency::kNormal;
  client_->client().call(
      std::move(call), [done = std::move(done)](const robotlink::Result<Client::Answer>& reply) {
        if (!reply) return done(reply.error().text);
        robotcontrol::RequestResult result;
        const bool isRead = result.ParseFromString(reply->data);
        done(!isRead ? "its answer is not valid" : result.accepted() ? std::string() : result.reason());
      });
}

}  // namespace app
