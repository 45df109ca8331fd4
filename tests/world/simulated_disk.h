// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// A disk that loses its power: what SQLite writes goes to files, and beside it is remembered
/// what would be on the plate if the power failed now. What was written since the last sync of a file may then be
/// there, be missing, or be there in part, in any order.
namespace axiometry::world {

enum class Trouble {
  none,
  power_fails,  ///< from here on nothing can be read or written
  full,         ///< for a while nothing can be written: SQLITE_FULL
  write_fails,  ///< one write or sync is refused: SQLITE_IOERR
  read_fails,   ///< one read is refused
};

class SimulatedDisk {
 public:
  /// Becomes SQLite's way to files until it goes. One at a time.
  SimulatedDisk();
  ~SimulatedDisk();
  SimulatedDisk(const SimulatedDisk&) = delete;
  SimulatedDisk& operator=(const SimulatedDisk&) = delete;

  /// After so many writes, syncs and removals from now.
  void plan_trouble(Trouble trouble, std::size_t after);
  bool has_power() const { return power_; }
  bool was_troubled() const { return troubled_; }  ///< since calm()
  void calm();                                     ///< what is over is forgotten; what lasts is not

  /// Every file of a folder as it is found when the power comes back, into another one. `chance` decides what became of
  /// what was not synced.
  void after_power_failure(const std::string& folder, const std::string& into, std::minstd_rand& chance);

  // What the file system of SQLite below calls.
  struct Write {
    std::int64_t at = 0;
    std::string bytes;
  };
  struct Truncation {
    std::int64_t size = 0;
  };
  using Change = std::variant<Write, Truncation>;
  struct Plate {
    bool exists = false;  ///< since a sync
    std::string bytes{};  ///< as of the last sync
    std::vector<Change> unsynced{};
  };
  int before_change();  ///< an error of SQLite, or SQLITE_OK
  int before_read();
  std::shared_ptr<Plate> plate_of(const std::string& path);
  void removed(const std::string& path, bool synced);
  void synced() { removed_unsynced_.clear(); }  ///< file systems keep the order of what happens to names

 private:
  std::map<std::string, std::shared_ptr<Plate>> plates_;
  std::map<std::string, std::shared_ptr<Plate>> removed_unsynced_;
  bool power_ = true;
  bool troubled_ = false;
  Trouble trouble_ = Trouble::none;
  std::size_t changes_until_trouble_ = 0;
  std::size_t full_for_ = 0;  // changes
};

/// All changes of a file reach the plate.
void sync_plate(SimulatedDisk::Plate& plate);
/// The bytes of a file as they are when the power comes back: of changes that were not synced each is there, or not, or
/// of a write some sectors are; in any order.
void settle(std::string& bytes, std::vector<SimulatedDisk::Change> changes, std::minstd_rand& chance);

}  // namespace axiometry::world
