// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <string>

#include <jpeglib.h>

namespace logplayer {

/// An error handler for libjpeg that leaves a failed call by longjmp. The caller sets `jump` by setjmp in a
/// function all of whose locals are trivial and that calls nothing but libjpeg; objects that own memory must
/// live outside of it. Warnings are stored, not printed.
class JpegErrors {
 public:
  /// Installs the callbacks below and disables output to stderr.
  JpegErrors() {
    jpeg_std_error(&errors_);
    errors_.error_exit = &fail;
    errors_.emit_message = &notice;
    errors_.output_message = [](j_common_ptr) {};
  }
  JpegErrors(const JpegErrors&) = delete;
  JpegErrors& operator=(const JpegErrors&) = delete;

  /// To be set as the `err` of a codec; this object must outlive the codec.
  jpeg_error_mgr* handler() { return &errors_; }
  /// The target of the longjmp.
  std::jmp_buf& jump() { return jump_; }
  /// The text of the error that ended it, else of the first warning; empty if there was none.
  std::string text() const { return text_; }
  /// Aborts the codec with an error of ours, from within one of its callbacks. Does not return.
  static void stop(j_common_ptr codec, const char* text) {
    std::snprintf(of(codec).text_, sizeof text_, "%s", text);
    std::longjmp(of(codec).jump_, 1);
  }

 private:
  /// The handler of a codec.
  static JpegErrors& of(j_common_ptr codec) { return *reinterpret_cast<JpegErrors*>(codec->err); }
  /// Called by libjpeg on a fatal error; does not return.
  static void fail(j_common_ptr codec) {
    codec->err->format_message(codec, of(codec).text_);
    std::longjmp(of(codec).jump_, 1);
  }
  /// Called by libjpeg on warnings (negative level) and traces; keeps the first warning.
  static void notice(j_common_ptr codec, int level) {
    if (level >= 0) return;
    if (codec->err->num_warnings++ == 0) codec->err->format_message(codec, of(codec).text_);
  }

  /// Must be the first member, so that a pointer to it is a pointer to this object.
  jpeg_error_mgr errors_{};
  std::jmp_buf jump_{};
  char text_[JMSG_LENGTH_MAX] = {};
};

}  // namespace logplayer
