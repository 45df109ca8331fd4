// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/identify_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "axiometry/report/volumetric.h"

namespace axiometry::app {
namespace {

struct KnownMachine {
  volumetric::MachineModel machine;
  std::string sha256;  ///< of the file in which it stands
  std::optional<volumetric::CalibrationPlan> plan;
  std::string plan_sha256;
  std::vector<std::string> remarks;
};

/// The machine of its own file counts before that of the plan.
Result<KnownMachine> known_machine(const std::optional<GivenFile>& own, const std::optional<GivenFile>& plan_file) {
  if (!own && !plan_file) return fail("found neither a machine nor a plan, expected one of them");
  std::optional<volumetric::CalibrationPlan> plan;
  std::string plan_sha256;
  if (plan_file) {
    AXIOMETRY_TRY(plan, in_file(formats::read_volumetric_plan(plan_file->bytes), plan_file->name));
    plan_sha256 = sha256(plan_file->bytes);
  }
  if (!own) {
    volumetric::MachineModel machine = plan->machine;
    return KnownMachine{std::move(machine), plan_sha256, std::move(plan), plan_sha256, {}};
  }
  AXIOMETRY_TRY(formats::MachineFile file, in_file(formats::read_machine(own->bytes), own->name));
  if (plan && json::dump(formats::machine_value(plan->machine)) != json::dump(formats::machine_value(file.machine)))
    file.remarks.push_back(fmt::format("the machine of {} is not in all that of {}: the former was used",
                                       text::quoted(base_name(own->name)), text::quoted(base_name(plan_file->name))));
  return KnownMachine{std::move(file.machine), sha256(own->bytes), std::move(plan), std::move(plan_sha256),
                      std::move(file.remarks)};
}

std::vector<report::VolumetricLengthsFile> report_files(const IdentifiedMachine& identified) {
  std::vector<report::VolumetricLengthsFile> files;
  for (const LengthsFile& f : identified.files)
    files.push_back({f.file, f.sha256, f.lengths,
                     f.layout.empty()                ? std::string()
                     : f.parts.first == f.parts.last ? fmt::format("{}", f.parts.first)
                                                     : fmt::format("{}–{}", f.parts.first, f.parts.last),
                     f.planned});
  return files;
}

Result<IdentifiedMachine> identified(IdentifyRequest request, KnownMachine known, GatheredLengths gathered) {
  auto found = volumetric::identify(known.machine, gathered.lengths, request.options);
  if (!found && request.lengths.files.size() == 1) found = in_file(std::move(found), request.lengths.files.front());
  AXIOMETRY_TRY(volumetric::Identification identification, std::move(found));
  for (std::string& remark : known.remarks)
    identification.findings.push_back({"volumetric-passed-over", false, std::move(remark)});
  std::ranges::move(gathered.findings, std::back_inserter(identification.findings));
  return IdentifiedMachine{std::move(request),           std::move(gathered.files), std::move(known.sha256),
                           std::move(known.plan_sha256), std::move(known.machine),  std::move(gathered.lengths),
                           std::move(identification)};
}

}  // namespace

Result<IdentifiedMachine> identify_lengths(const IdentifyRequest& request) {
  std::string machine_bytes, plan_bytes;
  std::optional<GivenFile> machine, plan;
  if (!request.plan.empty()) {
    AXIOMETRY_TRY(plan_bytes, whole_file(request.plan));
    plan = GivenFile{request.plan, plan_bytes};
  }
  if (!request.machine.empty()) {
    AXIOMETRY_TRY(machine_bytes, whole_file(request.machine));
    machine = GivenFile{request.machine, machine_bytes};
  }
  AXIOMETRY_TRY(KnownMachine known, known_machine(machine, plan));
  AXIOMETRY_TRY(GatheredLengths gathered, gather_lengths(request.lengths, known.plan ? &*known.plan : nullptr));
  return identified(request, std::move(known), std::move(gathered));
}

Result<IdentifiedMachine> identify_lengths(const IdentifyFiles& files, const IdentifyChoices& choices,
                                           const LengthsCheck& check) {
  AXIOMETRY_TRY(KnownMachine known, known_machine(files.machine, files.plan));
  IdentifyRequest request{.lengths = {.parts = choices.parts, .recording = choices.recording, .given = files.lengths},
                          .machine = files.machine ? files.machine->name : "",
                          .plan = files.plan ? files.plan->name : "",
                          .options = choices.model};
  request.options.stop = files.stop;
  for (const GivenFile& file : files.lengths) request.lengths.files.push_back(file.name);
  AXIOMETRY_TRY(GatheredLengths gathered, gather_lengths(request.lengths, known.plan ? &*known.plan : nullptr));
  request.lengths.given.clear();  // whose bytes nobody keeps for us
  AXIOMETRY_TRY_VOID(check(gathered.lengths));
  return identified(std::move(request), std::move(known), std::move(gathered));
}

Experiment present(const IdentifiedMachine& identified, const report::Options& options) {
  const std::vector<report::VolumetricLengthsFile> files = report_files(identified);
  const std::string plan = identified.request.plan.empty() ? "" : base_name(identified.request.plan);
  const report::VolumetricSubject subject{identified.machine,
                                          identified.lengths,
                                          identified.identification,
                                          files,
                                          base_name(identified.machine_file()),
                                          identified.machine_sha256,
                                          plan,
                                          identified.plan_sha256};
  return {report::compose(subject, options), to_json(identified)};
}

std::string gathered_table(const IdentifiedMachine& identified) {
  std::string text;
  for (const LengthsFile& f : identified.files)
    text += fmt::format("# {} (SHA-256 {}): {} lengths{}\n", f.file, f.sha256, f.lengths,
                        f.layout.empty() ? "" : fmt::format(" of {} stops, out of a continuous recording", f.planned));
  return text + formats::write_volumetric_lengths(identified.lengths);
}

std::string residuals_csv(const IdentifiedMachine& identified) {
  const volumetric::VolumetricLengths& lengths = identified.lengths;
  std::vector<bool> aside(lengths.readings.size(), false);
  for (const volumetric::SetAside& s : identified.identification.set_aside) aside[s.reading] = true;
  std::string text = fmt::format("{},residual_um,sigma_um,set_aside\n", formats::volumetric_lengths_head);
  for (std::size_t i = 0; i < lengths.readings.size(); ++i) {
    const volumetric::VolumetricReading& r = lengths.readings[i];
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{:.4f},{:.4f},{}\n",
                   text::csv_cell(text::no_formula(lengths.stations[r.station])),
                   text::csv_cell(text::no_formula(lengths.tools[r.tool])),
                   text::csv_cell(text::no_formula(lengths.segments[r.segment])), format_exact(r.axes_mm.x),
                   format_exact(r.axes_mm.y), format_exact(r.axes_mm.z), format_exact(r.length_mm),
                   identified.identification.residuals_um[i], identified.identification.sigmas_um[i],
                   aside[i] ? "yes" : "no");
  }
  return text;
}

}  // namespace axiometry::app
