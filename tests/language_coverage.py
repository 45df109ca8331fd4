#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the phrase books of all languages but English cover what the program may say.

Reads the string literals of the sources that compose findings, notes and reports, cuts them at their places, and reports
every longer piece that stands in no English phrase of the files of pairs (language_pairs.py), which have the same ones. With
PROGRAM it also makes every document in every language (language_documents.py) and asks the workbench for things it refuses
(language_refusals.py), and reports the English words that are left. Exits with 1 if there is one.

    python3 tests/language_coverage.py [PROGRAM]
"""
import os
import pathlib
import re
import sys

import language_documents
import language_pairs
import language_refusals

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = [
    "capture/capture_result.cpp", "capture/stop_lengths.cpp", "app/recordings/length_capture.cpp", "app/recordings/stop_notes.cpp", "capture/target_matcher.cpp",
    "capture/values/still_values.cpp", "capture/values/value_listener.cpp", "app/recordings/motion_listener.cpp", "app/live/disk/stop_marks.cpp",
    "app/volumetric/singles/assemble_singles.cpp", "app/volumetric/gathered_lengths.cpp", "app/volumetric/part_lengths.cpp", "app/volumetric/part_stops.cpp", "app/volumetric/planned_points.cpp", "standards/readings/artefact.cpp",
    "standards/iso230_2/assessment/assessment.cpp", "standards/iso230_2/rules/findings.cpp", "standards/iso230_2/uncertainty/gum.cpp",
    "standards/iso230_2/inputs/inputs_items.cpp", "standards/iso230_2/periodic/findings.cpp",
    "standards/rules/comparison.cpp", "standards/rules/comparison.h", "standards/rules/export_lists.cpp", "standards/rules/gb_t_38614_2020.cpp",
    "standards/rules/jis_b_0182_1993.cpp", "standards/rules/jis_b_6201.cpp", "standards/rules/rule.cpp", "standards/rules/rule_values.cpp",
    "standards/rules/rule_values.h", "standards/rules/two_sigma_figures.cpp", "standards/rules/vdi_dgq_3441.cpp", "report/documents/rules_document.cpp",
    "report/temperatures/temperature_document.cpp", "report/temperatures/temperature_figure.cpp", "report/figures/mean_deviations.cpp",
    "standards/environment/environment.cpp", "standards/iso230_2/rules/environment_findings.cpp",
    "formats/temperatures/log_columns.cpp", "formats/temperatures/temperature_log.cpp",
    "app/temperatures/evaluated_temperatures.cpp", "app/workbench/from_archive/kept_temperatures.cpp",
    "compensation/compensated_positions.cpp", "report/sections/known_positions.cpp",
    "standards/iso230_2/plan/rules.cpp", "standards/iso230_2/programme.cpp",
    "standards/iso230_2/rules/conditions.cpp", "standards/iso230_2/rules/lines.cpp",
    "standards/iso230_2/rules/programme.cpp", "standards/iso230_2/rules/report.cpp",
    "standards/iso230_2/uncertainty/annex_a.cpp", "standards/readings/reading_correction.cpp", "standards/readings/station_offset.cpp",
    "standards/readings/station_offset.h", "standards/readings/test_air.cpp", "tracking/lines/line_attempt.cpp", "tracking/lines/line_metadata.cpp",
    "tracking/station/station_misreading.cpp", "tracking/station/station_surface.cpp", "tracking/geometry/visibility.cpp",
    "report/documents/lines_document.cpp", "report/documents/lines_sections.cpp", "report/documents/multilateration_document.cpp",
    "report/documents/tracking_sheet.cpp", "report/documents/periodic_document.cpp", "report/documents/periodic_values.cpp",
    "report/figures/layout/layout.cpp", "report/figures/layout/layout_of.cpp", "report/figures/residuals.cpp",
    "report/figures/tracking/lines_overview.cpp", "report/figures/tracking/length_difference.cpp", "report/figures/periodic.cpp",
    "report/method_values.cpp", "report/conformity_text.cpp", "report/correction_text.cpp", "report/documents/plan_sheet.cpp",
    "app/compensate/measured_state.cpp", "app/workbench/compensations/compensations.cpp", "app/workbench/compensations/compensation_standing.cpp", "app/workbench/kept_records.cpp", "compensation/fit.cpp", "compensation/grid.cpp", "compensation/suspicions.cpp",
    "model/axis_correction.cpp", "nc/axis_table.cpp", "nc/table_text.cpp", "nc/compensations/fanuc_reading.cpp",
    "nc/compensations/increments.cpp", "nc/compensations/linuxcnc_lines.cpp", "nc/compensations/siemens_lines.cpp",
    "report/documents/compensation_document.cpp", "report/figures/compensation_curves.cpp", "report/documents/volumetric_document.cpp",
    "app/dynamics/dynamic_reports.cpp",
    "app/tracking/polar_report.cpp", "app/tracking/tracker_list.cpp",
    "app/error_motions/motion_tables.cpp", "app/error_motions/motion_reports.cpp", "report/figures/axis_motion.cpp",
    "formats/csv/csv_columns.cpp", "formats/csv/csv_long_contradictions.cpp", "formats/csv/csv_long_rows.cpp", "formats/csv/csv_preamble.cpp",
    "formats/devices/camonitor_codes.cpp", "formats/devices/camonitor_log.cpp", "formats/devices/renishaw_rtl_conditions.cpp",
    "formats/devices/renishaw_rtl_runs.cpp", "formats/plan/plan_json.cpp", "formats/plan/tracking_plan_json.cpp", "formats/recording.cpp",
    "formats/recordings/line_reader.cpp", "formats/recordings/rtx_header.cpp", "formats/recordings/sample_columns.cpp",
    "formats/recordings/stamp_judge.cpp", "formats/registry.cpp", "formats/table/generic_cells.cpp", "formats/table/generic_draft.cpp",
    "formats/table/generic_read.cpp", "formats/table/generic_rules.cpp", "formats/table/generic_shape.cpp", "formats/table/generic_transposed.cpp",
    "formats/test/metadata_json.cpp", "formats/series/approaches.cpp", "formats/text/csv_cells.cpp", "formats/text/decoded_text.cpp",
    "formats/text/json_members.cpp", "formats/text/named_rows.cpp", "formats/series/series_order.cpp", "formats/text/units.cpp",
    "formats/tracking/location_points_csv.cpp", "formats/tracking/station_json.cpp", "formats/tracking/tracking_setup_json.cpp",
    "formats/volumetric/machine_json.cpp", "formats/volumetric/true_errors_json.cpp", "formats/volumetric/volumetric_plan_json.cpp",
    "formats/volumetric/volumetric_result_json.cpp", "model/fields.cpp", "model/motion_series.cpp", "model/plan.cpp", "model/series.cpp",
    "app/cases/expression.cpp", "app/convert/convert.cpp", "app/evaluate/correction_text.cpp",
    "app/evaluate/drift_recording.cpp", "app/evaluate/evaluate.cpp", "app/evaluate/tolerance_table.cpp",
    "app/evaluate/tolerance_text.cpp", "app/files/amount_text.cpp", "app/files/number_list.cpp",
    "app/files/store_address.cpp", "app/live/runs/marks_of_run.cpp", "app/live/runs/recording_spared.cpp",
    "app/live/service/capture_service.cpp", "app/live/sources/capture_source.cpp",
    "app/live/sources/live_source.cpp", "app/live/sources/simulated_lengths.cpp",
    "app/plan/nc_program.cpp", "app/recordings/capture_session.cpp", "app/recordings/raw_log.cpp",
    "app/results/outputs.cpp", "app/studies/lee_experiments.cpp", "app/tracking/evaluate_options.cpp",
    "app/tracking/tracking_request.cpp", "app/volumetric/identify_options.cpp",
    "app/workbench/calibrations/calibration_evaluation.cpp", "app/workbench/measured_file.cpp", "app/workbench/workbench.cpp",
    "app/workbench/workbench_state.cpp", "capture/dynamics/motion_course.cpp", "digest/time_stamp.cpp",
    "nc/compensations/mitsubishi.cpp", "nc/word_program.cpp", "simulation/instrument_errors.cpp",
    "simulation/record.cpp", "simulation/timeline.cpp", "simulation/tracked_machine.cpp",
    "simulation/tracked_machine_check.cpp", "simulation/virtual_axis.cpp", "standards/error_motions/squareness.cpp",
    "standards/iso230_2/inputs/inputs.cpp", "standards/iso230_2/periodic/periodic.cpp",
    "standards/readings/air_refraction.cpp", "standards/readings/thermal_expansion.cpp",
    "store/database/connection.cpp", "store/proof/seal.cpp", "tracking/lines/seven_lines.cpp",
    "uncertainty/correlation.cpp", "uncertainty/monte_carlo.cpp", "uncertainty/propagate.cpp",
]
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)+\'', re.S)
SHORTEST = 12  # characters of a piece that says something by itself
NOT_FOR_READERS = re.compile(r"^[\w.:/<>-]*$|^#include|^axiometry/|^instrument\.|TOOL$|^Lee et al$")
# Places, and what a place may hold as well: symbols, numbers, units.
PLACE = re.compile(r"\{[^}]*\}|\b[A-Za-z]_[\w,]+|(?<![\w.])\w(?![\w.])|\d+(?:[.,]\d+)?|°C?|\bmm\b|µm|[ΔθαR]\(?|[−+=/%·]")


def literals(path):
    """Neighbouring literals as one, unescaped."""
    text = re.sub(r"^\s*#include.*$", "", path.read_text(encoding="utf-8"), flags=re.M)
    found, current, done = [], None, 0
    for match in TOKEN.finditer(text):
        if text[done:match.start()].strip() and current is not None:
            found.append(current)
            current = None
        done = match.end()
        if match.group(0).startswith('"'):
            current = (current or "") + match.group(0)[1:-1]
    if current is not None:
        found.append(current)
    return [re.sub(r"\\u([0-9a-fA-F]{4})", lambda m: chr(int(m.group(1), 16)), s).replace('\\"', '"') for s in found]


def blanks(text):
    return text.replace("\u00a0", " ")


def main(program=None):
    lower = "\n".join(PLACE.sub("\0", phrase) for phrase in map(blanks, language_pairs.program_pairs("de"))).lower()
    missing = []
    for name in SOURCES:
        for literal in literals(ROOT / "src/axiometry" / name):
            for piece in re.split("\0|(?<=[.)]) (?=[A-Z])", PLACE.sub("\0", blanks(literal))):
                piece = piece.strip(" ,;:.()")
                if len(piece) < SHORTEST or NOT_FOR_READERS.match(piece):
                    continue
                if piece.lower() not in lower:
                    missing.append(f"{name}: {piece}")
    for line in missing:
        print(line)
    if missing:
        print(f"{len(missing)} pieces are in no phrase")
    left = language_documents.english_words(program) + language_refusals.english_refusals(program) if program else []
    for line in left:
        print(line)
    if left:
        print(f"{len(left)} texts hold English words")
    is_covered = not missing and not left
    print(f"{', '.join(language_documents.LANGUAGES)}: {'ok' if is_covered else 'not ok'}")
    return 0 if is_covered else 1


if __name__ == "__main__":
    sys.exit(main(*map(os.path.abspath, sys.argv[1:2])))
