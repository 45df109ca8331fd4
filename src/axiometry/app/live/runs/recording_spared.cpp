// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/recording_spared.h"

#include <filesystem>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/live/disk/stop_marks.h"
#include "axiometry/app/recordings/raw_times.h"
#include "axiometry/app/results/outputs.h"

namespace axiometry::app {

Result<void> check_recording_spared(const CaptureRun& run, const std::string& plan) {
  if (!run.resume.empty()) AXIOMETRY_TRY_VOID(InputFiles(std::vector<InputFile>{{plan}}).check_spared(run.resume));
  AXIOMETRY_TRY_VOID(InputFiles(std::vector<InputFile>{{plan}, {run.from}}).check_standard_input());
  if (run.out.empty() || run.out == "-") return {};
  std::vector<InputFile> inputs{{plan}, {run.from}, {times_name(run.from)}};
  if (!run.keys.empty()) inputs.push_back({run.keys});
  for (const std::string& played : {run.from, run.resume})
    if (is_raw(played)) inputs.push_back({marks_name(played)});
  if (!run.resume.empty()) inputs.insert(inputs.end(), {{run.resume}, {times_name(run.resume)}});
  AXIOMETRY_TRY_VOID(InputFiles(inputs).check_spared(run.out));
  AXIOMETRY_TRY_VOID(check_writable(run.out));
  const auto whole = [](const std::string& name) {
    std::error_code unknown;
    const auto path = std::filesystem::weakly_canonical(std::filesystem::absolute(name, unknown), unknown);
    return unknown ? std::filesystem::path(name) : path;
  };
  const auto is_out = [&](const std::string& name) { return whole(run.out) == whole(name); };
  if (run.raw.empty() || !(is_out(run.raw) || is_out(times_name(run.raw)) || is_out(marks_name(run.raw)))) return {};
  return std::unexpected(Error{"found one file for the test and for what arrives, expected two", run.out, {}});
}

}  // namespace axiometry::app
