// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/audit_trail.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/store/proof/fingerprint.h"

namespace axiometry::store {
namespace {

constexpr std::string_view audit_columns = "id, at, actor, reason, action, subject, detail, sha256";
constexpr std::int64_t entries_at_once = 5000;

AuditEntry entry_of(const Row& row) {
  return {.id = row.integer(0),
          .change = {row.text(1), row.text(2), row.text(3)},
          .action = row.text(4),
          .subject = row.text(5),
          .detail = row.text(6),
          .sha256 = row.text(7)};
}

}  // namespace

std::string chained_hash(const std::string& previous, const AuditEntry& entry) {
  return Fingerprint()
      .add(previous)
      .add_cell(Cell(entry.id))
      .add(entry.change.at)
      .add(entry.change.actor)
      .add(entry.change.reason)
      .add(entry.action)
      .add(entry.subject)
      .add(entry.detail)
      .finish();
}

Result<void> record(Connection& connection, const Change& change, const Entry& entry) {
  AXIOMETRY_TRY(const Rows last, connection.query("SELECT id, sha256 FROM audit ORDER BY id DESC LIMIT 1"));
  AuditEntry line{.id = last.empty() ? 1 : last[0].integer(0) + 1,
                  .change = change,
                  .action = std::string(entry.action),
                  .subject = entry.subject,
                  .detail = json::dump(entry.detail, 0),
                  .sha256 = ""};
  line.sha256 = chained_hash(last.empty() ? "" : last[0].text(1), line);
  return connection.run(
      "INSERT INTO audit (id, at, actor, reason, action, subject, detail, sha256) "
      "VALUES ($1, $2, $3, $4, $5, $6, $7, $8)",
      {line.id, change.at, change.actor, change.reason, entry.action, line.subject, line.detail, line.sha256});
}

Result<std::vector<AuditEntry>> entries(Connection& connection, const std::string& subject, std::int64_t before,
                                        std::int64_t limit) {
  limit = std::clamp<std::int64_t>(limit, 0, largest_page);
  const std::int64_t end = before > 0 ? before : 0x7fff'ffff;
  const bool all = subject.empty();
  std::vector<Parameter> parameters = {end, limit};
  if (!all) parameters.emplace_back(subject);
  AXIOMETRY_TRY(const Rows rows,
                connection.query(fmt::format("SELECT {} FROM audit WHERE id < $1 {} ORDER BY id DESC LIMIT $2",
                                             audit_columns, all ? "" : "AND subject = $3"),
                                 parameters));
  std::vector<AuditEntry> found;
  for (const Row& row : rows) found.push_back(entry_of(row));
  return found;
}

Result<std::int64_t> verify_chain(Connection& connection, std::vector<std::string>& problems,
                                  const std::function<void(const AuditEntry&)>& visit) {
  std::string previous;
  std::int64_t last = 0;
  AXIOMETRY_TRY(const Rows first, connection.query("SELECT coalesce(min(id), 1) FROM audit"));
  const auto some_entries = [&](std::string_view relation, std::int64_t id) {
    return connection.query(
        fmt::format("SELECT {} FROM audit WHERE id {} $1 ORDER BY id LIMIT $2", audit_columns, relation),
        {id, entries_at_once});
  };
  for (bool begun = false;; begun = true) {
    AXIOMETRY_TRY(const Rows rows, begun ? some_entries(">", last) : some_entries(">=", first[0].integer(0)));
    if (rows.empty()) return last;
    for (const Row& row : rows) {
      const AuditEntry entry = entry_of(row);
      if (entry.id != last + 1)
        problems.push_back(fmt::format("audit trail: found entry {} after {}, expected {}", entry.id, last, last + 1));
      const std::string expected = chained_hash(previous, entry);
      if (entry.sha256 != expected)
        problems.push_back(
            fmt::format("audit trail: found entry {} with the hash {}, expected {}: it or one in front "
                        "of it was changed",
                        entry.id, entry.sha256, expected));
      visit(entry);
      previous = entry.sha256;
      last = entry.id;
    }
  }
}

}  // namespace axiometry::store
