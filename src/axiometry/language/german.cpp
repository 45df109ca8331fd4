// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/german.h"

#include <array>

namespace axiometry::language {

std::span<const std::span<const Phrase>> german_tables() {
  static const std::array tables{german_terms,
                                 german_report,
                                 german_figures,
                                 german_uncertainty,
                                 german_noise,
                                 german_temperatures,
                                 german_findings,
                                 german_scatter,
                                 german_claims,
                                 german_corrections,
                                 german_plan,
                                 german_fields,
                                 german_errors,
                                 german_service,
                                 german_simulation,
                                 german_tracking,
                                 german_tracking_findings,
                                 german_station,
                                 german_periodic,
                                 german_error_motions,
                                 german_rules,
                                 german_files,
                                 german_profile,
                                 german_requests,
                                 german_terminal,
                                 german_capture,
                                 german_tracking_requests,
                                 german_volumetric_findings,
                                 german_volume_recordings,
                                 german_length_captures,
                                 german_motion_captures,
                                 german_volume_report,
                                 german_volume_plan,
                                 german_calibrations,
                                 german_compensation,
                                 german_retests,
                                 german_known_positions,
                                 german_control_tables,
                                 german_controls,
                                 german_station_refusals,
                                 german_length_refusals,
                                 german_volume_files,
                                 german_volume_refusals,
                                 german_file_refusals,
                                 german_recording_refusals,
                                 german_plan_refusals,
                                 german_verb_refusals,
                                 german_archive_refusals,
                                 german_measurement_refusals};
  return tables;
}

}  // namespace axiometry::language
