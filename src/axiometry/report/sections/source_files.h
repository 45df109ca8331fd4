// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "axiometry/report/document.h"

/// Where results come from that no single test holds.
namespace axiometry::report {

/// A file that a result was made of.
struct SourceFile {
  std::string_view what;    ///< what it holds, in English: "Machine"; or a name, "EXX"
  std::string_view file;    ///< its name; "-" is the standard input
  std::string_view sha256;  ///< empty where nobody reckoned it
};

/// The name of the file without its folders.
TableCell file_cell(std::string_view path);

/// The section Provenance: every file with its SHA-256, and the program.
Section provenance_of_files(std::span<const SourceFile> files);

}  // namespace axiometry::report
