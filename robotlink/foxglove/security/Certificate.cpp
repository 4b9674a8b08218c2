// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/security/Certificate.h"

#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509.h>
#include <unistd.h>

#include <array>
#include <memory>

#include "robotlink/foxglove/protocol/Base64.h"
#include "robotlink/foxglove/security/SecretFile.h"

namespace robotlink::websocket {
namespace {

template <typename T, auto kFree>
struct Freed {
  void operator()(T* object) const { kFree(object); }
};
using KeyPtr = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY, EVP_PKEY_free>>;
using CertificatePtr = std::unique_ptr<X509, Freed<X509, X509_free>>;
using BioPtr = std::unique_ptr<BIO, Freed<BIO, BIO_free_all>>;
using NumberPtr = std::unique_ptr<BIGNUM, Freed<BIGNUM, BN_free>>;

constexpr long kBackdatedSeconds = 24 * 3600;  // clocks of robots are wrong
constexpr int kValidDays = 50 * 365;
constexpr int kSerialBits = 127;
constexpr std::size_t kMaxCommonName = 64;

tl::unexpected<Error> cryptoFailure(const std::string& what) {
  char reason[256] = "";
  ERR_error_string_n(ERR_get_error(), reason, sizeof reason);
  ERR_clear_error();
  return failure("certificate.crypto", what + " (" + reason + ")", {}, {reason});
}

bool setName(X509& certificate, const std::string& name) {
  const std::string text = name.substr(0, kMaxCommonName);
  X509_NAME* subject = X509_get_subject_name(&certificate);
  return X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_UTF8,
                                    reinterpret_cast<const unsigned char*>(text.data()),
                                    static_cast<int>(text.size()), -1, 0) == 1 &&
         X509_set_issuer_name(&certificate, subject) == 1;
}

bool setSerial(X509& certificate) {
  const NumberPtr number(BN_new());
  return number && BN_rand(number.get(), kSerialBits, BN_RAND_TOP_ANY, BN_RAND_BOTTOM_ANY) == 1 &&
         BN_to_ASN1_INTEGER(number.get(), X509_get_serialNumber(&certificate)) != nullptr;
}

bool fill(X509& certificate, EVP_PKEY& key, const std::string& name) {
  return X509_set_version(&certificate, 2) == 1 && setSerial(certificate) &&  // version 3
         X509_gmtime_adj(X509_getm_notBefore(&certificate), -kBackdatedSeconds) != nullptr &&
         X509_time_adj_ex(X509_getm_notAfter(&certificate), kValidDays, 0, nullptr) != nullptr &&
         setName(certificate, name) && X509_set_pubkey(&certificate, &key) == 1 &&
         X509_sign(&certificate, &key, EVP_sha256()) > 0;
}

std::string hostName() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0 || name[0] == '\0') return "robot";
  return name.data();
}

/// OpenSSL must not ask for a password on the terminal.
int noPassword(char*, int, int, void*) {
  return -1;
}

}  // namespace

std::string fingerprintOf(const X509* certificate) {
  if (certificate == nullptr) return {};
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  if (X509_digest(certificate, EVP_sha256(), digest.data(), &size) != 1) return {};
  std::string text = toBase64({reinterpret_cast<const char*>(digest.data()), size});
  while (text.ends_with('=')) text.pop_back();
  return "SHA256:" + text;
}

Result<Certificate> makeCertificate(const std::string& name) {
  const KeyPtr key(EVP_EC_gen("P-256"));
  if (!key) return cryptoFailure("cannot make a key");
  const CertificatePtr certificate(X509_new());
  if (!certificate || !fill(*certificate, *key, name)) return cryptoFailure("cannot make a certificate");
  const BioPtr out(BIO_new(BIO_s_mem()));
  if (!out ||
      PEM_write_bio_PKCS8PrivateKey(out.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) != 1 ||
      PEM_write_bio_X509(out.get(), certificate.get()) != 1)
    return cryptoFailure("cannot write a certificate");
  char* data = nullptr;
  const long size = BIO_get_mem_data(out.get(), &data);
  return Certificate{{data, static_cast<std::size_t>(size)}, fingerprintOf(certificate.get())};
}

Result<Certificate> parseCertificate(std::string pem, const std::string& file) {
  const auto open = [&] { return BioPtr(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size()))); };
  const KeyPtr key(PEM_read_bio_PrivateKey(open().get(), nullptr, noPassword, nullptr));
  const CertificatePtr certificate(PEM_read_bio_X509(open().get(), nullptr, noPassword, nullptr));
  const bool fits = key && certificate && X509_check_private_key(certificate.get(), key.get()) == 1;
  ERR_clear_error();
  if (!fits)
    return failure("certificate.file",
                   "this is not a certificate with its key: remove the file to have a new one created; "
                   "clients that know the robot will be warned then",
                   {file, 0, 0});
  std::string fingerprint = fingerprintOf(certificate.get());
  return Certificate{std::move(pem), std::move(fingerprint)};
}

Result<Certificate> loadOrMakeCertificate(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    const auto made = makeCertificate(hostName());
    if (!made) return tl::unexpected(made.error());
    // Another process may create the file at the same time; then that file is used.
    if (const auto created = createSecret(file, made->pem); !created) return tl::unexpected(created.error());
  }
  auto text = readSecret(file);
  if (!text) return tl::unexpected(text.error());
  return parseCertificate(*std::move(text), file.string());
}

}  // namespace robotlink::websocket
