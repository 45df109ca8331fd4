// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <random>

#include "axiometry/store/kept/folded_text.h"
#include "axiometry/store/store.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using Order = TestFilter::Order;

/// More tests than are sorted at once, so that both ways to a page are gone; equal values and absent ones among them.
std::vector<NewTest> many_tests(std::size_t count) {
  std::mt19937 random(1);
  const auto one_of = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  std::vector<NewTest> tests;
  for (std::size_t k = 0; k < count; ++k) {
    NewTest test = new_test(fmt::format("Test {} {}", one_of(50), one_of(3) == 0 ? "Äpfel" : "pears"));
    TestState& state = test.state;
    const unsigned machine = one_of(5);
    state.machine.name = fmt::format("Machine {}", machine);
    state.machine.serial_number = fmt::format("{}", machine);
    state.axis.name = one_of(3) == 0 ? "X" : "Y";
    state.instruments[0].serial_number = one_of(20) == 0 ? "1" : "0";
    state.measured_on = fmt::format("20{:02}-0{}-1{}", one_of(20), one_of(9) + 1, one_of(9));
    state.evaluation.verdict = one_of(100) == 0 ? "undecided" : one_of(2) == 0 ? "conforms" : "";
    state.evaluation.figures.clear();
    for (const char* parameter : {"A", "E", "R", "B"})
      if (one_of(10) != 0) state.evaluation.figures.push_back({parameter, one_of(100) / 8.0, 0.5, {}, ""});
    tests.push_back(std::move(test));
  }
  return tests;
}

struct Listed {
  Id id;
  const TestState* state;
};

std::optional<double> value_of(const TestState& state, Order order) {
  static const char* const names[] = {"A", "E", "R", "B"};
  for (const FigureRecord& figure : state.evaluation.figures)
    if (figure.parameter == names[static_cast<int>(order) - static_cast<int>(Order::A)]) return figure.value;
  return {};
}

std::string text_of(const TestState& state, Order order) {
  switch (order) {
    case Order::measured: return state.measured_on;
    case Order::title: return folded(state.title);
    case Order::machine: return folded(state.machine.name) + '\x01' + folded(state.axis.name);
    default: return "";
  }
}

bool fits(const TestState& state, const TestFilter& filter) {
  const std::string words = folded(state.title + " run.csv " + state.machine.name + " " + state.axis.name);
  for (std::size_t at = 0; at < filter.text.size();) {
    const std::size_t end = std::min(filter.text.find(' ', at), filter.text.size());
    if (words.find(folded(filter.text.substr(at, end - at))) == std::string::npos) return false;
    at = end + 1;
  }
  return (!filter.machine || state.machine.name == fmt::format("Machine {}", *filter.machine - 1)) &&
         (filter.verdict.empty() || state.evaluation.verdict == filter.verdict) &&
         (filter.measured_from.empty() || state.measured_on >= filter.measured_from) &&
         (filter.measured_to.empty() || state.measured_on.substr(0, filter.measured_to.size()) <= filter.measured_to) &&
         (!filter.instrument || (state.instruments[0].serial_number == "1") == (*filter.instrument == 1));
}

/// What the list must be, found in the most simple way.
std::vector<Id> expected(const std::vector<NewTest>& tests, const TestFilter& filter) {
  std::vector<Listed> rows;
  for (std::size_t k = 0; k < tests.size(); ++k)
    if (fits(tests[k].state, filter)) rows.push_back({static_cast<Id>(k) + 1, &tests[k].state});
  std::ranges::sort(rows, [&](const Listed& a, const Listed& b) {
    const auto [first, second] = filter.descending ? std::pair(b, a) : std::pair(a, b);
    if (filter.order >= Order::A) {
      const auto x = value_of(*first.state, filter.order), y = value_of(*second.state, filter.order);
      if (x.has_value() != y.has_value()) return value_of(*a.state, filter.order).has_value();  // absent ones last
      if (x != y) return x < y;
    }
    const std::string x = text_of(*first.state, filter.order), y = text_of(*second.state, filter.order);
    return x != y ? x < y : first.id < second.id;
  });
  std::vector<Id> ids;
  for (const Listed& row : rows) ids.push_back(row.id);
  return ids;
}

std::vector<TestFilter> filters() {
  std::vector<TestFilter> filters(11);
  filters[1].text = "äpfel";
  filters[2].text = "PEARS machine";
  filters[3].text = "test 7 Äpfel";
  filters[4].machine = 1;
  filters[5].verdict = "conforms";
  filters[6].verdict = "undecided";
  filters[7].measured_from = "2005-01-12";
  filters[7].measured_to = "2015-06-11";
  filters[8].instrument = 1;
  filters[8].text = "x";
  filters[9].instrument = 2;
  filters[10].text = "100%_";
  return filters;
}

class StoreListTest : public BothStores {};
AXIOMETRY_ON_BOTH_STORES(StoreListTest);

TEST_P(StoreListTest, GivesEveryPageOfEveryFilterInEveryOrder) {
  std::vector<NewTest> tests = many_tests(4500);
  tests[0].state.machine.name = "Machine 0";  // machines are numbered as they come
  for (std::size_t k = 0; k < 5; ++k) {
    tests[k].state.machine.name = fmt::format("Machine {}", k);
    tests[k].state.machine.serial_number = fmt::format("{}", k);
    tests[k].state.instruments[0].serial_number = k == 0 ? "1" : "0";
  }
  const auto store = must(Store::open(new_address()));
  must(store->receive(content_of("abc"), tests, by_anna));
  for (TestFilter filter : filters())
    for (int order = 0; order < 8; ++order)
      for (const bool descending : {false, true}) {
        filter.order = static_cast<Order>(order);
        filter.descending = descending;
        const std::vector<Id> ids = expected(tests, filter);
        for (const std::size_t offset : {std::size_t{0}, ids.size() / 2, ids.size() > 3 ? ids.size() - 3 : 0}) {
          filter.offset = static_cast<std::int64_t>(offset);
          filter.limit = 20;
          const TestPage page = must(store->tests(filter));
          std::vector<Id> found;
          for (const TestRow& row : page.rows) found.push_back(row.id);
          const std::size_t end = std::min(offset + 20, ids.size());
          ASSERT_EQ(page.total, static_cast<std::int64_t>(ids.size())) << filter.text << filter.verdict;
          ASSERT_EQ(found, (std::vector<Id>(ids.begin() + static_cast<std::ptrdiff_t>(offset),
                                            ids.begin() + static_cast<std::ptrdiff_t>(end))))
              << "text " << filter.text << " order " << order << " descending " << descending << " offset " << offset;
          if (page.rows.empty()) continue;
          const NewTest& first = tests[static_cast<std::size_t>(found[0]) - 1];
          EXPECT_EQ(page.rows[0].title, first.state.title);
          EXPECT_EQ(page.rows[0].figures.size(), first.state.evaluation.figures.size());
        }
      }
}

TEST_P(StoreListTest, HaveOfATestOfOneDirectionWhatItHasInPlaceOfBoth) {
  std::vector<NewTest> tests = {new_test("both"), new_test("one")};
  const auto with = [](NewTest& test, std::initializer_list<const char*> parameters) {
    test.state.evaluation.figures.clear();
    for (const char* parameter : parameters) test.state.evaluation.figures.push_back({parameter, 1.0, {}, {}, ""});
  };
  with(tests[0], {"A", "A_up", "A_down", "E", "E_up", "E_down", "M", "R", "R_up", "R_down", "B", "B_mean"});
  with(tests[1], {"A_down", "E_down", "R_down"});
  const auto store = must(Store::open(new_address()));
  must(store->receive(content_of("abc"), tests, by_anna));
  const TestPage page = must(store->tests({}));
  ASSERT_EQ(page.rows.size(), 2u);
  for (const TestRow& row : page.rows) {
    std::string found;
    for (const FigureRecord& figure : row.figures) found += figure.parameter + " ";
    EXPECT_EQ(found, row.title == "both" ? "A E R B " : "A_down E_down R_down ");
  }
}

TEST(FoldedText, MakesCapitalsSmall) {
  EXPECT_EQ(folded("AZ az 09 ÄÖÜß ÉŁŽ ΑΩ ЖЁ ×÷ ÿŸ"), "az az 09 äöüß éłž αω жё ×÷ ÿÿ");
  EXPECT_EQ(folded("ab€", 4), "ab") << "never half a letter";
  EXPECT_EQ(folded("\xff\xc3"), "\xff\xc3");
}

}  // namespace
}  // namespace axiometry::store
