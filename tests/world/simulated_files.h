// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "simulated_disk.h"

/// The files that the program writes itself, on the simulated disk: the calls of the system that change one are linked
/// to functions of this program (CMakeLists.txt), which do what they are asked to, and remember what of it would be on
/// the plate. As strict as POSIX: a synced file may have lost its name, and a name its bytes, until each is synced.
namespace axiometry::world {

class SimulatedFiles {
 public:
  /// Those in this folder, and the names in it, until it goes. What is there is on the plate. One at a time.
  SimulatedFiles(SimulatedDisk& disk, const std::string& folder, std::minstd_rand& chance);
  ~SimulatedFiles();
  SimulatedFiles(const SimulatedFiles&) = delete;
  SimulatedFiles& operator=(const SimulatedFiles&) = delete;

  /// What is found when the power comes back, into another folder.
  void after_power_failure(const std::string& into);

  // What the linked calls ask for. Each answers 0, or the error of the system.
  bool has(const std::string& path) const;
  int before_change() const;
  bool is_cut_short() { return chance_() % 8 == 0; }  ///< as write(2) may be at any time
  void opened(int descriptor, const std::string& path, bool truncated);
  void opened_folder(int descriptor) { folders_.insert(descriptor); }
  void written(int descriptor, std::int64_t at, std::string_view bytes);
  void truncated(int descriptor, std::int64_t size);
  void synced(int descriptor);
  bool knows(int descriptor) const { return files_.contains(descriptor) || folders_.contains(descriptor); }
  void closed(int descriptor);
  void renamed(const std::string& from, const std::string& to);
  void linked(const std::string& from, const std::string& to);
  void removed(const std::string& path);
  bool is_folder(const std::string& path) const { return path == folder_; }

 private:
  using File = std::shared_ptr<SimulatedDisk::Plate>;
  using Names = std::map<std::string, File>;
  struct Renaming {
    std::string path;
    File file;  // null: the name goes
  };
  void change_names(std::vector<Renaming> change);
  static void make(Names& names, const std::vector<Renaming>& change);

  SimulatedDisk& disk_;
  std::string folder_;
  std::minstd_rand& chance_;
  Names names_, on_plate_;
  std::vector<std::vector<Renaming>> unsynced_;  // each is there as a whole or not at all, none without those before it
  std::map<int, File> files_;
  std::set<int> folders_;
};

}  // namespace axiometry::world
