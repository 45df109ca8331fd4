// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/same_bytes.h"

#include <algorithm>
#include <string>
#include <tuple>

namespace axiometry::store {
namespace {

struct KeptTest {
  Id id = 0;
  int version = 1;
};

}  // namespace

Result<std::map<Id, std::vector<Id>>> repeated_tests(Connection& connection, Id axis) {
  // All tests of such a file, whatever axis they are of: only so the place of each in it is known.
  AXIOMETRY_TRY(const Rows rows,
                connection.query("SELECT l.test, l.version, l.withdrawn, l.axis, l.content, l.received_at, "
                                 "l.file_name, t.name_in_file FROM test_list l JOIN test t ON t.id = l.test WHERE "
                                 "l.content IN (SELECT content FROM test_list WHERE axis = $1 AND withdrawn = 0 GROUP "
                                 "BY content HAVING count(*) > 1) ORDER BY l.test",
                                 {axis}));
  using Receipt = std::tuple<std::string, std::string, std::string>;  // content, when, name of the file
  using Place = std::tuple<std::string, std::size_t, std::string>;    // content, which in the file, its name there
  std::map<Receipt, std::size_t> seen;
  std::map<Place, std::vector<KeptTest>> tests;
  for (const Row& row : rows) {
    const std::size_t place = seen[{row.text(4), row.text(5), row.text(6)}]++;
    if (row.flag(2) || row.optional_integer(3) != axis) continue;
    tests[{row.text(4), place, row.text(7)}].push_back({row.integer(0), row.number(1)});
  }
  std::map<Id, std::vector<Id>> repeated;
  for (auto& [place, same] : tests) {
    if (same.size() < 2) continue;
    const auto counted = std::ranges::max_element(same, {}, &KeptTest::version);
    for (const KeptTest& one : same)
      if (one.id != counted->id) repeated[counted->id].push_back(one.id);
  }
  return repeated;
}

}  // namespace axiometry::store
