// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/seal.h"

#include <fmt/format.h>

#include "axiometry/base/json/json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/digest/ed25519.h"
#include "axiometry/store/database/clock.h"
#include "axiometry/store/records.h"

namespace axiometry::store {
namespace {

constexpr std::size_t digits_of_short_head = 16;
constexpr std::string_view seal_format = "axiometry-seal-1";

Result<std::string> text_member(const json::Value& root, std::string_view name) {
  const json::Value* value = root.find(name);
  if (value == nullptr || !value->is(json::Kind::text))
    return fail(fmt::format("found no text {} in a seal, expected one", text::quoted(name)));
  return value->text();
}

Result<std::int64_t> entries_member(const json::Value& root) {
  const json::Value* value = root.find("entries");
  const double number = value != nullptr && value->is(json::Kind::number) ? value->number() : 0.0;
  if (!(number >= 1.0 && number <= static_cast<double>(id_max)) ||
      number != static_cast<double>(static_cast<Id>(number)))
    return fail("found no number of entries in a seal, expected a whole one of at least 1");
  return static_cast<std::int64_t>(number);
}

}  // namespace

std::string short_text(const Head& head) {
  return fmt::format("{}:{}", head.entries, head.sha256.substr(0, digits_of_short_head));
}

Result<Head> read_short_head(std::string_view text) {
  const auto parts = text::split(text::trim(text), ':');
  const auto number = parse_count(parts[0]);
  const std::string digits = parts.size() == 2 ? text::to_lower(parts[1]) : "";
  const bool sound = number && *number >= 1 && *number <= static_cast<std::uint64_t>(id_max) &&
                     digits.size() >= digits_of_short_head && digits.size() <= 64 &&
                     digits.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!sound)
    return fail(
        fmt::format("found {} as the head of an audit trail, expected its number and 16 to 64 digits of its "
                    "hash as a report says them: 17:3f2a9c0b1d2e4f56",
                    text::quoted(text)));
  return Head{static_cast<std::int64_t>(*number), digits, ""};
}

std::string signed_text(const Seal& seal) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n", seal_format, seal.head.entries, seal.head.sha256, seal.head.at, seal.at);
}

Seal sealed(const Head& head, const SigningKey& key) {
  Seal seal{.head = head, .at = now_text(), .public_key = key.public_key(), .signature = ""};
  seal.signature = key.signature(signed_text(seal));
  return seal;
}

std::string text_of(const Seal& seal) {
  json::Value root = json::Value::object();
  root.add("format", seal_format);
  root.add("entries", static_cast<double>(seal.head.entries));
  root.add("sha256", seal.head.sha256);
  root.add("entry_at", seal.head.at);
  root.add("sealed_at", seal.at);
  root.add("public_key", seal.public_key);
  root.add("signature", seal.signature);
  return json::dump(root) + "\n";
}

Result<Seal> read_seal(std::string_view text) {
  AXIOMETRY_TRY(const json::Value root, json::parse(text));
  if (!root.is(json::Kind::object)) return fail("found no JSON object, expected a seal");
  AXIOMETRY_TRY(const std::string format, text_member(root, "format"));
  if (format != seal_format)
    return fail(fmt::format("found the format {}, expected {}", text::quoted(format), seal_format));
  Seal seal;
  AXIOMETRY_TRY(seal.head.entries, entries_member(root));
  AXIOMETRY_TRY(seal.head.sha256, text_member(root, "sha256"));
  AXIOMETRY_TRY(seal.head.at, text_member(root, "entry_at"));
  AXIOMETRY_TRY(seal.at, text_member(root, "sealed_at"));
  AXIOMETRY_TRY(seal.public_key, text_member(root, "public_key"));
  AXIOMETRY_TRY(seal.signature, text_member(root, "signature"));
  if (!is_signed(signed_text(seal), seal.signature, seal.public_key))
    return fail(ErrorKind::damaged,
                "found a seal that its key has not signed as it is, expected it unchanged since it was made");
  return seal;
}

}  // namespace axiometry::store
