// SPDX-License-Identifier: Apache-2.0
//
// The mean deviations by the contributors of Annex A, against tests/uncertainty_oracle.py, which writes each equation
// out for the length at the target.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "axiometry/standards/iso230_2/uncertainty/annex_a.h"
#include "tests/support/golden_csv.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing_support::golden_rows;
using testing_support::RunDeviations;

struct StatedOfAxis {
  double calibration_um, calibration_um_per_m;
  CalibrationSum sum;
  double misalignment_mm, expansion, temperature_range, temperature_difference, expansion_range, variation_um;
};

/// As ANNEX_A of the oracle.
constexpr std::array<StatedOfAxis, 3> stated_of_axes = {
    {{0.7, 2, CalibrationSum::linear, 2, 12, 0.7, 5, 2, 1.7},
     {0.7, 2, CalibrationSum::quadratic, 0.5, 11, 0.2, -3, 1.5, 0.4},
     {0, 3.4, CalibrationSum::linear, 4, 10.5, 1, 0, 2, 0}}};

AnnexA annex_a_of(const StatedOfAxis& stated, double datum_mm) {
  Metadata m;
  AnnexAInputs& in = m.uncertainty;
  in.device_calibration = Deviation::native(stated.calibration_um);
  in.device_calibration_per_length = RelativeLength::um_per_m(stated.calibration_um_per_m);
  in.device_calibration_sum = stated.sum;
  in.misalignment = Length::mm(stated.misalignment_mm);
  in.machine_expansion = ExpansionCoefficient::um_per_m_K(stated.expansion);
  in.machine_temperature_range = TemperatureDifference::kelvin(stated.temperature_range);
  in.machine_temperature_difference = TemperatureDifference::kelvin(stated.temperature_difference);
  in.machine_expansion_range = ExpansionCoefficient::um_per_m_K(stated.expansion_range);
  in.environmental_variation = Deviation::native(stated.variation_um);
  m.nde.datum = Position::native(datum_mm);
  const std::vector<RunDeviations> runs(5, {0.0, 1.0, 2.0, 3.0, 4.0});
  const Series series = testing_support::make_series({0, 111.25, 480, 1000, 1751}, runs, runs);
  return annex_a(m, series, evaluate(series)).value();
}

TEST(GoldenAnnexAPositions, FollowTheEquationsForTheLengthAtTheTarget) {
  for (const auto& row : golden_rows("uncertainty/annex_a_positions.csv")) {
    const AnnexA annex = annex_a_of(stated_of_axes.at(static_cast<std::size_t>(row[0])), row[1]);
    const auto found =
        std::ranges::find_if(annex.positions, [&](const auto& p) { return p.target.in_native() == row[2]; });
    ASSERT_NE(found, annex.positions.end());
    const auto expect_close = [&](double got, double expected, std::string_view what) {
      EXPECT_NEAR(got, expected, 1e-13 * expected + 1e-300) << what << ", case " << row[0] << ", target " << row[2];
    };
    constexpr std::array<std::string_view, 4> keys = {"device", "misalignment", "m_machine", "e_machine"};
    for (std::size_t k = 0; k < annex.budget.size(); ++k)
      for (std::size_t column = 0; column < keys.size(); ++column)
        if (annex.budget[k].key == keys[column])
          expect_close(found->contributions[k].value().in_native(), row[3 + column], keys[column]);
    expect_close(found->up.value().U.in_native(), row[7], "U of the mean up");
    expect_close(found->down.value().U.in_native(), row[7], "U of the mean down");
    expect_close(found->mean.value().U.in_native(), row[8], "U of the mean of both");
  }
}

}  // namespace
}  // namespace axiometry::iso230_2
