// SPDX-License-Identifier: Apache-2.0
// An archive of 100 000 tests, as sixty machines give in years: raw data of 5 kB, results of 16 kB. It is filled once
// (minutes) and kept: the environment's AXIOMETRY_BENCH_STORE is its address, a file in the temporary folder otherwise.
#include "axiometry/store/store.h"

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "axiometry/digest/sha256.h"
#include "axiometry/store/kept/test_versions.h"
#include "axiometry/store/place.h"

namespace axiometry::store {
namespace {

constexpr Id tests_in_archive = 100'000;
constexpr int machines = 60;
constexpr int tests_per_transaction = 500;
constexpr int cold_runs = 8;

std::string address() {
  const char* set = std::getenv("AXIOMETRY_BENCH_STORE");
  return set != nullptr ? set : (std::filesystem::temp_directory_path() / "axiometry-bench-store.db").string();
}

/// Numbers as they stand in results, of about this many bytes.
std::string numbers(std::mt19937& random, std::size_t bytes) {
  std::string text;
  while (text.size() < bytes)
    text += fmt::format("{}{}", text.empty() ? "" : ",", static_cast<int>(random() % 20'000) / 1000.0 - 10.0);
  return text;
}

NewTest test_of(std::mt19937& random, Id number) {
  static constexpr const char* axes[] = {"X", "Y", "Z", "B"};
  const auto one_of = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  const unsigned machine = one_of(machines);
  const unsigned axis = one_of(4);
  NewTest test;
  TestState& state = test.state;
  state.title = fmt::format("{} {} {:05}", one_of(10) == 0 ? "Abnahme" : "Jahresprüfung", axes[axis], number);
  state.machine.name = fmt::format("Machining centre {:02}", machine);
  state.machine.manufacturer = "Maker";
  state.machine.serial_number = fmt::format("SN-{}", 1000 + machine);
  state.axis.name = axes[axis];
  state.axis.kind = axis == 3 ? "rotary" : "linear";
  InstrumentRecord& laser = state.instruments.emplace_back();
  laser.role = "Laser interferometer";
  laser.serial_number = fmt::format("L-{}", one_of(6));
  state.measured_on = fmt::format("{}-{:02}-{:02}", 2000 + one_of(26), 1 + one_of(12), 1 + one_of(28));
  state.changes = "{}";
  EvaluationRecord& evaluation = state.evaluation;
  evaluation.program = "axiometry 0.1.0";
  evaluation.standard = "ISO 230-2:2014";
  evaluation.options = R"({"methods":["gum"],"trials":null,"seed":1,"coverage":0.95,"corrections":[]})";
  evaluation.result = fmt::format(R"({{"positions":[{}]}})", numbers(random, 16'000));
  evaluation.unit = axis == 3 ? "arcsec" : "um";
  evaluation.conforming = one_of(8) != 0;
  evaluation.verdict = one_of(50) == 0 ? "undecided" : one_of(4) == 0 ? "does not conform" : "conforms";
  for (const char* parameter :
       {"A", "A_up", "A_down", "E", "E_up", "E_down", "M", "R", "R_up", "R_down", "B", "B_mean"})
    evaluation.figures.push_back({parameter, one_of(20'000) / 1000.0, 0.4, 10.0, "conforms"});
  return test;
}

Result<void> fill(const std::string& where) {
  AXIOMETRY_TRY(const std::unique_ptr<Place> place, place_of(where, {}));
  AXIOMETRY_TRY(const std::unique_ptr<Connection> connection, place->connect());
  AXIOMETRY_TRY(const Rows there, connection->query("SELECT coalesce(max(id), 0) FROM test"));
  std::mt19937 random(static_cast<unsigned>(there[0].integer(0)));
  for (Id number = there[0].integer(0) + 1; number <= tests_in_archive;) {
    AXIOMETRY_TRY_VOID(connection->begin_write());
    for (int k = 0; k < tests_per_transaction && number <= tests_in_archive; ++k, ++number) {
      const std::string bytes = fmt::format("# {}\n{}", number, numbers(random, 5'000));
      const Content content{sha256(bytes), fmt::format("run-{:05}.csv", number), "csv-long", bytes};
      const NewTest test = test_of(random, number);
      AXIOMETRY_TRY(const auto ids, receive_tests(*connection, content, std::span(&test, 1), {"bench", ""}));
      benchmark::DoNotOptimize(ids);
    }
    AXIOMETRY_TRY_VOID(connection->commit());
  }
  if (there[0].integer(0) < tests_in_archive)
    AXIOMETRY_TRY_VOID(connection->run(connection->is_sqlite() ? "PRAGMA wal_checkpoint(TRUNCATE)" : "VACUUM ANALYZE"));
  return {};
}

Store* archive(benchmark::State& state) {
  static const auto opened = [] {
    auto store = Store::open(address());
    if (!store) return store;
    const auto filled = fill(address());
    if (!filled) return Result<std::unique_ptr<Store>>(std::unexpected(filled.error()));
    return store;
  }();
  if (opened) return opened->get();
  state.SkipWithError(opened.error().to_string().c_str());
  return nullptr;
}

/// Takes the archive's pages out of memory, so that the next reader has them from the disk. Of SQLite only: what a
/// server has in its memory is not ours.
bool forget_pages() {
  if (is_postgresql(address())) return false;
  for (const char* rest : {"", "-wal"}) {
    const int descriptor = ::open((address() + rest).c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) continue;
    ::fsync(descriptor);
    ::posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
    ::close(descriptor);
  }
  return true;
}

/// Whatever else the computer does only adds to a time.
double least(const std::vector<double>& times) { return *std::ranges::min_element(times); }

/// How large an answer is, or why there is none.
using Answer = Result<std::int64_t>;

template <typename Ask>
void warm(benchmark::State& state, const Ask& ask) {
  Store* const store = archive(state);
  if (store == nullptr) return;
  std::int64_t size = 0;
  for (auto _ : state) {
    const Answer answer = ask(*store);
    if (!answer) return state.SkipWithError(answer.error().message.c_str());
    size = *answer;
  }
  state.counters["total"] = static_cast<double>(size);
}

/// What a program pays that has just been started on a computer that has: opening the archive is part of it.
template <typename Ask>
void cold(benchmark::State& state, const Ask& ask) {
  if (archive(state) == nullptr) return;
  for (auto _ : state) {
    state.PauseTiming();
    if (!forget_pages()) return state.SkipWithError("the pages of a server cannot be taken out of its memory");
    state.ResumeTiming();
    auto store = Store::open(address());
    if (!store) return state.SkipWithError(store.error().message.c_str());
    if (const Answer answer = ask(**store); !answer) return state.SkipWithError(answer.error().message.c_str());
    state.PauseTiming();
    store->reset();
    state.ResumeTiming();
  }
}

Answer page(const Store& store, const TestFilter& filter) {
  AXIOMETRY_TRY(const TestPage found, store.tests(filter));
  return found.total;
}

Answer course(const Store& store) {
  static const std::vector<std::string> parameters = {"A", "E", "R", "B"};
  AXIOMETRY_TRY(const auto points, store.trend(7, parameters, 500));
  return static_cast<std::int64_t>(points.size());
}

void list(benchmark::State& state, const TestFilter& filter) {
  warm(state, [&](const Store& store) { return page(store, filter); });
}

void cold_list(benchmark::State& state, const TestFilter& filter) {
  cold(state, [&](const Store& store) { return page(store, filter); });
}

TestFilter filter(void (*set)(TestFilter&)) {
  TestFilter made;
  set(made);
  return made;
}

#define AXIOMETRY_LIST(name, ...)                                                \
  BENCHMARK_CAPTURE(list, name, filter([](TestFilter& f) { __VA_ARGS__; }))      \
      ->UseRealTime()                                                            \
      ->Unit(benchmark::kMillisecond);                                           \
  BENCHMARK_CAPTURE(cold_list, name, filter([](TestFilter& f) { __VA_ARGS__; })) \
      ->UseRealTime()                                                            \
      ->Unit(benchmark::kMillisecond)                                            \
      ->Iterations(1)                                                            \
      ->Repetitions(cold_runs)                                                   \
      ->ComputeStatistics("least", least)                                        \
      ->DisplayAggregatesOnly()

AXIOMETRY_LIST(newest, static_cast<void>(f));
AXIOMETRY_LIST(last_page, f.offset = tests_in_archive - 50);
AXIOMETRY_LIST(by_date, f.order = TestFilter::Order::measured);
AXIOMETRY_LIST(by_title_ascending, f.order = TestFilter::Order::title; f.descending = false);
AXIOMETRY_LIST(by_machine, f.order = TestFilter::Order::machine; f.descending = false);
AXIOMETRY_LIST(by_A, f.order = TestFilter::Order::A);
AXIOMETRY_LIST(by_B_ascending, f.order = TestFilter::Order::B; f.descending = false);
AXIOMETRY_LIST(text_of_one, f.text = "prüfung 04711");
AXIOMETRY_LIST(text_of_none, f.text = "no such words");
AXIOMETRY_LIST(text_of_a_tenth, f.text = "ABNAHME"; f.order = TestFilter::Order::A);
AXIOMETRY_LIST(text_of_all, f.text = "machining"; f.order = TestFilter::Order::measured);
AXIOMETRY_LIST(text_and_machine, f.text = "abnahme"; f.machine = 7);
AXIOMETRY_LIST(of_machine, f.machine = 7; f.order = TestFilter::Order::measured);
AXIOMETRY_LIST(of_axis_by_A, f.axis = 7; f.order = TestFilter::Order::A);
AXIOMETRY_LIST(of_instrument_by_A, f.instrument = 2; f.order = TestFilter::Order::A);
AXIOMETRY_LIST(of_verdict, f.verdict = "conforms"; f.order = TestFilter::Order::E);
AXIOMETRY_LIST(of_rare_verdict, f.verdict = "undecided"; f.order = TestFilter::Order::R);
AXIOMETRY_LIST(of_a_year, f.measured_from = "2014-01-01"; f.measured_to = "2014-12-31";
               f.order = TestFilter::Order::measured);
AXIOMETRY_LIST(of_ten_years, f.measured_from = "2010-01-01"; f.measured_to = "2019-12-31";
               f.order = TestFilter::Order::A);
AXIOMETRY_LIST(a_thousand_rows, f.limit = 1000);

void trend(benchmark::State& state) { warm(state, course); }
BENCHMARK(trend)->UseRealTime()->Unit(benchmark::kMillisecond);

void cold_trend(benchmark::State& state) { cold(state, course); }
BENCHMARK(cold_trend)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->Repetitions(cold_runs)
    ->ComputeStatistics("least", least)
    ->DisplayAggregatesOnly();

void one_test(benchmark::State& state) {
  Store* const store = archive(state);
  if (store == nullptr) return;
  Id id = 0;
  for (auto _ : state) {
    id = id * 7919 % tests_in_archive + 1;
    const auto test = store->test(id);
    if (!test) return state.SkipWithError(test.error().message.c_str());
  }
}
BENCHMARK(one_test)->UseRealTime()->Unit(benchmark::kMillisecond);

void counts(benchmark::State& state) {
  Store* const store = archive(state);
  if (store == nullptr) return;
  for (auto _ : state)
    if (const auto counted = store->counts(); !counted) return state.SkipWithError(counted.error().message.c_str());
}
BENCHMARK(counts)->UseRealTime()->Unit(benchmark::kMillisecond);

/// What a program that has just been started pays.
void open_and_list(benchmark::State& state) {
  if (archive(state) == nullptr) return;
  TestFilter asked;
  asked.text = "prüfung 04711";
  for (auto _ : state) {
    const auto store = Store::open(address());
    if (!store) return state.SkipWithError(store.error().message.c_str());
    if (const auto page = (*store)->tests(asked); !page) return state.SkipWithError(page.error().message.c_str());
  }
}
BENCHMARK(open_and_list)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace axiometry::store
