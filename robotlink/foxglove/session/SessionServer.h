// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "robotlink/foxglove/server/Server.h"
#include "robotlink/foxglove/session/ImageEncoding.h"
#include "robotlink/foxglove/session/KeyRequests.h"
#include "robotlink/foxglove/session/ModuleParameters.h"
#include "robotlink/foxglove/session/NarrowLines.h"
#include "robotlink/foxglove/session/Steering.h"
#include "robotlink/session/Session.h"

namespace robotlink::websocket {

class PostedWork;

/// Offers a session to clients of the Foxglove WebSocket protocol: robots and worlds, simulated, real or
/// logged, as the session has them.
///
/// - Each stream (robotlink/session/STREAMS.md) is a channel of the same path, encoded as protobuf. So is
///   what a debug key would publish: the key is switched on while a client subscribes (KeyRequests). Streams
///   without subscribers are not serialized.
/// - Each request is a service (RequestServices.h); its answer is the result. Those that let a robot move are
///   granted to one client at a time (Steering), which "red1/steer" takes over. STOP is open to all.
/// - Messages of clients on "red1/remote/motion" and the like steer the robot, too (ClientCommands.h).
/// - Debug keys and solutions are parameters: "red1/keys/ball-percept/disc" is "off", "always", "5 times",
///   "every 3" or "every 200 ms"; "red1/solutions/ball-percept" is the name of a solution. So are the fields
///   of solutions' parameters (ModuleParameters).
/// - It publishes to the session which client steers ("red1/steering"), and which ones use a debug key
///   ("red1/tables/subscribers").
/// - The processes and their packages are the connection graph.
/// - A log that is open can be played.
///
/// One thread, that of Session::tick(); what clients ask for is done by tick().
class SessionServer {
 public:
  /// Sentences for the robot's log: clients that were refused, and why. Called by the link's thread.
  using Report = std::function<void(const std::string&)>;

  /// `session` must outlive this object.
  explicit SessionServer(Session& session, ServerOptions options = {}, Report report = {},
                         Steering::Limits steering = {});
  /// Keys that clients switched on get their modes back, and robots that clients steered stand.
  ~SessionServer();
  SessionServer(const SessionServer&) = delete;
  SessionServer& operator=(const SessionServer&) = delete;

  /// Keyed by kJpegChannel and kPngChannel.
  using ImageEncoders = std::map<std::string, ImageEncoder>;
  /// Adds channels to each channel of images, "red1/camera/image/jpeg", for slow links. Images are
  /// encoded once for all clients, while there are subscribers, in a separate thread. Call it once.
  void setImageEncoders(ImageEncoders encoders);
  /// Blocks until all images that tick() has taken are encoded.
  void finishImages();

  /// Stops offering clients this request to the world ("control_recording"), because nothing fulfills it
  /// here. A service that is called all the same is unknown.
  void withhold(const std::string& request);

  /// A stream on which clients may publish for other receivers than the robots' programs.
  struct ClientStream {
    /// "body/commands" for "red1/body/commands".
    std::string stream;
    /// The type of its messages, which are encoded as protobuf.
    std::string type;
    /// Called by tick() with the newest message of a client; returns why it is refused, empty if it is not.
    std::function<std::string(const ClientInfo& client, const std::string& robot, const std::string& payload)>
        take;
  };
  void takeFromClients(ClientStream stream) { clientStreams_.push_back(std::move(stream)); }

  /// Called when a client takes over a robot whose program is elsewhere, or gives it up: this session is only
  /// one of those who may steer it.
  void onSteerElsewhere(std::function<void(const std::string& robot, bool giveUp)> handler) {
    steerElsewhere_ = std::move(handler);
  }

  /// Whether a client subscribes to a stream.
  bool isWanted(const std::string& path) const;

  /// For a Listener.
  const std::shared_ptr<Server>& server() const { return server_; }

  /// The local user takes control of a robot, even if a client has it, or gives control up.
  void steer(const std::string& robot, bool giveUp);
  /// Does what clients asked for since the last time, and announces what is new. Call it after
  /// Session::tick().
  void tick();

 private:
  using Posted = PostedWork;
  /// A robot of the session, or with an empty name the world, as clients know it.
  struct Robot {
    std::vector<std::uint32_t> services;
    /// The names of its parameters, by group ("keys", "solutions").
    std::map<std::string, std::set<std::string>> parameters;
    /// Requests for parameters of solutions that have no answer yet.
    int asking = 0;
    /// The clients by key, as they were published.
    std::map<std::string, std::set<std::string>> subscribers;
    /// The newest tables of its processes and keys.
    robotcontrol::ProcessTable processes;
    robotcontrol::KeyTable keys;
    /// The keys that are on only for subscribers, as tables said last.
    std::set<std::string> onDemand;
    /// The robot's processes, with ids such as "red1/cognition", by package.
    ConnectionGraph graph;
  };

  ServerHandlers handlers(Report report);
  Steering::Actions steeringActions();
  // From the session.
  void addChannels(std::vector<ChannelSetup> setups);
  /// Removes the channel of a path, because its type is another one now; false: not so soon again.
  bool removeOutdated(const std::string& path);
  /// Has an image published on the channel of one of its codings, if that has subscribers.
  void passEncoded(const StreamMessage& message, const std::string& coding);
  /// The coding of a channel of encoded images; empty if it is none.
  std::string codingOf(const std::string& path) const;
  void pass(const StreamMessage& message);
  void notice(const StreamMessage& message);
  void noticeTable(const std::string& robot, const std::string& stream,
                   const google::protobuf::Message& value);
  /// Publishes the newest messages of streams again, for clients that subscribed in a pause.
  void publishUnheard();
  void updateRobots();
  void removeRobot(const std::string& name, Robot& robot);
  void offerServices(const std::string& robot, Robot& to);
  void offerSteering(const std::string& robot, Robot& to);
  /// Announces the channels of keys that have published nothing yet.
  void offerKeyChannels(const std::string& robot, const Robot& from);
  /// Replaces a group of parameters; `values` by their names in it.
  void offerParameters(const std::string& robot, Robot& to, const std::string& group,
                       const std::map<std::string, std::string>& values);
  /// Says whether there is a log, and where it stands.
  void offerPlayback();
  /// `requestId`: that of the client's request that this answers; empty: of none.
  void publishPlayback(bool didSeek, const std::string& requestId);
  /// Says which keys are on only for subscribers; tables of keys show these as off.
  void offerOnDemand(const std::string& robot);
  void noticeProcesses(const std::string& robot, const robotcontrol::ProcessTable& table, Robot& to);
  /// The connection graph is that of all robots.
  void offerGraph();
  // React to clients' actions.
  void getParameters();
  /// Offers JPEG to clients whose lines do not carry raw images.
  void offerJpeg();
  void watchLinks();
  void publishSubscribers();
  void publishSteering(const std::string& robot, const Steering::Status& status);
  /// Whether the session has the robot from another server.
  bool isElsewhere(const std::string& robot) const { return session_.remoteRobots().contains(robot); }
  /// Returns the package that clients receive on a stream: the other server knows who steers a remote robot,
  /// and this one knows which of its clients that is.
  PackagePtr shownTo(const StreamMessage& message) const;
  /// A table of keys as clients see it: with the modes that they have without subscribers.
  PackagePtr withOwnModes(const std::string& robot, const robotcontrol::KeyTable& table) const;
  // From clients.
  using ServiceHandlerOf = void (SessionServer::*)(const std::string& robot, const std::string& service,
                                                   const ClientInfo& client, const ServiceCallRequest& call,
                                                   const Reply& reply);
  std::uint32_t addService(Service service, const std::string& robot, ServiceAccess access, bool isUrgent,
                           ServiceHandlerOf handler);
  Result<robotcontrol::Request> requestFor(const Parameter& parameter) const;
  Result<std::vector<robotcontrol::Request>> requestsFor(const std::vector<Parameter>& parameters) const;
  void set(const ClientInfo& client, const std::vector<Parameter>& parameters, const Reply& reply);
  /// A client chooses the mode of a key, for as long as it is connected.
  void setKey(const ClientInfo& client, const robotcontrol::Request& wanted,
              std::function<void(const robotcontrol::RequestResult&)> onResult);
  /// The mode of a key that a client has chosen: what the robot is asked for; nothing if it is not asked.
  std::optional<robotcontrol::Request> chosenBy(const ClientInfo& client, robotcontrol::Request request);
  void play(const PlaybackControl& control);
  void noteSet(const robotcontrol::Request& request, bool isAccepted);
  /// Switches a key of a robot for clients; a refusal is reported.
  void setMode(const std::string& robot, const std::string& key, const robotcontrol::KeyMode& mode);
  /// Whether what a key would publish is in the log that is open.
  bool isLogged(const std::string& robot, const std::string& key) const;
  void call(const std::string& robot, const std::string& service, const ClientInfo& client,
            const ServiceCallRequest& call, const Reply& reply);
  void steer(const std::string& robot, const std::string& service, const ClientInfo& client,
             const ServiceCallRequest& call, const Reply& reply);
  void noteClients(const std::vector<ClientInfo>& clients);
  void command(const ClientInfo& client, const ClientChannel& channel, const std::string& payload);
  /// Null: the channel is for the programs.
  const ClientStream* clientStreamOf(const ClientChannel& channel) const;
  /// Returns the problem with a channel that a client has advertised; empty if it is valid.
  std::string problemOf(const ClientChannel& channel) const;
  /// Tells a client what is wrong with what it publishes, if that is news; empty: nothing is.
  void complain(const ClientInfo& client, const std::string& topic, const std::string& why);
  /// Makes a request as a client's, not as a local user's; one that names files is refused. The handler
  /// is called unless this object is gone by then.
  void request(robotcontrol::Request request,
               std::function<void(const robotcontrol::RequestResult&)> onResult);

  Session& session_;
  std::uint64_t listener_ = 0;
  /// The requests of the link's thread.
  std::shared_ptr<Posted> posted_;
  std::shared_ptr<Server> server_;
  KeyRequests keys_;
  Steering steering_;
  ModuleParameters modules_;
  ImageEncoders encoders_;
  /// Null without encoders.
  std::unique_ptr<ImageEncoding> encoding_;
  NarrowLines narrowLines_;
  Instant lookedAtLines_;
  std::vector<ClientStream> clientStreams_;
  /// See withhold().
  std::set<std::string> withheld_;
  std::function<void(const std::string& robot, bool giveUp)> steerElsewhere_;
  std::unordered_map<std::string, ChannelPtr> channels_;
  /// When the channel of a path was replaced last.
  std::map<std::string, Instant> outdated_;
  std::map<std::string, Robot> robots_;
  /// The problems reported to clients about their commands on a topic, so that each is reported once.
  std::map<std::pair<std::uint64_t, std::string>, std::string> complaints_;
  Instant newest_;
  /// Calls of tick() since it was newer than before.
  int stillTicks_ = 0;
  /// Streams that a client subscribed to, and on which nothing was published since.
  std::set<std::string> unheard_;
  /// The status of the log that was published last, and the history's generation() then.
  PackagePtr replay_;
  std::uint64_t generation_ = 0;
  /// Clients' requests to play that the log has not answered yet.
  std::size_t plays_ = 0;
  /// The clients that are there.
  std::set<std::uint64_t> clients_;
  bool isForwarding_ = false;
  /// Whether it is a key's mode that ends with its client.
  bool isChoosing_ = false;
  /// Ends with this object: results may come later.
  const std::shared_ptr<const int> alive_ = std::make_shared<int>();
};

}  // namespace robotlink::websocket
