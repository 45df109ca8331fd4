// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/documents.h"

#include <fmt/format.h>

#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/store/database/clock.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/test_versions.h"
#include "axiometry/store/proof/audit_trail.h"
#include "axiometry/store/proof/fingerprint.h"

namespace axiometry::store {
namespace {

constexpr std::string_view document_columns =
    "id, test, version, kind, name, media_type, language, content, size, at, actor, reason";

std::string_view kind_name(DocumentRecord::Kind kind) {
  return kind == DocumentRecord::Kind::report ? "report" : "attachment";
}

DocumentRecord::Kind document_kind(std::string_view name) {
  for (const DocumentRecord::Kind kind : {DocumentRecord::Kind::report, DocumentRecord::Kind::attachment})
    if (kind_name(kind) == name) return kind;
  throw DamagedCell();
}

DocumentRecord document_of(const Row& row) {
  return {.id = row.integer(0),
          .test = row.integer(1),
          .version = row.number(2),
          .kind = document_kind(row.text(3)),
          .name = row.text(4),
          .media_type = row.text(5),
          .language = row.text(6),
          .sha256 = row.text(7),
          .size = row.integer(8),
          .change = {row.text(9), row.text(10), row.text(11)}};
}

std::unexpected<Error> no_content(const std::string& hash) {
  return fail(ErrorKind::not_found,
              fmt::format("found no bytes with the SHA-256 {}, expected some", text::quoted(hash)));
}

}  // namespace

std::string fingerprint(const DocumentRecord& d) {
  return Fingerprint()
      .add_cell(d.id)
      .add_cell(d.test)
      .add_cell(std::int64_t{d.version})
      .add(kind_name(d.kind))
      .add(d.name)
      .add(d.media_type)
      .add(d.language)
      .add(d.sha256)
      .add_cell(d.size)
      .add(d.change.at)
      .add(d.change.actor)
      .add(d.change.reason)
      .finish();
}

Result<DocumentRecord> write_document(Connection& connection, const DocumentRecord& document, std::string_view bytes,
                                      const By& by) {
  AXIOMETRY_TRY(const TestVersion version, read_version(connection, document.test, document.version));
  DocumentRecord written = document;
  written.change = change_now(by);
  written.sha256 = sha256(bytes);
  written.size = static_cast<std::int64_t>(bytes.size());
  const Content content{written.sha256, written.name, written.media_type, std::string(bytes)};
  AXIOMETRY_TRY_VOID(keep_content(connection, content, written.change));
  AXIOMETRY_TRY(written.id, next_id(connection, "document"));
  const std::string_view kind = kind_name(written.kind);
  AXIOMETRY_TRY_VOID(connection.run(
      fmt::format("INSERT INTO document ({}) VALUES ({})", document_columns, places(1, 12)),
      {written.id, version.test, version.version, kind, written.name, written.media_type, written.language,
       written.sha256, written.size, written.change.at, written.change.actor, written.change.reason}));
  json::Value detail = json::Value::object();
  detail.add("test", static_cast<double>(version.test));
  detail.add("test_version", version.version);
  detail.add("name", written.name);
  detail.add("content", written.sha256);
  detail.add("sha256", fingerprint(written));
  AXIOMETRY_TRY_VOID(record(connection, written.change,
                            {fmt::format("{}.added", kind), fmt::format("document {}", written.id), detail}));
  return written;
}

Result<std::vector<DocumentRecord>> documents_of(Connection& connection, Id test) {
  AXIOMETRY_TRY(const TestHead head, read_head(connection, test));
  AXIOMETRY_TRY(const Rows rows,
                connection.query(fmt::format("SELECT {} FROM document WHERE test = $1 ORDER BY id", document_columns),
                                 {head.id}));
  std::vector<DocumentRecord> documents;
  for (const Row& row : rows) documents.push_back(document_of(row));
  return documents;
}

Result<DocumentRecord> read_document(Connection& connection, Id id) {
  AXIOMETRY_TRY(const Rows rows,
                connection.query(fmt::format("SELECT {} FROM document WHERE id = $1", document_columns), {id}));
  if (rows.empty()) return fail(ErrorKind::not_found, fmt::format("found no document {}, expected one", id));
  return document_of(rows[0]);
}

Result<std::int64_t> content_size(Connection& connection, const std::string& hash) {
  AXIOMETRY_TRY(const Rows rows, connection.query("SELECT size FROM content WHERE sha256 = $1", {hash}));
  if (rows.empty()) return no_content(hash);
  return rows[0].integer(0);
}

Result<Content> read_content(Connection& connection, const std::string& hash) {
  AXIOMETRY_TRY(const Rows rows,
                connection.query("SELECT file_name, format, bytes FROM content WHERE sha256 = $1", {hash}));
  if (rows.empty()) return no_content(hash);
  Content content{hash, rows[0].text(0), rows[0].text(1), rows[0].text(2)};
  if (const std::string found = sha256(content.bytes); found != hash)
    return fail(ErrorKind::damaged, fmt::format("found bytes with the SHA-256 {}, expected {}: they were changed after "
                                                "they were kept",
                                                found, hash));
  return content;
}

Result<std::vector<std::string>> list_contents(Connection& connection, std::string_view format) {
  AXIOMETRY_TRY(const Rows rows,
                connection.query("SELECT sha256 FROM content WHERE format = $1 ORDER BY id", {format}));
  std::vector<std::string> hashes;
  for (std::size_t k = 0; k < rows.size(); ++k) hashes.push_back(rows[k].text(0));
  return hashes;
}

}  // namespace axiometry::store
