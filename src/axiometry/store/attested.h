// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "axiometry/store/test_records.h"

namespace axiometry::store {

/// What the audit trail says was kept: by it, rows that were changed, added or taken away behind the program's back
/// are found even when their own hashes were made to fit.
class Attested {
 public:
  /// An entry of the trail. One whose detail is no JSON attests nothing.
  void learn(const AuditEntry& entry);

  /// Whether this version of "test 12" was kept with this hash; 0 for what has no versions.
  bool knows(const std::string& subject, int version, const std::string& sha256) const;

  /// How many versions were kept of all "test"s.
  std::int64_t count(std::string_view table) const;
  bool withdrawn(const std::string& subject) const;

 private:
  std::map<std::string, std::string> hashes_;  // by subject and version
  std::map<std::string, std::int64_t, std::less<>> counts_;
  std::map<std::string, bool> withdrawn_;
};

}  // namespace axiometry::store
