// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl watch`.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "app/core/platform/NumberRange.h"
#include "app/core/platform/RecordOptions.h"
#include "app/core/remote/ImageCodings.h"
#include "app/core/remote/LinkLimits.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/link/LinkOptions.h"
#include "app/robotctl/link/StreamList.h"
#include "logplayer/base/RecordedStreams.h"
#include "logplayer/export/JsonLine.h"
#include "logplayer/export/MessageTable.h"
#include "robotlink/base/Printable.h"
#include "robotlink/foxglove/session/remote/SessionClient.h"

namespace app {
namespace {

using robotlink::websocket::ConnectionState;
using robotlink::websocket::SessionClient;
using WallClock = std::chrono::steady_clock;

struct WatchArguments {
  LinkOptions link;
  RecordOptions record;
  std::string csv, jsonLines;
  std::optional<double> seconds;
  LinkLimits limits;
  bool asJson = false, asJpeg = false, asPng = false, asRaw = false;
};

constexpr std::chrono::milliseconds kWatchTick{10};
constexpr std::chrono::seconds kWatchInterval{1};
/// This command never looks back, so it keeps little.
constexpr robotlink::StreamStore::Limits kWatchHistory{std::chrono::seconds(1), 64U << 20U};

/// Other programs read the lines unchanged; a terminal must not obey control characters in them.
std::string shownLines(const std::string& lines) {
  return ::isatty(STDOUT_FILENO) == 1 ? robotlink::printableLines(lines) : lines;
}

/// Prints messages of one stream as lines of a table, whose columns are those of the first message.
class CsvPrinter {
 public:
  void print(const robotlink::StreamMessage& message) {
    const std::string& type = message.value->GetDescriptor()->full_name();
    if (type_.empty()) {
      type_ = type;
      table_.learn(*message.value);
      auto columns = table_.columns();
      columns.insert(columns.begin(), "time");
      std::cout << shownLines(logplayer::csvLine(columns));
    }
    if (type != type_) return;
    auto row = table_.row(*message.value);
    const auto time = message.time.time_since_epoch();
    constexpr std::int64_t kNanos = 1'000'000'000;
    row.insert(row.begin(), logplayer::secondsText(time.count() / kNanos, time.count() % kNanos));
    std::cout << shownLines(logplayer::csvLine(row)) << std::flush;
  }

 private:
  std::string type_;
  logplayer::MessageTable table_;
};

/// Prints messages of the streams that a selection has, as they come, each as a JSON object on a line of its
/// own.
class JsonPrinter {
 public:
  explicit JsonPrinter(const robotcontrol::StreamSelection& selection)
      : streams_{{selection.include().begin(), selection.include().end()},
                 {selection.exclude().begin(), selection.exclude().end()}} {}

  bool prints(const std::string& path) const { return streams_.has(path); }
  void print(const robotlink::StreamMessage& message) {
    const auto line = logplayer::jsonLine(message);
    if (line) std::cout << shownLines(*line) << std::flush;
  }

 private:
  logplayer::StreamFilter streams_;
};

/// Watches one server until the time is over or the user interrupts.
class Watch {
 public:
  Watch(const WatchArguments& arguments, const std::optional<robotcontrol::StreamSelection>& asJsonLines,
        robotlink::websocket::Connector::Options connection, logplayer::Recorder* recorder)
      : arguments_(arguments),
        recorder_(recorder),
        json_(asJsonLines ? std::make_optional<JsonPrinter>(*asJsonLines) : std::nullopt),
        session_(kWatchHistory),
        client_(session_, optionsFor(std::move(connection))) {
    LinkLimits limits = arguments.limits;
    if (arguments.asJpeg) limits.images = LinkLimits::Images::kJpeg;
    if (arguments.asPng) limits.images = LinkLimits::Images::kPng;
    if (arguments.asRaw) limits.images = LinkLimits::Images::kRaw;
    // Foreign servers do not support these.
    if (limits != LinkLimits()) apply(limits, client_);
  }

  int run() {
    const auto begin = WallClock::now();
    auto listed = begin;
    while (!Interrupt::noted() && std::cout) {
      client_.tick();
      session_.tick();
      reportState();
      const auto now = WallClock::now();
      if (arguments_.seconds && std::chrono::duration<double>(now - begin).count() >= *arguments_.seconds)
        break;
      if (now - listed >= kWatchInterval) {
        listed = now;
        list_.update(client_.streams(), std::chrono::duration<double>(now - begin).count());
        if (isInteractive()) std::cout << "\033[H\033[J" << title() << list_.text() << std::flush;
      }
      std::this_thread::sleep_for(kWatchTick);
    }
    return finish(std::chrono::duration<double>(WallClock::now() - begin).count());
  }

 private:
  SessionClient::Options optionsFor(robotlink::websocket::Connector::Options connection) {
    SessionClient::Options options;
    options.connection = std::move(connection);
    options.alsoWanted = [this](const std::string& path) {
      return path == arguments_.csv || (json_ && json_->prints(path)) ||
             (recorder_ != nullptr && recorder_->wants(path));
    };
    options.convert = decodedImage;
    options.passed = [this](const robotlink::StreamMessage& message) {
      if (recorder_ != nullptr) recorder_->add({message});
      if (!arguments_.csv.empty() && message.path == arguments_.csv) csv_.print(message);
      if (json_ && json_->prints(message.path)) json_->print(message);
    };
    return options;
  }
  bool printsMessages() const { return !arguments_.csv.empty() || json_; }
  bool isInteractive() const {
    return !arguments_.asJson && !printsMessages() && ::isatty(STDOUT_FILENO) == 1;
  }
  std::string title() const {
    std::string robots;
    for (const std::string& robot : client_.robots()) robots += (robots.empty() ? "" : ", ") + robot;
    return toString(client_.url()) + (robots.empty() ? "" : " (" + robots + ")") + ": " +
           robotlink::printable(client_.stateText()) + "\n";
  }
  /// Reports changes of the connection on stderr, once each time; a terminal shows them anyway.
  void reportState() {
    const ConnectionState state = client_.state();
    wasConnected_ |= state.isConnected();
    const std::string text = state.isConnected() ? "connected" : state.reason;
    if (isInteractive() || text.empty() || text == told_) return;
    std::cerr << toString(client_.url()) + ": " + robotlink::printable(text) + "\n";
    told_ = text;
  }
  int finish(double seconds) {
    list_.update(client_.streams(), seconds);
    if (arguments_.asJson)
      std::cout << list_.json(toString(client_.url()), client_.robots(), client_.stateText());
    else if (!printsMessages() && !isInteractive())
      std::cout << title() << list_.text();
    if (!arguments_.csv.empty() && !list_.has(arguments_.csv) && wasConnected_) {
      const std::string near = list_.near(arguments_.csv);
      const std::string advice = near.empty()
                                     ? ": see what 'robotctl watch " + toString(client_.url()) + "' lists"
                                     : "; did you mean '" + near + "'?";
      return printErrors({{"watch.stream", "there is no stream '" + arguments_.csv + "'" + advice, {}, {}}});
    }
    return wasConnected_ ? kDone : kFailed;
  }

  const WatchArguments& arguments_;
  logplayer::Recorder* recorder_;
  CsvPrinter csv_;
  std::optional<JsonPrinter> json_;
  StreamList list_;
  std::string told_;
  bool wasConnected_ = false;
  robotlink::Session session_;
  SessionClient client_;
};

int watch(const WatchArguments& arguments) {
  auto connection = arguments.link.connection();
  if (!connection) {
    printErrors({connection.error()});
    return kUsage;
  }
  std::optional<robotcontrol::StreamSelection> asJsonLines;
  if (!arguments.jsonLines.empty()) {
    auto selection = logplayer::readSelection(arguments.jsonLines);
    if (!selection) {
      printErrors({selection.error()});
      return kUsage;
    }
    asJsonLines = *std::move(selection);
  }
  auto recorder = arguments.record.start();
  if (!recorder) return printErrors({recorder.error()});
  const Interrupt interrupt;
  int status = Watch(arguments, asJsonLines, *std::move(connection), recorder->get()).run();
  if (*recorder == nullptr) return status;
  const bool isForPeople = arguments.csv.empty() && arguments.jsonLines.empty() && !arguments.asJson;
  const ExitStatus recorded = finishRecording(**recorder, isForPeople ? std::cout : std::cerr);
  return status == kDone ? recorded : status;
}

}  // namespace

void addWatchCommand(CLI::App& app, int& status) {
  auto arguments = std::make_shared<WatchArguments>();
  CLI::App* command = app.add_subcommand(
      "watch", "Lists the streams of a remote robot with their rates; records or prints them");
  arguments->link.addTo(*command);
  arguments->record.addTo(*command);
  auto* csv =
      command->add_option("--csv", arguments->csv, "Prints the messages of this stream as a table instead")
          ->type_name("STREAM");
  command
      ->add_option(
          "--json-lines", arguments->jsonLines,
          "Prints messages instead, each as a JSON object on a line of its own: comma-separated streams, "
          "* matches any text, - excludes (red1/models/*,-*/log)")
      ->type_name("STREAMS")
      ->excludes(csv);
  command->add_option("--seconds", arguments->seconds, "Ends after this time; default: with Ctrl-C")
      ->check(positiveNumber());
  command
      ->add_option("--budget", arguments->limits.bytesPerSecond,
                   "Bytes per second that the robot may send; 0: no limit")
      ->check(nonNegativeNumber());
  auto* jpeg = command->add_flag("--jpeg", arguments->asJpeg, "Requests images as JPEG, for slow links");
  auto* png = command->add_flag("--png", arguments->asPng, "Requests images as PNG")->excludes(jpeg);
  command
      ->add_option("--image-rate", arguments->limits.imagesPerSecond,
                   "Images per second of each stream that the robot may send; 0: all")
      ->check(nonNegativeNumber());
  command
      ->add_flag("--raw", arguments->asRaw,
                 "Keeps images raw even if the link is too slow; by default they are sent as JPEG then")
      ->excludes(jpeg)
      ->excludes(png);
  command->add_flag("--json", arguments->asJson, "Prints one JSON object at the end");
  command->footer(
      "It subscribes to what a workbench would: tables, states and texts, the output of debug keys that are "
      "on,\nand what is recorded or printed; a rate of '-' marks a stream not subscribed to. Exit status: 1 "
      "if the "
      "robot was\n"
      "never reached.");
  command->callback([arguments, &status] { status = watch(*arguments); });
}

}  // namespace app
