// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/volumetric/field/unseen_reasons.h"
#include "axiometry/volumetric/identify/findings/mixed_days.h"
#include "axiometry/volumetric/identify/findings/one_sided_places.h"
#include "axiometry/volumetric/identify/findings/residual_causes.h"
#include "axiometry/volumetric/identify/findings/reversal_causes.h"
#include "axiometry/volumetric/identify/findings/tried_fit.h"
#include "axiometry/volumetric/machine/error_motion.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr double aside_share_most = 0.02;
constexpr double chance_least = 1e-3;
constexpr double ratio_serious = 4.0;
constexpr double scales_certain = 0.01;                 // chance above which parts may differ, and no part is named
constexpr double spread_serious_um_per_m = 10.0;        // as of an axis of steel by 1 °C
constexpr double decided_u_ratio = 1.4142135623730951;  // √2: smoothness then gives half of the information on a curve

std::string place_text(const VolumetricLengths& lengths, std::size_t i) {
  const std::size_t line = lengths.readings[i].line;
  return line > 0 ? fmt::format("line {}", line) : fmt::format("reading {}", i + 1);
}

std::string reading_text(const VolumetricLengths& lengths, std::size_t i) {
  const VolumetricReading& r = lengths.readings[i];
  return fmt::format("{} of station {} with tool {}", place_text(lengths, i), text::quoted(lengths.stations[r.station]),
                     text::quoted(lengths.tools[r.tool]));
}

void add_unseen(const MachineModel& machine, const VolumetricLengths& lengths, const Identification& result,
                std::vector<VolumetricFinding>& findings) {
  SetupShape setup;
  for (const std::string& name : lengths.tools)
    if (const auto tool = machine.tool_named(name)) setup.tools_mm.push_back(machine.tools[*tool].offset_mm);
  if (const auto lever = short_lever(setup.tools_mm)) findings.push_back({"volumetric-short-lever", true, *lever});
  const std::vector<std::size_t> unseen = result.model.unseen_errors();
  if (unseen.empty()) return;
  std::vector<bool> seen(lengths.stations.size(), false);
  for (const IdentifiedStation& station : result.stations) {
    if (!seen[station.station]) setup.stations_mm.push_back(station.at_mm);
    seen[station.station] = true;
  }
  std::string reasons;
  for (const std::string& reason : unseen_reasons(setup)) reasons += "; " + reason;
  findings.push_back({"volumetric-unseen-errors", true,
                      fmt::format("the lengths do not tell {}{}: no number is given for {}", error_list(unseen),
                                  reasons, unseen.size() == 1 ? "it" : "them")});
}

void add_scatter(const Identification& result, std::vector<VolumetricFinding>& findings) {
  if (result.degrees_of_freedom == 0) return;
  const double nu = static_cast<double>(result.degrees_of_freedom), ratio = result.chi_squared_per_dof();
  const double above = 1.0 - numeric::chi_square_probability(result.chi_squared, nu);
  if (ratio > 1.0 && above < chance_least) {
    findings.push_back(
        {"volumetric-scatter", ratio > ratio_serious,
         fmt::format("the residuals are {:.2f} times as large as the uncertainties of instrument and machine allow "
                     "(χ²/ν = {:.2f}): either these are stated too small, or the machine does something that 21 errors "
                     "of its axes do not describe, as drift, play or bending under load, or its chain is another "
                     "one{}; all uncertainties were multiplied by {:.2f}",
                     std::sqrt(ratio), ratio,
                     result.smoothed ? ", or its curves bend farther than they were taken to" : "", std::sqrt(ratio))});
    return;
  }
  if (ratio < 0.5)
    findings.push_back({"volumetric-scatter-small", false,
                        fmt::format("the residuals are {:.2f} times what the uncertainties of instrument and machine "
                                    "let one expect: these are stated too large, and so are all uncertainties",
                                    std::sqrt(ratio))});
}

void add_part_scales(const Identifier& done, const VolumetricLengths& lengths, const Identification& result,
                     std::vector<VolumetricFinding>& findings) {
  if (done.looks_for_part_scales() && result.stations.size() > parts_most)
    findings.push_back({"volumetric-part-scales", false,
                        fmt::format("whether the axes differ in length from part to part, a station with a tool each, "
                                    "was not looked for: found {} parts, expected at most {}",
                                    result.stations.size(), parts_most)});
  if (!result.part_scales) return;
  const PartScales& scales = *result.part_scales;
  if (!scales.held) {
    findings.push_back({"volumetric-part-scales", scales.chance < chance_least,
                        fmt::format("the axes seem longer at one part, a station with a tool, than at another ({}), as "
                                    "where machine or air became warmer or colder between them: so few parts do not "
                                    "tell by how much, and uncertainties, of squareness too, do not hold it",
                                    format_chance(scales.chance))});
    return;
  }
  const std::string by = format_significant(scales.spread_um_per_m, 2), chance = format_chance(scales.chance);
  if (scales.chance > scales_certain) {
    findings.push_back(
        {"volumetric-part-scales", false,
         fmt::format(
             "the axes may differ in length from part to part, a station with a tool each, by {} µm/m (standard "
             "deviation, {}), as where machine or air become warmer or colder between them: what the lengths "
             "show of it was taken out, and is in the uncertainties",
             by, chance)});
    return;
  }
  const auto size = [](const IdentifiedStation& s) { return std::abs(s.scale_um_per_m.value_or(0.0)); };
  const IdentifiedStation& farthest = *std::ranges::max_element(result.stations, {}, size);
  const char* cause =
      result.chi_squared_per_dof() > ratio_serious ? ", or where the lengths show what 21 errors do not describe" : "";
  findings.push_back(
      {"volumetric-part-scales", scales.spread_um_per_m > spread_serious_um_per_m,
       fmt::format("the axes differ in length from part to part, a station with a tool each, by {} µm/m (standard "
                   "deviation, {}), as where machine or air become warmer or colder between them{}; at station {} with "
                   "tool {} they seem {} µm/m {} than on average (u = {} µm/m): what the lengths show of it was taken "
                   "out, and is in the uncertainties",
                   by, chance, cause, text::quoted(lengths.stations[farthest.station]),
                   text::quoted(lengths.tools[farthest.tool]), format_significant(size(farthest), 2),
                   farthest.scale_um_per_m > 0.0 ? "longer" : "shorter",
                   format_significant(farthest.scale_u_um_per_m.value_or(0.0), 2))});
}

void add_set_aside(const VolumetricLengths& lengths, const Identification& result,
                   std::vector<VolumetricFinding>& findings) {
  std::vector<SetAside> outliers;
  for (const SetAside& s : result.set_aside)
    if (s.reason == SetAside::Reason::outlier) outliers.push_back(s);
  if (outliers.empty()) return;
  const SetAside worst =
      *std::ranges::max_element(outliers, {}, [](const SetAside& s) { return std::abs(s.residual_um); });
  const double share = static_cast<double>(outliers.size()) / static_cast<double>(lengths.readings.size());
  findings.push_back(
      {"volumetric-set-aside", share > aside_share_most,
       fmt::format(
           "{} of {} lengths lie farther from what the others predict than chance allows, and {} set aside; the "
           "farthest is {}, by {} µm",
           outliers.size(), lengths.readings.size(), outliers.size() == 1 ? "was" : "were",
           reading_text(lengths, worst.reading), format_fixed(worst.residual_um, 1))});
}

/// The last reading that was certainly measured before the break, and what lies between: those of its station, tool and
/// segment, which need not follow each other.
struct InDoubt {
  std::size_t last_before = 0;
  std::size_t count = 0;
};
InDoubt in_doubt(const Identifier& done, const VolumetricLengths& lengths, const FoundBreak& found) {
  InDoubt doubt;
  const VolumetricReading& own = lengths.readings[found.before_reading];
  for (std::size_t i = 0; i < found.latest_reading; ++i) {
    const VolumetricReading& r = lengths.readings[i];
    if (r.station != own.station || r.tool != own.tool || r.segment != own.segment || done.is_copy(i)) continue;
    if (i < found.earliest_reading)
      doubt.last_before = i;
    else
      ++doubt.count;
  }
  return doubt;
}

std::string break_text(const Identifier& done, const VolumetricLengths& lengths, const FoundBreak& found) {
  if (found.is_certain())
    return fmt::format(
        "before {} all lengths jump by {} µm: the beam was broken, and the lengths from there on "
        "have a dead path of their own",
        reading_text(lengths, found.before_reading), format_fixed(found.jump_um, 1));
  const InDoubt doubt = in_doubt(done, lengths, found);
  return fmt::format(
      "between {} and {} all lengths jump by {} µm: the beam was broken, and the lengths from there "
      "on have a dead path of their own; on which side of the break the {} between {} measured cannot "
      "be told, and {} left out",
      place_text(lengths, doubt.last_before), reading_text(lengths, found.latest_reading),
      format_fixed(found.jump_um, 1), doubt.count == 1 ? "one length" : fmt::format("{} lengths", doubt.count),
      doubt.count == 1 ? "was" : "were", doubt.count == 1 ? "it is" : "they are");
}

void add_breaks(const Identifier& done, const VolumetricLengths& lengths, const Identification& result,
                std::vector<VolumetricFinding>& findings) {
  for (const FoundBreak& found : result.breaks)
    findings.push_back({"volumetric-beam-broken", false, break_text(done, lengths, found)});
}

void add_drift(const Identification& result, std::vector<VolumetricFinding>& findings) {
  if (!result.drift) return;
  double most = 0.0;
  for (const IdentifiedStretch& s : result.stretches) most = std::max(most, std::abs(s.drift_um.value_or(0.0)));
  findings.push_back(
      {"volumetric-drift", false,
       fmt::format("dead paths drift with time, by up to {:.2f} µm between breaks of the beam; a straight "
                   "drift of each was taken out",
                   most)});
}

void add_domain(const Identifier& done, const MachineModel& machine, std::vector<VolumetricFinding>& findings) {
  for (std::size_t a = 0; a < axis_count; ++a) {
    const CurveDomain& domain = done.domains()[a];
    if (domain.is_travel) continue;
    findings.push_back(
        {"volumetric-travel-not-covered", false,
         fmt::format("readings of {} reach from {} to {} mm of a travel from {} to {} mm: curves are stated where "
                     "readings are, and nothing is said of the rest",
                     "XYZ"[a], format_exact(done.observed().lowest_mm[a]), format_exact(done.observed().highest_mm[a]),
                     format_exact(machine.travel.lowest_mm[a]), format_exact(machine.travel.highest_mm[a]))});
  }
}

void add_places(const Identifier& done, const VolumetricLengths& lengths, std::vector<VolumetricFinding>& findings) {
  for (std::size_t a = 0; a < axis_count; ++a) {
    std::vector<double> positions;
    for (const VolumetricReading& reading : lengths.readings) positions.push_back(reading.axes_mm[a]);
    const std::size_t enough = places_for_function * done.coefficients().basis(a).functions();
    const std::size_t places = different_places(std::move(positions), enough);
    if (places == enough) continue;
    findings.push_back({"volumetric-few-places", true,
                        fmt::format("{} was read at {} places only: its curves go through what was read there, nothing "
                                    "shows what they are between, and no uncertainty holds it",
                                    "XYZ"[a], places)});
  }
}

void add_copies(const Identifier& done, std::vector<VolumetricFinding>& findings) {
  const std::size_t copies = done.copies();
  if (copies == 0) return;
  findings.push_back({"volumetric-copies", false,
                      fmt::format("{} row{} of earlier ones in every cell, and count{} once", copies,
                                  copies == 1 ? " is a copy" : "s are copies", copies == 1 ? "s" : "")});
}

/// Axes that do not move at all at some station with a tool, "X, Z".
std::string axes_at_rest(const Identifier& done, const VolumetricLengths& lengths) {
  std::array<bool, axis_count> rests{};
  const std::vector<Approaches>& approaches = done.approaches();
  for (std::size_t i = 0; i < approaches.size(); ++i) {
    const VolumetricReading& reading = lengths.readings[i];
    if (i + 1 < approaches.size() && lengths.readings[i + 1].station == reading.station &&
        lengths.readings[i + 1].tool == reading.tool)
      continue;
    for (std::size_t a = 0; a < axis_count; ++a) rests[a] = rests[a] || approaches[i][a] == 0.0;
  }
  std::string names;
  for (std::size_t a = 0; a < axis_count; ++a)
    if (rests[a]) names += fmt::format("{}{}", names.empty() ? "" : ", ", "XYZ"[a]);
  return names;
}

void add_unknown_directions(const Identifier& done, const VolumetricLengths& lengths,
                            std::vector<VolumetricFinding>& findings) {
  std::size_t left_out = 0, meant = 0;
  for (std::size_t i = 0; i < done.approaches().size(); ++i)
    if (!done.is_copy(i) && has_unknown_direction(done.approaches()[i]))
      ++(done.is_of_unknown_direction(i) ? left_out : meant);
  if (left_out > 0)
    findings.push_back(
        {"volumetric-unknown-directions", false,
         fmt::format("nothing tells in which direction axes had come to rest at {} length{} before their "
                     "first move at a station with a tool: {} left out",
                     left_out, left_out == 1 ? "" : "s", left_out == 1 ? "it is" : "they are")});
  if (meant == 0) return;
  const std::string at_rest = axes_at_rest(done, lengths);
  findings.push_back({"volumetric-unknown-directions", false,
                      fmt::format("nothing tells in which direction axes had come to rest at {} length{} before their "
                                  "first move at a station with a tool{}: {} as of the mean of both",
                                  meant, meant == 1 ? "" : "s",
                                  at_rest.empty() ? "" : fmt::format(", or where {} did not move at all", at_rest),
                                  meant == 1 ? "it counts" : "they count")});
}

std::string smoothness_text(const Smoothness& asked, double found, std::string_view of, std::string_view unit) {
  const bool stated = asked.kind == Smoothness::Kind::stated;
  const std::string change = stated         ? format_exact(found)
                             : found < 10.0 ? fmt::format("{:.2f}", found)
                                            : fmt::format("{:.1f}", found);
  return fmt::format("slopes of {} change by {}{} {} from one end of an axis to the other (standard deviation)", of,
                     stated || found > Smoothness::least ? "" : "no more than ", change, unit);
}

std::string smoothness_text(const Smoothness& asked, const SmoothedCurves& smoothed) {
  const auto is_displacement = [](const SmoothedError& s) { return s.error % motion_count < first_rotation; };
  const auto displacements = std::ranges::count_if(smoothed.errors, is_displacement);
  std::string text;
  if (displacements > 0) text = smoothness_text(asked, smoothed.displacement_um, "displacements", "µm");
  if (displacements < std::ssize(smoothed.errors))
    text += (text.empty() ? "" : "; ") + smoothness_text(asked, smoothed.rotation_urad, "rotations", "µrad");
  return text;
}

/// The farthest drawn displacement, or rotation.
void add_bias(const SmoothedCurves& smoothed, bool of_rotations, std::vector<VolumetricFinding>& findings) {
  const SmoothedError* farthest = nullptr;
  for (const SmoothedError& s : smoothed.errors)
    if ((s.error % motion_count >= first_rotation) == of_rotations && (farthest == nullptr || s.bias > farthest->bias))
      farthest = &s;
  if (farthest == nullptr) return;
  findings.push_back({"volumetric-smoothness-bias", false,
                      fmt::format("of {} the smoothness draws {} the farthest towards a straight line, by about {:.2f} "
                                  "{}; uncertainties hold this only as far as the smoothness holds",
                                  of_rotations ? "rotations" : "displacements", error_names()[farthest->error],
                                  farthest->bias, of_rotations ? "µrad" : "µm")});
}

/// What was taken for known of the curves, what rests on it, and what speaks against it.
void add_smoothness(const Identifier& done, const Identification& result, std::vector<VolumetricFinding>& findings) {
  if (!result.smoothed) return;
  const Smoothness& asked = done.smoothness();
  if (result.smoothed->errors.empty()) {
    findings.push_back(
        {"volumetric-smoothness-idle", false, "no curve is told that could be smooth: the smoothness changes nothing"});
    return;
  }
  const SmoothedCurves& smoothed = *result.smoothed;
  const char* how = asked.kind == Smoothness::Kind::stated ? "as was stated" : "as the lengths of all let it appear";
  findings.push_back({"volumetric-smoothness", false,
                      fmt::format("curves are taken to be smooth, {}: {}", how, smoothness_text(asked, smoothed))});
  if (!done.bends_settled())
    findings.push_back({"volumetric-smoothness-unsettled", true,
                        "how smooth the curves are was still changing when the search for it ended: curves and their "
                        "uncertainties may depend on where it ended, and another smoothness may be stated"});
  std::vector<std::size_t> decided, contradicted;
  double ratio = 1.0, bend = 1.0;
  for (const SmoothedError& s : smoothed.errors) {
    if (s.u_ratio > decided_u_ratio) {
      decided.push_back(s.error);
      ratio = std::max(ratio, s.u_ratio);
    }
    if (s.bend_ratio > 1.0 && s.chance < chance_least / static_cast<double>(smoothed.errors.size())) {
      contradicted.push_back(s.error);
      bend = std::max(bend, s.bend_ratio);
    }
  }
  if (!decided.empty())
    findings.push_back({"volumetric-smoothness-decides", false,
                        fmt::format("more is told of {} by the smoothness than by the lengths: by the lengths alone "
                                    "uncertainties would be up to {:.1f} times as large",
                                    error_list(decided), ratio)});
  if (contradicted.empty()) {  // the bend of a curve that was flattened too far understates the bias
    add_bias(smoothed, false, findings);
    add_bias(smoothed, true, findings);
  } else {
    findings.push_back({"volumetric-smoothness-contradicted", true,
                        fmt::format("the lengths show that {} bend{} farther than the smoothness allows, up to {:.1f} "
                                    "times as far: uncertainties may not hold the truth",
                                    error_list(contradicted), contradicted.size() == 1 ? "s" : "", bend)});
  }
}

void add_scale(const MachineModel& machine, const Identification& result, std::vector<VolumetricFinding>& findings) {
  if (machine.scale_uncertainty) return;
  findings.push_back(
      {"volumetric-scale-uncertainty", false,
       fmt::format("nothing is said of an error that all lengths have in common, as of the wavelength in air or the "
                   "temperature of the machine: it would appear in the slopes of EXX, EYY and EZZ, whose uncertainties "
                   "{} (instrument.scale_u_um_per_m in the machine's file)",
                   result.part_scales && result.part_scales->held ? "hold no more of it than that of parts that differ"
                                                                  : "do not hold it")});
}

}  // namespace

std::vector<VolumetricFinding> findings_of(const Identifier& done, const MachineModel& machine,
                                           const VolumetricLengths& lengths, const Identification& result) {
  std::vector<VolumetricFinding> findings;
  add_unseen(machine, lengths, result, findings);
  add_setup_findings(done, machine, lengths, result, findings);
  add_scatter(result, findings);
  add_part_scales(done, lengths, result, findings);
  const bool in_rows = is_in_rows(lengths.readings);
  add_residual_causes(done, machine, lengths, in_rows, findings);
  if (!in_rows) {
    add_mixed_days(done, findings);
    add_reversal_beyond_chance(done, lengths, findings);
  }
  add_set_aside(lengths, result, findings);
  add_breaks(done, lengths, result, findings);
  add_drift(result, findings);
  add_domain(done, machine, findings);
  add_places(done, lengths, findings);
  add_copies(done, findings);
  add_unknown_directions(done, lengths, findings);
  add_one_sided_places(done, lengths, findings);
  add_smoothness(done, result, findings);
  add_scale(machine, result, findings);
  std::ranges::stable_partition(findings, [](const VolumetricFinding& f) { return f.serious; });
  return findings;
}

}  // namespace axiometry::volumetric::detail
