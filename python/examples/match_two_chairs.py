# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
# Which parts of two chairs correspond, and a chair half-way between them.
import shape_correspondence as sc

a = sc.read("data/chair_four_legged")
b = sc.read("data/chair_slatted")
match = sc.match(a, b)
for (part, other), confidence in zip(match.pairs, match.confidences):
    print(f"{part} -> {other} ({confidence:.0%})")
match.save("match.html")
sc.blend(a, b, match)(0.5).save("half_way.obj")
