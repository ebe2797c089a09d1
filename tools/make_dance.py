#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes testdata/dance.bvh: a human who sways, lifts the knees and swings the arms, two seconds that loop. The
joints have Mixamo's names. tools/make_dance.py > testdata/dance.bvh"""

import math

SECONDS, RATE = 2, 24
FRAMES = SECONDS * RATE + 1  # the last is as the first

# name, offset in centimetres from the joint above, joints below; None: the end of a limb. The figure looks along
# z, its left is +x, the arms are stretched out.
FOOT = [(None, (0, -5, 14), [])]


def leg(side, x):
    foot = (side + "Foot", (0, -42, 0), FOOT)
    return (side + "UpLeg", (9 * x, -4, 0), [(side + "Leg", (0, -42, 0), [foot])])


def arm(side, x):
    hand = (side + "Hand", (25 * x, 0, 0), [(None, (12 * x, 0, 0), [])])
    return (side + "Shoulder", (4 * x, 14, 0),
            [(side + "Arm", (13 * x, 0, 0), [(side + "ForeArm", (27 * x, 0, 0), [hand])])])


HEAD = ("Neck", (0, 20, 0), [("Head", (0, 9, 0), [(None, (0, 18, 0), [])])])
SPINE = ("Spine", (0, 10, 0), [("Spine1", (0, 18, 0), [HEAD, arm("Left", 1), arm("Right", -1)])])
HIPS = ("Hips", (0, 0, 0), [SPINE, leg("Left", 1), leg("Right", -1)])


def hierarchy(joint, depth=0):
    name, offset, below = joint
    tab = "  " * depth
    kind = "ROOT Hips" if depth == 0 else f"JOINT {name}" if name else "End Site"
    lines = [tab + kind, tab + "{", f"{tab}  OFFSET {offset[0]} {offset[1]} {offset[2]}"]
    if name:
        position = "Xposition Yposition Zposition " if depth == 0 else ""
        count = 6 if depth == 0 else 3
        lines.append(f"{tab}  CHANNELS {count} {position}Zrotation Xrotation Yrotation")
    for child in below:
        lines += hierarchy(child, depth + 1)
    return lines + [tab + "}"]


def names(joint):
    return ([joint[0]] if joint[0] else []) + [name for child in joint[2] for name in names(child)]


def pose(time):
    """Zrotation and Xrotation of the joints that move, and the place of the hips."""
    beat = 2 * math.pi * time / SECONDS
    swing = math.sin(beat)
    lift = {"Left": max(0.0, swing), "Right": max(0.0, -swing)}
    angles = {"Hips": (5 * swing, 0), "Spine": (-4 * swing, 0), "Spine1": (-4 * swing, 0), "Head": (6 * swing, 0)}
    for side, x in (("Left", 1), ("Right", -1)):
        raised = 5 + 50 * x * swing
        angles[side + "Arm"] = (x * raised, 0)
        angles[side + "ForeArm"] = (x * (40 + 20 * math.cos(2 * beat)), 0)
        angles[side + "UpLeg"] = (-5 * swing, -40 * lift[side])
        angles[side + "Leg"] = (0, 70 * lift[side])
        angles[side + "Foot"] = (0, -30 * lift[side])
    return angles, (5 * swing, 93 + 2 * math.cos(2 * beat), 0)


def main():
    lines = ["HIERARCHY"] + hierarchy(HIPS)
    lines += ["MOTION", f"Frames: {FRAMES}", f"Frame Time: {1 / RATE:.6f}"]
    for frame in range(FRAMES):
        angles, place = pose(frame / RATE)
        values = [f"{v:.2f}" for v in place]
        for name in names(HIPS):
            z, x = angles.get(name, (0, 0))
            values += [f"{z:.1f}", f"{x:.1f}", "0"]
        lines.append(" ".join(values))
    print("\n".join(lines).replace("-0.0 ", "0.0 ").replace("-0.00 ", "0.00 "))


main()
