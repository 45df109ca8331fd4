// SPDX-License-Identifier: Apache-2.0
//
// Clauses 6 and 8 and Annex A: what a report must be able to state.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "axiometry/base/text/says_nothing.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/model/fields.h"
#include "axiometry/model/test_day.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"

namespace axiometry::iso230_2::rules {
namespace {

/// "1 to 8", "10": neighbours of target numbers drawn together.
std::vector<std::string> stretches(const std::vector<std::size_t>& indices) {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < indices.size();) {
    std::size_t last = k;
    while (last + 1 < indices.size() && indices[last + 1] == indices[last] + 1) ++last;
    if (last == k + 1) last = k;  // a pair reads better as two
    all.push_back(last == k ? fmt::format("{}", indices[k] + 1)
                            : fmt::format("{} to {}", indices[k] + 1, indices[last] + 1));
    k = last + 1;
  }
  return all;
}

/// Whether a title begins with a word that is written small within a sentence.
bool begins_small(std::string_view title) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  return title.size() > 1 && title[0] >= 'A' && title[0] <= 'Z' && is_small(title[1]);
}

/// What is missing of one group of the metadata, as it reads within a sentence.
struct MissingItems {
  std::string_view group;
  std::string text{};
  std::string_view last{};  ///< title of its last item

  /// "air temperature at the start" and "… at the end" become one item.
  void add(std::string_view title) {
    constexpr std::string_view start = " at the start", end = " at the end";
    const bool both = title.ends_with(end) && last.ends_with(start) &&
                      last.substr(0, last.size() - start.size()) == title.substr(0, title.size() - end.size());
    last = both ? std::string_view() : title;
    if (both) {
      text += " and the end";
      return;
    }
    if (!text.empty()) text += ", ";
    const std::size_t begin = text.size();
    text += title;
    if (begins_small(title)) text[begin] += 'a' - 'A';
  }
};

std::string_view group_of(std::string_view key) { return key.substr(0, key.find('.')); }

std::string_view group_title(std::string_view group) {
  if (group == "nde") return "NDE correction";
  if (group == "environment") return "air";
  if (group == "sensors") return "temperature";
  if (group == "tracking") return "tracking interferometer";
  return group;
}

/// A contributor that 8.2.1 asks for at least.
struct AskedContributor {
  std::string_view key, title;
  std::array<std::string_view, 3> clauses;  ///< clauses of the fields that state it
};

constexpr AskedContributor asked_contributors[] = {
    {"device", "measuring device (A.1 to A.3)", {"A.1", "A.2", "A.3"}},
    {"misalignment", "misalignment (A.4)", {"A.4"}},
    {"m_machine", "temperature measurement of the machine tool (A.5)", {"A.5"}},
    {"e_machine", "expansion coefficient of the machine tool (A.7)", {"A.7"}},
    {"eve", "environmental variation (A.9)", {"A.9"}}};

/// Titles of contributors and the fields that state them.
struct ContributorsFound {
  std::vector<std::string_view> titles, fields;

  void add(std::string_view key, AxisKind kind) {
    const auto& found = *std::ranges::find(asked_contributors, key, &AskedContributor::key);
    titles.push_back(found.title);
    for (const Field& field : metadata_fields()) {
      const bool means_nothing = kind == AxisKind::rotary && !field.unit_linear.empty() && field.unit_rotary.empty();
      if (!means_nothing && !field.clause.empty() &&
          std::ranges::find(found.clauses, field.clause) != found.clauses.end())
        fields.push_back(field.key);
    }
  }
};

/// Whether Annex A takes a contributor as 0, or of the machine's temperature its R(θ), whatever α is.
bool taken_as_zero(const AnnexA& annex, std::string_view key) {
  return std::ranges::any_of(annex.budget, [&](const Contributor& row) {
    const bool no_range = std::ranges::any_of(
        row.inputs, [](const BudgetInput& input) { return input.symbol == "R(θ)" && input.value == 0.0; });
    return row.key == key && row.U && (no_range || (key != "m_machine" && row.U->in_native() == 0.0));
  });
}

/// What 8.2.1 asks for at least and nothing was given of.
ContributorsFound contributors_left_out(const Case& c) {
  const auto budget =
      c.uncertainty ? std::span<const Contributor>(c.uncertainty->budget) : std::span<const Contributor>();
  ContributorsFound absent;
  for (std::string_view key : missing_contributors(budget, c.kind())) absent.add(key, c.kind());
  std::erase_if(absent.fields, [&](std::string_view key) { return is_given(*find_field(key), c.metadata); });
  return absent;
}

/// Of what a machine or a test need not have "none" is an answer; of a warm-up add_impossible() judges it.
bool may_be_none(const Field& field) {
  constexpr std::string_view keys[] = {"axis.scale_type", "axis.compensation", "test.axes_not_under_test",
                                       "test.warm_up"};
  return std::ranges::find(keys, field.key) != std::end(keys);
}

/// "K. A.", which may be somebody: "k. A." says nothing.
bool may_be_initials(const Field& field, std::string_view words) {
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  const std::string_view s = text::trim(words);
  return field.key == "test.inspector" && s.size() >= 4 && s.size() <= 5 && is_capital(s[0]) && s[1] == '.' &&
         is_capital(s[s.size() - 2]) && s.back() == '.';
}

bool names_nothing(std::string_view words) { return text::says_nothing(words) || text::says_none(words); }

/// A component by its role, else by what identifies it.
std::string name_of(const Equipment& e) {
  for (const std::string* name : {&e.role, &e.type, &e.manufacturer, &e.serial_number})
    if (!name->empty()) return *name;
  return "";
}

bool dates_calibration(const Equipment& e) {
  return !names_nothing(e.calibrated_on) || !names_nothing(e.calibration_due);
}

bool identifies_anything(const std::vector<Cell>& record) {
  return std::ranges::any_of(record, [](const Cell& cell) {
    const auto* words = std::get_if<std::string>(&cell);
    return words == nullptr ? std::holds_alternative<double>(cell) : !names_nothing(*words);
  });
}

}  // namespace

std::string within_sentence(std::string_view title) {
  std::string text(title);
  if (begins_small(title)) text[0] += 'a' - 'A';
  return text;
}

std::optional<Finding> parameters_not_applicable(const Case& c) {
  if (std::max(c.runs.up, c.runs.down) != 1) return std::nullopt;
  const bool both = std::min(c.runs.up, c.runs.down) > 0;
  return note("parameters-not-applicable", "6.2",
              both ? "with one approach from each direction s, R and A (3.18 to 3.22, 3.26, 3.27) are not applicable"
                   : "with one approach from one direction s, R and A (3.18 to 3.22, 3.26, 3.27) are not applicable");
}

bool is_stated(const Field& field, const Metadata& metadata) {
  const FieldValue value = field.get(metadata);
  if (const auto* words = std::get_if<std::string>(&value))
    return may_be_initials(field, *words) ||
           (!text::says_nothing(*words) && (may_be_none(field) || !text::says_none(*words)));
  if (const auto* records = std::get_if<Records>(&value)) return std::ranges::any_of(*records, identifies_anything);
  return is_given(field, metadata);
}

std::optional<Finding> items_of_identification(const Case& c) {
  // Usually, so that nothing moves.
  constexpr std::size_t groups = 8, of_group_at_most = 256, of_all_at_most = 1024, fields_usually = 64;
  std::vector<MissingItems> absent;
  std::vector<std::string_view> keys;
  absent.reserve(groups);
  keys.reserve(fields_usually);
  for (const Field& field : metadata_fields()) {
    if (!is_wanted(field, c.metadata) || is_stated(field, c.metadata)) continue;
    const std::string_view group = group_of(field.key);
    auto of_group = std::ranges::find(absent, group, &MissingItems::group);
    if (of_group == absent.end()) {
      of_group = absent.insert(of_group, {group});
      of_group->text.reserve(of_group_at_most);
    }
    of_group->add(field.title);
    keys.push_back(field.key);
  }
  if (absent.empty()) return std::nullopt;
  std::string message;
  message.reserve(of_all_at_most);
  message = "not given, but expected in the report – ";
  for (const MissingItems& of_group : absent)
    message.append(&of_group == &absent.front() ? "" : "; ")
        .append(group_title(of_group.group))
        .append(": ")
        .append(of_group.text);
  return answered_by(std::move(keys), missing("items-of-identification", "8.1", std::move(message)));
}

std::optional<Finding> equipment_identified(const Case& c) {
  std::vector<std::string> incomplete;
  std::vector<std::string_view> fields;
  for (std::size_t k = 0; k < c.metadata.equipment.size(); ++k) {
    const Equipment& e = c.metadata.equipment[k];
    std::vector<std::string_view> lacks;
    if (names_nothing(e.manufacturer)) lacks.push_back("manufacturer");
    if (names_nothing(e.type)) lacks.push_back("type");
    if (names_nothing(e.serial_number)) lacks.push_back("serial number");
    if (lacks.empty()) continue;
    incomplete.push_back(fmt::format("{} without {}",
                                     names_nothing(e.role) ? fmt::format("component {}", k + 1) : e.role,
                                     fmt::join(lacks, " and ")));
  }
  if (!incomplete.empty()) fields.push_back("equipment");
  // An artefact with calibrated positions is what was measured with.
  if (const Artefact& artefact = c.metadata.artefact; !artefact.calibrated_positions.empty()) {
    std::vector<std::string_view> lacks;
    if (names_nothing(artefact.type)) {
      lacks.push_back("type");
      fields.push_back("artefact.type");
    }
    if (names_nothing(artefact.serial_number)) {
      lacks.push_back("serial number");
      fields.push_back("artefact.serial_number");
    }
    if (!lacks.empty()) incomplete.push_back(fmt::format("the artefact without {}", fmt::join(lacks, " and ")));
  }
  if (incomplete.empty()) return std::nullopt;
  return answered_by(std::move(fields), missing("equipment-identified", "8.1",
                                                fmt::format("found test equipment not fully identified: {}",
                                                            fmt::join(incomplete, "; "))));
}

std::optional<Finding> impossible_date(const Case& c) {
  const std::string& date = c.metadata.conditions.date;
  if (date.empty()) return std::nullopt;
  const std::string day = iso_date(date);
  if (!day.empty() && !can_be_day_of_test(day))
    return answered_by(
        {"test.date"},
        missing("impossible-date", "8.1",
                fmt::format("the date of the test is given as {}, expected a day from 1950 to now", date)));
  if (!is_no_day(date)) return std::nullopt;
  return answered_by({"test.date"}, missing("impossible-date", "8.1",
                                            fmt::format("the date of the test is given as {}, which is no day", date)));
}

std::optional<Finding> date_not_read(const Case& c) {
  const std::string& date = c.metadata.conditions.date;
  if (names_nothing(date) || is_no_day(date) || !iso_date(date).empty()) return std::nullopt;
  // simulated_date says that there is none, and why; only dates of calibrations would ask for one.
  const bool none = text::says_none(std::string_view(date).substr(0, date.find(':')));
  if (none && std::ranges::none_of(c.metadata.equipment, dates_calibration)) return std::nullopt;
  return answered_by(
      {"test.date"},
      missing("date-not-read", "8.1",
              fmt::format("found {} for the date of the test, expected a day such as 2014-05-15: nothing that "
                          "depends on the day could be looked at",
                          date)));
}

std::optional<Finding> equipment_calibrated(const Case& c) {
  const std::string day = iso_date(c.metadata.conditions.date);
  if (day.empty()) return std::nullopt;
  std::vector<std::string> outside;
  for (const Equipment& e : c.metadata.equipment) {
    const std::string from = named_days(e.calibrated_on).first;
    const std::string due = named_days(e.calibration_due).last;
    if (from <= day && (due.empty() || due >= day)) continue;
    outside.push_back(fmt::format("{} ({} – {})", name_of(e), from.empty() ? "…" : from, due.empty() ? "…" : due));
  }
  if (outside.empty()) return std::nullopt;
  return note(
      "equipment-calibrated", "8.2.1",
      fmt::format("found a test on {}, when its equipment was out of calibration: {}", day, fmt::join(outside, "; ")));
}

std::optional<Finding> calibration_date_not_read(const Case& c) {
  std::vector<std::string> unread;
  for (const Equipment& e : c.metadata.equipment)
    for (const std::string* date : {&e.calibrated_on, &e.calibration_due})
      if (!names_nothing(*date) && named_days(*date).first.empty())
        unread.push_back(fmt::format("{} ({})", name_of(e), *date));
  if (unread.empty()) return std::nullopt;
  return answered_by(
      {"equipment"},
      missing("calibration-date-not-read", "8.2.1",
              fmt::format("found dates of calibration that name no day or month, so that nobody can tell whether it "
                          "held on the day of the test: {}",
                          fmt::join(unread, "; "))));
}

std::optional<Finding> sensors_complete(const Case& c) {
  if (c.metadata.nde.applied != true || c.metadata.environment.sensors.empty()) return std::nullopt;
  std::vector<std::string> lacks;
  const auto has_role = [&](std::string_view role) {
    return std::ranges::any_of(c.metadata.environment.sensors,
                               [&](const TemperatureSensor& s) { return text::equal_ignoring_case(s.role, role); });
  };
  if (!has_role("machine")) lacks.push_back("no sensor with the role machine");
  for (const TemperatureSensor& s : c.metadata.environment.sensors) {
    std::string name = names_nothing(s.role) ? "a sensor" : "the sensor of the " + s.role;
    const bool located = !names_nothing(s.location);
    if (located) name += fmt::format(" ({})", s.location);
    if (!located) lacks.push_back(name + " without location");
    if (!s.start || !s.end)
      lacks.push_back(fmt::format("{} without temperature at the {}", name,
                                  s.start ? "end"
                                  : s.end ? "start"
                                          : "start and the end"));
  }
  if (lacks.empty()) return std::nullopt;
  return answered_by({"sensors"}, missing("sensors-complete", "8.1",
                                          fmt::format("found an NDE correction with {}", fmt::join(lacks, ", "))));
}

std::optional<Finding> uncertainty_stated(const Case& c) {
  const ContributorsFound absent = contributors_left_out(c);
  if (absent.titles.empty()) return std::nullopt;
  const std::string titles = fmt::format("{}", fmt::join(absent.titles, ", "));
  return answered_by(
      absent.fields,
      missing("uncertainty-stated", "8.2.1",
              c.uncertainty
                  ? fmt::format("the uncertainty is incomplete and too small: nothing was given of {}", titles)
                  : fmt::format("no uncertainty is stated after Annex A: nothing was given of {}", titles)));
}

std::optional<Finding> uncertainty_of_zero(const Case& c) {
  if (!c.uncertainty) return std::nullopt;
  ContributorsFound zero;
  for (const char* key : {"device", "m_machine", "eve"})
    if (taken_as_zero(*c.uncertainty, key)) zero.add(key, c.kind());
  if (zero.titles.empty()) return std::nullopt;
  return answered_by(zero.fields, missing("uncertainty-of-zero", "8.2.1",
                                          fmt::format("the uncertainty takes as 0 what nobody knows without doubt: {}",
                                                      fmt::join(zero.titles, ", "))));
}

std::optional<Finding> repeatability_below_variation(const Case& c) {
  if (!c.uncertainty || !c.uncertainty->corrected || c.uncertainty->corrected->floored.empty()) return std::nullopt;
  const auto& floored = c.uncertainty->corrected->floored;
  return note("repeatability-below-variation", "A.2.6",
              fmt::format("found s_i smaller than U_EVE/2 at target{} {}; the corrected repeatability takes 0 there",
                          floored.size() == 1 ? "" : "s", fmt::join(stretches(floored), ", ")));
}

}  // namespace axiometry::iso230_2::rules
