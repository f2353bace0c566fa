#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""Bodies that meet bodies, wherever their motion takes them: laws hold, whatever slides, tips or
falls. The energy residual is that of the solver, no step gains energy, linear momentum stays to
1e-10, no node penetrates; and the results are those of mechanics, where that knows them.
"""

import math

import check_history
from following_scenes import body, box, disc, friction, obstacles, scene

FLOOR = obstacles({"floor": ["set Normal = 0, 1"]})
DISSIPATIVE = ("contact-implicit", "contact-stabilized-projected")
WEIGHT = "set Body force = 0; -10"


def off_centre(offset, level):
    """A disc that moves, and one at rest."""
    return [
        disc("p", "0, 0", "set Initial velocity = 0.2; 0", level=level),
        disc("q", f"2.0, {offset}", level=level),
    ]


class MeetingBodies(check_history.SceneTest):
    """See the beginning of the file."""

    def expect_laws(self, run, momentum=True):
        """Ledger, no gain, no penetration of nodes by the conditions of the steps, momentum."""
        self.expect_ledger_closes(run, driven=True)
        self.expect_no_gain_of_energy(run, driven=True)
        self.expect_no_penetration(run, 1)
        if not momentum:
            return
        components = [run[f"momentum_{axis}"] for axis in "xyz"]
        scale = max(abs(value) for values in components for value in values)
        for values in components:
            self.assertLess(max(abs(v - values[0]) for v in values), 1e-10 * scale)

    def test_a_block_slides_off_a_table_and_falls(self):
        """Without friction it keeps its speed but for what tipping over the edge adds; in the air
        the force is exactly zero and the centroid falls with g; the floor stops it."""
        table = box("table", "0, 0", "2, 1", "8, 4", "set Dirichlet = 2: 0; 0")
        block = box("block", "1, 1", "1.5, 1.5", "3, 3", WEIGHT, "set Initial velocity = 2; 0")
        for scheme in DISSIPATIVE:
            with self.subTest(scheme=scheme):
                run = check_history.Run(
                    scene(
                        [table, block],
                        ["block : table", "block : floor"],
                        1.0,
                        scheme,
                        obstacles=FLOOR,
                    ),
                    f"table_{scheme}",
                )
                self.expect_laws(run, momentum=False)
                bodies = run.table("bodies")
                speed = bodies["body_block_velocity_y"]
                air = [row for row, time in enumerate(run["time"]) if 0.6 <= time <= 0.82]
                self.assertEqual(max(run["contact_force"][row] for row in air), 0)
                for row in air[1:]:
                    self.assertAlmostEqual(speed[row] - speed[row - 1], -0.1, delta=1e-9)
                self.assertAlmostEqual(bodies["body_block_velocity_x"][air[0]], 2, delta=0.15)
                self.assertGreater(bodies["body_block_centroid_x"][air[0]], 2.2)
                # It lands in the step at whose end its corner would be inside without a floor.
                gap = run.table("pairs")["pair_1_smallest_gap"]
                landing = next(
                    row for row in range(air[-1], len(run)) if run["contact_force"][row] > 0
                )
                for row, inside in ((landing - 1, False), (landing, True)):
                    free = 2 * gap[row - 1] - gap[row - 2] - 10 * 0.01**2
                    self.assertEqual(free < 0, inside, f"row {row}: {free}")
                after = [f for f, time in zip(run["contact_force"], run["time"]) if time > 0.85]
                self.assertGreater(max(after), 1)
                self.assertGreater(min(bodies["body_block_centroid_y"]), 0.15)

    def test_a_block_over_the_seam_of_two_others(self):
        """A mirror image: the two below get the same impulses, and the block does not turn. Nodes
        that face both have one condition, wherever the seam is between them. The block as the
        master has no such nodes, and gives the same within what the meshes differ by."""
        below = [
            box("p", "-1.025, 0", "-0.025, 1", "4, 4"),
            box("q", "0.025, 0", "1.025, 1", "4, 4"),
        ]
        above = box("t", "-0.6, 1.0005", "0.6, 1.5005", "5, 3", "set Initial velocity = 0; -0.05")
        impulse = {}
        for pairs in (["t : p", "t : q"], ["p : t", "q : t"]):
            run = check_history.Run(scene(below + [above], pairs, 0.15, step=1e-3), "seam")
            self.expect_laws(run)
            bodies = run.table("bodies")
            p, q = (bodies[f"body_{name}_momentum_y"][-1] for name in "pq")
            self.assertAlmostEqual(p, q, delta=1e-7 * abs(p))
            self.assertLess(abs(bodies["body_t_angular_momentum_z"][-1]), 1e-7 * abs(p))
            impulse[pairs[0]] = p
        self.assertAlmostEqual(impulse["t : p"] / impulse["p : t"], 1, delta=0.01)

    def test_a_bridge(self):
        """A block on two others with friction and its weight, from no deformation: it vibrates, and
        the two carry equal parts in each step."""
        below = [
            box("p", "-1.025, 0", "-0.025, 1", "4, 4", "set Dirichlet = 2: 0; 0"),
            box("q", "0.025, 0", "1.025, 1", "4, 4", "set Dirichlet = 2: 0; 0"),
        ]
        above = box("t", "-0.6, 1", "0.6, 1.5", "5, 3", WEIGHT)
        pairs = ["t : p", "t : q"]
        run = check_history.Run(
            scene(
                below + [above],
                pairs,
                0.06,
                step=1e-3,
                laws="".join(friction(pair, 0.3) for pair in pairs),
            ),
            "bridge",
        )
        self.expect_laws(run, momentum=False)
        table = run.table("pairs")
        for p, q in zip(table["pair_0_normal_force"], table["pair_1_normal_force"]):
            self.assertAlmostEqual(p, q, delta=1e-8 * max(run["contact_force"]))
        self.assertGreater(min(table["pair_0_normal_force"][20:]), 0)

    def test_cradle(self):
        """Five discs in a row: the first one's momentum comes out at the other end, but for what
        vibrates: the middle ones stay where they are, nearly."""
        discs = [
            disc(f"d{k}", f"{2 * k}, 0", f"set Initial velocity = {0.5 if k == 0 else 0}; 0")
            for k in range(5)
        ]
        run = check_history.Run(
            scene(discs, [f"d{k} : d{k + 1}" for k in range(4)], 2.0, step=0.005), "cradle"
        )
        self.expect_laws(run)
        bodies = run.table("bodies")
        speeds = [bodies[f"body_d{k}_velocity_x"][-1] / 0.5 for k in range(5)]
        self.assertAlmostEqual(sum(speeds), 1, delta=1e-9)
        self.assertGreater(speeds[4], 0.75)
        self.assertLess(abs(speeds[0]), 0.15)
        self.assertEqual(run["contact_force"][-1], 0)

    def test_cradle_of_balls(self):
        """The same with three balls, as coarse as they can be."""
        balls = [
            disc(
                f"b{k}",
                f"{2 * k}, 0, 0",
                f"set Initial velocity = {0.5 if k == 0 else 0}; 0; 0",
                level=2,
            )
            for k in range(3)
        ]
        text = scene(balls, ["b0 : b1", "b1 : b2"], 1.6, dimension=3)
        run = check_history.Run(text, "cradle_of_balls")
        self.expect_laws(run)
        bodies = run.table("bodies")
        speeds = [bodies[f"body_b{k}_velocity_x"][-1] / 0.5 for k in range(3)]
        self.assertAlmostEqual(sum(speeds), 1, delta=1e-9)
        self.assertGreater(speeds[2], 0.9)
        self.assertEqual(run["contact_force"][-1], 0)

    def test_discs_that_pass_each_other_feel_nothing(self):
        """With a clearance of 0.01: the force is exactly zero in all steps."""
        run = check_history.Run(
            scene(
                [disc("p", "0, 0", "set Initial velocity = 2; 0"), disc("q", "3, 2.01")],
                ["p : q"],
                3.0,
                step=0.05,
            ),
            "past",
        )
        self.assertEqual(max(run["contact_force"]), 0)
        self.expect_laws(run)

    def test_two_discs_off_centre(self):
        """They part with opposite spins. Contact forces have no moment about anything: what is
        left of it shows in the angular momentum at the present positions, 1e-5 of that of the
        approach."""
        for scheme in DISSIPATIVE:
            with self.subTest(scheme=scheme):
                run = check_history.Run(
                    scene(
                        off_centre(0.8, level=4),
                        ["p : q"],
                        4.0,
                        scheme,
                        step=0.02,
                    ),
                    f"oblique_{scheme}",
                )
                self.expect_laws(run)
                self.expect_contact(run)
                self.assertLess(max(run.table("pairs")["pair_0_depth"]), 0.05 * 0.1)
                spin = run["angular_momentum_z"]
                moment = 0.8 * run["momentum_x"][0]
                self.assertLess(max(abs(value - spin[0]) for value in spin), 1e-4 * moment)

    def test_gaps_are_missed_by_less_on_finer_meshes(self):
        """Where a bound is clipped, forces act on nodes that are apart. Forces times what is missed
        in the worst step of each of three oblique impacts fall together to 0.26 from 64 to 128
        faces around; by themselves to 0.06, 0.31 and 0.71, as nodes meet by chance."""
        worst = []
        for level in (4, 5):
            worst.append(0)
            for offset in (0.7, 0.8, 0.9):
                text = scene(off_centre(offset, level), ["p : q"], 1.5, step=0.02)
                run = check_history.Run(text, "missed")
                self.expect_contact(run)
                worst[-1] += max(map(abs, run["work_geometry"])) / run["total_energy"][0]
        self.assertLess(worst[0], 0.04)  # measured 0.021
        self.assertLess(worst[1], 0.5 * worst[0])

    def test_side_by_side_on_a_floor(self):
        """The left block pushes the right one: nodes in the corner are held by the floor and follow
        the other body, and its nodes there are held themselves. The momentum along the floor
        stays; the weight is on the floor."""
        left = box("left", "0, 0", "1, 1", "4, 4", WEIGHT, "set Initial velocity = 1; 0")
        right = box("right", "1.05, 0", "2.05, 1", "5, 5", WEIGHT)
        for preconditioner in ("automatic", "multigrid"):
            with self.subTest(preconditioner=preconditioner):
                run = check_history.Run(
                    scene(
                        [left, right],
                        ["left : floor", "right : floor", "left : right"],
                        1.0,
                        obstacles=FLOOR,
                    ),
                    f"side_{preconditioner}",
                    [f"Solver/Preconditioner={preconditioner}"],
                )
                self.expect_laws(run, momentum=False)
                momentum = run["momentum_x"]
                self.assertLess(max(abs(p - 1) for p in momentum), 1e-9)
                forces = run["contact_force_y"]
                self.assertAlmostEqual(sum(forces) / len(forces), 20, delta=2)

    def test_friction_stops_a_block_on_a_body(self):
        """After V/(mu g) and V^2/(2 mu g), within what the vibration under the sudden weight
        changes."""
        table = box("table", "0, 0", "2, 0.5", "8, 2", "set Dirichlet = 2: 0; 0")
        block = box("block", "0.3, 0.5", "0.8, 0.8", "4, 2", WEIGHT, "set Initial velocity = 2; 0")
        run = check_history.Run(
            scene(
                [table, block],
                ["block : table"],
                1.2,
                laws=friction("block : table", 0.4),
            ),
            "friction",
        )
        self.expect_laws(run, momentum=False)
        bodies = run.table("bodies")
        path = bodies["body_block_centroid_x"][-1] - bodies["body_block_centroid_x"][0]
        self.assertAlmostEqual(path, 2**2 / (2 * 0.4 * 10), delta=0.02)
        self.assertLess(abs(bodies["body_block_velocity_x"][-1]), 0.02)

    def test_no_way_through_a_body(self):
        """Steps in which a disc would fly through another one unseen are cut."""
        run = check_history.Run(
            scene(
                [disc("p", "0, 0", "set Initial velocity = 4; 0"), disc("q", "6, 0.1")],
                ["p : q"],
                4.0,
                step=1.0,
            ),
            "cut",
            ["Bodies/p/Refinements=2", "Bodies/q/Refinements=2"],
        )
        self.assertGreater(sum(run["rejected_steps"]), 0)
        self.expect_contact(run)
        bodies = run.table("bodies")
        self.assertGreater(bodies["body_q_velocity_x"][-1], 2)
        self.expect_laws(run)

    def test_processes(self):
        """The same on one and two processes, with friction and three bodies that meet in an
        edge."""
        bodies = [
            box("a", "0, 0", "1, 1", "4, 4", "set Initial velocity = 0.3; -1"),
            box("b", "-1, -1.02", "0.6, -0.02", "6, 4", "set Dirichlet = 2: 0; 0"),
            box("c", "1.02, -1", "2, 1.5", "4, 8", "set Dirichlet = 1: 0; 0"),
        ]
        text = scene(
            bodies,
            ["a : b", "a : c"],
            0.6,
            "contact-stabilized-projected",
            laws=friction("a : b", 0.2),
        )
        one = check_history.Run(text, "one")
        two = check_history.Run(text, "two", processes=2)
        self.expect_laws(one, momentum=False)
        self.expect_contact(one)
        self.expect_same_history(two, one, 1e-8)

    def test_processes_under_light_contact(self):
        """A block slides off a table onto another block. Its weight strains it by 1e-4: a gap that
        is wrong by 1e-12 of the size changes forces by 1e-7. One and two processes agree to
        1e-8 nevertheless."""
        weight = "set Body force = 0; -0.1"
        bodies = [
            box("a", "-2.1, 0", "-0.1, 1", "8, 4", "set Initial velocity = 1; 0", weight),
            box("b", "0.1, -1", "3, 0", "12, 4", "set Dirichlet = 2: 0; 0", weight),
        ]
        table = ["set Shape = box", "set Lower corner = -9, -1", "set Upper corner = 0, 0"]
        text = scene(
            bodies,
            ["a : table", "a : b"],
            0.5,
            "contact-stabilized-projected",
            laws=friction("a : table", 0.1) + friction("a : b", 0.2),
            obstacles=obstacles({"table": table}),
        )
        one = check_history.Run(text, "light-one")
        two = check_history.Run(text, "light-two", processes=2)
        self.expect_laws(one, momentum=False)
        self.assertGreater(max(one.table("pairs")["pair_1_normal_force"]), 0)
        self.expect_same_history(two, one, 1e-8)

    def test_rings_meet_with_all_of_their_surface(self):
        """The inside of one lies as far behind the inside of the other as a body that overlaps it
        by the thickness of both walls. Rings that do overlap are refused, however thin they are."""
        folder = check_history.pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        shape = ("set Shape = file", f"set File = {ring(folder)}")

        def rings(distance):
            bodies = [
                body("a", *shape, "set Initial velocity = 0.2; 0"),
                body("b", *shape, f"set Translation = {distance}, 0.1"),
            ]
            return scene(bodies, ["a : b"], 0.5, "contact-stabilized-projected")

        run = check_history.Run(rings(2.01), "rings")
        self.assertGreater(max(run["contact_force"]), 0)
        self.expect_laws(run)
        for overlap in (0.03, 0.15):
            with self.assertRaisesRegex(AssertionError, "overlap at the start"):
                check_history.Run(rings(2 - overlap), f"rings_{overlap}")

    def test_a_ring_is_squashed_until_it_touches_itself(self):
        """Between two plates, one of which comes down by 1.78 of the height of 2: the walls of the
        ring, 0.1 thick each, have 0.02 between them then if they do not bend, and touch. What the
        plate brings is all that there is, and no wall goes through the other."""
        folder = check_history.pathlib.Path(check_history.settings["folder"])
        folder.mkdir(parents=True, exist_ok=True)
        plates = {
            "top": ["set Point = 0, 1", "set Normal = 0, -1", "set Motion = 0; -min(t, 1.78)"],
            "floor": ["set Point = 0, -1", "set Normal = 0, 1"],
        }
        text = scene(
            [body("ring", "set Shape = file", f"set File = {ring(folder)}")],
            ["ring : top", "ring : floor", "ring : ring"],
            2,
            "contact-stabilized-projected",
            step=0.02,
            obstacles=obstacles(plates),
        )
        one = check_history.Run(text, "ring")
        self.expect_laws(one, momentum=False)
        pairs = one.table("pairs")
        first = next(row for row, force in enumerate(pairs["pair_2_normal_force"]) if force > 0)
        self.assertGreater(one["time"][first], 1.2)
        self.assertEqual(max(pairs["pair_2_normal_force"][:first]), 0)
        self.assertGreater(pairs["pair_2_normal_force"][-1], 10)
        self.assertLess(max(pairs["pair_2_depth"]), 0.05 * 0.098)


def ring(folder, radius=1.0, thickness=0.1, around=64, across=2):
    """The file of a ring of quadrilaterals (UCD)."""
    points, cells = [], []
    for i in range(around):
        angle = 2 * math.pi * i / around
        for j in range(across + 1):
            r = radius - thickness + thickness * j / across
            points.append((r * math.cos(angle), r * math.sin(angle)))

    def point(i, j):
        return (i % around) * (across + 1) + j + 1

    for i in range(around):
        for j in range(across):
            cells.append((point(i, j), point(i, j + 1), point(i + 1, j + 1), point(i + 1, j)))
    lines = [f"{len(points)} {len(cells)} 0 0 0"]
    lines += [f"{k + 1} {x!r} {y!r} 0" for k, (x, y) in enumerate(points)]
    lines += [f"{k + 1} 0 quad {' '.join(map(str, cell))}" for k, cell in enumerate(cells)]
    path = folder / "ring.inp"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


if __name__ == "__main__":
    check_history.main()
