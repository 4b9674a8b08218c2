// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <string>

#include <jpeglib.h>

namespace logplayer {

/// Takes libjpeg's errors out of its longjmp: `jump` must be set (setjmp) in a function of which every local
/// is trivial, around nothing but calls of libjpeg; what owns memory lives outside. Warnings are kept, not
/// printed.
class JpegErrors {
 public:
  JpegErrors() {
    jpeg_std_error(&errors_);
    errors_.error_exit = &fail;
    errors_.emit_message = &notice;
    errors_.output_message = [](j_common_ptr) {};
  }
  JpegErrors(const JpegErrors&) = delete;
  JpegErrors& operator=(const JpegErrors&) = delete;

  jpeg_error_mgr* handler() { return &errors_; }
  std::jmp_buf& jump() { return jump_; }
  /// The text of the error that ended it, else of the first warning; empty if there was none.
  std::string text() const { return text_; }
  /// Ends what the codec does, from within one of its call-backs.
  static void stop(j_common_ptr codec, const char* text) {
    std::snprintf(of(codec).text_, sizeof text_, "%s", text);
    std::longjmp(of(codec).jump_, 1);
  }

 private:
  static JpegErrors& of(j_common_ptr codec) { return *reinterpret_cast<JpegErrors*>(codec->err); }
  static void fail(j_common_ptr codec) {
    codec->err->format_message(codec, of(codec).text_);
    std::longjmp(of(codec).jump_, 1);
  }
  static void notice(j_common_ptr codec, int level) {
    if (level >= 0) return;
    if (codec->err->num_warnings++ == 0) codec->err->format_message(codec, of(codec).text_);
  }

  jpeg_error_mgr errors_{};  // first, so that a codec's pointer to it is one to this
  std::jmp_buf jump_{};
  char text_[JMSG_LENGTH_MAX] = {};
};

}  // namespace logplayer
