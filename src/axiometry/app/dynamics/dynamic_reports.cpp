// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "axiometry/app/files/source.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/report/figures/recorded_motion.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"

namespace axiometry::app {
namespace {

using capture::UniformStretch;
using report::Align;
using report::plain;

constexpr int value_digits = 5;
constexpr std::size_t most_stretches_shown = 60;
constexpr std::size_t most_named_lines = 8;  // of more a legend takes more room than the figure

struct DynamicReport {
  const DynamicMotion& m;
  const report::Options& options;

  std::string unit() const { return std::string(position_unit(m.kind)); }
  double deviation_scale() const { return deviation_per_position(m.kind); }
  report::TableCell number(double x, int digits = value_digits) const {
    return {plain(report::shown_short(x, options, digits))};
  }
  report::TableCell time(std::size_t sample) const {
    return {plain(format_fixed(m.record.time_s(sample), 4, options.numbers))};
  }

  report::Section results() const {
    const DynamicExtremes at = extremes_of(m);
    report::Table table;
    table.columns = {{plain("Quantity"), Align::start, true, true},
                     {plain("Value"), Align::decimal},
                     {plain("Noise"), Align::decimal},
                     {plain("Unit")},
                     {plain("At / s"), Align::decimal},
                     {plain(fmt::format("At / {}", unit())), Align::decimal}};
    const auto add = [&](std::string_view name, double value, double noise, const std::string& of, std::size_t sample) {
      table.rows.push_back({word_cell(name),
                            number(value),
                            number(noise, 2),
                            word_cell(of),
                            time(sample),
                            {plain(format_fixed(m.record.positions[sample], 3, options.numbers))}});
    };
    const auto& [v, a] =
        std::pair<const std::vector<double>&, const std::vector<double>&>(m.course.velocity, m.course.acceleration);
    add("Highest velocity", v[at.fastest_up], m.course.velocity_noise, unit() + "/s", at.fastest_up);
    add("Lowest velocity", v[at.fastest_down], m.course.velocity_noise, unit() + "/s", at.fastest_down);
    add("Highest acceleration", a[at.strongest_up], m.course.acceleration_noise, unit() + "/s²", at.strongest_up);
    add("Lowest acceleration", a[at.strongest_down], m.course.acceleration_noise, unit() + "/s²", at.strongest_down);
    table.notes = {plain(fmt::format(
        "Of parabolas through {} samples ({} s): what is faster than that is averaged. Noise: the standard deviation "
        "that the noise of the positions, {} {}, makes of each value.",
        2 * m.course.half_window + 1, report::shown_short(m.course.window_s, options, 4),
        report::shown_short(m.course.noise * deviation_scale(), options, 2), deviation_unit(m.kind)))};
    return {"results", "Velocity and acceleration", true, {std::move(table)}};
  }

  std::vector<report::TableCell> stretch_row(const UniformStretch& s) const {
    const double per_minute = std::abs(s.velocity) * 60.0;
    std::vector<report::TableCell> row = {word_cell(s.velocity > 0.0 ? "↑" : "↓"),
                                          time(s.first),
                                          time(s.last),
                                          {plain(format_fixed(m.record.positions[s.first], 2, options.numbers))},
                                          {plain(format_fixed(m.record.positions[s.last], 2, options.numbers))},
                                          number(per_minute, 6)};
    if (m.feed) row.push_back({plain(format_fixed(100.0 * (per_minute / *m.feed - 1.0), 3, options.numbers))});
    return row;
  }

  report::Table stretch_table() const {
    report::Table table;
    table.columns = {{plain("Direction"), Align::centre, true},
                     {plain("From / s"), Align::decimal},
                     {plain("To / s"), Align::decimal},
                     {plain(fmt::format("From / {}", unit())), Align::decimal, false, false, true},
                     {plain(fmt::format("To / {}", unit())), Align::decimal},
                     {plain(fmt::format("Feed / {}/min", unit())), Align::decimal, false, false, true}};
    if (m.feed) table.columns.push_back({plain("less that asked for / %"), Align::decimal});
    for (const UniformStretch& s : shown()) table.rows.push_back(stretch_row(s));
    table.notes = {plain(fmt::format(
        "Of each movement the longest part whose velocity stays within {} % of its median, from where it first reaches "
        "that to where it last has it; it strays from the straight line of position over time by least squares.",
        report::shown_short(100.0 * m.uniform_share, options, 4)))};
    if (m.stretches.size() > most_stretches_shown)
      table.notes.push_back(plain(
          fmt::format("… and {} more; all of them stand in the JSON.", m.stretches.size() - most_stretches_shown)));
    return table;
  }

  report::Table straying_table() const {
    report::Table table;
    table.columns = {{plain("Direction"), Align::centre, true},
                     {plain("From / s"), Align::decimal},
                     {plain("s of velocity / %"), Align::decimal},
                     {plain("its range / %"), Align::decimal},
                     {plain(fmt::format("Strays, range / {}", deviation_unit(m.kind))), Align::decimal},
                     {plain(fmt::format("rms / {}", deviation_unit(m.kind))), Align::decimal}};
    for (const UniformStretch& s : shown()) {
      const double mean = std::abs(s.velocity);
      table.rows.push_back({word_cell(s.velocity > 0.0 ? "↑" : "↓"),
                            time(s.first),
                            {plain(format_fixed(100.0 * s.velocity_deviation / mean, 3, options.numbers))},
                            {plain(format_fixed(100.0 * s.velocity_range / mean, 3, options.numbers))},
                            number(s.deviation_range * deviation_scale(), 4),
                            number(s.deviation_rms * deviation_scale(), 4)});
    }
    return table;
  }

  std::span<const UniformStretch> shown() const {
    return std::span(m.stretches).first(std::min(m.stretches.size(), most_stretches_shown));
  }

  report::Section uniform() const {
    report::Section section{"uniform", "Even motion, without standstills", true, {}};
    section.blocks.emplace_back(report::Notice{
        report::Tone::caution,
        plain("No test of ISO 230-2"),
        {plain(
            "Standstills at targets are not looked for, and nobody knows when the control wanted a moving axis where. "
            "What is told is "
            "how far it strays from an even motion: errors of position, control and feed alike, as the instrument "
            "saw them. An error of scale, a lag and a reversal error cannot be told, nor A, E, R, B and M.")}});
    if (m.stretches.empty()) {
      section.blocks.emplace_back(report::Paragraph{plain("No stretch of even motion was found.")});
      return section;
    }
    section.blocks.emplace_back(stretch_table());
    section.blocks.emplace_back(straying_table());
    return section;
  }

  report::Section vibrations() const {
    report::Table table;
    const bool ways = m.spectrum_of == SpectrumOf::longest_stretch;
    table.columns = {{plain("Frequency / Hz"), Align::decimal, true},
                     {plain(fmt::format("Amplitude / {}", deviation_unit(m.kind))), Align::decimal}};
    if (ways) table.columns.push_back({plain(fmt::format("Period along the axis / {}", unit())), Align::decimal});
    for (const capture::SpectrumPeak& peak : m.spectrum.peaks) {
      auto& row = table.rows.emplace_back();
      row.push_back(number(peak.frequency_hz, 6));
      row.push_back(number(peak.amplitude, 4));
      if (ways) row.push_back(number(*way_of(m, peak), 5));
    }
    table.notes = {
        plain(fmt::format(
            fmt::runtime(
                ways ? "Of the longest stretch of even motion less its line, from {} to {} s, with Hann's window; "
                       "frequencies nearer than {} Hz cannot be told apart."
                     : "Of the whole recording less a straight line, from {} to {} s, with Hann's window; "
                       "frequencies nearer than {} Hz cannot be told apart."),
            format_fixed(m.record.time_s(m.spectrum_stretch.first), 3, options.numbers),
            format_fixed(m.record.time_s(m.spectrum_stretch.last), 3, options.numbers),
            report::shown_short(m.spectrum.resolution_hz, options, 3))),
        plain(fmt::format(
            "Shown is what stands above the noise about its frequency (nowhere less than {} {}), as white noise or a "
            "random walk alone would do in one recording of twenty at most, noise that the instrument has averaged "
            "over "
            "more than {} s more often; and above what a drift and higher peaks may leave beside themselves.",
            report::shown_short(m.spectrum.threshold, options, 2), deviation_unit(m.kind),
            report::shown_short(m.spectrum.averaging_told_s(), options, 2)))};
    if (m.spectrum.peaks_more > 0)
      table.notes.push_back(plain(fmt::format("Not shown: {}.", counted(m.spectrum.peaks_more, "lower peak"))));
    report::Section section{"vibrations", "Vibrations", true, {}};
    if (table.rows.empty())
      section.blocks.emplace_back(
          report::Paragraph{plain("No vibration stands out of the noise and of what a drift leaves.")});
    else
      section.blocks.emplace_back(std::move(table));
    return section;
  }

  /// Values of all samples over time.
  template <typename Of>
  std::vector<report::Point> over_time(const Of& of) const {
    std::vector<report::Point> points;
    for (std::size_t k = 0; k < m.record.positions.size(); ++k) points.push_back({m.record.time_s(k), of(k)});
    return points;
  }

  report::Figure time_figure(const std::string& title, const std::string& of, const std::string& in,
                             std::vector<report::Point> points) const {
    report::RecordedCurve curve;
    curve.title = title;
    curve.description = fmt::format("{} at {} samples.", of, m.record.positions.size());
    curve.x_title = "Time", curve.x_unit = "s";
    curve.y_title = of, curve.y_unit = in;
    curve.lines.push_back(std::move(points));
    for (const UniformStretch& s : m.stretches)
      curve.shaded.emplace_back(m.record.time_s(s.first), m.record.time_s(s.last));
    return report::recorded_figure(curve, options);
  }

  report::Figure straying() const {
    report::RecordedCurve curve;
    curve.title = "What strays from even motion over the position";
    curve.description = fmt::format("A line for each of {}.", counted(m.stretches.size(), "stretch", "stretches"));
    curve.x_title = "Position", curve.x_unit = unit();
    curve.y_title = "Strays", curve.y_unit = std::string(deviation_unit(m.kind));
    for (const UniformStretch& s : m.stretches) {
      if (curve.lines.size() == most_stretches_shown) break;
      const std::vector<double> residuals = capture::residuals_of(m.record, s);
      curve.names.push_back(fmt::format("{} {}\u00a0s", s.velocity > 0.0 ? "↑" : "↓",
                                        format_fixed(m.record.time_s(s.first), 2, options.numbers)));
      auto& line = curve.lines.emplace_back();
      for (std::size_t i = 0; i < residuals.size(); ++i)
        line.push_back({m.record.positions[s.first + i], residuals[i] * deviation_scale()});
      std::ranges::stable_sort(line, {}, &report::Point::x);
    }
    if (curve.names.size() > most_named_lines) curve.names.clear();
    return report::recorded_figure(curve, options);
  }

  report::Figure spectrum() const {
    report::RecordedCurve curve;
    curve.title = "Amplitudes by frequency";
    curve.description = fmt::format("Amplitudes at {} frequencies.", m.spectrum.amplitudes.size());
    curve.x_title = "Frequency", curve.x_unit = "Hz";
    curve.y_title = "Amplitude", curve.y_unit = std::string(deviation_unit(m.kind));
    curve.from_zero = true;
    auto& line = curve.lines.emplace_back();
    for (std::size_t k = 0; k < m.spectrum.amplitudes.size(); ++k)
      line.push_back({static_cast<double>(k) * m.spectrum.step_hz, m.spectrum.amplitudes[k]});
    return report::recorded_figure(curve, options);
  }

  report::Section figures() const {
    report::Section section{"figures", "Figures", true, {}};
    section.blocks.emplace_back(time_figure("Position over time; stretches of even motion are shaded", "Position",
                                            unit(), over_time([&](std::size_t k) { return m.record.positions[k]; })));
    section.blocks.emplace_back(time_figure("Velocity over time", "Velocity", unit() + "/s",
                                            over_time([&](std::size_t k) { return m.course.velocity[k]; })));
    section.blocks.emplace_back(time_figure("Acceleration over time", "Acceleration", unit() + "/s²",
                                            over_time([&](std::size_t k) { return m.course.acceleration[k]; })));
    if (!m.stretches.empty()) section.blocks.emplace_back(straying());
    section.blocks.emplace_back(spectrum());
    return section;
  }

  report::Document document(bool with_figures) const {
    report::Document d = experiment_document("Motion of an axis, evaluated without standstills", "");
    d.kind = "Recording";
    d.running_head = report::translated(d.title, options);
    d.running_status = "Motion, no test of ISO 230-2";
    d.edition = d.running_status;
    d.identity = {{plain("File"), {report::verbatim(base_name(m.file))}},
                  {plain("Samples"), word_cell(fmt::format("{}", m.record.positions.size()))},
                  {plain("Samples per second"), {plain(report::shown_short(m.record.rate_hz, options))}},
                  {plain("Duration"), {plain(report::shown_short(m.record.duration_s(), options, 5) + " s")}}};
    if (m.feed)
      d.identity.push_back(
          {plain("Feed asked for"), {plain(report::shown_exact(*m.feed, options) + " " + unit() + "/min")}});
    report::Notice notice{report::Tone::caution, plain("To be known with these figures"), {}};
    for (const std::string& remark : m.remarks) notice.lines.push_back(report::sentence(remark));
    d.status.push_back(std::move(notice));
    d.sections = {results(), uniform(), vibrations()};
    if (with_figures) d.sections.push_back(figures());
    const report::SourceFile source[] = {{"Recording", m.file, m.sha256}};
    d.sections.push_back(report::provenance_of_files(source));
    return d;
  }
};

}  // namespace

Experiment present(const DynamicMotion& motion, const report::Options& options, DynamicOutputs outputs) {
  Experiment experiment;
  experiment.document = DynamicReport{motion, options}.document(outputs.report);
  if (outputs.json) experiment.json = to_json(motion);
  return experiment;
}

}  // namespace axiometry::app
