#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors

"""A run that is killed at random instants, also while it writes a checkpoint, and resumed each time
ends as the one that was left alone: on as many processes with the same bits, as it goes the same
way; every resume works."""

import random
import subprocess
import time

import check_history
from interrupted_scene import InterruptedRun, differences

KILLS = 20


class Kill(check_history.SceneTest):
    def test_twenty_kills_leave_no_trace(self):
        start = time.monotonic()
        calm = InterruptedRun("calm", 2).start()
        self.assertEqual(calm.end()[0], 0)
        duration = time.monotonic() - start

        run = InterruptedRun("killed", 2)
        random_numbers = random.Random(1)
        kills = resumed = 0
        while kills < KILLS:
            for old in run.output.glob("checkpoint*/manifest"):
                old.unlink()
            status = None
            while status is None:
                resumes = run.has_checkpoint()
                resumed += resumes
                run.start(*(["--resume"] if resumes else []))
                try:
                    status, messages = run.end(timeout=random_numbers.uniform(0.2, 1.0) * duration)
                except subprocess.TimeoutExpired:
                    run.kill()
                    kills += 1
            self.assertEqual(status, 0, messages)
            different = {column: by for column, by in differences(calm, run).items() if by != 0.0}
            self.assertEqual(different, {})
        self.assertGreater(resumed, KILLS / 4)


if __name__ == "__main__":
    check_history.main()
