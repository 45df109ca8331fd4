// SPDX-License-Identifier: Apache-2.0
// The tables of several captures of one plan as one.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "axiometry/app/live/lengths/length_task.h"
#include "axiometry/formats/tracking/tracking_lengths_csv.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"

namespace axiometry::app {
namespace {

using volumetric::VolumetricLengths;
using volumetric::VolumetricReading;

/// Which table is the last one that has lengths of a line, or of a station and tool; the others' are left out and told.
class LastTables {
 public:
  void add(const std::string& group, std::size_t table) { last_[group].insert(table); }
  bool takes(const std::string& group, std::size_t table) const { return *last_.at(group).rbegin() == table; }

  std::string told(const std::vector<CapturedTable>& tables) const {
    std::string text;
    for (const auto& [group, of] : last_)
      for (const std::size_t table : of)
        if (table != *of.rbegin())
          text += fmt::format("# {}: the lengths of {} are left out, those of {} came later\n", group,
                              tables[table].name, tables[*of.rbegin()].name);
    return text;
  }

 private:
  std::map<std::string, std::set<std::size_t>> last_;
};

/// Comments of a table, which say what is to be known of it.
std::string comments_of(std::string_view bytes) {
  std::string comments;
  while (bytes.starts_with('#')) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size() - 1) + 1;
    comments += bytes.substr(0, end);
    bytes.remove_prefix(end);
  }
  return comments;
}

std::string head_of(const std::vector<CapturedTable>& tables) {
  std::string head;
  for (const CapturedTable& table : tables) head += fmt::format("# {}\n{}", table.name, comments_of(table.bytes));
  return head;
}

/// Each capture has dead paths of its own.
Result<std::string> joined_lines(const TrackingPlan& plan, const std::vector<CapturedTable>& tables) {
  std::vector<std::vector<LengthReading>> all;
  LastTables last;
  for (const CapturedTable& table : tables) {
    AXIOMETRY_TRY(const formats::TrackingLengths read, formats::read_tracking_lengths(table.bytes, plan));
    std::vector<LengthReading>& readings = all.emplace_back();
    for (const formats::LengthRow& row : read.rows) {
      readings.push_back(row.reading);
      last.add("line " + row.reading.line, all.size() - 1);
    }
  }
  std::vector<LengthReading> joined;
  std::size_t first_segment = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::size_t next = first_segment;
    for (LengthReading& reading : all[k]) {
      if (!last.takes("line " + reading.line, k)) continue;
      reading.segment += first_segment;
      next = std::max(next, reading.segment + 1);
      joined.push_back(std::move(reading));
    }
    first_segment = next;
  }
  return head_of(tables) + last.told(tables) + formats::write_tracking_lengths(joined);
}

std::size_t number_of(std::vector<std::string>& names, const std::string& name) {
  const auto at = std::ranges::find(names, name);
  if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

Result<std::string> joined_volume(const std::vector<CapturedTable>& tables) {
  std::vector<VolumetricLengths> all;
  LastTables last;
  const auto group = [&](const VolumetricLengths& of, const VolumetricReading& reading) {
    return fmt::format("station {}, tool {}", of.stations[reading.station], of.tools[reading.tool]);
  };
  for (const CapturedTable& table : tables) {
    AXIOMETRY_TRY(VolumetricLengths read, formats::read_volumetric_lengths(table.bytes));
    for (const VolumetricReading& reading : read.readings) last.add(group(read, reading), all.size());
    all.push_back(std::move(read));
  }
  VolumetricLengths joined;
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const VolumetricReading& reading : all[k].readings) {
      if (!last.takes(group(all[k], reading), k)) continue;
      VolumetricReading& added = joined.readings.emplace_back(reading);
      added.station = number_of(joined.stations, all[k].stations[reading.station]);
      added.tool = number_of(joined.tools, all[k].tools[reading.tool]);
      added.segment = number_of(joined.segments, all[k].segments[reading.segment]);
    }
  }
  return head_of(tables) + last.told(tables) + formats::write_volumetric_lengths(joined);
}

}  // namespace

Result<std::string> joined_tables(const LengthTask& plan, const std::vector<CapturedTable>& tables) {
  if (tables.size() == 1) return tables.front().bytes;
  return plan.volume() ? joined_volume(tables) : joined_lines(*plan.all_lines(), tables);
}

}  // namespace axiometry::app
