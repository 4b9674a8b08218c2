// SPDX-License-Identifier: GPL-3.0-or-later
// Foglove's own clients for JavaScript, unchanged, with our server.
#include <gmock/gmock.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "robotlink/foxglove/server/Listener.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"

namespace robotlink::websocket::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

const std::string kScript = ROBOTCONTROL_SOURCE_DIR "/tests/robotlink/foxglove/foxglove_client.mjs";

/// A program of node that runs until it ends by itself or is terminated.
class NodeProgram {
 public:
  explicit NodeProgram(std::vector<std::string> words) {
    int ends[2] = {-1, -1};
    if (::pipe(ends) != 0) return;
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    ::posix_spawn_file_actions_addclose(&actions, ends[0]);
    words.insert(words.begin(), "node");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    if (::posix_spawnp(&process_, "node", &actions, nullptr, arguments.data(), environ) != 0) process_ = -1;
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    reader_ = std::thread([this, from = ends[0]] {
      char buffer[4096];
      for (ssize_t count; (count = ::read(from, buffer, sizeof buffer)) > 0;) {
        const std::lock_guard lock(mutex_);
        output_.append(buffer, static_cast<std::size_t>(count));
      }
      ::close(from);
    });
  }
  ~NodeProgram() {
    interrupt();
    finish();
  }
  NodeProgram(const NodeProgram&) = delete;
  NodeProgram& operator=(const NodeProgram&) = delete;

  void interrupt() {
    if (process_ > 0) ::kill(process_, SIGTERM);
  }
  /// Waits for its end, and returns its exit status.
  int finish() {
    if (reader_.joinable()) reader_.join();
    if (process_ > 0 && ::waitpid(std::exchange(process_, -1), &status_, 0) < 0) status_ = -1;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
  }
  std::string output() {
    const std::lock_guard lock(mutex_);
    return output_;
  }
  bool says(const std::string& text) {
    return eventually([&] { return output().find(text) != std::string::npos; });
  }

 private:
  pid_t process_ = -1;
  int status_ = -1;
  std::mutex mutex_;
  std::string output_;
  std::thread reader_;
};

class FoxgloveInterop : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    NodeProgram check({kScript, "--check"});
    status_ = check.finish();
    examples_ = check.output().substr(0, check.output().find('\n'));
  }
  void SetUp() override {
    if (status_ != 0)
      GTEST_SKIP() << "it takes node with the packages @foxglove/ws-protocol, @foxglove/ws-protocol-examples "
                      "and ws: npm install "
                      "them anywhere, and set ROBOTCONTROL_NODE_MODULES to the folder node_modules there ("
                   << examples_ << ")";
    ServerHandlers handlers;
    handlers.clientMessage = [this](const ClientInfo&, const ClientChannel& channel,
                                    std::string_view payload) {
      server_->publishStatus({StatusLevel::kInfo, channel.topic + " " + std::string(payload), ""});
      ++messages_;
    };
    handlers.setParameters = [this](const ClientInfo&, const std::vector<Parameter>& parameters,
                                    const Reply& reply) {
      server_->updateParameters(parameters);
      reply.succeed();
    };
    ServerOptions options;
    options.name = "red1";
    options.publishesTime = true;
    server_ = Server::make(options, handlers);
    channel_ = server_->addChannels(
        {{"red1/log", "json", "Log", R"({"type":"object"})", "jsonschema", Delivery::kComplete, 10'000}})[0];
    server_->addService({0,
                         "set",
                         "std_srvs/SetBool",
                         {"json", "Request", "jsonschema", "{}"},
                         {"json", "Response", "jsonschema", "{}"}},
                        [](const ClientInfo&, const ServiceCallRequest&, const Reply& reply) {
                          reply.succeed(R"({"success":true})");
                        });
    server_->updateParameters({{"flag", Value{true}}, {"speed", Value{3.0}}});
    server_->setConnectionGraph({{{"red1/log", {"cognition"}}}, {}, {}});
    Listener::Options listening;
    listening.address.port = 0;
    listener_ = Listener::open(server_, listening).value();
    url_ = "ws://" + toString(listener_->address());
  }
  void publish(int count) {
    for (int i = 0; i < count; ++i)
      channel_->publish(Instant(Duration(1000 + i)), R"({"text":")" + std::to_string(i) + "\"}");
  }
  /// Closes the only client's connection when all was sent.
  void dismissClient() {
    EXPECT_TRUE(eventually([&] { return server_->clients().at(0).waitingBytes == 0; }));
    server_->disconnect(server_->clients().at(0).info.id, "done");
  }

  static inline int status_ = -1;
  static inline std::string examples_;
  std::atomic<int> messages_{0};
  std::shared_ptr<Server> server_;
  ChannelPtr channel_;
  std::unique_ptr<Listener> listener_;
  std::string url_;
};

TEST_F(FoxgloveInterop, theirClientUnderstandsAllThatWeSayAndWeIt) {
  NodeProgram client({kScript, url_});
  EXPECT_TRUE(eventually([&] { return channel_->isWanted(); })) << client.output();
  publish(1);
  server_->publishTime(Instant(Duration(77)));
  for (const char* line :
       {"serverInfo foxglove.sdk.v1 red1 parameters parametersSubscribe services connectionGraph time "
        "clientPublish",
        R"(channel red1/log {"type":"object"})", "service set Request", R"(answer 7 json {"success":true})",
        R"(message 1000 {"text":"0"})", "time 77",
        R"(graph [{"name":"red1/log","publisherIds":["cognition"]}])",
        R"(parameters all [{"name":"flag","value":true},{"name":"speed","type":"float64","value":3})",
        "asset 1 1 this robot offers no files", R"(status 0 drive {"speed":1})"})
    EXPECT_TRUE(client.says(line)) << line << "\n" << client.output();
  dismissClient();
  EXPECT_TRUE(client.says("status 2 done") && client.says("close"));
  EXPECT_EQ(client.finish(), 0);
}

TEST_F(FoxgloveInterop, mcapRecordRecordsEveryMessage) {
  const TestFolder folder;
  const std::string file = (folder.path() / "log.mcap").string();
  NodeProgram recorder({examples_, "mcap-record", "-o", file, "-n", url_});
  EXPECT_TRUE(eventually([&] { return channel_->isWanted(); })) << recorder.output();
  publish(500);
  dismissClient();
  EXPECT_EQ(recorder.finish(), 0) << recorder.output();
  std::ifstream stream(file, std::ios::binary);
  const std::string log{std::istreambuf_iterator<char>(stream), {}};
  for (int i = 0; i < 500; ++i) EXPECT_THAT(log, HasSubstr(R"({"text":")" + std::to_string(i) + "\"}"));
}

TEST_F(FoxgloveInterop, paramClientSetsAParameterAndHearsOfIt) {
  NodeProgram client({examples_, "param-client", url_});
  EXPECT_TRUE(client.says("name: 'flag', value: false")) << client.output();
}

TEST_F(FoxgloveInterop, publishClientPublishes) {
  NodeProgram client({examples_, "publish-client", url_});
  EXPECT_TRUE(eventually([&] { return messages_ >= 1; })) << client.output();
}

TEST_F(FoxgloveInterop, serviceClientGetsItsAnswer) {
  NodeProgram client({examples_, "service-client", url_});
  EXPECT_EQ(client.finish(), 0);
  EXPECT_THAT(client.output(), HasSubstr("{ success: true }"));
}

TEST_F(FoxgloveInterop, perfTestClientCountsEveryMessage) {
  NodeProgram client({examples_, "perf-test-client", url_});
  EXPECT_TRUE(eventually([&] { return channel_->isWanted(); })) << client.output();
  publish(5000);
  dismissClient();
  EXPECT_EQ(client.finish(), 0);
  EXPECT_THAT(client.output(), HasSubstr("5000"));
}

}  // namespace
}  // namespace robotlink::websocket::test
