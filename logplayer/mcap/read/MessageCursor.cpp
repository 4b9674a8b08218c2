// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/MessageCursor.h"

#include "logplayer/mcap/read/ChunkMerge.h"
#include "logplayer/mcap/read/ReaderParts.h"

namespace logplayer::mcap {

struct MessageCursor::Implementation {
  Implementation(Reader& from, ReaderParts& parts, const std::vector<std::uint16_t>& ids)
      : reader(from),
        file(parts),
        channels(ids),
        merge(parts.index, parts.cache, ids, parts.options.cacheBytes) {}

  Reader& reader;
  ReaderParts& file;
  const std::vector<std::uint16_t> channels;
  ChunkMerge merge;
  std::shared_ptr<const Buffer> stepped;  // of the message that a step found
  const std::shared_ptr<const Buffer>* owner = nullptr;
};

MessageCursor::MessageCursor(Reader& reader, const std::vector<std::uint16_t>& channels)
    : implementation_(std::make_unique<Implementation>(reader, *reader.parts_, channels)),
      behind_{Instant::min(), 0, 0, 0} {}

MessageCursor::~MessageCursor() = default;
MessageCursor::MessageCursor(MessageCursor&&) noexcept = default;
MessageCursor& MessageCursor::operator=(MessageCursor&&) noexcept = default;

void MessageCursor::seek(const MessagePosition& behind) {
  implementation_->merge.seek();
  behind_ = behind;
  stop();
}

/// Releases everything that the merge hands out.
void MessageCursor::stop() {
  come_ = false;
  next_ = end_ = nullptr;
}

bool MessageCursor::advance() {
  Implementation& self = *implementation_;
  behind_ = position();
  stop();
  ChunkMerge::Run run;
  do {
    run = self.merge.next(behind_);
  } while (self.file.refit());
  if (!self.merge.fits()) return step();
  if (run.records == nullptr) return false;
  sectionOffset_ = run.sectionOffset;
  readable_ = *run.records != nullptr;
  records_ = readable_ ? (*run.records)->data() : nullptr;
  self.owner = run.records;
  next_ = run.messages.data();
  end_ = next_ + run.messages.size();
  channel_ = run.channels;
  take();
  return true;
}

/// Steps by next() and read() of the reader.
bool MessageCursor::step() {
  Implementation& self = *implementation_;
  const auto found = self.reader.next(behind_, self.channels);
  if (!found) return false;
  behind_ = *found;
  self.owner = &self.stepped;
  auto data = self.reader.read(*found);
  readable_ = data.has_value();
  if (readable_) {
    message_ = data->message;
    self.stepped = std::move(data->owner);
  } else {
    message_ = {found->channelId, 0, found->time, found->time, {}};
    self.stepped.reset();
  }
  return true;
}

Reader::MessageData MessageCursor::data() const {
  return {message_, *implementation_->owner};
}

}  // namespace logplayer::mcap
