// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "axiometry/language/language.h"

/// The phrase book of German, one table per subject in german/<subject>.cpp, sorted by the English text.
/// The words are those of DIN ISO 230-2 and of calibration certificates.
namespace axiometry::language {

extern const std::span<const Phrase> german_archive_refusals;  ///< the archive, its trail, seals and backups: refusals
extern const std::span<const Phrase> german_calibrations;      ///< calibrations in the archive
extern const std::span<const Phrase> german_capture;           ///< live captures and recordings
extern const std::span<const Phrase> german_claims;            ///< what a result may be called
extern const std::span<const Phrase> german_compensation;      ///< tables by which controls correct an axis
extern const std::span<const Phrase> german_control_tables;    ///< files of tables: refusals
extern const std::span<const Phrase> german_controls;          ///< the controls, and what is known of each
extern const std::span<const Phrase> german_corrections;  ///< corrections of readings, sources of air and temperatures
extern const std::span<const Phrase> german_error_motions;    ///< straightness, angles, squareness
extern const std::span<const Phrase> german_errors;           ///< refusals of many subjects
extern const std::span<const Phrase> german_fields;           ///< titles, descriptions and columns of the metadata
extern const std::span<const Phrase> german_figures;          ///< labels, titles, descriptions of pictures
extern const std::span<const Phrase> german_file_refusals;    ///< files of devices, tables of numbers: refusals
extern const std::span<const Phrase> german_files;            ///< files that are refused, tables that are guessed
extern const std::span<const Phrase> german_findings;         ///< what departs, what is missing, what is worth a note
extern const std::span<const Phrase> german_known_positions;  ///< positions of a table that are known
extern const std::span<const Phrase> german_length_captures;  ///< lengths of a calibration captured live
extern const std::span<const Phrase> german_length_refusals;  ///< lines and lengths: refusals
extern const std::span<const Phrase> german_measurement_refusals;  ///< programs, simulations, evaluations: refusals
extern const std::span<const Phrase> german_motion_captures;       ///< straightness and rotations captured live
extern const std::span<const Phrase> german_noise;                 ///< kinds of the environment's noise
extern const std::span<const Phrase> german_periodic;              ///< periodic positioning errors
extern const std::span<const Phrase> german_plan;                  ///< plan sheets and plan findings
extern const std::span<const Phrase> german_plan_refusals;       ///< plans, tests in JSON, series of readings: refusals
extern const std::span<const Phrase> german_profile;             ///< import profiles
extern const std::span<const Phrase> german_recording_refusals;  ///< continuous recordings: refusals
extern const std::span<const Phrase> german_report;              ///< titles, heads and notes of the report
extern const std::span<const Phrase> german_requests;            ///< requests to the workbench
extern const std::span<const Phrase> german_retests;     ///< what speaks against the test of a table, what proves it
extern const std::span<const Phrase> german_rules;       ///< the same readings by other rules
extern const std::span<const Phrase> german_scatter;     ///< outliers, uneven scatter, shifts of the runs
extern const std::span<const Phrase> german_service;     ///< the archive and its server
extern const std::span<const Phrase> german_simulation;  ///< faults of the simulated axis
extern const std::span<const Phrase> german_station;     ///< stations, multilateration, length differences
extern const std::span<const Phrase> german_station_refusals;   ///< stations, angles, ranges: refusals
extern const std::span<const Phrase> german_temperatures;       ///< a temperature log about a test
extern const std::span<const Phrase> german_terminal;           ///< summaries in a terminal
extern const std::span<const Phrase> german_terms;              ///< single words: parameters, verdicts, roles, units
extern const std::span<const Phrase> german_tracking;           ///< lines from a tracking interferometer
extern const std::span<const Phrase> german_tracking_findings;  ///< what plan, station and lengths tell
extern const std::span<const Phrase> german_tracking_requests;  ///< requests about a tracking interferometer
extern const std::span<const Phrase> german_uncertainty;        ///< Annex A, GUM, Monte Carlo, budgets
extern const std::span<const Phrase> german_verb_refusals;      ///< commands, options, requests: refusals
extern const std::span<const Phrase> german_volume_files;       ///< files of volume, straightness, angles, simulations
extern const std::span<const Phrase> german_volume_plan;  ///< plans of volumetric calibrations, requests about them
extern const std::span<const Phrase> german_volume_recordings;    ///< lengths of a calibration out of several files
extern const std::span<const Phrase> german_volume_refusals;      ///< volumetric calibrations: further refusals
extern const std::span<const Phrase> german_volume_report;        ///< figures, field, predictions, tables of a volume
extern const std::span<const Phrase> german_volumetric_findings;  ///< what lengths of a whole machine tell

/// All of them.
std::span<const std::span<const Phrase>> german_tables();

}  // namespace axiometry::language
