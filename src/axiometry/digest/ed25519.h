// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Signatures by Ed25519 (RFC 8032): who holds the public key can tell what the holder of the private one has signed.
namespace axiometry {

class SigningKey {
 public:
  /// A new one from the system's source of random numbers.
  static SigningKey make();
  /// As pem() spells it; nothing where it is none.
  static std::optional<SigningKey> from_pem(std::string_view pem);

  std::string pem() const;                              ///< private key, PKCS #8 without a password
  std::string public_key() const;                       ///< 64 lower-case hexadecimal digits
  std::string signature(std::string_view bytes) const;  ///< 128 of them

 private:
  explicit SigningKey(std::string secret) : secret_(std::move(secret)) {}

  std::string secret_;  // the 32 bytes that RFC 8032 calls the private key
};

/// Whether the holder of that key has signed these bytes; not where key or signature are none at all.
bool is_signed(std::string_view bytes, std::string_view signature, std::string_view public_key);

}  // namespace axiometry
