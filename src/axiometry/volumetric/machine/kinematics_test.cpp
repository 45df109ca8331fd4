// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/machine/kinematics.h"

#include <gtest/gtest.h>

#include <random>

namespace axiometry::volumetric {
namespace {

MachineModel machine_of(const char* chain) { return {.chain = KinematicChain::make(chain).value()}; }

ErrorValues only(ErrorMotion error, double value) {
  ErrorValues errors;
  errors.motions[error.axis][error.motion] = value;
  return errors;
}

void expect_vector(Vector3 found, Vector3 expected, double within) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], within) << "XYZ"[k];
}

// Validation: the component formulas of FXYZ written out, one error at a time.
TEST(Kinematics, GivesTheComponentFormulasOfABridge) {
  const MachineModel machine = machine_of("FXYZ");
  const Vector3 q{300.0, 200.0, -100.0}, t{50.0, -20.0, -150.0};
  const auto delta = [&](const char* name) {
    return displacement_um(machine, only(*error_motion_named(name), 10.0), q, t);
  };
  const double y = 0.2, z = -0.1, tx = 0.05, ty = -0.02, tz = -0.15;  // m: 10 µrad times these
  expect_vector(delta("EXY"), {10.0, 0.0, 0.0}, 1e-12);
  expect_vector(delta("EAX"), {0.0, -10.0 * (z + tz), 10.0 * (y + ty)}, 1e-12);
  expect_vector(delta("EBX"), {10.0 * (z + tz), 0.0, -10.0 * tx}, 1e-12);
  expect_vector(delta("ECX"), {-10.0 * (y + ty), 10.0 * tx, 0.0}, 1e-12);
  expect_vector(delta("EBY"), {10.0 * (z + tz), 0.0, -10.0 * tx}, 1e-12);
  expect_vector(delta("ECY"), {-10.0 * ty, 10.0 * tx, 0.0}, 1e-12);
  expect_vector(delta("EAZ"), {0.0, -10.0 * tz, 10.0 * ty}, 1e-12);
}

TEST(Kinematics, TurnsTheAxesBySquareness) {
  const MachineModel machine = machine_of("XFYZ");
  const Vector3 q{300.0, 200.0, -100.0};
  const auto delta = [&](Squareness which) {
    ErrorValues errors;
    errors.squareness_urad[static_cast<std::size_t>(which)] = 10.0;
    const Vector3 first_order = displacement_um(machine, errors, q, {});
    expect_vector(displacement_exact_um(machine, errors, q, {}), first_order, 1e-4);
    return first_order;
  };
  expect_vector(delta(Squareness::C0Y), {-2.0, 0.0, 0.0}, 1e-12);
  expect_vector(delta(Squareness::B0Z), {-1.0, 0.0, 0.0}, 1e-12);
  expect_vector(delta(Squareness::A0Z), {0.0, 1.0, 0.0}, 1e-12);
}

// A table that moves along X turns with its error: the point at x on it is moved by the lever x.
TEST(Kinematics, LetsTheWorkpieceTurnWithItsTable) {
  const MachineModel table = machine_of("XFYZ"), bridge = machine_of("FXYZ");
  const ErrorValues yaw = only(*error_motion_named("ECX"), 10.0);
  const Vector3 q{500.0, 0.0, 0.0};
  expect_vector(displacement_um(bridge, yaw, q, {}), {}, 1e-12);
  expect_vector(displacement_um(table, yaw, q, {}), {0.0, 5.0, 0.0}, 1e-12);
  expect_vector(displacement_exact_um(table, yaw, q, {}), {0.0, 5.0, 0.0}, 1e-4);
}

TEST(Kinematics, IsToFirstOrderWhatTransformationsAre) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> one(-1.0, 1.0);
  for (const char* chain : {"FXYZ", "XFYZ", "YXFZ", "XYZF", "ZFYX", "FZXY"}) {
    MachineModel machine = machine_of(chain);
    machine.functional_point_mm[1] = {100.0, -50.0, 20.0};
    for (int k = 0; k < 50; ++k) {
      ErrorValues errors;
      for (auto& axis : errors.motions)
        for (double& e : axis) e = 50.0 * one(random);
      for (double& e : errors.squareness_urad) e = 50.0 * one(random);
      const Vector3 q{500.0 * one(random), 500.0 * one(random), 500.0 * one(random)};
      const Vector3 t{100.0 * one(random), 100.0 * one(random), -200.0};
      // Products of two errors: at most some 50 µrad · 50 µrad · 1 m and 50 µrad · 50 µm of each pair.
      expect_vector(displacement_um(machine, errors, q, t), displacement_exact_um(machine, errors, q, t), 0.02);
    }
  }
}

TEST(Kinematics, NamesTheErrorsAsTheStandardDoes) {
  EXPECT_EQ(error_names()[0], "EXX");
  EXPECT_EQ(error_names()[1], "EYX");
  EXPECT_EQ(error_names()[17], "ECZ");
  EXPECT_EQ(error_names()[18], "C0Y");
  EXPECT_EQ(error_names()[20], "A0Z");
  EXPECT_EQ(error_kind(*error_motion_named("EAX")), "roll");
  EXPECT_EQ(error_kind(*error_motion_named("EBX")), "pitch");
  EXPECT_EQ(error_kind(*error_motion_named("ECY")), "yaw");
  EXPECT_EQ(error_kind(*error_motion_named("ECZ")), "roll");
  EXPECT_FALSE(error_motion_named("EXA"));
}

}  // namespace
}  // namespace axiometry::volumetric
