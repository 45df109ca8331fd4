// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/identify_lengths.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/report/volumetric.h"

namespace axiometry::app {
namespace {

/// 100 million readings of 40 bytes.
constexpr std::size_t lengths_most_bytes = std::size_t{4} << 30;

}  // namespace

Result<IdentifiedMachine> identify_lengths(const IdentifyRequest& request) {
  AXIOMETRY_TRY(const std::string machine, whole_file(request.machine));
  AXIOMETRY_TRY(const std::string lengths, file_bytes(request.lengths, lengths_most_bytes));
  return identify_lengths({request.lengths, lengths}, {request.machine, machine}, request.options);
}

Result<IdentifiedMachine> identify_lengths(const GivenFile& lengths_file, const GivenFile& machine_file,
                                           const volumetric::IdentifyOptions& options) {
  AXIOMETRY_TRY(formats::MachineFile machine, in_file(formats::read_machine(machine_file.bytes), machine_file.name));
  AXIOMETRY_TRY(volumetric::VolumetricLengths lengths,
                in_file(formats::read_volumetric_lengths(lengths_file.bytes), lengths_file.name));
  AXIOMETRY_TRY(volumetric::Identification identification,
                in_file(volumetric::identify(machine.machine, lengths, options), lengths_file.name));
  const auto tell = [&](std::vector<std::string>& remarks) {
    for (std::string& remark : remarks)
      identification.findings.push_back({"volumetric-passed-over", false, std::move(remark)});
  };
  tell(machine.remarks);
  tell(lengths.remarks);
  return IdentifiedMachine{{lengths_file.name, machine_file.name, options},
                           sha256(lengths_file.bytes),
                           sha256(machine_file.bytes),
                           std::move(machine.machine),
                           std::move(lengths),
                           std::move(identification)};
}

Experiment present(const IdentifiedMachine& identified, const report::Options& options) {
  const report::VolumetricSubject subject{identified.machine,        identified.lengths,
                                          identified.identification, base_name(identified.request.lengths),
                                          identified.lengths_sha256, base_name(identified.request.machine),
                                          identified.machine_sha256};
  return {report::compose(subject, options), to_json(identified)};
}

std::string residuals_csv(const IdentifiedMachine& identified) {
  const volumetric::VolumetricLengths& lengths = identified.lengths;
  std::vector<bool> aside(lengths.readings.size(), false);
  for (const volumetric::SetAside& s : identified.identification.set_aside) aside[s.reading] = true;
  std::string text = "station,tool,segment,x_mm,y_mm,z_mm,length_mm,residual_um,sigma_um,set_aside\n";
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
