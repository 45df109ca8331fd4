// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/files/given_file.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/volumetric/field/error_model.h"

/// What all use cases behind an identification begin with.
namespace axiometry::app {

/// A model as it was kept, and what speaks against it.
struct KeptModel {
  volumetric::ErrorModel model;
  std::vector<NamedFinding> against;        ///< findings_against() of the result, and notes of errors measured singly
  std::string sha256 = {};                  ///< hash of its file; empty of one that is at hand as a value
  std::vector<std::string> made_from = {};  ///< hashes of the files it names; empty likewise
};

/// Serious findings of a result, each under its own name and as one of what is made of it, and that it was made from
/// simulated lengths. But for errors that are not told: the model has no number for these, and who needs one says so
/// itself.
std::vector<NamedFinding> findings_against(std::span<const KeptFinding> of_result);

/// Remarks of `axiometry volumetric assemble`, as notes: what its uncertainties and means do not hold, nothing that is
/// made of them holds. Names of errors with the same remark stand together. Nothing of other results.
std::vector<NamedFinding> remarks_of_singles(const json::Value& result);

bool is_of_singles(const json::Value& result);  ///< whether a result is one of that verb
/// The same of a list of such remarks that stands alone. Contract: an array.
std::vector<NamedFinding> notes_of_remarks(const json::Value& remarks);

/// For the head of a file that goes to a control: one sentence in ASCII that names what speaks seriously against the
/// result, by the findings' names, or says that nobody measured it. Empty where nothing does.
std::string warning_of(std::span<const NamedFinding> against);

/// Before the others.
void put_first(std::span<const NamedFinding> against, std::vector<NamedFinding>& findings);

/// Of a file of `axiometry volumetric identify --out`. Fails as formats::read_error_model(), with the file's name.
Result<KeptModel> kept_model(const std::string& file);
Result<KeptModel> kept_model(const GivenFile& file);  ///< the same of bytes that are at hand

/// Index of the tool; an empty name is the only one there is. Fails with the names there are.
Result<std::size_t> tool_of_model(const volumetric::ErrorModel& model, std::string_view name);

}  // namespace axiometry::app
