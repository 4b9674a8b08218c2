// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/MessageRecords.h"
#include "logplayer/mcap/Reader.h"

namespace logplayer::mcap {

/// Goes over the messages of some channels in order of time, equal times in the order of the file: the same
/// messages as by Reader::next() and read(), many times as fast, since it goes over the records of a chunk
/// when it comes to them. Chunks that overlap in time are held together up to the size of the reader's cache;
/// where more of them overlap, it goes step by step.
///
/// The reader must outlive it and may be asked other things in between. Like it for one thread at a time.
class MessageCursor {
 public:
  MessageCursor(Reader& reader, const std::vector<std::uint16_t>& channels);
  ~MessageCursor();
  MessageCursor(MessageCursor&&) noexcept;
  MessageCursor& operator=(MessageCursor&&) noexcept;

  /// To before the first message behind a position, which need not be that of a message.
  void seek(const MessagePosition& behind);
  /// False at the end.
  bool next() {
    if (next_ == end_) return advance();
    take();
    return true;
  }

  // What is known of the message that next() came to; valid until it is called again.
  MessagePosition position() const {
    return current_ == nullptr
               ? behind_
               : MessagePosition{current_->time, sectionOffset_, current_->offset, message_.channelId};
  }
  /// False: its chunk is damaged, which is then in the reader's damage(); only its position is known.
  bool readable() const { return readable_; }
  const Message& message() const { return message_; }
  /// With a share in the chunk that holds it, if it is readable.
  Reader::MessageData data() const;

 private:
  struct Implementation;
  void take() {
    current_ = next_++;
    if (readable_) {
      message_ = messageIn(records_, *current_);
    } else {
      message_ = {*channel_++, 0, current_->time, current_->time, {}};
    }
  }
  bool advance();
  bool step();

  std::unique_ptr<Implementation> implementation_;
  MessagePosition behind_;
  const MessageRecord* current_ = nullptr;  // null: `behind_` is the position
  const MessageRecord* next_ = nullptr;
  const MessageRecord* end_ = nullptr;  // of those that follow one another in a section
  std::uint64_t sectionOffset_ = 0;
  const std::uint8_t* records_ = nullptr;
  const std::uint16_t* channel_ = nullptr;  // the next one's, if they are not readable
  bool readable_ = true;
  Message message_;
};

}  // namespace logplayer::mcap
