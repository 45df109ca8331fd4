// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/workbench/from_archive/from_archive.h"
#include "axiometry/app/workbench/test_options.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/table/generic_delimited.h"
#include "axiometry/language/language.h"
#include "axiometry/model/series.h"
#include "axiometry/model/test.h"
#include "axiometry/report/report.h"
#include "axiometry/store/store.h"

/// What goes into the workbench and comes out of it (workbench.h). workbench_json.h spells it as JSON.
namespace axiometry::app {

/// A file as somebody sends it. The bytes must outlive the call.
struct Upload {
  std::string name;  ///< as sent; only its last part counts, and nothing is looked for under it
  std::string_view bytes;
  std::optional<store::Id> plan{};                  ///< plan after which the test was made
  std::optional<formats::ImportProfile> profile{};  ///< profile by which a table of any layout is read
  /// SHA-256 of contents as which the file may have been sent before, nobody knows whether it came: a test that has its
  /// name and one of these is the answer, and nothing is kept.
  std::vector<std::string> perhaps_kept_as{};
};

/// What may be tried with a test without keeping it.
struct Draft {
  Changes changes;
  TestOptions options;
};

struct Revision {
  Draft draft;
  int base_version = 0;
  std::string title;  ///< empty: as it is
  std::string reason{};
  std::optional<store::Id> plan{};  ///< none: as it is
};

/// One evaluation.
struct Outcome {
  json::Value result;                 ///< docs/results.md; of a version what was kept, and what changed since
  Series readings;                    ///< readings that were evaluated
  std::optional<Series> as_measured;  ///< readings before corrections, where there were any
  FromArchive from_archive;           ///< inputs of instruments and limits of the axis that took part
  double milliseconds = 0.0;          ///< time that the evaluation took
};

/// A test of a file that is only looked at.
struct PreviewedTest {
  std::string name;  ///< name in a file of many; else empty
  Metadata metadata;
  Series readings;
  std::optional<Outcome> outcome;  ///< outcome of each of the first eight
};

/// A table whose columns a person may say the meaning of.
struct AskedTable {
  formats::ImportProfile profile;                 ///< as guessed, or as given; what is open is null
  std::vector<formats::GuessDecision> questions;  ///< questions that the guess leaves open
  std::vector<std::string> names;                 ///< names of the columns; empty without a header
  std::vector<std::vector<std::string>> rows;     ///< the first ones
};

/// What a file without a measured test may be that has a page of its own.
enum class OtherFile { recording, error_motion, plan, temperatures };

struct Preview {
  std::string file_name;
  std::size_t size = 0;
  std::string sha256;
  std::string format;            ///< id; empty when none was recognised
  std::optional<Error> refused;  ///< then there are no tests
  std::optional<OtherFile> instead;  ///< what a refused file is
  std::vector<PreviewedTest> tests;
  std::vector<store::Id> same_content;  ///< tests of the archive with these very bytes
  /// Of a file that was refused and holds a table of numbers all the same, and of one that was read after a guess or a
  /// profile.
  std::optional<AskedTable> table;
};

struct ReceivedTest {
  store::Id id = 0;
  std::string title;
  std::vector<store::Id>
      same_content;                    ///< tests of other files with the bytes of its file, of before or of this upload
  std::vector<std::string> remarks{};  ///< what became of the machine that it states
};

struct Received {
  std::vector<ReceivedTest> tests;      ///< never empty; each at version 1 unless it was there (perhaps_kept_as)
  std::vector<store::Id> same_content;  ///< tests of before with the bytes of any of the files
  Outcome first;
};

/// A test of the archive as one of its versions evaluates it: with its metadata and corrections.
struct PreparedTest {
  store::TestRecord record;
  Test test;
};

/// A test of the archive at one of its versions.
struct KeptTest {
  store::TestRecord record;
  std::size_t size = 0;                 ///< bytes of the file
  std::vector<store::Change> versions;  ///< the first is version 1
  std::optional<store::MachineRecord> machine;
  std::optional<store::AxisRecord> axis;
  std::vector<store::Versioned<store::InstrumentRecord>> instruments;
  std::vector<store::DocumentRecord> documents;
  Draft draft;                                      ///< draft of this version
  std::optional<formats::ImportProfile> profile{};  ///< profile by which its file is read, where it came with one
  Outcome outcome;
};

struct ReportRequest {
  std::string extension;  ///< ending of a writer's files, or "json": the result that was kept
  report::Options options{};
  language::Language language = language::Language::english;
  std::stop_token stop{};
};

/// Media type of what has none of its own.
inline constexpr std::string_view octets = "application/octet-stream";

/// Of files that this program makes, by their extension in small letters.
std::string_view media_type_of(std::string_view extension);

/// A file that was made.
struct Rendered {
  std::string bytes;
  std::string media_type;
  std::string file_name;
};

struct Attachment {
  std::string name;
  std::string media_type;  ///< as sent; empty or malformed: application/octet-stream
  std::string_view bytes;
};

}  // namespace axiometry::app
