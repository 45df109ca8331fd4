// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json/json.h"
#include "axiometry/report/document.h"

/// A report's document as a page takes it apart: the same words, tables and figures as in the report.
namespace axiometry::app {

/// Title, notices and sections, with their blocks by kind: paragraph, notice, facts, table, figure (as SVG). Texts are
/// lists of runs, each with what is special of its style. For a dark page the colours of figures are turned.
/// The document is taken as it is: translate it before.
json::Value document_to_json(const report::Document& document, bool dark);

}  // namespace axiometry::app
