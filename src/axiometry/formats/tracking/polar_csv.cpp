// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/polar_csv.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/named_rows.h"
#include "axiometry/formats/text/simulated_note.h"
#include "axiometry/formats/text/table_heads.h"

namespace axiometry::formats {
namespace {

enum PolarRole : std::size_t {
  polar_point,
  polar_station,
  polar_segment,
  polar_length,
  polar_length_u,
  polar_azimuth,
  polar_elevation,
  polar_zenith,
  polar_azimuth_u,
  polar_elevation_u,
  polar_role_count
};
constexpr std::array<std::string_view, polar_role_count> polar_canonical = {
    "point",       "station",       "segment",    "length_mm",        "u_length_um",
    "azimuth_deg", "elevation_deg", "zenith_deg", "u_azimuth_arcsec", "u_elevation_arcsec"};
constexpr ColumnWord polar_words[] = {{"point", polar_point},
                                      {"p", polar_point},
                                      {"point id", polar_point},
                                      {"station", polar_station},
                                      {"s", polar_station},
                                      {"station id", polar_station},
                                      {"tracker", polar_station},
                                      {"segment", polar_segment},
                                      {"beam", polar_segment},
                                      {"length", polar_length},
                                      {"range", polar_length},
                                      {"distance", polar_length},
                                      {"l", polar_length},
                                      {"d", polar_length},
                                      {"u length", polar_length_u},
                                      {"u range", polar_length_u},
                                      {"u distance", polar_length_u},
                                      {"azimuth", polar_azimuth},
                                      {"az", polar_azimuth},
                                      {"horizontal angle", polar_azimuth},
                                      {"elevation", polar_elevation},
                                      {"el", polar_elevation},
                                      {"zenith", polar_zenith},
                                      {"zenith angle", polar_zenith},
                                      {"u azimuth", polar_azimuth_u},
                                      {"u horizontal angle", polar_azimuth_u},
                                      {"u elevation", polar_elevation_u},
                                      {"u zenith", polar_elevation_u}};
constexpr TableWords polar_table = {polar_canonical, polar_words, polar_length, polar_azimuth};
constexpr std::string_view polar_example = "point,station,length_mm,azimuth_deg,elevation_deg";

/// Reads rows into a PolarFile.
class PolarReader {
 public:
  Result<PolarFile> read(std::string_view text) {
    constexpr std::size_t needed[] = {polar_point, polar_station, polar_length};
    AXIOMETRY_TRY_VOID(
        for_named_rows(text, columns_, polar_table, needed, polar_example, [&](const NamedRow& row) -> Result<void> {
          if (!checked_) AXIOMETRY_TRY_VOID(check_columns());
          checked_ = true;
          return add(row);
        }));
    AXIOMETRY_TRY_VOID(check_distances());
    if (file_.rows.empty()) return fail("found a header and no lengths below it, expected one in each row");
    file_.points = points_.take();
    file_.stations = stations_.take();
    for (NameNumbers& names : segments_) file_.segments.push_back(names.take());
    tell_unused_segments();
    if (columns_.simulated) file_.remarks.emplace_back(simulated_lengths);
    if (!columns_.passed_over.empty()) file_.remarks.push_back(passed_over(columns_.passed_over));
    if (missing_ > 0)
      file_.remarks.push_back(fmt::format("passed over {} row{} without a length", missing_, missing_ == 1 ? "" : "s"));
    return std::move(file_);
  }

 private:
  Result<void> check_columns() const {
    const bool azimuth = columns_.has(polar_azimuth), elevation = columns_.has(polar_elevation),
               zenith = columns_.has(polar_zenith);
    if (elevation && zenith)
      return fail("found columns elevation and zenith, expected one of them", {columns_.line, 1});
    if (azimuth != (elevation || zenith))
      return fail("found a column of one angle, expected azimuth with elevation or zenith", {columns_.line, 1});
    if (!azimuth && (columns_.has(polar_azimuth_u) || columns_.has(polar_elevation_u)))
      return fail("found uncertainties of angles without angles, expected columns of both", {columns_.line, 1});
    return {};
  }

  static Result<void> check_uncertainty(double x, double most, const NamedRow& row, std::size_t role) {
    if (x > 0.0 && x <= most) return {};
    return fail(fmt::format("found {}, expected a standard uncertainty above 0, of lengths up to 1 m and of angles up "
                            "to 1°",
                            text::quoted(row.cell(role))),
                row.at(role));
  }

  Result<std::optional<double>> uncertainty(const NamedRow& row, std::size_t role) {
    if (!columns_.has(role) || is_missing(row.cell(role))) return std::nullopt;
    if (role == polar_length_u) {
      AXIOMETRY_TRY(const double mm, cells_.length(row, role));
      AXIOMETRY_TRY_VOID(check_uncertainty(mm, 1000.0, row, role));
      return mm;
    }
    AXIOMETRY_TRY(const double degrees, cells_.angle(row, role));
    AXIOMETRY_TRY_VOID(check_uncertainty(degrees, 1.0, row, role));
    return 3600.0 * degrees;
  }

  Result<std::optional<PolarAngles>> angles(const NamedRow& row) {
    if (!columns_.has(polar_azimuth)) return std::nullopt;
    const PolarRole upwards = columns_.has(polar_zenith) ? polar_zenith : polar_elevation;
    const bool no_azimuth = is_missing(row.cell(polar_azimuth)), no_upwards = is_missing(row.cell(upwards));
    if (no_azimuth && no_upwards) return std::nullopt;
    if (no_azimuth != no_upwards)
      return fail("found one angle in a row, expected both or none", row.at(no_azimuth ? upwards : polar_azimuth));
    PolarAngles angles;
    AXIOMETRY_TRY(angles.azimuth_deg, cells_.angle(row, polar_azimuth));
    if (!(std::abs(angles.azimuth_deg) <= 720.0))
      return fail(
          fmt::format("found {}, expected an azimuth from −720° to 720°", text::quoted(row.cell(polar_azimuth))),
          row.at(polar_azimuth));
    AXIOMETRY_TRY(angles.elevation_deg, cells_.angle(row, upwards));
    if (upwards == polar_zenith) angles.elevation_deg = 90.0 - angles.elevation_deg;
    if (!(std::abs(angles.elevation_deg) <= 90.0))
      return fail(fmt::format("found {}, expected {}", text::quoted(row.cell(upwards)),
                              upwards == polar_zenith ? "an angle from the zenith from 0° to 180°"
                                                      : "an elevation from −90° to 90°"),
                  row.at(upwards));
    AXIOMETRY_TRY(angles.azimuth_u_arcsec, uncertainty(row, polar_azimuth_u));
    AXIOMETRY_TRY(angles.elevation_u_arcsec, uncertainty(row, polar_elevation_u));
    return angles;
  }

  /// What a station shows is known after its last row: angles may be in any of them.
  Result<void> check_distances() const {
    for (const NoDistance& length : no_distances_)
      if (has_angles_[length.station])
        return fail(fmt::format("found the length {} at a station with angles, expected the distance from the "
                                "instrument, above 0",
                                text::quoted(length.text)),
                    length.at);
    return {};
  }

  void tell_unused_segments() {
    for (std::size_t j = 0; j < file_.stations.size(); ++j)
      if (has_angles_[j] && file_.segments[j].size() > 1)
        file_.remarks.push_back(fmt::format("segments of station {} are not used: it shows angles, and so distances",
                                            text::quoted(file_.stations[j])));
  }

  Result<void> add(const NamedRow& row) {
    AXIOMETRY_TRY(const std::string_view point, cells_.name(row, polar_point));
    AXIOMETRY_TRY(const std::string_view station, cells_.name(row, polar_station));
    if (is_missing(row.cell(polar_length))) {
      ++missing_;
      return {};
    }
    PolarTableRow reading;
    AXIOMETRY_TRY(reading.length_mm, cells_.length(row, polar_length));
    AXIOMETRY_TRY(reading.length_u_mm, uncertainty(row, polar_length_u));
    AXIOMETRY_TRY(reading.angles, angles(row));
    reading.point = points_.number(point);
    reading.station = stations_.number(station);
    if (reading.station == segments_.size()) {
      segments_.emplace_back();
      has_angles_.push_back(false);
    }
    if (reading.angles) has_angles_[reading.station] = true;
    if (!(reading.length_mm > 0.0))
      no_distances_.push_back({reading.station, std::string(row.cell(polar_length)), row.at(polar_length)});
    reading.segment =
        segments_[reading.station].number(columns_.has(polar_segment) ? row.cell(polar_segment) : std::string_view());
    reading.line = row.number();
    file_.rows.push_back(reading);
    return {};
  }

  NamedColumns columns_;
  NamedCells cells_{columns_, polar_table};
  NameNumbers points_, stations_;
  std::vector<NameNumbers> segments_;
  std::vector<bool> has_angles_;  // per station
  struct NoDistance {
    std::size_t station;
    std::string text;
    TextPosition at;
  };
  std::vector<NoDistance> no_distances_;  // lengths that are not above 0
  std::size_t missing_ = 0;
  bool checked_ = false;
  PolarFile file_;
};

}  // namespace

Result<PolarFile> read_polar(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  AXIOMETRY_TRY(PolarFile file, PolarReader().read(decoded.text));
  for (const SourceRemark& remark : encoding_remarks(decoded)) file.remarks.push_back(remark.message);
  return file;
}

}  // namespace axiometry::formats
