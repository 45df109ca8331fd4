#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Derives the polynomials of src/axiometry/numeric/random/normal_polynomials.h with 60 digits and prints them.

Each is the value at zero and a Chebyshev fit (close to the best one) of what is left; the error printed is that of
the rounded coefficients, relative, over the whole range.
"""
import struct

from mpmath import chebyfit, cos, log, mp, mpf, pi, polyval, sin, sqrt

mp.dps = 60


def to_single(x):
    return mpf(struct.unpack("f", struct.pack("f", float(x)))[0])


def to_double(x):
    return mpf(float(x))


def logarithm(z):  # −2 ln m ÷ s, where s = (m − 1)/(m + 1) and z = s²
    s = sqrt(z)
    return -2 * log((1 + s) / (1 - s)) / s if z > mpf(10) ** -40 else mpf(-4) - mpf(4) / 3 * z


def sine(z):  # sin(π/2 w) ÷ w, where z = w²
    w = sqrt(z)
    return sin(pi / 2 * w) / w if w else pi / 2


def cosine(z):  # cos(π/2 w)
    return cos(pi / 2 * sqrt(z))


def fit(function, end, count, rounded):
    first = function(mpf(0))
    tiny = mpf(10) ** -18
    rest = chebyfit(lambda z: (function(z + tiny) - first) / (z + tiny), [0, end], count - 1)
    coefficients = [rounded(first)] + [rounded(c) for c in reversed(rest)]
    grid = [end * k / 2000 for k in range(2001)]
    error = max(abs(polyval(coefficients[::-1], z) / function(z) - 1) for z in grid)
    return coefficients, error


def main():
    root = sqrt(mpf(2))
    log_end = ((root - 1) / (root + 1)) ** 2
    for name, rounded, digits, counts in (("double", to_double, 17, (8, 7, 8)), ("float", to_single, 9, (4, 4, 5))):
        for label, function, end, count in zip(("logarithm", "sine", "cosine"), (logarithm, sine, cosine),
                                               (log_end, mpf(1) / 4, mpf(1) / 4), counts):
            coefficients, error = fit(function, end, count, rounded)
            print(f"{name} {label}: relative error {mp.nstr(error, 3)}")
            print("  " + ", ".join(float(c).hex() for c in coefficients))
            print("  " + ", ".join(f"{float(c):.{digits}g}" for c in coefficients))


if __name__ == "__main__":
    main()
