// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/attested.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "axiometry/base/json/json.h"

namespace axiometry::store {
namespace {

std::string key(const std::string& subject, int version) { return fmt::format("{} {}", subject, version); }

std::optional<std::string> text_of(const json::Value& detail, std::string_view name) {
  const json::Value* value = detail.find(name);
  if (value == nullptr || !value->is(json::Kind::text)) return {};
  return value->text();
}

/// 0 of an entry that tells none, as of what has no versions; nothing where it is no number of one.
std::optional<int> told_version(const json::Value& detail) {
  const json::Value* value = detail.find("version");
  if (value == nullptr) return 0;
  if (!value->is(json::Kind::number)) return {};
  const double version = value->number();
  const bool counts = version >= 1.0 && version <= std::numeric_limits<int>::max() && version == std::floor(version);
  return counts ? std::optional(static_cast<int>(version)) : std::nullopt;
}

}  // namespace

void Attested::add(const AuditEntry& entry) {
  if (entry.action == "test.withdrawn" || entry.action == "test.reinstated")
    withdrawn_[entry.subject] = entry.action == "test.withdrawn";
  const auto detail = json::parse(entry.detail);
  if (!detail || !detail->is(json::Kind::object)) return;
  if (entry.action == "test.received")
    origins_[entry.subject] = {text_of(*detail, "content").value_or(""), text_of(*detail, "file").value_or(""),
                               text_of(*detail, "name_in_file").value_or(""), text_of(*detail, "format"), entry.change};
  if (entry.action == "content.kept")
    kept_[entry.subject] = {entry.change, text_of(*detail, "file"), text_of(*detail, "format")};
  const json::Value* hash = detail->find("sha256");
  const auto version = told_version(*detail);
  if (hash == nullptr || !hash->is(json::Kind::text) || !version) return;
  hashes_[key(entry.subject, *version)] = hash->text();
  ++counts_[entry.subject.substr(0, entry.subject.find(' '))];
}

bool Attested::knows(const std::string& subject, int version, const std::string& sha256) const {
  const auto found = hashes_.find(key(subject, version));
  return found != hashes_.end() && found->second == sha256;
}

const Origin* Attested::origin(const std::string& test) const {
  const auto found = origins_.find(test);
  return found == origins_.end() ? nullptr : &found->second;
}

const Keeping* Attested::kept(const std::string& content) const {
  const auto found = kept_.find(content);
  return found == kept_.end() ? nullptr : &found->second;
}

std::int64_t Attested::count(std::string_view table) const {
  const auto found = counts_.find(table);
  return found == counts_.end() ? 0 : found->second;
}

bool Attested::withdrawn(const std::string& subject) const {
  const auto found = withdrawn_.find(subject);
  return found != withdrawn_.end() && found->second;
}

}  // namespace axiometry::store
