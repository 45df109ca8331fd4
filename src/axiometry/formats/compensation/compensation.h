// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/field/error_model.h"
#include "axiometry/volumetric/field/table_effect.h"

/// Tables by which controls compensate the errors of a machine, a file for each kind.
namespace axiometry::formats {

struct CompensationRequest {
  const volumetric::ErrorModel& model;
  std::size_t tool = 0;    ///< tool of the machine, for tables of single axes
  std::size_t nodes = 21;  ///< positions of each axis, over the travel that was observed
};

struct Compensation {
  std::string_view id;       ///< "general-csv", for --for
  std::string_view title;    ///< title in lists
  std::string_view takes;    ///< "all 21 errors", "positioning"
  bool of_one_tool = false;  ///< whether it needs one
  std::string_view comment;  ///< what a line of comment begins with
  std::string_view manual;   ///< Markdown: what it assumes, what is verified and what inferred
  /// The file says what a positive number does, and what error the table leaves. Fails where the lengths do not tell an
  /// error that it needs.
  Result<std::string> (*write)(const CompensationRequest& request);
};

/// The file, and before all else in it, as comment, what warns of it; nothing of an empty warning.
Result<std::string> written_table(const Compensation& compensation, const CompensationRequest& request,
                                  std::string_view warning);

/// In alphabetical order of the source files (generated).
std::span<const Compensation* const> compensation_table();

/// Fails with the ids that there are.
Result<const Compensation*> compensation_named(std::string_view id);

/// Fails, naming them, where errors are unseen in the mean of both directions.
Result<void> check_all_told(const volumetric::ErrorModel& model);

/// What tables of all errors hold: at_machine_zero() of the model, from where a control levers. Fails as
/// check_all_told().
Result<volumetric::ErrorModel> errors_for_a_control(const volumetric::ErrorModel& model);

/// Lines behind `mark`, in tables of all errors, that say so of a result.
std::string functional_points_text(const volumetric::MachineModel& of_result, std::string_view mark);

/// mm to the nanometre, without idle zeros.
std::string position_text(double position_mm);

/// Whether tables hold means of both directions, or each direction where the errors differ.
enum class TableDirections { means, each };

/// Lines behind `mark` that all tables begin with: machine, chain, range, directions.
std::string compensation_head(const volumetric::ErrorModel& model, std::string_view mark, TableDirections directions);

/// A line behind `mark` that says how large the error of the tool point is with a tool, and how large the tables leave
/// it: of means, what of the directions stays beside.
std::string effect_text(const volumetric::ErrorModel& model, std::string_view mark, const volumetric::Tool& tool,
                        const volumetric::TableEffect& effect, TableDirections directions);

/// The same of every tool, for tables of all errors at so many positions. Contract: check_all_told().
std::string effects_of_all_errors(const CompensationRequest& request, std::string_view mark,
                                  TableDirections directions);

}  // namespace axiometry::formats
