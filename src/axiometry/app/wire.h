// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/evaluate.h"
#include "axiometry/base/json.h"

/// Results as machines read them: JSON objects and the rows of a combined CSV. The one place that
/// spells their keys; docs/results.md describes them.
namespace axiometry::app {

/// One evaluation. Numbers are in the axis' native unit ("um" or "arcsec") and full double precision;
/// what does not exist is null.
json::Value to_json(const Evaluated& evaluated);

/// What stands in a combined JSON for an input that could not be read.
json::Value error_to_json(const std::string& file, const Error& error);

/// Header and rows of the table of many evaluations: file, test, axis, kind, unit, conforming, the
/// twelve parameters, their U, error, verdict, keys of the parameters that do not conform and of those undecided;
/// RFC 4180, full precision, empty where null.
std::string combined_csv_header();
std::string combined_csv_row(const Evaluated& evaluated);
std::string combined_csv_error_row(const std::string& file, const Error& error);

}  // namespace axiometry::app
