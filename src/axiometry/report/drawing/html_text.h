// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "axiometry/report/document.h"

/// Text that anyone may have written, made harmless in a web page.
namespace axiometry::report::html {

/// cleaned(), for element content and quoted attributes.
std::string escaped(std::string_view text);

/// Styles as <i>, <b>, <sub>, <sup>; a bar as a span that says so to those who listen.
std::string rich(const RichText& text);

/// A quoted CSS string, safe inside a <style> element.
std::string css_string(std::string_view text);

/// Characters (code points), combining marks not counted.
std::size_t length(std::string_view text);

}  // namespace axiometry::report::html
