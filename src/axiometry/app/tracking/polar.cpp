// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/polar.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <unordered_map>

#include "axiometry/app/files/amount_text.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/unexpected_text.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/tracking/tracking_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/tracking/ranges_csv.h"

namespace axiometry::app {
namespace {

constexpr double rad_per_arcsec = std::numbers::pi / 648000.0;

std::unexpected<Error> fail_in(std::string message, const std::string& file) {
  return std::unexpected(in_file(Error{std::move(message), {}, {}}, file));
}

struct JoinedRow {
  formats::PolarTableRow row;  ///< with the numbers of all files
  std::size_t file = 0;
};

/// Reads the files and gives their points and stations common numbers.
class PolarGathering {
 public:
  PolarGathering(const PolarRequest& request, PolarResult& result) : request_(request), result_(result) {}

  Result<std::vector<JoinedRow>> gather() {
    for (std::size_t f = 0; f < request_.files.size(); ++f) AXIOMETRY_TRY_VOID(add_file(f));
    if (!request_.points.empty()) AXIOMETRY_TRY_VOID(add_nominal());
    return std::move(rows_);
  }

 private:
  Result<void> add_file(std::size_t f) {
    const std::string& name = request_.files[f];
    AXIOMETRY_TRY(const std::string bytes,
                  bytes_at_hand(request_.bytes.empty() ? std::nullopt : std::optional(request_.bytes[f]), name));
    result_.sources.push_back({name, sha256(bytes)});
    AXIOMETRY_TRY(formats::PolarFile file, in_file(formats::read_polar(bytes), name));
    const std::size_t stations_before = result_.stations.size();
    for (std::size_t j = 0; j < file.stations.size(); ++j) {
      if (!stations_.insert(file.stations[j], stations_before + j))
        return fail_in(fmt::format("found station {} in a second file, expected each in one: another name where the "
                                   "instrument was moved",
                                   text::quoted(file.stations[j])),
                       name);
      result_.stations.push_back(file.stations[j]);
      result_.segments.push_back(file.segments[j]);
    }
    std::vector<std::size_t> numbers;
    for (const std::string& point : file.points) {
      if (points_.insert(point, result_.points.size())) result_.points.push_back(point);
      numbers.push_back(points_.at(point));
    }
    for (formats::PolarTableRow row : file.rows) {
      row.point = numbers[row.point];
      row.station += stations_before;
      rows_.push_back({row, f});
    }
    for (const std::string& remark : file.remarks) result_.remarks.push_back({base_name(name), remark});
    return {};
  }

  Result<void> add_nominal() {
    AXIOMETRY_TRY(const std::string bytes, bytes_at_hand(request_.points_bytes, request_.points));
    result_.points_source = PolarSource{request_.points, sha256(bytes)};
    AXIOMETRY_TRY(const formats::NamedPoints named, in_file(formats::read_named_points(bytes), request_.points));
    std::unordered_map<std::string_view, std::size_t> numbers;
    for (std::size_t k = 0; k < named.names.size(); ++k) numbers.emplace(named.names[k], k);
    for (const std::string& point : result_.points) {
      const auto found = numbers.find(point);
      if (found == numbers.end())
        return fail_in(fmt::format("found no nominal place of point {}, expected one of each that was measured",
                                   text::quoted(point)),
                       request_.points);
      result_.nominal_mm.push_back(named.at_mm[found->second]);
    }
    if (const std::size_t left = named.names.size() - result_.points.size(); left > 0)
      result_.remarks.push_back(
          {base_name(request_.points), fmt::format("{} nominal point{} no length and {} left out", left,
                                                   left == 1 ? " has" : "s have", left == 1 ? "is" : "are")});
    for (const std::string& remark : named.remarks) result_.remarks.push_back({base_name(request_.points), remark});
    return {};
  }

  struct Numbers {
    std::unordered_map<std::string, std::size_t> of;
    bool insert(const std::string& name, std::size_t number) { return of.emplace(name, number).second; }
    std::size_t at(const std::string& name) const { return of.at(name); }
  };

  const PolarRequest& request_;
  PolarResult& result_;
  Numbers points_, stations_;
  std::vector<JoinedRow> rows_;
};

/// What is known of each station's readings.
class PolarUncertainties {
 public:
  static Result<PolarUncertainties> make(const PolarRequest& request, const PolarResult& result,
                                         const std::vector<bool>& has_angles) {
    PolarUncertainties made;
    std::map<std::string, std::string, std::less<>> named;
    for (const auto& [station, name] : request.instruments) {
      if (!station.empty() && std::ranges::find(result.stations, station) == result.stations.end())
        return fail(
            fmt::format("found an instrument of station {}, which the files do not have", text::quoted(station)));
      if (!named.emplace(station, name).second)
        return fail(station.empty()
                        ? std::string("found two instruments of all stations, expected one")
                        : fmt::format("found two instruments of station {}, expected one", text::quoted(station)));
    }
    for (std::size_t j = 0; j < result.stations.size(); ++j) {
      const auto mode = has_angles[j] ? tracking::LengthMode::absolute : tracking::LengthMode::changes;
      PolarUncertainty own, common;
      if (const auto found = named.find(result.stations[j]); found != named.end()) {
        AXIOMETRY_TRY(own, of_kind(found->second, mode));
      }
      if (const auto found = named.find(""); found != named.end()) {
        AXIOMETRY_TRY(common, of_kind(found->second, mode));
      }
      const auto first = [](const auto& a, const auto& b, const auto& c) { return a ? a : b ? b : c; };
      made.of_.push_back({first(own.length, request.stated.length, common.length),
                          first(own.across, request.stated.across, common.across)});
    }
    return made;
  }

  /// The reading of a row at about that distance.
  Result<tracking::PolarReading> reading(const formats::PolarTableRow& row, double distance_mm) const {
    tracking::PolarReading reading{row.point, row.station, row.segment, row.length_mm, 0.0, {}};
    const PolarUncertainty& known = of_[row.station];
    if (!row.length_u_mm && !known.length)
      return fail(
          "found a length whose uncertainty nobody states, expected it in u_length_um, or an instrument or "
          "the uncertainty of lengths",
          {row.line, 0});
    reading.length_sigma_mm = row.length_u_mm ? *row.length_u_mm : known.length->standard_mm(distance_mm);
    if (!(reading.length_sigma_mm > 0.0))
      return fail("found an uncertainty of a length that is 0, expected one above 0 to weigh by", {row.line, 0});
    if (row.angles) {
      AXIOMETRY_TRY(reading.direction, direction(row, known, distance_mm));
    }
    return reading;
  }

 private:
  static Result<PolarUncertainty> of_kind(const std::string& name, tracking::LengthMode mode) {
    AXIOMETRY_TRY(const auto chosen, tracking::find_tracker(name, mode));
    if (!chosen)
      return fail(
          fmt::format("found the instrument {}, expected one of those that axiometry tracking instruments "
                      "lists",
                      text::quoted(name)));
    PolarUncertainty known;
    if (chosen->length) known.length = chosen->length->expanded_uncertainty();
    if (chosen->kind->across) known.across = chosen->kind->across->expanded_uncertainty();
    return known;
  }

  /// An angle of its own uncertainty is one of the circle; one that is known across the beam is alike in both
  /// directions.
  static Result<tracking::PolarDirection> direction(const formats::PolarTableRow& row, const PolarUncertainty& known,
                                                    double distance_mm) {
    const formats::PolarAngles& angles = *row.angles;
    if ((!angles.azimuth_u_arcsec || !angles.elevation_u_arcsec) && !known.across)
      return fail(
          "found angles whose uncertainty nobody states, expected it in u_azimuth_arcsec and "
          "u_elevation_arcsec, or an instrument or the uncertainty of angles",
          {row.line, 0});
    const double across = known.across ? known.across->standard_mm(distance_mm) / distance_mm : 0.0;
    const double rad = std::numbers::pi / 180.0;
    const double upwards = angles.elevation_u_arcsec ? rad_per_arcsec * *angles.elevation_u_arcsec : across;
    tracking::PolarDirection direction =
        tracking::direction_of(rad * angles.azimuth_deg, rad * angles.elevation_deg,
                               rad_per_arcsec * angles.azimuth_u_arcsec.value_or(0.0), upwards);
    if (!angles.azimuth_u_arcsec) direction.sideways_sigma_rad = across;
    if (direction.sideways_sigma_rad > 0.0 && direction.upwards_sigma_rad > 0.0) return direction;
    return fail("found an uncertainty of angles that is 0, expected one above 0 to weigh by", {row.line, 0});
  }

  std::vector<PolarUncertainty> of_;
};

/// The readings, each weighed at its distance: that of its row with angles, else `distances`.
Result<void> weigh(PolarResult& result, const std::vector<JoinedRow>& rows, const PolarUncertainties& known,
                   const std::vector<double>& distances_mm) {
  result.readings.clear();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    AXIOMETRY_TRY(tracking::PolarReading reading,
                  in_file(known.reading(rows[k].row, distances_mm[k]), result.sources[rows[k].file].file));
    result.readings.push_back(std::move(reading));
  }
  return {};
}

}  // namespace

Result<RangingUncertainty> parse_across(std::string_view text) {
  if (text.ends_with("um") || text.ends_with("/m") || text.ends_with("mm")) return parse_ranging(text);
  const auto angle = parse_deviation(text, AxisKind::rotary);
  if (!angle || !(angle->in_native() >= 0.0))
    return unexpected_text(text,
                           "the expanded uncertainty of angles such as 2arcsec, or across the beam such as "
                           "30um+12um/m");
  return RangingUncertainty{Length::um(0.0), RelativeLength::um_per_m(1e6 * rad_per_arcsec * angle->in_native())};
}

Result<void> put_tracker(std::string_view text, PolarRequest& request) {
  const std::size_t mark = text.rfind('=');
  if (mark == 0) return fail("found no station before =, expected STATION=NAME");
  if (mark == std::string_view::npos)
    request.instruments.emplace_back("", text);
  else
    request.instruments.emplace_back(text.substr(0, mark), text.substr(mark + 1));
  return {};
}

Result<void> put_polar_lengths(std::string_view text, PolarRequest& request) {
  // A name would have to say whether it means distances or their changes: --instrument knows by the station.
  AXIOMETRY_TRY(const auto kind, tracking::find_tracker(text, tracking::LengthMode::absolute));
  if (kind)
    return fail(
        "found an instrument, expected A+B such as 20um+1um/m; the name of an instrument "
        "is given for itself, not as an uncertainty");
  AXIOMETRY_TRY(request.stated.length, parse_ranging(text));
  return {};
}

Result<std::unique_ptr<PolarResult>> adjust_polar_files(const PolarRequest& request) {
  auto result = std::make_unique<PolarResult>();
  AXIOMETRY_TRY(const std::vector<JoinedRow> rows, PolarGathering(request, *result).gather());
  std::vector<bool> has_angles(result->stations.size(), false);
  for (const JoinedRow& r : rows)
    if (r.row.angles) has_angles[r.row.station] = true;
  if (std::ranges::find(has_angles, true) == has_angles.end())
    return fail_in(
        "found no angles, expected them of one station at least; lengths alone are for axiometry tracking "
        "multilaterate",
        request.files.front());
  AXIOMETRY_TRY(const PolarUncertainties known, PolarUncertainties::make(request, *result, has_angles));
  // Of lengths alone the distance is not known before a first solution, which takes that of 1 m.
  std::vector<double> distances_mm;
  for (const JoinedRow& r : rows) distances_mm.push_back(has_angles[r.row.station] ? r.row.length_mm : 1000.0);
  AXIOMETRY_TRY_VOID(weigh(*result, rows, known, distances_mm));
  result->options.datum =
      result->nominal_mm.empty() || request.in_station ? tracking::PolarDatum::station : tracking::PolarDatum::nominal;
  result->options.nominal_mm = result->nominal_mm;
  result->options.stop = request.stop;
  result->options.station_names = result->stations;
  result->options.point_names = result->points;
  const auto adjust = [&] {
    return in_file(
        tracking::adjust_polar(result->points.size(), result->stations.size(), result->readings, result->options),
        request.files.front());
  };
  AXIOMETRY_TRY(result->fit, adjust());
  if (std::ranges::find(has_angles, false) == has_angles.end()) return result;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (!has_angles[rows[k].row.station])
      distances_mm[k] =
          distance(result->fit.points_mm[rows[k].row.point], result->fit.stations[rows[k].row.station].position_mm);
  AXIOMETRY_TRY_VOID(weigh(*result, rows, known, distances_mm));
  AXIOMETRY_TRY(result->fit, adjust());
  return result;
}

}  // namespace axiometry::app
