// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/report/document.h"
#include "axiometry/report/tracking.h"

/// Sections of the report of several lines that concern them together; lines_document.cpp puts them in order.
namespace axiometry::report {

/// The results of this line as those of any test, and the options fitted to it.
Subject subject_of(const AssessedLine& line);

/// One row per line, and the diagram of all.
Section overview_section(const LinesSubject& subject, const Options& options);

/// The three claims of every line, and the clauses that speak against its test.
Section lines_claim_section(const LinesSubject& subject);

/// The largest values of the diagonals, and what they do not tell. Needs a diagonal.
Section diagonal_section(const LinesSubject& subject, const Options& options);

/// Scales and squareness from the slopes. Needs evaluation.squareness.
Section squareness_section(const LinesSubject& subject, const Options& options);

/// What the uncertainty of the station does to each line, and from which distance on it may be neglected.
Section length_difference_section(const LinesSubject& subject, const Options& options);

/// Station, tool, travels, instrument, the lines that are lost, and a drawing of all that.
Section setup_section(const LinesSubject& subject, const Options& options);

bool has_diagonal(const LinesSubject& subject);

/// What the evaluation found about lengths, beam and station; nothing when it found nothing.
std::optional<Table> tracking_finding_table(std::span<const tracking::Finding> findings);

/// "0.123 mm", absent values as a dash.
std::string shown_mm(double mm, int decimals, const Options& options);

}  // namespace axiometry::report
