// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/report/drawing/figure.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// The standard's symbols as they are typeset: letters italic, indices low, arrows upright.
namespace axiometry::report::plot {

using Runs = std::vector<TextRun>;

TextRun plain(std::string_view text);
TextRun italic(std::string_view text);
TextRun barred(std::string_view letter);        ///< italic with a bar: x̄
TextRun index_letter(std::string_view letter);  ///< low and italic: the i of x̄_i
TextRun index_number(std::size_t number);       ///< low and upright: the 3 of R_3

/// "A↑" with an italic letter, "B̄" with a drawn bar.
Runs symbol(const iso230_2::ParameterInfo& parameter);

Runs joined(Runs first, const Runs& second);

/// The text cut after whole characters so that it fits, with an ellipsis when anything was cut.
std::string shortened(std::string_view text, double width, double size);

}  // namespace axiometry::report::plot
