// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/volumetric/identify/findings/findings.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr double offset_told_mm = 0.5;          // reflectors are mounted to within this
constexpr double offset_serious_mm = 5.0;       // with a rotation of 50 µrad a quarter of a micrometre
constexpr double place_told_mm = 50.0;          // where a station is said to stand is often read off a tape
constexpr double looks_like_inches_mm = 120.0;  // 3 m are 118 inches, and nobody calibrates a volume so small
constexpr double moved_statistic = 45.0;        // χ² of four unknowns: by chance once in 10⁸

/// Axes exchanged or turned round: what a file with mixed-up columns or signs does.
struct Mixing {
  std::array<std::size_t, 3> from{0, 1, 2};
  std::array<double, 3> sign{1.0, 1.0, 1.0};

  Vector3 operator()(Vector3 p) const { return {sign[0] * p[from[0]], sign[1] * p[from[1]], sign[2] * p[from[2]]}; }
  std::size_t changes() const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) count += (from[k] != k ? 2u : 0u) + (sign[k] < 0.0 ? 1u : 0u);
    return count;
  }
  std::string text() const {
    std::string turned, exchanged;
    for (std::size_t k = 0; k < 3; ++k) {
      if (from[k] != k) exchanged += (exchanged.empty() ? "" : " and ") + std::string(1, "XYZ"[k]);
      if (sign[k] < 0.0) turned += (turned.empty() ? "" : " and ") + std::string(1, "XYZ"[k]);
    }
    if (exchanged.empty()) return turned + " ran the other way";
    return exchanged + " were exchanged" + (turned.empty() ? "" : " and " + turned + " ran the other way");
  }
};

/// All but none, the simplest first.
std::vector<Mixing> mixings() {
  std::vector<Mixing> all;
  std::array<std::size_t, 3> from{0, 1, 2};
  do {
    for (unsigned bits = 0; bits < 8; ++bits) {
      Mixing mixing{from, {}};
      for (std::size_t k = 0; k < 3; ++k) mixing.sign[k] = (bits >> k & 1) != 0 ? -1.0 : 1.0;
      if (mixing.changes() > 0) all.push_back(mixing);
    }
  } while (std::ranges::next_permutation(from).found);
  std::ranges::stable_sort(all, {}, &Mixing::changes);
  return all;
}

std::string vector_text(Vector3 v, int decimals) {
  return fmt::format("({}; {}; {}) mm", format_fixed(v.x, decimals), format_fixed(v.y, decimals),
                     format_fixed(v.z, decimals));
}

/// Two stations of which each may have the name of the other; none where both are the same.
struct NamesExchanged {
  std::size_t one = 0, other = 0;

  std::size_t operator()(std::size_t station) const {
    return station == one ? other : station == other ? one : station;
  }
};

/// What is to be added to the stated offset of a tool less that of the first: s_first − s_tool, at every station that
/// saw both. A tool that is longer than stated by d sees its station moved by −d.
std::vector<Vector3> offset_errors(const Identification& result, std::size_t first, std::size_t tool,
                                   const NamesExchanged& of_tool = {}) {
  std::vector<Vector3> errors;
  for (const IdentifiedStation& a : result.stations)
    for (const IdentifiedStation& b : result.stations)
      if (a.station == of_tool(b.station) && a.tool == first && b.tool == tool) errors.push_back(a.at_mm - b.at_mm);
  return errors;
}

Vector3 mean_of(std::span<const Vector3> vectors) {
  Vector3 sum{};
  for (const Vector3& v : vectors) sum += v;
  return 1.0 / static_cast<double>(vectors.size()) * sum;
}

double spread_about(std::span<const Vector3> vectors, Vector3 mean) {
  double spread = 0.0;
  for (const Vector3& v : vectors) spread = std::max(spread, distance(v, mean));
  return spread;
}

/// The two stations whose names, exchanged at one of both tools, let all tell one difference: a fiftieth of what they
/// were apart is no chance. As many as `errors` are must do so: to call one by a name that neither tool has would only
/// leave it out.
std::optional<NamesExchanged> exchanged_between(const Identification& result, std::size_t stations, std::size_t tool,
                                                std::span<const Vector3> errors) {
  const double within_mm = std::max(offset_told_mm, 0.02 * spread_about(errors, mean_of(errors)));
  for (NamesExchanged names; names.one < stations; ++names.one)
    for (names.other = names.one + 1; names.other < stations; ++names.other) {
      const auto exchanged = offset_errors(result, 0, tool, names);
      if (exchanged.size() >= errors.size() && spread_about(exchanged, mean_of(exchanged)) < within_mm) return names;
    }
  return std::nullopt;
}

void add_tool_offsets(const MachineModel& machine, const VolumetricLengths& lengths, const Identification& result,
                      std::vector<VolumetricFinding>& findings) {
  for (std::size_t tool = 1; tool < lengths.tools.size(); ++tool) {
    std::vector<Vector3> errors = offset_errors(result, 0, tool);
    if (errors.empty()) continue;
    Vector3 mean = mean_of(errors);
    const double spread = spread_about(errors, mean);
    if (spread > std::max(offset_told_mm, 0.3 * norm(mean))) {
      if (result.rank.null_directions > 0) continue;  // places may lie in directions that nothing tells
      const auto names = exchanged_between(result, lengths.stations.size(), tool, errors);
      if (!names) {
        findings.push_back(
            {"volumetric-station-moved", true,
             fmt::format("where stations stand differs between tools {} and {} by {:.1f} mm, and not alike "
                         "for all stations: the instrument was moved between the tools, or stations are "
                         "mixed up",
                         text::quoted(lengths.tools[0]), text::quoted(lengths.tools[tool]), spread)});
        continue;
      }
      findings.push_back(
          {"volumetric-stations-exchanged", true,
           fmt::format("the names of stations {} and {} are exchanged in the lengths with tool {}, or in those with "
                       "tool {}: exchanged once more, all stations tell the same difference of both offsets",
                       text::quoted(lengths.stations[names->one]), text::quoted(lengths.stations[names->other]),
                       text::quoted(lengths.tools[0]), text::quoted(lengths.tools[tool]))});
      errors = offset_errors(result, 0, tool, *names);
      mean = mean_of(errors);
    }
    if (norm(mean) < offset_told_mm) continue;
    const Vector3 difference = machine.tools[*machine.tool_named(lengths.tools[tool])].offset_mm -
                               machine.tools[*machine.tool_named(lengths.tools[0])].offset_mm;
    std::string as_if;
    for (const Mixing& mixing : mixings())
      if (as_if.empty() && distance(mixing(difference) - difference, mean) < 0.1 * norm(mean))
        as_if = ", as if " + mixing.text();
    findings.push_back(
        {"volumetric-tool-offset", norm(mean) > offset_serious_mm,
         fmt::format("the offset of tool {} less that of tool {} is {}, not {} as stated, as {} station{} "
                     "show{}{}",
                     text::quoted(lengths.tools[tool]), text::quoted(lengths.tools[0]),
                     vector_text(difference + mean, 2), vector_text(difference, 2), errors.size(),
                     errors.size() == 1 ? "" : "s", errors.size() == 1 ? "s" : " alike", as_if)});
  }
}

struct Place {
  std::string name;
  Vector3 stated_mm, found_mm;
};

double farthest(std::span<const Place> places, const Mixing& mixing) {
  double most = 0.0;
  for (const Place& p : places) most = std::max(most, distance(mixing(p.stated_mm), p.found_mm));
  return most;
}

/// The two of which each stands where the other was said to, while all others stand where they were said to.
std::optional<NamesExchanged> exchanged_of(std::vector<Place> places) {
  for (std::size_t one = 0; one < places.size(); ++one)
    for (std::size_t other = one + 1; other < places.size(); ++other) {
      std::swap(places[one].stated_mm, places[other].stated_mm);
      if (farthest(places, {}) < place_told_mm) return NamesExchanged{one, other};
      std::swap(places[one].stated_mm, places[other].stated_mm);
    }
  return std::nullopt;
}

VolumetricFinding exchanged_finding(const std::string& one, const std::string& other, const std::string& mixed) {
  const std::string a = text::quoted(one), b = text::quoted(other);
  return {"volumetric-stations-exchanged", true,
          mixed.empty() ? fmt::format("station {} stands where {} was said to, and {} where {} was: the names of both "
                                      "are exchanged in the lengths, or where they stand in the machine's file",
                                      a, b, b, a)
                        : fmt::format("the stations stand where they were said to if the names of {} and {} are "
                                      "exchanged, or if {}",
                                      a, b, mixed)};
}

/// The simplest by which all stations stand where they were said to; empty where none does, or one station tells it.
std::string mixing_that_fits(std::span<const Place> places) {
  if (places.size() < 2) return "";
  for (const Mixing& mixing : mixings())
    if (farthest(places, mixing) < place_told_mm) return mixing.text();
  return "";
}

void add_places(const MachineModel& machine, const VolumetricLengths& lengths, const Identification& result,
                std::vector<VolumetricFinding>& findings) {
  std::vector<Place> places;
  for (const NamedStation& stated : machine.stations)
    for (const IdentifiedStation& found : result.stations)
      if (lengths.stations[found.station] == stated.name && found.tool == result.stations.front().tool)
        places.push_back({stated.name, stated.at_mm, found.at_mm});
  if (places.empty() || farthest(places, {}) < place_told_mm) return;
  const std::string mixed = mixing_that_fits(places);
  if (const auto exchanged = exchanged_of(places)) {
    findings.push_back(exchanged_finding(places[exchanged->one].name, places[exchanged->other].name, mixed));
    return;
  }
  if (!mixed.empty()) {
    findings.push_back({"volumetric-axes-mixed-up", true,
                        fmt::format("the stations stand where they were said to only if {}: axes or signs of the "
                                    "positions, or of the stations, are mixed up",
                                    mixed)});
    return;
  }
  std::vector<Vector3> off;
  for (const Place& p : places) off.push_back(p.found_mm - p.stated_mm);
  const Vector3 mean = mean_of(off);
  if (places.size() > 1 && spread_about(off, mean) < place_told_mm) {
    findings.push_back(
        {"volumetric-station-frame", true,
         fmt::format("all stations stand {} from where they were said to: they are stated in another "
                     "frame than the positions of the axes, or tool offsets are wrong by it, of all tools alike or "
                     "of one",
                     vector_text(mean, 0))});
    return;
  }
  const Place worst =
      *std::ranges::max_element(places, {}, [](const Place& p) { return distance(p.stated_mm, p.found_mm); });
  findings.push_back(
      {"volumetric-station-place", true,
       fmt::format("station {} stands at {}, {:.0f} mm from where it was said to", text::quoted(worst.name),
                   vector_text(worst.found_mm, 0), distance(worst.stated_mm, worst.found_mm))});
}

std::string names_text(const std::vector<std::string>& names) {
  constexpr std::size_t most_named = 6;
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), most_named); ++k)
    text += (k > 0 ? ", " : "") + text::quoted(names[k]);
  return text + (names.size() > most_named ? ", …" : "");
}

/// Where stations are stated, one of the lengths that is not among them is not looked at: most likely two names of one.
void add_unstated(const MachineModel& machine, const VolumetricLengths& lengths,
                  std::vector<VolumetricFinding>& findings) {
  std::vector<std::string> unstated, unmeasured;
  for (const std::string& name : lengths.stations)
    if (std::ranges::find(machine.stations, name, &NamedStation::name) == machine.stations.end())
      unstated.push_back(name);
  if (machine.stations.empty() || unstated.empty()) return;
  for (const NamedStation& stated : machine.stations)
    if (std::ranges::find(lengths.stations, stated.name) == lengths.stations.end()) unmeasured.push_back(stated.name);
  findings.push_back(
      {"volumetric-station-names", false,
       unmeasured.empty()
           ? fmt::format("nobody said where stations {} stand, which have lengths: their places were not looked at",
                         names_text(unstated))
           : fmt::format("nobody said where stations {} stand, which have lengths, and of {}, whose places are stated, "
                         "there are none: are they called otherwise? these places were not looked at",
                         names_text(unstated), names_text(unmeasured))});
}

/// What a place of its own would take of χ² in one stretch, and how far away it would be.
struct OwnPlace {
  double statistic = 0.0;
  double shift_um = 0.0;
};

std::vector<OwnPlace> own_places(const Identifier& done) {
  const Problem problem = done.problem();
  const std::size_t count = problem.unknowns.stretches.size();
  std::vector<Eigen::Matrix4d> normal(count, Eigen::Matrix4d::Zero());
  std::vector<Eigen::Vector4d> right(count, Eigen::Vector4d::Zero());
  for (std::size_t i = 0; i < problem.readings.size(); ++i) {
    const std::size_t j = problem.unknowns.stretch_of[i];
    const Vector3 s = done.fit().state.stations_mm[problem.unknowns.stretches[j].virtual_station];
    const Vector3 u = unit(problem.readings[i].axes_mm + problem.tool_mm(i) - s);
    const Eigen::Vector4d a(-u.x, -u.y, -u.z, -1.0);
    normal[j] += problem.weights[i] * a * a.transpose();
    right[j] += problem.weights[i] * done.fit().residuals_um[i] * a;
  }
  const double scale = robust_scale(problem, done.fit().residuals_um);
  std::vector<OwnPlace> places;
  for (std::size_t j = 0; j < count; ++j) {
    const Eigen::Vector4d move = normal[j].ldlt().solve(right[j]);
    places.push_back({move.allFinite() ? move.dot(right[j]) / (scale * scale) : 0.0, move.head<3>().norm()});
  }
  return places;
}

void add_moved(const Identifier& done, const VolumetricLengths& lengths, std::vector<VolumetricFinding>& findings) {
  constexpr std::size_t readings_least = 10;
  const std::vector<OwnPlace> places = own_places(done);
  const Unknowns& unknowns = done.unknowns();
  for (std::size_t v = 0; v < unknowns.stations.size(); ++v) {
    std::optional<std::size_t> worst;
    std::size_t stretches = 0;
    for (std::size_t j = 0; j < places.size(); ++j) {
      if (unknowns.stretches[j].virtual_station != v || unknowns.stretches[j].readings < readings_least) continue;
      ++stretches;
      if (places[j].statistic > moved_statistic && (!worst || places[j].statistic > places[*worst].statistic))
        worst = j;
    }
    if (stretches < 2 || !worst) continue;
    findings.push_back(
        {"volumetric-station-moved", true,
         fmt::format("station {} with tool {} stands about {:.1f} µm elsewhere in segment {} than in the others: the "
                     "instrument was moved, or lengths of two set-ups or days are mixed",
                     text::quoted(lengths.stations[unknowns.stations[v].station]),
                     text::quoted(lengths.tools[unknowns.stations[v].tool]), places[*worst].shift_um,
                     text::quoted(lengths.segments[unknowns.stretches[*worst].segment]))});
  }
}

}  // namespace

std::optional<VolumetricFinding> small_machine_finding(const MachineModel& machine) {
  const Vector3 travel = machine.travel.highest_mm - machine.travel.lowest_mm;
  if (std::max({travel.x, travel.y, travel.z}) > looks_like_inches_mm) return std::nullopt;
  return VolumetricFinding{
      "volumetric-small-machine", false,
      fmt::format("the travels of X, Y and Z are {:.1f}, {:.1f} and {:.1f} mm: are the numbers of the machine's file "
                  "in inches? all of them are read as mm",
                  travel.x, travel.y, travel.z)};
}

void add_setup_findings(const Identifier& done, const MachineModel& machine, const VolumetricLengths& lengths,
                        const Identification& result, std::vector<VolumetricFinding>& findings) {
  if (const auto small = small_machine_finding(machine)) findings.push_back(*small);
  add_tool_offsets(machine, lengths, result, findings);
  add_places(machine, lengths, result, findings);
  add_unstated(machine, lengths, findings);
  add_moved(done, lengths, findings);
}

}  // namespace axiometry::volumetric::detail
