# SPDX-License-Identifier: Apache-2.0
"""Clause 3 of ISO 230-2 a second time, by numpy."""
import numpy as np


def by_numpy(up, down):
    """Clause 3, as the standard has it, of complete readings (..., targets, runs)."""
    mean_up, mean_down = up.mean(-1), down.mean(-1)
    s_up, s_down = up.std(-1, ddof=1), down.std(-1, ddof=1)
    width = lambda high, low: high.max(-1) - low.min(-1)  # noqa: E731
    reversal = mean_up - mean_down
    both = np.concatenate([mean_up, mean_down], -1)
    high = np.concatenate([mean_up + 2 * s_up, mean_down + 2 * s_down], -1)
    low = np.concatenate([mean_up - 2 * s_up, mean_down - 2 * s_down], -1)
    return {"A": width(high, low), "A_up": width(mean_up + 2 * s_up, mean_up - 2 * s_up),
            "A_down": width(mean_down + 2 * s_down, mean_down - 2 * s_down), "E": width(both, both),
            "E_up": width(mean_up, mean_up), "E_down": width(mean_down, mean_down),
            "M": width((mean_up + mean_down) / 2, (mean_up + mean_down) / 2),
            "R": np.maximum(np.maximum(2 * s_up + 2 * s_down + abs(reversal), 4 * s_up), 4 * s_down).max(-1),
            "R_up": 4 * s_up.max(-1), "R_down": 4 * s_down.max(-1), "B": abs(reversal).max(-1),
            "B_mean": reversal.mean(-1)}
