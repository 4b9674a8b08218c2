// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bhuman/QueueImport.h"

#include "logplayer/bhuman/MessageQueueReader.h"
#include "logplayer/file/LogFormat.h"

namespace logplayer::bhuman {
namespace {

constexpr char kFormatName[] = "B-Human message queue";

/// A summary of the damage: "3 places are damaged: at byte 0 ...; at byte 17 ..."
std::string damageText(const MessageQueueReader& reader) {
  if (reader.damageCount() == 0) return {};
  std::string text = reader.damageCount() == 1
                         ? "1 place is damaged: "
                         : std::to_string(reader.damageCount()) + " places are damaged: ";
  for (std::size_t i = 0; i < reader.damage().size(); ++i) {
    const QueueDamage& damage = reader.damage()[i];
    text += (i > 0 ? "; at byte " : "at byte ") + std::to_string(damage.offset) + ": " + damage.text;
  }
  if (reader.damageCount() > reader.damage().size()) text += "; and so on";
  return text;
}

}  // namespace

robotlink::Result<ImportReport> importQueue(ByteSource& bytes, const std::string& robot,
                                            const FrameConverter::FrameSink& sink,
                                            const std::function<bool(double)>& progress) {
  MessageQueueReader reader(bytes);
  FrameConverter converter(robot, sink, [&reader](std::uint64_t offset, const std::string& text) {
    reader.addDamage(offset, text);
  });
  ImportReport report;
  report.format = kFormatName;
  while (const auto message = reader.next()) {
    ++report.messages;
    if (auto added = converter.add(*message); !added) return tl::unexpected(std::move(added.error()));
    const double done = static_cast<double>(reader.position()) / static_cast<double>(bytes.size());
    if (progress && !progress(done)) return robotlink::failure("log.given-up", "the import was canceled");
  }
  if (auto finished = converter.finish(); !finished) return tl::unexpected(std::move(finished.error()));
  report.imported = converter.imported();
  report.notUnderstood = converter.notUnderstood();
  report.damage = damageText(reader);
  return report;
}

namespace {

LogFormat::Robot naoOf2009() {
  return {"nao", "robots/nao.yaml"};
}

bool isQueue(const std::filesystem::path& file) {
  const auto bytes = openFile(file);
  return bytes && MessageQueueReader::recognizes(**bytes);
}

robotlink::Result<ImportReport> importQueueFile(const std::filesystem::path& from, const ImportSink& sink,
                                                const ImportOptions& options) {
  const auto bytes = openFile(from);
  if (!bytes) return tl::unexpected(bytes.error());
  return importQueue(**bytes, options.robot, sink, options.progress);
}

const LogFormatRegistration kQueueFormat{{kFormatName, naoOf2009, isQueue, importQueueFile}};

}  // namespace

}  // namespace logplayer::bhuman
