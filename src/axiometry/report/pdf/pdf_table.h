// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/pdf/pdf_flow.h"

namespace axiometry::report::pdf {

/// Room that a table asks for where it begins: all of it, with its notes, when it is short, else its head and a few
/// rows.
double beginning_height(const Table& table, const Typesetter& typesetter);

/// Sets a table over the full width. Columns are as wide as their content; columns that take space
/// share the rest and wrap; where that is not enough, the table is set smaller. Across pages its head
/// is repeated. Numbers stand at the decimal mark.
void set_table(const Table& table, const Typesetter& typesetter, PageFlow& flow);

}  // namespace axiometry::report::pdf
