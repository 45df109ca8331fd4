// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/test.h"

/// What is to be said of a test, beside its figures.
namespace axiometry::iso230_2 {

enum class Severity {
  departure,  ///< the test departs from the standard: it may not be called a test after ISO 230-2
  missing,    ///< something the report shall state (clause 8) was not given
  note,       ///< worth knowing; nothing is wrong
};

std::string_view severity_name(Severity severity);  ///< "departure", "missing", "note"

/// In place of a clause, of what the reader of the file found (Provenance::remarks) and not of a rule of the standard.
inline constexpr const char* source_clause = "source";

/// A deviation within a message, "2.99 µm", so that whoever shows the message may show it in another unit.
struct MessageDeviation {
  std::size_t at = 0;      ///< number of its first byte in the message, from 0
  std::size_t length = 0;  ///< number of its bytes, unit included
  Deviation value;
};

/// One departure, omission or remark, with the clause it rests on.
struct Finding {
  std::string id;      ///< stable, what it is about and not its numbers: "number-of-targets"; all in docs/findings.md
  std::string clause;  ///< "5.3.2"; "source"
  Severity severity = Severity::note;
  std::string message;  ///< what was found and what the clause expects; a whole sentence without full stop
  std::vector<MessageDeviation> deviations{};  ///< deviations in the message, in its order
  std::vector<std::string_view>
      fields{};  ///< fields of the metadata that would answer it: their Field::key, which last
};

}  // namespace axiometry::iso230_2
