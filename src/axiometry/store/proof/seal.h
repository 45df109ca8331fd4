// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
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

/// As a report in somebody's hand says it: number and the first 16 digits of the hash, "17:3f2a9c0b1d2e4f56".
std::string short_text(const Head& head);

/// Of such a text, with 16 to 64 digits; `at` stays empty.
Result<Head> read_short_head(std::string_view text);

struct Seal {
  Head head;
  std::string at;          ///< when it was made; RFC 3339, UTC
  std::string public_key;  ///< Ed25519, 64 hexadecimal digits
  std::string signature;   ///< signature over signed_text(), 128 hexadecimal digits
};

/// How a new seal follows an older one.
struct Sealing {
  std::optional<Seal> earlier{};  ///< the trail must go on from it
  bool change_key = false;        ///< even where another key has signed that one
};

/// What a seal signs (docs/theory/archive.md).
std::string signed_text(const Seal& seal);

Seal sealed(const Head& head, const SigningKey& key);

/// As a small text file, JSON.
std::string text_of(const Seal& seal);

/// Fails on what is no seal, and on one that the key it names has not signed as it is.
Result<Seal> read_seal(std::string_view text);

}  // namespace axiometry::store
