// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/app/results/experiment.h"
#include "axiometry/standards/error_motions/motion_estimate.h"
#include "axiometry/volumetric/singles/single_errors.h"

/// The use case "from single measurements of a machine's errors to the model of its volume".
namespace axiometry::app {

struct SingleItem {
  std::string name;                                                  ///< "EYX", "C0Y"
  std::string file;                                                  ///< file of readings; empty for a number
  std::optional<error_motions::InstrumentUncertainty> instrument{};  ///< uncertainty of the instrument, in µm or µrad
  double urad = 0.0;                                                 ///< squareness that is a number
  double U_urad = 0.0;                                               ///< k = 2
  std::optional<std::string_view> bytes{};  ///< those of `file` where they are at hand; they must outlive the call
};

/// Where the axes stood while one of them was measured, and with which of the machine's tools.
struct SingleStand {
  Vector3 axes_mm;
  std::string tool;                     ///< empty: the only one
  volumetric::Approaches approaches{};  ///< direction in which the others came to rest there; 0: not stated
};

struct AssembleRequest {
  std::string machine;  ///< file of the machine
  std::vector<SingleItem> items;
  std::array<std::optional<SingleStand>, 3> stands{};            ///< places of X, Y, Z
  volumetric::Reversal reversal = volumetric::Reversal::curves;  ///< how directions are modelled; none: means of both
  std::optional<std::string_view> machine_bytes{};               ///< bytes of `machine`; none: the file is opened
  std::stop_token stop{};                                        ///< nobody waits for it any more
};

struct AssembledItem {
  std::string name;
  std::string file;        ///< empty of squareness as a number
  std::string sha256;      ///< hash of the file; empty of squareness as a number
  std::size_t runs = 0;    ///< likewise 0; of squareness the larger of both lines
  double u_largest = 0.0;  ///< largest u of its readings, or of the squareness, µm or µrad, k = 1
  std::optional<error_motions::InstrumentUncertainty> instrument{};  ///< µm or µrad: as given, or as its file states
  std::string directions{};  ///< directions of its readings: "both", "up", "down"; empty of squareness
  double reversal = 0.0;     ///< largest |up − down| of its means of both directions, µm or µrad
  std::string equipment{};   ///< maker, type and serial number of what it was measured with; empty where not named
};

struct Assembled {
  AssembleRequest request;
  std::string machine_sha256;
  std::vector<AssembledItem> items;
  std::vector<std::string> remarks;  ///< remarks on reading
  volumetric::SingleModel made;
};

/// "EYX=FILE", "C0Y=FILE", or "C0Y=VALUE,U" in µrad with U for k = 2: what begins with a number is one. Fails on
/// anything else.
Result<SingleItem> parse_single(std::string_view text);

/// "X=0,300:up,-200:down@T1", "X=0,300,-200": the axis that was measured, and how. Fails on anything else, as on a
/// direction of that axis itself.
Result<std::pair<std::size_t, SingleStand>> parse_stand(std::string_view text);

/// "X=0,300,-200@T1" and "EYX=0.4,0.5" (U = A + B·L, k = 2, of an error that is given), put where they belong. Each
/// fails on anything else and on a second one of the same axis or error.
Result<void> put_stand(std::string_view text, AssembleRequest& request);
Result<void> put_instrument(std::string_view text, AssembleRequest& request);

/// How directions may be modelled: "curves", "none". Fails on anything else.
Result<volumetric::Reversal> parse_single_reversal(std::string_view word);

/// Positioning (EXX, EYY, EZZ) from a test of the axis in any format, the others as read_motion_csv() has them or as
/// read_motion_result() reads what `axiometry straightness`, `angles` and `squareness` wrote; squareness from the last
/// of these, by its lines over the range that all errors of each axis have in common (measured_square.h). Fails, with
/// the file's name, as reading does, on an error named twice, on a file that names another error or axis, on squareness
/// whose lines do not tell its sign in the machine, on two uncertainties of one instrument, on a test of a rotary axis
/// or along another line, as single_means() and as model_of_singles().
Result<Assembled> assemble_singles(const AssembleRequest& request);

/// The 21 errors, and as JSON everything, with the member "model" that `volumetric field` and the others read.
Experiment present(const Assembled& assembled, const report::Options& options);

}  // namespace axiometry::app
