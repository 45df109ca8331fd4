// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/attested.h"

#include <fmt/format.h>

#include "axiometry/base/json.h"

namespace axiometry::store {
namespace {

std::string key(const std::string& subject, int version) { return fmt::format("{} {}", subject, version); }

}  // namespace

void Attested::learn(const AuditEntry& entry) {
  if (entry.action == "test.withdrawn" || entry.action == "test.reinstated")
    withdrawn_[entry.subject] = entry.action == "test.withdrawn";
  const auto detail = json::parse(entry.detail);
  if (!detail || !detail->is(json::Kind::object)) return;
  const json::Value* hash = detail->find("sha256");
  const json::Value* version = detail->find("version");
  if (hash == nullptr || !hash->is(json::Kind::text)) return;
  const bool versioned = version != nullptr && version->is(json::Kind::number);
  hashes_[key(entry.subject, versioned ? static_cast<int>(version->number()) : 0)] = hash->text();
  ++counts_[entry.subject.substr(0, entry.subject.find(' '))];
}

bool Attested::knows(const std::string& subject, int version, const std::string& sha256) const {
  const auto found = hashes_.find(key(subject, version));
  return found != hashes_.end() && found->second == sha256;
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
