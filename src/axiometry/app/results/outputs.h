// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/output.h"
#include "axiometry/base/json/json.h"
#include "axiometry/report/report.h"
#include "axiometry/report/writer.h"

namespace axiometry::app {

/// The files that are read, by identity and not by name: no output may take the place of measured data.
class InputFiles {
 public:
  InputFiles() = default;
  explicit InputFiles(std::span<const InputFile> inputs);

  /// Fails where "-" stands for two of them: it brings the bytes of one.
  Result<void> check_standard_input() const;
  /// Fails when the name leads to one of them.
  Result<void> check_spared(const std::string& output) const;

 private:
  std::set<std::pair<dev_t, ino_t>> files_;
  std::size_t standard_inputs_ = 0;
};

/// In the name of a file: its place is taken by the name of each test, or of each line.
inline constexpr std::string_view name_mark = "{name}";

/// Where results go besides the terminal.
struct OutputNames {
  std::string json;                  ///< file, "-" or empty for none
  std::vector<std::string> reports;  ///< files; the extension chooses the writer
  InputFiles inputs;                 ///< must not be among the outputs
  UncertaintyOptions uncertainty;    ///< what was asked for; a table of many tests has columns for it
};

/// Whether an output states findings and the SHA-256 of the source file; a table of many tests does not.
bool state_tests_in_full(const OutputNames& names);

/// Fails on an extension that no writer has (the message lists those there are), and on a name given twice.
Result<void> check_outputs(const OutputNames& names);

/// Fails when one of the names, as far as they are known before {name} is, leads to an input, and as
/// InputFiles::check_standard_input().
Result<void> check_inputs_spared(const OutputNames& names);

/// Sets a document that is not the report of a single test into each of the files, by their extensions. Needs names
/// that check_outputs() let pass. Fails, with the file's name, when one cannot be set or written.
Result<void> write_document(const report::Document& document, std::span<const std::string> files,
                            const report::Options& options);

/// Fails, naming those there are, on an extension that no writer has.
Result<const report::Writer*> document_writer(std::string_view extension);

/// The same as bytes, in one of the writers' formats. Fails as document_writer().
Result<std::string> document_bytes(const report::Document& document, std::string_view extension,
                                   const report::Options& options);

/// Writes JSON and reports of the only test there is.
Result<void> write_outputs(const Evaluated& evaluated, const OutputNames& names, const report::Options& options);

/// A test as it stands among many in one JSON array.
std::string json_line(const Evaluated& evaluated);

/// Writes the outputs of many tests as they come, in memory that does not grow with their number: one
/// JSON array, one combined CSV, and for other reports one file per test, whose name takes the place
/// of "{name}", with a number behind it where another test has that name. The JSON and the CSV appear when commit()
/// succeeds, and not at all otherwise.
class ManyOutputs {
 public:
  /// Fails when a report that is not CSV has no "{name}", the folder of one is not there, or an output cannot be made.
  static Result<ManyOutputs> create(const OutputNames& names, const report::Options& options);

  /// `json` is json_line() of it where that is known already.
  Result<void> add(const Evaluated& evaluated, const std::string& json = {});
  Result<void> add_error(const std::string& file, const Error& error);
  /// Since the last call: of which tests the report has a number, and which one has the name.
  std::vector<std::string> numbered() { return std::exchange(numbered_, {}); }
  Result<void> commit();

 private:
  ManyOutputs() = default;
  Result<void> add_json(std::string_view text);
  std::string own_name(const Evaluated& evaluated);

  report::Options options_;
  InputFiles inputs_;
  UncertaintyOptions uncertainty_;
  std::optional<OutputFile> json_;
  bool json_empty_ = true;
  std::vector<OutputFile> tables_;
  std::vector<std::string> templates_;
  std::map<std::string, std::string> names_taken_;   // report name → the test it belongs to
  std::map<std::string, std::size_t> last_numbers_;  // last number behind each name: nothing is counted anew
  std::vector<std::string> numbered_;
};

}  // namespace axiometry::app
