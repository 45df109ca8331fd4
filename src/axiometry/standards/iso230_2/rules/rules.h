// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/fields.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/iso230_2/programme.h"

/// The rules behind find_departures(), one function each, in files by group of clauses. A rule looks at
/// one test and has one finding or none. Everything here is private to standards/.
namespace axiometry::iso230_2::rules {

/// How often a direction was run: runs in which at least one target has a reading.
struct Runs {
  std::size_t up = 0;
  std::size_t down = 0;
};

/// A test as the rules see it.
struct Case {
  const Metadata& metadata;
  const Series& series;
  const Evaluation& evaluation;
  const std::optional<AnnexA>& uncertainty;
  Programme programme;
  Runs runs;

  AxisKind kind() const { return metadata.axis.kind; }
  bool linear() const { return kind() == AxisKind::linear; }
  double travel() const { return series.travel_native(); }
  double target(std::size_t i) const { return series.targets()[i].in_native(); }
};

Case make_case(const Metadata& metadata, const Series& series, const Evaluation& evaluation,
               const std::optional<AnnexA>& uncertainty);

/// Whether an item is given and says something (base/text/says_nothing.h): "-" and "n/a" do not, nor "none" of what
/// must be.
bool is_stated(const Field& field, const Metadata& metadata);

/// Runs of one direction whose numbers all come before those of the other, counted from 1.
struct DirectionBlocks {
  Direction earlier = Direction::up;
  std::size_t first = 0, last = 0;              ///< runs of the earlier direction
  std::size_t later_first = 0, later_last = 0;  ///< runs of the other
};

/// Nothing where a direction has fewer than two runs, and where their numbers alternate or are the same.
std::optional<DirectionBlocks> directions_in_blocks(const Case& c);

using Rule = std::optional<Finding>(const Case&);

// Clauses 3 and 4: what was measured, and where (conditions.cpp).
Rule both_ends_from_both_sides;       // 3.2
Rule targets_within_axis_travel;      // 3.2
Rule part_of_axis_travel;             // 3.2
Rule readings_beyond_errors;          // 3.6
Rule same_reversal_everywhere;        // 3.17
Rule readings_repeat_exactly;         // 3.18
Rule readings_copied;                 // 3.18
Rule readings_coarsely_rounded;       // 3.18
Rule straight_slope;                  // 3.24
Rule temperature_without_correction;  // 4.1
Rule temperature_change;              // 4.1
Rule air_pressure_unlikely;           // 8.1
Rule ordered_progression;             // 4.3

inline constexpr const char* progression_clause = "4.3";  ///< clause of an ordered progression of deviations

/// Notes of what the standard forbids but where something allows it that no item states: that the targets could not be
/// chosen, that another test was made as well. As missing: they speak against a test, and against a plan of one.
std::vector<Finding> unexplained(const Case& c);

/// Clauses 3.18 and 4.3: outliers, uneven scatter, shifts and drifts of the runs (scatter.cpp).
std::vector<Finding> scatter_findings(const Case& c);

// Clause 5: the test programme (programme.cpp).
Rule equally_spaced_targets;    // 5.2
Rule gap_between_targets;       // 5.2
Rule targets_on_compensation;   // 5.2
Rule number_of_targets;         // 5.3.2 to 5.3.5
Rule principal_positions;       // 5.3.4
Rule directions_of_approach;    // 5.3.2 to 5.3.5
Rule number_of_approaches;      // 5.3.2 to 5.3.5
Rule missing_readings;          // 5.3.2 to 5.3.5
Rule runs_left_out;             // 5.3.2 to 5.3.5
Rule runs_in_blocks;            // 5.3.2 to 5.3.5
Rule more_than_five_turns;      // 5.3.5
Rule cycle_declared_otherwise;  // 5.3.2
Rule additional_test;           // 5.3.3, 5.3.5
Rule step_cycle;                // Annex B

// Clauses 6 and 8, Annex A: what the report states (report.cpp).
Rule parameters_not_applicable;      // 6.2
Rule items_of_identification;        // 8.1
Rule equipment_identified;           // 8.1
Rule impossible_date;                // 8.1
Rule date_not_read;                  // 8.1
Rule equipment_calibrated;           // 8.2.1
Rule calibration_date_not_read;      // 8.2.1
Rule sensors_complete;               // 8.1
Rule uncertainty_stated;             // 8.2.1
Rule uncertainty_of_zero;            // 8.2.1
Rule repeatability_below_variation;  // A.2.6

// Lines in space and tracking interferometers (lines.cpp).
Rule diagonal_line;   // ISO 230-6
Rule line_in_space;   // 8.1
Rule station_stated;  // 8.2.1

/// Acceptance and reverification must keep off the sampling points (5.2); a test whose purpose was not told may be one.
bool may_serve_acceptance(std::string_view purpose);
/// A title as it reads within a sentence: "Date of test" begins small, "NDE correction" does not.
std::string within_sentence(std::string_view title);
/// At most three decimals, no trailing zeros: "1744.209", "0.1".
std::string figure(double x);
/// Of a deviation, to three significant digits or to the unit, without trailing zeros and with a true minus sign:
/// "0.0213", "−2554".
std::string size_text(double x);
/// "1744.209 mm", "315°".
std::string position_text(AxisKind kind, double position);
std::string position_text(const Case& c, double position);
/// "target 3 (353.834 mm)".
std::string target_text(const Case& c, std::size_t target);

}  // namespace axiometry::iso230_2::rules
