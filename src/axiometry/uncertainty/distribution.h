// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/numeric/random/random.h"

/// Probability distributions of input quantities (JCGM 101:2008, 6.4). Values are plain numbers in the unit
/// of the quantity they describe.
namespace axiometry::uncertainty {

struct Constant {
  double value = 0.0;
};
struct Normal {  ///< 6.4.7
  double mean = 0.0;
  double sd = 0.0;
};
struct StudentT {  ///< 6.4.9, scaled and shifted
  double degrees_of_freedom = 0.0;
  double location = 0.0;
  double scale = 0.0;
};
struct Uniform {  ///< 6.4.2
  double lower = 0.0;
  double upper = 0.0;
};
struct Triangular {  ///< 6.4.5, symmetric
  double lower = 0.0;
  double upper = 0.0;
};
struct Trapezoidal {  ///< 6.4.4, symmetric
  double lower = 0.0;
  double upper = 0.0;
  double beta = 0.0;  ///< top width over base width, 0 (triangular) to 1 (uniform)
};
struct Arcsine {  ///< 6.4.6, U-shaped
  double lower = 0.0;
  double upper = 0.0;
};
struct CurvilinearTrapezoid {  ///< 6.4.3, limits inexactly known: each lies within ± d
  double lower = 0.0;
  double upper = 0.0;
  double d = 0.0;
};
struct Empirical {  ///< each value equally likely; drawn with replacement; make() puts them in ascending order
  std::vector<double> values;
};

/// A distribution whose parameters make sense.
class Distribution {
 public:
  using Form = std::variant<Constant, Normal, StudentT, Uniform, Triangular, Trapezoidal, Arcsine, CurvilinearTrapezoid,
                            Empirical>;

  /// Fails on a number that is not finite, a negative sd, scale or d, degrees of freedom below 0.1 (draws could
  /// overflow), limits that are swapped (equal ones are allowed: no uncertainty), d larger than half the width,
  /// beta outside 0 to 1, no empirical value.
  static Result<Distribution> make(Form form);

  /// From words, as in "uniform -0.5 0.5": the name, then the numbers in the order of the members above.
  /// Names: constant, normal, t, uniform, triangular, trapezoidal, arcsine, ctrap, empirical.
  /// Fails as make() does, on an unknown name (naming the nearest) and on too few or too many numbers.
  static Result<Distribution> parse(std::string_view text);

  const Form& form() const { return form_; }
  std::string text() const;  ///< what parse() reads

  double mean() const;                               ///< for t with ν ≤ 1 the location, else the mean
  std::optional<double> standard_deviation() const;  ///< absent for t with ν ≤ 2 (infinite)
  std::optional<double> degrees_of_freedom() const;  ///< degrees of freedom of t; absent (infinite) for all others

  /// The same shape about zero mean.
  Distribution centred() const;

  /// Independent draws; depend on the key alone, a shorter span gets the beginning of what a longer one gets.
  /// One uniform number per draw through the inverse distribution function; two for the curvilinear trapezoid
  /// (6.4.3.4) and for t, exact for any ν: √(ν (U^(−2/ν) − 1)) cos 2πV (Bailey, Math. Comp. 62 (1994) 779),
  /// which needs no rejection, so that a draw stays at its place.
  void sample(numeric::RandomKey key, std::span<double> draws) const;

  /// The value with probability p below it; contract: 0 < p < 1.
  double quantile(double p) const;

  /// quantile(Φ(z)) without the loss of digits where Φ(z) nears 1; increases with z.
  double from_normal(double z) const;

 private:
  explicit Distribution(Form form) : form_(std::move(form)) {}
  Form form_;
};

}  // namespace axiometry::uncertainty
