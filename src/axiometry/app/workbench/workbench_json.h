// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/app/files/reader.h"
#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/json/json.h"

/// The workbench's values as the API spells them (apps/server/openapi.json), and its requests as values. Texts of this
/// program are set in the reader's language; what users wrote stays.
namespace axiometry::app {

json::Value to_json(const Outcome& outcome, const Reader& reader);    ///< Evaluated
json::Value to_json(const Preview& preview, const Reader& reader);    ///< Preview
json::Value to_json(const Received& received, const Reader& reader);  ///< Received
json::Value to_json(const KeptTest& kept, const Reader& reader);      ///< Test
json::Value to_json(const store::TestPage& page, const Reader& reader);
json::Value to_json(const store::DocumentRecord& document);
json::Value to_json(const store::Change& change);
json::Value figures_to_json(std::span<const store::FigureRecord> figures);
json::Value error_to_json(const Error& error, const Reader& reader);  ///< the inner object of a Failure

/// null for an empty text.
json::Value text_or_null(const std::string& text);
json::Value id_value(store::Id id);
json::Value id_and_name(store::Id id, const std::string& name);  ///< Reference

/// {"changes", "options"}; either may be left out. Each fails, with line and column, on members that are unknown or of
/// another kind.
Result<Draft> draft_from(const json::Value& value);
/// Needs base_version.
Result<Revision> revision_from(const json::Value& value);

}  // namespace axiometry::app
