# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A ball of tetrahedra: the twenty between the centre and the faces of an icosahedron are cut into
eight again and again, and points are moved along their radii so that the surface becomes a sphere.
Written for Gmsh's version 4.1, with the surface as the group `skin`."""

import itertools
import math

EDGES = ((0, 1), (1, 2), (2, 0), (3, 0), (3, 2), (3, 1))  # in the order of Gmsh
GOLDEN = (1 + math.sqrt(5)) / 2


def icosahedron():
    """Its corners, and its faces: three corners next to each other."""
    corners = [
        tuple((0, a, b * GOLDEN)[(c + shift) % 3] for c in range(3))
        for shift, a, b in itertools.product(range(3), (-1, 1), (-1, 1))
    ]
    near = lambda p, q: math.dist(p, q) < 2.1
    faces = [
        three
        for three in itertools.combinations(range(12), 3)
        if all(near(corners[p], corners[q]) for p, q in itertools.combinations(three, 2))
    ]
    return corners, faces


class Ball:
    """Points x, y, z in the icosahedron with r, linear from 0 in the centre to 1 on the surface;
    and tetrahedra of them."""

    def __init__(self, refinements):
        corners, faces = icosahedron()
        self.points, self.middles, self.straight = [(0, 0, 0, 0)], {}, {}
        self.points += [(*corner, 1) for corner in corners]
        self.cells = [(0, *(v + 1 for v in face)) for face in faces]
        for _ in range(refinements):
            self.cells = [part for cell in self.cells for part in self.parts(cell)]

    def middle(self, a, b):
        """The point between two points."""
        key = min(a, b), max(a, b)
        if key not in self.middles:
            self.middles[key] = len(self.points)
            self.points.append(tuple(0.5 * (p + q) for p, q in zip(self.points[a], self.points[b])))
        return self.middles[key]

    def parts(self, cell):
        """Four tetrahedra at the corners, and four around a diagonal of what is left."""
        a, b, c, d = cell
        ab, ac, ad = self.middle(a, b), self.middle(a, c), self.middle(a, d)
        bc, bd, cd = self.middle(b, c), self.middle(b, d), self.middle(c, d)
        yield from ((a, ab, ac, ad), (b, ab, bc, bd), (c, ac, bc, cd), (d, ad, bd, cd))
        ring = (ab, ad, cd, bc)
        for k in range(4):
            yield ac, bd, ring[k], ring[(k + 1) % 4]

    def place(self, k):
        """Where a point comes to lie in the ball."""
        if k in self.straight:
            return tuple(0.5 * (p + q) for p, q in zip(*map(self.place, self.straight[k])))
        *point, r = self.points[k]
        return tuple(r * x / math.hypot(*point) if r > 0 else 0.0 for x in point)

    def skin(self):
        """The triangles of the surface."""
        for cell in self.cells:
            face = [v for v in cell if self.points[v][3] == 1]
            if len(face) == 3:
                yield tuple(face)

    def with_middles(self, corners):
        """The nodes of a cell or face of second order; inside, edges are straight."""
        nodes = list(corners)
        for a, b in EDGES if len(corners) == 4 else EDGES[:3]:
            nodes.append(self.middle(corners[a], corners[b]))
            if self.points[nodes[-1]][3] < 1:
                self.straight[nodes[-1]] = corners[a], corners[b]
        return tuple(nodes)


def write(path, refinements, curved, radius):
    """curved: with nodes on the sphere in the middle of edges."""
    ball = Ball(refinements)
    groups = [list(ball.skin()), ball.cells]
    if curved:
        groups = [[ball.with_middles(element) for element in group] for group in groups]
    types = (9, 11) if curved else (2, 4)
    box, n = "-1 -1 -1 1 1 1", len(ball.points)
    n_elements = sum(map(len, groups))
    with path.open("w", encoding="utf-8") as out:
        out.write('$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 5 "skin"\n')
        out.write(f'3 1 "ball"\n$EndPhysicalNames\n$Entities\n0 0 1 1\n1 {box} 1 5 0\n')
        out.write(f"1 {box} 1 1 0\n$EndEntities\n$Nodes\n1 {n} 1 {n}\n3 1 0 {n}\n")
        out.writelines(f"{k + 1}\n" for k in range(n))
        for k in range(n):
            out.write("%.17g %.17g %.17g\n" % tuple(radius * x for x in ball.place(k)))
        out.write(f"$EndNodes\n$Elements\n2 {n_elements} 1 {n_elements}\n")
        label = itertools.count(1)
        for dim, kind, elements in zip((2, 3), types, groups):
            out.write(f"{dim} 1 {kind} {len(elements)}\n")
            for element in elements:
                nodes = " ".join(str(node + 1) for node in element)
                out.write(f"{next(label)} {nodes}\n")
        out.write("$EndElements\n")
