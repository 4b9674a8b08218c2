// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotChoices.h"

#include <google/protobuf/descriptor.h>

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <map>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/NaturalOrder.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/expressions/NumericFields.h"
#include "widgets/TypedStreams.h"

namespace widgets {
namespace {

using google::protobuf::Descriptor;
using robotlink::FieldChoice;
using robotlink::StreamStore;

constexpr char kPlotType[] = "robotcontrol.PlotValue";
constexpr std::array kLeftOut{"foxglove.SceneUpdate",
                              "foxglove.ImageAnnotations",
                              "foxglove.RawImage",
                              "foxglove.CompressedImage",
                              "foxglove.Log",
                              "robotcontrol.KeyTable",
                              "robotcontrol.SolutionTable",
                              "robotcontrol.ProcessTable",
                              "robotcontrol.ParameterValues"};

bool isLeftOut(const std::string& type) {
  return std::ranges::any_of(kLeftOut, [&](const char* name) { return type == name; });
}

QString sentence(const char* text) {
  return QCoreApplication::translate("PlotChoices", text);
}

/// Streams that are not published now: their types, and why not.
class MissingStreams {
 public:
  explicit MissingStreams(const StreamStore& store) : store_(store) {}

  void add(const std::string& path, const std::string& type, const QString& why) {
    if (!type.empty() && !isLeftOut(type) && store_.find(path) == nullptr)
      streams_.emplace(path, std::pair(type, why));
  }

  /// Packages that the robots' processes exchange are published when their debug keys are on.
  void addPackages() {
    const QString why =
        sentence(QT_TRANSLATE_NOOP("PlotChoices", "Its debug key is off; adding the curve switches it on."));
    for (const auto* stream : streamsOfType(store_, {}, "robotcontrol.ProcessTable")) {
      const auto* table =
          dynamic_cast<const robotcontrol::ProcessTable*>(stream->messages.back().value.get());
      if (table == nullptr) continue;
      for (const auto& process : table->processes()) {
        for (const auto& port : process.senders()) {
          const bool isKnown = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(
                                   port.type()) != nullptr;
          if (isKnown && !port.package().starts_with("debug/"))
            add(robotlink::streams::robotOf(stream->path) + '/' + port.package(), port.type(), why);
        }
      }
    }
  }

  /// Plots of the program that are off, and plots of solutions that do not run.
  void addPlots() {
    const QString off =
        sentence(QT_TRANSLATE_NOOP("PlotChoices", "Its debug key is off; adding the curve switches it on."));
    const QString idle = sentence(
        QT_TRANSLATE_NOOP("PlotChoices", "No running solution provides it; see the view Solutions."));
    for (const auto* stream : streamsOfType(store_, {}, "robotcontrol.KeyTable")) {
      const std::string robot = robotlink::streams::robotOf(stream->path);
      const auto* table = dynamic_cast<const robotcontrol::KeyTable*>(stream->messages.back().value.get());
      if (table == nullptr || stream->path != robot + '/' + robotlink::streams::kKeys) continue;
      for (const auto& key : table->keys()) {
        const std::string path = robot + '/' + key.stream();
        const bool isPlot = key.stream().starts_with(robotlink::streams::kPlots);
        if (isPlot && store_.streams(path + '/').empty()) add(path, kPlotType, key.in_use() ? off : idle);
      }
    }
  }

  const std::map<std::string, std::pair<std::string, QString>>& all() const { return streams_; }

 private:
  const StreamStore& store_;
  std::map<std::string, std::pair<std::string, QString>> streams_;
};

void addMissing(const MissingStreams& missing, std::vector<PlotChoice>& choices) {
  for (const auto& [path, about] : missing.all()) {
    const auto& [type, why] = about;
    if (type == kPlotType) {
      choices.push_back({{path, {}, type}, why});
      continue;
    }
    const Descriptor* known = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(type);
    if (known == nullptr) {
      choices.push_back(
          {{path, {}, type},
           sentence(QT_TRANSLATE_NOOP("PlotChoices", "Its contents are known once it has been played.")),
           false});
      continue;
    }
    for (const std::string& field : robotlink::numericFields(*known, FieldChoice::kNumbersAndTexts))
      choices.push_back({{path, field, type}, why});
  }
}

}  // namespace

std::vector<PlotChoice> plotChoices(const StreamStore& store, const std::vector<LoggedStream>& logged) {
  std::vector<PlotChoice> choices;
  for (const auto* stream : store.streams()) {
    if (isLeftOut(stream->type) || stream->messages.empty()) continue;
    if (stream->type == kPlotType) {
      choices.push_back({{stream->path, {}, stream->type}});
      continue;
    }
    for (const std::string& field :
         robotlink::numericFields(*stream->messages.back().value, FieldChoice::kNumbersAndTexts))
      choices.push_back({{stream->path, field, stream->type}});
  }
  MissingStreams missing(store);
  const QString inLog = sentence(
      QT_TRANSLATE_NOOP("PlotChoices", "The log has it at other times; its curve is read from the file."));
  for (const LoggedStream& stream : logged) missing.add(stream.path, stream.type, inLog);
  missing.addPackages();
  missing.addPlots();
  addMissing(missing, choices);
  std::ranges::stable_sort(
      choices, robotlink::comesNaturallyBefore,
      [](const PlotChoice& choice) -> const std::string& { return choice.source.stream; });
  return choices;
}

std::vector<robotlink::PackagePtr> keyTables(const StreamStore& store) {
  std::vector<robotlink::PackagePtr> tables;
  for (const auto* stream : streamsOfType(store, {}, "robotcontrol.KeyTable"))
    tables.push_back(stream->messages.back().value);
  return tables;
}

}  // namespace widgets
