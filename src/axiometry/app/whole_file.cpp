// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/whole_file.h"

#include "axiometry/app/source.h"

namespace axiometry::app {
namespace {

constexpr std::size_t size_limit = std::size_t{64} << 20;

Result<std::string> all_of(const std::string& name) {
  AXIOMETRY_TRY(Source source, Source::open(name));
  return source.read_all(size_limit);
}

}  // namespace

Error in_file(Error error, const std::string& file) {
  if (error.file.empty() || error.file == file) error.file = file == "-" ? "(standard input)" : file;
  return error;
}

Result<std::string> whole_file(const std::string& name) { return in_file(all_of(name), name); }

}  // namespace axiometry::app
