// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/table/generic_delimited.h"

/// The use case "from a measured file to one of the project's own formats", and the guess at an unknown one.
namespace axiometry::app {

struct ConvertOptions {
  std::string input;   ///< file, "-" for the standard input
  std::string output;  ///< file, "-" for the standard output
  std::string to;      ///< id of a format that can be written; empty: by the extension of the output
  std::string format;  ///< id to force; empty: recognised by content
  std::string profile;
  std::vector<std::pair<std::string, std::string>> metadata;  ///< key and text, over what the file says
};

/// The format to write: named, or by the extension (.json, .csv). Fails on others and on formats that are only read.
Result<const formats::Format*> format_to_write(const std::string& to, const std::string& output);

/// Bytes of a test in a format that can be written. They are read again and compared first: fails where the format
/// could not hold every reading and every item of metadata.
Result<std::string> lossless_bytes(const Test& test, const formats::Format& format);

/// What these bytes leave behind all the same, in sentences: times, which only JSON keeps, and what the reader had to
/// remark, which JSON keeps too.
std::vector<std::string> left_behind(const Test& test, const formats::Format& format);

/// Reads one test and writes it, whole or not at all, and never over an input. Fails as lossless_bytes(). Gives
/// left_behind().
Result<std::vector<std::string>> convert(const ConvertOptions& options);

/// What a file that no format describes was taken for. Fails as formats::guess() does.
Result<formats::Guess> guess_file(const std::string& name);

/// Writes the profile of a guess, open questions as null. Never over the file that was guessed at.
Result<void> save_profile(const formats::ImportProfile& profile, const std::string& output, const std::string& input);

}  // namespace axiometry::app
