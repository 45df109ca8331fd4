// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"

/// Text of instruments whose programs write the code page of their computer: its encoding is found out, never stated.
namespace axiometry::formats {

struct DecodedText {
  std::string text;            ///< UTF-8 without a byte order mark; lines end in LF or CRLF
  std::string_view encoding;   ///< "UTF-8", "UTF-16", "GBK", "Windows-1252" or "Latin-1"
  bool old_line_ends = false;  ///< lines ended in CR alone
};

/// Tries, in this order: UTF-8; UTF-16 with a byte order mark or a zero in every second byte; GBK, when every byte
/// beyond ASCII is part of a pair and three of four pairs are common characters of GB 2312; Windows-1252; Latin-1,
/// which every byte fits. Lines that end in CR alone are accepted. Fails as readable_text() does on empty and binary
/// content, and on UTF-16 that is cut or broken.
Result<DecodedText> decoded_text(std::string_view bytes);

/// The same where the encoding is stated, by one of the names above. Fails on bytes that have no meaning in it.
Result<DecodedText> decoded_as(std::string_view bytes, std::string_view encoding);

/// What a reader tells when the text was not plain UTF-8: nothing, or one remark that departs from no standard.
std::vector<SourceRemark> encoding_remarks(const DecodedText& decoded);

}  // namespace axiometry::formats
