// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::cli {

class Verb;

/// Each adds one verb below `axiometry tracking`; when it is given, its callback sets `exit_code`.
void add_tracking_locate(const Verb& tracking, int& exit_code);
void add_tracking_plan(const Verb& tracking, int& exit_code);
void add_tracking_evaluate(const Verb& tracking, int& exit_code);
void add_tracking_simulate(const Verb& tracking, int& exit_code);
void add_tracking_length_difference(const Verb& tracking, int& exit_code);
void add_tracking_multilaterate(const Verb& tracking, int& exit_code);
void add_tracking_polar(const Verb& tracking, int& exit_code);
void add_tracking_compare_methods(const Verb& tracking, int& exit_code);
void add_tracking_instruments(const Verb& tracking, int& exit_code);

}  // namespace axiometry::cli
