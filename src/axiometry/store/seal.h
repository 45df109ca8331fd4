// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"

/// Seals: the end of an audit trail at some moment, signed and kept elsewhere. The trail of a later day must go through
/// it; so entries that were taken away at its end are missed, which nothing inside an archive can show.
namespace axiometry {
class SigningKey;
}
namespace axiometry::store {

/// The last entry of an audit trail, in whose hash all in front of it are.
struct Head {
  std::int64_t entries = 0;
  std::string sha256;  ///< empty without any entry
  std::string at;
};

struct Seal {
  Head head;
  std::string at;          ///< when it was made; RFC 3339, UTC
  std::string public_key;  ///< Ed25519, 64 hexadecimal digits
  std::string signature;   ///< over signed_text(), 128 of them
};

/// What a seal signs (docs/theory/archive.md).
std::string signed_text(const Seal& seal);

Seal sealed(const Head& head, const SigningKey& key);

/// As a small text file, JSON.
std::string text_of(const Seal& seal);

/// Fails on what is no seal, and on one that the key it names has not signed as it is.
Result<Seal> read_seal(std::string_view text);

}  // namespace axiometry::store
