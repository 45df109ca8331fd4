// SPDX-License-Identifier: Apache-2.0
#include "axiometry/digest/ed25519.h"

#include <fmt/format.h>
#include <openssl/bio.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rand.h>

#include <memory>

#include "axiometry/base/contract.h"
#include "axiometry/digest/raw_bytes.h"

namespace axiometry {
namespace {

constexpr std::size_t key_size = 32;
constexpr std::size_t signature_size = 64;

struct KeyCloser {
  void operator()(EVP_PKEY* key) const { EVP_PKEY_free(key); }
  void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  void operator()(BIO* bytes) const { BIO_free(bytes); }
};
using Key = std::unique_ptr<EVP_PKEY, KeyCloser>;
using SigningContext = std::unique_ptr<EVP_MD_CTX, KeyCloser>;
using Memory = std::unique_ptr<BIO, KeyCloser>;

Key private_key(const std::string& secret) {
  Key key(EVP_PKEY_new_raw_private_key(EVP_PKEY_ED25519, nullptr, raw(secret), secret.size()));
  AXIOMETRY_CONTRACT(key != nullptr);
  return key;
}

std::string hexadecimal(std::string_view bytes) {
  std::string digits;
  for (const char c : bytes) digits += fmt::format("{:02x}", static_cast<unsigned char>(c));
  return digits;
}

std::optional<std::string> from_hexadecimal(std::string_view digits, std::size_t size) {
  if (digits.size() != 2 * size) return {};
  std::string bytes;
  for (std::size_t k = 0; k < digits.size(); k += 2) {
    int value = 0;
    for (const char c : digits.substr(k, 2)) {
      if (!(c >= '0' && c <= '9') && !(c >= 'a' && c <= 'f')) return {};
      value = value * 16 + (c <= '9' ? c - '0' : c - 'a' + 10);
    }
    bytes += static_cast<char>(value);
  }
  return bytes;
}

}  // namespace

SigningKey SigningKey::make() {
  std::string secret(key_size, '\0');
  AXIOMETRY_CONTRACT(RAND_priv_bytes(raw(secret), static_cast<int>(secret.size())) == 1);
  return SigningKey(secret);
}

std::optional<SigningKey> SigningKey::from_pem(std::string_view pem) {
  const Memory memory(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())));
  // Without the last but one OpenSSL would ask the terminal for a password.
  const auto no_password = [](char*, int, int, void*) { return -1; };
  const Key key(PEM_read_bio_PrivateKey(memory.get(), nullptr, no_password, nullptr));
  std::string secret(key_size, '\0');
  std::size_t size = secret.size();
  if (!key || EVP_PKEY_id(key.get()) != EVP_PKEY_ED25519) return {};
  if (EVP_PKEY_get_raw_private_key(key.get(), raw(secret), &size) != 1 || size != key_size) return {};
  return SigningKey(secret);
}

std::string SigningKey::pem() const {
  const Key key = private_key(secret_);
  const Memory memory(BIO_new(BIO_s_mem()));
  AXIOMETRY_CONTRACT(PEM_write_bio_PKCS8PrivateKey(memory.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) ==
                     1);
  char* text = nullptr;
  const long size = BIO_get_mem_data(memory.get(), &text);
  return std::string(text, static_cast<std::size_t>(size));
}

std::string SigningKey::public_key() const {
  const Key key = private_key(secret_);
  std::string bytes(key_size, '\0');
  std::size_t size = bytes.size();
  AXIOMETRY_CONTRACT(EVP_PKEY_get_raw_public_key(key.get(), raw(bytes), &size) == 1);
  return hexadecimal(bytes);
}

std::string SigningKey::signature(std::string_view bytes) const {
  const Key key = private_key(secret_);
  const SigningContext context(EVP_MD_CTX_new());
  std::string made(signature_size, '\0');
  std::size_t size = made.size();
  AXIOMETRY_CONTRACT(EVP_DigestSignInit(context.get(), nullptr, nullptr, nullptr, key.get()) == 1);
  AXIOMETRY_CONTRACT(EVP_DigestSign(context.get(), raw(made), &size, raw(bytes), bytes.size()) == 1);
  return hexadecimal(made);
}

bool is_signed(std::string_view bytes, std::string_view signature, std::string_view public_key) {
  const auto made = from_hexadecimal(signature, signature_size);
  const auto point = from_hexadecimal(public_key, key_size);
  if (!made || !point) return false;
  const Key key(EVP_PKEY_new_raw_public_key(EVP_PKEY_ED25519, nullptr, raw(std::string_view(*point)), point->size()));
  const SigningContext context(EVP_MD_CTX_new());
  return key != nullptr && EVP_DigestVerifyInit(context.get(), nullptr, nullptr, nullptr, key.get()) == 1 &&
         EVP_DigestVerify(context.get(), raw(std::string_view(*made)), made->size(), raw(bytes), bytes.size()) == 1;
}

}  // namespace axiometry
