// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/base/json/json.h"

/// Results as machines read them: JSON objects and the rows of a combined CSV. The one place that
/// spells their keys; docs/results.md describes them.
namespace axiometry::app {

/// One evaluation. Numbers are in the axis' native unit ("um" or "arcsec") and full double precision;
/// what does not exist is null.
json::Value to_json(const Evaluated& evaluated);

/// Members that every result has: "findings", "source" (`test_name` for one of many in its file), "program".
json::Value findings_to_json(std::span<const iso230_2::Finding> findings);
json::Value source_to_json(const Provenance& provenance, const std::string& test_name = {});
json::Value program_to_json();

/// What stands in a combined JSON for an input that could not be read.
json::Value error_to_json(const std::string& file, const Error& error);

/// Header and rows of the table of many evaluations: file, test, axis, kind, unit, conforming, the
/// twelve parameters, their U, error, verdict, keys of the parameters that do not conform and of those undecided, and
/// what uncertainty_json.h adds for the methods that were asked for, label; RFC 4180, full precision, empty where null.
/// The same methods must be given for all rows of a table.
std::string combined_csv_header(const UncertaintyOptions& asked = {});
std::string combined_csv_row(const Evaluated& evaluated, const UncertaintyOptions& asked = {});
std::string combined_csv_error_row(const std::string& file, const Error& error, const UncertaintyOptions& asked = {});

}  // namespace axiometry::app
