// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/fields.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "axiometry/report/shown_targets.h"
#include "axiometry/standards/iso230_2/rules/claims.h"

/// The sections of a report, one source each. compose() puts them together.
namespace axiometry::report {

/// Title, identity, status and everything that runs along on each page.
Document title_page(const Subject& subject, const Options& options);

/// Customer, place, inspector and instrument, each where it was given.
std::vector<Fact> further_identity(const Metadata& metadata);

/// What conforms to its tolerance and what does not, and the rule; nothing when no tolerance was given.
std::optional<Notice> tolerance_notice(const Subject& subject, const Options& options);

/// Every decision with its limits, probability and risk, the rule in words, and the figure of it. Without blocks when
/// no tolerance was given.
Section conformity_section(const Subject& subject, const Options& options);
TableCell verdict_cell(uncertainty::Verdict verdict);

/// Parameters of clause 8.2 with their uncertainty, tolerances and verdicts.
Section parameter_section(const Subject& subject, const Options& options);

/// Figures 2 and 3.
Section figure_section(const Subject& subject, const Options& options);

/// What may be said of the result with the name of the standard, and what speaks against it.
Section claim_section(const Subject& subject, const Options& options);

Section finding_section(std::span<const iso230_2::Finding> findings);

/// A finding as a sentence with its clause behind it, for the first page.
RichText finding_line(const iso230_2::Finding& finding);

/// Of several tests in one report: what was found in all the same way is told once, with the names of all.
struct NamedFindings {
  std::string_view name;
  std::span<const iso230_2::Finding> findings;
};
Section finding_section(std::span<const NamedFindings> tests);

/// Clause 8.1, read from the table of metadata fields. It refers to Table 2 where the document lists the targets there.
Section identification_section(const Subject& subject, bool lists_targets, const Options& options);

/// Table 2: every reading, before and after a correction where there was one, and the results at every target.
Section position_section(const Subject& subject, const Options& options);
/// Of the targets that are shown: with a note where others are left out.
std::vector<Table> reading_tables(const Series& series, const ShownTargets& shown, AxisKind kind,
                                  std::string_view title, const Options& options);
void note_left_out(Table& table, const ShownTargets& shown);

/// Annex A. Nothing but a remark when no input of it was given.
Section uncertainty_section(const Subject& subject, const Options& options);

/// What was asked for beside Annex A: the question that is answered, the methods side by side, histograms, and how it
/// was found. For assessments with a GUM or Monte Carlo result only, as the next two.
Section method_section(const Subject& subject, const Options& options);

/// What each input contributes and what to improve first; the inputs with their distributions.
Section contribution_section(const Subject& subject, const Options& options);
Table contribution_table(const std::vector<iso230_2::Contribution>& all, const Subject& subject,
                         const Options& options);
Table input_table(const Subject& subject, const Options& options);

/// The GUM's budget of the parameters and its components at every target. Only where it was run.
Section gum_section(const Subject& subject, const Options& options);

/// The slope of the means and the drift of the readings, which the evaluation leaves where they are.
Section information_section(const Subject& subject, const Options& options);

/// Where the readings come from and what was done to them.
Section provenance_section(const Subject& subject, const Options& options);

/// Who made the test, who answers for the report, and where both sign; what the results hold for.
Section release_section(const Metadata& metadata);

/// A field to be filled in by hand.
TableCell to_fill_in();

/// A number as a cell, or a quiet dash where there is none.
TableCell deviation_cell(const std::optional<Deviation>& deviation, const Options& options);
TableCell quiet_cell(std::string_view text);
TableCell text_cell(std::string_view text);
TableCell verbatim_cell(std::string_view text);  ///< words of the user
RichText strong_verbatim(std::string_view text);

/// A field's value with its unit, quietly "not stated" where it was not given.
TableCell stated(const Field& field, const Metadata& metadata, const Options& options);
TableCell stated(std::string_view field_key, const Metadata& metadata);

}  // namespace axiometry::report
