// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/outputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <variant>

#include "axiometry/app/files/file_name_part.h"
#include "axiometry/app/results/report_subject.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/told_results.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

std::string_view extension_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos || name.find('/', dot) != std::string_view::npos ? std::string_view()
                                                                                        : name.substr(dot + 1);
}

bool is_table(std::string_view report) { return text::equal_ignoring_case(extension_of(report), "csv"); }

/// Name of a test as part of a file name: its file's stem and, among many, its own name.
std::string report_name(const Evaluated& evaluated) {
  const std::string& file = evaluated.test.provenance.file;
  std::string name = file == "-" ? "stdin" : std::filesystem::path(file).stem().string();
  if (!evaluated.name.empty()) name += "-" + evaluated.name;
  return file_name_part(std::move(name));
}

Result<void> write_report(const Evaluated& evaluated, const std::string& file, const report::Options& options) {
  const report::Writer* writer = report::find_writer(extension_of(file));
  auto bytes = writer->write(report_subject(evaluated), options);
  if (!bytes) return std::unexpected(Error{bytes.error().message, file, {}});
  return write_file(file, *bytes);
}

/// The first "{name}" of a file's name gives way.
std::string with_test_name(std::string report, std::string_view name) {
  if (const auto at = report.find(name_mark); at != std::string::npos) report.replace(at, name_mark.size(), name);
  return report;
}

/// Where a report of each test shall lie, before the first of them is evaluated. A folder that is named after the test
/// is not known yet.
Result<void> check_folder(const std::string& report) {
  const std::string folder = std::filesystem::path(report).parent_path().string();
  std::error_code error;
  if (folder.empty() || folder.contains(name_mark) || std::filesystem::is_directory(folder, error)) return {};
  return std::unexpected(Error{
      fmt::format("found no folder {} for the reports, expected one that is there", text::quoted(folder)), report, {}});
}

bool has_figure(const report::Document& document) {
  return std::ranges::any_of(document.sections, [](const report::Section& section) {
    return std::ranges::any_of(
        section.blocks, [](const report::Block& block) { return std::holds_alternative<report::Figure>(block); });
  });
}

/// A picture shows the figures of a document: without one it would be empty.
Result<void> check_pictures(const report::Document& document, std::span<const std::string> files) {
  for (const std::string& file : files)
    if (const std::string kind = text::to_lower(extension_of(file)); kind == "svg" || kind == "png")
      if (!has_figure(document))
        return fail(fmt::format("found {}, expected html, pdf or csv: there is no figure", text::quoted(file)));
  return {};
}

}  // namespace

Result<void> write_document(const report::Document& document, std::span<const std::string> files,
                            const report::Options& options) {
  AXIOMETRY_TRY_VOID(check_pictures(document, files));
  for (const std::string& file : files) {
    const report::Writer* writer = report::find_writer(extension_of(file));
    auto bytes = writer->set(document, options);
    if (!bytes) return std::unexpected(Error{bytes.error().message, file, {}});
    AXIOMETRY_TRY_VOID(write_file(file, *bytes));
  }
  return {};
}

Result<const report::Writer*> document_writer(std::string_view extension) {
  if (const report::Writer* writer = report::find_writer(extension)) return writer;
  std::vector<std::string_view> extensions;
  for (const report::Writer* writer : report::writer_table()) extensions.push_back(writer->extension);
  return fail(
      fmt::format("found a sheet as {}, expected one of {}", text::quoted(extension), fmt::join(extensions, ", ")));
}

Result<std::string> document_bytes(const report::Document& document, std::string_view extension,
                                   const report::Options& options) {
  AXIOMETRY_TRY(const report::Writer* writer, document_writer(extension));
  return writer->set(document, options);
}

bool state_tests_in_full(const OutputNames& names) {
  return !names.json.empty() || !std::ranges::all_of(names.reports, is_table) ||
         std::ranges::any_of(names.reports, [](const std::string& r) { return r.find(name_mark) != r.npos; });
}

InputFiles::InputFiles(std::span<const InputFile> inputs) {
  for (const InputFile& input : inputs) {
    if (input.name == "-") ++standard_inputs_;
    struct stat status {};
    const int failed = input.name == "-" ? ::fstat(STDIN_FILENO, &status) : ::stat(input.name.c_str(), &status);
    if (failed == 0 && S_ISREG(status.st_mode)) files_.emplace(status.st_dev, status.st_ino);
  }
}

Result<void> InputFiles::check_standard_input() const {
  if (standard_inputs_ < 2) return {};
  return fail("found the standard input twice, expected a file for one of them");
}

Result<void> InputFiles::check_spared(const std::string& output) const {
  struct stat status {};
  if (::stat(output.c_str(), &status) != 0 || !files_.contains({status.st_dev, status.st_ino})) return {};
  return std::unexpected(Error{"found an output that is also an input, expected another name", output, {}});
}

Result<void> check_inputs_spared(const OutputNames& names) {
  AXIOMETRY_TRY_VOID(names.inputs.check_standard_input());
  if (names.json != "-") AXIOMETRY_TRY_VOID(names.inputs.check_spared(names.json));
  for (const std::string& report : names.reports) AXIOMETRY_TRY_VOID(names.inputs.check_spared(report));
  return {};
}

Result<void> check_outputs(const OutputNames& names) {
  std::set<std::string> seen{names.json};
  for (const std::string& report : names.reports)
    if (!seen.insert(report).second)
      return fail(fmt::format("found the output {} twice, expected different names", text::quoted(report)));
  for (const std::string& report : names.reports) {
    if (report::find_writer(extension_of(report)) != nullptr) continue;
    std::vector<std::string_view> extensions;
    for (const report::Writer* writer : report::writer_table()) extensions.push_back(writer->extension);
    return fail(fmt::format("found the report name {}, expected a file ending in .{}", text::quoted(report),
                            fmt::join(extensions, ", .")));
  }
  return {};
}

Result<void> write_outputs(const Evaluated& evaluated, const OutputNames& names, const report::Options& options) {
  for (const std::string& report : names.reports) {
    const std::string file = with_test_name(report, report_name(evaluated));
    AXIOMETRY_TRY_VOID(names.inputs.check_spared(file));
    AXIOMETRY_TRY_VOID(write_report(evaluated, file, options));
  }
  if (!names.json.empty()) AXIOMETRY_TRY_VOID(write_file(names.json, json::dump(to_json(evaluated)) + "\n"));
  return {};
}

Result<ManyOutputs> ManyOutputs::create(const OutputNames& names, const report::Options& options) {
  ManyOutputs outputs;
  outputs.options_ = options;
  outputs.inputs_ = names.inputs;
  outputs.uncertainty_ = names.uncertainty;
  for (const std::string& report : names.reports) {
    const bool each = report.find(name_mark) != std::string::npos;
    if (!each && !is_table(report))
      return fail(
          fmt::format("found the report name {} for many tests, expected one with {} for the name of each test, or a "
                      ".csv for a table of all",
                      text::quoted(report), name_mark));
    if (each) {
      AXIOMETRY_TRY_VOID(check_folder(report));
      outputs.templates_.push_back(report);
      continue;
    }
    AXIOMETRY_TRY(OutputFile table, OutputFile::create(report));
    AXIOMETRY_TRY_VOID(table.write(combined_csv_header(names.uncertainty)));
    outputs.tables_.push_back(std::move(table));
  }
  if (!names.json.empty()) {
    AXIOMETRY_TRY(outputs.json_, OutputFile::create(names.json));
  }
  return outputs;
}

std::string json_line(const Evaluated& evaluated) {
  return json::text_of([&](json::Place place) { put_result(place, evaluated); });
}

Result<void> ManyOutputs::add_json(std::string_view text) {
  AXIOMETRY_TRY_VOID(json_->write(json_empty_ ? "[\n" : ",\n"));
  json_empty_ = false;
  return json_->write(text);
}

/// Of its report. Nobody's report is overwritten, and none is left out for its name.
std::string ManyOutputs::own_name(const Evaluated& evaluated) {
  const std::string name = report_name(evaluated);
  const std::string who = evaluated.test.provenance.file + (evaluated.name.empty() ? "" : ":" + evaluated.name);
  std::string own = name;
  std::size_t& number = last_numbers_.try_emplace(name, 1).first->second;
  while (!names_taken_.emplace(own, who).second) own = fmt::format("{}-{}", name, ++number);
  if (own != name)
    numbered_.push_back(fmt::format("the report of {} is called {}: that of {} is called {}", text::quoted(who),
                                    text::quoted(own), text::quoted(names_taken_.at(name)), text::quoted(name)));
  return own;
}

Result<void> ManyOutputs::add(const Evaluated& evaluated, const std::string& json) {
  if (json_) AXIOMETRY_TRY_VOID(add_json(json.empty() ? json_line(evaluated) : json));
  for (OutputFile& table : tables_) AXIOMETRY_TRY_VOID(table.write(combined_csv_row(evaluated, uncertainty_)));
  if (templates_.empty()) return {};
  const std::string name = own_name(evaluated);
  for (const std::string& name_of_all : templates_) {
    const std::string report = with_test_name(name_of_all, name);
    AXIOMETRY_TRY_VOID(inputs_.check_spared(report));
    AXIOMETRY_TRY_VOID(write_report(evaluated, report, options_));
  }
  return {};
}

Result<void> ManyOutputs::add_error(const std::string& file, const Error& error) {
  if (json_) AXIOMETRY_TRY_VOID(add_json(json::dump(error_to_json(file, error), 0)));
  for (OutputFile& table : tables_) AXIOMETRY_TRY_VOID(table.write(combined_csv_error_row(file, error, uncertainty_)));
  return {};
}

Result<void> ManyOutputs::commit() {
  if (json_) {
    AXIOMETRY_TRY_VOID(json_->write(json_empty_ ? "[]\n" : "\n]\n"));
    AXIOMETRY_TRY_VOID(json_->commit());
  }
  for (OutputFile& table : tables_) AXIOMETRY_TRY_VOID(table.commit());
  return {};
}

}  // namespace axiometry::app
