#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The model of a machine out of errors that were measured one by one, made without the program.

From readings in both directions or one, with the kinematics and formulas of docs/theory/volumetric.md ("Measured singly") and
numpy: every coefficient, their covariance, and the directions of coefficients of which nothing is told.
"""
import itertools

import numpy as np

NAMES = [f"E{m}{a}" for a in "XYZ" for m in "XYZABC"]
SQUARES = {"C0Y": ("EXY", "EYX", -1.0), "B0Z": ("EXZ", "EZX", 1.0), "A0Z": ("EYZ", "EZY", -1.0)}
LOWER, UPPER = np.array([0.0, -100.0, -500.0]), np.array([900.0, 500.0, -80.0])
TOLD_MOST = 1e-6


def axis_of(name):
    return "XYZ".index(name[2])


def motion_of(name):
    return "XYZABC".index(name[1])


# --- the machine


def levers(machine, q, tool):
    """r_a of each axis: what lies behind it in the chain moves its lever, and of a table its own way."""
    order, carried = [c for c in machine["chain"] if c != "F"], machine["chain"].split("F")[0]
    r = np.array([machine["tools"][tool] - machine["functional"][a] for a in range(3)])
    for k, letter in enumerate(order):
        a = "XYZ".index(letter)
        for b in ["XYZ".index(c) for c in order[k + 1:]] + ([a] if letter in carried else []):
            r[a][b] += q[b]
    return r


def measured_place(machine, a, at):
    q = machine["stood"][a].copy()
    q[a] = at
    return q


def displaced(e, squares, machine, q, tool):
    """δ of motions e[axis][6], to first order."""
    r = levers(machine, q, tool)
    c, b, a = squares
    d = 1e-3 * np.array([-c * q[1] + b * q[2], -a * q[2], 0.0])
    return d + sum(e[k][:3] + 1e-3 * np.cross(e[k][3:], r[k]) for k in range(3))


# --- straight lines between positions


def line_of(q, y):
    """Mean, and slope per mm of the best straight line, of the curve from position to position: Simpson's rule is exact."""
    q, y = np.asarray(q), np.asarray(y)
    h, middle, length = np.diff(q), 0.5 * (q[0] + q[-1]), q[-1] - q[0]
    mean = np.sum(h * (y[1:] + y[:-1]) / 2) / length
    x, xm, ym = q - middle, (q[1:] + q[:-1]) / 2 - middle, (y[1:] + y[:-1]) / 2
    return mean, np.sum(h / 6 * (x[:-1] * y[:-1] + 4 * xm * ym + x[1:] * y[1:])) * 12 / length**3


def slope_within(q, y, lower, upper):
    """µrad, of the part of a curve in µm between two places."""
    at = np.concatenate([[lower], [x for x in q if lower + 1e-6 < x < upper - 1e-6], [upper]])
    return 1e3 * line_of(at, np.interp(at, q, y))[1]


# --- the model out of what was read


class Model:
    """`read`: name → positions, means and halves (None in one direction) with their covariance; `squares`: name → what was
    measured; `stated`: of each axis the directions in which the others came to rest, 0 where nothing says it."""

    def __init__(self, machine, read, squares, stated, keeps_directions=True):
        self.machine, self.read, self.squares, self.stated = machine, read, squares, stated
        self.keeps = keeps_directions and any(r["halves"] is not None for r in read.values())
        self.ranges, self.nodes = [], []
        for a in range(3):
            own = [r["at"] for n, r in read.items() if axis_of(n) == a]
            low, high = (max(q[0] for q in own), min(q[-1] for q in own)) if own else (LOWER[a], UPPER[a])
            self.ranges.append((low, high))
            self.nodes.append(np.linspace(low, high, max(2, min([61, *(len(q) for q in own)])) if own else 2))
        self.count = sum(6 * len(n) for n in self.nodes)
        self.size = self.count + 3 + (self.count if self.keeps else 0)
        self.lay_out_inputs()
        self.untold = []
        self.values = self.coefficients(self.inputs, tells=True)
        # All is linear in the readings, and in the signs of unknown directions at the readings as they are.
        jacobian = np.array([self.coefficients(one, signs=0) for one in np.eye(len(self.inputs))]).T
        zero = self.coefficients(np.zeros(len(self.inputs)), signs=0)
        assert np.abs(zero).max() == 0.0
        self.covariance = jacobian @ self.spread @ jacobian.T
        for pair in itertools.permutations(range(3), 2):
            by_sign = self.coefficients(self.inputs, signs={pair: 1.0}) - self.values
            self.covariance += np.outer(by_sign, by_sign)

    def lay_out_inputs(self):
        self.place, inputs, blocks = {}, [], []
        for name, r in self.read.items():
            n, both = len(r["at"]), r["halves"] is not None
            self.place[name] = (len(inputs), n, both)
            inputs += [*r["means"], *(r["halves"] if both else [])]
            blocks.append(r["covariance"])
        for name, s in self.squares.items():
            self.place[name] = len(inputs)
            inputs.append(s["value"])
            blocks.append(np.array([[s["u"] ** 2]]))
        self.inputs, self.spread = np.array(inputs), np.zeros((len(inputs), len(inputs)))
        k = 0
        for block in blocks:
            self.spread[k:k + len(block), k:k + len(block)] = block
            k += len(block)

    def given(self, name, inputs, half=False):
        """A reading at the nodes of its axis; None where there is none."""
        if name not in self.read or (half and self.read[name]["halves"] is None):
            return None
        first, n, _ = self.place[name]
        values = inputs[first + (n if half else 0):][:n]
        return np.interp(self.nodes[axis_of(name)], self.read[name]["at"], values)

    def lever(self, a, at):
        return levers(self.machine, measured_place(self.machine, a, at), self.machine["stand_tool"][a])[a]

    def turns(self, a, m):
        """The rotations that move along m, each with its sign and the component of the lever."""
        return [(f"E{'ABC'[(m + 1) % 3]}{'XYZ'[a]}", 1.0, (m + 2) % 3), (f"E{'ABC'[(m + 2) % 3]}{'XYZ'[a]}", -1.0, (m + 1) % 3)]

    def lacks(self, name, told):
        a, m = axis_of(name), motion_of(name)
        return [n for n, _, k in self.turns(a, m)
                if n not in told and max(abs(self.lever(a, at)[k]) for at in self.nodes[a]) > 1e-6]

    def lever_effect(self, name, rotations):
        a, m = axis_of(name), motion_of(name)
        return sum(1e-3 * sign * np.array([self.lever(a, at)[k] for at in self.nodes[a]]) * rotations[n]
                   for n, sign, k in self.turns(a, m) if n in rotations)

    def curves(self, inputs):
        """Of means in the gauge, and of halves as they are."""
        means, halves = {}, {}
        for name in sorted(NAMES, key=lambda n: motion_of(n) < 3):
            y, q = self.given(name, inputs), self.nodes[axis_of(name)]
            if y is None or (motion_of(name) < 3 and self.lacks(name, means)):
                continue
            y = y - (self.lever_effect(name, means) if motion_of(name) < 3 else 0.0)
            mean, slope = line_of(q, y)
            level = motion_of(name) < 3 and name[1] != name[2]
            means[name] = y - mean - (slope * (q - 0.5 * (q[0] + q[-1])) if level else 0.0)
            h = self.given(name, inputs, half=True)
            if h is not None and self.keeps:
                halves[name] = h - (self.lever_effect(name, halves) if motion_of(name) < 3 else 0.0)
        return means, halves

    def turned(self, line, means, inputs, signs, missing):
        """What axes before that of a line in the chain make of its slope, µrad: [ω_b × e_a]_m for each before it."""
        a, m = axis_of(line), motion_of(line)
        order = [c for c in self.machine["chain"] if c != "F"]
        total = 0.0
        for letter in order[:order.index("XYZ"[a])]:
            b = "XYZ".index(letter)
            for n, sign, k in self.turns(b, m):
                if k != a:
                    continue
                at = self.machine["stood"][a][b]
                if n not in means or not self.ranges[b][0] - 0.02 <= at <= self.ranges[b][1] + 0.02:
                    missing.append(n)
                    continue
                total += sign * np.interp(at, self.nodes[b], means[n])
                if self.read[n]["halves"] is None:
                    continue
                direction = self.stated[a][b] or (signs or {}).get((a, b), 0.0)
                total += sign * direction * np.interp(at, self.nodes[b], self.given(n, inputs, half=True))
        return total

    def square(self, name, inputs, means, signs):
        """None where nothing tells it."""
        s, missing, total = self.squares[name], [], inputs[self.place[name]]
        for line, sign in ((SQUARES[name][0], SQUARES[name][2]), (SQUARES[name][1], SQUARES[name][2])):
            a, nodes = axis_of(line), self.nodes[axis_of(line)]
            own = {tuple(r["at"][[0, -1]]) for n, r in self.read.items() if axis_of(n) == a}
            if not s["lines"] and line not in self.read and len(own) > 1:
                return None
            missing += self.lacks(line, means)
            total -= sign * 1e3 * line_of(nodes, self.lever_effect(line, means) + 0.0 * nodes)[1]
            total -= sign * self.turned(line, means, inputs, signs, missing)
            if s["lines"]:
                h = self.given(line, inputs, half=True)
                if h is not None:
                    total -= sign * s["lines"][line] * 1e3 * line_of(nodes, h)[1]
            elif line in self.read:
                first, n, _ = self.place[line]
                y, at = inputs[first:first + n], self.read[line]["at"]
                low, high = self.ranges[a]
                if at[0] < low - 1e-6 or at[-1] > high + 1e-6:
                    total += sign * 1e3 * (line_of(nodes, self.given(line, inputs))[1] - line_of(at, y)[1])
        return None if missing else total

    def coefficients(self, inputs, signs=None, tells=False):
        means, halves = self.curves(inputs)
        values, first = np.zeros(self.size), 0
        for a in range(3):
            for m in range(6):
                name, at = NAMES[6 * a + m], first + m + 6 * np.arange(len(self.nodes[a]))
                if name in means:
                    values[at] = means[name]
                if name in halves:
                    values[self.count + 3 + at] = halves[name]
                if tells:
                    self.tell(name, at, means, halves)
            first += 6 * len(self.nodes[a])
        for k, name in enumerate(SQUARES):
            found = self.square(name, inputs, means, signs) if name in self.squares else None
            if found is not None:
                values[self.count + k] = found
            elif tells:
                self.untold.append(np.eye(self.size)[self.count + k])
        return values

    def tell(self, name, at, means, halves):
        """Directions of coefficients of which nothing is told."""
        if name not in means:
            self.untold += list(np.eye(self.size)[at])
        if not self.keeps or name in halves:
            return
        for n, place in enumerate(at + self.count + 3):
            direction = np.eye(self.size)[place]
            if motion_of(name) >= 3:  # what a displacement holds of it there goes with it
                for m in range(3):
                    other = f"E{'XYZ'[m]}{name[2]}"
                    for rotation, sign, k in self.turns(axis_of(name), m):
                        if rotation == name and other in halves:
                            direction[place - motion_of(name) + m] = (
                                -1e-3 * sign * self.lever(axis_of(name), self.nodes[axis_of(name)][n])[k])
            self.untold.append(direction / np.linalg.norm(direction))

    def rows(self, q, tool, directions=(0, 0, 0)):
        """What each component of δ is a sum of."""
        rows, r = np.zeros((3, self.size)), levers(self.machine, q, tool)
        first = 0
        for a in range(3):
            n = len(self.nodes[a])
            for k in range(n):
                share = np.interp(q[a], self.nodes[a], np.eye(n)[k])
                if share == 0.0:
                    continue
                for m in range(6):
                    e = np.zeros(6)
                    e[m] = share
                    effect = e[:3] + 1e-3 * np.cross(e[3:], r[a])
                    rows[:, first + 6 * k + m] += effect
                    if self.keeps:
                        rows[:, self.count + 3 + first + 6 * k + m] += directions[a] * effect
            first += 6 * n
        rows[0, self.count:self.count + 2] = [-1e-3 * q[1], 1e-3 * q[2]]
        rows[1, self.count + 2] = -1e-3 * q[2]
        return rows

    def is_told(self, row, beside=0.0):
        return all(abs(d @ (row - beside)) <= TOLD_MOST * np.sqrt(row @ row + np.sum(np.square(beside))) for d in self.untold)
