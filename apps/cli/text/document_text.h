// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "cli/text/terminal.h"

namespace axiometry::cli {

/// A document as text in the reader's language: title, facts, tables and paragraphs; its figures are left to the other
/// outputs.
std::string document_text(const report::Document& document, const report::Options& options, const Terminal& terminal);

}  // namespace axiometry::cli
