// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/error_motions/motion_evaluation.h"

/// What the three kinds of results show in common.
namespace axiometry::app {

/// A document of a measurement: title, "ISO 230-1", identity of the files and of what they say of the test.
report::Document motion_document(std::string_view kind, const std::string& title,
                                 const std::vector<const MeasuredMotion*>& files, const report::Options& options);

/// A row of "quantity, course, value, U, unit": U to two digits, the value to U's last place.
std::vector<report::TableCell> estimate_row(std::string_view quantity, std::string_view course,
                                            const error_motions::MotionEstimate& estimate, std::string_view unit,
                                            const report::Options& options);
/// Without rows; the note below it says what U holds.
report::Table estimate_table(std::string_view note);

/// Every figure of one file, and its positions.
report::Section motion_results(const MeasuredMotion& measured, const std::string& id, const std::string& title,
                               const report::Options& options);
report::Section motion_positions(const MeasuredMotion& measured, const std::string& id, const std::string& title,
                                 const report::Options& options);
void add_figures(report::Section& section, const MeasuredMotion& measured, const std::string& name,
                 const report::Options& options);

/// What stands beside the results: remarks of each file, each once, and with what it is of where it is not of all.
void add_remarks(report::Document& document, const std::vector<std::string>& remarks);
std::vector<std::string> all_remarks(const std::vector<const MeasuredMotion*>& files);

/// What a result is of: the files with their bytes and days, the program, the standard. A table, so that it stands in
/// CSV too.
report::Section motion_provenance(const std::vector<const MeasuredMotion*>& files, std::string_view edition);

report::Section motion_method(const MeasuredMotion& measured);

/// "EYX", or "" where nobody said.
std::string name_of(const MeasuredMotion& measured);

std::string_view course_key(error_motions::PathKind kind);  ///< of JSON: "up", "down", "mean"
json::Value estimate_to_json(const error_motions::MotionEstimate& estimate);
json::Value instrument_to_json(const std::optional<error_motions::InstrumentUncertainty>& instrument);
json::Value motion_to_json(const MeasuredMotion& measured);
json::Value texts_to_json(const std::vector<std::string>& texts);
json::Value numbers_to_json(std::span<const double> numbers);

}  // namespace axiometry::app
