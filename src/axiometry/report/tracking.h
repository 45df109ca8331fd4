// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/model/tracking.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/standards/iso230_6.h"
#include "axiometry/tracking/lengths/line_evaluation.h"
#include "axiometry/tracking/lines/seven_lines.h"
#include "axiometry/tracking/ranges/multilateration.h"
#include "axiometry/tracking/station/location_points.h"
#include "axiometry/tracking/station/station.h"

/// Everything that people see of a test with a tracking interferometer.
namespace axiometry::report {

/// What a picture of the set-up shows, in the reflector's coordinates.
struct Layout {
  struct Item {
    Vector3 begin_mm;
    Vector3 end_mm;
    std::string label;  ///< "xyz"; may be empty
    bool lost = false;  ///< shown, but as something that is not there
    bool beam = false;  ///< whether it is a beam from a station to a point: nothing moves along it
  };
  std::optional<TravelBox> box{};  ///< travels of the reflector
  std::vector<Vector3> stations_mm{};
  std::optional<double> safe_radius_mm{};
  std::vector<Item> lines{};
  std::vector<Vector3> points_mm{};  ///< numbered from 1 when there are no more than 20
  /// Of the stations and of the points, in their place: used where as many are given as there are.
  std::vector<std::string> station_names{}, point_names{};
  std::vector<Vector3> way_mm{};  ///< way of the reflector, from point to point; may be empty
  std::vector<Obstacle> obstacles{};
  std::string title{};
  std::string description{};
};

/// A parallel projection (X to the right, Y to the back, Z up) with the three views along the axes below it,
/// dimensioned. 500 points wide.
Figure layout_figure(const Layout& layout, const Options& options);

/// The set-up of a plan: travels of the reflector, station, lines from their first to their last target. A lost line of
/// the seven points from the station into the travels, to their end; `with_way` adds the ways from line to line.
Layout layout_of(const TrackingPlan& plan, bool with_way = false);

struct StationSubject {
  std::span<const LocationPoint> points;
  const tracking::StationLocation& location;
  const tracking::StationOptions& options;
  std::string file;    ///< as the user gave it
  std::string sha256;  ///< hash of its bytes
};
Document compose(const StationSubject& subject, const Options& options);

struct LocationPlanSubject {
  const TrackingSetup& setup;
  const tracking::LocationPlan& plan;
};
Document compose(const LocationPlanSubject& subject, const Options& options);

/// The sheet to take to the machine: set-up, layout, lines with their intervals and targets, lost lines, ways.
Document tracking_sheet(const TrackingPlan& plan, Duration duration, const Options& options);

struct AssessedLine {
  const tracking::EvaluatedLine& line;
  const iso230_2::Assessment& assessment;
  std::span<const iso230_2::Judgement> judgements;
};
struct LinesSubject {
  const TrackingPlan& plan;
  const tracking::LinesEvaluation& evaluation;
  std::span<const AssessedLine> lines;
  const iso230_6::DiagonalSummary& diagonals;
  std::string file;
  std::string sha256;
  std::span<const SourceFile> others{};  ///< plan and station
};
/// All lines in one report.
Document compose(const LinesSubject& subject, const Options& options);

struct MultilaterationSubject {
  std::span<const Vector3> nominal_mm;
  std::span<const RangeReading> readings;
  const tracking::MultilaterationFit& fit;
  const tracking::MultilaterationOptions& options;
  std::string file;
  std::string sha256;
  std::string points_file{}, points_sha256{};  ///< file of the nominal points; empty when there was none
};
Document compose(const MultilaterationSubject& subject, const Options& options);

}  // namespace axiometry::report
