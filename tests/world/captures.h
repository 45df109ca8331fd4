// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/live/disk/capture_folder.h"
#include "axiometry/app/live/service/capture_service.h"
#include "expect.h"
#include "life.h"
#include "simulated_disk.h"

namespace axiometry::world {

/// Captures of one archive through all lives of the program: begun, cut off, gone on with, concluded, kept. Their
/// sources fall silent, break off and come back.
class Captures {
 public:
  explicit Captures(Chance& chance) : chance_(chance) {}

  /// Begins one, goes on with one or concludes one, until it ends or the program does.
  void wish(Life& life, const std::string& folder, const SimulatedDisk& disk);

  /// What was acknowledged is there, in the folder or in the archive, and gives the same when it is played again.
  /// `disk`: which may be in trouble; nullptr for one in good order.
  void check(Life& life, const std::string& folder, const SimulatedDisk* disk);
  /// The same, and what is left becomes tests.
  void conclude_all(Life& life, const std::string& folder);

  std::size_t count() const { return captures_.size(); }  ///< each is one test at most
  std::size_t readings() const;                           ///< that people saw

 private:
  using Readings = std::vector<capture::CapturedReading>;
  struct Capture {
    std::string layout;
    std::uint64_t seed = 0;
    std::size_t sent = 0;  ///< of the lines of its source
    Readings told;         ///< readings that people saw
    std::optional<store::Id> test{};
    std::string raw{};  ///< what the archive acknowledged of its recording
    bool kept = false;  ///< acknowledged by the archive
  };

  std::optional<store::Id> plan(Life& life, const SimulatedDisk& disk);
  void begin(Life& life, const std::string& folder, const SimulatedDisk& disk);
  void run(Life& life, app::HeldCapture held, Capture& capture, bool resumes, const SimulatedDisk& disk);
  void keep(Life& life, app::HeldCapture& held, Capture& capture, std::optional<Test> test, const SimulatedDisk* disk);
  static void note_kept(Capture& capture, std::optional<store::Id> test, const std::string& raw);
  static void check_kept(Life& life, const Capture& capture, const SimulatedDisk* disk);
  static std::optional<Readings> played(const app::CaptureOrder& order, const std::string& raw,
                                        const std::string& layout);

  Chance& chance_;
  std::optional<store::Id> plan_;
  std::map<store::Id, Capture> captures_;
};

}  // namespace axiometry::world
