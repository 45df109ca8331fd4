// SPDX-License-Identifier: Apache-2.0
#include "axiometry/digest/time_stamp.h"

#include <fmt/format.h>
#include <openssl/bio.h>
#include <openssl/bn.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/ts.h>
#include <openssl/x509.h>

#include <ctime>
#include <memory>

#include "axiometry/base/contract.h"
#include "axiometry/digest/raw_bytes.h"

namespace axiometry {
namespace {

constexpr int nonce_bits = 64;
constexpr std::size_t digest_size = 32;

struct Freed {
  void operator()(TS_REQ* x) const { TS_REQ_free(x); }
  void operator()(TS_RESP* x) const { TS_RESP_free(x); }
  void operator()(TS_MSG_IMPRINT* x) const { TS_MSG_IMPRINT_free(x); }
  void operator()(TS_VERIFY_CTX* x) const { TS_VERIFY_CTX_free(x); }
  void operator()(ASN1_INTEGER* x) const { ASN1_INTEGER_free(x); }
  void operator()(X509_ALGOR* x) const { X509_ALGOR_free(x); }
  void operator()(X509_STORE* x) const { X509_STORE_free(x); }
  void operator()(X509* x) const { X509_free(x); }
  void operator()(BIGNUM* x) const { BN_free(x); }
  void operator()(BIO* x) const { BIO_free(x); }
};
template <typename T>
using Owned = std::unique_ptr<T, Freed>;

std::string digest_of(std::string_view bytes) {
  std::string digest(digest_size, '\0');
  AXIOMETRY_CONTRACT(EVP_Digest(bytes.data(), bytes.size(), raw(digest), nullptr, EVP_sha256(), nullptr) == 1);
  return digest;
}

/// What the library says of its last failure.
std::string last_reason() {
  const unsigned long code = ERR_peek_last_error();
  const char* const reason = code == 0 ? nullptr : ERR_reason_error_string(code);
  ERR_clear_error();
  return reason == nullptr ? "no reason is known" : reason;
}

Result<Owned<TS_RESP>> granted_answer(std::string_view bytes) {
  const unsigned char* at = raw(bytes);
  Owned<TS_RESP> answer(d2i_TS_RESP(nullptr, &at, static_cast<long>(bytes.size())));
  ERR_clear_error();
  if (!answer || at != raw(bytes) + bytes.size())
    return fail("found no answer of a time stamp authority, expected one after RFC 3161 (DER)");
  TS_STATUS_INFO* const status = TS_RESP_get_status_info(answer.get());
  const auto code = ASN1_INTEGER_get(TS_STATUS_INFO_get0_status(status));
  if (code == TS_STATUS_GRANTED || code == TS_STATUS_GRANTED_WITH_MODS) return answer;
  std::string words;
  const STACK_OF(ASN1_UTF8STRING)* const texts = TS_STATUS_INFO_get0_text(status);
  for (int k = 0; k < sk_ASN1_UTF8STRING_num(texts); ++k) {
    const ASN1_UTF8STRING* const text = sk_ASN1_UTF8STRING_value(texts, k);
    words += std::string(words.empty() ? ": " : "; ") +
             std::string(reinterpret_cast<const char*>(ASN1_STRING_get0_data(text)),
                         static_cast<std::size_t>(ASN1_STRING_length(text)));
  }
  return fail(fmt::format("the authority refused the time stamp, status {}{}", code, words));
}

Result<Owned<X509_STORE>> store_of(std::string_view trusted) {
  Owned<X509_STORE> store(X509_STORE_new());
  const Owned<BIO> text(BIO_new_mem_buf(trusted.data(), static_cast<int>(trusted.size())));
  AXIOMETRY_CONTRACT(store && text);
  const auto no_password = [](char*, int, int, void*) { return 0; };  // else a terminal would be asked
  std::size_t count = 0;
  while (const Owned<X509> certificate{PEM_read_bio_X509(text.get(), nullptr, no_password, nullptr)}) {
    X509_STORE_add_cert(store.get(), certificate.get());
    ++count;
  }
  const bool to_the_end = ERR_GET_REASON(ERR_peek_last_error()) == PEM_R_NO_START_LINE;
  ERR_clear_error();
  if (count == 0 && to_the_end) return fail("found no certificate of an authority, expected one at least (PEM)");
  if (!to_the_end) return fail(fmt::format("found no certificate in block {}, expected one (PEM)", count + 1));
  return store;
}

/// As a time of the Unix clock, and as text.
Result<std::pair<std::time_t, std::string>> moment_of(TS_RESP* answer) {
  std::tm utc{};
  const ASN1_GENERALIZEDTIME* const time = TS_TST_INFO_get_time(TS_RESP_get_tst_info(answer));
  if (time == nullptr || ASN1_TIME_to_tm(time, &utc) != 1)
    return fail("found a time stamp without its time, expected one");
  return std::pair(::timegm(&utc), fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900,
                                               utc.tm_mon + 1, utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec));
}

/// Whoever signed: the first certificate that the answer brings along and the signature names.
std::string signer_of(TS_RESP* answer) {
  STACK_OF(X509)* const signers = PKCS7_get0_signers(TS_RESP_get_token(answer), nullptr, 0);
  std::string name;
  if (signers != nullptr && sk_X509_num(signers) > 0) {
    const Owned<BIO> text(BIO_new(BIO_s_mem()));
    X509_NAME_print_ex(text.get(), X509_get_subject_name(sk_X509_value(signers, 0)), 0,
                       XN_FLAG_RFC2253 & ~ASN1_STRFLGS_ESC_MSB);
    char* bytes = nullptr;
    const long size = BIO_get_mem_data(text.get(), &bytes);
    name.assign(bytes, static_cast<std::size_t>(size));
  }
  sk_X509_free(signers);
  return name;
}

Owned<TS_VERIFY_CTX> checks_of_bytes(std::string_view bytes) {
  Owned<TS_VERIFY_CTX> context(TS_VERIFY_CTX_new());
  AXIOMETRY_CONTRACT(context != nullptr);
  const std::string digest = digest_of(bytes);
  auto* const imprint = static_cast<unsigned char*>(OPENSSL_memdup(digest.data(), digest.size()));
  TS_VERIFY_CTX_set_flags(context.get(), TS_VFY_VERSION | TS_VFY_IMPRINT);
  TS_VERIFY_CTX_set_imprint(context.get(), imprint, static_cast<long>(digest.size()));  // the context frees the imprint
  return context;
}

/// Its bytes and its number.
Owned<TS_VERIFY_CTX> checks_of_request(std::string_view request) {
  Owned<TS_VERIFY_CTX> context(TS_VERIFY_CTX_new());
  const unsigned char* at = raw(request);
  const Owned<TS_REQ> asked(d2i_TS_REQ(nullptr, &at, static_cast<long>(request.size())));
  AXIOMETRY_CONTRACT(context && asked && TS_REQ_to_TS_VERIFY_CTX(asked.get(), context.get()) != nullptr);
  return context;
}

Result<void> verify(TS_RESP* answer, TS_VERIFY_CTX* checks) {
  if (TS_RESP_verify_response(checks, answer) == 1) return {};
  return fail(fmt::format("found a time stamp that does not hold: {}", last_reason()));
}

}  // namespace

Result<void> check_certificates(std::string_view text) {
  AXIOMETRY_TRY_VOID(store_of(text));
  return {};
}

std::string time_stamp_request(std::string_view bytes) {
  std::string digest = digest_of(bytes);
  const Owned<TS_REQ> request(TS_REQ_new());
  const Owned<TS_MSG_IMPRINT> imprint(TS_MSG_IMPRINT_new());
  const Owned<X509_ALGOR> algorithm(X509_ALGOR_new());
  const Owned<BIGNUM> number(BN_new());
  AXIOMETRY_CONTRACT(request && imprint && algorithm && number);
  AXIOMETRY_CONTRACT(BN_rand(number.get(), nonce_bits, BN_RAND_TOP_ANY, BN_RAND_BOTTOM_ANY) == 1);
  const Owned<ASN1_INTEGER> nonce(BN_to_ASN1_INTEGER(number.get(), nullptr));
  const bool set = X509_ALGOR_set0(algorithm.get(), OBJ_nid2obj(NID_sha256), V_ASN1_NULL, nullptr) == 1 &&
                   TS_MSG_IMPRINT_set_algo(imprint.get(), algorithm.get()) == 1 &&
                   TS_MSG_IMPRINT_set_msg(imprint.get(), raw(digest), static_cast<int>(digest.size())) == 1 &&
                   TS_REQ_set_version(request.get(), 1) == 1 &&
                   TS_REQ_set_msg_imprint(request.get(), imprint.get()) == 1 &&
                   TS_REQ_set_nonce(request.get(), nonce.get()) == 1 && TS_REQ_set_cert_req(request.get(), 1) == 1;
  AXIOMETRY_CONTRACT(set);
  unsigned char* der = nullptr;
  const int size = i2d_TS_REQ(request.get(), &der);
  AXIOMETRY_CONTRACT(size > 0);
  std::string text(reinterpret_cast<const char*>(der), static_cast<std::size_t>(size));
  OPENSSL_free(der);
  return text;
}

Result<TimeStamp> read_time_stamp(std::string_view answer, std::string_view bytes, std::string_view trusted) {
  AXIOMETRY_TRY(const Owned<TS_RESP> given, granted_answer(answer));
  AXIOMETRY_TRY(auto store, store_of(trusted));
  AXIOMETRY_TRY(const auto moment, moment_of(given.get()));
  // Certificates of authorities live for some years, stamps for longer: what counts is the moment of the stamp.
  X509_VERIFY_PARAM_set_time(X509_STORE_get0_param(store.get()), moment.first);
  const Owned<TS_VERIFY_CTX> checks = checks_of_bytes(bytes);
  TS_VERIFY_CTX_add_flags(checks.get(), TS_VFY_SIGNATURE);
  TS_VERIFY_CTX_set_store(checks.get(), store.release());
  AXIOMETRY_TRY_VOID(verify(given.get(), checks.get()));
  return TimeStamp{moment.second, signer_of(given.get())};
}

Result<void> check_answer(std::string_view answer, std::string_view request) {
  AXIOMETRY_TRY(const Owned<TS_RESP> given, granted_answer(answer));
  return verify(given.get(), checks_of_request(request).get());
}

Result<void> check_stamped(std::string_view answer, std::string_view bytes) {
  AXIOMETRY_TRY(const Owned<TS_RESP> given, granted_answer(answer));
  return verify(given.get(), checks_of_bytes(bytes).get());
}

}  // namespace axiometry
