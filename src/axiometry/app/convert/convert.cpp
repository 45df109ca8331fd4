// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/convert/convert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/fields.h"
#include "axiometry/model/swapped_labels.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::app {
namespace {

std::unexpected<Error> about_output(std::string message, const std::string& output) {
  return std::unexpected(Error{std::move(message), output, {}});
}

bool same_readings(const Series& a, const Series& b) {
  if (!std::ranges::equal(a.targets(), b.targets())) return false;
  for (const Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < a.target_count(); ++i)
      for (std::size_t j = 0; j < std::max(a.run_count(), b.run_count()); ++j) {
        const auto in = [&](const Series& s) {
          return j < s.run_count() ? s.reading(i, direction, j) : std::nullopt;  // a run without readings is none
        };
        if (in(a) != in(b)) return false;
      }
  return true;
}

/// What the written text does not give back, as one word; empty when nothing is lost.
std::string lost_in(const std::string& text, const formats::Format& format, const Test& test) {
  const auto known = formats::recognise(std::string_view(text).substr(0, read_budget::head_bytes));
  if (!known || *known != &format)
    return fmt::format("a header within its first {} KiB, by which it is known", read_budget::head_bytes >> 10);
  const auto again = format.read(text);
  if (!again) return fmt::format("a text that can be read again ({})", again.error().message);
  if (!same_readings(again->series, test.series)) return "the readings";
  const auto departures_in = [](const Test& t) {
    return std::ranges::count_if(t.provenance.remarks, &SourceRemark::departs);
  };
  if (departures_in(*again) < departures_in(test))
    return fmt::format("why it is none of {}", standard_of(test.metadata.axis));
  if (has_swapped_labels(test) && !has_swapped_labels(*again)) return "that rows contradict its labels of direction";
  for (const Field& field : metadata_fields())
    if (field.get(again->metadata) != field.get(test.metadata)) return std::string(field.key);
  return "";
}

}  // namespace

std::vector<std::string> left_behind(const Test& test, const formats::Format& format) {
  std::vector<std::string> sentences;
  for (const SourceRemark& remark : test.provenance.remarks) sentences.push_back(remark.message);
  if (!test.times_s.empty() && format.id != "json")
    sentences.push_back(fmt::format("the times of the readings are not kept in {}; json keeps them", format.id));
  return sentences;
}

Result<std::string> lossless_bytes(const Test& test, const formats::Format& format) {
  std::string text = format.write(test);
  if (const std::string lost = lost_in(text, format, test); !lost.empty())
    return fail(fmt::format("found a test of which {} does not keep {}, expected another format such as json",
                            format.id, lost));
  return text;
}

Result<const formats::Format*> format_to_write(const std::string& to, const std::string& output) {
  std::string id = to;
  if (id.empty()) {
    const std::string lower = text::to_lower(output);
    if (lower.ends_with(".json")) id = "json";
    if (lower.ends_with(".csv")) id = "csv-long";
  }
  std::vector<std::string_view> known;
  for (const formats::Format* format : formats::format_table()) {
    if (format->write == nullptr) continue;
    if (format->id == id) return format;
    known.push_back(format->id);
  }
  if (id.empty())
    return fail(
        fmt::format("found the output {}, expected a file ending in .json or .csv, or its format stated as one of {}",
                    text::quoted(output), fmt::join(known, ", ")));
  return fail(fmt::format("found the format {}, expected one that can be written: {}", text::quoted(id),
                          fmt::join(known, ", ")));
}

Result<std::vector<std::string>> convert(const ConvertOptions& options) {
  AXIOMETRY_TRY(const formats::Format* format, format_to_write(options.to, options.output));
  std::vector<InputFile> inputs{{options.input}};
  if (!options.profile.empty()) inputs.push_back({options.profile});
  if (options.output != "-") AXIOMETRY_TRY_VOID(InputFiles(inputs).check_spared(options.output));
  AXIOMETRY_TRY(Test test, read_test(options.input, options.format, options.profile));
  if (auto set = set_metadata(test.metadata, options.metadata); !set)
    return about_output(set.error().message, options.input);
  test.provenance.file = base_name(options.input);
  AXIOMETRY_TRY(const std::string text, in_file(lossless_bytes(test, *format), options.output));
  AXIOMETRY_TRY_VOID(write_file(options.output, text));
  return left_behind(test, *format);
}

Result<formats::Guess> guess_file(const std::string& name) {
  AXIOMETRY_TRY(const std::string bytes, file_bytes(name));
  auto found = formats::guess(bytes);
  if (!found) return about_output(found.error().message, name == "-" ? "(standard input)" : name);
  return found;
}

Result<void> save_profile(const formats::ImportProfile& profile, const std::string& output, const std::string& input) {
  const std::vector<InputFile> inputs{{input}};
  AXIOMETRY_TRY_VOID(InputFiles(inputs).check_spared(output));
  return write_file(output, formats::write_profile(profile));
}

}  // namespace axiometry::app
