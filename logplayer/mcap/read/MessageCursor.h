// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/MessageRecords.h"
#include "logplayer/mcap/read/Reader.h"

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
    if (goOver()) return true;
    if (next_ == end_) return advance();
    take();
    return true;
  }

  // What is known of the message that next() came to; valid until it is called again.
  MessagePosition position() const {
    return come_ ? MessagePosition{message_.logTime, sectionOffset_, offset_, message_.channelId} : behind_;
  }
  /// False: its chunk is damaged, which is then in the reader's damage(); only its position is known.
  bool readable() const { return readable_; }
  const Message& message() const { return message_; }
  /// With a share in the chunk that holds it, if it is readable.
  Reader::MessageData data() const;

 private:
  struct Implementation;
  /// Comes to the next message in the records; false: there is none before other sections have some.
  bool goOver() {
    if (place_ == recordsEnd_) return false;
    place_ = nextMessage(records_, place_, recordsEnd_, *wanted_);
    if (place_ == recordsEnd_) return false;
    const std::uint8_t* record = records_ + place_;
    const Instant time = messageTime(record + kRecordHeadBytes);
    if (nanosecondsOf(time) >= until_) {
      place_ = recordsEnd_;
      return false;
    }
    const auto bytes = static_cast<std::uint32_t>(loadNumber<std::uint64_t>(record + 1));
    message_ = messageIn(records_, {time, static_cast<std::uint32_t>(place_), bytes});
    offset_ = place_;
    place_ += kRecordHeadBytes + bytes;
    come_ = true;
    return true;
  }
  /// Comes to the next of the sorted messages.
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
  void stop();
  bool advance();
  bool step();

  std::unique_ptr<Implementation> implementation_;
  MessagePosition behind_;
  bool come_ = false;  // to a message; else `behind_` is the position
  std::uint64_t sectionOffset_ = 0;
  std::uint64_t offset_ = 0;  // of the message
  const std::uint8_t* records_ = nullptr;
  std::size_t place_ = 0, recordsEnd_ = 0;  // what is to be gone over, as far as it comes before...
  std::uint64_t until_ = 0;                 // ...this time, ns
  const ChannelSet* wanted_ = nullptr;
  const MessageRecord* next_ = nullptr;  // of sorted ones
  const MessageRecord* end_ = nullptr;
  const std::uint16_t* channel_ = nullptr;  // the next one's, if they are not readable
  bool readable_ = true;
  Message message_;
};

}  // namespace logplayer::mcap
