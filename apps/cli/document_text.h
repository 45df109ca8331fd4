// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/report/document.h"
#include "terminal.h"

namespace axiometry::cli {

/// A document as text: title, facts, tables and paragraphs; its figures are left to the other outputs.
std::string document_text(const report::Document& document, const Terminal& terminal);

}  // namespace axiometry::cli
