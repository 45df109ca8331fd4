#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Figures of the thermal and the alignment factor with many digits, and of the mean deviations by the contributors of
Annex A, for the unit tests to be held against.

Usage: tests/uncertainty_oracle.py [--update]      checks (or writes) alignment.csv, thermal.csv and
                                                   annex_a_positions.csv below tests/golden/

Shares nothing with the program: the alignment by equations 20 and 21 of Lira & Cargill as they are printed, at 200
digits, so that their cancellation costs nothing; the thermal factor by the geometric series of 1/(1 + q), whose terms
are products of the moments of two uniform quantities. Annex A is written out for each target from what was stated, with
0.6, 0.3 and n as they are printed: nothing is scaled from a budget for the whole length.
"""
import pathlib
import sys
from decimal import Decimal, getcontext

getcontext().prec = 200
FOLDER = pathlib.Path(__file__).resolve().parent / "golden" / "uncertainty"
DIGITS = 40


def show(x):
    return f"{x:.{DIGITS - 1}e}"


def sin(x):
    term, total, k = x, x, 1
    while abs(term) > Decimal(10) ** -190 * abs(total):
        term = -term * x * x / ((k + 1) * (k + 2))
        total, k = total + term, k + 2
    return total


def cos(x):
    term, total, k = Decimal(1), Decimal(1), 0
    while abs(term) > Decimal(10) ** -190:
        term = -term * x * x / ((k + 1) * (k + 2))
        total, k = total + term, k + 2
    return total


def alignment():
    yield "theta_rad,mean_departure,sd"
    for text in ("1e-9", "3e-8", "1e-6", "2.5e-5", "1e-4", "0.0005711", "0.0017453292519943296", "0.01", "0.05", "0.1",
                 "0.3", "0.5", "0.7", "1.0", "1.2", "1.5"):
        # The program gets the nearest double, which is what is taken here too.
        theta = Decimal(float(text))
        f = sin(theta) / theta
        variance = (f * cos(theta) + 1) / 2 - f * f
        yield f"{text},{show(f - 1)},{show(variance.sqrt())}"


def moment(low, high, k):
    if low == high:
        return low ** k
    return (high ** (k + 1) - low ** (k + 1)) / ((k + 1) * (high - low))


def thermal():
    yield "alpha_m,alpha_M,dT_m,dT_M,mean_departure,sd"
    for row in (("10.53", "12.87", "-2.5", "-1.5"), ("10.53", "12.87", "-1", "1"), ("5.85", "17.55", "-1", "1"),
                ("9.9", "12.1", "1.8", "3.1"), ("11", "11", "2", "3"), ("10", "12", "0", "0"), ("10", "12", "5", "5"),
                ("10", "12", "-0.000001", "0.000001"), ("11.9999", "12.0001", "9.9999999", "10.0000001"),
                ("0.001", "24", "-30", "80"), ("5", "20", "0.5", "0.6"), ("5", "20", "-0.6", "-0.5"),
                ("100", "900", "-150", "190")):
        a, b, c, d = (Decimal(float(x)) for x in row)
        a, b = a / 10 ** 6, b / 10 ** 6
        mean = square = Decimal(0)  # of w = 1 − f_t = q − q² + q³ …, and w² = Σ (−1)^j (j − 1) q^j
        j = 1
        while True:
            q = moment(a, b, j) * moment(c, d, j)
            mean += q if j % 2 else -q
            square += (j - 1) * (q if j % 2 == 0 else -q)
            j += 1
            if j > 400 or abs(max(abs(c), abs(d)) * b) ** j < Decimal(10) ** -150:
                break
        variance = square - mean * mean
        sd = variance.sqrt() if variance > Decimal(10) ** -120 else Decimal(0)
        yield ",".join(row) + f",{show(-mean)},{show(sd)}"


# a and b of a certificate and how they are added, R of the misalignment, α, R(θ), ΔT, R(α) of the machine, E_VE
ANNEX_A = (("0.7", "2", "linear", "2", "12", "0.7", "5", "2", "1.7"),
           ("0.7", "2", "quadratic", "0.5", "11", "0.2", "-3", "1.5", "0.4"),
           ("0", "3.4", "linear", "4", "10.5", "1", "0", "2", "0"))
TARGETS_MM = ("0", "111.25", "480", "1000", "1751")
N = 5


def annex_a_positions():
    yield "case,datum_mm,target_mm,device,misalignment,m_machine,e_machine,U_up,U_mean"
    six, three = Decimal("0.6"), Decimal("0.3")
    travel = (Decimal(TARGETS_MM[-1]) - Decimal(TARGETS_MM[0])) / 1000
    for case, row in enumerate(ANNEX_A):
        a, b, R, alpha, R_theta, dT, R_alpha, E_VE = (Decimal(x) for k, x in enumerate(row) if k != 2)
        for datum in ("0", "480"):
            for target in TARGETS_MM:
                l = abs(Decimal(target) - Decimal(datum)) / 1000
                device = a + b * l if row[2] == "linear" else (a * a + b * b * l * l).sqrt()
                run_off = R * l / travel  # over l, at the angle that gives R over the travel
                misalignment = three * run_off * run_off / l if l else Decimal(0)
                m_machine, e_machine = six * alpha * l * R_theta, six * abs(dT) * l * R_alpha
                systematic = device ** 2 + misalignment ** 2 + m_machine ** 2 + e_machine ** 2
                environment = (six * E_VE) ** 2
                numbers = (device, misalignment, m_machine, e_machine, (systematic + environment / N).sqrt(),
                           (systematic + environment / (2 * N)).sqrt())
                yield f"{case},{datum},{target}," + ",".join(show(x) if x else "0" for x in numbers)


def main():
    stale = 0
    for name, lines in {"alignment.csv": alignment(), "thermal.csv": thermal(),
                        "annex_a_positions.csv": annex_a_positions()}.items():
        path = FOLDER / name
        text = "\n".join(lines) + "\n"
        if "--update" in sys.argv:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            print(f"{name} differs from what tests/uncertainty_oracle.py computes")
            stale = 1
    return stale


if __name__ == "__main__":
    sys.exit(main())
