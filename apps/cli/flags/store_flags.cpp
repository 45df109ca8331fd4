// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/store_flags.h"

#include "axiometry/app/files/store_address.h"

namespace axiometry::cli {

Result<std::unique_ptr<store::Store>> archive_at(const std::string& given, const store::Opening& opening) {
  AXIOMETRY_TRY(const std::string address, app::store_address(given));
  return store::Store::open(address, opening);
}

Flag add_store_flag(const Verb& verb, std::string& address) {
  return verb
      .add_option("--store", address,
                  "Archive: a file or postgresql://… (AXIOMETRY_STORE, else axiometry.db among the user's data)")
      .type_name("ADDRESS");
}

}  // namespace axiometry::cli
