#include "tests/server/guard/certificates.h"

#include <openssl/bio.h>
#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <atomic>
#include <stdexcept>

namespace remeshd::test {
namespace {

constexpr long kDay = 86400;

template <auto Free>
struct Freed {
  template <typename T>
  void operator()(T* object) const {
    Free(object);
  }
};
using Bio = std::unique_ptr<BIO, Freed<BIO_free>>;
using Certificate = std::unique_ptr<X509, Freed<X509_free>>;
using Key = std::unique_ptr<EVP_PKEY, Freed<EVP_PKEY_free>>;

void check(bool done) {
  if (!done) throw std::runtime_error("OpenSSL fails");
}

void extend(X509* certificate, int what, const char* value) {
  const std::unique_ptr<X509_EXTENSION, Freed<X509_EXTENSION_free>> extension(
      X509V3_EXT_conf_nid(nullptr, nullptr, what, value));
  check(extension && X509_add_ext(certificate, extension.get(), -1) == 1);
}

Certificate make(const std::string& name, EVP_PKEY* key, long valid_for) {
  static std::atomic<long> serial{1};
  Certificate out(X509_new());
  check(X509_set_version(out.get(), 2) == 1);
  ASN1_INTEGER_set(X509_get_serialNumber(out.get()), ++serial);
  X509_gmtime_adj(X509_getm_notBefore(out.get()), -kDay);
  X509_gmtime_adj(X509_getm_notAfter(out.get()), valid_for);
  check(X509_set_pubkey(out.get(), key) == 1);
  check(X509_NAME_add_entry_by_txt(X509_get_subject_name(out.get()), "CN", MBSTRING_ASC,
                                   reinterpret_cast<const unsigned char*>(name.c_str()), -1, -1,
                                   0) == 1);
  return out;
}

std::string text_of(const Bio& bio) {
  char* data = nullptr;
  const long size = BIO_get_mem_data(bio.get(), &data);
  return {data, static_cast<std::size_t>(size)};
}

std::string pem(X509* certificate) {
  const Bio bio(BIO_new(BIO_s_mem()));
  check(PEM_write_bio_X509(bio.get(), certificate) == 1);
  return text_of(bio);
}

std::string pem(EVP_PKEY* key) {
  const Bio bio(BIO_new(BIO_s_mem()));
  check(PEM_write_bio_PrivateKey(bio.get(), key, nullptr, nullptr, 0, nullptr, nullptr) == 1);
  return text_of(bio);
}

}  // namespace

struct Authority::Parts {
  Key key{EVP_EC_gen("P-256")};
  Certificate certificate;
};

Authority::Authority(const std::string& name) : parts_(std::make_unique<Parts>()) {
  check(parts_->key != nullptr);
  parts_->certificate = make(name, parts_->key.get(), kDay);
  X509* const own = parts_->certificate.get();
  check(X509_set_issuer_name(own, X509_get_subject_name(own)) == 1);
  extend(own, NID_basic_constraints, "critical,CA:TRUE");
  check(X509_sign(own, parts_->key.get(), EVP_sha256()) > 0);
}

Authority::~Authority() = default;

std::string Authority::certificate() const { return pem(parts_->certificate.get()); }

Issued Authority::issue(const std::string& name, long valid_for) const {
  const Key key(EVP_EC_gen("P-256"));
  const Certificate out = make(name, key.get(), valid_for);
  check(X509_set_issuer_name(out.get(), X509_get_subject_name(parts_->certificate.get())) == 1);
  extend(out.get(), NID_subject_alt_name, "DNS:localhost,IP:127.0.0.1");
  check(X509_sign(out.get(), parts_->key.get(), EVP_sha256()) > 0);
  return {pem(out.get()), pem(key.get())};
}

}  // namespace remeshd::test
