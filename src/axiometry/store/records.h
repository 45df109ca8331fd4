// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What the archive keeps. Plain values; texts that are empty and optionals that are absent mean "not given". Times are
/// RFC 3339 in UTC, "2026-11-22T09:30:00.123Z"; dates are "2026-11-22" or what the file said.
namespace axiometry::store {

/// Counted from 1 without gaps in each table, so that a missing number would be a lost record.
using Id = std::int64_t;
inline constexpr Id id_max = 0x7fff'ffff;  ///< of what a column of PostgreSQL holds; no record has a greater one

/// Who changes something, and why.
struct By {
  std::string actor;   ///< "import", a person's name as given
  std::string reason;  ///< may be empty
};

/// A By with its time, as it stands in the archive.
struct Change {
  std::string at;
  std::string actor;
  std::string reason;

  friend bool operator==(const Change&, const Change&) = default;
};

/// What is known as one thing over time, edited by versions that all stay. Versions count from 1.
template <typename Asset>
struct Versioned {
  Id id = 0;
  int version = 1;
  Change change;  ///< of this version
  Asset value;
};

struct Machine {
  std::string name;
  std::string manufacturer;
  std::string type;
  std::string serial_number;
  std::string controller;
  std::string location;
  std::string notes;
};

/// A limit of a parameter in the native unit of its axis (µm or ″).
struct Limit {
  std::string parameter;  ///< key: "A", "R_up"
  double value = 0.0;
};

struct Axis {
  Id machine = 0;
  std::string name;  ///< "X"
  std::string kind;  ///< "linear" or "rotary"
  std::vector<Limit> limits;
  std::string notes;
};

struct Instrument {
  std::string role;  ///< "Laser interferometer"
  std::string manufacturer;
  std::string type;
  std::string serial_number;
  std::string certificate;
  std::string calibrated_on;
  std::string calibration_due;
  /// Metadata that a test with this instrument takes from it: key and text as for `--set`.
  std::vector<std::pair<std::string, std::string>> inputs;
  std::string notes;
};

struct PlanRecord {
  std::string title;
  std::optional<Id> axis;
  std::string content;  ///< SHA-256 of the plan's JSON
};

}  // namespace axiometry::store
