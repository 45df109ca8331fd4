// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace axiometry::cli {

/// Each adds one verb below `axiometry tracking`; when it is given, its callback sets `exit_code`.
void add_tracking_locate(CLI::App& tracking, int& exit_code);
void add_tracking_plan(CLI::App& tracking, int& exit_code);
void add_tracking_evaluate(CLI::App& tracking, int& exit_code);
void add_tracking_simulate(CLI::App& tracking, int& exit_code);
void add_tracking_length_difference(CLI::App& tracking, int& exit_code);
void add_tracking_multilaterate(CLI::App& tracking, int& exit_code);

}  // namespace axiometry::cli
