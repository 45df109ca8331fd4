// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/store_address.h"

#include <cstdlib>

namespace axiometry::app {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

Result<std::string> user_data_folder() {
  // By the specification a path that is not absolute is ignored.
  if (const std::string data = environment("XDG_DATA_HOME"); data.starts_with('/')) return data;
  if (const std::string home = environment("HOME"); !home.empty()) return home + "/.local/share";
  return fail("found no home for the store, expected its address, AXIOMETRY_STORE, XDG_DATA_HOME or HOME");
}

Result<std::string> default_store_address() {
  if (const std::string address = environment("AXIOMETRY_STORE"); !address.empty()) return address;
  AXIOMETRY_TRY(const std::string data, user_data_folder());
  return data + "/axiometry/axiometry.db";
}

Result<std::string> store_address(const std::string& asked) {
  if (!asked.empty()) return asked;
  return default_store_address();
}

}  // namespace axiometry::app
