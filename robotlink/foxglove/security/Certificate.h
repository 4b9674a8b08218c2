// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "robotlink/base/Error.h"

struct x509_st;

namespace robotlink::websocket {

/// A robot's self-made certificate with its private key, as one PEM text, and the certificate's fingerprint:
/// "SHA256:" and the base64 of its digest, as ssh writes them. Clients recognize a robot by it.
struct Certificate {
  std::string pem;
  std::string fingerprint;
};

/// A new one with a key of its own (P-256), for `name`, valid for decades: nothing but its key counts.
Result<Certificate> makeCertificate(const std::string& name);
/// Reads a PEM text with both. Fails if the key is not that of the certificate; `file` is for errors.
Result<Certificate> parseCertificate(std::string pem, const std::string& file);
/// Reads the file, or makes it with mode 0600 if there is none.
Result<Certificate> loadOrMakeCertificate(const std::filesystem::path& file);

/// The fingerprint of a certificate that a peer showed; empty without one.
std::string fingerprintOf(const x509_st* certificate);

}  // namespace robotlink::websocket
