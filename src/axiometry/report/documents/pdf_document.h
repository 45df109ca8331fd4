// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/pdf/pdf_flow.h"

namespace axiometry::report::pdf {

/// Sets the whole document; running heads and feet are left to the writer, who knows the page count. The figures are
/// drawn from the document, which must live as long.
PageFlow set_document(const Document& document, const Typesetter& typesetter);

}  // namespace axiometry::report::pdf
