// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/store/kept/latest_tests.h"
#include "axiometry/store/records.h"

/// Tests in the archive, and what is found of them.
namespace axiometry::store {

/// A parameter of an evaluation as lists and trends show it, in the native unit.
struct FigureRecord {
  std::string parameter;  ///< key: "A"
  double value = 0.0;
  std::optional<double> U;      ///< expanded; absent where none was found, and of a method that states an interval
  std::optional<double> limit;  ///< limit of the tolerance
  std::string verdict;          ///< "conforms", "does not conform", "undecided" or empty without limit
  std::optional<double> low{};  ///< low end of the stated interval: value ± U, or one that is not symmetric
  std::optional<double> high{};
  std::string method{};  ///< method of record: "annex_a", "gum", "monte_carlo"; empty in versions older than that
};

/// What was computed of one version of a test.
struct EvaluationRecord {
  std::string program;                ///< "axiometry 0.1.0"
  std::string standard;               ///< "ISO 230-2:2014"
  std::string options;                ///< JSON: all that the result depends on beside data and metadata
  std::optional<std::uint64_t> seed;  ///< seed where random numbers were drawn
  std::string result;                 ///< JSON (docs/results.md)
  std::string unit;                   ///< "um" or "arcsec"
  bool conforming = false;            ///< whether it conforms to the standard
  std::string verdict;                ///< verdict on all tolerances together; empty without any
  std::string label;                  ///< must stand wherever the results do; mostly empty
  std::vector<FigureRecord> figures;
};

/// Everything about a test that an edit may change. The measured bytes are not among it.
struct TestState {
  std::string title;  ///< how people call it; from the file's name or the report number to begin with
  /// As stated; the archive finds the machine with the same serial number, or name, or adds one.
  MachineRecord machine;
  AxisRecord axis;                            ///< likewise among the machine's axes, by name; `machine` is ignored
  std::vector<InstrumentRecord> instruments;  ///< likewise by serial number, or by manufacturer and type
  std::optional<Id> plan;
  std::string measured_on;  ///< "2014-05-15"; empty where the metadata state no date that can be read as one
  std::string changes;      ///< JSON object: metadata over what the file says, key and text
  EvaluationRecord evaluation;
};

/// More than this no content may have: PostgreSQL gives bytes as two digits each, in answers below 1 GiB, and what can
/// be kept in one database shall fit the other.
inline constexpr std::size_t content_bytes_max = std::size_t{500} << 20;

/// No page of the list of tests, or of the audit trail, has more lines than this, whatever is asked for.
inline constexpr std::int64_t largest_page = 1000;

/// The measured bytes as they came. Never changed.
struct Content {
  std::string sha256;
  std::string file_name;  ///< as the user gave it, without folders
  std::string format;     ///< id of the format that reads it
  std::string bytes;
};

/// One test of a file that arrives.
struct NewTest {
  std::string name_in_file;  ///< name of one among many; else empty
  TestState state;
};

struct TestRecord {
  Id id = 0;
  int version = 1;  ///< number of this version
  int latest = 1;
  std::string sha256;
  std::string file_name;
  std::string format;
  std::string name_in_file;
  Change received;         ///< change that received the data
  Change change;           ///< change that made this version
  bool withdrawn = false;  ///< kept, but out of lists and trends
  std::optional<Id> machine;
  std::optional<Id> axis;
  std::vector<Id> instruments;
  TestState state;  ///< machine and axis as they are called now
};

/// One line of a list: no JSON is read for it.
struct TestRow {
  Id id = 0;
  int version = 1;
  std::string title;
  std::string file_name;
  std::optional<Id> machine;
  std::string machine_name;
  std::optional<Id> axis;
  std::string axis_name;
  std::string axis_kind;
  std::string unit;
  std::string measured_on;
  std::string received_at;
  bool conforming = false;
  bool withdrawn = false;
  std::string verdict;
  std::string label;
  std::vector<FigureRecord> figures;  ///< A, E, R and B, as far as there are; of one direction A_up or A_down, …
};

struct TestFilter {
  std::string text;  ///< words in title, file, machine or axis name; any case
  std::optional<Id> machine;
  std::optional<Id> axis;
  std::optional<Id> instrument;
  std::string measured_from;  ///< dates, both included
  std::string measured_to;
  std::string verdict;
  std::string sha256;
  bool withdrawn = false;  ///< show withdrawn ones too
  enum class Order { received, measured, title, machine, A, E, R, B } order = Order::received;
  bool descending = true;
  std::int64_t offset = 0;
  std::int64_t limit = 50;  ///< most records, at most largest_page
};

struct TestPage {
  std::vector<TestRow> rows;
  std::int64_t total = 0;  ///< number without limit and offset
};

/// A test's place in the history of its axis.
struct TrendPoint {
  Id test = 0;
  int version = 1;
  std::string title;
  std::string measured_on;
  std::string received_at;
  std::string unit;
  bool conforming = false;
  std::string label;
  std::string verdict{};              ///< verdict on all tolerances together; empty without any
  std::vector<FigureRecord> figures;  ///< figures of the parameters that were asked for
  std::vector<Id> same_bytes{};       ///< kept of the same bytes too: one measurement, which counts once
};

/// A report as it was issued: bytes that never change. Attachments (photographs, certificates) likewise.
struct DocumentRecord {
  Id id = 0;
  Id test = 0;
  int version = 1;  ///< version of the test
  enum class Kind { report, attachment } kind = Kind::report;
  std::string name;        ///< name of the file
  std::string media_type;  ///< "application/pdf"
  std::string language;    ///< language of a report; else empty
  std::string sha256;
  std::int64_t size = 0;
  Change change;
};

/// One line of the audit trail. Each carries the hash of itself and of the line before: none can be changed, taken
/// away or put between without breaking the chain.
struct AuditEntry {
  Id id = 0;
  Change change;
  std::string action;   ///< "test.received", "test.revised", "machine.changed", "store.restored"
  std::string subject;  ///< "test 12"
  std::string detail;   ///< JSON object
  std::string sha256;
};

}  // namespace axiometry::store
