// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "axiometry/base/result.h"

/// The log (-wal) that SQLite keeps beside a file: whether it is as it was written. Who may write and opens the file
/// takes what SQLite reads of the log for all, and throws the log away.
namespace axiometry::store {

/// A log as far as it is whole. Each page in it has a sum over all in front of it and the salts of its log; pages of an
/// earlier log, with other salts, may stand behind those that count.
struct LogState {
  std::int64_t pages = 0;      ///< from the first one on that are as they were written
  std::int64_t kept = 0;       ///< of these, up to the last one of a change; the change behind them is passed over
  std::int64_t behind = 0;     ///< finished changes behind that one, passed over too
  bool is_finished = false;    ///< whether the change that is passed over has its last page
  bool altered_head = false;   ///< and there are pages
  bool altered_salts = false;  ///< the page behind those that are whole is theirs by its sum, but not by its salts

  /// A change is begun when the one in front of it is safe on the disk: of two none can be half written. One may be.
  bool is_damaged() const { return altered_head || altered_salts || behind > 0; }
  /// The last change is not whole: nobody can tell whether power was lost or somebody has altered it.
  bool is_undecided() const { return is_finished && !is_damaged(); }
  bool operator==(const LogState&) const = default;
};

/// Of a log as the SQLite file format has it; of one that is too short for a page nothing.
LogState log_state(std::istream& log);

/// Of the log beside this file, which others may write meanwhile; nothing where there is none.
LogState log_beside(const std::string& file);

/// Fails where the log beside the file is damaged.
Result<void> check_log_beside(const std::string& file);

/// What is to be said of an undecided one.
std::string note_of_log(const LogState& state);

}  // namespace axiometry::store
