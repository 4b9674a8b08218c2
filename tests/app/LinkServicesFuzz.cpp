// SPDX-License-Identifier: GPL-3.0-or-later
// What clients ask of the folders that a robot offers: its recordings, and the files that are deployed to it.
// Each call has a byte for its service and two for the length of its argument.
#include <memory>
#include <thread>

#include "app/core/deploy/DeployServices.h"
#include "app/core/recordings/RecordingServices.h"
#include "logplayer/record/Recorder.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/foxglove/protocol/Base64.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"
#include "robotlink/foxglove/security/Digest.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "tests/TestFolder.h"
#include "tests/fuzz/FuzzTarget.h"

namespace link_services_fuzz {

using namespace robotlink::websocket;
namespace fs = std::filesystem;

namespace {

constexpr char kSecret[] = "nobody reads this over a link";
/// As they are offered, from 1.
enum LinkService : std::uint32_t { kList = 1, kRead, kCheck, kDelete, kStart, kStop, kStatus, kFiles, kPut };

/// A folder that is offered, beside one that is not, and links from one to the other.
struct OfferedFolder {
  OfferedFolder() {
    folder.write("secret/a.mcap", kSecret);
    folder.write("robot/a.mcap", std::string(2000, 'a'));
    folder.write("robot/layouts/a.yaml", "a");
    std::error_code ignored;
    fs::create_symlink(folder / "secret/a.mcap", folder / "robot/b.mcap", ignored);
    fs::create_symlink(folder / "secret", folder / "robot/motions", ignored);
  }
  void check() const {
    const auto secret = robotlink::readFile(folder / "secret/a.mcap", 1000);
    require(secret && *secret == kSecret, "what is not offered is not written");
    const auto count = [](const fs::path& where) {
      return std::distance(fs::directory_iterator(where), fs::directory_iterator());
    };
    require(count(folder / "secret") == 1 && count(folder / "robot/..") == 2,
            "nothing is written beside the folder");
  }
  TestFolder folder{TestFolder::Where::kMemory};
};

/// Used for several inputs, until there is much in it.
const OfferedFolder& offered() {
  constexpr std::ptrdiff_t kMaxFiles = 50;
  static std::unique_ptr<OfferedFolder> made;
  const bool isUsed = !made || !fs::exists(made->folder / "robot/a.mcap") ||
                      std::distance(fs::recursive_directory_iterator(made->folder / "robot"),
                                    fs::recursive_directory_iterator()) > kMaxFiles;
  if (isUsed) made = std::make_unique<OfferedFolder>();
  return *made;
}

/// Takes what waits for a client; returns whether an answer to the call was among it.
bool takeAnswers(Server& server, ServedClient& client, std::uint32_t call) {
  bool isAnswered = false;
  while (const auto next = server.next(client, robotlink::Instant())) {
    require(next->payload->find(kSecret) == std::string::npos, "what is not offered is not read");
    const auto message = decodeServerMessage(
        next->kind,
        std::string(reinterpret_cast<const char*>(next->head.data()), next->headSize) + *next->payload);
    if (!message) continue;
    const auto* answer = std::get_if<ServiceCallResponse>(&*message);
    const auto* refusal = std::get_if<ServiceCallFailure>(&*message);
    isAnswered = isAnswered || (answer && answer->callId == call) || (refusal && refusal->callId == call);
  }
  return isAnswered;
}

void callService(Server& server, const ClientPtr& client, std::uint32_t service, std::uint32_t id,
                 std::string_view argument) {
  const Frame frame = encode(ClientMessage(ServiceCallRequest{service, id, "json", argument}));
  server.received(client, frame.kind, frame.bytes);
}

std::string framedCall(std::uint32_t service, const std::string& argument) {
  return std::string{static_cast<char>(service), static_cast<char>(argument.size() & 255U),
                     static_cast<char>(argument.size() >> 8U)} +
         argument;
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const OfferedFolder& place = offered();
  const fs::path folder = place.folder / "robot";
  logplayer::Recorder recorder({});
  const auto server = Server::make({}, {});
  {
    const app::RecordingServices recordings(server, app::RecordingFolder(folder), recorder);
    const app::DeployServices deployment(server, app::ResourceFolder(folder));
    const ClientPtr client = server->connect({0, "1:1", "a"}, [] {}).value();
    robotlink::ByteReader reader(std::span(data, size));
    std::uint32_t id = 0;
    while (reader.good() && !reader.rest().empty()) {
      const auto service = reader.take<std::uint8_t>();
      const auto argument = reader.take(reader.take<std::uint16_t>() % 4096U);
      callService(*server, client, service % 10U, ++id,
                  {reinterpret_cast<const char*>(argument.data()), argument.size()});
      takeAnswers(*server, *client, id);
    }
    // Jobs are done in their order: when these are answered, all are.
    const ClientPtr last = server->connect({0, "2:2", "b"}, [] {}).value();
    for (const std::uint32_t service : {kStatus, kFiles}) {
      callService(*server, last, service, service, "{}");
      while (!takeAnswers(*server, *last, service)) std::this_thread::yield();
    }
    takeAnswers(*server, *client, 0);
  }
  place.check();
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  const std::string content = "a: 1\n";
  const std::string sent =
      R"("content": ")" + toBase64(content) + R"(", "sha256": ")" + sha256(content) + "\"";
  std::vector<std::string> seeds;
  std::string all;
  for (const char* name :
       {"a.mcap", "b.mcap", "../secret/a.mcap", "/etc/passwd", ".mcap", "a.mcap\\u0000", "motions/a.mcap"}) {
    const std::string named = R"("name": ")" + std::string(name) + "\"";
    std::string talk = framedCall(kRead, "{" + named + R"(, "offset": 10, "bytes": 18446744073709551615})");
    talk += framedCall(kCheck, "{" + named + R"(, "bytes": 1000})");
    seeds.push_back(talk + framedCall(kDelete, "{" + named + "}"));
    all += talk;
  }
  for (const char* path : {"layouts/b.yaml", "layouts/../../secret/a.mcap", "motions/b.mof", "/tmp/a.yaml",
                           "layouts//b.yaml", "./layouts/b.yaml", "parameters/x/b.textproto"}) {
    seeds.push_back(framedCall(kPut, R"({"path": ")" + std::string(path) + "\", " + sent + "}"));
    all += seeds.back();
  }
  all += framedCall(kStart, "{}") + framedCall(kList, "{}") + framedCall(kStop, "{}");
  seeds.push_back(all + framedCall(kFiles, "{}"));
  return seeds;
}

const FuzzRegistration kTarget({"link_services", &fuzzSeeds, &runInput});

}  // namespace link_services_fuzz
