// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/MessageRecords.h"
#include "logplayer/mcap/read/Reader.h"

namespace logplayer::mcap {

/// Iterates over the messages of some channels in order of time, and for equal times in the order of the
/// file. It finds the same messages as Reader::next() and read(), but many times faster, because it iterates
/// over the records of a chunk once that is read. Chunks that overlap in time are held together up to the
/// size of the reader's cache; where more of them overlap, it falls back to single steps.
///
/// The reader must outlive it and may be used for other things in between. One thread at a time, together
/// with the reader.
class MessageCursor {
 public:
  /// Starts before the first message.
  MessageCursor(Reader& reader, const std::vector<std::uint16_t>& channels);
  ~MessageCursor();
  MessageCursor(MessageCursor&&) noexcept;
  MessageCursor& operator=(MessageCursor&&) noexcept;

  /// Moves before the first message behind a position, which need not be that of a message.
  void seek(const MessagePosition& behind);
  /// Moves to the next message. Returns false at the end.
  bool next() {
    if (next_ == end_) return advance();
    take();
    return true;
  }

  // The current message; valid until the next call of next().
  MessagePosition position() const {
    return come_ ? MessagePosition{message_.logTime, sectionOffset_, offset_, message_.channelId} : behind_;
  }
  /// False if its chunk is damaged, which is then in the reader's damage(); only its position and channel are
  /// known.
  bool readable() const { return readable_; }
  const Message& message() const { return message_; }
  /// The message together with a share in the memory of its chunk, if it is readable.
  Reader::MessageData data() const;

 private:
  struct Implementation;
  /// Moves to the next message of the run.
  void take() {
    const MessageRecord& next = *next_++;
    offset_ = next.offset;
    come_ = true;
    if (readable_) {
      message_ = messageIn(records_, next);
    } else {
      message_ = {*channel_++, 0, next.time, next.time, {}};
    }
  }
  /// Drops all references to the current run.
  void stop();
  /// Moves to the first message of the next run.
  bool advance();
  /// Moves to the next message by way of the reader.
  bool step();

  std::unique_ptr<Implementation> implementation_;
  /// The position before the current run, or of the message found by a step.
  MessagePosition behind_;
  /// Whether message_ is one of the current run; otherwise behind_ is the position.
  bool come_ = false;
  std::uint64_t sectionOffset_ = 0;
  /// The message's offset in its section.
  std::uint64_t offset_ = 0;
  /// The records of the current run, if it is readable.
  const std::uint8_t* records_ = nullptr;
  /// The messages of the run that are still to come.
  const MessageRecord* next_ = nullptr;
  const MessageRecord* end_ = nullptr;
  /// The channel of the next message, if they are not readable.
  const std::uint16_t* channel_ = nullptr;
  bool readable_ = true;
  Message message_;
};

}  // namespace logplayer::mcap
