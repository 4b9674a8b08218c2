// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log fetch`: recordings at a robot.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/core/platform/JsonOutput.h"
#include "app/core/recordings/RecordingFetch.h"
#include "app/robotctl/link/LinkOptions.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "logplayer/base/LogDates.h"
#include "robotlink/base/Printable.h"
#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/Connector.h"

namespace app {
namespace {

using nlohmann::json;
using robotlink::websocket::Client;
using robotlink::websocket::Connector;

struct FetchArguments {
  LinkOptions link;
  std::string name, file;
  bool force = false, removes = false, asJson = false;
};

std::string dateOf(const RecordingFetch::Entry& entry) {
  return logplayer::dateText(robotlink::Instant(robotlink::fromSeconds(entry.modified))).substr(0, 19);
}

int printList(RecordingFetch& fetch, const RecordingFetch::Progress& progress, bool asJson) {
  const auto entries = fetch.list(progress);
  if (!entries) return printErrors({entries.error()});
  if (asJson) {
    json all = json::array();
    for (const auto& entry : *entries) {
      all.push_back({{"name", entry.name},
                     {"bytes", entry.bytes},
                     {"modified", entry.modified},
                     {"recording", entry.isRecording},
                     {"whole", entry.isWhole}});
    }
    std::cout << jsonOutput(json{{"recordings", std::move(all)}});
    return kDone;
  }
  if (entries->empty()) std::cerr << "The robot has no recordings.\n";
  for (const auto& entry : *entries) {
    std::printf("%s UTC  %9.2f MB  %s%s\n", dateOf(entry).c_str(), static_cast<double>(entry.bytes) * 1e-6,
                robotlink::printable(entry.name).c_str(),
                entry.isRecording ? "  (is being recorded)"
                : entry.isWhole   ? ""
                                  : "  (was cut off)");
  }
  return kDone;
}

int fetchOne(RecordingFetch& fetch, const RecordingFetch::Progress& progress, const FetchArguments& arguments,
             TerminalProgress& terminal) {
  const std::string file = arguments.file.empty() ? arguments.name : arguments.file;
  const auto fetched = fetch.fetch(arguments.name, file, arguments.force, progress);
  terminal.erase();
  if (!fetched) {
    if (fetched.error().id != "canceled") return printErrors({fetched.error()});
    std::cerr << file << ".part: what was fetched is kept; the same command continues there\n";
    return kFailed;
  }
  if (arguments.removes) {
    if (const auto removed = fetch.remove(arguments.name, progress); !removed)
      return printErrors({removed.error()});
  }
  if (arguments.asJson) {
    std::cout << jsonOutput(
        json{{"file", file}, {"bytes", fetched->bytes}, {"resumed_at", fetched->resumedAt}});
    return kDone;
  }
  std::fprintf(stderr, "%s: %.2f MB", file.c_str(), static_cast<double>(fetched->bytes) * 1e-6);
  if (fetched->resumedAt > 0)
    std::fprintf(stderr, ", %.2f MB of them from an earlier download",
                 static_cast<double>(fetched->resumedAt) * 1e-6);
  std::cerr << (arguments.removes ? "; deleted on the robot\n" : "\n");
  return kDone;
}

/// False if there is no connection within a few seconds; why is in the client's state.
bool isConnected(const Client& client, const RecordingFetch::Progress& progress) {
  constexpr std::chrono::seconds kLongest(5);
  const auto end = std::chrono::steady_clock::now() + kLongest;
  while (std::chrono::steady_clock::now() < end && progress(0)) {
    if (client.state().isConnected()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

int runFetch(const FetchArguments& arguments) {
  const auto connection = arguments.link.connection();
  if (!connection) {
    printErrors({connection.error()});
    return kUsage;
  }
  const auto client = std::make_shared<Client>(robotlink::websocket::ClientHandlers{});
  const Connector connector(client, *connection);
  TerminalProgress terminal;
  const auto shown = terminal.function();
  // A server that refuses once will refuse again.
  const auto refused = [&] {
    return client->state().phase == robotlink::websocket::ConnectionState::Phase::kRefused;
  };
  const RecordingFetch::Progress progress = [&](double share) { return shown(share) && !refused(); };
  if (!isConnected(*client, progress)) {
    terminal.erase();
    std::cerr << toString(connection->url) << ": " << robotlink::printable(client->state().reason) << "\n";
    return kFailed;
  }
  RecordingFetch fetch(callsOf(*client));
  return arguments.name.empty() ? printList(fetch, progress, arguments.asJson)
                                : fetchOne(fetch, progress, arguments, terminal);
}

}  // namespace

void addLogFetchCommand(CLI::App& log, int& status) {
  const auto arguments = std::make_shared<FetchArguments>();
  CLI::App* command = log.add_subcommand(
      "fetch", "Lists the recordings of a remote robot, or downloads one; resumes an interrupted download");
  arguments->link.addTo(*command);
  command->add_option("name", arguments->name, "The recording; if omitted, all recordings are listed");
  command->add_option("file", arguments->file, "The local file; by default the same name in this folder");
  command->add_flag("--force", arguments->force, "Replaces an existing file");
  command->add_flag("--delete", arguments->removes,
                    "Deletes the recording on the robot once it has been downloaded");
  command->add_flag("--json", arguments->asJson, "Prints JSON");
  command->callback([arguments, &status] { status = runFetch(*arguments); });
}

}  // namespace app
