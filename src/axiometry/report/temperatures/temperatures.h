// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "axiometry/model/temperatures.h"
#include "axiometry/report/document.h"
#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/environment/environment.h"

/// The report of the temperatures about a test (4.1, 7): words, figure, document.
namespace axiometry::report {

struct TemperatureSubject {
  std::string file;  ///< name of the log, without folders
  std::string sha256;
  std::string began;  ///< beginning of the test, as the user said it; may be empty
  std::string ended;
  const TemperatureLog& log;
  const std::optional<TimeStretch>& test;
  const iso230_2::TestEnvironment& environment;
};

/// "21.35 °C"; with more decimals where a limit is exceeded by less than these show.
std::string measured_text(const iso230_2::EnvironmentItem& item, const Options& options);
/// "at most 22 °C"; empty where nothing was agreed.
std::string agreed_text(const iso230_2::EnvironmentItem& item, const Options& options);

/// What was measured, what was agreed, and how each stands.
Table environment_table(const iso230_2::TestEnvironment& environment, const Options& options);

/// The sensors of a log with their extremes.
Table sensor_table(const TemperatureLog& log, const Options& options);

/// Of a log that goes with a test, which must outlive it.
TemperatureSubject subject_of(const iso230_2::LoggedEnvironment& logged);

/// temperature_figure() of the log that goes with a test; nothing where none does.
std::optional<Figure> surroundings_figure(const Subject& subject, const Options& options);

/// Its figure, table, gaps and sensors likewise.
std::optional<Section> surroundings_section(const Subject& subject, const Options& options);

/// Every sensor over time, the time of the test as a band, the agreed limits as lines. Of a sensor with very many
/// readings the lowest and the highest of each part of the width.
Figure temperature_figure(const TemperatureSubject& subject, const Options& options);

Document compose(const TemperatureSubject& subject, const Options& options);

}  // namespace axiometry::report
