// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/simulated.h"

#include <gtest/gtest.h>

namespace axiometry {
namespace {

TEST(SimulatedPurpose, IsAPurposeInAnySpelling) {
  for (const char* purpose : {"simulation", "Simulation", "SIMULATED", "simulated", "Simuliert", "simulé", "simulée",
                              "Simulationen", " simulation ", "Simulator"})
    EXPECT_EQ(simulated_by_purpose(purpose), "found readings that were simulated, expected those of a machine")
        << purpose;
}

TEST(SimulatedPurpose, IsAskedOfAPurposeThatSpeaksOfASimulation) {
  for (const char* purpose :
       {"Simulated test", "essai simulé", "Maschinensimulation", "comparison with the simulation",
        "Simulationsabgleich", "simulation-check"})
    EXPECT_EQ(simulated_by_purpose(purpose),
              std::string("found the purpose \"") + purpose +
                  "\", which speaks of a simulation, expected readings of a machine");
}

TEST(SimulatedPurpose, IsNoOtherPurpose) {
  for (const char* purpose : {"", "acceptance", "Abnahme", "réception", "check after repair", "simultaneous motion",
                              "Simultanbetrieb"})
    EXPECT_FALSE(simulated_by_purpose(purpose)) << purpose;
}

TEST(SimulatedPurpose, MarksAMachineOnce) {
  EXPECT_EQ(simulated_machine(""), "Simulator");
  EXPECT_EQ(simulated_machine("Mill"), "Mill (simulated)");
  EXPECT_EQ(simulated_machine(simulated_machine("Mill")), "Mill (simulated)");
}

}  // namespace
}  // namespace axiometry
