// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl log` info and verify.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/core/platform/JsonOutput.h"
#include "app/robotctl/log/LogInput.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "logplayer/LogInfo.h"
#include "logplayer/base/DamageReport.h"
#include "logplayer/file/ContainerFile.h"
#include "logplayer/mcap/read/Reader.h"
#include "robotlink/base/Printable.h"

namespace app {
namespace {

using nlohmann::json;
using robotlink::Result;

struct ReadArguments {
  std::vector<std::string> files;
  bool asJson = false;
};

/// The output for one file, and the result.
struct Findings {
  json object;
  std::string text;
  std::vector<std::string> losses;
};

Result<Findings> describe(const std::filesystem::path& file) {
  TerminalProgress progress;
  const auto info = logplayer::readLogInfo(file, progress.function());
  if (!info) return tl::unexpected(info.error());
  return Findings{toJson(*info), toText(*info), info->losses};
}

/// A number: "7", or "5 of 7" if not all can be read.
std::string ofAll(std::uint64_t readable, std::uint64_t all) {
  return readable < all ? std::to_string(readable) + " of " + std::to_string(all) : std::to_string(all);
}

Result<Findings> verify(const std::filesystem::path& path) {
  const std::string file = path.string();
  TerminalProgress progress;
  const auto container = logplayer::ContainerFile::of(file, progress.function());
  if (!container) return tl::unexpected(container.error());
  logplayer::mcap::Reader::Options options;
  options.progress = progress.function();
  const auto reader = logplayer::mcap::Reader::open(container->path(), options);
  if (!reader) return tl::unexpected(reader.error());
  const auto readable = (*reader)->verify();
  if (!readable) return robotlink::failure("log.given-up", "canceled", {file, 0, 0});
  Findings findings;
  if (container->conversion() && !container->conversion()->damage.empty()) {
    findings.losses.push_back(file + ": " + container->conversion()->damage);
  }
  const auto damaged = logplayer::describeDamage(file, (*reader)->complete(), (*reader)->damage());
  findings.losses.insert(findings.losses.end(), damaged.begin(), damaged.end());
  const auto messages = (*reader)->statistics().messageCount;
  const auto chunks = (*reader)->chunks().size();
  findings.object = {{"file", file},
                     {"whole", findings.losses.empty()},
                     {"messages", readable->messages},
                     {"chunks", readable->chunks},
                     {"losses", findings.losses}};
  findings.text = file + (findings.losses.empty() ? ": whole, " : ": readable in part, ") +
                  ofAll(readable->messages, messages) + " messages in " + ofAll(readable->chunks, chunks) +
                  " chunks\n";
  return findings;
}

/// Prints the object of a single file; for several files an object that contains theirs.
void printJson(const ReadArguments& arguments, const std::vector<json>& objects) {
  if (arguments.files.size() == 1 && objects.size() == 1) {
    std::cout << jsonOutput(objects.front());
  } else if (arguments.files.size() > 1) {
    std::cout << jsonOutput(json{{"files", objects}});
  }
}

int forAll(const ReadArguments& arguments, Result<Findings> (*find)(const std::filesystem::path&)) {
  int status = kDone;
  std::vector<json> objects;
  bool first = true;
  for (const std::string& file : arguments.files) {
    const auto input = LogInput::of(file);
    auto findings = input ? find(input->path()) : tl::unexpected(input.error());
    if (!findings) {
      status = printErrors({findings.error()});
      if (Interrupt::noted()) break;
      continue;
    }
    if (arguments.asJson) {
      objects.push_back(std::move(findings->object));
    } else {
      std::cout << (first ? "" : "\n") << robotlink::printableLines(findings->text) << std::flush;
    }
    first = false;
    const int here = printLosses(findings->losses);
    if (status == kDone) status = here;
    if (!std::cout) break;  // what else is found could not be printed, either
    if (Interrupt::noted() && &file != &arguments.files.back()) {
      status = kFailed;
      break;
    }
  }
  if (arguments.asJson) printJson(arguments, objects);
  return status;
}

void addReader(CLI::App& log, int& status, const char* name, const char* help,
               Result<Findings> (*find)(const std::filesystem::path&)) {
  auto arguments = std::make_shared<ReadArguments>();
  CLI::App* command = log.add_subcommand(name, help);
  command->add_option("files", arguments->files, "Log files (MCAP or older formats); - is standard input")
      ->required();
  command->add_flag("--json", arguments->asJson, "Prints one JSON object");
  command->callback([arguments, find, &status] { status = forAll(*arguments, find); });
}

}  // namespace

void addLogReadCommands(CLI::App& log, int& status) {
  addReader(log, status, "info", "Describes logs: streams with counts, sizes and rates, time, robots, damage",
            describe);
  addReader(log, status, "verify", "Reads logs completely and checks all checksums", verify);
}

}  // namespace app
