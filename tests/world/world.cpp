// SPDX-License-Identifier: Apache-2.0
//
// axiometry_world FIRST_SEED [COUNT]: the archive, the API of the workbench and captures in a world that a seed makes:
// a client whose requests and answers get lost, an instrument that falls silent, breaks off and comes back, a program
// that is killed, a disk that is full, refuses, or loses its power and with it what was not synced, and a clock that
// somebody sets back. Whatever happens, of every archive it must be true that what was acknowledged is there as it was
// acknowledged, that what failed has left no trace, that the chain is sound, that an evaluation made again is the one
// that was kept, that a recording played again gives the readings that people saw, and that each capture becomes one
// test. A failure names its seed, which alone repeats it.
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "captures.h"
#include "expect.h"
#include "life.h"
#include "simulated_clock.h"
#include "simulated_disk.h"
#include "simulated_files.h"

using namespace axiometry;
using namespace axiometry::world;
namespace files = std::filesystem;

namespace {

/// A folder in memory, where there is one: a disk that is simulated needs none.
class Folder {
 public:
  Folder() : path_(files::is_directory("/dev/shm") ? "/dev/shm" : files::temp_directory_path().string()) {
    path_ += "/axiometry-world-XXXXXX";
    if (::mkdtemp(path_.data()) == nullptr) broken("cannot make " + path_);
  }
  ~Folder() {
    std::error_code ignored;
    files::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string life(int number) const {
    const std::string path = fmt::format("{}/{}", path_, number);
    files::create_directories(path);
    return path;
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// What has been acknowledged: the answers to the client, by which it goes ever after.
struct Promised {
  struct Version {
    std::string title;
    std::string shown;
  };
  struct Test {
    std::string bytes;
    std::map<int, Version> versions;
    int latest = 0;
    bool in_doubt = false;  ///< an edit of it may or may not have been kept
  };
  std::map<int, Test> tests;
  std::map<int, std::string> documents;  ///< bytes
  std::vector<std::string> machines;
  std::size_t doubtful_tests = 0;  ///< uploads whose answer did not come
};

Promised::Version version_of(const json::Value& test) {
  const json::Value* const tests = test.find("tests");  // of an upload, which may be several
  const json::Value* const title = (tests == nullptr ? test : tests->items().front()).find("title");
  const json::Value* const shown = test.find("shown");
  if (title == nullptr || shown == nullptr) broken("an answer is no test: " + json::dump(test, 0).substr(0, 300));
  return {title->text(), json::dump(*shown)};
}

/// Readings of three targets, twice from both sides.
std::string readings(Chance& chance) {
  std::string csv = "# machine.name: Mill 1\n# axis.name: X\ntarget_mm,direction,run,deviation_um\n";
  for (int run = 1; run <= 2; ++run)
    for (const char* direction : {"up", "down"})
      for (int target = 0; target < 3; ++target)
        csv += fmt::format("{},{},{},{}.{}\n", 100 * target, direction, run, chance() % 9, chance() % 10);
  return csv;
}

class World {
 public:
  explicit World(std::uint32_t seed) : chance_(seed * 2'654'435'761u + 1) {}

  const Captures& captures() const { return captures_; }

  void run(const std::string& template_file) {
    std::string file = folder_.life(0) + "/archive.db";
    if (chance_() % 8 != 0) files::copy_file(template_file, file);
    const int lives = 1 + static_cast<int>(chance_() % 3);
    for (int k = 1; k <= lives; ++k) {
      const std::string next = folder_.life(k);
      live(file, next);
      file = next + "/archive.db";
    }
    check(file);
  }

 private:
  /// The program works until it is ended or the power fails; in `next` lies what is there afterwards.
  void live(const std::string& file, const std::string& next) {
    const auto captures_of = [](const std::string& archive) { return archive + ".captures"; };
    const std::string folder = files::path(file).parent_path().string();
    SimulatedDisk disk;
    SimulatedFiles written(disk, captures_of(file), chance_);
    const auto power_fails = [&] {
      disk.after_power_failure(folder, next, chance_);
      written.after_power_failure(captures_of(next + "/archive.db"));
    };
    const bool is_killed = chance_() % 4 == 0;
    plan_trouble(disk);
    {
      Life life(file);
      if (!life.began()) expect(disk.was_troubled(), "an archive cannot be opened: " + life.refused());
      if (life.began()) captures_.check(life, captures_of(file), &disk);
      const std::size_t wishes = 2 + chance_() % 10;
      for (std::size_t k = 0; k < wishes && life.began() && disk.has_power(); ++k) {
        move_clock_ms(chance_() % 20 == 0 ? -static_cast<int>(chance_() % 10'000'000)
                                          : static_cast<int>(chance_() % 100'000));
        if (chance_() % 6 == 0) plan_trouble(disk);
        disk.calm();
        if (chance_() % 4 == 0)
          captures_.wish(life, captures_of(file), disk);
        else
          wish(life, disk);
      }
      if (disk.has_power() && is_killed) return copy(folder, next);
      if (disk.has_power() && chance_() % 2 == 0) return power_fails();
    }
    power_fails();
  }

  /// Of a program that was killed all files are there; what it shared in its memory is not.
  static void copy(const std::string& folder, const std::string& next) {
    files::copy(folder, next, files::copy_options::recursive);
    files::remove(next + "/archive.db-shm");
  }

  void plan_trouble(SimulatedDisk& disk) {
    constexpr Trouble kinds[] = {Trouble::none, Trouble::power_fails, Trouble::power_fails,
                                 Trouble::full, Trouble::write_fails, Trouble::read_fails};
    disk.plan_trouble(kinds[chance_() % std::size(kinds)], chance_() % 120);
  }

  /// One thing that a client asks for. The request may be lost on its way, or the answer.
  void wish(Life& life, const SimulatedDisk& disk) {
    if (chance_() % 12 == 0) return;  // the request is lost
    const bool answered = chance_() % 10 != 0;
    const auto one_in = [&](unsigned n) { return chance_() % n == 0; };
    if (promised_.tests.empty() || one_in(3)) return upload(life, disk, answered);
    auto test = promised_.tests.begin();
    std::advance(test, chance_() % promised_.tests.size());
    if (one_in(3)) return attach(life, disk, answered, test->first);
    if (one_in(5)) return add_machine(life, disk, answered);
    revise(life, disk, answered, test->first, test->second);
  }

  /// Whether it was done. What failed must have had a reason.
  static bool done(const server::Response& response, const SimulatedDisk& disk) {
    if (response.status < 400) return true;
    expect(disk.was_troubled(), fmt::format("status {} without trouble: {}", response.status, response.body));
    expect(response.status >= 500,
           fmt::format("status {} for trouble of the disk: {}", response.status, response.body));
    return false;
  }

  void upload(Life& life, const SimulatedDisk& disk, bool answered) {
    const std::string bytes = readings(chance_);
    const server::Response response = life.ask("POST", "/api/tests", bytes);
    if (!answered || !done(response, disk)) {
      ++promised_.doubtful_tests;
      return;
    }
    const json::Value test = parsed(response);
    Promised::Test& kept = promised_.tests[number_of(test, "id")];
    expect(kept.latest == 0, "two tests have one number");
    kept.bytes = bytes;
    kept.latest = number_of(test, "version");
    kept.versions[kept.latest] = version_of(test);
  }

  void revise(Life& life, const SimulatedDisk& disk, bool answered, int id, Promised::Test& kept) {
    const server::Response response = life.ask(
        "POST", fmt::format("/api/tests/{}/versions", id),
        fmt::format(R"({{"base_version": {}, "title": "T {}", "reason": "r", "changes": {{"tolerance.A": "{}"}}}})",
                    kept.latest, chance_(), 1 + chance_() % 20));
    if (response.status == 409) return expect(kept.in_doubt, "a conflict with nobody: " + response.body);
    if (answered && response.status >= 500 && response.body.contains("the change was kept")) {
      ++kept.latest;
      return;
    }
    if (!answered || !done(response, disk)) {
      kept.in_doubt = true;
      return;
    }
    const json::Value test = parsed(response);
    expect(number_of(test, "version") == kept.latest + 1, "a version has the number of another one");
    ++kept.latest;
    kept.versions[kept.latest] = version_of(test);
  }

  void attach(Life& life, const SimulatedDisk& disk, bool answered, int id) {
    std::string bytes(chance_() % 20'000, static_cast<char>('a' + chance_() % 26));
    const server::Response response = life.ask("POST", fmt::format("/api/tests/{}/attachments", id), bytes);
    if (bytes.empty() && response.status == 422) return;
    if (answered && done(response, disk)) promised_.documents[number_of(parsed(response), "id")] = std::move(bytes);
  }

  void add_machine(Life& life, const SimulatedDisk& disk, bool answered) {
    const std::string name = fmt::format("Machine {}", chance_());
    const server::Response response =
        life.ask("POST", "/api/machines", fmt::format(R"({{"name": "{}", "reason": "new"}})", name));
    if (answered && done(response, disk)) promised_.machines.push_back(name);
  }

  /// All that must be true of the archive, on a disk in good order.
  void check(const std::string& file) {
    Life life(file);
    expect(life.began(), "an archive cannot be opened: " + life.refused());
    captures_.conclude_all(life, file + ".captures");
    const auto verified = life.store().verify();
    expect(verified.has_value(), "an archive cannot be verified");
    if (!verified->problems.empty()) broken("verify: " + verified->problems.front());
    for (const auto& [id, test] : promised_.tests) check(life, id, test);
    for (const auto& [id, bytes] : promised_.documents)
      expect(life.ask("GET", fmt::format("/api/documents/{}", id)).body == bytes, "a document is not as it was");
    const std::string machines = life.ask("GET", "/api/machines").body;
    for (const std::string& name : promised_.machines)
      expect(machines.find(name) != std::string::npos, "an acknowledged machine is not there");
    const auto total = static_cast<std::size_t>(number_of(parsed(life.ask("GET", "/api/tests")), "total"));
    expect(total >= promised_.tests.size() &&
               total <= promised_.tests.size() + promised_.doubtful_tests + captures_.count(),
           "there are tests that nobody sent");
  }

  static void check(Life& life, int id, const Promised::Test& test) {
    const std::string path = fmt::format("/api/tests/{}", id);
    const server::Response raw = life.ask("GET", path + "/raw");
    if (raw.status != 200) broken(fmt::format("status {} for test {}: {}", raw.status, id, raw.body));
    expect(raw.body == test.bytes, "measured bytes are not as they were");
    for (const auto& [number, version] : test.versions) {
      const json::Value found = parsed(life.ask("GET", path, {}, {{"version", std::to_string(number)}}));
      expect(found.find("title") != nullptr, fmt::format("version {} of test {} is not there", number, id));
      const Promised::Version now = version_of(found);
      expect(now.title == version.title && now.shown == version.shown, "a version is not as it was acknowledged");
    }
    const json::Value latest = parsed(life.ask("GET", path));
    const int beyond = number_of(latest, "version") - test.latest;
    expect(beyond == 0 || (beyond > 0 && test.in_doubt), "there are versions that nobody sent");
    const std::string said = fmt::format(R"({{"changes": {}}})", json::dump(*latest.find("changes")));
    const json::Value again = parsed(life.ask("POST", path + "/evaluate", said));
    expect(json::dump(*again.find("shown")) == json::dump(*latest.find("shown")),
           "an evaluation made again is another");
  }

  Chance chance_;
  Folder folder_;
  Promised promised_;
  Captures captures_{chance_};
};

std::uint32_t seed_of(const char* text) {
  std::uint32_t seed = 0;
  const auto [end, code] = std::from_chars(text, text + std::strlen(text), seed);
  if (code != std::errc() || *end != '\0') broken(fmt::format("found {}, expected a whole number", text));
  return seed;
}

}  // namespace

int main(int count, char** words) try {
  if (count < 2 || count > 3) broken("usage: axiometry_world FIRST_SEED [COUNT]");
  const std::uint32_t first = seed_of(words[1]);
  const std::uint32_t seeds = count == 3 ? seed_of(words[2]) : 1;
  const Folder folder;
  const std::string made = folder.path() + "/made.db";
  expect(Life(made).began(), "no archive can be made");
  std::uint32_t failed = 0;
  std::size_t captures = 0, readings = 0;
  for (std::uint32_t k = 0; k < seeds; ++k) {
    World one(first + k);
    try {
      one.run(made);
    } catch (const std::exception& error) {
      ++failed;
      fmt::print("seed {}: {}\n", first + k, error.what());
    }
    captures += one.captures().count();
    readings += one.captures().readings();
  }
  fmt::print("{} worlds with {} captures and {} readings that people saw, {} of them broken\n", seeds, captures,
             readings, failed);
  return failed == 0 ? 0 : 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "axiometry_world: {}\n", error.what());
  return 2;
}
