// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/exit_code.h"

namespace axiometry::cli {

class Verb;

/// Each adds one verb to the program; when that verb is given, its callback sets `exit_code`.
void add_evaluate(const Verb& program, int& exit_code);
void add_capture(const Verb& program, int& exit_code);
void add_uncertainty(const Verb& program, int& exit_code);
void add_convert(const Verb& program, int& exit_code);
void add_plan(const Verb& program, int& exit_code);
void add_air(const Verb& program, int& exit_code);
void add_periodic(const Verb& program, int& exit_code);
void add_straightness(const Verb& program, int& exit_code);
void add_squareness(const Verb& program, int& exit_code);
void add_angles(const Verb& program, int& exit_code);
void add_compare_rules(const Verb& program, int& exit_code);
void add_formats(const Verb& program, int& exit_code);
void add_licenses(const Verb& program, int& exit_code);
void add_schema(const Verb& program, int& exit_code);
void add_check(const Verb& program, int& exit_code);
void add_nc(const Verb& program, int& exit_code);
void add_simulate(const Verb& program, int& exit_code);
void add_serve(const Verb& program, int& exit_code);
void add_store(const Verb& program, int& exit_code);
void add_bench(const Verb& program, int& exit_code);
void add_completion(const Verb& program, int& exit_code);
void add_manual(const Verb& program, int& exit_code);
void add_tracking(const Verb& program, int& exit_code);
void add_volumetric(const Verb& program, int& exit_code);
void add_compensate(const Verb& program, int& exit_code);

}  // namespace axiometry::cli
