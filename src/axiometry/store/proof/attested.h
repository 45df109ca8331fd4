// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "axiometry/store/kept/test_records.h"

namespace axiometry::store {

/// How a content was kept.
struct Keeping {
  Change change;
  std::optional<std::string> file_name;  ///< absent where the entry is of a program that did not tell it
  std::optional<std::string> format;
};

/// Where a test came from.
struct Origin {
  std::string sha256;  ///< hash of the file's bytes
  std::string file_name;
  std::string name_in_file;
  std::optional<std::string> format;  ///< absent likewise
  Change received;
};

/// What the audit trail says was kept: by it, rows that were changed, added or taken away behind the program's back
/// are found even when their own hashes were made to fit.
class Attested {
 public:
  /// An entry of the trail. One whose detail is no JSON, or whose version is no number of one, attests no hash.
  void add(const AuditEntry& entry);

  /// Whether this version of "test 12" was kept with this hash; 0 for what has no versions.
  bool knows(const std::string& subject, int version, const std::string& sha256) const;

  /// Null for a test that the trail has not seen received.
  const Origin* origin(const std::string& test) const;
  /// Null for one that the trail does not know.
  const Keeping* kept(const std::string& content) const;

  /// How many versions were kept of all "test"s.
  std::int64_t count(std::string_view table) const;
  bool withdrawn(const std::string& subject) const;

 private:
  std::map<std::string, std::string> hashes_;  // hashes keyed by subject and version
  std::map<std::string, std::int64_t, std::less<>> counts_;
  std::map<std::string, bool> withdrawn_;
  std::map<std::string, Origin> origins_;
  std::map<std::string, Keeping> kept_;
};

}  // namespace axiometry::store
