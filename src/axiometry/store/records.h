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
inline constexpr Id id_max = 0x7fff'ffff;  ///< largest number in a column of PostgreSQL; no record has a greater one

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

/// An asset over time: what is edited by versions that all stay. Versions count from 1.
template <typename Asset>
struct Versioned {
  Id id = 0;
  int version = 1;
  Change change;  ///< change that made this version
  Asset value;
};

struct MachineRecord {
  std::string name;
  std::string manufacturer;
  std::string type;
  std::string serial_number;
  std::string controller;
  std::string location;
  std::string notes;
};

/// Which machine of the archive a test means by what it states.
struct MachineMeant {
  std::optional<Versioned<MachineRecord>> known;  ///< absent where one is added
  bool takes_number = false;  ///< known by its name, it never had a serial number and takes the test's
  std::size_t others = 0;     ///< called so too, where the test says no number that would tell them apart
};

/// A limit of a parameter in the native unit of its axis (µm or ″).
struct Limit {
  std::string parameter;  ///< key: "A", "R_up"
  double value = 0.0;
};

struct AxisRecord {
  Id machine = 0;
  std::string name;  ///< "X"
  std::string kind;  ///< "linear" or "rotary"
  std::vector<Limit> limits;
  std::string notes;
};

struct InstrumentRecord {
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

/// A file that belongs to a calibration or a compensation; its bytes are a content.
struct KeptFile {
  std::string role;     ///< "lengths", "plan", "station" or "machine"; of a compensation "table" or "existing"
  std::string name;     ///< as the user gave it, without folders
  std::string content;  ///< SHA-256
};

/// A figure by which a calibration or a compensation is known in a list, in the order in which they are shown.
struct KeptFigure {
  std::string parameter;  ///< "A", "volume_largest"
  std::string of;         ///< a line of the plan, a tool, a state of the axis ("before"); empty: of the whole
  double value = 0.0;
  std::optional<double> u;  ///< standard uncertainty; absent where none was found
  std::string unit;         ///< "um", "arcsec", "urad", or empty of a number
};

/// What a tracking interferometer found of a machine as a whole. Its result is a content, so that a list reads none.
struct CalibrationRecord {
  std::string kind;  ///< calibration_kinds.h: "lines" of a plan, "volumetric": the 21 errors, and others
  std::string title;
  std::optional<Id> machine;
  std::optional<Id> instrument;
  std::optional<int> instrument_version;  ///< as it was known then; present with `instrument`
  std::string measured_on;                ///< date as of a test
  std::string notes;
  bool withdrawn = false;  ///< kept, but out of lists
  std::vector<KeptFile> files;
  std::string program;  ///< "axiometry 0.1.0", which evaluated it
  std::string options;  ///< JSON object: what the result depends on beside the files
  std::string result;   ///< SHA-256 of the result document (JSON, docs/results.md)
  std::string verdict;  ///< verdict on all tolerances together; empty without any
  int serious = 0;      ///< findings after which the result should not be used as it is
  std::vector<KeptFigure> figures;
};

/// A table by which a control corrects an axis: measured, made, perhaps measured again.
struct CompensationRecord {
  Id test = 0;  ///< the test that it is made from
  int test_version = 0;
  std::optional<Id> retest;           ///< the test with the table active
  std::optional<int> retest_version;  ///< present with `retest`
  std::optional<Id> axis;             ///< axis of the test when the table was made
  std::string control;                ///< "linuxcnc"
  std::string notes;
  bool withdrawn = false;       ///< kept, but out of lists
  std::vector<KeptFile> files;  ///< the table, and the one that was active before where there was any
  std::string program;          ///< "axiometry 0.1.0", which made it
  std::string options;          ///< JSON object: what the table depends on beside the test
  std::string result;           ///< SHA-256 of the result document (JSON, docs/results.md)
  int serious = 0;              ///< findings after which the table should not be used as it is
  std::vector<KeptFigure> figures;
};

}  // namespace axiometry::store
