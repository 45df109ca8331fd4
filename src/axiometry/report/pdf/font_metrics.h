// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::report {

enum class FaceStyle { regular, bold, italic };

/// Advance width of a character in thousandths of the font size, in the sans serif face of all figures
/// (Liberation Sans, metrically equal to Arial). Control characters and combining marks have width 0;
/// East Asian characters are a full em; anything else unknown counts as an average letter.
int advance_width(char32_t character, FaceStyle style);

}  // namespace axiometry::report
