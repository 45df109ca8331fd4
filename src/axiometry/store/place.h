// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/store/database/connection.h"
#include "axiometry/store/store.h"

/// Where an archive is, and how one gets connections to it.
namespace axiometry::store {

class Place {
 public:
  virtual ~Place() = default;
  virtual Result<std::unique_ptr<Connection>> connect() const = 0;
  /// Without schema, which is found inside.
  virtual Info info() const = 0;
};

/// A file. Finds out whether it can be written, makes it (readable for its owner only, with its folder) where there is
/// none and `opening` allows; refuses a file that is no archive without touching it.
Result<std::unique_ptr<Place>> sqlite_place(const std::string& file, const Opening& opening);

/// "postgresql://…" or "postgres://…": libpq's URI. Tables are in the schema "axiometry" unless the URI sets another
/// search_path by its options. Neither info() nor an error ever shows the password.
Result<std::unique_ptr<Place>> postgresql_place(const std::string& uri, const Opening& opening);

bool is_postgresql(std::string_view address);

/// The one of the two that the address asks for.
Result<std::unique_ptr<Place>> place_of(std::string_view address, const Opening& opening);

}  // namespace axiometry::store
