// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stop_token>
#include <string_view>

#include "axiometry/store/store.h"
#include "axiometry/store/store_state.h"

namespace axiometry::store {
namespace {

/// Some tenths of a second on a slow disk: so long nobody who ends the program waits.
constexpr Id tests_warmed_at_once = 2000;

/// What every search reads first. Each asks for a column behind the others, so that whole rows are read.
constexpr std::string_view first_reads[] = {
    "SELECT sum(length(words)) FROM test_search WHERE test > $1 AND test <= $2",
    "SELECT sum(length(content)) FROM test_list WHERE test > $1 AND test <= $2",
    "SELECT sum(length(verdict)) FROM figure WHERE test > $1 AND test <= $2",
};

}  // namespace

Result<void> Store::warm_up(const std::stop_token& stop) const {
  if (info().kind != "sqlite") return {};
  AXIOMETRY_TRY(const Counts kept, counts());
  for (const std::string_view sql : first_reads) {
    for (Id newest = kept.tests; newest > 0 && !stop.stop_requested(); newest -= tests_warmed_at_once) {
      const Id before = std::max<Id>(0, newest - tests_warmed_at_once);
      AXIOMETRY_TRY_VOID(state_->read([&](Connection& connection) { return connection.run(sql, {before, newest}); }));
    }
  }
  return {};
}

}  // namespace axiometry::store
