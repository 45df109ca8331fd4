// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"

/// An axis whose faults are known, and the instrument that looks at it: what simulate() lets move and measures.
///
/// Every member is zero or empty until somebody wants it: a VirtualAxis{} is perfect. Deviations are µm on a linear
/// axis and ″ on a rotary one, positions mm or °. P is a target, P_1 the first and P_m the last of the plan, t the time
/// since the beginning of the test; z stands for independent standard normal numbers. In what follows d is a term of
/// the true deviation (actual minus target position), the sum of all terms.
namespace axiometry::simulation {

/// Errors of screw or scale that do not depend on time or direction.
struct PitchError {
  RelativeLength slope;               ///< d = slope · (P − P_1)
  std::vector<Deviation> polynomial;  ///< c_1, c_2, …: d = Σ c_k uᵏ with u = (P − P_1) / (P_m − P_1)

  struct Node {
    Position at;
    Deviation deviation;
  };
  std::vector<Node> table;  ///< ascending; d between nodes by a straight line, outside as at the nearest node

  /// A random curve: stationary, normal, with the correlation e^(−|ΔP|/ℓ) between two places; drawn at nodes of ℓ/8 and
  /// straight between them (which leaves 0.96 of the variance on average). One axis keeps its curve: it depends on the
  /// seed alone, not on the run.
  struct Walk {
    Deviation size;               ///< standard deviation
    Position correlation_length;  ///< ℓ
  };
  std::optional<Walk> walk;
};

/// d = amplitude · sin(2πP/period + phase).
struct CyclicError {
  Position period;
  Deviation amplitude;  ///< half of peak to valley
  Angle phase;
};

/// Play: the table stands still while the drive turns through the gap b, so that d is −b/2 after a long way ↑ and +b/2
/// after one ↓ (B_i = −b). b(P) = size + wear·exp(−((P − wear_at)/wear_width)²).
struct Backlash {
  Deviation size;
  Deviation wear;
  Position wear_at;
  Position wear_width = Position::native(1.0);  ///< width of the worn place, at least 10 times the wear
};

/// Elastic wind-up: d = −r·size/2, where r goes towards +1 (↑) or −1 (↓) as e^(−way/distance) after each reversal.
struct LostMotion {
  Deviation size;
  Position distance = Position::native(1.0);
};

/// The axis sticks before it arrives: d = −size·|z| in an approach ↑, +size·|z| in one ↓. Mean size·√(2/π), standard
/// deviation size·√(1 − 2/π).
struct StickSlip {
  Deviation up;
  Deviation down;
};

/// Thermal growth: d = growth·(1 − e^(−t/time_constant))·g, where g = (P − fixed_point)/(P_m − P_1), or 1 everywhere
/// when `everywhere` (a spindle that grows).
struct ThermalGrowth {
  Deviation growth;
  Duration time_constant = Duration::s(1.0);
  std::optional<Position> fixed_point;  ///< P_1 when absent
  bool everywhere = false;
};

/// The position follows the command as a second order system y″ + 2Dω y′ + ω² y = ω² c with ω = 2π/period: a following
/// error of 2D·v/ω while moving, then a decaying oscillation into the target, of which d is what is left at the
/// reading.
struct Servo {
  Duration period;
  double damping = 0.7;  ///< D, 0.05 to 0.95
};

/// Oscillation at rest that never ends: d = amplitude·sin(2πt/period + φ), φ random in each approach.
struct Hunting {
  Deviation amplitude;
  Duration period = Duration::s(1.0);
};

/// Faults of the instrument and of what surrounds it. They are in the readings, not in the true deviations.
struct VirtualInstrument {
  Deviation noise;                 ///< standard deviation of one reading, and of one sample of a recording; white
  Deviation drift_per_root_hour;   ///< standard deviation of the zero's random walk after an hour; steps of a second
  Deviation resolution;            ///< step of what is shown: the position is rounded to multiples of it
  double outlier_probability = 0;  ///< that a reading (the whole standstill in a recording) is off by ±outlier_size·u,
  Deviation outlier_size;          ///< u uniform between 1/2 and 3/2
  double slip_probability = 0;     ///< that a move shifts the zero for good by slip_size·z: loose optics
  Deviation slip_size;             ///< size of such a shift
  Deviation vibration;             ///< amplitude of a sinusoid of vibration_period between instrument and table
  Duration vibration_period = Duration::s(0.02);

  /// The index of air: reading error = ε(t)·(P − P_1 + dead_path), ε(t) = slow·sin(2πt/slow_period + φ) + a stationary
  /// normal process of standard deviation `random` and correlation e^(−|Δt|/random_time), drawn every eighth of it.
  struct Air {
    RelativeLength slow;
    Duration slow_period = Duration::s(900.0);
    RelativeLength random;
    Duration random_time = Duration::s(30.0);
    Position dead_path;
  };
  Air air;

  /// The machine is at `machine`, its expansion is `machine_expansion`, but the instrument corrects to 20 °C (4.1) with
  /// `assumed_expansion`: reading error = (machine_expansion − assumed_expansion)·(machine − 20 °C)·(P − P_1).
  struct Expansion {
    Temperature machine = Temperature::celsius(20.0);
    ExpansionCoefficient machine_expansion = ExpansionCoefficient::um_per_m_K(11.5);
    ExpansionCoefficient assumed_expansion = ExpansionCoefficient::um_per_m_K(11.5);
  };
  std::optional<Expansion> expansion;  ///< thermal expansion of a linear axis
};

struct VirtualAxis {
  PitchError pitch;
  std::vector<CyclicError> cyclic;
  Backlash backlash;
  LostMotion lost_motion;
  StickSlip stick_slip;
  ThermalGrowth thermal;
  std::optional<Servo> servo;
  Hunting hunting;
  Deviation resolution;         ///< step of the axis's own scale: d takes to the nearest multiple of it
  double acceleration = 500.0;  ///< mm/s² or °/s²; of beginning and end of every move
  VirtualInstrument instrument;
};

/// Fails, naming what is wrong, on a plan that is not sound, on what is not finite, negative where a size must not be,
/// or beyond any axis: deviations above 1e6 µm or ″, periods and lengths that are not above 0, more than 1e7 nodes of a
/// random curve, a wear steeper than a tenth of its width, a damping outside 0.05 to 0.95, a probability outside 0 to
/// 1, an acceleration outside 0.001 to 1e6, a faulty expansion of a rotary axis.
Result<void> check_sound(const VirtualAxis& axis, const Plan& plan);

}  // namespace axiometry::simulation
