// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/measured_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/app/evaluate/known_file.h"
#include "axiometry/app/files/source.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/recording.h"
#include "axiometry/formats/table/guessed_read.h"

namespace axiometry::app {
namespace {

constexpr std::size_t tests_max = 2000;
/// Of a file of 64 MiB, all of it readings, a test takes less. What stands once above a table is in every test of it,
/// and that may be far more than the file.
constexpr std::size_t memory_max = std::size_t{128} << 20;
/// No set-up has as many; each is looked for among all instruments of the archive.
constexpr std::size_t equipment_max = 100;

/// What a test takes in memory, as far as a file can make it large.
std::size_t memory_of(const Test& test) {
  const auto text = [](const std::string& s) { return sizeof s + s.capacity(); };
  const Metadata& data = test.metadata;
  std::size_t bytes = sizeof test + data.equipment.capacity() * sizeof(Equipment) +
                      data.environment.sensors.capacity() * sizeof(TemperatureSensor) +
                      data.gum.distributions.capacity() * sizeof(InputDistribution);
  for (const Equipment& e : data.equipment)
    for (const std::string* s :
         {&e.role, &e.manufacturer, &e.type, &e.serial_number, &e.certificate, &e.calibrated_on, &e.calibration_due})
      bytes += s->capacity();
  for (const TemperatureSensor& sensor : data.environment.sensors) bytes += text(sensor.role) + text(sensor.location);
  for (const InputDistribution& input : data.gum.distributions) bytes += text(input.input) + text(input.distribution);
  for (const std::string* s :
       {&data.conditions.comment, &data.conditions.purpose, &data.machine.name, &data.machine.axes_travel})
    bytes += s->capacity();
  for (const SourceRemark& remark : test.provenance.remarks) bytes += sizeof remark + text(remark.message);
  const std::size_t numbers = 2 * test.series.target_count() * test.series.run_count() + test.series.target_count() +
                              test.times_s.capacity() + data.gum.drift_recording.capacity() +
                              data.artefact.calibrated_positions.capacity();
  return bytes + numbers * sizeof(double);
}

/// Whether a file of tests stays within what one may hold. `memory` is that of all up to this one.
Result<void> check_size(const Test& test, std::size_t count, std::size_t memory) {
  if (test.metadata.equipment.size() > equipment_max)
    return fail(fmt::format("found {} pieces of test equipment in one test, expected at most {}",
                            test.metadata.equipment.size(), equipment_max));
  if (count > tests_max)
    return fail(fmt::format("found more than {} tests in one file, expected several files", tests_max));
  if (memory > memory_max)
    return fail(
        fmt::format("found tests that take more than {} MiB of memory up to test {} of the file, expected several "
                    "files, or less above the table that is the same for all",
                    memory_max >> 20, count));
  return {};
}

/// The format that fits the beginning. Fails on what people take for a test and is none.
Result<const formats::Format*> format_of_test(std::string_view bytes, const Recognised& found) {
  if (found.recording != nullptr)
    return fail(
        fmt::format("found a continuous recording ({}), expected a measured test; with the plan the axis moved after "
                    "its readings become one, and how the axis moved is told without a plan",
                    found.recording->title));
  if (!found.format && text::trim(bytes.substr(0, read_budget::head_bytes)).starts_with('{') &&
      formats::read_plan(bytes))
    return fail("found a plan, expected a measured test; plans are kept on the page of plans");
  return found.format;
}

/// Of the columns of readings, each its own or that of all.
std::string reading_units(const formats::ImportProfile& profile) {
  std::vector<std::string_view> units;
  for (const formats::ImportColumn& column : profile.columns) {
    if (column.role != formats::ImportRole::deviation && column.role != formats::ImportRole::position) continue;
    const formats::Unit* unit = column.unit != nullptr ? column.unit : profile.reading_unit;
    if (unit != nullptr && std::ranges::find(units, unit->symbol) == units.end()) units.push_back(unit->symbol);
  }
  return fmt::format("{}", fmt::join(units, ", "));
}

std::string_view in_words(formats::DirectionRule rule) {
  switch (rule) {
    case formats::DirectionRule::column: return "from a column";
    case formats::DirectionRule::names: return "from the names";
    case formats::DirectionRule::motion: return "from the motion";
    case formats::DirectionRule::visits: return "in turn at each target";
    case formats::DirectionRule::run_parity: return "in turn from run to run";
    case formats::DirectionRule::up: return "all ↑";
    case formats::DirectionRule::down: return "all ↓";
  }
  return "";
}

Result<Test> read_by_profile(std::string_view bytes, const formats::ImportProfile& profile) {
  AXIOMETRY_TRY(Test test, formats::read_with(profile, bytes));
  auto& remarks = test.provenance.remarks;
  remarks.insert(remarks.begin(),
                 {false, fmt::format("columns were read as stated with the file: targets in {}, readings in {}, "
                                     "direction of approach {}, {}",
                                     profile.target_unit->symbol, reading_units(profile), in_words(*profile.direction),
                                     profile.sign < 0.0 ? "readings of the other sign" : "readings as they stand")});
  return test;
}

std::unexpected<Error> in_measured_file(Error error, const std::string& name) {
  error.file = name;
  return std::unexpected(std::move(error));
}

}  // namespace

const Test* MeasuredFile::find(std::string_view name) const {
  const auto found = std::ranges::find(tests, name, &MeasuredTest::name);
  return found == tests.end() ? nullptr : &found->test;
}

Result<MeasuredFile> read_measured(const HashedBytes& sent, const std::string& name,
                                   const std::optional<formats::ImportProfile>& profile) {
  const std::string_view bytes = sent.bytes;
  if (bytes.empty()) return in_measured_file({"found an empty file, expected a measured test", {}, {}}, name);
  MeasuredFile file{.sha256 = sent.sha256, .size = bytes.size(), .memory = 0, .format = {}, .tests = {}};
  const auto take = [&](Test&& test, std::string&& own_name) -> Result<void> {
    file.memory += memory_of(test);
    AXIOMETRY_TRY_VOID(check_size(test, file.tests.size() + 1, file.memory));
    file.tests.push_back({std::move(own_name), std::move(test)});
    return {};
  };
  const auto take_table = [&](Test test) {
    test.provenance.file = name;
    test.provenance.sha256 = file.sha256;
    test.provenance.format = formats::any_table_format;
    return take(std::move(test), {});
  };
  const auto read = [&]() -> Result<void> {
    if (profile) {
      AXIOMETRY_TRY_VOID(formats::check_no_other_error(bytes.substr(0, read_budget::head_bytes)));
      AXIOMETRY_TRY(Test test, read_by_profile(bytes, *profile));
      return take_table(std::move(test));
    }
    AXIOMETRY_TRY(const formats::Format* format,
                  format_of_test(bytes, sent.recognised ? *sent.recognised : recognised(bytes)));
    if (format->id == formats::any_table_format) {
      AXIOMETRY_TRY(file.guess, formats::guess(bytes));
      AXIOMETRY_TRY(Test test, formats::read_guessed(*file.guess, bytes));
      return take_table(std::move(test));
    }
    Source source = Source::of_bytes(name, bytes);
    return read_known(source, {*format, file.sha256}, take);
  }();
  if (!read) return in_measured_file(read.error(), name);
  if (file.tests.empty()) return in_measured_file({"found no measured test, expected at least one", {}, {}}, name);
  file.format = file.tests.front().test.provenance.format;
  return file;
}

std::optional<formats::Guess> guess_measured(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, read_budget::head_bytes);
  if (formats::recognise_recording(head) || !formats::check_no_other_error(head)) return {};
  auto found = formats::guess(bytes);
  if (!found) return {};
  return *std::move(found);
}

}  // namespace axiometry::app
